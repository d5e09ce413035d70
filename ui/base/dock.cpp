#include "ui/base/dock.h"

#include "ui/base/parts.h"

#include <QEvent>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>

#include <utility>

namespace rasterlens
{

namespace
{

/// Scrolls, and is as small as may be.
class PanelScroll : public QScrollArea
{
public:
    explicit PanelScroll(QWidget* panel)
    {
        setFrameShape(NoFrame);
        setWidgetResizable(true);
        setFocusPolicy(Qt::NoFocus);
        setWidget(panel);
        panel->setAutoFillBackground(false); // the card below is seen through
        viewport()->setAutoFillBackground(false);
    }
    [[nodiscard]] QSize minimumSizeHint() const override { return {kLeastWidth, kLeastHeight}; }
    [[nodiscard]] QSize sizeHint() const override { return widget()->sizeHint(); }

private:
    static constexpr int kLeastWidth = 200;
    static constexpr int kLeastHeight = 48;
};

} // namespace

Dock::Dock(const QString& id, QWidget* panel, QWidget* parent, Fit fit) : QDockWidget(parent)
{
    setObjectName(id);
    auto* title = new QWidget;
    title->setObjectName(QStringLiteral("dockTitle"));
    title->setAttribute(Qt::WA_StyledBackground);
    m_titleRow = new QHBoxLayout(title);
    m_titleRow->setContentsMargins(12, 8, 8, 4);
    m_titleRow->setSpacing(2);
    m_title = new QLabel;
    m_title->setObjectName(QStringLiteral("title"));
    m_title->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred); // a long one does not widen the window
    m_titleRow->addWidget(m_title, 1);
    m_close = insertLink(1);
    m_close->setText(QStringLiteral("\u00d7"));
    connect(m_close, &QToolButton::clicked, this, &QDockWidget::close);
    setTitleBarWidget(title);

    auto* body = new QFrame;
    body->setObjectName(QStringLiteral("dockBody"));
    auto* column = new QVBoxLayout(body);
    column->setContentsMargins(1, 0, 1, 1);
    column->addWidget(fit == Fit::Scrolls ? new PanelScroll(panel) : panel);
    setWidget(body);
}

void Dock::setTitle(const QString& title)
{
    setWindowTitle(title);
    m_title->setText(title);
    m_close->setToolTip(tr("Close this panel; the menu Panels opens it again"));
    m_close->setAccessibleName(m_close->toolTip());
}

/// QMainWindow moves a tab behind another out of the window; it does not hide it.
bool Dock::isInSight() const
{
    return isVisible() && (isFloating() || (geometry().right() >= 0 && geometry().bottom() >= 0));
}

bool Dock::event(QEvent* event)
{
    const bool done = QDockWidget::event(event);
    switch (event->type()) {
    case QEvent::Show:
    case QEvent::Hide:
    case QEvent::Move:
    case QEvent::Resize:
        if (std::exchange(m_wasInSight, isInSight()) != isInSight())
            Q_EMIT sightChanged(isInSight());
        break;
    default: break;
    }
    return done;
}

QToolButton* Dock::addLink() { return insertLink(m_titleRow->indexOf(m_close)); }

QToolButton* Dock::insertLink(int index)
{
    QToolButton* link = makeLink();
    m_titleRow->insertWidget(index, link);
    return link;
}

} // namespace rasterlens
