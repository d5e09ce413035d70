#include "ui/canvas/viewport_widget.h"

#include "ui/base/image_export.h"
#include "ui/base/theme.h"
#include "ui/canvas/wipe.h"

#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <utility>

namespace rasterlens
{
namespace
{

constexpr int kFitMargin = 18;
constexpr int kNameRoom = 12;    ///< beside the margin, for the name of a corner below the badge
constexpr int kNarrowMargin = 2; ///< where it makes a small picture larger
constexpr int kPaneGap = 2;      ///< between the picture and the depth buffer beside it
constexpr int kKeptVisible = 40; ///< canvas pixels of the image that panning leaves in sight
constexpr int kMaxFigureSide = 16384;
constexpr int kWheelPauseMs = 500;

/// in  `fine`: quarters of a canvas pixel are steps as well, as long as picture pixels are small
double fittingZoom(QSizeF pixels, QSizeF canvas, bool fine)
{
    constexpr double kSmall = 4;
    constexpr double kQuarters = 4;
    const double zoom = std::min(canvas.width() / pixels.width(), canvas.height() / pixels.height());
    if (zoom < 1)
        return std::max(zoom, zoomSteps().front());
    if (fine && zoom < kSmall)
        return std::floor(zoom * kQuarters) / kQuarters;
    return std::min(std::floor(zoom), zoomSteps().back());
}

} // namespace

ViewportWidget::ViewportWidget(QWidget* parent) : QWidget(parent), m_canvasColor(Qt::lightGray)
{
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_OpaquePaintEvent);
    m_wheelGesture.setSingleShot(true);
    m_wheelGesture.setInterval(kWheelPauseMs);
    connect(&m_wheelGesture, &QTimer::timeout, this, &ViewportWidget::gestureEnded);
}

void ViewportWidget::setFrame(const FramePtr& frame)
{
    const QSize former = imageSize();
    const bool looksTheSame = m_frame == frame || looksLikeTheShown(*frame);
    m_frame = frame;
    syncDepth();
    if (imageSize() != former) {
        m_fitPixels.reset();
        m_options.selectedPixel.reset();
        m_options.hoveredPixel.reset();
        if (m_fitted || former.isEmpty())
            fit();
    }
    if (!looksTheSame) {
        m_frameShown = false;
        update();
    }
    Q_EMIT pixelChanged();
}

/// Whether the frame is another one of the same change, with the same picture: the counted one after the first. Where
/// the pixels show depths and faces the counted one looks different; so does one after a picture that was scaled
/// quickly.
bool ViewportWidget::looksLikeTheShown(const RenderedFrame& frame) const
{
    const bool showsCounts = (m_options.numbers && m_transform.zoom >= kNumbersFromZoom) || m_options.depthBeside;
    if (!m_frame || showsCounts || m_frame->requested != frame.requested || isScaledQuickly(*m_frame, m_transform))
        return false;
    const QImage& shown = m_frame->frame.image;
    const QImage& next = frame.frame.image;
    const bool isAlike = next.size() == shown.size() && next.format() == shown.format();
    return isAlike && std::memcmp(next.constBits(), shown.constBits(), std::size_t(shown.sizeInBytes())) == 0;
}

void ViewportWidget::setStale(bool stale)
{
    if (std::exchange(m_stale, stale) != stale)
        update();
}

void ViewportWidget::setCanvasColor(const QColor& color)
{
    m_canvasColor = color;
    update();
}

void ViewportWidget::setThickLines(bool on)
{
    m_options.thickLines = on;
    if (m_fitted)
        applyFit();
    update();
}

void ViewportWidget::setAnswering(bool on)
{
    m_options.tells = !on;
    update();
    Q_EMIT pixelChanged();
}

void ViewportWidget::setCovered(const QRect& part)
{
    if (std::exchange(m_covered, part) != part)
        placeAgain();
}

