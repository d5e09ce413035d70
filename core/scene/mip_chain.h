#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace rasterlens
{

/// A texture at its own size, half of it, a quarter and so on down to one texel.
struct MipLevels {
    struct Level {
        std::int32_t width;
        std::int32_t height;
        std::int32_t first; ///< of its texels
    };
    std::vector<Level> levels;         ///< at least one
    std::vector<std::uint32_t> texels; ///< 0xffRRGGBB, row by row, level behind level
};

/// Halves the sides, rounded down, until both are 1. A texel is the mean of the area it covers in the level before,
/// channel by channel, rounded to nearest; of an odd side the texels at the borders of that area count in part.
///
/// in   width * height texels, at least one
[[nodiscard]] MipLevels makeMipLevels(int width, int height, std::span<const std::uint32_t> texels);

/// The levels of a texture, made when they are first asked for. A copy of the texture makes its own.
class MipChain
{
public:
    MipChain();
    MipChain(const MipChain&) : MipChain() {}
    MipChain& operator=(const MipChain&);
    ~MipChain();

    /// in   the texels of the texture that this belongs to, which change no more; from any thread
    [[nodiscard]] const MipLevels& of(int width, int height, std::span<const std::uint32_t> texels) const;

private:
    struct Lazy;
    std::unique_ptr<Lazy> m_lazy;
};

} // namespace rasterlens
