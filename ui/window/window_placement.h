#pragma once
#include <QByteArray>
#include <QMargins>
#include <QObject>
#include <QRect>

class QWidget;

namespace rasterlens
{

/// The place for a window within the free area of a screen: as it is wanted where it fits, else moved, else smaller.
///
/// in   wanted, without the frame; the frame around it
/// out  without the frame
[[nodiscard]] QRect placeWithin(const QRect& wanted, const QMargins& frame, const QRect& free);

/// Keeps the main window on its screen: at the first start, after a restart with other screens, after full screen.
class WindowPlacement : public QObject
{
    Q_OBJECT

public:
    explicit WindowPlacement(QWidget& window);

    /// Sizes the window before it is shown.
    ///
    /// in  what geometry() gave in an earlier run, or nothing
    void start(const QByteArray& remembered);
    /// The window is about to be seen. A size that was set since start() is kept.
    void shown();

    /// Takes the whole screen, or goes back to what was before: maximised, or a window of its former size.
    void setFullScreen(bool on);
    /// What start() takes; of the window as it is outside full screen.
    [[nodiscard]] QByteArray geometry() const;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void keepOnScreen();
    void keepOnScreenSoon();

    QWidget& m_window;
    QSize m_chosen; ///< by start()
    bool m_wasShown = false;
    bool m_isOurs = true; ///< no other size was set since start()
    bool m_wasMaximized = false;
    QRect m_formerPlace;
    QByteArray m_formerGeometry; ///< empty outside full screen
};

} // namespace rasterlens
