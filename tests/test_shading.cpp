// Shading: every mode at numbers worked out by hand, texture look-up with any coordinate, and colour packing.
#include "core/pipeline/shading.h"
#include "tests/support.h"

#include <QTest>

#include <array>
#include <limits>
#include <set>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

constexpr float kInf = std::numeric_limits<float>::infinity();
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

/// Red, green / blue, white; row 0 lies at v = 0.
Texture fourTexels() { return {QStringLiteral("four"), 2, 2, {0xffff0000, 0xff00ff00, 0xff0000ff, 0xffffffff}}; }

bool close(const glm::vec3& a, const glm::vec3& b) { return glm::length(a - b) < 1e-5F; }

/// One triangle over the lower left of an 8 x 8 target, facing us, in the world's orientation.
Scene oneTriangle()
{
    const QSize size(8, 8);
    return soup({atPixel(0, 8, 0.5, size), atPixel(8, 8, 0.25, size), atPixel(0, 0, 0.75, size)});
}

QRgb pixelAt(const Scene& scene, Shading shading, int x, int y)
{
    Settings settings = plainSettings({8, 8});
    settings.shading = shading;
    return draw(scene, settings).image.pixel(x, y);
}

} // namespace

class TestShading : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void packingRounds();
    void gouraudFlatAndDepthAtAPixel();
    void lightOnVerticesAndFaces();
    void normalsAndCoordinates();
    void phongHasHighlights();
    void idsHaveColours();
    void nearestTexels();
    void bilinearTexels();
    void mipLevelsAreMeans();
    void trilinearTexels();
    void textureTimesColour();
    void anyCoordinateIsSafe();
    void varyingsAreAPrefix();
};

void TestShading::packingRounds()
{
    QCOMPARE(packColor({0, 0.5F, 1}), 0xff0080ffU);
    QCOMPARE(packColor({-1, 2, kNaN}), 0xff00ff00U);
    QCOMPARE(packColor({kInf, -kInf, 1e-30F}), 0xffff0000U);
    for (std::uint32_t c = 0; c < 256; ++c)
        QCOMPARE(packColor(unpackColor(0xff000000U | c << 16 | c << 8 | c)), 0xff000000U | c * 0x10101U);
    Random random = seededRandom();
    for (int i = 0; i < 100000; ++i) {
        const float c = static_cast<float>(uniform(random, 0, 1));
        const double packed = packColor({c, 0, 0}) >> 16 & 255U;
        QVERIFY(std::abs(packed - 255.0 * double(c)) <= 0.5 + 0x1p-15);
    }
}

/// Weights at the centre of (x, y): B has (x + 0.5) / 8, C has (7.5 - y) / 8.
void TestShading::gouraudFlatAndDepthAtAPixel()
{
    const Scene scene = oneTriangle();
    // (1, 5): 0.5 of red, 0.1875 of green, 0.3125 of blue.
    QCOMPARE(pixelAt(scene, Shading::Gouraud, 1, 5), qRgb(128, 48, 80));
    QCOMPARE(pixelAt(scene, Shading::Flat, 1, 5), qRgb(255, 0, 0));
    // 0.5 * 0.5 + 0.1875 * 0.25 + 0.3125 * 0.75 = 0.53125
    QCOMPARE(pixelAt(scene, Shading::Depth, 1, 5), qRgb(135, 135, 135));
    QCOMPARE(pixelAt(scene, Shading::Gouraud, 7, 0), qRgb(0, 0, 0)); // background
}

