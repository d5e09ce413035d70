#include "core/truth/judgement.h"

namespace rasterlens
{
namespace
{

void addWrongPixels(std::vector<WrongPixel>& wrong, const CoverageDifference& difference, const Frame& frame,
                    const ExactFrame& truth)
{
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
}

} // namespace

NotJudged notJudged(const Scene& scene, const Settings& settings)
{
    if (unsupported(scene, settings))
        return NotJudged::Unsupported;
    return settings.fill == Fill::Solid ? NotJudged::No : NotJudged::NotFilled;
}

Judgement judge(const Scene& scene, const Settings& settings, const std::stop_token& stop,
                const ExactProgress& progress, ReferenceSpace space)
{
    Judgement judgement;
    judgement.space = referenceSpace(scene, space);
    ExactOptions options = exactOptions(scene, settings, judgement.space);
    options.edgeDistance = scene.exact && settings.numberType == NumberType::Fixed;
    if (options.edgeDistance)
        judgement.bandPixels = legalBandPixels(settings.size);

    Settings whole = settings; // the truth knows faces without their holes
    whole.alphaTest = AlphaTest::Off;
    Frame frame;
    render(scene, whole, frame, {.depth = true, .ids = true, .coverage = true}, stop);
    const std::vector<ClipTriangle> triangles = exactTriangles(scene, settings, judgement.space);
    const std::vector<PixelRect> bands = bandsOf(options);
    for (std::size_t band = 0; band < bands.size(); ++band) {
        const auto tell = [&](double share) {
            if (progress)
                progress((static_cast<double>(band) + share) / static_cast<double>(bands.size()));
        };
        options.window = bands[band];
        const ExactFrame truth = exactReference(triangles, options, stop, tell);
        if (stop.stop_requested())
            return judgement;
        const CoverageDifference part = coverageDifference(frame, truth, scene.background, judgement.bandPixels);
        addWrongPixels(judgement.wrong, part, frame, truth);
        judgement.nonFinite = truth.nonFinite;
        judgement.difference = band == 0 ? part : joined(judgement.difference, part);
    }
    judgement.difference.verdicts = {};
    return judgement;
}

} // namespace rasterlens
