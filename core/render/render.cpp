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

/// Why these rules cannot be drawn with multi-sampling, whatever finds the covered samples.
std::optional<Reason> patternSupports(const Rules& rules)
{
    if (!rules.multiSampled())
        return std::nullopt;
    if (rules.fill != Fill::Solid)
        return Reason{QT_TRANSLATE_NOOP("Unsupported", "samples msaa2 to msaa16 need fill solid: lines and points go "
                                                       "from sample to sample of a grid, and a pattern has none")};
    if (rules.lineFaces)
        return Reason{QT_TRANSLATE_NOOP("Unsupported",
                                        "samples msaa2 to msaa16 do not go with the lines of this scene: "
                                        "lines go from sample to sample of a grid, and a pattern has "
                                        "none")};
    if (rules.algorithm == Algorithm::ColumnFill)
        return Reason{QT_TRANSLATE_NOOP("Unsupported",
                                        "samples msaa2 to msaa16 need an algorithm that goes by centres; "
                                        "column-fill goes by the grid points of the corners")};
    if (rules.attributePath == AttributePath::EdgeThenSpan)
        return Reason{QT_TRANSLATE_NOOP("Unsupported", "samples msaa2 to msaa16 need attribute-path planes: a pixel is "
                                                       "shaded once, and no span leads there")};
    if (rules.depthPerPixel || rules.strideIsRows || rules.positionInterpolated || rules.bounds == Bounds::Unclamped)
        return Reason{QT_TRANSLATE_NOOP("Unsupported", "samples msaa2 to msaa16 do not go with a mistake about where "
                                                       "samples are stored")};
    return std::nullopt;
}

/// Why these rules cannot share divisions by w among the samples of a span.
std::optional<Reason> sharedDivisionSupports(const Rules& rules)
{
    if (rules.dividedEvery == 1 || (rules.algorithm == Algorithm::EdgeWalking && rules.fill == Fill::Solid &&
                                    rules.attributePath == AttributePath::EdgeThenSpan))
        return std::nullopt;
    return Reason{QT_TRANSLATE_NOOP("Unsupported", "interpolation every-8 and every-16 divide along spans: they need "
                                                   "algorithm edge-walking, fill solid and attribute-path "
                                                   "edge-then-span")};
}

/// Why these rules cannot ask for the squares of pixels.
std::optional<Reason> coverageRuleSupports(const Scene& scene, const Rules& rules)
{
    if (rules.coverageRule == CoverageRule::Centre)
        return std::nullopt;
    if (rules.algorithm != Algorithm::EdgeEquation || rules.fill != Fill::Solid)
        return Reason{QT_TRANSLATE_NOOP("Unsupported", "coverage-rule conservative and inner ask the corners of every "
                                                       "pixel: they need algorithm edge-equation and fill solid")};
    if (rules.numberType != NumberType::Fixed || scene.exact)
        return Reason{QT_TRANSLATE_NOOP("Unsupported", "coverage-rule conservative and inner need number-type fixed "
                                                       "and corners that snap: rounding may not touch a square")};
    if (rules.samplesPerPixel() > 1)
        return Reason{QT_TRANSLATE_NOOP("Unsupported", "coverage-rule conservative and inner are about whole pixels: "
                                                       "they need samples 1")};
    return std::nullopt;
}

/// With one sample a pixel the counts of samples are those of pixels.
void drawTiled(const Scene& scene, const Settings& settings, const Resolved& resolved, Frame& frame, Outputs outputs,
               Statistics* statistics, const std::stop_token& stop)
{
    if (resolved.rules.multiSampled()) {
        Tiled::draw(scene, settings, resolved, frame, outputs, statistics, stop);
        return;
    }
    Outputs asked = outputs;
    asked.sampleCoverage = false;
    asked.coverage = outputs.coverage || outputs.sampleCoverage;
    Tiled::draw(scene, settings, resolved, frame, asked, statistics, stop);
    frame.sampleCoverage.clear();
    if (outputs.sampleCoverage)
        frame.sampleCoverage = outputs.coverage ? frame.coverage : std::exchange(frame.coverage, {});
}

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
    const std::int64_t samples = samplesPerPixel(settings.samples);
    if (std::int64_t(settings.size.width()) * settings.size.height() * samples > kMaxSamples)
        return Reason{
            QT_TRANSLATE_NOOP("Unsupported", "%1x%2 pixels with %3 samples each need more than %4 million samples"),
            {QString::number(settings.size.width()), QString::number(settings.size.height()), QString::number(samples),
             QString::number(kMaxSamples / 1000000)}};
    for (const QString& id : settings.mistakes)
        if (findMistake(id) == nullptr)
            return Reason{QT_TRANSLATE_NOOP("Unsupported", "there is no mistake \"%1\"; \"rasterlens-cli render "
                                                           "--list-mistakes\" lists those there are"),
                          {id}};
    if (resolved.rules.lineFaces && resolved.rules.clipping == Clipping::CohenSutherland)
        return Reason{QT_TRANSLATE_NOOP("Unsupported",
                                        "clipping cohen-sutherland here joins the outlines of faces, and "
                                        "this scene has lines; clipping frustum and guard-band cut them")};
    if (auto reason = coverageRuleSupports(scene, resolved.rules))
        return reason;
    if (auto reason = sharedDivisionSupports(resolved.rules))
        return reason;
    if (settings.algorithm == Algorithm::Tiled)
        if (auto reason = Tiled::supports(settings))
            return reason;
    if (auto reason = rasterizerSupports(resolved.rules))
        return reason;
    return patternSupports(resolved.rules);
}

std::optional<Reason> unsupportedOutputs(const Settings& settings, Outputs outputs)
{
    if (outputs.sampleCoverage && settings.algorithm == Algorithm::Tiled && sampleGrid(settings.samples) > 1)
        return Reason{QT_TRANSLATE_NOOP("Unsupported", "algorithm tiled keeps no counts of the samples of a grid; it "
                                                       "does of one sample a pixel, and of msaa2 to msaa16")};
    return std::nullopt;
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
        drawTiled(scene, settings, resolved, frame, outputs, nullptr, stop);
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
        drawTiled(scene, settings, resolved, frame, outputs, &statistics, stop);
        return statistics;
    }
    CountingObserver observer(resolved.rules);
    drawScene(scene, resolved, frame, outputs, observer, stop);
    return observer.statistics();
}

} // namespace rasterlens
