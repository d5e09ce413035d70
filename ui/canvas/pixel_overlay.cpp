#include "ui/canvas/pixel_overlay.h"

#include "core/settings/sample_pattern.h"
#include "ui/base/theme.h"
#include "ui/canvas/pixel_numbers.h"

#include <QFontMetricsF>
#include <QPaintEngine>
#include <QPainter>
#include <QPainterPath>
#include <QPixmap>
#include <QPixmapCache>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace rasterlens
{
namespace
{

constexpr double kLeastRing = 12; ///< canvas pixels within the ring around a pixel that is smaller

/// Small cells would drown in strong lines.
QColor gridColor(double zoom) { return {120, 128, 140, zoom >= kSampleDotsFromZoom ? 150 : 100}; }

/// Where the samples of a pixel lie, from its upper left corner, in pixels.
std::vector<QPointF> samplePlaces(Samples samples)
{
    std::vector<QPointF> places;
    if (const int count = patternSamples(samples); count > 1) {
        for (const SampleOffset& offset : samplePattern(count))
            places.emplace_back((8 + offset.x) / 16.0, (8 + offset.y) / 16.0);
        return places;
    }
    const int grid = sampleGrid(samples);
    for (int j = 0; j < grid; ++j)
        for (int i = 0; i < grid; ++i)
            places.emplace_back((i + 0.5) / grid, (j + 0.5) / grid);
    return places;
}

/// The sample positions of the pixel whose upper left corner is `corner`.
void paintSampleDots(QPainter& painter, QPointF corner, double zoom, Samples samples, bool thick)
{
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    const double spacing = zoom / std::sqrt(samplesPerPixel(samples));
    const double radius = std::clamp(spacing / 16 * (thick ? 1.5 : 1), 1.0, 4.0);
    for (const QPointF& place : samplePlaces(samples)) {
        const QPointF at = corner + place * zoom;
        painter.setBrush(QColor(255, 255, 255, 190));
        painter.drawEllipse(at, radius + 1, radius + 1);
        painter.setBrush(QColor(20, 24, 30));
        painter.drawEllipse(at, radius, radius);
    }
}

/// One pixel's grid lines and sample positions; the overlay of the whole image is this tile, repeated.
QPixmap cellTile(int zoom, Samples samples, const OverlayOptions& options)
{
    QPixmap tile(zoom, zoom);
    tile.fill(Qt::transparent);
    QPainter painter(&tile);
    if (options.grid) {
        const QColor line = gridColor(zoom);
        const int width = options.thickLines && zoom >= kSampleDotsFromZoom ? 2 : 1;
        painter.fillRect(0, 0, zoom, width, line);
        painter.fillRect(0, width, width, zoom - width, line);
    }
    if (options.sampleDots && zoom >= kSampleDotsFromZoom)
        paintSampleDots(painter, {0, 0}, zoom, samples, options.thickLines);
    return tile;
}

QPixmap cachedCellTile(int zoom, Samples samples, const OverlayOptions& options)
{
    const QString key = QStringLiteral("rasterlens-cell-%1-%2-%3%4%5")
                            .arg(zoom)
                            .arg(static_cast<int>(samples))
                            .arg(options.grid)
                            .arg(options.sampleDots)
                            .arg(options.thickLines);
    QPixmap tile;
    if (!QPixmapCache::find(key, &tile)) {
        tile = cellTile(zoom, samples, options);
        QPixmapCache::insert(key, tile);
    }
    return tile;
}

/// What moves lines of an odd width onto whole pixels of a drawing; on the screen they are moved by Qt.
QPointF lineShift(const QPainter& painter) { return isDrawing(painter) ? QPointF(0.5, 0.5) : QPointF(0, 0); }

/// Each run of equal pixels of a row as one rectangle: an image inside a drawing is blurred by most viewers.
void paintRuns(QPainter& painter, const QRect& pixels, const CanvasTransform& transform, const QImage& image)
{
    for (int y = pixels.top(); y <= pixels.bottom(); ++y)
        for (int x = pixels.left(); x <= pixels.right();) {
            const QRgb color = image.pixel(x, y);
            int end = x + 1;
            while (end <= pixels.right() && image.pixel(end, y) == color)
                ++end;
            painter.fillRect(transform.toCanvas(QRectF(x, y, end - x, 1)), QColor(color));
            x = end;
        }
}

void paintImage(QPainter& painter, const QRect& pixels, const CanvasTransform& transform, const RenderedFrame& frame)
{
    const QImage& image = frame.frame.image;
    if (isDrawing(painter) && transform.zoom > 1) {
        paintRuns(painter, pixels, transform, image);
        return;
    }
    const QRectF target = transform.toCanvas(QRectF(pixels));
    if (transform.zoom >= 1) {
        painter.drawImage(target, image, QRectF(pixels));
        return;
    }
    if (isScaledQuickly(frame, transform)) {
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.drawImage(target, image, QRectF(pixels));
        painter.setRenderHint(QPainter::SmoothPixmapTransform, false);
        return;
    }
    // Every pixel has its share of what is shown: the painter's own filter would skip some, and thin lines with them.
    const QSize size = (target.size() * painter.device()->devicePixelRatioF()).toSize().expandedTo({1, 1});
    const QImage shown = pixels == image.rect() ? image : image.copy(pixels);
    painter.drawImage(target, shown.scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation));
}

/// As the tiles of cellTile(), one of which each pixel gets on the screen.
void paintDrawnCells(QPainter& painter, const QRect& pixels, const CanvasTransform& transform, Samples samples,
                     const OverlayOptions& options)
{
    const QRectF target = transform.toCanvas(QRectF(pixels));
    if (options.grid) {
        QPainterPath lines; // one path: where two lines cross, neither darkens the other
        lines.setFillRule(Qt::WindingFill);
        const double width = options.thickLines && transform.zoom >= kSampleDotsFromZoom ? 2 : 1;
        for (int x = 0; x <= pixels.width(); ++x)
            lines.addRect(target.left() + x * transform.zoom, target.top(), width, target.height() + width);
        for (int y = 0; y <= pixels.height(); ++y)
            lines.addRect(target.left(), target.top() + y * transform.zoom, target.width() + width, width);
        painter.fillPath(lines, gridColor(transform.zoom));
    }
    if (!options.sampleDots || transform.zoom < kSampleDotsFromZoom)
        return;
    for (int y = pixels.top(); y <= pixels.bottom(); ++y)
        for (int x = pixels.left(); x <= pixels.right(); ++x)
            paintSampleDots(painter, transform.toCanvas(QRectF(x, y, 1, 1)).topLeft(), transform.zoom, samples,
                            options.thickLines);
}

void paintCells(QPainter& painter, const QRect& pixels, const CanvasTransform& transform, Samples samples,
                const OverlayOptions& options)
{
    if (isDrawing(painter)) {
        paintDrawnCells(painter, pixels, transform, samples, options);
        return;
    }
    const QRect target = transform.toCanvas(QRectF(pixels)).toRect();
    painter.drawTiledPixmap(target, cachedCellTile(static_cast<int>(transform.zoom), samples, options));
    if (options.grid) {
        const QColor line = gridColor(transform.zoom);
        painter.fillRect(target.right() + 1, target.top(), 1, target.height() + 1, line);
        painter.fillRect(target.left(), target.bottom() + 1, target.width(), 1, line);
    }
}

void paintPixelFrame(QPainter& painter, QPoint pixel, const CanvasTransform& transform, bool selected, bool thick)
{
    const QRectF cell = transform.toCanvas(QRectF(pixel, QSizeF(1, 1))).translated(lineShift(painter));
    const double width = (selected ? 3 : 1) * (thick ? 2 : 1);
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(255, 255, 255, 220), width + 2, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
    painter.drawRect(cell);
    painter.setPen(QPen(QColor(10, 12, 16), width, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
    painter.drawRect(cell);
}

/// A pixel too small to be framed is ringed.
void paintPixelRing(QPainter& painter, QPoint pixel, const CanvasTransform& transform, bool thick)
{
    const QPointF centre = transform.toCanvas(QPointF(pixel) + QPointF(0.5, 0.5));
    const double width = thick ? 4 : 2.5;
    const double radius = (thick ? 1.5 : 1) * kLeastRing / 2 + width / 2;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(255, 255, 255, 220), width + 3));
    painter.drawEllipse(centre, radius, radius);
    painter.setPen(QPen(QColor(10, 12, 16), width));
    painter.drawEllipse(centre, radius, radius);
}

/// A line around the picture. Four areas rather than an outline: viewers of drawings differ about its corners.
void paintBorder(QPainter& painter, const QRect& picture)
{
    const QColor line(120, 128, 140, 150);
    const QRect around = picture.adjusted(-1, -1, 1, 1);
    painter.fillRect(QRect(around.topLeft(), QSize(around.width(), 1)), line);
    painter.fillRect(QRect(around.left(), around.bottom(), around.width(), 1), line);
    painter.fillRect(QRect(around.left(), picture.top(), 1, picture.height()), line);
    painter.fillRect(QRect(around.right(), picture.top(), 1, picture.height()), line);
}

} // namespace

