#pragma once
#include "core/observe/step_record.h"

#include <QPixmap>
#include <QWidget>

#include <memory>

namespace rasterlens
{

[[nodiscard]] QColor pipColor(PipKind kind, const QPalette& palette);

/// The position in a record, to be dragged, above pips by kind of event.
class Scrubber : public QWidget
{
    Q_OBJECT

public:
    explicit Scrubber(QWidget* parent = nullptr);

    void setRecord(const std::shared_ptr<const StepRecord>& record);
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

    std::shared_ptr<const StepRecord> m_record;
    std::size_t m_position = 0;
    QPixmap m_pips; ///< as long as neither record nor size nor colours change
};

} // namespace rasterlens
