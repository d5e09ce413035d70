#include "ui/window/main_window.h"

#include "core/render/render.h"
#include "core/scenes/builtin_scenes.h"
#include "ui/base/applicability.h"
#include "ui/base/dock.h"
#include "ui/base/elided_label.h"
#include "ui/base/message_bar.h"
#include "ui/base/message_column.h"
#include "ui/base/parts.h"
#include "ui/base/typed_field.h"
#include "ui/document/navigation.h"
#include "ui/face/cards.h"
#include "ui/face/vertex_panel.h"
#include "ui/lessons/lesson_mode.h"
#include "ui/pipeline/canvas_views.h"
#include "ui/pipeline/mistake_badge.h"
#include "ui/pipeline/mistakes_section.h"
#include "ui/pipeline/pipeline_panel.h"
#include "ui/pipeline/scene_words.h"
#include "ui/pipeline/stage_strip.h"
#include "ui/pipeline/statistics_panel.h"
#include "ui/pipeline/views_bar.h"
#include "ui/steps/motion_mode.h"
#include "ui/steps/step_listing.h"
#include "ui/steps/step_mode.h"
#include "ui/steps/transport_dock.h"
#include "ui/truth/identify_panel.h"
#include "ui/truth/truth_mode.h"
#include "ui/window/action_search.h"
#include "ui/window/dragged_file.h"
#include "ui/window/figure_export.h"
#include "ui/window/guide_window.h"
#include "ui/window/help_overlay.h"
#include "ui/window/life_cycle.h"
#include "ui/window/locate_model.h"
#include "ui/window/panel_places.h"
#include "ui/window/readout_bar.h"
#include "ui/window/window_moment.h"
#include "ui/window/window_placement.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QSettings>
#include <QStatusBar>
#include <QTabWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include <utility>

namespace rasterlens
{
namespace
{

constexpr int kCardGap = 7;
constexpr int kActivityDelayMs = 150;
constexpr int kTitleShare = 1; ///< of the line above the canvas, behind what the links need
constexpr int kBarShare = 3;

QToolButton* canvasLink(QAction* action)
{
    QToolButton* button = makeLink();
    button->setFocusPolicy(Qt::TabFocus);
    if (action)
        button->setDefaultAction(action);
    return button;
}

/// A widget has the application's font from when it is made, so the look comes before the window.
QWidget* afterPlainLook(QWidget* parent)
{
    applyPlainLook(*qApp, {});
    return parent;
}

} // namespace

MainWindow::MainWindow(Memory memory, QWidget* parent) : QMainWindow(afterPlainLook(parent)), m_memory(memory)
{
    m_placement = new WindowPlacement(*this);
    m_placement->start({});
    setAcceptDrops(true);
    setDockOptions(AnimatedDocks | AllowNestedDocks | AllowTabbedDocks);
    setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::BottomDockWidgetArea);
    buildLayout();
    buildMenus();
    buildStatusBar();
    m_help = new HelpOverlay(this);
    m_guide = new GuideWindow(this);
    m_search = new ActionSearch(m_actions, *this);
    connectParts();
    buildFocus();
    applyStyleSheet(*qApp, m_look);
    m_defaultState = saveState(kLayoutVersion);
    if (m_memory == Memory::Remember)
        restoreMemory();
    setLook(m_look);
    retranslate();
    if (m_memory == Memory::Remember)
        m_lifeCycle->start();
}

MainWindow::~MainWindow() = default;

