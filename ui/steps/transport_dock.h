#pragma once
#include "ui/base/action_table.h"
#include "ui/steps/step_session.h"
#include "ui/steps/transport_icon.h"

#include <QDockWidget>
#include <QList>

#include <vector>

class QFrame;
class QLabel;
class QMenu;
class QToolButton;

namespace rasterlens
{

class Scrubber;

/// Playing, stepping and the scrubber; its actions make up the menu Step of the table of actions.
class TransportDock : public QDockWidget
{
    Q_OBJECT

public:
    TransportDock(StepSession& session, ActionTable& actions, QWidget* parent);

    /// The menu Step; its keys work in the whole window.
    [[nodiscard]] QMenu* menu() const { return m_menu; }
    [[nodiscard]] Scrubber& scrubber() const { return *m_scrubber; }
    [[nodiscard]] QString stepText() const;
    [[nodiscard]] QString noticeText() const;

    /// A thin bar of buttons, step and scrubber, for a large type: what is recorded is chosen in the menu, keys are in
    /// the help. Once the mouse was used it fades away while it rests.
    void setBrief(bool on);

Q_SIGNALS:
    void rectangleWanted(); ///< the scope is to be what the canvas shows

protected:
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void buildActions(ActionTable& table);
    void buildSteps(ActionMenu& menu);
    void buildScopeMenu(ActionMenu menu);
    void buildRunMenu(ActionMenu menu);
    void buildSpeedMenu(ActionMenu menu);
    void buildPlayMenu(ActionMenu menu);
    QWidget* buildTitleRow();
    QWidget* buildBody();
    QToolButton* addButton(QAction* action, TransportSign sign, bool backward);
    void syncIcons();
    QToolButton* addLink(QMenu* menu);
    void retranslate();
    void sync();
    void syncLog();
    void fade(bool away);
    void syncActions();
    void syncLinks();
    [[nodiscard]] QString playText() const;
    void runUntil(StepStop::Kind kind);
    void recordFaceHere();

    StepSession& m_session;
    QMenu* m_menu = nullptr;
    QMenu* m_scopeMenu = nullptr;
    QMenu* m_runMenu = nullptr;
    QMenu* m_speedMenu = nullptr;
    QMenu* m_playMenu = nullptr;
    QAction* m_record = nullptr;
    QAction* m_play = nullptr;
    QAction* m_start = nullptr;
    QAction* m_end = nullptr;
    QAction* m_loop = nullptr;
    QAction* m_untilPixel = nullptr;
    QList<QAction*> m_stepActions; ///< back and forth: event, row, face, stage
    QList<QAction*> m_scopeActions;
    QList<QAction*> m_speedActions;
    QList<QAction*> m_playActions;   ///< by which step
    QList<QAction*> m_secondActions; ///< the whole record in so many seconds
    QList<QAction*> m_onlyOpen;      ///< of use in the step mode only
    struct Button {
        QToolButton* widget;
        TransportSign sign;
        bool backward;
    };
    std::vector<Button> m_buttons;

    QFrame* m_body = nullptr;
    QFrame* m_titleRow = nullptr;
    QLabel* m_step = nullptr;
    QLabel* m_summary = nullptr;
    bool m_brief = false;
    QTimer m_rest;        ///< of the mouse
    bool m_isLow = false; ///< the window
    QLabel* m_notice = nullptr;
    QLabel* m_legend = nullptr;
    QLabel* m_hint = nullptr; ///< the keys, or who records in place of the chosen algorithm
    QToolButton* m_speedLink = nullptr;
    QToolButton* m_playLink = nullptr;
    QToolButton* m_runLink = nullptr;
    QToolButton* m_scopeLink = nullptr;
    Scrubber* m_scrubber = nullptr;
};

} // namespace rasterlens