void TestShading::lightOnVerticesAndFaces()
{
    Scene scene = oneTriangle();
    const glm::dvec3 light = glm::normalize(glm::dvec3(0.3, 0.5, 1));
    const std::array<glm::vec3, 3> normals{glm::vec3(0, 0, 1), glm::vec3(0, 1, 0), glm::vec3(0, 0, -1)};
    const std::array<double, 3> expected{0.2 + 0.8 * light.z, 0.2 + 0.8 * light.y, 0.2};
    for (std::size_t i = 0; i < 3; ++i) {
        MeshVertex vertex;
        vertex.normal = normals[i];
        vertex.color = {1, 0.5F, 0};
        Varyings out{};
        Rules rules;
        shadeVertex(vertex, rules, out);
        QVERIFY(close({out[0], out[1], out[2]}, glm::vec3(1, 0.5F, 0) * float(expected[i])));
        rules.lit = false;
        shadeVertex(vertex, rules, out);
        QVERIFY(close({out[0], out[1], out[2]}, {1, 0.5F, 0}));
    }
    // A flat face takes the normal of its plane, which here is (0, 0, 1) but for the slope of z.
    const glm::vec3 a(scene.mesh.vertices[0].position);
    const glm::vec3 b(scene.mesh.vertices[1].position);
    const glm::vec3 c(scene.mesh.vertices[2].position);
    const glm::dvec3 n = glm::normalize(glm::dvec3(glm::cross(b - a, c - a)));
    const float shade = float(0.2 + 0.8 * std::max(0.0, glm::dot(n, light)));
    Rules flat;
    flat.shading = Shading::Flat;
    QCOMPARE(faceUniforms(scene, 0, flat).color, packColor({shade, 0, 0}));
    // No area, no direction: no NaN either.
    scene.mesh.indices = {0, 0, 0};
    QCOMPARE(faceUniforms(scene, 0, flat).color & 0xff000000U, 0xff000000U);
}

void TestShading::normalsAndCoordinates()
{
    Scene scene = oneTriangle();
    for (MeshVertex& v : scene.mesh.vertices) {
        v.normal = glm::normalize(glm::vec3(0, 3, 4));
        v.uv = {v.position.x * 0.5F + 0.5F, v.position.y * 0.5F + 0.5F};
    }
    QCOMPARE(pixelAt(scene, Shading::Normals, 1, 5), qRgb(128, 204, 230)); // (0, 0.6, 0.8) / 2 + 1/2
    QCOMPARE(pixelAt(scene, Shading::Uv, 1, 5), qRgb(48, 80, 0));
    for (MeshVertex& v : scene.mesh.vertices)
        v.uv += glm::vec2(3, -2); // coordinates repeat
    QCOMPARE(pixelAt(scene, Shading::Uv, 1, 5), qRgb(48, 80, 0));
}

void TestShading::phongHasHighlights()
{
    Rules rules;
    rules.shading = Shading::Phong;
    const Material material;
    FaceUniforms uniforms;
    uniforms.material = &material;
    Varyings v{};
    v[kVaryingColor] = 0.5F;
    const glm::vec3 light = glm::normalize(glm::vec3(0.3F, 0.5F, 1));
    const auto shaded = [&](const glm::vec3& normal, const glm::vec3& eye) {
        for (int i = 0; i < 3; ++i)
            v[std::size_t(kVaryingNormal + i)] = normal[i];
        return shadeFragment(rules, uniforms, v, 0, eye);
    };
    // Eye and normal towards the light: all of the ambient, diffuse and specular light.
    QCOMPARE(shaded(light, light * 5.0F), packColor({0.5F + 0.25F, 0.25F, 0.25F}));
    // A normal need not have length 1.
    QCOMPARE(shaded(light * 3.0F, light * 5.0F), packColor({0.75F, 0.25F, 0.25F}));
    // Turned away from the light: ambient only.
    QCOMPARE(shaded(-light, -light), packColor({0.1F, 0, 0}));
    rules.lit = false;
    QCOMPARE(shaded(light, light * 5.0F), packColor({0.5F, 0, 0}));
    rules.lit = true;
    QCOMPARE(shaded({0, 0, 0}, {0, 0, 0}) & 0xff000000U, 0xff000000U); // no direction at all: defined
}

void TestShading::idsHaveColours()
{
    const Scene scene = oneTriangle();
    QCOMPARE(pixelAt(scene, Shading::TriangleId, 1, 5), colorOfId(0));
    QVERIFY(pixelAt(scene, Shading::RandomFlat, 1, 5) != colorOfId(0));
    std::set<std::uint32_t> colors;
    for (std::uint32_t id = 0; id < 1000; ++id) {
        colors.insert(colorOfId(id));
        QVERIFY(colorOfId(id) != 0xff000000U);
    }
    QVERIFY(colors.size() > 995);
}

