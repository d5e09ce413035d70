#include "ui/base/image_export.h"
#include "ui/face/cards.h"
#include "ui/pipeline/mistakes_section.h"
#include "ui/pipeline/pipeline_panel.h"
#include "ui/steps/step_mode.h"
#include "ui/truth/experiment_panel.h"
#include "ui/truth/truth_mode.h"
#include "ui/window/main_window.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QTimer>

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

/// Of `zh`, `zh_CN`, `zh-Hans`, `en_GB.UTF-8` and the like.
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
        QStringLiteral("Writes the window as a PNG image to <file> and exits; needs no display."),
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
    const QCommandLineOption measure(
        QStringLiteral("measure"),
        QStringLiteral("Measures speed against error, <frames> frames a variant (with --panel experiment)."),
        QStringLiteral("frames"));
    const QCommandLineOption compare(
        QStringLiteral("compare"),
        QStringLiteral("Compares with the picture without mistakes or as the scene asks: wipe, blink or difference."),
        QStringLiteral("view"));
    parser.addOptions(
        {help, version, screenshot, windowSize, language, theme, panel, pixel, step, referee, compare, measure});
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
    arguments.step = parser.value(step);
    if (parser.isSet(step) && !rasterlens::StepMode::isPlace(arguments.step))
        return refuse(QStringLiteral("--step takes a position, tie, sign-change, depth-fail, clip or nan"));
    if (parser.isSet(windowSize)) {
        arguments.windowSize = rasterlens::parseSize(parser.value(windowSize));
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
    arguments.referee = parser.isSet(referee);
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
        const QStringList parts = parser.value(pixel).split(QLatin1Char(','));
        bool goodX = false;
        bool goodY = false;
        const QPoint chosen(parts.value(0).toInt(&goodX), parts.value(1).toInt(&goodY));
        if (parts.size() != 2 || !goodX || !goodY || chosen.x() < 0 || chosen.y() < 0)
            return refuse(QStringLiteral("--pixel takes x,y"));
        arguments.pixel = chosen;
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
        if (const auto error = rasterlens::savePng(window.picture(), path)) {
            printError(*error);
            QApplication::exit(kInvalidInput);
            return;
        }
        QApplication::exit(kFine);
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

    choosePlatform();
    QApplication application(argc, argv);
    const bool forScreenshot = !arguments.screenshot.isEmpty();
    using rasterlens::MainWindow;
    MainWindow window(forScreenshot ? MainWindow::Memory::Forget : MainWindow::Memory::Remember);
    if (arguments.language)
        window.setLanguage(*arguments.language);
    if (arguments.theme)
        window.setLook({*arguments.theme, false});
    if (arguments.windowSize)
        window.resize(*arguments.windowSize);

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
    return QApplication::exec();
}
