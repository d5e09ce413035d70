// The menus: every action of the window that no part of it owns, and what they show.
#include "core/scenes/builtin_scenes.h"
#include "ui/base/applicability.h"
#include "ui/base/dock.h"
#include "ui/base/message_bar.h"
#include "ui/document/navigation.h"
#include "ui/face/cards.h"
#include "ui/lessons/lesson_mode.h"
#include "ui/pipeline/canvas_views.h"
#include "ui/pipeline/mistakes_section.h"
#include "ui/pipeline/pipeline_panel.h"
#include "ui/pipeline/views_bar.h"
#include "ui/steps/motion_mode.h"
#include "ui/steps/step_mode.h"
#include "ui/steps/transport_dock.h"
#include "ui/truth/truth_mode.h"
#include "ui/window/action_search.h"
#include "ui/window/figure_export.h"
#include "ui/window/guide_window.h"
#include "ui/window/handout_export.h"
#include "ui/window/life_cycle.h"
#include "ui/window/main_window.h"
#include "ui/window/page_export.h"
#include "ui/window/panel_places.h"
#include "ui/window/window_placement.h"

#include <QAction>
#include <QActionGroup>
#include <QClipboard>
#include <QGuiApplication>
#include <QMenu>
#include <QMenuBar>
#include <QToolButton>

#include <utility>

namespace rasterlens
{
namespace
{

/// A key that changes a setting: to and fro between the two values that a lecture compares, and with Shift through all
/// of them; or, where there is no such pair, through all values at once.
struct FieldKey {
    const char* field;
    Qt::Key key;
    const char* one = nullptr;   ///< values; null: no pair
    const char* other = nullptr; ///< the value that the key goes to from `one`
    const char* next = nullptr;  ///< what Shift does

