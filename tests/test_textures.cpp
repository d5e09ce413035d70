// The rules of textures, the same in every algorithm, on every instruction set and with any number of threads: borders
// between texels, textures that do not repeat, faces without a texture, holes, and numbers that are none.
#include "core/pipeline/mask_test.h"
#include "core/pipeline/shading.h"
#include "core/questions/why.h"
#include "core/scene/texel_border.h"
#include "tests/seed.h"
#include "tests/tiled_support.h"

#include <QTest>

#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <set>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

/// A square over the whole picture, lower left corner first, with uv from `low` to `high`.
void addSquare(Scene& scene, glm::vec2 low, glm::vec2 high, float depth = 0)
{
    const auto first = static_cast<std::uint32_t>(scene.mesh.vertices.size());
    for (const glm::vec2 at : {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(1, 1), glm::vec2(0, 1)})
        scene.mesh.vertices.push_back(
            {.position = glm::vec4(2.0F * at - 1.0F, depth, 1), .uv = glm::mix(low, high, at)});
    for (const std::uint32_t corner : {0U, 1U, 2U, 0U, 2U, 3U})
        scene.mesh.indices.push_back(first + corner);
}

/// Edge walking against edge equation, then tiled against edge equation on everything there is.
QString compareEverything(const Scene& scene, Settings settings, const std::vector<int>& threads = {1, 2})
{
    settings.culling = Culling::None;
    settings.algorithm = Algorithm::EdgeEquation;
    Frame expected;
    render(scene, settings, expected, kAll);
    settings.algorithm = Algorithm::EdgeWalking;
    Frame walked;
    render(scene, settings, walked, kAll);
    if (const QString d = difference(expected, walked); !d.isEmpty())
        return "edge-walking: " + d;
    if (expected.image != walked.image)
        return QStringLiteral("edge-walking: other colours");
    return compareAll(scene, settings, simds(), threads);
}

QString compareEach(const Scene& scene, Settings settings, std::initializer_list<Shading> shadings,
                    std::initializer_list<TextureFilter> filters)
{
    for (const Shading shading : shadings)
        for (const TextureFilter filter : filters) {
            settings.shading = shading;
            settings.textureFilter = filter;
            if (const QString d = compareEverything(scene, settings); !d.isEmpty())
                return QStringLiteral("shading %1, filter %2: %3")
                    .arg(valueId(*findSettingsField("shading"), settings),
                         valueId(*findSettingsField("texture-filter"), settings), d);
        }
    return {};
}

constexpr auto kAllFilters = {TextureFilter::Nearest, TextureFilter::Bilinear, TextureFilter::Trilinear};

/// Grey texels of all opacities.
Texture someOpacity(std::mt19937& random, int width, int height)
{
    Texture texture{QStringLiteral("opacity"), width, height, {}};
    for (int i = 0; i < width * height; ++i)
        texture.texels.push_back(0xff000000U | (random() & 255U) * 0x10101U);
    return texture;
}

QRgb pixelOf(const Scene& scene, Settings settings, int x, int y)
{
    Frame frame;
    render(scene, settings, frame, {});
    return frame.image.pixel(x, y);
}

} // namespace

class TestTextures : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void bordersBelongToTheTexelAbove();
    void roundingDrawsNoNoiseOnBorders();
    void coordinatesThatAreAlmostWhole();
    void clampedTexturesDoNotRepeat();
    void clampedTexturesEverywhere();
    void facesWithoutTextureShowTheirColor();
    void holesLetWhatIsBehindThrough();
    void holesEverywhere();
    void holesOfScenesThatAreHard();
    void holesAreExplained();
    void alphaTestOffDrawsTheWhole();
    void numbersThatAreNone();
    void tilesThatBelongToFacesOfNoNumbers();
    void noWToDivideBy();
};

/// A coordinate exactly on a border, or a rounding below it, is the texel's that begins there; one that is a little
/// more below is not.
void TestTextures::bordersBelongToTheTexelAbove()
{
    for (const float border : {0.0F, 1.0F, 2.0F, 255.0F, 256.0F, 4097.0F, 16384.0F, -1.0F, -512.0F}) {
        QCOMPARE(texelFloor(border), border);
        QCOMPARE(texelFloor(std::nextafter(border, -kInf)), border);
        QCOMPARE(texelFloor(std::nextafter(std::nextafter(border, -kInf), -kInf)), border);
        const float below = border - std::abs(border) * 0x1p-19F - 0x1p-18F;
        QCOMPARE(texelFloor(below), border - 1);
        QCOMPARE(texelFloor(border + 0.5F), border);
    }
    QVERIFY(std::isnan(texelFloor(kNaN)));
}

