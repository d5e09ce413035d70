#pragma once
#include "core/pipeline/frame.h"
#include "core/pipeline/resolve.h"
#include "core/pipeline/statistics.h"
#include "core/rasterizers/registry.h"
#include "core/scene/scene.h"

#include <stop_token>

namespace rasterlens
{

/// Tiles of samples that stay in the first-level cache, in parallel and in vector instructions. It finds for each
/// sample the nearest triangle first and shades that one alone; so it works on whole frames, not triangle by triangle.
///
/// covers  what the other algorithms draw with the same settings: the same coverage, ids and depth bit for bit
struct Tiled {
    static constexpr RasterizerInfo info{Algorithm::Tiled,
                                         "Greene, SIGGRAPH 1996; Abrash, Rasterization on Larrabee, 2009"};

    [[nodiscard]] static std::optional<Reason> supports(const Rules& rules);

    /// What the rules do not tell: threads and instructions.
    [[nodiscard]] static std::optional<Reason> supports(const Settings& settings);

    /// What `auto` stands for on this machine.
    [[nodiscard]] static int threads(const Settings& settings);
    [[nodiscard]] static Simd simd(const Settings& settings);

    /// Draws one frame.
    ///
    /// in      settings, for threads and instructions, and what they resolve to; statistics may be null; counting looks
    ///         at hidden samples too
    /// cost    linear in vertices, faces and visible samples
    /// errors  std::bad_alloc, whichever thread has it; the frame is good for another try
    static void draw(const Scene& scene, const Settings& settings, const Resolved& resolved, Frame& frame,
                     Outputs outputs, Statistics* statistics, const std::stop_token& stop);
};

} // namespace rasterlens
