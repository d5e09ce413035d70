// Derivations: their numbers come out, they are those of the exact answer, and every sentence has its Chinese.
#include "core/derive/derive.h"
#include "core/derive/face_record.h"
#include "core/observe/face_moment.h"
#include "core/observe/names.h"
#include "core/scenes/builtin_scenes.h"
#include "tests/derivation_fixture.h"
#include "tests/derived_numbers.h"
#include "tests/support.h"

#include <QTest>

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

using Rational = boost::multiprecision::cpp_rational;
using Vector = std::array<Rational, 2>;

/// Whether a symbol has a rational number as its value, to the last three bits of a double, and as its exact text if it
/// has one.
bool isRational(const Derivation& derivation, const char* id, const Rational& expected)
{
    const DerivationSymbol& symbol = *derivation.find(id);
    const double value = static_cast<double>(expected);
    const bool isClose =
        std::abs(symbol.value - value) <= 8 * std::numeric_limits<double>::epsilon() * std::max(std::abs(value), 1.0);
    if (!isClose)
        qWarning("%s is %.17g, not %.17g", id, symbol.value, value);
    if (symbol.exact.isEmpty())
        return isClose;
    if (Rational(symbol.exact.toStdString()) != expected)
        qWarning("%s is exactly %s, not %s", id, qPrintable(symbol.exact), expected.str().c_str());
    return isClose && Rational(symbol.exact.toStdString()) == expected;
}

/// The weights of a point by elimination: two equations, the unknown of the larger coefficient first.
std::array<Rational, 3> weightsByElimination(const std::array<Vector, 3>& corners, const Vector& p)
{
    // beta (B - A) + gamma (C - A) = P - A
    std::array<std::array<Rational, 3>, 2> rows;
    for (std::size_t i = 0; i < 2; ++i)
        rows[i] = {corners[1][i] - corners[0][i], corners[2][i] - corners[0][i], p[i] - corners[0][i]};
    if (rows[0][0] == 0)
        std::swap(rows[0], rows[1]);
    const Rational factor = rows[1][0] / rows[0][0];
    for (std::size_t k = 0; k < 3; ++k)
        rows[1][k] -= factor * rows[0][k];
    const Rational gamma = rows[1][2] / rows[1][1];
    const Rational beta = (rows[0][2] - gamma * rows[0][1]) / rows[0][0];
    return {1 - beta - gamma, beta, gamma};
}

/// The area of a triangle by the trapezoids under its sides.
Rational areaByTrapezoids(const Vector& a, const Vector& b, const Vector& c)
{
    const auto under = [](const Vector& p, const Vector& q) -> Rational { return (q[0] - p[0]) * (p[1] + q[1]) / 2; };
    return abs(Rational(under(a, b) + under(b, c) + under(c, a)));
}

} // namespace

class TestDerivations : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void numbersComeOut();
    void edgeFunctionByRationals();
    void edgeFunctionByHand();
    void barycentricByElimination();
    void bresenhamByRounding();
    void bresenhamByHand();
    void perspectiveByRays();
    void fourZByHand();
    void exchangedDistancesMayBeEqual();
    void depthCurveByHand();
    void cutsLieOnTheirPlanes();
    void cohenSutherlandByHand();
    void cutCornersHaveOneName();
    void twoPointAgreesWithPlanes();
    void flatLightByHand();
    void numbersAreWrittenOut();
    void painterByHand();
    void attributesByHand();
};

void TestDerivations::numbersComeOut()
{
    int lines = 0;
    forEachQuestion([&](const Scene& scene, const Settings& settings, const Question& question) {
        const Derived found = derive(question.topic, scene, settings, question.place);
        if (!found.derivation)
            return;
        // Attributes are float32, everything else double.
        const double rounding = question.topic == DerivationTopic::Attribute ? 3e-7 : 1e-11;
        for (const DerivationLine& line : found.derivation->lines) {
            const QString numbers = textOf(line.numbers);
            const std::vector<Printed> values = PrintedFormula(numbers).read();
            QCOMPARE(values.size(), line.values.size());
            for (std::size_t i = 0; i < values.size(); ++i) {
                const double slack = 1.01 * values[i].error + rounding * std::max(values[i].size, 1e-30);
                QVERIFY2(std::abs(values[i].value - line.values[i]) <= slack,
                         qPrintable(QStringLiteral("%1, %2: %3 = %4, but %5 (%6)")
                                        .arg(scene.id, QLatin1String(infoOf(question.topic).id), textOf(line.formula),
                                             numbers, line.result)
                                        .arg(values[i].value, 0, 'g', 17)));
            }
            ++lines;
        }
    });
    QVERIFY2(lines > 3000, qPrintable(QString::number(lines)));
}