void TestShading::nearestTexels()
{
    const Texture texture = fourTexels();
    const auto at = [&](float u, float v) { return packColor(sampleTexture(texture, {u, v}, TextureFilter::Nearest)); };
    QCOMPARE(at(0.25F, 0.25F), 0xffff0000U);
    QCOMPARE(at(0.75F, 0.25F), 0xff00ff00U);
    QCOMPARE(at(0.25F, 0.75F), 0xff0000ffU);
    QCOMPARE(at(0.75F, 0.75F), 0xffffffffU);
    QCOMPARE(at(0, 0), 0xffff0000U);
    QCOMPARE(at(0.5F, 0), 0xff00ff00U); // a texel begins at its lower bound
    QCOMPARE(at(1, 0), 0xffff0000U);    // coordinates repeat
    QCOMPARE(at(-0.25F, 0), 0xff00ff00U);
    QCOMPARE(at(-3.75F, 7.25F), 0xffff0000U);
    QCOMPARE(at(-1e-12F, 0), 0xffff0000U); // a border that rounding may have moved counts as met
    QCOMPARE(at(-1e-3F, 0), 0xff00ff00U);
}

void TestShading::bilinearTexels()
{
    const Texture texture = fourTexels();
    const auto at = [&](float u, float v) { return sampleTexture(texture, {u, v}, TextureFilter::Bilinear); };
    QVERIFY(close(at(0.25F, 0.25F), {1, 0, 0}));
    QVERIFY(close(at(0.75F, 0.75F), {1, 1, 1}));
    QVERIFY(close(at(0.5F, 0.25F), {0.5F, 0.5F, 0}));
    QVERIFY(close(at(0.5F, 0.5F), {0.5F, 0.5F, 0.5F}));
    QVERIFY(close(at(0, 0.25F), {0.5F, 0.5F, 0})); // between the last texel and the first
    QVERIFY(close(at(0, 0), {0.5F, 0.5F, 0.5F}));
    QVERIFY(close(at(5.25F, -2.75F), {1, 0, 0}));
    QVERIFY(close(at(0.3125F, 0.25F), {0.875F, 0.125F, 0}));
}

/// Every level is the mean of the whole, and of the area each of its texels covers.
void TestShading::mipLevelsAreMeans()
{
    const MipLevels four = makeMipLevels(2, 2, fourTexels().texels);
    QCOMPARE(four.levels.size(), 2U);
    QCOMPARE(four.texels.back(), 0xff808080U);
    // Five texels of width 2/5 of the next: 1, 1 and 1/2, then 1/2, 1 and 1.
    constexpr std::array<std::uint32_t, 5> kFive{0xff00000a, 0xff000014, 0xff00001e, 0xff000028, 0xff000032};
    const MipLevels five = makeMipLevels(5, 1, kFive);
    QCOMPARE(five.levels.size(), 3U);
    QCOMPARE(five.levels[1].width, 2);
    QCOMPARE(five.texels[5], 0xff000000U + 18); // (10 + 20 + 30 / 2) / 2.5
    QCOMPARE(five.texels[6], 0xff000000U + 42);
    QCOMPARE(five.texels[7], 0xff000000U + 30);
    Random random = seededRandom();
    for (int i = 0; i < 50; ++i) {
        Texture texture{QStringLiteral("random"), integer(random, 1, 33), integer(random, 1, 33), {}, {}};
        double sum = 0;
        for (int k = 0; k < texture.width * texture.height; ++k) {
            texture.texels.push_back(0xff000000U | static_cast<std::uint32_t>(integer(random, 0, 255)));
            sum += texture.texels.back() & 255U;
        }
        const MipLevels mips = makeMipLevels(texture.width, texture.height, texture.texels);
        QCOMPARE(mips.levels.back().width * mips.levels.back().height, 1);
        QCOMPARE(std::size_t(mips.levels.back().first) + 1, mips.texels.size());
        const double mean = sum / double(texture.texels.size());
        // Each level rounds once.
        QVERIFY(std::abs(double(mips.texels.back() & 255U) - mean) <= 0.5 * double(mips.levels.size()));
    }
}

