#include "ui/window/guide_window.h"

#include "ui/base/parts.h"
#include "ui/window/guide_view.h"

#include <QDesktopServices>
#include <QEvent>
#include <QHBoxLayout>
#include <QListWidget>
#include <QScreen>
#include <QScrollBar>
#include <QShortcut>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace rasterlens
{
namespace
{

constexpr QSize kUsualSize(1180, 820);
constexpr double kContentsShare = 0.3; ///< of the window's width, at most

QFrame* newCard(QLayout* inside)
{
    auto* card = new QFrame;
    card->setObjectName(QStringLiteral("card"));
    card->setLayout(inside);
    return card;
}

} // namespace

GuideWindow::GuideWindow(QWidget* parent)
    : QWidget(parent, Qt::Window), m_view(new GuideView), m_contents(new QListWidget), m_back(makeLink()),
      m_toGuide(makeLink())
{
    constexpr int kGap = 7;
    setObjectName(QStringLiteral("guideWindow"));
    m_contents->setObjectName(QStringLiteral("lessonContents"));
    m_contents->setWordWrap(true);
    m_contents->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    for (QToolButton* link : {m_back, m_toGuide})
        link->setFocusPolicy(Qt::TabFocus);
    auto* links = new QHBoxLayout;
    links->addWidget(m_back);
    links->addWidget(m_toGuide);
    links->addStretch(1);
    auto* side = new QVBoxLayout;
    side->setContentsMargins(8, 8, 8, 8);
    side->addLayout(links);
    side->addWidget(m_contents, 1);
    auto* page = new QVBoxLayout;
    page->setContentsMargins(1, 4, 1, 4);
    page->addWidget(m_view);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(kGap, kGap, kGap, kGap);
    row->setSpacing(kGap);
    row->addWidget(newCard(side));
    row->addWidget(newCard(page), 1);
    connect(m_view, &QTextBrowser::anchorClicked, this, &GuideWindow::follow);
    connect(m_view->verticalScrollBar(), &QScrollBar::valueChanged, this, &GuideWindow::syncContents);
    connect(m_contents, &QListWidget::itemClicked, this,
            [this](QListWidgetItem* item) { goToHeading(item->data(Qt::UserRole).toUInt()); });
    connect(m_contents, &QListWidget::itemActivated, this,
            [this](QListWidgetItem* item) { goToHeading(item->data(Qt::UserRole).toUInt()); });
    connect(m_back, &QToolButton::clicked, this, &GuideWindow::goBack);
    connect(m_toGuide, &QToolButton::clicked, this, [this] { follow(QUrl(guideName())); });
    connect(new QShortcut(QKeySequence::Back, this), &QShortcut::activated, this, &GuideWindow::goBack);
    connect(new QShortcut(Qt::Key_Escape, this), &QShortcut::activated, this, &QWidget::close);
    retranslate();
}

QString GuideWindow::guideName() const
{
    return m_language == LanguageKind::Chinese ? QStringLiteral("GUIDE.zh.md") : QStringLiteral("GUIDE.md");
}

void GuideWindow::open()
{
    if (!isVisible() && !testAttribute(Qt::WA_Moved)) {
        const QSize room = screen()->availableSize() * 9 / 10;
        resize(kUsualSize.boundedTo(room));
        const QPoint middle = parentWidget() ? parentWidget()->geometry().center() : screen()->geometry().center();
        QRect place(QPoint(0, 0), size());
        place.moveCenter(middle);
        const QRect whole = screen()->availableGeometry();
        move(std::max(whole.left(), std::min(place.left(), whole.right() - width())),
             std::max(whole.top(), std::min(place.top(), whole.bottom() - height())));
    }
    if (m_view->page().isEmpty())
        showPage(guideName());
    const int place = m_view->verticalScrollBar()->value();
    show(); // which brings the cursor of the text into sight, at the first time
    m_view->verticalScrollBar()->setValue(place);
    raise();
    activateWindow();
    m_view->setFocus();
}

/// Keeps the section: both guides have the same ones.
void GuideWindow::setLanguage(LanguageKind kind)
{
    if (kind == m_language)
        return;
    const bool isGuide = m_view->page() == guideName();
    m_language = kind;
    if (!isGuide)
        return;
    const auto heading = m_view->headingInSight();
    m_visited.clear();
    showPage(guideName());
    if (heading)
        m_view->showHeading(*heading);
}

void GuideWindow::showPage(const QString& page)
{
    m_view->setPage(page);
    fillContents();
    retranslate();
}

void GuideWindow::fillContents()
{
    m_contents->clear();
    const auto& headings = m_view->headings();
    for (std::size_t i = 0; i < headings.size(); ++i) {
        if (headings[i].level > 2)
            continue;
        auto* item = new QListWidgetItem(headings[i].text, m_contents);
        item->setData(Qt::UserRole, static_cast<uint>(i));
        QFont font = m_contents->font();
        font.setBold(headings[i].level == 1);
        item->setFont(font);
    }
    syncContents();
}

void GuideWindow::remember() { m_visited.push_back({m_view->page(), m_view->verticalScrollBar()->value()}); }

void GuideWindow::goToHeading(std::size_t index)
{
    remember();
    m_view->showHeading(index);
    retranslate();
}

void GuideWindow::follow(const QUrl& link)
{
    if (!link.isRelative()) {
        if (link.scheme() == QLatin1String("http") || link.scheme() == QLatin1String("https"))
            QDesktopServices::openUrl(link);
        return;
    }
    const QString page = link.path().isEmpty() ? m_view->page() : link.path();
    if (!GuideView::hasPage(page))
        return;
    remember();
    if (page != m_view->page())
        showPage(page);
    const QString anchor = link.fragment(QUrl::FullyDecoded);
    if (const auto heading = m_view->headingNamed(anchor))
        m_view->showHeading(*heading);
    retranslate();
}

void GuideWindow::goBack()
{
    if (m_visited.empty())
        return;
    const Place place = m_visited.back();
    m_visited.pop_back();
    if (place.page != m_view->page())
        showPage(place.page);
    m_view->verticalScrollBar()->setValue(place.scroll);
    retranslate();
}

/// Marks the section that is being read.
void GuideWindow::syncContents()
{
    const auto heading = m_view->headingInSight();
    for (int row = m_contents->count() - 1; row >= 0 && heading; --row)
        if (m_contents->item(row)->data(Qt::UserRole).toUInt() <= *heading) {
            m_contents->setCurrentRow(row);
            return;
        }
}

void GuideWindow::retranslate()
{
    setWindowTitle(tr("Guide to RasterLens"));
    m_back->setText(QStringLiteral("\u2190 ") + tr("Back"));
    m_back->setToolTip(QKeySequence(QKeySequence::Back).toString(QKeySequence::NativeText));
    m_back->setEnabled(canGoBack());
    m_toGuide->setText(tr("Guide"));
    m_toGuide->setVisible(!m_view->page().isEmpty() && m_view->page() != guideName());
    fitContents();
}

void GuideWindow::fitContents()
{
    constexpr int kSpare = 24; // for the scroll bar and the items' margins
    const int most = static_cast<int>(width() * kContentsShare);
    m_contents->setFixedWidth(std::min(m_contents->sizeHintForColumn(0) + kSpare, most));
}

void GuideWindow::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    fitContents();
}

void GuideWindow::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::FontChange)
        retranslate();
    if (event->type() == QEvent::FontChange && !m_view->page().isEmpty()) {
        fillContents();
        fitContents();
    }
}

} // namespace rasterlens
