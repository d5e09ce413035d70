#pragma once
#include "core/truth/exact_reference.h"
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
    int frames = 0; ///< measured; 0: none yet, the numbers say nothing
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
    double nsPerCoveredPixel = 0; ///< 0: nothing is covered, or no time yet
    double mtriPerS = 0;
    VariantError error;
    std::optional<ReferenceSpace> reference; ///< where the truth of the errors started; empty: none are measured
    bool frontier = false;                   ///< set by markFrontier()
};

struct ExperimentOptions {
    int frames = 15;                             ///< that count, a variant; one more each warms up
    bool reference = true;                       ///< measure errors
    ReferenceSpace space = ReferenceSpace::Clip; ///< scenes without a camera are measured from clip space
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
///         the machine disturbs all of them. The first round is not counted
/// covers  the truth is the exact picture of the *base*: perspective-correct, exact depths, z-buffer, vertices snapped
/// to
///         the base's subpixels, or not at all where the base's number type is a float. A variant with several samples
///         a pixel is compared with the truth of as many. Colours are compared with Gouraud shading, depths where
///         they are tested, coverage where faces are filled
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

/// Marks the rows that no other row of the same scene beats: none is at least as fast (median) with less error, none
/// is faster with the same error. Rows without that error or without times are not on it.
void markFrontier(std::span<ExperimentRow> rows, ErrorMeasure measure);

/// How many times as long one variant takes as another.
struct TimeRatio {
    double median; ///< of the medians
    double low;    ///< its fast frames (p10) by the other's slow ones (p90)
    double high;   ///< its slow frames (p90) by the other's fast ones (p10)
};

/// How many times as long edge equation takes as edge walking in these rows, if they hold both.
[[nodiscard]] std::optional<TimeRatio> walkingAdvantage(std::span<const ExperimentRow> rows);

/// walkingAdvantage() by the blog post [002]: 72 frames in 8 s with edge equation, 71 frames in 5.8 s with edge
/// walking.
constexpr double kPublishedWalkingAdvantage = 1.36;

} // namespace rasterlens
