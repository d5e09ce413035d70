#include "ui/pipeline/canvas_views.h"

#include "core/base/closed_list.h"
#include "core/questions/why.h"
#include "core/render/render.h"
#include "core/render/tile_side.h"
#include "ui/base/action_table.h"
#include "ui/base/applicability.h"

#include <QAction>

#include <algorithm>
#include <array>
#include <utility>

namespace rasterlens
{
namespace
{

constexpr std::size_t kFewFaces =
    4000; ///< so many go to the screen while the window waits: no picture without its lines

constexpr auto kViews = std::to_array<CanvasViewRow>({
    {CanvasView::Colour, "colour", std::nullopt, "view.colour", Qt::Key_Q,
     QT_TRANSLATE_NOOP("rasterlens::CanvasViews", "Colour")},
    {CanvasView::Depth, "depth", Shading::Depth, "view.depth", Qt::Key_Z,
     QT_TRANSLATE_NOOP("rasterlens::CanvasViews", "Depth")},
    {CanvasView::Ids, "ids", Shading::TriangleId, "view.ids", Qt::Key_I,
     QT_TRANSLATE_NOOP("rasterlens::CanvasViews", "Ids")},
    {CanvasView::Overdraw, "overdraw", Shading::Overdraw, "view.overdraw", Qt::Key_O,
     QT_TRANSLATE_NOOP("rasterlens::CanvasViews", "Overdraw")},
    {CanvasView::Facing, "facing", std::nullopt, "view.facing", Qt::Key_Y,
     QT_TRANSLATE_NOOP("rasterlens::CanvasViews", "Facing")},
    {CanvasView::Normals, "normals", Shading::Normals, "view.normals", Qt::Key_J,
     QT_TRANSLATE_NOOP("rasterlens::CanvasViews", "Normals")},
    {CanvasView::Uv, "uv", Shading::Uv, "view.uv", Qt::Key_U, QT_TRANSLATE_NOOP("rasterlens::CanvasViews", "UV")},
});
static_assert(isClosedList(kViews, &CanvasViewRow::view));

constexpr OverlayRow kOverlays[] = {
    {&OverlayOptions::grid, "grid", "view.grid",
     QT_TRANSLATE_NOOP("rasterlens::CanvasViews", "Pixel grid (from 8\u00d7)")},
    {&OverlayOptions::sampleDots, "samples", "view.samples",
     QT_TRANSLATE_NOOP("rasterlens::CanvasViews", "Sample positions (from 16\u00d7)"),
     QT_TRANSLATE_NOOP("rasterlens::CanvasViews", "Samples")},
    {&OverlayOptions::numbers, "numbers", "view.values",
     QT_TRANSLATE_NOOP("rasterlens::CanvasViews", "Pixel values (from 48\u00d7)")},
    {&OverlayOptions::wireframe, "wireframe", "view.wireframe",
     QT_TRANSLATE_NOOP("rasterlens::CanvasViews", "Wireframe over the picture"),
     QT_TRANSLATE_NOOP("rasterlens::CanvasViews", "Wireframe"), Qt::Key_K},
    {&OverlayOptions::outline, "outline", "view.outline",
     QT_TRANSLATE_NOOP("rasterlens::CanvasViews", "Outline of the face at the selected pixel")},
    {&OverlayOptions::boxes, "boxes", "view.boxes", QT_TRANSLATE_NOOP("rasterlens::CanvasViews", "Bounding boxes"),
     QT_TRANSLATE_NOOP("rasterlens::CanvasViews", "Boxes")},
    {&OverlayOptions::tiles, "tiles", "view.tiles",
     QT_TRANSLATE_NOOP("rasterlens::CanvasViews", "Tiles of the tiled algorithm"),
     QT_TRANSLATE_NOOP("rasterlens::CanvasViews", "Tiles")},
    {&OverlayOptions::barycentric, "barycentric", "view.barycentric",
     QT_TRANSLATE_NOOP("rasterlens::CanvasViews", "Barycentric areas and iso-lines"),
     QT_TRANSLATE_NOOP("rasterlens::CanvasViews", "Barycentric"), Qt::Key_G},
    {&OverlayOptions::midLine, "mid-line", "view.mid-line",
     QT_TRANSLATE_NOOP("rasterlens::CanvasViews", "Mid-line, where \u03b1 is nearly one half")},
    {&OverlayOptions::texels, "texels", "view.texels",
     QT_TRANSLATE_NOOP("rasterlens::CanvasViews", "Footprint of the selected pixel in the texture")},
    {&OverlayOptions::depthBeside, "depth-beside", "view.depth-beside",
     QT_TRANSLATE_NOOP("rasterlens::CanvasViews", "Depth buffer beside the picture"), nullptr, Qt::SHIFT | Qt::Key_Z},
};

/// What a stage of the strip shows: a view, and what is laid over it.
struct StageData {
    Stage stage;
    CanvasView view;
    bool OverlayOptions::*overlay; ///< null: nothing
};
constexpr auto kStageData = std::to_array<StageData>({
    {Stage::Scene, CanvasView::Ids, nullptr},
    {Stage::Clip, CanvasView::Colour, &OverlayOptions::wireframe},
    {Stage::Screen, CanvasView::Colour, &OverlayOptions::boxes},
    {Stage::Cull, CanvasView::Facing, nullptr},
    {Stage::Cover, CanvasView::Overdraw, nullptr},
    {Stage::Depth, CanvasView::Depth, nullptr},
    {Stage::Shade, CanvasView::Colour, nullptr},
    {Stage::Image, CanvasView::Colour, nullptr},
});
static_assert(isClosedList(kStageData, &StageData::stage));

/// The view that a shading draws.
CanvasView viewOf(Shading shading)
{
    const auto row = std::ranges::find(kViews, std::optional(shading), &CanvasViewRow::shading);
    return row == kViews.end() ? CanvasView::Colour : row->view;
}

} // namespace

std::span<const CanvasViewRow> canvasViews() { return kViews; }

std::span<const OverlayRow> canvasOverlays() { return kOverlays; }

CanvasViews::CanvasViews(Document& document, ViewportWidget& viewport, QObject* parent)
    : QObject(parent), m_document(document), m_viewport(viewport),
      m_facesJob([this](std::shared_ptr<const ScreenFaces> faces) { takeFaces(std::move(faces)); },
                 [this](Lack lack) { Q_EMIT failed(tr("The overlays were not computed: %1.").arg(lackText(lack))); }),
      m_weightsJob(
          [this](std::shared_ptr<const PixelWeights> weights) {
              m_barycentric.setWeights(std::move(weights));
              m_barycentric.setOn(m_viewport.overlays().barycentric);
              m_viewport.update();
          },
          [this](Lack lack) { Q_EMIT failed(tr("The overlays were not computed: %1.").arg(lackText(lack))); }),
      m_texelsJob(
          [this](std::shared_ptr<const TexelFootprint> footprint) {
              m_texels.setFootprint(std::move(footprint),
                                    m_texelsKey ? m_texelsKey->pixel.value_or(QPoint()) : QPoint());
              m_viewport.update();
          },
          [this](Lack lack) { Q_EMIT failed(tr("The overlays were not computed: %1.").arg(lackText(lack))); })
{
    viewport.addLayer(&m_facing);
    viewport.addLayer(&m_geometry);
    viewport.addLayer(&m_barycentric);
    viewport.addLayer(&m_texels);
    connect(&document, &Document::sceneChanged, this, [this] {
        m_facingOn = false;
        const Shading shading = m_document.defaults().shading;
        m_colour = viewOf(shading) == CanvasView::Colour ? shading : Shading::Gouraud;
    });
    connect(&document, &Document::settingsChanged, this, [this] {
        const Shading shading = m_document.settings().shading;
        if (viewOf(shading) == CanvasView::Colour)
            m_colour = shading;
        syncActions();
    });
    connect(&viewport, &ViewportWidget::pixelChanged, this, &CanvasViews::follow);
}

CanvasViews::~CanvasViews()
{
    m_viewport.removeLayer(&m_texels);
    m_viewport.removeLayer(&m_barycentric);
    m_viewport.removeLayer(&m_geometry);
    m_viewport.removeLayer(&m_facing);
}

void CanvasViews::buildMenu(ActionMenu& menu)
{
    const char* context = staticMetaObject.className();
    ActionMenu views = menu.addMenu({context, QT_TR_NOOP("Views")});
    for (const CanvasViewRow& row : kViews) {
        QAction* action =
            views.add(row.id, ActionWords{context, row.title}, {row.key}, [this, view = row.view] { setView(view); });
        action->setCheckable(true);
        m_viewActions.push_back(action);
    }
    ActionMenu overlays = menu.addMenu({context, QT_TR_NOOP("Overlays")});
    for (const OverlayRow& row : kOverlays) {
        QList<QKeySequence> keys;
        if (row.key.key() != Qt::Key(0))
            keys << QKeySequence(row.key);
        QAction* action = overlays.add(row.id, ActionWords{context, row.title}, keys,
                                       [this, member = row.member](bool on) { setOverlay(member, on); });
        action->setCheckable(true);
        m_overlayActions.push_back(action);
    }
    syncActions();
}

/// The bar has short words.
void CanvasViews::retranslate()
{
    for (std::size_t i = 0; i < m_overlayActions.size(); ++i)
        if (kOverlays[i].shortTitle)
            m_overlayActions[i]->setIconText(tr(kOverlays[i].shortTitle));
}

CanvasView CanvasViews::view() const { return m_facingOn ? CanvasView::Facing : viewOf(m_document.settings().shading); }

void CanvasViews::setView(CanvasView view)
{
    m_stage.reset();
    Settings next = m_document.settings();
    const std::optional<Shading> shading = kViews[static_cast<std::size_t>(view)].shading;
    next.shading = shading.value_or(m_colour);
    if (const auto why = unsupported(*m_document.scene(), next); why && next != m_document.settings()) {
        Q_EMIT message(tr("The view stays: %1").arg(whyUnsupported(*why)));
        syncActions();
        return;
    }
    m_facingOn = view == CanvasView::Facing;
    m_document.setSettings(next);
    follow();
    syncActions();
}

void CanvasViews::setOverlay(bool OverlayOptions::*member, bool on)
{
    OverlayOptions options = m_viewport.overlays();
    options.*member = on;
    m_barycentric.setOn(options.barycentric);
    m_viewport.setOverlays(options);
    follow();
    syncActions();
}

bool CanvasViews::setViewNamed(const QString& name)
{
    const auto row = std::ranges::find_if(kViews, [&](const auto& view) { return name == QLatin1String(view.name); });
    if (row == kViews.end())
        return false;
    setView(row->view);
    return true;
}

bool CanvasViews::setOverlayNamed(const QString& name, bool on)
{
    const auto row = std::ranges::find_if(kOverlays, [&](const auto& o) { return name == QLatin1String(o.name); });
    if (row == std::end(kOverlays))
        return false;
    setOverlay(row->member, on);
    return true;
}

QStringList CanvasViews::viewNames()
{
    QStringList names;
    for (const CanvasViewRow& row : kViews)
        names << QLatin1String(row.name);
    return names;
}

QStringList CanvasViews::overlayNames()
{
    QStringList names;
    for (const OverlayRow& row : kOverlays)
        names << QLatin1String(row.name);
    return names;
}

void CanvasViews::showStage(Stage stage)
{
    const bool wasShown = m_stage == stage;
    if (bool OverlayOptions::*overlay = std::exchange(m_stageOverlay, nullptr))
        setOverlay(overlay, false);
    const StageData& data = kStageData[static_cast<std::size_t>(stage)];
    setView(wasShown ? CanvasView::Colour : data.view);
    if (wasShown)
        return;
    m_stage = stage;
    if (data.overlay && !(m_viewport.overlays().*data.overlay)) {
        setOverlay(data.overlay, true);
        m_stageOverlay = data.overlay;
    }
}

void CanvasViews::setFrame(const FramePtr& frame)
{
    m_frame = frame;
    follow();
}

void CanvasViews::setCompared(bool on)
{
    m_compared = on;
    follow();
}

std::span<const std::int32_t> CanvasViews::owners() const
{
    if (!m_frame)
        return {};
    const QSize size = m_frame->frame.image.size();
    const auto pixels = std::size_t(size.width()) * std::size_t(size.height());
    if (m_frame->counted && m_frame->frame.ids.size() == pixels)
        return m_frame->frame.ids;
    return {};
}

/// The face that owns the selected pixel.
std::optional<std::uint32_t> CanvasViews::owner() const
{
    const auto pixel = m_viewport.selectedPixel();
    const std::span<const std::int32_t> ids = owners();
    if (!pixel || ids.empty() || !m_frame->frame.image.rect().contains(*pixel))
        return std::nullopt;
    const std::int32_t face =
        ids[std::size_t(pixel->y()) * std::size_t(m_frame->frame.image.width()) + std::size_t(pixel->x())];
    return face >= 0 ? std::optional(static_cast<std::uint32_t>(face)) : std::nullopt;
}

bool CanvasViews::wantsFaces() const
{
    const OverlayOptions& options = m_viewport.overlays();
    return m_facingOn || options.wireframe || options.boxes || options.midLine || (options.outline && owner());
}

/// Brings everything that is laid over the picture up to the picture.
void CanvasViews::follow()
{
    if (!m_frame)
        return;
    m_geometry.setWinner(owner());
    m_geometry.setTiles(double(tileSide()) / sampleGrid(m_frame->settings.samples), m_frame->frame.image.size());
    followFaces();
    followWeights();
    followTexels();
    showFacing();
}

void CanvasViews::followFaces()
{
    const Key key{m_frame->scene, m_frame->settings};
    if (!wantsFaces() || m_facesKey == key)
        return;
    m_facesKey = key;
    m_geometry.setFaces(nullptr); // those of another picture
    m_viewport.update();
    if (key.scene->mesh.faceCount() <= kFewFaces) {
        m_facesJob.drop();
        takeFaces(std::make_shared<const ScreenFaces>(screenFaces(*key.scene, key.settings)));
        return;
    }
    m_facesJob.ask(
        [key](const auto& turn) {
            return std::make_shared<const ScreenFaces>(screenFaces(*key.scene, key.settings, turn.stop()));
        },
        LatestJob::Running::Interrupt);
}

void CanvasViews::takeFaces(std::shared_ptr<const ScreenFaces> faces)
{
    m_geometry.setFaces(std::move(faces));
    m_viewport.update();
    showFacing();
}

void CanvasViews::followWeights()
{
    const bool isWanted = m_viewport.overlays().barycentric && owner();
    const std::optional<Key> key =
        isWanted ? std::optional(Key{m_frame->scene, m_frame->settings, owner(), m_viewport.selectedPixel()})
                 : std::nullopt;
    if (key == m_weightsKey)
        return;
    m_weightsKey = key;
    m_barycentric.setWeights(nullptr);
    m_barycentric.setOn(false);
    m_viewport.update();
    if (!key) {
        m_weightsJob.drop();
        return;
    }
    m_weightsJob.ask(
        [key = *key](const auto& turn) -> std::shared_ptr<const PixelWeights> {
            const auto weights = pixelWeights(*key.scene, key.settings, *key.face, *key.pixel, turn.stop());
            return weights ? std::make_shared<const PixelWeights>(*weights) : nullptr;
        },
        LatestJob::Running::Interrupt);
}

void CanvasViews::followTexels()
{
    const Shading shading = m_frame->settings.shading;
    const bool readsTexels = shading == Shading::Texture || shading == Shading::Phong || shading == Shading::MipLevel;
    const auto pixel = m_viewport.selectedPixel();
    const bool isWanted = m_viewport.overlays().texels && readsTexels && pixel &&
                          m_frame->frame.image.rect().contains(*pixel) &&
                          !unsupported(*m_frame->scene, m_frame->settings);
    const std::optional<Key> key =
        isWanted ? std::optional(Key{m_frame->scene, m_frame->settings, {}, pixel}) : std::nullopt;
    if (key == m_texelsKey)
        return;
    m_texelsKey = key;
    m_texels.setFootprint(nullptr, {});
    m_viewport.update();
    if (!key) {
        m_texelsJob.drop();
        return;
    }
    m_texelsJob.ask(
        [key = *key](const auto& turn) -> std::shared_ptr<const TexelFootprint> {
            const WhyReport report = why(*key.scene, key.settings, key.pixel->x(), key.pixel->y(), turn.stop());
            const WhyFace* seen =
                !turn.stop().stop_requested() && report.visibleFace ? report.find(*report.visibleFace) : nullptr;
            return seen != nullptr && seen->texels ? std::make_shared<const TexelFootprint>(*seen->texels) : nullptr;
        },
        LatestJob::Running::Interrupt);
}

/// Facings are shown once it is known whose the pixels are.
void CanvasViews::showFacing()
{
    const std::span<const std::int32_t> ids = owners();
    if (m_facingOn && !m_compared && !ids.empty() && m_geometry.faces())
        m_facing.show(*m_frame, ids, m_geometry.faces());
    else if (m_facing.picture())
        m_facing.hide();
    else
        return;
    m_viewport.update();
}

void CanvasViews::syncActions()
{
    if (m_viewActions.empty())
        return;
    for (std::size_t i = 0; i < m_viewActions.size(); ++i)
        m_viewActions[i]->setChecked(kViews[i].view == view());
    for (std::size_t i = 0; i < m_overlayActions.size(); ++i)
        m_overlayActions[i]->setChecked(m_viewport.overlays().*kOverlays[i].member);
    Q_EMIT changed();
}

} // namespace rasterlens
