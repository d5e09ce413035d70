#pragma once
#include "core/questions/picture_match.h"

#include <array>
#include <vector>

namespace rasterlens
{

/// How large differences are that are no mistake: noise, rounding, the losses of JPEG. Squared, a pixel; flat areas and
/// edges apart.
struct PictureNoise {
    std::array<double, 2> typical{};
    double least = 0; ///< squared differences that even the best picture leaves

    /// The noise that the best of some fits leaves.
    [[nodiscard]] static PictureNoise of(const std::vector<PictureFit>& fits);
};

/// Whether a fit leaves next to nothing but noise. In a picture whose flat areas are clean, what is left at edges is no
/// noise: small mistakes look so.
///
/// in  `most`: pixels at which some picture differs from the one handed in
[[nodiscard]] bool leavesOnlyNoise(const PictureFit& fit, const PictureNoise& noise, int most);

/// What a picture leaves of the picture handed in, where it is to be compared with what another one leaves at another
/// offset: an offset is not for nothing.
[[nodiscard]] double leavesOf(const PictureFit& fit);

/// What of the differences from both pictures is more than noise, and what is more than the best picture leaves.
[[nodiscard]] double unexplained(const PictureFit& fit, const PictureNoise& noise);

/// 1: the picture has all of the change and nothing else; 0: nothing of it. The part of the change that the picture
/// has, in the union of the change and of what else is different.
[[nodiscard]] double scoreOf(const PictureFit& fit, const PictureNoise& noise);

/// 1: the picture is the right one; one half: it differs by as much as `smallest`, a weight.
[[nodiscard]] double scoreOfRight(const PictureFit& fit, const PictureNoise& noise, double smallest);

} // namespace rasterlens
