#pragma once
#include "core/base/reason.h"

#include <glm/glm.hpp>

#include <limits>
#include <optional>

namespace rasterlens
{

struct Mesh;

/// The smallest box round some points, its sides along the axes; empty until a point is added.
struct BoundingBox {
    glm::dvec3 low{std::numeric_limits<double>::infinity()};
    glm::dvec3 high{-std::numeric_limits<double>::infinity()};

    /// Makes room for a point; one that is not finite is left out.
    void add(const glm::dvec3& point);
    [[nodiscard]] bool isEmpty() const { return low.x > high.x; }
    [[nodiscard]] glm::dvec3 center() const { return low + 0.5 * (high - low); }
    [[nodiscard]] double longestSide() const;
    /// The longest side over the centre's distance from 0: how much of a number's digits is left for the shape.
    /// Infinite for a box about 0 and for an empty one.
    [[nodiscard]] double relativeSize() const;
};

/// A box whose longest side is smaller than this part of its distance from 0 is told from an origin of its own.
constexpr double kRecentredBelow = 0.125;
/// Below this part of the distance the loader remarks on it: float32 would move corners by whole pixels.
constexpr double kRemarkedBelow = 1e-4;

/// The origin that the positions of a mesh are to be told from (Mesh::origin).
///
/// in     the box of the positions in use, in the file's coordinates
/// out    0 where relativeSize() is at least kRecentredBelow: such a mesh holds its positions as the file gives them.
///        Otherwise the box's centre, rounded to a multiple of the smallest power of two that is no less than the
///        longest side
/// exact  no coordinate of a point of the box is further than 1.5 sides from the origin, and the difference from it is
///        exact in double. A mesh moved by a multiple of that power of two keeps its float32 positions bit for bit
[[nodiscard]] glm::dvec3 originFor(const BoundingBox& box);

/// A position of the file as a mesh with this origin holds it: one subtraction in double, rounded once to float32.
[[nodiscard]] inline glm::vec3 objectFromWorld(const glm::dvec3& world, const glm::dvec3& origin)
{
    return glm::vec3(world - origin);
}

/// A position of a mesh in the coordinates of its file; w stays.
[[nodiscard]] glm::dvec4 worldFromObject(const glm::dvec4& object, const glm::dvec3& origin);
[[nodiscard]] glm::dvec4 worldPosition(const Mesh& mesh, std::size_t vertex);

/// The coordinate of the world that lies at `object` of the mesh's space, written out: as many decimals as lead back to
/// the float32 value.
///
/// in   a finite value, and the origin's coordinate of the same axis
[[nodiscard]] QString worldNumber(float object, double origin);
/// `x, y, z` of a vertex in the coordinates of its file.
[[nodiscard]] QString worldText(const glm::vec4& object, const glm::dvec3& origin);

/// What a loader says about a box far from 0; nothing where relativeSize() is at least kRemarkedBelow.
[[nodiscard]] std::optional<Reason> remarkOnDistance(const BoundingBox& box);

} // namespace rasterlens
