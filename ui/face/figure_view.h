#pragma once
#include "core/derive/figure.h"

#include <QPolygonF>
#include <QRectF>
#include <QString>
#include <QWidget>

#include <optional>
#include <vector>

namespace rasterlens
{

/// A name of a point or a stroke, as it is painted.
struct FigureName {
    QString name;
    QPointF at; ///< what it is the name of, in the widget
    QRectF box;
    int symbol; ///< index into Derivation::symbols; -1 none
};

/// Draws a figure of a derivation: what belongs to the present line is thick, and a symbol under the mouse is told.
class FigureView : public QWidget
{
    Q_OBJECT

public:
    explicit FigureView(QWidget* parent = nullptr);

    /// in  title: that of the figure, in the language in use
    void setFigure(const DerivationFigure& figure, const QString& title);
    /// The symbols of the present line, as indices into Derivation::symbols.
    void setPresent(std::vector<int> symbols);
    void setHovered(std::optional<std::size_t> symbol);

    /// Where a point of the figure lies in the widget.
    [[nodiscard]] QPointF toWidget(const glm::dvec2& at) const;
    /// The symbol whose stroke or point lies there; nothing where none is near.
    [[nodiscard]] std::optional<std::size_t> symbolAt(QPointF widget) const;

    /// Where the names stand: none over another, and each nearest to what it is the name of.
    [[nodiscard]] std::vector<FigureName> names() const;

    QSize sizeHint() const override { return {210, 150}; }
    QSize minimumSizeHint() const override { return {150, 130}; }

Q_SIGNALS:
    void symbolHovered(std::optional<std::size_t> symbol);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    [[nodiscard]] QRectF plotArea() const;
    [[nodiscard]] QColor inkOf(int symbol) const;
    [[nodiscard]] bool isLit(int symbol) const;
    void paintAxes(QPainter& painter) const;
    void paintXAxis(QPainter& painter, const QRectF& below) const;
    void paintStrokes(QPainter& painter) const;
    void paintPoints(QPainter& painter) const;
    void paintNames(QPainter& painter) const;
    [[nodiscard]] std::vector<QRectF> axisTexts() const;
    [[nodiscard]] QPolygonF wayOf(const FigureStroke& stroke) const;

    DerivationFigure m_figure;
    QString m_title;
    std::vector<int> m_present;
    std::optional<std::size_t> m_hovered;
};

} // namespace rasterlens
