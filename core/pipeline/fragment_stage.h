#pragma once
#include "core/pipeline/depth_test.h"
#include "core/pipeline/framebuffer.h"
#include "core/pipeline/gouraud_batch.h"
#include "core/pipeline/interpolation.h"
#include "core/pipeline/lockstep_depths.h"
#include "core/pipeline/observer.h"
#include "core/pipeline/shading.h"
#include "core/pipeline/texel_path.h"
#include "core/settings/rules.h"

#include <algorithm>
#include <array>
#include <optional>
#include <stop_token>
#include <type_traits>
#include <utility>

namespace rasterlens
{

// Samples as the fragment stage asks about them: depth(), the weights on the screen(), and the weights after
// perspective correction that attributes are weighted() with. Each is computed when it is asked for.

/// A sample inside the triangle.
struct AreaSample {
    const FaceInterpolation& interpolation;
    int x;
    int y;

    [[nodiscard]] Weights screen() const { return interpolation.weightsAt(x, y); }
    [[nodiscard]] double depth() const
    {
        return interpolation.depthAt(x, y, [&] { return screen(); });
    }
    [[nodiscard]] Weights weighted(const Weights& screen) const { return interpolation.perspective(screen); }
};

/// A sample inside the triangle whose edge values are at hand.
struct EdgeSample : AreaSample {
    FaceInterpolation::EdgeIntegers edges;

    [[nodiscard]] Weights screen() const { return interpolation.weightsAt(x, y, edges); }
};

/// A sample on one of the triangle's lines or corners.
struct LineSample {
    const FaceInterpolation& interpolation;
    const Weights& onScreen;

    [[nodiscard]] const Weights& screen() const { return onScreen; }
    [[nodiscard]] double depth() const { return interpolation.depthOf(onScreen); }
    [[nodiscard]] Weights weighted(const Weights& screen) const { return interpolation.perspective(screen); }
};

/// A sample whose depth and weights an algorithm brought along edges and spans itself (edge-then-span).
struct Interpolants {
    double carriedDepth;
    Weights onScreen;
    Weights weights;

    [[nodiscard]] const Weights& screen() const { return onScreen; }
    [[nodiscard]] double depth() const { return carriedDepth; }
    [[nodiscard]] const Weights& weighted(const Weights&) const { return weights; }
};

/// What happens to a covered sample, for every algorithm: interpolate, depth test, shade, write. Depth, weights and
/// attributes are computed only where the picture, the other outputs or the observer read them.
/// `Caller` makes types of their own for callers other than the algorithms, so that these keep their inlined code.
template <class Observer, class Caller = void>
class FragmentStage
{
public:
    FragmentStage(const Scene& scene, const Rules& rules, const SampleBuffer& samples, const glm::vec3& eyeWorld,
                  Observer& observer)
        : m_scene(&scene), m_rules(&rules), m_samples(samples), m_eyeWorld(eyeWorld), m_observer(&observer),
          m_store(rules),
          m_readsDepth(kReadsFragments<Observer> || samples.depth != nullptr || rules.shading == Shading::Depth),
          m_readsAttributes(varyingCount(rules.shading) > 0), m_takesOtherTexels(takesOtherTexels(rules)),
          m_readsUniforms(rules.shading != Shading::Gouraud && rules.shading != Shading::Depth),
          m_drawsBatches(std::is_same_v<Observer, NullObserver> && rules.shading == Shading::Gouraud &&
                         rules.depthTested && !rules.depthWrittenOnFail && rules.depthFormat == DepthFormat::Float32 &&
                         rules.depthRange.isWhole() && !rules.depthInLockstep && samples.depth != nullptr &&
                         samples.color != nullptr),
          m_testsRowsFirst(std::is_same_v<Observer, NullObserver> && rules.depthTested && rules.depthBeforeShading &&
                           !rules.depthWrittenOnFail && !rules.depthInLockstep && samples.depth != nullptr &&
                           samples.color != nullptr)
    {
    }

    /// From a request to stop on, stopped() tells the algorithms to end.
    void stopBy(std::stop_token stop) { m_stop = std::move(stop); }
    [[nodiscard]] bool stopped() const { return m_stop.stop_requested(); }

