// The transport of the step mode: every key, playing, stops, the scrubber, large scenes, and a run of pictures.
#include "core/render/render.h"
#include "tests/step_fixture.h"
#include "ui/steps/scrubber.h"
#include "ui/steps/step_listing.h"
#include "ui/steps/transport_dock.h"

#include <QElapsedTimer>
#include <QImageReader>
#include <QSignalSpy>

#include <cmath>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

/// Two faces behind each other, and one across the near plane.
constexpr auto kStops = R"(size 16 16
tri -0.8 -0.8 -0.5 1 1 0 0   0.8 -0.8 -0.5 1 0 1 0   0 0.8 -0.5 1 0 0 1
tri -0.8 -0.8 0.5 1 1 0 0   0.8 -0.8 0.5 1 0 1 0   0 0.8 0.5 1 0 0 1
tri -0.8 -0.8 -1.5 1 1 0 0   0.8 -0.8 0.5 1 0 1 0   0 0.8 0.5 1 0 0 1
)";

} // namespace

class TestTransport : public StepFixture
{
    Q_OBJECT

private Q_SLOTS:
    void init() { openSquare(); }
    void everyTransportKey();
    void playsAndLoops();
    void runUntilEachStop();
    void scrubberGoesThereAndBack();
    void pipsMarkTheMostTellingEvent();
    void largeSceneIsSteppedToItsEnd();
    void playsByEachLength();
    void recordingNeverBlocks();
    void theBeginningIsSteppedWhileTheRestIsRecorded();
    void formulasHaveRoomInASmallWindow();
    void exportsDrawingsAndRuns();

private:
    bool reopen(const std::function<void()>& inTheBeginning);
};

void TestTransport::everyTransportKey()
{
    QVERIFY(record());
    struct Key {
        Qt::KeyboardModifiers modifiers;
        StepLevel level;
    };
    const Key keys[] = {{Qt::NoModifier, StepLevel::Event},
                        {Qt::ShiftModifier, StepLevel::Row},
                        {Qt::ControlModifier, StepLevel::Face},
                        {Qt::ControlModifier | Qt::ShiftModifier, StepLevel::Stage}};
    for (const Key& pressed : keys) {
        session().moveTo(100);
        const std::size_t forth = log().step(100, pressed.level, StepDirection::Forward);
        key(Qt::Key_Right, pressed.modifiers);
        QCOMPARE(session().position(), forth);
        const std::size_t back = log().step(forth, pressed.level, StepDirection::Backward);
        key(Qt::Key_Left, pressed.modifiers);
        QCOMPARE(session().position(), back);
    }
    key(Qt::Key_End, Qt::ControlModifier);
    QCOMPARE(session().position(), log().size());
    key(Qt::Key_Right);
    QCOMPARE(session().position(), log().size());
    key(Qt::Key_Home, Qt::ControlModifier);
    QCOMPARE(session().position(), std::size_t(0));
    key(Qt::Key_Left);
    QCOMPARE(session().position(), std::size_t(0));

    QVERIFY(!session().isLooping());
    key(Qt::Key_L);
    QVERIFY(session().isLooping());
    key(Qt::Key_BracketRight);
    QCOMPARE(session().speed(), 2.0);
    for (int i = 0; i < 20; ++i)
        key(Qt::Key_BracketLeft);
    QCOMPARE(session().speed(), kSlowestSteps);
    for (int i = 0; i < 20; ++i)
        key(Qt::Key_BracketRight);
    QCOMPARE(session().speed(), kFastestSteps);
}

void TestTransport::playsAndLoops()
{
    QVERIFY(record());
    session().setSpeed(kFastestSteps);
    key(Qt::Key_Space);
    QVERIFY(session().isPlaying());
    QVERIFY(waitFor([this] { return session().position() > 0; }));
    key(Qt::Key_Space);
    QVERIFY(!session().isPlaying());

    session().moveTo(log().size() - 1);
    session().setPlaying(true);
    QVERIFY(waitFor([this] { return !session().isPlaying(); }));
    QCOMPARE(session().position(), log().size());

    session().setLooping(true);
    session().moveTo(log().size() - 1);
    session().setPlaying(true);
    QVERIFY(waitFor([this] { return session().position() < log().size() - 1; }));
    QVERIFY(session().isPlaying());
    key(Qt::Key_Right);
    QVERIFY(!session().isPlaying());
}

