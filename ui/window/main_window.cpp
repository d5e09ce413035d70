#include "ui/window/main_window.h"

#include "core/render/render.h"
#include "core/scenes/builtin_scenes.h"
#include "ui/base/applicability.h"
#include "ui/base/dock.h"
#include "ui/base/message_bar.h"
#include "ui/document/navigation.h"
#include "ui/face/cards.h"
#include "ui/pipeline/mistake_badge.h"
#include "ui/pipeline/mistakes_section.h"
#include "ui/pipeline/pipeline_panel.h"
#include "ui/pipeline/stage_strip.h"
#include "ui/pipeline/statistics_panel.h"
#include "ui/steps/step_listing.h"
#include "ui/steps/step_mode.h"
#include "ui/steps/transport_dock.h"
#include "ui/truth/truth_mode.h"
#include "ui/window/help_overlay.h"
#include "ui/window/readout_bar.h"

#include <QApplication>
#include <QClipboard>
#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QMimeData>
#include <QSettings>
#include <QStatusBar>
#include <QToolButton>
#include <QVBoxLayout>

#include <utility>

namespace rasterlens
{
namespace
{

constexpr int kCardGap = 7;
constexpr int kPipelineWidth = 298;
constexpr int kStatisticsWidth = 272;
constexpr int kActivityDelayMs = 150;
constexpr int kLayoutVersion = 3;

QToolButton* canvasLink(QAction* action)
{
    auto* button = new QToolButton;
    button->setObjectName(QStringLiteral("link"));
    button->setCursor(Qt::PointingHandCursor);
    button->setFocusPolicy(Qt::TabFocus);
    if (action)
        button->setDefaultAction(action);
    return button;
}

QString zoomText(double zoom)
{
    return zoom >= 1 ? QStringLiteral("%1\u00d7").arg(zoom) : QStringLiteral("%1 %").arg(zoom * 100, 0, 'f', 0);
}

} // namespace

MainWindow::MainWindow(Memory memory, QWidget* parent) : QMainWindow(parent), m_memory(memory)
{
    applyLook(*qApp, m_look);
    setAcceptDrops(true);
    setDockOptions(AnimatedDocks | AllowNestedDocks | AllowTabbedDocks);
    setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::BottomDockWidgetArea);
    buildLayout();
    buildMenus();
    buildStatusBar();
    m_help = new HelpOverlay(this);
    connectParts();
    resize(1440, 900);
    m_defaultState = saveState(kLayoutVersion);
    if (m_memory == Memory::Remember)
        restoreMemory();
    setLook(m_look);
    retranslate();
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
    stripRow->addWidget(m_stageStrip);
    column->addWidget(stripCard);
    column->addWidget(buildCanvas(), 1);
    setCentralWidget(central);

    m_pipelinePanel = new PipelinePanel(m_document, m_language);
    m_pipelineDock = new Dock(QStringLiteral("pipelineDock"), m_pipelinePanel, this);
    addDockWidget(Qt::LeftDockWidgetArea, m_pipelineDock);

    m_statisticsPanel = new StatisticsPanel;
    m_statisticsDock = new Dock(QStringLiteral("statisticsDock"), m_statisticsPanel, this);
    m_copyCsv = m_statisticsDock->addLink();
    m_copyJson = m_statisticsDock->addLink();
    m_copyCsv->setText(QStringLiteral("CSV"));
    m_copyJson->setText(QStringLiteral("JSON"));
    addDockWidget(Qt::RightDockWidgetArea, m_statisticsDock);
    m_cards = new Cards(m_document, *m_viewport, *this);
    m_cards->setParent(this);
    m_cards->place(m_statisticsDock, &m_stepMode->transport());
    m_truth->place(m_cards->docks().back());
    setContentsMargins(kCardGap, 0, kCardGap, 0);
}

