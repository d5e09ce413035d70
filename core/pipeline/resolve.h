#pragma once
#include "core/scene/camera.h"
#include "core/scene/scene.h"
#include "core/settings/mistakes.h"
#include "core/settings/rules.h"

#include <vector>

namespace rasterlens
{

/// What settings mean for a scene. A frame, its counters, its record, the answers about its pixels and its vertex table
/// are all made of such a value: settings are resolved once, and the functions that draw, record or explain are handed
/// the result. So what a text says of a picture holds for that picture.
struct Resolved {
    Rules rules;                          ///< what the stages read
    Rules right;                          ///< the same without the mistakes: what an explanation compares with
    std::vector<const Mistake*> mistakes; ///< those of the settings, in the order they were switched on
    Matrices matrices;                    ///< of the camera
};

/// Resolves the settings for a scene.
///
/// in   any settings, also those that unsupported() refuses; mistakes that do not exist are passed over
[[nodiscard]] Resolved resolve(const Settings& settings, const Scene& scene);

} // namespace rasterlens
