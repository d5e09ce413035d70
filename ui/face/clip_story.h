#pragma once
#include "core/observe/face_moment.h"
#include "core/observe/step_log.h"
#include "core/scene/scene.h"

#include <optional>
#include <stop_token>
#include <vector>

namespace rasterlens
{

/// What clipping did to one face, plane by plane.
struct ClipStory {
    Rules rules;                     ///< by which it was clipped
    std::vector<ClipVertex> corners; ///< A, B, C; empty: there is no such face
    std::uint32_t outsideOf = 0;     ///< planes a corner is outside of, one bit a ClipPlane
    std::vector<ClipStep> steps;     ///< a plane each that the face was cut by, in order
    std::optional<CohenSutherlandStep> regions;
    std::vector<MomentCorner> named; ///< all corners there were, with the names that the canvas gives them
    std::vector<ClipVertex> result;  ///< the polygon that is left
    int pieces = 0;                  ///< triangles of its fan
    FaceFate fate = FaceFate::Rejected;

    [[nodiscard]] const ClipStep* stepOf(ClipPlane plane) const;
    /// The numbers of corners: 3, then those after each step.
    [[nodiscard]] std::vector<int> counts() const;
};

/// A scene of one face of another, under the same camera.
[[nodiscard]] Scene sceneOfFace(const Scene& scene, std::uint32_t face);

/// in  settings for which unsupported() is empty
[[nodiscard]] ClipStory clipStory(const Scene& scene, const Settings& settings, std::uint32_t face,
                                  const std::stop_token& stop = {});

} // namespace rasterlens
