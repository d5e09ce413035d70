#include "core/derive/pixel_weights.h"

#include "core/derive/face_record.h"

#include <cmath>

namespace rasterlens
{

bool PixelWeights::isCorrected() const
{
    constexpr double kRounding = 1e-9;
    for (std::size_t i = 0; i < 3; ++i)
        if (!(std::abs(used[i] - screen[i]) <= kRounding))
            return true;
    return false;
}

std::optional<PixelWeights> pixelWeights(const Scene& scene, const Settings& settings, std::uint32_t face, QPoint pixel,
                                         const std::stop_token& stop)
{
    DerivationPlace place;
    place.face = face;
    place.pixel = pixel;
    const FaceRecord record(scene, settings, place, stop);
    const int grid = record.rules().sampleGrid;
    const int x = pixel.x() * grid + grid / 2;
    const int y = pixel.y() * grid + grid / 2;
    StepFilter filter;
    filter.pixels = PixelRect{pixel.x(), pixel.y(), 1, 1};
    filter.kinds = kindBit(StepKind::Triangle) | kindBit(StepKind::Fragment);
    const std::shared_ptr<const StepLog> log = record.logOf(settings, filter);
    std::optional<PixelWeights> found;
    for (const std::uint32_t i : log->eventsOf(StepKind::Fragment)) {
        const StepEvent& event = log->event(i);
        const StepTriangle* triangle = log->triangle(event);
        if (event.x != x || event.y != y || triangle == nullptr)
            continue;
        const FragmentStep& fragment = log->payload<FragmentStep>(event);
        found.emplace();
        found->face = face;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            found->corners[corner] = record.pixels(triangle->screen.vertices[corner].position);
            found->invW[corner] = triangle->screen.vertices[corner].invW;
        }
        found->point = record.pixels(testedPoint(record.rules(), x, y));
        found->screen = fragment.screen;
        found->used = fragment.shaded ? fragment.weights : fragment.screen;
    }
    return found;
}

} // namespace rasterlens
