#include "core/tiled/kernels.h"

// Every instruction set with vectors of four floats and more, and of a size known when this is compiled.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/tiled/kernels.cpp"
#include <hwy/foreach_target.h>

// The target of the compiler's own flags is always among them. Where that is the scalar one, kernels_scalar.cpp has it.
#if HWY_TARGET != HWY_SCALAR
#include "core/tiled/tile-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterlens::tiled::HWY_NAMESPACE
{
const Kernels* TargetKernels() { return &kKernels; }
} // namespace rasterlens::tiled::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#if HWY_ONCE
#include <algorithm>

namespace rasterlens::tiled
{
namespace
{

struct Target {
    Simd simd;
    std::int64_t flag;
    const Kernels* (*kernels)();
};

/// Best first.
constexpr Target kTargets[] = {
#if HWY_TARGETS & HWY_AVX3
    {Simd::Avx512, HWY_AVX3, N_AVX3::TargetKernels},
#endif
#if HWY_TARGETS & HWY_AVX2
    {Simd::Avx2, HWY_AVX2, N_AVX2::TargetKernels},
#endif
#if HWY_TARGETS & HWY_SSE4
    {Simd::Sse4, HWY_SSE4, N_SSE4::TargetKernels},
#endif
#if HWY_TARGETS & HWY_NEON
    {Simd::Neon, HWY_NEON, N_NEON::TargetKernels},
#endif
};

bool isSupported(const Target& target)
{
    static const std::int64_t supported = hwy::SupportedTargets();
    return (supported & target.flag) != 0;
}

} // namespace

const Kernels* kernelsFor(Simd simd)
{
    const Simd best = simdFor(simd);
    for (const Target& target : kTargets)
        if (best == target.simd && isSupported(target))
            return target.kernels();
    return best == Simd::Scalar ? scalarKernels() : nullptr;
}

Simd simdFor(Simd simd)
{
    if (simd != Simd::Auto)
        return simd;
    const auto best = std::find_if(std::begin(kTargets), std::end(kTargets), isSupported);
    return best != std::end(kTargets) ? best->simd : Simd::Scalar;
}

} // namespace rasterlens::tiled
#endif
