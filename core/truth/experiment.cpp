#include "core/truth/experiment.h"

#include "core/render/render.h"
#include "core/truth/coverage_difference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace rasterlens
{
namespace
{

constexpr int kWarmUpFrames = 1;
constexpr Outputs kEverything{.depth = true, .ids = true, .coverage = true};

/// in  sorted, not empty
double quantile(const std::vector<double>& sorted, double q)
{
    const double at = q * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(at);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return std::lerp(sorted[below], sorted[above], at - static_cast<double>(below));
}

FrameTimes summary(const std::vector<double>& sorted)
{
    return {quantile(sorted, 0.5), quantile(sorted, 0.1), quantile(sorted, 0.9), sorted.front(),
            static_cast<int>(sorted.size())};
}

VariantError errorFigures(const CoverageDifference& difference, const Settings& settings, bool depthTested)
{
    VariantError error;
    if (settings.fill != Fill::Solid)
        return error;
    error.coverage = {difference.missing, difference.extra, difference.hitTwice};
    if (depthTested)
        error.depth = {difference.depthMax, difference.depthMean};
    if (settings.shading == Shading::Gouraud)
        error.color = {difference.colorMax, difference.colorMean, difference.psnrDb};
    return error;
}

/// The variants that are measured, their frames and times.
class Experiment
{
public:
    Experiment(const Scene& scene, const Settings& base, std::span<const Variant* const> variants,
               const ExperimentOptions& options, const std::function<void(const ExperimentProgress&)>& progress,
               std::stop_token stop)
        : m_scene(scene), m_base(base), m_options(options), m_progress(progress), m_stop(std::move(stop)),
          m_times(variants.size())
    {
        for (const Variant* variant : variants)
            addRow(*variant);
        m_total = static_cast<int>(m_rows.size()) * (options.frames + kWarmUpFrames);
        if (options.reference)
            for (const ExperimentRow& row : m_rows)
                m_total += static_cast<int>(bandsOf(exactOptions(m_scene, row.settings)).size());
    }

    std::vector<ExperimentRow> run()
    {
        if (m_options.reference)
            for (int samples = 0; samples <= static_cast<int>(Samples::Msaa16); ++samples)
                measureErrors(static_cast<Samples>(samples));
        measureTimes();
        return std::move(m_rows);
    }

private:
    void addRow(const Variant& variant)
    {
        ExperimentRow row;
        row.scene = m_scene.id;
        row.variant = QLatin1String(variant.id);
        row.settings = settingsOf(variant, m_base);
        const Settings drawnWith = withWorkers(row.settings);
        row.threads = drawnWith.threads;
        row.simd = drawnWith.simd;
        if (m_options.reference)
            row.reference = referenceSpace(m_scene, m_options.space);
        m_rows.push_back(std::move(row));
    }

    /// Variants share frames, hence memory; but threads live in them.
    Frame& frameOf(const ExperimentRow& row) { return m_frames[{row.settings.algorithm, row.threads}]; }

    void measureErrors(Samples samples)
    {
        std::vector<std::size_t> members;
        for (std::size_t i = 0; i < m_rows.size(); ++i)
            if (m_rows[i].settings.samples == samples)
                members.push_back(i);
        if (members.empty())
            return;

        Settings wanted = m_base;
        wanted.samples = samples;
        wanted.depthFormat = DepthFormat::Float32;
        const ReferenceSpace space = referenceSpace(m_scene, m_options.space);
        const std::vector<ClipTriangle> triangles = exactTriangles(m_scene, wanted, space);
        ExactOptions exact = exactOptions(m_scene, wanted, space);
        std::vector<CoverageDifference> sums(members.size());
        const std::vector<PixelRect> bands = bandsOf(exact);
        for (std::size_t band = 0; band < bands.size() && !m_stop.stop_requested(); ++band) {
            exact.window = bands[band];
            const ExactFrame truth = exactReference(triangles, exact, m_stop);
            if (m_stop.stop_requested())
                return;
            for (std::size_t k = 0; k < members.size(); ++k) {
                ExperimentRow& row = m_rows[members[k]];
                Frame& frame = frameOf(row);
                Settings whole = row.settings; // the truth knows faces without their holes
                whole.alphaTest = AlphaTest::Off;
                render(m_scene, whole, frame, kEverything, m_stop);
                if (m_stop.stop_requested())
                    return;
                const CoverageDifference part = coverageDifference(frame, truth, m_scene.background);
                sums[k] = band == 0 ? part : joined(sums[k], part);
                if (band + 1 == bands.size())
                    row.error = errorFigures(sums[k], row.settings, exact.depthTested);
                step(members[k]);
            }
        }
    }

    void measureTimes()
    {
        const double covered = static_cast<double>(coveredPixels());
        for (int frame = -kWarmUpFrames; frame < m_options.frames; ++frame)
            for (std::size_t i = 0; i < m_rows.size() && !m_stop.stop_requested(); ++i) {
                ExperimentRow& row = m_rows[i];
                Frame& target = frameOf(row);
                render(m_scene, row.settings, target, {}, m_stop);
                if (m_stop.stop_requested())
                    return;
                if (frame >= 0)
                    addTime(i, target.times.total, covered);
                step(i);
            }
    }

    /// What every variant of the scene is divided by.
    std::uint64_t coveredPixels()
    {
        Frame frame;
        return renderCounted(m_scene, settingsOf(variants().front(), m_base), frame, {}, m_stop).pixels.covered;
    }

    void addTime(std::size_t i, double ms, double covered)
    {
        ExperimentRow& row = m_rows[i];
        std::vector<double>& times = m_times[i];
        times.insert(std::upper_bound(times.begin(), times.end(), ms), ms);
        row.ms = summary(times);
        constexpr double kNsPerMs = 1e6;
        row.nsPerCoveredPixel = covered > 0 ? row.ms.median * kNsPerMs / covered : 0;
        row.mtriPerS = static_cast<double>(m_scene.mesh.faceCount()) / row.ms.median / 1000;
    }

    void step(std::size_t changed)
    {
        ++m_done;
        if (m_progress)
            m_progress({m_done, m_total, m_rows, changed});
    }

    const Scene& m_scene;
    const Settings& m_base;
    const ExperimentOptions& m_options;
    const std::function<void(const ExperimentProgress&)>& m_progress;
    std::stop_token m_stop;
    std::vector<ExperimentRow> m_rows;
    std::vector<std::vector<double>> m_times; // sorted
    std::map<std::pair<Algorithm, int>, Frame> m_frames;
    int m_done = 0;
    int m_total = 0;
};

constexpr std::array<ErrorMeasureInfo, kErrorMeasures> kMeasures{{
    {"coverage", QT_TRANSLATE_NOOP("Experiment", "wrong pixels: missing, extra or hit twice")},
    {"depth", QT_TRANSLATE_NOOP("Experiment", "largest depth error, range 0 to 1")},
    {"color", QT_TRANSLATE_NOOP("Experiment", "colour error, root mean square, 8-bit steps")},
}};

} // namespace

std::vector<ExperimentRow> runExperiment(const Scene& scene, const Settings& base,
                                         std::span<const Variant* const> variants, const ExperimentOptions& options,
                                         const std::function<void(const ExperimentProgress&)>& progress,
                                         std::stop_token stop)
{
    return Experiment(scene, base, variants, options, progress, std::move(stop)).run();
}

const char* idOf(ReferenceSpace space) { return space == ReferenceSpace::Object ? "exact-object" : "exact"; }

const ErrorMeasureInfo& infoOf(ErrorMeasure measure) { return kMeasures[static_cast<std::size_t>(measure)]; }

std::optional<double> errorOf(const ExperimentRow& row, ErrorMeasure measure)
{
    const VariantError& error = row.error;
    switch (measure) {
    case ErrorMeasure::Coverage:
        if (error.coverage)
            return static_cast<double>(error.coverage->wrong());
        break;
    case ErrorMeasure::Depth:
        if (error.depth)
            return error.depth->max;
        break;
    case ErrorMeasure::Color:
        if (error.color)
            return 255 * std::pow(10, -error.color->psnrDb / 20);
        break;
    }
    return std::nullopt;
}

void markFrontier(std::span<ExperimentRow> rows, ErrorMeasure measure)
{
    const auto beats = [&](const ExperimentRow& a, const ExperimentRow& b) {
        const auto errorA = errorOf(a, measure);
        if (a.scene != b.scene || a.ms.frames == 0 || !errorA)
            return false;
        const double errorB = *errorOf(b, measure);
        return a.ms.median <= b.ms.median && *errorA <= errorB && (a.ms.median < b.ms.median || *errorA < errorB);
    };
    for (ExperimentRow& row : rows)
        row.frontier =
            row.ms.frames > 0 && errorOf(row, measure) &&
            std::none_of(rows.begin(), rows.end(), [&](const ExperimentRow& other) { return beats(other, row); });
}

std::optional<TimeRatio> walkingAdvantage(std::span<const ExperimentRow> rows)
{
    const auto timesOf = [&](const char* id) -> const FrameTimes* {
        const auto row = std::find_if(rows.begin(), rows.end(), [&](const ExperimentRow& r) {
            return r.variant == QLatin1String(id) && r.ms.frames > 0;
        });
        return row == rows.end() || !(row->ms.p10 > 0) ? nullptr : &row->ms;
    };
    const FrameTimes* equation = timesOf("edge-equation");
    const FrameTimes* walking = timesOf("edge-walking");
    if (equation == nullptr || walking == nullptr)
        return std::nullopt;
    return TimeRatio{equation->median / walking->median, equation->p10 / walking->p90, equation->p90 / walking->p10};
}

} // namespace rasterlens
