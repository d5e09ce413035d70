#pragma once
#include "ui/canvas/pixel_overlay.h"
#include "ui/steps/lens_glyphs.h"
#include "ui/steps/lens_model.h"
#include "ui/steps/lens_view.h"

#include <QColor>
#include <QHash>
#include <QPixmap>

#include <functional>
#include <memory>
#include <optional>

namespace rasterlens
{

/// Paints the edge-sign lens: signs, values, lines and the present step of one triangle.
///
/// cost  a full canvas of 1920 x 1080 at 16x in less than 16 ms
class LensOverlay : public CanvasLayer
{
public:
    /// in  null: nothing is painted
    void setModel(std::unique_ptr<const LensModel> model) { m_model = std::move(model); }
    /// Gives the coverage of a triangle in some pixels, for LensModel::setFar().
    using Coverage = std::function<std::shared_ptr<const StepLog>(const StepTriangle&, const PixelRect&)>;
    void setCoverage(Coverage coverage) { m_coverage = std::move(coverage); }
    [[nodiscard]] const LensModel* model() const { return m_model.get(); }
    /// What the legend tells where a sample has so many canvas pixels; nothing: there are no signs.
    [[nodiscard]] std::optional<LensLegend> legendAt(double cell) const;
    /// The legend stands beside the canvas, and not on it.
    void setLegendBeside(bool on) { m_isLegendBeside = on; }
    /// Where the legend was painted last; empty: it was not.
    [[nodiscard]] const QRectF& legendPlate() const { return m_legendPlate; }

    void paint(QPainter& painter, const QRect& canvas, const CanvasTransform& transform,
               const OverlayOptions& options) const override;
    [[nodiscard]] bool hidesNumbers() const override { return m_model != nullptr; }

private:
    void paintCells(LensView& view) const;
    void paintVeils(LensView& view) const;
    static void paintCell(QPainter& painter, const QRectF& box, const LensCell& cell);
    void paintNumbers(LensView& view) const;
    void paintBounds(LensView& view) const;
    void paintEdges(LensView& view) const;
    static void paintTies(LensView& view);
    void paintCorners(LensView& view) const;
    void paintLine(LensView& view) const;
    void paintLinePosition(LensView& view) const;
    void paintColumn(LensView& view) const;
    void paintCurrent(LensView& view) const;
    void paintHover(LensView& view) const;

    void paintWalkOfSample(LensView& view) const;
    void lookFar(const LensView& view) const;

    std::unique_ptr<const LensModel> m_model;
    Coverage m_coverage;
    bool m_isLegendBeside = false;
    mutable QRectF m_legendPlate;
    mutable QHash<quint32, QPixmap> m_tiles; ///< cells by what they show
    mutable QSize m_tileSize;
    mutable QColor m_tilePaper;
};

} // namespace rasterlens
