#include "core/truth/distance_chart.h"

#include "core/pipeline/resolve.h"
#include "core/pipeline/vertex_stage.h"
#include "core/render/render.h"
#include "core/scene/camera.h"
#include "core/scene/origin.h"
#include "core/truth/coverage_difference.h"
#include "core/truth/exact_reference.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLocale>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace rasterlens
{
namespace
{

/// The positions of a scene after a move, as a file would give them.
std::vector<glm::dvec3> movedPositions(const Scene& scene, const glm::dvec3& move)
{
    std::vector<glm::dvec3> positions;
    positions.reserve(scene.mesh.vertices.size());
    for (std::size_t i = 0; i < scene.mesh.vertices.size(); ++i)
        positions.push_back(glm::dvec3(worldPosition(scene.mesh, i)) + move);
    return positions;
}

BoundingBox boxOf(const std::vector<glm::dvec3>& positions)
{
    BoundingBox box;
    for (const glm::dvec3& position : positions)
        box.add(position);
    return box;
}

/// Puts the positions into the mesh, told from an origin.
void place(Scene& scene, const std::vector<glm::dvec3>& positions, const glm::dvec3& origin)
{
    scene.mesh.origin = origin;
    for (std::size_t i = 0; i < positions.size(); ++i)
        scene.mesh.vertices[i].position = glm::vec4(objectFromWorld(positions[i], origin), 1);
}

/// The truth about positions in double: where the corners are, and which pixels are whose.
class Truth
{
public:
    /// in  the scene recentred, whose matrix in double is the camera's
    Truth(const Scene& recentred, const Settings& settings, const std::vector<glm::dvec3>& positions)
        : m_settings(settings), m_options(exactOptions(recentred, settings, ReferenceSpace::Object)),
          m_triangles(exactTriangles(recentred, settings, ReferenceSpace::Object)), m_background(recentred.background)
    {
        for (const glm::dvec3& position : positions)
            m_clip.push_back(*m_options.clipFromObject * glm::dvec4(position - recentred.mesh.origin, 1));
        for (ClipTriangle& triangle : m_triangles)
            for (std::size_t i = 0; i < 3; ++i) {
                const std::uint32_t vertex = recentred.mesh.indices[3 * std::size_t(triangle.face) + i];
                triangle.vertices[i].positionClip = glm::dvec4(positions[vertex] - recentred.mesh.origin, 1);
            }
    }

    /// Fills the errors of both scenes, and what is covered.
    void compare(const Scene& recentred, const Scene& plain, DistanceRow& row) const
    {
        row.recentred.corner = cornerError(recentred);
        row.float32.corner = cornerError(plain);
        constexpr Outputs kCompared{.depth = true, .ids = true, .coverage = true};
        Frame recentredFrame;
        render(recentred, m_settings, recentredFrame, kCompared);
        Frame plainFrame;
        render(plain, m_settings, plainFrame, kCompared);
        for (const PixelRect& band : bandsOf(m_options)) {
            ExactOptions options = m_options;
            options.window = band;
            const ExactFrame truth = exactReference(m_triangles, options);
            const CoverageDifference difference = coverageDifference(recentredFrame, truth, m_background);
            row.covered += difference.covered;
            row.recentred.wrong += difference.wrong();
            row.float32.wrong += coverageDifference(plainFrame, truth, m_background).wrong();
        }
    }

private:
    [[nodiscard]] glm::dvec2 pixelOf(const glm::dvec4& clip) const
    {
        return {(clip.x / clip.w * 0.5 + 0.5) * m_settings.size.width(),
                (0.5 - clip.y / clip.w * 0.5) * m_settings.size.height()};
    }

    /// The largest error of the corners that the picture shows. A corner that is no longer before the eye counts as the
    /// picture's diagonal.
    [[nodiscard]] double cornerError(const Scene& scene) const
    {
        const Resolved resolved = resolve(m_settings, scene);
        const std::vector<ClipVertex> drawn = shadeVertices(scene, resolved.matrices, resolved.rules);
        const double diagonal = std::hypot(m_settings.size.width(), m_settings.size.height());
        double largest = 0;
        for (std::size_t i = 0; i < drawn.size(); ++i) {
            const glm::dvec4& p = m_clip[i];
            if (!(p.w > 0 && std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) <= p.w))
                continue;
            const double away = glm::length(pixelOf(drawn[i].positionClip) - pixelOf(p));
            largest = std::max(largest, drawn[i].positionClip.w > 0 && std::isfinite(away) ? away : diagonal);
        }
        return largest;
    }

    const Settings& m_settings;
    ExactOptions m_options;
    std::vector<ClipTriangle> m_triangles;
    glm::vec3 m_background;
    std::vector<glm::dvec4> m_clip; ///< true to some 2^-50
};

DistanceRow rowAt(const Scene& scene, Settings settings, const glm::dvec3& move)
{
    settings.view.eye += move;
    settings.view.target += move;
    const std::vector<glm::dvec3> positions = movedPositions(scene, move);
    const BoundingBox box = boxOf(positions);
    Scene recentred = scene;
    place(recentred, positions, originFor(box));
    recentred.bounds = boundingSphere(recentred.mesh);
    Scene plain = scene;
    place(plain, positions, glm::dvec3(0));
    plain.bounds = {recentred.bounds.center + recentred.mesh.origin, recentred.bounds.radius}; // the same camera

    DistanceRow row;
    row.relativeSize = box.relativeSize();
    row.units = glm::length(box.center());
    Truth(recentred, settings, positions).compare(recentred, plain, row);
    return row;
}

QJsonObject errorJson(const DistanceError& error)
{
    return {{"corner_px", error.corner}, {"wrong_pixels", static_cast<qint64>(error.wrong)}};
}

} // namespace

std::vector<DistanceRow> distanceChart(const Scene& scene, const Settings& settings, std::span<const int> log2Sides,
                                       const std::function<void(std::size_t done)>& progress)
{
    const double side = boxOf(movedPositions(scene, glm::dvec3(0))).longestSide();
    std::vector<DistanceRow> rows;
    for (const int log2 : log2Sides) {
        rows.push_back(rowAt(scene, settings, std::ldexp(side, log2) * glm::dvec3(1, -1, 1)));
        if (progress)
            progress(rows.size());
    }
    return rows;
}

QByteArray distanceJson(std::span<const DistanceRow> rows)
{
    QJsonArray array;
    for (const DistanceRow& row : rows)
        array.append(QJsonObject{{"distance", row.units},
                                 {"relative_size", row.relativeSize},
                                 {"covered", static_cast<qint64>(row.covered)},
                                 {"recentred", errorJson(row.recentred)},
                                 {"float32", errorJson(row.float32)}});
    return QJsonDocument(array).toJson();
}

QByteArray distanceCsv(std::span<const DistanceRow> rows)
{
    const auto number = [](double value) { return QString::number(value, 'g', QLocale::FloatingPointShortest); };
    QString csv = QStringLiteral("distance,relative_size,covered,recentred_corner_px,recentred_wrong_pixels,"
                                 "float32_corner_px,float32_wrong_pixels\n");
    for (const DistanceRow& row : rows)
        csv += QStringList{number(row.units),
                           number(row.relativeSize),
                           QString::number(row.covered),
                           number(row.recentred.corner),
                           QString::number(row.recentred.wrong),
                           number(row.float32.corner),
                           QString::number(row.float32.wrong)}
                   .join(QLatin1Char(',')) +
               QLatin1Char('\n');
    return csv.toUtf8();
}

} // namespace rasterlens
