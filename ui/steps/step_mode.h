#pragma once
#include "core/lessons/step_place.h"
#include "ui/steps/lens_overlay.h"
#include "ui/steps/moment_overlay.h"
#include "ui/steps/run_export.h"
#include "ui/steps/sample_lens.h"
#include "ui/steps/step_session.h"

#include <QObject>

#include <cstdint>
#include <functional>
#include <vector>

class QMainWindow;
class QMenu;

namespace rasterlens
{

class ActionTable;
class StepListing;
class TransportDock;
class ViewportWidget;

/// Puts the parts of the step mode together: the session, the transport, the lens on the canvas and the listing below.
class StepMode : public QObject
{
    Q_OBJECT

public:
    /// Adds the transport at the bottom of the window.
    StepMode(Document& document, ViewportWidget& viewport, QMainWindow& window, ActionTable& actions);
    ~StepMode() override;

    [[nodiscard]] StepSession& session() { return m_session; }
    [[nodiscard]] TransportDock& transport() { return *m_transport; }
    [[nodiscard]] StepListing& listing() { return *m_listing; }
    [[nodiscard]] const LensOverlay& lens() const { return m_lens; }
    [[nodiscard]] const SampleLens& sampleLens() const { return m_sampleLens; }
    [[nodiscard]] const MomentOverlay& geometry() const { return m_geometry; }

    /// The picture at the position, with depths, owners and counters; null when it is the document's own that is to be
    /// shown, as while a change is recorded: motion stays visible.
    [[nodiscard]] FramePtr frame();
    /// The step after which that frame is; nothing: the finished frame is shown.
    [[nodiscard]] std::optional<std::size_t> moment() const;

    /// Opens the step mode and goes there as soon as the record is there; to its end where it has no such place.
    void showPlace(const StepPlace& place);
    /// showPlace() of the place that a text tells.
    ///
    /// in  isPlace()
    void showStep(const QString& where);
    /// Opens the step mode and goes to the first event of a face at a pixel as soon as the record is there.
    void showFace(quint32 face, QPoint pixel);
    /// What stepPlaceFromText() reads.
    [[nodiscard]] static bool isPlace(const QString& where);
    /// Nothing is being recorded.
    [[nodiscard]] bool isSettled() const { return !m_session.isRecording(); }
    /// What the lens does not tell, for it would answer a question; nothing: there is no such question.
    void setSecret(const std::optional<LensSecret>& secret);

    /// Starts to write one numbered PNG a position, at a whole zoom or as on the screen.
    ///
    /// in   session() has a log that holds the run
    /// out  lives until it has finished
    RunExport& exportRun(const QString& folder, RunExport::Run run);

    /// Asks for the range and the folder.
    void chooseRunToExport(std::optional<int> zoom);
    /// Asks for the first and the last step of a run; a message instead where nothing is recorded.
    void chooseRun(const QString& title, std::function<void(std::size_t first, std::size_t last)> chosen);

Q_SIGNALS:
    void frameChanged(); ///< another picture is to be shown
    void message(const QString& text);
    void placeMissed(const QString& place); ///< a step that was asked for is not in the record, whose end is shown

private:
    void syncLens();
    void syncLegend();
    void syncSelection();
    void followStep();

    /// A frame that was handed out, and which moment of which record it shows.
    struct Shown {
        std::shared_ptr<RenderedFrame> frame;
        std::uint64_t record = 0; ///< StepSession::recordNumber()
        std::uint32_t turn = 0;   ///< StepCursor::turn()
    };

    StepSession m_session;
    ViewportWidget& m_viewport;
    SampleLens m_sampleLens;
    std::shared_ptr<const StepLog> m_lensLog; ///< what the lens reads, until it reads another one
    LensOverlay m_lens;
    MomentOverlay m_geometry;
    TransportDock* m_transport = nullptr;
    StepListing* m_listing = nullptr;
    QMainWindow& m_window;
    Shown m_shown;                     ///< last handed out
    Shown m_formerShown;               ///< before that
    std::optional<StepPlace> m_wanted; ///< where to go when the record is there
    /// The face and pixel to go to when the record is there.
    std::optional<std::pair<quint32, QPoint>> m_wantedFace;
    std::optional<LensSecret> m_secret;
};

} // namespace rasterlens
