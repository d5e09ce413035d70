#pragma once
#include "core/pipeline/frame.h"
#include "core/scene/scene.h"
#include "core/settings/mistakes.h"

#include <stop_token>

namespace rasterlens
{

/// The scene of a mistake and the settings in which it shows.
struct MistakeDemo {
    Scene scene;
    Settings right; ///< without the mistake
    Settings mistaken;
};
[[nodiscard]] MistakeDemo mistakeDemo(const Mistake& mistake);

/// A picture with all that proofs look at.
struct CountedPicture {
    Frame frame; ///< with depth and ids
    Statistics statistics;
};
/// What a proof looks at in the frames. Counters are always there.
[[nodiscard]] Outputs proofOutputs(Proof proof);
/// errors  as render(); `stop` ends the work early and leaves an unfinished picture
[[nodiscard]] CountedPicture drawCounted(const Scene& scene, const Settings& settings,
                                         Outputs outputs = {.depth = true, .ids = true}, std::stop_token stop = {});

/// The name of a counter as in the statistics document, or of a measure: `covered_twice`, `holes`.
[[nodiscard]] const char* proofId(Proof proof);

/// The value of a counter or a measure for a picture.
///
/// in   pictures of one size; the right one is not looked at for counters
[[nodiscard]] double proofValue(Proof proof, const CountedPicture& shown, const CountedPicture& right);

} // namespace rasterlens
