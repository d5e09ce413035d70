#pragma once
#include "core/pipeline/types.h"
#include "core/settings/rules.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <type_traits>

namespace rasterlens
{

/// The three edge values of a sample in pixel areas times 65536 (fixed point) or in pixel areas (floats), AB, BC, CA.
using EdgeValues = std::array<double, 3>;

/// What a sample stores.
struct Pixel {
    std::uint32_t color = 0; ///< 0xffRRGGBB
    float depth = 1;

    friend bool operator==(const Pixel&, const Pixel&) = default;
};

/// What decided whether a face is a front or a back face.
struct FacingDecision {
    Facing by = Facing::ScreenArea;
    double screenArea = 0; ///< samples squared, after clipping and snapping; positive is counter-clockwise with y up
    double value = 0;      ///< what the rules look at, which is this area unless they say otherwise; same sign
    FaceFate fate = FaceFate::Rasterized;
};

/// Edge walking: the corners from top to bottom, and the rows that are filled.
struct WalkedTriangle {
    std::array<glm::dvec2, 3> vertices; ///< samples: top, middle, bottom
    std::array<std::uint8_t, 3> source; ///< which vertex of the screen triangle each of them is
    bool longEdgeIsLeft = false;        ///< the long edge goes from top to bottom
    int firstRow = 0;
    int lastRow = 0; ///< < firstRow: none
};

/// Edge walking: what the height of the middle corner cuts the triangle into.
struct WalkedHalves {
    double alpha = 0;      ///< fraction of the way down the long edge at which the middle corner lies beside it
    double x = 0;          ///< samples: the long edge there
    int firstLowerRow = 0; ///< rows from there on belong to the lower half
};

/// Edge walking: where the centre line of a row crosses the long edge and the short edge of its half.
struct RowCrossings {
    int y = 0;              ///< the row, in samples
    double height = 0;      ///< where it is crossed: at its centre line, but for Rules::wholeRows
    bool upperHalf = false; ///< the short edge goes from top to middle, else from middle to bottom
    double alpha = 0;       ///< fraction of the way down the long edge
    double beta = 0;        ///< fraction of the way down the short edge
    double xa = 0;          ///< samples: on the long edge, as it was stepped there
    double xb = 0;          ///< samples: on the short edge
    int xBegin = 0;         ///< the span that follows: samples [xBegin, xEnd)
    int xEnd = 0;
};

/// Edge walking: where the two active edges cross the centre line of a row.
struct SpanEnds {
    double left = 0;  ///< samples
    double right = 0; ///< samples
    bool longEdgeIsLeft = false;
    bool upperHalf = false;    ///< the short edge goes from top to middle, else from middle to bottom
    std::int64_t begin = 0;    ///< first sample of the span, before it is held within the bounds
    std::int64_t end = 0;      ///< one past the last sample, before it is held within the bounds
    bool leftOwnsTie = true;   ///< a centre on the left edge is inside: ceil(v - 0.5), else floor(v - 0.5) + 1
    bool rightOwnsTie = false; ///< a centre on the right edge is inside
    bool whole = false;        ///< floor(v) and floor(v) + 1: see Rules::wholeRows
};

/// Column fill: the rows in which the edges of a triangle cross a column of samples.
struct FilledColumn {
    int x = 0;
    std::array<int, 6> rows{}; ///< `count` of them, edge by edge; a vertical edge has two
    int count = 0;             ///< 0: no edge crosses the column

    /// The least and the greatest row; first() > last() where there is none.
    [[nodiscard]] int first() const { return count > 0 ? *std::min_element(rows.begin(), rows.begin() + count) : 0; }
    [[nodiscard]] int last() const { return count > 0 ? *std::max_element(rows.begin(), rows.begin() + count) : -1; }
};

/// Bresenham: which of two samples is nearer to the ideal line, after sample (x, y) was plotted.
struct LineDecision {
    int step = 0; ///< i, counted from 0
    int x = 0;
    int y = 0;
    int decision = 0; ///< p_i; the shorter axis is stepped along if it is > 0
    int longer = 0;   ///< dx of a flat line, dy of a steep one
    int shorter = 0;
    bool steep = false;
    bool sideways = false; ///< the shorter axis is stepped along
};

/// Digital differential analyzer: how far a line has come by additions, and the sample that is nearest. Whole numbers
/// are centres of samples.
struct LinePosition {
    int step = 0;  ///< i, counted from 0
    int steps = 0; ///< of the whole line
    double x = 0;
    double y = 0;
    double perStepX = 0;
    double perStepY = 0;
    int column = 0;
    int row = 0;

    [[nodiscard]] bool steep() const { return std::abs(perStepY) > std::abs(perStepX); }
    /// How far the line is from the sample's centre, along the axis that is not stepped along by whole samples.
    [[nodiscard]] double error() const { return steep() ? x - column : y - row; }
};

/// The samples of a pixel, and the colour that the picture has of them.
struct ResolvedPixel {
    static constexpr int kMostSamples = 16;

