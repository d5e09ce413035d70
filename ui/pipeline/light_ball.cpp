#include "ui/pipeline/light_ball.h"

#include <QImage>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace rasterlens
{
namespace
{

/// A point of the widget from its middle, in radii of the ball, y up.
glm::dvec2 onBall(const QWidget& widget, QPointF at)
{
    const double radius = std::min(widget.width(), widget.height()) / 2.0;
    const QPointF middle(widget.width() / 2.0, widget.height() / 2.0);
    return {(at.x() - middle.x()) / radius, (middle.y() - at.y()) / radius};
}

} // namespace

LightBall::LightBall(QWidget* parent) : QWidget(parent)
{
    setFixedSize(sizeHint());
    setCursor(Qt::CrossCursor);
}

void LightBall::setLight(const glm::dvec3& towardsView)
{
    m_light = glm::normalize(towardsView);
    update();
}

void LightBall::paintEvent(QPaintEvent*)
{
    const qreal ratio = devicePixelRatioF();
    QImage image((QSizeF(size()) * ratio).toSize(), QImage::Format_ARGB32_Premultiplied);
    image.setDevicePixelRatio(ratio);
    const double rim = std::min(width(), height()) * ratio / 2;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const glm::dvec2 p = onBall(*this, QPointF(x + 0.5, y + 0.5) / ratio);
            const double far = glm::length(p);
            const double cover = std::clamp((1 - far) * rim + 0.5, 0.0, 1.0); // a smooth outline
            const glm::dvec3 normal(p, std::sqrt(std::max(1 - far * far, 0.0)));
            const double bright = 0.2 + 0.8 * std::max(glm::dot(normal, m_light), 0.0);
            const int grey = static_cast<int>(255 * bright * cover);
            image.setPixel(x, y, qRgba(grey, grey, grey, static_cast<int>(255 * cover)));
        }
    QPainter painter(this);
    painter.drawImage(0, 0, image);
    painter.setRenderHint(QPainter::Antialiasing);
    const QPointF spot((m_light.x + 1) * width() / 2, (1 - m_light.y) * height() / 2);
    painter.setPen(QPen(palette().color(QPalette::Highlight), 1.5));
    painter.setBrush(m_light.z >= 0 ? palette().brush(QPalette::Highlight) : QBrush(Qt::NoBrush));
    painter.drawEllipse(spot, 2.5, 2.5);
}

void LightBall::drag(const QMouseEvent& event)
{
    glm::dvec2 at = onBall(*this, event.position());
    const double far = glm::length(at);
    if (far > 1)
        at /= far;
    const double towardsEye = std::sqrt(std::max(1 - far * far, 0.0));
    const bool isBehind = event.modifiers().testFlag(Qt::ShiftModifier);
    Q_EMIT dragged(glm::dvec3(at, isBehind ? -towardsEye : towardsEye));
}

void LightBall::mousePressEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton)
        drag(*event);
}

void LightBall::mouseMoveEvent(QMouseEvent* event)
{
    if (event->buttons().testFlag(Qt::LeftButton))
        drag(*event);
}

void LightBall::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton)
        Q_EMIT dropped();
}

} // namespace rasterlens
