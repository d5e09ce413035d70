#include "core/derive/topic_list.h"

#include "core/pipeline/geometry.h"
#include "core/pipeline/resolve.h"

#include <QCoreApplication>

#include <algorithm>

namespace rasterlens
{
namespace
{

/// So many faces of the order are written down at most: those around the face that is asked for.
constexpr std::size_t kMostFaces = 8;

/// The part of the order that is written down.
std::span<const std::uint32_t> excerpt(std::span<const std::uint32_t> order, std::uint32_t face)
{
    const auto place = static_cast<std::size_t>(std::ranges::find(order, face) - order.begin());
    const std::size_t count = std::min(order.size(), kMostFaces);
    const std::size_t first = std::min(place - std::min(place, count / 2), order.size() - count);
    return order.subspan(first, count);
}

void writeKey(DerivationWriter& writer, const Scene& scene, const Settings& settings, std::uint32_t face,
              std::size_t place, bool perspective)
{
    const auto corners = vertexTable(scene, settings, face);
    const QString number = QString::number(face);
    CanvasPart area = areaPart(QStringLiteral("face %1").arg(number), {});
    for (const VertexRow& corner : corners)
        area.points.push_back(corner.screen);
    for (std::size_t i = 0; i < 3; ++i) {
        const CanvasPart part{CanvasKind::Corner, cornerLetter(i), {corners[i].screen}};
        const glm::dvec4& clip = corners[i].clip;
        writer.given(formula("d_%1%2", cornerLetter(i), number), perspective ? clip.w : clip.z / clip.w, part);
    }
    writer.show(formula("key_%1", number), area);
    writer.line(
        formula("{key_%1}", number), formula("({d_A%1} + {d_B%1} + {d_C%1}) / 3", number),
        perspective
            ? Reason(QT_TRANSLATE_NOOP("Derive", "Face %1 is number %2 in the order: the mean distance of its corners "
                                                 "(w of clip space) is its sort key."),
                     {face, static_cast<int>(place)})
            : Reason(QT_TRANSLATE_NOOP("Derive", "Face %1 is number %2 in the order: the mean depth of its corners (z "
                                                 "/ w) is its sort key."),
                     {face, static_cast<int>(place)}),
        {area});
}

} // namespace

Derivation derivePainter(const Scene& scene, const Settings& settings, const DerivationPlace& place,
                         const std::stop_token& stop)
{
    Settings painted = settings;
    painted.visibility = Visibility::Painter;
    const Resolved resolved = resolve(painted, scene);
    const std::vector<std::uint32_t> order = Geometry(scene, resolved.matrices, resolved.rules).order();
    if (stop.stop_requested())
        throw NoDerivation{QString()};
    DerivationWriter writer(DerivationTopic::Painter,
                            {QT_TRANSLATE_NOOP("Derive", "face %1 among %2"), {place.face, order.size()}});
    const std::span<const std::uint32_t> shown = excerpt(order, place.face);
    const auto first = static_cast<std::size_t>(std::ranges::find(order, shown.front()) - order.begin());
    const bool perspective = scene.space == SceneSpace::Object && !resolved.rules.orthographic;
    const bool rising = resolved.rules.reversedZ && !perspective;
    for (std::size_t i = 0; i < shown.size(); ++i) {
        writeKey(writer, scene, painted, shown[i], first + i, perspective);
        if (i > 0)
            writer.compare(
                formula(rising ? "{key_%1} <= {key_%2}" : "{key_%1} >= {key_%2}", QString::number(shown[i - 1]),
                        QString::number(shown[i])),
                {QT_TRANSLATE_NOOP("Derive", "Face %1 is painted before face %2, which covers it wherever both lie. "
                                             "Of equal keys the one that comes first in the mesh stays first."),
                 {shown[i - 1], shown[i]}});
    }
    return writer.take();
}

} // namespace rasterlens
