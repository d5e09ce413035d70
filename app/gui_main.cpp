#include "core/base/typed_numbers.h"
#include "core/io/file_writer.h"
#include "core/io/picture_file.h"
#include "ui/base/image_export.h"
#include "ui/base/settings_file.h"
#include "ui/face/cards.h"
#include "ui/pipeline/mistakes_section.h"
#include "ui/pipeline/pipeline_panel.h"
#include "ui/steps/step_mode.h"
#include "ui/truth/experiment_panel.h"
#include "ui/truth/truth_mode.h"
#include "ui/window/end_signals.h"
#include "ui/window/main_window.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QTimer>

#include <csignal>
#include <cstdio>
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
    std::optional<QSize> windowSize;
    QString panel;
    std::optional<QPoint> pixel;
    bool referee = false;
    rasterlens::ReferenceSpace reference = rasterlens::ReferenceSpace::Clip;
    int measuredFrames = 0;
    rasterlens::CompareView compare = rasterlens::CompareView::Off;
    std::optional<rasterlens::LanguageKind> language;
    std::optional<rasterlens::ThemeKind> theme;
};

QStringList panelNames()
{
    return rasterlens::Cards::names() + rasterlens::TruthMode::panelNames() + QStringList{QStringLiteral("mistakes")};
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

ParsedArguments parseArguments(const QStringList& words)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(QStringLiteral("Shows how a triangle becomes pixels."));
    const QCommandLineOption help({QStringLiteral("h"), QStringLiteral("help")}, QStringLiteral("Shows this list."));
    const QCommandLineOption version({QStringLiteral("v"), QStringLiteral("version")},
                                     QStringLiteral("Shows the version."));
    const QCommandLineOption screenshot(
        QStringLiteral("screenshot"),
        QStringLiteral("Writes the window as a picture to <file> and exits; needs no display. The suffix tells the "
                       "format: %1; - is stdout.")
            .arg(rasterlens::pictureSuffixes().join(QStringLiteral(", "))),
        QStringLiteral("file"));
    const QCommandLineOption windowSize(QStringLiteral("size-window"), QStringLiteral("Size of the window in pixels."),
                                        QStringLiteral("WxH"));
    const QCommandLineOption language(QStringLiteral("language"),
                                      QStringLiteral("Language of the window: en or zh, also zh_CN and the like."),
                                      QStringLiteral("en|zh"));
    const QCommandLineOption theme(QStringLiteral("theme"), QStringLiteral("Colours of the window: light or dark."),
                                   QStringLiteral("light|dark"));
    const QCommandLineOption panel(QStringLiteral("panel"),
                                   QStringLiteral("Opens a panel: %1.").arg(panelNames().join(", ")),
                                   QStringLiteral("name"));
    const QCommandLineOption pixel(QStringLiteral("pixel"), QStringLiteral("Selects a pixel of the picture."),
                                   QStringLiteral("x,y"));
    const QCommandLineOption step(
        QStringLiteral("step"),
        QStringLiteral("Opens the step mode at a position, or at the first tie, sign-change, depth-fail, clip or nan."),
        QStringLiteral("where"));
    const QCommandLineOption referee(QStringLiteral("referee"),
                                     QStringLiteral("Checks the picture against the exact reference."));
    const QCommandLineOption reference(
        QStringLiteral("reference"),
        QStringLiteral("The same, from clip space (exact) or from object space (exact-object): that judges the vertex "
                       "stage as well."),
        QStringLiteral("exact|exact-object"));
    const QCommandLineOption measure(
        QStringLiteral("measure"),
        QStringLiteral("Measures speed against error, <frames> frames a variant (with --panel experiment)."),
        QStringLiteral("frames"));
    const QCommandLineOption compare(
        QStringLiteral("compare"),
        QStringLiteral("Compares with the picture without mistakes or as the scene asks: wipe, blink or difference."),
        QStringLiteral("view"));
    parser.addOptions({help, version, screenshot, windowSize, language, theme, panel, pixel, step, referee, reference,
                       compare, measure});
    parser.addPositionalArgument(QStringLiteral("scene"),
                                 QStringLiteral("An .obj, a .case, a session .json, builtin:NAME or stress:NAME."),
                                 QStringLiteral("[scene]"));
    if (!parser.parse(words))
        return refuse(parser.errorText());
    if (parser.isSet(help)) {
        QString text = parser.helpText(); // there is no QApplication yet that knows the program's name
        std::fputs(qPrintable(text.replace(QLatin1String("<executable_name>"), QLatin1String("rasterlens"))), stdout);
        return {};
    }
    if (parser.isSet(version)) {
        std::printf("rasterlens %s\n", RASTERLENS_VERSION);
        return {};
    }

    Arguments arguments;
    if (parser.positionalArguments().size() > 1)
        return refuse(QStringLiteral("more than one scene given"));
    arguments.scene = parser.positionalArguments().value(0);
    arguments.screenshot = parser.value(screenshot);
    if (parser.isSet(screenshot) && arguments.screenshot.isEmpty())
        return refuse(QStringLiteral("--screenshot needs a file"));
    if (const auto why = rasterlens::whyNotFormat(arguments.screenshot, rasterlens::pictureSuffixes()))
        return refuse(QStringLiteral("--screenshot %1: %2").arg(arguments.screenshot, rasterlens::textOf(*why)));
    arguments.step = parser.value(step);
    if (parser.isSet(step) && !rasterlens::StepMode::isPlace(arguments.step))
        return refuse(QStringLiteral("--step takes a position, tie, sign-change, depth-fail, clip or nan"));
    if (parser.isSet(windowSize)) {
        arguments.windowSize = rasterlens::typedSize(parser.value(windowSize), rasterlens::kMaxViewport);
        if (!arguments.windowSize)
            return refuse(QStringLiteral("--size-window takes WIDTHxHEIGHT"));
    }
    if (parser.isSet(language)) {
        arguments.language = languageOf(parser.value(language));
        if (!arguments.language)
            return refuse(QStringLiteral("--language takes en or zh, also with a country: zh_CN"));
    }
    if (parser.isSet(theme)) {
        const QString value = parser.value(theme);
        if (value != QLatin1String("light") && value != QLatin1String("dark"))
            return refuse(QStringLiteral("--theme takes light or dark"));
        arguments.theme = value == QLatin1String("dark") ? rasterlens::ThemeKind::Dark : rasterlens::ThemeKind::Light;
    }
    if (parser.isSet(panel)) {
        arguments.panel = parser.value(panel);
        if (!panelNames().contains(arguments.panel))
            return refuse(QStringLiteral("--panel takes %1").arg(panelNames().join(", ")));
    }
    arguments.referee = parser.isSet(referee) || parser.isSet(reference);
    if (parser.isSet(reference)) {
        const QString value = parser.value(reference);
        if (value == QLatin1String("exact-object"))
            arguments.reference = rasterlens::ReferenceSpace::Object;
        else if (value != QLatin1String("exact"))
            return refuse(QStringLiteral("--reference takes exact or exact-object"));
    }
    arguments.measuredFrames = parser.value(measure).toInt();
    if (parser.isSet(measure) && arguments.measuredFrames < 1)
        return refuse(QStringLiteral("--measure takes a number of frames"));
    if (parser.isSet(compare)) {
        const QStringList views{QStringLiteral("wipe"), QStringLiteral("blink"), QStringLiteral("difference")};
        const qsizetype view = views.indexOf(parser.value(compare));
        if (view < 0)
            return refuse(QStringLiteral("--compare takes %1").arg(views.join(QStringLiteral(", "))));
        arguments.compare = static_cast<rasterlens::CompareView>(view + 1);
    }
    if (parser.isSet(pixel)) {
        arguments.pixel = rasterlens::typedPoint(parser.value(pixel));
        if (!arguments.pixel || arguments.pixel->x() < 0 || arguments.pixel->y() < 0)
            return refuse(QStringLiteral("--pixel: \"%1\" is not a pixel; expected: x,y").arg(parser.value(pixel)));
    }
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
        const auto error = rasterlens::savePicture(window.picture(), {path, inputs, true});
        if (error)
            printError(*error);
        QApplication::exit(overInput ? kBadArguments : error ? kInvalidInput : kFine);
    });
}

} // namespace

