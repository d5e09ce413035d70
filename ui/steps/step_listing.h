#pragma once
#include "ui/steps/lens_glyphs.h"
#include "ui/steps/step_formula.h"

#include <QFrame>

#include <optional>
#include <vector>

class QLabel;

namespace rasterlens
{

class CodeLine;
class LegendView;
class StepSession;

/// The linked view below the canvas: follows the session.
class StepListing : public QFrame
{
    Q_OBJECT

public:
    explicit StepListing(const StepSession& session, QWidget* parent = nullptr);

    enum class Place {
        Below,  ///< code and formula below the canvas
        Line,   ///< one line of the formula below the canvas
        Beside, ///< all of the code, and a longer formula, beside the canvas
    };
    void setPlace(Place place);
    /// What the signs on the canvas say; nothing: there are none. It is shown below the formula where the listing
    /// stands beside the canvas and has room for it.
    void setLegend(const std::optional<LensLegend>& legend);
    [[nodiscard]] bool hasRoomForLegend() const;
    /// Leaves out the next p of a line, which the formula of a decision ends with: a question asks for it.
    void setNextPConcealed(bool on);

    [[nodiscard]] const StepExplanation& explanation() const { return m_explanation; }
    [[nodiscard]] const std::vector<CodeLine*>& lines() const { return m_lines; }
    /// The rows of the formula as they are shown.
    [[nodiscard]] QStringList formulaRows() const;

    QSize minimumSizeHint() const override; ///< of the present line and the formula: the other lines leave first

Q_SIGNALS:
    void roomChanged(); ///< hasRoomForLegend(), perhaps

protected:
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void sync();
    void fitFormula();
    [[nodiscard]] int legendHeight() const;
    [[nodiscard]] int codeWidth() const;
    [[nodiscard]] int formulaRowCount() const;
    [[nodiscard]] static int lineHeight();

    const StepSession& m_session;
    StepExplanation m_explanation;
    Place m_place = Place::Below;
    bool m_isNextPConcealed = false;
    std::vector<CodeLine*> m_lines;
    QLabel* m_formula = nullptr;
    LegendView* m_legend = nullptr;
};

} // namespace rasterlens