/// The corners' v are rounded, so that in the middle it lies half way between two numbers of float32 below one half:
/// what the order of a sum decides.
void TestTextures::roundingDrawsNoNoiseOnBorders()
{
    std::mt19937 random(31);
    const QSize size(20, 17);
    int undecided = 0;
    for (const int side : {2, 512, 300, 1024})
        for (int i = 1; i < 12; ++i) {
            const float low = 0.5F - 1.0F / (3.0F + 2.0F * float(i) + float(i % 3) / 7.0F);
            const float high = std::nextafter(1.0F - low, i % 2 == 0 ? 0.0F : 1.0F);
            undecided += static_cast<float>(0.5 * (double(low) + double(high))) != 0.5F || low + high != 1.0F;
            Scene scene = clipScene(size);
            scene.textures = {noise(random, side, side)};
            scene.materials[0].texture = 0;
            addSquare(scene, {low, low}, {high, high});
            for (const Shading shading : {Shading::Texture, Shading::Phong}) {
                Settings settings;
                settings.size = size;
                settings.shading = shading;
                const QString d = compareEverything(scene, settings);
                QVERIFY2(d.isEmpty(), qPrintable(QStringLiteral("side %1, case %2: %3").arg(side).arg(i).arg(d)));
                if (side != 2)
                    continue;
                Frame frame;
                render(scene, settings, frame, {});
                std::set<QRgb> middle; // two texels a row, whatever the noise of the texture is
                for (int x = 0; x < size.width(); ++x)
                    middle.insert(frame.image.pixel(x, 8));
                QVERIFY(middle.size() <= 2);
                QCOMPARE(frame.image.pixel(2, 8), frame.image.pixel(2, 4)); // v = 1/2 belongs to the upper texel
            }
        }
    QVERIFY2(undecided > 8, "no corner's rounding was at stake");
}

void TestTextures::coordinatesThatAreAlmostWhole()
{
    const QSize size(40, 31);
    for (const float top : {1.0F, 2.0F, 3.0F, 64.0F}) {
        Scene scene = clipScene(size);
        addSquare(scene, {0, -std::nextafter(top, 0.0F)}, {top, top});
        Settings settings;
        settings.size = size;
        settings.shading = Shading::Uv;
        const QString d = compareEverything(scene, settings);
        QVERIFY2(d.isEmpty(), qPrintable(d));
        Frame frame;
        render(scene, settings, frame, {});
        for (int x = 0; x < size.width(); ++x)
            QVERIFY2(qGreen(frame.image.pixel(x, 15)) <= 1, "v is 0 in the middle row, not almost 1");
    }
}

void TestTextures::clampedTexturesDoNotRepeat()
{
    const QSize size(8, 8);
    Scene scene = clipScene(size);
    scene.textures = {Texture{QStringLiteral("two"), 2, 1, {0xffff0000U, 0xff0000ffU}}};
    scene.materials[0].texture = 0;
    addSquare(scene, {-1, 0}, {3, 1});
    Settings settings;
    settings.size = size;
    settings.shading = Shading::Texture;
    QCOMPARE(pixelOf(scene, settings, 0, 4), 0xffff0000U); // u = -0.75
    QCOMPARE(pixelOf(scene, settings, 1, 4), 0xff0000ffU); // u = -0.25
    QCOMPARE(pixelOf(scene, settings, 6, 4), 0xffff0000U); // u = 2.25
    scene.textures[0].clamp = true;
    for (const TextureFilter filter : kAllFilters) {
        settings.textureFilter = filter;
        QCOMPARE(pixelOf(scene, settings, 0, 4), 0xffff0000U);
        QCOMPARE(pixelOf(scene, settings, 1, 4), 0xffff0000U);
        QCOMPARE(pixelOf(scene, settings, 6, 4), 0xff0000ffU);
        QCOMPARE(pixelOf(scene, settings, 7, 4), 0xff0000ffU);
    }
}

void TestTextures::clampedTexturesEverywhere()
{
    std::mt19937 random(32);
    const QSize size(70, 50);
    Scene scene = soup(random, size, 40);
    dress(scene, random);
    for (std::size_t i = 0; i < scene.textures.size(); i += 2)
        scene.textures[i].clamp = true;
    Settings settings;
    settings.size = size;
    const QString d = compareEach(scene, settings, {Shading::Texture, Shading::Phong}, kAllFilters);
    QVERIFY2(d.isEmpty(), qPrintable(d));
}

