#pragma once
#include "core/truth/hard_cases.h"
#include "core/truth/variants.h"
#include "ui/base/latest_result.h"

#include <QAbstractListModel>
#include <QImage>

#include <array>
#include <span>
#include <utility>
#include <vector>

namespace rasterlens
{

/// The hard cases with thumbnails and what came of each variant, drawn and judged one after the other on a background
/// thread.
class CaseModel : public QAbstractListModel
{
    Q_OBJECT

public:
    /// A variant that a case is drawn with.
    struct Variant {
        const char* id;
        const char* sign; ///< at most four characters
    };
    static constexpr auto kVariants = std::to_array<Variant>({
        {"edge-equation", "EE"},
        {"edge-walking", "EW"},
        {"tiled", "Ti"},
        {"edge-equation-float32", "f32"},
        {"edge-equation-float64", "f64"},
    });
    struct Verdict {
        CaseGrade grade;
        std::vector<Reason> reasons;
    };
    struct Case {
        QString name;
        QString note; ///< what must hold, line by line
        std::vector<std::pair<QString, QString>> expectations;
        QImage thumbnail;              ///< of the part worth looking at
        std::vector<Verdict> verdicts; ///< one a variant; empty until it has been judged
        [[nodiscard]] bool fails() const;

        /// What must hold and what came of a variant, in the language in use.
        [[nodiscard]] QString noteText() const;
        [[nodiscard]] QString expectationsText() const;
        [[nodiscard]] QString reasonText(std::size_t variant) const;
    };

    explicit CaseModel(QObject* parent = nullptr);

    /// Draws and judges what has not been yet.
    void start();
    [[nodiscard]] bool isBusy() const { return m_result.isBusy(); }
    [[nodiscard]] int judged() const { return m_judged; }

    [[nodiscard]] const Case& at(int row) const { return m_cases[static_cast<std::size_t>(row)]; }
    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

    /// `edge equation, float32`, in the language in use.
    [[nodiscard]] static QString variantTitle(std::size_t variant);
    /// At most four characters: `EE`, `f32`.
    [[nodiscard]] static QString variantSign(std::size_t variant);

Q_SIGNALS:
    void progressed(); ///< one more case is judged; or all
    /// Judging ended early, for want of memory or threads; start() goes on with the next case.
    void failed(const QString& message);

private:
    struct Judged {
        int row = 0;
        Case result;
    };

    void take(const Judged& judged);

    std::vector<Case> m_cases;
    int m_judged = 0;
    LatestResult<Judged> m_result; ///< last: its thread uses the members above
};

} // namespace rasterlens
