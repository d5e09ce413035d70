#include "ui/face/cards.h"

#include "core/base/closed_list.h"
#include "core/derive/derive.h"
#include "core/observe/line_ends.h"
#include "core/observe/names.h"
#include "core/observe/step_log.h"
#include "core/questions/race.h"
#include "core/questions/why.h"
#include "core/render/render.h"
#include "core/scene/camera.h"
#include "core/settings/depth_rules.h"
#include "ui/base/bring_to_front.h"
#include "ui/base/dock.h"
#include "ui/face/clip_theatre.h"
#include "ui/face/curves_panel.h"
#include "ui/face/derivation_panel.h"
#include "ui/face/pixel_card.h"
#include "ui/face/race_panel.h"
#include "ui/face/vertex_handles.h"
#include "ui/face/vertex_panel.h"

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QMainWindow>
#include <QMouseEvent>
#include <QToolButton>

#include <algorithm>
#include <array>
#include <memory>

namespace rasterlens
{
namespace
{

/// How many samples the bounding box of a face holds on the screen, at most.
double boxSamples(const Scene& scene, const Settings& settings, std::uint32_t face)
{
    const glm::dvec2 size(settings.size.width(), settings.size.height());
    const auto corners = vertexTable(scene, settings, face);
    glm::dvec2 low = size;
    glm::dvec2 high(0, 0);
    for (const VertexRow& corner : corners) {
        if (corner.clip.w <= 0) // anywhere
            return size.x * size.y;
        low = glm::min(low, glm::clamp(corner.screen, glm::dvec2(0, 0), size));
        high = glm::max(high, glm::clamp(corner.screen, glm::dvec2(0, 0), size));
    }
    return std::max(0.0, high.x - low.x) * std::max(0.0, high.y - low.y) * samplesPerPixel(settings.samples);
}

struct PanelRow {
    Cards::Panel panel;
    const char* name;  ///< on the command line
    const char* title; ///< in the menu and, but for the pixel card, of the dock
};
constexpr auto kPanels = std::to_array<PanelRow>({
    {Cards::Panel::PixelCard, "why", QT_TRANSLATE_NOOP("rasterlens::Cards", "Pixel card: why this pixel?")},
    {Cards::Panel::Vertices, "vertices", QT_TRANSLATE_NOOP("rasterlens::Cards", "Vertices")},
    {Cards::Panel::Clip, "clip", QT_TRANSLATE_NOOP("rasterlens::Cards", "Clip theatre")},
    {Cards::Panel::Curves, "curves", QT_TRANSLATE_NOOP("rasterlens::Cards", "Curves")},
    {Cards::Panel::Race, "race", QT_TRANSLATE_NOOP("rasterlens::Cards", "Algorithm race")},
    {Cards::Panel::Derivation, "derive", QT_TRANSLATE_NOOP("rasterlens::Cards", "Derivations")},
});
static_assert(isClosedList(kPanels, &PanelRow::panel));

const PanelRow& rowOf(Cards::Panel panel) { return kPanels[static_cast<std::size_t>(panel)]; }

constexpr double kMostRaceSamples = 3e6; ///< every one is kept, with its counts

} // namespace

/// What the face's panels show, computed in one go.
struct FaceFindings {
    std::shared_ptr<const ClipStory> story;
    std::shared_ptr<const AlgorithmRace> race;
    bool tooLarge = false; ///< for a race
};

Cards::Cards(Document& document, ViewportWidget& viewport, QMainWindow& window)
    : m_document(document), m_viewport(viewport), m_window(window), m_pixelCard(new PixelCard),
      m_vertexPanel(new VertexPanel(document, m_selection, m_editing)), m_clipTheatre(new ClipTheatre(m_selection)),
      m_curvesPanel(new CurvesPanel(m_selection)), m_racePanel(new RacePanel(m_selection)),
      m_derivationPanel(new DerivationPanel(m_selection)), m_handles(new VertexHandles(document, viewport, m_editing)),
      m_why([this](const std::shared_ptr<const WhyReport>& report) { showReport(report); },
            [this](Lack lack) { Q_EMIT failed(tr("The pixel card was not computed: %1.").arg(lackText(lack))); }),
      m_face([this](const std::shared_ptr<const FaceFindings>& found) { showFace(*found); },
             [this](Lack lack) { Q_EMIT failed(tr("The face's panels were not computed: %1.").arg(lackText(lack))); }),
      m_derived([this](const std::shared_ptr<const Derived>& derived) { m_derivationPanel->setDerived(derived); },
                [this](Lack lack) { Q_EMIT failed(tr("The derivation was not computed: %1.").arg(lackText(lack))); })
{
    addDock(Panel::PixelCard, m_pixelCard);
    addDock(Panel::Vertices, m_vertexPanel);
    addDock(Panel::Clip, m_clipTheatre);
    addDock(Panel::Curves, m_curvesPanel);
    addDock(Panel::Race, m_racePanel);
    addDock(Panel::Derivation, m_derivationPanel);
    viewport.addLayer(&m_derivationPanel->layer());
    viewport.installEventFilter(this);
    m_copy = dock(Panel::PixelCard).addLink();
    m_soon.setSingleShot(true);
    m_soon.setInterval(0);
    connect(&m_soon, &QTimer::timeout, this, &Cards::refresh);
    connect(&document, &Document::sceneChanged, this, [this] {
        m_selection.setCount(static_cast<std::uint32_t>(m_document.scene()->mesh.faceCount()));
        refreshSoon();
    });
    connect(&document, &Document::settingsChanged, this, &Cards::refreshSoon);
    connect(&m_selection, &FaceSelection::changed, this, &Cards::refreshSoon);
    connect(&viewport, &ViewportWidget::pixelChanged, this, [this] {
        if (m_viewport.selectedPixel() == m_pixel)
            return;
        m_pixel = m_viewport.selectedPixel();
        followPixel();
        refreshSoon();
    });
    connect(m_copy, &QToolButton::clicked, this,
            [this] { QGuiApplication::clipboard()->setText(m_pixelCard->asText()); });
    connect(m_pixelCard, &PixelCard::rowClicked, this, [this](quint32 face, QPoint pixel) {
        m_selection.setFace(face);
        Q_EMIT stepRequested(face, pixel);
    });
    connect(m_derivationPanel, &DerivationPanel::asked, this, &Cards::refreshSoon);
    connect(m_derivationPanel, &DerivationPanel::layerChanged, &viewport, qOverload<>(&QWidget::update));
    retranslate();
}

Cards::~Cards() = default;

void Cards::addDock(Panel which, QWidget* panel)
{
    Q_ASSERT(static_cast<std::size_t>(which) == m_docks.size());
    const QString name = QLatin1String(rowOf(which).name);
    auto* dock = new Dock(name + QStringLiteral("Dock"), panel, &m_window,
                          which == Panel::PixelCard ? Dock::Fit::Shrinks : Dock::Fit::Scrolls);
    connect(dock, &Dock::sightChanged, this, &Cards::refreshSoon);
    connect(dock->toggleViewAction(), &QAction::triggered, dock, [dock](bool on) {
        if (on)
            dock->raise();
    });
    m_docks.push_back(dock);
}

QStringList Cards::names()
{
    QStringList names;
    for (const PanelRow& row : kPanels)
        names << QLatin1String(row.name);
    return names;
}

bool Cards::show(const QString& name)
{
    for (const PanelRow& row : kPanels)
        if (QLatin1String(row.name) == name) {
            bringToFront(dock(row.panel));
            refreshSoon();
            return true;
        }
    return false;
}

bool Cards::canDraw() const { return !unsupported(*m_document.scene(), m_document.settings()); }

void Cards::refreshSoon() { m_soon.start(); }

bool Cards::isBusy() const { return m_soon.isActive() || m_why.isBusy() || m_face.isBusy() || m_derived.isBusy(); }

void Cards::followPixel()
{
    m_followPending = false;
    if (!m_pixel)
        return;
    const auto readout = m_viewport.readout(*m_pixel);
    if (readout && readout->face && *readout->face >= 0)
        m_selection.setFace(static_cast<std::uint32_t>(*readout->face));
    m_followPending = readout && !readout->face;
}

/// The pixel and, where a line is drawn, the edge of an event.
///
/// in  the number of the event
Cards::StepPlace Cards::placeOf(const StepLog& log, std::size_t i)
{
    const StepEvent& event = log.event(i);
    StepPlace place;
    if (event.x >= 0 && event.y >= 0)
        place.pixel = QPoint(event.x / log.grid(), event.y / log.grid());
    const StepTriangle* triangle = log.triangle(event);
    const bool isLines = triangle != nullptr && passRules(log.rules(), event.face).fill == Fill::Wireframe;
    const StepEvent* decision = isLines ? decisionAt(log, i) : nullptr;
    if (decision == nullptr)
        return place;
    if (const auto line = lineOf(triangle->screen, log.payload<LineStep>(*decision).decision, log.rules()))
        place.edge = static_cast<int>(line->edge);
    return place;
}

void Cards::followStep(const StepLog* log, std::size_t position)
{
    const StepEvent* event = log != nullptr && position > 0 ? &log->event(position - 1) : nullptr;
    const bool isPlane = event && event->kind == StepKind::ClipPlane;
    const bool isClipping =
        isPlane || (event && (event->kind == StepKind::Vertex || event->kind == StepKind::CohenSutherland));
    m_clipTheatre->followStep(isClipping ? std::optional(event->kind) : std::nullopt,
                              isPlane ? std::optional(log->payload<ClipStep>(*event).plane) : std::nullopt);
    m_derivationPanel->setCornersAreNamed(event != nullptr && event->face != StepEvent::kNone);
    m_derivationPanel->followSymbol(
        isPlane ? QStringLiteral("t_") + QLatin1String(infoOf(log->payload<ClipStep>(*event).plane).sign) : QString());
    const StepPlace before = m_step;
    m_step = event != nullptr ? placeOf(*log, position - 1) : StepPlace{};
    if (m_step.pixel == before.pixel && m_step.edge == before.edge)
        return;
    if (m_step.edge && m_step.edge != before.edge)
        m_derivationPanel->followEdge();
    if (dock(Panel::Derivation).isInSight())
        askDerivation();
}

void Cards::setSaysMoment(bool on) { m_pixelCard->setSaysMoment(on); }

void Cards::setSecret(std::optional<QPoint> pixel)
{
    if (std::exchange(m_secret, pixel) != pixel)
        refresh();
}

void Cards::frameCounted()
{
    if (m_followPending)
        followPixel();
}

void Cards::refresh()
{
    askWhy();
    if (dock(Panel::Vertices).isInSight())
        m_vertexPanel->refresh();
    m_handles->setActive(dock(Panel::Vertices).isInSight());
    if (dock(Panel::Curves).isInSight()) {
        const Scene& scene = *m_document.scene();
        const Matrices matrices = cameraMatrices(scene, m_document.settings());
        std::optional<std::array<VertexRow, 3>> corners;
        if (m_selection.count() > 0)
            corners = vertexTable(scene, m_document.settings(), m_selection.face());
        m_curvesPanel->setCorners(corners, matrices);
    }
    askFace();
    askDerivation();
}

void Cards::askWhy()
{
    const QRect picture(QPoint(0, 0), m_document.settings().size);
    const bool asked =
        dock(Panel::PixelCard).isInSight() && m_pixel && m_pixel != m_secret && picture.contains(*m_pixel) && canDraw();
    if (!asked) {
        m_why.drop();
        if (m_pixelCard->report())
            m_pixelCard->setReport(nullptr);
        dock(Panel::PixelCard).setTitle(m_pixelCard->title());
        m_copy->setVisible(false);
        return;
    }
    m_why.ask(
        [pixel = *m_pixel, scene = m_document.scene(), settings = m_document.settings()](const auto& turn) {
            return std::make_shared<const WhyReport>(why(*scene, settings, pixel.x(), pixel.y(), turn.stop()));
        },
        LatestJob::Running::Interrupt);
}

void Cards::showReport(const std::shared_ptr<const WhyReport>& report)
{
    m_pixelCard->setReport(report);
    dock(Panel::PixelCard).setTitle(m_pixelCard->title());
    m_copy->setVisible(true);
}

void Cards::askFace()
{
    const bool wantsStory = dock(Panel::Clip).isInSight();
    const bool wantsRace = dock(Panel::Race).isInSight();
    if (!(wantsStory || wantsRace) || m_selection.count() == 0 || !canDraw()) {
        m_face.drop();
        if (!(wantsStory || wantsRace || m_clipTheatre->story() || m_racePanel->race()))
            return; // out of sight, and empty already
        m_clipTheatre->setStory(nullptr);
        m_racePanel->setRace(nullptr);
        return;
    }
    m_face.ask(
        [wantsStory, wantsRace, face = m_selection.face(), scene = m_document.scene(),
         settings = m_document.settings()](const auto& turn) {
            const auto found = std::make_shared<FaceFindings>();
            if (wantsStory)
                found->story = std::make_shared<const ClipStory>(clipStory(*scene, settings, face, turn.stop()));
            found->tooLarge = boxSamples(*scene, settings, face) > kMostRaceSamples;
            if (wantsRace && !found->tooLarge)
                found->race =
                    std::make_shared<const AlgorithmRace>(raceAlgorithms(*scene, settings, face, turn.stop()));
            return found;
        },
        LatestJob::Running::Interrupt);
}

/// Formulas of the selected face; those of a pixel are derived at the selected one, or else where the step is, or else
/// at one inside the face; those of an edge at the chosen one, or else at that of the line that is stepped along.
void Cards::askDerivation()
{
    if (!dock(Panel::Derivation).isInSight() || m_selection.count() == 0 || !canDraw()) {
        m_derived.drop();
        if (m_derivationPanel->derived())
            m_derivationPanel->setDerived(nullptr);
        return;
    }
    DerivationPlace place;
    place.face = m_selection.face();
    place.pixel = m_pixel ? m_pixel : m_step.pixel;
    place.edge = m_derivationPanel->edge();
    if (!place.edge && m_step.edge)
        place.edge = m_step.edge;
    place.m = m_derivationPanel->m();
    if (const std::optional<double> part = m_derivationPanel->depthPart()) {
        const Matrices matrices = cameraMatrices(*m_document.scene(), m_document.settings());
        place.depth = matrices.near + *part * (matrices.far - matrices.near);
    }
    m_derived.ask(
        [place, topic = m_derivationPanel->topic(), scene = m_document.scene(),
         settings = m_document.settings()](const auto& turn) {
            return std::make_shared<const Derived>(derive(topic, *scene, settings, place, turn.stop()));
        },
        LatestJob::Running::Interrupt);
}

/// A part of the picture under the mouse lights its symbol in the derivation.
bool Cards::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == &m_viewport && event->type() == QEvent::MouseMove && dock(Panel::Derivation).isInSight()) {
        constexpr double kReach = 7; // canvas pixels
        const CanvasTransform& transform = m_viewport.transform();
        const QPointF at = transform.toImage(static_cast<QMouseEvent*>(event)->position());
        m_derivationPanel->hoverSymbol(m_derivationPanel->symbolAt(at, kReach / transform.zoom));
    }
    if (watched == &m_viewport && event->type() == QEvent::Leave)
        m_derivationPanel->hoverSymbol(std::nullopt);
    return QObject::eventFilter(watched, event);
}

void Cards::showFace(const FaceFindings& found)
{
    m_clipTheatre->setStory(found.story);
    m_racePanel->setRace(found.race, found.tooLarge ? RacePanel::Absence::TooLarge : RacePanel::Absence::NotDrawn);
}

void Cards::retranslate()
{
    for (const PanelRow& row : kPanels)
        dock(row.panel).setTitle(tr(row.title));
    dock(Panel::PixelCard).setTitle(m_pixelCard->title());
    m_copy->setText(tr("Copy"));
    m_copy->setToolTip(tr("Copy as text"));
}

} // namespace rasterlens