    int x = 0; ///< pixels
    int y = 0;
    int count = 0;                             ///< samples, row by row, or in the order of the pattern
    bool isPattern = false;                    ///< multi-sampling: the samples lie on no grid
    std::array<Pixel, kMostSamples> samples{}; ///< what is stored
    std::uint32_t black = 0;                   ///< one bit a sample: it counts as black, whatever it stores
    std::uint32_t color = 0;                   ///< 0xffRRGGBB
    ResolveLight light = ResolveLight::Gamma;  ///< what the mean is taken of

    /// The colour that a sample brings into the mean.
    [[nodiscard]] std::uint32_t counted(int sample) const
    {
        return (black >> sample & 1U) != 0 ? 0xff000000U : samples[static_cast<std::size_t>(sample)].color;
    }

    friend bool operator==(const ResolvedPixel&, const ResolvedPixel&) = default;
};

/// The observer that ignores every event. Pass it for full speed: all calls compile away. To listen, derive a class and
/// *shadow* the functions of the events you need; none is virtual. Arguments are values that the algorithm already has.
struct NullObserver {
    /// Faces that go through geometry before the first of them is rasterized: many are fast, one keeps the order of
    /// events face by face.
    static constexpr int kFacesPerBatch = 256;

    /// A face fetches its three vertices, told before anything else about the face.
    constexpr void onVertex(std::uint32_t /*face*/, int /*corner*/, std::uint32_t /*meshVertex*/, const ClipVertex&) {}
    constexpr void onFace(std::uint32_t /*face*/, FaceFate) {}
    /// `before` and `after` one plane; `after` may be empty.
    constexpr void onClipPlane(std::uint32_t /*face*/, ClipPlane, const ClipPolygon& /*before*/,
                               const ClipPolygon& /*after*/)
    {
    }
    /// `before` and `after` the four sides of the screen were applied to the projected edges.
    constexpr void onCohenSutherland(std::uint32_t /*face*/, const ClipPolygon& /*before*/,
                                     const ClipPolygon& /*after*/)
    {
    }
    /// A corner of what is left of the face goes to the screen.
    constexpr void onViewport(std::uint32_t /*face*/, int /*corner*/, const ClipVertex&, const ScreenVertex&) {}
    /// A face was cut by at least one plane and is drawn as so many triangles; none if it is culled.
    constexpr void onClipped(std::uint32_t /*face*/, int /*pieces*/) {}
    constexpr void onFacing(std::uint32_t /*face*/, const FacingDecision&) {}
    constexpr void onTriangle(const ScreenTriangle&) {}
    /// Multi-sampling: what follows, up to the next such event or triangle, belongs to this sample of the pattern; -1:
    /// to none, but to the pixel.
    constexpr void onPatternSample(int /*sample*/) {}
    /// An optional TriangleSetup<T> for the triangle of the last onTriangle; empty: it holds no sample's centre.
    template <class Setup>
    constexpr void onSetup(const Setup&)
    {
    }
    /// Edge walking begins; the edges are those of the last onSetup.
    constexpr void onOutline() {}
    constexpr void onWalk(const WalkedTriangle&) {}
    constexpr void onSides(const WalkedTriangle&) {}
    constexpr void onHalves(const WalkedTriangle&, const WalkedHalves&) {}
    constexpr void onCrossing(const RowCrossings&) {}
    constexpr void onSpan(int /*y*/, int /*xBegin*/, int /*xEnd*/, const SpanEnds&) {}
    constexpr void onSample(int /*x*/, int /*y*/, const EdgeValues&, bool /*covered*/) {}
    /// Column fill: before the samples of the column.
    constexpr void onColumn(const FilledColumn&) {}
    constexpr void onLineDecision(const LineDecision&) {}
    constexpr void onLinePosition(const LinePosition&) {}
    /// A sample of a line, a corner or a filled column; off the target nothing is drawn.
    constexpr void onLineSample(int /*x*/, int /*y*/, bool /*onTarget*/) {}
    /// The sample's depth against the stored one. Varyings are there where the fragment is shaded.
    constexpr void onFragment(const Fragment&, float /*storedDepth*/, bool /*passedDepth*/) {}
    constexpr void onShade(const Fragment&, std::uint32_t /*color*/) {}
    constexpr void onWrite(int /*x*/, int /*y*/, Pixel /*before*/, Pixel /*after*/) {}
    /// A sample of a pattern is given the mean of its pixel (rules.resolvedByFace).
    constexpr void onShared(int /*x*/, int /*y*/, Pixel /*before*/, Pixel /*after*/) {}
    /// After the last face, pixel by pixel in rows from the top; only where a pixel has several samples.
    constexpr void onResolve(const ResolvedPixel&) {}
};

/// Whether an observer reads fragments: it then gets all their numbers, else only those the picture needs are computed.
template <class Observer>
constexpr bool kReadsFragments =
    !std::is_same_v<decltype(&Observer::onFragment), decltype(&NullObserver::onFragment)> ||
    !std::is_same_v<decltype(&Observer::onShade), decltype(&NullObserver::onShade)>;

/// Whether an observer is told how samples become pixels.
template <class Observer>
constexpr bool kReadsResolve = !std::is_same_v<decltype(&Observer::onResolve), decltype(&NullObserver::onResolve)>;

} // namespace rasterlens
