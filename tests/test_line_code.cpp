// What the lens writes beside lines: the loop of the octant a line goes in, and names of corners at one place.
#include "core/render/steps.h"
#include "core/scenes/builtin_scenes.h"
#include "ui/base/named_places.h"
#include "ui/steps/step_formula.h"

#include <QTest>

#include <set>

using namespace rasterlens;

class TestLineCode : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void loopsAreThoseOfTheOctant();
    void cornersAtOnePlaceShareAName();
};

/// From each sample to the next of its line, what moves is what the listing says.
void TestLineCode::loopsAreThoseOfTheOctant()
{
    const Scene scene = *makeBuiltinScene(QStringLiteral("lines")).scene;
    const auto log = renderSteps(scene, scene.defaults);
    std::set<QString> loops;
    for (const std::uint32_t i : log->eventsOf(StepKind::LineDecision)) {
        const LineDecision& d = log->payload<LineStep>(log->event(i)).decision;
        const auto next = log->find(i, StepDirection::Forward,
                                    [](const StepEvent& event) { return event.kind == StepKind::LineSample; });
        QVERIFY(next);
        const glm::ivec2 moved(log->event(*next).x - d.x, log->event(*next).y - d.y);
        const int along = d.steep ? moved.y : moved.x;
        const int aside = d.steep ? moved.x : moved.y;
        QCOMPARE(std::abs(along), 1);
        QCOMPARE(aside != 0, d.sideways);
        const QString u = d.steep ? QStringLiteral("y") : QStringLiteral("x");
        const QString v = d.steep ? QStringLiteral("x") : QStringLiteral("y");
        // The loop is told of the decision and of the sample after it.
        for (const std::size_t at : {std::size_t(i), *next}) {
            const StepExplanation told = explainStep(*log, at);
            const QString loop = told.listing[0].code;
            QVERIFY2(loop.contains((along < 0 ? QStringLiteral("--") : QStringLiteral("++")) + u), qPrintable(loop));
            QVERIFY2(loop.startsWith(QStringLiteral("p = 2 d%1 - d%2;").arg(v, u)), qPrintable(loop));
            const QString step = v + (aside < 0 ? QStringLiteral(" -= 1") : QStringLiteral(" += 1"));
            QVERIFY2(aside == 0 || told.listing[1].code.contains(step), qPrintable(told.listing[1].code));
            loops.insert(loop + told.listing[1].code);
        }
    }
    QCOMPARE(loops.size(), std::size_t(8));
}

void TestLineCode::cornersAtOnePlaceShareAName()
{
    const std::vector<NamedPlace> corners{
        {{10, 10}, QStringLiteral("A")}, {{200, 10}, QStringLiteral("B")}, {{13, 10}, QStringLiteral("C")}};
    const std::vector<NamedPlace> joined = joinedPlaces(corners, 8);
    QCOMPARE(joined.size(), std::size_t(2));
    QCOMPARE(joined[0].name, QStringLiteral("A, C"));
    QCOMPARE(joined[0].at, QPointF(10, 10));
    QCOMPARE(joined[1].name, QStringLiteral("B"));
    QCOMPARE(joinedPlaces(corners, 3).size(), std::size_t(3));
}

QTEST_GUILESS_MAIN(TestLineCode)
#include "test_line_code.moc"
