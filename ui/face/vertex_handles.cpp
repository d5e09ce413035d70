#include "ui/face/vertex_handles.h"

#include "core/observe/step_text.h"
#include "core/questions/vertex_place.h"
#include "core/questions/vertex_table.h"
#include "ui/base/theme.h"

#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace rasterlens
{
namespace
{

constexpr double kRadius = 5.5;
constexpr double kReach = 10; ///< canvas pixels round a handle that grip it

/// A place that was dragged to, in 1/256 pixels: the finest of the places it may stop at.
QString placeText(QPointF pixels)
{
    constexpr double kParts = 256;
    const auto coordinate = [&](double value) { return fullNumber(std::round(value * kParts) / kParts); };
    return QStringLiteral("%1, %2").arg(coordinate(pixels.x()), coordinate(pixels.y()));
}

} // namespace

VertexHandles::VertexHandles(Document& document, ViewportWidget& canvas, const VertexEditing& editing)
    : QWidget(&canvas), m_document(document), m_canvas(canvas), m_editing(editing)
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    canvas.installEventFilter(this);
    resize(canvas.size());
    hide();
}

void VertexHandles::setActive(bool active)
{
    m_active = active;
    refresh();
}

void VertexHandles::refresh()
{
    m_handles.clear();
    const Scene& scene = *m_document.scene();
    if (m_active && isEditable(scene))
        for (std::uint32_t face = 0; face < scene.mesh.faceCount(); ++face)
            for (const VertexRow& corner : vertexTable(scene, m_document.settings(), face)) {
                const bool known = std::ranges::find(m_handles, corner.meshVertex, &Handle::vertex) != m_handles.end();
                const bool onScreen =
                    corner.clip.w > 0 && std::isfinite(corner.screen.x) && std::isfinite(corner.screen.y);
                if (!known && onScreen)
                    m_handles.push_back({corner.meshVertex, QPointF(corner.screen.x, corner.screen.y)});
            }
    setVisible(!m_handles.empty());
    update();
}

std::optional<QPointF> VertexHandles::screenOf(std::uint32_t vertex) const
{
    const auto handle = std::ranges::find(m_handles, vertex, &Handle::vertex);
    return handle == m_handles.end() ? std::nullopt : std::optional(handle->screen);
}

void VertexHandles::moveVertex(std::uint32_t vertex, QPointF screen)
{
    const Scene& scene = *m_document.scene();
    const QPointF to = snappedPlace(screen, m_editing.snap, m_document.settings().subpixelBits);
    const auto position = positionAtPixel(scene, m_document.settings(), vertex, {to.x(), to.y()});
    if (!position || scene.mesh.vertices[vertex].position == *position)
        return;
    m_document.editScene(m_editing.together ? withCorner(scene, vertex, *position)
                                            : withVertex(scene, vertex, *position),
                         Document::Edit::Camera);
}

QPointF VertexHandles::toCanvas(QPointF pixels) const
{
    return m_canvas.transform().toCanvas(QRectF(pixels, QSizeF(0, 0))).topLeft();
}

const VertexHandles::Handle* VertexHandles::handleAt(QPointF canvas) const
{
    const Handle* nearest = nullptr;
    double distance = kReach;
    for (const Handle& handle : m_handles) {
        const QPointF away = toCanvas(handle.screen) - canvas;
        if (const double length = std::hypot(away.x(), away.y()); length < distance) {
            nearest = &handle;
            distance = length;
        }
    }
    return nearest;
}

bool VertexHandles::eventFilter(QObject* watched, QEvent* event)
{
    if (watched != &m_canvas)
        return false;
    switch (event->type()) {
    case QEvent::Resize: resize(m_canvas.size()); return false;
    case QEvent::MouseButtonPress: {
        const auto* mouse = static_cast<QMouseEvent*>(event);
        const Handle* handle = mouse->button() == Qt::LeftButton ? handleAt(mouse->position()) : nullptr;
        if (handle == nullptr)
            return false;
        m_dragged = handle->vertex;
        m_grip = toCanvas(handle->screen) - mouse->position();
        return true;
    }
    case QEvent::MouseMove: {
        const auto* mouse = static_cast<QMouseEvent*>(event);
        if (!m_dragged) {
            if (mouse->buttons() == Qt::NoButton && !m_handles.empty())
                m_canvas.setCursor(handleAt(mouse->position()) ? Qt::SizeAllCursor : Qt::ArrowCursor);
            return false;
        }
        moveVertex(*m_dragged, m_canvas.transform().toImage(mouse->position() + m_grip));
        return true;
    }
    case QEvent::MouseButtonRelease:
        if (!m_dragged)
            return false;
        m_dragged.reset();
        m_document.endGesture();
        return true;
    default: return false;
    }
}

void VertexHandles::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(textFont(-0.5, true));
    for (const Handle& handle : m_handles) {
        const QPointF at = toCanvas(handle.screen);
        painter.setPen(QPen(Qt::white, 4));
        painter.setBrush(Qt::white);
        painter.drawEllipse(at, kRadius, kRadius);
        painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
        painter.drawEllipse(at, kRadius, kRadius);
        if (m_dragged != handle.vertex)
            continue;
        const QString text = placeText(handle.screen);
        QRectF box = painter.boundingRect(QRectF(at + QPointF(12, -26), QSizeF(1, 1)), Qt::AlignLeft, text);
        constexpr double kMargin = 8; // of the plate, too
        const QRectF room = QRectF(rect()).adjusted(kMargin, kMargin, -kMargin, -kMargin);
        box.moveLeft(std::max(room.left(), std::min(box.left(), room.right() - box.width())));
        box.moveTop(std::max(room.top(), std::min(box.top(), room.bottom() - box.height())));
        painter.setPen(Qt::NoPen);
        painter.setBrush(QColor(40, 44, 52));
        painter.drawRoundedRect(box.adjusted(-6, -3, 6, 3), 4, 4);
        painter.setPen(Qt::white);
        painter.drawText(box, Qt::AlignCenter, text);
    }
}

} // namespace rasterlens
