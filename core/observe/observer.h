#pragma once
#include "core/pipeline/types.h"

#include <array>
#include <cstdint>

namespace rasterlens
{

enum class ClipPlane { W, Right, Left, Top, Bottom, Near, Far };

/// The three edge values of a sample in pixel areas times 65536 (fixed point) or in pixel areas (floats), AB, BC, CA.
using EdgeValues = std::array<double, 3>;

/// One covered sample on its way to the frame buffer.
struct Fragment {
    int x; ///< sample column
    int y; ///< sample row
    std::uint32_t face;
    float depth;     ///< as the buffer stores it
    Weights screen;  ///< barycentric weights on the screen
    Weights weights; ///< the same after perspective correction: what attributes are weighted with
    Varyings varyings;
};

/// What a sample stores.
struct Pixel {
    std::uint32_t color = 0; ///< 0xffRRGGBB
    float depth = 1;
};

/// Is told what happens; this one is told nothing that lasts, and compiles to nothing.
/// Derive and *shadow* what you want to know: no virtuals. Arguments are values the algorithm already has.
struct NullObserver {
    /// Faces that go through geometry before the first of them is rasterized: many are fast, one keeps the order of
    /// events face by face.
    static constexpr int kFacesPerBatch = 256;

    constexpr void onFace(std::uint32_t /*face*/, FaceFate) {}
    /// `before` and `after` one plane; `after` may be empty.
    constexpr void onClipPlane(std::uint32_t /*face*/, ClipPlane, const ClipPolygon& /*before*/,
                               const ClipPolygon& /*after*/)
    {
    }
    /// A face was cut by at least one plane and is drawn as so many triangles.
    constexpr void onClipped(std::uint32_t /*face*/, int /*pieces*/) {}
    /// The signed area that decided about culling, in pixel areas; positive is counter-clockwise with y up.
    constexpr void onFacing(std::uint32_t /*face*/, double /*area*/) {}
    constexpr void onTriangle(const ScreenTriangle&) {}
    constexpr void onSpan(int /*y*/, int /*xBegin*/, int /*xEnd*/) {}
    constexpr void onSample(int /*x*/, int /*y*/, const EdgeValues&, bool /*covered*/) {}
    /// A sample of a line or a corner; off the target nothing is drawn.
    constexpr void onLineSample(int /*x*/, int /*y*/, bool /*onTarget*/) {}
    constexpr void onFragment(const Fragment&, bool /*passedDepth*/) {}
    constexpr void onShade(const Fragment&) {}
    constexpr void onWrite(int /*x*/, int /*y*/, Pixel /*before*/, Pixel /*after*/) {}
};

} // namespace rasterlens
