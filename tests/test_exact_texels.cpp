// The nearest texel and the mip level of a sample, decided by integers: against values worked out by hand, and the
// rasterizers against them.
#include "core/io/case_file.h"
#include "core/pipeline/shading.h"
#include "core/questions/why.h"
#include "core/render/render.h"
#include "core/scenes/load_scene.h"
#include "core/truth/coverage_difference.h"
#include "core/truth/exact_reference.h"
#include "core/truth/exact_texels.h"
#include "tests/seed.h"

#include <QJsonArray>
#include <QJsonObject>
#include <QTest>

#include <array>
#include <cmath>
#include <random>
#include <set>

using namespace rasterlens;

namespace
{

constexpr int kSide = 16;

/// A square of pixels in which u and v are u0 + x du, v0 + y dv, with a texture whose texels all differ.
Scene sceneOf(double u0, double du, double v0, double dv, int texels)
{
    const SceneLoad load = parseCase("size 16 16\ntexture checker 2\n", QStringLiteral("a.case"));
    Scene scene = *load.scene;
    Texture& texture = scene.textures.front();
    texture.width = texture.height = texels;
    texture.texels.clear();
    for (int i = 0; i < texels * texels; ++i)
        texture.texels.push_back(0xff000000U | static_cast<std::uint32_t>(i * 7919 + 1));
    const auto corner = [&](double x, double y) {
        MeshVertex vertex;
        vertex.position = {2 * x / kSide - 1, 1 - 2 * y / kSide, 0, 1};
        vertex.uv = {static_cast<float>(u0 + x * du), static_cast<float>(v0 + y * dv)};
        scene.mesh.indices.push_back(static_cast<std::uint32_t>(scene.mesh.vertices.size()));
        scene.mesh.vertices.push_back(vertex);
    };
    const double ends[6][2] = {{0, 0}, {0, kSide}, {kSide, 0}, {kSide, 0}, {0, kSide}, {kSide, kSide}};
    for (const auto& end : ends)
        corner(end[0], end[1]);
    return scene;
}

std::vector<ExactTexel> texelsOf(const Scene& scene)
{
    return exactTexels(scene, scene.defaults, exactReference(scene, scene.defaults));
}

/// Samples whose colour is not that of the exact texel.
int wrongTexels(const Scene& scene, Algorithm algorithm)
{
    Settings settings = scene.defaults;
    settings.algorithm = algorithm;
    Frame frame;
    render(scene, settings, frame);
    const std::vector<ExactTexel> exact = texelsOf(scene);
    int wrong = 0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        const Texture& texture = scene.textures.front();
        const int x = static_cast<int>(i) % frame.image.width();
        const int y = static_cast<int>(i) / frame.image.width();
        const std::uint32_t texel =
            texture.texels[static_cast<std::size_t>(exact[i].row * texture.width + exact[i].column)];
        wrong += frame.image.pixel(x, y) != texel ? 1 : 0;
    }
    return wrong;
}

} // namespace

class TestExactTexels : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void bordersBelongToTheUpperTexel();
    void rasterizersAgree();
    void levelsChangeAtPowersOfTwo();
    void cutFacesAreNotKnown();
    void texturedTruthIsWhatIsDrawn_data();
    void texturedTruthIsWhatIsDrawn();
    void footprintTellsPlaceStepsAndLevel();
    void readsAreThoseOfTheSampler();
    void cornersAreExactDerivatives();
    void patchesHoldWhatIsDrawn();
    void levelsAreShownInColours();
};

