#include "ui/pipeline/number_dial.h"

#include "core/render/render.h"
#include "ui/base/applicability.h"
#include "ui/base/inks.h"
#include "ui/base/theme.h"

#include <QCoreApplication>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace rasterlens
{
namespace
{

constexpr int kFloatStops = 2;
constexpr int kMargin = 10;
constexpr int kGroupGap = 8;
constexpr int kTrackHeight = 24;
constexpr int kGaugeHeight = 9;

int smallLine() { return QFontMetrics(textFont(-1)).height(); }

/// 1/256 or 2^-42, whichever is shorter to read.
QString powerOfTwo(int exponent)
{
    constexpr int kMostWritten = 16;
    if (exponent == 0)
        return QStringLiteral("1");
    if (exponent < -kMostWritten || exponent > 0)
        return QStringLiteral("2^%1").arg(exponent);
    return QStringLiteral("1/%1").arg(1 << -exponent);
}

} // namespace

NumberDial::NumberDial(Document& document, QWidget* parent) : QWidget(parent), m_document(document)
{
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    setMouseTracking(true);
    connect(&document, &Document::settingsChanged, this, [this] {
        retranslate();
        update();
    });
    retranslate();
}

int NumberDial::stop() const
{
    const Settings& settings = m_document.settings();
    const auto present = std::ranges::find_if(kStops, [&](const Stop& stop) {
        return stop.type == settings.numberType &&
               (stop.type != NumberType::Fixed || stop.subpixelBits == settings.subpixelBits);
    });
    return static_cast<int>(present - kStops.begin());
}

Settings NumberDial::withStop(Settings settings, int stop)
{
    const Stop& chosen = kStops[static_cast<std::size_t>(stop)];
    settings.numberType = chosen.type;
    if (chosen.type == NumberType::Fixed)
        settings.subpixelBits = chosen.subpixelBits;
    return settings;
}

std::optional<Reason> NumberDial::whyNot(int stop) const
{
    return unsupported(*m_document.scene(), withStop(m_document.settings(), stop));
}

void NumberDial::choose(int stop)
{
    if (!whyNot(stop))
        m_document.setSettings(withStop(m_document.settings(), stop));
}

QString NumberDial::unitText() const
{
    const Settings& settings = m_document.settings();
    const QString unit = powerOfTwo(numberBudget(settings).unitLog2);
    if (settings.numberType == NumberType::Fixed)
        return tr("1 unit = %1 px").arg(unit);
    return tr("step %1 px").arg(unit);
}

QString NumberDial::bitsText() const
{
    const NumberBudget budget = numberBudget(m_document.settings());
    return budget.left() >= 0 ? tr("%1 of %2 bits, %3 left").arg(budget.needed).arg(budget.available).arg(budget.left())
                              : tr("needs %1 bits, has %2").arg(budget.needed).arg(budget.available);
}

QSize NumberDial::sizeHint() const { return {270, 2 * smallLine() + kTrackHeight + kGaugeHeight + 12}; }

QRectF NumberDial::segment(int stop) const
{
    const double each = (width() - 2 * kMargin - kGroupGap) / static_cast<double>(kStops.size());
    const double x = kMargin + stop * each + (stop >= kFloatStops ? kGroupGap : 0);
    return {x, smallLine() + 2.0, each, kTrackHeight};
}

int NumberDial::stopAt(QPointF point) const
{
    for (int i = 0; i < static_cast<int>(kStops.size()); ++i)
        if (segment(i).contains(point))
            return i;
    return -1;
}

void NumberDial::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(textFont(-1));
    painter.setPen(palette().color(QPalette::PlaceholderText));
    const auto caption = [&](int first, int last, const QString& text) {
        const QRectF where(segment(first).left(), 0, segment(last).right() - segment(first).left(), smallLine());
        painter.drawText(where, Qt::AlignCenter, text);
    };
    caption(0, kFloatStops - 1, tr("float"));
    caption(kFloatStops, static_cast<int>(kStops.size()) - 1, tr("fixed point, bits after the point"));
    paintTrack(painter);

    const double top = segment(0).bottom() + 5;
    paintBits(painter, QRectF(kMargin, top, width() - 2 * kMargin, kGaugeHeight));
    const NumberBudget budget = numberBudget(m_document.settings());
    painter.setFont(textFont(-1));
    const QRectF words(kMargin, top + kGaugeHeight + 2, width() - 2 * kMargin, smallLine());
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(words, Qt::AlignLeft | Qt::AlignVCenter, unitText());
    painter.setPen(budget.left() >= 0 ? palette().color(QPalette::Text) : inksFor(palette()).minus);
    painter.drawText(words, Qt::AlignRight | Qt::AlignVCenter, bitsText());
}

