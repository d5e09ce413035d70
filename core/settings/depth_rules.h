#pragma once
#include "core/settings/rules.h"

#include <algorithm>

namespace rasterlens
{

/// The sign between the new and the stored depth that holds where a fragment passes; empty: nothing is compared.
[[nodiscard]] constexpr const char* compareSign(DepthCompare compare)
{
    switch (compare) {
    case DepthCompare::Less: return "<";
    case DepthCompare::LessEqual: return "<=";
    case DepthCompare::Equal: return "==";
    case DepthCompare::GreaterEqual: return ">=";
    case DepthCompare::Greater: return ">";
    case DepthCompare::NotEqual: return "!=";
    case DepthCompare::Always: break;
    }
    return "";
}

/// Whether a face belongs to the first pass of two.
[[nodiscard]] constexpr bool isFirstPass(const Rules& rules, std::uint32_t face) { return face < rules.firstPassFaces; }

/// Whether the depths of a face's corners are biased.
[[nodiscard]] inline bool isBiased(const Rules& rules, std::uint32_t face)
{
    return rules.depthBias.isOn() && !isFirstPass(rules, face);
}

/// Whether a face is a line: Mesh::lines.
[[nodiscard]] inline bool isLineFace(const Rules& rules, std::uint32_t face)
{
    return rules.lineFaces && std::binary_search(rules.lineFaces->begin(), rules.lineFaces->end(), face);
}

/// How the depths of a face's fragments are compared.
[[nodiscard]] constexpr DepthCompare depthCompareOf(const Rules& rules, std::uint32_t face)
{
    if (isFirstPass(rules, face))
        return rules.reversedZ ? DepthCompare::Greater : DepthCompare::Less;
    return rules.depthCompare;
}

/// The rules by which the pass of a face is drawn, as if it were the only one; those of a wireframe for a line.
[[nodiscard]] inline Rules passRules(const Rules& rules, std::uint32_t face)
{
    Rules pass = rules;
    pass.depthCompare = depthCompareOf(rules, face);
    pass.firstPassFaces = 0;
    if (isFirstPass(rules, face)) {
        pass.fill = Fill::Solid;
        pass.depthBias = {};
    }
    if (isLineFace(rules, face)) {
        pass.fill = Fill::Wireframe;
        pass.depthBias = {};
    }
    pass.lineFaces = nullptr;
    return pass;
}

/// The sign of the comparison that the rules make for a face; empty where depth is not tested.
[[nodiscard]] constexpr const char* depthSign(const Rules& rules, std::uint32_t face)
{
    return rules.depthTested ? compareSign(depthCompareOf(rules, face)) : "";
}

/// What depth 1 is stored as where depth is stored as a whole number, 2^bits - 1; 0 where it is a float.
[[nodiscard]] constexpr int largestDepthCode(DepthFormat format)
{
    switch (format) {
    case DepthFormat::Float32: break;
    case DepthFormat::Unorm24: return 0xffffff;
    case DepthFormat::Unorm16: return 0xffff;
    case DepthFormat::Unorm8: return 0xff;
    }
    return 0;
}

} // namespace rasterlens
