#include "ui/window/readout_bar.h"

#include "ui/base/elided_label.h"
#include "ui/base/numbers.h"
#include "ui/base/step_words.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>

#include <utility>

namespace rasterlens
{
namespace
{

QString channelsText(const QColor& color)
{
    return QStringLiteral("%1 %2 %3").arg(color.red()).arg(color.green()).arg(color.blue());
}

} // namespace

/// The colour of a pixel; where two pictures are compared, those of both.
class ColorPair : public QWidget
{
public:
    ColorPair() { setFixedSize(18, 14); }

    void setColors(const QColor& left, const QColor& right)
    {
        if (std::exchange(m_left, left) != left || std::exchange(m_right, right) != right)
            update();
    }

protected:
    void paintEvent(QPaintEvent*) override
    {
        QPainter painter(this);
        painter.fillRect(rect(), Qt::gray);
        const QRect inner = rect().adjusted(1, 1, -1, -1);
        painter.fillRect(inner, m_right);
        painter.fillRect(QRect(inner.topLeft(), QSize(inner.width() / 2, inner.height())), m_left);
    }

private:
    QColor m_left;
    QColor m_right;
};

ReadoutBar::ReadoutBar(QWidget* parent)
    : QWidget(parent), m_swatch(new ColorPair), m_text(new ElidedLabel(QStringLiteral("readout")))
{
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    m_swatch->hide();
    row->addWidget(m_swatch);
    row->addWidget(m_text, 1);
}

QString ReadoutBar::text() const { return m_text->text(); }

void ReadoutBar::showPlace(QPoint pixel)
{
    m_swatch->hide();
    m_text->setText(tr("pixel (%1, %2)").arg(pixel.x()).arg(pixel.y()));
    m_text->setToolTip(m_text->text());
}

void ReadoutBar::show(const std::optional<PixelReadout>& pixel, const std::optional<ComparedPixel>& compared,
                      const std::optional<std::size_t>& step)
{
    m_swatch->setVisible(pixel.has_value());
    if (!pixel) {
        m_text->clear();
        return;
    }
    const QColor a(compared ? compared->a : pixel->color);
    const QColor b(compared ? compared->b : pixel->color);
    m_swatch->setColors(a, b);
    QStringList parts;
    if (step)
        parts << momentText(step);
    parts << tr("pixel (%1, %2)").arg(pixel->pixel.x()).arg(pixel->pixel.y());
    if (compared)
        parts << QStringLiteral("A %1").arg(channelsText(a)) << QStringLiteral("B %1").arg(channelsText(b))
              << QStringLiteral("B \u2212 A %1").arg(channelChanges(compared->a, compared->b));
    else
        parts << channelsText(a) << a.name().toUpper();
    constexpr int kBackground = -1;
    const int face = pixel->face.value_or(kBackground);
    if (face != kBackground)
        parts << (pixel->line > 0 ? tr("face %1, line %2").arg(face).arg(pixel->line) : tr("face %1").arg(face))
              << tr("depth %1").arg(static_cast<double>(pixel->depth.value_or(1.0F)), 0, 'f', 6);
    else if (pixel->face.has_value())
        parts << tr("background");
    m_text->setText(parts.join(QStringLiteral("    ")));
    m_text->setToolTip(m_text->text());
}

} // namespace rasterlens
