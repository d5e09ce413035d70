#include "core/derive/topic_list.h"

#include <QCoreApplication>

#include <algorithm>

namespace rasterlens
{
namespace
{

/// So many steps of the recurrence are written down at most.
constexpr std::size_t kMostSteps = 64;

/// A line of a face from one sample to another, and the decisions on the way.
struct RecordedLine {
    glm::ivec2 from; ///< samples
    glm::ivec2 to;
    std::vector<LineDecision> decisions;
};

glm::ivec2 sampleHolding(const glm::dvec2& position) { return glm::ivec2(glm::floor(position)); }

/// Whether a decision is the first one of a line.
bool begins(const LineDecision& decision, const RecordedLine& line)
{
    const glm::ivec2 way = glm::abs(line.to - line.from);
    return decision.step == 0 && decision.x == line.from.x && decision.y == line.from.y &&
           decision.longer == std::max(way.x, way.y) && decision.shorter == std::min(way.x, way.y) &&
           decision.steep == (way.y > way.x);
}

/// The edge of the place, of the first triangle that is drawn of the face.
///
/// errors  throws NoDerivation where nothing was decided
RecordedLine lineOf(const FaceRecord& record)
{
    const StepLog& log = record.log();
    const auto triangles = log.eventsOf(StepKind::Triangle);
    if (triangles.empty())
        throw NoDerivation{Reason(QT_TRANSLATE_NOOP("Derive", "face %1 is not drawn"), {record.place().face})};
    const auto& corners = log.triangle(log.event(triangles.front()))->screen.vertices;
    const std::size_t first = record.edge();
    RecordedLine line{sampleHolding(corners[first].position), sampleHolding(corners[(first + 1) % 3].position), {}};
    for (const std::uint32_t i : log.eventsOf(StepKind::LineDecision)) {
        const LineDecision& decision = log.payload<LineStep>(log.event(i)).decision;
        if (line.decisions.empty() ? begins(decision, line) : decision.step == int(line.decisions.size()))
            line.decisions.push_back(decision);
        else if (!line.decisions.empty())
            break;
    }
    if (line.decisions.empty())
        throw NoDerivation{
            Reason(QT_TRANSLATE_NOOP("Derive", "no step of the edge %1%2 is decided: it begins and ends in one "
                                               "pixel, or is not drawn by Bresenham's way"),
                   {cornerLetter(first), cornerLetter((first + 1) % 3)})};
    return line;
}

/// Writes the decisions of one line.
class BresenhamWriter
{
public:
    BresenhamWriter(const FaceRecord& record, const RecordedLine& line)
        : m_record(record), m_line(line), m_isSteep(line.decisions.front().steep),
          m_writer(DerivationTopic::Bresenham,
                   {QT_TRANSLATE_NOOP("Derive", "face %1, edge %2%3"),
                    {record.place().face, cornerLetter(record.edge()), cornerLetter((record.edge() + 1) % 3)}})
    {
        for (const char* axis : {"x", "y"}) {
            const int i = axis[0] == 'x' ? 0 : 1;
            m_writer.given(formula("%1_0", QString(QLatin1String(axis))), line.from[i], sampleMark(line.from));
            m_writer.given(formula("%1_1", QString(QLatin1String(axis))), line.to[i], sampleMark(line.to));
            m_writer.given(formula("s%1", QString(QLatin1String(axis))), backOr1(i));
        }
    }

    Derivation write()
    {
        writeLine();
        writeDecision(chosenStep());
        writeStart();
        writeRecurrence();
        writeTies();
        writeListing();
        return m_writer.take();
    }

private:
    [[nodiscard]] CanvasPart sampleMark(const glm::ivec2& sample) const
    {
        return {CanvasKind::Sample,
                QStringLiteral("(%1, %2)").arg(sample.x).arg(sample.y),
                {m_record.pixels(glm::dvec2(sample) + 0.5)}};
    }
    [[nodiscard]] CanvasPart edgeMark() const
    {
        return edgePart(QStringLiteral("line"), m_record.pixels(glm::dvec2(m_line.from) + 0.5),
                        m_record.pixels(glm::dvec2(m_line.to) + 0.5));
    }
    /// -1 where the line runs towards smaller numbers along an axis, else 1.
    [[nodiscard]] int backOr1(int axis) const { return m_line.to[axis] < m_line.from[axis] ? -1 : 1; }
    [[nodiscard]] const LineDecision& decision(std::size_t i) const { return m_line.decisions[i]; }

