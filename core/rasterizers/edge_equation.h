#pragma once
#include "core/pipeline/gouraud_batch.h"
#include "core/pipeline/observer.h"
#include "core/pipeline/stopping.h"
#include "core/pipeline/triangle_setup.h"
#include "core/rasterizers/registry.h"

#include <type_traits>

namespace rasterlens
{

/// Tests every sample of the bounding box against the three edge functions.
struct EdgeEquation {
    static constexpr RasterizerInfo info{Algorithm::EdgeEquation, "Pineda, SIGGRAPH 1988"};

    [[nodiscard]] static std::optional<Reason> supports(const Rules& rules)
    {
        if (rules.attributePath == AttributePath::EdgeThenSpan)
            return Reason{
                QT_TRANSLATE_NOOP("Unsupported", "attribute-path edge-then-span needs algorithm edge-walking")};
        return std::nullopt;
    }

    /// Calls emit for every covered sample, row by row from the top, left to right: emit(x, y, edge values) where these
    /// are integers that tell the weights, else emit(x, y).
    template <class T, class Emit, class Observer>
    static void cover(const TriangleSetup<T>& setup, const ScreenTriangle&, const Rules& rules, Emit& emit,
                      Observer& observer)
    {
        if (rules.insideTest != InsideTest::AllPositive || rules.samplesTruncated ||
            rules.coverageRule != CoverageRule::Centre)
            coverByRules(setup, rules, emit, observer);
        else if (rules.stepping == Stepping::Incremental)
            coverIncremental(setup, emit, observer);
        else
            coverDirect(setup, emit, observer);
    }

private:
    template <class T>
    using Values = std::array<T, 3>;

    /// Without a branch: which edge a sample is outside of is hard to predict.
    template <class T>
    static bool inside(const Values<T>& e, const TriangleSetup<T>& setup)
    {
        const auto& [ab, bc, ca] = setup.edges;
        return (int(e[0] >= ab.threshold) & int(e[1] >= bc.threshold) & int(e[2] >= ca.threshold)) != 0;
    }

    template <class T>
    static void step(Values<T>& e, const Values<T>& by)
    {
        for (std::size_t i = 0; i < 3; ++i)
            e[i] += by[i];
    }

    template <class T>
    static EdgeValues observed(const Values<T>& e)
    {
        return {static_cast<double>(e[0]), static_cast<double>(e[1]), static_cast<double>(e[2])};
    }

    template <class T, class Emit>
    [[gnu::always_inline]] static void emitWithEdges(int x, int y, const Values<T>& e, Emit& emit)
    {
        if constexpr (std::is_same_v<T, std::int64_t>)
            emit(x, y, e);
        else
            emit(x, y);
    }

    /// Edge values at the first sample of a box; then add A for each column and B for each row.
    template <class T>
    struct Steps {
        Values<T> first;
        Values<T> perColumn;
        Values<T> perRow;

        explicit Steps(const TriangleSetup<T>& setup)
        {
            for (std::size_t i = 0; i < 3; ++i) {
                const EdgeFunction<T>& edge = setup.edges[i];
                first[i] = edge.at(TriangleSetup<T>::centre(setup.bounds.x, setup.bounds.y));
                perColumn[i] = edge.a * Grid<T>::kUnit;
                perRow[i] = edge.b * Grid<T>::kUnit;
            }
        }
    };

    template <class T, class Emit, class Observer>
    static void coverIncremental(const TriangleSetup<T>& setup, Emit& emit, Observer& observer)
    {
        if constexpr (requires { emit.batch(); }) {
            if (GouraudBatch* batch = emit.batch()) {
                collectIncremental(setup, *batch, emit);
                return;
            }
        }
        const PixelRect& box = setup.bounds;
        const Steps<T> steps(setup);
        Values<T> row = steps.first;
        for (int y = box.y; y < box.y + box.height && !isStopped(emit); ++y, step(row, steps.perRow)) {
            if (skipsLine(emit, y))
                continue;
            Values<T> e = row;
            for (int x = box.x; x < box.x + box.width; ++x, step(e, steps.perColumn)) {
                const bool covered = inside(e, setup);
                observer.onSample(x, y, observed(e), covered);
                if (covered)
                    emitWithEdges(x, y, e, emit);
            }
        }
    }

