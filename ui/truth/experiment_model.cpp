#include "ui/truth/experiment_model.h"

#include "ui/base/theme.h"

#include <QCoreApplication>

#include <limits>

namespace rasterlens
{
namespace
{

QString translated(const char* text) { return QCoreApplication::translate("Settings", text); }

QString number(double value)
{
    constexpr double kWhole = 100;
    return value >= kWhole && value < 1e6 ? QString::number(value, 'f', 0) : QString::number(value, 'g', 3);
}

/// What the mark of the algorithm leaves to be said: `Subpixel bits: 4`.
QString shortTitleOf(const ExperimentRow& row)
{
    const QString title = ExperimentModel::titleOf(row);
    const QString changes = title.section(QStringLiteral("; "), 1);
    return changes.isEmpty() ? title : changes;
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

QString ExperimentModel::titleOf(const ExperimentRow& row)
{
    const Variant* variant = findVariant(row.variant);
    return variant ? rasterlens::titleOf(*variant, translated) : row.variant;
}

QString ExperimentModel::describe(const ExperimentRow& row)
{
    QString text = QStringLiteral("<p style='white-space: pre'><b>%1</b>").arg(titleOf(row));
    for (int i = 0; i < kErrorMeasures; ++i) {
        const auto measure = static_cast<ErrorMeasure>(i);
        if (const auto error = errorOf(row, measure))
            text += QStringLiteral("\n%1: %2").arg(errorTitle(measure)).arg(*error, 0, 'g', 3);
    }
    if (row.ms.frames == 0)
        return text + QStringLiteral("</p>");
    for (const SpeedMeasure measure : {SpeedMeasure::NsPerCoveredPixel, SpeedMeasure::MtriPerS}) {
        const rasterlens::Speed speed = speedOf(row, measure);
        text += QStringLiteral("\n%1: %2 (%3 \u2026 %4)")
                    .arg(speedTitle(measure))
                    .arg(speed.median, 0, 'g', 3)
                    .arg(speed.low, 0, 'g', 3)
                    .arg(speed.high, 0, 'g', 3);
    }
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
    case Name: return shortTitleOf(row);
    case Speed: return row.ms.frames > 0 ? number(speedOf(row, m_speed).median) : QStringLiteral("\u2026");
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
    case Error: return errorOf(row, m_error).value_or(kLast);
    case Frontier: return row.frontier ? 0 : 1;
    default: return titleOf(row);
    }
}

QVariant ExperimentModel::data(const QModelIndex& index, int role) const
{
    const ExperimentRow& row = m_rows[static_cast<std::size_t>(index.row())];
    switch (role) {
    case Qt::DisplayRole: return textAt(row, index.column());
    case SortRole: return sortKey(row, index.column());
    case Qt::DecorationRole: return index.column() == Name ? algorithmMark(row.settings.algorithm) : QVariant();
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
        return tr("On the frontier: no other variant is at least as fast with less error");
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
    case Error: return tr("Error");
    case Frontier: return QStringLiteral("\u2605");
    default: return {};
    }
}

} // namespace rasterlens