void ViewportWidget::setCompared(const FramePtr& left, const QString& tag)
{
    if (!left && !m_options.wipe && tag == m_options.tag)
        return;
    if (left)
        m_wipe.left = left;
    m_options.wipe = left ? std::optional(m_wipe) : std::nullopt;
    m_options.tag = tag;
    update();
}

bool ViewportWidget::isOnWipe(QPointF canvas) const
{
    constexpr double kReach = 8;
    return m_options.wipe &&
           std::abs(canvas.x() - wipeColumn(m_wipe, pane(), m_transform, imageSize().width())) <= kReach;
}

void ViewportWidget::moveWipe(double column)
{
    setWipeAt(m_transform.toImage(QPointF(column, 0)).x() / imageSize().width());
}

void ViewportWidget::setWipeAt(double at)
{
    m_wipe.at = std::clamp(at, 0.0, 1.0);
    if (m_options.wipe)
        m_options.wipe = m_wipe;
    update();
}

void ViewportWidget::addLayer(const CanvasLayer* layer)
{
    m_options.layers.push_back(layer);
    update();
}

void ViewportWidget::removeLayer(const CanvasLayer* layer)
{
    std::erase(m_options.layers, layer);
    update();
}

void ViewportWidget::showPixel(QPoint pixel)
{
    const QRect cell = m_transform.toCanvas(QRectF(pixel, QSizeF(1, 1))).toAlignedRect();
    if (pane().contains(cell) && !m_covered.intersects(cell))
        return;
    leaveFit();
    setTransform({m_transform.zoom, QRectF(pane()).center() - (QPointF(pixel) + QPointF(0.5, 0.5)) * m_transform.zoom});
}

void ViewportWidget::setOverlays(const OverlayOptions& options)
{
    const bool paneChanges = options.depthBeside != m_options.depthBeside;
    m_options = options;
    syncDepth();
    if (paneChanges && m_fitted)
        applyFit();
    else if (paneChanges)
        setTransform(m_transform);
    update();
}

QRect ViewportWidget::pane() const
{
    return m_options.depthBeside ? QRect(0, 0, (width() - kPaneGap) / 2, height()) : rect();
}

QRect ViewportWidget::depthPane() const
{
    return m_options.depthBeside ? pane().translated(pane().width() + kPaneGap, 0) : QRect();
}

/// The place in the picture's pane that shows the pixel which is shown here, in either pane.
QPointF ViewportWidget::inPane(QPointF canvas) const
{
    return m_options.depthBeside && canvas.x() >= depthPane().left() ? canvas - depthPane().topLeft() : canvas;
}

void ViewportWidget::syncDepth() { m_depthShown = m_options.depthBeside && m_frame ? depthPicture(*m_frame) : nullptr; }

QSize ViewportWidget::imageSize() const { return m_frame ? m_frame->frame.image.size() : QSize(); }

void ViewportWidget::fit(const std::optional<PixelRect>& pixels)
{
    m_fitted = true;
    m_fitPixels = pixels;
    applyFit();
}

void ViewportWidget::applyFit()
{
    if (imageSize().isEmpty())
        return;
    QRectF shown(QPointF(0, 0), imageSize());
    if (m_fitPixels)
        shown = QRectF(m_fitPixels->x, m_fitPixels->y, m_fitPixels->width, m_fitPixels->height).intersected(shown);
    if (shown.isEmpty())
        return;
    setTransform(fittedBesideBadge(shown));
}

/// All of `shown`, in pixels of the picture, in the middle of a place on the canvas.
CanvasTransform ViewportWidget::fitted(const QRectF& shown, const QRect& place, int margin) const
{
    const QSizeF room(std::max(1, place.width() - 2 * margin), std::max(1, place.height() - 2 * margin));
    CanvasTransform transform;
    transform.zoom = fittingZoom(shown.size(), room, m_options.thickLines);
    transform.origin = QRectF(place).center() - shown.center() * transform.zoom;
    return transform;
}

