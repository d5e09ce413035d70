#pragma once
#include "core/observe/step_log.h"

#include <QString>

#include <array>
#include <optional>
#include <vector>

namespace rasterlens
{

/// A corner of a face on its way from the mesh to the screen.
struct MomentCorner {
    QString name; ///< A, B, C; I1, I2, ... for those that cutting has made, in the order of the cuts
    glm::dvec4 positionClip;
    std::optional<glm::dvec2> snapped; ///< samples: where it stands on the screen, once it has come there

    /// Where the divide puts it, in samples; nothing if it is not in front of the eye.
    [[nodiscard]] std::optional<glm::dvec2> onScreen(const Rules& rules) const;
};

/// What a face has come to at a step of its geometry: the polygon of that moment.
struct FaceMoment {
    std::uint32_t face = 0;
    StepKind kind = StepKind::Vertex;  ///< of the step
    std::vector<MomentCorner> before;  ///< at a cut: the polygon that is cut
    std::vector<MomentCorner> corners; ///< in order; fewer than three while the face fetches its vertices
    std::optional<ClipPlane> plane;    ///< at a cut by a plane
    std::size_t corner = 0;            ///< at Vertex and Viewport: the one the step is about
    std::optional<FaceFate> fate;      ///< from Facing on
};

/// The moment of the face whose geometry is at work at a position; nothing where none is.
///
/// in  a position of the log
[[nodiscard]] std::optional<FaceMoment> faceMomentAt(const StepLog& log, std::size_t position);

/// The part of an edge that is in front of the eye, in samples; nothing if there is none.
[[nodiscard]] std::optional<std::array<glm::dvec2, 2>> edgeOnScreen(const MomentCorner& from, const MomentCorner& to,
                                                                    const Rules& rules);

} // namespace rasterlens