void MainWindow::buildLayout()
{
    auto* central = new QWidget;
    auto* column = new QVBoxLayout(central);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kCardGap);
    auto* stripCard = new QFrame;
    stripCard->setObjectName(QStringLiteral("card"));
    auto* stripRow = new QHBoxLayout(stripCard);
    stripRow->setContentsMargins(0, 0, 0, 0);
    m_stageStrip = new StageStrip;
    m_stageMenu = canvasLink(nullptr);
    m_stageMenu->setObjectName(QStringLiteral("stageMenu"));
    m_stageMenu->setText(QStringLiteral("\u2630"));
    m_stageMenu->setPopupMode(QToolButton::InstantPopup);
    m_stageMenu->hide();
    stripRow->addWidget(m_stageStrip, 1);
    stripRow->addWidget(m_stageMenu);
    column->addWidget(stripCard);
    column->addWidget(buildCanvas(), 1);
    setCentralWidget(central);

    m_pipelinePanel = new PipelinePanel(m_document, m_language);
    m_pipelineDock = new Dock(QStringLiteral("pipelineDock"), m_pipelinePanel, this);

    m_statisticsPanel = new StatisticsPanel;
    m_statisticsDock = new Dock(QStringLiteral("statisticsDock"), m_statisticsPanel, this);
    m_copyCsv = m_statisticsDock->addLink();
    m_copyJson = m_statisticsDock->addLink();
    m_copyCsv->setText(QStringLiteral("CSV"));
    m_copyJson->setText(QStringLiteral("JSON"));
    m_cards = new Cards(m_document, *m_viewport, *this);
    m_cards->setParent(this);
    QList<QDockWidget*> tabs;
    for (const auto& docks : {m_cards->docks(), m_truth->docks()})
        for (Dock* dock : docks)
            tabs << dock;
    const PanelPlaces::Columns columns{m_pipelineDock, &m_lessons->dock(), m_statisticsDock, tabs.takeFirst(),
                                       &m_stepMode->transport()};
    m_panels = new PanelPlaces(*this, *m_viewport, columns, tabs);
    setContentsMargins(kCardGap, 0, kCardGap, 0);
}

QWidget* MainWindow::buildCanvas()
{
    auto* card = new QFrame;
    card->setObjectName(QStringLiteral("card"));
    auto* column = new QVBoxLayout(card);
    column->setContentsMargins(1, 4, 1, 1);
    column->setSpacing(4);

    m_canvasHeader = new QWidget;
    auto* header = new QHBoxLayout(m_canvasHeader);
    header->setObjectName(QStringLiteral("canvasHeader"));
    header->setContentsMargins(12, 0, 8, 0);
    header->setSpacing(2);
    m_canvasTitle = new ElidedLabel;
    header->addWidget(m_canvasTitle, kTitleShare);
    column->addWidget(m_canvasHeader);

    m_viewport = new ViewportWidget;
    m_viewport->setObjectName(QStringLiteral("canvas"));
    m_views = std::make_unique<CanvasViews>(m_document, *m_viewport); // its layers lie below the others
    auto* messages = new MessageColumn(m_viewport);
    m_unsupported = messages->addBar();
    m_unsupported->setClosable(false);
    m_message = messages->addBar();
    m_recoveryOffer = messages->addBar();
    m_filesOffer = messages->addBar();
    auto* bars = new QVBoxLayout;
    column->addLayout(bars);
    m_mistakeBadge = new MistakeBadge(m_viewport);
    m_picture = new QBoxLayout(QBoxLayout::TopToBottom);
    m_picture->setSpacing(4);
    m_picture->addWidget(m_viewport, 1);
    column->addLayout(m_picture, 1);
    m_stepMode = std::make_unique<StepMode>(m_document, *m_viewport, *this, m_actions);
    m_motion = std::make_unique<MotionMode>(m_document, *m_viewport);
    m_truth = std::make_unique<TruthMode>(m_document, *m_viewport, *this, *bars, m_actions);
    m_lifeCycle =
        std::make_unique<LifeCycle>(m_document, *m_stepMode, LifeCycle::Bars{m_recoveryOffer, m_filesOffer}, *this);
    m_figures = std::make_unique<FigureExport>(m_document, *m_viewport, *m_stepMode, *m_motion, [this] {
        return QStringLiteral("%1: %2").arg(sceneTitle(*m_document.scene()), sceneWords());
    });
    m_lessons = std::make_unique<LessonMode>(*m_viewport, *this, m_actions);
    m_picture->addWidget(&m_stepMode->listing());

    m_caption = new QLabel;
    m_caption->setObjectName(QStringLiteral("caption"));
    m_caption->setWordWrap(true);
    m_caption->setContentsMargins(16, 3, 16, 4);
    m_caption->hide();
    column->addWidget(m_caption);
    return card;
}

