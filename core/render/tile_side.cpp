#include "core/render/tile_side.h"

#include "core/tiled/tile_data.h"

namespace rasterlens
{

int tileSide() { return tiled::kTileSide; }

} // namespace rasterlens
