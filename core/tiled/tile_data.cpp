#include "core/tiled/tile_data.h"

namespace rasterlens::tiled
{

std::uint32_t BinArena::allocate()
{
    const std::size_t number = m_next.size();
    if (number / kSlabBlocks == m_slabs.size())
        m_slabs.emplace_back().reserve(kSlabBlocks);
    if (m_textured && number / kSlabBlocks == m_texelSlabs.size())
        m_texelSlabs.emplace_back().reserve(kSlabBlocks);
    m_next.push_back(kNobody);
    return static_cast<std::uint32_t>(number);
}

void Chunk::grow(Bin& bin)
{
    const std::uint32_t block = arena.allocate();
    (bin.last == kNobody ? bin.first : arena.next(bin.last)) = block;
    bin.last = block;
    bin.lastBlock = &arena.block(block);
    bin.lastTexels = arena.texels(block);
    bin.used = 0;
}

} // namespace rasterlens::tiled
