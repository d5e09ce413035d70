#include "core/derive/topic_list.h"

#include <QCoreApplication>

namespace rasterlens
{
namespace
{

/// Writes the box of samples that are tested for a triangle.
class BoundsWriter
{
public:
    BoundsWriter(const FaceRecord& record, const SampledTriangle& sample)
        : m_record(record), m_bounds(sample.triangle->setup.bounds),
          m_writer(DerivationTopic::Bounds, faceReason(record))
    {
        const auto& corners = sample.triangle->screen.vertices;
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec2 position = corners[i].position;
            const CanvasPart corner{CanvasKind::Corner, cornerLetter(i), {record.pixels(position)}};
            m_writer.given(cornerLetter(i) + QStringLiteral("_x"), position.x, corner);
            m_writer.given(cornerLetter(i) + QStringLiteral("_y"), position.y, corner);
            m_low = i == 0 ? position : glm::min(m_low, position);
            m_high = i == 0 ? position : glm::max(m_high, position);
        }
        m_writer.given(QStringLiteral("W"), record.rules().columns());
        m_writer.given(QStringLiteral("H"), record.rules().rows());
    }

    Derivation write()
    {
        writeExtent();
        writeWholeNumbers();
        writeCentres();
        writeClamp();
        return m_writer.take();
    }

private:
    [[nodiscard]] double value(const char* id) const { return m_writer.valueOf(QLatin1String(id)); }

    /// A box between two corners, in samples.
    [[nodiscard]] CanvasPart box(const char* name, const glm::dvec2& low, const glm::dvec2& high) const
    {
        std::vector<glm::dvec2> corners;
        for (const glm::dvec2& corner : {low, glm::dvec2(high.x, low.y), high, glm::dvec2(low.x, high.y)})
            corners.push_back(m_record.pixels(corner));
        return areaPart(QLatin1String(name), std::move(corners));
    }

    /// A column or row of sample centres across the picture.
    [[nodiscard]] CanvasPart lineAt(CanvasKind kind, double at) const
    {
        const Rules& rules = m_record.rules();
        const glm::dvec2 from = kind == CanvasKind::Column ? glm::dvec2(at, 0) : glm::dvec2(0, at);
        const glm::dvec2 to =
            kind == CanvasKind::Column ? glm::dvec2(at, rules.rows()) : glm::dvec2(rules.columns(), at);
        return {kind, QString(), {m_record.pixels(from), m_record.pixels(to)}};
    }

    void writeExtent()
    {
        m_writer.line(formula("({x_min}, {x_max})"), formula("(min({A_x}, {B_x}, {C_x}), max({A_x}, {B_x}, {C_x}))"),
                      QT_TRANSLATE_NOOP("Derive", "The least and the greatest x of the three corners."));
        m_writer.line(formula("({y_min}, {y_max})"), formula("(min({A_y}, {B_y}, {C_y}), max({A_y}, {B_y}, {C_y}))"),
                      QT_TRANSLATE_NOOP("Derive",
                                        "The least and the greatest y. Whatever lies inside the triangle lies "
                                        "between these four numbers."),
                      {box("box", m_low, m_high)});
    }

    /// The box as texts round it: outwards, to whole samples.
    void writeWholeNumbers()
    {
        m_writer.line(formula("({left}, {right})"), formula("(floor({x_min}), ceil({x_max}))"),
                      QT_TRANSLATE_NOOP("Derive",
                                        "Rounded outwards to whole numbers, as most programs do: floor for the lesser, "
                                        "ceil for the greater. The loop runs from left on, as long as x < right."));
        m_writer.line(formula("({top}, {bottom})"), formula("(floor({y_min}), ceil({y_max}))"),
                      QT_TRANSLATE_NOOP("Derive", "The rows, in the same way. This box is never too small."),
                      {box("whole box", glm::floor(m_low), glm::ceil(m_high))});
    }

