#pragma once
#include "ui/base/latest_result.h"
#include "ui/canvas/viewport_widget.h"
#include "ui/document/document.h"
#include "ui/face/face_picker.h"
#include "ui/face/vertex_editing.h"

#include <QObject>
#include <QPoint>
#include <QTimer>

#include <memory>
#include <optional>
#include <vector>

class QDockWidget;
class QMainWindow;
class QToolButton;

namespace rasterlens
{

class ClipTheatre;
class DerivationPanel;
class CurvesPanel;
class Dock;
class PixelCard;
class RacePanel;
class StepLog;
class VertexHandles;
class VertexPanel;
struct Derived;
struct StepEvent;
struct FaceFindings;
struct WhyReport;

/// The panels about one pixel or one face, and what they show: computed on background threads for those in sight.
class Cards : public QObject
{
    Q_OBJECT

public:
    enum class Panel { PixelCard, Vertices, Clip, Curves, Race, Derivation };

    Cards(Document& document, ViewportWidget& viewport, QMainWindow& window);
    ~Cards() override;

    /// In the order of the panels; they have no place in the window yet.
    [[nodiscard]] const std::vector<Dock*>& docks() const { return m_docks; }
    /// Opens a panel by the short name of the command line: `why`, `vertices`, `clip`, `curves`, `race`, `derive`.
    bool show(const QString& name);
    [[nodiscard]] static QStringList names();

    [[nodiscard]] FaceSelection& selection() { return m_selection; }
    [[nodiscard]] PixelCard& pixelCard() { return *m_pixelCard; }
    [[nodiscard]] VertexPanel& vertexPanel() { return *m_vertexPanel; }
    [[nodiscard]] VertexHandles& vertexHandles() { return *m_handles; }
    [[nodiscard]] ClipTheatre& clipTheatre() { return *m_clipTheatre; }
    [[nodiscard]] CurvesPanel& curvesPanel() { return *m_curvesPanel; }
    [[nodiscard]] RacePanel& racePanel() { return *m_racePanel; }
    [[nodiscard]] DerivationPanel& derivationPanel() { return *m_derivationPanel; }

    /// While another picture than the finished one is on the canvas the pixel card says that it speaks of that.
    void setSaysMoment(bool on);
    /// The pixel card does not speak of this pixel, which an open question is about; nothing: no question is.
    void setSecret(std::optional<QPoint> pixel);
    /// A counted frame is shown: it knows the faces seen at the pixels.
    void frameCounted();
    /// The panels show this face.
    void followFace(quint32 face) { m_selection.setFace(face); }
    /// The clip theatre and the derivations show the step of the step mode; null: it has none.
    ///
    /// in  a position of the log
    void followStep(const StepLog* log, std::size_t position);
    /// Whether something shown is still being computed.
    [[nodiscard]] bool isBusy() const;
    void retranslate();

Q_SIGNALS:
    /// A row of the pixel card was clicked.
    void stepRequested(quint32 face, QPoint pixel);
    /// A panel keeps what it shows, for want of memory or threads.
    void failed(const QString& message);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    /// Where a step takes place; what it has not is empty.
    struct StepPlace {
        std::optional<QPoint> pixel;
        std::optional<int> edge; ///< of the face: AB, BC, CA
    };
    [[nodiscard]] static StepPlace placeOf(const StepLog& log, std::size_t i);

    /// Panels are added in their order.
    void addDock(Panel which, QWidget* panel);
    [[nodiscard]] Dock& dock(Panel which) const { return *m_docks[static_cast<std::size_t>(which)]; }
    void refreshSoon();
    void refresh();
    void followPixel();
    void askWhy();
    void askFace();
    void askDerivation();
    void showReport(const std::shared_ptr<const WhyReport>& report);
    void showFace(const FaceFindings& found);
    [[nodiscard]] bool canDraw() const;

    Document& m_document;
    ViewportWidget& m_viewport;
    QMainWindow& m_window;
    FaceSelection m_selection;
    VertexEditing m_editing;
    std::vector<Dock*> m_docks;
    PixelCard* m_pixelCard;
    VertexPanel* m_vertexPanel;
    ClipTheatre* m_clipTheatre;
    CurvesPanel* m_curvesPanel;
    RacePanel* m_racePanel;
    DerivationPanel* m_derivationPanel;
    VertexHandles* m_handles;
    QToolButton* m_copy;

    std::optional<QPoint> m_pixel;
    std::optional<QPoint> m_secret;
    StepPlace m_step;
    bool m_followPending = false; ///< the pixel was chosen before its frame was counted
    QTimer m_soon;
    LatestResult<std::shared_ptr<const WhyReport>> m_why;
    LatestResult<std::shared_ptr<const FaceFindings>> m_face;
    LatestResult<std::shared_ptr<const Derived>> m_derived;
};

} // namespace rasterlens
