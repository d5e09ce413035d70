#pragma once
#include "ui/document/render_worker.h"

namespace rasterlens
{

class MessageBar;

/// Says why a picture shows nothing, as long as it does.
class EmptyRemark
{
public:
    /// in   a counted frame
    void update(const RenderedFrame& frame, MessageBar& bar);

private:
    bool m_shown = false;
};

} // namespace rasterlens