void TestTextures::facesWithoutTextureShowTheirColor()
{
    const QSize size(8, 8);
    Scene scene = clipScene(size);
    addSquare(scene, {0, 0}, {1, 1});
    for (MeshVertex& v : scene.mesh.vertices)
        v.color = {1, 0.5F, 0};
    Settings settings;
    settings.size = size;
    settings.shading = Shading::Texture;
    const QRgb checkered = pixelOf(scene, settings, 4, 4);
    QCOMPARE(checkered, packColor(glm::vec3(1, 0.5F, 0) * unpackColor(checkerTexture().texels[256 * 512 + 256])));
    scene.textures = {Texture{QStringLiteral("other"), 1, 1, {0xff123456U}}}; // some material has one
    scene.materials.push_back(Material{});
    scene.materials[1].texture = 0;
    scene.mesh.faceMaterial = {0, 1};
    for (const TextureFilter filter : kAllFilters) {
        settings.textureFilter = filter;
        QCOMPARE(pixelOf(scene, settings, 6, 6), 0xffff8000U);
        const QString d = compareEverything(scene, settings);
        QVERIFY2(d.isEmpty(), qPrintable(d));
    }
}

/// A square before another one; the left half of the first is transparent.
Scene squareWithHole(QSize size)
{
    Scene scene = clipScene(size);
    addSquare(scene, {0, 0}, {1, 1}, -0.5F);
    addSquare(scene, {0, 0}, {1, 1}, 0.5F);
    for (std::size_t i = 0; i < 8; ++i)
        scene.mesh.vertices[i].color = i < 4 ? glm::vec3(1, 0, 0) : glm::vec3(0, 0, 1);
    scene.textures = {Texture{QStringLiteral("mask"), 2, 1, {0xff7f7f7fU, 0xff808080U}}};
    scene.materials.resize(2);
    scene.materials[1].mask = 0;
    scene.mesh.faceMaterial = {1, 1, 0, 0};
    return scene;
}

void TestTextures::holesLetWhatIsBehindThrough()
{
    const QSize size(8, 8);
    const Scene scene = squareWithHole(size);
    for (const Algorithm algorithm : {Algorithm::EdgeEquation, Algorithm::EdgeWalking, Algorithm::Tiled})
        for (const DepthOrder order : {DepthOrder::BeforeShading, DepthOrder::AfterShading}) {
            Settings settings;
            settings.size = size;
            settings.algorithm = algorithm;
            settings.depthOrder = order;
            Frame frame;
            const Statistics counts = renderCounted(scene, settings, frame, kAll);
            QCOMPARE(frame.image.pixel(1, 4), 0xff0000ffU); // 127 of 255 is less than one half
            QCOMPARE(frame.image.pixel(6, 4), 0xffff0000U); // 128 is not
            QCOMPARE(frame.ids[4 * 8 + 1] / 2, 1);
            QCOMPARE(frame.ids[4 * 8 + 6] / 2, 0);
            QCOMPARE(frame.depth[4 * 8 + 1], 0.75F);
            QCOMPARE(frame.depth[4 * 8 + 6], 0.25F);
            QCOMPARE(int(frame.coverage[4 * 8 + 1]), 1);
            QCOMPARE(int(frame.coverage[4 * 8 + 6]), 2);
            QCOMPARE(counts.pixels.covered, std::uint64_t(64 + 32));
        }
}

void TestTextures::holesEverywhere()
{
    std::mt19937 random(seedOfRun());
    const QSize size(66, 50);
    Scene scene = soup(random, size, 30);
    dress(scene, random);
    scene.textures.push_back(someOpacity(random, 8, 8));
    scene.textures.push_back(someOpacity(random, 5, 3));
    for (std::size_t i = 0; i < scene.materials.size(); i += 2)
        scene.materials[i].mask = 4 + int(i / 2 % 2);
    scene.materials[2].maskScale = {2, 0.5F};
    scene.materials[2].maskOffset = {0.25F, -1};
    Settings settings;
    settings.size = size;
    QString d = compareEach(scene, settings,
                            {Shading::Gouraud, Shading::Flat, Shading::Texture, Shading::Phong, Shading::Depth,
                             Shading::Normals, Shading::Uv, Shading::Overdraw, Shading::TriangleId},
                            {TextureFilter::Nearest});
    QVERIFY2(d.isEmpty(), qPrintable(d));
    d = compareEach(scene, settings, {Shading::Gouraud, Shading::Texture},
                    {TextureFilter::Bilinear, TextureFilter::Trilinear});
    QVERIFY2(d.isEmpty(), qPrintable(d));
}

