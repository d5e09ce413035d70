#pragma once
#include "core/scene/scene.h"
#include "core/truth/coverage_difference.h"
#include "core/truth/exact_reference.h"

#include <stop_token>
#include <vector>

namespace rasterlens
{

/// A pixel that is not as it should be.
struct WrongPixel {
    int x; ///< of the whole picture
    int y;
    PixelVerdict verdict;
    int face; ///< that should be seen or, where none should, that is seen

    friend bool operator==(const WrongPixel&, const WrongPixel&) = default;
};

/// What the exact reference says about the picture of some settings.
struct Judgement {
    CoverageDifference difference;               ///< without its verdicts
    std::vector<WrongPixel> wrong;               ///< row by row from the top
    double bandPixels = 0;                       ///< so close to a true edge everything counts as right
    int nonFinite = 0;                           ///< faces dropped
    ReferenceSpace space = ReferenceSpace::Clip; ///< where the truth started: Object judges the vertex stage as well
};

/// Why settings are not judged: they cannot be drawn, or draw no filled triangles.
enum class NotJudged { No, Unsupported, NotFilled };
[[nodiscard]] NotJudged notJudged(const Scene& scene, const Settings& settings);

/// Draws the settings and holds the picture against the truth.
///
/// in      settings for which notJudged() is No
/// out     the window of the scene. Scenes that are `exact` are compared with the unsnapped truth; fixed point may then
///         differ within legalBandPixels() of an edge. Scenes without a camera are judged from clip space in any case
/// cost    a few doubles a sample, some 20 us a face (exact_reference.h). The truth is computed in bands of rows, so
///         its memory does not grow with the picture
/// errors  `stop` ends the work early; what is returned then means nothing
[[nodiscard]] Judgement judge(const Scene& scene, const Settings& settings, const std::stop_token& stop = {},
                              const ExactProgress& progress = {}, ReferenceSpace space = ReferenceSpace::Clip);

} // namespace rasterlens
