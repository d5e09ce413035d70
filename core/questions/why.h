#pragma once
#include "core/observe/step_log.h"
#include "core/questions/texel_footprint.h"
#include "core/scene/scene.h"
#include "core/settings/mistakes.h"
#include "core/settings/sample_pattern.h"

#include <QJsonObject>
#include <QString>
#include <QStringList>

#include <optional>
#include <stop_token>
#include <vector>

namespace rasterlens
{

/// What became of a face at a pixel. The order is that of the pipeline: the further down, the further it got.
enum class WhyVerdict {
    NonFinite,   ///< a vertex is no number, so the face has no place on the screen
    Rejected,    ///< outside the view volume as a whole
    CulledBack,  ///< faces away
    CulledFront, ///< faces the eye
    Degenerate,  ///< no area on the screen
    ClippedAway, ///< the face would cover the pixel, but not the part of it that clipping left
    OutsideEdge, ///< an edge value is negative
    LostTie,     ///< the centre lies on an edge that does not own it
    Hole,        ///< covered, but the face's texture is transparent there
    FailedDepth, ///< covered, but what is stored won
    Written,     ///< covered and stored
};
[[nodiscard]] const char* whyVerdictId(WhyVerdict verdict);

/// An edge function at the sample.
struct WhyEdge {
    QString name;         ///< `BC`
    double value = 0;     ///< in units
    double threshold = 0; ///< in units: the smallest value that counts as inside
    EdgeSide side = EdgeSide::Neither;
    bool passed = false;
};

/// One face and its verdict, with the numbers that were computed on the way to it.
struct WhyFace {
    std::uint32_t face = 0; ///< the triangle
    std::int32_t line = -1; ///< of the `f` in the scene's file that it is a part of; -1 none
    WhyVerdict verdict = WhyVerdict::Rejected;
    std::uint32_t planes = 0;             ///< one bit a ClipPlane: rejected by, or cut by
    std::optional<FacingDecision> facing; ///< unless rejected before
    bool hasEdges = false;                ///< filled triangles that got to coverage
    std::array<WhyEdge, 3> edges;
    int edge = -1; ///< OutsideEdge, LostTie: the one that decided
    double unitsPerArea = 1;
    float opacity = 1;             ///< Hole: of the texture at the sample, below kLeastOpacity
    double area = 0;               ///< filled triangles that got to coverage: the share of the pixel, 0..1
    SampleMask coveredSamples = 0; ///< multi-sampling: one bit a sample of the pattern
    std::optional<FragmentStep> fragment;
    std::optional<TexelFootprint> texels;       ///< of the fragment, where a texture is looked up
    WriteStep write{};                          ///< Written
    std::optional<std::uint32_t> overwrittenBy; ///< Written: the face that was written next
    /// The mistakes without which the face would have another verdict, or other numbers.
    std::vector<const Mistake*> because;
};

/// Whether a face covers some of the pixel, and not all.
[[nodiscard]] inline bool hasPartOfPixel(const WhyFace& face)
{
    constexpr double kRounding = 1e-9;
    return face.area > kRounding && face.area < 1 - kRounding;
}

/// Why a pixel is what it is.
struct WhyReport {
    int x = 0; ///< pixels
    int y = 0;
    int sampleX = 0; ///< the sample the rows are about: the one nearest the pixel's centre
    int sampleY = 0;
    std::vector<WhyFace> faces; ///< in the order of drawing
    std::uint32_t background = 0;
    std::uint32_t color = 0; ///< of the pixel, 0xffRRGGBB; several samples: their mean
    float depth = 1;         ///< of the sample
    std::optional<std::uint32_t> visibleFace;
    /// With several samples a pixel: what they store when the frame is drawn, and the mean.
    std::optional<ResolvedPixel> samples;
    /// What the samples are without one of the mistakes, where that is something else.
    struct Without {
        const Mistake* mistake;
        ResolvedPixel samples;
    };
    std::vector<Without> without;
    Rules rules; ///< by which it was drawn

    [[nodiscard]] const WhyFace* find(std::uint32_t face) const;
    /// The line of the `f` that a triangle named here is a part of; -1 none.
    [[nodiscard]] std::int32_t lineOf(std::uint32_t face) const;
};

/// Every face that could concern a pixel, with its verdict.
///
/// in      settings for which unsupported() is empty; a pixel of the viewport
/// covers  faces whose bounds on the screen hold the sample's centre; of faces that never get to the screen those that
///         lie before or behind the eye in the direction of the sample; all faces with a non-finite vertex
/// cost    geometry for the whole scene, coverage for the faces concerned only; with mistakes the whole frame, and the
///         answer without each of them
/// exact   verdicts are those of render(): the same stages are run
/// errors  `stop` ends the work early; what is returned then means nothing
[[nodiscard]] WhyReport why(const Scene& scene, const Settings& settings, int x, int y,
                            const std::stop_token& stop = {});

/// One sentence about a face, as `rasterlens-cli why` prints it. Not translated.
[[nodiscard]] QString whyText(const WhyReport& report, const WhyFace& face);
/// The samples of the pixel and their mean in one line, and another for each mistake without which they would differ;
/// none with one sample a pixel.
[[nodiscard]] QStringList whySamples(const WhyReport& report);
[[nodiscard]] QJsonObject toJson(const WhyReport& report);

} // namespace rasterlens
