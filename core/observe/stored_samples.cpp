#include "core/observe/stored_samples.h"

#include "core/pipeline/framebuffer.h"

namespace rasterlens
{

ResolvedPixel storedSamples(const StepCursor& cursor, int x, int y)
{
    const Rules& rules = cursor.log().rules();
    ResolvedPixel stored;
    stored.x = x;
    stored.y = y;
    stored.count = rules.samplesPerPixel();
    stored.isPattern = rules.multiSampled();
    for (int i = 0; i < stored.count; ++i) {
        const std::size_t at = readIndex(rules, x, y, i);
        stored.samples[static_cast<std::size_t>(i)] = cursor.sample(at);
    }
    return stored;
}

} // namespace rasterlens
