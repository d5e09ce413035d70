#include "core/observe/step_text.h"

#include "core/observe/step_payload.h"
#include "core/scene/origin.h"
#include "core/settings/depth_rules.h"

#include <QCoreApplication>
#include <QStringList>

#include <cmath>

namespace rasterlens
{
namespace
{

QString pointText(const glm::dvec2& p) { return QStringLiteral("(%1, %2)").arg(shortNumber(p.x), shortNumber(p.y)); }

QString clipText(const glm::dvec4& p)
{
    return QStringLiteral("(%1, %2, %3, %4)")
        .arg(shortNumber(p.x), shortNumber(p.y), shortNumber(p.z), shortNumber(p.w));
}

QString weightsText(const Weights& w)
{
    return QStringLiteral("(%1, %2, %3)").arg(shortNumber(w[0]), shortNumber(w[1]), shortNumber(w[2]));
}

/// Nothing to say.
const Reason kNothing = QString();

/// Names of a set of planes, one bit each: `near+left`.
Reason planesWord(std::uint32_t planes)
{
    Reason words = kNothing;
    for (int i = 0; i < kClipPlanes; ++i)
        if ((planes & 1U << i) != 0) {
            const Reason name = clipPlaneId(static_cast<ClipPlane>(i));
            words = isEmpty(words) ? name : Reason("%1+%2", {words, name});
        }
    return isEmpty(words) ? Reason(QT_TRANSLATE_NOOP("Steps", "none")) : words;
}

Reason leftOrRight(bool isLeft)
{
    return isLeft ? QT_TRANSLATE_NOOP("Steps", "left") : QT_TRANSLATE_NOOP("Steps", "right");
}

/// The number that perspective correction takes for 1/w: some mistakes have it wrong.
Reason inverseWText(double invW, const Rules& rules)
{
    const bool isRight = rules.keptW == KeptW::Inverse && rules.clipUpdatesW && rules.cornerData == CornerData::Own;
    return {isRight ? QT_TRANSLATE_NOOP("Steps", "1/w %1") : QT_TRANSLATE_NOOP("Steps", "%1 in place of 1/w"),
            {shortNumber(invW)}};
}

StepParts parts(const StepLog&, const StepEvent&, const VertexStep& step)
{
    const Reason object = QString(clipText(step.positionObject));
    const Reason clip = QString(clipText(step.clip.positionClip));
    const Reason outside = planesWord(step.outside);
    return {{QT_TRANSLATE_NOOP("Steps", "%1 = vertex %2"), {cornerLetter(std::size_t(step.corner)), step.meshVertex}},
            step.origin == glm::dvec3(0)
                ? Reason{QT_TRANSLATE_NOOP("Steps", "object %1 -> clip %2, outside %3"), {object, clip, outside}}
                : Reason{QT_TRANSLATE_NOOP("Steps", "world (%1), object %2 -> clip %3, outside %4"),
                         {worldText(step.positionObject, step.origin), object, clip, outside}}};
}

StepParts parts(const StepLog&, const StepEvent&, const ClipStep& step)
{
    QStringList cuts;
    for (const ClipCut& cut : step.cuts)
        cuts << QStringLiteral("%1->%2 t=%3").arg(cut.inside).arg(cut.outside).arg(shortNumber(cut.t));
    const Reason plane = clipPlaneId(step.plane);
    const Reason before = step.before.size();
    const Reason after = step.after.size();
    if (cuts.isEmpty())
        return {plane, {QT_TRANSLATE_NOOP("Steps", "%1 -> %2 vertices"), {before, after}}};
    return {
        plane,
        {QT_TRANSLATE_NOOP("Steps", "%1 -> %2 vertices, cuts %3"), {before, after, cuts.join(QStringLiteral(", "))}}};
}

StepParts parts(const StepLog&, const StepEvent&, const CohenSutherlandStep& step)
{
    QStringList codes;
    for (const unsigned region : step.regions)
        codes << regionText(region);
    return {{QT_TRANSLATE_NOOP("Steps", "outcodes %1"), {codes.join(QLatin1Char(' '))}},
            {QT_TRANSLATE_NOOP("Steps", "%1 -> %2 vertices"), {step.before.size(), step.after.size()}}};
}

StepParts parts(const StepLog& log, const StepEvent&, const ViewportStep& step)
{
    const glm::dvec2& p = step.screen.position;
    Rules rules = log.rules(); // clipping is done: every corner has its own w
    rules.clipUpdatesW = true;
    rules.cornerData = CornerData::Own;
    return {{QT_TRANSLATE_NOOP("Steps", "corner %1"), {step.corner}},
            {QT_TRANSLATE_NOOP("Steps", "%1 -> %2, depth %3, %4"),
             {pointText(step.unsnapped), QStringLiteral("(%1, %2)").arg(fullNumber(p.x), fullNumber(p.y)),
              shortNumber(step.screen.depth), inverseWText(step.screen.invW, rules)}}};
}

StepParts parts(const StepLog&, const StepEvent&, const FacingStep& step)
{
    const FacingDecision& d = step.decision;
    return {{QT_TRANSLATE_NOOP("Steps", "%1 %2, screen area %3"),
             {facingId(d.by), shortNumber(d.value), shortNumber(d.screenArea)}},
            Reason(faceFateId(d.fate))};
}

StepParts parts(const StepLog&, const StepEvent&, const ClippedStep& step)
{
    return {kNothing, {QT_TRANSLATE_NOOP("Steps", "%1 triangles"), {step.pieces}}};
}

StepParts parts(const StepLog&, const StepEvent&, const FateStep& step)
{
    return {kNothing, Reason(faceFateId(step.fate))};
}

StepParts parts(const StepLog&, const StepEvent&, const WalkStep& step)
{
    const WalkedTriangle& w = step.walk;
    QStringList corners;
    for (std::size_t i = 0; i < 3; ++i)
        corners << cornerLetter(w.source[i]) + QLatin1Char(' ') + pointText(w.vertices[i]);
    return {QT_TRANSLATE_NOOP("Steps", "by y"),
            {QT_TRANSLATE_NOOP("Steps", "%1; long edge %2, rows %3..%4"),
             {corners.join(QStringLiteral(", ")), leftOrRight(w.longEdgeIsLeft), w.firstRow, w.lastRow}}};
}

StepParts parts(const StepLog&, const StepEvent&, const SpanStep& step)
{
    return {kNothing,
            {QT_TRANSLATE_NOOP("Steps", "x %1..%2 -> [%3, %4), long edge %5, %6 half"),
             {fullNumber(step.ends.left), fullNumber(step.ends.right), step.xBegin, step.xEnd,
              leftOrRight(step.ends.longEdgeIsLeft),
              step.ends.upperHalf ? QT_TRANSLATE_NOOP("Steps", "upper") : QT_TRANSLATE_NOOP("Steps", "lower")}}};
}

/// `E_AB = 12.5` or, on the edge itself, `E_AB = 0 (left, ours)`.
Reason edgeValue(const StepSetup& setup, std::size_t i, const EdgeValues& values, bool isOurs)
{
    const Reason name = edgeValueName(setup, int(i));
    const Reason number = edgeValueText(values[i], setup.unitsPerArea);
    if (values[i] != 0)
        return {QT_TRANSLATE_NOOP("Steps", "%1 = %2"), {name, number}};
    return {isOurs ? QT_TRANSLATE_NOOP("Steps", "%1 = %2 (%3, ours)")
                   : QT_TRANSLATE_NOOP("Steps", "%1 = %2 (%3, not ours)"),
            {name, number, edgeSideId(setup.edges[i].side)}};
}

StepParts parts(const StepLog& log, const StepEvent& event, const SampleStep& step)
{
    const StepSetup& setup = log.triangle(event)->setup;
    const bool atMost = decidingEdge(setup, step.values, log.rules()).sign == DecidingEdge::Sign::AtMost;
    std::vector<Reason> arguments;
    for (std::size_t i = 0; i < 3; ++i)
        arguments.push_back(edgeValue(setup, i, step.values, atMost || step.values[i] >= setup.edges[i].threshold));
    const bool inside = event.has(StepEvent::kCovered);
    arguments.push_back(
        event.has(StepEvent::kTie)
            ? (inside ? QT_TRANSLATE_NOOP("Steps", "inside, tie") : QT_TRANSLATE_NOOP("Steps", "outside, tie"))
            : (inside ? QT_TRANSLATE_NOOP("Steps", "inside") : QT_TRANSLATE_NOOP("Steps", "outside")));
    return {kNothing, {QT_TRANSLATE_NOOP("Steps", "%1  %2  %3  %4"), std::move(arguments)}};
}

StepParts parts(const StepLog&, const StepEvent&, const ColumnFillStep& step)
{
    const FilledColumn& column = step.column;
    if (column.count == 0)
        return {kNothing, QT_TRANSLATE_NOOP("Steps", "no edge crosses it: the list of y is empty")};
    QStringList rows;
    for (int i = 0; i < column.count; ++i)
        rows << QString::number(column.rows[std::size_t(i)]);
    return {{QT_TRANSLATE_NOOP("Steps", "y of the edges [%1]"), {rows.join(QStringLiteral(", "))}},
            {QT_TRANSLATE_NOOP("Steps", "filled from min %1 to max %2"), {column.first(), column.last()}}};
}

StepParts parts(const StepLog&, const StepEvent&, const LineStep& step)
{
    const LineDecision& d = step.decision;
    return {{QT_TRANSLATE_NOOP("Steps", "i %1, p %2, d_lower %3, d_upper %4"),
             {d.step, d.decision, shortNumber(step.dLower()), shortNumber(step.dUpper())}},
            d.sideways ? QT_TRANSLATE_NOOP("Steps", "step along both axes")
                       : QT_TRANSLATE_NOOP("Steps", "step along the longer axis")};
}

/// `depth 0.5 < 1: passed`
Reason depthTestText(const Rules& rules, const StepEvent& event, const FragmentStep& step)
{
    const Reason depth = depthNumber(step.depth);
    const QString sign = QLatin1String(depthSign(rules));
    if (sign.isEmpty())
        return {QT_TRANSLATE_NOOP("Steps", "depth %1, compared with nothing: passed"), {depth}};
    const char* const text = event.has(StepEvent::kPassed) ? QT_TRANSLATE_NOOP("Steps", "depth %1 %2 %3: passed")
                             : rules.depthWrittenOnFail
                                 ? QT_TRANSLATE_NOOP("Steps", "depth %1 %2 %3: failed, but its depth is stored")
                                 : QT_TRANSLATE_NOOP("Steps", "depth %1 %2 %3: failed");
    return {text, {depth, sign, depthNumber(step.storedDepth)}};
}

StepParts parts(const StepLog& log, const StepEvent& event, const FragmentStep& step)
{
    return {{QT_TRANSLATE_NOOP("Steps", "\u03b1 \u03b2 \u03b3 %1 -> %2, %3"),
             {weightsText(step.screen), weightsText(step.weights), inverseWText(step.invW, log.rules())}},
            depthTestText(log.rules(), event, step)};
}

StepParts parts(const StepLog&, const StepEvent&, const ShadeStep& step) { return {kNothing, colorText(step.color)}; }

StepParts parts(const StepLog&, const StepEvent&, const WriteStep& step)
{
    return {kNothing,
            {QT_TRANSLATE_NOOP("Steps", "%1 -> %2, depth %3 -> %4"),
             {colorText(step.before.color), colorText(step.after.color), depthNumber(step.before.depth),
              depthNumber(step.after.depth)}}};
}

QString triangleText(const StepTriangle& triangle)
{
    QStringList corners;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec2& p = triangle.screen.vertices[i].position;
        corners << QStringLiteral("%1 (%2, %3)").arg(cornerLetter(i), fullNumber(p.x), fullNumber(p.y));
    }
    return corners.join(QStringLiteral(", "));
}

/// `+8 per x, -8 per y`, `+0 per y`
QString signedAreas(double units, double unitsPerArea)
{
    const QString text = edgeValueText(units, unitsPerArea);
    return text.startsWith(QLatin1Char('-')) ? text : QLatin1Char('+') + text;
}

StepParts setupParts(const StepTriangle& triangle)
{
    if (!triangle.hasSetup)
        return {kNothing, QT_TRANSLATE_NOOP("Steps", "no sample's centre within its bounds, or no area")};
    const StepSetup& setup = triangle.setup;
    const auto edge = [&](std::size_t i) {
        const StepEdge& e = setup.edges[i];
        return Reason{QT_TRANSLATE_NOOP("Steps", "%1 %2 per x, %3 per y, inside from %4 = %5 (%6)"),
                      {edgeValueName(setup, int(i)), signedAreas(e.perX, setup.unitsPerArea),
                       signedAreas(e.perY, setup.unitsPerArea), thresholdName(setup, int(i)),
                       thresholdText(e.threshold, setup.unitsPerArea), edgeSideId(e.side)}};
    };
    const PixelRect& b = setup.bounds;
    return {{QT_TRANSLATE_NOOP("Steps", "bounds %1..%2 x %3..%4"), {b.x, b.x + b.width - 1, b.y, b.y + b.height - 1}},
            {QT_TRANSLATE_NOOP("Steps", "%1; %2; %3"), {edge(0), edge(1), edge(2)}}};
}

} // namespace

