#include "core/scene/texture.h"

namespace rasterlens
{
namespace
{

Texture makeChecker()
{
    constexpr int kSize = 512;
    constexpr int kCell = 32;
    constexpr std::uint32_t kLight = 0xffe6e6e6; // 230, 230, 230
    constexpr std::uint32_t kDark = 0xff283c78;  // 40, 60, 120
    Texture checker{QStringLiteral("checkerboard"), kSize, kSize, {}};
    checker.texels.reserve(kSize * kSize);
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x)
            checker.texels.push_back((x / kCell + y / kCell) % 2 == 0 ? kLight : kDark);
    return checker;
}

} // namespace

const Texture& checkerTexture()
{
    static const Texture checker = makeChecker();
    return checker;
}

} // namespace rasterlens
