#include "core/derive/topic_list.h"

#include <QCoreApplication>

#include <algorithm>

namespace rasterlens
{
namespace
{

/// An edge of the setup by its letters: from U to V.
struct EdgeNames {
    QString edge; ///< `AB`
    QString from; ///< `A`
    QString to;   ///< `B`
};

EdgeNames namesOf(const StepSetup& setup, std::size_t edge)
{
    const QString name = edgeName(setup, static_cast<int>(edge));
    return {name, name.left(1), name.right(1)};
}

/// The edge of the set-up that is an edge of the triangle; of a clockwise one it leads the other way.
std::size_t edgeOfSetup(const StepSetup& setup, std::size_t edge)
{
    const std::size_t opposite = (edge + 2) % 3; // the corner that is not on it
    const auto at = static_cast<std::size_t>(std::ranges::find(setup.source, opposite) - setup.source.begin());
    return (at + 1) % 3;
}

/// Writes the derivation of one edge function at one sample.
class EdgeFunctionWriter
{
public:
    EdgeFunctionWriter(const FaceRecord& record, const SampledTriangle& sample)
        : m_record(record), m_sample(sample), m_setup(sample.triangle->setup),
          m_edge(edgeOfSetup(m_setup, record.edge())), m_names(namesOf(m_setup, m_edge)),
          m_writer(DerivationTopic::EdgeFunction, pixelReason(record, sample))
    {
        for (std::size_t i = 0; i < 3; ++i) {
            const QString letter = cornerLetter(m_setup.source[i]);
            const CanvasPart corner{CanvasKind::Corner, letter, {cornerAt(i)}};
            m_writer.given(letter + QStringLiteral("_x"), m_setup.vertices[i].x, corner);
            m_writer.given(letter + QStringLiteral("_y"), m_setup.vertices[i].y, corner);
        }
        const CanvasPart point{CanvasKind::Sample, QStringLiteral("P"), {record.pixels(sample.point)}};
        m_writer.given(QStringLiteral("P_x"), sample.point.x, point);
        m_writer.given(QStringLiteral("P_y"), sample.point.y, point);
    }

    Derivation write()
    {
        writeCrossProduct();
        writeExpansion();
        writeSteps();
        writeVerdict();
        writeOtherEdges();
        writeFacing();
        return m_writer.take();
    }

private:
    [[nodiscard]] glm::dvec2 cornerAt(std::size_t i) const { return m_record.pixels(m_setup.vertices[i]); }
    [[nodiscard]] glm::dvec2 point() const { return m_record.pixels(m_sample.point); }
    [[nodiscard]] CanvasPart edgeMark(std::size_t edge) const
    {
        return edgePart(edgeName(m_setup, static_cast<int>(edge)), cornerAt(edge), cornerAt((edge + 1) % 3));
    }
    [[nodiscard]] QString text(const char* pattern) const
    {
        return formula(pattern, m_names.edge, m_names.from, m_names.to);
    }

    void writeCrossProduct()
    {
        const CanvasPart along = vectorPart(m_names.edge, cornerAt(m_edge), cornerAt((m_edge + 1) % 3));
        const CanvasPart across = vectorPart(m_names.from + QLatin1Char('P'), cornerAt(m_edge), point());
        for (const char* axis : {"_x", "_y"}) {
            m_writer.show(along.name + QLatin1String(axis), along);
            m_writer.show(across.name + QLatin1String(axis), across);
        }
        m_writer.line(text("({%1_x}, {%1_y})"), text("({%3_x} - {%2_x}, {%3_y} - {%2_y})"),
                      {QT_TRANSLATE_NOOP("Derive", "The edge as a vector, from %1 to %2; y runs down."),
                       {m_names.from, m_names.to}},
                      {along});
        m_writer.line(text("({%2P_x}, {%2P_y})"), text("({P_x} - {%2_x}, {P_y} - {%2_y})"),
                      {QT_TRANSLATE_NOOP("Derive", "From %1 to the sample P."), {m_names.from}}, {across});
        m_writer.show(text("F_%1"), areaPart(m_names.edge + QLatin1Char('P'),
                                             {cornerAt(m_edge), cornerAt((m_edge + 1) % 3), point()}));
        m_writer.line(
            text("{F_%1}"), text("{%1_x} * {%2P_y} - {%1_y} * {%2P_x}"),
            {QT_TRANSLATE_NOOP("Derive", "The cross product of the two vectors points along z, and has this "
                                         "length: twice the area of the triangle %1P, with a sign. What z the "
                                         "vectors themselves have does not matter to it."),
             {m_names.edge}},
            {along, across});
    }