int main(int argc, char** argv)
{
    QCoreApplication::setApplicationName(QStringLiteral("RasterLens"));
    QCoreApplication::setOrganizationName(QStringLiteral("RasterLens"));
    QCoreApplication::setApplicationVersion(QStringLiteral(RASTERLENS_VERSION));
    QStringList words;
    for (int i = 0; i < argc; ++i)
        words << QString::fromLocal8Bit(argv[i]);
    const ParsedArguments parsed = parseArguments(words);
    if (!parsed.arguments)
        return parsed.exitCode;
    const Arguments& arguments = *parsed.arguments;

    if (const auto why = rasterlens::whyNotWritable(arguments.screenshot); why && !arguments.screenshot.isEmpty()) {
        printError(QStringLiteral("%1: cannot be written: %2").arg(arguments.screenshot, rasterlens::textOf(*why)));
        return kInvalidInput;
    }
#ifdef Q_OS_UNIX
    std::signal(SIGPIPE, SIG_IGN); // a pipe whose reader has gone is an error message, not the end of the window
#endif

    choosePlatform();
    QApplication application(argc, argv);
    rasterlens::useSettingsFormat();
    constexpr int kEndedBySignal = 128; // shells count from here
    const rasterlens::EndSignals endSignals;
    const bool forScreenshot = !arguments.screenshot.isEmpty();
    using rasterlens::MainWindow;
    MainWindow window(forScreenshot ? MainWindow::Memory::Forget : MainWindow::Memory::Remember);
    QObject::connect(&endSignals, &rasterlens::EndSignals::received, &window, [&window](int signal) {
        window.keepAll();
        QApplication::exit(kEndedBySignal + signal);
    });
    QObject::connect(
        &application, &QGuiApplication::commitDataRequest, &window, [&window] { window.keepAll(); },
        Qt::DirectConnection);
    if (arguments.language)
        window.setLanguage(*arguments.language);
    if (arguments.theme)
        window.setLook({*arguments.theme, false});
    constexpr QSize kPictureSize(1440, 900); // on no screen: none limits it
    if (arguments.windowSize || forScreenshot)
        window.resize(arguments.windowSize.value_or(kPictureSize));

    // A scene named on the command line must open; later ones only leave a message in the window.
    QObject starting;
    QObject::connect(&window.document(), &rasterlens::Document::diagnosticsReported, &starting,
                     [](const rasterlens::Diagnostics& diagnostics) {
                         for (const rasterlens::Diagnostic& diagnostic : diagnostics)
                             printError(diagnostic.text());
                         if (rasterlens::hasErrors(diagnostics))
                             QApplication::exit(kInvalidInput);
                     });
    QString step = arguments.step;
    QObject::connect(&window, &MainWindow::settled, &starting, [&] {
        if (!step.isEmpty()) {
            window.stepMode().showStep(std::exchange(step, {}));
            return;
        }
        window.disconnect(&starting);
        window.document().disconnect(&starting);
        if (arguments.pixel)
            window.viewport().selectPixel(arguments.pixel);
        window.truthMode().referee().setSpace(arguments.reference);
        window.truthMode().referee().setOn(arguments.referee);
        window.truthMode().comparison().setView(arguments.compare);
        if (arguments.measuredFrames > 0)
            window.truthMode().experiment().run(arguments.measuredFrames);
        if (!arguments.panel.isEmpty())
            openPanel(window, arguments.panel);
        if (forScreenshot)
            takeScreenshot(window, arguments.screenshot);
    });
    if (arguments.scene.isEmpty())
        window.openDefaultScene();
    else
        window.document().open(arguments.scene);
    window.show();
    const int exitCode = QApplication::exec();
    if (const QString problem = rasterlens::settingsProblem(); !forScreenshot && !problem.isEmpty())
        printError(QStringLiteral("what the window remembers could not be kept: %1").arg(problem));
    return exitCode;
}
