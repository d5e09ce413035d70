#include "core/derive/topic_list.h"

#include <QCoreApplication>

#include <algorithm>
#include <optional>

namespace rasterlens
{
namespace
{

/// So many samples of the box are counted at most.
constexpr double kMostSamples = 4e6;

/// How many samples of a triangle's box each way to ask takes for inside.
struct InsideCounts {
    int strict = 0;    ///< all edge values > 0
    int inclusive = 0; ///< all edge values >= 0
    int drawn = 0;     ///< by the rules
};

std::optional<InsideCounts> countInside(const FaceRecord& record, const StepSetup& setup)
{
    const PixelRect& box = setup.bounds;
    if (double(box.width) * box.height > kMostSamples)
        return std::nullopt;
    InsideCounts counts;
    for (int y = box.y; y < box.y + box.height; ++y)
        for (int x = box.x; x < box.x + box.width; ++x) {
            const EdgeValues values = testedValues(setup, record.rules(), x, y);
            const double least = std::ranges::min(values);
            counts.strict += least > 0 ? 1 : 0;
            counts.inclusive += least >= 0 ? 1 : 0;
            counts.drawn += decidingEdge(setup, values, record.rules()).isInside() ? 1 : 0;
        }
    return counts;
}

/// Writes the forms in which texts ask whether a sample is inside.
class InsideWriter
{
public:
    InsideWriter(const FaceRecord& record, const SampledTriangle& sample)
        : m_record(record), m_sample(sample), m_setup(sample.triangle->setup),
          m_writer(DerivationTopic::Inside, pixelReason(record, sample))
    {
        for (std::size_t i = 0; i < 3; ++i) {
            m_names[i] = edgeName(m_setup, static_cast<int>(i));
            const QString letter = m_names[i].left(1);
            const CanvasPart corner{CanvasKind::Corner, letter, {cornerAt(i)}};
            m_writer.given(letter + QStringLiteral("_x"), m_setup.vertices[i].x, corner);
            m_writer.given(letter + QStringLiteral("_y"), m_setup.vertices[i].y, corner);
            m_writer.given(QStringLiteral("E_") + m_names[i], sample.values[i], edgeMark(i));
        }
    }

    Derivation write()
    {
        writeOneSign();
        writeEitherSign();
        writeBarycentric();
        writeOwners();
        writeCounts();
        return m_writer.take();
    }

private:
    [[nodiscard]] glm::dvec2 cornerAt(std::size_t i) const { return m_record.pixels(m_setup.vertices[i]); }
    [[nodiscard]] CanvasPart edgeMark(std::size_t edge) const
    {
        return edgePart(m_names[edge], cornerAt(edge), cornerAt((edge + 1) % 3));
    }
    [[nodiscard]] std::vector<CanvasPart> edges() const { return {edgeMark(0), edgeMark(1), edgeMark(2)}; }
    /// %1, %2, %3 are the names of the edges.
    [[nodiscard]] QString text(const char* pattern) const
    {
        return formula(pattern, m_names[0], m_names[1], m_names[2]);
    }

    void writeOneSign()
    {
        m_writer.compare(text("min({E_%1}, {E_%2}, {E_%3}) > 0"),
                         QT_TRANSLATE_NOOP("Derive",
                                           "Form 1, strict: the sample is inside if the least of the three edge values "
                                           "is positive. A centre on a shared edge is in neither triangle: holes."),
                         edges());
        m_writer.compare(text("min({E_%1}, {E_%2}, {E_%3}) >= 0"),
                         QT_TRANSLATE_NOOP("Derive",
                                           "Form 2, inclusive: 0 counts as inside. A centre on a shared edge is in "
                                           "both triangles: drawn twice."),
                         edges());
    }

    /// "All of one sign, whichever": the product of the least and the greatest says it in one number.
    void writeEitherSign()
    {
        m_writer.line(text("({F_%1}, {F_%2}, {F_%3})"), text("(-{E_%1}, -{E_%2}, -{E_%3})"),
                      QT_TRANSLATE_NOOP("Derive",
                                        "The cross products of a text with y down, or of corners in the other order: "
                                        "all three signs turn together."),
                      edges());
        m_writer.compare(text("max({F_%1}, {F_%2}, {F_%3}) <= 0"),
                         QT_TRANSLATE_NOOP("Derive", "Form 2 for these: inside is negative."), edges());
        m_writer.compare(
            text("min({E_%1}, {E_%2}, {E_%3}) * max({E_%1}, {E_%2}, {E_%3}) >= 0"),
            QT_TRANSLATE_NOOP("Derive", "Form 3: all >= 0 or all <= 0, whatever the order of the corners. That is so "
                                        "exactly if the least and the greatest have no different signs."),
            edges());
        m_writer.compare(text("min({E_%1}, {E_%2}, {E_%3}) * max({E_%1}, {E_%2}, {E_%3}) > 0"),
                         QT_TRANSLATE_NOOP("Derive", "Form 3, strict: all > 0 or all < 0."), edges());
    }

