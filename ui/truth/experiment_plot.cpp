#include "ui/truth/experiment_plot.h"

#include "ui/base/inks.h"
#include "ui/base/plot_theme.h"

#include <QApplication>
#include <QEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPicture>
#include <QPixmap>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace rasterlens
{
namespace
{

/// The dots of an algorithm, or of renderers that are not ours.
struct DotLook {
    std::optional<Algorithm> algorithm;
    QCPScatterStyle::ScatterShape shape;
    QColor Inks::*ink;
};
constexpr auto kDotLooks = std::to_array<DotLook>({
    {Algorithm::EdgeEquation, QCPScatterStyle::ssCircle, &Inks::plus},
    {Algorithm::EdgeWalking, QCPScatterStyle::ssSquare, &Inks::minus},
    {Algorithm::Tiled, QCPScatterStyle::ssTriangle, &Inks::third},
    {std::nullopt, QCPScatterStyle::ssDiamond, nullptr},
});
constexpr double kDotSize = 8;
constexpr int kLabelGap = 7; ///< pixels round a name

std::size_t lookOf(const ExperimentRow& row)
{
    const auto algorithm = row.other ? std::nullopt : std::optional(row.settings.algorithm);
    return static_cast<std::size_t>(std::ranges::find(kDotLooks, algorithm, &DotLook::algorithm) - kDotLooks.begin());
}

QColor colorOf(const DotLook& look, const QPalette& palette)
{
    return look.ink != nullptr ? inksFor(palette).*look.ink : palette.color(QPalette::Text);
}

/// Powers of ten, and a 0 where errors of zero are shown.
class ErrorTicker : public QCPAxisTickerLog
{
public:
    void setZero(std::optional<double> place) { m_zero = place; }

protected:
    QString getTickLabel(double tick, const QLocale& locale, QChar format, int precision) override
    {
        if (m_zero && tick < *m_zero * 1.001)
            return QStringLiteral("0");
        return QCPAxisTickerLog::getTickLabel(tick, locale, format, precision);
    }

    QVector<double> createTickVector(double step, const QCPRange& range) override
    {
        QVector<double> ticks = QCPAxisTickerLog::createTickVector(step, range);
        if (!m_zero)
            return ticks;
        const double zero = *m_zero;
        ticks.erase(std::remove_if(ticks.begin(), ticks.end(), [zero](double t) { return t < zero * 9.9; }),
                    ticks.end());
        ticks.prepend(zero);
        return ticks;
    }

    QVector<double> createSubTickVector(int count, const QVector<double>& ticks) override
    {
        QVector<double> between = QCPAxisTickerLog::createSubTickVector(count, ticks);
        if (m_zero) {
            const double border = *m_zero * 9.9;
            between.erase(std::remove_if(between.begin(), between.end(), [border](double t) { return t < border; }),
                          between.end());
        }
        return between;
    }

private:
    std::optional<double> m_zero;
};

QString titleOfLook(const DotLook& look)
{
    if (!look.algorithm)
        return QCoreApplication::translate("Experiment", "other renderers");
    const SettingsField* field = findSettingsField(QStringLiteral("algorithm"));
    return QCoreApplication::translate("Settings", field->choices[static_cast<std::size_t>(*look.algorithm)].title);
}

} // namespace

Speed speedOf(const ExperimentRow& row, SpeedMeasure measure)
{
    const double low = row.ms.p10 / row.ms.median;
    const double high = row.ms.p90 / row.ms.median;
    if (measure == SpeedMeasure::NsPerCoveredPixel)
        return {row.nsPerCoveredPixel, row.nsPerCoveredPixel * low, row.nsPerCoveredPixel * high};
    return {row.mtriPerS, row.mtriPerS / high, row.mtriPerS / low};
}

QString titleOf(const ExperimentRow& row)
{
    if (row.other)
        return row.other->name;
    const Variant* variant = findVariant(row.variant);
    const auto translated = [](const char* text) { return QCoreApplication::translate("Settings", text); };
    return variant != nullptr ? titleOf(*variant, translated) : row.variant;
}

QPixmap dotMark(const ExperimentRow& row)
{
    constexpr int kSharper = 3;
    constexpr int kSide = static_cast<int>(kDotSize) + 4;
    const DotLook& look = kDotLooks[lookOf(row)];
    QPixmap mark(kSide * kSharper, kSide * kSharper);
    mark.setDevicePixelRatio(kSharper);
    mark.fill(Qt::transparent);
    QCPPainter painter(&mark);
    painter.setAntialiasing(true);
    const QColor color = colorOf(look, QApplication::palette());
    const QCPScatterStyle style(look.shape, QPen(color), QBrush(color), kDotSize);
    style.applyTo(&painter, style.pen());
    style.drawShape(&painter, QPointF(kSide, kSide) / 2);
    return mark;
}

QString speedTitle(SpeedMeasure measure)
{
    return measure == SpeedMeasure::NsPerCoveredPixel
               ? QCoreApplication::translate("Experiment", "ns per covered pixel")
               : QCoreApplication::translate("Experiment", "million triangles a second");
}

QString errorTitle(ErrorMeasure measure) { return QCoreApplication::translate("Experiment", infoOf(measure).title); }

ExperimentPlot::ExperimentPlot(QWidget* parent) : QWidget(parent), m_plot(new QCustomPlot)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_plot);
    for (QCPAxis* axis : {m_plot->xAxis, m_plot->yAxis}) {
        axis->setScaleType(QCPAxis::stLogarithmic);
        axis->setNumberFormat(QStringLiteral("gb"));
        axis->setNumberPrecision(2);
    }
    m_plot->xAxis->setTicker(QSharedPointer<QCPAxisTicker>(new ErrorTicker));
    m_plot->yAxis->setTicker(QSharedPointer<QCPAxisTicker>(new QCPAxisTickerLog));
    for (std::size_t look = 0; look < kDotLooks.size(); ++look)
        for (const bool frontier : {true, false}) {
            QCPGraph* graph = m_plot->addGraph();
            graph->setLineStyle(QCPGraph::lsNone);
            auto* bars = new QCPErrorBars(m_plot->xAxis, m_plot->yAxis);
            bars->removeFromLegend();
            bars->setDataPlottable(graph);
            m_series.push_back({look, frontier, graph, bars});
        }
    m_sentence = new QCPItemText(m_plot);
    m_sentence->position->setType(QCPItemPosition::ptAxisRectRatio);
    m_sentence->position->setCoords(0.5, 0.5);
    m_sentence->setPositionAlignment(Qt::AlignCenter);
    m_ring = m_plot->addGraph();
    m_ring->setLineStyle(QCPGraph::lsNone);
    m_ring->removeFromLegend();
    putLegendAbove(*m_plot);
    m_plot->installEventFilter(this);
    m_plot->setMouseTracking(true);
    applyColors();
}

