#pragma once

namespace rasterlens
{

/// The side of the square tiles that the tiled algorithm sorts triangles into, in samples.
[[nodiscard]] int tileSide();

} // namespace rasterlens
