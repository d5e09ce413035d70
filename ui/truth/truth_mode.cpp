#include "ui/truth/truth_mode.h"

#include "core/base/closed_list.h"
#include "ui/base/dock.h"
#include "ui/canvas/viewport_widget.h"
#include "ui/truth/case_browser.h"
#include "ui/truth/compare_bar.h"
#include "ui/truth/experiment_panel.h"
#include "ui/truth/referee_bar.h"

#include <QAction>
#include <QMainWindow>
#include <QMenu>
#include <QVBoxLayout>

#include <array>
#include <utility>

namespace rasterlens
{
namespace
{

struct PanelRow {
    TruthMode::Panel panel;
    const char* name;  ///< on the command line
    const char* title; ///< of the dock
};
constexpr auto kPanels = std::to_array<PanelRow>({
    {TruthMode::Panel::Cases, "cases", QT_TRANSLATE_NOOP("rasterlens::TruthMode", "Hard cases")},
    {TruthMode::Panel::Experiment, "experiment", QT_TRANSLATE_NOOP("rasterlens::TruthMode", "Speed against error")},
});
static_assert(isClosedList(kPanels, &PanelRow::panel));

} // namespace

TruthMode::TruthMode(Document& document, ViewportWidget& viewport, QMainWindow& window, QVBoxLayout& bars)
    : m_document(document), m_viewport(viewport), m_window(window), m_referee(document), m_refereeLayer(m_referee),
      m_comparison(document), m_differenceLayer(m_comparison), m_refereeBar(new RefereeBar(m_referee)),
      m_compareBar(new CompareBar(document, m_comparison)), m_cases(new CaseBrowser),
      m_experiment(new ExperimentPanel(document)), m_menu(new QMenu(&window))
{
    viewport.addLayer(&m_refereeLayer);
    viewport.addLayer(&m_differenceLayer);
    bars.addWidget(m_refereeBar);
    bars.addWidget(m_compareBar);
    buildMenu();
    addDock(Panel::Cases, m_cases);
    addDock(Panel::Experiment, m_experiment);
    connect(m_cases, &CaseBrowser::caseChosen, this, &TruthMode::showCase);
    connect(&m_referee, &Referee::changed, this, &TruthMode::openLens);
    connect(&m_cases->model(), &CaseModel::failed, this, &TruthMode::failed);
    connect(m_experiment, &ExperimentPanel::message, this, &TruthMode::message);
    connect(m_experiment, &ExperimentPanel::failed, this, &TruthMode::failed);
    connect(m_refereeBar, &RefereeBar::nextRequested, this, &TruthMode::showNextWrong);
    connect(&m_referee, &Referee::changed, this, &TruthMode::sync);
    connect(&m_comparison, &Comparison::changed, this, &TruthMode::sync);
    connect(&m_comparison, &Comparison::frameChanged, this, &TruthMode::syncCanvas);
    retranslate();
}

TruthMode::~TruthMode()
{
    m_viewport.removeLayer(&m_differenceLayer);
    m_viewport.removeLayer(&m_refereeLayer);
}

void TruthMode::addDock(Panel which, QWidget* panel)
{
    Q_ASSERT(static_cast<std::size_t>(which) == m_docks.size());
    const QString name = QLatin1String(kPanels[static_cast<std::size_t>(which)].name);
    m_docks.push_back(new Dock(name + QStringLiteral("Dock"), panel, &m_window, Dock::Fit::Scrolls));
}

QStringList TruthMode::panelNames()
{
    QStringList names;
    for (const PanelRow& row : kPanels)
        names << QLatin1String(row.name);
    return names;
}

bool TruthMode::showPanel(const QString& name)
{
    for (const PanelRow& row : kPanels)
        if (QLatin1String(row.name) == name) {
            dock(row.panel).show();
            dock(row.panel).raise();
            return true;
        }
    return false;
}

QAction* TruthMode::add(const char* text, const QKeySequence& key, std::function<void()> run, bool checkable)
{
    QAction* action = m_menu->addAction(QString());
    action->setShortcut(key);
    action->setCheckable(checkable);
    connect(action, &QAction::triggered, this, [run = std::move(run)] { run(); });
    m_window.addAction(action); // keys work also while the menu bar is hidden
    m_texts.push_back({action, text});
    return action;
}

void TruthMode::buildMenu()
{
    m_refereeAction = add(
        QT_TR_NOOP("&Exact referee"), Qt::Key_V, [this] { m_referee.setOn(!m_referee.isOn()); }, true);
    m_vertexStage = add(
        QT_TR_NOOP("&Judge from object space"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_V),
        [this] {
            m_referee.setSpace(m_vertexStage->isChecked() ? ReferenceSpace::Object : ReferenceSpace::Clip);
            m_referee.setOn(true);
        },
        true);
    m_nextWrong =
        add(QT_TR_NOOP("&Next wrong pixel"), QKeySequence(Qt::SHIFT | Qt::Key_V), [this] { showNextWrong(); });
    m_menu->addSeparator();
    m_wipe = add(
        QT_TR_NOOP("&Wipe between A and B"), Qt::Key_S, [this] { toggle(CompareView::Wipe); }, true);
    m_blink = add(
        QT_TR_NOOP("&Blink A and B"), Qt::Key_B, [this] { toggle(CompareView::Blink); }, true);
    m_heat = add(
        QT_TR_NOOP("&Difference of A and B"), Qt::Key_D, [this] { toggle(CompareView::Difference); }, true);
    m_menu->addSeparator();
    add(QT_TR_NOOP("&Pin the present settings as A"), Qt::Key_A, [this] { m_comparison.pin(); });
    add(QT_TR_NOOP("E&xchange A and B"), QKeySequence(Qt::SHIFT | Qt::Key_A), [this] { m_comparison.swap(); });
}

void TruthMode::toggle(CompareView view)
{
    m_comparison.setView(m_comparison.view() == view ? CompareView::Off : view);
}

void TruthMode::sync()
{
    m_refereeAction->setChecked(m_referee.isOn());
    m_vertexStage->setChecked(m_referee.space() == ReferenceSpace::Object);
    m_vertexStage->setEnabled(m_referee.hasSpaces());
    m_nextWrong->setEnabled(m_referee.nextWrong({}).has_value());
    m_wipe->setChecked(m_comparison.view() == CompareView::Wipe);
    m_blink->setChecked(m_comparison.view() == CompareView::Blink);
    m_heat->setChecked(m_comparison.view() == CompareView::Difference);
    m_viewport.update();
}

bool TruthMode::isBusy() const
{
    return m_referee.isChecking() || m_comparison.isBusy() || m_experiment->isRunning() || m_cases->model().isBusy();
}

void TruthMode::showOnCanvas(const FramePtr& frame, bool isStep)
{
    m_frame = frame;
    m_isStep = isStep;
    if (!isStep)
        m_comparison.takeFrame(frame);
    syncCanvas();
    openLens();
}

void TruthMode::syncCanvas()
{
    if (!m_frame)
        return;
    const FramePtr compared = m_isStep ? nullptr : m_comparison.frame();
    m_differenceLayer.setShown(compared && m_comparison.view() == CompareView::Difference);
    m_viewport.setFrame(compared ? compared : m_frame);
    m_viewport.setCompared(m_isStep ? nullptr : m_comparison.wiped(), m_isStep ? QString() : m_comparison.tag());
}

void TruthMode::setPresentation(bool on)
{
    m_refereeBar->setBrief(on);
    m_compareBar->setBrief(on);
}

void TruthMode::showNextWrong()
{
    if (const auto pixel = m_referee.nextWrong(m_viewport.selectedPixel()))
        m_viewport.goToPixel(*pixel);
}

void TruthMode::showFloatFailure(const QString& scene)
{
    m_referee.setOn(true);
    m_document.openWith(scene, [](Settings& settings) {
        settings.algorithm = Algorithm::EdgeEquation;
        settings.numberType = NumberType::Float32;
        settings.stepping = Stepping::Incremental;
    });
}

void TruthMode::showCase(const QString& name, const QString& variant)
{
    m_referee.setOn(true);
    m_lensWanted = true;
    m_document.openWith(hardCasePath(name),
                        [variant](Settings& settings) { settings = changedBy(*findVariant(variant), settings); });
}

void TruthMode::openLens()
{
    // A picture of another size takes the selection away, so that of the case has to be there as well.
    const bool isThere = m_frame && m_frame->scene == m_document.scene() && !m_document.isLoading();
    if (!m_lensWanted || !isThere || m_referee.isChecking())
        return;
    m_lensWanted = false;
    const Judgement* judgement = m_referee.judgement();
    if (!judgement || judgement->wrong.empty() || judgement->wrong.front().face < 0) {
        Q_EMIT stepWanted(QStringLiteral("tie"));
        return;
    }
    const WrongPixel& wrong = judgement->wrong.front();
    const QPoint pixel(wrong.x, wrong.y);
    // The window still has to fit the new scene, which would take the eye away again.
    QMetaObject::invokeMethod(
        &m_viewport, [this, pixel] { m_viewport.goToPixel(pixel); }, Qt::QueuedConnection);
    m_viewport.selectPixel(pixel);
    Q_EMIT faceWanted(static_cast<quint32>(wrong.face), pixel);
}

void TruthMode::retranslate()
{
    m_menu->setTitle(tr("&Compare"));
    for (const PanelRow& row : kPanels)
        dock(row.panel).setTitle(tr(row.title));
    for (const TranslatedAction& entry : m_texts)
        entry.action->setText(tr(entry.text));
    sync();
}

} // namespace rasterlens
