#pragma once
#include "core/base/stopwatch.h"
#include "core/pipeline/fragment_stage.h"
#include "core/pipeline/frame.h"
#include "core/pipeline/framebuffer.h"
#include "core/pipeline/geometry.h"
#include "core/pipeline/multisample_stage.h"
#include "core/pipeline/resolve.h"
#include "core/pipeline/sample_router.h"
#include "core/rasterizers/lines.h"
#include "core/render/list.h"
#include "core/settings/depth_rules.h"

namespace rasterlens
{

/// Finds the samples of a screen triangle and hands them to the stage.
template <class Stage, class Observer>
using Cover = void (*)(const ScreenTriangle&, const Rules&, Stage&, Observer&);

/// Finds the samples of the area, with numbers of type T.
template <class Rasterizer, class T, class Stage, class Observer>
void coverArea(const ScreenTriangle& triangle, const Rules& rules, Stage& stage, Observer& observer)
{
    const std::optional<TriangleSetup<T>> setup = setupTriangle<T>(triangle, rules);
    observer.onSetup(setup);
    if (setup)
        Rasterizer::cover(*setup, triangle, rules, stage, observer);
}

template <class Rasterizer, class Stage, class Observer>
[[nodiscard]] Cover<Stage, Observer> coverWith(NumberType type)
{
    switch (type) {
    case NumberType::Fixed: return coverArea<Rasterizer, std::int64_t, Stage, Observer>;
    case NumberType::Float32: return coverArea<Rasterizer, float, Stage, Observer>;
    case NumberType::Float64: break;
    }
    return coverArea<Rasterizer, double, Stage, Observer>;
}

template <class Stage, class Observer>
[[nodiscard]] Cover<Stage, Observer> coverFor(const Rules& rules);

/// Where not all faces are drawn alike, because two passes are filled in two ways or some faces are lines: finds the
/// samples as the face asks for.
template <class Stage, class Observer>
void coverByPass(const ScreenTriangle& triangle, const Rules& rules, Stage& stage, Observer& observer)
{
    const Rules pass = passRules(rules, triangle.face);
    coverFor<Stage, Observer>(pass)(triangle, pass, stage, observer);
}

/// The way to samples that the rules ask for: lines, corners, or the area by one of the algorithms.
template <class Stage, class Observer>
[[nodiscard]] Cover<Stage, Observer> coverFor(const Rules& rules)
{
    if ((rules.firstPassFaces > 0 && rules.fill != Fill::Solid) || rules.lineFaces)
        return coverByPass<Stage, Observer>;
    switch (rules.fill) {
    case Fill::Wireframe: return drawWireframe<Stage, Observer>;
    case Fill::Points: return drawPoints<Stage, Observer>;
    case Fill::Solid: break;
    }
    if (rules.algorithm == Algorithm::ColumnFill)
        return ColumnFill::cover<Stage, Observer>;
    Cover<Stage, Observer> cover = nullptr;
    forEachTriangleRasterizer([&]<class Rasterizer>(Rasterizer) {
        if (Rasterizer::info.algorithm == rules.algorithm)
            cover = coverWith<Rasterizer, Stage, Observer>(rules.numberType);
    });
    return cover;
}

/// Covers the triangle once for every sample of the pattern, each time moved so that the sample lies at the centre of
/// its pixel: what is right for centres is right for samples.
///
/// exact  in fixed point, where positions are multiples of 1/256 pixel and samples of 1/16
template <class Stage, class Observer>
void coverPattern(ScreenTriangle triangle, const Rules& rules, Cover<Stage, Observer> cover, Stage& stage,
                  Observer& observer)
{
    const std::array<ScreenVertex, 3> vertices = triangle.vertices;
    for (int sample = 0; sample < rules.patternSamples && !isStopped(stage); ++sample) {
        for (std::size_t i = 0; i < 3; ++i)
            triangle.vertices[i].position = vertices[i].position - testedOffset(rules, sample).pixels();
        observer.onPatternSample(sample);
        if constexpr (requires { stage.beginSample(sample); })
            stage.beginSample(sample);
        cover(triangle, rules, stage, observer);
    }
}

template <class Stage, class Observer>
void drawTriangle(const ScreenTriangle& triangle, const Rules& rules, Cover<Stage, Observer> cover, Stage& stage,
                  Observer& observer)
{
    stage.begin(triangle);
    observer.onTriangle(triangle);
    if (rules.multiSampled())
        coverPattern(triangle, rules, cover, stage, observer);
    else
        cover(triangle, rules, stage, observer);
}

/// Adds up where the time of a frame goes.
class StageWatch
{
public:
    /// The time since the last call belongs to this stage.
    void add(double StageTimes::*stage) { m_times.*stage += m_lap.lap(); }

