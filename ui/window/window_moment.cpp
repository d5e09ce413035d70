#include "ui/window/window_moment.h"

#include "ui/base/action_table.h"
#include "ui/base/dock.h"
#include "ui/canvas/viewport_widget.h"
#include "ui/face/cards.h"
#include "ui/pipeline/canvas_views.h"
#include "ui/pipeline/mistakes_section.h"
#include "ui/pipeline/pipeline_panel.h"
#include "ui/steps/step_mode.h"
#include "ui/truth/truth_mode.h"

#include <QAction>

#include <utility>

namespace rasterlens
{
namespace
{

/// Nearly all of the picture is that with the mistake, which the moment speaks of; the line can be dragged. Where
/// single pixels are seen all of it is: what a caption counts can be counted.
double wipeFor(QSize size)
{
    constexpr int kCounted = 64; // pixels, the width of pictures in which each is seen
    return size.width() <= kCounted ? 0 : 0.1;
}

const QString kMistakes = QStringLiteral("mistakes");
const QString kReferee = QStringLiteral("referee");
const QString kNone = QStringLiteral("none");

/// Whether an overlay is on where a moment names none.
bool isUsual(const OverlayRow& row) { return OverlayOptions().*row.member; }

/// The entries of one object that another does not have, or has with another value.
QJsonObject differing(const QJsonObject& json, const QJsonObject& base)
{
    QJsonObject different;
    for (auto it = json.begin(); it != json.end(); ++it)
        if (base.value(it.key()) != it.value())
            different.insert(it.key(), it.value());
    return different;
}

CompareView viewOf(MomentCompare::View view)
{
    switch (view) {
    case MomentCompare::View::Off: return CompareView::Off;
    case MomentCompare::View::Wipe: return CompareView::Wipe;
    case MomentCompare::View::Blink: return CompareView::Blink;
    case MomentCompare::View::Difference: return CompareView::Difference;
    }
    return CompareView::Off;
}

MomentCompare::View viewOf(CompareView view)
{
    switch (view) {
    case CompareView::Off: return MomentCompare::View::Off;
    case CompareView::Wipe: return MomentCompare::View::Wipe;
    case CompareView::Blink: return MomentCompare::View::Blink;
    case CompareView::Difference: return MomentCompare::View::Difference;
    }
    return MomentCompare::View::Off;
}

} // namespace

WindowMoment::WindowMoment(Parts parts, QObject* parent) : QObject(parent), m_parts(std::move(parts))
{
    Document& document = m_parts.document;
    connect(&document, &Document::momentOpened, this, [this] {
        if (m_wanted)
            begin(*m_wanted);
    });
    connect(&document, &Document::momentRefused, this, [this] {
        m_wanted.reset();
        Q_EMIT refused();
    });
    connect(&document, &Document::opened, this, [this] { m_wanted.reset(); });
    connect(&document, &Document::settingsChanged, this, &WindowMoment::changed);
    connect(&m_parts.steps.session(), &StepSession::positionChanged, this, &WindowMoment::changed);
    connect(&m_parts.steps.session(), &StepSession::openChanged, this, &WindowMoment::changed);
    connect(&m_parts.truth.comparison(), &Comparison::changed, this, &WindowMoment::changed);
}

void WindowMoment::show(const Moment& moment, Document::GivingUp former)
{
    m_wanted = moment;
    m_isOpen = false;
    m_isSlide = true;
    m_parts.document.openMoment(moment, former);
}

void WindowMoment::showView(const Moment& moment)
{
    m_wanted = moment;
    m_isSlide = false;
    begin(moment);
}

/// Scene and settings are there, the picture of them is not yet.
void WindowMoment::begin(const Moment& moment)
{
    m_isOpen = true;
    if (moment.compare.view == MomentCompare::View::Off)
        m_parts.truth.comparison().setView(CompareView::Off);
    m_parts.viewport.setWipeAt(wipeFor(m_parts.document.settings().size));
    showOverlays(moment);
    showPanels(moment);
    if (moment.step)
        m_parts.steps.showPlace(*moment.step);
    else
        m_parts.steps.session().close();
    finish();
}

void WindowMoment::showOverlays(const Moment& moment)
{
    for (const OverlayRow& row : canvasOverlays()) {
        QAction* action = m_parts.actions.action(row.id);
        const bool isWanted =
            moment.overlays.isEmpty() ? isUsual(row) : moment.overlays.contains(QLatin1String(row.name));
        if (action->isChecked() != isWanted)
            action->trigger();
    }
    m_parts.truth.referee().setOn(moment.overlays.contains(kReferee));
}

void WindowMoment::showPanels(const Moment& moment)
{
    const auto hideOthers = [&](const std::vector<Dock*>& docks, const QStringList& names) {
        for (std::size_t i = 0; i < docks.size(); ++i) {
            const QString& name = names[static_cast<qsizetype>(i)];
            const bool stays = name == Cards::names().first() && !m_parts.hasFewDocks();
            if (!stays && !moment.panels.contains(name))
                docks[i]->hide();
        }
    };
    hideOthers(m_parts.cards.docks(), Cards::names());
    hideOthers(m_parts.truth.docks(), TruthMode::panelNames());
    for (const QString& name : moment.panels)
        if (m_parts.hasRoom() && !m_parts.cards.show(name))
            m_parts.truth.showPanel(name);
    m_parts.pipeline.mistakes().setOpen(moment.panels.contains(kMistakes));
}

void WindowMoment::finish()
{
    if (!m_wanted || !m_isOpen || !m_parts.isSettled())
        return;
    const Moment moment = *std::exchange(m_wanted, std::nullopt);
    Comparison& comparison = m_parts.truth.comparison();
    comparison.setView(viewOf(moment.compare.view));
    if (moment.compare.view != MomentCompare::View::Off)
        comparison.setWith(moment.compare.with == MomentCompare::With::Right ? CompareWith::Right : CompareWith::Scene);
    m_parts.viewport.selectPixel(moment.pixel);
    showPlace(moment);
    m_mark = mark();
    Q_EMIT shown();
    Q_EMIT changed();
}

/// Without a centre the whole picture is shown, as large as the canvas has room for; where that is less than half as
/// large as the moment wants, the selected pixel in its surroundings. A slide's centre gives way where all of the
/// picture has room in a larger zoom.
void WindowMoment::showPlace(const Moment& moment)
{
    ViewportWidget& viewport = m_parts.viewport;
    if (moment.centre && moment.zoom && !m_isSlide) {
        viewport.showAround(*moment.centre, *moment.zoom);
        return;
    }
    viewport.fit(m_parts.document.scene()->window);
    if (moment.centre && moment.zoom) {
        if (viewport.transform().zoom <= *moment.zoom)
            viewport.showAround(*moment.centre, *moment.zoom);
        return;
    }
    if (moment.zoom && moment.pixel && 2 * viewport.transform().zoom <= *moment.zoom)
        viewport.showAround(QPointF(*moment.pixel) + QPointF(0.5, 0.5), *moment.zoom);
}

QStringList WindowMoment::presentPanels() const
{
    QStringList panels;
    const auto add = [&](const std::vector<Dock*>& docks, const QStringList& names) {
        for (std::size_t i = 0; i < docks.size(); ++i)
            if (docks[i]->isInSight())
                panels << names[static_cast<qsizetype>(i)];
    };
    add(m_parts.cards.docks(), Cards::names());
    add(m_parts.truth.docks(), TruthMode::panelNames());
    if (m_parts.pipeline.mistakes().isOpen())
        panels << kMistakes;
    return panels;
}

QStringList WindowMoment::presentOverlays() const
{
    QStringList overlays;
    bool areUsual = !m_parts.truth.referee().isOn();
    for (const OverlayRow& row : canvasOverlays()) {
        const bool isOn = m_parts.actions.action(row.id)->isChecked();
        areUsual = areUsual && isOn == isUsual(row);
        if (isOn)
            overlays << QLatin1String(row.name);
    }
    if (areUsual)
        return {};
    if (m_parts.truth.referee().isOn())
        overlays << kReferee;
    return overlays.isEmpty() ? QStringList{kNone} : overlays;
}

Moment WindowMoment::present() const
{
    const Document& document = m_parts.document;
    const QString viewKey = QStringLiteral("view");
    Moment moment;
    moment.scene = document.scene()->id;
    moment.size = document.settings().size;
    QJsonObject settings = toJson(document.settings());
    QJsonObject defaults = toJson(document.defaults());
    moment.view = differing(settings.take(viewKey).toObject(), defaults.take(viewKey).toObject());
    settings.remove(QStringLiteral("size"));
    moment.settings = differing(settings, defaults);
    if (m_parts.steps.session().isOpen()) {
        moment.step.emplace();
        moment.step->position = m_parts.steps.session().position();
    }
    const ViewportWidget& viewport = m_parts.viewport;
    moment.pixel = viewport.selectedPixel();
    if (!viewport.isFitted()) {
        moment.zoom = viewport.transform().zoom;
        moment.centre = viewport.transform().toImage(viewport.middle());
    }
    moment.panels = presentPanels();
    moment.overlays = presentOverlays();
    const Comparison& comparison = m_parts.truth.comparison();
    moment.compare.view = viewOf(comparison.view());
    moment.compare.with = comparison.with() == CompareWith::Right || comparison.view() == CompareView::Off
                              ? MomentCompare::With::Right
                              : MomentCompare::With::Scene;
    return moment;
}

WindowMoment::Mark WindowMoment::mark() const
{
    const StepSession& session = m_parts.steps.session();
    return {m_parts.document.scene(), m_parts.document.settings(),
            session.isOpen() ? std::optional(session.position()) : std::nullopt,
            static_cast<int>(m_parts.truth.comparison().view())};
}

bool WindowMoment::isChanged() const { return !m_wanted && !(mark() == m_mark); }

} // namespace rasterlens
