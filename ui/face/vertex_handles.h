#pragma once
#include "ui/canvas/viewport_widget.h"
#include "ui/document/document.h"

#include <QWidget>

#include <optional>
#include <vector>

namespace rasterlens
{

/// Over the canvas: the vertices of a small scene, to be dragged from sub-pixel to sub-pixel.
class VertexHandles : public QWidget
{
    Q_OBJECT

public:
    VertexHandles(Document& document, ViewportWidget& canvas);

    /// Shows the handles where the scene can be edited.
    void setActive(bool active);
    void refresh();
    /// Moves a vertex to a point of the screen, snapped to the subpixel grid of the settings; depth and w stay.
    ///
    /// in  pixels
    void moveVertex(std::uint32_t vertex, QPointF screen);
    /// Where a vertex is on the screen, in pixels; nothing for one behind the eye.
    [[nodiscard]] std::optional<QPointF> screenOf(std::uint32_t vertex) const;

protected:
    void paintEvent(QPaintEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Handle {
        std::uint32_t vertex;
        QPointF screen; ///< pixels
        double clipZ;
        double clipW;
    };

    [[nodiscard]] const Handle* handleAt(QPointF canvas) const;
    [[nodiscard]] QPointF toCanvas(QPointF pixels) const;

    Document& m_document;
    ViewportWidget& m_canvas;
    bool m_active = false;
    std::vector<Handle> m_handles;
    std::optional<std::uint32_t> m_dragged;
    QPointF m_grip; ///< from the cursor to the vertex, canvas pixels
};

} // namespace rasterlens
