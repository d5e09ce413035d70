// The step mode in the window: every key of the transport, the lens's numbers and what the canvas shows.
#include "core/observe/step_text.h"
#include "tests/window_fixture.h"
#include "ui/pipeline/stage_strip.h"
#include "ui/steps/lens_overlay.h"
#include "ui/steps/scrubber.h"
#include "ui/steps/step_listing.h"
#include "ui/steps/transport_dock.h"

#include <QImageReader>
#include <QLabel>
#include <QMenu>
#include <QSignalSpy>

#include <algorithm>
#include <cmath>
#include <vector>

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

std::array<EdgeSign, 3> signsOf(const EdgeValues& values)
{
    return {signOf(values[0]), signOf(values[1]), signOf(values[2])};
}

} // namespace

class TestLens : public WindowFixture
{
    Q_OBJECT

private:
    StepMode& mode() { return m_window->stepMode(); }
    StepSession& session() { return mode().session(); }
    const StepLog& log() { return *session().log(); }

    bool record()
    {
        session().open();
        return settle() && session().log();
    }
    void setAlgorithm(Algorithm algorithm)
    {
        Settings next = settings();
        next.algorithm = algorithm;
        document().setSettings(next);
    }

private Q_SLOTS:
    void init()
    {
        openWindow();
        QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
    }

    void offUntilOpened();
    void startsPaused();
    void everyTransportKey();
    void playsAndLoops();
    void arrowsNudgeOutsideOfStepMode();
    void cellsEqualExactValues();
    void statesFollowThePosition();
    void tiesNameTheirOwner();
    void canvasShowsTheCursor();
    void endIsTheFinishedPicture();
    void runUntilEachStop();
    void scrubberGoesThereAndBack();
    void pipsMarkTheMostTellingEvent();
    void listingPutsNumbersIn();
    void walkingShowsSpans();
    void bresenhamShowsItsLine();
    void changesRecordAnew();
    void numbersSayTheirMoment();
    void otherSceneDropsTheRecord();
    void everyFaceOfThePainterHasItsTriangle();
    void scopeLimitsTheRecord();
    void capIsNoticed();
    void recordingNeverBlocks();
    void theStripMarksTheStageOfTheStep();
    void exportsDrawingsAndRuns();
};

void TestLens::offUntilOpened()
{
    QVERIFY(!session().isOpen());
    QVERIFY(!session().log());
    QVERIFY(!mode().lens().model());
    QVERIFY(mode().listing().isHidden());
    key(Qt::Key_R);
    QVERIFY(session().isOpen());
    QVERIFY(settle());
    QVERIFY(!mode().listing().isHidden());
    key(Qt::Key_R);
    QVERIFY(!session().isOpen());
    QVERIFY(!session().log());
}

void TestLens::startsPaused()
{
    QVERIFY(record());
    QCOMPARE(session().position(), std::size_t(0));
    QVERIFY(!session().isPlaying());
    QVERIFY(mode().transport().stepText().contains(QLocale(QLocale::English).toString(qulonglong(log().size()))));
}

void TestLens::everyTransportKey()
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

void TestLens::playsAndLoops()
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

void TestLens::arrowsNudgeOutsideOfStepMode()
{
    viewport().selectPixel(QPoint(3, 3));
    key(Qt::Key_Right);
    QCOMPARE(*viewport().selectedPixel(), QPoint(4, 3));
    QVERIFY(record());
    key(Qt::Key_Right);
    QCOMPARE(*viewport().selectedPixel(), QPoint(4, 3));
    QCOMPARE(session().position(), std::size_t(1));
    QCOMPARE(*session().selectedPixel(), QPoint(4, 3));
}

void TestLens::cellsEqualExactValues()
{
    for (const NumberType type : {NumberType::Fixed, NumberType::Float64}) {
        Settings next = settings();
        next.numberType = type;
        document().setSettings(next);
        QVERIFY(settle());
        QVERIFY(record());
        const auto at = log().find(0, StepDirection::Forward, [](const StepEvent& event) {
            return event.kind == StepKind::Sample && event.face == 1;
        });
        QVERIFY(at);
        session().moveTo(*at + 1);
        const LensModel& model = *mode().lens().model();
        const StepSetup& setup = model.triangle().setup;
        for (int y = 0; y < 8; ++y)
            for (int x = 0; x < 8; ++x) {
                // Twice the areas, with y up, of the sample with A (8, 0), B (0, 8) and C (8, 8), all on whole pixels.
                const double px = x + 0.5;
                const double py = y + 0.5;
                const EdgeValues exact{8 * (px + py - 8), 8 * (8 - py), 8 * (8 - px)};
                const LensCell cell = model.cell(x, y);
                QVERIFY(cell.hasValues);
                for (std::size_t i = 0; i < 3; ++i)
                    QCOMPARE(cell.values[i] / setup.unitsPerArea, exact[i]);
                QCOMPARE(cell.signs, signsOf(exact));
                const bool inside = exact[0] >= 0;
                if (cell.state == LensCell::State::Covered || cell.state == LensCell::State::Rejected)
                    QCOMPARE(cell.state == LensCell::State::Covered, inside);
            }
        QCOMPARE(edgeName(setup, 0), QStringLiteral("AB"));
    }
}

