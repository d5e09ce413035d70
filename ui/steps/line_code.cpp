#include "ui/steps/line_code.h"

#include "core/observe/line_ends.h"

#include <optional>

namespace rasterlens
{
namespace
{

/// Which axis a line goes along, and the way it goes on each.
struct LineWay {
    bool steep = false;
    glm::ivec2 step{1, 1};
};

LineWay wayAt(const StepLog& log, std::size_t i)
{
    LineWay way;
    const StepEvent* event = decisionAt(log, i);
    const StepTriangle* triangle = log.triangle(log.event(i));
    if (event == nullptr || triangle == nullptr)
        return way;
    const LineDecision& decision = log.payload<LineStep>(*event).decision;
    way.steep = decision.steep;
    if (const auto line = lineOf(triangle->screen, decision, log.rules())) {
        const auto& [from, to] = line->ends;
        way.step = {to.x < from.x ? -1 : 1, to.y < from.y ? -1 : 1};
    }
    return way;
}

} // namespace

std::array<QString, 2> bresenhamCode(const StepLog& log, std::size_t i)
{
    const LineWay way = wayAt(log, i);
    const QString u = way.steep ? QStringLiteral("y") : QStringLiteral("x");
    const QString v = way.steep ? QStringLiteral("x") : QStringLiteral("y");
    const bool uBack = way.step[way.steep ? 1 : 0] < 0;
    const bool vBack = way.step[way.steep ? 0 : 1] < 0;
    const bool hasLast = log.rightRules().lineRule == LineRule::Inclusive;
    const QString upTo = (uBack ? QStringLiteral(">") : QStringLiteral("<")) + QLatin1String(hasLast ? "=" : "");
    return {QStringLiteral("p = 2 d%2 - d%1;  for (%1 = %3; %1 %4 %5; %6%1) {  plot(x, y);")
                .arg(u, v, u + QStringLiteral("0"), upTo, u + QStringLiteral("1"),
                     uBack ? QStringLiteral("--") : QStringLiteral("++")),
            QStringLiteral("  if (p > 0) { %2 %3= 1;  p -= 2 d%1; }  p += 2 d%2; }")
                .arg(u, v, vBack ? QStringLiteral("-") : QStringLiteral("+"))};
}

} // namespace rasterlens
