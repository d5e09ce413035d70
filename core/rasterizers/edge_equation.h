#pragma once
#include "core/observe/observer.h"
#include "core/pipeline/interpolation.h"
#include "core/pipeline/triangle_setup.h"
#include "core/rasterizers/registry.h"

namespace rasterlens
{

/// Tests every sample of the bounding box against the three edge functions.
struct EdgeEquation {
    static constexpr RasterizerInfo info{Algorithm::EdgeEquation, "Pineda, SIGGRAPH 1988"};

    [[nodiscard]] static std::optional<QString> supports(const Rules& rules)
    {
        if (rules.attributePath == AttributePath::EdgeThenSpan)
            return QStringLiteral("attribute-path edge-then-span needs algorithm edge-walking");
        return std::nullopt;
    }

    /// Calls emit(x, y) for every covered sample, row by row from the top, left to right.
    template <class T, class Emit, class Observer>
    static void cover(const TriangleSetup<T>& setup, const FaceInterpolation&, const Rules& rules, Emit& emit,
                      Observer& observer)
    {
        if (rules.stepping == Stepping::Incremental)
            coverIncremental(setup, emit, observer);
        else
            coverDirect(setup, emit, observer);
    }

private:
    template <class T>
    using Values = std::array<T, 3>;

    template <class T>
    static bool inside(const Values<T>& e, const TriangleSetup<T>& setup)
    {
        return e[0] >= setup.edges[0].threshold && e[1] >= setup.edges[1].threshold && e[2] >= setup.edges[2].threshold;
    }

    template <class T>
    static EdgeValues observed(const Values<T>& e)
    {
        return {static_cast<double>(e[0]), static_cast<double>(e[1]), static_cast<double>(e[2])};
    }

    /// Three start values; then add A for each column and B for each row.
    template <class T, class Emit, class Observer>
    static void coverIncremental(const TriangleSetup<T>& setup, Emit& emit, Observer& observer)
    {
        const PixelRect& box = setup.bounds;
        const auto& edges = setup.edges;
        Values<T> row;
        Values<T> perColumn;
        Values<T> perRow;
        for (std::size_t i = 0; i < 3; ++i) {
            row[i] = edges[i].at(TriangleSetup<T>::centre(box.x, box.y));
            perColumn[i] = edges[i].a * Grid<T>::kUnit;
            perRow[i] = edges[i].b * Grid<T>::kUnit;
        }
        for (int y = box.y; y < box.y + box.height; ++y) {
            Values<T> e = row;
            for (int x = box.x; x < box.x + box.width; ++x) {
                const bool covered = inside(e, setup);
                observer.onSample(x, y, observed(e), covered);
                if (covered)
                    emit(x, y);
                for (std::size_t i = 0; i < 3; ++i)
                    e[i] += perColumn[i];
            }
            for (std::size_t i = 0; i < 3; ++i)
                row[i] += perRow[i];
        }
    }

    /// Evaluates the edge functions anew at every sample.
    template <class T, class Emit, class Observer>
    static void coverDirect(const TriangleSetup<T>& setup, Emit& emit, Observer& observer)
    {
        const PixelRect& box = setup.bounds;
        const auto& edges = setup.edges;
        for (int y = box.y; y < box.y + box.height; ++y)
            for (int x = box.x; x < box.x + box.width; ++x) {
                const Point<T> p = TriangleSetup<T>::centre(x, y);
                const Values<T> e{edges[0].at(p), edges[1].at(p), edges[2].at(p)};
                const bool covered = inside(e, setup);
                observer.onSample(x, y, observed(e), covered);
                if (covered)
                    emit(x, y);
            }
    }
};

} // namespace rasterlens
