#include "app/gui_arguments.h"

#include "core/base/typed_numbers.h"
#include "core/io/picture_file.h"
#include "core/io/session.h"
#include "core/lessons/lesson.h"
#include "ui/base/image_export.h"
#include "ui/face/cards.h"
#include "ui/pipeline/canvas_views.h"
#include "ui/steps/step_mode.h"

#include <QCommandLineParser>

#include <cstdio>
#include <map>
#include <utility>

namespace rasterlens
{
namespace
{

QStringList panelNames() { return Cards::names() + TruthMode::panelNames() + QStringList{QStringLiteral("mistakes")}; }

QStringList topicIds()
{
    QStringList ids;
    for (const DerivationTopicInfo& info : derivationTopics())
        ids << QLatin1String(info.id);
    return ids;
}

ParsedArguments refuse(const QString& why)
{
    printError(QStringLiteral("rasterlens: %1 (try --help)").arg(why));
    return {std::nullopt, kBadArguments};
}

/// The language that a locale names: `zh`, `zh_CN`, `zh-Hans`, `en_GB.UTF-8` and the like.
std::optional<LanguageKind> languageOf(const QString& locale)
{
    const QString language =
        QString(locale).replace(QLatin1Char('-'), QLatin1Char('_')).section(QLatin1Char('_'), 0, 0);
    if (language == QLatin1String("zh"))
        return LanguageKind::Chinese;
    if (language == QLatin1String("en"))
        return LanguageKind::English;
    return std::nullopt;
}

/// The options of the program; each has one word or none behind it.
struct Options {
    QCommandLineOption help{{QStringLiteral("h"), QStringLiteral("help")}, QStringLiteral("Shows this list.")};
    QCommandLineOption version{{QStringLiteral("v"), QStringLiteral("version")}, QStringLiteral("Shows the version.")};
    QCommandLineOption screenshot{
        QStringLiteral("screenshot"),
        QStringLiteral("Writes the window as a picture to <file> and exits; needs no display. The suffix tells the "
                       "format: %1; - is stdout.")
            .arg(pictureSuffixes().join(QStringLiteral(", "))),
        QStringLiteral("file")};
    QCommandLineOption windowSize{QStringLiteral("size-window"), QStringLiteral("Size of the window in pixels."),
                                  QStringLiteral("WxH")};
    QCommandLineOption language{QStringLiteral("language"),
                                QStringLiteral("Language of the window: en or zh, also zh_CN and the like."),
                                QStringLiteral("en|zh")};
    QCommandLineOption theme{QStringLiteral("theme"), QStringLiteral("Colours of the window: light or dark."),
                             QStringLiteral("light|dark")};
    QCommandLineOption panel{QStringLiteral("panel"), QStringLiteral("Opens a panel: %1.").arg(panelNames().join(", ")),
                             QStringLiteral("name")};
    QCommandLineOption topic{QStringLiteral("topic"),
                             QStringLiteral("Opens the panel derive with a topic: %1.").arg(topicIds().join(", ")),
                             QStringLiteral("id")};
    QCommandLineOption view{QStringLiteral("view"),
                            QStringLiteral("What the canvas shows: %1, or difference as with --compare.")
                                .arg(CanvasViews::viewNames().join(", ")),
                            QStringLiteral("name")};
    QCommandLineOption overlay{
        QStringLiteral("overlay"),
        QStringLiteral("Lays something over the picture; may repeat: %1.").arg(CanvasViews::overlayNames().join(", ")),
        QStringLiteral("name")};
    QCommandLineOption pixel{QStringLiteral("pixel"), QStringLiteral("Selects a pixel of the picture."),
                             QStringLiteral("x,y")};
    QCommandLineOption step{QStringLiteral("step"),
                            QStringLiteral("Opens the step mode at a place of the record: %1.").arg(stepPlaceHelp()),
                            QStringLiteral("where")};
    QCommandLineOption identify{QStringLiteral("identify"),
                                QStringLiteral("Says which mistake made the picture <file> of this scene."),
                                QStringLiteral("file")};
    QCommandLineOption referee{QStringLiteral("referee"),
                               QStringLiteral("Checks the picture against the exact reference.")};
    QCommandLineOption reference{
        QStringLiteral("reference"),
        QStringLiteral("The same, from clip space (exact) or from object space (exact-object): that judges the vertex "
                       "stage as well."),
        QStringLiteral("exact|exact-object")};
    QCommandLineOption measure{
        QStringLiteral("measure"),
        QStringLiteral("Measures speed against error, <frames> frames a variant (with --panel experiment)."),
        QStringLiteral("frames")};
    QCommandLineOption compare{
        QStringLiteral("compare"),
        QStringLiteral("Compares with the picture without mistakes or as the scene asks: wipe, blink or difference."),
        QStringLiteral("view")};

