// What texels are multiplied with: interpolated colours as 16-bit fractions. Included once for each target: see
// README.md.
#if defined(RASTERLENS_TILED_FACTORS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERLENS_TILED_FACTORS_INL_H
#undef RASTERLENS_TILED_FACTORS_INL_H
#else
#define RASTERLENS_TILED_FACTORS_INL_H
#endif

#include "core/tiled/gouraud-inl.h"
#include "core/tiled/lanes-inl.h"
#include "core/tiled/planes-inl.h"
#include "core/tiled/texture-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterlens::tiled::HWY_NAMESPACE
{

/// Texels, in steps, times factors.
HWY_INLINE Uints Modulate(const RgbLanes& texels, const RgbLanes& factors)
{
    const RgbLanes product = Scale(texels, Scale(factors, hn::Set(FloatTag(), 1 / kWhiteFactor)));
    return PackHeld(product.red, product.green, product.blue);
}

/// Stored texels times factors, rounded to nearest. The result is defined for the wanted samples only.
HWY_INLINE Uints Modulate(Uints texels, const RgbLanes& factors, hn::Mask<FloatTag> wanted)
{
    constexpr UintTag tag;
    const auto units = [](Floats factor) HWY_ATTR {
        return hn::BitCast(UintTag(), ChannelOf(hn::Max(factor, hn::Zero(FloatTag()))));
    };
    const Uints low = hn::Set(tag, 0xffff);
    const Uints redBlue = hn::OrAnd(hn::ShiftLeft<16>(units(factors.red)), units(factors.blue), low);
    const Uints green = hn::And(units(factors.green), low);
    // Half a step, and what the two roundings down lose on the average.
    const Uints rounding = hn::Set(tag, 0x00810081U);
    const auto times = [&](Uints texel, Uints by) HWY_ATTR { return AddHalves(MulHalvesHigh(texel, by), rounding); };
    const Uints redBlueSteps = UpperBytes(times(hn::And(hn::ShiftLeft<8>(texels), hn::Set(tag, 0xff00ff00U)), redBlue));
    const Uints greenSteps = times(hn::And(texels, hn::Set(tag, 0x0000ff00U)), green);
    const Uints product =
        hn::OrAnd(hn::Or(redBlueSteps, hn::Set(tag, 0xff000000U)), greenSteps, hn::Set(tag, 0x0000ff00U));

    // Colours beyond 1 do not fit 16 bits.
    const Floats highest = hn::Max(hn::Max(factors.red, factors.green), factors.blue);
    const auto tooBright = hn::And(wanted, hn::Gt(highest, hn::Set(FloatTag(), kWhiteFactor + 0.25F)));
    if (HWY_LIKELY(hn::AllFalse(FloatTag(), tooBright)))
        return product;
    return hn::IfThenElse(hn::RebindMask(tag, tooBright), Modulate(Unpack(texels), factors), product);
}

} // namespace rasterlens::tiled::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