void MainWindow::buildStatusBar()
{
    m_readout = new ReadoutBar;
    m_activity = new QLabel;
    m_activity->setObjectName(QStringLiteral("muted"));
    m_counters = new QLabel;
    m_counters->setObjectName(QStringLiteral("counters"));
    m_counters->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    statusBar()->addWidget(m_readout, 1);
    statusBar()->addPermanentWidget(m_activity);
    statusBar()->addPermanentWidget(m_counters);
    connect(m_statisticsPanel, &StatisticsPanel::changed, this, &MainWindow::syncCounters);
    connect(m_panels, &PanelPlaces::changed, this, &MainWindow::syncCounters);
    statusBar()->setSizeGripEnabled(false);
    m_activityDelay.setSingleShot(true);
    m_activityDelay.setInterval(kActivityDelayMs);

    auto* header = centralWidget()->findChild<QHBoxLayout*>(QStringLiteral("canvasHeader"));
    m_viewsBar = new ViewsBar(*m_views, m_actions.action("compare.difference"));
    header->addWidget(m_viewsBar, kBarShare);
    for (QAction* action : {m_fit, m_oneToOne, m_zoomOut, m_zoomIn})
        header->addWidget(canvasLink(action));
    m_goToButton = canvasLink(nullptr);
    connect(m_goToButton, &QToolButton::clicked, this, &MainWindow::toggleGoToPixel);
    header->addWidget(m_goToButton);
    m_goToEdit = new QLineEdit;
    m_goToEdit->setObjectName(QStringLiteral("goToPixel"));
    m_goToEdit->setPlaceholderText(QStringLiteral("x, y"));
    m_goToEdit->setFixedWidth(110);
    m_goToEdit->hide();
    m_goToField = new TypedField(m_goToEdit, [this](const QString& text, TypedField::Attempt attempt) {
        return goToTyped(text, attempt == TypedField::Attempt::Take);
    });
    connect(m_goToField, &TypedField::left, this, [this] { showGoToPixel(false); });
    header->addWidget(m_goToEdit);
}

template <class Field, class Refused, class Mended>
void MainWindow::connectField(Field* field, Refused refused, Mended mended)
{
    connect(field, refused, m_message,
            [this, field](const QString& why) { m_message->show(MessageKind::Error, why, field); });
    connect(field, mended, m_message, [this, field] { m_message->retract(field); });
}

void MainWindow::connectParts()
{
    connectDocument();
    connectWorker();
    connectPanels();
    connectModes();
    connectCanvas();
    connectLessons();
    // Errors and remarks of the parts are messages over the canvas.
    const auto says = [this](MessageKind kind) {
        return [this, kind](const QString& text) { m_message->show(kind, text); };
    };
    connect(&m_worker, &RenderWorker::memoryNeeded, m_message, says(MessageKind::Info));
    connect(m_truth.get(), &TruthMode::message, m_message, says(MessageKind::Info));
    connect(m_lessons.get(), &LessonMode::message, m_message, says(MessageKind::Info));
    connect(m_lessons.get(), &LessonMode::failed, m_message, says(MessageKind::Error));
    connect(m_views.get(), &CanvasViews::message, m_message, says(MessageKind::Info));
    connect(m_views.get(), &CanvasViews::failed, m_message, says(MessageKind::Error));
    connect(m_motion.get(), &MotionMode::refused, m_message, says(MessageKind::Info));
    connect(m_stepMode.get(), &StepMode::message, m_message, says(MessageKind::Info));
    connect(m_lifeCycle.get(), &LifeCycle::warned, m_message, says(MessageKind::Warning));
    connect(m_truth.get(), &TruthMode::failed, m_message, says(MessageKind::Error));
    connect(m_cards, &Cards::failed, m_message, says(MessageKind::Error));
    connect(m_mistakeBadge, &MistakeBadge::failed, m_message, says(MessageKind::Error));
    connect(m_pipelinePanel, &PipelinePanel::failed, m_message, says(MessageKind::Error));
    connect(&m_stepMode->session(), &StepSession::failed, m_message, says(MessageKind::Error));
    connectField(m_pipelinePanel, &PipelinePanel::invalidInput, &PipelinePanel::inputMended);
    connectField(&m_cards->vertexPanel(), &VertexPanel::invalidInput, &VertexPanel::inputMended);
    connectField(m_goToField, &TypedField::refused, &TypedField::mended);
}