bool isScaledQuickly(const RenderedFrame& frame, const CanvasTransform& transform)
{
    return frame.moving && frame.settings.fill == Fill::Solid && transform.zoom >= 0.5 && transform.zoom < 1;
}

void paintPicture(QPainter& painter, const QRect& canvas, const CanvasTransform& transform, const RenderedFrame& frame,
                  const OverlayOptions& options, const PixelLines& linesAt)
{
    const QRect pixels = transform.pixelsIn(canvas, frame.frame.image.size());
    if (pixels.isEmpty())
        return;
    paintImage(painter, pixels, transform, frame);
    if (transform.zoom >= kGridFromZoom)
        paintCells(painter, pixels, transform, frame.settings.samples, options);
    const bool numbersHidden =
        std::ranges::any_of(options.layers, [](const CanvasLayer* layer) { return layer->hidesNumbers(); });
    if (options.numbers && transform.zoom >= kNumbersFromZoom && !numbersHidden)
        paintPixelNumbers(painter, pixels, transform, frame.frame.image, [&](QPoint pixel, NumberRoom room) {
            return linesAt ? linesAt(pixel, room) : pixelNumbers(frame, pixel, room);
        });
}

void paintPixelFrames(QPainter& painter, const CanvasTransform& transform, QSize picture, const OverlayOptions& options)
{
    const QRect pixels(QPoint(0, 0), picture);
    if (options.hoveredPixel && transform.zoom >= kGridFromZoom && pixels.contains(*options.hoveredPixel))
        paintPixelFrame(painter, *options.hoveredPixel, transform, false, options.thickLines);
    if (!options.selectedPixel || !pixels.contains(*options.selectedPixel))
        return;
    if (transform.zoom >= kLeastRing)
        paintPixelFrame(painter, *options.selectedPixel, transform, true, options.thickLines);
    else
        paintPixelRing(painter, *options.selectedPixel, transform, options.thickLines);
}