QString edgeValueText(double value, double unitsPerArea)
{
    if (unitsPerArea != 65536 || !(std::abs(value) < 0x1p53))
        return fullNumber(value / unitsPerArea);
    const auto units = static_cast<std::int64_t>(std::abs(value));
    QString digits = QString::number(units / 65536);
    if (std::int64_t rest = units % 65536; rest != 0) {
        digits += QLatin1Char('.');
        for (; rest != 0; rest %= 65536) {
            rest *= 10;
            digits += QLatin1Char(char('0' + rest / 65536));
        }
    }
    return value < 0 ? QLatin1Char('-') + digits : digits;
}

QString edgeName(const StepSetup& setup, int edge)
{
    return cornerLetter(setup.source[std::size_t(edge)]) + cornerLetter(setup.source[std::size_t((edge + 1) % 3)]);
}

QString edgeValueName(const StepSetup& setup, int edge) { return QStringLiteral("E_") + edgeName(setup, edge); }

QString thresholdName(const StepSetup& setup, int edge) { return QStringLiteral("t_") + edgeName(setup, edge); }

QString thresholdText(double threshold, double unitsPerArea)
{
    return threshold != 0 && unitsPerArea == 65536 ? QStringLiteral("%1/65536").arg(threshold)
                                                   : fullNumber(threshold / unitsPerArea);
}

