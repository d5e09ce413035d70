#include "core/observe/step_text.h"

#include "core/scene/origin.h"

#include <QJsonArray>
#include <QLocale>
#include <QStringList>

#include <cmath>

namespace rasterlens
{
namespace
{

QString letter(std::size_t vertex) { return QString(QLatin1Char(char('A' + vertex))); }

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

QString text(const StepLog&, const StepEvent&, const VertexStep& step)
{
    const QString world = step.origin == glm::dvec3(0)
                              ? QString()
                              : QStringLiteral("world (%1), ").arg(worldText(step.positionObject, step.origin));
    return QStringLiteral("%1 = vertex %2: %3object %4 -> clip %5, outside %6")
        .arg(letter(std::size_t(step.corner)))
        .arg(step.meshVertex)
        .arg(world, clipText(step.positionObject), clipText(step.clip.positionClip), planesText(step.outside));
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

QString text(const StepLog&, const StepEvent&, const ClipStep& step)
{
    QStringList cuts;
    for (const ClipCut& cut : step.cuts)
        cuts << QStringLiteral("%1->%2 t=%3").arg(cut.inside).arg(cut.outside).arg(shortNumber(cut.t));
    return QStringLiteral("%1: %2 -> %3 vertices%4")
        .arg(QLatin1String(clipPlaneId(step.plane)))
        .arg(step.before.size())
        .arg(step.after.size())
        .arg(cuts.isEmpty() ? QString() : QStringLiteral(", cuts ") + cuts.join(QStringLiteral(", ")));
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

QString regionText(unsigned region) { return QString::number(region & 15U, 2).rightJustified(4, QLatin1Char('0')); }

QString text(const StepLog&, const StepEvent&, const CohenSutherlandStep& step)
{
    QStringList codes;
    for (const unsigned region : step.regions)
        codes << regionText(region);
    return QStringLiteral("outcodes %1: %2 -> %3 vertices")
        .arg(codes.join(QLatin1Char(' ')))
        .arg(step.before.size())
        .arg(step.after.size());
}

QJsonObject json(const StepLog&, const StepEvent&, const CohenSutherlandStep& step)
{
    QJsonArray regions;
    for (const unsigned region : step.regions)
        regions << regionText(region);
    return {{"before", positions(step.before)}, {"outcodes", regions}, {"after", positions(step.after)}};
}

QString text(const StepLog&, const StepEvent&, const ViewportStep& step)
{
    return QStringLiteral("corner %1: %2 -> %3, depth %4, 1/w %5")
        .arg(step.corner)
        .arg(pointText(step.unsnapped),
             QStringLiteral("(%1, %2)").arg(fullNumber(step.screen.position.x), fullNumber(step.screen.position.y)),
             shortNumber(step.screen.depth), shortNumber(step.screen.invW));
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

QString text(const StepLog&, const StepEvent&, const FacingStep& step)
{
    const FacingDecision& d = step.decision;
    return QStringLiteral("%1 %2, screen area %3: %4")
        .arg(QLatin1String(facingId(d.by)), shortNumber(d.value), shortNumber(d.screenArea),
             QLatin1String(faceFateId(d.fate)));
}

QJsonObject json(const StepLog&, const StepEvent&, const FacingStep& step)
{
    const FacingDecision& d = step.decision;
    return {{"space", QLatin1String(facingId(d.by))},
            {"value", json(d.value)},
            {"screen_area", json(d.screenArea)},
            {"fate", QLatin1String(faceFateId(d.fate))}};
}

QString text(const StepLog&, const StepEvent&, const FanStep& step)
{
    return QStringLiteral("%1 triangles").arg(step.pieces);
}

QJsonObject json(const StepLog&, const StepEvent&, const FanStep& step) { return {{"pieces", step.pieces}}; }

QString text(const StepLog&, const StepEvent&, const FateStep& step) { return QLatin1String(faceFateId(step.fate)); }

QJsonObject json(const StepLog&, const StepEvent&, const FateStep& step)
{
    return {{"fate", QLatin1String(faceFateId(step.fate))}};
}

QString text(const StepLog&, const StepEvent&, const WalkStep& step)
{
    const WalkedTriangle& w = step.walk;
    QStringList corners;
    for (std::size_t i = 0; i < 3; ++i)
        corners << letter(w.source[i]) + QLatin1Char(' ') + pointText(w.vertices[i]);
    return QStringLiteral("by y: %1; long edge %2, rows %3..%4")
        .arg(corners.join(QStringLiteral(", ")), w.longEdgeIsLeft ? QStringLiteral("left") : QStringLiteral("right"))
        .arg(w.firstRow)
        .arg(w.lastRow);
}

QJsonObject json(const StepLog&, const StepEvent&, const WalkStep& step)
{
    const WalkedTriangle& w = step.walk;
    QJsonArray vertices;
    for (const glm::dvec2& vertex : w.vertices)
        vertices << json(vertex);
    return {{"vertices", vertices},
            {"source", letter(w.source[0]) + letter(w.source[1]) + letter(w.source[2])},
            {"long_edge", w.longEdgeIsLeft ? "left" : "right"},
            {"first_row", w.firstRow},
            {"last_row", w.lastRow}};
}

QString text(const StepLog&, const StepEvent&, const SpanStep& step)
{
    return QStringLiteral("x %1..%2 -> [%3, %4), long edge %5, %6 half")
        .arg(shortNumber(step.ends.left), shortNumber(step.ends.right))
        .arg(step.xBegin)
        .arg(step.xEnd)
        .arg(step.ends.longEdgeIsLeft ? QStringLiteral("left") : QStringLiteral("right"),
             step.ends.upperHalf ? QStringLiteral("upper") : QStringLiteral("lower"));
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

/// `AB 12.5  BC 0 (left, ours)  CA -3.5`
QString edgesText(const StepSetup& setup, const EdgeValues& values)
{
    QStringList parts;
    for (std::size_t i = 0; i < 3; ++i) {
        QString part = edgeName(setup, int(i)) + QLatin1Char(' ') + edgeValueText(values[i], setup.unitsPerArea);
        if (values[i] == 0)
            part +=
                QStringLiteral(" (%1, %2)")
                    .arg(QLatin1String(edgeSideId(setup.edges[i].side)),
                         values[i] >= setup.edges[i].threshold ? QStringLiteral("ours") : QStringLiteral("not ours"));
        parts << part;
    }
    return parts.join(QStringLiteral("  "));
}

QString text(const StepLog& log, const StepEvent& event, const SampleStep& step)
{
    return edgesText(log.triangle(event)->setup, step.values) +
           (event.has(StepEvent::kCovered) ? QStringLiteral("  inside") : QStringLiteral("  outside")) +
           (event.has(StepEvent::kTie) ? QStringLiteral(", tie") : QString());
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

QString text(const StepLog&, const StepEvent&, const LineStep& step)
{
    const LineDecision& d = step.decision;
    return QStringLiteral("i %1, p %2, d_lower %3, d_upper %4: %5")
        .arg(d.step)
        .arg(d.decision)
        .arg(shortNumber(step.dLower()), shortNumber(step.dUpper()),
             d.sideways ? QStringLiteral("step along both axes") : QStringLiteral("step along the longer axis"));
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

QString text(const StepLog&, const StepEvent& event, const FragmentStep& step)
{
    return QStringLiteral("weights %1 -> %2, 1/w %3, depth %4 against %5: %6")
        .arg(weightsText(step.screen), weightsText(step.weights), shortNumber(step.invW),
             shortNumber(double(step.depth)), shortNumber(double(step.storedDepth)),
             event.has(StepEvent::kPassed) ? QStringLiteral("passed") : QStringLiteral("failed"));
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

QString text(const StepLog&, const StepEvent&, const ShadeStep& step) { return colorText(step.color); }

QJsonObject json(const StepLog&, const StepEvent&, const ShadeStep& step) { return {{"color", colorText(step.color)}}; }

QString text(const StepLog&, const StepEvent&, const WriteStep& step)
{
    return QStringLiteral("%1 -> %2, depth %3 -> %4")
        .arg(colorText(step.before.color), colorText(step.after.color), shortNumber(double(step.before.depth)),
             shortNumber(double(step.after.depth)));
}

QJsonObject json(const StepLog&, const StepEvent&, const WriteStep& step)
{
    return {{"before", json(step.before)}, {"after", json(step.after)}};
}

QString triangleText(const StepTriangle& triangle)
{
    QStringList corners;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec2& p = triangle.screen.vertices[i].position;
        corners << QStringLiteral("%1 (%2, %3)").arg(letter(i), fullNumber(p.x), fullNumber(p.y));
    }
    return corners.join(QStringLiteral(", "));
}

QJsonObject triangleJson(const StepTriangle& triangle)
{
    QJsonArray corners;
    for (const ScreenVertex& v : triangle.screen.vertices)
        corners << QJsonObject{{"screen", json(v.position)}, {"depth", json(v.depth)}, {"inv_w", json(v.invW)}};
    return {{"vertices", corners}};
}

QString setupText(const StepTriangle& triangle)
{
    if (!triangle.hasSetup)
        return QStringLiteral("no sample's centre within its bounds, or no area");
    QStringList edges;
    for (std::size_t i = 0; i < 3; ++i) {
        const StepEdge& e = triangle.setup.edges[i];
        edges << QStringLiteral("%1 +%2 per x, +%3 per y, inside from %4 (%5)")
                     .arg(edgeName(triangle.setup, int(i)), edgeValueText(e.perX, triangle.setup.unitsPerArea),
                          edgeValueText(e.perY, triangle.setup.unitsPerArea), shortNumber(e.threshold),
                          QLatin1String(edgeSideId(e.side)))
                     .replace(QStringLiteral("+-"), QStringLiteral("-"));
    }
    const PixelRect& b = triangle.setup.bounds;
    return QStringLiteral("bounds %1..%2 x %3..%4; ").arg(b.x).arg(b.x + b.width - 1).arg(b.y).arg(b.y + b.height - 1) +
           edges.join(QStringLiteral("; "));
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

/// Calls visit(payload) with what the event holds.
template <class Visit>
void visitPayload(const StepLog& log, const StepEvent& event, Visit&& visit)
{
    switch (event.kind) {
    case StepKind::Vertex: visit(log.payload<VertexStep>(event)); break;
    case StepKind::ClipPlane: visit(log.payload<ClipStep>(event)); break;
    case StepKind::CohenSutherland: visit(log.payload<CohenSutherlandStep>(event)); break;
    case StepKind::Viewport: visit(log.payload<ViewportStep>(event)); break;
    case StepKind::Facing: visit(log.payload<FacingStep>(event)); break;
    case StepKind::Clipped: visit(log.payload<FanStep>(event)); break;
    case StepKind::Fate: visit(log.payload<FateStep>(event)); break;
    case StepKind::Walk: visit(log.payload<WalkStep>(event)); break;
    case StepKind::Span: visit(log.payload<SpanStep>(event)); break;
    case StepKind::Sample: visit(log.payload<SampleStep>(event)); break;
    case StepKind::LineDecision: visit(log.payload<LineStep>(event)); break;
    case StepKind::Fragment: visit(log.payload<FragmentStep>(event)); break;
    case StepKind::Shade: visit(log.payload<ShadeStep>(event)); break;
    case StepKind::Write: visit(log.payload<WriteStep>(event)); break;
    case StepKind::Triangle:
    case StepKind::Setup:
    case StepKind::LineSample:
    case StepKind::End: break;
    }
}

} // namespace

QString shortNumber(double value) { return QString::number(value, 'g', 6); }

QString fullNumber(double value) { return QString::number(value, 'g', QLocale::FloatingPointShortest); }

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
    return letter(setup.source[std::size_t(edge)]) + letter(setup.source[std::size_t((edge + 1) % 3)]);
}

const char* clipPlaneId(ClipPlane plane)
{
    switch (plane) {
    case ClipPlane::W: return "w";
    case ClipPlane::Right: return "right";
    case ClipPlane::Left: return "left";
    case ClipPlane::Top: return "top";
    case ClipPlane::Bottom: return "bottom";
    case ClipPlane::Near: return "near";
    case ClipPlane::Far: return "far";
    }
    return "";
}

const char* faceFateId(FaceFate fate)
{
    switch (fate) {
    case FaceFate::Rejected: return "rejected";
    case FaceFate::CulledBack: return "culled-back";
    case FaceFate::CulledFront: return "culled-front";
    case FaceFate::Degenerate: return "degenerate";
    case FaceFate::NonFinite: return "non-finite";
    case FaceFate::Rasterized: return "rasterized";
    }
    return "";
}

const char* facingId(Facing facing)
{
    switch (facing) {
    case Facing::ClipDeterminant: return "clip";
    case Facing::ViewNormal: return "view";
    case Facing::LightNormal: return "light";
    case Facing::AreaWithoutDivide: return "undivided";
    case Facing::AreaWithoutClipping: return "unclipped";
    case Facing::ScreenArea: break;
    }
    return "screen";
}

QString colorText(std::uint32_t color)
{
    return QLatin1Char('#') + QString::number(color & 0xffffffU, 16).rightJustified(6, QLatin1Char('0'));
}

QString planesText(std::uint32_t planes)
{
    QStringList names;
    for (unsigned i = 0; i < 7; ++i)
        if ((planes & 1U << i) != 0)
            names << QLatin1String(clipPlaneId(static_cast<ClipPlane>(i)));
    return names.isEmpty() ? QStringLiteral("none") : names.join(QLatin1Char('+'));
}

QString faceText(std::uint32_t face, std::int32_t line)
{
    const QString text = QStringLiteral("face %1").arg(face);
    return line > 0 ? text + QStringLiteral(" (line %1)").arg(line) : text;
}

QString stepText(const StepLog& log, std::size_t i)
{
    const StepEvent& event = log.event(i);
    QString line = QStringLiteral("%1 %2").arg(i).arg(QLatin1String(stepKindId(event.kind)));
    if (event.face != StepEvent::kNone)
        line += QLatin1Char(' ') + faceText(event.face, log.lineOf(event.face));
    if (event.x >= 0 || event.kind == StepKind::LineSample || event.kind == StepKind::LineDecision)
        line += QStringLiteral(" (%1, %2)").arg(event.x).arg(event.y);
    else if (event.kind == StepKind::Span)
        line += QStringLiteral(" row %1").arg(event.y);
    QString numbers;
    visitPayload(log, event, [&](const auto& payload) { numbers = text(log, event, payload); });
    if (event.kind == StepKind::Triangle)
        numbers = triangleText(*log.triangle(event));
    if (event.kind == StepKind::Setup)
        numbers = setupText(*log.triangle(event));
    if (event.kind == StepKind::LineSample && !event.has(StepEvent::kCovered))
        numbers = QStringLiteral("off the target");
    return numbers.isEmpty() ? line : line + QStringLiteral(": ") + numbers;
}

QJsonObject stepJson(const StepLog& log, std::size_t i)
{
    const StepEvent& event = log.event(i);
    QJsonObject object;
    visitPayload(log, event, [&](const auto& payload) { object = json(log, event, payload); });
    if (event.kind == StepKind::Triangle)
        object = triangleJson(*log.triangle(event));
    if (event.kind == StepKind::Setup)
        object = setupJson(*log.triangle(event));
    if (event.kind == StepKind::LineSample)
        object.insert(QStringLiteral("on_target"), event.has(StepEvent::kCovered));
    object.insert(QStringLiteral("step"), static_cast<qint64>(i));
    object.insert(QStringLiteral("event"), QLatin1String(stepKindId(event.kind)));
    if (event.face != StepEvent::kNone)
        object.insert(QStringLiteral("face"), static_cast<qint64>(event.face));
    if (const std::int32_t line = log.lineOf(event.face); line > 0)
        object.insert(QStringLiteral("line"), line);
    const bool isSample = event.kind >= StepKind::Sample && event.kind <= StepKind::Write;
    if (isSample)
        object.insert(QStringLiteral("x"), event.x);
    if (isSample || event.kind == StepKind::Span)
        object.insert(QStringLiteral("y"), event.y);
    return object;
}

} // namespace rasterlens
