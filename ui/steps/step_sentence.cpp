#include "ui/steps/step_sentence.h"

#include "core/observe/because.h"
#include "core/observe/step_text.h"
#include "core/settings/depth_rules.h"
#include "ui/base/numbers.h"
#include "ui/base/step_words.h"
#include "ui/steps/lens_model.h"
#include "ui/steps/step_formula.h"

#include <QColor>
#include <QCoreApplication>

namespace rasterlens
{
namespace
{

/// The sentences about one event.
class Sentence
{
    Q_DECLARE_TR_FUNCTIONS(StepSentence)

public:
    Sentence(const StepLog& log, std::size_t i) : m_log(log), m_index(i), m_event(log.event(i)) {}

    [[nodiscard]] QString text() const
    {
        switch (m_event.kind) {
        case StepKind::Sample: return sample();
        case StepKind::Span: return span();
        case StepKind::Column: return tr("Column %1 is filled between its lowest and its highest row.").arg(m_event.x);
        case StepKind::LineDecision: return decision();
        case StepKind::LinePosition: return position();
        case StepKind::LineSample:
            return m_event.has(StepEvent::kCovered) ? tr("%1 belongs to the line.").arg(where()) : rest();
        case StepKind::Fragment: return fragment();
        case StepKind::Shade: return tr("%1 gets its colour from face %2.").arg(where()).arg(m_event.face);
        case StepKind::Write:
            return tr("%1 is written: colour and depth are now those of face %2.").arg(where()).arg(m_event.face);
        case StepKind::Resolve: return mean();
        case StepKind::End: return tr("The frame is finished.");
        case StepKind::Vertex:
        case StepKind::ClipPlane:
        case StepKind::CohenSutherland:
        case StepKind::Viewport:
        case StepKind::Facing:
        case StepKind::Clipped:
        case StepKind::Fate:
        case StepKind::Triangle:
        case StepKind::Setup:
        case StepKind::Outline:
        case StepKind::Walk:
        case StepKind::Sides:
        case StepKind::Halves:
        case StepKind::Crossing: break;
        }
        return rest();
    }

private:
    const StepLog& m_log;
    std::size_t m_index;
    const StepEvent& m_event;

    /// What becomes of a sample: `Pixel (3, 4)`, or `Sample (7, 9)` where pixels have several.
    [[nodiscard]] QString where() const
    {
        if (isOfPattern(m_log, m_event))
            return tr("Sample %3 of pixel (%1, %2)").arg(m_event.x).arg(m_event.y).arg(m_event.sample + 1);
        return (m_log.grid() == 1 ? tr("Pixel (%1, %2)") : tr("Sample (%1, %2)")).arg(m_event.x).arg(m_event.y);
    }

    [[nodiscard]] QString sample() const
    {
        const StepSetup& setup = m_log.triangle(m_event)->setup;
        const DecidingEdge decides = decidingEdge(setup, m_log.payload<SampleStep>(m_event).values, m_log.rules());
        const QString edge = edgeName(setup, static_cast<int>(decides.edge));
        const bool drawn = m_event.has(StepEvent::kCovered);
        const QString where = this->where();
        const auto face = m_event.face;
        if (!decides.isCentre)
            return square(edge);
        if (!decides.isTie())
            return drawn ? tr("%1 lies inside all three edges of face %2.").arg(where).arg(face)
                         : tr("%1 lies outside edge %3: face %2 does not draw it.").arg(where).arg(face).arg(edge);
        const EdgeSide side = setup.edges[decides.edge].side;
        if (side == EdgeSide::Neither)
            return (drawn ? tr("%1 lies exactly on %3, a right or bottom edge, and still face %2 draws it.")
                          : tr("%1 lies exactly on %3, a right or bottom edge: face %2 does not draw it."))
                .arg(where)
                .arg(face)
                .arg(edge);
        return (drawn ? tr("%1 lies exactly on %3, a %4 edge: face %2 draws it.")
                      : tr("%1 lies exactly on %3, a %4 edge, and still face %2 does not draw it."))
            .arg(where)
            .arg(face)
            .arg(edge, edgeSideText(side));
    }

