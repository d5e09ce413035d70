#include "core/observe/step_text.h"

#include "core/observe/face_moment.h"
#include "core/observe/step_payload.h"
#include "core/pipeline/framebuffer.h"
#include "core/scene/origin.h"
#include "core/settings/depth_rules.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <array>
#include <bit>
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

/// The name of a corner of the polygon that a step cuts, as the canvas has it.
QString cornerName(const std::vector<MomentCorner>& corners, std::size_t i)
{
    return i < corners.size() ? corners[i].name : QString::number(i);
}

StepParts clipParts(const StepLog& log, const ClipStep& step, const FaceMoment& moment)
{
    QStringList cuts;
    for (const ClipCut& cut : step.cuts)
        cuts << QStringLiteral("%1->%2 t=%3")
                    .arg(cornerName(moment.before, std::size_t(cut.inside)),
                         cornerName(moment.before, std::size_t(cut.outside)), shortNumber(cut.t));
    const QString holds = clipPlaneFormula(step.plane, log.rules());
    const Reason plane{"%1, %2", {clipPlaneId(step.plane), holds}};
    const Reason before = step.before.size();
    const Reason after = step.after.size();
    if (cuts.isEmpty())
        return {plane, {QT_TRANSLATE_NOOP("Steps", "%1 -> %2 vertices"), {before, after}}};
    return {
        plane,
        {QT_TRANSLATE_NOOP("Steps", "%1 -> %2 vertices, cuts %3"), {before, after, cuts.join(QStringLiteral(", "))}}};
}

StepParts regionParts(const CohenSutherlandStep& step, const FaceMoment& moment)
{
    QStringList codes;
    for (std::size_t i = 0; i < step.regions.size(); ++i)
        codes << cornerName(moment.before, i) + QLatin1Char(' ') + regionText(step.regions[i]);
    return {{QT_TRANSLATE_NOOP("Steps", "outcodes %1"), {codes.join(QStringLiteral(", "))}},
            {QT_TRANSLATE_NOOP("Steps", "%1 -> %2 vertices"), {step.before.size(), step.after.size()}}};
}

StepParts viewportParts(const StepLog& log, const ViewportStep& step, const FaceMoment& moment)
{
    const glm::dvec2& p = step.screen.position;
    Rules rules = log.rules(); // clipping is done: every corner has its own w
    rules.clipUpdatesW = true;
    rules.cornerData = CornerData::Own;
    return {{QT_TRANSLATE_NOOP("Steps", "corner %1"), {cornerName(moment.corners, std::size_t(step.corner))}},
            {QT_TRANSLATE_NOOP("Steps", "%1 -> %2, depth %3, %4"),
             {pointText(step.unsnapped), QStringLiteral("(%1, %2)").arg(fullNumber(p.x), fullNumber(p.y)),
              shortNumber(step.screen.depth), inverseWText(step.screen.invW, rules)}}};
}

/// The steps that speak of corners by their names: see stepParts().
StepParts parts(const StepLog&, const StepEvent&, const ClipStep&) { return {kNothing, kNothing}; }
StepParts parts(const StepLog&, const StepEvent&, const CohenSutherlandStep&) { return {kNothing, kNothing}; }
StepParts parts(const StepLog&, const StepEvent&, const ViewportStep&) { return {kNothing, kNothing}; }

/// What a cut or the way to the screen does to the polygon of that moment.
StepParts polygonParts(const StepLog& log, std::size_t i)
{
    const StepEvent& event = log.event(i);
    const FaceMoment moment = faceMomentAt(log, i + 1).value_or(FaceMoment{});
    switch (event.kind) {
    case StepKind::ClipPlane: return clipParts(log, log.payload<ClipStep>(event), moment);
    case StepKind::CohenSutherland: return regionParts(log.payload<CohenSutherlandStep>(event), moment);
    default: return viewportParts(log, log.payload<ViewportStep>(event), moment);
    }
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
        corners << QStringLiteral("%1 = %2 ").arg(i + 1).arg(cornerLetter(w.source[i])) + pointText(w.vertices[i]);
    return {QT_TRANSLATE_NOOP("Steps", "by y"),
            {QT_TRANSLATE_NOOP("Steps", "%1; long edge %2, rows %3..%4"),
             {corners.join(QStringLiteral(", ")), leftOrRight(w.longEdgeIsLeft), w.firstRow, w.lastRow}}};
}