void TestDerivations::edgeFunctionByRationals()
{
    // On 600 x 600 with y down A = (100, 400), B = (300, 200), C = (400, 500): clockwise, so set up as A, C, B.
    const Scene scene = builtin("triangle-600");
    const Vector a{100, 400};
    const Vector b{300, 200};
    const Vector c{400, 500};
    const Settings settings = scene.defaults;
    for (const QPoint& pixel : {QPoint(250, 350), QPoint(299, 499), QPoint(120, 390), QPoint(400, 100)}) {
        const Derivation d = derived(DerivationTopic::EdgeFunction, scene, settings, {0, pixel, 2, 0.5, {}});
        const Vector p{Rational(2 * pixel.x() + 1, 2), Rational(2 * pixel.y() + 1, 2)};
        // Twice an area, positive where the corners and P run counter-clockwise with y up.
        const auto twice = [&](const Vector& from, const Vector& to, const Vector& at) -> Rational {
            const Rational area = 2 * areaByTrapezoids(from, to, at);
            const Rational sign = (to[0] - from[0]) * (at[1] - from[1]) - (to[1] - from[1]) * (at[0] - from[0]);
            return sign < 0 ? area : Rational(-area);
        };
        QVERIFY(isRational(d, "E_AC", twice(a, c, p)));
        QVERIFY(isRational(d, "E_CB", twice(c, b, p)));
        QVERIFY(isRational(d, "E_BA", twice(b, a, p)));
        QVERIFY(isRational(d, "F_AC", -twice(a, c, p)));
        QVERIFY(isRational(d, "E_AC_right", twice(a, c, {p[0] + 1, p[1]})));
        QVERIFY(isRational(d, "E_AC_below", twice(a, c, {p[0], p[1] + 1})));
        QVERIFY(isRational(d, "S", 80000));
    }
}

void TestDerivations::edgeFunctionByHand()
{
    // AC = (300, 100): a = 100, b = -300, and c = 400 * 400 - 100 * 500 = 110000. At (100.5, 200.5):
    // 100 * 100.5 - 300 * 200.5 + 110000 = 10050 - 60150 + 110000 = 59900. F is its negative.
    const Scene scene = builtin("triangle-600");
    const Derivation d =
        derived(DerivationTopic::EdgeFunction, scene, scene.defaults, {0, QPoint(100, 200), 2, 0.5, {}});
    QCOMPARE(valueOf(d, "a_AC"), 100.0);
    QCOMPARE(valueOf(d, "b_AC"), -300.0);
    QCOMPARE(valueOf(d, "c_AC"), 110000.0);
    QCOMPARE(valueOf(d, "E_AC"), 59900.0);
    QCOMPARE(valueOf(d, "E_CB"), 59900.0);
    QCOMPARE(valueOf(d, "E_BA"), -39800.0);
    QCOMPARE(valueOf(d, "area2"), -80000.0); // clockwise
    // AC goes down to the right and the inside is right of it: a left edge. CB has the inside on its left.
    QCOMPARE(valueOf(d, "t_AC"), 0.0);
    QCOMPARE(valueOf(d, "t_CB"), 1.0 / 65536);
    // 8 x 8, face 0 is (0, 0), (0, 8), (8, 0). P = (3.5, 4.5) lies on its diagonal: BC = (8, -8), BP = (3.5, -3.5).
    const Scene square = builtin("square-diagonal");
    const Derivation tie =
        derived(DerivationTopic::EdgeFunction, square, square.defaults, {0, QPoint(3, 4), 1, 0.5, {}});
    QCOMPARE(valueOf(tie, "E_BC"), 0.0);
    QCOMPARE(valueOf(tie, "E_AB"), 28.0);
    QCOMPARE(valueOf(tie, "E_CA"), 36.0);
}

