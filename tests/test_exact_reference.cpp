// The exact reference against answers known by hand, against itself, and against the shared results.
#include "core/io/case_file.h"
#include "core/truth/edge_distance.h"
#include "core/truth/exact_geometry.h"
#include "core/truth/exact_reference.h"
#include "tests/support.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTest>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <random>

using namespace rasterlens;

namespace
{

/// The numbers of a NumPy file of a known type.
template <typename T>
std::vector<T> npyValues(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return {};
    const QByteArray bytes = file.readAll();
    const qsizetype header = 10 + static_cast<unsigned char>(bytes[8]) + 256 * static_cast<unsigned char>(bytes[9]);
    std::vector<T> values(static_cast<std::size_t>(bytes.size() - header) / sizeof(T));
    std::memcpy(values.data(), bytes.constData() + header, values.size() * sizeof(T));
    return values;
}

ClipVertex clipVertex(glm::dvec4 position, glm::vec3 color = {1, 1, 1})
{
    ClipVertex vertex{};
    vertex.positionClip = position;
    vertex.varyings[0] = color.r;
    vertex.varyings[1] = color.g;
    vertex.varyings[2] = color.b;
    return vertex;
}

/// Builds faces from pixel positions of an 8 x 8 viewport, where every 1/256 px is a float.
class Faces
{
public:
    explicit Faces(int size = 8) : m_size(size) {}

    Faces& pixels(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) { return clip(at(a), at(b), at(c)); }
    Faces& clip(glm::dvec4 a, glm::dvec4 b, glm::dvec4 c)
    {
        m_triangles.push_back(
            {{clipVertex(a), clipVertex(b), clipVertex(c)}, static_cast<std::uint32_t>(m_triangles.size())});
        return *this;
    }
    [[nodiscard]] glm::dvec4 at(glm::dvec2 p) const { return {2 * p.x / m_size - 1, 1 - 2 * p.y / m_size, 0, 1}; }
    [[nodiscard]] const std::vector<ClipTriangle>& list() const { return m_triangles; }
    [[nodiscard]] ExactOptions options(bool snap = true) const
    {
        ExactOptions options;
        options.size = {m_size, m_size};
        options.snap = snap;
        return options;
    }
    [[nodiscard]] ExactFrame draw(bool snap = true) const { return exactReference(m_triangles, options(snap)); }

private:
    int m_size;
    std::vector<ClipTriangle> m_triangles;
};

std::uint32_t totalCover(const ExactFrame& frame)
{
    return std::accumulate(frame.cover.begin(), frame.cover.end(), 0U);
}

bool everySampleOnce(const ExactFrame& frame)
{
    return std::all_of(frame.cover.begin(), frame.cover.end(), [](std::uint32_t n) { return n == 1; });
}

/// A grid of quads over the viewport, and beyond it by `reach`, with jittered inner corners and random diagonals.
std::vector<ClipTriangle> randomMesh(std::mt19937& random, int cells, double reach, double minW, double maxW)
{
    std::uniform_real_distribution<double> jitter(-0.35, 0.35);
    std::uniform_real_distribution<double> w(minW, maxW);
    const int side = cells + 1;
    std::vector<ClipVertex> corners;
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
            const bool inner = i > 0 && j > 0 && i < cells && j < cells;
            const auto place = [&](int k) {
                return static_cast<double>(
                    static_cast<float>(reach * (2 * (k + (inner ? jitter(random) : 0)) / cells - 1)));
            };
            const double weight = static_cast<double>(static_cast<float>(w(random)));
            const double x = place(i);
            const double y = place(j);
            corners.push_back(clipVertex({x * weight, y * weight, 0, weight}));
        }
    std::vector<ClipTriangle> triangles;
    const auto add = [&](int a, int b, int c) {
        const auto corner = [&](int i) { return corners[static_cast<std::size_t>(i)]; };
        triangles.push_back({{corner(a), corner(b), corner(c)}, static_cast<std::uint32_t>(triangles.size())});
    };
    for (int j = 0; j < cells; ++j)
        for (int i = 0; i < cells; ++i) {
            const int a = j * side + i;
            const int b = a + 1;
            const int c = a + side + 1;
            const int d = a + side;
            if (random() % 2 == 0) {
                add(a, b, c);
                add(d, c, a); // the other winding
            } else {
                add(a, b, d);
                add(b, c, d);
            }
        }
    return triangles;
}

} // namespace

