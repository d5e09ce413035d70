#pragma once
#include "core/pipeline/types.h"
#include "core/settings/rules.h"

#include <QString>

#include <optional>

namespace rasterlens
{

// What things are called, in both programs. Ids of planes, sides, fates and facings are texts of the context "Steps",
// where the window wants them in its language.

/// Which edges of a triangle own their points, and why.
enum class EdgeSide { Left, Top, Neither };
[[nodiscard]] const char* edgeSideId(EdgeSide side);

/// A plane of the view volume.
struct ClipPlaneInfo {
    ClipPlane plane;
    const char* id;   ///< `near`
    const char* sign; ///< `-z`
};
[[nodiscard]] const ClipPlaneInfo& infoOf(ClipPlane plane);
constexpr int kClipPlanes = static_cast<int>(ClipPlane::Far) + 1;

[[nodiscard]] inline const char* clipPlaneId(ClipPlane plane) { return infoOf(plane).id; }
/// What holds for the coordinates of a vertex inside: `x <= w`, with a guard band `x <= 1023 w`.
[[nodiscard]] QString clipPlaneFormula(ClipPlane plane, const Rules& rules);
[[nodiscard]] QString planesText(std::uint32_t planes); ///< ids of a set of planes, one bit each; `none` if empty
[[nodiscard]] QString planeSigns(std::uint32_t planes); ///< their signs: `+x, -y`; empty if there are none

[[nodiscard]] const char* faceFateId(FaceFate fate); ///< `culled-back`
[[nodiscard]] const char* facingId(Facing facing);   ///< `screen`

/// The nine regions of the projected plane: one bit a side of the screen.
constexpr unsigned kRegionLeft = 1;
constexpr unsigned kRegionRight = 2;
constexpr unsigned kRegionBelow = 4;
constexpr unsigned kRegionAbove = 8;
[[nodiscard]] unsigned screenRegion(const glm::dvec4& positionClip);
/// The bits in the order above, below, right, left, as the figure of the nine regions writes them: `1001`.
[[nodiscard]] QString regionText(unsigned region);

[[nodiscard]] QString colorText(std::uint32_t color); ///< `#rrggbb`

/// How many faces a colour of the overdraw view stands for, up to kMostOverdraw: so many or more.
[[nodiscard]] std::optional<int> overdrawCount(std::uint32_t color);
constexpr int kMostOverdraw = 8;

/// `face 12 (line 345)`: a triangle and the line of the `f` in the scene's file that it is a part of; `face 12` where
/// `line` is -1.
[[nodiscard]] QString faceText(std::uint32_t face, std::int32_t line);

/// `A`, `B`, `C`
[[nodiscard]] QString cornerLetter(std::size_t vertex);

/// A number as people read it: 6 significant digits, `nan`, `inf`.
[[nodiscard]] QString shortNumber(double value);
/// The shortest text that reads back as the same double.
[[nodiscard]] QString fullNumber(double value);
/// The digits that tell a depth from every other float: what compares as different reads as different.
[[nodiscard]] QString depthNumber(float depth);

} // namespace rasterlens