void TestDerivations::barycentricByElimination()
{
    const Scene scene = builtin("triangle-600");
    const std::array<Vector, 3> corners{Vector{100, 400}, Vector{300, 200}, Vector{400, 500}};
    for (const QPoint& pixel : {QPoint(250, 350), QPoint(300, 300), QPoint(150, 380), QPoint(380, 470)}) {
        const Derivation d = derived(DerivationTopic::Barycentric, scene, scene.defaults, {0, pixel, 0, 0.5, {}});
        const Vector p{Rational(2 * pixel.x() + 1, 2), Rational(2 * pixel.y() + 1, 2)};
        const std::array<Rational, 3> weights = weightsByElimination(corners, p);
        for (const char* way : {"_1", "_2", "_3", "_4", "_5", ""}) {
            QVERIFY(isRational(d, (std::string("alpha") + way).c_str(), weights[0]));
            QVERIFY(isRational(d, (std::string("beta") + way).c_str(), weights[1]));
            QVERIFY(isRational(d, (std::string("gamma") + way).c_str(), weights[2]));
        }
        QVERIFY(isRational(d, "S_BCP", areaByTrapezoids(corners[1], corners[2], p)));
        QVERIFY(isRational(d, "S_CAP", areaByTrapezoids(corners[2], corners[0], p)));
        QVERIFY(isRational(d, "S_ABP", areaByTrapezoids(corners[0], corners[1], p)));
        QVERIFY(isRational(d, "U_x", Rational(valueOf(d, "D_u"))));
        QVERIFY(isRational(d, "U_y", Rational(valueOf(d, "D_v"))));
        QVERIFY(isRational(d, "U_z", Rational(valueOf(d, "D"))));
        QVERIFY(isRational(d, "N_x", 0));
        QVERIFY(isRational(d, "N_y", 0));
        QVERIFY(valueOf(d, "d") < 1e-15);
    }
}

void TestDerivations::bresenhamByRounding()
{
    // After i steps along the longer axis the line has gone i s / l along the shorter one; the sample taken there is
    // the nearest, and of two equally near ones the first. So k = ceil(i s / l - 1/2) steps aside were taken, and the
    // decision is p_i = 2 s (i + 1) - 2 l k - l.
    const QSize size(32, 32);
    for (const QPoint& way : {QPoint(8, 3), QPoint(3, 8), QPoint(-3, 8), QPoint(-8, 3), QPoint(-8, -3), QPoint(-3, -8),
                              QPoint(3, -8), QPoint(8, -3), QPoint(8, 0), QPoint(0, -8), QPoint(8, 8), QPoint(8, 4)}) {
        const auto at = [&](int x, int y) { return atPixel(x + 0.5, y + 0.5, 0.5, size); };
        const Scene scene = soup({at(16, 16), at(16 + way.x(), 16 + way.y()), at(16 - way.y(), 16 + way.x())});
        const Derivation d = derived(DerivationTopic::Bresenham, scene, plainSettings(size), {});
        const int l = std::max(std::abs(way.x()), std::abs(way.y()));
        const int s = std::min(std::abs(way.x()), std::abs(way.y()));
        QCOMPARE(valueOf(d, "p_-1"), double(-l));
        for (int i = 0; i < l; ++i) {
            const Rational exact = Rational(i * s, l) - Rational(1, 2);
            int k = 0;
            while (Rational(k) < exact)
                ++k;
            QCOMPARE(valueOf(d, qPrintable(QStringLiteral("p_%1").arg(i))), double(2 * s * (i + 1) - 2 * l * k - l));
        }
        // Both distances make up one sample.
        QCOMPARE(valueOf(d, "d_lower") + valueOf(d, "d_upper"), 1.0);
        QVERIFY(d.listing.size() == 6);
    }
}

