#pragma once
#include "ui/document/render_worker.h"

namespace rasterlens
{

class MessageBar;

/// Says why a picture shows nothing, as long as it does.
class EmptyRemark
{
public:
    enum class Wanted {
        Yes,
        No, ///< the picture is that of a lesson's slide, whose caption speaks of it
    };
    /// in   a counted frame
    void update(const RenderedFrame& frame, Wanted wanted, MessageBar& bar);

private:
    bool m_shown = false;
};

} // namespace rasterlens