void TestLens::statesFollowThePosition()
{
    QVERIFY(record());
    session().moveTo(log().size() - 1);
    const auto samples = log().eventsOf(StepKind::Sample);
    const std::uint32_t middle = samples[samples.size() * 3 / 4];
    session().moveTo(middle + 1);
    const StepEvent& now = *session().event();
    const LensModel& model = *mode().lens().model();
    for (const std::uint32_t i : samples) {
        const StepEvent& sample = log().event(i);
        if (sample.triangle != now.triangle)
            continue;
        const LensCell cell = model.cell(sample.x, sample.y);
        QCOMPARE(cell.state == LensCell::State::Waiting, i > middle);
        QCOMPARE(cell.values, log().payload<SampleStep>(sample).values);
        if (i <= middle)
            QCOMPARE(cell.state == LensCell::State::Covered, sample.has(StepEvent::kCovered));
    }
    QCOMPARE(model.cell(8, 0).state, LensCell::State::OutOfBounds);
    QCOMPARE(model.cell(0, -1).state, LensCell::State::OutOfBounds);
}

void TestLens::tiesNameTheirOwner()
{
    QVERIFY(record());
    int ties[2] = {0, 0};
    for (std::uint32_t face = 0; face < 2; ++face) {
        const auto last = log().find(log().size(), StepDirection::Backward, [face](const StepEvent& event) {
            return event.kind == StepKind::Sample && event.face == face;
        });
        session().moveTo(*last + 1);
        const LensModel& model = *mode().lens().model();
        for (int i = 0; i < 8; ++i) {
            const LensCell cell = model.cell(7 - i, i);
            QVERIFY(cell.tie);
            ++ties[face];
            QCOMPARE(lensCellText(model.triangle().setup, cell),
                     face == 1 ? QStringLiteral("tie: left, ours") : QStringLiteral("tie: neither, not ours"));
            QCOMPARE(cell.state == LensCell::State::Covered, face == 1);
            QVERIFY(lensHoverLines(model, 7 - i, i)
                        .join(QString())
                        .contains(face == 1 ? QStringLiteral("left, ours") : QStringLiteral("not ours")));
        }
        for (int y = 0; y < 8; ++y)
            for (int x = 0; x < 8; ++x)
                QCOMPARE(model.cell(x, y).tie, x + y == 7);
    }
    QCOMPARE(ties[0], 8);
    QCOMPARE(ties[1], 8);
}

void TestLens::canvasShowsTheCursor()
{
    QVERIFY(record());
    StepCursor fresh(session().log());
    for (const std::size_t position : {std::size_t(0), log().size() / 3, log().size() / 2, log().size()}) {
        session().moveTo(position);
        fresh.moveTo(position);
        QCOMPARE(viewport().frame()->frame.image, fresh.image());
        QCOMPARE(viewport().frame()->statistics.pixels.written, fresh.counters().pixels.written);
    }
    session().close();
    QVERIFY(!viewport().frame()->frame.ids.empty()); // the document's own picture again
}

void TestLens::endIsTheFinishedPicture()
{
    const QImage finished = viewport().frame()->frame.image.copy();
    QVERIFY(record());
    QVERIFY(viewport().frame()->frame.image != finished);
    key(Qt::Key_End, Qt::ControlModifier);
    QCOMPARE(viewport().frame()->frame.image, finished);
    QVERIFY(!mode().lens().model()); // nothing is looked at any more
}

