#pragma once
#include "core/pipeline/depth_test.h"
#include "core/pipeline/framebuffer.h"
#include "core/pipeline/interpolation.h"
#include "core/pipeline/mask_test.h"
#include "core/pipeline/observer.h"
#include "core/pipeline/shading.h"
#include "core/settings/sample_pattern.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

namespace rasterlens
{

/// The fragment stage of multi-sampling: depth is tested at every sample, and a face is shaded once a pixel.
///
/// An algorithm covers the triangle once for every sample of the pattern, each time moved so that the sample lies at
/// the pixel's centre. The stage notes in masks what is covered, and draws the pixels when the triangle is finished.
template <class Observer>
class MultisampleStage
{
public:
    MultisampleStage(const Scene& scene, const Rules& rules, const SampleBuffer& samples, const glm::vec3& eyeWorld,
                     Observer& observer)
        : m_scene(&scene), m_rules(&rules), m_samples(samples), m_eyeWorld(eyeWorld), m_observer(&observer),
          m_pattern(samplePattern(rules.patternSamples)), m_store(rules),
          m_readsDepth(kReadsFragments<Observer> || samples.depth != nullptr || rules.shading == Shading::Depth)
    {
    }

    void stopBy(std::stop_token stop) { m_stop = std::move(stop); }
    [[nodiscard]] bool stopped() const { return m_stop.stop_requested(); }

    /// The triangle the following samples belong to; it must outlive them.
    void begin(const ScreenTriangle& triangle)
    {
        m_interpolation.emplace(triangle, triangle.area2, *m_rules, m_readsDepth ? DepthUse::Read : DepthUse::Ignored);
        m_compare = depthCompareOf(*m_rules, triangle.face);
        m_uniforms = faceUniforms(*m_scene, triangle.face, *m_rules);
        m_mask = maskTest(*m_scene, triangle.face, *m_rules);
        m_box = boxOf(triangle);
        m_masks.assign(static_cast<std::size_t>(m_box.width) * static_cast<std::size_t>(m_box.height), 0);
    }

    /// The covered pixels that follow are those whose sample number `sample` is covered.
    void beginSample(int sample) { m_bit = static_cast<SampleMask>(1U << sample); }

    template <class... Known>
    void operator()(int x, int y, const Known&...)
    {
        m_masks[maskIndex(x, y)] |= m_bit;
    }

    /// Draws the pixels of the triangle.
    ///
    /// in  take(x, y)  asked before each pixel: whether to draw it
    template <class Take>
    void finish(Take&& take)
    {
        for (int y = m_box.y; y < m_box.y + m_box.height && !stopped(); ++y)
            for (int x = m_box.x; x < m_box.x + m_box.width; ++x)
                if (const SampleMask covered = m_masks[maskIndex(x, y)]; covered != 0 && take(x, y))
                    draw(x, y, covered);
    }
    void finish()
    {
        finish([](int, int) { return true; });
    }

private:
    /// Where a pixel of the face is shaded: a point in pixels, and the weights there.
    struct Place {
        glm::dvec2 point;
        Weights screen;
        Weights weights;
    };

    /// The pixels that the triangle touches, within the target.
    [[nodiscard]] PixelRect boxOf(const ScreenTriangle& triangle) const
    {
        const auto& [a, b, c] = triangle.vertices;
        const glm::dvec2 size(m_samples.columns, m_samples.rows);
        const auto held = [&](const glm::dvec2& p) { return glm::clamp(p, glm::dvec2(0), size); };
        const glm::dvec2 low = held(glm::floor(glm::min(glm::min(a.position, b.position), c.position)) - 1.0);
        const glm::dvec2 high = held(glm::ceil(glm::max(glm::max(a.position, b.position), c.position)) + 1.0);
        return {int(low.x), int(low.y), int(high.x - low.x), int(high.y - low.y)};
    }

    [[nodiscard]] std::size_t maskIndex(int x, int y) const
    {
        return static_cast<std::size_t>(y - m_box.y) * static_cast<std::size_t>(m_box.width) +
               static_cast<std::size_t>(x - m_box.x);
    }

