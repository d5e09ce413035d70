// Depth and colour by the exact reference against answers known by hand, and the rounding of long numbers to doubles.
#include "core/truth/exact_geometry.h"
#include "tests/exact_support.h"
#include "tests/support.h"

#include <QTest>

#include <bit>
#include <cmath>
#include <limits>

using namespace rasterlens;
using namespace rasterlens::test;

class TestExactDepth : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void longNumbersRoundToNearest();
    void perspectiveColorByHand();
    void depthByHand();
    void depthTests();
    void depthsThatDoublesCannotTellApart();
    void unormCodes();
    void d3dRange();
    void samplesOfAPixel();
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

void TestExactDepth::longNumbersRoundToNearest()
{
    using boost::multiprecision::cpp_rational;
    Random random = seededRandom();
    // Random bits, and some that lie exactly between two doubles or one beside.
    const auto longNumber = [&](int bits) {
        exact::Integer value = 1;
        const bool nearTie = integer(random, 0, 2) == 0;
        for (int i = 1; i < bits; ++i)
            value = 2 * value + (nearTie && i > 52 ? (i == 53 ? 1 : 0) : integer(random, 0, 1));
        value += nearTie ? integer(random, -1, 1) : 0;
        return integer(random, 0, 1) == 0 ? value : exact::Integer(-value);
    };
    const auto rational = [](const exact::Integer& value) {
        return cpp_rational(boost::multiprecision::cpp_int(value));
    };
    for (int i = 0; i < casesOfBuild(20'000); ++i) {
        const exact::Integer top = longNumber(integer(random, 60, i % 2 == 0 ? 70 : 700));
        const exact::Integer bottom = longNumber(integer(random, 60, i % 2 == 0 ? 70 : 700));
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

void TestExactDepth::perspectiveColorByHand()
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

void TestExactDepth::depthByHand()
{
    Faces faces; // z = x on the screen: depth is (column + 1/2) / 8
    faces.clip({-1, -1, -1, 1}, {1, -1, 1, 1}, {1, 1, 1, 1}).clip({-1, -1, -1, 1}, {1, 1, 1, 1}, {-1, 1, -1, 1});
    for (const bool snap : {true, false}) {
        const ExactFrame frame = faces.draw(snap);
        for (std::size_t i = 0; i < 64; ++i)
            QCOMPARE(frame.depth[i], (static_cast<double>(i % 8) + 0.5) / 8);
    }
}

void TestExactDepth::depthTests()
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
    QCOMPARE(winner(DepthCompare::Equal, 1, {0.5, 1, 0.25}), 1);
    QCOMPARE(winner(DepthCompare::NotEqual, 1, {1, 0.5, 0.5}), 1);
    QCOMPARE(winner(DepthCompare::Less, 1, {1}), -1); // depth 1 is not less than the cleared 1
    QCOMPARE(winner(DepthCompare::LessEqual, 1, {1}), 0);
    QCOMPARE(winner(DepthCompare::Less, 1, {-1}), 0);
}

void TestExactDepth::depthsThatDoublesCannotTellApart()
{
    const auto plane = [](Faces& faces, double z) { faces.clip({-1, -1, z, 1}, {3, -1, z, 1}, {-1, 3, z, 1}); };
    Faces faces;
    plane(faces, 0);
    plane(faces, -0x1p-149);
    plane(faces, 0x1p-149);
    for (const bool snap : {true, false})
        QCOMPARE(faces.draw(snap).id[27], 1);
}

void TestExactDepth::unormCodes()
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

void TestExactDepth::d3dRange()
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

void TestExactDepth::samplesOfAPixel()
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

QTEST_APPLESS_MAIN(TestExactDepth)
#include "test_exact_depth.moc"
