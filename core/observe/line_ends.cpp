#include "core/observe/line_ends.h"

#include <utility>

namespace rasterlens
{

std::optional<LineOfTriangle> lineOf(const ScreenTriangle& triangle, const LineDecision& decision, const Rules& rules)
{
    const auto sampleOf = [&](std::size_t i) { return glm::ivec2(glm::floor(triangle.vertices[i].position)); };
    const int axis = decision.steep ? 1 : 0;
    for (std::size_t i = 0; i < 3; ++i) {
        if (!triangle.drawsEdge(i))
            continue;
        glm::ivec2 from = sampleOf(i);
        glm::ivec2 to = sampleOf((i + 1) % 3);
        if (!rules.lineTiesByDirection && std::pair(from.y, from.x) > std::pair(to.y, to.x))
            std::swap(from, to);
        const glm::ivec2 size = glm::abs(to - from);
        if (size[axis] != decision.longer || size[1 - axis] != decision.shorter)
            continue;
        const int now = axis == 0 ? decision.x : decision.y;
        if (from[axis] + (to[axis] < from[axis] ? -decision.step : decision.step) == now)
            return LineOfTriangle{i, {from, to}};
    }
    return std::nullopt;
}

const StepEvent* decisionAt(const StepLog& log, std::size_t i)
{
    const std::uint32_t triangle = log.event(i).triangle;
    // A triangle begins before its first sample.
    int samplesAhead = log.event(i).kind == StepKind::Triangle ? 1 : 0;
    for (std::size_t k = i; k < log.size() && log.event(k).triangle == triangle; ++k) {
        if (log.event(k).kind == StepKind::LineDecision)
            return &log.event(k);
        if (k > i && log.event(k).kind == StepKind::LineSample && samplesAhead-- == 0)
            break;
    }
    for (std::size_t k = i; k-- > 0 && log.event(k).triangle == triangle;)
        if (log.event(k).kind == StepKind::LineDecision)
            return &log.event(k);
    return nullptr;
}

} // namespace rasterlens