StepParts parts(const StepLog& log, const StepEvent& event, const SidesStep& step)
{
    const StepSetup& setup = log.triangle(event)->setup;
    const auto name = [&](std::size_t i, std::size_t j) { return walkedEdgeName(setup, step.walk, i, j); };
    return {{QT_TRANSLATE_NOOP("Steps", "long edge %1, from 1 to 3"), {name(0, 2)}},
            {QT_TRANSLATE_NOOP("Steps", "broken edge %1 and %2, from 1 over 2 to 3, on the %3"),
             {name(0, 1), name(1, 2), leftOrRight(!step.walk.longEdgeIsLeft)}}};
}

/// `3..9`; `none`
Reason rowsWord(int first, int last)
{
    if (first > last)
        return QT_TRANSLATE_NOOP("Steps", "none");
    return QStringLiteral("%1..%2").arg(first).arg(last);
}

StepParts parts(const StepLog&, const StepEvent&, const HalvesStep& step)
{
    const auto& [top, middle, bottom] = step.walk.vertices;
    const Reason upper = rowsWord(step.walk.firstRow, step.halves.firstLowerRow - 1);
    const Reason lower = rowsWord(step.halves.firstLowerRow, step.walk.lastRow);
    if (bottom.y == middle.y)
        return {QT_TRANSLATE_NOOP("Steps", "2 and 3 are of one height: there is no lower half"),
                {QT_TRANSLATE_NOOP("Steps", "rows of the upper half %1"), {upper}}};
    if (top.y == middle.y)
        return {QT_TRANSLATE_NOOP("Steps", "1 and 2 are of one height: there is no upper half"),
                {QT_TRANSLATE_NOOP("Steps", "rows of the lower half %1"), {lower}}};
    return {{QT_TRANSLATE_NOOP("Steps", "y2 = %1, cut from x2 = %2 to the long edge at alpha = %3, x = %4"),
             {fullNumber(middle.y), fullNumber(middle.x), shortNumber(step.halves.alpha), shortNumber(step.halves.x)}},
            {QT_TRANSLATE_NOOP("Steps", "rows of the upper half %1, of the lower half %2"), {upper, lower}}};
}

Reason upperOrLower(bool isUpper)
{
    return isUpper ? QT_TRANSLATE_NOOP("Steps", "upper") : QT_TRANSLATE_NOOP("Steps", "lower");
}

StepParts parts(const StepLog&, const StepEvent&, const CrossingStep& step)
{
    const RowCrossings& row = step.row;
    return {{QT_TRANSLATE_NOOP("Steps", "%1 half, alpha %2, beta %3"),
             {upperOrLower(row.upperHalf), shortNumber(row.alpha), shortNumber(row.beta)}},
            {QT_TRANSLATE_NOOP("Steps", "xa %1 on the long edge, xb %2 on the broken edge"),
             {fullNumber(row.xa), fullNumber(row.xb)}}};
}

StepParts parts(const StepLog&, const StepEvent&, const SpanStep& step)
{
    return {kNothing,
            {QT_TRANSLATE_NOOP("Steps", "x %1..%2 -> [%3, %4), long edge %5, %6 half"),
             {fullNumber(step.ends.left), fullNumber(step.ends.right), step.xBegin, step.xEnd,
              leftOrRight(step.ends.longEdgeIsLeft), upperOrLower(step.ends.upperHalf)}}};
}

