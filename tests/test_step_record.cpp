// The step record: it makes events anew, so whatever is asked of it must be what a log of all events would answer.
#include "core/observe/counting_observer.h"
#include "core/observe/step_text.h"
#include "core/render/draw.h"
#include "core/render/render.h"
#include "core/render/steps.h"
#include "core/scenes/builtin_scenes.h"
#include "core/settings/mistakes.h"
#include "tests/seed.h"
#include "tests/support.h"

#include <QElapsedTimer>
#include <QTest>

#include <algorithm>
#include <bit>
#include <random>

using namespace rasterlens;

namespace
{

/// Little of everything, so that small pictures have many resume points and windows.
constexpr RecordMemory kLittle{60, std::size_t(1) << 18, 100};

std::shared_ptr<const Scene> builtin(const char* name)
{
    return std::make_shared<const Scene>(*makeBuiltinScene(QLatin1String(name)).scene);
}

class Draws
{
public:
    explicit Draws(unsigned seed) : m_random(seed) {}

    /// 0..n
    int upTo(int n) { return std::uniform_int_distribution<int>(0, n)(m_random); }
    std::size_t below(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(m_random); }

    /// Any settings that can be drawn, at a size of a few pixels.
    Settings settings(const Scene& scene)
    {
        for (;;) {
            Settings settings = scene.defaults;
            settings.size = {1 + upTo(40), 1 + upTo(40)};
            for (const SettingsField& field : settingsFields())
                if (upTo(2) == 0)
                    field.set(settings, field.minimum + upTo(field.maximum - field.minimum));
            if (upTo(1) == 0)
                settings.mistakes = {QString::fromLatin1(mistakes()[below(mistakes().size())].id)};
            if (!unsupported(scene, settings))
                return settings;
        }
    }

    /// Each part of a filter is there every other time.
    StepFilter filter(const Scene& scene, QSize size)
    {
        StepFilter filter;
        filter.cap = 10'000'000;
        if (upTo(1) == 0)
            return filter;
        if (upTo(1) == 0)
            filter.pixels = PixelRect{upTo(size.width()), upTo(size.height()), 1 + upTo(8), 1 + upTo(8)};
        if (upTo(1) == 0)
            filter.face = static_cast<std::uint32_t>(upTo(static_cast<int>(scene.mesh.faceCount()) - 1));
        if (upTo(1) == 0)
            filter.kinds = static_cast<StepKinds>(m_random());
        return filter;
    }

private:
    std::mt19937 m_random;
};

/// What differs between two cursors at one position; null: nothing.
const char* difference(const StepCursor& a, const StepCursor& b)
{
    if (a.image() != b.image())
        return "picture";
    if (!std::ranges::equal(a.sampleColors(), b.sampleColors()))
        return "colours";
    const auto bits = [](float depth) { return std::bit_cast<std::uint32_t>(depth); };
    if (!std::ranges::equal(a.sampleDepths(), b.sampleDepths(), {}, bits, bits))
        return "depths";
    if (!std::ranges::equal(a.sampleOwners(), b.sampleOwners()))
        return "owners";
    if (!(a.counters() == b.counters()))
        return "counters";
    if (a.position() != b.position())
        return "position";
    if ((a.lastEvent() == nullptr) != (b.lastEvent() == nullptr))
        return "last event";
    if (a.lastEvent() != nullptr &&
        stepText(a.log(), a.positionInLog() - 1) != stepText(b.log(), b.positionInLog() - 1))
        return "text";
    if (a.lastEvent() != nullptr && a.lastEvent()->flags != b.lastEvent()->flags)
        return "flags";
    return nullptr;
}

/// Counts events, and keeps the picture after the n-th of them.
class Snapshot : public CountingObserver
{
public:
    static constexpr int kFacesPerBatch = 1;

    /// in  what a cleared sample stores: pixels of nothing else have no event
    Snapshot(const Rules& rules, const Frame& frame, const Pixel& clear, std::size_t position)
        : CountingObserver(rules), m_frame(&frame), m_clear(clear), m_position(position)
    {
    }

