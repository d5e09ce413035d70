#pragma once
#include "core/questions/vertex_table.h"
#include "core/scene/camera.h"
#include "core/truth/perspective_curves.h"
#include "ui/face/face_picker.h"

#include <QWidget>

#include <array>
#include <optional>

class QBoxLayout;
class QComboBox;
class QLabel;
class QSlider;

namespace rasterlens
{

class CurvePlot;

/// What the curves are about: the distances of an edge's ends and the near and far planes.
struct CurveInput {
    double near = 0.1;
    double far = 50;
    double z1 = 1;
    double z2 = 10;
    bool ofEdge = false; ///< else the numbers of the textbook
};

/// Perspective correction n(m) of an edge, the squeezed depth z', and the four-z board.
class CurvesPanel : public QWidget
{
    Q_OBJECT

public:
    explicit CurvesPanel(FaceSelection& selection, QWidget* parent = nullptr);

    /// Nothing: no face. near and far of the matrices are 0 where the scene has no camera.
    void setCorners(const std::optional<std::array<VertexRow, 3>>& corners, const Matrices& matrices);

    [[nodiscard]] QComboBox* edgeBox() const { return m_edge; }
    [[nodiscard]] QSlider* slider() const { return m_slider; }
    [[nodiscard]] const CurveInput& input() const { return m_input; }
    [[nodiscard]] FourZ board() const;
    /// A cell of the four-z board as it is shown: row 0 NDC z, row 1 distance; truth, linear, error, corrected, error.
    [[nodiscard]] QString boardText(int row, int column) const;
    [[nodiscard]] const CurvePlot& correctionPlot() const { return *m_correction; }
    [[nodiscard]] const CurvePlot& squeezePlot() const { return *m_squeeze; }

    QSize sizeHint() const override { return {760, 250}; }

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    class Board;

    void choose();
    void arrange();
    void retranslate();
    void showCurves();
    [[nodiscard]] double fraction() const;
    void paintBoard(QPainter& painter, const QRectF& where) const;

    std::optional<std::array<VertexRow, 3>> m_corners;
    double m_near = 0;
    double m_far = 0;
    bool m_isOrthographic = false;
    CurveInput m_input;
    QComboBox* m_edge;
    QSlider* m_slider;
    QLabel* m_sliderName;
    QLabel* m_note;
    CurvePlot* m_correction;
    CurvePlot* m_squeeze;
    QWidget* m_board;
    QBoxLayout* m_figures; ///< the plots and the board
    QBoxLayout* m_plots;
    bool m_inARow = true;
    bool m_arePlotsBeside = true;
    bool m_edgeIsChosen = false; ///< by hand; until then the edge with the most to correct is shown
};

} // namespace rasterlens
