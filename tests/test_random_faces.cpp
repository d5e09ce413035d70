// Fixed-point coverage of random faces against the exact reference: not one sample may differ.
// RASTERLENS_FACES=N draws N faces a size class, RASTERLENS_CORNERS=N as many for each largest coordinate and clipping
// mode; the CTest label `long` runs a million and 60,000.
#include "core/truth/exact_reference.h"
#include "tests/support.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

constexpr QSize kViewport(64, 48);
constexpr int kFacesPerPicture = 50;

/// How large the faces are, in pixels, and whether they leave the view volume.
struct SizeClass {
    const char* name;
    double size;
    bool perspective; ///< corners with different w, some behind the eye: near, far and side planes cut
};

constexpr SizeClass kClasses[] = {{"a pixel", 1, false},   {"some pixels", 6, false},
                                  {"a screen", 60, false}, {"larger than the screen", 2000, false},
                                  {"cut, small", 6, true}, {"cut, large", 80, true}};

glm::vec4 corner(Random& random, const glm::dvec2& middle, const SizeClass& c)
{
    const double x = middle.x + uniform(random, -c.size, c.size);
    const double y = middle.y + uniform(random, -c.size, c.size);
    glm::vec4 p = atPixel(x, y, uniform(random, 0.05, 0.95), kViewport);
    if (c.perspective) {
        const auto w = static_cast<float>(uniform(random, -0.5, 2));
        p = glm::vec4(p.x * w, p.y * w, static_cast<float>(uniform(random, -2, 2)), w);
    }
    return p;
}

Scene randomFaces(Random& random, const SizeClass& c)
{
    std::vector<glm::vec4> corners;
    for (int i = 0; i < kFacesPerPicture; ++i) {
        const glm::dvec2 middle(uniform(random, -4, kViewport.width() + 4),
                                uniform(random, -4, kViewport.height() + 4));
        for (int k = 0; k < 3; ++k)
            corners.push_back(corner(random, middle, c));
    }
    return soup(corners);
}

int numberFromEnvironment(const char* name, int otherwise)
{
    bool good = false;
    const int number = qEnvironmentVariableIntValue(name, &good);
    return good ? number : casesOfBuild(otherwise);
}

int facesPerClass() { return numberFromEnvironment("RASTERLENS_FACES", 2'000); }

/// A coordinate of the kind that shows what rounding does to a clipper: 0, small multiples of 1/4, or as large as M.
float hardCoordinate(Random& random, float largest)
{
    const int kind = integer(random, 0, 7);
    const float sign = integer(random, 0, 1) == 0 ? -1 : 1;
    if (kind == 0)
        return 0;
    return sign * (kind <= 2 ? largest : static_cast<float>(integer(random, 1, 16)) / 4);
}

Scene hardFaces(Random& random, float largest, int faces)
{
    std::vector<glm::vec4> corners;
    for (int i = 0; i < 3 * faces; ++i) {
        glm::vec4 p;
        for (int k = 0; k < 4; ++k)
            p[k] = hardCoordinate(random, largest);
        corners.push_back(p);
    }
    return soup(corners);
}

/// The planes a mode cuts by where they are not those of the view volume.
ExactSides sidesOf(const Settings& settings)
{
    const auto guardBand = [](int pixels) { return 2 * 32768.0 / pixels - 1; };
    switch (settings.clipping) {
    case Clipping::GuardBand: return {guardBand(settings.size.width()), guardBand(settings.size.height()), 0};
    case Clipping::FrustumW: return {1, 1, 1e-5};
    default: return {};
    }
}

/// Draws with every algorithm that can, and says where one of them differs from the truth.
QString wrongSample(const Scene& scene, Settings settings, const ExactFrame& exact)
{
    for (const Algorithm algorithm : algorithmsFor(scene, settings)) {
        settings.algorithm = algorithm;
        const Frame frame = draw(scene, settings);
        const auto width = std::size_t(settings.size.width());
        for (std::size_t at = 0; at < frame.coverage.size(); ++at) {
            const std::size_t sample = exact.sampleNearestCentre(int(at % width), int(at / width));
            if (frame.coverage[at] != exact.cover[sample])
                return QStringLiteral("%1, clipping %2, %3 x %4 pixels, %5 bits, pixel (%6, %7): %8 instead of %9")
                    .arg(QLatin1String(idOf(algorithm)))
                    .arg(int(settings.clipping))
                    .arg(settings.size.width())
                    .arg(settings.size.height())
                    .arg(settings.subpixelBits)
                    .arg(at % width)
                    .arg(at / width)
                    .arg(frame.coverage[at])
                    .arg(exact.cover[sample]);
        }
    }
    return {};
}

} // namespace

class TestRandomFaces : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everySampleIsRight_data();
    void everySampleIsRight();
    void cornersOfAnySize_data();
    void cornersOfAnySize();
    void hardMeshesAreWatertight();
};

void TestRandomFaces::everySampleIsRight_data()
{
    QTest::addColumn<int>("sizeClass");
    QTest::addColumn<bool>("anyBits");
    for (int i = 0; i < int(std::size(kClasses)); ++i) {
        QTest::addRow("%s, 8 bits", kClasses[i].name) << i << false;
        QTest::addRow("%s, 0 to 7 bits", kClasses[i].name) << i << true;
    }
}

