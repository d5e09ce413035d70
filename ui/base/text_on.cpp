#include "ui/base/text_on.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace rasterlens
{
namespace
{

constexpr double kFlare = 0.05; ///< what the standard adds to every luminance

double luminance(QRgb color)
{
    const auto linear = [](int channel) {
        const double value = channel / 255.0;
        return value <= 0.03928 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(qRed(color)) + 0.7152 * linear(qGreen(color)) + 0.0722 * linear(qBlue(color));
}

} // namespace

InkOn inkOn(QRgb surface)
{
    constexpr double kEnough = 7;
    const double behind = luminance(surface) + kFlare;
    const double ofBlack = behind / kFlare;
    const double ofWhite = (1 + kFlare) / behind;
    const bool isBlack = ofBlack >= ofWhite;
    const bool needsSeam = std::max(ofBlack, ofWhite) < kEnough;
    return {isBlack ? Qt::black : Qt::white, !needsSeam ? QColor() : isBlack ? Qt::white : Qt::black};
}

void drawTextOn(QPainter& painter, const QRectF& box, int flags, const QString& text, QRgb surface)
{
    const InkOn inks = inkOn(surface);
    if (inks.seam.isValid()) {
        painter.setPen(inks.seam);
        for (const QPointF away : {QPointF(-1, -1), QPointF(1, -1), QPointF(-1, 1), QPointF(1, 1)})
            painter.drawText(box.translated(away), flags, text);
    }
    painter.setPen(inks.ink);
    painter.drawText(box, flags, text);
}

} // namespace rasterlens