    [[nodiscard]] StageTimes times()
    {
        m_times.total = m_total.lap();
        return m_times;
    }

private:
    Stopwatch m_total;
    Stopwatch m_lap;
    StageTimes m_times;
};

/// The pipeline from clip space to the samples, for the faces in this order. Faces go through geometry in batches, so
/// that the clock is not read for each.
template <class Stage, class Observer>
void drawFaces(const Geometry& geometry, std::span<const std::uint32_t> faces, const Rules& rules, Stage& stage,
               Observer& observer, StageWatch& watch)
{
    const Cover<Stage, Observer> cover = coverFor<Stage, Observer>(rules); // the rasterizer, chosen once
    std::vector<ScreenTriangle> triangles;
    while (!faces.empty() && !stage.stopped()) {
        faces = geometry.processBatch(faces, triangles, observer); // assemble, clip, to the screen, fan, cull
        watch.add(&StageTimes::geometry);
        for (const ScreenTriangle& triangle : triangles) {
            drawTriangle(triangle, rules, cover, stage, observer); // set up, cover; the stage tests, shades and writes
            stage.finish();
        }
        watch.add(&StageTimes::raster);
    }
}

/// Samples become pixels. Where a pixel has several, an observer that listens is told of each.
template <class Observer>
void resolvePicture(Framebuffer& framebuffer, const Rules& rules, Observer& observer)
{
    if constexpr (kReadsResolve<Observer>) {
        if (rules.samplesPerPixel() > 1) {
            framebuffer.resolve([&](const ResolvedPixel& pixel) { observer.onResolve(pixel); });
            return;
        }
    }
    framebuffer.resolve();
}

/// One frame, all stages in order; the observer is told everything.
///
/// in   what the settings resolve to for this scene
template <class Observer>
void drawScene(const Scene& scene, const Resolved& resolved, Frame& frame, Outputs outputs, Observer& observer,
               const std::stop_token& stop)
{
    const Rules& rules = resolved.rules;
    const Matrices& matrices = resolved.matrices;
    StageWatch watch;
    Framebuffer framebuffer(frame, rules, outputs, packColor(scene.background), stop);
    watch.add(&StageTimes::raster);

    const Geometry geometry(scene, matrices, rules); // every vertex once
    const std::vector<std::uint32_t> order = geometry.order();
    watch.add(&StageTimes::vertex);

    const auto drawInto = [&]<class Stage>(Stage stage) {
        stage.stopBy(stop);
        drawFaces(geometry, order, rules, stage, observer, watch);
    };
    const glm::vec3 eye(matrices.eyeObject);
    if (rules.multiSampled())
        drawInto(MultisampleStage<Observer>(scene, rules, framebuffer.samples(), eye, observer));
    else if (SampleRouter<Observer>::wanted(rules))
        drawInto(SampleRouter<Observer>(scene, rules, framebuffer.samples(), eye, observer));
    else
        drawInto(FragmentStage<Observer>(scene, rules, framebuffer.samples(), eye, observer));

    if (!stop.stop_requested())
        resolvePicture(framebuffer, rules, observer);
    watch.add(&StageTimes::raster);
    frame.times = watch.times();
}

} // namespace rasterlens
