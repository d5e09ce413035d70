#include "ui/pipeline/views_bar.h"

#include "ui/base/parts.h"
#include "ui/pipeline/canvas_views.h"

#include <QAction>
#include <QEvent>
#include <QFontMetrics>
#include <QMenu>
#include <QToolButton>

#include <algorithm>

namespace rasterlens
{
namespace
{

constexpr std::size_t kLeastOpen = 3; ///< fewer views than this are not worth a second menu beside them
const QString kArrow = QStringLiteral(" \u25be");
constexpr int kSpacing = 1;
constexpr int kGroupGap = 8; ///< between the views and the overlays

QToolButton* buttonFor(QAction* action, QWidget* parent)
{
    QToolButton* button = makeLink();
    button->setParent(parent);
    button->setFocusPolicy(Qt::TabFocus);
    button->setDefaultAction(action);
    return button;
}

QToolButton* foldFor(QMenu* menu, QWidget* parent)
{
    QToolButton* fold = makeMenuLink(menu);
    fold->setParent(parent);
    fold->setFocusPolicy(Qt::TabFocus);
    return fold;
}

} // namespace

ViewsBar::ViewsBar(CanvasViews& views, QAction* difference, QWidget* parent)
    : QWidget(parent), m_views(views), m_difference(difference), m_viewMenu(new QMenu(this)),
      m_overlayMenu(new QMenu(this)), m_allMenu(new QMenu(this)), m_viewFold(foldFor(m_viewMenu, this)),
      m_overlayFold(foldFor(m_overlayMenu, this)), m_allFold(foldFor(m_allMenu, this))
{
    setObjectName(QStringLiteral("viewsBar"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    std::vector<QAction*> actions = views.viewActions();
    actions.push_back(difference);
    for (QAction* action : actions) {
        m_viewButtons.push_back(buttonFor(action, this));
        m_viewMenu->addAction(action);
        m_allMenu->addAction(action);
    }
    m_allMenu->addSeparator();
    for (std::size_t i = 0; i < canvasOverlays().size(); ++i) {
        QAction* action = views.overlayActions()[i];
        if (canvasOverlays()[i].shortTitle)
            m_overlayButtons.push_back(buttonFor(action, this));
        m_overlayMenu->addAction(action);
        m_allMenu->addAction(action);
    }
    connect(&views, &CanvasViews::changed, this, &ViewsBar::sync);
    connect(difference, &QAction::toggled, this, &ViewsBar::sync);
    retranslate();
}

void ViewsBar::retranslate()
{
    m_difference->setIconText(tr("Difference"));
    m_overlayFold->setText(tr("Overlays") + kArrow);
    m_overlayFold->setToolTip(tr("What is laid over the picture"));
    m_viewFold->setToolTip(tr("What the canvas shows"));
    m_allFold->setText(tr("View") + kArrow);
    m_allFold->setToolTip(tr("What the canvas shows, and what is laid over it"));
    for (QToolButton* fold : {m_overlayFold, m_viewFold, m_allFold})
        fold->setAccessibleName(fold->toolTip());
    updateGeometry();
    arrange();
}

/// The menu of views names the one that is shown if it has no open button.
void ViewsBar::sync()
{
    QString name = m_form.openViews == 0 ? tr("View") : tr("More");
    for (std::size_t i = m_form.openViews; i < m_viewButtons.size(); ++i)
        if (m_viewButtons[i]->defaultAction()->isChecked())
            name = m_viewButtons[i]->defaultAction()->iconText();
    m_viewFold->setText(name + kArrow);
}

/// From all open to all folded.
std::vector<ViewsBar::Form> ViewsBar::forms() const
{
    const std::size_t views = m_viewButtons.size();
    std::vector<Form> forms{{true, false, views}};
    for (std::size_t open = views; open >= kLeastOpen; --open)
        forms.push_back({false, false, open});
    forms.push_back({false, false, 0});
    forms.push_back({false, true, 0});
    return forms;
}

std::vector<QToolButton*> ViewsBar::buttonsOf(const Form& form) const
{
    if (form.oneMenu)
        return {m_allFold};
    std::vector<QToolButton*> buttons(m_viewButtons.begin(), m_viewButtons.begin() + std::ptrdiff_t(form.openViews));
    if (form.openViews < m_viewButtons.size())
        buttons.push_back(m_viewFold);
    if (form.overlaysOpen)
        buttons.insert(buttons.end(), m_overlayButtons.begin(), m_overlayButtons.end());
    buttons.push_back(m_overlayFold); // it also has what has no button of its own
    return buttons;
}

/// The menu of views has room for the longest name: no other name moves what stands behind it.
int ViewsBar::widthOf(const QToolButton* button) const
{
    int width = button->sizeHint().width();
    if (button == m_viewFold)
        for (const QToolButton* view : m_viewButtons)
            width = std::max(width, view->sizeHint().width() + fontMetrics().horizontalAdvance(kArrow) + 2);
    return width;
}

int ViewsBar::widthOf(const Form& form) const
{
    int width = form.oneMenu ? 0 : kGroupGap;
    for (const QToolButton* button : buttonsOf(form))
        width += widthOf(button) + kSpacing;
    return width;
}

QSize ViewsBar::sizeHint() const { return minimumSizeHint(); }

QSize ViewsBar::minimumSizeHint() const { return {widthOf(forms().back()), m_overlayFold->sizeHint().height()}; }

void ViewsBar::arrange()
{
    const std::vector<Form> all = forms();
    const auto form = std::ranges::find_if(all, [this](const Form& f) { return widthOf(f) <= width(); });
    m_form = form == all.end() ? all.back() : *form;
    sync();
    const std::vector<QToolButton*> shown = buttonsOf(m_form);
    for (QToolButton* button : findChildren<QToolButton*>(Qt::FindDirectChildrenOnly))
        button->setVisible(std::ranges::find(shown, button) != shown.end());
    const bool isFolded = m_form.openViews < m_viewButtons.size();
    const QToolButton* lastView = isFolded ? m_viewFold : m_viewButtons.back();
    int x = 0;
    for (QToolButton* button : shown) {
        const int high = button->sizeHint().height();
        button->setGeometry(x, (height() - high) / 2, widthOf(button), high);
        x += widthOf(button) + kSpacing + (button == lastView ? kGroupGap : 0);
    }
}

void ViewsBar::resizeEvent(QResizeEvent*) { arrange(); }

void ViewsBar::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) {
        updateGeometry();
        arrange();
    }
}

} // namespace rasterlens
