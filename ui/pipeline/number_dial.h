#pragma once
#include "core/base/reason.h"
#include "core/settings/number_budget.h"
#include "ui/document/document.h"

#include <QWidget>

#include <array>
#include <optional>

namespace rasterlens
{

/// The numbers coverage is decided with, as one dial: double, float32, and fixed point with 8 to 0 bits after the
/// point. Below it the size of one unit, and the bits an edge value needs against those there are.
class NumberDial : public QWidget
{
    Q_OBJECT

public:
    explicit NumberDial(Document& document, QWidget* parent = nullptr);

    /// One position of the dial.
    struct Stop {
        NumberType type;
        int subpixelBits; ///< fixed point only
        const char* label;
    };
    static constexpr std::array<Stop, 11> kStops{{{NumberType::Float64, 8, "64"},
                                                  {NumberType::Float32, 8, "32"},
                                                  {NumberType::Fixed, 8, ".8"},
                                                  {NumberType::Fixed, 7, ".7"},
                                                  {NumberType::Fixed, 6, ".6"},
                                                  {NumberType::Fixed, 5, ".5"},
                                                  {NumberType::Fixed, 4, ".4"},
                                                  {NumberType::Fixed, 3, ".3"},
                                                  {NumberType::Fixed, 2, ".2"},
                                                  {NumberType::Fixed, 1, ".1"},
                                                  {NumberType::Fixed, 0, ".0"}}};
    /// The present one.
    [[nodiscard]] int stop() const;
    /// Sets number type and subpixel bits; nothing happens where they cannot be drawn with the other settings.
    void choose(int stop);

    /// `1 unit = 1/256 px`
    [[nodiscard]] QString unitText() const;
    /// `38 of 63 bits, 25 left`; `needs 47 bits, has 24`
    [[nodiscard]] QString bitsText() const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {190, sizeHint().height()}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool event(QEvent* event) override;

private:
    [[nodiscard]] QRectF segment(int stop) const;
    [[nodiscard]] int stopAt(QPointF point) const;
    [[nodiscard]] std::optional<Reason> whyNot(int stop) const;
    [[nodiscard]] static Settings withStop(Settings settings, int stop);
    void paintTrack(QPainter& painter) const;
    void paintBits(QPainter& painter, const QRectF& where) const;
    void retranslate();

    Document& m_document;
};

} // namespace rasterlens
