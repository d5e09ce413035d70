// Derivations of the bounding box, the forms of the inside test and transparent faces; the figures of derivations.
#include "core/derive/derive.h"
#include "core/questions/vertex_table.h"
#include "tests/derivation_fixture.h"
#include "tests/derived_numbers.h"
#include "tests/support.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

/// Whether the comparison of these words holds; throws where there is none or more than one.
bool holds(const Derivation& derivation, const QString& formula)
{
    const DerivationLine* found = nullptr;
    for (const DerivationLine& line : derivation.lines)
        if (line.isComparison() && textOf(line.formula) == formula) {
            if (found != nullptr)
                throw std::runtime_error("twice: " + formula.toStdString());
            found = &line;
        }
    if (found == nullptr)
        throw std::runtime_error("no line " + formula.toStdString());
    return found->holds();
}

const FigurePoint& pointOf(const DerivationFigure& figure, const char* name)
{
    for (const FigurePoint& point : figure.points)
        if (point.name == QString::fromUtf8(name))
            return point;
    throw std::runtime_error(std::string("no point ") + name);
}

} // namespace

class TestDerivationTopics : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void boundsByHand();
    void boundsOfMistakes();
    void insideByHand();
    void insideCounts();
    void blendByHand();
    void matrixByHand();
    void slipsByHand();
    void sideViewIsTrue();
    void edgeOfTheTopicsChoice();
    void logarithmicAxis();
    void curvesOfPerspective();
    void curveOfDepth();
    void behindTheEye();
};

void TestDerivationTopics::boundsByHand()
{
    // 8 x 8: x from 1.25 to 6.75, y from 0.5 to 9.5. Centres: 1.5 .. 6.5 and 0.5 .. 9.5, of which the picture has 7.5.
    const QSize size(8, 8);
    const Scene scene = soup({atPixel(1.25, 0.5, 0.5, size), atPixel(6.75, 2, 0.5, size), atPixel(3, 9.5, 0.5, size)});
    Settings settings = plainSettings(size);
    settings.clipping = Clipping::GuardBand;
    const Derivation d = derived(DerivationTopic::Bounds, scene, settings, {});
    QCOMPARE(valueOf(d, "x_min"), 1.25);
    QCOMPARE(valueOf(d, "x_max"), 6.75);
    QCOMPARE(valueOf(d, "left"), 1.0);
    QCOMPARE(valueOf(d, "right"), 7.0);
    QCOMPARE(valueOf(d, "top"), 0.0);
    QCOMPARE(valueOf(d, "bottom"), 10.0);
    QCOMPARE(valueOf(d, "x_first"), 1.0);
    QCOMPARE(valueOf(d, "x_last"), 6.0);
    QCOMPARE(valueOf(d, "y_first"), 0.0);
    QCOMPARE(valueOf(d, "y_last"), 9.0);
    QCOMPARE(valueOf(d, "y_1"), 7.0);
    QCOMPARE(valueOf(d, "tested"), 48.0);
    QCOMPARE(valueOf(d, "share"), 0.75);
}

void TestDerivationTopics::boundsOfMistakes()
{
    // What the box of a mistake is computed from still comes out as it is.
    const QSize size(8, 8);
    const Scene scene = soup({atPixel(1.25, 0.5, 0.5, size), atPixel(6.75, 2, 0.5, size), atPixel(3, 9.5, 0.5, size)});
    for (const auto& [mistake, lastColumn, lastRow] :
         {std::tuple("box-one-short", 5.0, 6.0), std::tuple("box-not-clamped", 6.0, 9.0)}) {
        Settings settings = plainSettings(size);
        settings.clipping = Clipping::GuardBand;
        settings.mistakes = {QLatin1String(mistake)};
        const Derivation d = derived(DerivationTopic::Bounds, scene, settings, {});
        QCOMPARE(valueOf(d, "x_1"), lastColumn);
        QCOMPARE(valueOf(d, "y_1"), lastRow);
        for (const DerivationLine& line : d.lines) {
            const std::vector<Printed> values = PrintedFormula(textOf(line.numbers)).read();
            for (std::size_t i = 0; i < values.size(); ++i)
                QCOMPARE(values[i].value, line.values[i]);
        }
    }
}