void TestDerivations::bresenhamByHand()
{
    // From (2, 12) to (10, 9): dx = 8, dy = 3. p_0 = 6 - 8 = -2, then + 6 or + 6 - 16 as the sign says.
    const QSize size(16, 16);
    const auto at = [&](int x, int y) { return atPixel(x + 0.5, y + 0.5, 0.5, size); };
    const Scene scene = soup({at(2, 12), at(10, 9), at(10, 14)});
    DerivationPlace place;
    const Derivation d = derived(DerivationTopic::Bresenham, scene, plainSettings(size), place);
    const int expected[] = {-2, 4, -6, 0, 6, -4, 2, -8};
    for (int i = 0; i < 8; ++i)
        QCOMPARE(valueOf(d, qPrintable(QStringLiteral("p_%1").arg(i))), double(expected[i]));
    QCOMPARE(valueOf(d, "m"), -0.375);
    QCOMPARE(valueOf(d, "b"), 12.75);
    QCOMPARE(valueOf(d, "ideal"), 11.625);  // 12.75 - 0.375 * 3
    QCOMPARE(valueOf(d, "d_lower"), 0.375); // 12 - 11.625, y runs up here
    QCOMPARE(valueOf(d, "d_upper"), 0.625);
    // The tie p_3 = 0 holds for <= and not for <.
    int ties = 0;
    for (const DerivationLine& line : d.lines) {
        if (textOf(line.formula) == QStringLiteral("p_3 \u2264 0"))
            QVERIFY(++ties > 0 && line.holds());
        if (textOf(line.formula) == QStringLiteral("p_3 < 0"))
            QVERIFY(++ties > 0 && !line.holds());
    }
    QCOMPARE(ties, 2);
    // At a pixel of the line, the step from there: (6, 11) is reached after 4 steps, with p_4 = 6.
    place.pixel = QPoint(6, 11);
    QVERIFY(!derive(DerivationTopic::Bresenham, scene, plainSettings(size), {0, QPoint(6, 3), 0, 0.5, {}}).derivation);
    const Derivation fourth = derived(DerivationTopic::Bresenham, scene, plainSettings(size), place);
    QCOMPARE(valueOf(fourth, "p_4"), 6.0);
    QCOMPARE(valueOf(fourth, "d_lower") - valueOf(fourth, "d_upper"), 0.75); // 6 / 8
}

void TestDerivations::perspectiveByRays()
{
    // Corners of clip space with different w. Whatever projects to P' satisfies (1-n) X1 + n X2 = P' ((1-n) Z1 + n Z2).
    const QSize size(64, 64);
    const Scene scene = soup({{-0.5F, -0.75F, 0, 1}, {3, -2, 0, 4}, {-1, 1.5F, 0, 2}});
    const Rational x[] = {Rational(-1, 2), 3, -1};
    const Rational y[] = {Rational(-3, 4), -2, Rational(3, 2)};
    const Rational w[] = {1, 4, 2};
    for (const int quarters : {1, 2, 3}) {
        const Derivation d = derived(DerivationTopic::Perspective, scene, plainSettings(size),
                                     {0, QPoint(30, 36), 0, quarters / 4.0, {}});
        const Rational m(quarters, 4);
        const Rational p = (1 - m) * x[0] / w[0] + m * x[1] / w[1];
        const Rational n = (p * w[0] - x[0]) / (x[1] - x[0] - p * (w[1] - w[0]));
        QVERIFY(isRational(d, "P'", p));
        QVERIFY(isRational(d, "n", n));
        QVERIFY(isRational(d, "n_ratio", n / (1 - n)));
        QVERIFY(isRational(d, "Zn", w[0] + n * (w[1] - w[0])));
        QVERIFY(isRational(d, "n_1", m));
        QVERIFY(isRational(d, "n_4", 4 * m / (1 + 3 * m)));
        // The weights in space of what is seen at the sample: the point where all of x - px w and y - py w cancel.
        const Rational px = Rational(61, 64) - 1;
        const Rational py = 1 - Rational(73, 64);
        std::array<Vector, 3> seen;
        for (std::size_t i = 0; i < 3; ++i)
            seen[i] = {x[i] - px * w[i], y[i] - py * w[i]};
        const std::array<Rational, 3> weights = weightsByElimination(seen, Vector{0, 0});
        QVERIFY(isNear(valueOf(d, "alpha_p"), static_cast<double>(weights[0]), 1e-14));
        QVERIFY(isNear(valueOf(d, "beta_p"), static_cast<double>(weights[1]), 1e-14));
        QVERIFY(isNear(valueOf(d, "gamma_p"), static_cast<double>(weights[2]), 1e-14));
        const Rational depth = weights[0] * w[0] + weights[1] * w[1] + weights[2] * w[2];
        QVERIFY(isNear(valueOf(d, "w"), static_cast<double>(depth), 1e-13));
    }
}

/// Neither end is nearer where both lie equally far away.
void TestDerivations::exchangedDistancesMayBeEqual()
{
    const auto saysNearEnd = [](const char* name) {
        const Scene scene = builtin(name);
        const Derivation d = derived(DerivationTopic::Perspective, scene, scene.defaults, {0, {}, 0, 0.25, {}});
        const bool isEqual = valueOf(d, "n_swapped") == valueOf(d, "n");
        const bool says = std::ranges::any_of(
            d.lines, [](const DerivationLine& line) { return textOf(line.words).contains(QLatin1String("near end")); });
        return std::pair(isEqual, says);
    };
    QCOMPARE(saysNearEnd("games101"), std::pair(true, false));
    QCOMPARE(saysNearEnd("four-z"), std::pair(false, true));
}