/// Other depth tests and samples, faces that are cut, fields of view that pass the eye.
void TestTextures::holesOfScenesThatAreHard()
{
    std::mt19937 random(34);
    const QSize size(50, 40);
    Scene scene = soup(random, size, 25);
    dress(scene, random);
    scene.textures.push_back(someOpacity(random, 6, 6));
    for (std::size_t i = 0; i < scene.materials.size(); i += 2)
        scene.materials[i].mask = 4;
    const auto check = [&](auto change) {
        Settings settings;
        settings.size = size;
        change(settings);
        const QString d = compareEach(scene, settings, {Shading::Texture, Shading::Gouraud}, {TextureFilter::Nearest});
        QVERIFY2(d.isEmpty(), qPrintable(d));
    };
    check([](Settings& s) { s.depthTest = DepthTest::LessEqual; });
    check([](Settings& s) { s.depthTest = DepthTest::Greater; });
    check([](Settings& s) { s.depthTest = DepthTest::None; });
    check([](Settings& s) { s.depthFormat = DepthFormat::Unorm16; });
    check([](Settings& s) { s.reversedZ = true; });
    check([](Settings& s) { s.samples = Samples::Grid2; });
    check([](Settings& s) { s.samples = Samples::Grid3; });
    check([](Settings& s) { s.clipping = Clipping::None; });
    check([](Settings& s) { s.interpolation = Interpolation::Affine; });
    check([](Settings& s) { s.visibility = Visibility::SubmissionOrder; });
}

void TestTextures::holesAreExplained()
{
    const QSize size(8, 8);
    const Scene scene = squareWithHole(size);
    for (const Algorithm algorithm : {Algorithm::EdgeEquation, Algorithm::EdgeWalking, Algorithm::Tiled}) {
        Settings settings;
        settings.size = size;
        settings.algorithm = algorithm;
        const WhyReport hole = why(scene, settings, 1, 4);
        int holes = 0;
        for (const WhyFace& face : hole.faces)
            if (face.verdict == WhyVerdict::Hole) {
                ++holes;
                QVERIFY(face.face < 2);
                QCOMPARE(face.opacity, 127.0F / 255.0F);
                QVERIFY2(whyText(hole, face).contains(QStringLiteral("cut out by the alpha test")),
                         qPrintable(whyText(hole, face)));
            }
        QCOMPARE(holes, 1);
        QVERIFY(hole.visibleFace && *hole.visibleFace >= 2);
        QCOMPARE(hole.color, 0xff0000ffU);
        const WhyReport whole = why(scene, settings, 6, 4);
        QVERIFY(std::ranges::none_of(whole.faces, [](const WhyFace& f) { return f.verdict == WhyVerdict::Hole; }));
        settings.alphaTest = AlphaTest::Off;
        const WhyReport off = why(scene, settings, 1, 4);
        QVERIFY(off.visibleFace && *off.visibleFace < 2);
    }
}

void TestTextures::alphaTestOffDrawsTheWhole()
{
    const QSize size(8, 8);
    Scene scene = squareWithHole(size);
    Settings settings;
    settings.size = size;
    settings.alphaTest = AlphaTest::Off;
    for (const Algorithm algorithm : {Algorithm::EdgeEquation, Algorithm::EdgeWalking, Algorithm::Tiled}) {
        settings.algorithm = algorithm;
        QCOMPARE(pixelOf(scene, settings, 1, 4), 0xffff0000U);
    }
    // Without masks the switch changes nothing.
    scene.materials[1].mask = -1;
    Frame on;
    Frame off;
    render(scene, settings, off, kAll);
    settings.alphaTest = AlphaTest::On;
    render(scene, settings, on, kAll);
    QVERIFY(difference(off, on).isEmpty() && off.image == on.image);
}