void TestTransport::runUntilEachStop()
{
    QVERIFY(record());
    const auto expect = [this](const StepStop& stop) {
        session().moveTo(0);
        const auto at = log().findStop(0, StepDirection::Forward, stop);
        QSignalSpy missed(&session(), &StepSession::stopMissed);
        session().runUntil(stop);
        QCOMPARE(missed.isEmpty(), at.has_value());
        QCOMPARE(session().position(), at ? *at + 1 : log().size());
    };
    expect({StepStop::Kind::Pixel, 3, 4});
    QCOMPARE(session().event()->x, 3);
    QCOMPARE(session().event()->y, 4);
    expect({StepStop::Kind::Tie});
    QVERIFY(session().event()->has(StepEvent::kTie));
    const std::size_t first = session().position();
    session().runUntil({StepStop::Kind::Tie});
    QVERIFY(session().position() > first);
    QVERIFY(session().event()->has(StepEvent::kTie));
    expect({StepStop::Kind::SignChange});
    QVERIFY(session().event()->has(StepEvent::kSignChange));
    expect({StepStop::Kind::DepthFail});
    QCOMPARE(session().position(), log().size()); // there is none

    QVERIFY(openText(kStops));
    QVERIFY(record());
    expect({StepStop::Kind::DepthFail});
    QCOMPARE(session().event()->kind, StepKind::Fragment);
    QVERIFY(!session().event()->has(StepEvent::kPassed));
    expect({StepStop::Kind::Clip});
    QCOMPARE(session().event()->kind, StepKind::ClipPlane);

    // Without clipping the corner with w = 0 is divided by it.
    QVERIFY(openText("size 16 16\ntri -0.8 -0.8 0 1 1 0 0   0.8 -0.3 0 0 0 1 0   0 0.8 0 1 0 0 1\n"));
    Settings next = settings();
    next.clipping = Clipping::None;
    document().setSettings(next);
    QVERIFY(settle());
    QVERIFY(record());
    expect({StepStop::Kind::NonFinite});
    QVERIFY(session().event()->has(StepEvent::kNonFinite));
}

void TestTransport::scrubberGoesThereAndBack()
{
    QVERIFY(record());
    Scrubber& scrubber = mode().transport().scrubber();
    QVERIFY(scrubber.width() > 400);
    for (const std::size_t position : {std::size_t(0), log().size() / 2, log().size()}) {
        QTest::mouseClick(&scrubber, Qt::LeftButton, {}, QPoint(int(std::lround(scrubber.xOf(position))), 18));
        QVERIFY(std::abs(double(session().position()) - double(position)) <= 1);
        QCOMPARE(scrubber.position(), session().position());
    }
    QCOMPARE(scrubber.positionAt(-100), std::size_t(0));
    QCOMPARE(scrubber.positionAt(10000), log().size());
}

void TestTransport::pipsMarkTheMostTellingEvent()
{
    QVERIFY(record());
    const auto one = session().record()->pips().columns(1);
    QCOMPARE(one.size(), std::size_t(1));
    QCOMPARE(one[0], PipKind::Tie);
    const auto many = session().record()->pips().columns(int(log().size()) + 1);
    QCOMPARE(many[0], PipKind::None); // the cleared frame
    for (std::size_t i = 0; i < log().size(); ++i)
        QCOMPARE(many[i + 1], pipKindOf(log().event(i)));
    QCOMPARE(std::count(many.begin(), many.end(), PipKind::Tie), std::ptrdiff_t(16));
}

