#pragma once
#include "ui/truth/case_model.h"

#include <QWidget>

class QCheckBox;
class QLabel;
class QLayout;
class QLineEdit;
class QListView;
class QProgressBar;
class QSortFilterProxyModel;

namespace rasterlens
{

/// The catalogue of hard cases as thumbnails, with a sign for each variant: passed, passed within what snapping or the
/// depth format can tell, failed, cannot be drawn. A click opens the case, one on a sign opens it with that variant.
class CaseBrowser : public QWidget
{
    Q_OBJECT

public:
    explicit CaseBrowser(QWidget* parent = nullptr);

    [[nodiscard]] CaseModel& model() { return *m_model; }
    [[nodiscard]] QListView& list() { return *m_list; }
    [[nodiscard]] QLineEdit* filterEdit() const { return m_filter; }
    [[nodiscard]] QCheckBox* failingBox() const { return m_failing; }
    /// How many cases are listed.
    [[nodiscard]] int listed() const;
    /// Where the sign of a variant is in a cell of the list, for clicks.
    [[nodiscard]] static QRect signBox(const QRect& cell, std::size_t variant);

    QSize sizeHint() const override { return {1000, 300}; }

Q_SIGNALS:
    void caseChosen(const QString& name, const QString& variant);

protected:
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    class Delegate;
    class Filter;

    QLayout* buildHead();
    QLayout* buildCases();
    void choose(const QModelIndex& listed, QPoint at);
    void describe(const QModelIndex& listed);
    void syncState();
    void retranslate();
    [[nodiscard]] QString reasonText(const CaseModel::Case& one) const;

    CaseModel* m_model;
    Filter* m_filtered;
    QLineEdit* m_filter;
    QCheckBox* m_failing;
    QLabel* m_state;
    QProgressBar* m_progress;
    QListView* m_list;
    QLabel* m_detail;
};

} // namespace rasterlens
