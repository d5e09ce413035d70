#include "core/rasterizers/registry.h"

#include "core/render/list.h"

namespace rasterlens
{

std::optional<Reason> rasterizerSupports(const Rules& rules)
{
    std::optional<Reason> reason = Reason{QT_TRANSLATE_NOOP("Unsupported", "this algorithm is not built in")};
    forEachRasterizer([&](auto rasterizer) {
        if (rasterizer.info.algorithm == rules.algorithm)
            reason = rasterizer.supports(rules);
    });
    return reason;
}

} // namespace rasterlens