class TestExactReference : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void longNumbersRoundToNearest();
    void diagonalBelongsToOneFace();
    void quadWithEdgesOnCentres();
    void coverageIsThatOfTheDisplacedSample();
    void halfStepsRoundToEven();
    void fewerSubpixelBitsSnapFurther();
    void zeroAreaDrawsNothing();
    void areaMayVanishOnSnapping();
    void negativeWIsNotMirrored();
    void cornerAtTheEyeIsEdgeOn();
    void nonFiniteFacesAreCounted();
    void cullingFollowsTheSnappedArea();
    void perspectiveColorByHand();
    void depthByHand();
    void depthTests();
    void depthsThatDoublesCannotTellApart();
    void unormCodes();
    void d3dRange();
    void samplesOfAPixel();
    void windowIsACut();
    void scalingChangesNothing();
    void meshesPartitionTheViewport();
    void clippedEqualsUnclippedCoverage();
    void edgeDistanceByHand();
    void sharedCases_data();
    void sharedCases();
};

/// A double is nearest to a number if its two neighbours are no nearer; of two equally near the even one is right.
bool isNearest(double rounded, const boost::multiprecision::cpp_rational& number)
{
    using boost::multiprecision::cpp_rational;
    const cpp_rational error = abs(cpp_rational(rounded) - number);
    for (const double side : {-1.0, 1.0}) {
        const double next = std::nextafter(rounded, side * std::numeric_limits<double>::infinity());
        const cpp_rational other = abs(cpp_rational(next) - number);
        const bool isEven = std::bit_cast<std::uint64_t>(rounded) % 2 == 0;
        if (other < error || (other == error && !isEven))
            return false;
    }
    return true;
}

