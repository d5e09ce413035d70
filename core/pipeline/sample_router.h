#pragma once
#include "core/pipeline/fragment_stage.h"
#include "core/pipeline/mask_test.h"

#include <algorithm>
#include <stop_token>
#include <utility>
#include <vector>

namespace rasterlens
{

/// Stands between an algorithm and the fragment stage where faces have holes, or where the rules want a covered sample
/// to be drawn at another place than its own, or the samples of a pixel to share a depth.
///
/// A hole is no part of its face: the fragment stage hears nothing of it, whenever it tests depth.
template <class Observer>
class SampleRouter
{
public:
    SampleRouter(const Scene& scene, const Rules& rules, const SampleBuffer& samples, const glm::vec3& eyeWorld,
                 Observer& observer)
        : m_scene(&scene), m_rules(&rules), m_stage(scene, rules, samples, eyeWorld, observer)
    {
    }

    [[nodiscard]] static bool wanted(const Rules& rules)
    {
        return rules.positionInterpolated || rules.bounds == Bounds::Unclamped || rules.depthPerPixel ||
               rules.maskUv >= 0;
    }

    void stopBy(std::stop_token stop) { m_stage.stopBy(std::move(stop)); }
    [[nodiscard]] bool stopped() const { return m_stage.stopped(); }

    void begin(const ScreenTriangle& triangle)
    {
        m_stage.begin(triangle);
        m_mask = maskTest(*m_scene, triangle.face, *m_rules);
    }

    void operator()(int x, int y)
    {
        if (m_mask.mask != nullptr && isHoleAt(m_stage.interpolation().weightsAt(x, y)))
            return;
        const GridPoint place = placeOf(x, y);
        draw(place, [&] { m_stage.drawElsewhere(x, y, place.x, place.y); });
    }

    void operator()(int x, int y, const FaceInterpolation::EdgeIntegers&) { (*this)(x, y); }

    void operator()(int x, int y, const Weights& screen)
    {
        if (m_mask.mask == nullptr || !isHoleAt(screen))
            m_stage(x, y, screen);
    }

    void operator()(int x, int y, const Interpolants& interpolants)
    {
        if (isHole(m_mask, m_stage.interpolation(), interpolants.onScreen, interpolants.weights))
            return;
        const GridPoint place = placeOf(x, y);
        if (onTarget(place))
            draw(place, [&] { m_stage(place.x, place.y, interpolants); });
    }

    /// Call this after the last sample of a triangle. Until then all its samples are tested against the depths that
    /// were there before the triangle.
    void finish()
    {
        for (const GridPoint place : m_depthWritten)
            shareDepth(place);
        m_depthWritten.clear();
    }

private:
    struct GridPoint {
        int x;
        int y;
    };

    [[nodiscard]] bool isHoleAt(const Weights& screen) const
    {
        const FaceInterpolation& interpolation = m_stage.interpolation();
        return isHole(m_mask, interpolation, screen, interpolation.perspective(screen));
    }

    template <class Draw>
    void draw(GridPoint place, Draw drawSample)
    {
        const SampleBuffer& samples = m_stage.samples();
        if (!m_rules->depthPerPixel || samples.depth == nullptr || !onTarget(place)) {
            drawSample();
            return;
        }
        const float& depth = samples.depth[samples.index(place.x, place.y)];
        const float before = depth;
        drawSample();
        if (depth != before)
            m_depthWritten.push_back(place);
    }

    [[nodiscard]] GridPoint placeOf(int x, int y) const
    {
        if (m_rules->positionInterpolated)
            return interpolatedPlace(x, y);
        if (m_rules->bounds == Bounds::Unclamped)
            return placeInMemory(x, y);
        return {x, y};
    }

    /// The sample's place as float32 weights make it of the places of the corners; what should be 7 may be 6.9999995.
    [[nodiscard]] GridPoint interpolatedPlace(int x, int y) const
    {
        const ScreenTriangle& triangle = m_stage.interpolation().triangle();
        const Weights weights = m_stage.interpolation().weightsAt(x, y);
        glm::vec2 place(0);
        for (std::size_t i = 0; i < 3; ++i)
            place += static_cast<float>(weights[i]) * glm::vec2(triangle.vertices[i].position - 0.5);
        const auto truncated = [](float p) { return p > -1e6F ? static_cast<int>(std::min(p, 1e6F)) : -1; };
        return {truncated(place.x), truncated(place.y)};
    }

    /// The sample that lies where row-by-row addressing finds (x, y), or (-1, -1) before and behind the buffer.
    [[nodiscard]] GridPoint placeInMemory(int x, int y) const
    {
        const SampleBuffer& samples = m_stage.samples();
        const std::int64_t at = std::int64_t(y) * samples.columns + x;
        if (at < 0 || at >= std::int64_t(samples.columns) * samples.rows)
            return {-1, -1};
        return {static_cast<int>(at % samples.columns), static_cast<int>(at / samples.columns)};
    }

    [[nodiscard]] bool onTarget(GridPoint p) const
    {
        const SampleBuffer& samples = m_stage.samples();
        return p.x >= 0 && p.y >= 0 && p.x < samples.columns && p.y < samples.rows;
    }

    /// Copies the depth of a sample to the others of its pixel.
    void shareDepth(GridPoint p) const
    {
        const SampleBuffer& samples = m_stage.samples();
        const int grid = m_rules->sampleGrid;
        const float depth = samples.depth[samples.index(p.x, p.y)];
        for (int y = p.y / grid * grid; y < p.y / grid * grid + grid; ++y)
            for (int x = p.x / grid * grid; x < p.x / grid * grid + grid; ++x)
                samples.depth[samples.index(x, y)] = depth;
    }

    const Scene* m_scene;
    const Rules* m_rules;
    MaskTest m_mask; ///< of the triangle the samples belong to
    FragmentStage<Observer, SampleRouter> m_stage;
    std::vector<GridPoint> m_depthWritten; ///< with depthPerPixel
};

} // namespace rasterlens