    QImage image;
    std::vector<std::int32_t> owners;
    Statistics counters;
    std::size_t count = 0;

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
    void onResolve(const ResolvedPixel& pixel)
    {
        for (int i = 0; i < pixel.count; ++i)
            if (pixel.samples[std::size_t(i)] != m_clear) {
                tick();
                return;
            }
    }

private:
    void tick()
    {
        if (++count != m_position)
            return;
        image = m_frame->image.copy();
        owners = m_frame->ids;
        counters = statistics();
    }

    const Frame* m_frame;
    Pixel m_clear;
    std::size_t m_position;
};

/// A whole run that is looked at after `position` events. For one sample a pixel and no overdraw.
Snapshot freshRun(const Scene& scene, const Settings& settings, std::size_t position)
{
    Frame frame;
    const Resolved resolved = resolve(settings, scene);
    Snapshot snapshot(resolved.rules, frame, clearedPixel(scene, resolved.rules), position);
    drawScene(scene, resolved, frame, {.ids = true}, snapshot, std::stop_token());
    return snapshot;
}

} // namespace

class TestStepRecord : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isTheLog();
    void stepsAsTheLog();
    void stopsWhereTheLogStops();
    void wholeScenes_data();
    void wholeScenes();
    void beginningIsTheBeginningOfTheWhole();
    void historyKeepsToItsMemory();
    void keepsManyMomentsOfPatterns();
    void stoppedRecordSaysSo();
};

/// Jumps at random through small pictures of all scenes, with all settings, mistakes and filters.
void TestStepRecord::isTheLog()
{
    const unsigned seed = test::seedOfRun();
    Draws draws(seed);
    const auto scenes = builtinScenes();
    int longRecords = 0;
    for (int i = 0; i < test::casesOfBuild(300); ++i) {
        const auto scene = builtin(scenes[std::size_t(i) % scenes.size()].name);
        if (scene->mesh.faceCount() > 3000)
            continue;
        const Settings settings = draws.settings(*scene);
        const StepFilter filter = draws.filter(*scene, settings.size);
        StepCursor log(renderSteps(*scene, settings, filter));
        const auto record = recordSteps(scene, settings, filter, {}, kLittle);
        const QByteArray what = QStringLiteral("%1 of seed %2, %3 ").arg(i).arg(seed).arg(scene->id).toUtf8() +
                                settings.mistakes.join(QLatin1Char(' ')).toUtf8();
        QVERIFY2(record->size() == log.size(), what.constData());
        QVERIFY(!record->truncated());
        longRecords += record->size() > 10 * kLittle.windowEvents ? 1 : 0;
        StepCursor cursor(record);
        for (int k = 0; k < 24; ++k) {
            // Far jumps, then single steps, so that windows are left on both sides.
            const std::size_t to = k % 3 == 0   ? draws.below(log.size() + 1)
                                   : k % 3 == 1 ? log.position() + 1
                                                : log.position() - std::min<std::size_t>(log.position(), 3);
            log.moveTo(to);
            cursor.moveTo(to);
            // Looking at all samples unpacks them, so that is left out now and then.
            const char* wrong = draws.upTo(2) > 0               ? difference(log, cursor)
                                : log.image() == cursor.image() ? nullptr
                                                                : "picture";
            QVERIFY2(wrong == nullptr, (what + " at " + QByteArray::number(qulonglong(to)) + ": " + wrong).constData());
        }
        log.moveTo(log.size());
        cursor.moveTo(log.size());
        QVERIFY2(difference(log, cursor) == nullptr, what.constData());
    }
    QVERIFY(longRecords > test::casesOfBuild(20));
}

void TestStepRecord::stepsAsTheLog()
{
    Draws draws(test::seedOfRun());
    for (const char* name : {"triangle", "square-diagonal", "piercing", "behind-camera", "tunnel"}) {
        const auto scene = builtin(name);
        for (int i = 0; i < 6; ++i) {
            const Settings settings = draws.settings(*scene);
            const StepFilter filter = draws.filter(*scene, settings.size);
            const auto log = renderSteps(*scene, settings, filter);
            const auto record = recordSteps(scene, settings, filter, {}, kLittle);
            StepFinder finder(record);
            for (int k = 0; k < 20; ++k)
                for (const StepLevel level :
                     {StepLevel::Event, StepLevel::Sample, StepLevel::Row, StepLevel::Face, StepLevel::Stage})
                    for (const StepDirection direction : {StepDirection::Forward, StepDirection::Backward}) {
                        const std::size_t from = draws.below(log->size() + 1);
                        QVERIFY2(finder.step(from, level, direction) == log->step(from, level, direction), name);
                    }
        }
    }
}

