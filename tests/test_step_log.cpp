#include "core/pipeline/resolve.h"
// The step log: stepping shows what the plain run does, and every position is a moment of it.
#include "core/io/case_file.h"
#include "core/observe/counting_observer.h"
#include "core/render/draw.h"
#include "core/render/render.h"
#include "core/render/steps.h"
#include "core/scenes/builtin_scenes.h"
#include "core/settings/mistakes.h"
#include "tests/seed.h"
#include "tests/support.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

using namespace rasterlens;

namespace
{

Scene builtin(const char* name) { return *makeBuiltinScene(QLatin1String(name)).scene; }

/// Any settings that can be drawn, at a size of a few pixels.
Settings randomSettings(const Scene& scene, std::mt19937& random)
{
    const auto upTo = [&](int n) { return std::uniform_int_distribution<int>(0, n)(random); };
    for (;;) {
        Settings settings = scene.defaults;
        settings.size = {1 + upTo(30), 1 + upTo(30)};
        for (const SettingsField& field : settingsFields())
            if (upTo(2) == 0)
                field.set(settings, field.minimum + upTo(field.maximum - field.minimum));
        if (upTo(3) == 0)
            settings.mistakes = {QString::fromLatin1(mistakes()[random() % mistakes().size()].id)};
        if (!unsupported(scene, settings))
            return settings;
    }
}

/// Each part of a filter is there every other time.
StepFilter randomFilter(const Scene& scene, QSize size, std::mt19937& random)
{
    const auto upTo = [&](int n) { return std::uniform_int_distribution<int>(0, n)(random); };
    StepFilter filter;
    if (upTo(1) == 0)
        filter.pixels = PixelRect{upTo(size.width()), upTo(size.height()), 1 + upTo(8), 1 + upTo(8)};
    if (upTo(1) == 0)
        filter.face = static_cast<std::uint32_t>(upTo(static_cast<int>(scene.mesh.faceCount()) - 1));
    if (upTo(1) == 0)
        filter.kinds = static_cast<StepKinds>(random());
    return filter;
}

Frame plain(const Scene& scene, const Settings& settings)
{
    Frame frame;
    render(scene, settings, frame);
    return frame;
}

/// Keeps the picture and the counters of the moment after event `position`, counting callbacks as the log does.
class Snapshot : public CountingObserver
{
public:
    static constexpr int kFacesPerBatch = 1;

    Snapshot(const Rules& rules, const Frame& frame, std::size_t position)
        : CountingObserver(rules), m_frame(&frame), m_position(position)
    {
    }

    QImage image;
    Statistics counters;

    void onVertex(std::uint32_t, int, std::uint32_t, const ClipVertex&) { tick(); }
    void onFace(std::uint32_t face, FaceFate fate) { CountingObserver::onFace(face, fate), tick(); }
    void onClipPlane(std::uint32_t, ClipPlane, const ClipPolygon&, const ClipPolygon&) { tick(); }
    void onCohenSutherland(std::uint32_t, const ClipPolygon&, const ClipPolygon&) { tick(); }
    void onViewport(std::uint32_t, int, const ClipVertex&, const ScreenVertex&) { tick(); }
    void onClipped(std::uint32_t face, int pieces) { CountingObserver::onClipped(face, pieces), tick(); }
    void onFacing(std::uint32_t, const FacingDecision&) { tick(); }
    void onTriangle(const ScreenTriangle& t) { CountingObserver::onTriangle(t), tick(); }
    template <class Setup>
    void onSetup(const Setup&)
    {
        tick();
    }
    void onOutline() { tick(); }
    void onWalk(const WalkedTriangle&) { tick(); }
    void onSides(const WalkedTriangle&) { tick(); }
    void onHalves(const WalkedTriangle&, const WalkedHalves&) { tick(); }
    void onCrossing(const RowCrossings&) { tick(); }
    void onSpan(int y, int from, int to, const SpanEnds& ends) { CountingObserver::onSpan(y, from, to, ends), tick(); }
    void onSample(int x, int y, const EdgeValues& e, bool c) { CountingObserver::onSample(x, y, e, c), tick(); }
    void onColumn(const FilledColumn&) { tick(); }
    void onLineDecision(const LineDecision&) { tick(); }
    void onLinePosition(const LinePosition&) { tick(); }
    void onLineSample(int x, int y, bool on) { CountingObserver::onLineSample(x, y, on), tick(); }
    void onFragment(const Fragment& f, float stored, bool p) { CountingObserver::onFragment(f, stored, p), tick(); }
    void onShade(const Fragment& f, std::uint32_t color) { CountingObserver::onShade(f, color), tick(); }
    void onWrite(int x, int y, Pixel b, Pixel a) { CountingObserver::onWrite(x, y, b, a), tick(); }

private:
    void tick()
    {
        if (++m_count != m_position)
            return;
        image = m_frame->image.copy();
        counters = statistics();
    }

