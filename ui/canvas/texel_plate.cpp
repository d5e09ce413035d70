#include "ui/canvas/texel_plate.h"

#include "ui/base/inks.h"
#include "ui/base/text_on.h"
#include "ui/base/theme.h"
#include "ui/canvas/overlay_inks.h"

#include <QColor>
#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>
#include <QPolygonF>

#include <algorithm>
#include <cmath>

namespace rasterlens
{
namespace
{

constexpr double kGridFromCell = 6;
constexpr double kWeightsFromCell = 40;
constexpr double kSide = 190; ///< of the drawing on the canvas
constexpr double kPadding = 8;
constexpr double kFromBorder = 10;
constexpr QRgb kReadInk = 0xfff0883e;
constexpr QRgb kFootprintInk = 0xfff5f7fa;

QString translated(const char* text) { return QCoreApplication::translate("rasterlens::TexelPlate", text); }

QString percent(double share) { return QString::number(100 * share, 'f', share < 0.0995 && share > 0 ? 1 : 0); }

/// From texels of a level to the box, v upwards.
class TexelPlace
{
public:
    TexelPlace(const QRectF& box, const TexelPatch& patch)
        : m_patch(patch), m_cell(std::min(box.width() / patch.size.width(), box.height() / patch.size.height()))
    {
        const QSizeF size = m_cell * QSizeF(patch.size);
        m_frame = QRectF(box.left() + (box.width() - size.width()) / 2, box.top() + (box.height() - size.height()) / 2,
                         size.width(), size.height());
    }