    /// The triangle the following samples belong to; it must outlive them.
    void begin(const ScreenTriangle& triangle)
    {
        m_interpolation.emplace(triangle, triangle.area2, *m_rules, m_readsDepth ? DepthUse::Read : DepthUse::Ignored);
        m_compare = depthCompareOf(*m_rules, triangle.face);
        if (m_rules->depthInLockstep)
            m_lockstep.begin(triangle.face);
        if (m_readsUniforms)
            m_uniforms = faceUniforms(*m_scene, triangle.face, *m_rules);
    }

    /// Call this after the last sample of a triangle: some may wait in the batch.
    void finish()
    {
        if (m_batch.count > 0)
            drawBatch();
    }

    // Many loops call the next two, which makes compilers hesitate to inline them.

    /// A sample covered by the area of the triangle.
    [[gnu::always_inline]] void operator()(int x, int y) { process(x, y, AreaSample{*m_interpolation, x, y}); }

    /// A sample covered by the area of the triangle, and its edge values.
    [[gnu::always_inline]] void operator()(int x, int y, const FaceInterpolation::EdgeIntegers& edges)
    {
        process(x, y, EdgeSample{{*m_interpolation, x, y}, edges});
    }

    /// The samples [xBegin, xEnd) of a row, covered by the area of the triangle: the same as one after the other.
    ///
    /// Where the observer does not tell the order, all depths of the row are tested before what passes is shaded. Which
    /// samples pass is hard to predict, and a processor that guesses wrong throws away the shading it has begun.
    void drawRow(int y, int xBegin, int xEnd)
    {
        if (GouraudBatch* batch = this->batch()) {
            for (int x = xBegin; x < xEnd; ++x) {
                batch->x[batch->count] = x;
                batch->y[batch->count] = y;
                if (++batch->count == GouraudBatch::kMost)
                    drawBatch();
            }
            return;
        }
        if (!m_testsRowsFirst) {
            for (int x = xBegin; x < xEnd; ++x)
                (*this)(x, y);
            return;
        }
        for (; xBegin < xEnd; xBegin += kRowPart)
            drawTestedRow(y, xBegin, std::min(xBegin + kRowPart, xEnd));
    }

    /// Room for covered samples of the triangle, to be filled and drawn by drawBatch(); null where each sample is to be
    /// handed over by itself.
    [[nodiscard]] GouraudBatch* batch()
    {
        return m_drawsBatches && !m_interpolation->planeOfDepth().byWeights ? &m_batch : nullptr;
    }

    /// Draws the samples of the batch: the same as one after the other, but all depths are tested before what passes is
    /// shaded.
    ///
    /// in  batch() with x, y and their count; afterwards it is empty
    void drawBatch()
    {
        computeDepths(*m_interpolation, m_batch);
        switch (m_compare) {
        case DepthCompare::Less: testBatch<DepthCompare::Less>(); break;
        case DepthCompare::LessEqual: testBatch<DepthCompare::LessEqual>(); break;
        case DepthCompare::Equal: testBatch<DepthCompare::Equal>(); break;
        case DepthCompare::GreaterEqual: testBatch<DepthCompare::GreaterEqual>(); break;
        case DepthCompare::Greater: testBatch<DepthCompare::Greater>(); break;
        case DepthCompare::NotEqual: testBatch<DepthCompare::NotEqual>(); break;
        case DepthCompare::Always: testBatch<DepthCompare::Always>(); break;
        }
        computeColors(*m_interpolation, m_batch);
        for (std::size_t i = 0; i < m_batch.count; ++i)
            m_samples.color[m_batch.at[i]] = m_batch.color[i];
        if (m_samples.ids != nullptr)
            for (std::size_t i = 0; i < m_batch.count; ++i)
                m_samples.ids[m_batch.at[i]] = static_cast<std::int32_t>(m_interpolation->triangle().face);
        m_batch.count = 0;
    }

    /// A sample on one of the triangle's lines or corners, inside the target or not.
    void operator()(int x, int y, const Weights& screen)
    {
        const bool onTarget = x >= 0 && y >= 0 && x < m_samples.columns && y < m_samples.rows;
        m_observer->onLineSample(x, y, onTarget);
        if (onTarget)
            process(x, y, LineSample{*m_interpolation, screen});
    }

    void operator()(int x, int y, const Interpolants& interpolants) { process(x, y, interpolants); }

