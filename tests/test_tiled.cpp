// The tiled algorithm against edge-equation: the same coverage, ids and depth bit for bit, colours to a step.
#include "tests/seed.h"
#include "tests/tiled_support.h"

#include <QTest>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <new>
#include <system_error>
#include <thread>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

std::atomic<int> allocations = 0;
std::atomic<int> allocationsLeft = std::numeric_limits<int>::max(); ///< then there is no memory

/// Counts an allocation; false: it fails.
bool mayAllocate()
{
    ++allocations;
    return allocationsLeft == std::numeric_limits<int>::max() || --allocationsLeft >= 0;
}

void* allocate(std::size_t size, std::size_t alignment)
{
    void* memory = nullptr;
    if (!mayAllocate() || posix_memalign(&memory, std::max(alignment, sizeof(void*)), size) != 0)
        return nullptr;
    return memory;
}

void* allocateOrThrow(std::size_t size, std::size_t alignment)
{
    if (void* memory = allocate(size, alignment))
        return memory;
    throw std::bad_alloc();
}

constexpr std::size_t kUsual = alignof(std::max_align_t);

} // namespace

void* operator new(std::size_t size) { return allocateOrThrow(size, kUsual); }
void* operator new(std::size_t size, std::align_val_t a) { return allocateOrThrow(size, std::size_t(a)); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return allocate(size, kUsual); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

#if !RASTERLENS_SANITIZED // those have theirs
void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept { return allocate(size, alignment); }
#endif

class TestTiled : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void drawsBuiltinScenesAlike_data();
    void drawsBuiltinScenesAlike();
    void drawsModesAlike_data();
    void drawsModesAlike();
    void drawsSoupsAlike_data();
    void drawsSoupsAlike();
    void drawsAtTheLimitsOf14And16Bits();
    void drawsAtTheLimitOf32Bits();
    void drawsHugeTrianglesOnSmallTargets();
    void keepsTheOrderOfEqualDepths();
    void hidesLayers();
    void showsNeedlesBehindPlanes();
    void allocatesNothingOnceWarm();
    void outlivesLackOfMemory();
    void keepsNothingInCommonWithACopy();
    void clearsWhatIsNotItsOwn();
    void clearsDepthsThatAreNotItsOwn();
    void refusesWhatItCannotDraw();
};

void TestTiled::drawsBuiltinScenesAlike_data()
{
    QTest::addColumn<QString>("name");
    for (const auto& scene : builtinScenes())
        QTest::addRow("%s", scene.name) << QString::fromLatin1(scene.name);
}

void TestTiled::drawsBuiltinScenesAlike()
{
    QFETCH(QString, name);
    const SceneLoad load = makeBuiltinScene(name);
    QVERIFY(load.scene);
    for (const Samples samples : {Samples::One, Samples::Grid2, Samples::Grid3, Samples::Grid4}) {
        Settings settings = load.scene->defaults;
        settings.mistakes.clear();
        settings.visibility = Visibility::ZBuffer;
        settings.numberType = NumberType::Fixed;
        settings.tieRule = TieRule::TopLeft;
        settings.fill = Fill::Solid;
        settings.attributePath = AttributePath::Planes;
        settings.samples = samples;
        settings.size = {140, 100};
        settings.algorithm = Algorithm::Tiled;
        if (const auto reason = unsupported(*load.scene, settings))
            QSKIP(qPrintable(textOf(*reason))); // lines
        const QString d =
            compareAll(*load.scene, settings, samples == Samples::One ? simds() : std::vector{Simd::Auto});
        QVERIFY2(d.isEmpty(), qPrintable(d));
    }
}

void TestTiled::drawsModesAlike_data()
{
    QTest::addColumn<QString>("field");
    QTest::addColumn<QString>("value");
    for (const char* field :
         {"shading", "depth-format", "depth-test", "culling", "winding", "cull-space", "clipping", "clip-z",
          "reversed-z", "visibility", "interpolation", "texture-filter", "subpixel-bits", "depth-order", "samples"}) {
        const SettingsField& f = *findSettingsField(field);
        for (int value = f.minimum; value <= f.maximum; ++value) {
            Settings settings;
            f.set(settings, value);
            settings.algorithm = Algorithm::Tiled;
            if (!unsupported(Scene(), settings))
                QTest::addRow("%s %s", field, qPrintable(valueId(f, settings))) << field << valueId(f, settings);
        }
    }
}

