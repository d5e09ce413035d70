#include "core/truth/renderer_probe.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rasterlens
{
namespace
{

/// Pixels of a picture to clip space.
glm::vec4 clipAt(double x, double y, QSize size)
{
    return {static_cast<float>(2 * x / size.width() - 1), static_cast<float>(1 - 2 * y / size.height()), 0, 1};
}

Scene emptyScene()
{
    Scene scene;
    scene.id = QStringLiteral("probe");
    scene.space = SceneSpace::Clip;
    scene.lit = false;
    scene.materials.resize(1);
    return scene;
}

Settings probeSettings(QSize size)
{
    Settings settings;
    settings.size = size;
    settings.culling = Culling::None;
    settings.depthTest = DepthTest::None;
    return settings;
}

void addFace(Scene& scene, const std::array<glm::vec4, 3>& corners)
{
    for (const glm::vec4& corner : corners) {
        MeshVertex vertex;
        vertex.position = corner;
        scene.mesh.indices.push_back(static_cast<std::uint32_t>(scene.mesh.vertices.size()));
        scene.mesh.vertices.push_back(vertex);
    }
}

std::vector<std::uint16_t> coverageOf(OtherRenderer& renderer, const Scene& scene, QSize size)
{
    Frame frame;
    renderer.load(scene, probeSettings(size));
    renderer.draw(frame, {.ids = true, .coverage = true});
    return std::move(frame.coverage);
}

constexpr int kPlaces = 1024;  ///< edges a pixel
constexpr int kRows = kPlaces; ///< in which an edge crosses a column of centres
constexpr int kApart = 4;      ///< pixels from edge to edge

/// How many rows each of the edges leaves on its right.
///
/// in   transposed: columns take the part of rows
std::vector<int> coveredRows(OtherRenderer& renderer, bool transposed)
{
    const QSize size = transposed ? QSize(kRows, kApart * kPlaces) : QSize(kApart * kPlaces, kRows);
    Scene scene = emptyScene();
    const auto corner = [&](double x, double y) { return transposed ? clipAt(y, x, size) : clipAt(x, y, size); };
    const auto centreOf = [](int k) { return kApart * k + 1.5; };
    for (int k = 0; k < kPlaces; ++k) {
        const double right = centreOf(k) + (k + 0.5) / kPlaces; // half way between two steps is never met
        addFace(scene, {corner(right - 1, 0), corner(right, kRows), corner(centreOf(k) + 1.25, 0)});
    }
    const std::vector<std::uint16_t> coverage = coverageOf(renderer, scene, size);
    std::vector<int> rows;
    for (int k = 0; k < kPlaces; ++k) {
        int covered = 0;
        const int column = static_cast<int>(centreOf(k));
        for (int row = 0; row < kRows; ++row) {
            const int at = transposed ? column * kRows + row : row * size.width() + column;
            covered += coverage[static_cast<std::size_t>(at)] > 0 ? 1 : 0;
        }
        rows.push_back(covered);
    }
    return rows;
}

struct Snapping {
    int step;      ///< in 1024ths of a pixel
    bool isMiddle; ///< the first step begins half a step before the first place
};

Snapping snappingOf(const std::vector<int>& rows)
{
    std::vector<int> runs{1};
    for (std::size_t i = 1; i < rows.size(); ++i)
        if (rows[i] == rows[i - 1])
            ++runs.back();
        else
            runs.push_back(1);
    const int first = runs.front();
    int step = kPlaces;
    if (runs.size() > 3) {
        std::vector<int> whole(runs.begin() + 1, runs.end() - 1);
        std::ranges::nth_element(whole, whole.begin() + static_cast<std::ptrdiff_t>(whole.size() / 2));
        step = whole[whole.size() / 2];
    } else if (*std::ranges::max_element(runs) < kPlaces * 3 / 4) {
        step = kPlaces / 2;
    }
    return {step, first < step};
}

OwnedSides sidesOwned(bool top, bool left, bool bottom, bool right)
{
    if (top && left && bottom && right)
        return OwnedSides::All;
    if (!top && !left && !bottom && !right)
        return OwnedSides::None;
    if (top == bottom || left == right)
        return OwnedSides::Other;
    return top ? (left ? OwnedSides::TopLeft : OwnedSides::TopRight)
               : (left ? OwnedSides::BottomLeft : OwnedSides::BottomRight);
}

/// A square whose sides run through the centres of pixels, cut by a diagonal that does as well.
void findTies(OtherRenderer& renderer, RendererTraits& traits)
{
    constexpr int kSide = 16;
    constexpr int kLow = 4; ///< first and last pixels whose centres lie on the border
    constexpr int kHigh = 10;
    const QSize size(kSide, kSide);
    const auto corner = [&](int x, int y) { return clipAt(x + 0.5, y + 0.5, size); };
    Scene scene = emptyScene();
    addFace(scene, {corner(kLow, kLow), corner(kLow, kHigh), corner(kHigh, kLow)});
    addFace(scene, {corner(kHigh, kHigh), corner(kHigh, kLow), corner(kLow, kHigh)});
    const std::vector<std::uint16_t> coverage = coverageOf(renderer, scene, size);
    const auto at = [&](int x, int y) { return coverage[static_cast<std::size_t>(y * kSide + x)]; };
    constexpr int kBetween = kLow + 2; ///< beside the diagonal
    traits.sides =
        sidesOwned(at(kBetween, kLow) > 0, at(kLow, kBetween) > 0, at(kBetween, kHigh) > 0, at(kHigh, kBetween) > 0);
    traits.diagonalOnce = true;
    for (int x = kLow + 1; x < kHigh; ++x)
        traits.diagonalOnce = traits.diagonalOnce && at(x, kLow + kHigh - x) == 1;
}

} // namespace

const char* idOf(OwnedSides sides)
{
    switch (sides) {
    case OwnedSides::TopLeft: return "top-left";
    case OwnedSides::TopRight: return "top-right";
    case OwnedSides::BottomLeft: return "bottom-left";
    case OwnedSides::BottomRight: return "bottom-right";
    case OwnedSides::All: return "inclusive";
    case OwnedSides::None: return "exclusive";
    case OwnedSides::Other: break;
    }
    return "other";
}

RendererTraits traitsOf(OtherRenderer& renderer)
{
    RendererTraits traits;
    const Snapping across = snappingOf(coveredRows(renderer, false));
    const Snapping down = snappingOf(coveredRows(renderer, true));
    const int step = std::max({across.step, down.step, 1});
    traits.subpixelBits = static_cast<int>(std::lround(std::log2(static_cast<double>(kPlaces) / step)));
    traits.orMore = step == 1;
    traits.nearest = !traits.orMore && across.isMiddle && down.isMiddle;
    findTies(renderer, traits);
    return traits;
}

} // namespace rasterlens
