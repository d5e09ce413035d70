#include "ui/steps/step_listing.h"

#include "ui/base/theme.h"
#include "ui/steps/code_line.h"
#include "ui/steps/step_session.h"

#include <QEvent>
#include <QLabel>
#include <QPainter>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace rasterlens
{
namespace
{

constexpr double kLeastScale = 0.75;            ///< of code beside the canvas; longer lines are broken into rows
constexpr int kNarrow = 480;                    ///< width below which a formula has a row more
constexpr int kCompactBelow = 560;              ///< height of the canvas card from which on the whole listing has room
const QString kBetween = QStringLiteral("   "); ///< what stands between the parts of a formula

/// Where the first row of a line ends: before the last part that has room, else before the last word that has; -1: the
/// first word has no room.
qsizetype endOfRow(const QString& line, const QFontMetrics& metrics, int room, const QStringList& breaks)
{
    for (const QString& between : breaks) {
        qsizetype end = -1;
        for (qsizetype at = line.indexOf(between, 1); at > 0 && metrics.horizontalAdvance(line.left(at)) <= room;
             at = line.indexOf(between, at + between.size()))
            end = at;
        if (end > 0)
            return end;
    }
    return -1;
}

/// Breaks a line at the first of `breaks` that it has, as late as there is room.
QStringList wrapped(QString line, const QFontMetrics& metrics, int room, const QStringList& breaks)
{
    QStringList rows;
    while (metrics.horizontalAdvance(line) > room) {
        const qsizetype end = endOfRow(line, metrics, room, breaks);
        if (end < 0)
            break;
        rows << line.left(end);
        line = line.sliced(end).trimmed();
    }
    return rows << line;
}

/// A formula in at most `most` rows; what is left over stands behind the last one, which ends in dots then. If rows are
/// to be filled, they end before any word, and else where a part ends if there is such a place.
QStringList rowsOf(QString formula, const QFontMetrics& metrics, int room, int most, bool filled)
{
    const QString word = QStringLiteral(" ");
    QStringList rows;
    if (filled)
        rows = wrapped(formula.replace(QLatin1Char('\n'), kBetween), metrics, room, {word});
    else
        for (const QString& line : formula.split(QLatin1Char('\n')))
            rows << wrapped(line, metrics, room, {kBetween, word});
    while (rows.size() > most) {
        const QString last = rows.takeLast();
        rows.last() += kBetween + last;
    }
    return rows;
}

bool fits(const QStringList& rows, const QFontMetrics& metrics, int room)
{
    return std::ranges::all_of(rows, [&](const QString& row) { return metrics.horizontalAdvance(row) <= room; });
}

} // namespace

/// The legend of the lens, on a plate of its own.
class LegendView : public QWidget
{
public:
    LegendView() { setObjectName(QStringLiteral("lensLegend")); }

    void setLegend(const std::optional<LensLegend>& legend)
    {
        m_legend = legend;
        if (legend)
            setFixedSize(legend->size().toSize() + QSize(2, 2));
        update();
    }
    [[nodiscard]] bool hasLegend() const { return m_legend.has_value(); }

protected:
    void paintEvent(QPaintEvent* /*event*/) override
    {
        if (!m_legend)
            return;
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        m_legend->paint(painter, QRectF(QPointF(0.5, 0.5), m_legend->size()));
    }

private:
    std::optional<LensLegend> m_legend;
};

StepListing::StepListing(const StepSession& session, QWidget* parent) : QFrame(parent), m_session(session)
{
    setObjectName(QStringLiteral("stepListing"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(10, 3, 10, 3);
    column->setSpacing(0);
    for (std::size_t i = 0; i < std::tuple_size_v<Listing>; ++i) {
        m_lines.push_back(new CodeLine);
        column->addWidget(m_lines.back());
    }
    m_formula = new QLabel;
    m_formula->setObjectName(QStringLiteral("stepFormula"));
    m_formula->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_formula->setForegroundRole(QPalette::Link);
    m_formula->setTextFormat(Qt::PlainText);
    m_formula->setContentsMargins(4, 2, 0, 0);
    m_formula->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_formula->setFocusPolicy(Qt::NoFocus);
    column->addWidget(m_formula);
    m_legend = new LegendView;
    column->addWidget(m_legend, 0, Qt::AlignLeft);
    column->addStretch(0);
    connect(&session, &StepSession::positionChanged, this, &StepListing::sync);
    connect(&session, &StepSession::openChanged, this, [this](bool open) {
        setVisible(open);
        sync();
    });
    hide();
}

void StepListing::setPlace(Place place)
{
    m_place = place;
    auto* column = static_cast<QVBoxLayout*>(layout());
    column->setStretch(column->count() - 1, place == Place::Beside ? 1 : 0);
    sync();
    Q_EMIT roomChanged();
}

void StepListing::setLegend(const std::optional<LensLegend>& legend)
{
    m_legend->setLegend(hasRoomForLegend() ? legend : std::nullopt);
    m_legend->setVisible(m_legend->hasLegend());
    fitFormula();
}

/// By the height alone, so that the legend stays in its place from step to step: the code has up to eight rows.
bool StepListing::hasRoomForLegend() const
{
    constexpr int kRows = 20; // of code, formula and legend
    return m_place == Place::Beside && isVisible() && height() >= kRows * lineHeight();
}

int StepListing::legendHeight() const { return m_legend->hasLegend() ? m_legend->height() : 0; }

void StepListing::setNextPConcealed(bool on)
{
    if (std::exchange(m_isNextPConcealed, on) != on)
        sync();
}

void StepListing::sync()
{
    m_explanation = {};
    if (m_session.isOpen() && m_session.log() && m_session.position() > 0)
        m_explanation = explainStep(*m_session.log(), m_session.positionInLog() - 1);
    const StepEvent* event = m_session.event();
    if (m_isNextPConcealed && event && event->kind == StepKind::LineDecision)
        m_explanation.formula = m_explanation.formula.section(QLatin1Char('\n'), 0, -2);
    const bool isCompact = m_place == Place::Below && parentWidget()->height() < kCompactBelow;
    double scale = 1;
    if (m_place == Place::Beside)
        for (const ListingLine& line : m_explanation.listing)
            scale = std::min(scale, CodeLine::scaleFor(line.code, codeWidth(), kLeastScale));
    // The canvas above keeps its height: there are as many lines at every step, all of one height.
    const int kept = std::clamp(m_explanation.line, 0, int(m_lines.size()) - 1);
    for (std::size_t i = 0; i < m_lines.size(); ++i) {
        CodeLine& line = *m_lines[i];
        line.setScale(scale);
        line.setWrapped(m_place == Place::Beside);
        line.setVisible(m_place != Place::Line && (int(i) == kept || !isCompact));
        line.setLine(m_explanation.listing[i], int(i) == m_explanation.line);
        int rows = 1;
        if (m_place == Place::Beside) {
            const CodeLine::Rows all = line.rowsFor(codeWidth());
            rows = int(all.code.size() + all.right.size());
        }
        line.setFixedHeight(rows * lineHeight());
    }
    fitFormula();
}

int StepListing::codeWidth() const
{
    const QMargins around = layout()->contentsMargins();
    return width() - around.left() - around.right();
}

/// Room for digits and for the taller signs of other scripts.
int StepListing::lineHeight()
{
    constexpr int kAir = 2;
    return std::max(QFontMetrics(numberFont(-0.5)).height(), QFontMetrics(textFont(-0.5)).height()) + kAir;
}

/// With a mistake on there is a row more, for its name: at every step of the record. Where the canvas is narrow, as on
/// a small projector, there is one more. Beside the canvas there are as many as the code leaves.
int StepListing::formulaRowCount() const
{
    if (m_place == Place::Line)
        return 1;
    const bool hasMistakes = m_session.log() && !m_session.log()->mistakes().empty();
    const int usual = hasMistakes ? 3 : 2;
    if (m_place != Place::Beside)
        return usual + (width() < kNarrow ? 1 : 0);
    int code = 0;
    for (const CodeLine* line : m_lines)
        code += line->minimumHeight(); // which the layout follows later
    const QMargins around = layout()->contentsMargins() + m_formula->contentsMargins();
    const int room = height() - around.top() - around.bottom() - code - legendHeight();
    return std::clamp(room / lineHeight(), usual, 3 * usual);
}

/// Long formulas are broken into rows, then made smaller, then the rows are filled, and they end in dots at last; the
/// tool tip has all of them.
void StepListing::fitFormula()
{
    const QMargins around = layout()->contentsMargins() + m_formula->contentsMargins();
    const int room = width() - around.left() - around.right();
    const int most = formulaRowCount();
    QFont font = numberFont(-0.5);
    const double full = font.pointSizeF();
    QStringList rows;
    constexpr std::pair<double, bool> kTries[]{{1.0, false}, {0.9, false}, {0.8, false}, {0.8, true}};
    for (const auto& [size, isFilled] : kTries) {
        font.setPointSizeF(full * size);
        rows = rowsOf(m_explanation.formula, QFontMetrics(font), room, most, isFilled);
        if (fits(rows, QFontMetrics(font), room))
            break;
    }
    for (QString& row : rows)
        row = QFontMetrics(font).elidedText(row, Qt::ElideRight, room);
    while (rows.size() < most)
        rows << QString();
    m_formula->setFont(font);
    m_formula->setFixedHeight(most * lineHeight() + 2);
    m_formula->setText(rows.join(QLatin1Char('\n')));
    m_formula->setToolTip(m_explanation.formula);
}

QStringList StepListing::formulaRows() const { return m_formula->text().split(QLatin1Char('\n')); }

void StepListing::resizeEvent(QResizeEvent* event)
{
    QFrame::resizeEvent(event);
    if (m_place == Place::Beside)
        sync();
    else
        fitFormula();
    Q_EMIT roomChanged();
}

QSize StepListing::minimumSizeHint() const
{
    int shown = 0;
    for (const CodeLine* line : m_lines)
        shown += line->isHidden() ? 0 : 1;
    return QFrame::minimumSizeHint() - QSize(0, std::max(shown - 1, 0) * lineHeight());
}

void StepListing::showEvent(QShowEvent* event)
{
    parentWidget()->installEventFilter(this);
    QFrame::showEvent(event);
    Q_EMIT roomChanged();
}

void StepListing::hideEvent(QHideEvent* event)
{
    QFrame::hideEvent(event);
    Q_EMIT roomChanged();
}

bool StepListing::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == parentWidget() && event->type() == QEvent::Resize)
        sync();
    return QFrame::eventFilter(watched, event);
}

void StepListing::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange) {
        sync();
        Q_EMIT roomChanged(); // the legend has words
    }
    QFrame::changeEvent(event);
}

} // namespace rasterlens
