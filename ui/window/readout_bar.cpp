#include "ui/window/readout_bar.h"

#include "ui/base/elided_label.h"
#include "ui/base/numbers.h"
#include "ui/base/step_words.h"

#include <QHBoxLayout>
#include <QLabel>

namespace rasterlens
{
namespace
{

QString channelsText(const QColor& color)
{
    return QStringLiteral("%1 %2 %3").arg(color.red()).arg(color.green()).arg(color.blue());
}

} // namespace

ReadoutBar::ReadoutBar(QWidget* parent)
    : QWidget(parent), m_swatch(new QLabel), m_text(new ElidedLabel(QStringLiteral("readout")))
{
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    m_swatch->setFixedSize(18, 14);
    m_swatch->hide();
    row->addWidget(m_swatch);
    row->addWidget(m_text, 1);
}

QString ReadoutBar::text() const { return m_text->text(); }

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
    m_swatch->setStyleSheet(
        QStringLiteral("background: qlineargradient(x1:0, y1:0, x2:1, y2:0, stop:0.499 %1, stop:0.501 %2);"
                       "border: 1px solid gray;")
            .arg(a.name(), b.name()));
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
