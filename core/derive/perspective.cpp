#include "core/derive/topic_list.h"

#include <QCoreApplication>

namespace rasterlens
{
namespace
{

/// Writes the way from weights on the screen to weights in space: along an edge seen from the side, and over the face.
class PerspectiveWriter
{
public:
    PerspectiveWriter(const FaceRecord& record, const SampledTriangle& sample, const FragmentStep& fragment)
        : m_record(record), m_sample(sample), m_fragment(fragment), m_first(std::size_t(record.place().edge)),
          m_last((m_first + 1) % 3), m_writer(DerivationTopic::Perspective, pixelReason(record, sample))
    {
        const VertexRow& a = record.corners()[m_first];
        const VertexRow& b = record.corners()[m_last];
        // The side view shows the axis along which the ends are further apart on the screen.
        const glm::dvec2 apart = glm::abs(b.screen - a.screen);
        const int axis = apart.x >= apart.y ? 0 : 1;
        m_writer.given(QStringLiteral("m"), record.place().m, placeAt(record.place().m));
        m_writer.given(QStringLiteral("Z1"), a.clip.w, corner(m_first));
        m_writer.given(QStringLiteral("Z2"), b.clip.w, corner(m_last));
        m_writer.given(QStringLiteral("X1"), a.clip[axis], corner(m_first));
        m_writer.given(QStringLiteral("X2"), b.clip[axis], corner(m_last));
    }

