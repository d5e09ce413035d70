#include "core/questions/vertex_table.h"

#include "core/observe/step_log.h"
#include "core/pipeline/clipping.h"
#include "core/pipeline/resolve.h"
#include "core/pipeline/unsnapped.h"
#include "core/pipeline/vertex_stage.h"
#include "core/pipeline/viewport.h"
#include "core/scene/origin.h"

#include <algorithm>
#include <cmath>

namespace rasterlens
{

std::array<VertexRow, 3> vertexTable(const Scene& scene, const Settings& settings, std::uint32_t face)
{
    const Resolved resolved = resolve(settings, scene);
    const Rules& rules = resolved.rules;
    const Matrices& matrices = resolved.matrices;
    const ClipVolume volume = clipVolume(rules);

    // The vertex stage sees a scene of these three vertices alone.
    Scene corners;
    corners.space = scene.space;
    corners.lit = scene.lit;
    std::array<VertexRow, 3> rows;
    for (std::size_t i = 0; i < 3; ++i) {
        rows[i].meshVertex = scene.mesh.indices[3 * std::size_t(face) + i];
        corners.mesh.vertices.push_back(scene.mesh.vertices[rows[i].meshVertex]);
    }
    const std::vector<ClipVertex> clipVertices = shadeVertices(corners, matrices, rules);
    for (std::size_t i = 0; i < 3; ++i) {
        VertexRow& row = rows[i];
        row.object = glm::dvec4(corners.mesh.vertices[i].position);
        if (scene.mesh.origin != glm::dvec3(0))
            row.world = worldText(corners.mesh.vertices[i].position, scene.mesh.origin);
        row.view = matrices.viewFromObject * row.object;
        row.clip = clipVertices[i].positionClip;
        row.ndc = glm::dvec3(row.clip) / row.clip.w;
        row.screen = unsnappedPosition(row.clip, rules) / double(rules.sampleGrid);
        const ScreenVertex onScreen = toScreen(clipVertices[i], rules);
        row.snapped = onScreen.position / double(rules.sampleGrid);
        row.depth = rules.depthIsDistance ? depthOfDistance(row.clip.w, matrices.near, matrices.far) : onScreen.depth;
        row.outside = outcode(row.clip, volume).view;
        row.screenRegion = screenRegion(row.clip);
    }
    return rows;
}

bool isBeforeEye(const VertexRow& corner) { return corner.clip.w > 0 && std::isfinite(corner.clip.w); }

int mostUnequalEdge(const std::array<VertexRow, 3>& corners)
{
    int best = 0;
    double most = 0;
    for (int edge = 0; edge < 3; ++edge) {
        const VertexRow& from = corners[static_cast<std::size_t>(edge)];
        const VertexRow& to = corners[static_cast<std::size_t>((edge + 1) % 3)];
        if (!isBeforeEye(from) || !isBeforeEye(to))
            continue;
        const double ratio = std::max(from.clip.w / to.clip.w, to.clip.w / from.clip.w);
        if (ratio > most) {
            most = ratio;
            best = edge;
        }
    }
    return best;
}

} // namespace rasterlens
