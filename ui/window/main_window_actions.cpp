#include "core/io/picture_file.h"
#include "core/scenes/builtin_scenes.h"
#include "ui/base/applicability.h"
#include "ui/base/dock.h"
#include "ui/base/image_export.h"
#include "ui/base/message_bar.h"
#include "ui/document/navigation.h"
#include "ui/face/cards.h"
#include "ui/pipeline/mistakes_section.h"
#include "ui/pipeline/pipeline_panel.h"
#include "ui/steps/step_mode.h"
#include "ui/steps/transport_dock.h"
#include "ui/truth/truth_mode.h"
#include "ui/window/help_overlay.h"
#include "ui/window/life_cycle.h"
#include "ui/window/main_window.h"
#include "ui/window/panel_places.h"
#include "ui/window/window_placement.h"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QClipboard>
#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QPainter>
#include <QToolButton>

#include <array>
#include <utility>

namespace rasterlens
{
namespace
{

const QString kSvg = QStringLiteral("svg");

} // namespace

QMenu* MainWindow::addMenu(QMenu* parent, const char* text)
{
    QMenu* menu = parent ? parent->addMenu(QString()) : menuBar()->addMenu(QString());
    m_actions.push_back({menu->menuAction(), text});
    return menu;
}

QAction* MainWindow::add(QMenu* menu, const char* text, const QKeySequence& key, std::function<void()> run)
{
    QAction* action = menu->addAction(QString());
    action->setShortcut(key);
    connect(action, &QAction::triggered, this, [run = std::move(run)] { run(); });
    m_actions.push_back({action, text});
    addAction(action); // keys work also while the menu bar is hidden
    return action;
}

QAction* MainWindow::addToggle(QMenu* menu, const char* text, const QKeySequence& key, bool on,
                               std::function<void(bool)> run)
{
    QAction* action = menu->addAction(QString());
    action->setShortcut(key);
    action->setCheckable(true);
    action->setChecked(on);
    connect(action, &QAction::triggered, this, std::move(run));
    m_actions.push_back({action, text});
    addAction(action);
    return action;
}

void MainWindow::buildMenus()
{
    buildFileMenu();
    buildEditMenu();
    buildViewMenu();
    m_panels->buildMenu(addMenu(nullptr, QT_TR_NOOP("&Panels")));
    buildSettingsMenu();
    menuBar()->addMenu(m_stepMode->transport().menu());
    menuBar()->addMenu(m_truth->menu());
    buildMistakesMenu();
    buildHelpMenu();
}

void MainWindow::buildFileMenu()
{
    QMenu* file = addMenu(nullptr, QT_TR_NOOP("&File"));
    add(file, QT_TR_NOOP("&Open\u2026"), QKeySequence::Open, [this] { chooseFileToOpen(); });
    m_recentMenu = addMenu(file, QT_TR_NOOP("Open &recent"));
    connect(m_recentMenu, &QMenu::aboutToShow, this, &MainWindow::fillRecentMenu); // files come and go
    m_builtinMenu = addMenu(file, QT_TR_NOOP("&Built-in scenes"));
    m_reload = add(file, QT_TR_NOOP("Re&load from disk"), Qt::Key_F5, [this] { m_lifeCycle->reload(); });
    file->addSeparator();
    add(file, QT_TR_NOOP("&Save session"), QKeySequence::Save, [this] { m_lifeCycle->save(); });
    add(file, QT_TR_NOOP("Save session &as\u2026"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S),
        [this] { m_lifeCycle->saveAs(); });
    file->addSeparator();
    add(file, QT_TR_NOOP("Export &figure\u2026"), Qt::Key_F12, [this] {
        chooseFileToExport(tr("Export figure"), QStringLiteral("figure.png"), true,
                           [this](const QString& path) { exportFigure(path); });
    });
    add(file, QT_TR_NOOP("Export figure as S&VG\u2026"), {}, [this] {
        chooseFileToExport(tr("Export figure as SVG"), QStringLiteral("figure.svg"), true,
                           [this](const QString& path) { exportFigure(path); });
    });
    add(file, QT_TR_NOOP("Export a &run of steps\u2026"), {}, [this] { m_stepMode->chooseRunToExport(m_figureZoom); });
    QMenu* scale = addMenu(file, QT_TR_NOOP("Figure s&cale"));
    auto* scales = new QActionGroup(this);
    const auto addScale = [&](QAction* action, std::optional<int> zoom) {
        action->setCheckable(true);
        action->setChecked(zoom == m_figureZoom);
        scales->addAction(action);
        connect(action, &QAction::triggered, this, [this, zoom] { m_figureZoom = zoom; });
    };
    addScale(add(scale, QT_TR_NOOP("As on the screen"), {}, [] {}), std::nullopt);
    for (const int zoom : {1, 2, 3, 4, 6, 8, 12, 16, 24, 32})
        addScale(scale->addAction(QStringLiteral("%1\u00d7").arg(zoom)), zoom);
    add(file, QT_TR_NOOP("Export frame&buffer 1:1\u2026"), QKeySequence(Qt::CTRL | Qt::Key_F12), [this] {
        chooseFileToExport(tr("Export framebuffer"), QStringLiteral("framebuffer.png"), false,
                           [this](const QString& path) { exportFramebuffer(path); });
    });
    add(file, QT_TR_NOOP("Export &window\u2026"), QKeySequence(Qt::SHIFT | Qt::Key_F12), [this] {
        chooseFileToExport(tr("Export window"), QStringLiteral("window.png"), false,
                           [this](const QString& path) { exportWindow(path); });
    });
    add(file, QT_TR_NOOP("Copy &image"), QKeySequence::Copy, [this] {
        if (m_lastFrame)
            QGuiApplication::clipboard()->setImage(m_lastFrame->frame.image.copy());
    });
    file->addSeparator();
    add(file, QT_TR_NOOP("&Quit"), QKeySequence(Qt::CTRL | Qt::Key_Q), [this] { close(); });
}

void MainWindow::buildEditMenu()
{
    QMenu* edit = addMenu(nullptr, QT_TR_NOOP("&Edit"));
    m_undo = add(edit, QT_TR_NOOP("&Undo"), QKeySequence::Undo, [this] { m_document.undo(); });
    m_redo = add(edit, QT_TR_NOOP("&Redo"), {}, [this] { m_document.redo(); });
    m_redo->setShortcuts({QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)});
    edit->addSeparator();
    m_reset = add(edit, QT_TR_NOOP("Reset &settings"), QKeySequence(Qt::CTRL | Qt::Key_Backspace),
                  [this] { m_document.resetSettings(); });
}

