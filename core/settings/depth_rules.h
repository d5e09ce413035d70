#pragma once
#include "core/settings/rules.h"

namespace rasterlens
{

/// The sign between the new and the stored depth that holds where a fragment passes; empty: nothing is compared.
[[nodiscard]] constexpr const char* compareSign(DepthCompare compare)
{
    switch (compare) {
    case DepthCompare::Less: return "<";
    case DepthCompare::LessEqual: return "<=";
    case DepthCompare::Greater: return ">";
    case DepthCompare::GreaterEqual: return ">=";
    case DepthCompare::Always: break;
    }
    return "";
}
/// The sign of the comparison that the rules make; empty where depth is not tested.
[[nodiscard]] constexpr const char* depthSign(const Rules& rules)
{
    return rules.depthTested ? compareSign(rules.depthCompare) : "";
}

/// What depth 1 is stored as where depth is stored as a whole number, 2^bits - 1; 0 where it is a float.
[[nodiscard]] constexpr int largestDepthCode(DepthFormat format)
{
    switch (format) {
    case DepthFormat::Float32: break;
    case DepthFormat::Unorm24: return 0xffffff;
    case DepthFormat::Unorm16: return 0xffff;
    }
    return 0;
}

} // namespace rasterlens