void TestTextures::numbersThatAreNone()
{
    std::mt19937 random(35);
    const QSize size(70, 50);
    const std::array odd{kNaN, -kNaN, kInf, -kInf, 1e30F, -1e-42F, -0.0F};
    for (int round = 0; round < casesOfBuild(6); ++round) {
        Scene scene = soup(random, size, 30);
        dress(scene, random);
        scene.textures.push_back(someOpacity(random, 4, 4));
        if (round % 2 == 1)
            scene.materials[1].mask = 4;
        scene.textures[std::size_t(round) % 4].clamp = round > 3;
        scene.materials[2].shininess = round % 3 == 0 ? kInf : kNaN;
        scene.materials[3].specular = {kNaN, kInf, 0.5F};
        scene.lit = round % 2 == 0;
        for (MeshVertex& v : scene.mesh.vertices) {
            const auto some = [&](float usual) { return random() % 4 == 0 ? odd[random() % odd.size()] : usual; };
            v.uv = {some(v.uv.x), some(v.uv.y)};
            v.color = {some(v.color.x), some(v.color.y), some(v.color.z)};
            v.normal = {some(v.normal.x), some(v.normal.y), some(v.normal.z)};
        }
        Settings settings;
        settings.size = size;
        settings.samples = round == 5 ? Samples::Grid4 : Samples::One;
        QString d = compareEach(scene, settings, {Shading::Texture, Shading::Phong}, kAllFilters);
        QVERIFY2(d.isEmpty(), qPrintable(QStringLiteral("round %1: %2").arg(round).arg(d)));
        d = compareEach(scene, settings, {Shading::Gouraud, Shading::Normals, Shading::Uv, Shading::Flat},
                        {TextureFilter::Nearest});
        QVERIFY2(d.isEmpty(), qPrintable(QStringLiteral("round %1: %2").arg(round).arg(d)));
    }
}

/// Faces that have whole blocks and tiles to themselves take another way than small ones.
void TestTextures::tilesThatBelongToFacesOfNoNumbers()
{
    std::mt19937 random(36);
    const QSize size(130, 70);
    for (const QSize texels : {QSize(8, 8), QSize(7, 5)})
        for (const float bad : {kNaN, kInf, -kInf, 3e38F})
            for (const std::size_t corner : {0U, 1U, 2U}) {
                Scene scene = clipScene(size);
                scene.textures = {noise(random, texels.width(), texels.height())};
                scene.materials[0].texture = 0;
                addSquare(scene, {0, 0}, {3, 2});
                scene.mesh.vertices[corner].uv.x = bad;
                Settings settings;
                settings.size = size;
                QString d = compareEach(scene, settings, {Shading::Texture, Shading::Phong}, kAllFilters);
                QVERIFY2(d.isEmpty(), qPrintable(d));
                scene.mesh.vertices[corner].uv.x = 0;
                scene.mesh.vertices[corner].color.y = bad;
                d = compareEach(scene, settings, {Shading::Texture, Shading::Gouraud}, {TextureFilter::Nearest});
                QVERIFY2(d.isEmpty(), qPrintable(d));
            }
}

/// Corners with w = 0: there is no w to divide by, and no instruction set may find one.
void TestTextures::noWToDivideBy()
{
    std::mt19937 random(37);
    const QSize size(20, 16);
    const std::array<std::array<float, 3>, 6> ws{
        {{0, 0, 0}, {0, 0, 1}, {0, 1, 1}, {1, 0, 0}, {-1, 0, 1}, {-0.0F, 0, 0}}};
    for (const std::array<float, 3>& w : ws)
        for (const Clipping clipping : {Clipping::None, Clipping::NearFarReject}) {
            Scene scene = clipScene(size);
            scene.textures = {noise(random, 16, 16)};
            scene.materials[0].texture = 0;
            addTriangle(scene, {glm::vec4(1, 0, 0, w[0]), glm::vec4(0, 1, 0, w[1]), glm::vec4(-1, -1, 0, w[2])},
                        random);
            Settings settings;
            settings.size = size;
            settings.clipping = clipping;
            QString d = compareEach(scene, settings,
                                    {Shading::Gouraud, Shading::Texture, Shading::Phong, Shading::Normals, Shading::Uv},
                                    {TextureFilter::Nearest});
            QVERIFY2(d.isEmpty(), qPrintable(QStringLiteral("w %1 %2 %3: %4").arg(w[0]).arg(w[1]).arg(w[2]).arg(d)));
            for (MeshVertex& v : scene.mesh.vertices)
                v.color = {1, 0.5F, 0.25F}; // one colour: no range to be off by
            d = compareEach(scene, settings, {Shading::Gouraud}, {TextureFilter::Nearest});
            QVERIFY2(d.isEmpty(), qPrintable(d));
        }
}

QTEST_APPLESS_MAIN(TestTextures)
#include "test_textures.moc"
