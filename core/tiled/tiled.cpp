#include "core/tiled/tiled.h"

#include "core/base/stopwatch.h"
#include "core/pipeline/framebuffer.h"
#include "core/pipeline/shading.h"
#include "core/scene/camera.h"
#include "core/settings/sample_pattern.h"
#include "core/tiled/context.h"
#include "core/tiled/kernels.h"

#include <algorithm>
#include <new>

namespace rasterlens
{
namespace
{

using namespace tiled;

constexpr std::size_t kVerticesPerTask = 4096;
constexpr int kTilesPerTask = 8;
constexpr std::size_t kFewestFacesPerChunk = 1024;
constexpr std::size_t kChunksPerThread = 4; ///< so that threads finish about together
constexpr std::size_t kMostBins = 16384;    ///< in all chunks: the last block of each is half empty

/// The frame's context, made or, where a copy of the frame has it too, made anew.
///
/// in   samples a pixel of a pattern
TiledContext& contextOf(Frame& frame, int threads, std::size_t samples)
{
    if (!frame.tiled || frame.tiled.use_count() > 1)
        frame.tiled = std::make_shared<TiledContext>();
    TiledContext& context = *frame.tiled;
    if (!context.pool || context.pool->threads() != threads)
        context.pool = std::make_unique<ThreadPool>(threads);
    while (context.workers.size() < static_cast<std::size_t>(threads))
        context.workers.push_back(std::make_unique<Worker>());
    std::size_t blocks = 0;
    std::size_t visible = 0;
    for (const auto& worker : context.workers) {
        blocks = std::max(blocks, worker->blocks.capacity());
        visible = std::max(visible, worker->visible.capacity());
    }
    for (const auto& worker : context.workers) { // any worker may get the fullest tile this time
        worker->shares.reserve(kTileSamples * samples);
        if (samples > 1)
            worker->pattern.reserve(samples);
        worker->blocks.reserve(blocks);
        worker->visibleOf.reserve(blocks * BinBlock::kCapacity);
        worker->visible.reserve(visible);
        worker->pixels = {};
    }
    return context;
}

PixelPattern pixelPattern(const Rules& rules)
{
    PixelPattern pattern;
    const std::span<const SampleOffset> offsets = samplePattern(rules.patternSamples);
    pattern.samples = offsets.size();
    for (std::size_t i = 0; i < offsets.size(); ++i) {
        pattern.x[i] = offsets[i].x;
        pattern.y[i] = offsets[i].y;
        pattern.offsetX[i] = offsets[i].pixels().x;
        pattern.offsetY[i] = offsets[i].pixels().y;
        pattern.reach = std::max({pattern.reach, std::abs(pattern.x[i]), std::abs(pattern.y[i])});
    }
    return pattern;
}

TileGrid tileGrid(const Rules& rules)
{
    TileGrid grid;
    grid.pitch = rules.sampleGrid == 3 ? 48 : kTileSide; // whole subtiles and whole pixels
    grid.columns = (rules.columns() + grid.pitch - 1) / grid.pitch;
    grid.rows = (rules.rows() + grid.pitch - 1) / grid.pitch;
    return grid;
}

void clearChunks(TiledContext& context, const FrameJob& job, std::size_t faces, int threads)
{
    const auto workers = static_cast<std::size_t>(threads);
    const std::size_t wanted =
        workers == 1 ? 1 : std::clamp(kMostBins / job.grid.count(), workers, kChunksPerThread * workers);
    const std::size_t count = std::clamp<std::size_t>(faces / kFewestFacesPerChunk, 1, wanted);
    context.chunks.resize(count);
    for (Chunk& chunk : context.chunks) {
        chunk.bins.assign(job.grid.count(), {});
        chunk.pieces.clear();
        chunk.varyingCount = 0;
        chunk.arena.reset(job.hasTexels());
        chunk.faces = {};
    }
}

template <class T>
T* output(std::vector<T>& memory, bool asked, std::size_t count)
{
    memory.resize(asked ? count : 0);
    return asked ? memory.data() : nullptr;
}

/// A picture in pages of 2 MiB: the rows of a tile lie in as many small pages, which would all have to be looked up.
QImage newPicture(int width, int height)
{
    using Memory = LargeArray<std::uint32_t>;
    auto memory = std::make_unique<Memory>();
    std::uint32_t* pixels = memory->reserve(std::size_t(width) * std::size_t(height));
    const auto release = [](void* owner) { delete static_cast<Memory*>(owner); };
    QImage picture(reinterpret_cast<uchar*>(pixels), width, height, width * qsizetype(sizeof *pixels),
                   QImage::Format_RGB32, release, memory.get());
    memory.release(); // it is the picture's now
    return picture;
}

/// Whether what is asked for still holds what was drawn, and would be cleared to the same.
bool isUnchanged(const PictureMemory& memory, const Frame& frame, const FrameJob& job)
{
    const Rules& rules = job.rules;
    const bool picture =
        !job.outputs.picture || (memory.image == frame.image.cacheKey() && memory.emptyColor == job.emptyColor);
    const std::size_t pixels = std::size_t(rules.width) * std::size_t(rules.height);
    const bool depth = !job.outputs.depth || (memory.depth == frame.depth.key() && frame.depth.size() == pixels &&
                                              memory.depthClear == rules.depthClear);
    return picture && depth && memory.size == QSize(rules.width, rules.height) && memory.pitch == job.grid.pitch &&
           memory.blank.size() == job.grid.count();
}

/// Where the frame goes, and what is already there.
void aim(FrameJob& job, Frame& frame, PictureMemory& picture)
{
    const Rules& rules = job.rules;
    const bool fits =
        frame.image.size() == QSize(rules.width, rules.height) && frame.image.format() == QImage::Format_RGB32;
    if (!job.outputs.picture)
        frame.image = QImage();
    else if (!fits)
        frame.image = newPicture(rules.width, rules.height);
    if (!isUnchanged(picture, frame, job))
        picture.blank.assign(job.grid.count(), 0);
    job.blank = picture.blank.data();
    const std::size_t pixels = std::size_t(rules.width) * std::size_t(rules.height);
    if (job.outputs.picture) {
        job.color = reinterpret_cast<std::uint32_t*>(frame.image.bits());
        if (job.color == nullptr) // shared, and no memory for a copy
            throw std::bad_alloc();
    }
    if (job.outputs.depth)
        job.depth = frame.depth.write(pixels);
    else
        frame.depth.clear();
    job.ids = output(frame.ids, job.outputs.ids, pixels);
    job.coverage = output(frame.coverage, job.outputs.coverage, pixels);
    const bool countsSamples = job.outputs.sampleCoverage && job.pattern.isOn();
    job.sampleCoverage = output(frame.sampleCoverage, countsSamples, pixels * job.pattern.samples);
    picture.size = {rules.width, rules.height};
    picture.pitch = job.grid.pitch;
    picture.image = frame.image.cacheKey();
    picture.emptyColor = job.emptyColor;
    picture.depth = frame.depth.key();
    picture.depthClear = rules.depthClear;
}

void add(Statistics::Faces& sum, const Statistics::Faces& f)
{
    sum.submitted += f.submitted;
    sum.rejected += f.rejected;
    sum.culledBack += f.culledBack;
    sum.culledFront += f.culledFront;
    sum.degenerate += f.degenerate;
    sum.nonFinite += f.nonFinite;
    sum.clipped += f.clipped;
    sum.createdByClipping += f.createdByClipping;
    sum.rasterized += f.rasterized;
}

void add(Statistics::Pixels& sum, const Statistics::Pixels& p)
{
    sum.tested += p.tested;
    sum.covered += p.covered;
    sum.depthPassed += p.depthPassed;
    sum.depthFailed += p.depthFailed;
    sum.shaded += p.shaded;
    sum.written += p.written;
}

Statistics collect(const TiledContext& context)
{
    Statistics statistics;
    for (const Chunk& chunk : context.chunks)
        add(statistics.faces, chunk.faces);
    for (const auto& worker : context.workers)
        add(statistics.pixels, worker->pixels);
    return statistics;
}

/// Whether faces share so many vertices that it pays to process each once and keep it.
bool sharesVertices(const Mesh& mesh)
{
    constexpr std::size_t kMostCorners = 1U << 27; // their places in the mesh fit 32 bits
    return mesh.vertices.size() < 2 * mesh.faceCount() || mesh.vertices.size() > kMostCorners;
}

void processVertices(const FrameJob& job, const Kernels& kernels, ThreadPool& pool)
{
    const std::size_t count = job.scene->mesh.vertices.size();
    pool.forEach((count + kVerticesPerTask - 1) / kVerticesPerTask, [&](int, std::size_t task) {
        const std::size_t begin = task * kVerticesPerTask;
        kernels.processVertices(job, begin, std::min(begin + kVerticesPerTask, count));
    });
}

void processFaces(const FrameJob& job, const Kernels& kernels, ThreadPool& pool)
{
    const std::size_t faces = job.scene->mesh.faceCount();
    std::vector<Chunk>& chunks = *job.chunks;
    pool.forEach(chunks.size(), [&](int, std::size_t i) {
        kernels.processFaces(job, chunks[i], static_cast<std::uint32_t>(faces * i / chunks.size()),
                             static_cast<std::uint32_t>(faces * (i + 1) / chunks.size()));
    });
}

void drawTiles(const FrameJob& job, const Kernels& kernels, TiledContext& context, const std::stop_token& stop)
{
    const int tasksPerRow = (job.grid.columns + kTilesPerTask - 1) / kTilesPerTask;
    context.pool->forEach(std::size_t(tasksPerRow) * std::size_t(job.grid.rows), [&](int worker, std::size_t task) {
        if (stop.stop_requested())
            return;
        const int column = static_cast<int>(task) % tasksPerRow * kTilesPerTask;
        kernels.drawTiles(job, *context.workers[static_cast<std::size_t>(worker)], column,
                          std::min(column + kTilesPerTask, job.grid.columns), static_cast<int>(task) / tasksPerRow);
    });
}

void drawFrame(const Scene& scene, const Settings& settings, const Resolved& resolved, Frame& frame, Outputs outputs,
               Statistics* statistics, const std::stop_token& stop)
{
    Stopwatch total;
    Stopwatch watch;
    StageTimes times;
    const Kernels& kernels = *kernelsFor(settings.simd);
    const int threads = Tiled::threads(settings);
    const PixelPattern pattern = pixelPattern(resolved.rules);
    TiledContext& context = contextOf(frame, threads, pattern.samples);
    ThreadPool& pool = *context.pool;

    FrameJob job;
    job.scene = &scene;
    job.rules = resolved.rules;
    job.shadingVaryings = outputs.picture ? varyingCount(job.rules.shading) : 0;
    if (!outputs.picture && job.rules.maskUv < 0)
        job.rules.varyingCount = 0; // nothing is shaded
    job.texelErrors = axisErrors(job.rules.textureFilter);
    job.masked = job.rules.maskUv >= 0;
    job.leavesTexels = !std::ranges::all_of(scene.textures, fastTexels);
    job.matrices = resolved.matrices;
    const FaceStages stages(scene, job.matrices, job.rules);
    job.stages = &stages;
    job.plainTexture = &plainTexture(scene);
    job.grid = tileGrid(job.rules);
    job.pattern = pattern;
    job.outputs = outputs;
    job.counting = statistics != nullptr;
    job.clearColor = packColor(scene.background);
    job.emptyColor = job.rules.shading == Shading::Overdraw ? overdrawColor(0) : job.clearColor;
    job.chunks = &context.chunks;
    aim(job, frame, context.picture);
    const std::size_t vertices = scene.mesh.vertices.size();
    if (job.interpolates() && (scene.lit || scene.space == SceneSpace::Object))
        job.colors = context.colors.reserve(vertices);
    if (job.colors != nullptr || sharesVertices(scene.mesh))
        job.points = context.points.reserve(vertices);
    clearChunks(context, job, scene.mesh.faceCount(), threads);

    if (job.points != nullptr)
        processVertices(job, kernels, pool);
    times.vertex = watch.lap();
    if (!stop.stop_requested())
        processFaces(job, kernels, pool);
    times.geometry = watch.lap();
    if (!stop.stop_requested())
        drawTiles(job, kernels, context, stop);
    times.raster = watch.lap();
    times.total = total.lap();
    frame.times = times;
    if (statistics != nullptr)
        *statistics = collect(context);
}

} // namespace

std::optional<Reason> Tiled::supports(const Settings& settings)
{
    if (!settings.mistakes.isEmpty())
        return Reason{
            QT_TRANSLATE_NOOP("Unsupported", "algorithm tiled makes no mistakes; edge-equation and edge-walking do")};
    if (kernelsFor(settings.simd) == nullptr)
        return Reason{QT_TRANSLATE_NOOP("Unsupported", "this machine does not have simd %1"),
                      {valueId(*findSettingsField(QStringLiteral("simd")), settings)}};
    return std::nullopt;
}

int Tiled::threads(const Settings& settings)
{
    return settings.threads > 0 ? settings.threads
                                : std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, 256);
}

Simd Tiled::simd(const Settings& settings) { return simdFor(settings.simd); }

void Tiled::draw(const Scene& scene, const Settings& settings, const Resolved& resolved, Frame& frame, Outputs outputs,
                 Statistics* statistics, const std::stop_token& stop)
{
    try {
        drawFrame(scene, settings, resolved, frame, outputs, statistics, stop);
    } catch (...) {
        frame.tiled = nullptr; // half filled, and no longer what is known of the picture
        throw;
    }
}

} // namespace rasterlens
