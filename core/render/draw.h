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

/// Finds the samples of a screen triangle with the algorithm and the number type of the rules.
template <class T, class Stage, class Observer>
void coverTriangle(const ScreenTriangle& triangle, const FaceInterpolation& interpolation, const Rules& rules,
                   Stage& stage, Observer& observer)
{
    const std::optional<TriangleSetup<T>> setup = setupTriangle<T>(triangle, rules);
    observer.onSetup(setup);
    if (!setup)
        return;
    forEachTriangleRasterizer([&](auto rasterizer) {
        if (rasterizer.info.algorithm == rules.algorithm)
            rasterizer.cover(*setup, interpolation, rules, stage, observer);
    });
}

template <class Stage, class Observer>
void drawTriangle(const Scene& scene, const ScreenTriangle& triangle, const Rules& rules, Stage& stage,
                  Observer& observer)
{
    const auto& [a, b, c] = triangle.vertices;
    const double area2 = twiceArea(a.position, b.position, c.position);
    const FaceInterpolation interpolation(triangle, area2, rules);
    const FaceUniforms uniforms = faceUniforms(scene, triangle.face, rules.shading);
    stage.begin(interpolation, uniforms);
    observer.onTriangle(triangle);
    switch (rules.fill) {
    case Fill::Wireframe: drawWireframe(triangle, rules, stage, observer); return;
    case Fill::Points: drawPoints(triangle, stage); return;
    case Fill::Solid: break;
    }
    switch (rules.numberType) {
    case NumberType::Fixed: coverTriangle<std::int64_t>(triangle, interpolation, rules, stage, observer); break;
    case NumberType::Float32: coverTriangle<float>(triangle, interpolation, rules, stage, observer); break;
    case NumberType::Float64: coverTriangle<double>(triangle, interpolation, rules, stage, observer); break;
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
    std::vector<std::uint32_t> order = geometry.order();
    times.vertex += watch.lap();

    FragmentStage<Observer> stage(rules, framebuffer.samples(), glm::vec3(matrices.eyeObject), observer);
    SampleRouter<Observer> router(scene, rules, framebuffer.samples(), glm::vec3(matrices.eyeObject), observer);
    stage.stopBy(stop);
    router.stopBy(stop);
    const bool routed = SampleRouter<Observer>::wanted(rules);
    std::vector<ScreenTriangle> batch;
    for (std::size_t i = 0; i < order.size() && !stop.stop_requested();) {
        batch.clear();
        for (int k = 0; k < Observer::kFacesPerBatch && i < order.size(); ++k, ++i) {
            const FaceFate fate = geometry.process(order[i], batch, observer);
            if (fate == FaceFate::Rejected && !rules.continuesAfterReject)
                order.resize(i + 1);
        }
        times.geometry += watch.lap();
        for (ScreenTriangle& triangle : batch) {
            if (rules.cornerData != CornerData::Own)
                triangle = withCornerData(triangle, rules.cornerData);
            if (routed) {
                drawTriangle(scene, triangle, rules, router, observer);
                router.finish();
            } else {
                drawTriangle(scene, triangle, rules, stage, observer);
            }
        }
        times.raster += watch.lap();
    }
    if (!stop.stop_requested())
        framebuffer.resolve();
    times.raster += watch.lap();
    times.total = total.lap();
    frame.times = times;
}

} // namespace rasterlens
