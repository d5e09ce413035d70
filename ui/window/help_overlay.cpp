#include "ui/window/help_overlay.h"

#include <QApplication>
#include <QEvent>
#include <QGraphicsDropShadowEffect>
#include <QHBoxLayout>
#include <QLabel>

#include <algorithm>
#include <utility>

namespace rasterlens
{
namespace
{

constexpr std::size_t kMostColumns = 3;

QString htmlOf(const KeySection& section, const QPalette& palette)
{
    const QString accent = palette.color(QPalette::Highlight).name();
    const QString muted = palette.color(QPalette::PlaceholderText).name();
    QString html = QStringLiteral("<p style='margin:8px 0 3px 0'><b>%1</b></p><table cellspacing='0' cellpadding='2'>")
                       .arg(section.title.toHtmlEscaped());
    for (const KeyLine& line : section.lines)
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
    for (std::size_t i = 0; i < kMostColumns; ++i) {
        auto* label = new QLabel;
        label->setTextFormat(Qt::RichText);
        label->setAlignment(Qt::AlignTop | Qt::AlignLeft);
        row->addWidget(label);
        m_columns.push_back(label);
    }
    auto* shadow = new QGraphicsDropShadowEffect(this);
    shadow->setBlurRadius(32);
    shadow->setOffset(0, 6);
    shadow->setColor(QColor(0, 0, 0, 110));
    setGraphicsEffect(shadow);
    parent->installEventFilter(this);
    hide();
}

void HelpOverlay::setSections(std::vector<KeySection> sections)
{
    if (sections == m_sections)
        return;
    m_sections = std::move(sections);
    if (m_usedColumns == 0 || !fits(m_usedColumns)) // mostly a state has changed, and the type is as good as it was
        place();
}

/// Spreads the sections over so many columns of about equal height, in their order.
void HelpOverlay::fill(std::size_t columns)
{
    constexpr std::size_t kHeading = 2; // lines that a heading takes
    std::size_t total = 0;
    for (const KeySection& section : m_sections)
        total += section.lines.size() + kHeading;
    std::vector<QString> texts(m_columns.size());
    std::size_t used = 0;
    for (const KeySection& section : m_sections) {
        const std::size_t lines = section.lines.size() + kHeading;
        texts[(2 * used + lines) * columns / (2 * total)] += htmlOf(section, palette());
        used += lines;
    }
    for (std::size_t i = 0; i < m_columns.size(); ++i) {
        m_columns[i]->setText(texts[i]);
        m_columns[i]->setVisible(i < columns);
    }
}

/// Whether the sections have room in so many columns.
bool HelpOverlay::fits(std::size_t columns)
{
    m_usedColumns = columns;
    fill(columns);
    layout()->activate();
    adjustSize();
    return width() <= parentWidget()->width() && height() <= parentWidget()->height();
}

void HelpOverlay::place()
{
    // As large as everything else where there is room, smaller where there is not.
    constexpr qreal kSmallest = 7;
    for (qreal points = QApplication::font().pointSizeF(); points >= kSmallest; points -= 0.5) {
        QFont font = QApplication::font();
        font.setPointSizeF(points);
        for (QLabel* column : m_columns)
            column->setFont(font);
        if (fits(2) || fits(kMostColumns))
            break;
    }
    const QSize room = parentWidget()->size();
    move(std::max(0, (room.width() - width()) / 2), std::max(0, (room.height() - height()) / 2));
    raise();
}

void HelpOverlay::mousePressEvent(QMouseEvent*) { hide(); }

void HelpOverlay::showEvent(QShowEvent* event)
{
    place();
    QFrame::showEvent(event);
}

void HelpOverlay::changeEvent(QEvent* event)
{
    QFrame::changeEvent(event);
    if (isVisible() && (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange))
        place(); // colours and type are in its texts
}

bool HelpOverlay::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == parentWidget() && event->type() == QEvent::Resize && isVisible())
        place();
    return QFrame::eventFilter(watched, event);
}

} // namespace rasterlens
