#pragma once
#include "core/pipeline/statistics.h"
#include "core/pipeline/types.h"
#include "core/settings/depth_rules.h"

namespace rasterlens
{

/// Counts the lines that a triangle is drawn as, and those that another one draws for it.
inline void countLines(const ScreenTriangle& triangle, const Rules& rules, Statistics::Lines& lines)
{
    const bool drawsEdges = rules.fill == Fill::Wireframe && !isFirstPass(rules, triangle.face);
    if (!triangle.isLine && !drawsEdges)
        return;
    for (std::size_t i = 0; i < 3; ++i)
        if (triangle.drawsEdge(i))
            ++lines.drawn;
        else if (!triangle.isLine)
            ++lines.shared;
}

} // namespace rasterlens