    void writeExpansion()
    {
        m_writer.given(text("E_%1"), m_sample.values[m_edge], edgeMark(m_edge));
        m_writer.line(text("{E_%1}"), text("-{F_%1}"),
                      QT_TRANSLATE_NOOP("Derive",
                                        "With y down the product is negative inside a triangle that runs "
                                        "counter-clockwise. The program turns the sign round, so that inside is "
                                        "positive; a text that keeps it tests F <= 0."),
                      {edgeMark(m_edge)});
        m_writer.line(text("{E_%1}"),
                      text("({%3_y} - {%2_y}) * ({P_x} - {%2_x}) - ({%3_x} - {%2_x}) * ({P_y} - {%2_y})"),
                      QT_TRANSLATE_NOOP("Derive", "The coordinates put in."), {edgeMark(m_edge)});
        m_writer.line(text("({a_%1}, {b_%1}, {c_%1})"),
                      text("({%3_y} - {%2_y}, {%2_x} - {%3_x}, {%2_y} * {%3_x} - {%2_x} * {%3_y})"),
                      QT_TRANSLATE_NOOP("Derive",
                                        "What stands before x, what stands before y, and what stands alone, once "
                                        "the products are multiplied out. P does not occur in them: they are "
                                        "computed once a triangle."),
                      {edgeMark(m_edge)});
        m_writer.line(text("{E_%1}"), text("{a_%1} * {P_x} + {b_%1} * {P_y} + {c_%1}"),
                      QT_TRANSLATE_NOOP("Derive", "The line equation: 0 on the edge, a plane over the picture."),
                      {edgeMark(m_edge)});
    }

    void writeSteps()
    {
        const StepSetup& s = m_setup;
        const auto valueAt = [&](const glm::dvec2& step) {
            return s.at(m_sample.point + step)[m_edge] / s.unitsPerArea;
        };
        const auto neighbour = [&](const glm::dvec2& step) {
            return CanvasPart{CanvasKind::Sample, QString(), {m_record.pixels(m_sample.point + step)}};
        };
        m_writer.given(text("E_%1_right"), valueAt({1, 0}), neighbour({1, 0}));
        m_writer.given(text("E_%1_below"), valueAt({0, 1}), neighbour({0, 1}));
        m_writer.line(text("{E_%1_right}"), text("{E_%1} + {a_%1}"),
                      QT_TRANSLATE_NOOP("Derive", "One sample to the right x grows by 1: one addition instead of two "
                                                  "products."),
                      {neighbour({1, 0})});
        m_writer.line(text("{E_%1_below}"), text("{E_%1} + {b_%1}"),
                      QT_TRANSLATE_NOOP("Derive",
                                        "One row down y grows by 1: the start of the next row is one addition "
                                        "away, too."),
                      {neighbour({0, 1})});
    }

    [[nodiscard]] Reason sideWords() const
    {
        switch (m_setup.edges[m_edge].side) {
        case EdgeSide::Left:
            return {QT_TRANSLATE_NOOP("Derive", "%1 is a left edge. t is the smallest value that counts as inside."),
                    {m_names.edge}};
        case EdgeSide::Top:
            return {QT_TRANSLATE_NOOP("Derive", "%1 is a top edge. t is the smallest value that counts as inside."),
                    {m_names.edge}};
        case EdgeSide::Neither: break;
        }
        return {
            QT_TRANSLATE_NOOP("Derive", "%1 is a right or bottom edge. t is the smallest value that counts as inside."),
            {m_names.edge}};
    }

    void writeVerdict()
    {
        m_writer.given(text("t_%1"), m_setup.edges[m_edge].threshold / m_setup.unitsPerArea);
        m_writer.compare(text("{E_%1} >= {t_%1}"), sideWords(), {edgeMark(m_edge)});
    }

