#include "core/render/render.h"

#include "core/observe/counting_observer.h"
#include "core/render/draw.h"
#include "core/render/render_resolved.h"
#include "core/settings/mistakes.h"

#include <utility>

namespace rasterlens
{
namespace
{

/// 2 GiB of colour and depth: the largest viewport with one sample a pixel.
constexpr std::int64_t kMaxSamples = std::int64_t(kMaxViewport) * kMaxViewport;

} // namespace

std::optional<Reason> unsupported(const Scene& scene, const Settings& settings)
{
    return unsupported(scene, settings, resolve(settings, scene));
}

std::optional<Reason> unsupported(const Scene& scene, const Settings& settings, const Resolved& resolved)
{
    if (settings.cullSpace == CullSpace::View && scene.space == SceneSpace::Clip)
        return Reason{QT_TRANSLATE_NOOP(
            "Unsupported", "cull-space view needs object-space positions; this scene is given in clip space")};
    const std::int64_t grid = sampleGrid(settings.samples);
    if (std::int64_t(settings.size.width()) * settings.size.height() * grid * grid > kMaxSamples)
        return Reason{
            QT_TRANSLATE_NOOP("Unsupported", "%1x%2 pixels with %3 samples each need more than %4 million samples"),
            {QString::number(settings.size.width()), QString::number(settings.size.height()),
             QString::number(grid * grid), QString::number(kMaxSamples / 1000000)}};
    for (const QString& id : settings.mistakes)
        if (findMistake(id) == nullptr)
            return Reason{QT_TRANSLATE_NOOP("Unsupported", "there is no mistake \"%1\"; \"rasterlens-cli render "
                                                           "--list-mistakes\" lists those there are"),
                          {id}};
    if (settings.algorithm == Algorithm::Tiled)
        if (auto reason = Tiled::supports(settings))
            return reason;
    return rasterizerSupports(resolved.rules);
}

Settings withoutAuto(const Settings& settings)
{
    Settings actual = settings;
    actual.threads = Tiled::threads(settings);
    actual.simd = Tiled::simd(settings);
    return actual;
}

std::optional<Settings> fastSettings(const Scene& scene, const Settings& settings)
{
    Settings fast = settings;
    fast.algorithm = Algorithm::Tiled;
    if (fast == settings || unsupported(scene, fast))
        return std::nullopt;
    return fast;
}

Settings withWorkers(Settings settings)
{
    if (settings.algorithm == Algorithm::Tiled)
        return withoutAuto(settings);
    settings.threads = 1;
    settings.simd = Simd::Scalar;
    return settings;
}

void render(const Scene& scene, const Settings& settings, Frame& frame, Outputs outputs, std::stop_token stop)
{
    const Resolved resolved = resolve(settings, scene);
    if (settings.algorithm == Algorithm::Tiled) {
        Tiled::draw(scene, settings, resolved, frame, outputs, nullptr, stop);
        return;
    }
    NullObserver observer;
    drawScene(scene, resolved, frame, outputs, observer, stop);
}

Statistics renderCounted(const Scene& scene, const Settings& settings, Frame& frame, Outputs outputs,
                         std::stop_token stop)
{
    return renderCounted(scene, settings, resolve(settings, scene), frame, outputs, std::move(stop));
}

Statistics renderCounted(const Scene& scene, const Settings& settings, const Resolved& resolved, Frame& frame,
                         Outputs outputs, std::stop_token stop)
{
    if (settings.algorithm == Algorithm::Tiled) {
        Statistics statistics;
        Tiled::draw(scene, settings, resolved, frame, outputs, &statistics, stop);
        return statistics;
    }
    CountingObserver observer(resolved.rules);
    drawScene(scene, resolved, frame, outputs, observer, stop);
    return observer.statistics();
}

} // namespace rasterlens
