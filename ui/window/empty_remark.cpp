#include "ui/window/empty_remark.h"

#include "core/questions/empty_picture.h"
#include "ui/base/message_bar.h"
#include "ui/pipeline/scene_words.h"

namespace rasterlens
{

void EmptyRemark::update(const RenderedFrame& frame, Wanted wanted, MessageBar& bar)
{
    const auto empty = wanted == Wanted::Yes ? whyEmpty(frame.statistics) : std::nullopt;
    if (empty && !m_shown && !bar.isHidden())
        return; // what the bar says already comes first
    if (empty)
        bar.show(Diagnostics{{Severity::Warning, sceneTitle(*frame.scene), 0, sentenceOf(*empty, empty->action)}});
    else if (m_shown)
        bar.hide();
    m_shown = empty.has_value();
}

} // namespace rasterlens
