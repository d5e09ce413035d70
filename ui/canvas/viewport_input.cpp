// The canvas under mouse and keys.
#include "ui/canvas/viewport_widget.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <utility>

namespace rasterlens
{
namespace
{

constexpr int kWheelNotch = 120;
constexpr int kDragThreshold = 3;
constexpr double kDollyPerNotch = 0.9;
constexpr double kDollyPerPixel = 1.005;

} // namespace

void ViewportWidget::wheelEvent(QWheelEvent* event)
{
    m_wheelRest += event->angleDelta().y();
    const int notches = m_wheelRest / kWheelNotch;
    m_wheelRest -= notches * kWheelNotch;
    event->accept();
    if (notches == 0)
        return;
    if (event->modifiers() & Qt::ControlModifier) {
        Q_EMIT dollied(std::pow(kDollyPerNotch, notches));
        m_wheelGesture.start();
        return;
    }
    double zoom = m_transform.zoom;
    for (int i = 0; i < std::abs(notches); ++i)
        zoom = nextZoomStep(zoom, notches);
    zoomAt(inPane(event->position()), zoom);
    hover(m_transform.pixelAt(inPane(event->position())));
}

ViewportWidget::Drag ViewportWidget::dragFor(const QMouseEvent& event) const
{
    switch (event.button()) {
    case Qt::MiddleButton: return Drag::PanCanvas;
    case Qt::RightButton: return Drag::Dolly;
    case Qt::LeftButton: break;
    default: return Drag::None;
    }
    if (event.modifiers() & Qt::ShiftModifier)
        return Drag::PanCanvas;
    if (m_leftDrag == LeftDrag::PansCanvas)
        return Drag::PanCanvas;
    return event.modifiers() & Qt::ControlModifier ? Drag::PanCamera : Drag::Orbit;
}

void ViewportWidget::mousePressEvent(QMouseEvent* event)
{
    m_drag = event->button() == Qt::LeftButton && isOnWipe(event->position()) ? Drag::Wipe : dragFor(*event);
    m_pressedAt = event->position();
    m_lastDragAt = event->position();
    m_moved = false;
}

void ViewportWidget::mouseMoveEvent(QMouseEvent* event)
{
    const QPointF at = event->position();
    hover(m_transform.pixelAt(inPane(at)));
    if (m_drag == Drag::None) {
        isOnWipe(at) ? setCursor(Qt::SplitHCursor) : unsetCursor();
        return;
    }
    if (!m_moved && (at - m_pressedAt).manhattanLength() < kDragThreshold)
        return;
    m_moved = true;
    const QPointF drag = at - m_lastDragAt;
    m_lastDragAt = at;
    // Camera moves are meant in viewport pixels, whatever the zoom; a close-up is not to make the camera creep.
    const double scale = std::min(m_transform.zoom, 1.0);
    switch (m_drag) {
    case Drag::PanCanvas:
        leaveFit();
        setTransform({m_transform.zoom, m_transform.origin + drag});
        setCursor(Qt::ClosedHandCursor);
        break;
    case Drag::Orbit: Q_EMIT orbited(drag / scale); break;
    case Drag::PanCamera: Q_EMIT cameraPanned(drag / m_transform.zoom); break;
    case Drag::Dolly: Q_EMIT dollied(std::pow(kDollyPerPixel, drag.y())); break;
    case Drag::Wipe: moveWipe(at.x()); break;
    case Drag::None: break;
    }
}

void ViewportWidget::mouseReleaseEvent(QMouseEvent* event)
{
    if (m_drag == Drag::None)
        return;
    const bool clicked = !m_moved && event->button() == Qt::LeftButton;
    m_drag = Drag::None;
    unsetCursor();
    if (clicked) {
        choose(m_transform.pixelAt(inPane(event->position())));
    }
    Q_EMIT gestureEnded();
}

/// in  a pixel, or a place beside the picture
void ViewportWidget::choose(QPoint pixel)
{
    const bool isThere = QRect(QPoint(0, 0), imageSize()).contains(pixel);
    if (isAnswering()) {
        if (isThere)
            Q_EMIT pixelAnswered(pixel);
        return;
    }
    selectPixel(isThere ? std::optional(pixel) : std::nullopt);
    if (isThere)
        Q_EMIT pixelChosen();
}

void ViewportWidget::mouseDoubleClickEvent(QMouseEvent* event)
{
    if (isAnswering()) { // the second of two clicks
        mousePressEvent(event);
        return;
    }
    const QPoint pixel = m_transform.pixelAt(inPane(event->position()));
    if (event->button() == Qt::LeftButton && QRect(QPoint(0, 0), imageSize()).contains(pixel))
        goToPixel(pixel);
}

void ViewportWidget::nudge(QPoint step)
{
    if (imageSize().isEmpty())
        return;
    const QPoint hovered = m_options.hoveredPixel.value_or(m_transform.pixelAt(QRectF(pane()).center()) - step);
    const QPoint from = isAnswering() ? hovered : m_options.selectedPixel.value_or(hovered);
    const QSize size = imageSize();
    const QPoint to(std::clamp(from.x() + step.x(), 0, size.width() - 1),
                    std::clamp(from.y() + step.y(), 0, size.height() - 1));
    if (isAnswering())
        hover(to);
    else
        selectPixel(to);
    showPixel(to);
}

/// While pixels are an answer the arrows move from pixel to pixel, and not from step to step.
bool ViewportWidget::event(QEvent* event)
{
    if (isAnswering() && event->type() == QEvent::ShortcutOverride) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Up || key == Qt::Key_Down) {
            event->accept();
            return true;
        }
    }
    return QWidget::event(event);
}

void ViewportWidget::keyPressEvent(QKeyEvent* event)
{
    const int step = event->modifiers() & Qt::ShiftModifier ? 10 : 1;
    switch (event->key()) {
    case Qt::Key_Left: nudge({-step, 0}); return;
    case Qt::Key_Right: nudge({step, 0}); return;
    case Qt::Key_Up: nudge({0, -step}); return;
    case Qt::Key_Down: nudge({0, step}); return;
    default: break;
    }
    QWidget::keyPressEvent(event);
}

void ViewportWidget::leaveEvent(QEvent*) { hover(std::nullopt); }

} // namespace rasterlens
