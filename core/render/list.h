#pragma once
#include "core/rasterizers/edge_equation.h"
#include "core/rasterizers/edge_walking.h"
#include "core/tiled/tiled.h"

namespace rasterlens
{

/// Every rasterizer that works triangle by triangle, with cover(): add the name of a new one here.
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
}

} // namespace rasterlens
