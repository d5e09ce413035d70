#include "ui/window/help_overlay.h"

#include <QApplication>
#include <QEvent>
#include <QGraphicsDropShadowEffect>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>
#include <span>
#include <tuple>
#include <utility>

namespace rasterlens
{
namespace
{

constexpr std::size_t kMostColumns = 3;
constexpr std::size_t kHeading = 2; ///< lines that a heading takes
constexpr int kCell = 2;            ///< around a text of a line

QString htmlOf(const QString& title, std::span<const KeyLine> lines, const QPalette& palette)
{
    const QString accent = palette.color(QPalette::Highlight).name();
    const QString muted = palette.color(QPalette::PlaceholderText).name();
    QString html = QStringLiteral("<p style='margin:8px 0 3px 0'><b>%1</b></p><table cellspacing='0' cellpadding='%2'>")
                       .arg(title.toHtmlEscaped())
                       .arg(kCell);
    for (const KeyLine& line : lines)
        html +=
            QStringLiteral("<tr><td style='padding-right:12px'><b><span style='color:%1'>%2</span></b></td>"
                           "<td style='padding-right:10px'>%3</td><td style='color:%4'>%5</td></tr>")
                .arg(accent, line.keys.toHtmlEscaped(), line.what.toHtmlEscaped(), muted, line.state.toHtmlEscaped());
    return html + QStringLiteral("</table>");
}

} // namespace

HelpOverlay::HelpOverlay(QWidget* parent) : QFrame(parent), m_footer(new QLabel)
{
    setObjectName(QStringLiteral("card"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(22, 12, 22, 16);
    auto* row = new QHBoxLayout;
    row->setSpacing(28);
    for (std::size_t i = 0; i < kMostColumns; ++i) {
        auto* label = new QLabel;
        label->setTextFormat(Qt::RichText);
        label->setAlignment(Qt::AlignTop | Qt::AlignLeft);
        row->addWidget(label);
        m_columns.push_back(label);
    }
    column->addLayout(row);
    m_footer->setObjectName(QStringLiteral("muted"));
    m_footer->setAlignment(Qt::AlignRight);
    column->addWidget(m_footer);
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
    if (m_spread.columns == 0 || !fits(m_spread)) // mostly a state has changed, and the type is as good as it was
        choose();
    place();
}

bool HelpOverlay::turnPage()
{
    if (m_page + 1 >= m_pages.size())
        return false;
    ++m_page;
    place();
    return true;
}

/// So many columns of about equal height, with the sections in their order.
std::vector<HelpOverlay::Page> HelpOverlay::spreadOnOne(std::size_t columns) const
{
    std::size_t total = 0;
    for (const KeySection& section : m_sections)
        total += section.lines.size() + kHeading;
    Page page(columns);
    std::size_t used = 0;
    for (const KeySection& section : m_sections) {
        const std::size_t lines = section.lines.size() + kHeading;
        page[(2 * used + lines) * columns / (2 * total)] += htmlOf(section.title, section.lines, palette());
        used += lines;
    }
    return {page};
}

/// Columns of at most so many rows. A section that goes on in the next column has its heading there once more.
std::vector<HelpOverlay::Page> HelpOverlay::spreadOnSeveral(const Spread& spread) const
{
    constexpr std::size_t kLeast = 2; // lines below a heading
    std::vector<Page> pages{{QString()}};
    std::size_t used = 0;
    for (const KeySection& section : m_sections) {
        std::span<const KeyLine> left = section.lines;
        while (!left.empty()) {
            if (used > 0 && used + kHeading + std::min(kLeast, left.size()) > spread.rows) {
                if (pages.back().size() == spread.columns)
                    pages.emplace_back();
                pages.back().emplace_back();
                used = 0;
            }
            const std::size_t here = std::min(left.size(), std::max(kLeast, spread.rows - used - kHeading));
            pages.back().back() += htmlOf(section.title, left.first(here), palette());
            used += kHeading + here;
            left = left.subspan(here);
        }
    }
    return pages;
}

/// Spreads the sections so, and tells whether every page has room.
bool HelpOverlay::fits(const Spread& spread)
{
    m_spread = spread;
    m_pages = spread.rows == 0 ? spreadOnOne(spread.columns) : spreadOnSeveral(spread);
    bool fit = true;
    for (std::size_t page = 0; page < m_pages.size() && fit; ++page) {
        showPage(page);
        fit = width() <= parentWidget()->width() && height() <= parentWidget()->height();
    }
    return fit;
}

void HelpOverlay::setType(qreal points)
{
    QFont font = QApplication::font();
    font.setPointSizeF(points);
    for (QLabel* column : m_columns)
        column->setFont(font);
    m_footer->setFont(font);
}

/// The rows of a column that the window has room for beside the footer.
std::size_t HelpOverlay::rowsWithRoom() const
{
    const QMargins around = layout()->contentsMargins();
    const int line = m_columns.front()->fontMetrics().lineSpacing();
    const int height =
        parentWidget()->height() - around.top() - around.bottom() - layout()->spacing() - m_footer->sizeHint().height();
    return static_cast<std::size_t>(std::max(0, height)) / static_cast<std::size_t>(line + 2 * kCell + 1);
}

/// As large as everything else where there is room, somewhat smaller where there is not, and then on several pages.
void HelpOverlay::choose()
{
    const qreal usual = QApplication::font().pointSizeF();
    const qreal smallest = std::max(7.0, 0.7 * usual);
    for (qreal points = usual; points >= smallest; points -= 0.5) {
        setType(points);
        if (fits({2, 0}) || fits({kMostColumns, 0}))
            return;
    }
    const auto rows = [this] { return std::max(rowsWithRoom(), kHeading + 1); };
    for (qreal points = usual; points >= smallest; points -= 1) {
        setType(points);
        if (fits({kMostColumns, rows()}) || fits({2, rows()}))
            return;
    }
    setType(usual);
    std::ignore = fits({1, rows()});
}

void HelpOverlay::showPage(std::size_t page)
{
    for (std::size_t i = 0; i < m_columns.size(); ++i) {
        const bool isUsed = i < m_pages[page].size();
        m_columns[i]->setText(isUsed ? m_pages[page][i] : QString());
        m_columns[i]->setVisible(isUsed);
    }
    m_footer->setText(tr("Page %1 of %2 \u00b7 F1: the next one").arg(page + 1).arg(m_pages.size()));
    m_footer->setVisible(m_pages.size() > 1);
    layout()->activate();
    adjustSize();
}

void HelpOverlay::place()
{
    m_page = std::min(m_page, m_pages.size() - 1);
    showPage(m_page);
    const QSize room = parentWidget()->size();
    move(std::max(0, (room.width() - width()) / 2), std::max(0, (room.height() - height()) / 2));
    raise();
}

void HelpOverlay::mousePressEvent(QMouseEvent*)
{
    if (!turnPage())
        hide();
}

void HelpOverlay::showEvent(QShowEvent* event)
{
    m_page = 0;
    choose();
    place();
    QFrame::showEvent(event);
}

void HelpOverlay::changeEvent(QEvent* event)
{
    QFrame::changeEvent(event);
    if (isVisible() && (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)) {
        choose(); // colours and type are in its texts
        place();
    }
}

bool HelpOverlay::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == parentWidget() && event->type() == QEvent::Resize && isVisible()) {
        choose();
        place();
    }
    return QFrame::eventFilter(watched, event);
}

} // namespace rasterlens
