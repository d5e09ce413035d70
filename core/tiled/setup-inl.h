// Edges, depth planes and bounds of triangles, lane by lane. Included once for each target: see README.md.
#if defined(RASTERLENS_TILED_SETUP_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERLENS_TILED_SETUP_INL_H
#undef RASTERLENS_TILED_SETUP_INL_H
#else
#define RASTERLENS_TILED_SETUP_INL_H
#endif

#include "core/pipeline/interpolation.h"
#include "core/tiled/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterlens::tiled::HWY_NAMESPACE
{

/// First and last sample along an axis whose centre lies between two positions, inside the target.
struct SampleLanes {
    HalfInts first;
    HalfInts last;
};

///
/// in   units by which samples may lie beside the centre
HWY_INLINE SampleLanes SamplesBetween(HalfInts low, HalfInts high, int size, int reach)
{
    constexpr HalfIntTag tag;
    return {hn::Max(hn::ShiftRight<8>(hn::Add(low, hn::Set(tag, kUnit / 2 - 1 - reach))), hn::Zero(tag)),
            hn::Min(hn::ShiftRight<8>(hn::Sub(high, hn::Set(tag, kUnit / 2 - reach))), hn::Set(tag, size - 1))};
}

HWY_INLINE HalfInts Min3(HalfInts a, HalfInts b, HalfInts c) { return hn::Min(hn::Min(a, b), c); }
HWY_INLINE HalfInts Max3(HalfInts a, HalfInts b, HalfInts c) { return hn::Max(hn::Max(a, b), c); }
HWY_INLINE Doubles Min3(Doubles a, Doubles b, Doubles c) { return hn::Min(hn::Min(a, b), c); }
HWY_INLINE Doubles Max3(Doubles a, Doubles b, Doubles c) { return hn::Max(hn::Max(a, b), c); }

/// twiceArea() of positions in any unit.
HWY_INLINE Doubles TwiceArea(Doubles abX, Doubles abY, Doubles acX, Doubles acY)
{
    return hn::Sub(hn::Mul(abY, acX), hn::Mul(abX, acY));
}

/// The edge from one corner to the next, in units.
struct EdgeLanes {
    HalfInts a, b;
    HalfInts fromX, fromY;
    HalfInts threshold; ///< of the tie rule, in 256ths of a unit
};

HWY_INLINE EdgeLanes MakeEdge(HalfInts fromX, HalfInts fromY, HalfInts toX, HalfInts toY, const Rules& rules)
{
    constexpr HalfIntTag tag;
    const HalfInts a = hn::Sub(toY, fromY);
    const HalfInts b = hn::Sub(fromX, toX);
    const HalfInts zero = hn::Zero(tag);
    const auto owner = hn::Or(hn::Gt(a, zero), hn::And(hn::Eq(a, zero), hn::Gt(b, zero)));
    return {a, b, fromX, fromY, hn::IfThenElse(owner, hn::Set(tag, rules.tie.owner), hn::Set(tag, rules.tie.other))};
}

/// Edge values in 32 bits: from kFarInside on they are held there, and so are those as far outside.
HWY_INLINE HalfInts HeldEdge(Doubles value)
{
    const Doubles limit = hn::Set(DoubleTag(), double(kFarInside));
    return hn::DemoteTo(HalfIntTag(), hn::Min(hn::Max(value, hn::Neg(limit)), limit));
}

/// The middle of samples, in units.
HWY_INLINE HalfInts CentreOf(HalfInts samples)
{
    return hn::Add(hn::ShiftLeft<8>(samples), hn::Set(HalfIntTag(), kUnit / 2));
}

/// The edges of a vector of triangles, and their values with the threshold taken off, in 256ths of a unit rounded down.
struct TriangleEdges {
    std::array<EdgeLanes, 3> edge;
    bool compact;                      ///< all triangles are small and near (x, y): IsCompact()
    HalfInts x, y;                     ///< a sample, the first one of the bounds
    std::array<HalfInts, 3> compactAt; ///< values there, of compact triangles
    std::array<Doubles, 3> c;          ///< of other triangles: values at the first sample of the target
    std::array<HalfInts, 3> rest;      ///< multi-sampling: sixteenths that c lacks

    HWY_INLINE Doubles at(std::size_t k, HalfInts column, HalfInts row) const
    {
        return HWY_LIKELY(compact) ? hn::PromoteTo(DoubleTag(), nearAt(k, column, row)) : farAt(k, column, row);
    }
    HWY_INLINE HalfInts heldAt(std::size_t k, HalfInts column, HalfInts row) const
    {
        return HWY_LIKELY(compact) ? nearAt(k, column, row) : HeldEdge(farAt(k, column, row));
    }

private:
    HWY_INLINE HalfInts nearAt(std::size_t k, HalfInts column, HalfInts row) const
    {
        const HalfInts alongX = hn::Mul(edge[k].a, hn::Sub(column, x));
        const HalfInts alongY = hn::Mul(edge[k].b, hn::Sub(row, y));
        return hn::Add(compactAt[k], hn::Add(alongX, alongY));
    }
    HWY_INLINE Doubles farAt(std::size_t k, HalfInts column, HalfInts row) const
    {
        const auto along = [](HalfInts slope, HalfInts samples) HWY_ATTR {
            return hn::Mul(hn::PromoteTo(DoubleTag(), slope), hn::PromoteTo(DoubleTag(), samples));
        };
        return hn::Add(c[k], hn::Add(along(edge[k].a, column), along(edge[k].b, row)));
    }
};

/// Whether edge values of all triangles of a vector may be computed in 32 bits near the sample (x, y).
///
/// in     bounds of the corners
/// exact  gradients are less than 2^14, and no corner is farther from the sample along an axis than 2^15, so products
///        are less than 2^29
HWY_INLINE bool IsCompact(HalfInts lowX, HalfInts lowY, HalfInts highX, HalfInts highY, HalfInts x, HalfInts y)
{
    constexpr HalfIntTag tag;
    const auto span = hn::Max(hn::Sub(highX, lowX), hn::Sub(highY, lowY));
    const auto way = hn::Max(hn::Abs(hn::Sub(CentreOf(x), lowX)), hn::Abs(hn::Sub(CentreOf(y), lowY)));
    return hn::AllTrue(tag, hn::Lt(hn::Max(span, way), hn::Set(tag, 1 << 14)));
}

/// Fills in the values of the edges.
HWY_INLINE void EvaluateEdges(const Rules& rules, TriangleEdges& edges)
{
    constexpr HalfIntTag tag;
    constexpr DoubleTag wide;
    for (std::size_t k = 0; k < 3; ++k) {
        const EdgeLanes& edge = edges.edge[k];
        if (HWY_LIKELY(edges.compact)) {
            const HalfInts value = hn::Add(hn::Mul(edge.a, hn::Sub(CentreOf(edges.x), edge.fromX)),
                                           hn::Mul(edge.b, hn::Sub(CentreOf(edges.y), edge.fromY)));
            edges.compactAt[k] = hn::ShiftRight<8>(hn::Sub(value, edge.threshold));
            continue;
        }
        const HalfInts half = hn::Set(tag, kUnit / 2);
        const auto along = [&](HalfInts slope, HalfInts from) HWY_ATTR {
            return hn::Mul(hn::PromoteTo(wide, slope), hn::PromoteTo(wide, hn::Sub(half, from)));
        };
        const Doubles above =
            hn::Sub(hn::Add(along(edge.a, edge.fromX), along(edge.b, edge.fromY)), hn::PromoteTo(wide, edge.threshold));
        edges.c[k] = hn::Floor(hn::Mul(above, hn::Set(wide, 1.0 / kUnit)));
        if (rules.multiSampled()) {
            const Doubles sixteenths = hn::Floor(hn::Mul(above, hn::Set(wide, 16.0 / kUnit)));
            edges.rest[k] = hn::DemoteTo(tag, hn::Sub(sixteenths, hn::Mul(edges.c[k], hn::Set(wide, 16.0))));
        }
    }
}

/// Rounds to a multiple of a power of two, as depthPlane() does.
HWY_INLINE Doubles RoundTo(Doubles value, Doubles quantum)
{
    const Doubles magic = hn::Mul(quantum, hn::Set(DoubleTag(), 0x1.8p52));
    return hn::Sub(hn::Add(value, magic), magic);
}

struct CornerLanes {
    Doubles x, y, depth; ///< samples
};

struct PlaneLanes {
    Doubles origin, perX, perY;
    hn::Mask<DoubleTag> plane; ///< false: a needle
};

/// depthPlane(), operation by operation.
HWY_INLINE PlaneLanes MakeDepthPlane(const CornerLanes& a, const CornerLanes& b, const CornerLanes& c,
                                     Doubles inverseArea, const Rules& rules)
{
    constexpr DoubleTag tag;
    const auto set = [](double value) HWY_ATTR { return hn::Set(DoubleTag(), value); };
    const Doubles abX = hn::Sub(b.x, a.x);
    const Doubles abY = hn::Sub(b.y, a.y);
    const Doubles acX = hn::Sub(c.x, a.x);
    const Doubles acY = hn::Sub(c.y, a.y);
    const Doubles zb = hn::Sub(b.depth, a.depth);
    const Doubles zc = hn::Sub(c.depth, a.depth);
    const Doubles zcAbY = hn::Mul(zc, abY);
    const Doubles zbAcY = hn::Mul(zb, acY);
    const Doubles zbAcX = hn::Mul(zb, acX);
    const Doubles zcAbX = hn::Mul(zc, abX);
    const Doubles perX = hn::Mul(hn::Sub(zcAbY, zbAcY), inverseArea);
    const Doubles perY = hn::Mul(hn::Sub(zbAcX, zcAbX), inverseArea);

    const Doubles margin = set(kPlaneMargin);
    const Doubles lowX = hn::Sub(hn::Max(Min3(a.x, b.x, c.x), set(0)), margin);
    const Doubles lowY = hn::Sub(hn::Max(Min3(a.y, b.y, c.y), set(0)), margin);
    const Doubles highX = hn::Add(hn::Min(Max3(a.x, b.x, c.x), set(rules.columns())), margin);
    const Doubles highY = hn::Add(hn::Min(Max3(a.y, b.y, c.y), set(rules.rows())), margin);
    const Doubles toOriginX = hn::Sub(set(0.5), a.x);
    const Doubles toOriginY = hn::Sub(set(0.5), a.y);
    const Doubles originAtZero = hn::Add(hn::Add(a.depth, hn::Mul(perX, toOriginX)), hn::Mul(perY, toOriginY));
    const Doubles largest =
        hn::Add(hn::Add(hn::Abs(originAtZero), hn::Mul(hn::Abs(perX), hn::Max(hn::Abs(highX), margin))),
                hn::Mul(hn::Abs(perY), hn::Max(hn::Abs(highY), margin)));
    // 2^(exponent - 51)
    constexpr DoubleBitsTag bits;
    const auto exponent =
        hn::And(hn::BitCast(bits, hn::Max(largest, set(0x1p-900))), hn::Set(bits, std::int64_t(0x7ff) << 52));
    const Doubles quantum = hn::BitCast(tag, hn::Sub(exponent, hn::Set(bits, std::int64_t(51) << 52)));
    const Doubles extent = hn::Add(hn::Add(hn::Sub(highX, lowX), hn::Sub(highY, lowY)), set(1));
    const Doubles products = hn::Add(hn::Add(hn::Add(hn::Abs(zcAbY), hn::Abs(zbAcY)), hn::Abs(zbAcX)), hn::Abs(zcAbX));
    const Doubles steepness = hn::Mul(hn::Mul(products, hn::Abs(inverseArea)), set(0x1p-52));
    const auto finite = hn::Le(largest, set(std::numeric_limits<double>::max()));
    PlaneLanes plane;
    plane.plane = hn::And(finite, hn::Lt(hn::Mul(hn::Add(quantum, steepness), extent), set(kPlaneError)));
    plane.perX = RoundTo(perX, quantum);
    plane.perY = RoundTo(perY, quantum);
    plane.origin =
        RoundTo(hn::Add(hn::Add(a.depth, hn::Mul(plane.perX, toOriginX)), hn::Mul(plane.perY, toOriginY)), quantum);
    return plane;
}

/// The largest gradients of triangles, without their signs.
HWY_INLINE HalfInts Steepest(const std::array<EdgeLanes, 3>& edges)
{
    HalfInts steepest = hn::Zero(HalfIntTag());
    for (const EdgeLanes& edge : edges)
        steepest = Max3(steepest, hn::Abs(edge.a), hn::Abs(edge.b));
    return steepest;
}

/// Lanes whose edges 32 bits cannot decide.
HWY_INLINE hn::Mask<HalfIntTag> TooSteep(const std::array<EdgeLanes, 3>& edges)
{
    return hn::Gt(Steepest(edges), hn::Set(HalfIntTag(), kLargestGradient));
}

/// Narrows the bounds of triangles of at most 4 x 4 samples to the rows and columns they cover, to nothing if they
/// cover none: it is cheaper to find that out here, many at a time, than in the tiles. Huge triangles that only a
/// corner of the target meets stay as they are.
HWY_INLINE void NarrowBounds(const TriangleEdges& edges, hn::Mask<HalfIntTag> tooSteep, SampleLanes& columns,
                             SampleLanes& rows)
{
    constexpr HalfIntTag tag;
    const HalfInts side = hn::Set(tag, kBlockSide);
    const auto small = hn::AndNot(tooSteep, hn::And(hn::Lt(hn::Sub(columns.last, columns.first), side),
                                                    hn::Lt(hn::Sub(rows.last, rows.first), side)));
    if (hn::AllFalse(tag, small))
        return;
    std::array<HalfInts, 3> row;
    for (std::size_t k = 0; k < 3; ++k)
        row[k] = edges.heldAt(k, columns.first, rows.first);
    const HalfInts outside = hn::Set(tag, -1);
    const HalfInts none = hn::Set(tag, kBlockSide);
    HalfInts firstColumn = none, lastColumn = outside, firstRow = none, lastRow = outside;
    for (int y = 0; y < kBlockSide; ++y) {
        std::array<HalfInts, 3> e = row;
        for (int x = 0; x < kBlockSide; ++x) {
            const auto covered = hn::Gt(hn::Or3(e[0], e[1], e[2]), outside);
            const HalfInts column = hn::Set(tag, x);
            const HalfInts line = hn::Set(tag, y);
            firstColumn = hn::IfThenElse(covered, hn::Min(firstColumn, column), firstColumn);
            lastColumn = hn::IfThenElse(covered, hn::Max(lastColumn, column), lastColumn);
            firstRow = hn::IfThenElse(covered, hn::Min(firstRow, line), firstRow);
            lastRow = hn::IfThenElse(covered, line, lastRow);
            for (std::size_t k = 0; k < 3; ++k)
                e[k] = hn::Add(e[k], edges.edge[k].a);
        }
        for (std::size_t k = 0; k < 3; ++k)
            row[k] = hn::Add(row[k], edges.edge[k].b);
    }
    // Samples beyond the target may be covered too.
    columns = {hn::IfThenElse(small, hn::Add(columns.first, firstColumn), columns.first),
               hn::Min(columns.last, hn::IfThenElse(small, hn::Add(columns.first, lastColumn), columns.last))};
    rows = {hn::IfThenElse(small, hn::Add(rows.first, firstRow), rows.first),
            hn::Min(rows.last, hn::IfThenElse(small, hn::Add(rows.first, lastRow), rows.last))};
}

} // namespace rasterlens::tiled::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
