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
#include "ui/window/main_window.h"

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
    m_builtinMenu = addMenu(file, QT_TR_NOOP("&Built-in scenes"));
    file->addSeparator();
    add(file, QT_TR_NOOP("&Save session"), QKeySequence::Save, [this] {
        if (m_document.sessionPath().isEmpty())
            chooseSessionToSave();
        else if (m_document.saveSession(m_document.sessionPath()))
            reportSaved(std::nullopt, m_document.sessionPath());
    });
    add(file, QT_TR_NOOP("Save session &as\u2026"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S),
        [this] { chooseSessionToSave(); });
    file->addSeparator();
    add(file, QT_TR_NOOP("Export &figure\u2026"), Qt::Key_F12, [this] {
        chooseFileToExport(tr("Export figure"), QStringLiteral("figure.png"),
                           [this](const QString& path) { exportFigure(path); });
    });
    add(file, QT_TR_NOOP("Export figure as S&VG\u2026"), {}, [this] {
        chooseFileToExport(tr("Export figure as SVG"), QStringLiteral("figure.svg"),
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
        chooseFileToExport(tr("Export framebuffer"), QStringLiteral("framebuffer.png"),
                           [this](const QString& path) { exportFramebuffer(path); });
    });
    add(file, QT_TR_NOOP("Export &window\u2026"), QKeySequence(Qt::SHIFT | Qt::Key_F12), [this] {
        chooseFileToExport(tr("Export window"), QStringLiteral("window.png"),
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
    addToggle(view, QT_TR_NOOP("Draw continuously (measures FPS)"), QKeySequence(Qt::SHIFT | Qt::Key_R), false,
              [this](bool on) { m_worker.setContinuous(on); });
    view->addSeparator();
    buildAppearanceMenus(view);
}

void MainWindow::buildAppearanceMenus(QMenu* view)
{
    QMenu* panels = addMenu(view, QT_TR_NOOP("&Panels"));
    for (Dock* dock : {m_pipelineDock, m_statisticsDock})
        panels->addAction(dock->toggleViewAction());
    panels->addAction(m_stepMode->transport().toggleViewAction());
    for (const auto& docks : {m_cards->docks(), m_truth->docks()})
        for (Dock* dock : docks)
            panels->addAction(dock->toggleViewAction());
    add(view, QT_TR_NOOP("Reset &layout"), QKeySequence(Qt::CTRL | Qt::Key_0), [this] { resetLayout(); });
    m_presentation =
        addToggle(view, QT_TR_NOOP("P&resentation"), Qt::Key_F11, false, [this](bool on) { setPresentation(on); });
    m_fullScreen = addToggle(view, QT_TR_NOOP("Full s&creen"), QKeySequence(Qt::SHIFT | Qt::Key_F11), false,
                             [this](bool on) { on ? showFullScreen() : showNormal(); });
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
    if (m_refused)
        updatePicture(); // says why again
    m_pipelineDock->setTitle(tr("Scene"));
    m_statisticsDock->setTitle(tr("Statistics"));
    m_pipelineDock->toggleViewAction()->setText(tr("Scene and pipeline"));
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

void MainWindow::fillRecentMenu()
{
    m_recentMenu->clear();
    const QStringList files = m_document.recentFiles();
    for (const QString& path : files) {
        QAction* action = m_recentMenu->addAction(QFileInfo(path).fileName());
        action->setToolTip(path);
        action->setStatusTip(path);
        connect(action, &QAction::triggered, this, [this, path] { m_document.open(path); });
    }
    m_recentMenu->setToolTipsVisible(true);
    if (!files.isEmpty()) {
        m_recentMenu->addSeparator();
        connect(m_recentMenu->addAction(tr("Clear")), &QAction::triggered, this,
                [this] { m_document.clearRecentFiles(); });
    }
    m_recentMenu->menuAction()->setEnabled(!files.isEmpty());
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
                    {QStringLiteral("Ctrl+0"), tr("reset layout"), {}},
                    {QStringLiteral("Ctrl+Z  Ctrl+Y"), tr("undo, redo"), {}},
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
          {QStringLiteral("S"), tr("wipe between A and B"), compared == CompareView::Wipe ? on : off},
          {QStringLiteral("B"), tr("blink A and B"), compared == CompareView::Blink ? on : off},
          {QStringLiteral("D"), tr("difference of A and B"), compared == CompareView::Difference ? on : off},
          {QStringLiteral("A  Shift+A"), tr("pin A, exchange A and B"), {}}}});
    m_help->setSections(sections);
}

void MainWindow::chooseFileToOpen()
{
    auto* dialog = new QFileDialog(this, tr("Open"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    dialog->setNameFilters({tr("Scenes, cases and sessions (*.obj *.case *.json)"), tr("All files (*)")});
    connect(dialog, &QFileDialog::fileSelected, &m_document, &Document::open);
    dialog->open();
}

void MainWindow::chooseSessionToSave()
{
    auto* dialog = new QFileDialog(this, tr("Save session"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("json"));
    dialog->setNameFilter(tr("Sessions (*.json)"));
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
        if (m_document.saveSession(path))
            reportSaved(std::nullopt, path);
    });
    dialog->open();
}

void MainWindow::chooseFileToExport(const QString& title, const QString& suggestion,
                                    std::function<void(const QString&)> save)
{
    auto* dialog = new QFileDialog(this, title);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    const QString suffix = QFileInfo(suggestion).suffix();
    dialog->setDefaultSuffix(suffix);
    dialog->setNameFilter(suffix == QLatin1String("svg") ? tr("SVG drawings (*.svg)") : tr("PNG images (*.png)"));
    dialog->selectFile(suggestion);
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
    const auto error = path.endsWith(QLatin1String(".svg"), Qt::CaseInsensitive)
                           ? m_viewport->saveSvgFigure(m_figureZoom, path)
                           : savePng(m_viewport->figure(m_figureZoom), path);
    reportSaved(error, path);
    return !error;
}

bool MainWindow::exportFramebuffer(const QString& path)
{
    const auto error = savePng(m_lastFrame ? m_lastFrame->frame.image : QImage(), path);
    reportSaved(error, path);
    return !error;
}

bool MainWindow::exportWindow(const QString& path)
{
    const auto error = savePng(picture(), path);
    reportSaved(error, path);
    return !error;
}

void MainWindow::reportSaved(const std::optional<QString>& error, const QString& path)
{
    m_message->show(error ? MessageKind::Error : MessageKind::Info, error ? *error : tr("Written: %1").arg(path));
}

} // namespace rasterlens
