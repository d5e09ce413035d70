#pragma once
#include "core/truth/other_renderer.h"

namespace rasterlens
{

/// Which of the pixels on its border a rectangle owns whose sides run through their centres.
enum class OwnedSides { TopLeft, TopRight, BottomLeft, BottomRight, All, None, Other };

/// What a renderer does with corners and ties, found by drawing.
struct RendererTraits {
    int subpixelBits = 0; ///< corners snap to 1/2^bits pixel
    bool orMore = false;  ///< corners snap to steps at most as large as these: finer ones are not told apart
    bool nearest = false; ///< to the nearest step; false: to the one on one side, or not told: steps of a whole pixel,
                          ///< or too fine ones
    OwnedSides sides = OwnedSides::Other;
    bool diagonalOnce = false; ///< two faces share the pixels whose centres lie on their common edge
};

/// The id of a tie rule: `top-left`, `inclusive` (all sides), `exclusive` (none), `other` ..
[[nodiscard]] const char* idOf(OwnedSides sides);

/// Finds out what a renderer does by drawing two pictures.
///
/// Snapping: 1024 slender triangles side by side, whose left edges, a pixel wide and 1024 rows high, each begin 1/1024
/// pixel further right than the one before, and pass a column of centres. How many rows they cover is where the edge
/// has come to lie: it stays the same for as many triangles as there are 1024ths in a step.
///
/// in      a renderer that draws clip-space scenes without depth test and culling
/// exact   steps from 1 pixel (to the nearest) or 1/2 to 1/512; positions are floats without rounding on the way to
/// pixels
[[nodiscard]] RendererTraits traitsOf(OtherRenderer& renderer);

} // namespace rasterlens
