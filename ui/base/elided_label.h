#pragma once
#include <QLabel>
#include <QPainter>
#include <QStyle>
#include <QStyleOption>

namespace rasterlens
{

/// A line of text that ends in dots where it has no room, and that never widens what holds it.
class ElidedLabel : public QLabel
{
public:
    explicit ElidedLabel(const QString& style = QStringLiteral("muted"))
    {
        setObjectName(style);
        setTextFormat(Qt::PlainText);
        setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    }

protected:
    void paintEvent(QPaintEvent*) override
    {
        QPainter painter(this);
        QStyleOption option;
        option.initFrom(this);
        style()->drawPrimitive(QStyle::PE_Widget, &option, &painter, this); // what the style sheet gives it
        painter.setPen(palette().color(foregroundRole()));
        const QRect room = contentsRect();
        painter.drawText(room, int(alignment()), fontMetrics().elidedText(text(), Qt::ElideRight, room.width()));
    }
};

} // namespace rasterlens
