// The step mode in the window: the lens's numbers, what the canvas shows, and when steps are recorded anew.
#include "core/observe/step_text.h"
#include "tests/step_fixture.h"
#include "ui/base/inks.h"
#include "ui/face/cards.h"
#include "ui/pipeline/stage_strip.h"
#include "ui/steps/code_line.h"
#include "ui/steps/lens_overlay.h"
#include "ui/steps/step_listing.h"
#include "ui/steps/transport_dock.h"
#include "ui/steps/walk_painter.h"

#include <QLabel>
#include <QSignalSpy>

#include <algorithm>
#include <set>
#include <vector>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

std::array<EdgeSign, 3> signsOf(const EdgeValues& values)
{
    return {signOf(values[0]), signOf(values[1]), signOf(values[2])};
}

} // namespace

class TestLens : public StepFixture
{
    Q_OBJECT

private Q_SLOTS:
    void init() { openSquare(); }
    void offUntilOpened();
    void startsPaused();
    void arrowsNudgeOutsideOfStepMode();
    void cellsEqualExactValues();
    void statesFollowThePosition();
    void tiesNameTheirOwner();
    void canvasShowsTheCursor();
    void endIsTheFinishedPicture();
    void listingPutsNumbersIn();
    void walkingShowsSpans();
    void walkingGoesThroughItsStages();
    void flatTrianglesHaveOneHalf();
    void bresenhamShowsItsLine();
    void changesRecordAnew();
    void numbersSayTheirMoment();
    void otherSceneDropsTheRecord();
    void everyFaceOfThePainterHasItsTriangle();
    void scopeLimitsTheRecord();
    void cellsReachBeyondTheWindow();
    void geometryShowsThePolygonOfTheMoment();
    void theSentenceLeavesCornersInSight();
    void theStripMarksTheStageOfTheStep();
    void mistakesFitSmallWindows_data();
    void mistakesFitSmallWindows();
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

/// C (7, 1), B (15, 7), A (2, 10): 1, 2 and 3 by height; the long edge is CA.
void TestLens::walkingGoesThroughItsStages()
{
    QVERIFY(
        openText("size 16 12\ntri -0.75 -0.666666667 0 1 1 1 1  0.875 -0.166666667 0 1 1 1 1  -0.125 0.833333333 0 1 "
                 "1 1 1\n"));
    setAlgorithm(Algorithm::EdgeWalking);
    QVERIFY(settle());
    QVERIFY(record());
    const auto goTo = [&](StepKind kind, std::size_t nth = 0) {
        session().moveTo(std::size_t(log().eventsOf(kind)[nth]) + 1);
        return mode().listing().explanation();
    };
    const auto has = [&](QRgb color) {
        const QImage figure = viewport().figure(32);
        for (int y = 0; y < figure.height(); ++y)
            for (int x = 0; x < figure.width(); ++x)
                if (figure.pixel(x, y) == color)
                    return true;
        return false;
    };
    const auto cornerNames = [&] {
        QStringList names;
        for (std::size_t i = 0; i < 3; ++i)
            names << walkedCornerName(*mode().lens().model(), i);
        return names.join(QLatin1Char(' '));
    };

    const StepExplanation outline = goTo(StepKind::Outline);
    QVERIFY(outline.formula.contains(QStringLiteral("AB 3, BC 6, CA 9")));
    QCOMPARE(cornerNames(), QStringLiteral("A B C"));
    goTo(StepKind::Walk);
    QCOMPARE(cornerNames(), QStringLiteral("A = 3 B = 2 C = 1"));
    QVERIFY(!has(kCanvasLongEdge) && !has(kCanvasBrokenEdge));

    const StepExplanation sides = goTo(StepKind::Sides);
    QVERIFY(sides.formula.contains(QStringLiteral("long edge CA, from 1 to 3")));
    QVERIFY(sides.formula.contains(QStringLiteral("BC and AB")));
    QVERIFY(has(kCanvasLongEdge) && has(kCanvasBrokenEdge));

    const StepExplanation halves = goTo(StepKind::Halves);
    QVERIFY2(halves.listing[std::size_t(halves.line)].code.contains(QStringLiteral("up = y < y2 || y2 == y3")),
             qPrintable(QString::number(halves.line) + halves.listing[std::size_t(halves.line)].code));
    QVERIFY2(halves.formula.contains(QStringLiteral("alpha = 0.666667, x = 3.66667")), qPrintable(halves.formula));
    QVERIFY(halves.formula.contains(QStringLiteral("rows of the upper half 1..6, of the lower half 7..9")));

    // Row 3: 2.5 rows of 9 down the long edge, of 6 down the short one.
    const StepExplanation crossing = goTo(StepKind::Crossing, 2);
    const QString minus(QChar(0x2212));
    QCOMPARE(crossing.formula,
             QStringLiteral("alpha = (3.5 - 1) / (10 - 1) = 0.277778   xa = 7 + 0.277778\u00b7(2 - 7) = 5.61111111\n"
                            "beta = (3.5 - 1) / (7 - 1) = 0.416667   xb = 7 + 0.416667\u00b7(15 - 7) = 10.3333333")
                 .replace(QLatin1Char('-'), minus));
    QVERIFY(crossing.listing[std::size_t(crossing.line)].code.contains(QStringLiteral("alpha = (y-y1) / (y3-y1)")));
    QVERIFY(mode().lens().model()->crossings()->upperHalf);
    const StepExplanation span = goTo(StepKind::Span, 2);
    QVERIFY(span.formula.contains(QStringLiteral("x = 6 \u2026 9")));
    QVERIFY(!viewport().figure(32).isNull());
}

void TestLens::flatTrianglesHaveOneHalf()
{
    QVERIFY(openText("size 16 16\ntri -0.5 0.5 0 1 1 1 1  -0.25 -0.5 0 1 1 1 1  0.75 0.5 0 1 1 1 1\n"));
    setAlgorithm(Algorithm::EdgeWalking);
    QVERIFY(settle());
    QVERIFY(record());
    session().moveTo(std::size_t(log().eventsOf(StepKind::Halves)[0]) + 1);
    const QString formula = mode().listing().explanation().formula;
    QVERIFY2(formula.contains(QStringLiteral("there is no upper half")), qPrintable(formula));
    QVERIFY(!viewport().figure(32).isNull());
    for (const std::uint32_t i : log().eventsOf(StepKind::Crossing))
        QVERIFY(!log().payload<CrossingStep>(log().event(i)).row.upperHalf);
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
    QVERIFY(complete()); // the words follow before the window is painted
    QCOMPARE(heading(), QStringLiteral("Faces \u00b7 after step 50"));
    QVERIFY2(readout().startsWith(QStringLiteral("after step 50")), qPrintable(readout()));
    session().moveTo(session().size());
    QVERIFY(complete());
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

void TestLens::mistakesFitSmallWindows_data()
{
    QTest::addColumn<LanguageKind>("language");
    QTest::newRow("English") << LanguageKind::English;
    QTest::newRow("Chinese") << LanguageKind::Chinese;
}

/// What has no room at the least usual size ends in dots and is whole in the tool tip; nothing is left out in between.
void TestLens::mistakesFitSmallWindows()
{
    QFETCH(LanguageKind, language);
    m_window->resize(1024, 768);
    m_window->setLanguage(language);
    QVERIFY(m_window->cards().show(QStringLiteral("why")));
    QVERIFY(change([](Settings& s) {
        s.mistakes = {QStringLiteral("all-inclusive")};
        s.reversedZ = true;
        s.numberType = NumberType::Float32;
    }));
    mode().showStep(QStringLiteral("tie"));
    QVERIFY(complete());
    const StepListing& listing = mode().listing();
    const StepExplanation& told = listing.explanation();
    const ListingLine& line = told.listing.at(std::size_t(told.line));
    QVERIFY(!line.right.isEmpty());
    const CodeLine& shown = *listing.lines().at(std::size_t(told.line));
    QVERIFY(shown.isVisible());
    QCOMPARE(shown.shown().code, line.code);
    const QString right = shown.shown().right;
    const QString whole = line.right.trimmed();
    const QChar dots(0x2026);
    QVERIFY2(right == whole || (right.endsWith(dots) && whole.startsWith(right.chopped(1)) && right.size() > 12),
             qPrintable(right));
    QVERIFY(shown.toolTip().contains(whole));

    const QString formula = told.formula.simplified();
    QString rows = listing.formulaRows().join(QLatin1Char(' ')).simplified();
    QVERIFY2(rows == formula || (rows.endsWith(dots) && formula.startsWith(rows.chopped(1))), qPrintable(rows));
    QVERIFY2(rows.size() > formula.size() / 2, qPrintable(rows));
    const QString snapped = m_window->stageStrip().shown(Stage::Screen);
    QVERIFY2(!snapped.isEmpty() && !snapped.contains(dots), qPrintable(snapped));
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
        const StepTriangle* triangle = session().lookedAt().triangle();
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
    const auto kindsOf = [&](StepScope scope) {
        session().setScope(scope);
        std::set<StepKind> kinds;
        if (settle())
            for (const StepEvent& event : log().events())
                kinds.insert(event.kind);
        return kinds;
    };
    QCOMPARE(kindsOf(StepScope::Geometry),
             (std::set{StepKind::Vertex, StepKind::Viewport, StepKind::Facing, StepKind::Fate, StepKind::End}));
    QCOMPARE(kindsOf(StepScope::Coverage),
             (std::set{StepKind::Triangle, StepKind::Setup, StepKind::Sample, StepKind::End}));
    session().selectPixel(QPoint(5, 6));
    session().setScope(StepScope::SelectedPixel);
    QVERIFY(settle());
    for (const StepEvent& event : log().events())
        QVERIFY(event.x < 0 || (event.x == 5 && event.y == 6));
    session().selectPixel(QPoint(1, 2)); // another pixel is another record
    QVERIFY(settle());
    QVERIFY(log().findStop(0, StepDirection::Forward, {StepStop::Kind::Pixel, 1, 2}));
}

/// A triangle of many more events than a window holds: the lens knows of each of its samples what a log of all events
/// knows.
void TestLens::cellsReachBeyondTheWindow()
{
    QVERIFY(openSmall(QStringLiteral("builtin:triangle"), {600, 480}));
    for (const Algorithm algorithm : {Algorithm::EdgeEquation, Algorithm::EdgeWalking}) {
        QVERIFY(change([algorithm](Settings& s) {
            s.algorithm = algorithm;
            s.numberType = NumberType::Float32;
        }));
        QVERIFY(record());
        const auto all = renderSteps(*document().scene(), session().settings());
        QVERIFY(all->size() == session().size() && all->size() > 2 * session().record()->index().memory().windowEvents);
        const StepEvent& triangle = all->event(all->eventsOf(StepKind::Triangle).front());
        for (std::size_t position = all->size() / 7; position < all->size(); position += all->size() / 7) {
            session().moveTo(position);
            const LensModel expected(*all, triangle, position);
            const StepSession::LookedAt& here = session().lookedAt();
            QVERIFY(here.log && here.log->size() < all->size());
            const LensModel model(*here.log, *here.begin, here.position, session().event());
            model.setFar(session().coverage(*here.triangle(), {0, 0, 600, 480}));
            for (int y = 0; y < 480; y += 5)
                for (int x = 0; x < 600; x += 11) {
                    const LensCell cell = model.cell(x, y);
                    const LensCell right = expected.cell(x, y);
                    QCOMPARE(cell.state, right.state);
                    if (cell.state == LensCell::State::Covered || cell.state == LensCell::State::Rejected)
                        QCOMPARE(cell.values, right.values);
                }
        }
    }
}

/// A face that two of its corners leave the view volume with: its polygon while geometry is stepped.
void TestLens::geometryShowsThePolygonOfTheMoment()
{
    QVERIFY(openText("size 16 16\ntri -0.8 -0.8 -1.5 1 1 0 0   0.8 -0.8 0.5 1 0 1 0   0 0.8 0.5 1 0 0 1\n"));
    QVERIFY(record());
    const auto namesAt = [&](std::size_t position) {
        session().moveTo(position);
        QStringList names;
        if (const auto& moment = mode().geometry().moment())
            for (const MomentCorner& corner : moment->corners)
                names << corner.name;
        return names.join(QLatin1Char(' '));
    };
    QCOMPARE(namesAt(0), QString());
    QCOMPARE(namesAt(2), QStringLiteral("A B"));
    QCOMPARE(namesAt(3), QStringLiteral("A B C"));
    const auto cut = std::size_t(log().eventsOf(StepKind::ClipPlane).front());
    QCOMPARE(namesAt(cut + 1), QStringLiteral("I1 B C I2"));
    const FaceMoment moment = *mode().geometry().moment();
    const ClipStep& step = log().payload<ClipStep>(log().event(cut));
    for (std::size_t i = 0; i < moment.corners.size(); ++i)
        QCOMPARE(moment.corners[i].positionClip, step.after[i].positionClip);
    QCOMPARE(moment.before.size(), std::size_t(3));
    QVERIFY(!mode().lens().model());
    QVERIFY(momentLines(moment, log().rules()).front().contains(QStringLiteral("4 corners are left")));
    const auto fate = std::size_t(log().eventsOf(StepKind::Fate).front());
    QCOMPARE(namesAt(fate + 1), QStringLiteral("I1 B C I2"));
    for (const MomentCorner& corner : mode().geometry().moment()->corners)
        QVERIFY(corner.snapped);
    QCOMPARE(namesAt(fate + 2), QString()); // coverage begins
    QVERIFY(mode().lens().model());
}

/// The sentence of the moment stands in the corner of the canvas where it hides the least of corners and names.
void TestLens::theSentenceLeavesCornersInSight()
{
    const QRectF canvas(0, 0, 800, 600);
    const QSizeF size(200, 40);
    const QRectF upperLeft(5, 5, 20, 20);
    const QRectF upperRight(780, 10, 10, 20);
    const QRectF lowerLeft(30, 560, 20, 20);
    QCOMPARE(freeCorner(canvas, size, {upperLeft}), QPointF(588, 12));
    QCOMPARE(freeCorner(canvas, size, {upperLeft, upperRight}), QPointF(12, 548));
    QCOMPARE(freeCorner(canvas, size, {upperLeft, upperRight, lowerLeft}), QPointF(588, 548));
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

QTEST_MAIN(TestLens)
#include "test_lens.moc"