void ExperimentPlot::setRows(const std::vector<ExperimentRow>& rows, ErrorMeasure error, SpeedMeasure speed)
{
    m_error = error;
    m_speed = speed;
    takeDots(rows);
    draw();
}

void ExperimentPlot::takeDots(const std::vector<ExperimentRow>& rows)
{
    double smallest = std::numeric_limits<double>::infinity();
    m_hasZero = false;
    for (const ExperimentRow& row : rows)
        if (const auto error = errorOf(row, m_error); error && row.ms.frames > 0) {
            m_hasZero |= *error == 0;
            if (*error > 0)
                smallest = std::min(smallest, *error);
        }
    m_zeroPlace = std::isinf(smallest) ? 0.1 : std::pow(10, std::floor(std::log10(smallest)) - 1);
    m_dots.clear();
    m_sentence->setVisible(isExactThroughout(rows, m_error));
    if (m_sentence->visible())
        return;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto error = errorOf(rows[i], m_error);
        if (!error || rows[i].ms.frames == 0)
            continue;
        const Speed speed = speedOf(rows[i], m_speed);
        m_dots.push_back({static_cast<int>(i), *error > 0 ? *error : m_zeroPlace, speed.median, speed.low, speed.high,
                          lookOf(rows[i]), rows[i].frontier, titleOf(rows[i])});
    }
}

void ExperimentPlot::setRanges()
{
    double left = std::numeric_limits<double>::infinity();
    double right = 0;
    double bottom = std::numeric_limits<double>::infinity();
    double top = 0;
    for (const Dot& dot : m_dots) {
        left = std::min(left, dot.x);
        right = std::max(right, dot.x);
        bottom = std::min(bottom, dot.low);
        top = std::max(top, dot.high);
    }
    if (m_dots.empty()) {
        left = bottom = 0.1;
        right = top = 10;
    }
    constexpr double kRoom = 1.6;
    m_plot->xAxis->setRange(left / kRoom, std::max(right, left * 10) * kRoom);
    top = std::max(top, bottom * 2);
    constexpr double kShare = 0.12; // of the height: names stand beside the lowest dots
    const double room = std::pow(top / bottom, kShare) * 1.1;
    m_plot->yAxis->setRange(bottom / room, top * room);
}

