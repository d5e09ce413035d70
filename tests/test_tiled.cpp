// The tiled algorithm against edge-equation: the same coverage, ids and depth bit for bit, colours to a step.
#include "core/builtin_scenes.h"
#include "core/render.h"

#include <QTest>

#include <atomic>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <new>
#include <random>
#include <thread>

using namespace rasterlens;

namespace
{

std::atomic<int> allocations = 0;

} // namespace

void* operator new(std::size_t size)
{
    ++allocations;
    if (void* memory = std::malloc(size))
        return memory;
    throw std::bad_alloc();
}

void* operator new(std::size_t size, const std::nothrow_t&) noexcept
{
    ++allocations;
    return std::malloc(size);
}

void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace
{

constexpr Outputs kAll{.depth = true, .ids = true, .coverage = true};

/// Instruction sets of this machine.
std::vector<Simd> simds()
{
    std::vector<Simd> found;
    for (const Simd simd : {Simd::Scalar, Simd::Sse4, Simd::Avx2, Simd::Avx512, Simd::Neon}) {
        Settings settings;
        settings.algorithm = Algorithm::Tiled;
        settings.simd = simd;
        if (!unsupported(Scene(), settings))
            found.push_back(simd);
    }
    return found;
}

int largestColorStep(const QImage& a, const QImage& b)
{
    int step = 0;
    for (int y = 0; y < a.height(); ++y) {
        const auto* rowA = reinterpret_cast<const QRgb*>(a.constScanLine(y));
        const auto* rowB = reinterpret_cast<const QRgb*>(b.constScanLine(y));
        for (int x = 0; x < a.width(); ++x)
            if (rowA[x] != rowB[x])
                step =
                    std::max({step, std::abs(qRed(rowA[x]) - qRed(rowB[x])),
                              std::abs(qGreen(rowA[x]) - qGreen(rowB[x])), std::abs(qBlue(rowA[x]) - qBlue(rowB[x]))});
    }
    return step;
}

bool sameBits(const std::vector<float>& a, const std::vector<float>& b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](float p, float q) {
        return std::bit_cast<std::uint32_t>(p) == std::bit_cast<std::uint32_t>(q);
    });
}

template <class T>
QString firstDifference(const std::vector<T>& a, const std::vector<T>& b, int width)
{
    for (std::size_t i = 0; i < a.size(); ++i)
        if (a[i] != b[i])
            return QStringLiteral("at (%1, %2): %3, expected %4")
                .arg(i % std::size_t(width))
                .arg(i / std::size_t(width))
                .arg(double(b[i]), 0, 'g', 9)
                .arg(double(a[i]), 0, 'g', 9);
    return QStringLiteral("none");
}

/// What of two pictures differs, or nothing.
QString difference(const Frame& expected, const Frame& actual)
{
    const int width = expected.image.width();
    if (expected.coverage != actual.coverage)
        return "coverage " + firstDifference(expected.coverage, actual.coverage, width);
    if (!sameBits(expected.depth, actual.depth))
        return "depth " + firstDifference(expected.depth, actual.depth, width);
    if (expected.ids != actual.ids)
        return "ids " + firstDifference(expected.ids, actual.ids, width);
    const int step = largestColorStep(expected.image, actual.image);
    return step > 1 ? QStringLiteral("colours by %1").arg(step) : QString();
}

/// Compares with edge-equation: every instruction set, several threads, with and without the other outputs (which
/// take different ways through the kernel).
QString compareAll(const Scene& scene, Settings settings, const std::vector<Simd>& among,
                   std::initializer_list<int> threadCounts = {1, 2, 5})
{
    settings.algorithm = Algorithm::EdgeEquation;
    Frame expected;
    const Statistics expectedCounts = renderCounted(scene, settings, expected, kAll);
    settings.algorithm = Algorithm::Tiled;
    std::optional<QImage> first;
    for (const Simd simd : among)
        for (const int threads : threadCounts) {
            settings.simd = simd;
            settings.threads = threads;
            const auto tell = [&](const QString& what) {
                return QStringLiteral("simd %1, %2 threads: %3")
                    .arg(valueId(*findSettingsField("simd"), settings))
                    .arg(threads)
                    .arg(what);
            };
            Frame all;
            const Statistics counts = renderCounted(scene, settings, all, kAll);
            if (const QString d = difference(expected, all); !d.isEmpty())
                return tell(d);
            if (!(counts.faces == expectedCounts.faces))
                return tell("counts of faces");
            if (counts.pixels.covered != expectedCounts.pixels.covered ||
                counts.pixels.depthPassed != expectedCounts.pixels.depthPassed ||
                counts.pixels.depthFailed != expectedCounts.pixels.depthFailed || counts.pixels.coveredTwice != 0)
                return tell("counts of samples");
            if (first && *first != all.image)
                return tell("colours differ from those of another instruction set");
            first = all.image;
            Frame usual;
            render(scene, settings, usual, {.depth = true, .ids = true});
            usual.coverage = all.coverage;
            if (const QString d = difference(expected, usual); !d.isEmpty())
                return tell("uncounted: " + d);
            if (usual.image != all.image)
                return tell("counting changes colours");
            Frame depth;
            render(scene, settings, depth, {.depth = true, .picture = false});
            if (!depth.image.isNull() || !sameBits(expected.depth, depth.depth))
                return tell("depth alone");
        }
    return {};
}

