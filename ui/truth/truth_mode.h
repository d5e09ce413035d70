#pragma once
#include "ui/truth/comparison.h"
#include "ui/truth/difference_layer.h"
#include "ui/truth/referee.h"

#include <QObject>

#include <vector>

class QAction;
class QMainWindow;
class QMenu;
class QVBoxLayout;

namespace rasterlens
{

class ActionTable;
class CaseBrowser;
class ChartPanel;
class CompareBar;
class Dock;
class ExperimentPanel;
class IdentifyPanel;
class RefereeBar;
class ViewportWidget;

/// Puts together what says how right the picture is: the referee and the comparison with their lines above the canvas
/// and the menu Compare, the hard cases, speed against error, charts, and the mistake that made a picture.
class TruthMode : public QObject
{
    Q_OBJECT

public:
    enum class Panel { Cases, Experiment, Charts, Identify };

    /// Adds the lines to `bars` and the menu's actions to the table.
    TruthMode(Document& document, ViewportWidget& viewport, QMainWindow& window, QVBoxLayout& bars,
              ActionTable& actions);
    ~TruthMode() override;

    [[nodiscard]] Referee& referee() { return m_referee; }
    [[nodiscard]] Comparison& comparison() { return m_comparison; }
    [[nodiscard]] CompareBar& compareBar() { return *m_compareBar; }
    [[nodiscard]] RefereeBar& refereeBar() { return *m_refereeBar; }
    [[nodiscard]] CaseBrowser& caseBrowser() { return *m_cases; }
    [[nodiscard]] ExperimentPanel& experiment() { return *m_experiment; }
    [[nodiscard]] ChartPanel& charts() { return *m_charts; }
    [[nodiscard]] IdentifyPanel& identifyPanel() { return *m_identify; }

    /// In the order of the panels; they have no place in the window yet.
    [[nodiscard]] const std::vector<Dock*>& docks() const { return m_docks; }
    /// Opens a panel by the short name of the command line.
    bool showPanel(const QString& name);
    [[nodiscard]] static QStringList panelNames();

    /// The menu Compare; its keys work in the whole window.
    [[nodiscard]] QMenu* menu() const { return m_menu; }

    /// Shows a picture on the canvas or, while pictures are compared, what the comparison has in its place.
    ///
    /// in  whether it is a step of the picture, which is not compared
    void showOnCanvas(const FramePtr& frame, bool isStep);
    [[nodiscard]] bool isBusy() const;
    /// Leaves the canvas more room.
    void setPresentation(bool on);
    void showNextWrong();
    /// Opens a scene with stepped float32 edge functions and has it checked.
    void showFloatFailure(const QString& scene);
    /// Opens a hard case as a variant draws it, checked and in the lens: at its first wrong pixel or, without one, at
    /// the first tie.
    void showCase(const QString& name, const QString& variant);
    void retranslate();

Q_SIGNALS:
    /// The step mode is to show a face at a pixel, or a stop by its name.
    void faceWanted(quint32 face, QPoint pixel);
    void stepWanted(const QString& where);
    void message(const QString& text);
    void failed(const QString& text);

private:
    /// Panels are added in their order.
    void addDock(Panel which, QWidget* panel, QMainWindow& window);
    [[nodiscard]] Dock& dock(Panel which) const { return *m_docks[static_cast<std::size_t>(which)]; }
    void buildMenu(ActionTable& table);
    void toggle(CompareView view);
    void sync();
    void syncCanvas();
    void openLens();

    Document& m_document;
    ViewportWidget& m_viewport;
    Referee m_referee;
    RefereeLayer m_refereeLayer;
    Comparison m_comparison;
    DifferenceLayer m_differenceLayer;
    FramePtr m_frame; ///< last to be shown
    bool m_isStep = false;
    bool m_lensWanted = false; ///< as soon as the case has been checked
    RefereeBar* m_refereeBar;
    CompareBar* m_compareBar;
    CaseBrowser* m_cases;
    ExperimentPanel* m_experiment;
    ChartPanel* m_charts;
    IdentifyPanel* m_identify;
    std::vector<Dock*> m_docks;
    QMenu* m_menu;
    QAction* m_refereeAction = nullptr;
    QAction* m_vertexStage = nullptr;
    QAction* m_nextWrong = nullptr;
    QAction* m_wipe = nullptr;
    QAction* m_blink = nullptr;
    QAction* m_heat = nullptr;
};

} // namespace rasterlens
