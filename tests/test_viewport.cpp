// The viewport: snapping against exact integers, the formulas of the conventions, and what happens to absurd input.
#include "core/pipeline/viewport.h"
#include "tests/support.h"

#include <QTest>
#include <boost/multiprecision/cpp_int.hpp>

#include <limits>

using namespace rasterlens;
using namespace rasterlens::test;
using boost::multiprecision::cpp_int;

namespace
{

constexpr double kFarthestPixel = 1 << 19;

/// The float as a multiple of 2^-149.
cpp_int exactly(float value)
{
    int exponent = 0;
    const float mantissa = std::frexp(value, &exponent);
    const auto digits = static_cast<std::int64_t>(std::ldexp(mantissa, 24));
    const int shift = exponent - 24 + 149;
    return shift >= 0 ? cpp_int(digits) << static_cast<unsigned>(shift)
                      : cpp_int(digits) >> static_cast<unsigned>(-shift);
}

struct Rounded {
    double value;
    bool tie;
};

/// (p/w * 0.5 + 0.5) * size in units of 1/2^bits, rounded half to even in exact arithmetic, held at the limit.
Rounded roundExactly(float p, float w, int size, int bits)
{
    cpp_int numerator = (exactly(p) + exactly(w)) * size * (1 << bits);
    cpp_int denominator = 2 * exactly(w);
    if (denominator < 0) {
        numerator = -numerator;
        denominator = -denominator;
    }
    cpp_int quotient = numerator / denominator;
    cpp_int rest = numerator % denominator;
    if (rest < 0) {
        rest += denominator;
        quotient -= 1;
    }
    const bool tie = 2 * rest == denominator;
    if (2 * rest > denominator || (tie && quotient % 2 != 0))
        quotient += 1;
    const double limit = kFarthestPixel * (1 << bits);
    return {std::clamp(static_cast<double>(quotient), -limit, limit), tie};
}

} // namespace

class TestViewport : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void snapsToTheNearestHalfToEven();
    void followsTheFormulas();
    void keepsAbsurdPositionsInBounds();
};

void TestViewport::snapsToTheNearestHalfToEven()
{
    Random random = seededRandom();
    int ties = 0;
    int negative = 0;
    int denormal = 0;
    for (int i = 0; i < 200000; ++i) {
        int size = integer(random, 1, kMaxViewport);
        int bits = integer(random, 0, 8);
        float w = static_cast<float>(std::exp2(uniform(random, -20, 20)) * (integer(random, 0, 3) == 0 ? -1 : 1));
        float p = static_cast<float>(w * uniform(random, -3, 3));
        switch (i % 4) {
        case 0: // any two numbers
            p = anyFloat(random);
            w = anyFloat(random);
            break;
        case 1: // on a tie, or one unit in the last place beside it
            size = 1 << integer(random, 0, 14);
            w = static_cast<float>(integer(random, -7, 7));
            p = static_cast<float>(w * ((2 * integer(random, -64, 2 * size) + 1.0) / (size << bits) - 1));
            if (integer(random, 0, 2) == 0)
                p = std::nextafter(p, integer(random, 0, 1) == 0 ? -1e30F : 1e30F);
            break;
        case 2: // denormals
            p = std::ldexp(static_cast<float>(integer(random, -5000, 5000)), -149);
            w = std::ldexp(static_cast<float>(integer(random, -5000, 5000)), -149);
            break;
        default: break;
        }
        if (!std::isfinite(p) || !std::isfinite(w) || w == 0)
            continue;
        const Rounded expected = roundExactly(p, w, size, bits);
        ties += expected.tie;
        negative += w < 0;
        denormal += std::fpclassify(w) == FP_SUBNORMAL;
        const double found = snapToGrid(double(p), double(w), size, bits);
        QVERIFY2(found == expected.value, qPrintable(QStringLiteral("p %1 w %2 size %3 bits %4: %5, not %6")
                                                         .arg(double(p), 0, 'g', 9)
                                                         .arg(double(w), 0, 'g', 9)
                                                         .arg(size)
                                                         .arg(bits)
                                                         .arg(found)
                                                         .arg(expected.value)));
    }
    QVERIFY(ties > 5000);
    QVERIFY(negative > 20000);
    QVERIFY(denormal > 20000);
}