void MainWindow::buildViewMenu()
{
    QMenu* view = addMenu(nullptr, QT_TR_NOOP("&View"));
    m_fit = add(view, QT_TR_NOOP("&Fit"), Qt::Key_F, [this] { m_viewport->fit(); });
    m_oneToOne = add(view, QT_TR_NOOP("1:1"), QKeySequence(Qt::CTRL | Qt::Key_1), [this] { m_viewport->setZoom(1); });
    m_zoomIn = add(view, QT_TR_NOOP("Zoom in"), {}, [this] { m_viewport->zoomStep(1); });
    m_zoomIn->setShortcuts({QKeySequence(Qt::CTRL | Qt::Key_Plus), QKeySequence(Qt::CTRL | Qt::Key_Equal)});
    m_zoomOut =
        add(view, QT_TR_NOOP("Zoom out"), QKeySequence(Qt::CTRL | Qt::Key_Minus), [this] { m_viewport->zoomStep(-1); });
    m_goTo = add(view, QT_TR_NOOP("&Go to pixel"), QKeySequence(Qt::CTRL | Qt::Key_G), [this] { toggleGoToPixel(); });
    view->addSeparator();
    const auto addCamera = [&](const char* text, const QKeySequence& key, auto next) {
        QAction* action = add(view, text, key, [this, next] {
            m_document.endGesture();
            moveCamera(next());
            m_document.endGesture();
        });
        m_cameraActions.push_back(action);
    };
    const auto axis = [this](AxisView which) {
        return [this, which] { return axisView(m_document.settings().view, which); };
    };
    addCamera(QT_TR_NOOP("From the front"), Qt::Key_1, axis(AxisView::Front));
    addCamera(QT_TR_NOOP("From the right"), Qt::Key_3, axis(AxisView::Right));
    addCamera(QT_TR_NOOP("From above"), Qt::Key_7, axis(AxisView::Top));
    addCamera(QT_TR_NOOP("Reset camera"), Qt::Key_Home, [this] { return m_document.defaults().view; });
    view->addSeparator();
    const auto overlay = [this](bool OverlayOptions::*member) {
        return [this, member](bool on) {
            OverlayOptions options = m_viewport->overlays();
            options.*member = on;
            m_viewport->setOverlays(options);
        };
    };
    addToggle(view, QT_TR_NOOP("Pixel grid (from 8\u00d7)"), {}, true, overlay(&OverlayOptions::grid));
    addToggle(view, QT_TR_NOOP("Sample positions (from 16\u00d7)"), {}, true, overlay(&OverlayOptions::sampleDots));
    addToggle(view, QT_TR_NOOP("Pixel values (from 48\u00d7)"), {}, true, overlay(&OverlayOptions::numbers));
    m_fastMotion = addToggle(view, QT_TR_NOOP("Fast first picture (camera moves, slow scenes)"), {}, true,
                             [this](bool on) { m_worker.setFastMotion(on); });
    m_continuous = addToggle(view, QT_TR_NOOP("Draw continuously (measures FPS)"), QKeySequence(Qt::SHIFT | Qt::Key_R),
                             false, [this](bool on) { m_worker.setContinuous(on); });
    view->addSeparator();
    buildAppearanceMenus(view);
}

