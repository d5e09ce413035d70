#include "ui/steps/scrubber.h"

#include "ui/base/inks.h"

#include <QEvent>
#include <QGuiApplication>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <vector>

namespace rasterlens
{
namespace
{

constexpr int kMargin = 9; ///< room for half of the knob
constexpr int kTrackY = 17;
constexpr int kTrackHeight = 5;
constexpr double kKnobRadius = 7;

} // namespace

QColor pipColor(PipKind kind, const QPalette& palette)
{
    const Inks inks = inksFor(palette);
    const bool dark = isDark(palette);
    const auto readable = [dark](QRgb onLight, QRgb onDark) { return QColor(dark ? onDark : onLight); };
    switch (kind) {
    case PipKind::None: return Qt::transparent;
    case PipKind::Other: return palette.color(QPalette::Mid);
    case PipKind::Sample: return inks.plus;
    case PipKind::Outside: return inks.minus;
    case PipKind::Cull: return readable(0x6a3d9a, 0xc5a3e8);
    case PipKind::Clip: return readable(0x005f54, 0x4fc3b0);
    case PipKind::DepthFail: return readable(0x77466b, 0xe0a0cb);
    case PipKind::Tie: break;
    }
    return palette.color(QPalette::Text);
}

Scrubber::Scrubber(QWidget* parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setCursor(Qt::PointingHandCursor);
}

void Scrubber::setRecord(const std::shared_ptr<const StepRecord>& record)
{
    m_record = record;
    m_pips = QPixmap();
    update();
}

void Scrubber::setPosition(std::size_t position)
{
    m_position = position;
    update();
}

double Scrubber::xOf(std::size_t position) const
{
    const double size = m_record ? double(std::max<std::size_t>(m_record->size(), 1)) : 1;
    return kMargin + double(position) / size * (width() - 2 * kMargin - 1);
}

std::size_t Scrubber::positionAt(double x) const
{
    const double fraction = std::clamp((x - kMargin) / std::max(1, width() - 2 * kMargin - 1), 0.0, 1.0);
    return m_record ? std::size_t(std::llround(fraction * double(m_record->size()))) : 0;
}

void Scrubber::paintPips()
{
    m_pips = QPixmap(size());
    m_pips.fill(Qt::transparent);
    if (!m_record)
        return;
    QPainter painter(&m_pips);
    const std::vector<PipKind> bins = m_record->pips().columns(width() - 2 * kMargin);
    for (std::size_t i = 0; i < bins.size(); ++i) {
        if (bins[i] == PipKind::None)
            continue;
        const bool tall = bins[i] == PipKind::Tie || bins[i] == PipKind::DepthFail;
        const int height = tall ? 13 : bins[i] == PipKind::Other ? 5 : 8;
        painter.fillRect(kMargin + int(i), kTrackY - height, tall ? 2 : 1, height,
                         pipColor(bins[i], QGuiApplication::palette()));
    }
}

void Scrubber::paintEvent(QPaintEvent*)
{
    if (m_pips.isNull())
        paintPips();
    QPainter painter(this);
    painter.drawPixmap(0, 0, m_pips);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    const QColor accent = palette().color(QPalette::Highlight);
    QColor track = accent;
    track.setAlpha(64);
    painter.setBrush(track);
    painter.drawRoundedRect(QRectF(kMargin, kTrackY, width() - 2 * kMargin, kTrackHeight), 2, 2);
    if (!m_record)
        return;
    const double x = xOf(m_position);
    painter.setBrush(accent);
    painter.drawRoundedRect(QRectF(kMargin, kTrackY, x - kMargin, kTrackHeight), 2, 2);
    painter.setPen(QPen(palette().color(QPalette::Base), 1.5));
    painter.drawEllipse(QPointF(x, kTrackY + kTrackHeight / 2.0), kKnobRadius, kKnobRadius);
}

void Scrubber::resizeEvent(QResizeEvent*) { m_pips = QPixmap(); }

void Scrubber::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::ApplicationPaletteChange)
        m_pips = QPixmap();
    QWidget::changeEvent(event);
}

void Scrubber::mousePressEvent(QMouseEvent* event) { Q_EMIT moved(positionAt(event->position().x())); }

void Scrubber::mouseMoveEvent(QMouseEvent* event)
{
    if (event->buttons() & Qt::LeftButton)
        Q_EMIT moved(positionAt(event->position().x()));
}

} // namespace rasterlens
