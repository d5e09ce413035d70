#include "core/render/steps.h"

#include "core/observe/recorder.h"
#include "core/render/draw.h"

namespace rasterlens
{

Settings recordedAs(Settings settings)
{
    if (settings.algorithm == Algorithm::Tiled)
        settings.algorithm = Algorithm::EdgeEquation;
    return settings;
}

std::shared_ptr<const StepLog> renderSteps(const Scene& scene, const Settings& settings, const StepFilter& filter,
                                           std::stop_token stop)
{
    const Settings shown = recordedAs(settings);
    std::stop_source ending;
    const std::stop_callback stopToo(stop, [&] { ending.request_stop(); });
    const Resolved resolved = resolve(shown, scene);
    StepRecorder recorder(scene, resolved, filter, ending);
    Frame frame;
    drawScene(scene, resolved, frame, {}, recorder, ending.get_token());
    return recorder.finish(stop.stop_requested(), frame.image);
}

} // namespace rasterlens
