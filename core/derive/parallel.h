#pragma once
#include "core/derive/face_record.h"

namespace rasterlens
{

// What an orthographic camera makes of the topics about perspective: w is 1, and nothing is left to correct.

/// Weights on the screen and in space, along an edge and over the face.
[[nodiscard]] Derivation deriveParallelWeights(const FaceRecord& record, const SampledTriangle& sample,
                                               const FragmentStep& fragment);

/// What becomes of depth: z' is linear in the distance.
[[nodiscard]] Derivation deriveParallelDepth(const FaceRecord& record);

} // namespace rasterlens