    /// A formula in which `u` is the axis that is stepped along always and `v` the other one: x and y of a flat line.
    /// %1, %2 are u and v, %3 is a step's number.
    [[nodiscard]] QString text(const char* pattern, std::size_t step = 0) const
    {
        return formula(pattern, u(), v(), QString::number(step));
    }
    [[nodiscard]] QString u() const { return m_isSteep ? QStringLiteral("y") : QStringLiteral("x"); }
    [[nodiscard]] QString v() const { return m_isSteep ? QStringLiteral("x") : QStringLiteral("y"); }

    /// The step at the pixel of the place, or the first one.
    [[nodiscard]] std::size_t chosenStep() const
    {
        const std::optional<QPoint>& pixel = m_record.place().pixel;
        if (!pixel)
            return 0;
        const int grid = m_record.rules().sampleGrid;
        for (std::size_t i = 0; i < m_line.decisions.size(); ++i)
            if (decision(i).x / grid == pixel->x() && decision(i).y / grid == pixel->y())
                return i;
        throw NoDerivation{
            Reason(QT_TRANSLATE_NOOP("Derive", "nothing is decided at pixel (%1, %2): the edge does not go on "
                                               "from there"),
                   {pixel->x(), pixel->y()})};
    }

    void writeLine()
    {
        m_writer.line(
            formula("({dx}, {dy})"), formula("(|{x_1} - {x_0}|, |{y_1} - {y_0}|)"),
            QT_TRANSLATE_NOOP("Derive", "How far the line goes along each axis; sx and sy say which way, 1 or -1."),
            {edgeMark()});
        m_writer.compare(
            text("{d%1} >= {d%2}"),
            m_isSteep ? Reason(QT_TRANSLATE_NOOP("Derive", "The line is steep: y takes a step every time, and x "
                                                           "now and then. x and y change their parts."))
                      : Reason(QT_TRANSLATE_NOOP("Derive", "The line is flat: x takes a step every time, and y now "
                                                           "and then.")),
            {edgeMark()});
        m_writer.line(formula("{m}"), text("({%2_1} - {%2_0}) / ({%1_1} - {%1_0})"),
                      m_isSteep ? Reason(QT_TRANSLATE_NOOP("Derive", "The line through both samples is x = m y + b."))
                                : Reason(QT_TRANSLATE_NOOP("Derive", "The line through both samples is y = m x + b.")),
                      {edgeMark()});
        m_writer.line(formula("{b}"), text("{%2_0} - {m} * {%1_0}"),
                      QT_TRANSLATE_NOOP("Derive", "b from the first sample."), {edgeMark()});
    }

