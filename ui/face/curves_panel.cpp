#include "ui/face/curves_panel.h"

#include "core/observe/names.h"
#include "ui/base/field_row.h"
#include "ui/base/flow_layout.h"
#include "ui/base/inks.h"
#include "ui/base/parts.h"
#include "ui/base/theme.h"
#include "ui/base/turning.h"
#include "ui/face/curve_plot.h"

#include <QEvent>
#include <QFontInfo>
#include <QLabel>
#include <QPainter>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace rasterlens
{
namespace
{

constexpr int kCurvePoints = 129;
constexpr int kSliderSteps = 1000;
constexpr int kTextbook = 3;

std::vector<QPointF> points(const std::vector<CurvePoint>& curve)
{
    std::vector<QPointF> points;
    points.reserve(curve.size());
    for (const CurvePoint& point : curve)
        points.emplace_back(point.x, point.y);
    return points;
}

QString fixed(double value)
{
    QString text = QString::number(value, 'f', 4);
    return text.replace(QLatin1Char('-'), QChar(0x2212));
}

constexpr int kWidthOfOneRow = 676;   ///< two plots and the board beside each other
constexpr int kWidthOfTwoPlots = 420; ///< beside each other, above the board
constexpr int kLargeType = 20;        ///< pixels

} // namespace

/// The four-z board: painted, since its rows share the height there is.
class CurvesPanel::Board : public QWidget
{
public:
    explicit Board(CurvesPanel& panel) : m_panel(panel) {}

protected:
    void paintEvent(QPaintEvent*) override
    {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        m_panel.paintBoard(painter, rect());
    }

private:
    CurvesPanel& m_panel;
};

CurvesPanel::CurvesPanel(FaceSelection& selection, QWidget* parent)
    : QWidget(parent), m_edge(new PanelCombo), m_slider(new QSlider(Qt::Horizontal)), m_sliderName(new QLabel),
      m_note(new QLabel), m_correction(new CurvePlot), m_squeeze(new CurvePlot), m_board(new Board(*this)),
      m_figures(new QBoxLayout(QBoxLayout::LeftToRight)), m_plots(new QBoxLayout(QBoxLayout::LeftToRight))
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 2, 12, 8);
    column->setSpacing(6);
    auto* head = new FlowLayout(10);
    head->addWidget(new FacePicker(selection));
    m_edge->addItems({QString(), QString(), QString(), QString()});
    head->addWidget(m_edge);
    m_slider->setRange(0, kSliderSteps);
    m_slider->setValue(kSliderSteps / 2);
    m_slider->setPageStep(kSliderSteps / 20);
    m_slider->setFixedWidth(150);
    head->addWidget(makeTogether(m_sliderName, m_slider));
    m_note->setObjectName(QStringLiteral("muted"));
    m_note->setWordWrap(true);
    column->addLayout(head);
    column->addWidget(m_note);
    constexpr int kShareOfPlot = 32; // of 100
    m_figures->setSpacing(14);
    m_plots->setSpacing(14);
    m_plots->addWidget(m_correction, 1);
    m_plots->addWidget(m_squeeze, 1);
    m_figures->addLayout(m_plots, 2 * kShareOfPlot);
    m_figures->addWidget(m_board, 100 - 2 * kShareOfPlot);
    column->addLayout(m_figures, 1);
    new Turning(this, kWidthOfOneRow, [this](bool inARow) {
        m_inARow = inARow;
        arrange();
    });
    new Turning(this, kWidthOfTwoPlots, [this](bool beside) {
        m_arePlotsBeside = beside;
        arrange();
    });
    connect(m_edge, &QComboBox::currentIndexChanged, this, [this] {
        m_edgeIsChosen = true;
        choose();
    });
    connect(m_slider, &QSlider::valueChanged, this, &CurvesPanel::choose);
    arrange();
    retranslate();
}

void CurvesPanel::setCorners(const std::optional<std::array<VertexRow, 3>>& corners, const Matrices& matrices)
{
    m_corners = corners;
    m_near = matrices.near;
    m_far = matrices.far;
    m_isOrthographic = matrices.orthographic;
    if (m_corners && !m_edgeIsChosen) {
        const QSignalBlocker blocked(m_edge);
        m_edge->setCurrentIndex(mostUnequalEdge(*m_corners));
    }
    choose();
}

