#pragma once
#include "ui/base/latest_result.h"
#include "ui/canvas/barycentric_layer.h"
#include "ui/canvas/facing_layer.h"
#include "ui/canvas/geometry_layer.h"
#include "ui/canvas/texel_layer.h"
#include "ui/canvas/viewport_widget.h"
#include "ui/document/document.h"

#include <QObject>
#include <QStringList>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

class QAction;

namespace rasterlens
{

class ActionMenu;

/// What of the pipeline's data the canvas shows in place of the finished colours. All but Facing are shadings of the
/// settings, so that the record, the comparison, the cards and the session show what the canvas shows.
enum class CanvasView { Colour, Depth, Ids, Overdraw, Facing, Normals, Uv };

/// A view: the shading that draws it, its name on the command line, and its action.
struct CanvasViewRow {
    CanvasView view;
    const char* name;
    std::optional<Shading> shading; ///< none: Colour (any of several), Facing (the faces of the present shading)
    const char* id;
    Qt::Key key;
    const char* title;
};
[[nodiscard]] std::span<const CanvasViewRow> canvasViews();

/// Something laid over the picture: a switch of OverlayOptions.
struct OverlayRow {
    bool OverlayOptions::*member;
    const char* name; ///< on the command line and in lessons
    const char* id;   ///< of its action
    const char* title;
    const char* shortTitle = nullptr; ///< on the bar; null: it stands in the bar's menu only
    QKeyCombination key = Qt::Key(0); ///< 0: none
};
[[nodiscard]] std::span<const OverlayRow> canvasOverlays();

/// Chooses what the canvas shows and lays over it, and keeps what the overlays are drawn from: the faces on the screen
/// the weights at the selected pixel and its footprint in the texture, computed on background threads for the picture
/// that is shown.
class CanvasViews : public QObject
{
    Q_OBJECT

public:
    /// Adds its layers below those that come later.
    CanvasViews(Document& document, ViewportWidget& viewport, QObject* parent = nullptr);
    ~CanvasViews() override;

    /// Adds the views and the overlays to the menu View.
    void buildMenu(ActionMenu& menu);
    [[nodiscard]] const std::vector<QAction*>& viewActions() const { return m_viewActions; }
    /// In the order of canvasOverlays().
    [[nodiscard]] const std::vector<QAction*>& overlayActions() const { return m_overlayActions; }
    void retranslate();

    [[nodiscard]] CanvasView view() const;
    /// A step of undo, but for Facing. Colour is the last shading in colours.
    void setView(CanvasView view);
    void setOverlay(bool OverlayOptions::*member, bool on);
    /// By the names of the command line.
    ///
    /// out  whether there is such a view, or such an overlay
    bool setViewNamed(const QString& name);
    bool setOverlayNamed(const QString& name, bool on);
    [[nodiscard]] static QStringList viewNames();
    [[nodiscard]] static QStringList overlayNames();

    /// Shows the data of a stage, or the colours where that is what is shown already.
    void showStage(Stage stage);

    /// The picture on the canvas.
    void setFrame(const FramePtr& frame);
    /// Pictures are compared: facings are not shown.
    void setCompared(bool on);

    [[nodiscard]] bool isBusy() const { return m_facesJob.isBusy() || m_weightsJob.isBusy() || m_texelsJob.isBusy(); }
    [[nodiscard]] const GeometryLayer& geometry() const { return m_geometry; }
    [[nodiscard]] const BarycentricLayer& barycentric() const { return m_barycentric; }
    [[nodiscard]] const FacingLayer& facing() const { return m_facing; }
    [[nodiscard]] const TexelLayer& texels() const { return m_texels; }

Q_SIGNALS:
    void changed(); ///< view or overlays
    void message(const QString& text);
    void failed(const QString& text);

private:
    /// What the faces or the weights were computed for.
    struct Key {
        std::shared_ptr<const Scene> scene;
        Settings settings;
        std::optional<std::uint32_t> face{};
        std::optional<QPoint> pixel{};

        friend bool operator==(const Key&, const Key&) = default;
    };

    void follow();
    void followFaces();
    void followWeights();
    void followTexels();
    void takeFaces(std::shared_ptr<const ScreenFaces> faces);
    void showFacing();
    void syncActions();
    [[nodiscard]] std::optional<std::uint32_t> owner() const;
    [[nodiscard]] std::span<const std::int32_t> owners() const;
    [[nodiscard]] bool wantsFaces() const;

    Document& m_document;
    ViewportWidget& m_viewport;
    GeometryLayer m_geometry;
    BarycentricLayer m_barycentric;
    FacingLayer m_facing;
    TexelLayer m_texels;
    std::vector<QAction*> m_viewActions;
    std::vector<QAction*> m_overlayActions;
    Shading m_colour = Shading::Gouraud; ///< the last one in colours
    bool m_facingOn = false;
    bool m_compared = false;
    std::optional<Stage> m_stage;                   ///< its data is shown, and nothing else has been chosen since
    bool OverlayOptions::*m_stageOverlay = nullptr; ///< laid over the picture for a stage
    FramePtr m_frame;
    std::optional<Key> m_facesKey;
    std::optional<Key> m_weightsKey;
    std::optional<Key> m_texelsKey;
    LatestResult<std::shared_ptr<const ScreenFaces>> m_facesJob; ///< last: their threads use the members above
    LatestResult<std::shared_ptr<const PixelWeights>> m_weightsJob;
    LatestResult<std::shared_ptr<const TexelFootprint>> m_texelsJob;
};

} // namespace rasterlens