/// `E_AB = 12.5` or, on the edge itself, `E_AB = 0 (left, ours)`.
///
/// in  isCentre  whether the centre was asked: corners of pixels have no owner
Reason edgeValue(const StepSetup& setup, std::size_t i, const EdgeValues& values, bool isOurs, bool isCentre)
{
    const Reason name = edgeValueName(setup, int(i));
    const Reason number = edgeValueText(values[i], setup.unitsPerArea);
    if (values[i] != 0 || !isCentre)
        return {QT_TRANSLATE_NOOP("Steps", "%1 = %2"), {name, number}};
    return {isOurs ? QT_TRANSLATE_NOOP("Steps", "%1 = %2 (%3, ours)")
                   : QT_TRANSLATE_NOOP("Steps", "%1 = %2 (%3, not ours)"),
            {name, number, edgeSideId(setup.edges[i].side)}};
}

StepParts parts(const StepLog& log, const StepEvent& event, const SampleStep& step)
{
    const StepSetup& setup = log.triangle(event)->setup;
    const DecidingEdge decides = decidingEdge(setup, step.values, log.rules());
    const bool atMost = decides.sign == DecidingEdge::Sign::AtMost;
    std::vector<Reason> arguments;
    for (std::size_t i = 0; i < 3; ++i)
        arguments.push_back(
            edgeValue(setup, i, step.values, atMost || step.values[i] >= setup.edges[i].threshold, decides.isCentre));
    const bool inside = event.has(StepEvent::kCovered);
    arguments.push_back(
        event.has(StepEvent::kTie)
            ? (inside ? QT_TRANSLATE_NOOP("Steps", "inside, tie") : QT_TRANSLATE_NOOP("Steps", "outside, tie"))
            : (inside ? QT_TRANSLATE_NOOP("Steps", "inside") : QT_TRANSLATE_NOOP("Steps", "outside")));
    return {kNothing, {QT_TRANSLATE_NOOP("Steps", "%1  %2  %3  %4"), std::move(arguments)}};
}

StepParts parts(const StepLog& log, const StepEvent&, const ColumnFillStep& step)
{
    const FilledColumn& column = step.column;
    if (column.count == 0)
        return {kNothing, QT_TRANSLATE_NOOP("Steps", "no edge crosses it: the list of y is empty")};
    QStringList rows;
    for (int i = 0; i < column.count; ++i)
        rows << QString::number(column.rows[std::size_t(i)]);
    const Reason what{QT_TRANSLATE_NOOP("Steps", "y of the edges [%1]"), {rows.join(QStringLiteral(", "))}};
    const int first = std::max(column.first(), 0);
    const int last = std::min(column.last(), log.rows() - 1);
    if (first > last)
        return {what,
                {QT_TRANSLATE_NOOP("Steps", "min %1, max %2: nothing of it is on the target"),
                 {column.first(), column.last()}}};
    if (first != column.first() || last != column.last())
        return {what,
                {QT_TRANSLATE_NOOP("Steps", "min %1, max %2, of which %3 to %4 are on the target"),
                 {column.first(), column.last(), first, last}}};
    return {what, {QT_TRANSLATE_NOOP("Steps", "filled from min %1 to max %2"), {first, last}}};
}

StepParts parts(const StepLog&, const StepEvent&, const LineStep& step)
{
    const LineDecision& d = step.decision;
    return {{QT_TRANSLATE_NOOP("Steps", "i %1, p %2, d_lower %3, d_upper %4"),
             {d.step, d.decision, shortNumber(step.dLower()), shortNumber(step.dUpper())}},
            d.sideways ? QT_TRANSLATE_NOOP("Steps", "step along both axes")
                       : QT_TRANSLATE_NOOP("Steps", "step along the longer axis")};
}

StepParts parts(const StepLog&, const StepEvent& event, const LinePositionStep& step)
{
    const LinePosition& p = step.position;
    return {{QT_TRANSLATE_NOOP("Steps", "i %1, x %2, y %3"), {p.step, shortNumber(p.x), shortNumber(p.y)}},
            {QT_TRANSLATE_NOOP("Steps", "rounded to (%1, %2), error %3"), {event.x, event.y, shortNumber(p.error())}}};
}

