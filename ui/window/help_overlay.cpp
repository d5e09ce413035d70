#include "ui/window/help_overlay.h"

#include <QApplication>
#include <QEvent>
#include <QGraphicsDropShadowEffect>
#include <QHBoxLayout>
#include <QLabel>

#include <algorithm>

namespace rasterlens
{
namespace
{

QString htmlOf(const HelpOverlay::Section& section, const QPalette& palette)
{
    const QString accent = palette.color(QPalette::Highlight).name();
    const QString muted = palette.color(QPalette::PlaceholderText).name();
    QString html = QStringLiteral("<p style='margin:8px 0 3px 0'><b>%1</b></p><table cellspacing='0' cellpadding='2'>")
                       .arg(section.title.toHtmlEscaped());
    for (const HelpOverlay::Line& line : section.lines)
        html +=
            QStringLiteral("<tr><td style='padding-right:12px'><b><span style='color:%1'>%2</span></b></td>"
                           "<td style='padding-right:10px'>%3</td><td style='color:%4'>%5</td></tr>")
                .arg(accent, line.keys.toHtmlEscaped(), line.what.toHtmlEscaped(), muted, line.state.toHtmlEscaped());
    return html + QStringLiteral("</table>");
}

} // namespace

HelpOverlay::HelpOverlay(QWidget* parent) : QFrame(parent)
{
    setObjectName(QStringLiteral("card"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(22, 12, 22, 16);
    row->setSpacing(28);
    for (QLabel** label : {&m_left, &m_right}) {
        *label = new QLabel;
        (*label)->setTextFormat(Qt::RichText);
        (*label)->setAlignment(Qt::AlignTop | Qt::AlignLeft);
        row->addWidget(*label);
    }
    auto* shadow = new QGraphicsDropShadowEffect(this);
    shadow->setBlurRadius(32);
    shadow->setOffset(0, 6);
    shadow->setColor(QColor(0, 0, 0, 110));
    setGraphicsEffect(shadow);
    parent->installEventFilter(this);
    hide();
}

void HelpOverlay::setSections(const std::vector<Section>& sections)
{
    std::size_t total = 0;
    for (const Section& section : sections)
        total += section.lines.size() + 2;
    QString left;
    QString right;
    std::size_t used = 0;
    for (const Section& section : sections) {
        (used * 2 + section.lines.size() < total ? left : right) += htmlOf(section, palette());
        used += section.lines.size() + 2;
    }
    m_left->setText(left);
    m_right->setText(right);
    place();
}

void HelpOverlay::place()
{
    // As large as everything else where there is room, smaller where there is not.
    const QSize room = parentWidget()->size();
    constexpr qreal kSmallest = 7;
    for (qreal points = QApplication::font().pointSizeF(); points >= kSmallest; points -= 0.5) {
        QFont font = QApplication::font();
        font.setPointSizeF(points);
        m_left->setFont(font);
        m_right->setFont(font);
        layout()->activate();
        adjustSize();
        if (width() <= room.width() && height() <= room.height())
            break;
    }
    move(std::max(0, (room.width() - width()) / 2), std::max(0, (room.height() - height()) / 2));
    raise();
}

void HelpOverlay::mousePressEvent(QMouseEvent*) { hide(); }

bool HelpOverlay::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == parentWidget() && event->type() == QEvent::Resize && isVisible())
        place();
    return QFrame::eventFilter(watched, event);
}

} // namespace rasterlens