void MainWindow::buildAppearanceMenus(QMenu* view)
{
    add(view, QT_TR_NOOP("Reset &layout"), QKeySequence(Qt::CTRL | Qt::Key_0), [this] { resetLayout(); });
    m_presentation =
        addToggle(view, QT_TR_NOOP("P&resentation"), Qt::Key_F11, false, [this](bool on) { setPresentation(on); });
    m_fullScreen =
        addToggle(view, QT_TR_NOOP("Full s&creen"), QKeySequence(Qt::SHIFT | Qt::Key_F11), false, [this](bool on) {
            if (!m_look.presentation) // which takes the whole screen anyway
                m_placement->setFullScreen(on);
        });
    m_dark = addToggle(view, QT_TR_NOOP("&Dark theme"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_D), false,
                       [this](bool on) {
                           Look look = m_look;
                           look.kind = on ? ThemeKind::Dark : ThemeKind::Light;
                           setLook(look);
                       });
    QMenu* language = view->addMenu(QStringLiteral("English / \u4e2d\u6587"));
    auto* languages = new QActionGroup(this);
    const auto addLanguage = [&](const QString& name, LanguageKind kind) {
        QAction* action = languages->addAction(language->addAction(name));
        action->setCheckable(true);
        action->setChecked(kind == LanguageKind::English);
        connect(action, &QAction::triggered, this, [this, kind] { setLanguage(kind); });
        return action;
    };
    m_english = addLanguage(QStringLiteral("English"), LanguageKind::English);
    m_chinese = addLanguage(QStringLiteral("\u4e2d\u6587"), LanguageKind::Chinese);
}

