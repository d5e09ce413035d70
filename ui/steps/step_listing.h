#pragma once
#include "core/observe/step_log.h"

#include <QFrame>
#include <QStringList>

#include <vector>

class QLabel;

namespace rasterlens
{

class StepSession;

/// The algorithm in a few lines, the line at work, and its formula with the numbers put in.
struct StepExplanation {
    QStringList listing;
    int line = -1;   ///< of the listing; -1: none
    QString formula; ///< may have several lines
};

/// in  event number
[[nodiscard]] StepExplanation explainStep(const StepLog& log, std::size_t i);

/// One event in a few words: `sample · row 4 · face 1`. In the language in use.
[[nodiscard]] QString stepTitle(const StepLog& log, std::size_t i);

/// The linked view below the canvas: follows the session.
class StepListing : public QFrame
{
    Q_OBJECT

public:
    explicit StepListing(const StepSession& session, QWidget* parent = nullptr);

    [[nodiscard]] const StepExplanation& explanation() const { return m_explanation; }

    QSize minimumSizeHint() const override; ///< of the present line and the formula: the other lines leave first

protected:
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void sync();
    void fitFormula();
    [[nodiscard]] static int lineHeight();

    const StepSession& m_session;
    StepExplanation m_explanation;
    std::vector<QLabel*> m_lines;
    QLabel* m_formula = nullptr;
};

} // namespace rasterlens
