#include "ui/truth/truth_mode.h"

#include "core/base/closed_list.h"
#include "ui/base/action_table.h"
#include "ui/base/bring_to_front.h"
#include "ui/base/dock.h"
#include "ui/canvas/viewport_widget.h"
#include "ui/truth/case_browser.h"
#include "ui/truth/chart_panel.h"
#include "ui/truth/compare_bar.h"
#include "ui/truth/experiment_panel.h"
#include "ui/truth/identify_panel.h"
#include "ui/truth/referee_bar.h"

#include <QAction>
#include <QMainWindow>
#include <QMenu>
#include <QVBoxLayout>

#include <array>

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
    {TruthMode::Panel::Charts, "charts", QT_TRANSLATE_NOOP("rasterlens::TruthMode", "Charts of errors")},
    {TruthMode::Panel::Identify, "identify", QT_TRANSLATE_NOOP("rasterlens::TruthMode", "Which mistake is mine?")},
});
static_assert(isClosedList(kPanels, &PanelRow::panel));

} // namespace

TruthMode::TruthMode(Document& document, ViewportWidget& viewport, QMainWindow& window, QVBoxLayout& bars,
                     ActionTable& actions)
    : m_document(document), m_viewport(viewport), m_referee(document), m_refereeLayer(m_referee),
      m_comparison(document), m_differenceLayer(m_comparison), m_refereeBar(new RefereeBar(m_referee)),
      m_compareBar(new CompareBar(document, m_comparison)), m_cases(new CaseBrowser),
      m_experiment(new ExperimentPanel(document)), m_charts(new ChartPanel(document)),
      m_identify(new IdentifyPanel(document)), m_menu(new QMenu(&window))
{
    viewport.addLayer(&m_refereeLayer);
    viewport.addLayer(&m_differenceLayer);
    bars.addWidget(m_refereeBar);
    bars.addWidget(m_compareBar);
    buildMenu(actions);
    addDock(Panel::Cases, m_cases, window);
    addDock(Panel::Experiment, m_experiment, window);
    addDock(Panel::Charts, m_charts, window);
    addDock(Panel::Identify, m_identify, window);
    connect(m_cases, &CaseBrowser::caseChosen, this, &TruthMode::showCase);
    connect(&m_referee, &Referee::changed, this, &TruthMode::openLens);
    connect(&m_cases->model(), &CaseModel::failed, this, &TruthMode::failed);
    connect(m_experiment, &ExperimentPanel::message, this, &TruthMode::message);
    connect(m_experiment, &ExperimentPanel::failed, this, &TruthMode::failed);
    connect(m_charts, &ChartPanel::message, this, &TruthMode::message);
    connect(m_charts, &ChartPanel::failed, this, &TruthMode::failed);
    connect(m_identify, &IdentifyPanel::failed, this, &TruthMode::failed);
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

void TruthMode::addDock(Panel which, QWidget* panel, QMainWindow& window)
{
    Q_ASSERT(static_cast<std::size_t>(which) == m_docks.size());
    const QString name = QLatin1String(kPanels[static_cast<std::size_t>(which)].name);
    m_docks.push_back(new Dock(name + QStringLiteral("Dock"), panel, &window, Dock::Fit::Scrolls));
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
            bringToFront(dock(row.panel));
            return true;
        }
    return false;
}

void TruthMode::buildMenu(ActionTable& table)
{
    ActionMenu menu(table, m_menu, *this, ActionSection::Compare, QT_TR_NOOP("&Compare"));
    m_refereeAction = menu.addToggle("compare.referee", QT_TR_NOOP("&Exact referee"), {Qt::Key_V}, false,
                                     [this] { m_referee.setOn(!m_referee.isOn()); });
    m_vertexStage = menu.addToggle("compare.object-space", QT_TR_NOOP("&Judge from object space"),
                                   {Qt::CTRL | Qt::SHIFT | Qt::Key_V}, false, [this](bool on) {
                                       m_referee.setSpace(on ? ReferenceSpace::Object : ReferenceSpace::Clip);
                                       m_referee.setOn(true);
                                   });
    m_nextWrong = menu.add("compare.next-wrong", QT_TR_NOOP("&Next wrong pixel"), {Qt::SHIFT | Qt::Key_V},
                           [this] { showNextWrong(); });
    menu.addSeparator();
    const auto addView = [&](const char* id, const char* text, Qt::Key key, CompareView view) {
        return menu.addToggle(id, text, {key}, false, [this, view] { toggle(view); });
    };
    m_wipe = addView("compare.wipe", QT_TR_NOOP("&Wipe between A and B"), Qt::Key_S, CompareView::Wipe);
    m_blink = addView("compare.blink", QT_TR_NOOP("&Blink A and B"), Qt::Key_B, CompareView::Blink);
    m_heat = addView("compare.difference", QT_TR_NOOP("&Difference of A and B"), Qt::Key_D, CompareView::Difference);
    menu.addSeparator();
    QAction* pin = menu.add("compare.pin", QT_TR_NOOP("&Pin the present settings as A"), {Qt::Key_A},
                            [this] { m_comparison.pin(); });
    QAction* swap = menu.add("compare.exchange", QT_TR_NOOP("E&xchange A and B"), {Qt::SHIFT | Qt::Key_A},
                             [this] { m_comparison.swap(); });
    table.listTogether(menu.words(QT_TR_NOOP("Pin A, exchange A and B")), {pin, swap});
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
    return m_referee.isChecking() || m_comparison.isBusy() || m_experiment->isRunning() || m_charts->isBusy() ||
           m_cases->model().isBusy() || m_identify->isBusy();
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

void TruthMode::setPresentation(bool on) { m_refereeBar->setBrief(on); }

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
    for (const PanelRow& row : kPanels)
        dock(row.panel).setTitle(tr(row.title));
    sync();
}

} // namespace rasterlens
