#include "core/pipeline/gouraud_batch.h"

#include "core/pipeline/depth_test.h"
#include "core/pipeline/shading.h"

namespace rasterlens
{

void computeDepths(const FaceInterpolation& interpolation, GouraudBatch& batch)
{
    const DepthPlane plane = interpolation.planeOfDepth();
    const std::size_t count = batch.count;
    for (std::size_t i = 0; i < count; ++i)
        batch.depth[i] = storedDepth(plane.at(batch.x[i], batch.y[i]), DepthFormat::Float32);
}

void computeColors(const FaceInterpolation& interpolation, GouraudBatch& batch)
{
    const std::size_t count = batch.count;
    const auto compute = [&](auto&& corrected) {
        for (std::size_t i = 0; i < count; ++i) {
            const Weights weights = corrected(interpolation.weightsAt(batch.x[i], batch.y[i]));
            batch.color[i] = packColor({interpolation.varying(0, weights), interpolation.varying(1, weights),
                                        interpolation.varying(2, weights)});
        }
    };
    // The decision stands outside of the loop, which could not become vectors with it.
    if (interpolation.correctsPerspective())
        compute([&](const Weights& screen) { return interpolation.corrected(screen); });
    else
        compute([](const Weights& screen) { return screen; });
}

} // namespace rasterlens