    [[nodiscard]] double cell() const { return m_cell; }
    [[nodiscard]] const QRectF& frame() const { return m_frame; }
    /// in   texels of the patch's level
    [[nodiscard]] QPointF at(double column, double row) const
    {
        return {m_frame.left() + (column - m_patch.column) * m_cell, m_frame.bottom() - (row - m_patch.row) * m_cell};
    }
    [[nodiscard]] QRectF rect(double column, double row, double width, double height) const
    {
        return {at(column, row + height), at(column + width, row)};
    }

private:
    const TexelPatch& m_patch;
    double m_cell;
    QRectF m_frame;
};

void paintCells(QPainter& painter, const TexelPlace& place, const TexelPatch& patch)
{
    const int width = patch.size.width();
    for (int row = 0; row < patch.size.height(); ++row)
        for (int column = 0; column < width; ++column)
            painter.fillRect(place.rect(patch.column + column, patch.row + row, 1, 1),
                             QColor(QRgb(patch.texels[static_cast<std::size_t>(row * width + column)])));
    const QRectF& frame = place.frame();
    const auto lines = [&](double every, const QPen& pen) {
        painter.setPen(pen);
        for (double x = std::ceil(patch.column / every) * every; x <= patch.column + width; x += every)
            painter.drawLine(QPointF(place.at(x, 0).x(), frame.top()), QPointF(place.at(x, 0).x(), frame.bottom()));
    };
    const auto rows = [&](double every, const QPen& pen) {
        painter.setPen(pen);
        for (double y = std::ceil(patch.row / every) * every; y <= patch.row + patch.size.height(); y += every)
            painter.drawLine(QPointF(frame.left(), place.at(0, y).y()), QPointF(frame.right(), place.at(0, y).y()));
    };
    if (place.cell() >= kGridFromCell) {
        const QPen thin(QColor(128, 128, 128, 120), 1);
        lines(1, thin);
        rows(1, thin);
    }
    const QPen border(QColor(kCanvasInk), 2, Qt::DashLine); // where the texture begins again
    lines(patch.levelSize.width(), border);
    rows(patch.levelSize.height(), border);
}

/// What one texel of another level is in texels of the patch's.
QPointF scaleTo(const TexelFootprint& footprint, int level)
{
    const auto side = [&](int full, int patch) {
        return double(patch) / std::max(1, full >> level); // levels halve their sides, rounded down
    };
    return {side(footprint.size.width(), footprint.patch.levelSize.width()),
            side(footprint.size.height(), footprint.patch.levelSize.height())};
}

void paintReads(QPainter& painter, const TexelPlace& place, const TexelFootprint& footprint)
{
    for (const TexelRead& read : footprint.reads) {
        const QPointF scale = scaleTo(footprint, read.level);
        const QRectF rect = place.rect(read.column * scale.x(), read.row * scale.y(), scale.x(), scale.y());
        const bool isFirst = read.level == footprint.reads.front().level;
        paintSeamed(painter, kReadInk, isFirst ? 2 : 1.5, isFirst ? Qt::SolidLine : Qt::DashLine,
                    [&] { painter.drawRect(rect); });
        if (!isFirst || rect.width() < kWeightsFromCell || rect.height() < kWeightsFromCell)
            continue;
        // away from the pixel's centre
        const QPointF full = scaleTo(footprint, 0);
        const bool isAbove = place.at(0, footprint.place.y * full.y()).y() > rect.center().y();
        drawTextOn(painter, rect.adjusted(3, 3, -3, -3), Qt::AlignHCenter | (isAbove ? Qt::AlignTop : Qt::AlignBottom),
                   percent(read.weight) + QLatin1Char('%'), QRgb(read.color));
    }
}

void paintParallelogram(QPainter& painter, const TexelPlace& place, const TexelFootprint& footprint)
{
    const QPointF scale = scaleTo(footprint, 0);
    const auto at = [&](const glm::dvec2& texels) { return place.at(texels.x * scale.x(), texels.y * scale.y()); };
    QPolygonF outline;
    for (const glm::dvec2& corner : footprint.corners())
        outline << at(corner);
    paintSeamed(painter, kFootprintInk, 2, Qt::SolidLine, [&] { painter.drawPolygon(outline); });
    painter.setPen(QPen(QColor(kFootprintInk), 1.5));
    painter.setBrush(QColor(kCanvasInk));
    painter.drawEllipse(at(footprint.place), 3.5, 3.5);
}

/// `level 2 (16 x 16), 37 %: (13, 4) 25 %, (14, 4) 12 %`
QString levelWords(const TexelFootprint& footprint, int level)
{
    double share = 0;
    QStringList texels;
    for (const TexelRead& read : footprint.reads)
        if (read.level == level) {
            share += read.weight;
            texels << QStringLiteral("(%1,\u00a0%2)\u00a0%3\u00a0%").arg(read.x).arg(read.y).arg(percent(read.weight));
        }
    return translated(QT_TRANSLATE_NOOP("rasterlens::TexelPlate", "level %1 (%2 x %3), %4 %: %5"))
        .arg(level)
        .arg(std::max(1, footprint.size.width() >> level))
        .arg(std::max(1, footprint.size.height() >> level))
        .arg(percent(share), texels.join(QStringLiteral(", ")));
}

} // namespace

QStringList texelWords(const TexelFootprint& footprint)
{
    QStringList words;
    if (footprint.patch.level > 0)
        words
            << translated(QT_TRANSLATE_NOOP("rasterlens::TexelPlate", "drawn on level %1")).arg(footprint.patch.level);
    int last = -1;
    for (const TexelRead& read : footprint.reads)
        if (read.level != last) {
            last = read.level;
            words << levelWords(footprint, last);
        }
    if (footprint.reads.empty())
        words << translated(QT_TRANSLATE_NOOP("rasterlens::TexelPlate", "no texel is read: the level itself is shown"));
    return words;
}

void paintTexels(QPainter& painter, const QRectF& box, const TexelFootprint& footprint)
{
    if (footprint.patch.texels.empty())
        return;
    const TexelPlace place(box, footprint.patch);
    painter.save();
    painter.setClipRect(place.frame(), Qt::IntersectClip);
    painter.setFont(numberFont(-1));
    painter.setRenderHint(QPainter::Antialiasing, false);
    paintCells(painter, place, footprint.patch);
    painter.setRenderHint(QPainter::Antialiasing);
    paintReads(painter, place, footprint);
    paintParallelogram(painter, place, footprint);
    painter.restore();
}

void paintTexelPlate(QPainter& painter, const QRectF& canvas, const QPointF& pixel, const TexelFootprint& footprint)
{
    if (footprint.patch.texels.empty())
        return;
    painter.save();
    painter.setFont(textFont(0));
    QStringList lines{translated(QT_TRANSLATE_NOOP("rasterlens::TexelPlate", "Footprint in the texture (%1 x %2)"))
                          .arg(footprint.size.width())
                          .arg(footprint.size.height())};
    lines += texelWords(footprint);
    const QString text = lines.join(QLatin1Char('\n'));
    const double widest = std::min(kSide + 70, canvas.width() - 2 * (kFromBorder + kPadding));
    const int flags = Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap;
    const QFontMetricsF metrics(painter.font());
    const double textHeight = metrics.boundingRect(QRectF(0, 0, widest, 10000), flags, text).height();
    const double side = std::min(kSide, canvas.height() - textHeight - 3 * kPadding - 2 * kFromBorder);
    if (widest < kSide / 2 || side < kSide / 3) {
        painter.restore();
        return;
    }
    const QSizeF size(widest + 2 * kPadding, textHeight + side + 3 * kPadding);
    const bool isLeft = pixel.x() > canvas.center().x();
    const bool isTop = pixel.y() > canvas.center().y();
    const QRectF plate(isLeft ? canvas.left() + kFromBorder : canvas.right() - kFromBorder - size.width(),
                       isTop ? canvas.top() + kFromBorder : canvas.bottom() - kFromBorder - size.height(), size.width(),
                       size.height());
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(QColor(kReadInk), 1.5));
    painter.setBrush(QColor(kCanvasInk));
    painter.drawRoundedRect(plate, 4, 4);
    paintTexels(painter, QRectF(plate.left() + kPadding, plate.top() + kPadding, widest, side), footprint);
    painter.setPen(Qt::white);
    painter.drawText(QRectF(plate.left() + kPadding, plate.top() + side + 2 * kPadding, widest, textHeight), flags,
                     text);
    painter.restore();
}

} // namespace rasterlens
