#pragma once
#include "core/observe/line_count.h"
#include "core/pipeline/observer.h"
#include "core/pipeline/statistics.h"
#include "core/settings/rules.h"

#include <optional>
#include <span>
#include <unordered_map>
#include <unordered_set>

namespace rasterlens
{

/// Counts what happens into Statistics.
class CountingObserver : public NullObserver
{
public:
    explicit CountingObserver(const Rules& rules);
    /// Goes on in the middle of a frame that was counted before.
    ///
    /// in  the counters there; which fragments, counted from 1, were second hits at an edge, ascending
    CountingObserver(const Rules& rules, const Statistics& before, std::span<const std::uint64_t> doubleHits);

    void onFace(std::uint32_t, FaceFate fate);
    void onClipped(std::uint32_t, int pieces);
    void onTriangle(const ScreenTriangle& triangle)
    {
        beginTriangle(triangle);
        countLines(triangle, m_rules, m_statistics.lines);
    }
    /// Takes a triangle that was counted before, by which its samples are told.
    void beginTriangle(const ScreenTriangle& triangle);
    void onPatternSample(int sample) { m_sample = sample; }
    void onSpan(int, int xBegin, int xEnd, const SpanEnds&)
    {
        m_statistics.pixels.tested += static_cast<std::uint64_t>(xEnd - xBegin);
    }
    void onSample(int, int, const EdgeValues&, bool) { ++m_statistics.pixels.tested; }
    void onLineSample(int, int, bool) { ++m_statistics.pixels.tested; }
    void onFragment(const Fragment& fragment, float storedDepth, bool passedDepth);
    void onShade(const Fragment&, std::uint32_t) { ++m_statistics.pixels.shaded; }
    void onWrite(int, int, Pixel, Pixel) { ++m_statistics.pixels.written; }

    [[nodiscard]] const Statistics& statistics() const { return m_statistics; }

private:
    /// An edge of the screen with the triangle on its left, and a sample the triangle covers close to it: triangles on
    /// opposite sides of an edge have it in opposite directions.
    struct EdgeHit {
        glm::dvec2 from;
        glm::dvec2 to;
        std::uint64_t sample;
        bool operator==(const EdgeHit&) const = default;
    };
    struct EdgeHitHash {
        std::size_t operator()(const EdgeHit& hit) const;
    };

    Rules m_rules;
    int m_columns;
    int m_rows;
    int m_sample = 0;               ///< of a pattern
    bool m_isLine = false;          ///< the triangle is a line of the scene
    bool m_isFilled;                ///< false: lines and corners belong to both faces, no tie rule parts them
    std::uint32_t m_firstPassFaces; ///< these are filled, whatever the others are
    double m_nearDistance;          ///< samples covered so close to an edge, in samples, are looked at for a second hit
    Statistics m_statistics;
    std::optional<std::span<const std::uint64_t>> m_doubleHits; ///< those to come, if they are known
    std::array<glm::dvec2, 3> m_positions{};
    bool m_counterClockwise = true;
    Weights m_nearEdge{}; ///< weights below these are close to the edge opposite the vertex
    std::unordered_set<EdgeHit, EdgeHitHash> m_hits;
    std::unordered_set<std::uint64_t> m_hitTwice;
};

} // namespace rasterlens