void TestTiled::drawsModesAlike()
{
    QFETCH(QString, field);
    QFETCH(QString, value);
    std::mt19937 random(1);
    const std::vector<Simd> all = simds();
    const SceneLoad mesh = makeBuiltinScene("head");
    QVERIFY(mesh.scene);
    for (const bool lit : {false, true}) {
        if (lit && RASTERLENS_SANITIZED)
            continue; // the built-in scenes are drawn as well
        const Scene scene = lit ? *mesh.scene : soup(random, {100, 70}, 60);
        Settings settings;
        settings.size = {100, 70};
        if (!lit)
            settings.culling = Culling::None;
        QVERIFY(!setFromText(*findSettingsField(field), value, settings));
        if (field == "texture-filter")
            settings.shading = Shading::Texture;
        if (unsupported(scene, settings))
            continue;
        const QString d = compareAll(scene, settings, all);
        QVERIFY2(d.isEmpty(), qPrintable(d));
    }
}

void TestTiled::drawsSoupsAlike_data()
{
    QTest::addColumn<QSize>("size");
    for (const QSize size : {QSize(1, 1), QSize(63, 65), QSize(64, 64), QSize(257, 3), QSize(320, 200), QSize(1, 16384),
                             QSize(16384, 1), QSize(130, 130)})
        QTest::addRow("%dx%d", size.width(), size.height()) << size;
}

void TestTiled::drawsSoupsAlike()
{
    QFETCH(QSize, size);
    const unsigned seed = test::seedOfRun();
    std::mt19937 random(seed);
    const std::vector<Simd> all = simds();
    for (int round = 0; round < casesOfBuild(10); ++round) {
        const Scene scene = soup(random, size, 150);
        Settings settings;
        settings.size = size;
        settings.culling = static_cast<Culling>(random() % 3);
        settings.depthTest = std::array{DepthTest::Less, DepthTest::LessEqual, DepthTest::Greater}[random() % 3];
        settings.clipping = static_cast<Clipping>(random() % 7);
        settings.samples = round % 2 == 0 ? Samples::One : static_cast<Samples>(random() % 4);
        const QString d = compareAll(scene, settings, {all[random() % all.size()]});
        QVERIFY2(d.isEmpty(), qPrintable(d));
    }
}

void TestTiled::drawsAtTheLimitsOf14And16Bits()
{
    // Edges of triangles below 64 pixels are made in 32 bits, those below 128 pixels are spread from pairs of 16 bits.
    // Whole vectors of triangles lie on the limits, one unit below them and one above.
    std::mt19937 random(11);
    std::uniform_real_distribution<double> place(-20, 180);
    std::uniform_real_distribution<double> unit(0, 1);
    const QSize size(300, 300);
    constexpr double kUnitInPixels = 1.0 / 256;
    for (const double limit : {64.0, 128.0})
        for (const double reach : {limit - kUnitInPixels, limit, limit + kUnitInPixels}) {
            Scene scene = clipScene(size);
            for (int i = 0; i < 32; ++i) {
                const double x = std::floor(place(random) / kUnitInPixels) * kUnitInPixels;
                const double y = std::floor(place(random) / kUnitInPixels) * kUnitInPixels;
                const auto corner = [&](double toX, double toY) {
                    return fromScreen(x + toX * reach, y + toY * reach, 0.1 + 0.8 * unit(random), 1, size);
                };
                if (i % 2 == 0)
                    addTriangle(scene, {corner(0, 0), corner(1, unit(random)), corner(unit(random), 1)}, random);
                else
                    addTriangle(scene, {corner(0, 1), corner(1, 0), corner(1, 1)}, random);
            }
            Settings settings;
            settings.size = size;
            settings.culling = Culling::None;
            const QString d = compareAll(scene, settings, simds());
            QVERIFY2(d.isEmpty(), qPrintable(d));
        }
}

