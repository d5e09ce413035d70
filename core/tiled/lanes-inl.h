// Vectors of this instruction set, and what Highway's one-lane target lacks. Included once for each target: see
// README.md.
#if defined(RASTERLENS_TILED_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERLENS_TILED_LANES_INL_H
#undef RASTERLENS_TILED_LANES_INL_H
#else
#define RASTERLENS_TILED_LANES_INL_H
#endif

#include "core/tiled/tile_data.h"

#include <cmath>
#include <cstring>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace rasterlens::tiled::HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

// Sixteen samples (or blocks, or subtiles) at a time, in one vector or several.
using FloatTag = hn::CappedTag<float, kLanes>;
using IntTag = hn::RebindToSigned<FloatTag>;
using UintTag = hn::RebindToUnsigned<FloatTag>;
using Floats = hn::Vec<FloatTag>;
using Ints = hn::Vec<IntTag>;
using Uints = hn::Vec<UintTag>;
constexpr std::size_t kPerVector = hn::MaxLanes(FloatTag());
constexpr std::size_t kVectors = kLanes / kPerVector;

// Doubles, and as many 32-bit numbers.
using DoubleTag = hn::CappedTag<double, 8>;
using DoubleBitsTag = hn::RebindToSigned<DoubleTag>;
using HalfFloatTag = hn::Rebind<float, DoubleTag>;
using HalfIntTag = hn::Rebind<std::int32_t, DoubleTag>;
using Doubles = hn::Vec<DoubleTag>;
using HalfFloats = hn::Vec<HalfFloatTag>;
using HalfInts = hn::Vec<HalfIntTag>;
constexpr std::size_t kDoubles = hn::MaxLanes(DoubleTag());
constexpr std::size_t kParts = kPerVector / kDoubles; ///< vectors of double for one of float

