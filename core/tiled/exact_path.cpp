#include "core/tiled/exact_path.h"

#include "core/pipeline/depth_bias.h"
#include "core/pipeline/depth_test.h"
#include "core/pipeline/fate_count.h"
#include "core/pipeline/interpolation.h"
#include "core/pipeline/mask_test.h"
#include "core/pipeline/shading.h"
#include "core/pipeline/triangle_setup.h"
#include "core/pipeline/vertex_stage.h"

#include <bit>

namespace rasterlens::tiled
{
namespace
{

/// Counts the pieces of cut faces.
struct PieceCounter : NullObserver {
    explicit PieceCounter(Statistics::Faces& f) : faces(&f) {}
    void onClipped(std::uint32_t, int pieces)
    {
        ++faces->clipped;
        faces->createdByClipping += static_cast<std::uint64_t>(pieces);
    }
    Statistics::Faces* faces;
};

ProcessedVertex processedVertex(const FrameJob& job, std::size_t vertex)
{
    ProcessedVertex out;
    shadeVertexAt(*job.scene, job.matrices, job.rules, vertex, out.clip);
    job.stages->processVertex(out);
    return out;
}

/// Where a tile keeps the samples of its pixels.
struct StoredSamples {
    std::int32_t* key;
    std::uint32_t* ids;
    std::uint16_t* coverage;
};

StoredSamples storedSamples(const FrameJob& job, Worker& worker)
{
    if (job.pattern.isOn())
        return {worker.pattern.key.data(), worker.pattern.ids.data(), worker.pattern.coverage.data()};
    return {worker.samples.key.data(), worker.samples.ids.data(), worker.samples.coverage.data()};
}

/// Covers with one sample of each pixel: the triangle is moved so that the sample lies at the pixel's centre.
void coverSample(const FrameJob& job, const FaceInterpolation& interpolation, const MaskTest& mask,
                 std::uint32_t number, TileOrigin origin, std::size_t sample, Worker& worker)
{
    const glm::dvec2 offset(job.pattern.offsetX[sample], job.pattern.offsetY[sample]);
    ScreenTriangle moved = interpolation.triangle();
    for (ScreenVertex& vertex : moved.vertices)
        vertex.position -= offset;
    const auto setup = setupTriangle<std::int64_t>(moved, job.rules);
    if (!setup)
        return;
    const PixelRect& box = setup->bounds;
    const int yEnd = std::min({box.y + box.height, origin.y + job.grid.pitch, job.rules.rows()});
    const int xEnd = std::min({box.x + box.width, origin.x + job.grid.pitch, job.rules.columns()});
    const StoredSamples stored = storedSamples(job, worker);
    const DepthStore store(job.rules);
    const PassingDifferences test = passingDifferences(job.rules, moved.face);
    for (int y = std::max(box.y, origin.y); y < yEnd; ++y)
        for (int x = std::max(box.x, origin.x); x < xEnd; ++x) {
            const auto p = TriangleSetup<std::int64_t>::centre(x, y);
            ++worker.pixels.tested;
            const auto inside = [&](const EdgeFunction<std::int64_t>& e) { return e.at(p) >= e.threshold; };
            if (!std::all_of(setup->edges.begin(), setup->edges.end(), inside))
                continue;
            const Weights screen = interpolation.weightsAt(x, y);
            if (mask.mask != nullptr && isHole(mask, interpolation, screen, interpolation.perspective(screen)))
                continue;
            const std::size_t at =
                job.pattern.place(static_cast<std::size_t>(sampleIndex(x - origin.x, y - origin.y)), sample);
            const double depth = interpolation.depthAt(x, y, offset);
            const auto key = std::bit_cast<std::int32_t>(storedDepth(depth, store));
            const bool passed = test.holds(key, stored.key[at]);
            ++worker.pixels.covered;
            ++(passed ? worker.pixels.depthPassed : worker.pixels.depthFailed);
            if (job.countsCoverage() && stored.coverage[at] != 0xffff)
                ++stored.coverage[at];
            if (passed) {
                stored.key[at] = key;
                stored.ids[at] = number;
            }
        }
}

} // namespace

std::int32_t planesOutside(const FrameJob& job, std::size_t vertex)
{
    const ProcessedVertex v = processedVertex(job, vertex);
    return v.finite ? static_cast<std::int32_t>(v.outcode.view) : kNotFinite;
}

void processOutsideFace(const FrameJob& job, Chunk& chunk, std::uint32_t face, std::array<std::int32_t, 3> codes)
{
    chunk.clipped.clear();
    if (((codes[0] | codes[1] | codes[2]) & kNotFinite) != 0) {
        countFate(FaceFate::NonFinite, chunk.faces);
        return;
    }
    const auto seen = [&](std::size_t k) { return Outcode{static_cast<ClipPlanes>(codes[k]), 0}; };
    if (clipVerdict(job.rules.clipping, seen(0), seen(1), seen(2)) == ClipVerdict::Reject) {
        countFate(FaceFate::Rejected, chunk.faces);
        return;
    }
    std::array<ProcessedVertex, 3> vertices;
    for (std::size_t k = 0; k < 3; ++k)
        vertices[k] = processedVertex(job, job.scene->mesh.indices[3 * std::size_t(face) + k]);
    PieceCounter observer(chunk.faces);
    countFate(job.stages->process(face, {&vertices[0], &vertices[1], &vertices[2]}, chunk.clipped, observer),
              chunk.faces);
}

ScreenTriangle screenTriangle(const FrameJob& job, const Chunk& chunk, std::uint32_t source)
{
    if ((source & kPiece) != 0)
        return chunk.pieces[source & ~kPiece];
    ScreenTriangle triangle;
    triangle.isLine = false;
    triangle.sharedEdges = 0;
    triangle.face = source;
    for (std::size_t k = 0; k < 3; ++k) {
        const ProcessedVertex v = processedVertex(job, job.scene->mesh.indices[3 * std::size_t(source) + k]);
        triangle.vertices[k] = v.screen;
        triangle.vertices[k].varyings = v.clip.varyings;
    }
    const auto& [a, b, c] = triangle.vertices;
    triangle.area2 = twiceArea(a.position, b.position, c.position);
    if (isBiased(job.rules, source)) {
        const double bias = depthBias(triangle.vertices, job.rules);
        for (ScreenVertex& vertex : triangle.vertices)
            vertex.depth += bias;
    }
    return triangle;
}

void coverExactly(const FrameJob& job, const ScreenTriangle& piece, std::uint32_t number, TileOrigin origin,
                  Worker& worker)
{
    const FaceInterpolation interpolation(piece, piece.area2, job.rules);
    const MaskTest mask = maskTest(*job.scene, piece.face, job.rules);
    for (std::size_t sample = 0; sample < job.pattern.samples; ++sample)
        coverSample(job, interpolation, mask, number, origin, sample, worker);
}

void shadeExactly(const FrameJob& job, const VisibleTriangle& visible, const BlockShare& share, TileOrigin origin,
                  TileSamples& samples)
{
    const ScreenTriangle triangle = screenTriangle(job, *visible.chunk, visible.source);
    const FaceInterpolation interpolation(triangle, triangle.area2, job.rules);
    const FaceUniforms uniforms = faceUniforms(*job.scene, triangle.face, job.rules);
    for (unsigned lanes = share.lanes; lanes != 0; lanes &= lanes - 1) {
        const int lane = std::countr_zero(lanes);
        const int x = origin.x + blockColumn(share.block) * kBlockSide + lane % kBlockSide;
        const int y = origin.y + blockRow(share.block) * kBlockSide + lane / kBlockSide;
        const std::size_t at = std::size_t(share.block) * kLanes + std::size_t(lane);
        Varyings varyings;
        UvGradient gradient;
        // The centre of a pixel with a pattern has no stored depth.
        const float depth = job.pattern.isOn()
                                ? storedDepth(interpolation.depthAt(x, y, glm::dvec2(0)), DepthStore(job.rules))
                                : std::bit_cast<float>(samples.key[at]);
        if (job.rules.varyingCount > 0) {
            const Weights screen = interpolation.weightsAt(x, y);
            const Weights weights = interpolation.perspective(screen);
            interpolation.varyings(weights, varyings);
            if (needsUvGradient(job.rules, uniforms))
                gradient = interpolation.uvGradient(screen, weights, kVaryingUv);
        }
        samples.color[at] =
            shadeFragment(job.rules, uniforms, varyings, depth, glm::vec3(job.matrices.eyeObject), gradient);
    }
}

} // namespace rasterlens::tiled
