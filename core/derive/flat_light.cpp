#include "core/derive/topic_list.h"

#include "core/pipeline/shading.h"

#include <QCoreApplication>

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

void writeNormal(DerivationWriter& writer, const FaceRecord& record)
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
    writer.line(formula("({N_x}, {N_y}, {N_z})"),
                formula("({AB_y} * {AC_z} - {AB_z} * {AC_y}, {AB_z} * {AC_x} - {AB_x} * {AC_z}, "
                        "{AB_x} * {AC_y} - {AB_y} * {AC_x})"),
                QT_TRANSLATE_NOOP("Derive", "AB x AC stands at right angles to the face."));
    writer.line(formula("{length}"), formula("sqrt({N_x} * {N_x} + {N_y} * {N_y} + {N_z} * {N_z})"),
                QT_TRANSLATE_NOOP("Derive", "Its length is twice the area."));
    writer.line(formula("({n_x}, {n_y}, {n_z})"), formula("({N_x} / {length}, {N_y} / {length}, {N_z} / {length})"),
                QT_TRANSLATE_NOOP("Derive", "The normal, of length 1."));
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

void writeLight(DerivationWriter& writer, const FaceRecord& record)
{
    const Scene& scene = record.scene();
    const std::uint32_t face = record.place().face;
    Rules rules = record.rules();
    rules.shading = Shading::Flat;
    giveVector(writer, QStringLiteral("l"), glm::dvec3(rules.light), {});
    writer.line(formula("{n.l}"), formula("{n_x} * {l_x} + {n_y} * {l_y} + {n_z} * {l_z}"),
                aboutLight(record.settings().light));
    writer.compare(formula("{n.l} > 0"),
                   QT_TRANSLATE_NOOP("Derive",
                                     "Whether the light falls on the front. A program that draws faces only where it "
                                     "holds takes the light for the eye."));
    writer.given(QStringLiteral("ambient"), kAmbient);
    writer.given(QStringLiteral("diffuse"), kDiffuse);
    writer.line(formula("{brightness}"), formula("{ambient} + {diffuse} * max({n.l}, 0)"),
                QT_TRANSLATE_NOOP("Derive",
                                  "Some light is everywhere; the rest grows with the cosine, and never takes light "
                                  "away."));
    const MeshVertex& first = scene.mesh.vertices[scene.mesh.indices[3 * std::size_t(face)]];
    const std::uint32_t color = faceUniforms(scene, face, rules).color;
    constexpr const char* kChannels[] = {"r", "g", "b"};
    for (int i = 0; i < 3; ++i) {
        const QString channel = QLatin1String(kChannels[i]);
        writer.given(QStringLiteral("c_") + channel, first.color[i]);
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
    writeNormal(writer, record);
    writeLight(writer, record);
    return writer.take();
}

} // namespace rasterlens