void TestDerivations::fourZByHand()
{
    // From distance 1 to 10, half-way on the screen: n = 0.5 / (5 + 0.5) = 1/11, and 1/Z = (1 + 1/10) / 2 = 0.55.
    const Scene scene = builtin("four-z");
    const Derivation d = derived(DerivationTopic::Perspective, scene, scene.defaults, {0, {}, 0, 0.5, {}});
    QVERIFY(isNear(valueOf(d, "n"), 1.0 / 11, 1e-6));
    QVERIFY(isNear(valueOf(d, "Zn"), 1 / 0.55, 1e-5));
    QVERIFY(isNear(valueOf(d, "n_swapped"), 10.0 / 11, 1e-6));
    // The four-z board: z / w between 0 and 0.98 or so is linear on the screen; the distance there by the weight on the
    // screen would be 5.5.
    const Derivation board = derived(DerivationTopic::DepthCurve, scene, scene.defaults, {0, {}, 0, 1.0 / 11, {}});
    QVERIFY(isNear(valueOf(board, "b"), 0.5, 1e-6));
    QVERIFY(isNear(valueOf(board, "z3"), 1 / 0.55, 1e-5));
    QVERIFY(isNear(valueOf(board, "c3"), 0.8938, 1e-4));
    QVERIFY(isNear(valueOf(board, "c_corrected"), 0.8200, 1e-4));
    QVERIFY(isNear(valueOf(board, "c_error"), -0.0738, 1e-4));
    QVERIFY(isNear(valueOf(board, "z_linear"), 5.5, 1e-5));
    QVERIFY(isNear(valueOf(board, "z_error"), 5.5 - 1 / 0.55, 1e-5));
}

void TestDerivations::depthCurveByHand()
{
    // near 0.1 and far 50: half-way is 25.05, and z' = 50.1 - 5 / 25.05 = 50.1 - 0.1996008 = 49.9003992.
    const Scene scene = builtin("games101");
    const Derivation d = derived(DerivationTopic::DepthCurve, scene, scene.defaults, {});
    QVERIFY(isNear(valueOf(d, "T_33"), 50.1, 1e-12));
    QVERIFY(isNear(valueOf(d, "T_34"), -5, 1e-12));
    QVERIFY(isNear(valueOf(d, "z"), 25.05, 1e-12));
    QVERIFY(isNear(valueOf(d, "z'"), 49.9003992, 1e-7));
    QVERIFY(isNear(valueOf(d, "z_behind'"), 50.2996008, 1e-7));
    QVERIFY(isNear(valueOf(d, "part"), 0.9980040, 1e-7)); // 49.8003992 / 49.9
    QVERIFY(isNear(valueOf(d, "z3"), 7, 1e-6));           // the eye at 5 looks at z = -2
    const Derivation free = derived(DerivationTopic::DepthCurve, scene, scene.defaults, {0, {}, 0, 0.5, 1.0});
    QVERIFY(isNear(valueOf(free, "z'"), 45.1, 1e-12)); // 50.1 - 5 / 1
    // On an edge that leads away from the eye: b from the place on the screen, and z' is there as b says.
    const Scene tiles = builtin("tile-square");
    for (const int edge : {1, 2}) {
        const Derivation away = derived(DerivationTopic::DepthCurve, tiles, tiles.defaults, {0, {}, edge, 0.25, {}});
        const double y1 = valueOf(away, "y1'");
        const double y2 = valueOf(away, "y2'");
        const double b = (valueOf(away, "y3'") - y2) / (y1 - y2);
        QVERIFY(std::abs(b - 0.75) > 0.01);
        QVERIFY(isNear(valueOf(away, "b"), b, 1e-12));
        QVERIFY(isNear(valueOf(away, "z3'"), b * valueOf(away, "z1'") + (1 - b) * valueOf(away, "z2'"), 1e-12));
    }
}

