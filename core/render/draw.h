#pragma once
#include "core/base/stopwatch.h"
#include "core/pipeline/fragment_stage.h"
#include "core/pipeline/frame.h"
#include "core/pipeline/framebuffer.h"
#include "core/pipeline/geometry.h"
#include "core/pipeline/rules_for.h"
#include "core/pipeline/sample_router.h"
#include "core/rasterizers/lines.h"
#include "core/render/list.h"
#include "core/scene/camera.h"

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

/// The way to samples that the rules ask for: lines, corners, or the area by one of the algorithms.
template <class Stage, class Observer>
[[nodiscard]] Cover<Stage, Observer> coverFor(const Rules& rules)
{
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

template <class Stage, class Observer>
void drawTriangle(const ScreenTriangle& triangle, const Rules& rules, Cover<Stage, Observer> cover, Stage& stage,
                  Observer& observer)
{
    stage.begin(triangle);
    observer.onTriangle(triangle);
    cover(triangle, rules, stage, observer);
}

/// Draws the faces in this order, from clip space to the samples.
template <class Stage, class Observer>
void drawFaces(const Geometry& geometry, std::span<const std::uint32_t> faces, const Rules& rules, Stage& stage,
               Observer& observer, StageTimes& times)
{
    const Cover<Stage, Observer> cover = coverFor<Stage, Observer>(rules);
    std::vector<ScreenTriangle> triangles;
    Stopwatch watch;
    while (!faces.empty() && !stage.stopped()) {
        faces = geometry.processBatch(faces, triangles, observer); // clip, to the screen, cull
        times.geometry += watch.lap();
        for (const ScreenTriangle& triangle : triangles) {
            drawTriangle(triangle, rules, cover, stage, observer); // set up, cover; the stage shades and writes
            stage.finish();
        }
        times.raster += watch.lap();
    }
}

/// One frame, all stages in order; the observer is told everything.
template <class Observer>
void drawScene(const Scene& scene, const Settings& settings, Frame& frame, Outputs outputs, Observer& observer,
               const std::stop_token& stop)
{
    Stopwatch total;
    Stopwatch watch;
    StageTimes times;
    const Rules rules = rulesFor(scene, settings);
    const Matrices matrices = cameraMatrices(scene, settings);
    Framebuffer framebuffer(frame, rules, outputs, packColor(scene.background), stop);
    times.raster += watch.lap();

    const Geometry geometry(scene, matrices, rules);
    const std::vector<std::uint32_t> order = geometry.order();
    times.vertex += watch.lap();

    const auto drawInto = [&]<class Stage>(Stage stage) {
        stage.stopBy(stop);
        drawFaces(geometry, order, rules, stage, observer, times);
    };
    const glm::vec3 eye(matrices.eyeObject);
    if (SampleRouter<Observer>::wanted(rules))
        drawInto(SampleRouter<Observer>(scene, rules, framebuffer.samples(), eye, observer));
    else
        drawInto(FragmentStage<Observer>(scene, rules, framebuffer.samples(), eye, observer));
    watch.lap();
    if (!stop.stop_requested())
        framebuffer.resolve();
    times.raster += watch.lap();
    times.total = total.lap();
    frame.times = times;
}

} // namespace rasterlens