void TestExactReference::longNumbersRoundToNearest()
{
    using boost::multiprecision::cpp_rational;
    test::Random random = test::seededRandom();
    // Random bits, and some that lie exactly between two doubles or one beside.
    const auto longNumber = [&](int bits) {
        exact::Integer value = 1;
        const bool nearTie = test::integer(random, 0, 2) == 0;
        for (int i = 1; i < bits; ++i)
            value = 2 * value + (nearTie && i > 52 ? (i == 53 ? 1 : 0) : test::integer(random, 0, 1));
        value += nearTie ? test::integer(random, -1, 1) : 0;
        return test::integer(random, 0, 1) == 0 ? value : exact::Integer(-value);
    };
    const auto rational = [](const exact::Integer& value) {
        return cpp_rational(boost::multiprecision::cpp_int(value));
    };
    for (int i = 0; i < test::casesOfBuild(20'000); ++i) {
        const exact::Integer top = longNumber(test::integer(random, 60, i % 2 == 0 ? 70 : 700));
        const exact::Integer bottom = longNumber(test::integer(random, 60, i % 2 == 0 ? 70 : 700));
        const Scaled scaled = nearestScaled(top);
        const exact::Integer unit = exact::Integer(1) << static_cast<unsigned>(scaled.exponent);
        QVERIFY2(isNearest(scaled.mantissa, rational(top) / rational(unit)), qPrintable(QString::number(i)));
        QVERIFY2(isNearest(nearestQuotient(top, bottom), rational(top) / rational(bottom)),
                 qPrintable(QString::number(i)));
        QCOMPARE(nearestQuotient(top, exact::Integer(1)), static_cast<double>(rational(top)));
    }
    QCOMPARE(nearestQuotient(exact::Integer(0), exact::Integer(-3)), 0.0);
    QCOMPARE(nearestScaled(exact::Integer(0)).mantissa, 0.0);
}

void TestExactReference::diagonalBelongsToOneFace()
{
    Faces faces;
    faces.pixels({0, 0}, {0, 8}, {8, 8}).pixels({0, 0}, {8, 8}, {8, 0});
    for (const bool snap : {true, false}) {
        const ExactFrame frame = faces.draw(snap);
        QVERIFY(everySampleOnce(frame));
        // the diagonal runs through the centres and is a left edge of the upper right face
        QCOMPARE(std::count(frame.id.begin(), frame.id.end(), 1), 36);
        QCOMPARE(frame.id[3 * 8 + 3], 1);
    }
}

void TestExactReference::quadWithEdgesOnCentres()
{
    Faces faces;
    faces.pixels({1.5, 1.5}, {1.5, 6.5}, {6.5, 6.5}).pixels({1.5, 1.5}, {6.5, 6.5}, {6.5, 1.5});
    for (const bool snap : {true, false}) {
        const ExactFrame frame = faces.draw(snap);
        for (std::size_t y = 0; y < 8; ++y)
            for (std::size_t x = 0; x < 8; ++x)
                QCOMPARE(frame.cover[y * 8 + x], x >= 1 && x <= 5 && y >= 1 && y <= 5 ? 1U : 0U);
    }
}

void TestExactReference::coverageIsThatOfTheDisplacedSample()
{
    // corners on all the half pixels there are: every tie rule is exercised, and a displacement too small to meet
    // anything but the ties must not change a thing
    const quint32 seed = 20240611;
    qInfo("seed %u", seed);
    std::mt19937 random(seed);
    const auto place = [&] { return static_cast<double>(random() % 15 + 1) / 2; };
    for (int i = 0; i < 2000; ++i) {
        const glm::dvec2 a(place(), place());
        const glm::dvec2 b(place(), place());
        const glm::dvec2 c(place(), place());
        const glm::dvec2 shift(-0x1p-10, -0x1p-20);
        const ExactFrame tied = Faces().pixels(a, b, c).draw(true);
        const ExactFrame exact = Faces().pixels(a, b, c).draw(false);
        const ExactFrame shifted = Faces().pixels(a + shift, b + shift, c + shift).draw(false);
        QCOMPARE(tied.cover, exact.cover);
        QCOMPARE(tied.cover, shifted.cover);
    }
}

void TestExactReference::halfStepsRoundToEven()
{
    // a quad whose left edge is `units` 512ths of a pixel right of the centre of column 2
    const auto covered = [](double units) {
        const double x = 2.5 + units / 512;
        return Faces().pixels({x, 0}, {x, 8}, {6, 8}).pixels({x, 0}, {6, 8}, {6, 0}).draw().cover[2] == 1;
    };
    QVERIFY(covered(-1)); // rounds up to the centre
    QVERIFY(covered(0));
    QVERIFY(covered(1)); // rounds down to the centre
    QVERIFY(!covered(2));
    QVERIFY(!covered(3)); // rounds up to the second unit
}

void TestExactReference::fewerSubpixelBitsSnapFurther()
{
    Faces faces;
    faces.pixels({1.5, 1.5}, {1.5, 6.5}, {6.5, 6.5}).pixels({1.5, 1.5}, {6.5, 6.5}, {6.5, 1.5});
    ExactOptions options = faces.options();
    options.subpixelBits = 0; // 1.5 rounds to 2, 6.5 to 6
    const ExactFrame frame = exactReference(faces.list(), options);
    QCOMPARE(totalCover(frame), 16U);
    QCOMPARE(frame.cover[2 * 8 + 2], 1U);
    QCOMPARE(frame.cover[1 * 8 + 1], 0U);
    options.subpixelBits = 1;
    QCOMPARE(totalCover(exactReference(faces.list(), options)), 25U);
}

void TestExactReference::zeroAreaDrawsNothing()
{
    Faces faces;
    faces.pixels({0.5, 0.5}, {3.5, 3.5}, {7.5, 7.5}).pixels({2.5, 2.5}, {2.5, 2.5}, {6.5, 2.5});
    for (const bool snap : {true, false}) {
        const ExactFrame frame = faces.draw(snap);
        QCOMPARE(totalCover(frame), 0U);
        QCOMPARE(frame.degenerate, 2);
    }
}

void TestExactReference::areaMayVanishOnSnapping()
{
    const double d = 1.0 / 1024;
    Faces faces;
    faces.pixels({4.5 - d, 4.5 - d}, {4.5 - d, 4.5 + d}, {4.5 + 2 * d, 4.5});
    QCOMPARE(totalCover(faces.draw(true)), 0U);
    QCOMPARE(faces.draw(true).degenerate, 1);
    QCOMPARE(totalCover(faces.draw(false)), 1U);
}

void TestExactReference::negativeWIsNotMirrored()
{
    Faces faces;
    faces.clip({-0.5, -0.5, 0.25, 1}, {0.5, -0.5, 0.25, 1}, {0, 1.5, 0.25, -1});
    const ExactFrame snapped = faces.draw(true);
    const ExactFrame exact = faces.draw(false);
    QCOMPARE(snapped.cover, exact.cover);
    // the face opens upwards from its visible edge; the divide alone would put the third corner below it
    QCOMPARE(snapped.cover[2 * 8 + 4], 1U);
    QCOMPARE(snapped.cover[7 * 8 + 4], 0U);

    Faces behind;
    behind.clip({-0.5, -0.5, 0, -1}, {0.5, -0.5, 0, -1}, {0, 0.5, 0, -1});
    QCOMPARE(totalCover(behind.draw(true)), 0U);
    QCOMPARE(totalCover(behind.draw(false)), 0U);
}

void TestExactReference::cornerAtTheEyeIsEdgeOn()
{
    Faces faces;
    faces.clip({0, 0, 0, 0}, {0.5, -0.5, 0, 1}, {0, 0.5, 0, 1});
    for (const bool snap : {true, false}) {
        QCOMPARE(totalCover(faces.draw(snap)), 0U);
        QCOMPARE(faces.draw(snap).degenerate, 1);
    }
}

void TestExactReference::nonFiniteFacesAreCounted()
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double inf = std::numeric_limits<double>::infinity();
    Faces faces;
    faces.clip({nan, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}).clip({0, 0, 0, inf}, {1, 0, 0, 1}, {0, 1, 0, 1});
    faces.pixels({0, 0}, {0, 8}, {8, 8});
    const ExactFrame frame = faces.draw();
    QCOMPARE(frame.nonFinite, 2);
    QCOMPARE(totalCover(frame), 28U);
    QCOMPARE(frame.id[7 * 8], 2);
}