    void writeOtherEdges()
    {
        QString sum = text("{E_%1}");
        for (std::size_t k = 1; k < 3; ++k) {
            const std::size_t edge = (m_edge + k) % 3;
            const EdgeNames names = namesOf(m_setup, edge);
            const auto with = [&](const char* pattern) { return formula(pattern, names.edge, names.from, names.to); };
            m_writer.given(with("E_%1"), m_sample.values[edge], edgeMark(edge));
            m_writer.given(with("t_%1"), m_setup.edges[edge].threshold / m_setup.unitsPerArea);
            m_writer.line(
                with("{E_%1}"), with("({%3_y} - {%2_y}) * ({P_x} - {%2_x}) - ({%3_x} - {%2_x}) * ({P_y} - {%2_y})"),
                {QT_TRANSLATE_NOOP("Derive", "The same formula for the edge %1."), {names.edge}}, {edgeMark(edge)});
            m_writer.compare(with("{E_%1} >= {t_%1}"),
                             {QT_TRANSLATE_NOOP("Derive", "On which side of %1 the sample lies."), {names.edge}},
                             {edgeMark(edge)});
            sum += with(" + {E_%1}");
        }
        m_writer.show(QStringLiteral("S"), areaPart(QStringLiteral("ABC"), {cornerAt(0), cornerAt(1), cornerAt(2)}));
        m_writer.line(QStringLiteral("{S}"), sum,
                      QT_TRANSLATE_NOOP("Derive", "Wherever the sample lies, the three add up to twice the area of the "
                                                  "triangle."),
                      {areaPart(QStringLiteral("ABC"), {cornerAt(0), cornerAt(1), cornerAt(2)})});
    }

    void writeFacing()
    {
        const auto& corners = m_sample.triangle->screen.vertices;
        const auto vector = [&](const char* name, std::size_t from, std::size_t to) {
            return vectorPart(QLatin1String(name), m_record.pixels(corners[from].position),
                              m_record.pixels(corners[to].position));
        };
        const CanvasPart ab = vector("AB", 0, 1);
        const CanvasPart bc = vector("BC", 1, 2);
        for (const CanvasPart& part : {ab, bc})
            for (const char* axis : {"_x", "_y"})
                m_writer.show(part.name + QLatin1String(axis), part);
        m_writer.line(formula("({AB_x}, {AB_y})"), formula("({B_x} - {A_x}, {B_y} - {A_y})"),
                      QT_TRANSLATE_NOOP("Derive",
                                        "Which way the face looks is told by two of its edges, in the order of "
                                        "its corners. The first one."),
                      {ab});
        m_writer.line(formula("({BC_x}, {BC_y})"), formula("({C_x} - {B_x}, {C_y} - {B_y})"),
                      QT_TRANSLATE_NOOP("Derive", "The second one."), {bc});
        m_writer.given(QStringLiteral("area2"), m_sample.triangle->screen.area2);
        m_writer.line(formula("{area2}"), formula("-({AB_x} * {BC_y} - {AB_y} * {BC_x})"),
                      QT_TRANSLATE_NOOP("Derive",
                                        "Twice the area with a sign: the z of AB x BC, turned round because y runs "
                                        "down."),
                      {ab, bc});
        m_writer.given(QStringLiteral("s"), m_record.rules().frontSign);
        m_writer.compare(formula("{area2} * {s} > 0"),
                         QT_TRANSLATE_NOOP("Derive",
                                           "A front face, if it holds. s is 1 where counter-clockwise is front, "
                                           "and -1 where clockwise is."),
                         {ab, bc});
    }

    const FaceRecord& m_record;
    const SampledTriangle& m_sample;
    const StepSetup& m_setup;
    std::size_t m_edge;
    EdgeNames m_names;
    DerivationWriter m_writer;
};

} // namespace

Derivation deriveEdgeFunction(const Scene& scene, const Settings& settings, const DerivationPlace& place,
                              const std::stop_token& stop)
{
    const FaceRecord record(scene, withArea(settings), place, stop);
    const SampledTriangle sample = sampleOf(record, SampleNeed::Any);
    return EdgeFunctionWriter(record, sample).write();
}

} // namespace rasterlens
