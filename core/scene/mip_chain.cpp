#include "core/scene/mip_chain.h"

#include <algorithm>
#include <array>
#include <mutex>

namespace rasterlens
{
namespace
{

/// The texels of the larger level that one of the smaller covers along an axis, and how much of each, in parts of
/// 1 / (number of smaller ones).
struct Footprint {
    int first;
    int count;                         ///< 1 to 3
    std::array<std::uint32_t, 3> part; ///< their sum is the number of larger ones
};

Footprint footprint(int at, int larger, int smaller)
{
    const std::int64_t begin = std::int64_t(at) * larger;
    const std::int64_t end = begin + larger;
    Footprint f{static_cast<int>(begin / smaller), 0, {}};
    for (std::int64_t i = f.first; i * smaller < end; ++i)
        f.part[static_cast<std::size_t>(f.count++)] =
            static_cast<std::uint32_t>(std::min((i + 1) * smaller, end) - std::max(i * smaller, begin));
    return f;
}

std::uint32_t meanTexel(const std::uint32_t* texels, int pitch, const Footprint& columns, const Footprint& rows)
{
    std::array<std::uint64_t, 3> sum{};
    std::uint64_t area = 0;
    for (int j = 0; j < rows.count; ++j)
        for (int i = 0; i < columns.count; ++i) {
            const std::uint64_t part =
                std::uint64_t(columns.part[static_cast<std::size_t>(i)]) * rows.part[static_cast<std::size_t>(j)];
            const std::uint32_t texel = texels[std::ptrdiff_t(rows.first + j) * pitch + columns.first + i];
            for (std::size_t channel = 0; channel < 3; ++channel)
                sum[channel] += part * (texel >> (8 * channel) & 255U);
            area += part;
        }
    std::uint32_t mean = 0xff000000U;
    for (std::size_t channel = 0; channel < 3; ++channel)
        mean |= static_cast<std::uint32_t>((2 * sum[channel] + area) / (2 * area)) << (8 * channel);
    return mean;
}

} // namespace

MipLevels makeMipLevels(int width, int height, std::span<const std::uint32_t> texels)
{
    MipLevels mips;
    mips.levels.push_back({width, height, 0});
    mips.texels.assign(texels.begin(), texels.end());
    while (mips.levels.back().width > 1 || mips.levels.back().height > 1) {
        const MipLevels::Level larger = mips.levels.back();
        const MipLevels::Level smaller{std::max(larger.width / 2, 1), std::max(larger.height / 2, 1),
                                       static_cast<std::int32_t>(mips.texels.size())};
        for (int y = 0; y < smaller.height; ++y)
            for (int x = 0; x < smaller.width; ++x)
                mips.texels.push_back(meanTexel(mips.texels.data() + larger.first, larger.width,
                                                footprint(x, larger.width, smaller.width),
                                                footprint(y, larger.height, smaller.height)));
        mips.levels.push_back(smaller);
    }
    return mips;
}

struct MipChain::Lazy {
    std::once_flag once;
    MipLevels levels;
};

MipChain::MipChain() : m_lazy(std::make_unique<Lazy>()) {}
MipChain::~MipChain() = default;

MipChain& MipChain::operator=(const MipChain&)
{
    m_lazy = std::make_unique<Lazy>();
    return *this;
}

const MipLevels& MipChain::of(int width, int height, std::span<const std::uint32_t> texels) const
{
    std::call_once(m_lazy->once, [&] { m_lazy->levels = makeMipLevels(width, height, texels); });
    return m_lazy->levels;
}

} // namespace rasterlens