    void writeDecision(std::size_t i)
    {
        const LineDecision& d = decision(i);
        const glm::ivec2 here(d.x, d.y);
        const glm::ivec2 way = glm::sign(m_line.to - m_line.from);
        const glm::ivec2 straight = here + (m_isSteep ? glm::ivec2(0, way.y) : glm::ivec2(way.x, 0));
        const glm::ivec2 aside = straight + (m_isSteep ? glm::ivec2(backOr1(0), 0) : glm::ivec2(0, backOr1(1)));
        m_writer.given(QStringLiteral("x_i"), d.x, sampleMark(here));
        m_writer.given(QStringLiteral("y_i"), d.y, sampleMark(here));
        m_writer.given(formula("p_%1", QString::number(d.step)), d.decision);
        // What a line passes through, d_lower and d_upper end to end.
        const glm::dvec2 begin = m_record.pixels(glm::dvec2(m_line.from) + 0.5);
        const glm::dvec2 end = m_record.pixels(glm::dvec2(m_line.to) + 0.5);
        const int along = m_isSteep ? 1 : 0;
        const glm::dvec2 lower = m_record.pixels(glm::dvec2(straight) + 0.5);
        const glm::dvec2 upper = m_record.pixels(glm::dvec2(aside) + 0.5);
        const glm::dvec2 on = begin + (lower[along] - begin[along]) / (end[along] - begin[along]) * (end - begin);
        m_writer.show(QStringLiteral("ideal"), {CanvasKind::Point, QStringLiteral("ideal"), {on}});
        m_writer.show(QStringLiteral("d_lower"), vectorPart(QStringLiteral("d_lower"), lower, on));
        m_writer.show(QStringLiteral("d_upper"), vectorPart(QStringLiteral("d_upper"), on, upper));
        m_writer.line(formula("{ideal}"), text("{m} * ({%1_i} + {s%1}) + {b}"),
                      {QT_TRANSLATE_NOOP("Derive", "Step %1: where the line itself is one step on."), {d.step}},
                      {edgeMark()});
        m_writer.line(formula("{d_lower}"), text("({ideal} - {%2_i}) * {s%2}"),
                      QT_TRANSLATE_NOOP("Derive", "From the sample straight on to the line."),
                      {sampleMark(straight), vectorPart(QStringLiteral("d_lower"), lower, on)});
        m_writer.line(
            formula("{d_upper}"), text("({%2_i} + {s%2} - {ideal}) * {s%2}"),
            QT_TRANSLATE_NOOP("Derive", "From the line to the sample that also goes aside; both distances make 1."),
            {sampleMark(aside), vectorPart(QStringLiteral("d_upper"), on, upper)});
        m_writer.line(text("{p_%3}", i), text("{d%1} * ({d_lower} - {d_upper})"),
                      QT_TRANSLATE_NOOP("Derive",
                                        "The sign of the difference decides. Times the length of the line, which is "
                                        "positive, no fraction is left in it."),
                      {sampleMark(straight), sampleMark(aside)});
        const bool isFirstOctant = !m_isSteep && m_line.to.x > m_line.from.x && m_line.to.y >= m_line.from.y;
        if (isFirstOctant) {
            m_writer.line(formula("{c}"), formula("{dx} * (2 * {b} - 1) + 2 * {dy}"),
                          QT_TRANSLATE_NOOP("Derive", "What of it does not change from step to step."), {});
            m_writer.line(text("{p_%3}", i), formula("2 * {x_i} * {dy} - 2 * {y_i} * {dx} + {c}"),
                          QT_TRANSLATE_NOOP("Derive", "Multiplied out, with m = dy / dx: whole numbers only."), {});
        }
        m_writer.compare(
            text("{p_%3} > 0", i),
            d.sideways ? Reason(QT_TRANSLATE_NOOP("Derive", "The line is nearer to the sample aside: that one is "
                                                            "taken."))
                       : Reason(QT_TRANSLATE_NOOP("Derive", "The line is not nearer to the sample aside: the next "
                                                            "one straight on is taken.")),
            {sampleMark(d.sideways ? aside : straight)});
    }

    void writeStart()
    {
        m_writer.line(formula("{p_-1}"), text("{d%1} * (0 - 1)"),
                      QT_TRANSLATE_NOOP("Derive",
                                        "The start. The line goes through the middle of its first sample: d_lower is 0 "
                                        "there and d_upper 1."),
                      {sampleMark(m_line.from)});
        m_writer.given(QStringLiteral("p_0"), decision(0).decision);
        m_writer.line(formula("{p_0}"), text("{p_-1} + 2 * {d%2}"),
                      QT_TRANSLATE_NOOP("Derive", "One step straight on from there."), {sampleMark(m_line.from)});
        m_writer.line(formula("{p_0}"), text("2 * {d%2} - {d%1}"),
                      QT_TRANSLATE_NOOP("Derive", "The value the loop begins with."), {sampleMark(m_line.from)});
    }