void TestShading::trilinearTexels()
{
    const Texture texture = fourTexels();
    const auto at = [&](float u, float v, float texelsPerSample) {
        return sampleTexture(texture, {u, v}, TextureFilter::Trilinear, {{0, texelsPerSample / 2}, {0.01F, 0}});
    };
    const glm::vec3 gray = glm::vec3(128) / 255.0F;
    QVERIFY(close(at(0.25F, 0.25F, 0), {1, 0, 0}));
    QVERIFY(close(at(0.25F, 0.25F, 1), {1, 0, 0})); // a texel a sample: the texture itself
    QVERIFY(close(at(0.25F, 0.25F, 2), gray));      // two: the level of half its size, which is one texel
    QVERIFY(close(at(0.25F, 0.25F, 1000), gray));
    QVERIFY(close(at(0.25F, 0.25F, std::sqrt(2.0F)), glm::mix(glm::vec3(1, 0, 0), gray, 0.5F)));
    QVERIFY(close(at(0.25F, 0.25F, kNaN), {1, 0, 0}));
    QVERIFY(close(at(0.25F, 0.25F, kInf), gray));
    // A copy with other texels has other levels.
    Texture copy = texture;
    copy.texels.assign(4, 0xff0000ff);
    QVERIFY(close(sampleTexture(copy, {0, 0}, TextureFilter::Trilinear, {{9, 9}, {0, 0}}), {0, 0, 1}));
}

void TestShading::textureTimesColour()
{
    Scene scene = oneTriangle();
    scene.textures.push_back(fourTexels());
    scene.materials[0].texture = 0;
    for (MeshVertex& v : scene.mesh.vertices) {
        v.uv = {0.75F, 0.25F};
        v.color = {1, 0.5F, 0.25F};
    }
    QCOMPARE(pixelAt(scene, Shading::Texture, 1, 5), qRgb(0, 128, 0));
    // A face without a texture shows its colour; where the scene has none, the board stands in.
    scene.materials[0].texture = -1;
    for (MeshVertex& v : scene.mesh.vertices) {
        v.uv = {0.01F, 0.01F};
        v.color = {1, 1, 1};
    }
    QCOMPARE(pixelAt(scene, Shading::Texture, 1, 5), qRgb(255, 255, 255));
    scene.textures.clear();
    QCOMPARE(pixelAt(scene, Shading::Texture, 1, 5), qRgb(230, 230, 230));
}

void TestShading::anyCoordinateIsSafe()
{
    Random random = seededRandom();
    const Texture texture = fourTexels();
    const Texture one{QStringLiteral("one"), 1, 1, {0xff00ff00}};
    std::vector<float> values{0, 1, -1, kInf, -kInf, kNaN, 1e30F, -1e30F, 1e-45F, 0x1p52F, 0x1p31F, -0x1p31F};
    for (int i = 0; i < 500; ++i)
        values.push_back(anyFloat(random));
    for (const float u : values)
        for (const float v : {u, values[static_cast<std::size_t>(integer(random, 0, int(values.size()) - 1))], 0.3F})
            for (const TextureFilter filter :
                 {TextureFilter::Nearest, TextureFilter::Bilinear, TextureFilter::Trilinear}) {
                const UvGradient gradient{{u, v}, {v, u}};
                QCOMPARE(packColor(sampleTexture(texture, {u, v}, filter, gradient)) & 0xff000000U, 0xff000000U);
                const glm::vec3 green = sampleTexture(one, {u, v}, filter, gradient);
                QVERIFY(filter != TextureFilter::Nearest || close(green, {0, 1, 0}));
            }
}

/// Nothing is interpolated that the shading does not read.
void TestShading::varyingsAreAPrefix()
{
    QCOMPARE(varyingCount(Shading::Gouraud), 3);
    QCOMPARE(varyingCount(Shading::Texture), 5);
    QCOMPARE(varyingCount(Shading::Phong), 11);
    QCOMPARE(varyingCount(Shading::Uv), 2);
    for (const Shading s : {Shading::Flat, Shading::RandomFlat, Shading::Depth, Shading::Overdraw, Shading::TriangleId})
        QCOMPARE(varyingCount(s), 0);
    for (int s = 0; s < 10; ++s) {
        Rules rules;
        rules.shading = Shading(s);
        Varyings out;
        out.fill(123);
        shadeVertex(MeshVertex(), rules, out);
        QVERIFY(varyingCount(Shading(s)) <= kMaxVaryings);
        for (std::size_t k = std::size_t(varyingCount(Shading(s))); k < out.size(); ++k)
            QCOMPARE(out[k], 123.0F);
    }
}

QTEST_APPLESS_MAIN(TestShading)
#include "test_shading.moc"