    QCommandLineOption model{QStringLiteral("model"),
                             QStringLiteral("Opens the session with this model in place of the one that it names."),
                             QStringLiteral("file")};
    QCommandLineOption allowOutside{
        QStringLiteral("allow-outside"),
        QStringLiteral("Models, sessions and lessons may name files outside their own folders; without it those are "
                       "not read.")};

    FigureOptions figure;
    PageOptions page;
    QCommandLineOption lesson{QStringLiteral("lesson"),
                              QStringLiteral("Opens a lesson: the id of a built-in one, or a .json file."),
                              QStringLiteral("name")};
    QCommandLineOption slide{QStringLiteral("slide"),
                             QStringLiteral("The slide of the lesson, counted from 1; its question is skipped."),
                             QStringLiteral("n")};
    QCommandLineOption ask{QStringLiteral("ask"), QStringLiteral("Leaves the question of the slide open.")};
    QCommandLineOption presentation{QStringLiteral("presentation"), QStringLiteral("Opens the presentation (F11).")};
    QCommandLineOption guide{QStringLiteral("guide"),
                             QStringLiteral("Opens the guide; a --screenshot is one of its window then.")};
    QCommandLineOption keys{
        QStringLiteral("keys"),
        QStringLiteral("Prints the keys as a table in Markdown, in English or in --language, and exits.")};