Scene clipScene(QSize size)
{
    Scene scene;
    scene.space = SceneSpace::Clip;
    scene.lit = false;
    scene.materials = {Material{}};
    scene.defaults.size = size;
    return scene;
}

void addTriangle(Scene& scene, const std::array<glm::vec4, 3>& positions, std::mt19937& random)
{
    std::uniform_real_distribution<float> unit(0, 1);
    for (const glm::vec4& position : positions) {
        scene.mesh.indices.push_back(static_cast<std::uint32_t>(scene.mesh.vertices.size()));
        scene.mesh.vertices.push_back({.position = position,
                                       .uv = {unit(random), unit(random)},
                                       .color = {unit(random), unit(random), unit(random)}});
    }
}

glm::vec4 fromScreen(double x, double y, double depth, double w, QSize size)
{
    return {float((x / size.width() * 2 - 1) * w), float((1 - y / size.height() * 2) * w), float((2 * depth - 1) * w),
            float(w)};
}

/// Triangles of every kind that is hard: small, slivers, huge, clipped, on sample centres, at equal depth.
Scene soup(std::mt19937& random, QSize size, int count)
{
    Scene scene = clipScene(size);
    std::uniform_real_distribution<double> unit(0, 1);
    const auto range = [&](double low, double high) { return low + (high - low) * unit(random); };
    for (int i = 0; i < count; ++i) {
        const int kind = int(range(0, 7));
        const double scale = kind == 0 ? 3 : kind == 1 ? 30 : kind == 2 ? 3000 : 0.6 * size.width();
        const glm::dvec2 centre(range(-0.1, 1.1) * size.width(), range(-0.1, 1.1) * size.height());
        const double depth = kind == 3 ? 0.5 : range(-0.05, 1.05);
        const double angle = range(0, 6.28);
        std::array<glm::vec4, 3> p;
        for (glm::vec4& v : p) {
            glm::dvec2 at = centre + scale * glm::dvec2(range(-1, 1), range(-1, 1));
            if (kind == 4) { // a sliver
                const double along = range(-1, 1) * size.width();
                const double across = range(-0.01, 0.01);
                at = centre + glm::dvec2(along * std::cos(angle) - across * std::sin(angle),
                                         along * std::sin(angle) + across * std::cos(angle));
            }
            if (kind == 5)
                at = glm::floor(at) + 0.5;
            const double w = kind == 6 ? range(-0.5, 2) : kind == 1 ? range(0.5, 4) : 1;
            v = fromScreen(at.x, at.y, kind == 3 ? depth : depth + range(-0.1, 0.1), w, size);
        }
        addTriangle(scene, p, random);
    }
    return scene;
}

Texture noise(std::mt19937& random, int width, int height)
{
    Texture texture{QStringLiteral("noise"), width, height, {}, {}};
    for (int i = 0; i < width * height; ++i)
        texture.texels.push_back(0xff000000U | static_cast<std::uint32_t>(random() & 0xffffffU));
    return texture;
}

/// Gives every face one of several materials: with textures of all kinds of sizes, without, dull and shiny; and the
/// vertices normals and coordinates that repeat.
void dress(Scene& scene, std::mt19937& random)
{
    scene.textures = {noise(random, 16, 8), noise(random, 7, 5), noise(random, 1, 3), noise(random, 64, 64)};
    scene.materials.clear();
    for (int i = 0; i < 6; ++i) {
        Material material;
        material.texture = i < 4 ? i : -1;
        material.shininess = std::array{1.0F, 32.0F, 1000.0F, 0.5F, 7.25F, 0.0F}[std::size_t(i)];
        scene.materials.push_back(material);
    }
    std::uniform_real_distribution<float> unit(-1, 1);
    for (MeshVertex& v : scene.mesh.vertices) {
        v.normal = {unit(random), unit(random), unit(random)}; // not of length 1
        v.uv = 4.0F * glm::vec2(unit(random), unit(random));
    }
    for (std::size_t face = 0; face < scene.mesh.faceCount(); ++face)
        scene.mesh.faceMaterial.push_back(static_cast<std::uint32_t>(random() % scene.materials.size()));
}

} // namespace