    const Frame* m_frame;
    std::size_t m_position;
    std::size_t m_count = 0;
};

/// What a run that is looked at after `position` events has drawn. One sample a pixel, no overdraw.
Snapshot partialRun(const Scene& scene, const Settings& settings, std::size_t position)
{
    Frame frame;
    const Resolved resolved = resolve(settings, scene);
    Snapshot snapshot(resolved.rules, frame, position);
    drawScene(scene, resolved, frame, {}, snapshot, std::stop_token());
    return snapshot;
}

bool isSame(const StepCursor& a, const StepCursor& b)
{
    return a.image() == b.image() && std::ranges::equal(a.sampleDepths(), b.sampleDepths()) &&
           a.counters() == b.counters();
}

} // namespace

class TestStepLog : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void builtinScenesLookTheSame_data();
    void builtinScenesLookTheSame();
    void randomSettingsLookTheSame();
    void everyPositionIsAFreshPartialRun();
    void everyPositionIsACappedRun();
    void filtersKeepPixelsAndCounters();
    void pixelFilterKeepsWhatConcernsThePixel();
    void truncatedLogSaysSo();
    void stoppedLogSaysSo();
    void stepsOfEveryLevelGoBackWhereTheyCame();
    void diagonalHasEightTiesWithOwners();
    void tiesLieOnTheTriangle();
    void edgeValuesAreExact();
    void cutsLieOnTheirPlane();
    void bresenhamDistancesAreThoseOfTheLine();
    void ddaPositionsAreThoseOfTheLine();
    void spansRoundTheirEnds();
    void millionEventsAreWalkedBothWays();
};

void TestStepLog::builtinScenesLookTheSame_data()
{
    QTest::addColumn<QString>("name");
    for (const BuiltinScene& scene : builtinScenes())
        QTest::newRow(scene.name) << QString::fromLatin1(scene.name);
}

void TestStepLog::builtinScenesLookTheSame()
{
    QFETCH(QString, name);
    const Scene scene = *makeBuiltinScene(name).scene;
    Settings settings = scene.defaults;
    settings.size = settings.size.boundedTo(QSize(96, 64));
    Frame frame;
    const Statistics statistics = renderCounted(scene, settings, frame);
    StepCursor cursor(renderSteps(scene, settings));
    QVERIFY(!cursor.log().truncated());
    cursor.moveTo(cursor.log().size());
    QVERIFY(cursor.image() == frame.image);
    QVERIFY(cursor.counters() == statistics);
}

void TestStepLog::randomSettingsLookTheSame()
{
    const unsigned seed = test::seedOfRun();
    std::mt19937 random(seed);
    const auto scenes = builtinScenes();
    std::vector<Scene> small;
    for (const BuiltinScene& scene : scenes)
        if (Scene made = builtin(scene.name); made.mesh.faceCount() < 300)
            small.push_back(std::move(made));
    for (int i = 0; i < 1000; ++i) {
        const Scene& scene = small[random() % small.size()];
        Settings settings = randomSettings(scene, random);
        if (settings.algorithm == Algorithm::Tiled)
            settings.algorithm = Algorithm::EdgeEquation; // which is what is recorded for it
        const StepFilter filter = i % 2 == 0 ? StepFilter() : randomFilter(scene, settings.size, random);
        StepCursor cursor(renderSteps(scene, settings, filter));
        cursor.moveTo(cursor.log().size());
        if (cursor.log().truncated())
            continue;
        Frame frame;
        const Statistics statistics = renderCounted(scene, settings, frame);
        const QByteArray what = QStringLiteral("%1 of seed %2, %3 ").arg(i).arg(seed).arg(scene.id).toUtf8() +
                                settings.mistakes.join(QLatin1Char(' ')).toUtf8();
        QVERIFY2(cursor.image() == plain(scene, settings).image, what.constData());
        QVERIFY2(cursor.image() == frame.image, what.constData());
        QVERIFY2(cursor.counters() == statistics, what.constData());
    }
}

