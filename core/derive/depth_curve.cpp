#include "core/derive/parallel.h"
#include "core/derive/place_edge.h"
#include "core/derive/topic_list.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace rasterlens
{
namespace
{

// How far the figure of the curve goes on beyond far, as a power of f / n, and up and down, as a part of f.
constexpr double kBeyondFar = 0.15;
constexpr double kBeyondNear = 0.25;

/// Writes what the projection makes of depth along an edge.
class DepthCurveWriter
{
public:
    explicit DepthCurveWriter(const FaceRecord& record)
        : m_record(record), m_edge(record), m_writer(DerivationTopic::DepthCurve, faceReason(record))
    {
        const Matrices matrices = record.matrices();
        m_writer.given(QStringLiteral("n"), matrices.near);
        m_writer.given(QStringLiteral("f"), matrices.far);
        giveEnd(m_edge.start(), m_edge.startPart(), "1");
        giveEnd(m_edge.end(), m_edge.endPart(), "2");
        m_writer.given(QStringLiteral("a"), 1 - record.place().m);
    }

    Derivation write()
    {
        writeMatrix();
        writeDirectProof();
        writeProofByRatios();
        writeCurve();
        writeFourZ();
        drawCurve();
        return m_writer.take();
    }

private:
    /// View space looks along -z; the texts count distances in front of the eye as positive.
    void giveEnd(const VertexRow& row, const CanvasPart& corner, const char* number)
    {
        const QString suffix = QLatin1String(number);
        m_writer.given(QStringLiteral("x") + suffix, row.view.x, corner);
        m_writer.given(QStringLiteral("y") + suffix, row.view.y, corner);
        m_writer.given(QStringLiteral("z") + suffix, -row.view.z, corner);
        m_writer.given(QStringLiteral("c") + suffix, row.clip.z / row.clip.w, corner);
    }

    void writeMatrix()
    {
        const auto row = [&](const char* left, const char* right, Reason words) {
            m_writer.line(formula(left), formula(right), std::move(words));
        };
        row("({T_11}, {T_12}, {T_13}, {T_14})", "({n}, 0, 0, 0)",
            QT_TRANSLATE_NOOP("Derive",
                              "The matrix T that makes a box of the view volume, row by row; z is the distance in "
                              "front of the eye. x is to become n x / z: n times x here, and the divide by z after "
                              "it. With n = 0 all that x and y say would be lost."));
        row("({T_21}, {T_22}, {T_23}, {T_24})", "(0, {n}, 0, 0)", QT_TRANSLATE_NOOP("Derive", "y becomes n y / z."));
        row("({T_31}, {T_32}, {T_33}, {T_34})", "(0, 0, {n} + {f}, -{n} * {f})",
            QT_TRANSLATE_NOOP("Derive", "z has two numbers of its own, so that near and far can stay where they are."));
        row("({T_41}, {T_42}, {T_43}, {T_44})", "(0, 0, 1, 0)",
            QT_TRANSLATE_NOOP("Derive",
                              "w becomes the distance, which everything is divided by. A corner at the eye itself, z "
                              "= 0, has no place: it must be cut away before the divide."));
        row("{n'}", "{T_33} + {T_34} / {n}", QT_TRANSLATE_NOOP("Derive", "What lies at near stays at near..."));
        row("{f'}", "{T_33} + {T_34} / {f}", QT_TRANSLATE_NOOP("Derive", "...and what lies at far stays at far."));
        for (const char* number : {"1", "2"}) {
            const QString i = QLatin1String(number);
            m_writer.line(formula("({X%1}, {Y%1}, {Z%1}, {W%1})", i),
                          formula("({T_11} * {x%1}, {T_22} * {y%1}, {T_33} * {z%1} + {T_34}, {T_43} * {z%1})", i),
                          {QT_TRANSLATE_NOOP("Derive", "T times end %1 of the edge. w has become the distance."), {i}},
                          {m_edge.part()});
            m_writer.line(formula("({x%1'}, {y%1'}, {z%1'})", i),
                          formula("({X%1} / {W%1}, {Y%1} / {W%1}, {Z%1} / {W%1})", i),
                          QT_TRANSLATE_NOOP("Derive", "Divided by w."), {m_edge.part()});
            m_writer.line(formula("{z%1'}", i), formula("{n} + {f} - {n} * {f} / {z%1}", i),
                          QT_TRANSLATE_NOOP("Derive", "So z' is a hyperbola over the distance."), {m_edge.part()});
        }
    }

    /// First proof: z' of a point between the ends is between theirs as its place on the screen is.
    void writeDirectProof()
    {
        m_writer.line(
            formula("({x3}, {y3}, {z3})"),
            formula("({a} * {x1} + (1 - {a}) * {x2}, {a} * {y1} + (1 - {a}) * {y2}, {a} * {z1} + (1 - {a}) * {z2})"),
            QT_TRANSLATE_NOOP("Derive", "First proof. A point of the edge in space: a parts of end 1, 1 - a of end "
                                        "2."),
            {m_edge.part()});
        m_writer.line(formula("({x3'}, {y3'}, {z3'})"),
                      formula("({n} * {x3} / {z3}, {n} * {y3} / {z3}, {n} + {f} - {n} * {f} / {z3})"),
                      QT_TRANSLATE_NOOP("Derive", "The point itself through T and the divide."), {m_edge.part()});
        m_writer.line(
            formula("({b}, {b_2})"), formula("({a} * {z1} / {z3}, (1 - {a}) * {z2} / {z3})"),
            QT_TRANSLATE_NOOP("Derive", "x = z x' / n put into the sum for x3: these stand before x1' and x2'."),
            {m_edge.part()});
        m_writer.line(formula("{b_sum}"), formula("{b} + {b_2}"),
                      QT_TRANSLATE_NOOP("Derive",
                                        "They add up to z3 / z3 = 1, so the second is 1 - b: straight lines stay "
                                        "straight."));
        m_writer.line(formula("({x3'}, {y3'})"),
                      formula("({b} * {x1'} + (1 - {b}) * {x2'}, {b} * {y1'} + (1 - {b}) * {y2'})"),
                      QT_TRANSLATE_NOOP("Derive", "The place on the screen, from those of the ends."), {m_edge.part()});
        m_writer.line(formula("{r}"), formula("1 / {z3}"), QT_TRANSLATE_NOOP("Derive", "One over the distance."));
        m_writer.line(
            formula("{r}"), formula("{b} / {z1} + (1 - {b}) / {z2}"),
            QT_TRANSLATE_NOOP("Derive", "1 / z is linear on the screen: a / z3 = b / z1, and the other end alike."),
            {m_edge.part()});
        m_writer.line(formula("{z3'}"),
                      formula("({n} + {f}) * ({b} + 1 - {b}) - {n} * {f} * ({b} / {z1} + (1 - {b}) / {z2})"),
                      QT_TRANSLATE_NOOP("Derive", "Put into z' = n + f - n f / z."), {m_edge.part()});
        m_writer.line(
            formula("{z3'}"), formula("{b} * {z1'} + (1 - {b}) * {z2'}"),
            QT_TRANSLATE_NOOP("Derive", "Sorted by b: z' is linear on the screen, with the weights of x' and y'."),
            {m_edge.part()});
    }

    /// Second proof: from the ratios of the parts.
    void writeProofByRatios()
    {
        m_writer.line(formula("({eta_1}, {eta_2})"), formula("({a} / (1 - {a}), {b} / (1 - {b}))"),
                      QT_TRANSLATE_NOOP("Derive",
                                        "Second proof. Suppose P' lies between A' and B' with b. The two ratios, in "
                                        "space and on the screen."));
        m_writer.line(
            formula("{eta_1}"), formula("{eta_2} * {z2} / {z1}"),
            QT_TRANSLATE_NOOP("Derive", "x3 / y3 = x3' / y3' holds if they differ by the ratio of the distances."),
            {m_edge.part()});
        m_writer.line(formula("{z3}"), formula("({eta_1} * {z1} + {z2}) / ({eta_1} + 1)"),
                      QT_TRANSLATE_NOOP("Derive", "The distance by the ratio in space."), {m_edge.part()});
        m_writer.line(formula("{z3}"), formula("{z1} * {z2} / ({z2} * {b} + {z1} * (1 - {b}))"),
                      QT_TRANSLATE_NOOP("Derive",
                                        "The distance by b: one over it is linear, and the end of the first proof "
                                        "follows again."),
                      {m_edge.part()});
    }

    void writeCurve()
    {
        const double middle = (m_writer.valueOf(QStringLiteral("n")) + m_writer.valueOf(QStringLiteral("f"))) / 2;
        m_writer.given(QStringLiteral("z"), m_record.place().depth.value_or(middle));
        m_writer.line(formula("{z'}"), formula("{n} + {f} - {n} * {f} / {z}"),
                      QT_TRANSLATE_NOOP("Derive",
                                        "A distance of free choice on the curve; half-way from near to far unless "
                                        "another is asked for."));
        m_writer.line(formula("{part}"), formula("({z'} - {n}) / ({f} - {n})"),
                      QT_TRANSLATE_NOOP("Derive",
                                        "The part of the way from near to far at which it comes to lie: what lay in "
                                        "the middle goes towards far."));
        m_writer.line(formula("{z_behind'}"), formula("{n} + {f} - {n} * {f} / (-{z})"),
                      QT_TRANSLATE_NOOP("Derive", "As far behind the eye: the other branch of the curve."));
        m_writer.compare(formula("{z_behind'} > {f}"),
                         QT_TRANSLATE_NOOP("Derive",
                                           "What lies behind the eye comes out beyond far; so it is cut away before "
                                           "the divide."));
    }

    /// The four-z board: z/w is linear on the screen, the distance is not.
    void writeFourZ()
    {
        m_writer.line(formula("{c3}"), formula("{b} * {c1} + (1 - {b}) * {c2}"),
                      QT_TRANSLATE_NOOP("Derive",
                                        "c is z / w of the program's own clip space at the ends. It is linear on the "
                                        "screen: b is the right weight."),
                      {m_edge.part()});
        m_writer.line(
            formula("{c_corrected}"), formula("{a} * {c1} + (1 - {a}) * {c2}"),
            QT_TRANSLATE_NOOP("Derive", "z / w \"corrected\" with the weight in space, as attributes are: wrong."),
            {m_edge.part()});
        m_writer.line(formula("{c_error}"), formula("{c_corrected} - {c3}"), QT_TRANSLATE_NOOP("Derive", "Its error."));
        m_writer.line(formula("{z_spread}"), formula("{c3} * ({f} - {n}) / 2 + ({f} + {n}) / 2"),
                      QT_TRANSLATE_NOOP(
                          "Derive", "Some programs spread z / w over near to far again before they store it. That is "
                                    "linear, so comparisons come out as before; it is not the distance."),
                      {m_edge.part()});
        m_writer.line(formula("{z_linear}"), formula("{b} * {z1} + (1 - {b}) * {z2}"),
                      QT_TRANSLATE_NOOP("Derive", "The distance itself with the weight on the screen: wrong."),
                      {m_edge.part()});
        m_writer.line(formula("{z_error}"), formula("{z_linear} - {z3}"), QT_TRANSLATE_NOOP("Derive", "Its error."));
    }

    /// z' over z with both branches, and on it the ends of the edge, its point, and the distance of free choice.
    void drawCurve()
    {
        const auto value = [&](const char* id) { return m_writer.valueOf(QLatin1String(id)); };
        const auto symbol = [&](const char* id) { return m_writer.indexOf(QLatin1String(id)); };
        const double n = value("n");
        const double f = value("f");
        const double z = value("z");
        const double beyond = std::pow(f / n, kBeyondFar);
        const double width = beyond * std::max({f, z, value("z1"), value("z2")});
        DerivationFigure figure;
        figure.title = QT_TRANSLATE_NOOP("Derive", "z' over z, spaced by its logarithm: in front of the eye and behind "
                                                   "it");
        figure.xName = QStringLiteral("z");
        figure.yName = QStringLiteral("z'");
        figure.low = {-width, n - kBeyondNear * f};
        figure.high = {width, n + f + (1 + kBeyondNear) * f};
        figure.logFrom = n;
        figure.xTicks = {{-f, QStringLiteral("\u2212f")},
                         {-n, QStringLiteral("\u2212n")},
                         {n, QStringLiteral("n")},
                         {f, QStringLiteral("f")}};
        // Where the branches leave the figure, on both sides of z = 0.
        const double steepest = n * f / (f + kBeyondNear * f);
        const auto branch = [&](double from, double to) {
            constexpr int kPieces = 96;
            const double first = figure.partOfWidth(from);
            const double last = figure.partOfWidth(to);
            std::vector<glm::dvec2> points;
            for (int i = 0; i <= kPieces; ++i) {
                const double x = figure.xAt(first + (last - first) * i / kPieces);
                points.emplace_back(x, n + f - n * f / x);
            }
            return points;
        };
        using enum FigureStroke::Look;
        figure.strokes = {{{{-width, n}, {width, n}}, QStringLiteral("n"), Dashed, symbol("n")},
                          {{{-width, f}, {width, f}}, QStringLiteral("f"), Dashed, symbol("f")},
                          {{{0, figure.low.y}, {0, figure.high.y}}, QString(), Dashed, -1},
                          {branch(-width, -steepest), QString(), Solid, symbol("z_behind'")},
                          {branch(steepest, width), QString(), Solid, symbol("z'")}};
        figure.points = {{{value("z1"), value("z1'")}, QStringLiteral("1"), symbol("z1'")},
                         {{value("z2"), value("z2'")}, QStringLiteral("2"), symbol("z2'")},
                         {{value("z3"), value("z3'")}, QStringLiteral("3"), symbol("z3'")},
                         {{z, value("z'")}, QStringLiteral("z"), symbol("z'")},
                         {{-z, value("z_behind'")}, QStringLiteral("\u2212z"), symbol("z_behind'")}};
        m_writer.figure(std::move(figure));
    }

    const FaceRecord& m_record;
    PlaceEdge m_edge;
    DerivationWriter m_writer;
};

} // namespace

Derivation deriveDepthCurve(const Scene& scene, const Settings& settings, const DerivationPlace& place,
                            const std::stop_token& stop)
{
    if (scene.space == SceneSpace::Clip)
        throw NoDerivation{QT_TRANSLATE_NOOP("Derive", "a scene in clip space has no distances of near and far")};
    const FaceRecord record(scene, settings, place, stop);
    requireBeforeEye(record);
    if (record.rules().orthographic)
        return deriveParallelDepth(record);
    return DepthCurveWriter(record).write();
}

} // namespace rasterlens
