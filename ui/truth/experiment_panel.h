#pragma once
#include "core/truth/experiment.h"
#include "ui/base/latest_result.h"
#include "ui/document/document.h"
#include "ui/truth/experiment_plot.h"

#include <QWidget>

#include <memory>
#include <optional>
#include <vector>

class QCheckBox;
class QComboBox;
class QLabel;
class QMenu;
class QProgressBar;
class QPushButton;
class QSpinBox;
class QSortFilterProxyModel;
class QTableView;
class QToolButton;

namespace rasterlens
{

class ExperimentModel;

/// Measures every variant of the present scene, on a background thread, and shows speed against error: a plot and a
/// table. A click on a dot or a double click on a row loads the variant.
class ExperimentPanel : public QWidget
{
    Q_OBJECT

public:
    explicit ExperimentPanel(Document& document, QWidget* parent = nullptr);
    ~ExperimentPanel() override;

    /// Measures the scene and the settings of the document; what was measured before is let go of.
    void run(int frames);
    /// Stops; what has been measured stays.
    void cancel();
    [[nodiscard]] bool isRunning() const { return m_result.isBusy(); }

    [[nodiscard]] const std::vector<ExperimentRow>& rows() const { return m_rows; }
    [[nodiscard]] ExperimentPlot& plot() { return *m_plot; }
    [[nodiscard]] QTableView& table() { return *m_table; }
    [[nodiscard]] QComboBox* errorBox() const { return m_errorBox; }
    [[nodiscard]] QComboBox* speedBox() const { return m_speedBox; }
    /// Measures other renderers too, from the next run on.
    [[nodiscard]] QCheckBox* othersBox() const { return m_withOthers; }
    /// How edge equation and edge walking compare here, or why nothing is shown.
    [[nodiscard]] QString ratioText() const;
    /// How far the numbers can be trusted, and which renderers are not there.
    [[nodiscard]] QStringList remarks() const;

    /// Makes the settings of a row the present ones, seen from where the camera is now.
    void load(int row);

    /// in      a name that ends in .csv, .json, .svg or .png
    /// errors  a sentence in the language in use
    [[nodiscard]] std::optional<QString> exportTo(const QString& path);

    QSize sizeHint() const override { return {1000, 300}; }

Q_SIGNALS:
    void finished();
    void message(const QString& text);
    void failed(const QString& text);

protected:
    void changeEvent(QEvent* event) override;

private:
    QWidget* buildControls();
    QSortFilterProxyModel* buildTable();
    [[nodiscard]] QWidget* arrangedControls();
    /// What has been measured so far.
    struct Measured {
        std::vector<ExperimentRow> rows;
        std::vector<Reason> notMeasured; ///< other renderers
        int done = 1;
        int total = 1;
    };

    void take(Measured measured);
    void giveUp(Lack lack);
    void show();
    void choose(int row);
    void chooseFile(const QString& suffix);
    void syncState();
    [[nodiscard]] QString runText() const;
    void keepRunWidth();
    void retranslate();

    Document& m_document;
    std::vector<ExperimentRow> m_rows;
    std::vector<Reason> m_notMeasured; ///< why other renderers have no row
    QString m_sceneTitle;
    QPushButton* m_run = nullptr;
    QSpinBox* m_frames = nullptr;
    QCheckBox* m_withOthers = nullptr;
    QProgressBar* m_progress = nullptr;
    QComboBox* m_errorBox = nullptr;
    QComboBox* m_speedBox = nullptr;
    QToolButton* m_export = nullptr;
    QMenu* m_exportMenu = nullptr;
    QLabel* m_note = nullptr;
    ExperimentPlot* m_plot = nullptr;
    QTableView* m_table = nullptr;
    ExperimentModel* m_model = nullptr;
    LatestResult<Measured> m_result; ///< last: its thread uses the members above
};

} // namespace rasterlens
