#pragma once
#include "ui/canvas/pixel_overlay.h"
#include "ui/steps/lens_model.h"

#include <QColor>
#include <QHash>
#include <QPixmap>

#include <memory>
#include <optional>

namespace rasterlens
{

constexpr double kGlyphsFromCell = 16; ///< canvas pixels a sample
constexpr double kLensNumbersFromCell = 48;

/// The hue and the pen style of the edges AB, BC, CA.
struct EdgeLook {
    QRgb color;
    Qt::PenStyle style;
};
constexpr std::array<EdgeLook, 3> kEdgeLooks{
    {{0xff6a3d9a, Qt::SolidLine}, {0xff00796b, Qt::DashLine}, {0xff8c5a00, Qt::DotLine}}};

/// The circle that stands for the sign of an edge value: plus, minus, zero or not a number.
void paintEdgeGlyph(QPainter& painter, QPointF centre, double diameter, EdgeSign sign);

/// Paints the edge-sign lens: signs, values, lines and the present step of one triangle.
///
/// cost  a full canvas of 1920 x 1080 at 16x in less than 16 ms
class LensOverlay : public CanvasLayer
{
public:
    /// in  null: nothing is painted
    void setModel(std::unique_ptr<const LensModel> model) { m_model = std::move(model); }
    [[nodiscard]] const LensModel* model() const { return m_model.get(); }

    void paint(QPainter& painter, const QRect& canvas, const CanvasTransform& transform,
               const OverlayOptions& options) const override;
    [[nodiscard]] bool hidesNumbers() const override { return m_model != nullptr; }

private:
    struct View;

    void paintCells(View& view) const;
    void paintVeils(View& view) const;
    [[nodiscard]] static QColor veilOf(const LensCell& cell, const QColor& fill);
    static void paintCell(QPainter& painter, const QRectF& box, const LensCell& cell);
    void paintNumbers(View& view) const;
    void paintBounds(View& view) const;
    void paintEdges(View& view) const;
    static void paintTies(View& view);
    void paintCorners(View& view) const;
    void paintWalk(View& view) const;
    void paintLine(View& view) const;
    void paintColumn(View& view) const;
    void paintCurrent(View& view) const;
    void paintHover(View& view) const;

    std::unique_ptr<const LensModel> m_model;
    mutable QHash<quint32, QPixmap> m_tiles; ///< cells by what they show
    mutable QSize m_tileSize;
    mutable QColor m_tilePaper;
};

} // namespace rasterlens