void TestExactTexels::bordersBelongToTheUpperTexel()
{
    // Eight texels on eight columns, and borders at the centres: u W = x - 4 at column x.
    const Scene scene = sceneOf(-4.5 / 8, 1.0 / 8, 0.03, 0, 8);
    const std::vector<ExactTexel> exact = texelsOf(scene);
    for (int x = 0; x < kSide; ++x) {
        QCOMPARE(exact[static_cast<std::size_t>(x)].column, (x - 4 + 8) % 8);
        QCOMPARE(exact[static_cast<std::size_t>(x)].row, 0);
    }
    // A hair below the border, by less than rounding accounts for, counts as on it; by more it does not.
    QCOMPARE(texelsOf(sceneOf(0.5 - 0x1p-24, 0, 0.03, 0, 8)).front().column, 4);
    QCOMPARE(texelsOf(sceneOf(0.5 - 0x1p-20, 0, 0.03, 0, 8)).front().column, 3);
    // Clamped, the last texel goes on.
    Scene clamped = sceneOf(-1, 0.25, 0.03, 0, 8);
    clamped.textures.front().clamp = true;
    QCOMPARE(texelsOf(clamped).front().column, 0);
    QCOMPARE(texelsOf(clamped)[kSide - 1].column, 7);
}

void TestExactTexels::rasterizersAgree()
{
    const unsigned seed = test::seedOfRun();
    std::mt19937 random(seed);
    const auto any = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
    for (int i = 0; i < 40; ++i) {
        // Multiples of 1/64 put many centres on borders exactly, also mirrored ones and those left of 0.
        const auto step = [&] { return std::round(any(-32, 32)) / 64; };
        const Scene scene = sceneOf(step(), step(), step(), step(), 1 << (i % 5));
        for (const Algorithm algorithm : {Algorithm::EdgeEquation, Algorithm::EdgeWalking, Algorithm::Tiled})
            QVERIFY2(wrongTexels(scene, algorithm) == 0,
                     qPrintable(QStringLiteral("scene %1, seed %2").arg(i).arg(seed)));
    }
}

void TestExactTexels::levelsChangeAtPowersOfTwo()
{
    for (const double texels : {0.5, 1.0, 2.0, 3.999, 4.0, 5.0, 8.0, 32.0}) {
        const int level = std::max(0, static_cast<int>(std::floor(std::log2(texels))));
        QCOMPARE(texelsOf(sceneOf(0, texels / 64, 0, 0, 64)).front().level, level);
        QCOMPARE(texelsOf(sceneOf(0, 0, 0, -texels / 64, 64)).front().level, level);
    }
    // Just below a power of two in float32.
    const double below = static_cast<double>(std::nextafter(2.0F / 64 * kSide, 0.0F)) / kSide;
    QCOMPARE(texelsOf(sceneOf(0, below, 0, 0, 64)).front().level, 0);
    QCOMPARE(texelsOf(sceneOf(0.3, 0, 0.7, 0, 64)).front().level, 0); // no derivative
}

void TestExactTexels::cutFacesAreNotKnown()
{
    Scene scene = sceneOf(0, 0.1, 0, 0.1, 8);
    scene.mesh.vertices[0].position.x = -1.5F;
    const std::vector<ExactTexel> exact = texelsOf(scene);
    QCOMPARE(exact.front().column, -1);
    QVERIFY(exact.back().column >= 0);
}

void TestExactTexels::texturedTruthIsWhatIsDrawn_data()
{
    QTest::addColumn<TextureFilter>("filter");
    QTest::newRow("nearest") << TextureFilter::Nearest;
    QTest::newRow("bilinear") << TextureFilter::Bilinear;
    QTest::newRow("trilinear") << TextureFilter::Trilinear;
}

