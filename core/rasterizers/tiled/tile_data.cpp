#include "core/rasterizers/tiled/tile_data.h"

namespace rasterlens::tiled
{

BinBlock* BinArena::allocate()
{
    const std::size_t slab = m_used / kSlabBlocks;
    if (slab == m_slabs.size())
        m_slabs.push_back(std::make_unique_for_overwrite<BinBlock[]>(kSlabBlocks));
    return &m_slabs[slab][m_used++ % kSlabBlocks];
}

void Chunk::grow(Bin& bin)
{
    BinBlock* block = arena.allocate();
    block->next = nullptr;
    block->count = 0;
    (bin.last != nullptr ? bin.last->next : bin.first) = block;
    bin.last = block;
}

} // namespace rasterlens::tiled
