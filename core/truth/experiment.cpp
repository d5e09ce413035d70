#include "core/truth/experiment.h"

#include "core/render/render.h"
#include "core/truth/coverage_difference.h"
#include "core/truth/exact_texels.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <ctime>
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

double medianOf(std::vector<double> values)
{
    std::ranges::sort(values);
    return quantile(values, 0.5);
}

/// Milliseconds of a frame, by the clock and by the processor.
struct Timing {
    double clock;
    double processor;
};

/// Measures a piece of work.
class WorkTimer
{
public:
    /// in  alone: no other thread works on it, so that what other threads do meanwhile is not counted
    explicit WorkTimer(bool alone)
        : m_processor(alone ? CLOCK_THREAD_CPUTIME_ID : CLOCK_PROCESS_CPUTIME_ID), m_processorStart(processorTime())
    {
    }

    [[nodiscard]] Timing elapsed(int frames) const
    {
        const std::chrono::duration<double, std::milli> clock = std::chrono::steady_clock::now() - m_start;
        return {clock.count() / frames, (processorTime() - m_processorStart) / frames};
    }

private:
    [[nodiscard]] double processorTime() const
    {
        timespec time{};
        clock_gettime(m_processor, &time);
        return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) * 1e-6;
    }

    clockid_t m_processor;
    double m_processorStart;
    std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
};