    /// Collects the samples for a stage that draws many at a time.
    template <class T, class Emit>
    static void collectIncremental(const TriangleSetup<T>& setup, GouraudBatch& batch, Emit& emit)
    {
        const PixelRect box = setup.bounds;
        const Steps<T> steps(setup);
        Values<T> row = steps.first;
        std::size_t count = batch.count;
        for (int y = box.y; y < box.y + box.height && !isStopped(emit); ++y, step(row, steps.perRow)) {
            Values<T> e = row;
            for (int x = box.x; x < box.x + box.width; ++x, step(e, steps.perColumn)) {
                batch.x[count] = x;
                batch.y[count] = y;
                count += inside(e, setup) ? 1 : 0;
                if (count == GouraudBatch::kMost) {
                    batch.count = count;
                    emit.drawBatch();
                    count = 0;
                }
            }
        }
        batch.count = count; // emit.finish() draws the rest
    }

    /// An edge value as an integer of whole pixel areas with so many bits keeps it, without an overflow that C++ leaves
    /// undefined.
    template <class T>
    static T wrapped(T e, int bits)
    {
        const int lostBits = 48 - bits; // of 64, with 16 bits behind the point
        if constexpr (std::is_same_v<T, std::int64_t>)
            e = static_cast<std::int64_t>(static_cast<std::uint64_t>(e) << lostBits) >> lostBits;
        return e;
    }

    template <class T>
    static T asKept(T e, InsideTest test)
    {
        switch (test) {
        case InsideTest::Wrapped32: return wrapped(e, 32);
        case InsideTest::Wrapped16: return wrapped(e, 16);
        case InsideTest::AllPositive:
        case InsideTest::EitherSign:
        case InsideTest::None: break;
        }
        return e;
    }

    /// Where a sample is tested: its centre, or the corner of its pixel.
    template <class T>
    static Point<T> testPoint(int x, int y, const Rules& rules)
    {
        if (!rules.samplesTruncated)
            return TriangleSetup<T>::centre(x, y);
        const int grid = rules.sampleGrid;
        return {static_cast<T>(x / grid * grid) * Grid<T>::kUnit, static_cast<T>(y / grid * grid) * Grid<T>::kUnit};
    }

    /// The box that holds all samples of the pixels it touches.
    static PixelRect wholePixels(const PixelRect& box, int grid)
    {
        const int left = box.x / grid * grid;
        const int top = box.y / grid * grid;
        const int right = (box.x + box.width + grid - 1) / grid * grid;
        const int bottom = (box.y + box.height + grid - 1) / grid * grid;
        return {left, top, right - left, bottom - top};
    }

    /// The test of rules.insideTest and rules.coverageRule, evaluated anew at every sample.
    template <class T, class Emit, class Observer>
    static void coverByRules(const TriangleSetup<T>& setup, const Rules& rules, Emit& emit, Observer& observer)
    {
        const PixelRect box = rules.samplesTruncated ? wholePixels(setup.bounds, rules.sampleGrid) : setup.bounds;
        const T reach = cornerReach<T>(rules);
        for (int y = box.y; y < box.y + box.height && !isStopped(emit); ++y) {
            if (skipsLine(emit, y))
                continue;
            for (int x = box.x; x < box.x + box.width; ++x) {
                Values<T> e;
                bool allNegative = rules.insideTest == InsideTest::EitherSign;
                for (std::size_t i = 0; i < 3; ++i) {
                    const EdgeFunction<T>& edge = setup.edges[i];
                    e[i] = asKept(edge.atCorner(testPoint<T>(x, y, rules), reach), rules.insideTest);
                    allNegative = allNegative && e[i] <= edge.threshold;
                }
                const bool covered = inside(e, setup) || allNegative || rules.insideTest == InsideTest::None;
                observer.onSample(x, y, observed(e), covered);
                if (covered)
                    emit(x, y);
            }
        }
    }

    /// Evaluates the edge functions anew at every sample.
    template <class T, class Emit, class Observer>
    static void coverDirect(const TriangleSetup<T>& setup, Emit& emit, Observer& observer)
    {
        const PixelRect& box = setup.bounds;
        const auto& edges = setup.edges;
        for (int y = box.y; y < box.y + box.height && !isStopped(emit); ++y) {
            if (skipsLine(emit, y))
                continue;
            for (int x = box.x; x < box.x + box.width; ++x) {
                const Point<T> p = TriangleSetup<T>::centre(x, y);
                const Values<T> e{edges[0].at(p), edges[1].at(p), edges[2].at(p)};
                const bool covered = inside(e, setup);
                observer.onSample(x, y, observed(e), covered);
                if (covered)
                    emitWithEdges(x, y, e, emit);
            }
        }
    }
};

} // namespace rasterlens
