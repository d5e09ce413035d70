#include "core/render/count.h"

#include "core/pipeline/rules_for.h"
#include "core/settings/rules.h"

#include <algorithm>
#include <utility>

namespace rasterlens
{

Statistics countPicture(const Scene& scene, const Settings& settings, const Frame& picture, Frame& counted,
                        const std::stop_token& stop)
{
    const bool counts = settings.shading == Shading::Overdraw;
    if (settings.algorithm == Algorithm::Tiled)
        return renderCounted(scene, settings, counted, {.depth = true, .ids = true, .coverage = counts}, stop);
    QImage memory = std::exchange(counted.image, QImage());
    Statistics statistics = renderCounted(scene, settings, counted,
                                          {.depth = true, .ids = true, .coverage = counts, .picture = false}, stop);
    if (stop.stop_requested())
        return statistics;
    if (memory.size() == picture.image.size() && memory.format() == picture.image.format())
        std::copy_n(picture.image.constBits(), picture.image.sizeInBytes(), memory.bits());
    else
        memory = picture.image;
    counted.image = std::move(memory);
    const bool onlyPassed = rulesFor(scene, settings).depthBeforeShading;
    statistics.pixels.shaded = onlyPassed ? statistics.pixels.depthPassed : statistics.pixels.covered;
    return statistics;
}

} // namespace rasterlens
