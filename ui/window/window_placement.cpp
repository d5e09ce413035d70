#include "ui/window/window_placement.h"

#include <QEvent>
#include <QGuiApplication>
#include <QScreen>
#include <QTimer>
#include <QWidget>

#include <algorithm>
#include <utility>

namespace rasterlens
{
namespace
{

constexpr QSize kUsualSize(1440, 900);
constexpr QMargins kUsualFrame(8, 40, 8, 8); ///< before a window manager has drawn its own
constexpr int kFrameDelayMs = 300;           ///< until the frame's true size is known

QMargins frameOf(const QWidget& window)
{
    const QRect outer = window.frameGeometry();
    const QRect inner = window.geometry();
    return {inner.left() - outer.left(), inner.top() - outer.top(), outer.right() - inner.right(),
            outer.bottom() - inner.bottom()};
}

} // namespace

QRect placeWithin(const QRect& wanted, const QMargins& frame, const QRect& free)
{
    const QRect room = free.marginsRemoved(frame);
    QRect place(wanted.topLeft(), wanted.size().boundedTo(room.size()));
    place.moveLeft(std::max(std::min(place.left(), room.right() - place.width() + 1), room.left()));
    place.moveTop(std::max(std::min(place.top(), room.bottom() - place.height() + 1), room.top()));
    return place;
}

WindowPlacement::WindowPlacement(QWidget& window) : QObject(&window), m_window(window)
{
    window.installEventFilter(this);
    connect(qGuiApp, &QGuiApplication::screenRemoved, this, &WindowPlacement::keepOnScreenSoon);
    for (const QScreen* screen : QGuiApplication::screens())
        connect(screen, &QScreen::availableGeometryChanged, this, &WindowPlacement::keepOnScreenSoon);
}

void WindowPlacement::start(const QByteArray& remembered)
{
    if (remembered.isEmpty() || !m_window.restoreGeometry(remembered)) {
        const QScreen* screen = m_window.screen();
        const QRect free = screen ? screen->availableGeometry() : QRect(QPoint(0, 0), kUsualSize);
        m_window.resize(kUsualSize.boundedTo(free.marginsRemoved(kUsualFrame).size()));
    }
    m_chosen = m_window.size();
    m_isOurs = true;
}

void WindowPlacement::shown()
{
    if (std::exchange(m_wasShown, true))
        return;
    m_isOurs = m_window.size() == m_chosen;
    if (m_isOurs)
        keepOnScreenSoon();
}

void WindowPlacement::keepOnScreenSoon()
{
    if (!m_wasShown || !m_isOurs)
        return;
    for (const int delay : {0, kFrameDelayMs})
        QTimer::singleShot(delay, this, &WindowPlacement::keepOnScreen);
}

void WindowPlacement::keepOnScreen()
{
    const QScreen* screen = m_window.screen();
    if (!screen || m_window.windowState() != Qt::WindowNoState)
        return;
    const QRect place = placeWithin(m_window.geometry(), frameOf(m_window), screen->availableGeometry());
    if (place != m_window.geometry())
        m_window.setGeometry(place);
}

void WindowPlacement::setFullScreen(bool on)
{
    if (on == m_window.isFullScreen())
        return;
    if (on) {
        m_wasMaximized = m_window.isMaximized();
        m_formerPlace = m_window.geometry();
        m_formerGeometry = m_window.saveGeometry();
        m_window.showFullScreen();
        return;
    }
    m_formerGeometry.clear();
    if (m_wasMaximized) {
        m_window.showMaximized();
        return;
    }
    m_window.showNormal();
    // Large type may have made the window's least size larger; by then the layout knows the usual one again.
    QTimer::singleShot(0, this, [this] {
        if (m_window.windowState() != Qt::WindowNoState || !m_formerPlace.isValid())
            return;
        m_window.setGeometry(m_formerPlace);
        keepOnScreen();
    });
}

QByteArray WindowPlacement::geometry() const
{
    return m_formerGeometry.isEmpty() ? m_window.saveGeometry() : m_formerGeometry;
}

bool WindowPlacement::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == &m_window && event->type() == QEvent::WindowStateChange &&
        m_window.windowState() == Qt::WindowNoState)
        keepOnScreenSoon();
    return QObject::eventFilter(watched, event);
}

} // namespace rasterlens