void TestExactReference::cullingFollowsTheSnappedArea()
{
    Faces faces; // y up: the first runs counter-clockwise
    faces.pixels({0, 0}, {0, 8}, {8, 8}).pixels({0, 0}, {8, 0}, {8, 8});
    for (const bool snap : {true, false}) {
        ExactOptions options = faces.options(snap);
        options.culling = Culling::Back;
        ExactFrame frame = exactReference(faces.list(), options);
        QCOMPARE(frame.culled, 1);
        QCOMPARE(std::count(frame.id.begin(), frame.id.end(), 0), 28);
        QCOMPARE(std::count(frame.id.begin(), frame.id.end(), 1), 0);
        options.winding = Winding::Clockwise;
        frame = exactReference(faces.list(), options);
        QCOMPARE(std::count(frame.id.begin(), frame.id.end(), 1), 36);
    }
    // 1/1024 px to one side before snapping, 1/256 px to the other after it
    Faces thin;
    thin.pixels({0.5, 3.5}, {7.5, 3.5}, {4, 3.5 + 1.0 / 1024});
    QCOMPARE(thin.draw(true).degenerate, 1);
    QCOMPARE(thin.draw(false).degenerate, 0);
}

void TestExactReference::perspectiveColorByHand()
{
    // A floor from w = 1 at the lower border to w = 3 at the upper one, red 0 to 1. In row y the screen fraction from
    // the bottom is t = 1 - (y + 1/2) / 8 and red is (t / 3) / (t / 3 + (1 - t)).
    const auto corner = [](double x, double y, double w, float red) {
        return clipVertex({x * w, y * w, 0, w}, {red, 0.25F, 0});
    };
    const std::vector<ClipTriangle> floor{{{corner(-1, -1, 1, 0), corner(1, -1, 1, 0), corner(1, 1, 3, 1)}, 0},
                                          {{corner(-1, -1, 1, 0), corner(1, 1, 3, 1), corner(-1, 1, 3, 1)}, 1}};
    for (const bool snap : {true, false}) {
        ExactOptions options = Faces().options(snap);
        const ExactFrame frame = exactReference(floor, options);
        for (std::size_t y = 0; y < 8; ++y)
            for (std::size_t x = 0; x < 8; ++x) {
                const double t = 1 - (static_cast<double>(y) + 0.5) / 8;
                const double red = t / 3 / (t / 3 + 1 - t);
                QVERIFY(std::abs(frame.color[y * 8 + x].r - red) < 1e-15);
                QVERIFY(std::abs(frame.color[y * 8 + x].g - 0.25) < 1e-15);
            }
    }
}

