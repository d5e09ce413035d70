#include "core/derive/topic_list.h"

#include <QCoreApplication>

namespace rasterlens
{
namespace
{

/// What edge walking recorded of the row a sample lies in.
struct WalkedRow {
    WalkedTriangle walk;
    SpanEnds ends;
};

WalkedRow rowOf(const FaceRecord& record, const SampledTriangle& sample)
{
    if (record.rules().wholeRows)
        throw NoDerivation{Reason(QT_TRANSLATE_NOOP(
            "Derive", "a mistake crosses the rows at whole heights, not at the centres that are interpolated to"))};
    std::optional<WalkedTriangle> walk;
    for (const StepEvent& event : record.log().events()) {
        if (event.kind == StepKind::Walk)
            walk = record.log().payload<WalkStep>(event).walk;
        if (event.kind != StepKind::Span || event.y != sample.y || !walk)
            continue;
        const SpanStep& span = record.log().payload<SpanStep>(event);
        if (sample.x >= span.xBegin && sample.x < span.xEnd)
            return {*walk, span.ends};
    }
    throw NoDerivation{Reason(QT_TRANSLATE_NOOP("Derive", "edge walking does not fill the pixel (%1, %2)"),
                              {sample.x / record.rules().sampleGrid, sample.y / record.rules().sampleGrid})};
}

/// Writes the interpolation along the long edge, the short edge and the span.
class TwoPointWriter
{
public:
    TwoPointWriter(const FaceRecord& record, const SampledTriangle& sample, const FragmentStep& fragment)
        : m_record(record), m_sample(sample), m_fragment(fragment), m_row(rowOf(record, sample)),
          m_writer(DerivationTopic::TwoPoint, pixelReason(record, sample))
    {
        const auto& screen = sample.triangle->screen.vertices;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t source = m_row.walk.source[i];
            const CanvasPart corner{CanvasKind::Corner, cornerLetter(source), {record.pixels(m_row.walk.vertices[i])}};
            const QString number = QString::number(i + 1);
            m_writer.given(QStringLiteral("x_") + number, m_row.walk.vertices[i].x, corner);
            m_writer.given(QStringLiteral("y_") + number, m_row.walk.vertices[i].y, corner);
            m_writer.given(QStringLiteral("w_") + number, 1 / screen[source].invW, corner);
        }
        const CanvasPart row{
            CanvasKind::Row,
            QString(),
            {record.pixels({0, sample.point.y}), record.pixels({double(record.rules().columns()), sample.point.y})}};
        m_writer.given(QStringLiteral("y"), sample.point.y, row);
        m_writer.given(QStringLiteral("x"), sample.point.x,
                       {CanvasKind::Sample, QStringLiteral("P"), {record.pixels(sample.point)}});
    }

    Derivation write()
    {
        writeOrder();
        writeUnsortedW();
        writeEdge(
            "long", "1", "3", m_row.ends.longEdgeIsLeft,
            QT_TRANSLATE_NOOP("Derive", "The long edge runs from the first corner to the third: t from y alone."));
        if (m_row.ends.upperHalf)
            writeEdge("short", "1", "2", !m_row.ends.longEdgeIsLeft,
                      QT_TRANSLATE_NOOP("Derive",
                                        "The row lies in the upper half: the short edge runs from the first corner to "
                                        "the second."));
        else
            writeEdge("short", "2", "3", !m_row.ends.longEdgeIsLeft,
                      QT_TRANSLATE_NOOP("Derive",
                                        "The row lies in the lower half: the short edge runs from the second corner "
                                        "to the third."));
        writeSpan();
        writeWeights();
        return m_writer.take();
    }

private:
    void writeOrder()
    {
        m_writer.compare(formula("{y_1} <= {y_2}"),
                         QT_TRANSLATE_NOOP("Derive",
                                           "The corners are sorted by y and numbered 1, 2, 3 from the top. The second "
                                           "is not above..."));
        m_writer.compare(formula("{y_2} <= {y_3}"),
                         QT_TRANSLATE_NOOP("Derive", "...and not below its neighbours in this order."));
        m_writer.compare(formula(m_row.ends.upperHalf ? "{y} <= {y_2}" : "{y} >= {y_2}"),
                         QT_TRANSLATE_NOOP("Derive",
                                           "The centre line of the row, and the half it lies in: the second corner is "
                                           "where the triangle is divided."));
    }

    /// Exchanges of w that are done whether corners are exchanged or not leave the w of C, B, A.
    void writeUnsortedW()
    {
        std::array<QString, 3> numbers; // in the order of height, of corners A, B, C
        for (std::size_t i = 0; i < 3; ++i)
            numbers[m_row.walk.source[i]] = QString::number(i + 1);
        m_writer.line(formula("({w_1'}, {w_2'}, {w_3'})"),
                      formula("({w_%1}, {w_%2}, {w_%3})", numbers[2], numbers[1], numbers[0]),
                      QT_TRANSLATE_NOOP("Derive",
                                        "A slip worth knowing: if (a.y > b.y) swap(points); swap(w); has no braces, so "
                                        "w is exchanged all three times. The corners then have the w of C, B and A, "
                                        "whatever their heights."));
    }