    /// The box of this program: the first and the last centre between the extremes.
    void writeCentres()
    {
        m_writer.line(formula("({x_first}, {x_last})"), formula("(ceil({x_min} - 0.5), floor({x_max} - 0.5))"),
                      QT_TRANSLATE_NOOP("Derive",
                                        "Only centres are tested, and they lie at x + 0.5: the first one that is not "
                                        "left of x_min, and the last one that is not right of x_max. This box leaves "
                                        "out columns that floor and ceil would test in vain."));
        m_writer.line(formula("({y_first}, {y_last})"), formula("(ceil({y_min} - 0.5), floor({y_max} - 0.5))"),
                      QT_TRANSLATE_NOOP("Derive", "The first and the last row of centres."));
    }

    /// The box within the picture. A mistake may leave it unclamped, or end it one early: the lines say what was done.
    void writeClamp()
    {
        const bool isClamped = m_record.rules().bounds != Bounds::Unclamped;
        const QString oneShort = m_record.rules().bounds == Bounds::OneShort ? QStringLiteral(" - 1") : QString();
        give("x_0", m_bounds.x, CanvasKind::Column);
        give("x_1", m_bounds.x + m_bounds.width - 1, CanvasKind::Column);
        give("y_0", m_bounds.y, CanvasKind::Row);
        give("y_1", m_bounds.y + m_bounds.height - 1, CanvasKind::Row);
        const Reason words =
            isClamped ? Reason(QT_TRANSLATE_NOOP("Derive", "Held within the picture of W columns and H rows: what lies "
                                                           "beyond cannot be drawn."))
                      : Reason(QT_TRANSLATE_NOOP("Derive", "Not held within the picture: samples beyond it are tested, "
                                                           "and would be written to other rows or other memory."));
        const CanvasPart tested =
            box("tested box", {m_bounds.x, m_bounds.y}, {m_bounds.x + m_bounds.width, m_bounds.y + m_bounds.height});
        if (m_record.rules().wholeRows) {
            m_writer.line(formula("({x_0}, {x_1})"), formula("(max(floor({x_min}), 0), min(floor({x_max}), {W} - 1))"),
                          QT_TRANSLATE_NOOP("Derive", "A mistake cuts both ends to whole columns, and fills both."),
                          {tested});
            m_writer.line(formula("({y_0}, {y_1})"), formula("(max(ceil({y_min}), 0), min(floor({y_max}), {H} - 1))"),
                          QT_TRANSLATE_NOOP("Derive", "It fills the rows from the first whole height to the last."),
                          {tested});
        } else if (isClamped) {
            m_writer.line(formula("({x_0}, {x_1})"), formula("(max({x_first}, 0), min({x_last}, {W} - 1)%1)", oneShort),
                          words, {tested});
            m_writer.line(formula("({y_0}, {y_1})"), formula("(max({y_first}, 0), min({y_last}, {H} - 1)%1)", oneShort),
                          words, {tested});
        } else if (m_bounds.x == value("x_first") && m_bounds.y == value("y_first")) {
            m_writer.line(formula("({x_0}, {y_0})"), formula("({x_first}, {y_first})"), words, {tested});
        }
        m_writer.line(formula("{tested}"), formula("({x_1} - {x_0} + 1) * ({y_1} - {y_0} + 1)"),
                      QT_TRANSLATE_NOOP("Derive", "So many samples are tested for this triangle."), {tested});
        m_writer.line(formula("{share}"), formula("{tested} / ({W} * {H})"),
                      QT_TRANSLATE_NOOP("Derive", "The part of the picture: without a box every sample of it would be "
                                                  "tested for every triangle."),
                      {tested});
    }

    void give(const char* id, int at, CanvasKind kind)
    {
        m_writer.given(QLatin1String(id), at, lineAt(kind, at + 0.5));
    }

    const FaceRecord& m_record;
    PixelRect m_bounds;     ///< samples
    glm::dvec2 m_low{0, 0}; ///< the least coordinates of the corners, samples
    glm::dvec2 m_high{0, 0};
    DerivationWriter m_writer;
};

} // namespace

Derivation deriveBounds(const Scene& scene, const Settings& settings, const DerivationPlace& place,
                        const std::stop_token& stop)
{
    const FaceRecord record(scene, withArea(settings), place, stop);
    return BoundsWriter(record, sampleOf(record, SampleNeed::Any)).write();
}

} // namespace rasterlens