/// Steps beyond the first million, back and forth.
void TestTransport::largeSceneIsSteppedToItsEnd()
{
    QVERIFY(open(QStringLiteral("builtin:head")));
    QVERIFY(record());
    QVERIFY(!session().record()->truncated());
    QCOMPARE(mode().transport().noticeText(), QString());
    QVERIFY(session().size() > 1'300'000);
    session().moveTo(session().size());
    QCOMPARE(session().event()->kind, StepKind::End);
    Frame frame;
    render(*document().scene(), session().settings(), frame);
    QCOMPARE(viewport().frame()->frame.image, frame.image);

    constexpr std::size_t kPlace = 1'234'567;
    mode().showStep(QString::number(kPlace));
    QCOMPARE(session().position(), kPlace);
    QVERIFY(session().event());
    const QImage there = viewport().frame()->frame.image.copy();
    const StepEvent event = *session().event();
    QVERIFY(there != frame.image);
    key(Qt::Key_Right, Qt::ControlModifier);
    const std::size_t next = session().position();
    QVERIFY(next > kPlace);
    QVERIFY(session().event()->face == event.face);
    for (const std::size_t place : {std::size_t(0), session().size() - 1, kPlace + 100'000, kPlace})
        session().moveTo(place);
    QCOMPARE(viewport().frame()->frame.image, there);
    QCOMPARE(session().event()->kind, event.kind);
    QCOMPARE(QPoint(session().event()->x, session().event()->y), QPoint(event.x, event.y));
    QVERIFY(mode().transport().stepText().contains(QStringLiteral("1,234,567")));
}

void TestTransport::playsByEachLength()
{
    QVERIFY(record());
    session().setSpeed(kFastestSteps);
    const std::pair<PlayBy, StepLevel> lengths[] = {{PlayBy::Sample, StepLevel::Sample},
                                                    {PlayBy::Row, StepLevel::Row},
                                                    {PlayBy::Face, StepLevel::Face},
                                                    {PlayBy::Stage, StepLevel::Stage}};
    for (const auto& [by, level] : lengths) {
        session().moveTo(0);
        session().setPlayBy(by);
        std::vector<std::size_t> places;
        const auto seen =
            connect(&session(), &StepSession::positionChanged, this, [&] { places.push_back(session().position()); });
        session().setPlaying(true);
        QVERIFY(waitFor([&] { return places.size() >= 2 || !session().isPlaying(); }));
        session().setPlaying(false);
        disconnect(seen);
        QVERIFY(!places.empty());
        for (const std::size_t place : places) // at the end of a step of this length
            QCOMPARE(log().step(log().step(place, level, StepDirection::Backward), level, StepDirection::Forward),
                     place);
    }
    constexpr double kSeconds = 0.6;
    session().moveTo(0);
    session().setPlayBy(PlayBy::Seconds);
    session().setSeconds(kSeconds);
    QElapsedTimer time;
    time.start();
    session().setPlaying(true);
    QVERIFY(waitFor([&] { return !session().isPlaying(); }));
    QVERIFY(double(time.elapsed()) / 1000 > 0.9 * kSeconds);
    QCOMPARE(session().position(), session().size());
}

void TestTransport::recordingNeverBlocks()
{
    QVERIFY(open(QStringLiteral("builtin:head")));
    int turns = 0;
    QTimer ticks;
    ticks.setInterval(0);
    connect(&ticks, &QTimer::timeout, this, [&turns] { ++turns; });
    ticks.start();
    session().open();
    QVERIFY(session().isRecording()); // open() came back before the work was done
    QVERIFY(waitFor([this] { return !session().isRecording(); }));
    QVERIFY2(turns > 3, qPrintable(QString::number(turns)));
    QVERIFY(session().log());

    // Many changes in a row: the latest wins.
    QSignalSpy changed(&session(), &StepSession::logChanged);
    for (int i = 0; i < 5; ++i)
        setAlgorithm(i % 2 == 0 ? Algorithm::EdgeWalking : Algorithm::EdgeEquation);
    session().close();
    QVERIFY(!session().isRecording());
    QTest::qWait(100);
    QVERIFY(!session().log());
}

/// Records anew, and does something as soon as the beginning is there; whether it was a beginning, and whole in the
/// end.
bool TestTransport::reopen(const std::function<void()>& inTheBeginning)
{
    session().close();
    session().open();
    bool wasBeginning = false;
    const auto connection = connect(&session(), &StepSession::logChanged, this, [&] {
        if (!session().isBeginning())
            return;
        wasBeginning = true;
        QVERIFY(session().isRecording());
        inTheBeginning();
    });
    const bool isWhole = waitFor([this] { return !session().isRecording(); });
    disconnect(connection);
    return isWhole && wasBeginning && !session().isBeginning();
}

void TestTransport::theBeginningIsSteppedWhileTheRestIsRecorded()
{
    Settings settings = document().settings();
    settings.size = {1024, 1024};
    document().setSettings(settings);
    QVERIFY(waitFor([this] { return m_window->isSettled(); }));
    std::size_t begun = 0;
    QVERIFY(reopen([&] {
        begun = session().size();
        session().moveTo(begun / 2);
        session().step(StepLevel::Event, StepDirection::Forward);
        QCOMPARE(session().position(), begun / 2 + 1);
        QVERIFY(mode().moment());
        QVERIFY(mode().transport().stepText().contains(QStringLiteral("more than")));
    }));
    QCOMPARE(session().position(), begun / 2 + 1); // the rest came, the moment stayed
    const std::size_t all = session().size();
    QVERIFY(begun > 0 && all > 2 * begun);

    // What asks for more than there is, waits for it.
    QVERIFY(reopen([&] {
        key(Qt::Key_End, Qt::ControlModifier);
        QCOMPARE(session().position(), std::size_t(0));
        QVERIFY(session().isPutOff());
    }));
    QCOMPARE(session().position(), all);
    session().moveTo(all - 1);
    const StepStop lastPixel{StepStop::Kind::Pixel, session().event()->x, session().event()->y};
    session().moveTo(0);
    session().runUntil(lastPixel);
    const std::size_t there = session().position();
    QVERIFY(there > begun && there < all);
    QSignalSpy missed(&session(), &StepSession::stopMissed);
    QVERIFY(reopen([&] { session().runUntil(lastPixel); }));
    QCOMPARE(session().position(), there);
    QVERIFY(reopen([&] { session().runUntil({StepStop::Kind::DepthFail}); }));
    QCOMPARE(session().position(), all);
    QCOMPARE(missed.size(), 1);

    // What is asked for later takes its place.
    QVERIFY(reopen([&] {
        session().moveToEnd();
        session().moveTo(7);
    }));
    QCOMPARE(session().position(), std::size_t(7));
}

void TestTransport::exportsDrawingsAndRuns()
{
    QVERIFY(record());
    session().runUntil({StepStop::Kind::Tie});
    const QString drawing = m_folder.filePath(QStringLiteral("figure.svg"));
    QVERIFY(m_window->exportFigure(drawing));
    QFile file(drawing);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray text = file.readAll();
    QVERIFY(text.contains("<svg"));
    QVERIFY(text.contains("#005a8c")); // the signs, as shapes
    QVERIFY(!text.contains("<image"));

    const std::size_t before = session().position();
    const auto errorOf = [&](const QString& folder, RunExport::Run run) {
        QSignalSpy finished(&mode().exportRun(folder, run), &RunExport::finished);
        return finished.wait(kPatienceMs) ? finished.front().front().toString() : QStringLiteral("never finished");
    };
    QCOMPARE(errorOf(m_folder.path(), {8, 12, 16}), QString());
    QCOMPARE(session().position(), before);
    for (const char* name : {"step-08.png", "step-09.png", "step-10.png", "step-11.png", "step-12.png"})
        QCOMPARE(QImageReader(m_folder.filePath(QLatin1String(name))).size(), QSize(8 * 16 + 1, 8 * 16 + 1));
    QVERIFY(errorOf(m_folder.filePath(QStringLiteral("missing")), {0, 1, 1}).contains(QStringLiteral("step-0.png")));
    QCOMPARE(session().position(), before);
    for (const int zoom : {1, 8, 32})
        QCOMPARE(viewport().figure(zoom).width(), 8 * zoom + (zoom >= 8 ? 1 : 0));
}

/// In the window of a small projector too: in every kind of step of edge walking no formula ends in dots.
void TestTransport::formulasHaveRoomInASmallWindow()
{
    QVERIFY(open(QStringLiteral("builtin:triangle-600")));
    QVERIFY(change([](Settings& s) { s.algorithm = Algorithm::EdgeWalking; }));
    m_window->resize(1024, 768);
    for (const char* step :
         {"vertex", "viewport", "walk", "sides", "halves", "crossing #120", "span #120", "fragment"}) {
        mode().showStep(QLatin1String(step));
        QVERIFY(complete());
        const StepListing& listing = mode().listing();
        const QString rows = listing.formulaRows().join(QLatin1Char(' ')).simplified();
        QCOMPARE(rows, listing.explanation().formula.simplified());
    }
}

QTEST_MAIN(TestTransport)
#include "test_transport.moc"