    Derivation write()
    {
        writeSideView();
        writeFraction();
        writeCurve();
        writeFace();
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
    [[nodiscard]] CanvasPart placeAt(double m) const
    {
        const glm::dvec2& a = m_record.corners()[m_first].screen;
        const glm::dvec2& b = m_record.corners()[m_last].screen;
        return {CanvasKind::Point, QStringLiteral("P'"), {a + m * (b - a)}};
    }

    void writeSideView()
    {
        m_writer.show(QStringLiteral("A'"), corner(m_first));
        m_writer.show(QStringLiteral("B'"), corner(m_last));
        m_writer.show(QStringLiteral("P'"), placeAt(m_record.place().m));
        m_writer.line(formula("({A'}, {B'})"), formula("({X1} / {Z1}, {X2} / {Z2})"),
                      QT_TRANSLATE_NOOP("Derive",
                                        "From the side: the eye at 0, the screen at distance 1, the ends of the "
                                        "edge at height X and distance Z (the w of clip space). A ray to the eye "
                                        "meets the screen at X / Z."),
                      {corner(m_first), corner(m_last)});
        m_writer.line(formula("{P'}"), formula("(1 - {m}) * {A'} + {m} * {B'}"),
                      QT_TRANSLATE_NOOP("Derive", "The point at the part m of the way on the screen."),
                      {placeAt(m_record.place().m), edge()});
        m_writer.line(formula("({AG}, {BK})"), formula("(({P'} - {A'}) * {Z1}, ({B'} - {P'}) * {Z2})"),
                      QT_TRANSLATE_NOOP("Derive",
                                        "Parallels to the screen through the ends, up to the ray of P: what is seen "
                                        "as P'A' and P'B' is Z1 and Z2 times as long there."),
                      {edge()});
        m_writer.line(formula("{n_ratio}"), formula("{m} * {Z1} / ((1 - {m}) * {Z2})"),
                      QT_TRANSLATE_NOOP("Derive",
                                        "The two triangles along the ray are similar, so n / (1 - n) = AG / BK: P "
                                        "divides the edge in space in this ratio. The size of the screen cancels "
                                        "out."),
                      {edge()});
        if (m_writer.valueOf(QStringLiteral("BK")) != 0)
            m_writer.line(formula("{n_ratio}"), formula("{AG} / {BK}"),
                          QT_TRANSLATE_NOOP("Derive", "The same from the lengths."), {edge()});
    }

    void writeFraction()
    {
        m_writer.line(formula("{n}"), formula("{m} * {Z1} / ((1 - {m}) * {Z2} + {m} * {Z1})"),
                      QT_TRANSLATE_NOOP("Derive", "Solved for n: the part of the way in space."), {edge()});
        m_writer.line(formula("{n_ratio}"), formula("{n} / (1 - {n})"), QT_TRANSLATE_NOOP("Derive", "Put in again."),
                      {edge()});
        m_writer.line(formula("{n_swapped}"), formula("{m} * {Z2} / ((1 - {m}) * {Z1} + {m} * {Z2})"),
                      QT_TRANSLATE_NOOP("Derive",
                                        "With Z1 and Z2 exchanged, a mistake often seen, the near end weighs too "
                                        "little."),
                      {edge()});
        m_writer.line(formula("{Zn}"), formula("(1 - {n}) * {Z1} + {n} * {Z2}"),
                      QT_TRANSLATE_NOOP("Derive", "The distance of P: linear in n."), {edge()});
        m_writer.line(formula("{Zn}"), formula("{Z1} * {Z2} / ((1 - {m}) * {Z2} + {m} * {Z1})"),
                      QT_TRANSLATE_NOOP("Derive", "With n put in."), {edge()});
        m_writer.line(formula("{Zn}"), formula("1 / ((1 - {m}) / {Z1} + {m} / {Z2})"),
                      QT_TRANSLATE_NOOP("Derive", "Divided by Z1 Z2: 1 / Z is linear on the screen."), {edge()});
        m_writer.line(formula("{P'}"), formula("((1 - {n}) * {X1} + {n} * {X2}) / {Zn}"),
                      QT_TRANSLATE_NOOP("Derive", "The point of the edge at n is seen at P' indeed."),
                      {placeAt(m_record.place().m)});
    }

    /// n(m) of several edges: the steeper they lead away from the eye, the further from the diagonal.
    void writeCurve()
    {
        for (const char* ratio : {"0.25", "0.5", "1", "2", "4", "10"}) {
            const QString k = QLatin1String(ratio);
            m_writer.given(QStringLiteral("k_") + k, k.toDouble());
            m_writer.line(
                formula("{n_%1}", k), formula("{m} * {k_%1} / ((1 - {m}) + {m} * {k_%1})", k),
                {QT_TRANSLATE_NOOP("Derive", "n at this m where Z1 / Z2 is %1; it is m where both are equal."), {k}},
                {placeAt(m_record.place().m)});
        }
    }

    /// From weights on the screen to weights in space at the sample, and back.
    void writeFace()
    {
        const auto& corners = m_sample.triangle->screen.vertices;
        const CanvasPart point{CanvasKind::Sample, QStringLiteral("P"), {m_record.pixels(m_sample.point)}};
        constexpr const char* kNames[] = {"alpha", "beta", "gamma"};
        for (std::size_t i = 0; i < 3; ++i) {
            const CanvasPart corner{CanvasKind::Corner, cornerLetter(i), {m_record.pixels(corners[i].position)}};
            m_writer.given(QLatin1String(kNames[i]), m_fragment.screen[i]);
            m_writer.given(QStringLiteral("w_") + cornerLetter(i), 1 / corners[i].invW, corner);
        }
        m_writer.line(formula("{w}"), formula("1 / ({alpha} / {w_A} + {beta} / {w_B} + {gamma} / {w_C})"),
                      QT_TRANSLATE_NOOP("Derive",
                                        "The same over a face, at the pixel: 1 / w is linear on the screen, so the "
                                        "weights on the screen give it, and it gives w."),
                      {point});
        if (m_record.rules().perspectiveCorrect)
            for (std::size_t i = 0; i < 3; ++i)
                m_writer.given(QLatin1String(kNames[i]) + QStringLiteral("_p"), m_fragment.weights[i]);
        m_writer.line(formula("({alpha_p}, {beta_p}, {gamma_p})"),
                      formula("({alpha} / {w_A} * {w}, {beta} / {w_B} * {w}, {gamma} / {w_C} * {w})"),
                      QT_TRANSLATE_NOOP("Derive", "The weights in space, which attributes are weighted with."),
                      {point});
        m_writer.line(formula("{sum}"), formula("{alpha_p} + {beta_p} + {gamma_p}"),
                      QT_TRANSLATE_NOOP("Derive", "They add up to 1, because w was chosen so."), {point});
        m_writer.line(formula("{w}"), formula("{alpha_p} * {w_A} + {beta_p} * {w_B} + {gamma_p} * {w_C}"),
                      QT_TRANSLATE_NOOP("Derive",
                                        "From the matrix: it is linear, so w P' = alpha wA A' + beta wB B' + gamma wC "
                                        "C' with the weights in space; the last row is this sum."),
                      {point});
        m_writer.line(formula("({alpha}, {beta}, {gamma})"),
                      formula("({alpha_p} * {w_A} / {w}, {beta_p} * {w_B} / {w}, {gamma_p} * {w_C} / {w})"),
                      QT_TRANSLATE_NOOP("Derive", "Divided by w: the weights of A', B' and C' on the screen."),
                      {point});
    }

    const FaceRecord& m_record;
    const SampledTriangle& m_sample;
    const FragmentStep& m_fragment;
    std::size_t m_first; ///< corner where the edge begins
    std::size_t m_last;  ///< corner where it ends
    DerivationWriter m_writer;
};

} // namespace

Derivation derivePerspective(const Scene& scene, const Settings& settings, const DerivationPlace& place,
                             const std::stop_token& stop)
{
    const FaceRecord record(scene, withArea(settings), place, stop);
    requireBeforeEye(record);
    const SampledTriangle sample = sampleOf(record, SampleNeed::Inside);
    const SampledFragment fragment = fragmentOf(record, sample, record.settings());
    return PerspectiveWriter(record, sample, fragment.numbers).write();
}

} // namespace rasterlens