    void writeBarycentric()
    {
        constexpr const char* kWeights[] = {"alpha", "beta", "gamma"};
        std::array<QString, 3> quotients;
        for (std::size_t edge = 0; edge < 3; ++edge) {
            const std::size_t corner = m_setup.source[(edge + 2) % 3];
            m_writer.show(QLatin1String(kWeights[corner]),
                          areaPart(m_names[edge] + QLatin1Char('P'),
                                   {cornerAt(edge), cornerAt((edge + 1) % 3), m_record.pixels(m_sample.point)}));
            quotients[corner] =
                formula("{E_%4} / ({E_%1} + {E_%2} + {E_%3})", m_names[0], m_names[1], m_names[2], m_names[edge]);
        }
        m_writer.line(formula("({alpha}, {beta}, {gamma})"),
                      QStringLiteral("(%1, %2, %3)").arg(quotients[0], quotients[1], quotients[2]),
                      QT_TRANSLATE_NOOP("Derive",
                                        "Form 4: the weights of A, B and C. Outside one or two of them are negative, "
                                        "and their sum is still 1."),
                      edges());
        m_writer.compare(formula("min({alpha}, {beta}, {gamma}) >= 0"),
                         QT_TRANSLATE_NOOP("Derive",
                                           "Inside if no weight is negative: form 2 again, as the sum of the edge "
                                           "values has the sign of the triangle."),
                         edges());
    }

    /// The top-left rule as a comparison of the ends of each edge, and what the program asks.
    void writeOwners()
    {
        for (std::size_t edge = 0; edge < 3; ++edge) {
            const QString from = m_names[edge].left(1);
            const QString to = m_names[edge].right(1);
            const bool isLevel = m_setup.vertices[edge].y == m_setup.vertices[(edge + 1) % 3].y;
            m_writer.compare(
                formula(isLevel ? "{%2_x} < {%1_x}" : "{%2_y} > {%1_y}", from, to),
                isLevel ? Reason(QT_TRANSLATE_NOOP("Derive", "Edge %1 is level. It is a top edge if it runs to the "
                                                             "left."),
                                 {m_names[edge]})
                        : Reason(QT_TRANSLATE_NOOP("Derive",
                                                   "Edge %1: with the corners counter-clockwise it is a left edge if "
                                                   "it runs down the screen. Where the corners run clockwise the "
                                                   "comparison turns round."),
                                 {m_names[edge]}),
                {edgeMark(edge)});
            const QString threshold = QStringLiteral("t_") + m_names[edge];
            m_writer.given(threshold, m_setup.edges[edge].threshold / m_setup.unitsPerArea);
            m_writer.compare(formula("{E_%1} >= {t_%1}", m_names[edge]),
                             {QT_TRANSLATE_NOOP("Derive", "What the program asks of %1. Under the top-left rule t is 0 "
                                                          "for left and top edges, and the smallest value above 0 for "
                                                          "the others: a bias of one step."),
                              {m_names[edge]}},
                             {edgeMark(edge)});
        }
    }

    void writeCounts()
    {
        const std::optional<InsideCounts> counts = countInside(m_record, m_setup);
        if (!counts)
            return;
        m_writer.given(QStringLiteral("strict"), counts->strict);
        m_writer.given(QStringLiteral("inclusive"), counts->inclusive);
        m_writer.given(QStringLiteral("drawn"), counts->drawn);
        m_writer.line(formula("{on_edges}"), formula("{inclusive} - {strict}"),
                      QT_TRANSLATE_NOOP("Derive",
                                        "Counted over the whole triangle: samples that form 2 takes and form 1 does "
                                        "not. Their centres lie on an edge exactly."));
        m_writer.line(formula("{owned}"), formula("{drawn} - {strict}"),
                      QT_TRANSLATE_NOOP("Derive", "Those of them that the rule in use gives to this triangle; the "
                                                  "others belong to its neighbours."));
    }

    const FaceRecord& m_record;
    const SampledTriangle& m_sample;
    const StepSetup& m_setup;
    std::array<QString, 3> m_names; ///< of the edges
    DerivationWriter m_writer;
};

} // namespace

Derivation deriveInside(const Scene& scene, const Settings& settings, const DerivationPlace& place,
                        const std::stop_token& stop)
{
    const FaceRecord record(scene, withArea(settings), place, stop);
    const SampledTriangle sample = sampleOf(record, SampleNeed::Any);
    return InsideWriter(record, sample).write();
}

} // namespace rasterlens