/// In the whole pane, or below the badge where the picture would lie under it and does not become much smaller.
CanvasTransform ViewportWidget::fittedBesideBadge(const QRectF& shown) const
{
    const auto usual = [&](const QRect& place) {
        constexpr double kGain = 1.5; // whole pixels of the canvas make 1x into 2x, or 2x into 3x
        const CanvasTransform wide = fitted(shown, place, kFitMargin);
        const CanvasTransform narrow = fitted(shown, place, kNarrowMargin);
        return narrow.zoom >= kGain * wide.zoom ? narrow : wide;
    };
    const CanvasTransform whole = usual(pane());
    if (!whole.toCanvas(shown).toAlignedRect().intersects(m_covered))
        return whole;
    // Its margin belongs to the picture as well, and so do the names of corners at its border, unless the picture, or
    // the numbers in the pixels, would suffer.
    const int top = m_covered.bottom() + 1;
    const auto below = [&](int gap) { return pane().adjusted(0, top + gap, 0, 0); };
    const std::array places{usual(below(kNameRoom)), usual(below(-kFitMargin / 2)),
                            fitted(shown, below(0), kNarrowMargin)};
    const auto keepsNumbers = [&](const CanvasTransform& place) {
        return place.zoom >= kNumbersFromZoom || whole.zoom < kNumbersFromZoom;
    };
    constexpr double kWorth = 0.8; // of the size
    const auto isLarge = [&](const CanvasTransform& place) { return place.zoom >= kWorth * whole.zoom; };
    const auto best =
        std::ranges::find_if(places, [&](const auto& place) { return keepsNumbers(place) && isLarge(place); });
    if (best != places.end())
        return *best;
    const auto large = std::ranges::find_if(places, isLarge);
    return large != places.end() ? *large : whole;
}

/// From here on the user decides what is in sight.
void ViewportWidget::leaveFit()
{
    m_fitted = false;
    m_centre.reset();
}

void ViewportWidget::showAround(QPointF image, double zoom)
{
    m_fitted = false;
    m_centre = image;
    setTransform({zoom, middle() - image * zoom});
}

QPointF ViewportWidget::middle() const
{
    return QRectF(rect().adjusted(0, m_covered.isEmpty() ? 0 : m_covered.bottom() + 1, 0, 0)).center();
}

void ViewportWidget::zoomAt(QPointF canvas, double zoom)
{
    const QPointF image = m_transform.toImage(canvas);
    leaveFit();
    CanvasTransform transform;
    transform.zoom = zoom;
    transform.origin = canvas - image * zoom;
    setTransform(transform);
}

void ViewportWidget::setTransform(CanvasTransform transform)
{
    const QSizeF size = QSizeF(imageSize()) * transform.zoom;
    const auto keepVisible = [](double origin, double length, int room) {
        const double kept = std::min<double>(kKeptVisible, length);
        return std::clamp(origin, std::min(kept - length, room - kept), std::max(kept - length, room - kept));
    };
    transform.origin.setX(std::round(keepVisible(transform.origin.x(), size.width(), pane().width())));
    transform.origin.setY(std::round(keepVisible(transform.origin.y(), size.height(), height())));
    if (transform == m_transform)
        return;
    m_transform = transform;
    update();
    Q_EMIT viewChanged();
}

void ViewportWidget::selectPixel(std::optional<QPoint> pixel)
{
    if (pixel == m_options.selectedPixel)
        return;
    m_options.selectedPixel = pixel;
    update();
    Q_EMIT pixelChanged();
}

void ViewportWidget::hover(std::optional<QPoint> pixel)
{
    if (pixel && !QRect(QPoint(0, 0), imageSize()).contains(*pixel))
        pixel.reset();
    if (pixel == m_options.hoveredPixel)
        return;
    m_options.hoveredPixel = pixel;
    if (m_transform.zoom >= kGridFromZoom) // smaller pixels are not framed
        update();
    Q_EMIT pixelChanged();
}

