#pragma once
#include "core/scene/scene.h"
#include "core/settings/settings.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

namespace rasterlens
{

/// A triangle that is drawn: a whole face or a piece of a cut one. Pixels, y down.
struct ScreenPiece {
    std::uint32_t face = 0;
    std::array<glm::dvec2, 3> corners; ///< A, B, C as the rules have snapped them
    std::array<double, 3> invW{};      ///< what interpolation is told of the corners: 1 / w unless a mistake is on
    glm::dvec2 boxLow{0, 0};           ///< the bounding box whose samples are tested, as an area of whole samples
    glm::dvec2 boxHigh{0, 0};          ///< as `boxLow` where the box holds no sample or coverage does not use one
};

/// What becomes of a face on its way to the screen.
struct ScreenFace {
    bool drawn = false;
    bool front = false;            ///< it is a front face by what the rules look at; false where nothing was decided
    std::uint32_t firstCorner = 0; ///< into ScreenFaces::corners
    std::uint32_t cornerCount = 0; ///< of what clipping left; 0 unless drawn
    std::uint32_t firstPiece = 0;  ///< into ScreenFaces::pieces
    std::uint32_t pieceCount = 0;
};

/// All faces of a scene on the screen.
struct ScreenFaces {
    std::vector<ScreenFace> faces; ///< one per face of the mesh
    std::vector<glm::dvec2> corners;
    std::vector<ScreenPiece> pieces;
    bool perspective = true; ///< attributes are interpolated with 1 / w

    [[nodiscard]] std::span<const glm::dvec2> cornersOf(const ScreenFace& face) const
    {
        return std::span(corners).subspan(face.firstCorner, face.cornerCount);
    }
    [[nodiscard]] std::span<const ScreenPiece> piecesOf(const ScreenFace& face) const
    {
        return std::span(pieces).subspan(face.firstPiece, face.pieceCount);
    }
};

/// Takes all faces through the stages up to coverage.
///
/// in      settings for which unsupported() is empty
/// cost    geometry for the whole scene
/// exact   corners, boxes and facings are those of render(): the same stages are run, with the mistakes that are on
/// errors  std::bad_alloc; `stop` ends the work early, and the faces that are left count as not drawn
[[nodiscard]] ScreenFaces screenFaces(const Scene& scene, const Settings& settings, const std::stop_token& stop = {});

} // namespace rasterlens
