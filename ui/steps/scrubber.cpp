#include "ui/steps/scrubber.h"

#include "ui/base/inks.h"

#include <QEvent>
#include <QGuiApplication>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>

namespace rasterlens
{
namespace
{

constexpr int kMargin = 9; ///< room for half of the knob
constexpr int kTrackY = 17;
constexpr int kTrackHeight = 5;
constexpr double kKnobRadius = 7;

} // namespace

PipKind pipKindOf(const StepEvent& event)
{
    if (event.has(StepEvent::kTie))
        return PipKind::Tie;
    switch (event.kind) {
    case StepKind::ClipPlane:
    case StepKind::CohenSutherland:
    case StepKind::Clipped: return PipKind::Clip;
    case StepKind::Facing:
    case StepKind::Fate: return PipKind::Cull;
    case StepKind::Sample: return event.has(StepEvent::kCovered) ? PipKind::Sample : PipKind::Outside;
    case StepKind::Span:
    case StepKind::Column:
    case StepKind::LineSample: return PipKind::Sample;
    case StepKind::Fragment: return event.has(StepEvent::kPassed) ? PipKind::Other : PipKind::DepthFail;
    case StepKind::Vertex:
    case StepKind::Viewport:
    case StepKind::Triangle:
    case StepKind::Setup:
    case StepKind::Outline:
    case StepKind::Walk:
    case StepKind::Sides:
    case StepKind::Halves:
    case StepKind::Crossing:
    case StepKind::LineDecision:
    case StepKind::Shade:
    case StepKind::Write:
    case StepKind::Resolve:
    case StepKind::End: break;
    }
    return PipKind::Other;
}

QColor pipColor(PipKind kind, const QPalette& palette)
{
    const Inks inks = inksFor(palette);
    const bool dark = isDark(palette);
    const auto readable = [dark](QRgb color) { return dark ? QColor(color).lighter(165) : QColor(color); };
    switch (kind) {
    case PipKind::None: return Qt::transparent;
    case PipKind::Other: return palette.color(QPalette::Mid);
    case PipKind::Sample: return inks.plus;
    case PipKind::Outside: return inks.minus;
    case PipKind::Cull: return readable(0x6a3d9a);
    case PipKind::Clip: return readable(0x005f54);
    case PipKind::DepthFail: return readable(0x7a4a6e);
    case PipKind::Tie: break;
    }
    return palette.color(QPalette::Text);
}

std::vector<PipKind> binPips(const StepLog& log, int columns)
{
    const auto width = std::size_t(std::max(columns, 1));
    std::vector<std::array<std::uint32_t, kPipKinds>> counts(width);
    const double perEvent = double(width - 1) / std::max(1.0, double(log.size()));
    for (std::size_t i = 0; i < log.size(); ++i)
        ++counts[std::size_t(double(i + 1) * perEvent)][std::size_t(pipKindOf(log.event(i)))];

    constexpr auto kCommon = std::size_t(PipKind::Cull);
    std::vector<PipKind> bins(width, PipKind::None);
    for (std::size_t column = 0; column < width; ++column) {
        const auto& count = counts[column];
        std::size_t shown = count[std::size_t(PipKind::Other)] > 0 ? std::size_t(PipKind::Other) : 0;
        for (std::size_t kind = std::size_t(PipKind::Sample); kind < kPipKinds; ++kind) {
            const bool outnumbers = count[kind] > (shown > std::size_t(PipKind::Other) ? count[shown] : 0);
            if (kind <= kCommon ? outnumbers : count[kind] > 0)
                shown = kind;
        }
        bins[column] = PipKind(shown);
    }
    return bins;
}

Scrubber::Scrubber(QWidget* parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setCursor(Qt::PointingHandCursor);
}

void Scrubber::setLog(const std::shared_ptr<const StepLog>& log)
{
    m_log = log;
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
    const double size = m_log ? double(std::max<std::size_t>(m_log->size(), 1)) : 1;
    return kMargin + double(position) / size * (width() - 2 * kMargin - 1);
}

std::size_t Scrubber::positionAt(double x) const
{
    const double fraction = std::clamp((x - kMargin) / std::max(1, width() - 2 * kMargin - 1), 0.0, 1.0);
    return m_log ? std::size_t(std::llround(fraction * double(m_log->size()))) : 0;
}

void Scrubber::paintPips()
{
    m_pips = QPixmap(size());
    m_pips.fill(Qt::transparent);
    if (!m_log)
        return;
    QPainter painter(&m_pips);
    const std::vector<PipKind> bins = binPips(*m_log, width() - 2 * kMargin);
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
    if (!m_log)
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