void TestDerivations::cutsLieOnTheirPlanes()
{
    // A = (0, 0, 0, 1), B = (4, 0, 0, 2), C = (0, 0.5, 0, 1). Inside of +x: 1, -2 and 1. On AB and on CB that is 0
    // after a third of the way, at x = w = 4/3.
    const Scene scene = soup({{0, 0, 0, 1}, {4, 0, 0, 2}, {0, 0.5F, 0, 1}});
    const Derivation d = derived(DerivationTopic::Cut, scene, plainSettings({64, 64}), {});
    QVERIFY(isRational(d, "t_+x", Rational(1, 3)));
    QVERIFY(isRational(d, "t_-x", Rational(-1, 5))); // 1 / (1 - 6)
    QVERIFY(isRational(d, "t_+y", -1));
    QVERIFY(isRational(d, "t_-y", -1));
    QVERIFY(isRational(d, "t_+z", -1));
    QVERIFY(isRational(d, "t_-z", -1));
    QVERIFY(isNear(valueOf(d, "t_w"), -(1 - 1e-5), 1e-12)); // (1 - e) / (1 - e - 2 + e)
    QCOMPARE(valueOf(d, "d_+x_B"), -2.0);
    QVERIFY(isNear(valueOf(d, "x_I1"), 4.0 / 3, 1e-15));
    QVERIFY(isNear(valueOf(d, "w_I1"), 4.0 / 3, 1e-15));
    QVERIFY(isNear(valueOf(d, "y_I2"), 1.0 / 3, 1e-15));
    QVERIFY(isNear(valueOf(d, "t_I2"), 1.0 / 3, 1e-15));
    QVERIFY(isNear(valueOf(d, "t_I2_start"), 2.0 / 3, 1e-15));
    QCOMPARE(valueOf(d, "triangles"), 2.0);
    // A corner behind the eye: for every plane the point at t lies on it, in rationals of the float32 corners.
    const Scene behind = builtin("behind-camera");
    for (const int edge : {0, 1, 2}) {
        const Derivation b = derived(DerivationTopic::Cut, behind, behind.defaults, {0, {}, edge, 0.5, {}});
        const char* const letters[] = {"A", "B", "C"};
        const auto at = [&](const char* axis, int corner) {
            return Rational(valueOf(b, (std::string(axis) + "_" + letters[corner % 3]).c_str()));
        };
        for (const char* plane : {"t_+x", "t_-x", "t_+y", "t_-y", "t_+z", "t_-z"}) {
            const Rational t(valueOf(b, plane));
            const std::string axis(1, plane[3]);
            const auto point = [&](const char* of) -> Rational {
                return at(of, edge) + t * (at(of, edge + 1) - at(of, edge));
            };
            const Rational distance = point("w") - (plane[2] == '+' ? 1 : -1) * point(axis.c_str());
            QVERIFY2(abs(distance) < Rational(1, 1000000000), plane);
        }
    }
}

void TestDerivations::cohenSutherlandByHand()
{
    // On 8 x 8: A = (2, 2), B = (14, 2), C = (2, 6). B is right of the screen. From B the border x = 8 is at half the
    // way to A, (8, 2), and at half the way to C, (8, 4).
    const QSize size(8, 8);
    const Scene scene = soup({atPixel(2, 2, 0.5, size), atPixel(14, 2, 0.5, size), atPixel(2, 6, 0.5, size)});
    const Derivation d = derived(DerivationTopic::CohenSutherland, scene, plainSettings(size), {});
    QCOMPARE(valueOf(d, "code_A"), 0.0);
    QCOMPARE(valueOf(d, "code_B"), 2.0);
    QCOMPARE(valueOf(d, "t_I1"), 0.5);
    QCOMPARE(valueOf(d, "x_I1"), 8.0);
    QCOMPARE(valueOf(d, "y_I1"), 2.0);
    QCOMPARE(valueOf(d, "y_I2"), 4.0);
    QCOMPARE(valueOf(d, "code_I2"), 0.0);
    QCOMPARE(valueOf(d, "ends"), 4.0);
    QCOMPARE(valueOf(d, "corners"), 4.0);
    // With 0.001 pixels added to what is cut, the new ends are drawn at x = 7.999.
    Settings nudging = plainSettings(size);
    nudging.mistakes = {QStringLiteral("nudged-cut")};
    const Derivation nudged = derived(DerivationTopic::CohenSutherland, scene, nudging, {});
    QCOMPARE(valueOf(nudged, "x_I1"), 8.0);
    QCOMPARE(valueOf(nudged, "x_drawn_I1"), 8 - 0.001);
    QCOMPARE(valueOf(nudged, "x_drawn_I2"), 8 - 0.001);
    // The example: U = (-2, 2), V = (4, -8). At x = 0 a third of the way is done, y = 2 - 10 / 3 = -4/3: above, 1000.
    QCOMPARE(valueOf(d, "code_U"), 1.0);
    QCOMPARE(valueOf(d, "code_V"), 8.0);
    QVERIFY(isRational(d, "t_J1", Rational(1, 3)));
    QVERIFY(isRational(d, "y_J1", Rational(-4, 3)));
    QCOMPARE(valueOf(d, "code_J1"), 8.0);
    QVERIFY(!d.lines.back().holds()); // 1000 AND 1000 = 0 does not hold: a null line
    // A face around the whole screen: no edge is left, and all four corners of the screen are.
    const Scene around = soup({atPixel(-40, 40, 0.5, size), atPixel(40, 40, 0.5, size), atPixel(4, -40, 0.5, size)});
    const Derivation corners = derived(DerivationTopic::CohenSutherland, around, plainSettings(size), {});
    QCOMPARE(valueOf(corners, "ends"), 0.0);
    QCOMPARE(valueOf(corners, "screen_corners"), 4.0);
    QCOMPARE(valueOf(corners, "corners"), 4.0);
}