void TestExactReference::depthByHand()
{
    Faces faces; // z = x on the screen: depth is (column + 1/2) / 8
    faces.clip({-1, -1, -1, 1}, {1, -1, 1, 1}, {1, 1, 1, 1}).clip({-1, -1, -1, 1}, {1, 1, 1, 1}, {-1, 1, -1, 1});
    for (const bool snap : {true, false}) {
        const ExactFrame frame = faces.draw(snap);
        for (std::size_t i = 0; i < 64; ++i)
            QCOMPARE(frame.depth[i], (static_cast<double>(i % 8) + 0.5) / 8);
    }
}

void TestExactReference::depthTests()
{
    const auto winner = [](DepthCompare compare, double clear, std::initializer_list<double> depths) {
        Faces faces;
        for (const double z : depths)
            faces.clip({-1, -1, z, 1}, {3, -1, z, 1}, {-1, 3, z, 1});
        ExactOptions options = faces.options();
        options.depthCompare = compare;
        options.depthClear = clear;
        return exactReference(faces.list(), options).id[27];
    };
    QCOMPARE(winner(DepthCompare::Less, 1, {0.5, 0.25, 0.25, 0.75}), 1);
    QCOMPARE(winner(DepthCompare::LessEqual, 1, {0.5, 0.25, 0.25, 0.75}), 2);
    QCOMPARE(winner(DepthCompare::Greater, 0, {0.5, 0.75, 0.75, 0.25}), 1);
    QCOMPARE(winner(DepthCompare::GreaterEqual, 0, {0.5, 0.75, 0.75, 0.25}), 2);
    QCOMPARE(winner(DepthCompare::Always, 1, {0.5, 0.25, 0.75}), 2);
    QCOMPARE(winner(DepthCompare::Less, 1, {1}), -1); // depth 1 is not less than the cleared 1
    QCOMPARE(winner(DepthCompare::LessEqual, 1, {1}), 0);
    QCOMPARE(winner(DepthCompare::Less, 1, {-1}), 0);
}

void TestExactReference::depthsThatDoublesCannotTellApart()
{
    const auto plane = [](Faces& faces, double z) { faces.clip({-1, -1, z, 1}, {3, -1, z, 1}, {-1, 3, z, 1}); };
    Faces faces;
    plane(faces, 0);
    plane(faces, -0x1p-149);
    plane(faces, 0x1p-149);
    for (const bool snap : {true, false})
        QCOMPARE(faces.draw(snap).id[27], 1);
}

void TestExactReference::unormCodes()
{
    const auto frameOf = [](double z, DepthFormat format) {
        Faces faces;
        faces.clip({-1, -1, z, 1}, {3, -1, z, 1}, {-1, 3, z, 1});
        ExactOptions options = faces.options();
        options.depthFormat = format;
        return exactReference(faces.list(), options);
    };
    // depth 1/2 lies exactly between two codes and takes the even one
    QCOMPARE(frameOf(0, DepthFormat::Unorm16).depth[27], 32768.0 / 65535);
    QCOMPARE(frameOf(0, DepthFormat::Unorm24).depth[27], 8388608.0 / 16777215);
    QCOMPARE(frameOf(-0x1p-40, DepthFormat::Unorm16).depth[27], 32767.0 / 65535);
}

void TestExactReference::d3dRange()
{
    Faces faces;
    faces.clip({-1, -1, 0, 1}, {3, -1, 0, 1}, {-1, 3, 0, 1})
        .clip({-1, -1, -0.25, 1}, {3, -1, -0.25, 1}, {-1, 3, -0.25, 1});
    for (const bool snap : {true, false}) {
        ExactOptions options = faces.options(snap);
        options.clipZ = ClipZ::D3d;
        const ExactFrame frame = exactReference(faces.list(), options);
        QVERIFY(everySampleOnce(frame));
        QCOMPARE(frame.depth[27], 0.0);
        QCOMPARE(frame.id[27], 0);
    }
}

