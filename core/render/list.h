#pragma once
#include "core/rasterizers/column_fill.h"
#include "core/rasterizers/edge_equation.h"
#include "core/rasterizers/edge_walking.h"
#include "core/tiled/tiled.h"

namespace rasterlens
{

/// Every rasterizer that finds the samples whose centres a triangle covers, triangle by triangle, with cover(): add the
/// name of a new one here.
template <class Visitor>
void forEachTriangleRasterizer(Visitor&& visit)
{
    const auto visitAll = [&]<class... Rasterizer>(Rasterizer... rasterizer) { (visit(rasterizer), ...); };
    visitAll(EdgeEquation(), EdgeWalking());
}

/// Every rasterizer there is.
template <class Visitor>
void forEachRasterizer(Visitor&& visit)
{
    forEachTriangleRasterizer(visit);
    visit(Tiled());
    visit(ColumnFill());
}

/// Why the algorithm of these rules cannot draw them, or nothing; a text of the context "Unsupported".
[[nodiscard]] inline std::optional<Reason> rasterizerSupports(const Rules& rules)
{
    std::optional<Reason> reason = Reason{QT_TRANSLATE_NOOP("Unsupported", "this algorithm is not built in")};
    forEachRasterizer([&](auto rasterizer) {
        if (rasterizer.info.algorithm == rules.algorithm)
            reason = rasterizer.supports(rules);
    });
    return reason;
}

} // namespace rasterlens
