#include "core/render/steps.h"

#include "core/observe/recorder.h"
#include "core/pipeline/rules_for.h"
#include "core/render/draw.h"

namespace rasterlens
{

std::shared_ptr<const StepLog> renderSteps(const Scene& scene, const Settings& settings, const StepFilter& filter,
                                           std::stop_token stop)
{
    Settings shown = settings;
    if (shown.algorithm == Algorithm::Tiled)
        shown.algorithm = Algorithm::EdgeEquation;
    std::stop_source ending;
    const std::stop_callback stopToo(stop, [&] { ending.request_stop(); });
    StepRecorder recorder(scene, shown, rulesFor(scene, shown), filter, ending);
    Frame frame;
    drawScene(scene, shown, frame, {}, recorder, ending.get_token());
    return recorder.finish(stop.stop_requested(), frame.image);
}

} // namespace rasterlens
