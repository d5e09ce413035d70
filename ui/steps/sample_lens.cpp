#include "ui/steps/sample_lens.h"

#include "core/observe/stored_samples.h"
#include "ui/base/step_words.h"
#include "ui/base/text_on.h"
#include "ui/base/theme.h"
#include "ui/steps/lens_view.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace rasterlens
{
namespace
{

constexpr double kSamplesFromCell = 2;   ///< canvas pixels a sample
constexpr double kPatternsFromZoom = 20; ///< canvas pixels a pixel

QString translated(const char* text) { return QCoreApplication::translate("Lens", text); }

/// The pixels that are not resolved, in at most two rectangles: the rest of a row, and the rows below it.
std::vector<QRect> unresolved(std::size_t resolved, QSize picture)
{
    const int width = picture.width();
    const int row = int(resolved / std::size_t(width));
    const int column = int(resolved % std::size_t(width));
    std::vector<QRect> parts;
    if (column > 0)
        parts.emplace_back(column, row, width - column, 1);
    parts.emplace_back(0, column > 0 ? row + 1 : row, width, picture.height() - (column > 0 ? row + 1 : row));
    std::erase_if(parts, [](const QRect& part) { return part.isEmpty(); });
    return parts;
}

/// A drawing of rectangles holds no image: runs of one colour in a row.
void paintRuns(QPainter& painter, const QImage& samples, const QRect& part, const CanvasTransform& transform, int grid)
{
    for (int y = part.top(); y <= part.bottom(); ++y)
        for (int x = part.left(), next = x; x <= part.right(); x = next) {
            const QRgb color = samples.pixel(x, y);
            while (next <= part.right() && samples.pixel(next, y) == color)
                ++next;
            painter.fillRect(transform.toCanvas(QRectF(QPointF(x, y) / grid, QSizeF(next - x, 1) / grid)),
                             QColor(color));
        }
}

void paintGrid(QPainter& painter, const QRect& pixels, const CanvasTransform& transform, int grid, double cell)
{
    const QRectF area = transform.toCanvas(QRectF(pixels));
    const auto lines = [&](int perPixel, const QColor& color) {
        for (int i = 0; i <= pixels.width() * perPixel; ++i)
            painter.fillRect(QRectF(area.left() + i * transform.zoom / perPixel, area.top(), 1, area.height()), color);
        for (int i = 0; i <= pixels.height() * perPixel; ++i)
            painter.fillRect(QRectF(area.left(), area.top() + i * transform.zoom / perPixel, area.width(), 1), color);
    };
    if (cell >= kGridFromZoom)
        lines(grid, QColor(120, 128, 140, 90));
    lines(1, QColor(40, 46, 54, 190));
}

/// What a pixel stores and the mean of it: of many samples two a line, and the sums without their terms, so that a
/// plate has room on the canvas.
QStringList resolveWords(const ResolvedPixel& pixel)
{
    constexpr int kFewSamples = 8;
    const QStringList stored = storedWords(pixel);
    const QStringList sums = meanWords(pixel);
    if (pixel.count <= kFewSamples)
        return stored + sums;
    QStringList lines;
    const qsizetype rows = (stored.size() + 1) / 2;
    qsizetype widest = 0;
    for (qsizetype i = 0; i < rows; ++i)
        widest = std::max(widest, stored[i].size());
    for (qsizetype i = 0; i < rows; ++i)
        lines << (i + rows < stored.size() ? stored[i].leftJustified(widest + 3) + stored[i + rows] : stored[i]);
    for (const QString& sum : sums) {
        const QString mean = sum.section(QLatin1String(" = "), 2);
        lines << (mean.isEmpty() ? sum : QStringLiteral("%1 = %2").arg(sum.left(1), mean));
    }
    return lines;
}

} // namespace

bool SampleLens::isAtWork() const
{
    if (m_cursor == nullptr || m_cursor->log().samplesPerPixel() == 1)
        return false;
    const QSize picture = m_cursor->image().size();
    return m_cursor->log().resolvedPixels(m_cursor->positionInLog()) <
           std::size_t(picture.width()) * std::size_t(picture.height());
}

void SampleLens::paint(QPainter& painter, const QRect& canvas, const CanvasTransform& transform,
                       const OverlayOptions& options) const
{
    if (!isAtWork() || options.wipe)
        return;
    painter.save();
    painter.setClipRect(canvas);
    if (transform.zoom / m_cursor->log().grid() >= kSamplesFromCell)
        paintSamples(painter, canvas, transform, options);
    const StepEvent* now = m_cursor->lastEvent();
    if (now != nullptr && now->kind == StepKind::Resolve)
        paintResolve(painter, canvas, transform, m_cursor->log().payload<ResolveStep>(*now).pixel);
    else if (options.hoveredPixel && options.tells && transform.zoom >= kGridFromZoom)
        paintHover(painter, canvas, transform, *options.hoveredPixel);
    painter.restore();
}

void SampleLens::paintSamples(QPainter& painter, const QRect& canvas, const CanvasTransform& transform,
                              const OverlayOptions& options) const
{
    const StepLog& log = m_cursor->log();
    const int grid = log.grid();
    const QImage samples(reinterpret_cast<const uchar*>(m_cursor->sampleColors().data()), log.columns(), log.rows(),
                         log.columns() * qsizetype(sizeof(QRgb)), QImage::Format_RGB32);
    const QRect seen = transform.pixelsIn(canvas, m_cursor->image().size());
    if (log.rules().multiSampled()) {
        paintPatterns(painter, seen, transform);
        return;
    }
    painter.setRenderHint(QPainter::SmoothPixmapTransform, false);
    const bool vectors = isDrawing(painter);
    for (const QRect& part : unresolved(log.resolvedPixels(m_cursor->positionInLog()), m_cursor->image().size())) {
        const QRect pixels = part.intersected(seen);
        if (pixels.isEmpty())
            continue;
        const QRect of(pixels.topLeft() * grid, pixels.size() * grid);
        if (vectors)
            paintRuns(painter, samples, of, transform, grid);
        else
            painter.drawImage(transform.toCanvas(QRectF(pixels)), samples, QRectF(of));
        if (options.grid && transform.zoom >= kGridFromZoom)
            paintGrid(painter, pixels, transform, grid, transform.zoom / grid);
    }
}

/// The samples of the pixels that are not resolved, each where it lies.
void SampleLens::paintPatterns(QPainter& painter, const QRect& seen, const CanvasTransform& transform) const
{
    if (transform.zoom < kPatternsFromZoom)
        return;
    for (const QRect& part :
         unresolved(m_cursor->log().resolvedPixels(m_cursor->positionInLog()), m_cursor->image().size())) {
        const QRect pixels = part.intersected(seen);
        for (int y = pixels.top(); y <= pixels.bottom(); ++y)
            for (int x = pixels.left(); x <= pixels.right(); ++x)
                paintStored(painter, transform, storedSamples(*m_cursor, x, y));
    }
}

/// What the samples of a pixel store, on discs where they lie.
void SampleLens::paintStored(QPainter& painter, const CanvasTransform& transform, const ResolvedPixel& pixel) const
{
    const Rules& rules = m_cursor->log().rules();
    const double radius = transform.zoom * (rules.patternSamples > 8 ? 0.06 : 0.09);
    painter.setRenderHint(QPainter::Antialiasing);
    for (int i = 0; i < pixel.count; ++i) {
        const glm::dvec2 point = testedPoint(rules, pixel.x, pixel.y, i);
        const QColor stored{QRgb(pixel.samples[std::size_t(i)].color)};
        const QColor ink = stored.lightness() > 128 ? Qt::black : Qt::white;
        const QPointF at = transform.toCanvas(QPointF(point.x, point.y));
        painter.setPen(QPen(ink, 1.2));
        painter.setBrush(stored);
        painter.drawEllipse(at, radius, radius);
        if (pixel.counted(i) == pixel.samples[std::size_t(i)].color)
            continue;
        painter.drawLine(at - QPointF(radius, radius), at + QPointF(radius, radius));
        painter.drawLine(at + QPointF(-radius, radius), at + QPointF(radius, -radius));
    }
}

/// The samples of the pixel with their numbers, those that count as black crossed out, and the sum beside them.
void SampleLens::paintResolve(QPainter& painter, const QRect& canvas, const CanvasTransform& transform,
                              const ResolvedPixel& pixel) const
{
    const int grid = m_cursor->log().grid();
    const QRectF box = transform.toCanvas(QRectF(pixel.x, pixel.y, 1, 1));
    const QSizeF cell = box.size() / grid;
    QFont font = numberFont();
    font.setPixelSize(std::clamp(int(cell.height() / 2), 8, 18));
    painter.setFont(font);
    const bool isGrid = !m_cursor->log().rules().multiSampled();
    if (!isGrid && box.width() >= kPatternsFromZoom)
        paintStored(painter, transform, pixel);
    for (int i = 0; i < pixel.count && isGrid && cell.width() >= kSamplesFromCell; ++i) {
        const QRectF part(box.topLeft() + QPointF(i % grid * cell.width(), i / grid * cell.height()), cell);
        const QColor stored{QRgb(pixel.samples[std::size_t(i)].color)};
        const QColor ink = inkOn(stored.rgb()).ink;
        painter.fillRect(part, stored);
        painter.setPen(QPen(ink, 1));
        painter.drawRect(part);
        if (cell.height() >= kGlyphsFromCell)
            drawTextOn(painter, part, Qt::AlignCenter, QString::number(i + 1), stored.rgb());
        if (pixel.counted(i) == pixel.samples[std::size_t(i)].color)
            continue;
        painter.setPen(QPen(ink, 2));
        painter.drawLine(part.topLeft(), part.bottomRight());
        painter.drawLine(part.topRight(), part.bottomLeft());
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(Qt::white, 6, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
    painter.drawRect(box);
    painter.setPen(QPen(Qt::black, 3, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
    painter.drawRect(box);
    const QString title = translated(QT_TRANSLATE_NOOP("Lens", "pixel (%1, %2): %3 samples and their mean"))
                              .arg(pixel.x)
                              .arg(pixel.y)
                              .arg(pixel.count);
    const QStringList lines = QStringList{title} + resolveWords(pixel);
    paintPlate(painter, canvas, placeOfPlate(canvas, transform, box, lines), lines, numberFont(0));
}

/// Beside the pixel, or at the right or left border of the canvas, wherever the plate hides the fewest changes of
/// colour from pixel to pixel.
QPointF SampleLens::placeOfPlate(const QRect& canvas, const CanvasTransform& transform, const QRectF& box,
                                 const QStringList& lines) const
{
    constexpr double kGap = 10;
    const QRectF beside = textPlate(canvas, box.bottomRight() + QPointF(kGap, kGap), lines, numberFont(0));
    QPointF best = beside.topLeft();
    if (transform.zoom < kGridFromZoom) // pixels are too small to be told apart
        return best;
    int fewest = std::numeric_limits<int>::max();
    for (const double x : {beside.left(), canvas.right() - 4 - beside.width(), canvas.left() + 4.0,
                           box.left() - kGap - beside.width()}) {
        const QRectF plate(QPointF(x, beside.top()), beside.size());
        if (x < canvas.left() || x + plate.width() > canvas.right() || plate.intersects(box))
            continue;
        if (const int hidden = changesOfColor(transform.pixelsIn(plate.toRect(), m_cursor->image().size()));
            hidden < fewest) {
            fewest = hidden;
            best = plate.topLeft();
        }
    }
    return best;
}

/// How often neighbours in a row or a column differ, as they are shown.
int SampleLens::changesOfColor(const QRect& pixels) const
{
    const StepLog& log = m_cursor->log();
    const std::size_t resolved = log.resolvedPixels(m_cursor->positionInLog());
    const int width = m_cursor->image().width();
    const auto shown = [&](int x, int y) {
        if (std::size_t(y) * std::size_t(width) + std::size_t(x) < resolved)
            return std::array{m_cursor->image().pixel(x, y), m_cursor->image().pixel(x, y)};
        const ResolvedPixel stored = storedSamples(*m_cursor, x, y);
        return std::array{QRgb(stored.samples[0].color), QRgb(stored.samples[std::size_t(stored.count) - 1].color)};
    };
    int changes = 0;
    for (int y = pixels.top(); y < pixels.bottom(); ++y)
        for (int x = pixels.left(); x < pixels.right(); ++x)
            changes += (shown(x, y) != shown(x + 1, y) ? 1 : 0) + (shown(x, y) != shown(x, y + 1) ? 1 : 0);
    return changes;
}

void SampleLens::paintHover(QPainter& painter, const QRect& canvas, const CanvasTransform& transform,
                            QPoint pixel) const
{
    if (!QRect(QPoint(0, 0), m_cursor->image().size()).contains(pixel))
        return;
    const QString title = translated(QT_TRANSLATE_NOOP("Lens", "pixel (%1, %2): what its samples store now"))
                              .arg(pixel.x())
                              .arg(pixel.y());
    const QStringList lines = QStringList{title} + storedWords(storedSamples(*m_cursor, pixel.x(), pixel.y()));
    const double height = QFontMetricsF(numberFont(0)).lineSpacing() * double(lines.size()) + 16;
    const QPointF above = transform.toCanvas(QRectF(pixel, QSizeF(1, 1))).topLeft() - QPointF(0, height);
    paintPlate(painter, canvas, above, lines, numberFont(0));
}

} // namespace rasterlens