    /// What belongs at the sample (x, y), drawn at another place or, if that is not on the target, not at all.
    void drawElsewhere(int x, int y, int placeX, int placeY)
    {
        if (placeX < 0 || placeY < 0 || placeX >= m_samples.columns || placeY >= m_samples.rows) {
            m_observer->onLineSample(placeX, placeY, false);
            return;
        }
        process(placeX, placeY, AreaSample{*m_interpolation, x, y});
    }

    [[nodiscard]] const SampleBuffer& samples() const { return m_samples; }
    [[nodiscard]] const FaceInterpolation& interpolation() const { return *m_interpolation; }

private:
    static constexpr int kRowPart = 64; ///< samples of a row that are tested before the first of them is shaded

    /// The samples of a part of a row that pass the depth test.
    struct PassedSamples {
        std::array<int, kRowPart> x;
        std::array<float, kRowPart> depth;
        int count = 0;
    };

    void drawTestedRow(int y, int xBegin, int xEnd)
    {
        PassedSamples passed;
        switch (m_compare) {
        case DepthCompare::Less: testRow<DepthCompare::Less>(y, xBegin, xEnd, passed); break;
        case DepthCompare::LessEqual: testRow<DepthCompare::LessEqual>(y, xBegin, xEnd, passed); break;
        case DepthCompare::Equal: testRow<DepthCompare::Equal>(y, xBegin, xEnd, passed); break;
        case DepthCompare::GreaterEqual: testRow<DepthCompare::GreaterEqual>(y, xBegin, xEnd, passed); break;
        case DepthCompare::Greater: testRow<DepthCompare::Greater>(y, xBegin, xEnd, passed); break;
        case DepthCompare::NotEqual: testRow<DepthCompare::NotEqual>(y, xBegin, xEnd, passed); break;
        case DepthCompare::Always: testRow<DepthCompare::Always>(y, xBegin, xEnd, passed); break;
        }
        for (std::size_t i = 0; i < static_cast<std::size_t>(passed.count); ++i) {
            const int x = passed.x[i];
            const std::uint32_t color = shade(AreaSample{*m_interpolation, x, y}, passed.depth[i]);
            write(x, y, m_samples.index(x, y), color, passed.depth[i]);
        }
    }

    /// Collects without a branch: a sample that fails is overwritten by the next one.
    template <DepthCompare compare>
    void testRow(int y, int xBegin, int xEnd, PassedSamples& passed)
    {
        const DepthStore store = m_store;
        std::size_t count = 0;
        for (int x = xBegin; x < xEnd; ++x) {
            const std::size_t at = m_samples.index(x, y);
            if (m_samples.coverage != nullptr && m_samples.coverage[at] != 0xffff)
                ++m_samples.coverage[at];
            const float depth = storedDepth(AreaSample{*m_interpolation, x, y}.depth(), store);
            passed.x[count] = x;
            passed.depth[count] = depth;
            count += depthPasses(depth, m_samples.depth[at], compare) ? 1 : 0;
        }
        passed.count = static_cast<int>(count);
    }

    /// Counts the samples of the batch, writes the depths of those that pass and keeps these alone.
    template <DepthCompare compare>
    void testBatch()
    {
        const SampleBuffer target = m_samples; // no write to a plane can change a copy
        GouraudBatch& batch = m_batch;
        const std::size_t count = batch.count;
        std::size_t passed = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t at = target.index(batch.x[i], batch.y[i]);
            const float depth = batch.depth[i];
            const float stored = target.depth[at];
            const bool passes = depthPasses(depth, stored, compare);
            target.depth[at] = passes ? depth : stored;
            batch.x[passed] = batch.x[i];
            batch.y[passed] = batch.y[i];
            batch.at[passed] = at;
            passed += passes ? 1 : 0;
            if (target.coverage != nullptr && target.coverage[at] != 0xffff)
                ++target.coverage[at];
        }
        batch.count = passed;
    }