bool isDrawing(const QPainter& painter)
{
    const QPaintEngine::Type type = painter.paintEngine()->type();
    return type == QPaintEngine::SVG || type == QPaintEngine::Pdf;
}

void paintCanvas(QPainter& painter, const QRect& canvas, const CanvasTransform& transform, const RenderedFrame& frame,
                 const OverlayOptions& options)
{
    const QImage& image = frame.frame.image;
    painter.save();
    paintBorder(painter, transform.toCanvas(QRectF(image.rect())).toRect());
    paintPicture(painter, canvas, transform, frame, options);
    const bool wiped = options.wipe && options.wipe->left->frame.image.size() == image.size();
    const double column = wiped ? wipeColumn(*options.wipe, canvas, transform, image.width()) : 0;
    if (wiped) {
        painter.save();
        const QRectF left(QPointF(canvas.topLeft()), QPointF(column, canvas.bottom() + 1.0));
        painter.setClipRect(left);
        paintPicture(painter, canvas, transform, *options.wipe->left, options);
        painter.restore();
    }
    for (const CanvasLayer* layer : options.layers)
        layer->paint(painter, canvas, transform, options);
    paintPixelFrames(painter, transform, image.size(), options);
    if (wiped)
        paintWipe(painter, canvas, transform.toCanvas(QRectF(image.rect())), column, options.thickLines);
    if (!options.tag.isEmpty())
        paintTag(painter, canvas, options.tag);
    painter.restore();
}

} // namespace rasterlens