void ViewportWidget::goToPixel(QPoint pixel)
{
    constexpr double kComfortable = 32;
    leaveFit();
    CanvasTransform transform;
    transform.zoom = std::max(m_transform.zoom, kComfortable);
    transform.origin = QRectF(pane()).center() - (QPointF(pixel) + QPointF(0.5, 0.5)) * transform.zoom;
    setTransform(transform);
    selectPixel(pixel);
}

std::optional<PixelReadout> ViewportWidget::readout(QPoint pixel) const
{
    if (!QRect(QPoint(0, 0), imageSize()).contains(pixel))
        return std::nullopt;
    const Frame& frame = m_frame->frame;
    PixelReadout readout{pixel, frame.image.pixel(pixel), std::nullopt, std::nullopt, -1};
    const auto index = static_cast<std::size_t>(pixel.y()) * static_cast<std::size_t>(frame.image.width()) +
                       static_cast<std::size_t>(pixel.x());
    if (m_frame->counted && index < frame.depth.size())
        readout.depth = frame.depth[index];
    if (m_frame->counted && index < frame.ids.size())
        readout.face = frame.ids[index];
    if (readout.face.value_or(-1) >= 0)
        readout.line = m_frame->scene->mesh.lineOf(static_cast<std::size_t>(*readout.face));
    return readout;
}

QImage ViewportWidget::figure(std::optional<int> zoom) const
{
    const auto part = figurePart(zoom);
    if (!part)
        return {};
    QImage image(part->size, QImage::Format_RGB32);
    if (image.isNull())
        return {};
    QPainter painter(&image);
    paintFigure(painter, *part);
    return image;
}

std::optional<QString> ViewportWidget::saveSvgFigure(std::optional<int> zoom, const ExportTarget& target) const
{
    const auto part = figurePart(zoom);
    return saveSvg(part ? part->size : QSize(), target, [&](QPainter& painter) { paintFigure(painter, *part); });
}

std::optional<ViewportWidget::FigurePart> ViewportWidget::figurePart(std::optional<int> zoom) const
{
    if (imageSize().isEmpty())
        return std::nullopt;
    CanvasTransform transform = m_transform;
    QRect canvas = m_transform.toCanvas(QRectF(QPointF(0, 0), imageSize())).toAlignedRect().intersected(pane());
    if (zoom) {
        transform = {static_cast<double>(*zoom), {0, 0}};
        const QSizeF size = QSizeF(imageSize()) * *zoom;
        if (size.width() >= kMaxFigureSide || size.height() >= kMaxFigureSide)
            return std::nullopt;
        canvas = QRect(QPoint(0, 0), size.toSize());
    }
    transform.origin -= canvas.topLeft();
    // One more column and row hold the grid lines that close the last pixels.
    const QSize closing = transform.zoom >= kGridFromZoom ? QSize(1, 1) : QSize(0, 0);
    const QSize picture = canvas.size() + closing;
    const QSize size = m_options.depthBeside ? QSize(2 * picture.width() + kPaneGap, picture.height()) : picture;
    if (size.width() > kMaxFigureSide)
        return std::nullopt;
    return FigurePart{transform, picture, size};
}

std::optional<ViewportWidget::FigurePart> ViewportWidget::partInSight(std::optional<int> zoom,
                                                                      const std::optional<QRect>& pixels) const
{
    if (!zoom && !pixels)
        return figurePart(zoom);
    const double scale = zoom ? double(*zoom) : m_transform.zoom;
    const QRect whole(QPoint(0, 0), imageSize());
    const QRect shown = pixels ? *pixels & whole : m_transform.pixelsIn(pane(), imageSize());
    const QSizeF size = QSizeF(shown.size()) * scale;
    if (shown.isEmpty() || size.width() >= kMaxFigureSide || size.height() >= kMaxFigureSide)
        return std::nullopt;
    const QSize closing = scale >= kGridFromZoom ? QSize(1, 1) : QSize(0, 0);
    const CanvasTransform transform{scale, -QPointF(shown.topLeft()) * scale};
    const QSize picture = size.toSize() + closing;
    return FigurePart{transform, picture, picture};
}