class TestTiled : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void drawsBuiltinScenesAlike_data();
    void drawsBuiltinScenesAlike();
    void drawsModesAlike_data();
    void drawsModesAlike();
    void drawsShadingsAlike_data();
    void drawsShadingsAlike();
    void findsTexelsOnTheirBorders();
    void drawsAttributesThatAreNoNumbers();
    void drawsSoupsAlike_data();
    void drawsSoupsAlike();
    void drawsAtTheLimitOf32Bits();
    void keepsTheOrderOfEqualDepths();
    void allocatesNothingOnceWarm();
    void keepsNothingInCommonWithACopy();
    void clearsWhatIsNotItsOwn();
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
        settings.size = {200, 150};
        const QString d = compareAll(*load.scene, settings, {Simd::Auto});
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
    const SceneLoad head = makeBuiltinScene("head");
    QVERIFY(head.scene);
    for (const bool lit : {false, true}) {
        const Scene scene = lit ? *head.scene : soup(random, {150, 100}, 80);
        Settings settings;
        settings.size = {150, 100};
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

void TestTiled::drawsShadingsAlike_data()
{
    QTest::addColumn<Settings>("settings");
    const SettingsField& shading = *findSettingsField("shading");
    const SettingsField& filter = *findSettingsField("texture-filter");
    const SettingsField& samples = *findSettingsField("samples");
    Settings settings;
    for (int i = shading.minimum; i <= shading.maximum; ++i)
        for (int j = filter.minimum; j <= filter.maximum; ++j)
            for (int k = samples.minimum; k <= samples.maximum; ++k) {
                shading.set(settings, i);
                filter.set(settings, j);
                samples.set(settings, k);
                const bool textured = settings.shading == Shading::Texture || settings.shading == Shading::Phong;
                if (j == filter.minimum || textured)
                    QTest::addRow("%s %s %s", qPrintable(valueId(shading, settings)),
                                  qPrintable(valueId(filter, settings)), qPrintable(valueId(samples, settings)))
                        << settings;
            }
}

void TestTiled::drawsShadingsAlike()
{
    QFETCH(Settings, settings);
    const std::vector<Simd> all = simds();
    std::mt19937 random(5);
    const SceneLoad head = makeBuiltinScene("head");
    QVERIFY(head.scene);
    for (const bool lit : {false, true})
        for (const Interpolation interpolation : {Interpolation::Perspective, Interpolation::Affine}) {
            settings.size = lit ? QSize(90, 70) : QSize(75, 50);
            settings.culling = lit ? Culling::Back : Culling::None;
            settings.view.distance = 0.7; // some of it is cut
            settings.interpolation = interpolation;
            Scene scene = lit ? *head.scene : soup(random, settings.size, 60);
            dress(scene, random);
            const QString d = compareAll(scene, settings, all, {2});
            QVERIFY2(d.isEmpty(), qPrintable(d));
        }
}

/// Two texels a pixel: every centre lies on the border of two texels, and the wrong one would be seen.
void TestTiled::findsTexelsOnTheirBorders()
{
    std::mt19937 random(9);
    const QSize size(96, 64);
    for (const int side : {64, 48, 7}) {
        Scene scene = clipScene(size);
        scene.textures = {noise(random, side, side)};
        scene.materials[0].texture = 0;
        addTriangle(scene,
                    {fromScreen(0, 0, 0.5, 1, size), fromScreen(0, 64, 0.5, 1, size), fromScreen(96, 64, 0.5, 1, size)},
                    random);
        addTriangle(scene,
                    {fromScreen(0, 0, 0.5, 1, size), fromScreen(96, 64, 0.5, 1, size), fromScreen(96, 0, 0.5, 1, size)},
                    random);
        for (MeshVertex& v : scene.mesh.vertices) {
            v.uv = glm::vec2(v.position.x + 1, v.position.y + 1) * glm::vec2(96, 64) / float(side);
            v.color = {1, 1, 1};
        }
        for (const Shading shading : {Shading::Texture, Shading::Uv}) {
            Settings settings;
            settings.size = size;
            settings.shading = shading;
            const QString d = compareAll(scene, settings, simds(), {1});
            QVERIFY2(d.isEmpty(), qPrintable(d));
        }
    }
}

void TestTiled::drawsAttributesThatAreNoNumbers()
{
    constexpr float kInf = std::numeric_limits<float>::infinity();
    std::mt19937 random(10);
    const QSize size(80, 60);
    Scene scene = soup(random, size, 60);
    dress(scene, random);
    const std::array odd{0.0F, kInf, -kInf, std::numeric_limits<float>::quiet_NaN(), 1e30F, -1e9F, 1e-42F};
    const auto some = [&] { return odd[random() % odd.size()]; };
    for (MeshVertex& v : scene.mesh.vertices) {
        if (random() % 3 == 0)
            v.uv = {some(), some()};
        if (random() % 3 == 0)
            v.normal = {some(), some(), some()};
    }
    for (const Shading shading : {Shading::Texture, Shading::Phong, Shading::Normals, Shading::Uv}) {
        Settings settings;
        settings.size = size;
        settings.culling = Culling::None;
        settings.shading = shading;
        const QString d = compareAll(scene, settings, simds(), {1});
        QVERIFY2(d.isEmpty(), qPrintable(d));
    }
}

void TestTiled::drawsSoupsAlike_data()
{
    QTest::addColumn<QSize>("size");
    for (const QSize size : {QSize(1, 1), QSize(63, 65), QSize(64, 64), QSize(257, 3), QSize(640, 360), QSize(1, 16384),
                             QSize(16384, 1), QSize(130, 130)})
        QTest::addRow("%dx%d", size.width(), size.height()) << size;
}

void TestTiled::drawsSoupsAlike()
{
    QFETCH(QSize, size);
    const QByteArray wanted = qgetenv("SEED"); // to repeat a run
    const unsigned seed = wanted.isEmpty() ? std::random_device()() : wanted.toUInt();
    qInfo("seed %u", seed);
    std::mt19937 random(seed);
    const std::vector<Simd> all = simds();
    for (int round = 0; round < 6; ++round) {
        const Scene scene = soup(random, size, 150);
        Settings settings;
        settings.size = size;
        settings.culling = static_cast<Culling>(random() % 3);
        settings.depthTest = static_cast<DepthTest>(random() % 3);
        settings.clipping = static_cast<Clipping>(random() % 3);
        settings.samples = round % 2 == 0 ? Samples::One : static_cast<Samples>(random() % 4);
        const QString d = compareAll(scene, settings, {all[random() % all.size()]});
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

void TestTiled::allocatesNothingOnceWarm()
{
    // Clipped faces too, but none so long that only rational arithmetic can cut it.
    const SceneLoad load = makeBuiltinScene("head");
    QVERIFY(load.scene);
    const Scene& scene = *load.scene;
    for (const int threads : {1, 3}) {
        Settings settings;
        settings.size = {640, 360};
        settings.algorithm = Algorithm::Tiled;
        settings.threads = threads;
        settings.view.distance = 0.4;
        Frame frame;
        for (int i = 0; i < 30; ++i) // each worker has met each tile's worth of triangles by then
            render(scene, settings, frame, kAll);
        const int before = allocations;
        render(scene, settings, frame, kAll);
        const int made = allocations - before;
        if (threads == 1)
            QCOMPARE(made, 0);
        else // a worker may meet the fullest tile for the first time
            QVERIFY2(made <= 4, qPrintable(QString::number(made)));
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

/// Tiles known to be empty are not cleared again: whatever else happens to the picture must be noticed.
void TestTiled::clearsWhatIsNotItsOwn()
{
    const QSize size{640, 400};
    std::mt19937 random(21);
    Settings settings;
    settings.size = size;
    settings.algorithm = Algorithm::Tiled;
    const auto corner = [&](int x, int y) {
        Scene scene = clipScene(size);
        addTriangle(
            scene,
            {fromScreen(x, y, 0.5, 1, size), fromScreen(x, y + 50, 0.5, 1, size), fromScreen(x + 50, y, 0.5, 1, size)},
            random);
        return scene;
    };
    Scene left = corner(10, 10);
    const Scene right = corner(500, 300);
    Frame frame;
    const auto matchesFresh = [&](const Scene& scene) {
        Frame fresh;
        render(scene, settings, fresh);
        render(scene, settings, frame);
        return fresh.image == frame.image;
    };
    QVERIFY(matchesFresh(left));
    QVERIFY(matchesFresh(left));
    QVERIFY(matchesFresh(right)); // what was drawn is empty now
    frame.image.fill(Qt::red);
    QVERIFY(matchesFresh(right));
    left.background = {0, 0, 1};
    QVERIFY(matchesFresh(left));
    const QImage kept = frame.image;
    QVERIFY(matchesFresh(right));
    QVERIFY(matchesFresh(left));
    QVERIFY(kept == frame.image);
    settings.shading = Shading::Overdraw;
    QVERIFY(matchesFresh(left));
    settings.shading = Shading::Gouraud;
    settings.algorithm = Algorithm::EdgeEquation;
    render(right, settings, frame);
    settings.algorithm = Algorithm::Tiled;
    QVERIFY(matchesFresh(left));
    settings.samples = Samples::Grid2;
    QVERIFY(matchesFresh(left));
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
