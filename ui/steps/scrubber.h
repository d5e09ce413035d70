#pragma once
#include "core/observe/step_log.h"

#include <QPixmap>
#include <QWidget>

#include <memory>
#include <vector>

namespace rasterlens
{

/// What a pip of the scrubber marks. Where several fall on one place, the rare ones are shown, the last of this list
/// before the others, and of the common ones, up to Cull, the most frequent.
enum class PipKind : std::uint8_t { None, Other, Sample, Outside, Cull, Clip, DepthFail, Tie };
constexpr std::size_t kPipKinds = 8;
[[nodiscard]] PipKind pipKindOf(const StepEvent& event);
[[nodiscard]] QColor pipColor(PipKind kind, const QPalette& palette);

/// The most telling pip of each column of a scrubber.
///
/// cost  one pass over the events
[[nodiscard]] std::vector<PipKind> binPips(const StepLog& log, int columns);

/// The position in a log, to be dragged, above pips by kind of event.
class Scrubber : public QWidget
{
    Q_OBJECT

public:
    explicit Scrubber(QWidget* parent = nullptr);

    void setLog(const std::shared_ptr<const StepLog>& log);
    void setPosition(std::size_t position);
    [[nodiscard]] std::size_t position() const { return m_position; }
    [[nodiscard]] double xOf(std::size_t position) const;
    [[nodiscard]] std::size_t positionAt(double x) const;

    QSize sizeHint() const override { return {400, 26}; }
    QSize minimumSizeHint() const override { return {120, 26}; }

Q_SIGNALS:
    void moved(std::size_t position);

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;

private:
    void paintPips();

    std::shared_ptr<const StepLog> m_log;
    std::size_t m_position = 0;
    QPixmap m_pips; ///< as long as neither log nor size nor colours change
};

} // namespace rasterlens