void MainWindow::sizeDocks()
{
    resizeDocks({m_pipelineDock, m_statisticsDock}, {kPipelineWidth, kStatisticsWidth}, Qt::Horizontal);
    QDockWidget* above = m_cards->docks().front();
    const int column = above->height() + m_statisticsDock->height();
    const int statistics = m_statisticsDock->sizeHint().height();
    resizeDocks({above, m_statisticsDock}, {std::max(column - statistics, 1), statistics}, Qt::Vertical);
}

QWidget* MainWindow::buildCanvas()
{
    auto* card = new QFrame;
    card->setObjectName(QStringLiteral("card"));
    auto* column = new QVBoxLayout(card);
    column->setContentsMargins(1, 4, 1, 1);
    column->setSpacing(4);

    auto* header = new QHBoxLayout;
    header->setObjectName(QStringLiteral("canvasHeader"));
    header->setContentsMargins(12, 0, 8, 0);
    header->setSpacing(2);
    m_canvasTitle = new QLabel;
    m_canvasTitle->setObjectName(QStringLiteral("muted"));
    m_canvasTitle->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    header->addWidget(m_canvasTitle, 1);
    column->addLayout(header);

    auto* messages = new QVBoxLayout;
    messages->setContentsMargins(8, 0, 8, 0);
    m_unsupported = new MessageBar;
    m_unsupported->setClosable(false);
    m_message = new MessageBar;
    messages->addWidget(m_unsupported);
    messages->addWidget(m_message);
    column->addLayout(messages);

    m_viewport = new ViewportWidget;
    auto* bars = new QVBoxLayout;
    column->addLayout(bars);
    m_mistakeBadge = new MistakeBadge(m_viewport);
    column->addWidget(m_viewport, 1);
    m_stepMode = std::make_unique<StepMode>(m_document, *m_viewport, *this);
    m_truth = std::make_unique<TruthMode>(m_document, *m_viewport, *this, *bars);
    column->addWidget(&m_stepMode->listing());

    m_caption = new QLabel;
    m_caption->setObjectName(QStringLiteral("caption"));
    m_caption->setWordWrap(true);
    m_caption->setContentsMargins(16, 8, 16, 10);
    m_caption->hide();
    column->addWidget(m_caption);
    return card;
}

void MainWindow::buildStatusBar()
{
    m_readout = new ReadoutBar;
    m_activity = new QLabel;
    m_activity->setObjectName(QStringLiteral("muted"));
    statusBar()->addWidget(m_readout, 1);
    statusBar()->addPermanentWidget(m_activity);
    statusBar()->setSizeGripEnabled(false);
    m_activityDelay.setSingleShot(true);
    m_activityDelay.setInterval(kActivityDelayMs);

    auto* header = centralWidget()->findChild<QHBoxLayout*>(QStringLiteral("canvasHeader"));
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
    connect(m_goToEdit, &QLineEdit::returnPressed, this, &MainWindow::goToTypedPixel);
    header->addWidget(m_goToEdit);
}

