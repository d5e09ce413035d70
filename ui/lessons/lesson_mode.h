#pragma once
#include "ui/base/action_table.h"
#include "ui/lessons/answer_layer.h"
#include "ui/lessons/lesson_player.h"

#include <QObject>

class QAction;
class QLayout;
class QMainWindow;
class QMenu;

namespace rasterlens
{

class Dock;
class LessonPanel;
class ViewportWidget;

/// Puts the parts of the lessons together: the player, its panel, the marks on the canvas and the menu Lessons.
class LessonMode : public QObject
{
    Q_OBJECT

public:
    /// Adds the menu's actions to the table. The panel has no place in the window yet.
    LessonMode(ViewportWidget& viewport, QMainWindow& window, ActionTable& actions);
    ~LessonMode() override;

    [[nodiscard]] LessonPlayer& player() { return m_player; }
    [[nodiscard]] LessonPanel& panel() const { return *m_panel; }
    [[nodiscard]] Dock& dock() const { return *m_dock; }
    [[nodiscard]] QMenu* menu() const { return m_menu; }

    /// Opens a built-in lesson by its id, or the file of one. The slides of a file are checked on a background thread.
    ///
    /// errors  reported(); false, and the lesson that was open stays
    bool open(const QString& name);
    /// The window shows something else than the slide.
    void setAway(bool away);
    /// Brings the panel to the front where a lesson is open.
    void showDock();
    /// The panel is a bar below the picture in place of a dock.
    ///
    /// in  the layout that takes it; null: back to the dock
    void setBar(QLayout* bar);
    [[nodiscard]] bool isBusy() const { return m_player.isBusy(); }
    [[nodiscard]] bool isChecking() const { return m_check.isBusy(); }
    /// Writes the answers to a file, now and after each further one.
    ///
    /// errors  message() and failed(); false
    bool keepAnswers(const QString& path);
    void retranslate();

Q_SIGNALS:
    void momentWanted(const rasterlens::Moment& moment);
    void tryWanted();
    void reported(const rasterlens::Diagnostics& diagnostics);
    void message(const QString& text);
    void failed(const QString& text);

private:
    void buildMenu(ActionTable& table);
    void buildLessons(ActionMenu menu);
    void follow();
    void markPixel();
    void openNext();
    void chooseAnswerFile();
    bool writeAnswers();
    void sync();

    ViewportWidget& m_viewport;
    QMainWindow& m_window;
    LessonPlayer m_player;
    AnswerLayer m_layer;
    QMenu* m_menu;
    LessonPanel* m_panel = nullptr;
    Dock* m_dock = nullptr;
    QAction* m_next = nullptr;
    QAction* m_previous = nullptr;
    QAction* m_back = nullptr;
    QAction* m_close = nullptr;
    QAction* m_mark = nullptr;
    QAction* m_level = nullptr;
    QAction* m_keep = nullptr;
    QString m_answerFile;
    bool m_isBar = false;
    std::size_t m_markedSlide = 0;     ///< of the marks on the canvas
    LatestResult<Diagnostics> m_check; ///< last: its thread uses the members above
};

} // namespace rasterlens
