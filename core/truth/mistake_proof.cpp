#include "core/truth/mistake_proof.h"

#include "core/render/render.h"
#include "core/scenes/builtin_scenes.h"
#include "core/truth/difference.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>
#include <vector>

namespace rasterlens
{
namespace
{

/// Pixels for which a statement about the faces seen there holds: (shown, right), -1 none.
template <class Statement>
double pixelsWhere(const CountedPicture& shown, const CountedPicture& right, Statement holds)
{
    std::size_t count = 0;
    for (std::size_t i = 0; i < shown.frame.ids.size(); ++i)
        count += holds(shown.frame.ids[i], right.frame.ids[i]) ? 1 : 0;
    return static_cast<double>(count);
}

double depthError(const CountedPicture& shown, const CountedPicture& right)
{
    float largest = 0;
    for (std::size_t i = 0; i < shown.frame.ids.size(); ++i)
        if (shown.frame.ids[i] >= 0 && shown.frame.ids[i] == right.frame.ids[i])
            largest = std::max(largest, std::abs(shown.frame.depth[i] - right.frame.depth[i]));
    return static_cast<double>(largest);
}

std::span<const QRgb> pixelsOf(const QImage& image)
{
    return {reinterpret_cast<const QRgb*>(image.constBits()),
            static_cast<std::size_t>(image.width()) * static_cast<std::size_t>(image.height())};
}

double distinctColors(const QImage& image)
{
    constexpr std::size_t kColors = std::size_t(1) << 24;
    std::vector<bool> seen(kColors);
    for (const QRgb color : pixelsOf(image))
        seen[color & (kColors - 1)] = true;
    return static_cast<double>(std::ranges::count(seen, true));
}

/// Brightness of the right picture that the shown one lacks, in white pixels.
double missingLight(const QImage& shown, const QImage& right)
{
    double missing = 0;
    for (std::size_t i = 0; i < pixelsOf(shown).size(); ++i)
        missing += std::max(0, qGray(pixelsOf(right)[i]) - qGray(pixelsOf(shown)[i])) / 255.0;
    return missing;
}

} // namespace

MistakeDemo mistakeDemo(const Mistake& mistake)
{
    SceneLoad load = makeBuiltinScene(QLatin1String(mistake.scene));
    assert(load.scene);
    MistakeDemo demo{std::move(*load.scene), {}, {}};
    demo.right = demo.mistaken = demo.scene.defaults;
    demo.mistaken.mistakes = QStringList{QLatin1String(mistake.id)};
    return demo;
}

Outputs proofOutputs(Proof proof)
{
    switch (proof) {
    case Proof::Holes:
    case Proof::Strays:
    case Proof::WrongFaces: return {.ids = true, .picture = false};
    case Proof::DepthError: return {.depth = true, .ids = true, .picture = false};
    case Proof::WrongPixels:
    case Proof::Colors:
    case Proof::MissingLight: return {};
    case Proof::CoveredTwice:
    case Proof::Covered:
    case Proof::Tested:
    case Proof::DepthPassed:
    case Proof::DepthFailed:
    case Proof::Rejected:
    case Proof::CulledBack:
    case Proof::Degenerate:
    case Proof::Rasterized: break;
    }
    return {.picture = false};
}

CountedPicture drawCounted(const Scene& scene, const Settings& settings, Outputs outputs, std::stop_token stop)
{
    CountedPicture picture;
    picture.statistics = renderCounted(scene, settings, picture.frame, outputs, std::move(stop));
    return picture;
}

const char* proofId(Proof proof)
{
    switch (proof) {
    case Proof::CoveredTwice: return "covered_twice";
    case Proof::Covered: return "covered";
    case Proof::Tested: return "tested";
    case Proof::DepthPassed: return "depth_passed";
    case Proof::DepthFailed: return "depth_failed";
    case Proof::Rejected: return "rejected";
    case Proof::CulledBack: return "culled_back";
    case Proof::Degenerate: return "degenerate";
    case Proof::Rasterized: return "rasterized";
    case Proof::Holes: return "holes";
    case Proof::Strays: return "strays";
    case Proof::WrongFaces: return "wrong_faces";
    case Proof::WrongPixels: return "wrong_pixels";
    case Proof::DepthError: return "depth_error";
    case Proof::Colors: return "colors";
    case Proof::MissingLight: break;
    }
    return "missing_light";
}

double proofValue(Proof proof, const CountedPicture& shown, const CountedPicture& right)
{
    const Statistics::Faces& faces = shown.statistics.faces;
    const Statistics::Pixels& pixels = shown.statistics.pixels;
    switch (proof) {
    case Proof::CoveredTwice: return static_cast<double>(pixels.coveredTwice);
    case Proof::Covered: return static_cast<double>(pixels.covered);
    case Proof::Tested: return static_cast<double>(pixels.tested);
    case Proof::DepthPassed: return static_cast<double>(pixels.depthPassed);
    case Proof::DepthFailed: return static_cast<double>(pixels.depthFailed);
    case Proof::Rejected: return static_cast<double>(faces.rejected);
    case Proof::CulledBack: return static_cast<double>(faces.culledBack);
    case Proof::Degenerate: return static_cast<double>(faces.degenerate);
    case Proof::Rasterized: return static_cast<double>(faces.rasterized);
    case Proof::Holes: return pixelsWhere(shown, right, [](int is, int should) { return is < 0 && should >= 0; });
    case Proof::Strays: return pixelsWhere(shown, right, [](int is, int should) { return is >= 0 && should < 0; });
    case Proof::WrongFaces: return pixelsWhere(shown, right, [](int is, int should) { return is != should; });
    case Proof::WrongPixels: return static_cast<double>(difference(shown.frame.image, right.frame.image).differing);
    case Proof::DepthError: return depthError(shown, right);
    case Proof::Colors: return distinctColors(shown.frame.image);
    case Proof::MissingLight: break;
    }
    return missingLight(shown.frame.image, right.frame.image);
}

} // namespace rasterlens
