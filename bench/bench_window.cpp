// How long the window keeps its user waiting, measured in the program: start, orbit, overlay, jumps in the record.
#include "ui/canvas/viewport_widget.h"
#include "ui/pipeline/statistics_panel.h"
#include "ui/steps/step_mode.h"
#include "ui/window/main_window.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QElapsedTimer>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cstdio>
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

/// Jumps to anywhere in the record, each with the repaint of a canvas full of pixels 16 wide.
Times jumps(MainWindow& window, int count)
{
    StepSession& session = window.stepMode().session();
    ViewportWidget& viewport = window.viewport();
    QImage target(viewport.size(), QImage::Format_RGB32);
    std::mt19937 random(1);
    std::uniform_int_distribution<std::size_t> anywhere(0, session.size());
    Times ms;
    for (int i = 0; i < count; ++i) {
        QElapsedTimer clock;
        clock.start();
        session.moveTo(anywhere(random));
        paintMs(viewport, target);
        ms.push_back(msOf(clock));
        QCoreApplication::processEvents();
    }
    return ms;
}

/// What recording makes the user wait for, in ms.
struct Recording {
    double ready;        ///< from R until the first step can be taken
    double longestPause; ///< between two turns of the event loop in the meantime
};

Recording recordFrame(MainWindow& window)
{
    StepSession& session = window.stepMode().session();
    Recording ms{0, 0};
    QElapsedTimer whole;
    QElapsedTimer turn;
    whole.start();
    turn.start();
    session.open();
    do {
        ms.longestPause = std::max(ms.longestPause, msOf(turn));
        turn.start();
        QCoreApplication::processEvents();
    } while (session.isRecording());
    ms.ready = msOf(whole);
    ms.longestPause = std::max(ms.longestPause, msOf(turn));
    return ms;
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
    parser.process(application);
    const QString scene = parser.positionalArguments().value(0, QStringLiteral("builtin:teapot"));

    std::printf("%-58s %8s %8s %8s\n", "milliseconds", "median", "p90", "min");
    MainWindow window(MainWindow::Memory::Forget);
    window.resize(2560, 1440);
    bool shown = false;
    QObject::connect(&window.viewport(), &ViewportWidget::frameShown, [&] { shown = true; });
    window.openDefaultScene();
    window.show();
    waitFor([&] { return shown; });
    report("start to the first picture of the built-in scene", {msOf(start)});

    window.document().open(scene);
    waitFor([&] { return !window.document().isLoading() && window.isSettled(); });
    Settings settings = window.document().settings();
    settings.size = {1920, 1080};
    window.document().setSettings(settings);
    waitFor([&] { return window.isSettled(); });
    const QByteArray name = scene.section(QLatin1Char('/'), -1).toUtf8();
    report(("orbiting " + name + " at 1920x1080: move to picture").constData(), orbit(window, 60));
    waitFor([&] { return window.isSettled(); });
    StepSession& session = window.stepMode().session();
    const Recording recording = recordFrame(window);
    report(("recording " + name + ": ready to step").constData(), {recording.ready});
    report(("recording " + name + ": longest pause of the window").constData(), {recording.longestPause});
    std::printf("record of %s: %zu events, index of %zu MB\n", name.constData(), session.size(),
                session.record() ? session.record()->index().bytes() >> 20 : 0);
    report("jump anywhere in it, with a paint", jumps(window, 100));
    session.close();

    window.document().open(QStringLiteral("builtin:covering"));
    waitFor([&] { return !window.document().isLoading() && window.isSettled(); });
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
    report("jump anywhere in it, with that paint", jumps(window, 100));
    return 0;
}