    /// What of the pixel the triangle covers; none of a pixel that it does not touch.
    [[nodiscard]] SampleMask maskAt(int x, int y) const
    {
        const bool isInBox = x >= m_box.x && y >= m_box.y && x < m_box.x + m_box.width && y < m_box.y + m_box.height;
        return isInBox ? m_masks[maskIndex(x, y)] : SampleMask(0);
    }

    [[nodiscard]] glm::dvec2 offsetOf(int sample) const { return m_pattern[static_cast<std::size_t>(sample)].pixels(); }

    [[nodiscard]] Place placeAt(int x, int y, const glm::dvec2& offset) const
    {
        const glm::dvec2 point = glm::dvec2(x + 0.5, y + 0.5) + offset;
        const Weights screen = m_interpolation->weightsAt(point);
        return {point, screen, m_interpolation->perspective(screen)};
    }

    void draw(int x, int y, SampleMask covered)
    {
        if (m_rules->attributeAt == AttributeAt::Sample) {
            for (SampleMask left = covered; left != 0; left &= static_cast<SampleMask>(left - 1)) {
                const int sample = std::countr_zero(left);
                drawSamples(x, y, static_cast<SampleMask>(1U << sample), placeAt(x, y, offsetOf(sample)));
            }
        } else {
            drawSamples(x, y, covered, placeAt(x, y, shadingOffset(*m_rules, covered)));
        }
        if (m_rules->resolvedByFace && m_samples.color != nullptr)
            shareMean(x, y);
    }

    /// Tests the covered samples, shades once for all of them, and writes those that pass.
    void drawSamples(int x, int y, SampleMask covered, const Place& place)
    {
        if (isHole(m_mask, *m_interpolation, place.screen, place.weights))
            return;
        SampleMask passed = 0;
        std::array<float, ResolvedPixel::kMostSamples> depths{};
        for (SampleMask left = covered; left != 0; left &= static_cast<SampleMask>(left - 1)) {
            const int sample = std::countr_zero(left);
            float& depth = depths[static_cast<std::size_t>(sample)];
            if (test(x, y, sample, place, depth))
                passed |= static_cast<SampleMask>(1U << sample);
        }
        const bool shaded = m_samples.color != nullptr && (passed != 0 || !m_rules->depthBeforeShading);
        const std::uint32_t color = shaded ? shade(x, y, place) : 0;
        for (SampleMask left = passed; left != 0; left &= static_cast<SampleMask>(left - 1)) {
            const int sample = std::countr_zero(left);
            write(x, y, sample, color, depths[static_cast<std::size_t>(sample)]);
        }
    }

    /// Counts a covered sample and compares its depth.
    bool test(int x, int y, int sample, const Place& place, float& depth)
    {
        const std::size_t at = m_samples.index(x, y, sample);
        if (m_samples.coverage != nullptr && m_samples.coverage[at] != 0xffff)
            ++m_samples.coverage[at];
        depth = m_readsDepth ? storedDepth(m_interpolation->depthAt(x, y, offsetOf(sample)), m_store) : 0;
        const float stored = m_samples.depth != nullptr ? m_samples.depth[at] : m_rules->depthClear;
        const bool passed = !m_rules->depthTested || depthPasses(depth, stored, m_compare);
        if constexpr (kReadsFragments<Observer>) {
            m_observer->onPatternSample(sample);
            Fragment fragment = fragmentAt(x, y, place);
            fragment.depth = depth;
            fragment.screen = m_interpolation->weightsAt(glm::dvec2(x + 0.5, y + 0.5) + offsetOf(sample));
            m_observer->onFragment(fragment, stored, passed);
        }
        if (!passed && m_rules->depthWrittenOnFail)
            m_samples.depth[at] = depth;
        return passed;
    }