void ExperimentPlot::draw()
{
    // Dots keep the order of the rows; a graph wants them from left to right.
    std::vector<const Dot*> sorted;
    for (const Dot& dot : m_dots)
        sorted.push_back(&dot);
    std::ranges::stable_sort(sorted, {}, [](const Dot* dot) { return dot->x; });
    for (const Series& series : m_series) {
        series.graph->data()->clear();
        series.bars->data()->clear();
        for (const Dot* dot : sorted)
            if (dot->look == series.look && dot->frontier == series.frontier) {
                series.graph->addData(dot->x, dot->y);
                series.bars->addData(dot->y - dot->low, dot->high - dot->y);
            }
        series.graph->setName(titleOfLook(kDotLooks[series.look]));
        const auto hasLook = [&](const Dot& dot) { return dot.look == series.look; };
        series.graph->removeFromLegend();
        if (series.frontier && (kDotLooks[series.look].algorithm || std::ranges::any_of(m_dots, hasLook)))
            series.graph->addToLegend();
    }
    m_sentence->setText(
        QCoreApplication::translate("Experiment", "Every variant is exact here:\nall of these errors are 0."));
    setRanges();
    m_plot->xAxis->setLabel(errorTitle(m_error));
    m_plot->yAxis->setLabel(speedTitle(m_speed));
    qSharedPointerCast<ErrorTicker>(m_plot->xAxis->ticker())
        ->setZero(m_hasZero ? std::optional(m_zeroPlace) : std::nullopt);
    setChosen(m_chosen);
}

/// Names the chosen dot, and those that are not beaten from the lowest on, as far as no name covers another or a dot
/// that has one.
void ExperimentPlot::drawLabels()
{
    for (QCPItemText* label : m_labels)
        m_plot->removeItem(label);
    m_labels.clear();
    std::vector<const Dot*> named;
    for (const Dot& dot : m_dots)
        if (dot.frontier && dot.row != m_chosen)
            named.push_back(&dot);
    std::ranges::stable_sort(named, {}, [](const Dot* dot) { return dot->y; });
    if (m_speed == SpeedMeasure::MtriPerS)
        std::ranges::reverse(named); // the fastest first
    for (const Dot& dot : m_dots)
        if (dot.row == m_chosen)
            named.insert(named.begin(), &dot);
    std::vector<QRectF> taken; // by these dots, and by their names
    for (const Dot* dot : named) {
        const QPointF at(m_plot->xAxis->coordToPixel(dot->x), m_plot->yAxis->coordToPixel(dot->y));
        taken.emplace_back(at - QPointF(kDotSize, kDotSize) / 2, QSizeF(kDotSize, kDotSize));
    }
    for (const Dot* dot : named)
        if (const auto place = labelPlace(*dot, taken)) {
            taken.push_back(place->area);
            auto* label = new QCPItemText(m_plot);
            label->setClipToAxisRect(false);
            label->position->setCoords(dot->x, dot->y);
            label->setPositionAlignment(place->alignment);
            label->setPadding(QMargins(kLabelGap, kLabelGap / 2, kLabelGap, kLabelGap / 2));
            label->setText(place->text);
            label->setFont(font());
            label->setColor(palette().color(QPalette::Text));
            m_labels.push_back(label);
        }
}

/// Beside the dot, above or below it, as there is room; nothing where there is none.
std::optional<ExperimentPlot::LabelPlace> ExperimentPlot::labelPlace(const Dot& dot,
                                                                     const std::vector<QRectF>& taken) const
{
    constexpr int kWidest = 230;
    const QFontMetrics metrics(font());
    const QPointF at(m_plot->xAxis->coordToPixel(dot.x), m_plot->yAxis->coordToPixel(dot.y));
    const QString changes = dot.name.section(QStringLiteral("; "), 1); // the mark tells the algorithm
    const QString text = metrics.elidedText(changes.isEmpty() ? dot.name : changes, Qt::ElideRight, kWidest);
    const QSizeF size(metrics.horizontalAdvance(text) + 2 * kLabelGap, metrics.height() + kLabelGap);
    for (const Qt::Alignment alignment :
         {Qt::AlignLeft | Qt::AlignVCenter, Qt::AlignRight | Qt::AlignVCenter, Qt::AlignLeft | Qt::AlignBottom,
          Qt::AlignRight | Qt::AlignBottom, Qt::AlignLeft | Qt::AlignTop, Qt::AlignRight | Qt::AlignTop}) {
        const double left = alignment.testFlag(Qt::AlignLeft) ? 0 : size.width();
        const double up = alignment.testFlag(Qt::AlignTop)      ? 0
                          : alignment.testFlag(Qt::AlignBottom) ? size.height()
                                                                : size.height() / 2;
        const QRectF area = QRectF(at - QPointF(left, up), size).adjusted(kLabelGap, 0, -kLabelGap, 0);
        const bool isFree = std::ranges::none_of(taken, [&](const QRectF& other) { return other.intersects(area); });
        if (isFree && QRectF(m_plot->axisRect()->rect()).contains(area))
            return LabelPlace{text, alignment, area};
    }
    return std::nullopt;
}