void MainWindow::connectDocument()
{
    connect(&m_document, &Document::sceneChanged, this, [this] {
        const bool hasCamera = m_document.scene()->space == SceneSpace::Object;
        m_stageStrip->setScene(*m_document.scene());
        m_viewport->setLeftDrag(hasCamera ? ViewportWidget::LeftDrag::Orbits : ViewportWidget::LeftDrag::PansCanvas);
        m_message->hide();
        for (QAction* action : m_cameraActions)
            action->setEnabled(hasCamera);
    });
    connect(&m_document, &Document::settingsChanged, this, [this] {
        m_stageStrip->setSettings(m_document.settings());
        updatePicture();
        syncActions(); // at once: the next key may be Undo
        setWindowModified(m_document.isDirty());
        syncSoon(Words::OfDocument);
    });
    connect(&m_document, &Document::diagnosticsReported, m_message,
            [this](const Diagnostics& diagnostics) { m_message->show(diagnostics); });
    connect(&m_document, &Document::sceneMissing, this,
            [this](const QString& session) { offerToLocateModel(*this, m_document, session); });
    connect(&m_document, &Document::recentFilesChanged, this, &MainWindow::fillRecentMenu);
    connect(&m_document, &Document::loadingChanged, this, [this](bool loading, const QString& name) {
        m_activity->setText(loading ? tr("opening %1 \u2026").arg(QFileInfo(name).fileName()) : QString());
    });
    connect(m_figures.get(), &FigureExport::finished, this, [this](const QString& path, const QString& error) {
        reportSaved(error.isEmpty() ? std::nullopt : std::optional(error), path);
    });
    connect(m_lifeCycle.get(), &LifeCycle::saved, this,
            [this](const QString& path) { reportSaved(std::nullopt, path); });
    connect(m_lifeCycle.get(), &LifeCycle::agreedTo, this, &MainWindow::open);
}

void MainWindow::connectWorker()
{
    connect(&m_worker, &RenderWorker::frameReady, this, &MainWindow::takeFrame);
    connect(&m_worker, &RenderWorker::failed, this, [this](const QString& message) {
        m_message->show(MessageKind::Error, message);
        m_gaveUp = true;
        tellIfSettled();
    });
    connect(&m_worker, &RenderWorker::busyChanged, this, [this](bool busy) {
        if (busy)
            m_activityDelay.start();
        else
            m_activityDelay.stop();
        if (!busy && !m_document.isLoading())
            m_activity->clear();
    });
    connect(&m_activityDelay, &QTimer::timeout, this, [this] { m_activity->setText(tr("drawing \u2026")); });
}