void TestExactReference::samplesOfAPixel()
{
    Faces faces;
    faces.pixels({0, 0}, {0, 8}, {8, 8});
    for (const bool snap : {true, false})
        for (int grid = 1; grid <= 4; ++grid) {
            ExactOptions options = faces.options(snap);
            options.sampleGrid = grid;
            const ExactFrame frame = exactReference(faces.list(), options);
            const int side = 8 * grid;
            QCOMPARE(frame.width, side);
            // the diagonal through the sample centres belongs to the face above it
            QCOMPARE(totalCover(frame), static_cast<std::uint32_t>(side * (side - 1) / 2));
            const double share = frame.pixelColor(3, 3, {0, 0, 0}).r;
            QCOMPARE(share, (grid - 1) / (2.0 * grid));
        }
}

void TestExactReference::windowIsACut()
{
    const quint32 seed = 7;
    qInfo("seed %u", seed);
    std::mt19937 random(seed);
    const std::vector<ClipTriangle> mesh = randomMesh(random, 6, 1.5, 0.5, 4);
    for (const bool snap : {true, false}) {
        ExactOptions options = Faces(64).options(snap);
        const ExactFrame whole = exactReference(mesh, options);
        options.window = PixelRect{17, 23, 30, 11};
        const ExactFrame cut = exactReference(mesh, options);
        for (std::size_t y = 0; y < 11; ++y)
            for (std::size_t x = 0; x < 30; ++x) {
                const std::size_t i = (y + 23) * 64 + x + 17;
                QCOMPARE(cut.cover[y * 30 + x], whole.cover[i]);
                QCOMPARE(cut.id[y * 30 + x], whole.id[i]);
                QVERIFY(std::abs(cut.depth[y * 30 + x] - whole.depth[i]) < 1e-15);
            }
    }
}

void TestExactReference::scalingChangesNothing()
{
    const auto scaled = [](double s) {
        const glm::dvec4 a(-0.75, -0.5, 0.25, 1);
        const glm::dvec4 b(1.5, -1, 0.5, 2);
        const glm::dvec4 c(0.25, 0.875, -0.5, 1);
        return Faces(32).clip(s * a, s * b, s * c);
    };
    for (const bool snap : {true, false}) {
        const ExactFrame one = scaled(1).draw(snap);
        QVERIFY(totalCover(one) > 100);
        for (const double s : {0x1p-126, 0x1p100, 0x1p-1000, 0x1p900}) {
            const ExactFrame other = scaled(s).draw(snap);
            QCOMPARE(other.cover, one.cover);
            QCOMPARE(other.depth, one.depth);
        }
    }
}

void TestExactReference::meshesPartitionTheViewport()
{
    const quint32 seed = 4711;
    qInfo("seed %u", seed);
    std::mt19937 random(seed);
    for (int round = 0; round < 20; ++round)
        for (const double reach : {1.0, 2.5, 1e4}) {
            const std::vector<ClipTriangle> mesh = randomMesh(random, 9, reach, 0.25, 4);
            ExactOptions options = Faces(61).options(round % 2 == 0);
            options.subpixelBits = round % 9;
            options.sampleGrid = round % 4 + 1;
            const ExactFrame frame = exactReference(mesh, options);
            // a coarse grid may fold a mesh over, but never tear it
            QVERIFY(std::all_of(frame.cover.begin(), frame.cover.end(), [](std::uint32_t n) { return n >= 1; }));
            if (!options.snap || (options.subpixelBits > 4 && reach < 10))
                QVERIFY(everySampleOnce(frame));
        }
}