    template <class Sample>
    [[gnu::always_inline]] void process(int x, int y, const Sample& sample)
    {
        const std::size_t at = m_samples.index(x, y);
        if (m_samples.coverage != nullptr && m_samples.coverage[at] != 0xffff)
            ++m_samples.coverage[at];
        const float depth = m_readsDepth ? storedDepth(sample.depth(), m_store) : 0;
        const float stored = m_samples.depth == nullptr ? m_rules->depthClear
                             : m_rules->depthInLockstep ? m_lockstep.read(at, m_samples.depth[at])
                                                        : m_samples.depth[at];
        const bool passed = !m_rules->depthTested || depthPasses(depth, stored, m_compare);
        const bool shaded = m_samples.color != nullptr && (passed || !m_rules->depthBeforeShading);
        std::uint32_t color = 0;
        if constexpr (kReadsFragments<Observer>)
            color = shadeObserved(x, y, sample, depth, stored, passed, shaded);
        else if (shaded)
            color = shade(sample, depth);
        if (passed)
            write(x, y, at, color, depth);
        else if (m_rules->depthWrittenOnFail)
            m_samples.depth[at] = depth;
    }

    template <class Sample>
    [[gnu::always_inline]] std::uint32_t shade(const Sample& sample, float depth) const
    {
        if (!m_readsAttributes)
            return m_rules->shading == Shading::Depth ? packColor(glm::vec3(depth)) : m_uniforms.color;
        const Weights screen = sample.screen();
        const Weights weights = sample.weighted(screen);
        if (m_rules->shading == Shading::Gouraud)
            return packColor({m_interpolation->varying(0, weights), m_interpolation->varying(1, weights),
                              m_interpolation->varying(2, weights)});
        Varyings varyings;
        return shadeVaryings(screen, weights, depth, varyings);
    }

    /// Shades, and tells the observer all numbers of the fragment.
    template <class Sample>
    std::uint32_t shadeObserved(int x, int y, const Sample& sample, float depth, float stored, bool passed, bool shaded)
    {
        Fragment fragment;
        fragment.x = x;
        fragment.y = y;
        fragment.face = m_interpolation->triangle().face;
        fragment.depth = depth;
        fragment.screen = sample.screen();
        std::uint32_t color = 0;
        if (shaded) {
            fragment.weights = sample.weighted(fragment.screen);
            color = shadeVaryings(fragment.screen, fragment.weights, depth, fragment.varyings);
        }
        m_observer->onFragment(fragment, stored, passed);
        if (shaded)
            m_observer->onShade(fragment, color);
        return color;
    }

    /// The colour, and the varyings it is made of. Weights are copied, so that the loops can keep theirs in registers.
    [[gnu::noinline]] std::uint32_t shadeVaryings(Weights screen, Weights weights, float depth,
                                                  Varyings& varyings) const
    {
        m_interpolation->varyings(weights, varyings);
        UvGradient gradient;
        if (needsUvGradient(*m_rules, m_uniforms))
            gradient = m_interpolation->uvGradient(screen, weights, kVaryingUv);
        if (m_takesOtherTexels)
            takeOtherTexels(*m_interpolation, *m_rules, screen, varyings, gradient);
        return shadeFragment(*m_rules, m_uniforms, varyings, depth, m_eyeWorld, gradient);
    }

    void write(int x, int y, std::size_t at, std::uint32_t color, float depth)
    {
        const bool writesDepth = m_samples.depth != nullptr;
        const bool writesColor = m_samples.color != nullptr;
        const Pixel before{writesColor ? m_samples.color[at] : 0,
                           writesDepth ? m_samples.depth[at] : m_rules->depthClear};
        if (writesColor)
            m_samples.color[at] = color;
        if (writesDepth)
            m_samples.depth[at] = depth;
        if (m_samples.ids != nullptr)
            m_samples.ids[at] = static_cast<std::int32_t>(m_interpolation->triangle().face);
        m_observer->onWrite(x, y, before, {color, writesDepth ? depth : before.depth});
    }

    const Scene* m_scene;
    const Rules* m_rules;
    SampleBuffer m_samples;
    glm::vec3 m_eyeWorld;
    Observer* m_observer;
    DepthStore m_store;
    DepthCompare m_compare = DepthCompare::Always; ///< of the face that the samples belong to
    LockstepDepths m_lockstep;                     ///< with depthInLockstep
    bool m_readsDepth;
    bool m_readsAttributes;
    bool m_takesOtherTexels;
    bool m_readsUniforms;
    bool m_drawsBatches;
    bool m_testsRowsFirst;                            ///< see drawRow()
    std::optional<FaceInterpolation> m_interpolation; ///< of the triangle the samples belong to
    FaceUniforms m_uniforms;                          ///< of its face
    GouraudBatch m_batch;                             ///< some of its samples
    std::stop_token m_stop;
};

} // namespace rasterlens
