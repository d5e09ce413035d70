#pragma once
#include "core/pipeline/depth_test.h"
#include "core/pipeline/framebuffer.h"
#include "core/pipeline/interpolation.h"
#include "core/pipeline/observer.h"
#include "core/pipeline/shading.h"
#include "core/settings/rules.h"

#include <stop_token>
#include <utility>

namespace rasterlens
{

/// Depth and weights that an algorithm brought along edges and spans itself (edge-then-span).
struct Interpolants {
    double depth;
    Weights screen;
    Weights weights;
};

/// What happens to a covered sample, for every algorithm: interpolate, depth test, shade, write.
/// `Caller` makes types of their own for callers other than the algorithms, so that these keep their inlined code.
template <class Observer, class Caller = void>
class FragmentStage
{
public:
    FragmentStage(const Rules& rules, const SampleBuffer& samples, const glm::vec3& eyeWorld, Observer& observer)
        : m_rules(&rules), m_samples(samples), m_eyeWorld(eyeWorld), m_observer(&observer)
    {
    }

    /// From a request to stop on, stopped() tells the algorithms to end.
    void stopBy(std::stop_token stop) { m_stop = std::move(stop); }
    [[nodiscard]] bool stopped() const { return m_stop.stop_requested(); }

    /// The triangle the following samples belong to; both must outlive them.
    void begin(const FaceInterpolation& interpolation, const FaceUniforms& uniforms)
    {
        m_interpolation = &interpolation;
        m_uniforms = &uniforms;
    }

    /// A sample covered by the area of the triangle.
    [[gnu::always_inline]] void operator()(int x, int y) // many loops call it, which makes compilers hesitate
    {
        const Weights screen = m_interpolation->weightsAt(x, y);
        process(x, y, m_interpolation->depthAt(x, y, screen), screen, nullptr);
    }

    /// A sample on one of the triangle's lines or corners, inside the target or not.
    void operator()(int x, int y, const Weights& screen)
    {
        const bool onTarget = x >= 0 && y >= 0 && x < m_samples.columns && y < m_samples.rows;
        m_observer->onLineSample(x, y, onTarget);
        if (onTarget)
            process(x, y, m_interpolation->depthOf(screen), screen, nullptr);
    }

    void operator()(int x, int y, const Interpolants& interpolants)
    {
        process(x, y, interpolants.depth, interpolants.screen, &interpolants.weights);
    }

    /// What belongs at the sample (x, y), drawn at another place or, if that is not on the target, not at all.
    void drawElsewhere(int x, int y, int placeX, int placeY)
    {
        if (placeX < 0 || placeY < 0 || placeX >= m_samples.columns || placeY >= m_samples.rows) {
            m_observer->onLineSample(placeX, placeY, false);
            return;
        }
        const Weights screen = m_interpolation->weightsAt(x, y);
        process(placeX, placeY, m_interpolation->depthAt(x, y, screen), screen, nullptr);
    }

    [[nodiscard]] const SampleBuffer& samples() const { return m_samples; }
    [[nodiscard]] const FaceInterpolation& interpolation() const { return *m_interpolation; }

private:
    void process(int x, int y, double depth, const Weights& screen, const Weights* weights)
    {
        const std::size_t at = m_samples.index(x, y);
        if (m_samples.coverage != nullptr && m_samples.coverage[at] != 0xffff)
            ++m_samples.coverage[at];
        Fragment fragment;
        fragment.x = x;
        fragment.y = y;
        fragment.face = m_interpolation->triangle().face;
        fragment.depth = storedDepth(depth, m_rules->depthFormat);
        fragment.screen = screen;

        const float stored = m_samples.depth != nullptr ? m_samples.depth[at] : m_rules->depthClear;
        const bool passed = !m_rules->depthTested || depthPasses(fragment.depth, stored, m_rules->depthCompare);
        const bool shaded = m_samples.color != nullptr && (passed || !m_rules->depthBeforeShading);
        std::uint32_t color = 0;
        if (shaded) {
            UvGradient gradient;
            if (m_rules->varyingCount > 0) {
                fragment.weights = weights != nullptr ? *weights : m_interpolation->perspective(screen);
                m_interpolation->varyings(fragment.weights, fragment.varyings);
                if (needsUvGradient(*m_rules, *m_uniforms))
                    gradient = m_interpolation->uvGradient(screen, fragment.weights, kVaryingUv);
            }
            color = shadeFragment(*m_rules, *m_uniforms, fragment.varyings, fragment.depth, m_eyeWorld, gradient);
        }
        m_observer->onFragment(fragment, stored, passed);
        if (shaded)
            m_observer->onShade(fragment, color);
        if (passed)
            write(at, fragment, color);
        else if (m_rules->depthWrittenOnFail)
            m_samples.depth[at] = fragment.depth;
    }

    void write(std::size_t at, const Fragment& fragment, std::uint32_t color)
    {
        const bool writesDepth = m_samples.depth != nullptr;
        const bool writesColor = m_samples.color != nullptr;
        const Pixel before{writesColor ? m_samples.color[at] : 0,
                           writesDepth ? m_samples.depth[at] : m_rules->depthClear};
        if (writesColor)
            m_samples.color[at] = color;
        if (writesDepth)
            m_samples.depth[at] = fragment.depth;
        if (m_samples.ids != nullptr)
            m_samples.ids[at] = static_cast<std::int32_t>(fragment.face);
        m_observer->onWrite(fragment.x, fragment.y, before, {color, writesDepth ? fragment.depth : before.depth});
    }

    const Rules* m_rules;
    SampleBuffer m_samples;
    glm::vec3 m_eyeWorld;
    Observer* m_observer;
    const FaceInterpolation* m_interpolation = nullptr;
    const FaceUniforms* m_uniforms = nullptr;
    std::stop_token m_stop;
};

} // namespace rasterlens
