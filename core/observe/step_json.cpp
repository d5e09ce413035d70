#include "core/observe/step_payload.h"
#include "core/observe/step_text.h"
#include "core/scene/origin.h"

#include <QJsonArray>

#include <cmath>

namespace rasterlens
{
namespace
{

/// JSON knows no infinities: those are text.
QJsonValue json(double value) { return std::isfinite(value) ? QJsonValue(value) : QJsonValue(fullNumber(value)); }

template <class Range>
QJsonArray jsonArray(const Range& values)
{
    QJsonArray array;
    for (const auto value : values)
        array << json(static_cast<double>(value));
    return array;
}

QJsonArray json(const glm::dvec2& p) { return jsonArray(std::array{p.x, p.y}); }
QJsonArray json(const glm::dvec4& p) { return jsonArray(std::array{p.x, p.y, p.z, p.w}); }
QJsonObject json(const PixelRect& r) { return {{"x", r.x}, {"y", r.y}, {"width", r.width}, {"height", r.height}}; }
QJsonObject json(const Pixel& p) { return {{"color", colorText(p.color)}, {"depth", json(double(p.depth))}}; }

QJsonArray positions(const std::vector<ClipVertex>& corners)
{
    QJsonArray array;
    for (const ClipVertex& corner : corners)
        array << json(corner.positionClip);
    return array;
}

QJsonObject json(const StepLog&, const StepEvent&, const VertexStep& step)
{
    QJsonObject object{{"corner", step.corner},
                       {"mesh_vertex", double(step.meshVertex)},
                       {"object", json(glm::dvec4(step.positionObject))},
                       {"clip", json(step.clip.positionClip)},
                       {"outside", planesText(step.outside)}};
    if (step.origin != glm::dvec3(0))
        object["world"] = json(worldFromObject(glm::dvec4(step.positionObject), step.origin));
    return object;
}

QJsonObject json(const StepLog&, const StepEvent&, const ClipStep& step)
{
    QJsonArray cuts;
    for (const ClipCut& cut : step.cuts)
        cuts << QJsonObject{
            {"inside", cut.inside}, {"outside", cut.outside}, {"t", json(cut.t)}, {"corner", cut.corner}};
    return {{"plane", QLatin1String(clipPlaneId(step.plane))},
            {"before", positions(step.before)},
            {"distances", jsonArray(step.distances)},
            {"after", positions(step.after)},
            {"cuts", cuts}};
}

QJsonObject json(const StepLog&, const StepEvent&, const CohenSutherlandStep& step)
{
    QJsonArray regions;
    for (const unsigned region : step.regions)
        regions << regionText(region);
    return {{"before", positions(step.before)}, {"outcodes", regions}, {"after", positions(step.after)}};
}

QJsonObject json(const StepLog&, const StepEvent&, const ViewportStep& step)
{
    return {{"corner", step.corner},
            {"clip", json(step.positionClip)},
            {"unsnapped", json(step.unsnapped)},
            {"screen", json(step.screen.position)},
            {"depth", json(step.screen.depth)},
            {"inv_w", json(step.screen.invW)}};
}

QJsonObject json(const StepLog&, const StepEvent&, const FacingStep& step)
{
    const FacingDecision& d = step.decision;
    return {{"space", QLatin1String(facingId(d.by))},
            {"value", json(d.value)},
            {"screen_area", json(d.screenArea)},
            {"fate", QLatin1String(faceFateId(d.fate))}};
}

QJsonObject json(const StepLog&, const StepEvent&, const ClippedStep& step) { return {{"pieces", step.pieces}}; }

QJsonObject json(const StepLog&, const StepEvent&, const FateStep& step)
{
    return {{"fate", QLatin1String(faceFateId(step.fate))}};
}

QString lettersOf(const WalkedTriangle& walk)
{
    return cornerLetter(walk.source[0]) + cornerLetter(walk.source[1]) + cornerLetter(walk.source[2]);
}

QJsonObject json(const StepLog&, const StepEvent&, const WalkStep& step)
{
    const WalkedTriangle& w = step.walk;
    QJsonArray vertices;
    for (const glm::dvec2& vertex : w.vertices)
        vertices << json(vertex);
    return {{"vertices", vertices},
            {"source", lettersOf(w)},
            {"long_edge", w.longEdgeIsLeft ? "left" : "right"},
            {"first_row", w.firstRow},
            {"last_row", w.lastRow}};
}

QJsonObject json(const StepLog& log, const StepEvent& event, const SidesStep& step)
{
    const StepSetup& setup = log.triangle(event)->setup;
    return {{"source", lettersOf(step.walk)},
            {"long", walkedEdgeName(setup, step.walk, 0, 2)},
            {"broken", QJsonArray{walkedEdgeName(setup, step.walk, 0, 1), walkedEdgeName(setup, step.walk, 1, 2)}},
            {"long_edge", step.walk.longEdgeIsLeft ? "left" : "right"}};
}

QJsonObject json(const StepLog&, const StepEvent&, const HalvesStep& step)
{
    return {{"middle", json(step.walk.vertices[1])},
            {"alpha", json(step.halves.alpha)},
            {"x", json(step.halves.x)},
            {"first_row", step.walk.firstRow},
            {"first_lower_row", step.halves.firstLowerRow},
            {"last_row", step.walk.lastRow}};
}

QJsonObject json(const StepLog&, const StepEvent&, const CrossingStep& step)
{
    const RowCrossings& row = step.row;
    return {{"half", row.upperHalf ? "upper" : "lower"},
            {"alpha", json(row.alpha)},
            {"beta", json(row.beta)},
            {"xa", json(row.xa)},
            {"xb", json(row.xb)}};
}

QJsonObject json(const StepLog&, const StepEvent&, const SpanStep& step)
{
    return {{"left", json(step.ends.left)},
            {"right", json(step.ends.right)},
            {"x_begin", step.xBegin},
            {"x_end", step.xEnd},
            {"long_edge", step.ends.longEdgeIsLeft ? "left" : "right"},
            {"half", step.ends.upperHalf ? "upper" : "lower"}};
}

QJsonObject json(const StepLog& log, const StepEvent& event, const SampleStep& step)
{
    const StepSetup& setup = log.triangle(event)->setup;
    QJsonArray edges;
    QJsonArray areas;
    for (std::size_t i = 0; i < 3; ++i) {
        edges << edgeName(setup, int(i));
        areas << json(step.values[i] / setup.unitsPerArea);
    }
    return {{"edges", edges},
            {"values", jsonArray(step.values)},
            {"areas", areas},
            {"covered", event.has(StepEvent::kCovered)},
            {"tie", event.has(StepEvent::kTie)}};
}

QJsonObject json(const StepLog&, const StepEvent&, const ColumnFillStep& step)
{
    const FilledColumn& column = step.column;
    QJsonArray rows;
    for (int i = 0; i < column.count; ++i)
        rows << column.rows[std::size_t(i)];
    QJsonObject object{{"x", column.x}, {"rows", rows}};
    if (column.count > 0) {
        object.insert(QStringLiteral("min"), column.first());
        object.insert(QStringLiteral("max"), column.last());
    }
    return object;
}

QJsonObject json(const StepLog&, const StepEvent&, const LineStep& step)
{
    const LineDecision& d = step.decision;
    return {{"i", d.step},
            {"p", d.decision},
            {"d_lower", json(step.dLower())},
            {"d_upper", json(step.dUpper())},
            {"longer", d.longer},
            {"shorter", d.shorter},
            {"steep", d.steep},
            {"sideways", d.sideways}};
}

QJsonObject json(const StepLog&, const StepEvent&, const LinePositionStep& step)
{
    const LinePosition& p = step.position;
    return {{"i", p.step},
            {"x", json(p.x)},
            {"y", json(p.y)},
            {"per_step_x", json(p.perStepX)},
            {"per_step_y", json(p.perStepY)},
            {"column", p.column},
            {"row", p.row},
            {"error", json(p.error())}};
}

QJsonObject json(const StepLog& log, const StepEvent& event, const FragmentStep& step)
{
    return {{"screen_weights", jsonArray(step.screen)},
            {"weights", jsonArray(step.weights)},
            {"inv_w", json(step.invW)},
            {"depth", json(double(step.depth))},
            {"stored_depth", json(double(step.storedDepth))},
            {"passed", event.has(StepEvent::kPassed)},
            {"shaded", step.shaded},
            {"varyings", jsonArray(std::span(step.varyings).first(std::size_t(log.varyingCount())))}};
}

QJsonObject json(const StepLog&, const StepEvent&, const ShadeStep& step) { return {{"color", colorText(step.color)}}; }

QJsonObject json(const StepLog&, const StepEvent&, const WriteStep& step)
{
    return {{"before", json(step.before)}, {"after", json(step.after)}};
}

QJsonObject json(const StepLog&, const StepEvent&, const ResolveStep& step)
{
    const ResolvedPixel& pixel = step.pixel;
    QJsonArray samples;
    for (int i = 0; i < pixel.count; ++i) {
        QJsonObject sample = json(pixel.samples[std::size_t(i)]);
        sample.insert(QStringLiteral("counts_as"), colorText(pixel.counted(i)));
        samples << sample;
    }
    return {{"pixel", QJsonArray{pixel.x, pixel.y}}, {"samples", samples}, {"color", colorText(pixel.color)}};
}

QJsonObject outlineJson(const StepTriangle& triangle)
{
    QJsonObject heights;
    const StepSetup& setup = triangle.setup;
    for (std::size_t i = 0; i < 3; ++i)
        heights.insert(edgeName(setup, int(i)), json(std::abs(setup.vertices[(i + 1) % 3].y - setup.vertices[i].y)));
    return {{"heights", heights}};
}

QJsonObject triangleJson(const StepTriangle& triangle)
{
    QJsonArray corners;
    for (const ScreenVertex& v : triangle.screen.vertices)
        corners << QJsonObject{{"screen", json(v.position)}, {"depth", json(v.depth)}, {"inv_w", json(v.invW)}};
    return {{"vertices", corners}};
}

QJsonObject setupJson(const StepTriangle& triangle)
{
    if (!triangle.hasSetup)
        return {{"empty", true}};
    const StepSetup& setup = triangle.setup;
    QJsonArray edges;
    for (std::size_t i = 0; i < 3; ++i) {
        const StepEdge& e = setup.edges[i];
        // E(x, y) = a x + b y + c in units
        edges << QJsonObject{{"edge", edgeName(setup, int(i))},
                             {"a", json(e.a)},
                             {"b", json(e.b)},
                             {"c", json(-(e.a * e.from.x + e.b * e.from.y))},
                             {"per_x", json(e.perX)},
                             {"per_y", json(e.perY)},
                             {"threshold", json(e.threshold)},
                             {"side", QLatin1String(edgeSideId(e.side))}};
    }
    return {{"bounds", json(setup.bounds)},
            {"units_per_sample", setup.unitsPerSample},
            {"area2", json(setup.area2)},
            {"edges", edges}};
}

} // namespace

QJsonObject stepJson(const StepLog& log, std::size_t i)
{
    const StepEvent& event = log.event(i);
    QJsonObject object;
    visitPayload(log, event, [&](const auto& payload) { object = json(log, event, payload); });
    if (event.kind == StepKind::Triangle)
        object = triangleJson(*log.triangle(event));
    if (event.kind == StepKind::Setup)
        object = setupJson(*log.triangle(event));
    if (event.kind == StepKind::Outline)
        object = outlineJson(*log.triangle(event));
    if (event.kind == StepKind::LineSample)
        object.insert(QStringLiteral("on_target"), event.has(StepEvent::kCovered));
    object.insert(QStringLiteral("step"), static_cast<qint64>(log.numberOf(i)));
    object.insert(QStringLiteral("event"), QLatin1String(stepKindId(event.kind)));
    if (event.face != StepEvent::kNone)
        object.insert(QStringLiteral("face"), static_cast<qint64>(event.face));
    if (const std::int32_t line = log.lineOf(event.face); line > 0)
        object.insert(QStringLiteral("line"), line);
    const bool isSample = event.kind >= StepKind::Sample && event.kind <= StepKind::Write;
    if (isSample)
        object.insert(QStringLiteral("x"), event.x);
    if (isSample || event.kind == StepKind::Span || event.kind == StepKind::Crossing)
        object.insert(QStringLiteral("y"), event.y);
    if (isOfPattern(log, event))
        object.insert(QStringLiteral("sample"), event.sample);
    return object;
}

} // namespace rasterlens