double CurvesPanel::fraction() const { return static_cast<double>(m_slider->value()) / kSliderSteps; }

FourZ CurvesPanel::board() const { return fourZ(m_input.near, m_input.far, m_input.z1, m_input.z2, fraction()); }

/// The edge's numbers where it has some: both ends before the eye. Otherwise those of the textbook.
void CurvesPanel::choose()
{
    m_input = {};
    const int edge = m_edge->currentIndex();
    m_note->clear();
    if (edge < kTextbook && m_corners && m_isOrthographic) {
        m_note->setText(
            tr("The camera is orthographic: w is 1, n is m, and z' is linear in the distance. The numbers of "
               "the textbook are shown."));
    } else if (edge < kTextbook && m_corners) {
        const VertexRow& from = (*m_corners)[static_cast<std::size_t>(edge)];
        const VertexRow& to = (*m_corners)[static_cast<std::size_t>((edge + 1) % 3)];
        if (isBeforeEye(from) && isBeforeEye(to)) {
            const double z1 = from.clip.w;
            const double z2 = to.clip.w;
            m_input = {m_near, m_far, z1, z2, true};
            if (!(m_near > 0 && m_far > m_near)) {
                m_input.near = std::min(z1, z2) / 2;
                m_input.far = std::max(z1, z2) * 2;
                m_note->setText(tr("The scene has no camera: near and far are examples."));
            }
        } else {
            m_note->setText(tr("An end of this edge is behind the eye: the numbers of the textbook are shown."));
        }
    }
    m_sliderName->setText(QStringLiteral("m = %1").arg(fraction(), 0, 'f', 3));
    showCurves();
    m_board->update();
}

QString CurvesPanel::boardText(int row, int column) const
{
    const FourZ z = board();
    const DepthGuess& guess = row == 0 ? z.ndc : z.view;
    const double values[] = {guess.truth, guess.linear, guess.linearError, guess.corrected, guess.correctedError};
    return fixed(values[column] == 0 ? 0.0 : values[column]);
}