void MainWindow::connectPanels()
{
    connect(m_stageStrip, &StageStrip::stageClicked, this, [this](Stage stage) {
        m_panels->showScene();
        m_pipelinePanel->scrollTo(stage);
        m_views->showStage(stage);
    });
    connect(m_mistakeBadge, &MistakeBadge::placed, m_viewport, &ViewportWidget::setCovered);
    connect(m_mistakeBadge, &MistakeBadge::clicked, this, [this] {
        m_panels->showScene();
        m_pipelinePanel->mistakes().setOpen(true);
    });
    connect(m_pipelinePanel, &PipelinePanel::sceneChosen, &m_document, &Document::open);
    connect(m_pipelinePanel, &PipelinePanel::floatFailureChosen, m_truth.get(), &TruthMode::showFloatFailure);
    connect(m_pipelinePanel, &PipelinePanel::openRequested, this, &MainWindow::chooseFileToOpen);
    connect(&m_truth->identifyPanel(), &IdentifyPanel::fileWanted, this, &MainWindow::chooseFileToIdentify);
    connect(m_copyCsv, &QToolButton::clicked, this,
            [this] { QGuiApplication::clipboard()->setText(m_statisticsPanel->asCsv()); });
    connect(m_copyJson, &QToolButton::clicked, this,
            [this] { QGuiApplication::clipboard()->setText(m_statisticsPanel->asJson()); });
}

void MainWindow::connectModes()
{
    connect(m_actions.action("step.record"), &QAction::triggered, this, &MainWindow::offerSmallRecord);
    connect(m_cards, &Cards::stepRequested, m_stepMode.get(), &StepMode::showFace);
    connect(m_stepMode.get(), &StepMode::frameChanged, this, &MainWindow::showFrame);
    connect(&m_stepMode->session(), &StepSession::positionChanged, this, [this] {
        const StepSession& session = m_stepMode->session();
        if (const auto face = session.face())
            m_cards->followFace(*face);
        m_cards->followStep(session.log().get(), session.event() != nullptr ? session.positionInLog() : 0);
    });
    connect(&m_stepMode->session(), &StepSession::positionChanged, this, [this] {
        if (m_look.presentation)
            syncSoon(Words::OfDocument); // the caption tells the step
    });
    connect(&m_stepMode->session(), &StepSession::openChanged, this, &MainWindow::syncStage);
    connect(&m_stepMode->session(), &StepSession::recordingChanged, this, &MainWindow::tellIfSettled);
    connect(m_truth.get(), &TruthMode::faceWanted, m_stepMode.get(), &StepMode::showFace);
    connect(m_truth.get(), &TruthMode::stepWanted, m_stepMode.get(), &StepMode::showStep);
    connectMotion();
    connect(&m_truth->comparison(), &Comparison::changed, this, [this] {
        m_views->setCompared(m_truth->comparison().view() != CompareView::Off);
        syncSoon(Words::OfPixel);
    });
}

void MainWindow::connectCanvas()
{
    connect(m_viewport, &ViewportWidget::frameShown, m_statisticsPanel, &StatisticsPanel::setShown);
    connect(m_viewport, &ViewportWidget::viewChanged, this, [this] { syncSoon(Words::OfPixel); });
    connect(m_viewport, &ViewportWidget::pixelChanged, this, [this] { syncSoon(Words::OfPixel); });
    connect(m_viewport, &ViewportWidget::pixelChosen, m_panels, &PanelPlaces::revealCard);
    connect(m_viewport, &ViewportWidget::gestureEnded, this, [this] { m_document.endGesture(); });
    const auto height = [this] { return m_document.settings().size.height(); };
    connect(m_viewport, &ViewportWidget::orbited, this,
            [this, height](QPointF drag) { moveCamera(orbit(m_document.settings().view, drag, height())); });
    connect(m_viewport, &ViewportWidget::cameraPanned, this, [this, height](QPointF drag) {
        moveCamera(panCamera(m_document.settings().view, drag, height(), m_document.scene()->bounds));
    });
    connect(m_viewport, &ViewportWidget::dollied, this,
            [this](double factor) { moveCamera(dolly(m_document.settings().view, factor)); });
}

void MainWindow::openDefaultScene()
{
    if (!builtinScenes().empty())
        m_document.open(QStringLiteral("builtin:") + QLatin1String(builtinScenes().front().name));
}