void MainWindow::buildSettingsMenu()
{
    QMenu* menu = addMenu(nullptr, QT_TR_NOOP("&Settings"));
    constexpr std::pair<const char*, Qt::Key> kKeys[] = {
        {"clipping", Qt::Key_X},  {"number-type", Qt::Key_N}, {"culling", Qt::Key_C},       {"fill", Qt::Key_W},
        {"algorithm", Qt::Key_E}, {"depth-test", Qt::Key_T},  {"interpolation", Qt::Key_P},
    };
    for (const auto& [id, key] : kKeys) {
        const SettingsField* field = findSettingsField(QLatin1String(id));
        QAction* action = menu->addAction(QString());
        action->setShortcut(key);
        addAction(action);
        connect(action, &QAction::triggered, this, [this, field] { stepField(*field); });
        m_fieldKeys.push_back({id, key, action});
        m_pipelinePanel->setKeyHint(QLatin1String(id), QKeySequence(key).toString());
    }
}

void MainWindow::buildMistakesMenu()
{
    QMenu* menu = addMenu(nullptr, QT_TR_NOOP("&Mistakes"));
    add(menu, QT_TR_NOOP("List of mistakes"), Qt::Key_M, [this] {
        const bool open = !m_pipelineDock->isVisible() || !m_pipelinePanel->mistakes().isOpen();
        m_pipelineDock->show();
        m_pipelinePanel->mistakes().setOpen(open);
    });
    m_pipelinePanel->mistakes().setKeyHint(QKeySequence(Qt::Key_M).toString());
    m_mistakesMenu = new MistakesMenu(m_document, m_language, menu);
}

void MainWindow::buildHelpMenu()
{
    QMenu* help = addMenu(nullptr, QT_TR_NOOP("&Help"));
    add(help, QT_TR_NOOP("&Keys and their states"), Qt::Key_H, [this] { toggleHelp(); });
    add(help, QT_TR_NOOP("&About RasterLens"), {}, [this] {
        m_message->show(
            MessageKind::Info,
            tr("RasterLens %1 shows how a triangle becomes pixels.").arg(QStringLiteral(RASTERLENS_VERSION)));
    });
}

void MainWindow::retranslate()
{
    retranslateActions();
    m_mistakesMenu->retranslate();
    m_cards->retranslate();
    m_truth->retranslate();
    m_lifeCycle->retranslate();
    m_pipelineDock->setTitle(tr("Scene"));
    m_statisticsDock->setTitle(tr("Statistics"));
    m_pipelineDock->toggleViewAction()->setText(tr("Scene and pipeline"));
    m_panels->retranslate();
    m_copyCsv->setToolTip(tr("Copy the counters as CSV"));
    m_copyJson->setToolTip(tr("Copy the counters as JSON"));
    m_goToButton->setText(tr("Go to pixel (%1)").arg(m_goTo->shortcut().toString(QKeySequence::NativeText)));
    fillRecentMenu();
    fillBuiltinMenu();
    syncActions();
    syncReadout();
    syncTitle();
    syncCaption();
    if (m_refused)
        updatePicture();
}

void MainWindow::retranslateActions()
{
    for (const TranslatedAction& entry : m_actions)
        entry.action->setText(tr(entry.text));
    // The links above the canvas are short.
    m_fit->setIconText(tr("Fit"));
    m_zoomIn->setIconText(QStringLiteral("+"));
    m_zoomOut->setIconText(QStringLiteral("\u2212"));
}

void MainWindow::fillBuiltinMenu()
{
    m_builtinMenu->clear();
    for (const BuiltinScene& scene : builtinScenes()) {
        QAction* action = m_builtinMenu->addAction(QCoreApplication::translate("BuiltinScene", scene.title));
        action->setToolTip(QCoreApplication::translate("BuiltinScene", scene.note));
        const QString name = QStringLiteral("builtin:") + QLatin1String(scene.name);
        connect(action, &QAction::triggered, this, [this, name] { m_document.open(name); });
    }
    m_builtinMenu->addSeparator();
    for (const StressScene& scene : stressScenes()) {
        QAction* action = m_builtinMenu->addAction(QCoreApplication::translate("StressScene", scene.title));
        const QString name = QStringLiteral("stress:") + QLatin1String(scene.name);
        connect(action, &QAction::triggered, this, [this, name] { m_document.open(name); });
    }
    m_builtinMenu->setToolTipsVisible(true);
    m_builtinMenu->menuAction()->setEnabled(!builtinScenes().empty());
}