void TestDerivationTopics::insideByHand()
{
    // (3.5, 4.5) lies on the diagonal of the square: E_BC = 0, E_AB = 28, E_CA = 36.
    const Scene square = builtin("square-diagonal");
    const Derivation tie = derived(DerivationTopic::Inside, square, square.defaults, {0, QPoint(3, 4), 0, 0.5, {}});
    QVERIFY(!holds(tie, QStringLiteral("min(E_AB, E_BC, E_CA) > 0")));
    QVERIFY(holds(tie, QStringLiteral("min(E_AB, E_BC, E_CA) ≥ 0")));
    QVERIFY(holds(tie, QStringLiteral("max(F_AB, F_BC, F_CA) ≤ 0")));
    QVERIFY(holds(tie, QStringLiteral("min(E_AB, E_BC, E_CA)·max(E_AB, E_BC, E_CA) ≥ 0")));
    QVERIFY(!holds(tie, QStringLiteral("min(E_AB, E_BC, E_CA)·max(E_AB, E_BC, E_CA) > 0")));
    QCOMPARE(valueOf(tie, "alpha"), 0.0);
    QCOMPARE(valueOf(tie, "gamma"), 28.0 / 64);
    // A = (0, 0), B = (0, 8), C = (8, 0): AB runs down, BC up, and CA is level and runs to the left.
    QVERIFY(holds(tie, QStringLiteral("B_y > A_y")));
    QVERIFY(!holds(tie, QStringLiteral("C_y > B_y")));
    QVERIFY(holds(tie, QStringLiteral("A_x < C_x")));
    QCOMPARE(valueOf(tie, "t_AB"), 0.0);
    QCOMPARE(valueOf(tie, "t_CA"), 0.0);
    QVERIFY(valueOf(tie, "t_BC") > 0);
    // Outside: (100.5, 200.5) has the edge values 59900, 59900 and -39800 of 80000.
    const Scene scene = builtin("triangle-600");
    const Derivation out = derived(DerivationTopic::Inside, scene, scene.defaults, {0, QPoint(100, 200), 0, 0.5, {}});
    QCOMPARE(valueOf(out, "alpha"), 0.74875);
    QCOMPARE(valueOf(out, "beta"), 0.74875);
    QCOMPARE(valueOf(out, "gamma"), -0.4975);
    QVERIFY(!holds(out, QStringLiteral("min(α, β, γ) ≥ 0")));
}

void TestDerivationTopics::insideCounts()
{
    // The corners are whole pixels. By Pick's theorem for the centres, which lie half a pixel off: counted by rows.
    const Scene scene = builtin("triangle-600");
    const Derivation d = derived(DerivationTopic::Inside, scene, scene.defaults, {});
    const auto side = [](int ax, int ay, int bx, int by, double x, double y) {
        return (by - ay) * (x - ax) - (bx - ax) * (y - ay);
    };
    int strict = 0;
    int inclusive = 0;
    for (int j = 0; j < 600; ++j)
        for (int i = 0; i < 600; ++i) {
            // A = (100, 400), C = (400, 500), B = (300, 200)
            const double values[] = {side(100, 400, 400, 500, i + 0.5, j + 0.5),
                                     side(400, 500, 300, 200, i + 0.5, j + 0.5),
                                     side(300, 200, 100, 400, i + 0.5, j + 0.5)};
            const double least = std::ranges::min(values);
            strict += least > 0 ? 1 : 0;
            inclusive += least >= 0 ? 1 : 0;
        }
    QCOMPARE(valueOf(d, "strict"), double(strict));
    QCOMPARE(valueOf(d, "inclusive"), double(inclusive));
    QCOMPARE(valueOf(d, "on_edges"), 400.0);
    QCOMPARE(valueOf(d, "drawn"), 40100.0);
    QCOMPARE(valueOf(d, "owned"), 300.0);
    // Drawn with all edges inclusive, all that lies on an edge is drawn.
    Settings settings = scene.defaults;
    settings.tieRule = TieRule::Inclusive;
    const Derivation all = derived(DerivationTopic::Inside, scene, settings, {});
    QCOMPARE(valueOf(all, "owned"), 400.0);
}