StepParts stepParts(const StepLog& log, std::size_t i)
{
    const StepEvent& event = log.event(i);
    StepParts said{kNothing, kNothing};
    visitPayload(log, event, [&](const auto& payload) { said = parts(log, event, payload); });
    if (event.kind == StepKind::Triangle)
        said.numbers = triangleText(*log.triangle(event));
    if (event.kind == StepKind::Setup)
        said = setupParts(*log.triangle(event));
    if (event.kind == StepKind::LineSample && !event.has(StepEvent::kCovered))
        said.numbers = QT_TRANSLATE_NOOP("Steps", "off the target");
    return said;
}

QString stepText(const StepLog& log, std::size_t i)
{
    const StepEvent& event = log.event(i);
    QString line = QStringLiteral("%1 %2").arg(i).arg(QLatin1String(stepKindId(event.kind)));
    if (event.face != StepEvent::kNone)
        line += QLatin1Char(' ') + faceText(event.face, log.lineOf(event.face));
    if (event.kind == StepKind::Column)
        line += QStringLiteral(" x %1").arg(event.x);
    else if (event.x >= 0 || event.kind == StepKind::LineSample || event.kind == StepKind::LineDecision)
        line += QStringLiteral(" (%1, %2)").arg(event.x).arg(event.y);
    else if (event.kind == StepKind::Span)
        line += QStringLiteral(" row %1").arg(event.y);
    const StepParts parts = stepParts(log, i);
    for (const Reason* part : {&parts.what, &parts.numbers})
        if (!isEmpty(*part))
            line += QStringLiteral(": ") + textOf(*part);
    return line;
}

} // namespace rasterlens