void ViewportWidget::paintFigure(QPainter& painter, const FigurePart& part, const RenderedFrame* instead) const
{
    OverlayOptions options = m_options;
    options.hoveredPixel.reset();
    if (options.wipe && options.wipe->at <= 0)
        options.wipe.reset(); // nothing of A is seen, and a line on paper cannot be dragged
    if (instead) {
        options.layers.clear();
        options.wipe.reset();
        options.tag.clear();
    }
    painter.fillRect(QRect(QPoint(0, 0), part.size), m_canvasColor);
    const QRect picture(QPoint(0, 0), part.picture);
    const RenderedFrame& frame = instead ? *instead : *m_frame;
    if (part.size == part.picture) {
        paintCanvas(painter, picture, part.transform, frame, options);
        return;
    }
    painter.save();
    painter.setClipRect(picture);
    paintCanvas(painter, picture, part.transform, frame, options);
    painter.translate(part.picture.width() + kPaneGap, 0);
    painter.setClipRect(picture);
    paintDepthPicture(painter, picture, part.transform, *m_frame, m_depthShown.get(), options);
    painter.restore();
}

/// The picture, and beside it the depth buffer from the same place at the same zoom.
void ViewportWidget::paintPanes(QPainter& painter) const
{
    if (!m_options.depthBeside) {
        paintCanvas(painter, rect(), m_transform, *m_frame, m_options);
        return;
    }
    painter.save();
    painter.setClipRect(pane());
    paintCanvas(painter, pane(), m_transform, *m_frame, m_options);
    painter.restore();
    painter.save();
    painter.translate(depthPane().topLeft());
    painter.setClipRect(pane());
    paintDepthPicture(painter, pane(), m_transform, *m_frame, m_depthShown.get(), m_options);
    painter.restore();
    painter.fillRect(QRect(pane().right() + 1, 0, kPaneGap, height()), palette().color(QPalette::Mid));
}

void ViewportWidget::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.fillRect(rect(), m_canvasColor);
    if (!imageSize().isEmpty())
        paintPanes(painter);
    if (m_stale && !imageSize().isEmpty())
        paintStaleMark(painter);
    if (hasFocus())
        paintFocus(painter);
    if (m_frame && !std::exchange(m_frameShown, true))
        Q_EMIT frameShown(m_frame);
}

/// A line along the edge: the keys are the canvas's.
void ViewportWidget::paintFocus(QPainter& painter) const
{
    constexpr double kWidth = 2;
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(QPen(palette().color(QPalette::Highlight), kWidth, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(QRectF(rect()).adjusted(kWidth / 2, kWidth / 2, -kWidth / 2, -kWidth / 2));
}

void ViewportWidget::paintStaleMark(QPainter& painter) const
{
    QColor veil = m_canvasColor;
    veil.setAlpha(140);
    painter.fillRect(rect(), veil);
    painter.setFont(textFont(1, true));
    const QString text = tr("former picture");
    const QRectF box = painter.boundingRect(QRectF(rect()), Qt::AlignHCenter | Qt::AlignTop, text)
                           .adjusted(-12, -5, 12, 5)
                           .translated(0, 16);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(40, 44, 52));
    painter.drawRoundedRect(box, 6, 6);
    painter.setPen(Qt::white);
    painter.drawText(box, Qt::AlignCenter, text);
}

void ViewportWidget::resizeEvent(QResizeEvent*) { placeAgain(); }

/// After the room for the picture has changed.
void ViewportWidget::placeAgain()
{
    if (m_fitted)
        applyFit();
    else if (m_centre)
        showAround(*m_centre, m_transform.zoom);
    else
        setTransform(m_transform);
}

} // namespace rasterlens
