#include "core/observe/frame_planes.h"

#include "core/base/pieces.h"
#include "core/pipeline/shading.h"

namespace rasterlens
{

SampleRuns::SampleRuns(const Rules& rules)
    : frame(storedSamples(rules) / static_cast<std::size_t>(rules.patternSamples)),
      frames(static_cast<std::size_t>(rules.patternSamples)), shift(rules.multiSampled() ? 4 : 6),
      hasPixels(rules.sampleGrid == 1 && !rules.strideIsRows)
{
}

Pixel clearedPixel(const Scene& scene, const Rules& rules)
{
    return {rules.shading == Shading::Overdraw ? overdrawColor(0) : packColor(scene.background), rules.depthClear};
}

FramePlanes clearedPlanes(const Rules& rules, const Pixel& clear, bool hasDepth, const std::stop_token& stop)
{
    const std::size_t samples = storedSamples(rules);
    FramePlanes planes;
    assignInPieces(planes.color, samples, clear.color, stop);
    if (hasDepth)
        assignInPieces(planes.depth, samples, clear.depth, stop);
    if (rules.shading == Shading::Overdraw)
        assignInPieces(planes.coverCount, samples, std::uint16_t(0), stop);
    if (rules.depthPerPixel)
        assignInPieces(planes.ownDepth, samples, clear.depth, stop);
    assignInPieces(planes.owners, samples, std::int32_t(-1), stop);
    planes.layout = SampleRuns(rules);
    planes.runs.resize(planes.layout.count());
    return planes;
}

} // namespace rasterlens