void TestRandomFaces::everySampleIsRight()
{
    QFETCH(int, sizeClass);
    QFETCH(bool, anyBits);
    Random random = seededRandom();
    const int pictures = facesPerClass() / kFacesPerPicture;
    std::size_t covered = 0;
    for (int i = 0; i < pictures; ++i) {
        const Scene scene = randomFaces(random, kClasses[sizeClass]);
        Settings settings = plainSettings(kViewport);
        settings.subpixelBits = anyBits ? integer(random, 0, 7) : 8;
        settings.clipping = Clipping::Frustum;
        settings.threads = 1; // the pictures are small
        const ExactFrame exact = exactReference(scene, settings);
        covered += std::accumulate(exact.cover.begin(), exact.cover.end(), std::size_t(0));
        const QString wrong = wrongSample(scene, settings, exact);
        QVERIFY2(wrong.isEmpty(), qPrintable(QStringLiteral("picture %1, %2").arg(i).arg(wrong)));
    }
    QVERIFY(covered > std::size_t(pictures)); // the faces are seen
}

void TestRandomFaces::cornersOfAnySize_data()
{
    QTest::addColumn<float>("largest");
    QTest::addColumn<int>("clipping");
    for (const float largest : {1.0F, 1e5F, 1e7F, 1e8F, 1e10F, 1e15F, 1e20F, 1e30F, 3e38F})
        for (const Clipping mode :
             {Clipping::Frustum, Clipping::FrustumW, Clipping::GuardBand, Clipping::CohenSutherland})
            QTest::addRow("up to %g, clipping %d", double(largest), int(mode)) << largest << int(mode);
}

/// Faces that reach behind the eye and out to the largest float, and vertices that clipping puts exactly on a tie.
void TestRandomFaces::cornersOfAnySize()
{
    QFETCH(float, largest);
    QFETCH(int, clipping);
    constexpr int kFaces = 20;
    Random random = seededRandom();
    const int pictures = numberFromEnvironment("RASTERLENS_CORNERS", 500) / kFaces;
    const std::array sizes{QSize(16, 16), QSize(63, 3), kViewport, QSize(1, 1), QSize(100, 75)};
    std::size_t covered = 0;
    for (int i = 0; i < pictures; ++i) {
        const Scene scene = hardFaces(random, largest, kFaces);
        Settings settings = plainSettings(sizes[std::size_t(i) % sizes.size()]);
        settings.subpixelBits = integer(random, 0, 8);
        settings.clipZ = integer(random, 0, 3) == 0 ? ClipZ::D3d : ClipZ::Gl;
        settings.clipping = static_cast<Clipping>(clipping);
        settings.threads = 1;
        ExactOptions options = exactOptions(scene, settings);
        options.sides = sidesOf(settings);
        const ExactFrame exact = exactReference(exactTriangles(scene, settings), options);
        covered += std::accumulate(exact.cover.begin(), exact.cover.end(), std::size_t(0));
        const QString wrong = wrongSample(scene, settings, exact);
        QVERIFY2(wrong.isEmpty(), qPrintable(QStringLiteral("picture %1, %2").arg(i).arg(wrong)));
    }
    QVERIFY(covered > std::size_t(pictures));
}

/// A rectangle from edge to edge of the view, cut up by rays from a corner inside to far ones: wherever clipping puts
/// the new corners, no pixel may be missed or drawn twice.
void TestRandomFaces::hardMeshesAreWatertight()
{
    Random random = seededRandom();
    for (int round = 0; round < casesOfBuild(200); ++round) {
        const float reach = std::exp2(static_cast<float>(uniform(random, 0, 120)));
        // The rim goes once round a square that holds the view; positions on its sides are any.
        std::vector<glm::vec4> corners{{hardCoordinate(random, 0) / 8, hardCoordinate(random, 0) / 8, 0, 1}};
        const auto n = static_cast<std::uint32_t>(integer(random, 4, 12));
        for (std::uint32_t k = 0; k < n; ++k) {
            const int side = int(4 * k / n);
            const float along = -1 + 2 * (4 * static_cast<float>(k) / static_cast<float>(n) - static_cast<float>(side));
            const std::array<glm::vec2, 4> rim{glm::vec2(along, -1), glm::vec2(1, along), glm::vec2(-along, 1),
                                               glm::vec2(-1, -along)};
            corners.emplace_back(rim[std::size_t(side)] * std::max(reach, 2.0F), 0, 1);
            corners.back() *= std::exp2(static_cast<float>(integer(random, -2, 2))); // another w, the same place
        }
        std::vector<std::uint32_t> indices;
        for (std::uint32_t k = 0; k < n; ++k)
            for (const std::uint32_t corner : {0U, 1 + k, 1 + (k + 1) % n})
                indices.push_back(corner);
        const Scene scene = clipScene(corners, indices);
        for (const Clipping mode :
             {Clipping::Frustum, Clipping::FrustumW, Clipping::GuardBand, Clipping::CohenSutherland}) {
            Settings settings = plainSettings(kViewport);
            settings.clipping = mode;
            settings.subpixelBits = integer(random, 0, 8);
            for (const Algorithm algorithm : algorithmsFor(scene, settings)) {
                settings.algorithm = algorithm;
                const Frame frame = draw(scene, settings);
                const auto odd = std::ranges::count_if(frame.coverage, [](std::uint16_t hits) { return hits != 1; });
                QVERIFY2(odd == 0, qPrintable(QStringLiteral("round %1, %2, clipping %3, reach %4: %5 pixels")
                                                  .arg(round)
                                                  .arg(QLatin1String(idOf(algorithm)))
                                                  .arg(int(mode))
                                                  .arg(double(reach))
                                                  .arg(odd)));
            }
        }
    }
}

QTEST_APPLESS_MAIN(TestRandomFaces)
#include "test_random_faces.moc"