QStringList ExperimentPlot::labels() const
{
    QStringList texts;
    for (const QCPItemText* label : m_labels)
        texts << label->text();
    return texts;
}

QString ExperimentPlot::sentence() const { return m_sentence->visible() ? m_sentence->text() : QString(); }

void ExperimentPlot::setChosen(std::optional<int> row)
{
    m_chosen = row;
    m_ring->data()->clear();
    for (const Dot& dot : m_dots)
        if (row && dot.row == *row)
            m_ring->addData(dot.x, dot.y);
    drawLabels();
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

std::optional<QPointF> ExperimentPlot::placeOf(int row) const
{
    for (const Dot& dot : m_dots)
        if (dot.row == row)
            return QPointF(m_plot->xAxis->coordToPixel(dot.x), m_plot->yAxis->coordToPixel(dot.y));
    return std::nullopt;
}

std::optional<int> ExperimentPlot::rowAt(QPointF point) const
{
    constexpr double kReach = 12;
    std::optional<int> nearest;
    double least = kReach;
    for (const Dot& dot : m_dots) {
        const QPointF to(m_plot->xAxis->coordToPixel(dot.x), m_plot->yAxis->coordToPixel(dot.y));
        const double distance = std::hypot(to.x() - point.x(), to.y() - point.y());
        if (distance < least) {
            least = distance;
            nearest = dot.row;
        }
    }
    return nearest;
}

bool ExperimentPlot::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == m_plot && event->type() == QEvent::MouseButtonPress) {
        const auto* mouse = static_cast<QMouseEvent*>(event);
        const auto row = rowAt(mouse->position());
        if (row && mouse->button() == Qt::LeftButton)
            Q_EMIT rowClicked(*row);
        return true;
    }
    if (watched == m_plot && event->type() == QEvent::MouseMove) {
        const auto* mouse = static_cast<QMouseEvent*>(event);
        const auto row = rowAt(mouse->position());
        m_plot->setCursor(row ? Qt::PointingHandCursor : Qt::ArrowCursor);
        Q_EMIT rowHovered(row.value_or(-1), mouse->globalPosition().toPoint());
    }
    return QWidget::eventFilter(watched, event);
}

void ExperimentPlot::applyColors()
{
    const QColor text = palette().color(QPalette::Text);
    applyPlotTheme(*m_plot, palette());
    for (const Series& series : m_series) {
        const DotLook& look = kDotLooks[series.look];
        const QColor color = colorOf(look, palette());
        const QColor ground = palette().color(QPalette::Base);
        series.graph->setScatterStyle(QCPScatterStyle(look.shape, QPen(series.frontier ? ground : color, 1),
                                                      QBrush(series.frontier ? color : ground), kDotSize));
        series.graph->setPen(QPen(color));
        QColor faint = color;
        faint.setAlpha(150);
        series.bars->setPen(QPen(faint, 1));
        series.bars->setWhiskerWidth(4);
    }
    m_sentence->setColor(text);
    m_sentence->setFont(font());
    m_ring->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssCircle, QPen(text, 2), Qt::NoBrush, kDotSize + 7));
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void ExperimentPlot::paintTo(QPainter& painter, QSize size)
{
    // QCustomPlot draws with a painter of its own kind; a picture hands it on without losing lines for pixels.
    QPicture picture;
    QCPPainter recorder(&picture);
    m_plot->toPainter(&recorder, size.width(), size.height());
    recorder.end();
    painter.fillRect(QRect(QPoint(0, 0), size), palette().color(QPalette::Base));
    painter.drawPicture(0, 0, picture);
}

void ExperimentPlot::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    m_plot->replot(QCustomPlot::rpImmediateRefresh); // lays the axes out, by which names are placed
    drawLabels();
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void ExperimentPlot::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    switch (event->type()) {
    case QEvent::PaletteChange:
    case QEvent::FontChange:
    case QEvent::StyleChange: applyColors(); break;
    case QEvent::LanguageChange: draw(); break;
    default: break;
    }
}

} // namespace rasterlens
