#pragma once
#include "ui/canvas/viewport_widget.h"
#include "ui/truth/comparison.h"

#include <QWidget>

class QLabel;

namespace rasterlens
{

class ColorPair;

/// The line in the status bar that says what is at a pixel; while pictures are compared, what is there in both, and the
/// difference.
class ReadoutBar : public QWidget
{
    Q_OBJECT

public:
    explicit ReadoutBar(QWidget* parent = nullptr);

    /// in   pixel: nothing where there is none to speak of; compared: nothing where there is no comparison; step: of a
    ///      record, after which that is so; nothing where it is so of the finished frame
    void show(const std::optional<PixelReadout>& pixel, const std::optional<ComparedPixel>& compared,
              const std::optional<std::size_t>& step);
    /// Where a pixel is, and nothing that is known of it.
    void showPlace(QPoint pixel);
    [[nodiscard]] QString text() const;

private:
    ColorPair* m_swatch;
    QLabel* m_text;
};

} // namespace rasterlens
