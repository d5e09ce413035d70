#include "ui/truth/picture_strip.h"

#include "ui/base/inks.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace rasterlens
{
namespace
{

constexpr int kGap = 8;

} // namespace

PictureStrip::PictureStrip(QWidget* parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void PictureStrip::setPictures(std::vector<Picture> pictures, const QRect& marked)
{
    m_pictures = std::move(pictures);
    m_marked = marked;
    update();
}

void PictureStrip::paintEvent(QPaintEvent*)
{
    if (m_pictures.empty())
        return;
    QPainter painter(this);
    const int count = static_cast<int>(m_pictures.size());
    const int each = (width() - kGap * (count - 1)) / count;
    for (int i = 0; i < count; ++i)
        paintOne(painter, m_pictures[static_cast<std::size_t>(i)], QRect(i * (each + kGap), 0, each, height()));
}

void PictureStrip::paintOne(QPainter& painter, const Picture& picture, const QRect& room) const
{
    const int nameHeight = fontMetrics().height() + 2;
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(QRect(room.topLeft(), QSize(room.width(), nameHeight)), Qt::AlignLeft | Qt::AlignVCenter,
                     fontMetrics().elidedText(picture.name, Qt::ElideRight, room.width()));
    const QSize free(room.width() - 2, room.height() - nameHeight - 2);
    if (picture.image.isNull() || free.isEmpty())
        return;
    double zoom =
        std::min(double(free.width()) / picture.image.width(), double(free.height()) / picture.image.height());
    zoom = zoom >= 1 ? std::floor(zoom) : zoom;
    const QSize size = (QSizeF(picture.image.size()) * zoom).toSize().expandedTo({1, 1});
    const QRect target(room.topLeft() + QPoint(1, nameHeight + 1), size);
    const QImage shown =
        zoom < 1 ? picture.image.scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation) : picture.image;
    painter.setPen(palette().color(QPalette::Mid));
    painter.drawRect(target.adjusted(-1, -1, 0, 0));
    painter.drawImage(target, shown);
    if (m_marked.isEmpty() || m_marked == picture.image.rect())
        return;
    const QRectF marked(target.topLeft() + QPointF(m_marked.topLeft()) * zoom, QSizeF(m_marked.size()) * zoom);
    constexpr double kRoom = 3; // between the frame and what it is around
    const QRectF frame = marked.adjusted(-kRoom, -kRoom, kRoom, kRoom) & QRectF(target);
    painter.setPen(QPen(QColor(Qt::white), 3));
    painter.drawRect(frame);
    painter.setPen(QPen(QColor(kCanvasMinus), 1));
    painter.drawRect(frame);
}

} // namespace rasterlens
