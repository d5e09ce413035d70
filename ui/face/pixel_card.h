#pragma once
#include "core/questions/why.h"

#include <QPoint>
#include <QTimer>
#include <QWidget>

#include <memory>
#include <optional>
#include <vector>

class QLabel;
class QScrollArea;
class QVBoxLayout;

namespace rasterlens
{

/// A face on the card, in words.
struct WhyWords {
    std::uint32_t face = 0;
    QString name;        ///< the face, with the line of the file that it comes from
    bool good = false;   ///< it got into the picture
    QString verdict;     ///< the headline
    QStringList details; ///< the numbers on the way to it
};

/// The verdict of core in the language of the window.
[[nodiscard]] WhyWords whyWords(const WhyReport& report, const WhyFace& face);
/// Which face is seen at the pixel.
[[nodiscard]] QString whyAnswer(const WhyReport& report);

/// Why a pixel is what it is: every face that could concern it with its verdict. A click on a row asks for its step.
class PixelCard : public QWidget
{
    Q_OBJECT

public:
    explicit PixelCard(QWidget* parent = nullptr);

    /// Null: no pixel is selected.
    void setReport(std::shared_ptr<const WhyReport> report);
    [[nodiscard]] const std::shared_ptr<const WhyReport>& report() const { return m_report; }
    [[nodiscard]] const std::vector<WhyWords>& rows() const { return m_rows; }
    /// While another picture than the finished one is on the canvas the card says that it speaks of that.
    void setSaysMoment(bool on);
    /// All rows as plain text.
    [[nodiscard]] QString asText() const;
    [[nodiscard]] QString title() const;

    QSize sizeHint() const override { return {250, 330}; }

Q_SIGNALS:
    void rowClicked(quint32 face, QPoint pixel);

protected:
    void changeEvent(QEvent* event) override;

private:
    void rebuild();
    /// What is seen, and where that is in doubt, when.
    [[nodiscard]] QString answer() const;
    QWidget* makeHeader() const;
    QWidget* makeRow(std::size_t index);

    std::shared_ptr<const WhyReport> m_report;
    std::vector<WhyWords> m_rows;
    bool m_saysMoment = false;
    QScrollArea* m_scroll = nullptr;
    QTimer m_rebuildSoon;
};

} // namespace rasterlens
