#pragma once
#include "core/scene/scene.h"

#include <QPointF>
#include <QString>

#include <cstdint>
#include <memory>
#include <optional>

namespace rasterlens
{

/// Scenes of at most so many faces can be edited corner by corner.
constexpr std::size_t kMostEditableFaces = 4;

[[nodiscard]] bool isEditable(const Scene& scene);

/// How corners are typed and dragged.
struct VertexEditing {
    enum class Typed {
        Pixels, ///< the place on the screen; depth and w stay
        Given,  ///< what the scene gives: clip space, object space, or the world of a file
    };
    /// The places of the screen that dragged corners go to.
    enum class Snap {
        SubpixelGrid, ///< 1/2^subpixelBits of a pixel
        PixelCentre,  ///< (i + 0.5, j + 0.5)
        PixelGrid,    ///< (i, j), where pixels meet
    };

    Typed typed = Typed::Given;
    Snap snap = Snap::SubpixelGrid;
    bool together = true; ///< vertices that lie at one place move as one corner
};

/// The place nearest to a point of the screen that corners may be dragged to.
///
/// in  pixels; subpixelBits 0..8
[[nodiscard]] QPointF snappedPlace(QPointF pixels, VertexEditing::Snap snap, int subpixelBits);

/// A copy of the scene with one vertex elsewhere. The bounding sphere stays: the camera is not to run after the corner.
[[nodiscard]] std::shared_ptr<const Scene> withVertex(const Scene& scene, std::uint32_t vertex,
                                                      const glm::vec4& position);
/// A copy of the scene with a corner elsewhere: the vertex and all others that lay at the same place.
[[nodiscard]] std::shared_ptr<const Scene> withCorner(const Scene& scene, std::uint32_t vertex,
                                                      const glm::vec4& position);
/// A copy of the scene with another colour of one vertex, which all faces that share its index show.
[[nodiscard]] std::shared_ptr<const Scene> withColor(const Scene& scene, std::uint32_t vertex, const glm::vec3& color);

/// A position that a person typed: x, y, z or x, y, z, w, in coordinates of the file. Without w the former w stays.
///
/// in      origin: the mesh's
/// errors  nothing for any other text
[[nodiscard]] std::optional<glm::vec4> typedPosition(const QString& text, const glm::vec4& former,
                                                     const glm::dvec3& origin);
/// A place on the screen that a person typed: x, y in pixels.
[[nodiscard]] std::optional<glm::dvec2> typedPlace(const QString& text);
/// A colour that a person typed: r, g, b from 0 to 1, or `#rrggbb`.
[[nodiscard]] std::optional<glm::vec3> typedColor(const QString& text);

} // namespace rasterlens