void TestStepLog::everyPositionIsAFreshPartialRun()
{
    const unsigned seed = test::seedOfRun();
    std::mt19937 random(seed);
    for (const char* name : {"triangle", "painter-cycle", "tunnel", "lines"}) {
        const Scene scene = builtin(name);
        for (int i = 0; i < 10; ++i) {
            Settings settings = randomSettings(scene, random);
            settings.samples = Samples::One; // so that the picture is finished at any time
            settings.shading = Shading::Gouraud;
            settings.mistakes.clear();
            if (settings.algorithm == Algorithm::Tiled)
                settings.algorithm = Algorithm::EdgeEquation;
            if (unsupported(scene, settings))
                continue;
            StepCursor cursor(renderSteps(scene, settings));
            for (int k = 0; k < 10 && cursor.log().size() > 1; ++k) {
                const std::size_t position = 1 + random() % (cursor.log().size() - 1);
                cursor.moveTo(position);
                const Snapshot fresh = partialRun(scene, settings, position);
                QVERIFY2(cursor.image() == fresh.image, name);
                QVERIFY2(cursor.counters() == fresh.counters, name);
            }
        }
    }
}

void TestStepLog::everyPositionIsACappedRun()
{
    const unsigned seed = test::seedOfRun();
    std::mt19937 random(seed);
    for (const char* name : {"square-diagonal", "piercing", "cube", "behind-camera"}) {
        const Scene scene = builtin(name);
        for (int i = 0; i < 10; ++i) {
            const Settings settings = randomSettings(scene, random);
            StepFilter filter = randomFilter(scene, settings.size, random);
            StepCursor cursor(renderSteps(scene, settings, filter));
            const std::size_t size = cursor.log().size();
            for (int k = 0; k < 10; ++k) {
                filter.cap = random() % size;
                StepCursor capped(renderSteps(scene, settings, filter));
                QVERIFY(capped.log().truncated() || filter.cap + 1 == size);
                QVERIFY(capped.log().size() <= filter.cap + 1);
                const std::size_t position = std::min(filter.cap, capped.log().size());
                capped.moveTo(position);
                cursor.moveTo(position);
                QVERIFY2(isSame(cursor, capped), name);
            }
        }
    }
}

void TestStepLog::filtersKeepPixelsAndCounters()
{
    const Scene scene = builtin("piercing");
    Settings settings = scene.defaults;
    settings.size = {40, 30};
    StepCursor whole(renderSteps(scene, settings));
    StepFilter filter;
    filter.pixels = PixelRect{18, 12, 3, 3};
    StepCursor part(renderSteps(scene, settings, filter));
    QVERIFY(part.log().size() > 20);
    std::size_t position = 0;
    for (std::size_t k = 1; k <= part.log().size(); ++k) {
        const StepEvent& event = part.log().event(k - 1);
        const auto same = [&](const StepEvent& e) {
            return e.kind == event.kind && e.face == event.face && e.x == event.x && e.y == event.y;
        };
        position = *whole.log().find(position, StepDirection::Forward, same) + 1;
        part.moveTo(k);
        whole.moveTo(position);
        QVERIFY2(isSame(part, whole), qPrintable(QString::number(k)));
    }
    QCOMPARE(position, whole.log().size());
    whole.moveTo(0);
    part.moveTo(0);
    QVERIFY(isSame(part, whole));
}

void TestStepLog::pixelFilterKeepsWhatConcernsThePixel()
{
    const Scene scene = builtin("sphere");
    Settings settings = scene.defaults;
    settings.size = {64, 48};
    StepFilter filter;
    filter.pixels = PixelRect{32, 24, 1, 1};
    const auto log = renderSteps(scene, settings, filter);
    std::size_t written = 0;
    for (const StepEvent& event : log->events()) {
        QVERIFY(event.x < 0 || (event.x == 32 && event.y == 24));
        written += event.kind == StepKind::Write ? 1 : 0;
        const auto touches = [&](const StepEvent& e) { return e.face == event.face && e.x == 32; };
        QVERIFY(event.kind == StepKind::End || log->find(0, StepDirection::Forward, touches));
    }
    QCOMPARE(written, std::size_t(1));
}

