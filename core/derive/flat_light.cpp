#include "core/derive/topic_list.h"

#include "core/pipeline/shading.h"
#include "core/pipeline/unsnapped.h"

#include <QCoreApplication>

#include <algorithm>
#include <vector>

namespace rasterlens
{
namespace
{

void giveVector(DerivationWriter& writer, const QString& name, const glm::dvec3& v, const CanvasPart& canvas)
{
    constexpr const char* kAxes[] = {"_x", "_y", "_z"};
    for (int i = 0; i < 3; ++i)
        writer.given(name + QLatin1String(kAxes[i]), v[i], canvas);
}

/// The normal and the way to the light as vectors from the middle of a face, as the camera sees them: foreshortened,
/// and both in one scale.
struct LightVectors {
    CanvasPart normal;
    CanvasPart light;
};

LightVectors lightVectors(const FaceRecord& record)
{
    const auto& corners = record.corners();
    glm::dvec3 middle(0);
    glm::dvec3 normal = glm::cross(glm::dvec3(corners[1].object - corners[0].object),
                                   glm::dvec3(corners[2].object - corners[0].object));
    for (const VertexRow& corner : corners)
        middle += glm::dvec3(corner.object) / 3.0;
    normal = glm::normalize(normal);
    const glm::dvec3 light(record.rules().light);
    const glm::dmat4 clipFromObject = record.matrices().clipFromObjectDouble;
    const auto clip = [&](const glm::dvec3& point) { return clipFromObject * glm::dvec4(point, 1); };
    const auto seen = [&](const glm::dvec3& point) {
        return record.pixels(unsnappedPosition(clip(point), record.rules()));
    };
    const double distance = clip(middle).w;
    if (!(distance > 0)) // behind the eye
        return {{CanvasKind::Vector, QStringLiteral("n"), {}}, {CanvasKind::Vector, QStringLiteral("l"), {}}};
    constexpr double kShort = 1e-4; // of the distance: what is seen of it is as good as straight
    const double step = kShort * distance;
    const glm::dvec2 from = seen(middle);
    const glm::dvec2 ofNormal = seen(middle + step * normal) - from;
    const glm::dvec2 ofLight = seen(middle + step * light) - from;
    constexpr double kLongest = 0.2; // of the picture
    const QSize size = record.settings().size;
    const double scale = kLongest * std::min(size.width(), size.height()) /
                         std::max({glm::length(ofNormal), glm::length(ofLight), 1e-12});
    return {vectorPart(QStringLiteral("n"), from, from + scale * ofNormal),
            vectorPart(QStringLiteral("l"), from, from + scale * ofLight)};
}

void writeNormal(DerivationWriter& writer, const FaceRecord& record, const CanvasPart& normal)
{
    const auto corner = [&](std::size_t i) {
        return CanvasPart{CanvasKind::Corner, cornerLetter(i), {record.corners()[i].screen}};
    };
    for (std::size_t i = 0; i < 3; ++i)
        giveVector(writer, cornerLetter(i), glm::dvec3(record.corners()[i].object), corner(i));
    for (const char* to : {"B", "C"}) {
        const QString end = QLatin1String(to);
        const CanvasPart part = vectorPart(QLatin1Char('A') + end, record.corners()[0].screen,
                                           record.corners()[end == QLatin1String("B") ? 1 : 2].screen);
        for (const char* axis : {"_x", "_y", "_z"})
            writer.show(QLatin1Char('A') + end + QLatin1String(axis), part);
        writer.line(formula("({A%1_x}, {A%1_y}, {A%1_z})", end),
                    formula("({%1_x} - {A_x}, {%1_y} - {A_y}, {%1_z} - {A_z})", end),
                    {QT_TRANSLATE_NOOP("Derive", "From A to %1, in the space of the mesh."), {end}}, {part});
    }
    for (const char* name : {"N_x", "N_y", "N_z", "n_x", "n_y", "n_z"})
        writer.show(QLatin1String(name), normal);
    writer.line(formula("({N_x}, {N_y}, {N_z})"),
                formula("({AB_y} * {AC_z} - {AB_z} * {AC_y}, {AB_z} * {AC_x} - {AB_x} * {AC_z}, "
                        "{AB_x} * {AC_y} - {AB_y} * {AC_x})"),
                QT_TRANSLATE_NOOP("Derive", "AB x AC stands at right angles to the face."), {normal});
    writer.line(formula("{length}"), formula("sqrt({N_x} * {N_x} + {N_y} * {N_y} + {N_z} * {N_z})"),
                QT_TRANSLATE_NOOP("Derive", "Its length is twice the area."), {normal});
    writer.line(formula("({n_x}, {n_y}, {n_z})"), formula("({N_x} / {length}, {N_y} / {length}, {N_z} / {length})"),
                QT_TRANSLATE_NOOP("Derive", "The normal, of length 1."), {normal});
}

/// The light of a text that shines along the gaze, on a normal that its order of the corners has turned round.
void writeHeadlight(DerivationWriter& writer)
{
    writer.line(formula("{n.l_head}"), formula("(-{n_x}) * 0 + (-{n_y}) * 0 + (-{n_z}) * (-1)"),
                QT_TRANSLATE_NOOP("Derive",
                                  "A text that takes AC x AB has -n, and lets light travel along (0, 0, -1), away from "
                                  "the eye. Both signs cancel out: its n . l is the z of the normal."));
    writer.line(formula("{grey}"), formula("floor(255 * max({n.l_head}, 0))"),
                QT_TRANSLATE_NOOP(
                    "Derive", "Its colour is n . l alone, from black to white; where n . l is not positive it draws "
                              "nothing."));
}

/// Where l comes from.
Reason aboutLight(const Light& light)
{
    if (light.isHead())
        return QT_TRANSLATE_NOOP("Derive",
                                 "The headlight: l is the camera's backward axis, from the scene to the eye, and has "
                                 "length 1, so n . l is the cosine of the angle between the normal and the gaze.");
    return QT_TRANSLATE_NOOP("Derive", "l points to the light and has length 1, so n . l is the cosine of the angle "
                                       "between the two.");
}

void writeLight(DerivationWriter& writer, const FaceRecord& record, const LightVectors& vectors)
{
    const Scene& scene = record.scene();
    const std::uint32_t face = record.place().face;
    Rules rules = record.rules();
    rules.shading = Shading::Flat;
    giveVector(writer, QStringLiteral("l"), glm::dvec3(rules.light), vectors.light);
    const std::vector<CanvasPart> both{vectors.normal, vectors.light};
    writer.line(formula("{n.l}"), formula("{n_x} * {l_x} + {n_y} * {l_y} + {n_z} * {l_z}"),
                aboutLight(record.settings().light), both);
    writer.compare(formula("{n.l} > 0"),
                   QT_TRANSLATE_NOOP("Derive",
                                     "Whether the light falls on the front. A program that draws faces only where it "
                                     "holds takes the light for the eye."),
                   both);
    writer.given(QStringLiteral("ambient"), inFewestDigits(kAmbient));
    writer.given(QStringLiteral("diffuse"), inFewestDigits(kDiffuse));
    writer.line(formula("{brightness}"), formula("{ambient} + {diffuse} * max({n.l}, 0)"),
                QT_TRANSLATE_NOOP("Derive",
                                  "Some light is everywhere; the rest grows with the cosine, and never takes light "
                                  "away."));
    const MeshVertex& first = scene.mesh.vertices[scene.mesh.indices[3 * std::size_t(face)]];
    const std::uint32_t color = faceUniforms(scene, face, rules).color;
    constexpr const char* kChannels[] = {"r", "g", "b"};
    for (int i = 0; i < 3; ++i) {
        const QString channel = QLatin1String(kChannels[i]);
        writer.given(QStringLiteral("c_") + channel, inFewestDigits(first.color[i]));
        writer.given(channel, color >> (16 - 8 * i) & 255U);
    }
    writer.line(
        formula("({r}, {g}, {b})"),
        formula("(floor(255 * min({c_r} * {brightness}, 1) + 0.5), floor(255 * min({c_g} * {brightness}, 1) + 0.5), "
                "floor(255 * min({c_b} * {brightness}, 1) + 0.5))"),
        QT_TRANSLATE_NOOP("Derive", "The colour of the face: that of its first corner times the brightness, as whole "
                                    "numbers up to 255."));
    writeHeadlight(writer);
}

} // namespace

Derivation deriveFlatLight(const Scene& scene, const Settings& settings, const DerivationPlace& place,
                           const std::stop_token& stop)
{
    if (!scene.lit)
        throw NoDerivation{QT_TRANSLATE_NOOP("Derive", "this scene has no light: its colours are shown as they are")};
    if (settings.fill != Fill::Solid)
        throw NoDerivation{QT_TRANSLATE_NOOP("Derive", "lines and points are drawn in the colours of the model: no "
                                                       "light falls on them")};
    const FaceRecord record(scene, settings, place, stop);
    DerivationWriter writer(DerivationTopic::FlatLight, faceReason(record));
    const auto& corners = record.corners();
    const glm::dvec3 a(corners[0].object);
    if (glm::cross(glm::dvec3(corners[1].object) - a, glm::dvec3(corners[2].object) - a) == glm::dvec3(0))
        throw NoDerivation{Reason(QT_TRANSLATE_NOOP("Derive", "face %1 has no area, and so no normal"), {place.face})};
    const LightVectors vectors = lightVectors(record);
    writeNormal(writer, record, vectors.normal);
    writeLight(writer, record, vectors);
    return writer.take();
}

} // namespace rasterlens