void TestDerivationTopics::blendByHand()
{
    // A red face in front, sent first, and a blue one behind it, on black.
    const QSize size(8, 8);
    Scene scene = soup({atPixel(0, 0, 0.25, size), atPixel(0, 8, 0.25, size), atPixel(8, 0, 0.25, size),
                        atPixel(0, 0, 0.75, size), atPixel(0, 8, 0.75, size), atPixel(8, 0, 0.75, size)});
    for (std::size_t i = 0; i < 6; ++i)
        scene.mesh.vertices[i].color = i < 3 ? glm::vec3(1, 0, 0) : glm::vec3(0, 0, 1);
    scene.background = {0, 0, 0};
    for (const bool reversed : {false, true}) {
        Settings settings = plainSettings(size);
        settings.reversedZ = reversed;
        const Derivation d = derived(DerivationTopic::Blend, scene, settings, {0, QPoint(1, 1), 0, 0.5, {}});
        QCOMPARE(valueOf(d, "r_s1"), 0.5);
        QCOMPARE(valueOf(d, "r_s2"), 0.25);
        QCOMPARE(valueOf(d, "b_s2"), 0.5);
        QCOMPARE(valueOf(d, "b_f1"), 0.5);
        QCOMPARE(valueOf(d, "r_f2"), 0.5);
        QCOMPARE(valueOf(d, "b_f2"), 0.25);
        QVERIFY(!holds(d, QStringLiteral("r_s2 = r_f2")));
        QVERIFY(!holds(d, reversed ? QStringLiteral("z_F1 > z_F0") : QStringLiteral("z_F1 < z_F0")));
    }
    // A pixel on an edge that two faces share is painted by both if edges are inclusive, and by one under the rule.
    const Scene square = builtin("square-diagonal");
    Settings inclusive = square.defaults;
    const auto layers = [&] {
        const Derivation d = derived(DerivationTopic::Blend, square, inclusive, {0, QPoint(3, 4), 0, 0.5, {}});
        return std::ranges::count_if(d.symbols, [](const DerivationSymbol& s) { return s.id.startsWith("z_F"); });
    };
    inclusive.tieRule = TieRule::Inclusive;
    QCOMPARE(layers(), 2);
}

void TestDerivationTopics::matrixByHand()
{
    // near 0.1, far 50
    const Scene scene = builtin("games101");
    const Derivation d = derived(DerivationTopic::DepthCurve, scene, scene.defaults, {});
    const double expected[4][4] = {{0.1, 0, 0, 0}, {0, 0.1, 0, 0}, {0, 0, 50.1, -5}, {0, 0, 1, 0}};
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            QVERIFY(isNear(valueOf(d, qPrintable(QStringLiteral("T_%1%2").arg(row + 1).arg(column + 1))),
                           expected[row][column], 1e-12));
    QVERIFY(isNear(valueOf(d, "n'"), 0.1, 1e-12));
    QVERIFY(isNear(valueOf(d, "f'"), 50, 1e-12));
    // z / w of -1 to 1 spread over 0.1 to 50: half of 49.9 and of 50.1.
    QVERIFY(isNear(valueOf(d, "z_spread"), 24.95 * valueOf(d, "c3") + 25.05, 1e-9));
}

void TestDerivationTopics::slipsByHand()
{
    // On the screen A = (16, 56), B = (56, 48), C = (16, 8): by height C, B, A.
    const QSize size(64, 64);
    const Scene scene = soup({{-0.5F, -0.75F, 0, 1}, {3, -2, 0, 4}, {-1, 1.5F, 0, 2}});
    const Derivation d =
        derived(DerivationTopic::TwoPoint, scene, plainSettings(size), {0, QPoint(30, 36), 0, 0.5, {}});
    const double m = valueOf(d, "m");
    const double a = valueOf(d, "w_long");
    const double b = valueOf(d, "w_short");
    // 1 / n - 1 = (1 - m) / m * w2 / w1, and with both w exchanged its ratio is the other way up.
    QVERIFY(isNear(1 / valueOf(d, "n_span") - 1, (1 - m) / m * b / a, 1e-12));
    QVERIFY(isNear(1 / valueOf(d, "n_slip") - 1, (1 - m) / m * a / b, 1e-12));
    // The order C, B, A is the right one here, so the slip does no harm: w is 2, 4, 1.
    QCOMPARE(valueOf(d, "w_1'"), 2.0);
    QCOMPARE(valueOf(d, "w_2'"), 4.0);
    QCOMPARE(valueOf(d, "w_3'"), 1.0);
    // Bytes: each product is cut off.
    const Scene triangle = builtin("triangle-600");
    const Derivation bytes =
        derived(DerivationTopic::Attribute, triangle, triangle.defaults, {0, QPoint(250, 350), 0, 0.5, {}});
    // Only A is red: 255 * 299 / 800 = 95.3
    QCOMPARE(valueOf(bytes, "r_byte"), 95.0);
    QCOMPARE(valueOf(bytes, "r_cut"), 95.0);
}