    /// What the square of a pixel has to do with the face.
    [[nodiscard]] QString square(const QString& edge) const
    {
        const bool drawn = m_event.has(StepEvent::kCovered);
        const bool isInner = m_log.rules().coverageRule == CoverageRule::Inner;
        const QString text = isInner
                                 ? (drawn ? tr("The whole square of pixel (%1, %2) lies inside face %3.")
                                          : tr("Face %3 does not hold the whole square of pixel (%1, %2): a part of "
                                               "it lies outside edge %4."))
                                 : (drawn ? tr("Face %3 touches the square of pixel (%1, %2).")
                                          : tr("Face %3 does not touch the square of pixel (%1, %2): all of it lies "
                                               "outside edge %4."));
        const QString said = text.arg(m_event.x).arg(m_event.y).arg(m_event.face);
        return drawn ? said : said.arg(edge);
    }

    [[nodiscard]] QString span() const
    {
        const SpanStep& span = m_log.payload<SpanStep>(m_event);
        return span.xBegin < span.xEnd
                   ? tr("Row %1 of face %2 is filled from x = %3 to %4.")
                         .arg(m_event.y)
                         .arg(m_event.face)
                         .arg(span.xBegin)
                         .arg(span.xEnd - 1)
                   : tr("Row %1 of face %2 holds no pixel centre.").arg(m_event.y).arg(m_event.face);
    }

    [[nodiscard]] QString decision() const
    {
        const LineDecision& d = m_log.payload<LineStep>(m_event).decision;
        return (d.sideways ? tr("p = %1 is greater than 0: the line steps aside.")
                           : tr("p = %1 is not greater than 0: the line goes straight on."))
            .arg(QString::number(d.decision).replace(QLatin1Char('-'), QChar(0x2212)));
    }

    [[nodiscard]] QString position() const
    {
        const LinePosition& p = m_log.payload<LinePositionStep>(m_event).position;
        const auto number = [](double value) { return shortNumber(value).replace(QLatin1Char('-'), QChar(0x2212)); };
        return (p.steep() ? tr("x = %1 is rounded to %2: an error of %3.")
                          : tr("y = %1 is rounded to %2: an error of %3."))
            .arg(number(p.steep() ? p.x : p.y), number(p.steep() ? p.column : p.row), number(p.error()));
    }

    [[nodiscard]] QString fragment() const
    {
        if (depthSign(m_log.rules(), m_event.face)[0] == '\0')
            return tr("%1 of face %2 is taken: depth is not tested.").arg(where()).arg(m_event.face);
        const FragmentStep& step = m_log.payload<FragmentStep>(m_event);
        const bool passed = m_event.has(StepEvent::kPassed);
        return (passed ? tr("%1: face %2, at depth %3 against %4, passes the depth test.")
                       : tr("%1: face %2, at depth %3 against %4, fails the depth test."))
            .arg(where())
            .arg(m_event.face)
            .arg(shortNumber(double(step.depth)), shortNumber(double(step.storedDepth)));
    }

    [[nodiscard]] QString mean() const
    {
        const ResolvedPixel& pixel = m_log.payload<ResolveStep>(m_event).pixel;
        const QColor color{QRgb(pixel.color)};
        return tr("The mean of the %3 samples of pixel (%1, %2) is (%4, %5, %6).")
            .arg(pixel.x)
            .arg(pixel.y)
            .arg(pixel.count)
            .arg(color.red())
            .arg(color.green())
            .arg(color.blue());
    }

    /// Steps whose words say it all.
    [[nodiscard]] QString rest() const
    {
        const QString what = stepWords(stepParts(m_log, m_index).what);
        return what.isEmpty() ? stepTitle(m_log, m_index)
                              : QStringLiteral("%1: %2").arg(stepTitle(m_log, m_index), what);
    }
};

} // namespace

QString stepSentence(const StepLog& log, std::size_t i)
{
    const QString text = Sentence(log, i).text();
    const QString because = becauseWords(becauseOf(log, i));
    return because.isEmpty() || text.contains(because) ? text : text + QStringLiteral(" \u2014 ") + because;
}

} // namespace rasterlens