    [[nodiscard]] QList<QCommandLineOption> all() const
    {
        return QList<QCommandLineOption>{help,      version, screenshot, windowSize,  language, theme,    panel,
                                         topic,     view,    overlay,    pixel,       step,     identify, referee,
                                         reference, compare, measure,    lesson,      slide,    ask,      presentation,
                                         guide,     keys,    model,      allowOutside} +
               figure.all() + page.all();
    }
};

/// Reads the options about the window and its look.
///
/// out  why one of them is refused
std::optional<QString> readLook(const QCommandLineParser& parser, const Options& options, Arguments& arguments)
{
    if (parser.isSet(options.windowSize)) {
        arguments.windowSize = typedSize(parser.value(options.windowSize), kMaxViewport);
        if (!arguments.windowSize)
            return QStringLiteral("--size-window takes WIDTHxHEIGHT");
    }
    if (parser.isSet(options.language)) {
        arguments.language = languageOf(parser.value(options.language));
        if (!arguments.language)
            return QStringLiteral("--language takes en or zh, also with a country: zh_CN");
    }
    if (parser.isSet(options.theme)) {
        const QString value = parser.value(options.theme);
        if (value != QLatin1String("light") && value != QLatin1String("dark"))
            return QStringLiteral("--theme takes light or dark");
        arguments.theme = value == QLatin1String("dark") ? ThemeKind::Dark : ThemeKind::Light;
    }
    if (parser.isSet(options.panel)) {
        arguments.panel = parser.value(options.panel);
        if (!panelNames().contains(arguments.panel))
            return QStringLiteral("--panel takes %1").arg(panelNames().join(", "));
    }
    if (parser.isSet(options.topic)) {
        arguments.topic = derivationTopic(parser.value(options.topic));
        if (!arguments.topic)
            return QStringLiteral("--topic takes %1").arg(topicIds().join(", "));
    }
    return std::nullopt;
}

/// Reads the options about the canvas.
///
/// out  why one of them is refused
std::optional<QString> readCanvas(const QCommandLineParser& parser, const Options& options, Arguments& arguments)
{
    arguments.view = parser.value(options.view);
    if (arguments.view == QLatin1String("difference")) {
        arguments.view.clear();
        arguments.compare = CompareView::Difference;
    } else if (parser.isSet(options.view) && !CanvasViews::viewNames().contains(arguments.view)) {
        return QStringLiteral("--view takes %1, difference").arg(CanvasViews::viewNames().join(", "));
    }
    arguments.overlays = parser.values(options.overlay);
    for (const QString& name : arguments.overlays)
        if (!CanvasViews::overlayNames().contains(name))
            return QStringLiteral("--overlay takes %1").arg(CanvasViews::overlayNames().join(", "));
    if (parser.isSet(options.pixel)) {
        arguments.pixel = typedPoint(parser.value(options.pixel));
        if (!arguments.pixel || arguments.pixel->x() < 0 || arguments.pixel->y() < 0)
            return QStringLiteral("--pixel: \"%1\" is not a pixel; expected: x,y").arg(parser.value(options.pixel));
    }
    return std::nullopt;
}

/// Reads the options about how right the picture is.
///
/// out  why one of them is refused
std::optional<QString> readTruth(const QCommandLineParser& parser, const Options& options, Arguments& arguments)
{
    arguments.referee = parser.isSet(options.referee) || parser.isSet(options.reference);
    if (parser.isSet(options.reference)) {
        const QString value = parser.value(options.reference);
        if (value == QLatin1String("exact-object"))
            arguments.reference = ReferenceSpace::Object;
        else if (value != QLatin1String("exact"))
            return QStringLiteral("--reference takes exact or exact-object");
    }
    arguments.measuredFrames = parser.value(options.measure).toInt();
    if (parser.isSet(options.measure) && arguments.measuredFrames < 1)
        return QStringLiteral("--measure takes a number of frames");
    if (parser.isSet(options.compare)) {
        const std::map<QString, CompareView> views{{QStringLiteral("wipe"), CompareView::Wipe},
                                                   {QStringLiteral("blink"), CompareView::Blink},
                                                   {QStringLiteral("difference"), CompareView::Difference}};
        const auto view = views.find(parser.value(options.compare));
        if (view == views.end())
            return QStringLiteral("--compare takes wipe, blink, difference");
        arguments.compare = view->second;
    }
    return std::nullopt;
}

/// Reads the options about a lesson.
///
/// out  why one of them is refused
std::optional<QString> readLesson(const QCommandLineParser& parser, const Options& options, Arguments& arguments)
{
    arguments.lesson = parser.value(options.lesson);
    arguments.asks = parser.isSet(options.ask);
    arguments.presentation = parser.isSet(options.presentation);
    if (arguments.lesson.isEmpty() && isLesson(arguments.scene))
        arguments.lesson = std::exchange(arguments.scene, {});
    if (!arguments.lesson.isEmpty() && !arguments.scene.isEmpty())
        return QStringLiteral("--lesson: a lesson brings its own scenes");
    if ((parser.isSet(options.slide) || arguments.asks) && arguments.lesson.isEmpty())
        return QStringLiteral("--slide and --ask need --lesson");
    if (!parser.isSet(options.slide))
        return std::nullopt;
    arguments.slide = parser.value(options.slide).toInt();
    return arguments.slide < 1 ? std::optional(QStringLiteral("--slide takes a number from 1 on")) : std::nullopt;
}

/// Reads all words but --help and --version.
///
/// out  why one of them is refused
std::optional<QString> readAll(const QCommandLineParser& parser, const Options& options, Arguments& arguments)
{
    if (parser.positionalArguments().size() > 1)
        return QStringLiteral("more than one scene given");
    arguments.scene = parser.positionalArguments().value(0);
    arguments.keys = parser.isSet(options.keys);
    arguments.guide = parser.isSet(options.guide);
    arguments.allowOutside = parser.isSet(options.allowOutside);
    arguments.model = parser.value(options.model);
    if (parser.isSet(options.model) && !isSession(arguments.scene))
        return QStringLiteral("--model needs a session");
    arguments.identify = parser.value(options.identify);
    arguments.screenshot = parser.value(options.screenshot);
    if (parser.isSet(options.screenshot) && arguments.screenshot.isEmpty())
        return QStringLiteral("--screenshot needs a file");
    if (const auto why = whyNotFormat(arguments.screenshot, pictureSuffixes()))
        return QStringLiteral("--screenshot %1: %2").arg(arguments.screenshot, textOf(*why));
    arguments.step = parser.value(options.step);
    if (parser.isSet(options.step) && !StepMode::isPlace(arguments.step))
        return QStringLiteral("--step takes %1").arg(stepPlaceHelp());
    if (const auto why = readLook(parser, options, arguments))
        return why;
    if (const auto why = readCanvas(parser, options, arguments))
        return why;
    if (const auto why = readFigure(parser, options.figure, arguments.figure))
        return why;
    if (const auto why = readPage(parser, options.page, arguments.page))
        return why;
    arguments.page.scene = arguments.scene;
    arguments.page.model = arguments.model;
    arguments.page.outside = arguments.allowOutside ? Outside::Allow : Outside::Refuse;
    arguments.page.step = arguments.step;
    arguments.page.chosen = arguments.pixel;
    if (!arguments.page.path.isEmpty() && arguments.scene.isEmpty())
        return QStringLiteral("--page needs a scene");
    if (const auto why = readLesson(parser, options, arguments))
        return why;
    return readTruth(parser, options, arguments);
}

} // namespace

void printError(const QString& text) { std::fprintf(stderr, "%s\n", qPrintable(text)); }

ParsedArguments parseArguments(const QStringList& words)
{
    const Options options;
    QCommandLineParser parser;
    parser.setApplicationDescription(QStringLiteral("Shows how a triangle becomes pixels."));
    parser.addOptions(options.all());
    parser.addPositionalArgument(QStringLiteral("scene"),
                                 QStringLiteral("An .obj, a .case, a session .json, builtin:NAME or stress:NAME."),
                                 QStringLiteral("[scene]"));
    if (!parser.parse(words))
        return refuse(parser.errorText());
    if (parser.isSet(options.help)) {
        QString text = parser.helpText(); // there is no QApplication yet that knows the program's name
        std::fputs(qPrintable(text.replace(QLatin1String("<executable_name>"), QLatin1String("rasterlens"))), stdout);
        return {};
    }
    if (parser.isSet(options.version)) {
        std::printf("rasterlens %s\n", RASTERLENS_VERSION);
        return {};
    }
    Arguments arguments;
    if (const auto why = readAll(parser, options, arguments))
        return refuse(*why);
    return {arguments, kFine};
}

} // namespace rasterlens