void TestTiled::drawsAtTheLimitOf32Bits()
{
    // Gradients of exactly 2^22 units, 16384 samples from corner to corner, are the largest that 32 bits are proven
    // for; the guard band lets longer edges through, which must take the other way.
    std::mt19937 random(7);
    for (const bool wide : {true, false})
        for (const double reach : {16384.0, 16383.99609375, 16000.5, 20000.0}) {
            const QSize size = wide ? QSize(16384, 20) : QSize(20, 16384);
            Scene scene = clipScene(size);
            const auto corner = [&](double along, double across, double depth) {
                return wide ? fromScreen(along, across, depth, 1, size) : fromScreen(across, along, depth, 1, size);
            };
            addTriangle(scene, {corner(0, 0, 0.1), corner(reach, 20, 0.9), corner(0, 20, 0.5)}, random);
            addTriangle(scene, {corner(0, 0.3, 0.9), corner(reach, 0, 0.2), corner(reach, 19.7, 0.2)}, random);
            addTriangle(scene, {corner(0, 9, 0.3), corner(reach, 10.1, 0.4), corner(reach, 10.2, 0.5)}, random);
            Settings settings;
            settings.size = size;
            settings.culling = Culling::None;
            settings.clipping = reach > 16384 ? Clipping::GuardBand : Clipping::Frustum;
            const QString d = compareAll(scene, settings, simds());
            QVERIFY2(d.isEmpty(), qPrintable(d));
        }
}

/// Edges that lie billions of units off a target of one tile or a few, or climb that much from sample to sample.
void TestTiled::drawsHugeTrianglesOnSmallTargets()
{
    std::mt19937 random(19);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (const Samples samples : {Samples::One, Samples::Grid3, Samples::Grid4})
        for (const int side : {1, 4, 9, 40, 200}) {
            if (side > 40 && samples != Samples::One)
                continue;
            const QSize size(side, side);
            Scene scene = clipScene(size);
            for (int i = 0; i < (side > 40 ? 60 : 300); ++i) {
                const auto corner = [&] {
                    const double reach = std::pow(10, 3 + 4 * unit(random)); // pixels
                    return fromScreen(reach * unit(random), reach * unit(random), 0.5 + 0.4 * unit(random), 1, size);
                };
                addTriangle(scene, {corner(), corner(), corner()}, random);
            }
            Settings settings;
            settings.size = size;
            settings.samples = samples;
            settings.culling = Culling::None;
            for (const Clipping clipping : {Clipping::GuardBand, Clipping::None}) {
                settings.clipping = clipping;
                const QString d = compareAll(scene, settings, simds(), {1});
                QVERIFY2(d.isEmpty(), qPrintable(d));
            }
        }
}

void TestTiled::keepsTheOrderOfEqualDepths()
{
    std::mt19937 random(3);
    const QSize size(100, 100);
    Scene scene = clipScene(size);
    for (int i = 0; i < 100; ++i)
        addTriangle(scene,
                    {fromScreen(0, 0, 0.5, 1, size), fromScreen(0, 99, 0.5, 1, size), fromScreen(99, 0, 0.5, 1, size)},
                    random);
    Settings settings;
    settings.size = size;
    settings.algorithm = Algorithm::Tiled;
    Frame frame;
    render(scene, settings, frame, kAll);
    QCOMPARE(frame.ids[0], 0);
    settings.depthTest = DepthTest::LessEqual;
    render(scene, settings, frame, kAll);
    QCOMPARE(frame.ids[0], 99);
}

/// Layers that cover whole tiles, level and slanting, some at equal depth, among small triangles; also where the last
/// tiles are cut off by the target.
void TestTiled::hidesLayers()
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(0, 1);
    const QSize size(150, 140);
    Settings settings;
    settings.size = size;
    for (int round = 0; round < casesOfBuild(20); ++round) {
        Scene scene = clipScene(size);
        for (int i = 0; i < 40; ++i) {
            const double slope = i % 4 == 0 ? 0 : 0.2 * (unit(random) - 0.5);
            const double depth = i % 5 == 0 ? 0.5 : round % 3 == 0 ? 0.9 - 0.02 * i : unit(random);
            const double side = i % 3 == 2 ? 5 : 1000;
            const glm::dvec2 corner(side < 10 ? 140 * unit(random) : -100, side < 10 ? 130 * unit(random) : -100);
            addTriangle(scene,
                        {fromScreen(corner.x, corner.y, depth, 1, size),
                         fromScreen(corner.x, corner.y + side, depth + slope, 1, size),
                         fromScreen(corner.x + side, corner.y, depth - slope, 1, size)},
                        random);
        }
        settings.samples = round % 4 == 3 ? Samples::Grid4 : Samples::One;
        const QString d = compareAll(scene, settings, simds(), {1, 2});
        QVERIFY2(d.isEmpty(), qPrintable(d));
    }
}

