// How long the window keeps its user waiting, measured in the program: start, orbit, overlay, jumps in the record.
#include "core/scenes/builtin_scenes.h"
#include "core/settings/settings.h"
#include "ui/canvas/viewport_widget.h"
#include "ui/pipeline/statistics_panel.h"
#include "ui/steps/step_mode.h"
#include "ui/window/main_window.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QElapsedTimer>
#include <QFile>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <random>

using namespace rasterlens;

namespace
{

using Times = std::vector<double>;

void report(const char* what, Times ms)
{
    std::sort(ms.begin(), ms.end());
    const auto at = [&](double q) { return ms[static_cast<std::size_t>(q * double(ms.size() - 1))]; };
    std::printf("%-58s %8.2f %8.2f %8.2f\n", what, at(0.5), at(0.9), ms.front());
}

double msOf(const QElapsedTimer& clock) { return double(clock.nsecsElapsed()) / 1e6; }

/// Processor time so far, of all threads or of this one.
double processorMs(clockid_t of = CLOCK_PROCESS_CPUTIME_ID)
{
    timespec time{};
    clock_gettime(of, &time);
    return 1e3 * double(time.tv_sec) + double(time.tv_nsec) / 1e6;
}

/// Memory of the process that is resident, in MB; 0 where the system does not tell.
double residentMb()
{
    QFile file(QStringLiteral("/proc/self/status"));
    if (!file.open(QIODevice::ReadOnly))
        return 0;
    for (const QByteArray& line : file.readAll().split('\n'))
        if (line.startsWith("VmRSS:"))
            return line.sliced(6).trimmed().split(' ').first().toDouble() / 1024;
    return 0;
}

double median(Times values)
{
    std::ranges::nth_element(values, values.begin() + std::ptrdiff_t(values.size() / 2));
    return values[values.size() / 2];
}

template <class Condition>
void waitFor(Condition&& done)
{
    while (!done())
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 50);
}

void send(QWidget& target, QEvent::Type type, QPointF at, Qt::MouseButton button)
{
    QMouseEvent event(type, at, target.mapToGlobal(at), button, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&target, &event);
}

/// From each move of the mouse to the first new picture that is painted.
Times orbit(MainWindow& window, int moves)
{
    ViewportWidget& viewport = window.viewport();
    const QPointF middle = QRectF(viewport.rect()).center();
    send(viewport, QEvent::MouseButtonPress, middle, Qt::LeftButton);
    Times ms;
    for (int i = 1; i <= moves; ++i) {
        bool shown = false;
        const auto connection = QObject::connect(&viewport, &ViewportWidget::frameShown, [&] { shown = true; });
        QElapsedTimer clock;
        clock.start();
        send(viewport, QEvent::MouseMove, middle + QPointF(10 + 2 * i, i), Qt::NoButton);
        waitFor([&] { return shown; });
        ms.push_back(msOf(clock));
        QObject::disconnect(connection);
    }
    send(viewport, QEvent::MouseButtonRelease, middle, Qt::LeftButton);
    return ms;
}

/// Painting the canvas into an image of its size.
double paintMs(ViewportWidget& viewport, QImage& target)
{
    QElapsedTimer clock;
    clock.start();
    viewport.render(&target);
    return msOf(clock);
}

/// What jumps to anywhere in the record take, each with the repaint of the canvas.
struct Jumps {
    Times ms;
    Times processorMs; ///< of all threads: Qt scales pictures in several
    Times moveMs;      ///< of this thread, to the position and up to the new picture
    Times paintMs;     ///< of this thread, the canvas
};

Jumps jumps(MainWindow& window, int count)
{
    StepSession& session = window.stepMode().session();
    ViewportWidget& viewport = window.viewport();
    QImage target(viewport.size(), QImage::Format_RGB32);
    std::mt19937 random(1);
    std::uniform_int_distribution<std::size_t> anywhere(0, session.size());
    Jumps jumps;
    for (int i = 0; i < count; ++i) {
        QElapsedTimer clock;
        clock.start();
        const double before = processorMs();
        const double ownBefore = processorMs(CLOCK_THREAD_CPUTIME_ID);
        session.moveTo(anywhere(random));
        const double ownMoved = processorMs(CLOCK_THREAD_CPUTIME_ID);
        paintMs(viewport, target);
        jumps.ms.push_back(msOf(clock));
        jumps.processorMs.push_back(processorMs() - before);
        jumps.moveMs.push_back(ownMoved - ownBefore);
        jumps.paintMs.push_back(processorMs(CLOCK_THREAD_CPUTIME_ID) - ownMoved);
        QCoreApplication::processEvents();
    }
    return jumps;
}

/// What recording makes the user wait for, in ms.
struct Recording {
    double first = 0;          ///< from R until the first step can be taken
    double ready = 0;          ///< until all of the frame is recorded
    double processorReady = 0; ///< of all threads
    double longestPause = 0;   ///< between two turns of the event loop in the meantime
    double residentMb = 0;     ///< by which the process has grown
};

Recording recordFrame(MainWindow& window)
{
    StepSession& session = window.stepMode().session();
    Recording ms;
    const double residentBefore = residentMb();
    const double processorBefore = processorMs();
    QElapsedTimer whole;
    QElapsedTimer turn;
    whole.start();
    turn.start();
    session.open();
    do {
        ms.longestPause = std::max(ms.longestPause, msOf(turn));
        turn.start();
        QCoreApplication::processEvents();
        if (ms.first == 0 && session.isReady())
            ms.first = msOf(whole);
    } while (session.isRecording());
    ms.ready = msOf(whole);
    if (ms.first == 0) // there was no beginning
        ms.first = ms.ready;
    ms.processorReady = processorMs() - processorBefore;
    ms.residentMb = residentMb() - residentBefore;
    ms.longestPause = std::max(ms.longestPause, msOf(turn));
    return ms;
}

