#include "core/truth/judgement.h"

namespace rasterlens
{
namespace
{

std::vector<WrongPixel> wrongPixels(const CoverageDifference& difference, const Frame& frame, const ExactFrame& truth)
{
    std::vector<WrongPixel> wrong;
    wrong.reserve(difference.wrong());
    std::size_t i = 0;
    for (int y = 0; y < difference.window.height; ++y)
        for (int x = 0; x < difference.window.width; ++x, ++i)
            if (difference.verdicts[i] != PixelVerdict::Right) {
                WrongPixel pixel{difference.window.x + x, difference.window.y + y, difference.verdicts[i],
                                 truth.id[truth.sampleNearestCentre(x, y)]};
                if (pixel.face < 0)
                    pixel.face =
                        frame.ids[static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(frame.image.width()) +
                                  static_cast<std::size_t>(pixel.x)];
                wrong.push_back(pixel);
            }
    return wrong;
}

} // namespace

double judgedSamples(const Scene& scene, const Settings& settings)
{
    const double grid = sampleGrid(settings.samples);
    const QSize size = scene.window ? QSize(scene.window->width, scene.window->height) : settings.size;
    return double(size.width()) * double(size.height()) * grid * grid;
}

NotJudged notJudged(const Scene& scene, const Settings& settings)
{
    if (unsupported(scene, settings))
        return NotJudged::Unsupported;
    if (settings.fill != Fill::Solid)
        return NotJudged::NotFilled;
    return judgedSamples(scene, settings) > kMostJudgedSamples ? NotJudged::TooManySamples : NotJudged::No;
}

Judgement judge(const Scene& scene, const Settings& settings, const std::stop_token& stop)
{
    Judgement judgement;
    ExactOptions options = exactOptions(scene, settings);
    options.edgeDistance = scene.exact && settings.numberType == NumberType::Fixed;
    if (options.edgeDistance)
        judgement.bandPixels = legalBandPixels(settings.size);

    Frame frame;
    render(scene, settings, frame, {.depth = true, .ids = true, .coverage = true}, stop);
    const ExactFrame truth = exactReference(exactTriangles(scene, settings), options, stop);
    if (stop.stop_requested())
        return judgement;
    judgement.nonFinite = truth.nonFinite;
    judgement.difference = coverageDifference(frame, truth, scene.background, judgement.bandPixels);
    judgement.wrong = wrongPixels(judgement.difference, frame, truth);
    judgement.difference.verdicts = {};
    return judgement;
}

} // namespace rasterlens