/// Faces that are cut, that repeat the texture, and that lie far from the eye, also with several samples a pixel: what
/// is drawn is the truth to rounding, and an affine picture of the same scene is not.
void TestExactTexels::texturedTruthIsWhatIsDrawn()
{
    QFETCH(const TextureFilter, filter);
    for (const char* name : {"builtin:floor", "builtin:tile-square", "builtin:tunnel"}) {
        const SceneLoad load = loadScene(QLatin1String(name));
        const Scene& scene = *load.scene;
        Settings settings = scene.defaults;
        settings.size = {160, 120};
        settings.shading = Shading::Texture;
        settings.textureFilter = filter;
        for (const Samples samples : {Samples::One, Samples::Grid2}) {
            settings.samples = samples;
            ExactFrame truth = exactReference(scene, settings);
            textureExactly(scene, settings, truth);
            Frame frame;
            render(scene, settings, frame, {.depth = true, .ids = true});
            const CoverageDifference right = coverageDifference(frame, truth, scene.background);
            QVERIFY(right.colorsCompared > 1000);
            QVERIFY2(right.colorMax < 0.6 || samples != Samples::One, qPrintable(QString::number(right.colorMax)));
            QVERIFY2(right.colorMean < 0.3, qPrintable(QString::number(right.colorMean)));
        }
    }
}

void TestExactTexels::footprintTellsPlaceStepsAndLevel()
{
    // 64 texels: 4 a sample to the right, half of one down, which is up in the texture.
    const Scene scene = sceneOf(0, 4.0 / 64, 1, -0.5 / 64, 64);
    const WhyReport report = why(scene, scene.defaults, 3, 5);
    const WhyFace* face = report.visibleFace ? report.find(*report.visibleFace) : nullptr;
    QVERIFY(face && face->texels);
    QCOMPARE(face->texels->size, QSize(64, 64));
    const auto isNear = [](const glm::dvec2& a, const glm::dvec2& b) { return glm::distance(a, b) < 1e-4; };
    QVERIFY(isNear(face->texels->place, {14, 64 - 2.75}));
    QVERIFY(isNear(face->texels->right, {4, 0}) && isNear(face->texels->down, {0, -0.5}));
    QVERIFY(std::abs(face->texels->level - 2) < 1e-5);
    const QJsonObject json =
        toJson(report)[QLatin1String("faces")].toArray()[int(face - report.faces.data())].toObject();
    QVERIFY(std::abs(json[QLatin1String("texels")][QLatin1String("level")].toDouble() - 2) < 1e-5);

    // The wrong level is told where it is taken: twice as many levels.
    Settings doubled = scene.defaults;
    doubled.mistakes = {QStringLiteral("lod-doubled")};
    const WhyReport wrong = why(scene, doubled, 3, 5);
    QVERIFY(std::abs(wrong.find(*wrong.visibleFace)->texels->level - 4) < 1e-5);

    Settings plain = scene.defaults;
    plain.shading = Shading::Gouraud;
    const WhyReport untextured = why(scene, plain, 3, 5);
    QVERIFY(!untextured.find(*untextured.visibleFace)->texels);
}

/// The texels that are listed, by their weights, give the colour; another value of one of them changes it, and that of
/// no other does.
void TestExactTexels::readsAreThoseOfTheSampler()
{
    std::mt19937_64 random(test::seedOfRun());
    const auto uniform = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    std::set<int> levels;
    for (int round = 0; round < 600; ++round) {
        Texture texture;
        texture.width = 1 + int(random() % 9);
        texture.height = 1 + int(random() % 9);
        texture.clamp = round % 3 == 0;
        for (int i = 0; i < texture.width * texture.height; ++i)
            texture.texels.push_back(0xff000000U | static_cast<std::uint32_t>(random() & 0xffffff));
        const glm::vec2 uv(uniform(-2, 3), uniform(-2, 3));
        const auto filter = static_cast<TextureFilter>(round / 3 % 3);
        const double step = std::exp2(uniform(-4, 1));
        const UvGradient gradient{{step, 0.1 * step}, {-0.3 * step, 0.7 * step}};
        const std::vector<TexelRead> reads = texelReads(texture, uv, filter, gradient);
        QCOMPARE(reads.size() % 4, std::size_t(filter == TextureFilter::Nearest ? 1 : 0));
        glm::dvec3 sum(0);
        double weights = 0;
        for (const TexelRead& read : reads) {
            sum += read.weight * glm::dvec3(unpackColor(read.color));
            weights += read.weight;
            levels.insert(read.level);
            const MipLevels::Level& level = texture.mipLevels().levels[std::size_t(read.level)];
            QCOMPARE(read.color, texture.mipLevels().texels[std::size_t(level.first + read.y * level.width + read.x)]);
            if (!texture.clamp) {
                QCOMPARE(std::fmod(std::fmod(read.column, level.width) + level.width, level.width), double(read.x));
                QCOMPARE(std::fmod(std::fmod(read.row, level.height) + level.height, level.height), double(read.y));
            }
        }
        QVERIFY(std::abs(weights - 1) < 1e-6);
        const glm::vec3 color = sampleTexture(texture, uv, filter, gradient);
        QVERIFY(glm::distance(sum, glm::dvec3(color)) < 1e-5);
        if (filter == TextureFilter::Trilinear)
            continue; // its levels are means of texels
        for (std::size_t i = 0; i < texture.texels.size(); ++i) {
            double weight = 0;
            for (const TexelRead& read : reads)
                weight += std::size_t(read.y * texture.width + read.x) == i ? read.weight : 0;
            Texture other = texture;
            other.texels[i] ^= 0xffffff;
            const bool isChanged = glm::distance(sampleTexture(other, uv, filter, gradient), color) > 1e-6F;
            if (weight == 0 || weight > 1e-3)
                QCOMPARE(isChanged, weight > 0);
        }
    }
    QVERIFY(levels.size() >= 3);
}