void TestDerivationTopics::sideViewIsTrue()
{
    for (const char* name : {"four-z", "tile-square", "floor"}) {
        const Scene scene = builtin(name);
        for (const double m : {0.25, 0.5, 0.875}) {
            const Derived found = derive(DerivationTopic::Perspective, scene, scene.defaults, {0, {}, 0, m, {}});
            if (!found.derivation)
                continue;
            const Derivation& d = *found.derivation;
            const DerivationFigure& figure = d.figures.front();
            const glm::dvec2 a = pointOf(figure, "A").at;
            const glm::dvec2 b = pointOf(figure, "B").at;
            const glm::dvec2 p = pointOf(figure, "P").at;
            const glm::dvec2 seen = pointOf(figure, "P'").at;
            const double size = glm::length(a) + glm::length(b);
            // The eye, P' on the screen and P on the edge lie on one ray, G and K on it too, right above A and B.
            QCOMPARE(seen.x, 1.0);
            for (const char* on : {"P", "G", "K"})
                QVERIFY(isNear(pointOf(figure, on).at.y, seen.y * pointOf(figure, on).at.x, 1e-12 * size));
            QCOMPARE(pointOf(figure, "G").at.x, a.x);
            QCOMPARE(pointOf(figure, "K").at.x, b.x);
            const glm::dvec2 along = b - a;
            QVERIFY(isNear((p - a).x * along.y - (p - a).y * along.x, 0, 1e-12 * size * size));
            // m and n are the parts of the two ways.
            const glm::dvec2 seenA = pointOf(figure, "A'").at;
            const glm::dvec2 seenB = pointOf(figure, "B'").at;
            QVERIFY(isNear((seen - seenA).y, m * (seenB - seenA).y, 1e-12 * size));
            QVERIFY(isNear(glm::length(p - a), valueOf(d, "n") * glm::length(along), 1e-12 * size));
            for (const FigureStroke& stroke : figure.strokes)
                for (const glm::dvec2& point : stroke.points)
                    QVERIFY(point.x >= figure.low.x && point.x <= figure.high.x * (1 + 1e-12));
        }
    }
}

void TestDerivationTopics::edgeOfTheTopicsChoice()
{
    const Scene tiles = builtin("tile-square");
    const auto corners = vertexTable(tiles, tiles.defaults, 0);
    QCOMPARE(corners[0].clip.w, corners[1].clip.w);
    for (const DerivationTopic topic : {DerivationTopic::Perspective, DerivationTopic::DepthCurve}) {
        const Derived found = derive(topic, tiles, tiles.defaults, {});
        QVERIFY(found.edge && *found.edge > 0);
        const auto from = std::size_t(*found.edge);
        const double z1 = corners[from].clip.w;
        const double z2 = corners[(from + 1) % 3].clip.w;
        for (std::size_t i = 0; i < 3; ++i) {
            const double ratio = corners[i].clip.w / corners[(i + 1) % 3].clip.w;
            QVERIFY(std::max(ratio, 1 / ratio) <= std::max(z1 / z2, z2 / z1));
        }
        QCOMPARE(derive(topic, tiles, tiles.defaults, {0, {}, 0, 0.5, {}}).edge, std::optional(0));
    }
    QCOMPARE(derive(DerivationTopic::Cut, tiles, tiles.defaults, {}).edge, std::optional(0));
    QCOMPARE(derive(DerivationTopic::Painter, tiles, tiles.defaults, {0, {}, 1, 0.5, {}}).edge, std::optional<int>());
}

