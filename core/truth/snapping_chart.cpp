#include "core/truth/chart_list.h"

#include "core/base/grouped.h"
#include "core/pipeline/clipping.h"
#include "core/truth/exact_geometry.h"
#include "core/truth/exact_reference.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace rasterlens
{

using namespace exact;

namespace
{

constexpr int kMostBits = 8;
constexpr std::size_t kMostFaces = 20'000; ///< more take long, and change no share that is to be seen

int signOf(std::int64_t value) { return (value > 0) - (value < 0); }

/// The sense in which a polygon before the divide runs on the screen; 0: it has no area.
int senseOf(const std::vector<ScreenCorner>& polygon)
{
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
        if (const int sign = determinant({polygon[0], polygon[i], polygon[i + 1]}).sign(); sign != 0)
            return sign;
    return 0;
}

/// What became of the faces with so many subpixel bits.
struct Snappings {
    std::uint64_t faces = 0;
    std::uint64_t cut = 0;
    std::uint64_t turned = 0;
    std::uint64_t vanished = 0;
    std::uint64_t folded = 0;
};

void add(const ClipTriangle& triangle, const ExactOptions& options, Snappings& counts)
{
    const Lattice lattice = latticeOf(options);
    const std::vector<Corner> clipped =
        clipExactly(integerTriangle(triangle, options.sides.smallestW, glm::dmat4(1)), options.clipZ, options.sides);
    std::vector<ScreenCorner> corners;
    for (const Corner& corner : clipped)
        corners.push_back(toScreen(corner, triangle, lattice));
    const bool hasScreen =
        !corners.empty() && std::ranges::all_of(corners, [](const ScreenCorner& c) { return c.w.sign() > 0; });
    const int sense = hasScreen ? senseOf(corners) : 0;
    if (sense == 0)
        return;
    std::vector<Snapped> polygon;
    for (ScreenCorner& corner : corners)
        polygon.push_back(snap(corner, lattice));
    const int snapped = signOf(doubledArea(polygon));
    ++counts.faces;
    counts.turned += snapped == -sense ? 1 : 0;
    counts.vanished += snapped == 0 ? 1 : 0;
    if (polygon.size() == 3)
        return;
    ++counts.cut;
    counts.folded += snapped != 0 && isFolded(polygon, snapped) ? 1 : 0;
}

double share(std::uint64_t part, std::uint64_t whole)
{
    return whole == 0 ? std::nan("") : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

bool isFinite(const ClipTriangle& triangle)
{
    return std::ranges::all_of(triangle.vertices, [](const ClipVertex& vertex) {
        const glm::dvec4& p = vertex.positionClip;
        return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z) && std::isfinite(p.w);
    });
}

} // namespace

Chart snappingChart(const Scene& scene, const Settings& settings, const std::stop_token& stop)
{
    const std::vector<ClipTriangle> triangles = exactTriangles(scene, settings);
    ExactOptions options = exactOptions(scene, settings);
    options.snap = true;
    const std::size_t every = triangles.size() / kMostFaces + 1;
    Chart chart;
    chart.series = {{QT_TRANSLATE_NOOP("Chart", "turned over"), {}},
                    {QT_TRANSLATE_NOOP("Chart", "without area"), {}},
                    {QT_TRANSLATE_NOOP("Chart", "folded, of those that were cut"), {}}};
    Snappings counts;
    for (int bits = 0; bits <= kMostBits && !stop.stop_requested(); ++bits) {
        options.subpixelBits = bits;
        counts = {};
        for (std::size_t i = 0; i < triangles.size() && !stop.stop_requested(); i += every)
            if (isFinite(triangles[i]))
                add(triangles[i], options, counts);
        chart.x.push_back(bits);
        chart.series[0].y.push_back(share(counts.turned, counts.faces));
        chart.series[1].y.push_back(share(counts.vanished, counts.faces));
        chart.series[2].y.push_back(share(counts.folded, counts.cut));
    }
    chart.notes = {{QT_TRANSLATE_NOOP("Chart", "%1 faces in the view volume, %2 of them cut by its planes."),
                    {grouped(counts.faces), grouped(counts.cut)}}};
    return chart;
}

} // namespace rasterlens