/// A corner that the sides of the screen have made has the name that the canvas gives it, and stands where it does.
void TestDerivations::cutCornersHaveOneName()
{
    int compared = 0;
    for (const char* name : {"cut-on-centres", "overhang", "covering", "tunnel"}) {
        const Scene scene = builtin(name);
        Settings settings = scene.defaults;
        settings.clipping = Clipping::CohenSutherland;
        const FaceRecord record(scene, settings, {}, {});
        const auto events = record.log().eventsOf(StepKind::CohenSutherland);
        if (events.empty())
            continue;
        const Derivation d = derived(DerivationTopic::CohenSutherland, scene, settings, {});
        const FaceMoment moment = *faceMomentAt(record.log(), events.front() + 1);
        for (const MomentCorner& corner : moment.corners) {
            const std::string id = corner.name.toStdString();
            if (d.find(("x_" + id).c_str()) == nullptr)
                continue; // a corner of the screen
            const glm::dvec2 place = record.pixels(*corner.onScreen(record.rules()));
            QVERIFY(isNear(valueOf(d, ("x_" + id).c_str()), place.x, 1e-6 * settings.size.width()));
            QVERIFY(isNear(valueOf(d, ("y_" + id).c_str()), place.y, 1e-6 * settings.size.width()));
            compared += corner.name.startsWith(QLatin1Char('I')) ? 1 : 0;
        }
    }
    qInfo("%d corners", compared);
    QVERIFY(compared >= 3);
}

void TestDerivations::twoPointAgreesWithPlanes()
{
    // B = (300, 200), A = (100, 400), C = (400, 500) by height. At y = 350.5: 150.5 / 300 along BC, 150.5 / 200 along
    // BA.
    const Scene scene = builtin("triangle-600");
    const Derivation d = derived(DerivationTopic::TwoPoint, scene, scene.defaults, {0, QPoint(250, 350), 0, 0.5, {}});
    QVERIFY(isRational(d, "t_long", Rational(301, 600)));
    QVERIFY(isRational(d, "t_short", Rational(301, 400)));
    QVERIFY(isNear(valueOf(d, "x_long"), 300 + 100.0 * 301 / 600, 1e-9));
    QVERIFY(isNear(valueOf(d, "x_short"), 300 - 200.0 * 301 / 400, 1e-9));
    // Two interpolations between two points are one between three: the weights are those of the planes.
    for (const char* name : {"tile-square", "four-z", "games101", "triangle"}) {
        const Scene other = builtin(name);
        const Derivation walked = derived(DerivationTopic::TwoPoint, other, other.defaults, {});
        const Derivation planes = derived(DerivationTopic::Perspective, other, other.defaults, {});
        for (const char* weight : {"alpha_p", "beta_p", "gamma_p"})
            QVERIFY(isNear(valueOf(walked, weight), valueOf(planes, weight), 1e-9));
    }
}

