#pragma once
#include "core/questions/screen_faces.h"
#include "ui/canvas/pixel_overlay.h"

#include <cstdint>
#include <memory>
#include <optional>

namespace rasterlens
{

/// Lines over the picture: the outlines of all faces, bounding boxes, tiles, the outline of the face that owns the
/// selected pixel, and the lines on which a weight is one half.
class GeometryLayer : public CanvasLayer
{
public:
    /// Null: the faces of the picture on the canvas are not known (yet).
    void setFaces(std::shared_ptr<const ScreenFaces> faces) { m_faces = std::move(faces); }
    [[nodiscard]] const std::shared_ptr<const ScreenFaces>& faces() const { return m_faces; }
    /// The face that owns the selected pixel.
    void setWinner(std::optional<std::uint32_t> face) { m_winner = face; }
    [[nodiscard]] std::optional<std::uint32_t> winner() const { return m_winner; }
    /// in  pixels: the side of a tile, and the picture that is tiled
    void setTiles(double side, QSize picture)
    {
        m_tileSide = side;
        m_picture = picture;
    }

    void paint(QPainter& painter, const QRect& canvas, const CanvasTransform& transform,
               const OverlayOptions& options) const override;
    [[nodiscard]] bool hidesNumbers() const override { return false; }

private:
    void paintTiles(QPainter& painter, const QRect& canvas, const CanvasTransform& transform) const;
    void paintBoxes(QPainter& painter, const QRectF& visible, const CanvasTransform& transform) const;
    void paintWires(QPainter& painter, const QRectF& visible, const CanvasTransform& transform, bool thick) const;
    void paintMidLines(QPainter& painter, const QRect& canvas, const CanvasTransform& transform) const;
    void paintOutline(QPainter& painter, const CanvasTransform& transform, bool thick) const;

    std::shared_ptr<const ScreenFaces> m_faces;
    std::optional<std::uint32_t> m_winner;
    double m_tileSide = 64;
    QSize m_picture;
};

/// Where a line of equal weight crosses the edge from the corner whose weight it is, as a part of the way from there.
///
/// in   weight: 0..1; invW of the corner and of the edge's other end; 1 and 1: without perspective
[[nodiscard]] double wayToWeight(double weight, double invWHere, double invWThere);

/// The two points of a triangle's edges at which the weight of a corner has a value.
///
/// in   corrected: the weight after perspective correction
[[nodiscard]] std::array<glm::dvec2, 2> isoLine(const std::array<glm::dvec2, 3>& corners,
                                                const std::array<double, 3>& invW, std::size_t corner, double weight,
                                                bool corrected);

/// The mid-line: where |alpha - 0.5| is smaller than this.
constexpr double kMidLineHalfWidth = 0.05;

} // namespace rasterlens