void MainWindow::syncActions()
{
    m_undo->setEnabled(m_document.canUndo());
    m_redo->setEnabled(m_document.canRedo());
    m_reload->setEnabled(m_document.isReloadable());
    m_reset->setEnabled(!(m_document.settings() == m_document.defaults()));
    for (const FieldKey& entry : m_fieldKeys) {
        const SettingsField* field = findSettingsField(QLatin1String(entry.field));
        entry.action->setText(QStringLiteral("%1: %2").arg(QCoreApplication::translate("Settings", field->title),
                                                           valueTitle(*field, m_document.settings())));
    }
    if (m_help->isVisible())
        syncHelp();
}

void MainWindow::toggleHelp()
{
    if (m_help->isVisible()) {
        m_help->hide();
        return;
    }
    m_help->show();
    syncHelp();
}

void MainWindow::syncHelp()
{
    std::vector<HelpOverlay::Section> sections(4);
    sections[0].title = tr("Pipeline");
    for (const FieldKey& entry : m_fieldKeys) {
        const SettingsField* field = findSettingsField(QLatin1String(entry.field));
        sections[0].lines.push_back({QKeySequence(entry.key).toString(),
                                     QCoreApplication::translate("Settings", field->title),
                                     valueTitle(*field, m_document.settings())});
    }
    sections[0].lines.push_back(
        {QStringLiteral("M"), tr("mistakes"), QString::number(m_document.settings().mistakes.size())});
    sections[1] = {tr("Canvas"),
                   {{tr("Wheel"), tr("zoom at the cursor"), {}},
                    {tr("Middle drag, Shift + drag"), tr("move the picture"), {}},
                    {tr("Click, arrows"), tr("choose a pixel, move on by one"), {}},
                    {tr("Double click"), tr("close up of a pixel"), {}},
                    {QStringLiteral("F"), tr("fit"), {}},
                    {QStringLiteral("Ctrl+1"), tr("one to one"), {}},
                    {QStringLiteral("Ctrl+G"), tr("go to pixel"), {}}}};
    sections[2] = {tr("Camera"),
                   {{tr("Drag"), tr("orbit"), {}},
                    {tr("Right drag, Ctrl + wheel"), tr("nearer, farther"), {}},
                    {tr("Ctrl + drag"), tr("move the scene"), {}},
                    {QStringLiteral("1  3  7"), tr("front, right, above"), {}},
                    {tr("Home"), tr("reset camera"), {}}}};
    const QString on = tr("on");
    const QString off = tr("off");
    sections[3] = {tr("Window"),
                   {{QStringLiteral("F11"), tr("presentation"), m_look.presentation ? on : off},
                    {QStringLiteral("Ctrl+Shift+D"), tr("dark theme"), m_look.kind == ThemeKind::Dark ? on : off},
                    {QStringLiteral("Shift+R"), tr("draw continuously"), m_worker.isContinuous() ? on : off},
                    {tr("Menu View"), tr("fast first picture"), m_worker.hasFastMotion() ? on : off},
                    {tr("Esc"), tr("leave field, help, presentation, steps"), {}},
                    {QStringLiteral("Ctrl+0"), tr("reset layout"), {}},
                    {QStringLiteral("Ctrl+Z  Ctrl+Y"), tr("undo, redo"), {}},
                    {QStringLiteral("Ctrl+S"), tr("save session"), {}},
                    {QStringLiteral("F5"), tr("read files again"), {}},
                    {QStringLiteral("F12"), tr("figure with overlay"), {}},
                    {QStringLiteral("Ctrl+F12"), tr("framebuffer 1:1"), {}},
                    {QStringLiteral("Shift+F12"), tr("whole window"), {}},
                    {QStringLiteral("H"), tr("this list"), {}}}};
    sections.push_back({tr("Steps"),
                        {{QStringLiteral("R"), tr("record steps"), m_stepMode->session().isOpen() ? on : off},
                         {tr("Space"), tr("play, pause"), m_stepMode->session().isPlaying() ? on : off},
                         {tr("Left, Right"), tr("one step"), {}},
                         {tr("Shift + Left, Right"), tr("one row"), {}},
                         {tr("Ctrl + Left, Right"), tr("one face"), {}},
                         {tr("Ctrl + Shift + Left, Right"), tr("one stage"), {}},
                         {tr("Ctrl + Home, End"), tr("to the start, the end"), {}},
                         {QStringLiteral("[  ]"), tr("slower, faster"), {}}}});
    const CompareView compared = m_truth->comparison().view();
    sections.push_back(
        {tr("Compare"),
         {{QStringLiteral("V"), tr("exact referee"), m_truth->referee().isOn() ? on : off},
          {QStringLiteral("Shift+V"), tr("next wrong pixel"), {}},
          {QStringLiteral("Ctrl+Shift+V"), tr("judge from object space"),
           m_truth->referee().space() == ReferenceSpace::Object ? on : off},
          {QStringLiteral("S"), tr("wipe between A and B"), compared == CompareView::Wipe ? on : off},
          {QStringLiteral("B"), tr("blink A and B"), compared == CompareView::Blink ? on : off},
          {QStringLiteral("D"), tr("difference of A and B"), compared == CompareView::Difference ? on : off},
          {QStringLiteral("A  Shift+A"), tr("pin A, exchange A and B"), {}}}});
    HelpOverlay::Section panels{tr("Panels"), {}};
    for (const auto& [action, dock] : m_panels->actions())
        panels.lines.push_back(
            {action->shortcut().toString(), dock->toggleViewAction()->text(), m_panels->isInSight(dock) ? on : off});
    sections.push_back(std::move(panels));
    m_help->setSections(sections);
}

