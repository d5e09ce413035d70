#pragma once
#include "ui/base/inks.h"

#include <QColor>
#include <QPainter>

#include <array>

namespace rasterlens
{

// Lines over a picture of any colour: each is drawn twice, first wider in kCanvasInk, so that it shows on black and on
// white alike.
constexpr QRgb kWireInk = 0xfff5f7fa;
constexpr QRgb kOutlineInk = 0xfff0e442;
constexpr QRgb kBoxInk = 0xff56b4e9;
constexpr QRgb kTileInk = 0xffe69bc0;
/// What belongs to the corners A, B and C: the areas, weights and iso-lines of alpha, beta and gamma.
constexpr std::array<QRgb, 3> kWeightInks{0xff56b4e9, 0xfff0883e, 0xff5fd3b3};
constexpr QRgb kMidLineInk = 0xffffffff;

/// The dark lines below come first, then the lines themselves.
///
/// in  draw: paints with the pen that is set
template <class Draw>
void paintSeamed(QPainter& painter, QRgb ink, double width, Qt::PenStyle style, Draw&& draw)
{
    constexpr double kSeam = 2; ///< wider on both sides together
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(kCanvasInk), width + kSeam));
    draw();
    painter.setPen(QPen(QColor(ink), width, style));
    draw();
}

/// Writes white letters on a dark plate with a border in `ink`, its middle at `centre`, held within `canvas`.
///
/// out  the plate
QRectF paintPlate(QPainter& painter, const QRect& canvas, QPointF centre, const QString& text, QRgb ink);
/// The plate that paintPlate() paints.
[[nodiscard]] QRectF plateOf(const QPainter& painter, const QRect& canvas, QPointF centre, const QString& text);

} // namespace rasterlens