/// The parallelogram lies half of each step round the place. The steps are derivatives of quotients of two linear
/// functions, computed here from the corners' own equations.
void TestExactTexels::cornersAreExactDerivatives()
{
    std::mt19937_64 random(test::seedOfRun());
    const auto uniform = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    int asked = 0;
    for (int round = 0; round < 60; ++round) {
        Scene scene = sceneOf(0, 1, 0, 1, 32);
        scene.mesh.indices = {0, 1, 2};
        glm::dmat3 system(1); // row k: x, y, 1 of corner k
        glm::dvec3 numerators[2];
        glm::dvec3 denominator;
        for (int k = 0; k < 3; ++k) {
            MeshVertex& vertex = scene.mesh.vertices[std::size_t(k)];
            const double w = std::exp2(double(random() % 4));
            const int x = int(random() % 4096);
            const int y = int(random() % 4096);
            vertex.position = {(x / 2048.0 - 1) * w, (1 - y / 2048.0) * w, 0, w};
            vertex.uv = {uniform(-2, 2), uniform(-2, 2)};
            for (int column = 0; column < 3; ++column)
                system[column][k] = column == 0 ? x / 256.0 : column == 1 ? y / 256.0 : 1;
            numerators[0][k] = double(vertex.uv.x) / w;
            numerators[1][k] = double(vertex.uv.y) / w;
            denominator[k] = 1 / w;
        }
        if (std::abs(glm::determinant(system)) < 8)
            continue;
        const glm::dmat3 solve = glm::inverse(system);
        const glm::dvec3 d = solve * denominator;
        for (int pixel = 0; pixel < kSide * kSide; pixel += 7) {
            const int x = pixel % kSide;
            const int y = pixel / kSide;
            const WhyReport report = why(scene, scene.defaults, x, y);
            if (!report.visibleFace)
                continue;
            const TexelFootprint& texels = *report.find(*report.visibleFace)->texels;
            const glm::dvec3 centre(x + 0.5, y + 0.5, 1);
            const double bottom = glm::dot(d, centre);
            glm::dvec2 place;
            glm::dvec2 right;
            glm::dvec2 down;
            for (int axis = 0; axis < 2; ++axis) {
                const glm::dvec3 n = solve * numerators[axis];
                const double top = glm::dot(n, centre);
                place[axis] = 32 * top / bottom;
                right[axis] = 32 * (n.x * bottom - top * d.x) / (bottom * bottom);
                down[axis] = 32 * (n.y * bottom - top * d.y) / (bottom * bottom);
            }
            const double size = 1 + glm::length(place) + glm::length(right) + glm::length(down);
            const std::array<glm::dvec2, 4> exact{place - (right + down) / 2.0, place + (right - down) / 2.0,
                                                  place + (right + down) / 2.0, place + (down - right) / 2.0};
            for (std::size_t i = 0; i < 4; ++i)
                QVERIFY(glm::distance(texels.corners()[i], exact[i]) < 1e-5 * size);
            ++asked;
        }
    }
    QVERIFY(asked > 100);
}