    [[nodiscard]] bool isToggle() const { return one != nullptr; }
};
constexpr FieldKey kFieldKeys[] = {
    {"clipping", Qt::Key_X, "frustum", "none", QT_TRANSLATE_NOOP("rasterlens::MainWindow", "Clipping, next value")},
    {"number-type", Qt::Key_N},
    {"culling", Qt::Key_C, "back", "none", QT_TRANSLATE_NOOP("rasterlens::MainWindow", "Culling, next value")},
    {"fill", Qt::Key_W, "solid", "wireframe", QT_TRANSLATE_NOOP("rasterlens::MainWindow", "Fill, next value")},
    {"algorithm", Qt::Key_E},
    {"depth-test", Qt::Key_T, "less", "none", QT_TRANSLATE_NOOP("rasterlens::MainWindow", "Depth test, next value")},
    {"interpolation", Qt::Key_P, "perspective", "affine",
     QT_TRANSLATE_NOOP("rasterlens::MainWindow", "Interpolation, next value")},
};

} // namespace

ActionMenu MainWindow::addMenu(ActionSection section, const char* title)
{
    return {m_actions, menuBar()->addMenu(QString()), *this, section, title};
}

void MainWindow::buildMenus()
{
    addMouseHints();
    buildFileMenu();
    buildEditMenu();
    buildViewMenu();
    m_panels->buildMenu(addMenu(ActionSection::Panels, QT_TR_NOOP("&Panels")));
    buildSettingsMenu();
    menuBar()->addMenu(m_stepMode->transport().menu());
    menuBar()->addMenu(m_truth->menu());
    buildMistakesMenu();
    menuBar()->addMenu(m_lessons->menu());
    buildHelpMenu();
    buildStageMenu();
    const QStringList conflicts = m_actions.conflicts();
    Q_ASSERT_X(conflicts.isEmpty(), "ActionTable", qPrintable(conflicts.join(QStringLiteral("; "))));
}

void MainWindow::addHint(const char* id, ActionSection section, const char* keys, const char* what)
{
    const char* context = staticMetaObject.className();
    m_actions.addHint(id, section, {context, keys}, {context, what});
}

/// What the canvas does with the mouse and the arrows, which no action has.
void MainWindow::addMouseHints()
{
    const auto canvas = [this](const char* id, const char* keys, const char* what) {
        addHint(id, ActionSection::Canvas, keys, what);
    };
    canvas("mouse.zoom", QT_TR_NOOP("Wheel"), QT_TR_NOOP("Zoom at the cursor"));
    canvas("mouse.move", QT_TR_NOOP("Middle drag, Shift + drag"), QT_TR_NOOP("Move the picture"));
    canvas("mouse.choose", QT_TR_NOOP("Click, arrows"), QT_TR_NOOP("Choose a pixel, move on by one"));
    canvas("mouse.close-up", QT_TR_NOOP("Double click"), QT_TR_NOOP("Close up of a pixel"));
    const auto camera = [this](const char* id, const char* keys, const char* what) {
        addHint(id, ActionSection::Camera, keys, what);
    };
    camera("mouse.orbit", QT_TR_NOOP("Drag"), QT_TR_NOOP("Orbit"));
    camera("mouse.dolly", QT_TR_NOOP("Right drag, Ctrl + wheel"), QT_TR_NOOP("Nearer, farther"));
    camera("mouse.pan", QT_TR_NOOP("Ctrl + drag"), QT_TR_NOOP("Move the scene"));
}

void MainWindow::buildFileMenu()
{
    ActionMenu file = addMenu(ActionSection::File, QT_TR_NOOP("&File"));
    file.add("file.open", QT_TR_NOOP("&Open\u2026"), {Qt::CTRL | Qt::Key_O}, [this] { chooseFileToOpen(); });
    ActionMenu recent = file.addMenu(QT_TR_NOOP("Open &recent"));
    m_recentMenu = recent.menu();
    connect(m_recentMenu, &QMenu::aboutToShow, this, &MainWindow::fillRecentMenu); // files come and go
    m_clearRecent = recent.add("file.clear-recent", QT_TR_NOOP("Clear"), {}, [this] { m_document.clearRecentFiles(); });
    buildSceneMenu(file.addMenu(QT_TR_NOOP("&Built-in scenes")));
    m_reload =
        file.add("file.reload", QT_TR_NOOP("Re&load from disk"), {Qt::Key_F5}, [this] { m_lifeCycle->reload(); });
    file.add("file.identify", QT_TR_NOOP("Which &mistake is mine?\u2026"), {}, [this] { chooseFileToIdentify(); });
    file.addSeparator();
    file.add("file.save", QT_TR_NOOP("&Save session"), {Qt::CTRL | Qt::Key_S}, [this] { m_lifeCycle->save(); });
    file.add("file.save-as", QT_TR_NOOP("Save session &as\u2026"), {Qt::CTRL | Qt::SHIFT | Qt::Key_S},
             [this] { m_lifeCycle->saveAs(); });
    file.addSeparator();
    buildExports(file);
    file.addSeparator();
    file.add("file.quit", QT_TR_NOOP("&Quit"), {Qt::CTRL | Qt::Key_Q}, [this] { close(); });
}

void MainWindow::buildSceneMenu(ActionMenu scenes)
{
    scenes.menu()->setToolTipsVisible(true);
    const auto addScene = [&](const QString& name, const ActionWords& title) {
        return scenes.add(QString(name).replace(QLatin1Char(':'), QLatin1Char('.')), title, {},
                          [this, name] { m_document.open(name); });
    };
    for (const BuiltinScene& scene : builtinScenes()) {
        const QAction* action =
            addScene(QStringLiteral("builtin:") + QLatin1String(scene.name), {"BuiltinScene", scene.title});
        m_actions.setToolTip(action, {"BuiltinScene", scene.note});
    }
    scenes.addSeparator();
    for (const StressScene& scene : stressScenes())
        addScene(QStringLiteral("stress:") + QLatin1String(scene.name), {"StressScene", scene.title});
}

void MainWindow::buildExports(ActionMenu& file)
{
    file.add("file.figure", QT_TR_NOOP("Export &figure\u2026"), {Qt::Key_F12}, [this] {
        chooseFileToExport(tr("Export figure"), QStringLiteral("figure.png"), true,
                           [this](const QString& path) { exportFigure(path); });
    });
    file.add("file.figure-svg", QT_TR_NOOP("Export figure as S&VG\u2026"), {}, [this] {
        chooseFileToExport(tr("Export figure as SVG"), QStringLiteral("figure.svg"), true,
                           [this](const QString& path) { exportFigure(path); });
    });
    file.add("file.run", QT_TR_NOOP("Export a &run of steps\u2026"), {},
             [this] { m_stepMode->chooseRunToExport(m_figures->zoom()); });
    file.add("file.run-gif", QT_TR_NOOP("Export a run as &GIF\u2026"), {}, [this] { chooseRunToAnimate(); });
    file.add("file.before-after", QT_TR_NOOP("Export before and after\u2026"), {}, [this] {
        chooseFileToExport(tr("Export before and after"), QStringLiteral("before-after.png"), true,
                           [this](const QString& path) { m_figures->exportBeforeAfter(path); });
    });
    file.add("file.handout", QT_TR_NOOP("Export handout of a lesson\u2026"), {}, [this] {
        chooseHandout(*this, m_language.kind(), [this](const QString& path, const QString& error) {
            reportSaved(error.isEmpty() ? std::nullopt : std::optional(error), path);
        });
    });
    file.add("file.page", QT_TR_NOOP("Export pa&ge for browsers\u2026"), {}, [this] {
        const LessonPlayer& player = m_lessons->player();
        choosePage(*this, {m_document.session(), player.isOpen() ? player.lesson().file : QString()},
                   [this](const QString& path, const QString& error) {
                       reportSaved(error.isEmpty() ? std::nullopt : std::optional(error), path);
                   });
    });
    buildFigureScale(file.addMenu(QT_TR_NOOP("Figure s&cale")));
    file.add("file.framebuffer", QT_TR_NOOP("Export frame&buffer 1:1\u2026"), {Qt::CTRL | Qt::Key_F12}, [this] {
        chooseFileToExport(tr("Export framebuffer"), QStringLiteral("framebuffer.png"), false,
                           [this](const QString& path) { exportFramebuffer(path); });
    });
    file.add("file.window", QT_TR_NOOP("Export &window\u2026"), {Qt::SHIFT | Qt::Key_F12}, [this] {
        chooseFileToExport(tr("Export window"), QStringLiteral("window.png"), false,
                           [this](const QString& path) { exportWindow(path); });
    });
    file.add("file.copy", QT_TR_NOOP("&Copy figure"), {Qt::CTRL | Qt::Key_C},
             [this] { copyPicture(m_figures->image()); });
    file.add("file.copy-framebuffer", QT_TR_NOOP("Copy framebuffer 1:1"), {Qt::CTRL | Qt::SHIFT | Qt::Key_C}, [this] {
        if (m_lastFrame)
            copyPicture(m_lastFrame->frame.image.copy());
    });
}

/// A clipboard is not seen: that something lies on it is said.
void MainWindow::copyPicture(const QImage& picture)
{
    if (picture.isNull()) {
        m_message->show(MessageKind::Error, tr("Nothing is copied: the picture is empty or too large."));
        return;
    }
    QGuiApplication::clipboard()->setImage(picture);
    m_message->show(MessageKind::Info,
                    tr("On the clipboard: a picture of %1 x %2 pixels.").arg(picture.width()).arg(picture.height()));
}

void MainWindow::buildFigureScale(ActionMenu scale)
{
    auto* scales = new QActionGroup(this);
    const auto addScale = [&](const QString& id, const ActionWords& words, std::optional<int> zoom) {
        QAction* action = scales->addAction(scale.add(id, words, {}, [this, zoom] { m_figures->setZoom(zoom); }));
        action->setCheckable(true);
        action->setChecked(zoom == m_figures->zoom());
    };
    addScale(QStringLiteral("file.scale-screen"), scale.words(QT_TR_NOOP("As on the screen")), std::nullopt);
    for (const int zoom : {1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128})
        addScale(QStringLiteral("file.scale-%1").arg(zoom), {.name = QStringLiteral("%1\u00d7").arg(zoom)}, zoom);
    scale.addSeparator();
    scale.addToggle("file.figure-texts", QT_TR_NOOP("With caption, formula and legend"), {}, m_figures->hasTexts(),
                    [this](bool on) { m_figures->setTexts(on); });
}

void MainWindow::buildEditMenu()
{
    ActionMenu edit = addMenu(ActionSection::Edit, QT_TR_NOOP("&Edit"));
    m_undo = edit.add("edit.undo", QT_TR_NOOP("&Undo"), {Qt::CTRL | Qt::Key_Z}, [this] { m_document.undo(); });
    m_redo = edit.add("edit.redo", QT_TR_NOOP("&Redo"), {Qt::CTRL | Qt::SHIFT | Qt::Key_Z, Qt::CTRL | Qt::Key_Y},
                      [this] { m_document.redo(); });
    edit.addSeparator();
    m_reset = edit.add("edit.reset-settings", QT_TR_NOOP("Reset &settings"), {Qt::CTRL | Qt::Key_Backspace},
                       [this] { m_document.resetSettings(); });
}

void MainWindow::buildViewMenu()
{
    ActionMenu view = addMenu(ActionSection::Canvas, QT_TR_NOOP("&View"));
    m_fit = view.add("view.fit", QT_TR_NOOP("&Fit"), {Qt::Key_F}, [this] { m_viewport->fit(); });
    m_oneToOne =
        view.add("view.one-to-one", QT_TR_NOOP("1:1"), {Qt::CTRL | Qt::Key_1}, [this] { m_viewport->setZoom(1); });
    m_zoomIn = view.add("view.zoom-in", QT_TR_NOOP("Zoom in"), {Qt::CTRL | Qt::Key_Plus, Qt::CTRL | Qt::Key_Equal},
                        [this] { m_viewport->zoomStep(1); });
    m_zoomOut = view.add("view.zoom-out", QT_TR_NOOP("Zoom out"), {Qt::CTRL | Qt::Key_Minus},
                         [this] { m_viewport->zoomStep(-1); });
    m_goTo =
        view.add("view.go-to-pixel", QT_TR_NOOP("&Go to pixel"), {Qt::CTRL | Qt::Key_G}, [this] { toggleGoToPixel(); });
    view.addSeparator();
    buildCamera(view.in(ActionSection::Camera));
    buildMotion(view.in(ActionSection::Camera));
    view.addSeparator();
    m_views->buildMenu(view);
    view.addSeparator();
    buildDrawing(view.in(ActionSection::Window));
    view.addSeparator();
    buildAppearance(view.in(ActionSection::Window));
}

void MainWindow::moveCamera(const View& view)
{
    if (m_document.scene()->space != SceneSpace::Object)
        return;
    Settings next = m_document.settings();
    next.view = view;
    m_document.setSettings(next, Document::Edit::Camera);
}

void MainWindow::buildCamera(ActionMenu menu)
{
    const auto addCamera = [&](const char* id, const char* text, Qt::Key key, auto next) {
        m_cameraActions.push_back(menu.add(id, text, {key}, [this, next] {
            m_document.endGesture();
            moveCamera(next());
            m_document.endGesture();
        }));
        return m_cameraActions.back();
    };
    const auto axis = [this](AxisView which) {
        return [this, which] { return axisView(m_document.settings().view, which); };
    };
    QAction* front = addCamera("camera.front", QT_TR_NOOP("From the front"), Qt::Key_1, axis(AxisView::Front));
    QAction* right = addCamera("camera.right", QT_TR_NOOP("From the right"), Qt::Key_3, axis(AxisView::Right));
    QAction* above = addCamera("camera.above", QT_TR_NOOP("From above"), Qt::Key_7, axis(AxisView::Top));
    m_actions.listTogether(menu.words(QT_TR_NOOP("From the front, the right, above")), {front, right, above});
    addCamera("camera.reset", QT_TR_NOOP("Reset camera"), Qt::Key_Home, [this] { return m_document.defaults().view; });
}

/// What moves by itself.
void MainWindow::buildMotion(ActionMenu menu)
{
    const auto addMotion = [&](const char* id, Motion motion, const QKeySequence& keys) {
        QAction* action = menu.add(id, ActionWords{"Motion", infoOf(motion).title}, {keys}, [this, motion](bool on) {
            on ? m_motion->start(motion) : m_motion->stop();
            syncMotion();
        });
        action->setCheckable(true);
        m_motionActions.push_back(action);
    };
    addMotion("camera.turntable", Motion::Turntable, Qt::CTRL | Qt::Key_T);
    addMotion("camera.jitter", Motion::Jitter, Qt::CTRL | Qt::Key_J);
}

/// What moves is neither stepped through nor judged.
void MainWindow::connectMotion()
{
    connect(m_motion.get(), &MotionMode::frameChanged, this, &MainWindow::showFrame);
    connect(m_motion.get(), &MotionMode::motionChanged, this, [this] {
        if (m_motion->motion()) {
            m_stepMode->session().close();
            m_truth->referee().setOn(false);
        }
        syncMotion();
    });
    connect(&m_stepMode->session(), &StepSession::openChanged, m_motion.get(), [this](bool open) {
        if (open)
            m_motion->stop();
    });
}

void MainWindow::syncMotion()
{
    for (const MotionInfo& info : motions())
        m_motionActions[static_cast<std::size_t>(info.motion)]->setChecked(m_motion->motion() == info.motion);
}

/// When the worker draws.
void MainWindow::buildDrawing(ActionMenu menu)
{
    m_fastMotion = menu.addToggle("view.fast-first", QT_TR_NOOP("Fast first picture (camera moves, slow scenes)"), {},
                                  true, [this](bool on) { m_worker.setFastMotion(on); });
    m_actions.listWithoutKey(m_fastMotion, menu.words(QT_TR_NOOP("Menu View")));
    menu.addToggle("view.continuous", QT_TR_NOOP("Draw continuously (measures FPS)"), {Qt::SHIFT | Qt::Key_R}, false,
                   [this](bool on) { m_worker.setContinuous(on); });
}

void MainWindow::buildAppearance(ActionMenu menu)
{
    menu.add("view.reset-layout", QT_TR_NOOP("Reset &layout"), {Qt::CTRL | Qt::Key_0}, [this] { resetLayout(); });
    m_presentation = menu.addToggle("view.presentation", QT_TR_NOOP("P&resentation"), {Qt::Key_F11}, false,
                                    [this](bool on) { setPresentation(on); });
    m_fullScreen = menu.addToggle("view.full-screen", QT_TR_NOOP("Full s&creen"), {Qt::SHIFT | Qt::Key_F11}, false,
                                  [this](bool on) {
                                      if (!m_look.presentation) // which takes the whole screen anyway
                                          m_placement->setFullScreen(on);
                                  });
    m_dark = menu.addToggle("view.dark", QT_TR_NOOP("&Dark theme"), {Qt::CTRL | Qt::SHIFT | Qt::Key_D}, false,
                            [this](bool on) {
                                Look look = m_look;
                                look.kind = on ? ThemeKind::Dark : ThemeKind::Light;
                                setLook(look);
                            });
    buildLanguages(menu.addMenu({.name = QStringLiteral("Language / \u8bed\u8a00")}));
}

void MainWindow::buildLanguages(ActionMenu language)
{
    m_languageMenu = language.menu();
    auto* languages = new QActionGroup(this);
    const auto addLanguage = [&](const char* id, const QString& name, LanguageKind kind) {
        QAction* action =
            languages->addAction(language.add(id, {.name = name}, {}, [this, kind] { setLanguage(kind); }));
        action->setCheckable(true);
        action->setChecked(kind == LanguageKind::English);
        return action;
    };
    m_english = addLanguage("view.english", QStringLiteral("English"), LanguageKind::English);
    m_chinese = addLanguage("view.chinese", QStringLiteral("\u4e2d\u6587"), LanguageKind::Chinese);
}

void MainWindow::buildSettingsMenu()
{
    ActionMenu menu = addMenu(ActionSection::Pipeline, QT_TR_NOOP("&Settings"));
    for (const FieldKey& row : kFieldKeys) {
        const QString id = QLatin1String(row.field);
        const SettingsField* field = findSettingsField(id);
        const ActionWords title{"Settings", field->title};
        QAction* action = menu.add(QStringLiteral("settings.") + id, title, {row.key}, [this, field, row] {
            if (row.isToggle())
                changeField(*field, withOtherOf(*field, row.one, row.other, m_document.settings()));
            else
                stepField(*field);
        });
        m_actions.setState(
            action, [this, field] { return valueTitle(*field, m_document.settings()); }, true);
        m_pipelinePanel->setKeyHint(id, action->shortcut().toString());
        if (!row.isToggle())
            continue;
        QAction* next = menu.add(QStringLiteral("settings.%1.next").arg(id), menu.words(row.next),
                                 {Qt::SHIFT | row.key}, [this, field] { stepField(*field); });
        m_actions.listTogether(title, {action, next});
    }
    menu.addSeparator();
    menu.menu()->addMenu(m_languageMenu); // that of the menu View: in many programs it is a setting
}

void MainWindow::buildMistakesMenu()
{
    ActionMenu menu = addMenu(ActionSection::Pipeline, QT_TR_NOOP("&Mistakes"));
    const QAction* list = menu.add("mistakes.list", QT_TR_NOOP("List of mistakes"), {Qt::Key_M}, [this] {
        const bool open = !m_panels->isInSight(m_pipelineDock) || !m_pipelinePanel->mistakes().isOpen();
        m_panels->showScene();
        m_pipelinePanel->mistakes().setOpen(open);
    });
    m_actions.setState(list, [this] { return QString::number(m_document.settings().mistakes.size()); });
    m_pipelinePanel->mistakes().setKeyHint(list->shortcut().toString());
    m_mistakesMenu = new MistakesMenu(m_document, m_language, menu);
}

void MainWindow::buildHelpMenu()
{
    ActionMenu help = addMenu(ActionSection::Window, QT_TR_NOOP("&Help"));
    help.add("help.guide", QT_TR_NOOP("&Guide"), {Qt::SHIFT | Qt::Key_F1}, [this] { m_guide->open(); });
    help.add("help.search", QT_TR_NOOP("&Search for an action\u2026"), {Qt::CTRL | Qt::SHIFT | Qt::Key_P},
             [this] { m_search->toggle(); });
    help.add("help.keys", QT_TR_NOOP("&Keys and their states"), {Qt::Key_H, Qt::Key_F1}, [this] { toggleHelp(); });
    help.add("help.about", QT_TR_NOOP("&About RasterLens"), {}, [this] {
        m_message->show(
            MessageKind::Info,
            tr("RasterLens %1 shows how a triangle becomes pixels.").arg(QStringLiteral(RASTERLENS_VERSION)));
    });
    addHint("window.leave", ActionSection::Window, QT_TR_NOOP("Esc"),
            QT_TR_NOOP("Leave field, help, presentation, steps"));
    addHint("window.next-field", ActionSection::Window, QT_TR_NOOP("Tab, Shift + Tab"),
            QT_TR_NOOP("To the next field, back"));
}

/// All menus once more, for the presentation, which has no menu bar.
void MainWindow::buildStageMenu()
{
    auto* menu = new QMenu(this);
    for (QAction* one : menuBar()->actions())
        menu->addAction(one);
    m_stageMenu->setMenu(menu);
}

void MainWindow::retranslate()
{
    m_actions.retranslate();
    // The links above the canvas are short.
    m_fit->setIconText(tr("Fit"));
    m_zoomIn->setIconText(QStringLiteral("+"));
    m_zoomOut->setIconText(QStringLiteral("\u2212"));
    m_goToButton->setText(withoutMnemonic(m_goTo->text()));
    m_goToButton->setToolTip(
        QStringLiteral("%1 (%2)").arg(m_goToButton->text(), m_goTo->shortcut().toString(QKeySequence::NativeText)));
    m_views->retranslate();
    m_viewsBar->retranslate();
    m_mistakesMenu->retranslate();
    m_cards->retranslate();
    m_truth->retranslate();
    m_lessons->retranslate();
    m_lifeCycle->retranslate();
    m_guide->setLanguage(m_language.kind());
    m_pipelineDock->setTitle(tr("Scene"));
    m_statisticsDock->setTitle(tr("Statistics"));
    m_copyCsv->setToolTip(tr("Copy the counters as CSV"));
    m_stageMenu->setToolTip(tr("All menus: scenes, mistakes, panels, lessons"));
    m_stageMenu->setAccessibleName(m_stageMenu->toolTip());
    m_copyJson->setToolTip(tr("Copy the counters as JSON"));
    fillRecentMenu();
    syncActions();
    syncCounters();
    syncReadout();
    syncTitle();
    syncCaption();
    if (m_refused)
        updatePicture();
}

void MainWindow::syncActions()
{
    m_undo->setEnabled(m_document.canUndo());
    m_redo->setEnabled(m_document.canRedo());
    m_reload->setEnabled(m_document.isReloadable());
    m_reset->setEnabled(!(m_document.settings() == m_document.defaults()));
    m_actions.syncStates();
    syncHelp();
}

} // namespace rasterlens
