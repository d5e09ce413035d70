#pragma once
// A main window whose views and overlays are chosen.
#include "ui/pipeline/canvas_views.h"
#include "window_fixture.h"

#include <optional>
#include <vector>

namespace rasterlens::test
{

class ViewsFixture : public WindowFixture
{
    Q_OBJECT

protected:
    CanvasViews& views() { return m_window->canvasViews(); }

    bool show(CanvasView view)
    {
        views().setView(view);
        return complete();
    }

    bool choose(QPoint pixel)
    {
        viewport().selectPixel(pixel);
        return complete();
    }

    /// A pixel near the middle of what a face owns.
    std::optional<QPoint> ownedPixel()
    {
        const Frame& frame = viewport().frame()->frame;
        const int width = frame.image.width();
        std::vector<int> owned;
        for (std::size_t i = 0; i < frame.ids.size(); ++i)
            if (frame.ids[i] >= 0)
                owned.push_back(int(i));
        if (owned.empty())
            return std::nullopt;
        const int at = owned[owned.size() / 2];
        return QPoint(at % width, at / width);
    }
};

} // namespace rasterlens::test