    /// What the pixel's shading reads.
    [[nodiscard]] Fragment fragmentAt(int x, int y, const Place& place) const
    {
        Fragment fragment;
        fragment.x = x;
        fragment.y = y;
        fragment.face = m_interpolation->triangle().face;
        fragment.depth =
            m_readsDepth
                ? storedDepth(m_interpolation->depthAt(x, y, place.point - glm::dvec2(x + 0.5, y + 0.5)), m_store)
                : 0;
        fragment.screen = place.screen;
        fragment.weights = place.weights;
        m_interpolation->varyings(place.weights, fragment.varyings);
        return fragment;
    }

    [[nodiscard]] std::uint32_t shade(int x, int y, const Place& place)
    {
        const Fragment fragment = fragmentAt(x, y, place);
        UvGradient gradient;
        if (needsUvGradient(*m_rules, m_uniforms))
            gradient = m_rules->gradientByNeighbours
                           ? neighbourGradient(x, y, fragment.varyings)
                           : m_interpolation->uvGradient(place.screen, place.weights, kVaryingUv);
        const std::uint32_t color =
            shadeFragment(*m_rules, m_uniforms, fragment.varyings, fragment.depth, m_eyeWorld, gradient);
        m_observer->onPatternSample(-1);
        m_observer->onShade(fragment, color);
        return color;
    }

    /// Differences of texture coordinates within the block of 2 x 2 pixels, each pixel shaded at its own place.
    [[nodiscard]] UvGradient neighbourGradient(int x, int y, const Varyings& here) const
    {
        const auto difference = [&](int otherX, int otherY) {
            const Place there = placeAt(otherX, otherY, shadingOffset(*m_rules, maskAt(otherX, otherY)));
            Varyings varyings;
            m_interpolation->varyings(there.weights, varyings);
            const glm::vec2 step(varyings[kVaryingUv] - here[kVaryingUv],
                                 varyings[kVaryingUv + 1] - here[kVaryingUv + 1]);
            return otherX < x || otherY < y ? -step : step;
        };
        return {difference(x ^ 1, y), difference(x, y ^ 1)};
    }

    void write(int x, int y, int sample, std::uint32_t color, float depth)
    {
        const std::size_t at = m_samples.index(x, y, sample);
        const bool writesDepth = m_samples.depth != nullptr;
        const Pixel before{m_samples.color != nullptr ? m_samples.color[at] : 0,
                           writesDepth ? m_samples.depth[at] : m_rules->depthClear};
        if (m_samples.color != nullptr)
            m_samples.color[at] = color;
        if (writesDepth)
            m_samples.depth[at] = depth;
        if (m_samples.ids != nullptr)
            m_samples.ids[at] = static_cast<std::int32_t>(m_interpolation->triangle().face);
        m_observer->onPatternSample(sample);
        m_observer->onWrite(x, y, before, {color, writesDepth ? depth : before.depth});
    }

    /// Gives all samples of a pixel their mean, as if the picture had no room for more than one colour a pixel.
    void shareMean(int x, int y)
    {
        const std::uint32_t mean = resolvedPixel(m_samples, *m_rules, x, y).color;
        for (int sample = 0; sample < m_rules->patternSamples; ++sample) {
            const std::size_t at = m_samples.index(x, y, sample);
            const float depth = m_samples.depth != nullptr ? m_samples.depth[at] : m_rules->depthClear;
            const Pixel before{std::exchange(m_samples.color[at], mean), depth};
            m_observer->onPatternSample(sample);
            m_observer->onShared(x, y, before, {mean, depth});
        }
    }

    const Scene* m_scene;
    const Rules* m_rules;
    SampleBuffer m_samples;
    glm::vec3 m_eyeWorld;
    Observer* m_observer;
    std::span<const SampleOffset> m_pattern;
    DepthStore m_store;
    DepthCompare m_compare = DepthCompare::Always; ///< of the face that the samples belong to
    bool m_readsDepth;
    std::optional<FaceInterpolation> m_interpolation; ///< of the triangle the samples belong to
    FaceUniforms m_uniforms;                          ///< of its face
    MaskTest m_mask;                                  ///< of its face
    PixelRect m_box;                                  ///< the pixels there are masks of
    std::vector<SampleMask> m_masks;
    SampleMask m_bit = 1; ///< of the sample that is covered now
    std::stop_token m_stop;
};

} // namespace rasterlens