/// A needle has no plane of depth: its weights, and so its depths, may come out far beyond its corners.
void TestTiled::showsNeedlesBehindPlanes()
{
    Scene scene = clipScene({60, 60});
    std::mt19937 random(1);
    addTriangle(scene, {glm::vec4(-1, 1, -0.2, 1), {3, 1, -0.2, 1}, {-1, -3, -0.2, 1}}, random);
    addTriangle(scene, {glm::vec4(-1, 0.916666667, 0, 1), {1, 0.916666667, 0, 1}, {0, -1e-20, 0.9, 1e-20}}, random);
    Settings settings;
    settings.size = {60, 60};
    settings.culling = Culling::None;
    for (const Clipping clipping : {Clipping::None, Clipping::AnyVertexInside}) {
        settings.clipping = clipping;
        const QString d = compareAll(scene, settings, simds());
        QVERIFY2(d.isEmpty(), qPrintable(d));
    }
}

void TestTiled::allocatesNothingOnceWarm()
{
    // Clipped faces too, but none so long that only rational arithmetic can cut it.
    const SceneLoad load = makeBuiltinScene("head");
    QVERIFY(load.scene);
    const Scene& scene = *load.scene;
    const auto allocationsOf = [&](Shading shading, int threads, Outputs outputs) {
        Settings settings;
        settings.size = {640, 360};
        settings.algorithm = Algorithm::Tiled;
        settings.shading = shading;
        settings.threads = threads;
        settings.view.distance = 0.4;
        Frame frame;
        for (int i = 0; i < 3; ++i) // the workers share what they know of the fullest tile a frame later
            render(scene, settings, frame, outputs);
        const int before = allocations;
        render(scene, settings, frame, outputs);
        return allocations - before;
    };
    for (const Shading shading : {Shading::Gouraud, Shading::Texture, Shading::Phong, Shading::Flat})
        for (const Outputs outputs : {Outputs{}, kAll}) {
            QCOMPARE(allocationsOf(shading, 1, outputs), 0);
            QCOMPARE(allocationsOf(shading, 3, outputs), 0);
        }
}

void TestTiled::outlivesLackOfMemory()
{
    const SceneLoad load = makeBuiltinScene("head");
    QVERIFY(load.scene);
    Settings settings;
    settings.size = {200, 120};
    settings.algorithm = Algorithm::Tiled;
    settings.view.distance = 0.4; // clipped faces too
    for (const Shading shading : {Shading::Gouraud, Shading::Texture, Shading::Phong})
        for (const int threads : {1, 3}) {
            settings.shading = shading;
            settings.threads = threads;
            Frame expected;
            render(*load.scene, settings, expected, kAll);
            bool failed = true;
            for (int left = 0; failed; left += 1 + left / 8) {
                Frame frame;
                failed = false;
                allocationsLeft = left;
                try {
                    render(*load.scene, settings, frame, kAll);
                } catch (const std::bad_alloc&) {
                    failed = true;
                } catch (const std::system_error&) { // a thread that does not start
                    failed = true;
                }
                allocationsLeft = std::numeric_limits<int>::max();
                render(*load.scene, settings, frame, kAll);
                QCOMPARE(difference(expected, frame), QString());
                QVERIFY(frame.image == expected.image);
            }
        }
}

void TestTiled::keepsNothingInCommonWithACopy()
{
    std::mt19937 random(12);
    const Scene scene = soup(random, {300, 200}, 300);
    Settings settings;
    settings.size = {300, 200};
    settings.algorithm = Algorithm::Tiled;
    settings.threads = 2;
    Frame first;
    render(scene, settings, first, kAll);
    const Frame expected = first;
    Frame second = first;
    std::jthread other([&] {
        for (int i = 0; i < 20; ++i)
            render(scene, settings, second, kAll);
    });
    for (int i = 0; i < 20; ++i)
        render(scene, settings, first, kAll);
    other.join();
    QVERIFY(difference(expected, first).isEmpty());
    QVERIFY(difference(expected, second).isEmpty());
}

/// A triangle near one corner of the picture or near the opposite one, drawn again and again into one frame.
class CornerPictures
{
public:
    static constexpr QSize kSize{640, 400};

    CornerPictures()
    {
        settings.size = kSize;
        settings.algorithm = Algorithm::Tiled;
        left = corner(10, 10);
        right = corner(500, 300);
    }

    /// Draws into the frame, and says whether that is what a fresh frame would hold.
    bool matchesFresh(const Scene& scene)
    {
        Frame fresh;
        render(scene, settings, fresh, outputs);
        render(scene, settings, frame, outputs);
        return fresh.image == frame.image && sameBits(fresh.depth, frame.depth);
    }

