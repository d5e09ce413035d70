#pragma once
#include "ui/truth/experiment_plot.h"

#include <QAbstractTableModel>

#include <vector>

namespace rasterlens
{

/// The rows of an experiment as a table.
class ExperimentModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column { Name, Speed, Ratio, Processor, Error, Frontier, ColumnCount };
    static constexpr int SortRole = Qt::UserRole;

    using QAbstractTableModel::QAbstractTableModel;

    void setRows(const std::vector<ExperimentRow>& rows, ErrorMeasure error, SpeedMeasure speed);

    /// All errors and speeds with their spread, and what was found out about another renderer, as rich text.
    [[nodiscard]] static QString describe(const ExperimentRow& row);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    [[nodiscard]] QString textAt(const ExperimentRow& row, int column) const;
    [[nodiscard]] QVariant sortKey(const ExperimentRow& row, int column) const;

    std::vector<ExperimentRow> m_rows;
    ErrorMeasure m_error = ErrorMeasure::Coverage;
    SpeedMeasure m_speed = SpeedMeasure::NsPerCoveredPixel;
};

} // namespace rasterlens
