#include "core/render/count.h"

#include "core/render/render_resolved.h"

#include <algorithm>
#include <utility>

namespace rasterlens
{

Statistics countPicture(const Scene& scene, const Settings& settings, const Frame& picture, Frame& counted,
                        const std::stop_token& stop)
{
    const bool counts = settings.shading == Shading::Overdraw;
    if (settings.algorithm == Algorithm::Tiled || patternSamples(settings.samples) > 1)
        return renderCounted(scene, settings, counted, {.depth = true, .ids = true, .coverage = counts}, stop);
    QImage memory = std::exchange(counted.image, QImage());
    const Resolved resolved = resolve(settings, scene);
    Statistics statistics = renderCounted(scene, settings, resolved, counted,
                                          {.depth = true, .ids = true, .coverage = counts, .picture = false}, stop);
    if (stop.stop_requested())
        return statistics;
    if (memory.size() == picture.image.size() && memory.format() == picture.image.format())
        std::copy_n(picture.image.constBits(), picture.image.sizeInBytes(), memory.bits());
    else
        memory = picture.image;
    counted.image = std::move(memory);
    const bool onlyPassed = resolved.rules.depthBeforeShading;
    statistics.pixels.shaded = onlyPassed ? statistics.pixels.depthPassed : statistics.pixels.covered;
    return statistics;
}

} // namespace rasterlens
