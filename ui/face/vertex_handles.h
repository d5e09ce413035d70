#pragma once
#include "ui/canvas/viewport_widget.h"
#include "ui/document/document.h"
#include "ui/face/vertex_editing.h"

#include <QWidget>

#include <optional>
#include <vector>

namespace rasterlens
{

/// Over the canvas: the vertices of a small scene, to be dragged from place to place.
class VertexHandles : public QWidget
{
    Q_OBJECT

public:
    /// in  editing: where corners go, and what goes with them; to outlive the handles
    VertexHandles(Document& document, ViewportWidget& canvas, const VertexEditing& editing);

    /// Shows the handles where the scene can be edited.
    void setActive(bool active);
    void refresh();
    /// Moves a corner to the place nearest to a point of the screen that corners are dragged to; depth and w stay.
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
    };

    [[nodiscard]] const Handle* handleAt(QPointF canvas) const;
    [[nodiscard]] QPointF toCanvas(QPointF pixels) const;

    Document& m_document;
    ViewportWidget& m_canvas;
    const VertexEditing& m_editing;
    bool m_active = false;
    std::vector<Handle> m_handles;
    std::optional<std::uint32_t> m_dragged;
    QPointF m_grip; ///< from the cursor to the vertex, canvas pixels
};

} // namespace rasterlens
