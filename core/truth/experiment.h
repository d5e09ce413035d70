#pragma once
#include "core/truth/exact_reference.h"
#include "core/truth/renderer_probe.h"
#include "core/truth/variants.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>

namespace rasterlens
{

/// What several frames took, milliseconds from the clear to the finished QImage.
struct FrameTimes {
    double median = 0;
    double p10 = 0;
    double p90 = 0;
    double min = 0;
    int frames = 0;       ///< measured; 0: none yet, the numbers say nothing
    double processor = 0; ///< median of the processor time a frame took, of all threads that worked on it
    int batch = 1;        ///< frames timed together, of which each of the others above is the mean
};

/// A frame that is over sooner than this, in milliseconds, is timed together with those that follow it: the clock, the
/// scheduler and the caches would else be a part of what is measured.
constexpr double kShortestTiming = 2;

/// How many frames of so many milliseconds make a timing: 1, unless they are shorter than that; at most 1000.
[[nodiscard]] int batchOf(double frameMs);

/// How many times as long one variant takes as another: of the frames of the same round, which were drawn one soon
/// after the other.
struct TimeRatio {
    QString to; ///< id of the other variant
    double median = 0;
    double p10 = 0;
    double p90 = 0;
    int pairs = 0;
};

/// Another renderer as it was found to be.
struct RendererFacts {
    QString name; ///< what it calls itself
    RendererTraits traits;
};

/// How far a variant's picture is from the truth; what cannot be compared is empty.
struct VariantError {
    struct Coverage {
        std::uint64_t missing = 0;  ///< pixels
        std::uint64_t extra = 0;    ///< pixels
        std::uint64_t hitTwice = 0; ///< pixels that more faces hit than should
        [[nodiscard]] std::uint64_t wrong() const { return missing + extra + hitTwice; }
    };
    struct Depth {
        double max = 0;  ///< depth units, where both see the same face
        double mean = 0; ///< depth units, where both see the same face
    };
    struct Color {
        double max = 0;    ///< 8-bit steps from the exact colour, where both see the same face; rounding alone: 0.5
        double mean = 0;   ///< 8-bit steps over all channels, where both see the same face
        double psnrDb = 0; ///< of the 8-bit pictures, all pixels; infinite where they are equal
    };
    std::optional<Coverage> coverage;
    std::optional<Depth> depth;
    std::optional<Color> color;
};

/// One variant measured on one scene: a row of the table, a dot of the plot.
struct ExperimentRow {
    QString scene;            ///< its id
    QString variant;          ///< its id
    Settings settings;        ///< load these to see it
    int threads = 1;          ///< that worked
    Simd simd = Simd::Scalar; ///< instructions used, never Auto
    FrameTimes ms;
    std::vector<double> rounds;         ///< milliseconds a frame, round by round
    std::optional<TimeRatio> ratio;     ///< to the first row; none in that row
    std::optional<RendererFacts> other; ///< of a renderer that is not ours; its algorithm is unknown
    double nsPerCoveredPixel = 0;       ///< 0: nothing is covered, or no time yet
    double mtriPerS = 0;
    VariantError error;
    std::optional<ReferenceSpace> reference; ///< where the truth of the errors started; empty: none are measured
    bool frontier = false;                   ///< set by markFrontier()
};

struct ExperimentOptions {
    int frames = 15;                             ///< that count, a variant; one more each warms up
    bool reference = true;                       ///< measure errors
    ReferenceSpace space = ReferenceSpace::Clip; ///< scenes without a camera are measured from clip space
    FindRenderers others{};                      ///< called in the thread that measures; empty: ours alone are measured
    /// Told, in the same thread, of another renderer that does not draw the scene, and why.
    std::function<void(const QString& id, const Reason& reason)> refused{};
};

/// The id of a reference on the command line and in rows: `exact` or `exact-object`.
[[nodiscard]] const char* idOf(ReferenceSpace space);

/// How far an experiment is. The rows are those of the result as they are so far.
struct ExperimentProgress {
    int done;
    int total;
    std::span<const ExperimentRow> rows;
    std::size_t changed; ///< the row that just changed
};

/// Measures variants of a scene.
///
/// in      variants that the scene supports with this base (supportedVariants())
/// out     one row a variant in the order given; `progress` is called in the calling thread after every frame
/// order   first the errors, variant by variant; then rounds of one frame of every variant, so that whatever disturbs
///         the machine disturbs all of them, every second round from the last to the first. The first round is not
///         counted; it tells how many frames make a timing (kShortestTiming)
/// covers  the truth is the exact picture of the *base*: perspective-correct, exact depths, z-buffer, vertices snapped
///         to the base's subpixels, or not at all where the base's number type is a float. A variant with several
///         samples a pixel is compared with the truth of as many, each shaded at its own place. Colours are compared
///         with the shadings gouraud and texture, depths where they are tested, coverage where faces are filled. Other
///         renderers come last; those that do not draw the scene have no row
/// exact   ns per covered pixel divides by one number a scene: the `covered` counter of the base with edge-equation and
///         one sample a pixel (fragments before the depth test); Mtri/s counts the submitted faces
/// cost    frames + 1 frames a variant, and one exact picture a sample grid (exact_reference.h), in horizontal bands
///         (bandsOf)
/// errors  none; `stop` returns early with what has been measured
[[nodiscard]] std::vector<ExperimentRow>
runExperiment(const Scene& scene, const Settings& base, std::span<const Variant* const> variants,
              const ExperimentOptions& options = {},
              const std::function<void(const ExperimentProgress&)>& progress = {}, std::stop_token stop = {});

/// The x axis of the plot.
enum class ErrorMeasure {
    Coverage, ///< wrong pixels: missing, extra, hit twice
    Depth,    ///< largest depth error
    Color,    ///< root mean square of the colour error over the whole picture, 8-bit steps
};
struct ErrorMeasureInfo {
    const char* id;    ///< stable
    const char* title; ///< axis title, QT_TRANSLATE_NOOP("Experiment", ...)
};
constexpr int kErrorMeasures = 3;
[[nodiscard]] const ErrorMeasureInfo& infoOf(ErrorMeasure measure);
[[nodiscard]] std::optional<double> errorOf(const ExperimentRow& row, ErrorMeasure measure);

/// Whether the errors of all rows that have one are 0, and some have.
[[nodiscard]] bool isExactThroughout(std::span<const ExperimentRow> rows, ErrorMeasure measure);

/// How many times as long `row` takes as `other`, if both have been timed.
[[nodiscard]] std::optional<TimeRatio> pairedRatio(const ExperimentRow& row, const ExperimentRow& other);

/// Marks the rows that no other row of the same scene beats. A row beats another if its error is no larger and it is
/// faster by more than frames vary: in nine of ten rounds (the 90th percentile of their ratio is below 1). Rows whose
/// times overlap are not ranked, so both may be marked. Rows without that error or without times never are.
void markFrontier(std::span<ExperimentRow> rows, ErrorMeasure measure);

/// How many times as long edge equation takes as edge walking in these rows, if they hold both.
[[nodiscard]] std::optional<TimeRatio> walkingAdvantage(std::span<const ExperimentRow> rows);

/// walkingAdvantage() that a blog post for students tells of: 72 frames in "more than 8 s" with edge equation, 71 in
/// some 5.8 s with edge walking; one model, one run, a debug build.
constexpr double kPublishedWalkingAdvantage = 1.36;

/// How far the numbers of an experiment can be trusted.
struct MachineNoise {
    double spread = 0; ///< how far frames of a variant differ: p90 - p10 by the median, the median of the variants
    double own = 0;    ///< processor time by the clock, of variants with one thread: below 1 others had the processor
    int largestBatch = 1; ///< frames timed together; 1: no variant was timed in batches
};
[[nodiscard]] MachineNoise noiseOf(std::span<const ExperimentRow> rows);

} // namespace rasterlens
