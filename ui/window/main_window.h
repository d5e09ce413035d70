#pragma once
#include "ui/base/action_table.h"
#include "ui/base/language.h"
#include "ui/base/theme.h"
#include "ui/canvas/viewport_widget.h"
#include "ui/document/document.h"
#include "ui/document/render_worker.h"
#include "ui/lessons/lesson_player.h"
#include "ui/window/empty_remark.h"

#include <QMainWindow>

#include <bitset>
#include <functional>
#include <memory>
#include <vector>

class QBoxLayout;
class QLabel;
class QLineEdit;
class QMenu;
class QToolButton;

namespace rasterlens
{

class ActionSearch;
class CanvasViews;
class Cards;
class Dock;
class GuideWindow;
class HelpOverlay;
class LessonMode;
class LifeCycle;
class MessageBar;
class MistakeBadge;
class MistakesMenu;
class MotionMode;
class PipelinePanel;
class FigureExport;
class FocusOrder;
class PanelPlaces;
class ReadoutBar;
class StageStrip;
class StatisticsPanel;
class StepMode;
class TruthMode;
class TypedField;
class ViewsBar;
class WindowMoment;
class WindowPlacement;

/// The window: canvas in the middle, pipeline left, statistics right.
class MainWindow : public QMainWindow
{
    Q_OBJECT

public:
    enum class Memory { Remember, Forget }; ///< of layout, theme and language between runs

    explicit MainWindow(Memory memory = Memory::Remember, QWidget* parent = nullptr);
    ~MainWindow() override;

    [[nodiscard]] Document& document() { return m_document; }
    [[nodiscard]] ViewportWidget& viewport() { return *m_viewport; }
    [[nodiscard]] PipelinePanel& pipelinePanel() { return *m_pipelinePanel; }
    [[nodiscard]] StatisticsPanel& statisticsPanel() { return *m_statisticsPanel; }
    [[nodiscard]] StageStrip& stageStrip() { return *m_stageStrip; }
    [[nodiscard]] HelpOverlay& helpOverlay() { return *m_help; }
    [[nodiscard]] GuideWindow& guide() { return *m_guide; }
    [[nodiscard]] ActionSearch& actionSearch() { return *m_search; }
    [[nodiscard]] const ActionTable& actionTable() const { return m_actions; }
    [[nodiscard]] Cards& cards() { return *m_cards; }
    [[nodiscard]] MistakeBadge& mistakeBadge() { return *m_mistakeBadge; }
    [[nodiscard]] RenderWorker& worker() { return m_worker; }
    [[nodiscard]] CanvasViews& canvasViews() { return *m_views; }
    [[nodiscard]] ViewsBar& viewsBar() { return *m_viewsBar; }
    [[nodiscard]] StepMode& stepMode() { return *m_stepMode; }
    [[nodiscard]] MotionMode& motion() { return *m_motion; }
    [[nodiscard]] TruthMode& truthMode() { return *m_truth; }
    [[nodiscard]] LessonMode& lessons() { return *m_lessons; }
    /// What the window shows, as one value.
    [[nodiscard]] WindowMoment& moment() { return *m_moment; }
    [[nodiscard]] PanelPlaces& panels() { return *m_panels; }
    [[nodiscard]] FocusOrder& focusOrder() { return *m_focusOrder; }
    [[nodiscard]] FigureExport& figures() { return *m_figures; }
    [[nodiscard]] LifeCycle& lifeCycle() { return *m_lifeCycle; }

    void openDefaultScene();
    /// What a start without arguments opens: the first lesson the first time, else the default scene.
    void openAtStart();
    /// Opens whatever a file holds: a scene, a session or a lesson.
    void open(const QString& name);
    void setLanguage(LanguageKind kind);
    [[nodiscard]] LanguageKind language() const { return m_language.kind(); }
    void setLook(const Look& look);
    [[nodiscard]] const Look& look() const { return m_look; }
    void setPresentation(bool on);
    void resetLayout();
    /// Keeps layout and unsaved changes for the next start, without a question: the system ends program or session.
    void keepAll();

