// Logarithm, power and vector length, made of additions, multiplications, divisions and square roots only: every
// instruction set rounds these alike. The functions of hwy/contrib/math fuse multiplications with additions where the
// instruction set can, and so differ between machines. Included once for each target: see README.md.
#if defined(RASTERLENS_TILED_MATH_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERLENS_TILED_MATH_INL_H
#undef RASTERLENS_TILED_MATH_INL_H
#else
#define RASTERLENS_TILED_MATH_INL_H
#endif

#include "core/tiled/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterlens::tiled::HWY_NAMESPACE
{

/// a0 + a1 x + a2 x^2 ...
template <std::size_t kTerms>
HWY_INLINE Floats Polynomial(Floats x, const std::array<float, kTerms>& a)
{
    Floats sum = hn::Set(FloatTag(), a[kTerms - 1]);
    for (std::size_t i = kTerms - 1; i-- > 0;)
        sum = hn::Add(hn::Mul(sum, x), hn::Set(FloatTag(), a[i]));
    return sum;
}

/// The logarithm to base 2 of positive normal numbers.
///
/// exact  to a few units of the last place, also near 1, by the series of 2 artanh((m - 1) / (m + 1)), with
///        x = m 2^e and m within a factor sqrt(2) of 1
HWY_INLINE Floats Log2(Floats x)
{
    constexpr FloatTag tag;
    constexpr IntTag intTag;
    constexpr double kPerLn = 1.4426950408889634; // 1 / ln 2
    constexpr std::array<float, 5> kSeries{float(2 * kPerLn), float(2 * kPerLn / 3), float(2 * kPerLn / 5),
                                           float(2 * kPerLn / 7), float(2 * kPerLn / 9)};
    const Ints bits = hn::BitCast(intTag, x);
    const Ints exponent = hn::ShiftRight<23>(hn::Sub(bits, hn::Set(intTag, 0x3f3504f3))); // bits of sqrt(1/2)
    const Floats m = hn::BitCast(tag, hn::Sub(bits, hn::ShiftLeft<23>(exponent)));
    const Floats one = hn::Set(tag, 1.0F);
    const Floats t = hn::Div(hn::Sub(m, one), hn::Add(m, one));
    return hn::Add(hn::ConvertTo(tag, exponent), hn::Mul(t, Polynomial(hn::Mul(t, t), kSeries)));
}

/// 2^x for x from -126 to 126.
///
/// exact  to a few units of the last place, by the series of e^(f ln 2) for the fraction f, at most 1/2
HWY_INLINE Floats Exp2(Floats x)
{
    constexpr FloatTag tag;
    constexpr IntTag intTag;
    constexpr double kLn = 0.6931471805599453; // ln 2
    constexpr std::array<float, 8> kSeries{1.0F,
                                           float(kLn),
                                           float(kLn * kLn / 2),
                                           float(kLn * kLn * kLn / 6),
                                           float(kLn * kLn * kLn * kLn / 24),
                                           float(kLn * kLn * kLn * kLn * kLn / 120),
                                           float(kLn * kLn * kLn * kLn * kLn * kLn / 720),
                                           float(kLn * kLn * kLn * kLn * kLn * kLn * kLn / 5040)};
    const Floats whole = hn::Round(x);
    const Ints exponent = hn::Add(IntsOf(whole), hn::Set(intTag, 127));
    return hn::Mul(Polynomial(hn::Sub(x, whole), kSeries), hn::BitCast(tag, hn::ShiftLeft<23>(exponent)));
}

/// x^exponent for x >= 0 and exponent >= 1; powers below 2^-126 are 0, those above 2^126 that.
HWY_INLINE Floats Power(Floats x, Floats exponent)
{
    constexpr FloatTag tag;
    const Floats smallest = hn::Set(tag, -126.0F);
    const Floats log = hn::Mul(exponent, Log2(hn::Max(x, hn::Set(tag, std::numeric_limits<float>::min()))));
    const Floats held = hn::Min(hn::Max(log, smallest), hn::Neg(smallest));
    return hn::IfThenElseZero(hn::Gt(log, smallest), Exp2(held));
}

struct VectorLanes {
    Floats x, y, z;
};

HWY_INLINE Floats Dot(const VectorLanes& a, const VectorLanes& b)
{
    return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}

HWY_INLINE VectorLanes Add(const VectorLanes& a, const VectorLanes& b)
{
    return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}

/// The vector at unit length; without one where its length is 0.
HWY_INLINE VectorLanes Normalize(const VectorLanes& a)
{
    const Floats inverse = hn::Div(hn::Set(FloatTag(), 1.0F), hn::Sqrt(Dot(a, a)));
    return {hn::Mul(a.x, inverse), hn::Mul(a.y, inverse), hn::Mul(a.z, inverse)};
}

} // namespace rasterlens::tiled::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
