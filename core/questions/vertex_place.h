#pragma once
#include "core/scene/scene.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>

namespace rasterlens
{

/// The position a vertex has to have to be drawn at a point of the screen: the inverse of viewport, divide and camera,
/// with the mistakes that are on. Its z and w of clip space stay.
///
/// in      a vertex of the mesh; pixels, y down, before snapping
/// out     for MeshVertex::position, rounded to float32
/// errors  nothing where w <= 0: behind the eye a vertex has no place on the screen
[[nodiscard]] std::optional<glm::vec4> positionAtPixel(const Scene& scene, const Settings& settings,
                                                       std::uint32_t vertex, const glm::dvec2& pixel);

} // namespace rasterlens
