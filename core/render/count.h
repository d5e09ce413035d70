#pragma once
#include "core/pipeline/statistics.h"
#include "core/render/render.h"

#include <stop_token>

namespace rasterlens
{

/// What was done for a picture that is already there: renderCounted() without computing its colours once more.
///
/// in      `picture`, drawn by render() from these settings
/// out     the statistics of renderCounted(), bit for bit; in `counted` depth, ids, for the overdraw view coverage, and
/// the picture: copied where
///         `counted` brings memory of that size, else shared
/// cost    that of coverage and the depth test; the tiled algorithm and multi-sampling, whose shadings are not those of
///         the samples that pass, draw anew
/// errors  throws std::bad_alloc, and std::system_error where threads cannot be started; `stop` ends the work early and
///         leaves an unfinished picture
[[nodiscard]] Statistics countPicture(const Scene& scene, const Settings& settings, const Frame& picture,
                                      Frame& counted, const std::stop_token& stop = {});

} // namespace rasterlens
