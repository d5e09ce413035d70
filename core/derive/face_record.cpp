#include "core/derive/face_record.h"

#include "core/render/steps.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace rasterlens
{
namespace
{

/// The scene with one face, whose number is then 0, seen by the same camera.
Scene withFaceAlone(const Scene& scene, std::uint32_t face)
{
    Scene alone;
    alone.id = scene.id;
    alone.space = scene.space;
    alone.lit = scene.lit;
    alone.background = scene.background;
    alone.materials = scene.materials;
    alone.textures = scene.textures;
    alone.bounds = scene.bounds;
    alone.mesh.origin = scene.mesh.origin;
    for (std::uint32_t i = 0; i < 3; ++i) {
        alone.mesh.vertices.push_back(scene.mesh.vertices[scene.mesh.indices[3 * std::size_t(face) + i]]);
        alone.mesh.indices.push_back(i);
    }
    if (!scene.mesh.faceMaterial.empty())
        alone.mesh.faceMaterial.push_back(scene.mesh.faceMaterial[face]);
    if (scene.mesh.isLine(face))
        alone.mesh.lines.push_back(0);
    return alone;
}

Reason whyNotDrawn(FaceFate fate)
{
    switch (fate) {
    case FaceFate::Rejected: return QT_TRANSLATE_NOOP("Derive", "it lies outside the view volume");
    case FaceFate::CulledBack: return QT_TRANSLATE_NOOP("Derive", "it is a back face, and those are culled");
    case FaceFate::CulledFront: return QT_TRANSLATE_NOOP("Derive", "it is a front face, and those are culled");
    case FaceFate::Degenerate: return QT_TRANSLATE_NOOP("Derive", "it has no area on the screen");
    case FaceFate::NonFinite: return QT_TRANSLATE_NOOP("Derive", "a corner is no number");
    case FaceFate::Rasterized: break;
    }
    return QT_TRANSLATE_NOOP("Derive", "it holds no sample's centre");
}

std::vector<const StepTriangle*> trianglesOf(const StepLog& log)
{
    std::vector<const StepTriangle*> triangles;
    for (const std::uint32_t i : log.eventsOf(StepKind::Setup))
        if (const StepTriangle* triangle = log.triangle(log.event(i)); triangle != nullptr && triangle->hasSetup)
            triangles.push_back(triangle);
    return triangles;
}

SampledTriangle sampleAt(const FaceRecord& record, const StepTriangle& triangle, int x, int y)
{
    const StepSetup& setup = triangle.setup;
    SampledTriangle sample{&triangle, x, y, testedPoint(record.rules(), x, y), {}, false};
    const EdgeValues units = setup.at(sample.point);
    sample.isInside = decidingEdge(setup, units, record.rules()).isInside();
    for (std::size_t i = 0; i < 3; ++i)
        sample.values[i] = units[i] / setup.unitsPerArea;
    return sample;
}

/// A sample inside a triangle, near its middle if there is one.
std::optional<SampledTriangle> sampleInside(const FaceRecord& record, const StepTriangle& triangle)
{
    const auto& corners = triangle.setup.vertices;
    const glm::dvec2 middle = (corners[0] + corners[1] + corners[2]) / 3.0;
    const PixelRect& box = triangle.setup.bounds;
    const int middleX = std::clamp(static_cast<int>(std::floor(middle.x)), box.x, box.x + box.width - 1);
    const int middleY = std::clamp(static_cast<int>(std::floor(middle.y)), box.y, box.y + box.height - 1);
    if (const SampledTriangle sample = sampleAt(record, triangle, middleX, middleY); sample.isInside)
        return sample;
    for (int y = box.y; y < box.y + box.height; ++y)
        for (int x = box.x; x < box.x + box.width; ++x)
            if (const SampledTriangle sample = sampleAt(record, triangle, x, y); sample.isInside)
                return sample;
    return std::nullopt;
}

[[noreturn]] void refuseUndrawn(const FaceRecord& record)
{
    if (record.scene().mesh.isLine(record.place().face))
        throw NoDerivation{
            Reason(QT_TRANSLATE_NOOP("Derive", "face %1 is a line, and covers no area"), {record.place().face})};
    const FateStep* fate = record.first<FateStep>();
    throw NoDerivation{Reason(QT_TRANSLATE_NOOP("Derive", "face %1 is not drawn: %2"),
                              {record.place().face, whyNotDrawn(fate != nullptr ? fate->fate : FaceFate::Rasterized)})};
}

} // namespace

FaceRecord::FaceRecord(const Scene& scene, const Settings& settings, const DerivationPlace& place, std::stop_token stop)
    : m_scene(&scene), m_settings(settings), m_place(place), m_stop(std::move(stop)),
      m_alone(withFaceAlone(scene, place.face)), m_corners(vertexTable(scene, settings, place.face))
{
    StepFilter filter;
    filter.kinds = kAllSteps & ~(kindBit(StepKind::Sample) | kindBit(StepKind::Fragment) | kindBit(StepKind::Shade) |
                                 kindBit(StepKind::Write) | kindBit(StepKind::LineSample));
    m_log = logOf(settings, filter);
}

std::shared_ptr<const StepLog> FaceRecord::logOf(const Settings& settings, StepFilter filter) const
{
    return renderSteps(m_alone, settings, filter, m_stop);
}

SampledTriangle sampleOf(const FaceRecord& record, SampleNeed need)
{
    const std::vector<const StepTriangle*> triangles = trianglesOf(record.log());
    if (triangles.empty())
        refuseUndrawn(record);
    std::optional<SampledTriangle> inside;
    if (const std::optional<QPoint>& pixel = record.place().pixel) {
        const int grid = record.rules().sampleGrid;
        const int x = pixel->x() * grid + grid / 2;
        const int y = pixel->y() * grid + grid / 2;
        for (std::size_t i = 0; i < triangles.size() && !inside; ++i)
            if (const SampledTriangle sample = sampleAt(record, *triangles[i], x, y); sample.isInside)
                inside = sample;
        if (!inside && need == SampleNeed::Any)
            return sampleAt(record, *triangles.front(), x, y);
        if (!inside)
            throw NoDerivation{Reason(QT_TRANSLATE_NOOP("Derive", "pixel (%1, %2) is not inside face %3"),
                                      {pixel->x(), pixel->y(), record.place().face})};
        return *inside;
    }
    for (std::size_t i = 0; i < triangles.size() && !inside; ++i)
        inside = sampleInside(record, *triangles[i]);
    if (!inside)
        refuseUndrawn(record);
    return *inside;
}

SampledFragment fragmentOf(const FaceRecord& record, const SampledTriangle& sample, const Settings& settings)
{
    const int grid = record.rules().sampleGrid;
    StepFilter filter;
    filter.pixels = PixelRect{sample.x / grid, sample.y / grid, 1, 1};
    filter.kinds = kindBit(StepKind::Fragment) | kindBit(StepKind::Shade);
    const std::shared_ptr<const StepLog> log = record.logOf(settings, filter);
    SampledFragment found;
    bool isShaded = false;
    for (const StepEvent& event : log->events()) {
        if (event.x != sample.x || event.y != sample.y)
            continue;
        if (event.kind == StepKind::Fragment) {
            found.numbers = log->payload<FragmentStep>(event);
            isShaded = found.numbers.shaded;
        } else if (event.kind == StepKind::Shade) {
            found.color = log->payload<ShadeStep>(event).color;
        }
    }
    if (!isShaded)
        throw NoDerivation{Reason(QT_TRANSLATE_NOOP("Derive", "nothing of face %1 is shaded at pixel (%2, %3)"),
                                  {record.place().face, sample.x / grid, sample.y / grid})};
    return found;
}

void requireBeforeEye(const FaceRecord& record)
{
    for (std::size_t i = 0; i < 3; ++i)
        if (!(record.corners()[i].clip.w > 0))
            throw NoDerivation{
                Reason(QT_TRANSLATE_NOOP("Derive", "corner %1 of face %2 is not in front of the eye: w is "
                                                   "%3"),
                       {cornerLetter(i), record.place().face, shortNumber(record.corners()[i].clip.w)})};
}

Reason faceReason(const FaceRecord& record) { return {QT_TRANSLATE_NOOP("Derive", "face %1"), {record.place().face}}; }

Reason pixelReason(const FaceRecord& record, const SampledTriangle& sample)
{
    const int grid = record.rules().sampleGrid;
    return {QT_TRANSLATE_NOOP("Derive", "face %1, pixel (%2, %3)"),
            {record.place().face, sample.x / grid, sample.y / grid}};
}

Settings withArea(Settings settings)
{
    settings.algorithm = Algorithm::EdgeEquation;
    settings.fill = Fill::Solid;
    settings.attributePath = AttributePath::Planes;
    if (dividedEvery(settings.interpolation) > 1)
        settings.interpolation = Interpolation::Perspective; // what the samples between two divisions come close to
    settings.shading = Shading::Gouraud;
    return settings;
}

} // namespace rasterlens
