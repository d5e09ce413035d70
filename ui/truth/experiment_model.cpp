#include "ui/truth/experiment_model.h"

#include "ui/base/theme.h"

#include <QCoreApplication>

#include <limits>

namespace rasterlens
{
namespace
{

QString number(double value)
{
    constexpr double kWhole = 100;
    return value >= kWhole && value < 1e6 ? QString::number(value, 'f', 0) : QString::number(value, 'g', 3);
}

/// `1.13 (1.10 .. 1.19)`: median and range.
QString withRange(double median, double low, double high)
{
    return QStringLiteral("%1 (%2 \u2026 %3)").arg(median, 0, 'g', 3).arg(low, 0, 'g', 3).arg(high, 0, 'g', 3);
}

QString tieRuleOf(const RendererTraits& traits)
{
    switch (traits.sides) {
    case OwnedSides::TopLeft: return ExperimentModel::tr("tie rule: top-left");
    case OwnedSides::TopRight: return ExperimentModel::tr("tie rule: top-right");
    case OwnedSides::BottomLeft: return ExperimentModel::tr("tie rule: bottom-left");
    case OwnedSides::BottomRight: return ExperimentModel::tr("tie rule: bottom-right");
    case OwnedSides::All: return ExperimentModel::tr("tie rule: all edges own their points");
    case OwnedSides::None: return ExperimentModel::tr("tie rule: no edge owns its points");
    case OwnedSides::Other: break;
    }
    return ExperimentModel::tr("tie rule: none that is known");
}

QString traitLines(const RendererTraits& traits)
{
    const QString step = traits.orMore ? ExperimentModel::tr("corners snap to 1/%1 pixel or finer")
                                       : ExperimentModel::tr("corners snap to 1/%1 pixel");
    return QStringLiteral("\n%1\n%2").arg(step.arg(1 << traits.subpixelBits), tieRuleOf(traits));
}

} // namespace

void ExperimentModel::setRows(const std::vector<ExperimentRow>& rows, ErrorMeasure error, SpeedMeasure speed)
{
    const bool sameRows = rows.size() == m_rows.size();
    m_error = error;
    m_speed = speed;
    if (!sameRows)
        beginResetModel();
    m_rows = rows;
    if (!sameRows) {
        endResetModel();
    } else if (!rows.empty()) {
        Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
        Q_EMIT headerDataChanged(Qt::Horizontal, 0, ColumnCount - 1);
    }
}

QString ExperimentModel::describe(const ExperimentRow& row)
{
    QString text =
        QStringLiteral("<p style='white-space: pre'><b>%1</b>").arg(rasterlens::titleOf(row).toHtmlEscaped());
    if (row.other)
        text += traitLines(row.other->traits);
    for (int i = 0; i < kErrorMeasures; ++i) {
        const auto measure = static_cast<ErrorMeasure>(i);
        if (const auto error = errorOf(row, measure))
            text += QStringLiteral("\n%1: %2").arg(errorTitle(measure)).arg(*error, 0, 'g', 3);
    }
    if (row.ms.frames == 0)
        return text + QStringLiteral("</p>");
    for (const SpeedMeasure measure : {SpeedMeasure::NsPerCoveredPixel, SpeedMeasure::MtriPerS}) {
        const rasterlens::Speed speed = speedOf(row, measure);
        text += QStringLiteral("\n%1: %2").arg(speedTitle(measure), withRange(speed.median, speed.low, speed.high));
    }
    text += QStringLiteral("\n") +
            tr("milliseconds of the clock: %1").arg(withRange(row.ms.median, row.ms.p10, row.ms.p90));
    text +=
        QStringLiteral("\n") + tr("milliseconds of the processor, all threads: %1").arg(row.ms.processor, 0, 'g', 3);
    if (row.ratio)
        text += QStringLiteral("\n") + tr("times as long as the first variant: %1, in %2 pairs of frames")
                                           .arg(withRange(row.ratio->median, row.ratio->p10, row.ratio->p90))
                                           .arg(row.ratio->pairs);
    if (row.ms.batch > 1)
        text += QStringLiteral("\n") + tr("timed in batches of %1 frames").arg(row.ms.batch);
    return text + QStringLiteral("</p>");
}

int ExperimentModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int ExperimentModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : ColumnCount; }

QString ExperimentModel::textAt(const ExperimentRow& row, int column) const
{
    switch (column) {
    case Name: return rasterlens::titleOf(row);
    case Speed: return row.ms.frames > 0 ? number(speedOf(row, m_speed).median) : QStringLiteral("\u2026");
    case Ratio: return row.ratio ? QString::number(row.ratio->median, 'f', 2) : QString();
    case Processor: return row.ms.frames > 0 ? number(row.ms.processor) : QString();
    case Error: {
        const auto error = errorOf(row, m_error);
        return error ? number(*error) : QStringLiteral("\u2013");
    }
    case Frontier: return row.frontier ? QStringLiteral("\u2605") : QString();
    default: return {};
    }
}

QVariant ExperimentModel::sortKey(const ExperimentRow& row, int column) const
{
    constexpr double kLast = std::numeric_limits<double>::infinity();
    switch (column) {
    case Speed: return row.ms.frames > 0 ? speedOf(row, m_speed).median : kLast;
    case Ratio: return row.ratio ? row.ratio->median : 1;
    case Processor: return row.ms.frames > 0 ? row.ms.processor : kLast;
    case Error: return errorOf(row, m_error).value_or(kLast);
    case Frontier: return row.frontier ? 0 : 1;
    default: return rasterlens::titleOf(row);
    }
}

QVariant ExperimentModel::data(const QModelIndex& index, int role) const
{
    const ExperimentRow& row = m_rows[static_cast<std::size_t>(index.row())];
    switch (role) {
    case Qt::DisplayRole: return textAt(row, index.column());
    case SortRole: return sortKey(row, index.column());
    case Qt::DecorationRole: return index.column() == Name ? dotMark(row) : QVariant();
    case Qt::TextAlignmentRole:
        return QVariant::fromValue((index.column() == Name ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    case Qt::ToolTipRole: return describe(row);
    case Qt::FontRole: return row.frontier ? textFont(0, true) : QVariant();
    default: return {};
    }
}

QVariant ExperimentModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::ToolTipRole && section == Frontier)
        return tr("On the frontier: no variant with as small an error was faster in nine of ten rounds");
    if (role == Qt::ToolTipRole && section == Ratio)
        return tr(
            "How many times as long as the first variant in the same round: median of the pairs; a row's tool-tip "
            "adds the tenth and ninetieth percentile");
    if (role == Qt::ToolTipRole && section == Processor)
        return tr("Milliseconds of processor time, of all threads that work on a frame: median");
    if (role == Qt::ToolTipRole && section == Error)
        return errorTitle(m_error);
    if (role == Qt::ToolTipRole && section == Speed)
        return tr("%1: median; a row's tool-tip adds the tenth and ninetieth percentile").arg(speedTitle(m_speed));
    if (role == Qt::TextAlignmentRole)
        return QVariant::fromValue((section == Name ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    switch (section) {
    case Name: return tr("Variant");
    case Speed: return m_speed == SpeedMeasure::NsPerCoveredPixel ? tr("ns/px") : tr("Mtri/s");
    case Ratio: return tr("Ratio");
    case Processor: return tr("CPU ms");
    case Error: return tr("Error");
    case Frontier: return QStringLiteral("\u2605");
    default: return {};
    }
}

} // namespace rasterlens