void TestStepLog::truncatedLogSaysSo()
{
    const Scene scene = builtin("triangle");
    StepFilter filter;
    filter.cap = 50;
    const auto log = renderSteps(scene, scene.defaults, filter);
    QVERIFY(log->truncated());
    QCOMPARE(log->size(), std::size_t(50));
    QVERIFY(log->eventsOf(StepKind::End).empty());
    QVERIFY(!renderSteps(builtin("square-diagonal"), builtin("square-diagonal").defaults)->truncated());
}

void TestStepLog::stoppedLogSaysSo()
{
    const Scene scene = builtin("triangle");
    std::stop_source stop;
    stop.request_stop();
    const auto log = renderSteps(scene, scene.defaults, {}, stop.get_token());
    QVERIFY(log->stopped());
    QVERIFY(!log->truncated());
    QCOMPARE(log->size(), std::size_t(0));
}

void TestStepLog::stepsOfEveryLevelGoBackWhereTheyCame()
{
    const Scene scene = builtin("square-diagonal");
    const auto log = renderSteps(scene, scene.defaults);
    std::size_t previousCount = log->size() + 1;
    for (const StepLevel level : {StepLevel::Event, StepLevel::Row, StepLevel::Stage, StepLevel::Face}) {
        std::vector<std::size_t> stations{0};
        while (stations.back() < log->size())
            stations.push_back(log->step(stations.back(), level, StepDirection::Forward));
        QVERIFY(stations.size() <= previousCount);
        previousCount = stations.size() - 1;
        std::size_t position = log->size();
        for (std::size_t i = stations.size(); i-- > 0;) {
            QCOMPARE(position, stations[i]);
            position = log->step(position, level, StepDirection::Backward);
        }
        QCOMPARE(position, std::size_t(0));
    }
    QCOMPARE(previousCount, std::size_t(3)); // two faces and the end
}

void TestStepLog::diagonalHasEightTiesWithOwners()
{
    const Scene scene = builtin("square-diagonal");
    const auto log = renderSteps(scene, scene.defaults);
    std::map<std::pair<int, int>, std::vector<std::pair<EdgeSide, bool>>> ties;
    std::size_t from = 0;
    while (const auto at = log->findStop(from, StepDirection::Forward, {StepStop::Kind::Tie})) {
        const StepEvent& event = log->event(*at);
        const EdgeValues& values = log->payload<SampleStep>(event).values;
        const auto edge = std::size_t(std::ranges::find(values, 0.0) - values.begin());
        QVERIFY(edge < 3);
        ties[{event.x, event.y}].emplace_back(log->triangle(event)->setup.edges[edge].side,
                                              event.has(StepEvent::kCovered));
        from = *at + 1;
    }
    QCOMPARE(ties.size(), std::size_t(8));
    for (const auto& [pixel, sides] : ties) {
        QCOMPARE(sides.size(), std::size_t(2)); // each triangle meets the centre on its edge
        int owners = 0;
        for (const auto& [side, covered] : sides) {
            QCOMPARE(covered, side != EdgeSide::Neither);
            owners += covered ? 1 : 0;
        }
        QCOMPARE(owners, 1);
    }
}

/// The line of an edge goes on beyond the edge: a centre there has an edge value of 0, yet there is no tie to decide.
void TestStepLog::tiesLieOnTheTriangle()
{
    const QSize size(8, 8);
    const auto at = [&](double x, double y) { return test::atPixel(x, y, 0.5, size); };
    // The line of the first edge runs on through the centres of the pixels (4, 2), (5, 1) and (6, 0), which lie in the
    // bounding box of the face but not in the face.
    const Scene scene = test::soup({at(0.5, 6.5), at(3.5, 3.5), at(7.5, 0.5)});
    const auto log = renderSteps(scene, test::plainSettings(size));
    int ties = 0;
    int beyond = 0;
    for (std::size_t i = 0; i < log->size(); ++i) {
        const StepEvent& event = log->event(i);
        if (event.kind != StepKind::Sample)
            continue;
        const EdgeValues& values = log->payload<SampleStep>(event).values;
        const bool onLine = std::ranges::any_of(values, [](double v) { return v == 0; });
        const bool inside = std::ranges::all_of(values, [](double v) { return v >= 0; });
        QCOMPARE(event.has(StepEvent::kTie), onLine && inside);
        ties += onLine && inside ? 1 : 0;
        beyond += onLine && !inside ? 1 : 0;
    }
    QVERIFY(ties > 0);
    QCOMPARE(beyond, 3);
}

