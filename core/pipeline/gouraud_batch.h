#pragma once
#include "core/pipeline/interpolation.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace rasterlens
{

/// Samples of one triangle that are drawn together, each at most once.
///
/// Which samples of a box are covered, and which of them pass the depth test, is hard to predict, and a processor that
/// guesses wrong throws away the work it has begun. Samples are therefore collected without a branch: one that is not
/// wanted is overwritten by the next. What is computed for all of them alike becomes vector instructions.
struct GouraudBatch {
    static constexpr std::size_t kMost = 128;
    template <class T>
    using Values = std::array<T, kMost + 1>; ///< one more for a sample that is not wanted

    std::size_t count = 0;
    Values<int> x;
    Values<int> y;
    Values<std::size_t> at; ///< where the frame buffer stores the sample
    Values<float> depth;
    Values<std::uint32_t> color; ///< 0xffRRGGBB
};

/// The depths as float32, bit for bit those of FaceInterpolation::depthAt() and storedDepth().
///
/// in  a triangle whose depth is a plane
void computeDepths(const FaceInterpolation& interpolation, GouraudBatch& batch);

/// The colours, bit for bit those of the weights, varyings and packColor() one by one.
void computeColors(const FaceInterpolation& interpolation, GouraudBatch& batch);

} // namespace rasterlens