void TestDerivations::flatLightByHand()
{
    // A face in the plane z = 0: its normal is (0, 0, 1), and l = (0.3, 0.5, 1) / sqrt(1.34). n . l = 1 / 1.1575837 =
    // 0.8638684; 0.2 + 0.8 * 0.8638684 = 0.8910947; 255 times that is 227.2.
    Scene scene = soup({{0, 0, 0, 1}, {2, 0, 0, 1}, {0, 1, 0, 1}});
    scene.space = SceneSpace::Object;
    scene.lit = true;
    scene.mesh.vertices[0].color = {1, 0.5F, 0};
    const Derivation d = derived(DerivationTopic::FlatLight, scene, plainSettings({64, 64}), {});
    QCOMPARE(valueOf(d, "n_x"), 0.0);
    QCOMPARE(valueOf(d, "n_z"), 1.0);
    QCOMPARE(valueOf(d, "length"), 2.0);
    QVERIFY(isNear(valueOf(d, "n.l"), 0.8638684, 1e-7));
    QVERIFY(isNear(valueOf(d, "brightness"), 0.8910947, 1e-7));
    QCOMPARE(valueOf(d, "r"), 227.0);
    QCOMPARE(valueOf(d, "g"), 114.0); // 113.6
    QCOMPARE(valueOf(d, "b"), 0.0);
    QCOMPARE(valueOf(d, "n.l_head"), 1.0);
    QCOMPARE(valueOf(d, "grey"), 255.0);
}

void TestDerivations::numbersAreWrittenOut()
{
    QCOMPARE(derivedNumber(-100000), QStringLiteral("-100000"));
    QCOMPARE(fullNumber(2e14), QStringLiteral("200000000000000"));
    QCOMPARE(fullNumber(1e300), QStringLiteral("1e+300"));
    QCOMPARE(fullNumber(0.0000125), QStringLiteral("1.25e-05"));
    // A pixel of the 600 x 600 triangle: 0.37375 of red, as a float
    const Derivation d = derived(DerivationTopic::Attribute, builtin("triangle-600"), plainSettings({600, 600}),
                                 {0, QPoint(250, 350), {}, 0.5, {}});
    QCOMPARE(derivedNumber(valueOf(d, "r")), QStringLiteral("0.37375"));
    QCOMPARE(derivedNumber(valueOf(d, "b")), QStringLiteral("0.2525"));
}

void TestDerivations::painterByHand()
{
    // Mean z of the corners: (-0.7 + 0.9 - 0.7) / 3 = -1/6 and (-0.6 - 0.6 + 0.8) / 3 = -2/15. The eye looks along -z,
    // so face 0 is 1/30 further away and is painted first.
    const Scene scene = builtin("piercing");
    const Derivation d = derived(DerivationTopic::Painter, scene, scene.defaults, {1, {}, 0, 0.5, {}});
    QVERIFY(isNear(valueOf(d, "key_0") - valueOf(d, "key_1"), 1.0 / 30, 1e-5));
    QCOMPARE(textOf(d.lines.back().formula), QStringLiteral("key_0 \u2265 key_1"));
    QVERIFY(d.lines.back().holds());
}

void TestDerivations::attributesByHand()
{
    // All w are equal, the corners are red, green and blue, and uv is the place over 600.
    const Scene scene = builtin("triangle-600");
    const std::array<Rational, 3> weights = weightsByElimination({Vector{100, 400}, Vector{300, 200}, Vector{400, 500}},
                                                                 {Rational(501, 2), Rational(701, 2)});
    const Derivation d = derived(DerivationTopic::Attribute, scene, scene.defaults, {0, QPoint(250, 350), 0, 0.5, {}});
    QVERIFY(isNear(valueOf(d, "r"), static_cast<double>(weights[0]), 1e-7));
    QVERIFY(isNear(valueOf(d, "g"), static_cast<double>(weights[1]), 1e-7));
    QVERIFY(isNear(valueOf(d, "b"), static_cast<double>(weights[2]), 1e-7));
    QVERIFY(isNear(valueOf(d, "u"), 250.5 / 600, 1e-7));
    QVERIFY(isNear(valueOf(d, "v"), 350.5 / 600, 1e-7));
    QVERIFY(isNear(valueOf(d, "n_z"), 1, 1e-7));
    // The board of four z: u is (distance - 1) / 9, so it tells the distance that 1 / w gives.
    const Scene board = builtin("four-z");
    const Derivation far = derived(DerivationTopic::Attribute, board, board.defaults, {});
    const Derivation weighted = derived(DerivationTopic::Perspective, board, board.defaults, {});
    QVERIFY(isNear(valueOf(far, "u"), (valueOf(weighted, "w") - 1) / 9, 1e-5));
    QVERIFY(std::abs(valueOf(far, "u_affine") - valueOf(far, "u")) > 0.1);
}

QTEST_APPLESS_MAIN(TestDerivations)
#include "test_derivations.moc"