/// `depth 0.5 < 1: passed`
Reason depthTestText(const Rules& rules, const StepEvent& event, const FragmentStep& step)
{
    const Reason depth = depthNumber(step.depth);
    const QString sign = QLatin1String(depthSign(rules, event.face));
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

StepParts parts(const StepLog& log, const StepEvent&, const ResolveStep& step)
{
    const ResolvedPixel& pixel = step.pixel;
    QStringList stored;
    for (int i = 0; i < pixel.count; ++i) {
        const Pixel& sample = pixel.samples[std::size_t(i)];
        stored << QStringLiteral("%1 z %2").arg(colorText(sample.color), depthNumber(sample.depth));
    }
    const Reason what{QT_TRANSLATE_NOOP("Steps", "stored %1"), {stored.join(QStringLiteral(", "))}};
    const Reason sums = meanSums(pixel).join(QStringLiteral(", "));
    if (log.rules().resolve == Resolve::AllSamples)
        return {what, {QT_TRANSLATE_NOOP("Steps", "mean %1"), {sums}}};
    return {what,
            {QT_TRANSLATE_NOOP("Steps", "%1 of %2 count as black, mean %3"),
             {std::popcount(pixel.black), pixel.count, sums}}};
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

/// The three edges of an outline and how high they are, in samples.
Reason outlineText(const StepSetup& setup)
{
    QStringList edges;
    for (std::size_t i = 0; i < 3; ++i)
        edges << edgeName(setup, int(i)) + QLatin1Char(' ') +
                     shortNumber(std::abs(setup.vertices[(i + 1) % 3].y - setup.vertices[i].y));
    return {QT_TRANSLATE_NOOP("Steps", "three edges, not yet told apart; heights %1"),
            {edges.join(QStringLiteral(", "))}};
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

QString walkedEdgeName(const StepSetup& setup, const WalkedTriangle& walk, std::size_t from, std::size_t to)
{
    for (std::size_t i = 0; i < 3; ++i) {
        const std::array ends{setup.source[i], setup.source[(i + 1) % 3]};
        if (std::ranges::is_permutation(ends, std::array{walk.source[from], walk.source[to]}))
            return edgeName(setup, int(i));
    }
    return {};
}

const WalkedTriangle* walkOf(const StepLog& log, const StepEvent& event)
{
    const auto walks = log.eventsOf(StepKind::Walk);
    // With a pattern a triangle is walked once for each sample.
    const auto ofTriangle =
        std::ranges::equal_range(walks, event.triangle, {}, [&](std::uint32_t i) { return log.event(i).triangle; });
    const auto at = std::ranges::find(ofTriangle, event.sample, [&](std::uint32_t i) { return log.event(i).sample; });
    return at != ofTriangle.end() ? &log.payload<WalkStep>(log.event(*at)).walk : nullptr;
}

namespace
{

/// `R: light (0.871 + 0) / 2 = 0.436 -> 177`
QString meanOfLight(const ResolvedPixel& pixel, char name, int shift)
{
    QStringList terms;
    double sum = 0;
    for (int i = 0; i < pixel.count; ++i) {
        const double light = lightOfValue(pixel.counted(i) >> shift & 255U);
        terms << shortNumber(light);
        sum += light;
    }
    return QStringLiteral("%1: light (%2) / %3 = %4 -> %5")
        .arg(QLatin1Char(name))
        .arg(terms.join(QStringLiteral(" + ")))
        .arg(pixel.count)
        .arg(shortNumber(sum / pixel.count))
        .arg(pixel.color >> shift & 255U);
}

} // namespace

QStringList meanSums(const ResolvedPixel& pixel)
{
    constexpr std::array<std::pair<char, int>, 3> kChannels{{{'R', 16}, {'G', 8}, {'B', 0}}};
    QStringList sums;
    for (const auto& [name, shift] : kChannels) {
        if (pixel.light == ResolveLight::Linear) {
            sums << meanOfLight(pixel, name, shift);
            continue;
        }
        QStringList terms;
        std::uint32_t sum = 0;
        for (int i = 0; i < pixel.count; ++i) {
            const std::uint32_t value = pixel.counted(i) >> shift & 255U;
            terms << QString::number(value);
            sum += value;
        }
        QString text = QStringLiteral("%1 = (%2) / %3 = %4")
                           .arg(QLatin1Char(name))
                           .arg(terms.join(QStringLiteral(" + ")))
                           .arg(pixel.count)
                           .arg(shortNumber(double(sum) / pixel.count));
        if (sum % std::uint32_t(pixel.count) != 0)
            text += QStringLiteral(" -> %1").arg(pixel.color >> shift & 255U);
        sums << text;
    }
    return sums;
}

QString edgeValueName(const StepSetup& setup, int edge) { return QStringLiteral("E_") + edgeName(setup, edge); }

QString thresholdName(const StepSetup& setup, int edge) { return QStringLiteral("t_") + edgeName(setup, edge); }

QString thresholdText(double threshold, double unitsPerArea)
{
    return threshold != 0 && unitsPerArea == 65536 ? QStringLiteral("%1/65536").arg(threshold)
                                                   : fullNumber(threshold / unitsPerArea);
}

namespace
{

/// How far a line that has one sample a column has come since the sample before; nothing at its first sample.
Reason columnStep(const StepLog& log, std::size_t i)
{
    const StepEvent& event = log.event(i);
    for (std::size_t k = i; k-- > 0 && log.event(k).triangle == event.triangle;) {
        const StepEvent& before = log.event(k);
        if (before.kind != StepKind::LineSample)
            continue;
        if (std::abs(event.x - before.x) != 1)
            break; // of another line
        return {QT_TRANSLATE_NOOP("Steps", "x %1 -> %2, y %3 -> %4 in one column"),
                {before.x, event.x, before.y, event.y}};
    }
    return kNothing;
}

} // namespace

StepParts stepParts(const StepLog& log, std::size_t i)
{
    const StepEvent& event = log.event(i);
    StepParts said{kNothing, kNothing};
    visitPayload(log, event, [&](const auto& payload) { said = parts(log, event, payload); });
    if (event.kind == StepKind::ClipPlane || event.kind == StepKind::CohenSutherland ||
        event.kind == StepKind::Viewport)
        said = polygonParts(log, i);
    if (event.kind == StepKind::Triangle)
        said.numbers = triangleText(*log.triangle(event));
    if (event.kind == StepKind::Setup)
        said = setupParts(*log.triangle(event));
    if (event.kind == StepKind::Outline)
        said.numbers = outlineText(log.triangle(event)->setup);
    if (event.kind == StepKind::LineSample && log.rules().lineAdvance == LineAdvance::OneRow)
        said.what = columnStep(log, i);
    if (event.kind == StepKind::LineSample && !event.has(StepEvent::kCovered))
        said.numbers = QT_TRANSLATE_NOOP("Steps", "off the target");
    return said;
}

QString stepText(const StepLog& log, std::size_t i)
{
    const StepEvent& event = log.event(i);
    QString line = QStringLiteral("%1 %2").arg(log.numberOf(i)).arg(QLatin1String(stepKindId(event.kind)));
    if (event.face != StepEvent::kNone)
        line += QLatin1Char(' ') + faceText(event.face, log.lineOf(event.face));
    if (event.kind == StepKind::Column)
        line += QStringLiteral(" x %1").arg(event.x);
    else if (event.kind == StepKind::Resolve)
        line += QStringLiteral(" pixel (%1, %2)").arg(event.x / log.grid()).arg(event.y / log.grid());
    else if (event.x >= 0 || event.kind == StepKind::LineSample || event.kind == StepKind::LineDecision ||
             event.kind == StepKind::LinePosition)
        line += QStringLiteral(" (%1, %2)").arg(event.x).arg(event.y);
    else if (event.kind == StepKind::Span || event.kind == StepKind::Crossing)
        line += QStringLiteral(" row %1").arg(event.y);
    if (isOfPattern(log, event))
        line += QStringLiteral(" sample %1").arg(event.sample + 1);
    const StepParts parts = stepParts(log, i);
    for (const Reason* part : {&parts.what, &parts.numbers})
        if (!isEmpty(*part))
            line += QStringLiteral(": ") + textOf(*part);
    return line;
}

} // namespace rasterlens
