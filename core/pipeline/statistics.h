#pragma once
#include <QJsonObject>

#include <cstdint>

namespace rasterlens
{

struct Settings;

/// What one frame did, counted. See docs/CONVENTIONS.md for the meaning of every counter.
///
/// exact   submitted = rejected + culledBack + culledFront + degenerate + nonFinite + rasterized
///         covered = depthPassed + depthFailed
struct Statistics {
    struct Faces {
        std::uint64_t submitted = 0;
        std::uint64_t rejected = 0;
        std::uint64_t culledBack = 0;
        std::uint64_t culledFront = 0;
        std::uint64_t degenerate = 0;
        std::uint64_t nonFinite = 0;
        std::uint64_t clipped = 0;           ///< cut by at least one plane
        std::uint64_t createdByClipping = 0; ///< triangles drawn for cut faces
        std::uint64_t rasterized = 0;
        friend bool operator==(const Faces&, const Faces&) = default;
    } faces;

    /// Samples, where there is more than one a pixel.
    struct Pixels {
        std::uint64_t tested = 0;
        std::uint64_t covered = 0;
        std::uint64_t depthPassed = 0;
        std::uint64_t depthFailed = 0;
        std::uint64_t shaded = 0;
        std::uint64_t written = 0;
        std::uint64_t coveredTwice = 0; ///< hit by both faces at an edge they share; 0 under the top-left rule
        friend bool operator==(const Pixels&, const Pixels&) = default;
    } pixels;

    /// Lines of the wireframe, and those of the scene.
    struct Lines {
        std::uint64_t drawn = 0;
        std::uint64_t shared = 0; ///< edges that were not drawn because another face draws them
        friend bool operator==(const Lines&, const Lines&) = default;
    } lines;

    friend bool operator==(const Statistics&, const Statistics&) = default;
};

/// Wall-clock time of the stages of one frame, milliseconds.
struct StageTimes {
    double vertex = 0;   ///< vertex stage
    double geometry = 0; ///< assembly, clipping, viewport, culling, set-up
    double raster = 0;   ///< coverage, depth, shading, resolve
    double total = 0;    ///< clear + frame into the QImage
};

/// The statistics document of the command line.
///
/// in   the settings as asked for, and those with the threads and vector instructions that worked (withWorkers())
[[nodiscard]] QJsonObject toJson(const Statistics& statistics, const StageTimes& times, const Settings& settings,
                                 const Settings& drawnWith);

} // namespace rasterlens