void MainWindow::stepField(const SettingsField& field)
{
    // Values that cannot be drawn with the others are stepped over.
    Settings next = withNextValue(field, m_document.settings());
    for (int i = field.minimum; i < field.maximum && unsupported(*m_document.scene(), next); ++i)
        next = withNextValue(field, next);
    changeField(field, next == m_document.settings() ? withNextValue(field, next) : next);
}

/// Takes the settings, in which another value of the field is chosen, or says why they cannot be drawn.
void MainWindow::changeField(const SettingsField& field, const Settings& settings)
{
    if (const auto why = unsupported(*m_document.scene(), settings))
        m_message->show(
            MessageKind::Info,
            tr("%1 stays: %2").arg(QCoreApplication::translate("Settings", field.title), whyUnsupported(*why)));
    else
        m_document.setSettings(settings);
    m_pipelinePanel->bringInSight(QLatin1String(field.id));
}

void MainWindow::updatePicture()
{
    const auto why = unsupported(*m_document.scene(), m_document.settings());
    m_refused = why.has_value();
    m_gaveUp = false;
    m_viewport->setStale(m_refused);
    if (m_refused) {
        m_statisticsPanel->setStale(true);
        m_unsupported->show(MessageKind::Warning, tr("These settings cannot be drawn: %1").arg(whyUnsupported(*why)));
        Q_EMIT settled();
        return;
    }
    m_unsupported->hide();
    if (isShown() && !m_worker.busy() && !m_worker.isContinuous()) { // saved, or back from settings without a picture
        showFrame();
        tellIfSettled();
        return;
    }
    m_worker.request(m_document.scene(), m_document.settings());
}

void MainWindow::takeFrame(const FramePtr& frame)
{
    if (frame->scene != m_document.scene())
        return;
    const bool newScene = !m_lastFrame || m_lastFrame->scene->id != frame->scene->id;
    m_lastFrame = frame;
    showFrame();
    if (newScene)
        m_viewport->fit(frame->scene->window);
    if (frame->counted) {
        m_cards->frameCounted();
        m_mistakeBadge->showFor(frame);
        const bool isSlide = m_lessons->player().isOpen() && !m_moment->isChanged();
        m_emptyRemark.update(*frame, isSlide ? EmptyRemark::Wanted::No : EmptyRemark::Wanted::Yes, *m_message);
    }
    syncSoon(Words::OfPixel);
    tellIfSettled();
}

void MainWindow::tellIfSettled()
{
    if (isSettled())
        Q_EMIT settled();
}

/// The picture that moves, or that of the present step, or else the finished one.
void MainWindow::showFrame()
{
    const FramePtr moved = m_motion->frame();
    const FramePtr step = moved ? nullptr : m_stepMode->frame();
    const FramePtr& frame = moved ? moved : step ? step : m_lastFrame;
    if (!frame)
        return;
    m_truth->showOnCanvas(frame, moved || step);
    m_views->setFrame(frame);
    m_stageStrip->setFrame(frame);
    const StepEvent* event = step ? m_stepMode->session().event() : nullptr;
    m_stageStrip->setCurrent(event ? std::optional(stageOf(event->kind)) : std::nullopt);
    m_statisticsPanel->setFrame(frame);
    const std::optional<std::size_t> moment = m_stepMode->moment();
    m_statisticsPanel->setMoment(moment);
    m_mistakeBadge->setSaysMoment(moment.has_value());
    m_cards->setSaysMoment(moment.has_value());
    syncSoon(Words::OfPixel);
}

bool MainWindow::isSettled() const
{
    if (m_document.isLoading() || !m_stepMode->isSettled())
        return false;
    return m_refused || m_gaveUp || isShown();
}

/// The last frame is that of the document, and counted.
bool MainWindow::isShown() const
{
    return m_lastFrame && m_lastFrame->counted && m_lastFrame->scene == m_document.scene() &&
           m_lastFrame->settings == m_document.settings();
}