/// Both plots and the board in a row or, where that is too narrow, the board below the plots, which stand below each
/// other at last.
void CurvesPanel::arrange()
{
    constexpr double kLinesOfBoard = 10.5;
    constexpr double kLinesOfPlot = 10;
    constexpr int kNarrowestBoard = 290;
    constexpr int kWidestBoard = 430;
    const double line = QFontMetricsF(textFont(0, true)).lineSpacing();
    const int boardHeight = static_cast<int>(line * kLinesOfBoard);
    const bool isLargeType = QFontInfo(font()).pixelSize() >= kLargeType; // else two plots are too small
    const bool arePlotsBeside = m_inARow || (m_arePlotsBeside && isLargeType);
    m_figures->setDirection(m_inARow ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    m_plots->setDirection(arePlotsBeside ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    constexpr int kLettersOfPlot = 14;
    for (CurvePlot* plot : {m_correction, m_squeeze})
        plot->setMinimumSize(kLettersOfPlot * QFontInfo(font()).pixelSize(), static_cast<int>(line * kLinesOfPlot));
    m_board->setMinimumSize(m_inARow ? QSize(kNarrowestBoard, 0) : QSize(0, boardHeight));
    m_board->setMaximumSize(m_inARow ? QSize(kWidestBoard, QWIDGETSIZE_MAX) : QSize(QWIDGETSIZE_MAX, boardHeight));
}

void CurvesPanel::showCurves()
{
    const double m = fraction();
    const double n = spaceFraction(m, m_input.z1, m_input.z2);
    m_correction->setFigure(
        {.title = tr("Perspective correction n(m)"),
         .xName = tr("m, on the screen"),
         .yName = tr("n, in space"),
         .diagonalName = tr("affine"),
         .curveName = QStringLiteral("z1 %1, z2 %2").arg(shortNumber(m_input.z1), shortNumber(m_input.z2)),
         .low = 0,
         .high = 1,
         .points = points(spaceFractionCurve(m_input.z1, m_input.z2, kCurvePoints)),
         .mark = {m, n},
         .markText = QStringLiteral("n = %1").arg(fixed(n))});

    const double z = fourZ(m_input.near, m_input.far, m_input.z1, m_input.z2, m).view.truth;
    const double squeezed = squeezedDepth(z, m_input.near, m_input.far);
    m_squeeze->setFigure({.title = tr("z' = n + f \u2212 nf / z"),
                          .xName = tr("z, distance"),
                          .yName = tr("z'"),
                          .diagonalName = tr("z' = z"),
                          .curveName = {},
                          .low = m_input.near,
                          .high = m_input.far,
                          .points = points(squeezedDepthCurve(m_input.near, m_input.far, kCurvePoints)),
                          .mark = {z, squeezed},
                          .markText = QStringLiteral("z %1 \u2192 %2").arg(shortNumber(z), shortNumber(squeezed))});
}

void CurvesPanel::paintBoard(QPainter& painter, const QRectF& where) const
{
    const Inks inks = inksFor(palette());
    const QColor text = palette().color(QPalette::Text);
    const QColor muted = palette().color(QPalette::PlaceholderText);
    painter.setFont(textFont(0, true));
    painter.setPen(text);
    painter.drawText(where, Qt::AlignLeft | Qt::AlignTop, tr("Four-z board"));
    const double line = QFontMetricsF(painter.font()).lineSpacing();
    painter.setFont(textFont(-1));
    painter.setPen(muted);
    painter.drawText(where.adjusted(0, line + 1, 0, 0), Qt::AlignLeft | Qt::AlignTop,
                     QStringLiteral("n = %1   f = %2   z %3 \u2026 %4   m = %5")
                         .arg(shortNumber(m_input.near), shortNumber(m_input.far), shortNumber(m_input.z1),
                              shortNumber(m_input.z2), shortNumber(fraction())));
    const double column = (where.width() - 8) / 3;
    const double row = std::clamp((where.height() - 2.4 * line) / 7, line * 0.95, line * 1.45);
    double y = where.top() + 2.4 * line;
    const auto cell = [&](int i, const QString& content, const QColor& color, bool bold) {
        painter.setPen(color);
        QFont font = i == 0 ? textFont(bold ? 0 : -1, bold) : numberFont(-0.5);
        font.setBold(bold);
        painter.setFont(font);
        const QRectF box(where.left() + i * column, y, column, row);
        painter.drawText(box, static_cast<int>((i == 0 ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter), content);
    };
    const auto heading = [&](int i, const QString& content) {
        painter.setPen(text);
        painter.setFont(textFont(-1, true));
        painter.drawText(QRectF(where.left() + i * column, y, column, row), Qt::AlignRight | Qt::AlignVCenter, content);
    };
    heading(1, tr("NDC z"));
    heading(2, tr("distance z"));
    y += row;
    // z/w is linear on the screen, the distance is not: each has one right column.
    const QString names[] = {tr("truth"), tr("linear"), tr("  error"), tr("\"corrected\""), tr("  error")};
    for (int i = 0; i < 5; ++i) {
        if (i == 1 || i == 3) {
            painter.setPen(palette().color(QPalette::Mid));
            painter.drawLine(QPointF(where.left(), y), QPointF(where.right(), y));
        }
        cell(0, names[i], i == 0 ? text : muted, i == 0);
        for (int which = 0; which < 2; ++which) {
            const bool right = i == 0 || (which == 0) == (i <= 2);
            cell(1 + which, boardText(which, i), i == 0 ? text : right ? inks.plus : inks.minus, i == 0);
        }
        y += row;
    }
}

void CurvesPanel::retranslate()
{
    const QSignalBlocker blocked(m_edge);
    m_edge->setItemText(0, tr("Edge AB"));
    m_edge->setItemText(1, tr("Edge BC"));
    m_edge->setItemText(2, tr("Edge CA"));
    m_edge->setItemText(kTextbook, tr("Textbook: n .1, f 50, z 1..10"));
    m_edge->setAccessibleName(tr("Edge"));
    m_slider->setAccessibleName(tr("Fraction of the way on the screen"));
    m_slider->setToolTip(m_slider->accessibleName());
    choose();
}

void CurvesPanel::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange)
        arrange();
    QWidget::changeEvent(event);
}

void CurvesPanel::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    arrange();
}

} // namespace rasterlens