void MainWindow::chooseFileToExport(const QString& title, const QString& suggestion, bool asDrawing,
                                    std::function<void(const QString&)> save)
{
    const QStringList formats = pictureSuffixes() + (asDrawing ? QStringList{kSvg} : QStringList());
    QFileDialog* dialog = newExportDialog(this, title, suggestion, formats);
    connect(dialog, &QFileDialog::fileSelected, this, std::move(save));
    dialog->open();
}

QImage MainWindow::picture()
{
    QPixmap picture = grab();
    QPainter painter(&picture);
    for (Dock* dock : findChildren<Dock*>())
        if (dock->isVisible() && dock->isFloating())
            painter.drawPixmap(mapFromGlobal(dock->mapToGlobal(QPoint(0, 0))), dock->grab());
    painter.end();
    return picture.toImage();
}

bool MainWindow::exportFigure(const QString& path)
{
    const ExportTarget target{path, m_document.inputFiles()};
    const auto error = formatOf(path) == kSvg ? m_viewport->saveSvgFigure(m_figureZoom, target)
                                              : savePicture(m_viewport->figure(m_figureZoom), target, {kSvg});
    reportSaved(error, path);
    return !error;
}

bool MainWindow::exportFramebuffer(const QString& path)
{
    const auto error = savePicture(m_lastFrame ? m_lastFrame->frame.image : QImage(), {path, m_document.inputFiles()});
    reportSaved(error, path);
    return !error;
}

bool MainWindow::exportWindow(const QString& path)
{
    const auto error = savePicture(picture(), {path, m_document.inputFiles()});
    reportSaved(error, path);
    return !error;
}

void MainWindow::reportSaved(const std::optional<QString>& error, const QString& path)
{
    m_message->show(error ? MessageKind::Error : MessageKind::Info, error ? *error : tr("Written: %1").arg(path));
}

} // namespace rasterlens
