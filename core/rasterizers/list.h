#pragma once
#include "core/rasterizers/edge_equation.h"
#include "core/rasterizers/edge_walking.h"

namespace rasterlens
{

/// Every rasterizer there is: add the name of a new one here.
template <class Visitor>
void forEachRasterizer(Visitor&& visit)
{
    const auto visitAll = [&]<class... Rasterizer>(Rasterizer... rasterizer) { (visit(rasterizer), ...); };
    visitAll(EdgeEquation(), EdgeWalking());
}

} // namespace rasterlens
