#pragma once
#include "core/pipeline/geometry.h"
#include "core/rasterizers/tiled/tile_data.h"
#include "core/render.h"

#include <optional>

namespace rasterlens::tiled
{

/// Everything the stages of a frame read.
struct FrameJob {
    const Scene* scene = nullptr;
    Rules rules;
    Matrices matrices;
    const FaceStages* stages = nullptr; ///< for faces that need more than the fast path has
    TileGrid grid;
    Outputs outputs;
    bool counting = false; ///< count samples: nothing hidden is skipped then
    std::uint32_t clearColor = 0;
    ScreenPoint* points = nullptr;  ///< a vertex of the mesh each
    float* clipW = nullptr;         ///< likewise
    glm::vec3* litColors = nullptr; ///< likewise; null where vertex colours are shown as they are
    std::vector<Chunk>* chunks = nullptr;
    std::uint32_t* color = nullptr; ///< the picture, row by row
    float* depth = nullptr;         ///< null if not asked for, as the following
    std::int32_t* ids = nullptr;
    std::uint16_t* coverage = nullptr;

    [[nodiscard]] bool countsCoverage() const
    {
        return counting || outputs.coverage || rules.shading == Shading::Overdraw;
    }
};

/// A triangle of the tile that won samples.
struct VisibleTriangle {
    std::uint32_t source;
    const Chunk* chunk;
    float x0; ///< where its planes are anchored, in samples of the tile
    float y0;
};

/// A block and the samples of it that a triangle won.
struct BlockShare {
    std::uint16_t block;
    std::uint16_t lanes; ///< a bit each
    std::uint32_t visible;
};

constexpr int kMaxPlanes = kMaxVaryings + 1;

/// Attributes of a triangle over the samples of a tile, divided by w where that is asked for.
struct AttributePlanes {
    bool exact;                              ///< too steep for float32: shaded sample by sample
    std::uint32_t color;                     ///< of flat shadings
    std::array<float, 3 * kMaxPlanes> plane; ///< origin, per x, per y; 1/w first
};

/// The memory one thread draws tiles with; kept from frame to frame.
struct Worker {
    TileSamples samples;
    std::vector<const BinBlock*> blocks; ///< of the tile, in the order of the faces
    std::vector<const Chunk*> blockChunk;
    std::vector<std::uint32_t> visibleOf; ///< of a triangle of the tile
    std::vector<VisibleTriangle> visible;
    std::vector<AttributePlanes> planes;
    std::vector<BlockShare> shares;
    Statistics::Pixels pixels;
};

/// The stages that are written in vector instructions.
struct Kernels {
    void (*processVertices)(const FrameJob& job, std::size_t begin, std::size_t end);
    void (*processFaces)(const FrameJob& job, Chunk& chunk, std::uint32_t begin, std::uint32_t end);
    void (*drawTile)(const FrameJob& job, Worker& worker, int column, int row);
};

/// The stages for an instruction set, or nothing where the machine does not have it. Auto is the best there is.
[[nodiscard]] const Kernels* kernelsFor(Simd simd);

} // namespace rasterlens::tiled