void MainWindow::connectParts()
{
    connect(&m_document, &Document::sceneChanged, this, [this] {
        m_stageStrip->setScene(*m_document.scene());
        m_viewport->setLeftDrag(m_document.scene()->space == SceneSpace::Object ? ViewportWidget::LeftDrag::Orbits
                                                                                : ViewportWidget::LeftDrag::PansCanvas);
        m_message->hide();
        for (QAction* action : m_cameraActions)
            action->setEnabled(m_document.scene()->space == SceneSpace::Object);
    });
    connect(&m_document, &Document::settingsChanged, this, [this] {
        m_stageStrip->setSettings(m_document.settings());
        updatePicture();
        syncActions();
        syncTitle();
        syncCaption();
    });
    connect(&m_document, &Document::diagnosticsReported, m_message,
            [this](const Diagnostics& diagnostics) { m_message->show(diagnostics); });
    connect(&m_document, &Document::recentFilesChanged, this, &MainWindow::fillRecentMenu);
    connect(&m_document, &Document::loadingChanged, this, [this](bool loading, const QString& name) {
        m_activity->setText(loading ? tr("opening %1 \u2026").arg(QFileInfo(name).fileName()) : QString());
    });
    connect(&m_worker, &RenderWorker::frameReady, this, &MainWindow::takeFrame);
    connect(&m_worker, &RenderWorker::failed, this, [this](const QString& message) {
        m_message->show(MessageKind::Error, message);
        m_gaveUp = true;
        if (isSettled())
            Q_EMIT settled();
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

    connect(m_stageStrip, &StageStrip::stageClicked, this, [this](Stage stage) {
        m_pipelineDock->show();
        m_pipelinePanel->scrollTo(stage);
    });
    connect(m_mistakeBadge, &MistakeBadge::clicked, this, [this] {
        m_pipelineDock->show();
        m_pipelinePanel->mistakes().setOpen(true);
    });
    connect(m_pipelinePanel, &PipelinePanel::sceneChosen, &m_document, &Document::open);
    connect(m_pipelinePanel, &PipelinePanel::floatFailureChosen, m_truth.get(), &TruthMode::showFloatFailure);
    connect(m_pipelinePanel, &PipelinePanel::openRequested, this, &MainWindow::chooseFileToOpen);
    connect(m_pipelinePanel, &PipelinePanel::invalidInput, m_message,
            [this](const QString& message) { m_message->show(MessageKind::Error, message); });
    connect(m_copyCsv, &QToolButton::clicked, this,
            [this] { QGuiApplication::clipboard()->setText(m_statisticsPanel->asCsv()); });
    connect(m_copyJson, &QToolButton::clicked, this,
            [this] { QGuiApplication::clipboard()->setText(m_statisticsPanel->asJson()); });

    connect(m_cards, &Cards::stepRequested, m_stepMode.get(), &StepMode::showFace);
    connect(m_stepMode.get(), &StepMode::frameChanged, this, &MainWindow::showFrame);
    connect(m_truth.get(), &TruthMode::faceWanted, m_stepMode.get(), &StepMode::showFace);
    connect(m_truth.get(), &TruthMode::stepWanted, m_stepMode.get(), &StepMode::showStep);
    connect(&m_truth->comparison(), &Comparison::changed, this, &MainWindow::syncReadout);
    connect(m_truth.get(), &TruthMode::message, m_message,
            [this](const QString& text) { m_message->show(MessageKind::Info, text); });
    connect(m_truth.get(), &TruthMode::failed, m_message,
            [this](const QString& text) { m_message->show(MessageKind::Error, text); });
    connect(m_stepMode.get(), &StepMode::message, m_message,
            [this](const QString& text) { m_message->show(MessageKind::Info, text); });
    connect(&m_stepMode->session(), &StepSession::positionChanged, this, [this] {
        if (const auto face = m_stepMode->session().face())
            m_cards->followFace(*face);
    });
    connect(&m_stepMode->session(), &StepSession::recordingChanged, this, [this] {
        if (isSettled())
            Q_EMIT settled();
    });

    connect(m_viewport, &ViewportWidget::frameShown, m_statisticsPanel, &StatisticsPanel::setShown);
    connect(m_viewport, &ViewportWidget::viewChanged, this, &MainWindow::syncCanvasHeader);
    connect(m_viewport, &ViewportWidget::pixelChanged, this, &MainWindow::syncReadout);
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

void MainWindow::moveCamera(const View& view)
{
    if (m_document.scene()->space != SceneSpace::Object)
        return;
    Settings next = m_document.settings();
    next.view = view;
    m_document.setSettings(next, Document::Edit::Camera);
}

void MainWindow::stepField(const SettingsField& field)
{
    // Values that cannot be drawn with the others are stepped over.
    Settings next = withNextValue(field, m_document.settings());
    for (int i = field.minimum; i < field.maximum && unsupported(*m_document.scene(), next); ++i)
        next = withNextValue(field, next);
    if (next == m_document.settings()) {
        if (const auto why = unsupported(*m_document.scene(), withNextValue(field, next)))
            m_message->show(
                MessageKind::Info,
                tr("%1 stays: %2").arg(QCoreApplication::translate("Settings", field.title), whyUnsupported(*why)));
        return;
    }
    m_document.setSettings(next);
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
        m_mistakeBadge->showFor(frame->scene, frame->settings);
    }
    syncCanvasHeader();
    if (isSettled())
        Q_EMIT settled();
}

/// The picture of the present step, or else the finished one.
void MainWindow::showFrame()
{
    const FramePtr step = m_stepMode->frame();
    const FramePtr& frame = step ? step : m_lastFrame;
    if (!frame)
        return;
    m_truth->showOnCanvas(frame, step != nullptr);
    m_stageStrip->setFrame(frame);
    const StepEvent* event = step ? m_stepMode->session().event() : nullptr;
    m_stageStrip->setCurrent(event ? std::optional(stageOf(event->kind)) : std::nullopt);
    m_statisticsPanel->setFrame(frame);
}

bool MainWindow::isSettled() const
{
    if (m_document.isLoading() || !m_stepMode->isSettled())
        return false;
    return m_refused || m_gaveUp ||
           (m_lastFrame && m_lastFrame->counted && m_lastFrame->scene == m_document.scene() &&
            m_lastFrame->settings == m_document.settings());
}

bool MainWindow::isComplete() const
{
    return isSettled() && !m_cards->isBusy() && !m_mistakeBadge->isCounting() && !m_truth->isBusy();
}

QString MainWindow::message() const
{
    if (!m_message->isHidden())
        return m_message->text();
    return m_unsupported->isHidden() ? QString() : m_unsupported->text();
}

void MainWindow::syncCanvasHeader()
{
    QStringList parts{zoomText(m_viewport->transform().zoom)};
    if (const auto pixel = m_viewport->selectedPixel())
        parts << tr("pixel (%1, %2)").arg(pixel->x()).arg(pixel->y());
    m_canvasTitle->setText(parts.join(QStringLiteral("  \u00b7  ")));
}

void MainWindow::syncReadout()
{
    syncCanvasHeader();
    const auto at = m_viewport->hoveredPixel() ? m_viewport->hoveredPixel() : m_viewport->selectedPixel();
    m_readout->show(at ? m_viewport->readout(*at) : std::nullopt, at ? m_truth->comparison().at(*at) : std::nullopt);
}

void MainWindow::syncTitle()
{
    setWindowTitle(QStringLiteral("%1[*] \u2013 RasterLens").arg(m_pipelinePanel->sceneBox()->currentText()));
    setWindowModified(m_document.isDirty());
}

/// The caption of the presentation names the scene and what was changed about it, or else what there is to see.
void MainWindow::syncCaption()
{
    QStringList changes;
    for (const SettingsField& field : settingsFields())
        if (field.get(m_document.settings()) != field.get(m_document.defaults()))
            changes << QStringLiteral("%1: %2").arg(QCoreApplication::translate("Settings", field.title),
                                                    valueTitle(field, m_document.settings()));
    const QString title = m_pipelinePanel->sceneBox()->currentText().toHtmlEscaped();
    const QString text = changes.isEmpty() ? m_pipelinePanel->sceneNote() : changes.join(QStringLiteral(" \u00b7 "));
    m_caption->setText(QStringLiteral("<b>%1</b> &nbsp; %2").arg(title, text.toHtmlEscaped()));
}

void MainWindow::toggleGoToPixel()
{
    const bool opening = m_goToEdit->isHidden();
    m_goToEdit->setVisible(opening);
    m_goToButton->setVisible(!opening);
    if (!opening) {
        m_viewport->setFocus();
        return;
    }
    m_goToEdit->selectAll();
    m_goToEdit->setFocus(Qt::ShortcutFocusReason);
}

void MainWindow::goToTypedPixel()
{
    const QStringList parts = m_goToEdit->text().split(QLatin1Char(','));
    bool goodX = false;
    bool goodY = false;
    const QPoint pixel(parts.value(0).trimmed().toInt(&goodX), parts.value(1).trimmed().toInt(&goodY));
    const QSize size = m_document.settings().size;
    if (parts.size() != 2 || !goodX || !goodY || !QRect(QPoint(0, 0), size).contains(pixel)) {
        m_message->show(MessageKind::Error,
                        tr("\"%1\" is no pixel of the picture. Write x, y with 0 to %2 and 0 to %3.")
                            .arg(m_goToEdit->text())
                            .arg(size.width() - 1)
                            .arg(size.height() - 1));
        return;
    }
    m_message->hide();
    toggleGoToPixel();
    m_viewport->goToPixel(pixel);
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
    m_viewport->setCanvasColor(themeColors(look.kind).canvas);
    m_truth->setPresentation(look.presentation);
    m_viewport->setThickLines(look.presentation);
    m_dark->setChecked(look.kind == ThemeKind::Dark);
}

void MainWindow::setPresentation(bool on)
{
    if (on == m_look.presentation)
        return;
    if (on) {
        m_stateBeforePresentation = saveState(kLayoutVersion);
        for (Dock* dock : findChildren<Dock*>()) // before the type grows, and the window with it
            dock->hide();
    }
    m_stepMode->transport().setBrief(on);
    Look look = m_look;
    look.presentation = on;
    setLook(look);
    menuBar()->setVisible(!on);
    centralWidget()->layout()->setContentsMargins(0, on ? kCardGap : 0, 0, 0);
    m_caption->setVisible(on);
    m_presentation->setChecked(on);
    if (on) {
        m_stepMode->transport().setVisible(m_stepMode->session().isOpen());
        showFullScreen();
        m_viewport->setFocus();
    } else {
        restoreState(m_stateBeforePresentation, kLayoutVersion);
        showNormal();
    }
}

void MainWindow::resetLayout()
{
    setPresentation(false);
    restoreState(m_defaultState, kLayoutVersion);
    m_docksArranged = false;
    sizeDocks();
    m_viewport->fit(m_document.scene()->window);
}

void MainWindow::restoreMemory()
{
    const QSettings memory;
    restoreGeometry(memory.value(QStringLiteral("window/geometry")).toByteArray());
    m_docksArranged = restoreState(memory.value(QStringLiteral("window/state")).toByteArray(), kLayoutVersion);
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
    setPresentation(false);
    memory.setValue(QStringLiteral("window/geometry"), saveGeometry());
    memory.setValue(QStringLiteral("window/state"), saveState(kLayoutVersion));
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

void MainWindow::closeEvent(QCloseEvent* event)
{
    if (m_memory == Memory::Remember)
        saveMemory();
    m_worker.setContinuous(false);
    event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
    if (event->mimeData()->hasUrls() && event->mimeData()->urls().first().isLocalFile())
        event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event)
{
    m_document.open(event->mimeData()->urls().first().toLocalFile());
    event->acceptProposedAction();
}

void MainWindow::showEvent(QShowEvent* event)
{
    QMainWindow::showEvent(event);
    m_viewport->setFocus();
}

void MainWindow::resizeEvent(QResizeEvent* event)
{
    QMainWindow::resizeEvent(event);
    if (!m_docksArranged)
        QTimer::singleShot(0, this, &MainWindow::sizeDocks); // once the docks have followed the window
}

bool MainWindow::event(QEvent* event)
{
    // Where the main window itself takes the mouse there are only the lines between the docks.
    if (event->type() == QEvent::MouseMove)
        m_docksArranged = m_docksArranged || (QGuiApplication::mouseButtons() & Qt::LeftButton) != 0;
    return QMainWindow::event(event);
}

} // namespace rasterlens