void TestStepRecord::stopsWhereTheLogStops()
{
    Draws draws(test::seedOfRun());
    for (const char* name : {"triangle", "square-diagonal", "piercing", "behind-camera", "sphere"}) {
        const auto scene = builtin(name);
        for (int i = 0; i < 6; ++i) {
            const Settings settings = draws.settings(*scene);
            StepFilter all;
            all.cap = 10'000'000;
            const auto log = renderSteps(*scene, settings, all);
            const auto record = recordSteps(scene, settings, all, {}, kLittle);
            StepFinder finder(record);
            for (int kind = 0; kind <= int(StepStop::Kind::NonFinite); ++kind)
                for (const StepDirection direction : {StepDirection::Forward, StepDirection::Backward}) {
                    const StepStop stop{StepStop::Kind(kind), draws.upTo(settings.size.width()),
                                        draws.upTo(settings.size.height())};
                    const std::size_t from = draws.below(log->size() + 1);
                    QVERIFY2(finder.findStop(from, direction, stop) == log->findStop(from, direction, stop), name);
                }
            const auto face = static_cast<std::uint32_t>(draws.below(scene->mesh.faceCount()));
            const int x = draws.upTo(settings.size.width());
            const int y = draws.upTo(settings.size.height());
            QVERIFY(finder.firstEventOf(face, x, y) == log->firstEventOf(face, x, y));
        }
    }
}

void TestStepRecord::wholeScenes_data()
{
    QTest::addColumn<QString>("name");
    const auto scenes = builtinScenes();
    for (std::size_t i = 0; i < scenes.size(); i += test::everyOfBuild())
        QTest::newRow(scenes[i].name) << QString::fromLatin1(scenes[i].name);
}

/// Every scene at its own size, to the end.
void TestStepRecord::wholeScenes()
{
    QFETCH(QString, name);
    const auto scene = builtin(qPrintable(name));
    const Settings settings = recordedAs(scene->defaults);
    QElapsedTimer time;
    time.start();
    const auto record = recordSteps(scene, settings);
    const qint64 readyMs = time.elapsed();
    QVERIFY(!record->truncated());
    Frame frame;
    const Statistics statistics = renderCounted(*scene, settings, frame, {.ids = true});
    StepCursor cursor(record);
    cursor.moveTo(record->size());
    QCOMPARE(cursor.lastEvent()->kind, StepKind::End);
    QVERIFY(cursor.image() == frame.image);
    QVERIFY(settings.samples != Samples::One || std::ranges::equal(cursor.sampleOwners(), frame.ids));
    QVERIFY(cursor.counters() == statistics);

    Draws draws(test::seedOfRun());
    const bool isPlain = settings.samples == Samples::One && settings.shading != Shading::Overdraw;
    std::size_t events = 0;
    for (int i = 0; i < 2; ++i) {
        const std::size_t position = 1 + draws.below(record->size() - 1);
        const Snapshot fresh = freshRun(*scene, settings, position);
        events = fresh.count;
        cursor.moveTo(position);
        QVERIFY(cursor.counters() == fresh.counters);
        QVERIFY(!isPlain || cursor.image() == fresh.image);
        QVERIFY(!isPlain || std::ranges::equal(cursor.sampleOwners(), fresh.owners));
    }
    QCOMPARE(record->size(), events + 1); // and End
    constexpr std::size_t kMostBytes = std::size_t(110) << 20;
    QVERIFY2(record->index().bytes() < kMostBytes, qPrintable(QString::number(record->index().bytes())));

    std::vector<double> jumps;
    for (int i = 0; i < 15; ++i) {
        time.start();
        cursor.moveTo(draws.below(record->size() + 1));
        jumps.push_back(double(time.nsecsElapsed()) / 1e6);
    }
    std::ranges::nth_element(jumps, jumps.begin() + 7);
    qInfo("%-20s %9zu events, ready in %lld ms, index %zu MB, jump %.1f ms", qPrintable(name), record->size(),
          static_cast<long long>(readyMs), record->index().bytes() >> 20, jumps[7]);
}