bool MainWindow::isComplete() const
{
    return isSettled() && !m_moment->isPending() && !m_lessons->isBusy() && !m_wordsAreOld.any() &&
           !m_cards->isBusy() && !m_views->isBusy() && !m_mistakeBadge->isCounting() && !m_truth->isBusy() &&
           !m_pipelinePanel->isBusy() && !m_figures->isBusy();
}

QString MainWindow::message() const
{
    if (!m_message->isHidden())
        return m_message->text();
    return m_unsupported->isHidden() ? QString() : m_unsupported->text();
}

void MainWindow::setLanguage(LanguageKind kind)
{
    m_language.use(kind);
    (kind == LanguageKind::Chinese ? m_chinese : m_english)->setChecked(true);
}

void MainWindow::setLook(const Look& look)
{
    if (!(look == m_look))
        applyLook(*qApp, look);
    m_look = look;
    m_viewport->setCanvasColor(canvasColor(look.kind));
    m_truth->setPresentation(look.presentation);
    m_viewport->setThickLines(look.presentation);
    m_dark->setChecked(look.kind == ThemeKind::Dark);
}

void MainWindow::restoreMemory()
{
    const QSettings memory;
    m_placement->start(memory.value(QStringLiteral("window/geometry")).toByteArray());
    bool restored = false;
    m_panels->quietly(
        [&] { restored = restoreState(memory.value(QStringLiteral("window/state")).toByteArray(), kLayoutVersion); });
    m_panels->restore(restored && memory.value(QStringLiteral("window/arranged")).toBool(),
                      memory.value(QStringLiteral("window/tabsBelow")).toBool());
    setLook({memory.value(QStringLiteral("window/dark")).toBool() ? ThemeKind::Dark : ThemeKind::Light, false});
    m_worker.setFastMotion(memory.value(QStringLiteral("window/fastFirst"), true).toBool());
    m_fastMotion->setChecked(m_worker.hasFastMotion());
    const QString language = memory.value(QStringLiteral("window/language")).toString();
    setLanguage(language.isEmpty()                   ? Language::ofSystem()
                : language == QLatin1String("zh_CN") ? LanguageKind::Chinese
                                                     : LanguageKind::English);
}

void MainWindow::saveMemory()
{
    QSettings memory;
    memory.setValue(QStringLiteral("window/geometry"), m_placement->geometry());
    memory.setValue(QStringLiteral("window/state"),
                    m_look.presentation ? m_stateBeforePresentation : saveState(kLayoutVersion));
    memory.setValue(QStringLiteral("window/arranged"), m_panels->areArranged());
    memory.setValue(QStringLiteral("window/tabsBelow"), m_panels->areTabsAtBottom());
    memory.setValue(QStringLiteral("window/dark"), m_look.kind == ThemeKind::Dark);
    memory.setValue(QStringLiteral("window/fastFirst"), m_worker.hasFastMotion());
    memory.setValue(QStringLiteral("window/language"),
                    m_language.kind() == LanguageKind::Chinese ? QStringLiteral("zh_CN") : QStringLiteral("en"));
}

void MainWindow::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QMainWindow::changeEvent(event);
}

void MainWindow::showEvent(QShowEvent* event)
{
    QMainWindow::showEvent(event);
    m_placement->shown();
    if (!event->spontaneous())
        QTimer::singleShot(0, m_lessons.get(), &LessonMode::showDock); // once the docks have their places
    m_viewport->setFocus();
}

void MainWindow::resizeEvent(QResizeEvent* event)
{
    QMainWindow::resizeEvent(event);
    syncStage();
    if (!m_look.presentation)
        QTimer::singleShot(0, m_panels, &PanelPlaces::follow); // once the docks have followed the window
}

bool MainWindow::event(QEvent* event)
{
    // Where the main window itself takes the mouse there are only the lines between the docks.
    if (event->type() == QEvent::MouseMove)
        m_panels->setArranged(m_panels->areArranged() || (QGuiApplication::mouseButtons() & Qt::LeftButton) != 0);
    return QMainWindow::event(event);
}

} // namespace rasterlens