    /// Whether the picture of the present settings is shown and counted, or refused with a message.
    [[nodiscard]] bool isSettled() const;
    /// Whether all that is shown is also computed: settled, the badge and the cards with it.
    [[nodiscard]] bool isComplete() const;
    /// The message over the canvas; empty when there is none.
    [[nodiscard]] QString message() const;
    /// The window with the panels that float above it.
    [[nodiscard]] QImage picture();

    /// Compares a picture with the present scene, with and without each mistake, in the panel for it.
    void identifyPicture(const QString& path);

    /// errors  a message over the canvas; false
    bool exportFigure(const QString& path); ///< in the format that the suffix names, also SVG and PDF
    bool exportFramebuffer(const QString& path);
    bool exportWindow(const QString& path);

Q_SIGNALS:
    void settled();

protected:
    void changeEvent(QEvent* event) override;
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    bool event(QEvent* event) override;
    bool focusNextPrevChild(bool next) override;

private:
    static constexpr int kLayoutVersion = 4; ///< another one makes the program forget former layouts

    void buildLayout();
    void buildFocus();
    QWidget* buildCanvas();
    void buildStatusBar();
    void connectParts();
    void connectDocument();
    void connectWorker();
    void connectPanels();
    void connectModes();
    void connectMotion();
    void syncMotion();
    void connectLessons();
    void keepAnswersSecret();
    void copyPicture(const QImage& picture);
    void connectCanvas();
    void buildMenus();
    void addHint(const char* id, ActionSection section, const char* keys, const char* what);
    void addMouseHints();
    void buildFileMenu();
    void buildExports(ActionMenu& file);
    void buildFigureScale(ActionMenu scale);
    void buildSceneMenu(ActionMenu scenes);
    void buildEditMenu();
    void buildViewMenu();
    void buildCamera(ActionMenu menu);
    void buildMotion(ActionMenu menu);
    void buildDrawing(ActionMenu menu);
    void buildAppearance(ActionMenu menu);
    void buildLanguages(ActionMenu language);
    void buildSettingsMenu();
    void buildMistakesMenu();
    void buildHelpMenu();
    void buildStageMenu();
    [[nodiscard]] ActionMenu addMenu(ActionSection section, const char* title);

    void retranslate();
    void fillRecentMenu();
    /// What the window says in words: about the scene and its settings (title, caption), and about a pixel (the line
    /// above the canvas, the read-out).
    enum class Words { OfDocument, OfPixel };
    void syncSoon(Words which);
    void syncWords();
    void syncActions();
    void syncHelp();
    void syncCanvasHeader();
    void syncReadout();
    void syncTitle();
    void syncCaption();
    [[nodiscard]] QString sceneWords() const;

    void updatePicture();
    [[nodiscard]] bool isShown() const;
    void tellIfSettled();
    void takeFrame(const FramePtr& frame);
    void showFrame();
    void stepField(const SettingsField& field);
    void changeField(const SettingsField& field, const Settings& settings);
    void offerSmallRecord();
    void moveCamera(const View& view);
    void toggleHelp();
    void toggleGoToPixel();
    void showGoToPixel(bool on);
    std::optional<QString> goToTyped(const QString& text, bool go);
    /// Shows why a field refuses a text, until it is mended.
    template <class Field, class Refused, class Mended>
    void connectField(Field* field, Refused refused, Mended mended);
    void leaveInnermost();
    void syncStage();
    void syncTransport();
    void syncCompareBar();
    [[nodiscard]] QString stageText() const;
    void syncCounters();
    void reportSaved(const std::optional<QString>& error, const QString& path);
    void chooseFileToOpen();
    void chooseFileToIdentify();
    void chooseRunToAnimate();
    void chooseFileToExport(const QString& title, const QString& suggestion, bool asDrawing,
                            std::function<void(const QString&)> save);
    void restoreMemory();
    void saveMemory();

