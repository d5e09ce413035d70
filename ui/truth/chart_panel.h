#pragma once
#include "core/truth/charts.h"
#include "ui/base/latest_result.h"
#include "ui/document/document.h"
#include "ui/truth/chart_plot.h"

#include <QWidget>

#include <optional>

class QComboBox;
class QLabel;
class QMenu;
class QPushButton;
class QToolButton;

namespace rasterlens
{

/// Charts of what costs how much accuracy: of numbers, rules, samples and formats. One is drawn when it is chosen; one
/// that is about the scene is drawn again when asked to.
class ChartPanel : public QWidget
{
    Q_OBJECT

public:
    explicit ChartPanel(Document& document, QWidget* parent = nullptr);
    ~ChartPanel() override;

    /// in  an id of chartInfos()
    void choose(const QString& id);
    [[nodiscard]] bool isBusy() const { return m_result.isBusy(); }
    [[nodiscard]] const ChartInfo& info() const;
    [[nodiscard]] const Chart& chart() const { return m_chart; }
    [[nodiscard]] ChartPlot& plot() { return *m_plot; }
    [[nodiscard]] QComboBox* box() const { return m_box; }
    [[nodiscard]] QString note() const;

    /// in      a name that ends in .csv, .json, .svg or .png
    /// errors  a sentence in the language in use
    [[nodiscard]] std::optional<QString> exportTo(const QString& path);

    QSize sizeHint() const override { return {1000, 300}; }

Q_SIGNALS:
    void message(const QString& text);
    void failed(const QString& text);

protected:
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void buildControls();
    void draw();
    void take(Chart chart);
    void giveUp(Lack lack);
    void chooseFile(const QString& suffix);
    void syncNote();
    void retranslate();
    [[nodiscard]] std::optional<Reason> refusal() const;

    Document& m_document;
    Chart m_chart;
    bool m_isDrawn = false; ///< of the chart that is chosen
    bool m_isOld = false;   ///< the scene or the settings have changed since
    QString m_failure;
    QComboBox* m_box = nullptr;
    QPushButton* m_again = nullptr;
    QToolButton* m_export = nullptr;
    QMenu* m_exportMenu = nullptr;
    QLabel* m_note = nullptr;
    ChartPlot* m_plot = nullptr;
    LatestResult<Chart> m_result; ///< last: its thread uses the members above
};

} // namespace rasterlens
