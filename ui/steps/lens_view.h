#pragma once
#include "ui/base/named_places.h"
#include "ui/canvas/pixel_overlay.h"
#include "ui/steps/lens_model.h"

#include <QColor>
#include <QFont>
#include <QPainter>
#include <QRectF>
#include <QStringList>

#include <utility>
#include <vector>

namespace rasterlens
{

constexpr double kGlyphsFromCell = 16; ///< canvas pixels a sample
constexpr double kLensNumbersFromCell = 48;

/// The colours of a card, for what is written over the picture.
struct Paper {
    QColor fill;
    QColor ink;
};
[[nodiscard]] Paper paper();
[[nodiscard]] QColor withAlpha(QColor color, int alpha);

/// Text on a plate, readable over anything.
///
/// in  where its upper left corner is wanted; it is moved into `within`
QRectF paintPlate(QPainter& painter, const QRectF& within, QPointF at, const QStringList& lines, const QFont& font);
/// The plate that paintPlate() paints.
[[nodiscard]] QRectF textPlate(const QRectF& within, QPointF at, const QStringList& lines, const QFont& font);

/// Where a plate of this size hides the least of what is marked: in a corner of the canvas, the upper left one if it
/// can be; its own upper left corner.
[[nodiscard]] QPointF freeCorner(const QRectF& canvas, QSizeF size, const std::vector<QRectF>& marked);

/// What one paint of the lens works with.
struct LensView {
    QPainter& painter;
    QRect canvas;
    const CanvasTransform& transform;
    const OverlayOptions& options;
    int grid;
    double cell;                                    ///< canvas pixels a sample
    std::vector<std::pair<QRectF, LensCell>> cells; ///< in sight, from kGlyphsFromCell on

    [[nodiscard]] QPointF at(glm::dvec2 sample) const { return transform.toCanvas(QPointF(sample.x, sample.y) / grid); }
    [[nodiscard]] QRectF box(int x, int y) const { return {at({x, y}), QSizeF(cell, cell)}; }
    [[nodiscard]] double thickness(double pen) const { return options.thickLines ? pen * 1.6 : pen; }
    /// The samples that the canvas shows, cut to a rectangle of samples.
    [[nodiscard]] QRect visible(const PixelRect& of) const;
    /// A line with a light rim, cut to the canvas.
    void line(glm::dvec2 from, glm::dvec2 to, QColor color, double width, Qt::PenStyle style) const;
    /// The plates of the names of corners, in the painter's font, each beside its corner, away from a point in their
    /// middle, and within the canvas. Corners at one place share a plate.
    struct NamePlate {
        QRectF plate;
        QString name;
    };
    [[nodiscard]] std::vector<NamePlate> namePlates(const std::vector<NamedPlace>& corners, QPointF middle) const;
    void paintNames(const std::vector<NamePlate>& plates) const;
    void cornerNames(const std::vector<NamedPlace>& corners, QPointF middle) const
    {
        paintNames(namePlates(corners, middle));
    }
};

} // namespace rasterlens