void TestStepLog::edgeValuesAreExact()
{
    const unsigned seed = test::seedOfRun();
    std::mt19937 random(seed);
    std::size_t samples = 0;
    for (int i = 0; i < 50; ++i) {
        QByteArray text = "size 16 12\ntri";
        for (int corner = 0; corner < 3; ++corner) {
            for (int axis = 0; axis < 2; ++axis)
                text += ' ' + QByteArray::number(int(random() % 2001) / 1000.0 - 1);
            text += " 0 1 1 1 1 ";
        }
        const Scene scene = *parseCase(text + "\n", QStringLiteral("random.case")).scene;
        const auto log = renderSteps(scene, scene.defaults);
        for (const StepEvent& event : log->events()) {
            if (event.kind != StepKind::Sample)
                continue;
            ++samples;
            // Twice the area of the edge and the centre, in 24.8 integers, from the snapped corners alone.
            const StepTriangle& triangle = *log->triangle(event);
            std::array<std::int64_t, 3> x;
            std::array<std::int64_t, 3> y;
            for (std::size_t v = 0; v < 3; ++v) {
                const glm::dvec2& p = triangle.screen.vertices[triangle.setup.source[v]].position;
                x[v] = std::llround(p.x * 256);
                y[v] = std::llround(p.y * 256);
            }
            const std::int64_t px = event.x * 256 + 128;
            const std::int64_t py = event.y * 256 + 128;
            for (std::size_t v = 0; v < 3; ++v) {
                const std::size_t w = (v + 1) % 3;
                const std::int64_t e = (x[v] - px) * (y[w] - py) - (x[w] - px) * (y[v] - py);
                QCOMPARE(log->payload<SampleStep>(event).values[v], double(-e));
                QCOMPARE(triangle.setup.at(testedPoint(log->rules(), event.x, event.y))[v], double(-e));
            }
        }
    }
    QVERIFY(samples > 500);
}

void TestStepLog::cutsLieOnTheirPlane()
{
    const Scene scene = builtin("behind-camera");
    Settings settings = scene.defaults;
    settings.size = {32, 32};
    const auto log = renderSteps(scene, settings);
    std::size_t cuts = 0;
    for (const std::uint32_t i : log->eventsOf(StepKind::ClipPlane)) {
        const ClipStep& step = log->payload<ClipStep>(log->event(i));
        for (const ClipCut& cut : step.cuts) {
            ++cuts;
            const auto at = [](const std::vector<ClipVertex>& corners, int c) {
                return corners[std::size_t(c)].positionClip;
            };
            QVERIFY(step.distances[std::size_t(cut.inside)] >= 0 && step.distances[std::size_t(cut.outside)] < 0);
            QVERIFY(cut.t >= 0 && cut.t <= 1);
            const glm::dvec4 a = at(step.before, cut.inside);
            const glm::dvec4 expected = a + cut.t * (at(step.before, cut.outside) - a);
            QVERIFY(glm::distance(at(step.after, cut.corner), expected) < 1e-9);
        }
    }
    QVERIFY(cuts >= 2);
}

void TestStepLog::bresenhamDistancesAreThoseOfTheLine()
{
    const Scene scene = builtin("lines");
    Settings settings = scene.defaults;
    settings.fill = Fill::Wireframe;
    const auto log = renderSteps(scene, settings);
    const auto decisions = log->eventsOf(StepKind::LineDecision);
    QVERIFY(!decisions.empty());
    int firstOfLine = 0;
    int shorterSteps = 0;
    for (const std::uint32_t i : decisions) {
        const LineStep& step = log->payload<LineStep>(log->event(i));
        const LineDecision& d = step.decision;
        if (d.step == 0) {
            QCOMPARE(d.decision, 2 * d.shorter - d.longer);
            shorterSteps = 0;
            ++firstOfLine;
        }
        // After step + 1 steps along the longer axis the ideal line is this far from the sample beside it.
        const double ideal = double(d.step + 1) * d.shorter / d.longer - shorterSteps;
        QVERIFY(std::abs(step.dLower() - ideal) < 1e-12);
        QVERIFY(std::abs(step.dUpper() - (1 - ideal)) < 1e-12);
        QCOMPARE(d.sideways, d.decision > 0);
        shorterSteps += d.sideways ? 1 : 0;
    }
    QVERIFY(firstOfLine > 10);
}