void TestLens::runUntilEachStop()
{
    QVERIFY(record());
    const auto expect = [this](const StepStop& stop) {
        session().moveTo(0);
        const auto at = log().findStop(0, StepDirection::Forward, stop);
        QCOMPARE(session().runUntil(stop), at.has_value());
        QCOMPARE(session().position(), at ? *at + 1 : log().size());
    };
    expect({StepStop::Kind::Pixel, 3, 4});
    QCOMPARE(session().event()->x, 3);
    QCOMPARE(session().event()->y, 4);
    expect({StepStop::Kind::Tie});
    QVERIFY(session().event()->has(StepEvent::kTie));
    const std::size_t first = session().position();
    QVERIFY(session().runUntil({StepStop::Kind::Tie}));
    QVERIFY(session().position() > first);
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

void TestLens::scrubberGoesThereAndBack()
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

void TestLens::pipsMarkTheMostTellingEvent()
{
    QVERIFY(record());
    const auto one = binPips(log(), 1);
    QCOMPARE(one.size(), std::size_t(1));
    QCOMPARE(one[0], PipKind::Tie);
    const auto many = binPips(log(), int(log().size()) + 1);
    QCOMPARE(many[0], PipKind::None); // the cleared frame
    for (std::size_t i = 0; i < log().size(); ++i)
        QCOMPARE(many[i + 1], pipKindOf(log().event(i)));
    QCOMPARE(std::count(many.begin(), many.end(), PipKind::Tie), std::ptrdiff_t(16));
}

void TestLens::listingPutsNumbersIn()
{
    QVERIFY(record());
    const auto at = log().find(0, StepDirection::Forward, [](const StepEvent& event) {
        return event.kind == StepKind::Sample && event.face == 1 && event.x == 3 && event.y == 4;
    });
    session().moveTo(*at + 1);
    const StepExplanation& told = mode().listing().explanation();
    QVERIFY(told.listing.at(std::size_t(told.line)).code.contains(QStringLiteral("E_AB >= t_AB")));
    QVERIFY2(told.formula.contains(QStringLiteral("E_AB(3.5, 4.5) = 8\u00b7(3.5 \u2212 ")), qPrintable(told.formula));
    QVERIFY(told.formula.contains(QStringLiteral(" = 0\n")));
    QVERIFY(told.formula.contains(QStringLiteral("owned: AB is a left edge")));
    QVERIFY(told.formula.contains(QStringLiteral("next x: E_AB += 8")));
    for (std::size_t i = 0; i < log().size(); ++i) {
        const StepExplanation any = explainStep(log(), i);
        QVERIFY(any.line < int(any.listing.size()));
        QVERIFY(!stepTitle(log(), i).isEmpty());
    }
}

void TestLens::walkingShowsSpans()
{
    setAlgorithm(Algorithm::EdgeWalking);
    QVERIFY(settle());
    QVERIFY(record());
    const auto spans = log().eventsOf(StepKind::Span);
    QVERIFY(spans.size() >= 2);
    const std::uint32_t at = spans[2];
    session().moveTo(at + 1);
    const LensModel& model = *mode().lens().model();
    QVERIFY(model.walk());
    QVERIFY(model.span());
    const StepEvent& event = log().event(at);
    const SpanStep& span = log().payload<SpanStep>(event);
    QCOMPARE(model.span()->xBegin, span.xBegin);
    for (int x = 0; x < 8; ++x) {
        const LensCell cell = model.cell(x, event.y);
        QVERIFY(!cell.hasValues); // this algorithm looks at none
        QCOMPARE(cell.state == LensCell::State::Covered, x >= span.xBegin && x < span.xEnd);
        QCOMPARE(model.cell(x, event.y + 1).state, LensCell::State::Waiting);
    }
    QVERIFY(mode().listing().explanation().formula.contains(QStringLiteral("ceil(")));
    QVERIFY(!viewport().figure(48).isNull());
}

void TestLens::bresenhamShowsItsLine()
{
    QVERIFY(openText("size 16 16\ntri -0.8 -0.8 0 1 1 0 0   0.8 -0.3 0 1 0 1 0   0 0.8 0 1 0 0 1\n"));
    Settings next = settings();
    next.fill = Fill::Wireframe;
    document().setSettings(next);
    QVERIFY(settle());
    QVERIFY(record());
    const auto decisions = log().eventsOf(StepKind::LineDecision);
    QVERIFY(!decisions.empty());
    for (const std::uint32_t i : decisions) {
        session().moveTo(i + 1);
        const LensModel& model = *mode().lens().model();
        const LineDecision& d = log().payload<LineStep>(log().event(i)).decision;
        QCOMPARE(model.line()->decision.decision, d.decision);
        const auto ends = model.lineEnds();
        QVERIFY(ends);
        const glm::ivec2 size = glm::abs((*ends)[1] - (*ends)[0]);
        QCOMPARE(std::max(size.x, size.y), d.longer);
        QCOMPARE(std::min(size.x, size.y), d.shorter);
    }
    QVERIFY(mode().listing().explanation().formula.contains(QStringLiteral("d_upper = ")));
}

void TestLens::changesRecordAnew()
{
    QVERIFY(record());
    session().moveTo(50);
    const auto former = session().log();
    QSignalSpy changed(&session(), &StepSession::logChanged);
    setAlgorithm(Algorithm::EdgeWalking);
    QVERIFY(session().isRecording());
    QVERIFY(!mode().lens().model()); // it was about another picture
    QVERIFY(settle());
    QVERIFY(mode().lens().model());
    QVERIFY(session().log() != former);
    QCOMPARE(changed.count(), 1);
    QCOMPARE(session().position(), std::size_t(50));
    QVERIFY(session().settings() == settings());
}

/// What is on the canvas beside the finished frame is said to be.
void TestLens::numbersSayTheirMoment()
{
    const auto readout = [this] { return m_window->findChild<QLabel*>(QStringLiteral("readout"))->text(); };
    const auto heading = [this] {
        for (const QLabel* label : m_window->findChildren<QLabel*>(QStringLiteral("heading")))
            if (label->text().startsWith(QStringLiteral("Faces")))
                return label->text();
        return QString();
    };
    viewport().selectPixel(QPoint(3, 4));
    QCOMPARE(heading(), QStringLiteral("Faces \u00b7 finished frame"));
    QVERIFY(!readout().contains(QStringLiteral("step")));
    QVERIFY(record());
    session().moveTo(50);
    QCOMPARE(heading(), QStringLiteral("Faces \u00b7 after step 50"));
    QVERIFY2(readout().startsWith(QStringLiteral("after step 50")), qPrintable(readout()));
    session().moveTo(session().size());
    QCOMPARE(heading(), QStringLiteral("Faces \u00b7 finished frame"));
    QVERIFY(!readout().contains(QStringLiteral("step")));
}

void TestLens::otherSceneDropsTheRecord()
{
    QVERIFY(record());
    session().moveTo(50);
    QVERIFY(open(QStringLiteral("builtin:triangle")));
    QVERIFY(session().log());
    QCOMPARE(session().position(), std::size_t(0));
    QCOMPARE(viewport().frame()->scene, document().scene());
}

/// The painter draws faces from far to near: their numbers come in any order.
void TestLens::everyFaceOfThePainterHasItsTriangle()
{
    QVERIFY(openSmall(QStringLiteral("builtin:cube"), {32, 24}));
    QVERIFY(change([](Settings& s) {
        s.visibility = Visibility::Painter;
        s.culling = Culling::None;
    }));
    QVERIFY(record());
    std::vector<std::uint32_t> order;
    for (const std::uint32_t event : log().eventsOf(StepKind::Triangle))
        order.push_back(log().event(event).face);
    QCOMPARE(order.size(), std::size_t(12));
    QVERIFY2(!std::ranges::is_sorted(order), "the order of drawing is not that of the numbers");
    for (const std::uint32_t face : order) {
        session().selectFace(face);
        const StepTriangle* triangle = session().triangle();
        QVERIFY2(triangle, qPrintable(QStringLiteral("face %1").arg(face)));
        QCOMPARE(triangle->screen.face, face);
    }
}

void TestLens::scopeLimitsTheRecord()
{
    QVERIFY(record());
    session().selectFace(1);
    session().setScope(StepScope::SelectedFace);
    QVERIFY(settle());
    for (const StepEvent& event : log().events())
        QVERIFY(event.kind == StepKind::End || event.face == 1);
    session().setRectangle(PixelRect{2, 3, 2, 1});
    session().setScope(StepScope::Rectangle);
    QVERIFY(settle());
    for (const StepEvent& event : log().events())
        QVERIFY(event.x < 0 || (event.x >= 2 && event.x < 4 && event.y == 3));
    QCOMPARE(mode().transport().noticeText(), QString());
}

void TestLens::capIsNoticed()
{
    QVERIFY(open(QStringLiteral("builtin:head")));
    QVERIFY(record());
    QCOMPARE(log().truncated(), !mode().transport().noticeText().isEmpty());
    QVERIFY(log().truncated());
    session().moveTo(log().size());
    QCOMPARE(session().position(), log().size());
}

void TestLens::recordingNeverBlocks()
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

void TestLens::theStripMarksTheStageOfTheStep()
{
    QVERIFY(!m_window->stageStrip().current());
    QVERIFY(record());
    QVERIFY(!m_window->stageStrip().current()); // before the first step
    for (std::size_t position = 1; position <= session().size(); ++position) {
        session().moveTo(position);
        QCOMPARE(m_window->stageStrip().current(), std::optional(stageOf(log().event(position - 1).kind)));
    }
    session().close();
    QVERIFY(settle());
    QVERIFY(!m_window->stageStrip().current());
}

void TestLens::exportsDrawingsAndRuns()
{
    QVERIFY(record());
    session().runUntil({StepStop::Kind::Tie});
    const QString drawing = m_folder.filePath(QStringLiteral("figure.svg"));
    QVERIFY(m_window->exportFigure(drawing));
    QFile file(drawing);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray text = file.readAll();
    QVERIFY(text.contains("<svg"));
    QVERIFY(text.contains("#0072b2")); // the signs, as shapes
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

QTEST_MAIN(TestLens)
#include "test_lens.moc"