/// What is drawn of the texture: the texels of a level, which hold the place, the corners and what was read of it.
void TestExactTexels::patchesHoldWhatIsDrawn()
{
    for (const double texels : {0.05, 0.7, 3.0, 40.0, 700.0})
        for (const TextureFilter filter : {TextureFilter::Nearest, TextureFilter::Bilinear, TextureFilter::Trilinear}) {
            Scene scene = sceneOf(-0.4, texels / 64, 1, -0.5 * texels / 64, 64);
            scene.defaults.textureFilter = filter;
            const WhyReport report = why(scene, scene.defaults, 5, 6);
            const TexelFootprint& footprint = *report.find(*report.visibleFace)->texels;
            const TexelPatch& patch = footprint.patch;
            QCOMPARE(patch.texels.size(), std::size_t(patch.size.width()) * std::size_t(patch.size.height()));
            QVERIFY(patch.size.width() <= 200 && patch.size.height() <= 200);
            const double scale = double(patch.levelSize.width()) / 64;
            const auto holds = [&](const glm::dvec2& at) {
                return at.x >= patch.column && at.x <= patch.column + patch.size.width() && at.y >= patch.row &&
                       at.y <= patch.row + patch.size.height();
            };
            QVERIFY(holds(footprint.place * scale));
            if (texels < 100)
                for (const glm::dvec2& corner : footprint.corners())
                    QVERIFY(holds(corner * scale));
            for (const TexelRead& read : footprint.reads)
                if (read.level == patch.level) {
                    QVERIFY(holds({read.column, read.row}) && holds({read.column + 1, read.row + 1}));
                    const auto at = static_cast<std::size_t>((read.row - patch.row) * patch.size.width() + read.column -
                                                             patch.column);
                    QCOMPARE(patch.texels[at], read.color);
                }
            QCOMPARE(footprint.filter, filter);
        }
    // The level alone is shown: nothing is read.
    Scene scene = sceneOf(0, 2.0 / 64, 0, 0, 64);
    scene.defaults.shading = Shading::MipLevel;
    const WhyReport report = why(scene, scene.defaults, 3, 3);
    const TexelFootprint& footprint = *report.find(*report.visibleFace)->texels;
    QVERIFY(footprint.reads.empty() && !footprint.patch.texels.empty());
}

void TestExactTexels::levelsAreShownInColours()
{
    for (const int level : {0, 1, 2, 5}) {
        const Scene scene = sceneOf(0, double(1 << level) / 64, 0, 0, 64);
        Settings settings = scene.defaults;
        settings.shading = Shading::MipLevel;
        for (const Algorithm algorithm : {Algorithm::EdgeEquation, Algorithm::EdgeWalking}) {
            settings.algorithm = algorithm;
            Frame frame;
            render(scene, settings, frame);
            QCOMPARE(frame.image.pixel(3, 4), packColor(levelColor(float(level))));
            QCOMPARE(frame.image.pixel(15, 15), frame.image.pixel(3, 4));
        }
        settings.algorithm = Algorithm::Tiled;
        const auto reason = unsupported(scene, settings);
        QVERIFY(reason && textOf(*reason).contains(QLatin1String("mip-level")));
    }
    QVERIFY(levelColor(0.5F) != levelColor(0) && levelColor(0.5F) != levelColor(1));
    QVERIFY(levelColor(8) == levelColor(20) && levelColor(-1) == levelColor(0));
}

QTEST_APPLESS_MAIN(TestExactTexels)
#include "test_exact_texels.moc"