void TestDerivationTopics::logarithmicAxis()
{
    DerivationFigure figure;
    figure.low = {-100, 0};
    figure.high = {100, 1};
    QCOMPARE(figure.partOfWidth(50), 0.75);
    QCOMPARE(figure.xAt(0.75), 50.0);
    figure.logFrom = 0.1;
    QCOMPARE(figure.partOfWidth(-100), 0.0);
    QCOMPARE(figure.partOfWidth(0), 0.5);
    QCOMPARE(figure.partOfWidth(100), 1.0);
    // Equal ratios have equal room, and 0.1 has as much as the first e-fold beyond it.
    const auto room = [&](double from, double to) { return figure.partOfWidth(to) - figure.partOfWidth(from); };
    QVERIFY(isNear(room(0.1, 1), room(10, 100), 1e-12));
    QVERIFY(isNear(room(-100, -10), room(1, 10), 1e-12));
    QVERIFY(isNear(room(0, 0.1), room(0.1, 0.1 * std::exp(1)), 1e-12));
    for (const double x : {-100.0, -3.0, -0.1, -0.05, 0.0, 0.02, 0.1, 7.0, 100.0})
        QVERIFY(isNear(figure.xAt(figure.partOfWidth(x)), x, 1e-12 * std::abs(x) + 1e-15));
}

void TestDerivationTopics::curvesOfPerspective()
{
    // Two triangles whose corners are 7 and 10 away each: the correction has nothing to correct.
    const Scene flat = builtin("games101");
    for (const std::uint32_t face : {0U, 1U}) {
        const Derivation d = derived(DerivationTopic::Perspective, flat, flat.defaults, {face, {}, 0, 0.25, {}});
        QVERIFY(isNear(valueOf(d, "w_spread"), 0, 1e-6));
        QVERIFY(isNear(valueOf(d, "w"), face == 0 ? 7 : 10, 1e-5));
        QVERIFY(isNear(valueOf(d, "n"), 0.25, 1e-6));
    }
    const Scene scene = builtin("four-z");
    const Derivation d = derived(DerivationTopic::Perspective, scene, scene.defaults, {0, {}, 0, 0.5, {}});
    const DerivationFigure& figure = d.figures.at(1);
    QCOMPARE(figure.strokes.size(), std::size_t(7)); // six ratios and the edge
    for (const FigureStroke& stroke : figure.strokes) {
        QCOMPARE(stroke.points.front(), glm::dvec2(0, 0));
        QCOMPARE(stroke.points.back(), glm::dvec2(1, 1));
        // Z2 n (1 - m) = Z1 m (1 - n)
        const double ratio = stroke.name.isEmpty() ? valueOf(d, "Z1") / valueOf(d, "Z2") : stroke.name.toDouble();
        for (const glm::dvec2& point : stroke.points)
            QVERIFY(isNear(point.y * (1 - point.x), ratio * point.x * (1 - point.y), 1e-12));
    }
}

void TestDerivationTopics::curveOfDepth()
{
    const Scene scene = builtin("games101");
    const Derivation d = derived(DerivationTopic::DepthCurve, scene, scene.defaults, {0, {}, 0, 0.5, 25.05});
    const DerivationFigure& figure = d.figures.front();
    int branches = 0;
    for (const FigureStroke& stroke : figure.strokes) {
        if (stroke.points.size() < 3)
            continue;
        ++branches;
        const bool isBehind = d.symbols[std::size_t(stroke.symbol)].id == QStringLiteral("z_behind'");
        for (const glm::dvec2& point : stroke.points) {
            QVERIFY(isNear((50.1 - point.y) * point.x, 5, 1e-9)); // z' = n + f - n f / z
            QCOMPARE(point.x < 0, isBehind);
            QCOMPARE(point.y > 50.1, isBehind);
        }
    }
    QCOMPARE(branches, 2);
    QVERIFY(isNear(pointOf(figure, "z").at.y, 49.9003992, 1e-7));
    QVERIFY(isNear(pointOf(figure, "−z").at.y, 50.2996008, 1e-7));
}

void TestDerivationTopics::behindTheEye()
{
    const Scene scene = builtin("behind-camera");
    const Derivation d = derived(DerivationTopic::Cut, scene, scene.defaults, {});
    QVERIFY(valueOf(d, "w_B") < 0);
    QVERIFY(!holds(d, QStringLiteral("−w_B ≤ w_B")));
}

QTEST_APPLESS_MAIN(TestDerivationTopics)
#include "test_derivation_topics.moc"