VariantError errorFigures(const CoverageDifference& difference, const Settings& settings, bool depthTested)
{
    VariantError error;
    if (settings.fill != Fill::Solid)
        return error;
    error.coverage = {difference.missing, difference.extra, difference.hitTwice};
    if (depthTested)
        error.depth = {difference.depthMax, difference.depthMean};
    if (settings.shading == Shading::Gouraud || settings.shading == Shading::Texture)
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
        : m_scene(scene), m_base(base), m_options(options), m_progress(progress), m_stop(std::move(stop))
    {
        for (const Variant* variant : variants)
            addRow(*variant);
        if (options.others)
            addOthers(options.others());
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
    /// What is measured of a variant besides its row.
    struct Measured {
        OtherRenderer* other = nullptr; ///< null: it is ours
        std::vector<double> processor;  ///< milliseconds a frame, round by round
    };

    void addRow(const Variant& variant)
    {
        ExperimentRow row;
        row.variant = QLatin1String(variant.id);
        row.settings = settingsOf(variant, m_base);
        const Settings drawnWith = withWorkers(row.settings);
        row.threads = drawnWith.threads;
        row.simd = drawnWith.simd;
        addRow(std::move(row), nullptr);
    }

    void addRow(ExperimentRow row, OtherRenderer* other)
    {
        row.scene = m_scene.id;
        if (m_options.reference)
            row.reference = referenceSpace(m_scene, m_options.space);
        m_rows.push_back(std::move(row));
        m_measured.push_back({other, {}});
    }

    void addOthers(OtherRenderers found)
    {
        const Settings settings = settingsOf(variants().front(), m_base);
        for (std::unique_ptr<OtherRenderer>& other : found.renderers) {
            if (const auto reason = other->unsupported(m_scene, settings)) {
                if (m_options.refused)
                    m_options.refused(other->id(), *reason);
                continue;
            }
            ExperimentRow row;
            row.variant = other->id();
            row.settings = settings;
            row.other = {other->name(), traitsOf(*other)};
            addRow(std::move(row), other.get());
            m_others.push_back(std::move(other));
        }
    }

    /// Variants share frames, hence memory; but threads live in them.
    Frame& frameOf(std::size_t i)
    {
        if (m_measured[i].other != nullptr)
            return m_otherFrame;
        return m_frames[{m_rows[i].settings.algorithm, m_rows[i].threads}];
    }

    /// Draws everything that errors are measured of.
    void drawJudged(std::size_t i)
    {
        if (OtherRenderer* other = m_measured[i].other) {
            other->load(m_scene, m_rows[i].settings);
            other->draw(m_otherFrame, kEverything);
            return;
        }
        Settings whole = m_rows[i].settings; // the truth knows faces without their holes
        whole.alphaTest = AlphaTest::Off;
        render(m_scene, whole, frameOf(i), kEverything, m_stop);
    }

    void drawTimed(std::size_t i)
    {
        if (OtherRenderer* other = m_measured[i].other)
            other->draw(m_otherFrame, {});
        else
            render(m_scene, m_rows[i].settings, frameOf(i), {}, m_stop);
    }

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
        exact.textured = wanted.shading == Shading::Texture;
        std::vector<CoverageDifference> sums(members.size());
        const std::vector<PixelRect> bands = bandsOf(exact);
        for (std::size_t band = 0; band < bands.size() && !m_stop.stop_requested(); ++band) {
            exact.window = bands[band];
            ExactFrame truth = exactReference(triangles, exact, m_stop);
            if (m_stop.stop_requested())
                return;
            if (exact.textured)
                textureExactly(m_scene, wanted, truth, space);
            for (std::size_t k = 0; k < members.size(); ++k) {
                drawJudged(members[k]);
                if (m_stop.stop_requested())
                    return;
                const CoverageDifference part = coverageDifference(frameOf(members[k]), truth, m_scene.background);
                sums[k] = band == 0 ? part : joined(sums[k], part);
                ExperimentRow& row = m_rows[members[k]];
                if (band + 1 == bands.size())
                    row.error = errorFigures(sums[k], row.settings, exact.depthTested);
                step(members[k]);
            }
        }
    }

    void measureTimes()
    {
        m_covered = static_cast<double>(coveredPixels());
        for (std::size_t i = 0; i < m_rows.size(); ++i)
            if (OtherRenderer* other = m_measured[i].other)
                other->load(m_scene, m_rows[i].settings);
        for (int round = -kWarmUpFrames; round < m_options.frames; ++round)
            for (std::size_t place = 0; place < m_rows.size(); ++place) {
                const std::size_t i = round % 2 == 0 ? place : m_rows.size() - 1 - place;
                const Timing timing = timed(i, m_rows[i].ms.batch);
                if (m_stop.stop_requested())
                    return;
                if (round < 0)
                    chooseBatch(i, timing);
                else
                    addTiming(i, timing);
                step(i);
            }
    }

    [[nodiscard]] Timing timed(std::size_t i, int frames)
    {
        const WorkTimer timer(m_rows[i].threads == 1 && m_measured[i].other == nullptr);
        for (int frame = 0; frame < frames && !m_stop.stop_requested(); ++frame)
            drawTimed(i);
        return timer.elapsed(frames);
    }

    /// How many frames make a timing. The first frame of all is no measure for that: it is the slowest.
    void chooseBatch(std::size_t i, const Timing& first)
    {
        if (first.clock >= 4 * kShortestTiming)
            return;
        m_rows[i].ms.batch = batchOf(timed(i, 1).clock);
    }

    /// What every variant of the scene is divided by.
    std::uint64_t coveredPixels()
    {
        Frame frame;
        return renderCounted(m_scene, settingsOf(variants().front(), m_base), frame, {}, m_stop).pixels.covered;
    }

    void addTiming(std::size_t i, const Timing& timing)
    {
        ExperimentRow& row = m_rows[i];
        row.rounds.push_back(timing.clock);
        m_measured[i].processor.push_back(timing.processor);
        std::vector<double> sorted = row.rounds;
        std::ranges::sort(sorted);
        row.ms = {quantile(sorted, 0.5), quantile(sorted, 0.1),           quantile(sorted, 0.9),
                  sorted.front(),        static_cast<int>(sorted.size()), medianOf(m_measured[i].processor),
                  row.ms.batch};
        constexpr double kNsPerMs = 1e6;
        row.nsPerCoveredPixel = m_covered > 0 ? row.ms.median * kNsPerMs / m_covered : 0;
        row.mtriPerS = static_cast<double>(m_scene.mesh.faceCount()) / row.ms.median / 1000;
        if (i > 0)
            row.ratio = pairedRatio(row, m_rows.front());
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
    std::vector<Measured> m_measured; ///< of the same rows
    std::vector<std::unique_ptr<OtherRenderer>> m_others;
    std::map<std::pair<Algorithm, int>, Frame> m_frames;
    Frame m_otherFrame;
    double m_covered = 0;
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

int batchOf(double frameMs)
{
    constexpr double kLargest = 1000;
    return static_cast<int>(std::clamp(std::ceil(kShortestTiming / frameMs), 1.0, kLargest));
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

bool isExactThroughout(std::span<const ExperimentRow> rows, ErrorMeasure measure)
{
    bool isMeasured = false;
    for (const ExperimentRow& row : rows) {
        const auto error = errorOf(row, measure);
        if (error.value_or(0) > 0)
            return false;
        isMeasured = isMeasured || error;
    }
    return isMeasured;
}

std::optional<TimeRatio> pairedRatio(const ExperimentRow& row, const ExperimentRow& other)
{
    std::vector<double> ratios;
    for (std::size_t round = 0; round < std::min(row.rounds.size(), other.rounds.size()); ++round)
        if (other.rounds[round] > 0)
            ratios.push_back(row.rounds[round] / other.rounds[round]);
    if (ratios.empty())
        return std::nullopt;
    std::ranges::sort(ratios);
    return TimeRatio{other.variant, quantile(ratios, 0.5), quantile(ratios, 0.1), quantile(ratios, 0.9),
                     static_cast<int>(ratios.size())};
}

void markFrontier(std::span<ExperimentRow> rows, ErrorMeasure measure)
{
    const auto beats = [&](const ExperimentRow& a, const ExperimentRow& b) {
        const auto errorA = errorOf(a, measure);
        if (a.scene != b.scene || !errorA || *errorA > *errorOf(b, measure) || a.ms.median >= b.ms.median)
            return false;
        const auto ratio = pairedRatio(a, b);
        return ratio && ratio->p90 < 1;
    };
    for (ExperimentRow& row : rows)
        row.frontier =
            row.ms.frames > 0 && errorOf(row, measure) &&
            std::none_of(rows.begin(), rows.end(), [&](const ExperimentRow& other) { return beats(other, row); });
}

std::optional<TimeRatio> walkingAdvantage(std::span<const ExperimentRow> rows)
{
    const auto rowOf = [&](const char* id) {
        return std::ranges::find(rows, QLatin1String(id), &ExperimentRow::variant);
    };
    const auto equation = rowOf("edge-equation");
    const auto walking = rowOf("edge-walking");
    if (equation == rows.end() || walking == rows.end())
        return std::nullopt;
    return pairedRatio(*equation, *walking);
}

MachineNoise noiseOf(std::span<const ExperimentRow> rows)
{
    MachineNoise noise;
    std::vector<double> spreads;
    std::vector<double> shares;
    for (const ExperimentRow& row : rows) {
        if (row.ms.frames == 0)
            continue;
        spreads.push_back((row.ms.p90 - row.ms.p10) / row.ms.median);
        if (row.threads == 1 && !row.other)
            shares.push_back(row.ms.processor / row.ms.median);
        noise.largestBatch = std::max(noise.largestBatch, row.ms.batch);
    }
    if (!spreads.empty())
        noise.spread = medianOf(std::move(spreads));
    if (!shares.empty())
        noise.own = std::min(1.0, medianOf(std::move(shares)));
    return noise;
}

} // namespace rasterlens
