#include "app/gui_arguments.h"
#include "core/io/file_writer.h"
#include "core/io/picture_file.h"
#include "ui/base/image_export.h"
#include "ui/base/settings_file.h"
#include "ui/document/consents.h"
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
#include <QIcon>
#include <QTimer>

#include <csignal>
#include <cstdio>
#include <optional>
#include <utility>

namespace
{

using rasterlens::Arguments;
using rasterlens::ExitCode;
using enum rasterlens::ExitCode;
using rasterlens::printError;

/// Without a display the window is drawn in memory.
void choosePlatform()
{
    const bool hasDisplay = qEnvironmentVariableIsSet("DISPLAY") || qEnvironmentVariableIsSet("WAYLAND_DISPLAY");
    if (!hasDisplay && !qEnvironmentVariableIsSet("QT_QPA_PLATFORM"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
}

void openPanel(rasterlens::MainWindow& window, const QString& name)
{
    if (!window.cards().show(name) && !window.truthMode().showPanel(name))
        window.pipelinePanel().mistakes().setOpen(true);
}

/// Renders the window as soon as all in it is computed, and laid out.
void takeScreenshot(rasterlens::MainWindow& window, const QString& path, bool wasComplete = false)
{
    // At least one turn of the event loop lets the layout follow the counters' widths and what was computed last.
    constexpr int kWaitMs = 20;
    QTimer::singleShot(kWaitMs, &window, [&window, path, wasComplete] {
        const bool isComplete = window.isComplete();
        if (!isComplete || !wasComplete) {
            takeScreenshot(window, path, isComplete);
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

/// Whether the window asks about the file that did not open: it names others outside its folder. The default scene
/// stands there meanwhile. A window that writes a picture and ends asks nothing.
bool asksInstead(const Arguments& arguments)
{
    return arguments.screenshot.isEmpty() && arguments.figure.path.isEmpty() &&
           rasterlens::Consents::ofProgram().hasTold();
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
    if (!lessons.open(arguments.lesson)) {
        if (!asksInstead(arguments))
            return kInvalidInput;
        window.openDefaultScene();
        return kFine;
    }
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
    if (arguments.allowOutside)
        rasterlens::Consents::ofProgram().addAll();
    if (!arguments.lesson.isEmpty())
        return startLesson(window, arguments);
    if (!hasArguments)
        window.openAtStart();
    else if (arguments.scene.isEmpty())
        window.openDefaultScene();
    else if (!arguments.model.isEmpty())
        window.document().openSessionWith(arguments.scene, arguments.model);
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
                     [&window, arguments](const rasterlens::Diagnostics& diagnostics) {
                         for (const rasterlens::Diagnostic& diagnostic : diagnostics)
                             printError(diagnostic.text());
                         if (!rasterlens::hasErrors(diagnostics))
                             return;
                         if (asksInstead(arguments))
                             QMetaObject::invokeMethod(&window, &rasterlens::MainWindow::openDefaultScene,
                                                       Qt::QueuedConnection);
                         else
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
                         if (!rasterlens::startMotion(window, arguments.figure)) {
                             QApplication::exit(kBadArguments);
                             return;
                         }
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
    const rasterlens::ParsedArguments parsed = rasterlens::parseArguments(wordsOf(argc, argv));
    if (!parsed.arguments)
        return parsed.exitCode;
    const Arguments& arguments = *parsed.arguments;
    for (const QString& path : {arguments.screenshot, arguments.figure.path, arguments.page.path})
        if (const auto why = rasterlens::whyNotWritable(path); why && !path.isEmpty()) {
            printError(QStringLiteral("%1: cannot be written: %2").arg(path, rasterlens::textOf(*why)));
            return kInvalidInput;
        }
#ifdef Q_OS_UNIX
    std::signal(SIGXFSZ, SIG_IGN); // a file that may not grow is an error message
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
    QGuiApplication::setDesktopFileName(QStringLiteral("org.rasterlens.RasterLens"));
    QGuiApplication::setWindowIcon(QIcon(QStringLiteral(":/rasterlens/desktop/rasterlens.svg")));
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
    window.setAnimated(!forScreenshot);      // or the picture shows panels on the way to their places
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