void TestStepRecord::beginningIsTheBeginningOfTheWhole()
{
    const unsigned seed = test::seedOfRun();
    Draws draws(seed);
    const auto scenes = builtinScenes();
    int cutOff = 0;
    for (int i = 0; i < test::casesOfBuild(100); ++i) {
        const auto scene = builtin(scenes[std::size_t(i) % scenes.size()].name);
        if (scene->mesh.faceCount() > 3000)
            continue;
        const Settings settings = draws.settings(*scene);
        StepFilter filter = draws.filter(*scene, settings.size);
        const auto whole = recordSteps(scene, settings, filter, {}, kLittle);
        // Every other one is cut off, if it has any length; of the rest some are.
        filter.cap = 1 + draws.below(i % 2 == 0 ? std::max<std::size_t>(1, whole->size() / 2) : 2 * whole->size());
        const auto beginning = recordBeginning(scene, settings, filter);
        const QByteArray what = QStringLiteral("%1 of seed %2, %3").arg(i).arg(seed).arg(scene->id).toUtf8();
        QVERIFY2(beginning->truncated() == (filter.cap < whole->size() - 1),
                 what.constData()); // End is stored beside it
        QVERIFY2(beginning->size() >= std::min(filter.cap, whole->size()), what.constData());
        QVERIFY2(beginning->size() <= whole->size(), what.constData());
        cutOff += beginning->truncated() ? 1 : 0;
        StepCursor a(beginning);
        StepCursor b(whole);
        for (int k = 0; k < 8; ++k) {
            const std::size_t to = k == 7 ? beginning->size() : draws.below(beginning->size() + 1);
            a.moveTo(to);
            b.moveTo(to);
            const char* wrong = difference(a, b);
            QVERIFY2(wrong == nullptr, (what + " at " + QByteArray::number(qulonglong(to)) + ": " + wrong).constData());
        }
    }
    QVERIFY(cutOff > test::casesOfBuild(10));
}

void TestStepRecord::historyKeepsToItsMemory()
{
    const auto scene = builtin("sphere");
    Settings settings = scene->defaults;
    settings.size = {640, 480};
    const auto many = recordSteps(scene, settings, {}, {}, {1000, std::size_t(400) << 20, 5000});
    const std::size_t most = many->index().history().bytes() / 2;
    const auto few = recordSteps(scene, settings, {}, {}, {1000, most, 5000});
    QVERIFY2(few->index().history().bytes() <= most, qPrintable(QString::number(few->index().history().bytes())));
    StepCursor a(few);
    StepCursor b(many);
    Draws draws(test::seedOfRun());
    for (int i = 0; i < 20; ++i) {
        const std::size_t to = draws.below(few->size() + 1);
        a.moveTo(to);
        b.moveTo(to);
        const char* wrong = difference(a, b);
        QVERIFY2(wrong == nullptr, wrong);
    }
}

/// Samples of a pixel are mostly alike, so there is room for a moment every few thousand samples, also where a picture
/// has many times as many samples as pixels.
void TestStepRecord::keepsManyMomentsOfPatterns()
{
    const auto scene = builtin("msaa-gradient"); // 8 samples a pixel
    Settings settings = scene->defaults;
    settings.size = {640, 360};
    const RecordMemory memory{1 << 13, std::size_t(16) << 20, 1 << 13};
    const auto record = recordSteps(scene, settings, {}, {}, memory);
    const std::size_t moments = record->index().pointBefore(record->size()) + 1;
    QVERIFY2(moments > 1000, qPrintable(QString::number(moments)));
    QVERIFY(record->index().history().bytes() <= memory.history);
}

void TestStepRecord::stoppedRecordSaysSo()
{
    std::stop_source stop;
    stop.request_stop();
    const auto scene = builtin("triangle");
    const auto record = recordSteps(scene, scene->defaults, {}, stop.get_token());
    QVERIFY(record->stopped());
    QCOMPARE(record->size(), std::size_t(0));
    QCOMPARE(StepCursor(record).position(), std::size_t(0));
}

QTEST_APPLESS_MAIN(TestStepRecord)
#include "test_step_record.moc"