    Memory m_memory;
    Language m_language;
    ActionTable m_actions{*this, m_language};
    Look m_look;
    Document m_document;
    RenderWorker m_worker;

    ViewportWidget* m_viewport = nullptr;
    std::unique_ptr<CanvasViews> m_views;
    std::unique_ptr<StepMode> m_stepMode;
    std::unique_ptr<MotionMode> m_motion;
    std::unique_ptr<TruthMode> m_truth;
    std::unique_ptr<LifeCycle> m_lifeCycle;
    std::unique_ptr<FigureExport> m_figures;
    std::unique_ptr<LessonMode> m_lessons;
    WindowMoment* m_moment = nullptr;
    Diagnostics m_lessonRemarks;      ///< to be said when the slide is shown
    LessonPlayer::Place m_shownPlace; ///< of the lesson, whose moment the window shows
    StageStrip* m_stageStrip = nullptr;
    PipelinePanel* m_pipelinePanel = nullptr;
    StatisticsPanel* m_statisticsPanel = nullptr;
    Cards* m_cards = nullptr;
    MistakeBadge* m_mistakeBadge = nullptr;
    Dock* m_pipelineDock = nullptr;
    Dock* m_statisticsDock = nullptr;
    QToolButton* m_copyCsv = nullptr;
    QToolButton* m_copyJson = nullptr;
    MessageBar* m_message = nullptr; ///< what happened last
    MessageBar* m_recoveryOffer = nullptr;
    MessageBar* m_filesOffer = nullptr;
    MessageBar* m_unsupported = nullptr; ///< why the present settings are not drawn
    HelpOverlay* m_help = nullptr;
    GuideWindow* m_guide = nullptr;
    ActionSearch* m_search = nullptr;
    QWidget* m_canvasHeader = nullptr;
    QBoxLayout* m_picture = nullptr; ///< the canvas, and the listing below or beside it
    QLabel* m_canvasTitle = nullptr;
    ViewsBar* m_viewsBar = nullptr;
    QToolButton* m_goToButton = nullptr;
    QLineEdit* m_goToEdit = nullptr;
    TypedField* m_goToField = nullptr;
    QLabel* m_caption = nullptr;
    QToolButton* m_stageMenu = nullptr; ///< in place of the menu bar
    ReadoutBar* m_readout = nullptr;
    QLabel* m_activity = nullptr;
    QLabel* m_counters = nullptr; ///< the most important ones, where the panel is out of sight
    PanelPlaces* m_panels = nullptr;
    WindowPlacement* m_placement = nullptr;
    FocusOrder* m_focusOrder = nullptr;
    QTimer m_activityDelay;

    QMenu* m_recentMenu = nullptr;
    QMenu* m_languageMenu = nullptr; ///< in two menus
    MistakesMenu* m_mistakesMenu = nullptr;
    QAction* m_clearRecent = nullptr;
    QAction* m_undo = nullptr;
    QAction* m_redo = nullptr;
    QAction* m_reset = nullptr;
    QAction* m_reload = nullptr;
    QAction* m_fit = nullptr;
    QAction* m_oneToOne = nullptr;
    QAction* m_zoomIn = nullptr;
    QAction* m_zoomOut = nullptr;
    QAction* m_goTo = nullptr;
    QAction* m_fastMotion = nullptr;
    QAction* m_presentation = nullptr;
    QAction* m_fullScreen = nullptr;
    QAction* m_dark = nullptr;
    QAction* m_chinese = nullptr;
    QAction* m_english = nullptr;
    std::vector<QAction*> m_cameraActions;
    std::vector<QAction*> m_motionActions; ///< by Motion

    FramePtr m_lastFrame;
    bool m_refused = false;
    EmptyRemark m_emptyRemark;
    std::bitset<2> m_wordsAreOld; ///< by Words
    bool m_gaveUp = false;        ///< the system had no memory or no threads for the present picture
    QByteArray m_defaultState;
    QByteArray m_stateBeforePresentation;
};

} // namespace rasterlens