/// A line from A to B with n = max(|dx|, |dy|): its i-th position is A + i (B - A) / n, and its sample the nearest.
void TestStepLog::ddaPositionsAreThoseOfTheLine()
{
    const Scene scene = builtin("lines");
    Settings settings = scene.defaults;
    settings.fill = Fill::Wireframe;
    settings.line = LineAlgorithm::Dda;
    const auto log = renderSteps(scene, settings);
    QVERIFY(log->eventsOf(StepKind::LineDecision).empty());
    int lines = 0;
    int steep = 0;
    for (const std::uint32_t i : log->eventsOf(StepKind::LinePosition)) {
        const StepEvent& event = log->event(i);
        const LinePosition& p = log->payload<LinePositionStep>(event).position;
        const auto& vertices = log->triangle(event)->screen.vertices;
        bool isFound = false;
        for (std::size_t k = 0; k < 3; ++k) {
            const GridPoint from = sampleOf(vertices[k].position);
            const GridPoint to = sampleOf(vertices[(k + 1) % 3].position);
            const int dx = to.x - from.x;
            const int dy = to.y - from.y;
            const int n = std::max(std::abs(dx), std::abs(dy));
            const double part = n > 0 ? double(p.step) / n : 0;
            isFound = isFound || (p.steps == n && std::abs(p.x - (from.x + part * dx)) < 1e-9 &&
                                  std::abs(p.y - (from.y + part * dy)) < 1e-9);
        }
        QVERIFY(isFound);
        QVERIFY(std::abs(p.error()) <= 0.5 && std::abs(p.x - p.column) <= 0.5 && std::abs(p.y - p.row) <= 0.5);
        QCOMPARE(p.error(), p.steep() ? p.x - p.column : p.y - p.row);
        // The sample of the position follows.
        const StepEvent& next = log->event(i + 1);
        QCOMPARE(next.kind, StepKind::LineSample);
        QCOMPARE(next.x, p.column);
        QCOMPARE(next.y, p.row);
        lines += p.step == 0 ? 1 : 0;
        steep += p.steep() ? 1 : 0;
    }
    QVERIFY(lines > 10 && steep > 10);
}

void TestStepLog::spansRoundTheirEnds()
{
    const Scene scene = builtin("triangle");
    Settings settings = scene.defaults;
    settings.size = {37, 23};
    settings.algorithm = Algorithm::EdgeWalking;
    const auto log = renderSteps(scene, settings);
    QVERIFY(!log->eventsOf(StepKind::Span).empty());
    QCOMPARE(log->eventsOf(StepKind::Walk).size(), std::size_t(1));
    for (const std::uint32_t i : log->eventsOf(StepKind::Span)) {
        const SpanStep& span = log->payload<SpanStep>(log->event(i));
        QCOMPARE(double(span.ends.begin), std::ceil(span.ends.left - 0.5));
        QCOMPARE(double(span.ends.end), std::ceil(span.ends.right - 0.5));
        const WalkedTriangle& walk = log->payload<WalkStep>(log->event(log->eventsOf(StepKind::Walk)[0])).walk;
        QCOMPARE(span.ends.upperHalf, log->event(i).y + 0.5 < walk.vertices[1].y);
    }
}

void TestStepLog::millionEventsAreWalkedBothWays()
{
    const Scene scene = builtin("piercing");
    Settings settings = scene.defaults;
    settings.size = {1920, 1080};
    StepCursor cursor(renderSteps(scene, settings));
    QCOMPARE(cursor.log().size(), std::size_t(1'000'000));
    QVERIFY(cursor.log().truncated());
    cursor.moveTo(cursor.log().size());
    const QImage end = cursor.image().copy();
    QBENCHMARK
    {
        cursor.moveTo(0);
        cursor.moveTo(cursor.log().size());
    }
    QVERIFY(cursor.image() == end);
    cursor.moveTo(0);
    QImage cleared(settings.size, QImage::Format_RGB32);
    cleared.fill(cursor.log().clear().color);
    QVERIFY(cursor.image() == cleared);
}

QTEST_APPLESS_MAIN(TestStepLog)
#include "test_step_log.moc"