void TestViewport::followsTheFormulas()
{
    Random random = seededRandom();
    for (int i = 0; i < 20000; ++i) {
        Rules rules;
        rules.width = integer(random, 1, kMaxViewport);
        rules.height = integer(random, 1, kMaxViewport);
        rules.sampleGrid = integer(random, 1, 4);
        rules.subpixelBits = integer(random, 0, 8);
        rules.clipZ = integer(random, 0, 1) == 0 ? ClipZ::Gl : ClipZ::D3d;
        rules.numberType = i % 2 == 0 ? NumberType::Fixed : NumberType::Float64;
        ClipVertex vertex{};
        const double w = uniform(random, 0.01, 100);
        vertex.positionClip = {uniform(random, -w, w), uniform(random, -w, w), uniform(random, -w, w), w};
        vertex.varyings[0] = 7;
        const glm::dvec3 ndc = glm::dvec3(vertex.positionClip) / w;
        const glm::dvec2 pixels((ndc.x * 0.5 + 0.5) * rules.width, (0.5 - ndc.y * 0.5) * rules.height);
        const double depth = rules.clipZ == ClipZ::Gl ? ndc.z * 0.5 + 0.5 : ndc.z;

        const ScreenVertex screen = toScreen(vertex, rules);
        const bool snapped = rules.numberType == NumberType::Fixed;
        const double tolerance = snapped ? 0.5001 / (1 << rules.subpixelBits) : 1e-9;
        QVERIFY(std::abs(screen.position.x / rules.sampleGrid - pixels.x) <= tolerance);
        QVERIFY(std::abs(screen.position.y / rules.sampleGrid - pixels.y) <= tolerance);
        const double units = screen.position.x / rules.sampleGrid * (1 << rules.subpixelBits);
        QVERIFY(!snapped || std::abs(units - std::nearbyint(units)) < 1e-6);
        QVERIFY(std::abs(screen.depth - depth) < 1e-15);
        QCOMPARE(screen.invW, 1 / w);
        QCOMPARE(screen.varyings[0], 7.0F);
    }
}

void TestViewport::keepsAbsurdPositionsInBounds()
{
    constexpr double kInf = std::numeric_limits<double>::infinity();
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    QCOMPARE(snapToGrid(1, 0, 100, 8), kFarthestPixel * 256);
    QCOMPARE(snapToGrid(-1, 0, 100, 8), -kFarthestPixel * 256);
    QCOMPARE(snapToGrid(0, 0, 100, 8), 0.0);
    QCOMPARE(snapToGrid(1e30, 1e-30, 100, 0), kFarthestPixel);
    QCOMPARE(snapToGrid(1e30, -1e-30, 100, 0), -kFarthestPixel);
    for (const double p : {0.0, 1.0, -1e300, kInf, -kInf, kNaN})
        for (const double w : {0.0, -0.0, 1e-300, -1.0, kInf, kNaN})
            for (const int bits : {0, 8})
                QVERIFY(std::abs(snapToGrid(p, w, 16384, bits)) <= kFarthestPixel * (1 << bits));
    Rules rules;
    rules.width = rules.height = 64;
    for (const NumberType type : {NumberType::Fixed, NumberType::Float32, NumberType::Float64}) {
        rules.numberType = type;
        for (const double w : {0.0, -1.0, 1e-300, kNaN}) {
            ClipVertex vertex{};
            vertex.positionClip = {1, -1e30, 1, w};
            const ScreenVertex screen = toScreen(vertex, rules);
            QVERIFY(std::abs(screen.position.x) <= kFarthestPixel);
            QVERIFY(std::abs(screen.position.y) <= kFarthestPixel);
        }
    }
}

QTEST_APPLESS_MAIN(TestViewport)
#include "test_viewport.moc"
