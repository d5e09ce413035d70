#include "core/derive/topic_list.h"

#include <QCoreApplication>

namespace rasterlens
{
namespace
{

/// Writes what the projection makes of depth along an edge.
class DepthCurveWriter
{
public:
    explicit DepthCurveWriter(const FaceRecord& record)
        : m_record(record), m_first(std::size_t(record.place().edge)), m_last((m_first + 1) % 3),
          m_writer(DerivationTopic::DepthCurve, faceReason(record))
    {
        const Matrices matrices = record.matrices();
        m_writer.given(QStringLiteral("n"), matrices.near);
        m_writer.given(QStringLiteral("f"), matrices.far);
        giveEnd(m_first, "1");
        giveEnd(m_last, "2");
        m_writer.given(QStringLiteral("a"), 1 - record.place().m);
    }

    Derivation write()
    {
        writeMatrix();
        writeDirectProof();
        writeProofByRatios();
        writeCurve();
        writeFourZ();
        return m_writer.take();
    }

private:
    [[nodiscard]] CanvasPart corner(std::size_t i) const
    {
        return {CanvasKind::Corner, cornerLetter(i), {m_record.corners()[i].screen}};
    }
    [[nodiscard]] CanvasPart edge() const
    {
        return edgePart(cornerLetter(m_first) + cornerLetter(m_last), m_record.corners()[m_first].screen,
                        m_record.corners()[m_last].screen);
    }

    /// View space looks along -z; the texts count distances in front of the eye as positive.
    void giveEnd(std::size_t i, const char* number)
    {
        const VertexRow& row = m_record.corners()[i];
        const QString suffix = QLatin1String(number);
        m_writer.given(QStringLiteral("x") + suffix, row.view.x, corner(i));
        m_writer.given(QStringLiteral("y") + suffix, row.view.y, corner(i));
        m_writer.given(QStringLiteral("z") + suffix, -row.view.z, corner(i));
        m_writer.given(QStringLiteral("c") + suffix, row.clip.z / row.clip.w, corner(i));
    }

    void writeMatrix()
    {
        m_writer.line(formula("({T_33}, {T_34}, {T_43})"), formula("({n} + {f}, -{n} * {f}, 1)"),
                      QT_TRANSLATE_NOOP("Derive",
                                        "The matrix T that makes a box of the view volume: rows (n, 0, 0, 0), "
                                        "(0, n, 0, 0), (0, 0, n + f, -n f) and (0, 0, 1, 0); z is the distance in "
                                        "front of the eye."));
        for (const char* number : {"1", "2"}) {
            const QString i = QLatin1String(number);
            m_writer.line(formula("({X%1}, {Y%1}, {Z%1}, {W%1})", i),
                          formula("({n} * {x%1}, {n} * {y%1}, {T_33} * {z%1} + {T_34}, {T_43} * {z%1})", i),
                          {QT_TRANSLATE_NOOP("Derive", "T times end %1 of the edge. w has become the distance."), {i}},
                          {edge()});
            m_writer.line(formula("({x%1'}, {y%1'}, {z%1'})", i),
                          formula("({X%1} / {W%1}, {Y%1} / {W%1}, {Z%1} / {W%1})", i),
                          QT_TRANSLATE_NOOP("Derive", "Divided by w."), {edge()});
            m_writer.line(formula("{z%1'}", i), formula("{n} + {f} - {n} * {f} / {z%1}", i),
                          QT_TRANSLATE_NOOP("Derive", "So z' is a hyperbola over the distance."), {edge()});
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
            {edge()});
        m_writer.line(formula("({x3'}, {y3'}, {z3'})"),
                      formula("({n} * {x3} / {z3}, {n} * {y3} / {z3}, {n} + {f} - {n} * {f} / {z3})"),
                      QT_TRANSLATE_NOOP("Derive", "The point itself through T and the divide."), {edge()});
        m_writer.line(
            formula("({b}, {b_2})"), formula("({a} * {z1} / {z3}, (1 - {a}) * {z2} / {z3})"),
            QT_TRANSLATE_NOOP("Derive", "x = z x' / n put into the sum for x3: these stand before x1' and x2'."),
            {edge()});
        m_writer.line(formula("{b_sum}"), formula("{b} + {b_2}"),
                      QT_TRANSLATE_NOOP("Derive",
                                        "They add up to z3 / z3 = 1, so the second is 1 - b: straight lines stay "
                                        "straight."));
        m_writer.line(formula("({x3'}, {y3'})"),
                      formula("({b} * {x1'} + (1 - {b}) * {x2'}, {b} * {y1'} + (1 - {b}) * {y2'})"),
                      QT_TRANSLATE_NOOP("Derive", "The place on the screen, from those of the ends."), {edge()});
        m_writer.line(formula("{r}"), formula("1 / {z3}"), QT_TRANSLATE_NOOP("Derive", "One over the distance."));
        m_writer.line(
            formula("{r}"), formula("{b} / {z1} + (1 - {b}) / {z2}"),
            QT_TRANSLATE_NOOP("Derive", "1 / z is linear on the screen: a / z3 = b / z1, and the other end alike."),
            {edge()});
        m_writer.line(formula("{z3'}"),
                      formula("({n} + {f}) * ({b} + 1 - {b}) - {n} * {f} * ({b} / {z1} + (1 - {b}) / {z2})"),
                      QT_TRANSLATE_NOOP("Derive", "Put into z' = n + f - n f / z."), {edge()});
        m_writer.line(
            formula("{z3'}"), formula("{b} * {z1'} + (1 - {b}) * {z2'}"),
            QT_TRANSLATE_NOOP("Derive", "Sorted by b: z' is linear on the screen, with the weights of x' and y'."),
            {edge()});
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
            {edge()});
        m_writer.line(formula("{z3}"), formula("({eta_1} * {z1} + {z2}) / ({eta_1} + 1)"),
                      QT_TRANSLATE_NOOP("Derive", "The distance by the ratio in space."), {edge()});
        m_writer.line(formula("{z3}"), formula("{z1} * {z2} / ({z2} * {b} + {z1} * (1 - {b}))"),
                      QT_TRANSLATE_NOOP("Derive",
                                        "The distance by b: one over it is linear, and the end of the first proof "
                                        "follows again."),
                      {edge()});
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
                      {edge()});
        m_writer.line(
            formula("{c_corrected}"), formula("{a} * {c1} + (1 - {a}) * {c2}"),
            QT_TRANSLATE_NOOP("Derive", "z / w \"corrected\" with the weight in space, as attributes are: wrong."),
            {edge()});
        m_writer.line(formula("{c_error}"), formula("{c_corrected} - {c3}"), QT_TRANSLATE_NOOP("Derive", "Its error."));
        m_writer.line(formula("{z_linear}"), formula("{b} * {z1} + (1 - {b}) * {z2}"),
                      QT_TRANSLATE_NOOP("Derive", "The distance itself with the weight on the screen: wrong."),
                      {edge()});
        m_writer.line(formula("{z_error}"), formula("{z_linear} - {z3}"), QT_TRANSLATE_NOOP("Derive", "Its error."));
    }

    const FaceRecord& m_record;
    std::size_t m_first; ///< corner where the edge begins
    std::size_t m_last;  ///< corner where it ends
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
    return DepthCurveWriter(record).write();
}

} // namespace rasterlens
