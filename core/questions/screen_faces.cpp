#include "core/questions/screen_faces.h"

#include "core/pipeline/geometry.h"
#include "core/pipeline/resolve.h"
#include "core/pipeline/triangle_setup.h"

#include <optional>

namespace rasterlens
{
namespace
{

/// Keeps what one face tells on its way to the screen.
class FaceWatch : public NullObserver
{
public:
    FaceWatch(const Rules& rules, std::vector<glm::dvec2>& corners) : m_rules(&rules), m_corners(&corners) {}

    bool front = false;

    void onViewport(std::uint32_t, int, const ClipVertex&, const ScreenVertex& vertex)
    {
        m_corners->push_back(vertex.position / double(m_rules->sampleGrid));
    }
    void onFacing(std::uint32_t, const FacingDecision& decision) { front = decision.value * m_rules->frontSign > 0; }

private:
    const Rules* m_rules;
    std::vector<glm::dvec2>* m_corners;
};

template <class T>
std::optional<PixelRect> boundsWith(const ScreenTriangle& triangle, const Rules& rules)
{
    const auto setup = setupTriangle<T>(triangle, rules);
    return setup ? std::optional(setup->bounds) : std::nullopt;
}

/// The box of samples that coverage looks through; nothing where it holds none, or where none is looked through.
std::optional<PixelRect> boundsOf(const ScreenTriangle& triangle, const Rules& rules)
{
    if (!passRules(rules, triangle.face).coversByCentres())
        return std::nullopt;
    switch (rules.numberType) {
    case NumberType::Fixed: return boundsWith<std::int64_t>(triangle, rules);
    case NumberType::Float32: return boundsWith<float>(triangle, rules);
    case NumberType::Float64: break;
    }
    return boundsWith<double>(triangle, rules);
}

ScreenPiece pieceOf(const ScreenTriangle& triangle, const Rules& rules)
{
    const double grid = rules.sampleGrid;
    ScreenPiece piece;
    piece.face = triangle.face;
    for (std::size_t i = 0; i < 3; ++i) {
        piece.corners[i] = triangle.vertices[i].position / grid;
        piece.invW[i] = triangle.vertices[i].invW;
    }
    if (const auto box = boundsOf(triangle, rules)) {
        piece.boxLow = glm::dvec2(box->x, box->y) / grid;
        piece.boxHigh = glm::dvec2(box->x + box->width, box->y + box->height) / grid;
    }
    return piece;
}

} // namespace

ScreenFaces screenFaces(const Scene& scene, const Settings& settings, const std::stop_token& stop)
{
    const Resolved resolved = resolve(settings, scene);
    const Rules& rules = resolved.rules;
    const Geometry geometry(scene, resolved.matrices, rules);
    ScreenFaces out;
    out.faces.resize(scene.mesh.faceCount());
    out.perspective = rules.perspectiveCorrect;
    std::vector<ScreenTriangle> triangles;
    for (const std::uint32_t face : geometry.order()) {
        if (stop.stop_requested())
            break;
        ScreenFace& kept = out.faces[face];
        kept.firstCorner = static_cast<std::uint32_t>(out.corners.size());
        kept.firstPiece = static_cast<std::uint32_t>(out.pieces.size());
        triangles.clear();
        FaceWatch watch(rules, out.corners);
        const FaceFate fate = geometry.process(face, triangles, watch);
        kept.front = watch.front;
        kept.drawn = fate == FaceFate::Rasterized;
        if (!kept.drawn)
            out.corners.resize(kept.firstCorner);
        kept.cornerCount = static_cast<std::uint32_t>(out.corners.size()) - kept.firstCorner;
        for (const ScreenTriangle& triangle : triangles)
            out.pieces.push_back(pieceOf(triangle, rules));
        kept.pieceCount = static_cast<std::uint32_t>(out.pieces.size()) - kept.firstPiece;
        if (fate == FaceFate::Rejected && !rules.continuesAfterReject)
            break;
    }
    return out;
}

} // namespace rasterlens