    void writeRecurrence()
    {
        const std::size_t count = std::min(m_line.decisions.size(), kMostSteps);
        for (std::size_t i = 0; i < count; ++i)
            m_writer.given(text("p_%3", i), decision(i).decision);
        for (std::size_t i = 1; i < count; ++i) {
            const QString before = text("{p_%3}", i - 1);
            const LineDecision& d = decision(i);
            m_writer.line(
                text("{p_%3}", i),
                before + (decision(i - 1).sideways ? text(" + 2 * {d%2} - 2 * {d%1}") : text(" + 2 * {d%2}")),
                {decision(i - 1).sideways
                     ? QT_TRANSLATE_NOOP("Derive", "Sample (%1, %2): the step before went aside, which takes 2 lengths "
                                                   "off.")
                     : QT_TRANSLATE_NOOP("Derive", "Sample (%1, %2): the step before went straight on."),
                 {d.x, d.y}},
                {sampleMark({d.x, d.y})});
        }
    }

    /// A tie: the two candidates are equally near.
    void writeTies()
    {
        const auto tie = std::ranges::find(m_line.decisions, 0, &LineDecision::decision);
        if (tie == m_line.decisions.end())
            return;
        const QString p = formula("p_%1", QString::number(tie->step));
        m_writer.given(p, 0);
        m_writer.compare(
            formula("{%1} <= 0", p),
            {QT_TRANSLATE_NOOP("Derive", "A tie at sample (%1, %2): both candidates are equally near. By the rule in "
                                         "words, p <= 0, the line goes straight on."),
             {tie->x, tie->y}},
            {sampleMark({tie->x, tie->y})});
        const glm::ivec2 straight(tie->x + (m_isSteep ? 0 : backOr1(0)), tie->y + (m_isSteep ? backOr1(1) : 0));
        const glm::ivec2 aside(tie->x + backOr1(0), tie->y + backOr1(1));
        m_writer.compare(
            formula("{%1} < 0", p),
            {QT_TRANSLATE_NOOP("Derive", "Code that asks p < 0 goes aside at a tie and plots (%1, %2) in place of (%3, "
                                         "%4), equally near. One sample later both ways are at one place again."),
             {aside.x, aside.y, straight.x, straight.y}},
            {sampleMark(aside), sampleMark(straight)});
    }

    /// The loop of the octant the line lies in.
    void writeListing()
    {
        const auto step = [&](const QString& axis, bool isBack) {
            return (isBack ? QStringLiteral("--") : QStringLiteral("++")) + axis;
        };
        const int iu = m_isSteep ? 1 : 0;
        const bool uBack = m_line.to[iu] < m_line.from[iu];
        const bool vBack = m_line.to[1 - iu] < m_line.from[1 - iu];
        m_writer.code(text("p = 2 * d%2 - d%1;  x = x_0;  y = y_0;"));
        m_writer.code(text("for (i = 0; i <= d%1; ++i) {"));
        m_writer.code(QStringLiteral("    plot(x, y);"));
        m_writer.code(QStringLiteral("    if (p > 0) { %1;  p -= 2 * d%2; }").arg(step(v(), vBack), u()));
        m_writer.code(QStringLiteral("    %1;  p += 2 * d%2;").arg(step(u(), uBack), v()));
        m_writer.code(QStringLiteral("}"));
    }

    const FaceRecord& m_record;
    const RecordedLine& m_line;
    bool m_isSteep;
    DerivationWriter m_writer;
};

} // namespace

Derivation deriveBresenham(const Scene& scene, const Settings& settings, const DerivationPlace& place,
                           const std::stop_token& stop)
{
    Settings lines = settings;
    lines.fill = Fill::Wireframe;
    lines.line = LineAlgorithm::Bresenham;
    const FaceRecord record(scene, lines, place, stop);
    const RecordedLine line = lineOf(record);
    return BresenhamWriter(record, line).write();
}

} // namespace rasterlens