    /// The way along an edge: t, the point on the screen, n and w there.
    void writeEdge(const char* edge, const char* from, const char* to, bool isLeft, Reason words)
    {
        const QString e = QLatin1String(edge);
        const QString a = QLatin1String(from);
        const QString b = QLatin1String(to);
        const auto part = [&] {
            const glm::dvec2& p = m_row.walk.vertices[std::size_t(a.toInt() - 1)];
            const glm::dvec2& q = m_row.walk.vertices[std::size_t(b.toInt() - 1)];
            return edgePart(cornerLetter(m_row.walk.source[std::size_t(a.toInt() - 1)]) +
                                cornerLetter(m_row.walk.source[std::size_t(b.toInt() - 1)]),
                            m_record.pixels(p), m_record.pixels(q));
        }();
        const auto with = [&](const char* pattern) { return formula(pattern, e, a, b); };
        m_writer.line(with("{t_%1}"), with("({y} - {y_%2}) / ({y_%3} - {y_%2})"), std::move(words), {part});
        m_writer.given(
            with("x_%1"), isLeft ? m_row.ends.left : m_row.ends.right,
            {CanvasKind::Point, e, {m_record.pixels({isLeft ? m_row.ends.left : m_row.ends.right, m_sample.point.y})}});
        m_writer.line(with("{x_%1}"), with("lerp({x_%2}, {x_%3}, {t_%1})"),
                      QT_TRANSLATE_NOOP("Derive", "Where the edge crosses the row: lerp(a, b, t) = a + t (b - a)."),
                      {part});
        writeFraction(e, QStringLiteral("t_") + e, QStringLiteral("w_") + a, QStringLiteral("w_") + b, part);
    }

    /// n of a way from one w to another, and w there.
    void writeFraction(const QString& name, const QString& t, const QString& w1, const QString& w2,
                       const CanvasPart& part)
    {
        if (m_record.rules().perspectiveCorrect)
            m_writer.line(
                formula("{n_%1}", name), formula("{%2} * {%3} / ((1 - {%2}) * {%4} + {%2} * {%3})", name, t, w1, w2),
                QT_TRANSLATE_NOOP("Derive", "The part of the way in space that belongs to this part of the way on the "
                                            "screen."),
                {part});
        else
            m_writer.line(formula("{n_%1}", name), formula("{%1}", t),
                          QT_TRANSLATE_NOOP("Derive",
                                            "Affine interpolation takes the part of the way on the screen for the "
                                            "part in space."),
                          {part});
        m_writer.line(formula("{w_%1}", name), formula("lerp({%2}, {%3}, {n_%1})", name, w1, w2),
                      QT_TRANSLATE_NOOP("Derive", "w there: it is an attribute like the others."), {part});
    }

    void writeSpan()
    {
        const CanvasPart span = edgePart(QStringLiteral("span"), m_record.pixels({m_row.ends.left, m_sample.point.y}),
                                         m_record.pixels({m_row.ends.right, m_sample.point.y}));
        m_writer.line(formula("{m}"), formula("({x} - {x_long}) / ({x_short} - {x_long})"),
                      QT_TRANSLATE_NOOP("Derive",
                                        "Along the span, from the long edge to the short one: the lerp number of the "
                                        "sample."),
                      {span});
        writeFraction(QStringLiteral("span"), QStringLiteral("m"), QStringLiteral("w_long"), QStringLiteral("w_short"),
                      span);
        m_writer.line(formula("{n_slip}"), formula("{m} * {w_short} / ((1 - {m}) * {w_long} + {m} * {w_short})"),
                      QT_TRANSLATE_NOOP("Derive",
                                        "A slip worth knowing: a program that exchanges the ends of the span, so that "
                                        "it runs from left to right, and forgets to exchange their w, takes this "
                                        "number in place of n."),
                      {span});
    }

    /// What the three corners contribute in the end.
    void writeWeights()
    {
        constexpr const char* kNames[] = {"alpha_p", "beta_p", "gamma_p"};
        const std::array<QString, 3> sums =
            m_row.ends.upperHalf
                ? std::array<QString, 3>{formula("(1 - {n_span}) * (1 - {n_long}) + {n_span} * (1 - {n_short})"),
                                         formula("{n_span} * {n_short}"), formula("(1 - {n_span}) * {n_long}")}
                : std::array<QString, 3>{formula("(1 - {n_span}) * (1 - {n_long})"),
                                         formula("{n_span} * (1 - {n_short})"),
                                         formula("(1 - {n_span}) * {n_long} + {n_span} * {n_short}")};
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t source = m_row.walk.source[i];
            const QString id = QLatin1String(kNames[source]);
            const CanvasPart corner{
                CanvasKind::Corner, cornerLetter(source), {m_record.pixels(m_row.walk.vertices[i])}};
            m_writer.given(id, m_fragment.weights[source], corner);
            m_writer.line(formula("{%1}", id), sums[i],
                          {QT_TRANSLATE_NOOP("Derive", "What corner %1 contributes to the sample after both ways."),
                           {cornerLetter(source)}},
                          {corner});
        }
    }

    const FaceRecord& m_record;
    const SampledTriangle& m_sample;
    const FragmentStep& m_fragment;
    WalkedRow m_row;
    DerivationWriter m_writer;
};

} // namespace

Derivation deriveTwoPoint(const Scene& scene, const Settings& settings, const DerivationPlace& place,
                          const std::stop_token& stop)
{
    Settings walking = withArea(settings);
    walking.algorithm = Algorithm::EdgeWalking;
    walking.attributePath = AttributePath::EdgeThenSpan;
    const FaceRecord record(scene, walking, place, stop);
    requireBeforeEye(record);
    const SampledTriangle sample = sampleOf(record, SampleNeed::Inside);
    const SampledFragment fragment = fragmentOf(record, sample, record.settings());
    return TwoPointWriter(record, sample, fragment.numbers).write();
}

} // namespace rasterlens
