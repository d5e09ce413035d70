#include "app/gui_figure.h"
#include "app/gui_page.h"
#include "core/base/typed_numbers.h"
#include "core/io/file_writer.h"
#include "core/io/picture_file.h"
#include "ui/base/image_export.h"
#include "ui/base/settings_file.h"
#include "ui/face/cards.h"
#include "ui/face/derivation_panel.h"
#include "ui/lessons/lesson_mode.h"
#include "ui/pipeline/canvas_views.h"
#include "ui/pipeline/mistakes_section.h"
#include "ui/pipeline/pipeline_panel.h"
#include "ui/steps/step_mode.h"
#include "ui/truth/experiment_panel.h"
#include "ui/truth/truth_mode.h"
#include "ui/window/end_signals.h"
#include "ui/window/guide_window.h"
#include "ui/window/main_window.h"
#include "ui/window/window_moment.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QTimer>

#include <csignal>
#include <cstdio>
#include <map>
#include <optional>
#include <utility>

namespace
{

enum ExitCode { kFine = 0, kBadArguments = 2, kInvalidInput = 3 };

void printError(const QString& text) { std::fprintf(stderr, "%s\n", qPrintable(text)); }

/// Without a display the window is drawn in memory.
void choosePlatform()
{
    const bool hasDisplay = qEnvironmentVariableIsSet("DISPLAY") || qEnvironmentVariableIsSet("WAYLAND_DISPLAY");
    if (!hasDisplay && !qEnvironmentVariableIsSet("QT_QPA_PLATFORM"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
}

struct Arguments {
    QString scene;
    QString screenshot;
    QString step;
    QString identify;
    rasterlens::FigureArguments figure;
    rasterlens::PageArguments page;
    std::optional<QSize> windowSize;
    QString panel;
    std::optional<rasterlens::DerivationTopic> topic;
    QString view;
    QStringList overlays;
    std::optional<QPoint> pixel;
    bool referee = false;
    rasterlens::ReferenceSpace reference = rasterlens::ReferenceSpace::Clip;
    int measuredFrames = 0;
    rasterlens::CompareView compare = rasterlens::CompareView::Off;
    std::optional<rasterlens::LanguageKind> language;
    std::optional<rasterlens::ThemeKind> theme;
    bool keys = false;
    QString lesson;
    int slide = 1;     ///< counted from 1
    bool asks = false; ///< the slide's question is open
    bool presentation = false;
    bool guide = false;
};

QStringList panelNames()
{
    return rasterlens::Cards::names() + rasterlens::TruthMode::panelNames() + QStringList{QStringLiteral("mistakes")};
}

QStringList topicIds()
{
    QStringList ids;
    for (const rasterlens::DerivationTopicInfo& info : rasterlens::derivationTopics())
        ids << QLatin1String(info.id);
    return ids;
}

struct ParsedArguments {
    std::optional<Arguments> arguments;
    int exitCode = kFine;
};

ParsedArguments refuse(const QString& why)
{
    printError(QStringLiteral("rasterlens: %1 (try --help)").arg(why));
    return {std::nullopt, kBadArguments};
}

/// The language that a locale names: `zh`, `zh_CN`, `zh-Hans`, `en_GB.UTF-8` and the like.
std::optional<rasterlens::LanguageKind> languageOf(const QString& locale)
{
    const QString language =
        QString(locale).replace(QLatin1Char('-'), QLatin1Char('_')).section(QLatin1Char('_'), 0, 0);
    if (language == QLatin1String("zh"))
        return rasterlens::LanguageKind::Chinese;
    if (language == QLatin1String("en"))
        return rasterlens::LanguageKind::English;
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
            .arg(rasterlens::pictureSuffixes().join(QStringLiteral(", "))),
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
                                .arg(rasterlens::CanvasViews::viewNames().join(", ")),
                            QStringLiteral("name")};
    QCommandLineOption overlay{QStringLiteral("overlay"),
                               QStringLiteral("Lays something over the picture; may repeat: %1.")
                                   .arg(rasterlens::CanvasViews::overlayNames().join(", ")),
                               QStringLiteral("name")};
    QCommandLineOption pixel{QStringLiteral("pixel"), QStringLiteral("Selects a pixel of the picture."),
                             QStringLiteral("x,y")};
    QCommandLineOption step{
        QStringLiteral("step"),
        QStringLiteral("Opens the step mode at a place of the record: %1.").arg(rasterlens::stepPlaceHelp()),
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

    rasterlens::FigureOptions figure;
    rasterlens::PageOptions page;
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
        return QList<QCommandLineOption>{help,     version, screenshot,   windowSize, language, theme,
                                         panel,    topic,   view,         overlay,    pixel,    step,
                                         identify, referee, reference,    compare,    measure,  lesson,
                                         slide,    ask,     presentation, guide,      keys} +
               figure.all() + page.all();
    }
};

/// Reads the options about the window and its look.
///
/// out  why one of them is refused
std::optional<QString> readLook(const QCommandLineParser& parser, const Options& options, Arguments& arguments)
{
    if (parser.isSet(options.windowSize)) {
        arguments.windowSize = rasterlens::typedSize(parser.value(options.windowSize), rasterlens::kMaxViewport);
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
        arguments.theme = value == QLatin1String("dark") ? rasterlens::ThemeKind::Dark : rasterlens::ThemeKind::Light;
    }
    if (parser.isSet(options.panel)) {
        arguments.panel = parser.value(options.panel);
        if (!panelNames().contains(arguments.panel))
            return QStringLiteral("--panel takes %1").arg(panelNames().join(", "));
    }
    if (parser.isSet(options.topic)) {
        arguments.topic = rasterlens::derivationTopic(parser.value(options.topic));
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
    using rasterlens::CanvasViews;
    arguments.view = parser.value(options.view);
    if (arguments.view == QLatin1String("difference")) {
        arguments.view.clear();
        arguments.compare = rasterlens::CompareView::Difference;
    } else if (parser.isSet(options.view) && !CanvasViews::viewNames().contains(arguments.view)) {
        return QStringLiteral("--view takes %1, difference").arg(CanvasViews::viewNames().join(", "));
    }
    arguments.overlays = parser.values(options.overlay);
    for (const QString& name : arguments.overlays)
        if (!CanvasViews::overlayNames().contains(name))
            return QStringLiteral("--overlay takes %1").arg(CanvasViews::overlayNames().join(", "));
    if (parser.isSet(options.pixel)) {
        arguments.pixel = rasterlens::typedPoint(parser.value(options.pixel));
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
            arguments.reference = rasterlens::ReferenceSpace::Object;
        else if (value != QLatin1String("exact"))
            return QStringLiteral("--reference takes exact or exact-object");
    }
    arguments.measuredFrames = parser.value(options.measure).toInt();
    if (parser.isSet(options.measure) && arguments.measuredFrames < 1)
        return QStringLiteral("--measure takes a number of frames");
    if (parser.isSet(options.compare)) {
        using rasterlens::CompareView;
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
    if (arguments.lesson.isEmpty() && rasterlens::isLesson(arguments.scene))
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
    arguments.identify = parser.value(options.identify);
    arguments.screenshot = parser.value(options.screenshot);
    if (parser.isSet(options.screenshot) && arguments.screenshot.isEmpty())
        return QStringLiteral("--screenshot needs a file");
    if (const auto why = rasterlens::whyNotFormat(arguments.screenshot, rasterlens::pictureSuffixes()))
        return QStringLiteral("--screenshot %1: %2").arg(arguments.screenshot, rasterlens::textOf(*why));
    arguments.step = parser.value(options.step);
    if (parser.isSet(options.step) && !rasterlens::StepMode::isPlace(arguments.step))
        return QStringLiteral("--step takes %1").arg(rasterlens::stepPlaceHelp());
    if (const auto why = readLook(parser, options, arguments))
        return why;
    if (const auto why = readCanvas(parser, options, arguments))
        return why;
    if (const auto why = rasterlens::readFigure(parser, options.figure, arguments.figure))
        return why;
    if (const auto why = rasterlens::readPage(parser, options.page, arguments.page))
        return why;
    arguments.page.scene = arguments.scene;
    arguments.page.step = arguments.step;
    arguments.page.chosen = arguments.pixel;
    if (!arguments.page.path.isEmpty() && arguments.scene.isEmpty())
        return QStringLiteral("--page needs a scene");
    if (const auto why = readLesson(parser, options, arguments))
        return why;
    return readTruth(parser, options, arguments);
}

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

void openPanel(rasterlens::MainWindow& window, const QString& name)
{
    if (!window.cards().show(name) && !window.truthMode().showPanel(name))
        window.pipelinePanel().mistakes().setOpen(true);
}

/// Renders the window as soon as all in it is computed.
void takeScreenshot(rasterlens::MainWindow& window, const QString& path)
{
    // At least one turn of the event loop lets the layout follow the counters' widths.
    constexpr int kWaitMs = 20;
    QTimer::singleShot(kWaitMs, &window, [&window, path] {
        if (!window.isComplete()) {
            takeScreenshot(window, path);
            return;
        }
        const QStringList inputs = window.document().inputFiles();
        const bool overInput = rasterlens::whyNotOver(path, inputs).has_value();
        const QImage picture = window.guide().isVisible() ? window.guide().grab().toImage() : window.picture();
        const auto error = rasterlens::savePicture(picture, {path, inputs, true});
        if (error)
            printError(*error);
        QApplication::exit(overInput ? kBadArguments : error ? kInvalidInput : kFine);
    });
}

void openGuide(rasterlens::MainWindow& window, const Arguments& arguments)
{
    window.guide().open();
    if (arguments.windowSize)
        window.guide().resize(*arguments.windowSize);
}

/// Prints the list of keys, which a window in memory knows.
ExitCode printKeys(int& argc, char** argv, const Arguments& arguments)
{
    if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
    const QApplication application(argc, argv);
    rasterlens::MainWindow window(rasterlens::MainWindow::Memory::Forget);
    window.setLanguage(arguments.language.value_or(rasterlens::LanguageKind::English));
    QCoreApplication::sendPostedEvents(); // the window changes its language
    const QByteArray text = window.actionTable().markdown().toUtf8();
    const bool written = std::fwrite(text.constData(), 1, std::size_t(text.size()), stdout) == std::size_t(text.size());
    if (std::fflush(stdout) == 0 && written)
        return kFine;
    printError(QStringLiteral("rasterlens: the keys could not be written"));
    return kInvalidInput;
}

/// Keeps what the window holds when the system ends the program or the session.
void keepAllAtTheEnd(const QApplication& application, const rasterlens::EndSignals& signals,
                     rasterlens::MainWindow& window)
{
    constexpr int kEndedBySignal = 128; // shells count from here
    QObject::connect(&signals, &rasterlens::EndSignals::received, &window, [&window](int signal) {
        window.keepAll();
        QApplication::exit(kEndedBySignal + signal);
    });
    QObject::connect(
        &application, &QGuiApplication::commitDataRequest, &window, [&window] { window.keepAll(); },
        Qt::DirectConnection);
}

/// Opens the lesson that the arguments name.
///
/// out  fine, or the exit code after an error message
ExitCode startLesson(rasterlens::MainWindow& window, const Arguments& arguments)
{
    using rasterlens::LessonPlayer;
    rasterlens::LessonMode& lessons = window.lessons();
    QObject loading;
    QObject::connect(&lessons, &rasterlens::LessonMode::reported, &loading,
                     [](const rasterlens::Diagnostics& diagnostics) {
                         for (const rasterlens::Diagnostic& diagnostic : diagnostics)
                             printError(diagnostic.text());
                     });
    if (!lessons.open(arguments.lesson))
        return kInvalidInput;
    const std::size_t count = lessons.player().lesson().slides.size();
    if (static_cast<std::size_t>(arguments.slide) > count) {
        printError(QStringLiteral("rasterlens: --slide takes a number from 1 to %1").arg(count));
        return kBadArguments;
    }
    lessons.player().goTo(static_cast<std::size_t>(arguments.slide - 1), arguments.asks || arguments.slide == 1
                                                                             ? LessonPlayer::Entry::Asks
                                                                             : LessonPlayer::Entry::Skips);
    return kFine;
}

/// Opens what the arguments name, or what a start without any shows.
///
/// out  fine, or the exit code after an error message
ExitCode openFirst(rasterlens::MainWindow& window, const Arguments& arguments, bool hasArguments)
{
    if (!arguments.lesson.isEmpty())
        return startLesson(window, arguments);
    if (!hasArguments)
        window.openAtStart();
    else if (arguments.scene.isEmpty())
        window.openDefaultScene();
    else
        window.document().open(arguments.scene);
    return kFine;
}

/// Compares as the arguments ask for; a slide says itself how it is compared.
void compare(rasterlens::MainWindow& window, const Arguments& arguments)
{
    const bool isSlide = !arguments.lesson.isEmpty();
    if (!isSlide || arguments.referee) {
        window.truthMode().referee().setSpace(arguments.reference);
        window.truthMode().referee().setOn(arguments.referee);
    }
    if (!isSlide || arguments.compare != rasterlens::CompareView::Off)
        window.truthMode().comparison().setView(arguments.compare);
}

/// Does what the arguments ask for once the first picture is there. A scene named on the command line must open; later
/// ones only leave a message in the window.
///
/// in  `starting` lives as long as the window's event loop; its connections end with the start
void startWith(rasterlens::MainWindow& window, const Arguments& arguments, QObject& starting)
{
    QObject::connect(&window.document(), &rasterlens::Document::diagnosticsReported, &starting,
                     [](const rasterlens::Diagnostics& diagnostics) {
                         for (const rasterlens::Diagnostic& diagnostic : diagnostics)
                             printError(diagnostic.text());
                         if (rasterlens::hasErrors(diagnostics))
                             QApplication::exit(kInvalidInput);
                     });
    QObject::connect(&window.stepMode(), &rasterlens::StepMode::placeMissed, &starting, [](const QString& place) {
        printError(QStringLiteral("rasterlens: with these settings the record has no step \"%1\"").arg(place));
        QApplication::exit(kBadArguments);
    });
    QObject::connect(&window, &rasterlens::MainWindow::settled, &starting,
                     [&window, &starting, arguments, step = arguments.step]() mutable {
                         if (window.moment().isPending())
                             return;
                         if (!step.isEmpty()) {
                             window.stepMode().showStep(std::exchange(step, {}));
                             return;
                         }
                         window.disconnect(&starting);
                         window.document().disconnect(&starting);
                         window.stepMode().disconnect(&starting);
                         if (arguments.pixel)
                             window.viewport().selectPixel(arguments.pixel);
                         if (!arguments.view.isEmpty())
                             window.canvasViews().setViewNamed(arguments.view);
                         for (const QString& overlay : arguments.overlays)
                             window.canvasViews().setOverlayNamed(overlay, true);
                         compare(window, arguments);
                         if (arguments.measuredFrames > 0)
                             window.truthMode().experiment().run(arguments.measuredFrames);
                         if (!arguments.panel.isEmpty())
                             openPanel(window, arguments.panel);
                         if (!arguments.identify.isEmpty())
                             window.identifyPicture(arguments.identify);
                         if (arguments.topic) {
                             window.cards().derivationPanel().setTopic(*arguments.topic);
                             openPanel(window, QStringLiteral("derive"));
                         }
                         if (arguments.guide)
                             openGuide(window, arguments);
                         if (!arguments.screenshot.isEmpty())
                             takeScreenshot(window, arguments.screenshot);
                         if (!arguments.figure.path.isEmpty()) {
                             rasterlens::prepareFigure(window, arguments.figure);
                             rasterlens::writeFigure(window, arguments.figure);
                         }
                     });
}

QStringList wordsOf(int argc, char** argv)
{
    QStringList words;
    for (int i = 0; i < argc; ++i)
        words << QString::fromLocal8Bit(argv[i]);
    return words;
}

} // namespace

int main(int argc, char** argv)
{
    QCoreApplication::setApplicationName(QStringLiteral("RasterLens"));
    QCoreApplication::setOrganizationName(QStringLiteral("RasterLens"));
    QCoreApplication::setApplicationVersion(QStringLiteral(RASTERLENS_VERSION));
    const ParsedArguments parsed = parseArguments(wordsOf(argc, argv));
    if (!parsed.arguments)
        return parsed.exitCode;
    const Arguments& arguments = *parsed.arguments;
    for (const QString& path : {arguments.screenshot, arguments.figure.path, arguments.page.path})
        if (const auto why = rasterlens::whyNotWritable(path); why && !path.isEmpty()) {
            printError(QStringLiteral("%1: cannot be written: %2").arg(path, rasterlens::textOf(*why)));
            return kInvalidInput;
        }
#ifdef Q_OS_UNIX
    std::signal(SIGPIPE, SIG_IGN); // a pipe whose reader has gone is an error message, not the end of the window
#endif

    if (arguments.keys)
        return printKeys(argc, argv, arguments);
    if (!arguments.page.path.isEmpty()) {
        const QCoreApplication application(argc, argv);
        return rasterlens::writePage(arguments.page);
    }
    choosePlatform();
    QApplication application(argc, argv);
    rasterlens::useSettingsFormat();
    const rasterlens::EndSignals endSignals;
    const bool forScreenshot = !arguments.screenshot.isEmpty() || !arguments.figure.path.isEmpty();
    using rasterlens::MainWindow;
    MainWindow window(forScreenshot ? MainWindow::Memory::Forget : MainWindow::Memory::Remember);
    keepAllAtTheEnd(application, endSignals, window);
    if (arguments.language)
        window.setLanguage(*arguments.language);
    if (arguments.theme)
        window.setLook({*arguments.theme, false});
    constexpr QSize kPictureSize(1440, 900); // on no screen: none limits it
    if (arguments.windowSize || forScreenshot)
        window.resize(arguments.windowSize.value_or(kPictureSize));

    QObject starting;
    startWith(window, arguments, starting);
    if (const ExitCode code = openFirst(window, arguments, argc > 1); code != kFine)
        return code;
    window.show();
    if (arguments.presentation)
        window.setPresentation(true);
    if (arguments.presentation && forScreenshot) { // of the size that is asked for, not that of a screen
        window.showNormal();
        window.resize(arguments.windowSize.value_or(kPictureSize));
    }
    const int exitCode = QApplication::exec();
    if (const QString problem = rasterlens::settingsProblem(); !forScreenshot && !problem.isEmpty())
        printError(QStringLiteral("what the window remembers could not be kept: %1").arg(problem));
    return exitCode;
}