void NumberDial::paintTrack(QPainter& painter) const
{
    const int present = stop();
    const QColor accent = palette().color(QPalette::Active, QPalette::Highlight);
    for (int i = 0; i < static_cast<int>(kStops.size()); ++i) {
        const QRectF box = segment(i).adjusted(0.5, 0.5, -0.5, -0.5);
        const bool possible = isEnabled() && !whyNot(i);
        painter.setPen(QPen(i == present && hasFocus() ? accent : palette().color(QPalette::Mid), 1));
        painter.setBrush(i == present ? accent : palette().color(QPalette::AlternateBase));
        if (!possible && i != present)
            painter.setBrush(Qt::NoBrush);
        painter.drawRoundedRect(box, 4, 4);
        if (i == present && hasFocus()) {
            painter.setPen(QPen(palette().color(QPalette::HighlightedText), 1));
            painter.setBrush(Qt::NoBrush);
            painter.drawRoundedRect(box.adjusted(2, 2, -2, -2), 3, 3);
        }
        painter.setFont(textFont(0, i == present));
        painter.setPen(palette().color(i == present ? QPalette::HighlightedText
                                       : possible   ? QPalette::Text
                                                    : QPalette::Mid));
        painter.drawText(box, Qt::AlignCenter, QLatin1String(kStops[static_cast<std::size_t>(i)].label));
    }
}

/// A box a bit: filled are those an edge value needs; beyond the border, hatched, those that are rounded away.
void NumberDial::paintBits(QPainter& painter, const QRectF& where) const
{
    const NumberBudget budget = numberBudget(m_document.settings());
    const int shown = std::max(budget.needed, budget.available);
    const double each = where.width() / shown;
    const Inks inks = inksFor(palette());
    painter.setPen(Qt::NoPen);
    for (int bit = 0; bit < shown; ++bit) {
        const QRectF box(where.left() + bit * each, where.top(), std::max(each - 1, 1.0), where.height());
        const bool needed = bit < budget.needed;
        if (bit < budget.available) {
            painter.fillRect(box, needed ? inks.plus : palette().color(QPalette::AlternateBase));
            continue;
        }
        painter.fillRect(box.adjusted(0, box.height() / 2 - 1, 0, 1 - box.height() / 2), inks.minus);
    }
    if (budget.left() < 0) {
        const double border = where.left() + budget.available * each - 0.5;
        painter.fillRect(QRectF(border - 1, where.top() - 3, 2, where.height() + 6), palette().color(QPalette::Text));
    }
}

void NumberDial::mousePressEvent(QMouseEvent* event)
{
    const int pressed = stopAt(event->position());
    if (event->button() == Qt::LeftButton && pressed >= 0)
        choose(pressed);
}

void NumberDial::mouseMoveEvent(QMouseEvent* event)
{
    const int at = stopAt(event->position());
    if (at >= 0 && (event->buttons() & Qt::LeftButton))
        choose(at);
    setCursor(at >= 0 && !whyNot(at) ? Qt::PointingHandCursor : Qt::ArrowCursor);
}

void NumberDial::keyPressEvent(QKeyEvent* event)
{
    const int step = event->key() == Qt::Key_Up ? -1 : event->key() == Qt::Key_Down ? 1 : 0;
    if (step == 0) {
        QWidget::keyPressEvent(event);
        return;
    }
    for (int next = stop() + step; next >= 0 && next < static_cast<int>(kStops.size()); next += step)
        if (!whyNot(next)) {
            choose(next);
            return;
        }
}

bool NumberDial::event(QEvent* event)
{
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        const int at = stopAt(help->pos());
        const auto why = at >= 0 ? whyNot(at) : std::nullopt;
        QToolTip::showText(help->globalPos(), why ? whyUnsupported(*why) : toolTip(), this);
        return true;
    }
    return QWidget::event(event);
}

void NumberDial::retranslate()
{
    setAccessibleName(tr("Number dial: %1, %2").arg(unitText(), bitsText()));
    setToolTip(QStringLiteral("<p>%1</p><p>%2</p>")
                   .arg(tr("The numbers that decide which samples are inside. Up and Down turn the dial."),
                        tr("The bar shows the bits of the largest edge value on this picture: filled are those it "
                           "needs; what does not fit into the number is rounded away, and samples close to an edge may "
                           "be decided wrongly.")));
}

void NumberDial::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::FontChange)
        updateGeometry();
}

} // namespace rasterlens