/// Number of each lane, its column and row in its block.
struct alignas(64) LanePattern {
    std::array<std::uint32_t, kLanes> place{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
    std::array<std::int32_t, kLanes> x{0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
    std::array<std::int32_t, kLanes> y{0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};
    // Column and row, 16 bits each.
    std::array<std::int32_t, kLanes> xy{0x00000, 0x00001, 0x00002, 0x00003, 0x10000, 0x10001, 0x10002, 0x10003,
                                        0x20000, 0x20001, 0x20002, 0x20003, 0x30000, 0x30001, 0x30002, 0x30003};
    std::array<float, kLanes> floatX{0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
    std::array<float, kLanes> floatY{0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};
    std::array<double, kLanes> doubleX{0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
    std::array<double, kLanes> doubleY{0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};
};
inline constexpr LanePattern kPattern;

/// first, first + 1, ... from a lane on. (hn::Iota() goes through memory number by number.)
HWY_INLINE Uints PlacesFrom(std::uint32_t first, std::size_t lane)
{
    constexpr UintTag tag;
    return hn::Add(hn::Load(tag, kPattern.place.data() + lane), hn::Set(tag, first));
}

/// The upper byte of both halves of each lane.
HWY_INLINE Uints UpperBytes(Uints pairs)
{
#if HWY_TARGET == HWY_SCALAR
    return hn::And(hn::ShiftRight<8>(pairs), hn::Set(UintTag(), 0x00ff00ffU));
#else
    constexpr hn::Repartition<std::uint16_t, UintTag> halves;
    return hn::BitCast(UintTag(), hn::ShiftRight<8>(hn::BitCast(halves, pairs)));
#endif
}

// Halves of lanes: numbers of 16 bits, modulo 2^16.
#if HWY_TARGET == HWY_SCALAR
template <class Operation>
HWY_INLINE Uints ForHalves(Uints a, Uints b, Operation&& operation)
{
    const std::uint32_t x = hn::GetLane(a);
    const std::uint32_t y = hn::GetLane(b);
    return hn::Set(UintTag(), operation(x >> 16, y >> 16) << 16 | (operation(x & 0xffff, y & 0xffff) & 0xffff));
}
HWY_INLINE Uints AddHalves(Uints a, Uints b)
{
    return ForHalves(a, b, [](std::uint32_t x, std::uint32_t y) { return x + y; });
}
HWY_INLINE Uints MulHalvesHigh(Uints a, Uints b)
{
    return ForHalves(a, b, [](std::uint32_t x, std::uint32_t y) { return x * y >> 16; });
}
#else
using HalvesTag = hn::Repartition<std::uint16_t, UintTag>;
HWY_INLINE Uints AddHalves(Uints a, Uints b)
{
    return hn::BitCast(UintTag(), hn::Add(hn::BitCast(HalvesTag(), a), hn::BitCast(HalvesTag(), b)));
}
/// The upper 16 bits of products.
HWY_INLINE Uints MulHalvesHigh(Uints a, Uints b)
{
    return hn::BitCast(UintTag(), hn::MulHigh(hn::BitCast(HalvesTag(), a), hn::BitCast(HalvesTag(), b)));
}
#endif

/// The halves of each lane as signed numbers of 16 bits.
HWY_INLINE Ints LowerHalves(Ints pairs) { return hn::ShiftRight<16>(hn::ShiftLeft<16>(pairs)); }
HWY_INLINE Ints UpperHalves(Ints pairs) { return hn::ShiftRight<16>(pairs); }

/// The product of the lower halves plus that of the upper ones.
HWY_INLINE Ints PairProducts(Ints a, Ints b)
{
#if HWY_TARGET == HWY_SCALAR
    return hn::Add(hn::Mul(LowerHalves(a), LowerHalves(b)), hn::Mul(UpperHalves(a), UpperHalves(b)));
#else
    constexpr hn::Repartition<std::int16_t, IntTag> halves; // x86 has one instruction for all of it
    Ints others = hn::Zero(IntTag());
    const Ints some = hn::ReorderWidenMulAccumulate(IntTag(), hn::BitCast(halves, a), hn::BitCast(halves, b),
                                                    hn::Zero(IntTag()), others);
    return hn::RearrangeToOddPlusEven(some, others);
#endif
}

/// Halves that are negative become 0.
HWY_INLINE Ints PositiveHalves(Ints pairs)
{
#if HWY_TARGET == HWY_SCALAR
    const std::int32_t both = hn::GetLane(pairs);
    const std::int32_t lower = std::max(static_cast<std::int32_t>(static_cast<std::int16_t>(both)), 0);
    return hn::Set(IntTag(), std::max(both >> 16, 0) * 0x10000 + lower);
#else
    constexpr hn::Repartition<std::int16_t, IntTag> halves;
    return hn::BitCast(IntTag(), hn::Max(hn::BitCast(halves, pairs), hn::Zero(halves)));
#endif
}

/// As many doubles as a vector of floats has lanes.
struct WideDoubles {
    std::array<Doubles, kParts> part;
};

HWY_INLINE WideDoubles Add(const WideDoubles& a, Doubles b)
{
    WideDoubles sum;
    for (std::size_t p = 0; p < kParts; ++p)
        sum.part[p] = hn::Add(a.part[p], b);
    return sum;
}

HWY_INLINE WideDoubles Mul(const WideDoubles& a, Doubles b)
{
    WideDoubles product;
    for (std::size_t p = 0; p < kParts; ++p)
        product.part[p] = hn::Mul(a.part[p], b);
    return product;
}

HWY_INLINE void Store(const WideDoubles& wide, double* to)
{
    for (std::size_t p = 0; p < kParts; ++p)
        hn::Store(wide.part[p], DoubleTag(), to + p * kDoubles);
}

HWY_INLINE WideDoubles LoadWide(const double* from)
{
    WideDoubles wide;
    for (std::size_t p = 0; p < kParts; ++p)
        wide.part[p] = hn::Load(DoubleTag(), from + p * kDoubles);
    return wide;
}

/// Rounds to nearest.
HWY_INLINE Floats ToFloats(const WideDoubles& wide)
{
#if HWY_TARGET == HWY_SCALAR
    return hn::DemoteTo(HalfFloatTag(), wide.part[0]);
#else
    return hn::Combine(FloatTag(), hn::DemoteTo(HalfFloatTag(), wide.part[1]),
                       hn::DemoteTo(HalfFloatTag(), wide.part[0]));
#endif
}

HWY_INLINE WideDoubles ToDoubles(Floats narrow)
{
#if HWY_TARGET == HWY_SCALAR
    return {{hn::PromoteTo(DoubleTag(), narrow)}};
#else
    return {{hn::PromoteTo(DoubleTag(), hn::LowerHalf(HalfFloatTag(), narrow)),
             hn::PromoteTo(DoubleTag(), hn::UpperHalf(HalfFloatTag(), narrow))}};
#endif
}

/// Floats that hold whole numbers, as integers. A float beyond the integers, or NaN, gives an undefined lane: only
/// lanes that are ignored afterwards may hold one. (hn::ConvertTo() of one lane is undefined there, and differs
/// between targets.)
HWY_INLINE Ints IntsOf(Floats whole)
{
#if HWY_TARGET == HWY_SCALAR
    const float number = hn::GetLane(whole);
    return hn::Set(IntTag(), std::abs(number) < 0x1p31F ? static_cast<std::int32_t>(number) : 0);
#else
    return hn::ConvertTo(IntTag(), whole);
#endif
}

/// Doubles that hold whole numbers, as integers.
HWY_INLINE Ints ToInts(const WideDoubles& wide)
{
#if HWY_TARGET == HWY_SCALAR
    return hn::DemoteTo(HalfIntTag(), wide.part[0]);
#else
    return hn::Combine(IntTag(), hn::DemoteTo(HalfIntTag(), wide.part[1]), hn::DemoteTo(HalfIntTag(), wide.part[0]));
#endif
}

/// A bit for each lane of a mask.
template <class Tag, class Mask>
HWY_INLINE std::uint32_t BitsOf(Tag tag, Mask mask)
{
#if HWY_TARGET <= HWY_AVX3
    // GCC 12 would merge the comparison with the widening of its mask, store 2 bytes of it and read 4. The empty asm
    // hides from the compiler where the mask comes from.
    asm("" : "+k"(mask.raw));
#endif
    // As many bytes as are written are read: compilers then see through the memory.
    using Bits = std::conditional_t<(hn::MaxLanes(Tag()) > 8), std::uint16_t, std::uint8_t>;
    alignas(8) std::array<std::uint8_t, 8> bytes{};
    hn::StoreMaskBits(tag, mask, bytes.data());
    Bits bits;
    std::memcpy(&bits, bytes.data(), sizeof bits);
    return bits;
}

/// The mask of the lowest bits.
template <class Tag>
HWY_INLINE hn::Mask<Tag> MaskOf(Tag tag, std::uint32_t bits)
{
    alignas(8) std::array<std::uint8_t, 8> bytes;
    std::memcpy(bytes.data(), &bits, sizeof bits);
    return hn::LoadMaskBits(tag, bytes.data());
}

/// Stores the chosen lanes; the others keep what is there.
HWY_INLINE void StoreWhere(Uints v, hn::Mask<UintTag> chosen, std::uint32_t* to)
{
#if HWY_TARGET <= HWY_AVX3
    hn::BlendedStore(v, chosen, UintTag(), to);
#else // processors with AVX2 may take long for a store under a mask
    hn::Store(hn::IfThenElse(chosen, v, hn::Load(UintTag(), to)), UintTag(), to);
#endif
}

/// from[at] for the wanted lanes, 0 for the others.
template <class T>
HWY_INLINE hn::Vec<hn::Rebind<T, FloatTag>> Gather(const T* from, Ints at, hn::Mask<FloatTag> wanted)
{
    constexpr hn::Rebind<T, FloatTag> tag;
    static_assert(sizeof(T) == sizeof(std::int32_t));
#if HWY_TARGET <= HWY_AVX3
    // hn::GatherIndex() leaves open what the register held: each would wait for whatever was there before.
    if constexpr (kPerVector == 16) {
        const __mmask16 mask = static_cast<__mmask16>(BitsOf(FloatTag(), wanted));
        return hn::BitCast(tag, Ints{_mm512_mask_i32gather_epi32(_mm512_setzero_si512(), mask, at.raw, from, 4)});
    }
#endif
    const auto chosen = hn::RebindMask(tag, wanted);
    return hn::IfThenElseZero(chosen,
                              hn::GatherIndex(tag, from, hn::IfThenElseZero(hn::RebindMask(IntTag(), wanted), at)));
}

} // namespace rasterlens::tiled::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