void openScene(MainWindow& window, const QString& scene, QSize size)
{
    window.document().open(scene);
    waitFor([&] { return !window.document().isLoading() && window.isSettled(); });
    Settings settings = window.document().settings();
    settings.size = size;
    window.document().setSettings(settings);
    waitFor([&] { return window.isSettled(); });
}

/// A row for each scene: how long its record takes, what it weighs, and jumps in it.
void measureRecords(MainWindow& window, const QStringList& scenes, QSize size)
{
    std::printf("%-22s %10s %7s %7s %7s %6s %6s %8s %8s %8s %8s %8s\n", "record, 1920x1080", "events", "first", "whole",
                "cpu", "index", "grown", "jump", "min", "cpu", "move", "paint");
    for (const QString& scene : scenes) {
        openScene(window, scene, size);
        StepSession& session = window.stepMode().session();
        const Recording recording = recordFrame(window);
        constexpr int kJumps = 30;
        const Jumps there = jumps(window, kJumps);
        std::printf("%-22s %10zu %7.0f %7.0f %7.0f %6zu %6.0f %8.2f %8.2f %8.2f %8.2f %8.2f\n",
                    scene.section(QLatin1Char('/'), -1).toUtf8().constData(), session.size(), recording.first,
                    recording.ready, recording.processorReady,
                    session.record() ? session.record()->index().bytes() >> 20 : 0, recording.residentMb,
                    median(there.ms), std::ranges::min(there.ms), median(there.processorMs), median(there.moveMs),
                    median(there.paintMs));
        std::fflush(stdout);
        session.close();
    }
}

/// The edge-sign lens over a canvas full of pixels 16 wide, and jumps with it.
void measureLens(MainWindow& window)
{
    window.document().open(QStringLiteral("builtin:covering"));
    waitFor([&] { return !window.document().isLoading() && window.isSettled(); });
    StepSession& session = window.stepMode().session();
    session.open();
    waitFor([&] { return !session.isRecording(); });
    ViewportWidget& viewport = window.viewport();
    viewport.setParent(nullptr);
    viewport.resize(1920, 1080);
    viewport.setZoom(16);
    session.moveTo(session.size() / 2);
    QImage target(viewport.size(), QImage::Format_RGB32);
    Times paints;
    for (int i = 0; i < 50; ++i)
        paints.push_back(paintMs(viewport, target));
    report("lens on 1920x1080 canvas pixels of 16x: one paint", paints);
    std::printf("record of builtin:covering: %zu events\n", session.size());
    report("jump anywhere in it, with that paint", jumps(window, 100).ms);
}

} // namespace

int main(int argc, char** argv)
{
    QElapsedTimer start;
    start.start();
    if (qEnvironmentVariableIsEmpty("DISPLAY"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication application(argc, argv);
    QCommandLineParser parser;
    parser.addHelpOption();
    parser.addPositionalArgument("SCENE", "what is orbited and recorded, for example stanford-bunny.obj");
    const QCommandLineOption records(
        "records",
        "Records every SCENE that is named, a row each; nothing else. \"all\" stands for the built-in ones.");
    parser.addOption(records);
    const QCommandLineOption startOnly("start", "Measures the start; nothing else.");
    parser.addOption(startOnly);
    const QCommandLineOption windowSize("size-window", "Size of the window.", "WxH", "1920x1080");
    parser.addOption(windowSize);
    parser.process(application);
    const QString scene = parser.positionalArguments().value(0, QStringLiteral("builtin:teapot"));

    std::printf("%-58s %8s %8s %8s\n", "milliseconds", "median", "p90", "min");
    MainWindow window(MainWindow::Memory::Forget);
    window.resize(parseSize(parser.value(windowSize)).value_or(QSize(1920, 1080)));
    bool shown = false;
    QObject::connect(&window.viewport(), &ViewportWidget::frameShown, [&] { shown = true; });
    window.openDefaultScene();
    window.show();
    waitFor([&] { return shown; });
    report("start to the first picture of the built-in scene", {msOf(start)});
    if (parser.isSet(startOnly))
        return 0;

    constexpr QSize kSize(1920, 1080);
    if (parser.isSet(records)) {
        QStringList scenes = parser.positionalArguments();
        if (scenes.removeAll(QStringLiteral("all")) > 0)
            for (const BuiltinScene& entry : builtinScenes())
                scenes << QStringLiteral("builtin:") + QLatin1String(entry.name);
        measureRecords(window, scenes, kSize);
        return 0;
    }
    openScene(window, scene, kSize);
    const QByteArray name = scene.section(QLatin1Char('/'), -1).toUtf8();
    report(("orbiting " + name + " at 1920x1080: move to picture").constData(), orbit(window, 60));
    waitFor([&] { return window.isSettled(); });
    StepSession& session = window.stepMode().session();
    const Recording recording = recordFrame(window);
    report(("recording " + name + ": ready to step").constData(), {recording.ready});
    report(("recording " + name + ": longest pause of the window").constData(), {recording.longestPause});
    std::printf("record of %s: %zu events, index of %zu MB\n", name.constData(), session.size(),
                session.record() ? session.record()->index().bytes() >> 20 : 0);
    report("jump anywhere in it, with a paint", jumps(window, 100).ms);
    session.close();

    measureLens(window);
    return 0;
}