void TestExactReference::clippedEqualsUnclippedCoverage()
{
    // two methods that share no line: with snapping a face is clipped, without it is not. They may differ only where
    // the snap moved an edge.
    const quint32 seed = 815;
    qInfo("seed %u", seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(-3, 3);
    std::uniform_real_distribution<double> depth(-1.5, 1.5);
    std::uniform_real_distribution<double> weight(-1, 2);
    int compared = 0;
    for (int i = 0; i < 1000; ++i) {
        Faces faces(64);
        const auto corner = [&] { return glm::dvec4(place(random), place(random), depth(random), weight(random)); };
        faces.clip(corner(), corner(), corner());
        ExactOptions options = faces.options(true);
        options.edgeDistance = true;
        const ExactFrame snapped = exactReference(faces.list(), options);
        const ExactFrame exact = faces.draw(false);
        for (std::size_t k = 0; k < exact.cover.size(); ++k)
            if (snapped.edgeDistance[k] > 0.005F) {
                QCOMPARE(snapped.cover[k], exact.cover[k]);
                compared += exact.cover[k] > 0;
            }
    }
    QVERIFY2(compared > 10000, qPrintable(QString::number(compared)));
}

void TestExactReference::edgeDistanceByHand()
{
    Faces faces;
    faces.pixels({2, 2}, {2, 6}, {6, 2});
    ExactOptions options = faces.options();
    options.edgeDistance = true;
    const ExactFrame frame = exactReference(faces.list(), options);
    const auto at = [&](std::size_t x, std::size_t y) { return static_cast<double>(frame.edgeDistance[y * 8 + x]); };
    QCOMPARE(at(2, 3), 0.5);
    QVERIFY(std::abs(at(1, 1) - std::sqrt(0.5)) < 1e-6);
    QVERIFY(std::abs(at(4, 4) - std::sqrt(0.5)) < 1e-6);
    QCOMPARE(frame.edgeDistance[63], kFarFromEdges);
}

void TestExactReference::sharedCases_data()
{
    QTest::addColumn<QString>("name");
    const QDir folder(QStringLiteral(RASTERLENS_SHARED "/cases"));
    const QStringList files = folder.entryList({QStringLiteral("*.case")});
    for (const QString& file : files)
        QTest::newRow(qPrintable(file)) << QFileInfo(file).completeBaseName();
    if (files.isEmpty())
        QTest::newRow("none") << QString();
}

void TestExactReference::sharedCases()
{
    QFETCH(QString, name);
    if (name.isEmpty())
        QSKIP("the shared cases are not there");
    const QString folder = QStringLiteral(RASTERLENS_SHARED "/cases/");
    const SceneLoad load = loadCase(folder + name + QStringLiteral(".case"));
    QVERIFY(load.scene);
    const Scene& scene = *load.scene;
    int compared = 0;
    for (const bool snap : {true, false}) {
        const QString prefix =
            folder + QStringLiteral("expected/") + name + (snap ? QString() : QStringLiteral(".exact"));
        const auto cover = npyValues<std::uint32_t>(prefix + QStringLiteral(".cover.npy"));
        if (cover.empty())
            continue;
        ExactOptions options = exactOptions(scene, scene.defaults);
        options.snap = snap && !scene.exact;
        options.edgeDistance = true;
        const ExactFrame frame = exactReference(exactTriangles(scene, scene.defaults), options);
        const auto depth = npyValues<double>(prefix + QStringLiteral(".depth.npy"));
        const auto color = npyValues<double>(prefix + QStringLiteral(".color.npy"));
        const auto edge = npyValues<float>(prefix + QStringLiteral(".edge.npy"));
        QCOMPARE(frame.cover, cover);
        QCOMPARE(frame.id, npyValues<std::int32_t>(prefix + QStringLiteral(".id.npy")));
        for (std::size_t i = 0; i < cover.size(); ++i) {
            QVERIFY(std::abs(depth[i] - frame.depth[i]) <= 1e-12);
            for (int k = 0; k < 3; ++k)
                QVERIFY(std::abs(color[3 * i + static_cast<std::size_t>(k)] - frame.color[i][k]) <= 1e-12);
            if (std::min(edge[i], frame.edgeDistance[i]) < static_cast<float>(kEdgeBandPixels))
                QVERIFY(std::abs(edge[i] - frame.edgeDistance[i]) < 1e-6F);
        }
        ++compared;
    }
    if (compared == 0)
        QSKIP("no expected arrays for this case");
}

QTEST_APPLESS_MAIN(TestExactReference)
#include "test_exact_reference.moc"