    Scene left;
    Scene right;
    Settings settings;
    Frame frame;
    Outputs outputs;

private:
    Scene corner(int x, int y)
    {
        Scene scene = clipScene(kSize);
        addTriangle(scene,
                    {fromScreen(x, y, 0.5, 1, kSize), fromScreen(x, y + 50, 0.5, 1, kSize),
                     fromScreen(x + 50, y, 0.5, 1, kSize)},
                    m_random);
        return scene;
    }

    std::mt19937 m_random{21};
};

/// Tiles known to be empty are not cleared again: whatever else happens to the picture must be noticed.
void TestTiled::clearsWhatIsNotItsOwn()
{
    CornerPictures p;
    QVERIFY(p.matchesFresh(p.left));
    QVERIFY(p.matchesFresh(p.left));
    QVERIFY(p.matchesFresh(p.right)); // what was drawn is empty now
    p.frame.image.fill(Qt::red);
    QVERIFY(p.matchesFresh(p.right));
    p.left.background = {0, 0, 1};
    QVERIFY(p.matchesFresh(p.left));
    const QImage kept = p.frame.image;
    QVERIFY(p.matchesFresh(p.right));
    QVERIFY(p.matchesFresh(p.left));
    QVERIFY(kept == p.frame.image);
    p.settings.shading = Shading::Overdraw;
    QVERIFY(p.matchesFresh(p.left));
    p.settings.shading = Shading::Gouraud;
    p.settings.algorithm = Algorithm::EdgeEquation;
    render(p.right, p.settings, p.frame);
    p.settings.algorithm = Algorithm::Tiled;
    QVERIFY(p.matchesFresh(p.left));
    p.settings.samples = Samples::Grid2;
    QVERIFY(p.matchesFresh(p.left));
}

/// Depths of tiles known to be empty are not cleared again either, with a picture or without.
void TestTiled::clearsDepthsThatAreNotItsOwn()
{
    CornerPictures p;
    p.left.background = {0, 0, 1};
    for (const bool picture : {false, true}) {
        p.outputs = {.depth = true, .picture = picture};
        QVERIFY(p.matchesFresh(p.left));
        QVERIFY(p.matchesFresh(p.left));
        QVERIFY(p.matchesFresh(p.right));
        std::fill_n(p.frame.depth.write(p.frame.depth.size()), p.frame.depth.size(), 0.25F);
        QVERIFY(p.matchesFresh(p.right));
        const Frame copy = p.frame;
        QVERIFY(p.matchesFresh(p.left));
        p.frame.depth = copy.depth;
        QVERIFY(p.matchesFresh(p.left));
        p.settings.size = CornerPictures::kSize.transposed(); // as many pixels
        QVERIFY(p.matchesFresh(p.left));
        p.settings.size = CornerPictures::kSize;
        p.settings.reversedZ = !p.settings.reversedZ; // clears to 0
        QVERIFY(p.matchesFresh(p.left));
        p.outputs.depth = false;
        p.outputs.picture = true;
        QVERIFY(p.matchesFresh(p.right));
        p.outputs = {.depth = true, .picture = picture};
        QVERIFY(p.matchesFresh(p.left));
    }
}

void TestTiled::refusesWhatItCannotDraw()
{
    const auto refused = [](auto&& change) {
        Settings settings;
        settings.algorithm = Algorithm::Tiled;
        change(settings);
        return unsupported(Scene(), settings).has_value();
    };
    QVERIFY(!refused([](Settings&) {}));
    QVERIFY(refused([](Settings& s) { s.numberType = NumberType::Float32; }));
    QVERIFY(refused([](Settings& s) { s.fill = Fill::Wireframe; }));
    QVERIFY(refused([](Settings& s) { s.visibility = Visibility::Painter; }));
    QVERIFY(refused([](Settings& s) { s.tieRule = TieRule::Inclusive; }));
    QVERIFY(refused([](Settings& s) { s.attributePath = AttributePath::EdgeThenSpan; }));
    QVERIFY(refused([](Settings& s) { s.mistakes = {"anything"}; }));
    QVERIFY(refused([](Settings& s) {
#ifdef __x86_64__
        s.simd = Simd::Neon;
#else
        s.simd = Simd::Avx512;
#endif
    }));
}

QTEST_APPLESS_MAIN(TestTiled)
#include "test_tiled.moc"
