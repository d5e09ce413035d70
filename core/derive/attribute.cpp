#include "core/derive/topic_list.h"

#include <QCoreApplication>

#include <algorithm>
#include <stdexcept>

namespace rasterlens
{
namespace
{

/// An attribute: what shading carries it as the first of its floats, and what the parts are called.
struct AttributeInfo {
    Shading shading;
    std::vector<const char*> parts;
    const char* words; ///< QT_TRANSLATE_NOOP("Derive", ...)
};

const AttributeInfo kAttributes[] = {
    {Shading::Gouraud,
     {"r", "g", "b"},
     QT_TRANSLATE_NOOP("Derive",
                       "The colour at the pixel (0 to 1, lit at the corners): the %1 of the three corners, each "
                       "times its weight.")},
    {Shading::Uv,
     {"u", "v"},
     QT_TRANSLATE_NOOP("Derive", "The texture coordinates: the %1 of the three corners, each times its weight.")},
    {Shading::Normals,
     {"n_x", "n_y", "n_z"},
     QT_TRANSLATE_NOOP("Derive",
                       "The normal: the %1 of the three corners, each times its weight. The sum is shorter than 1 "
                       "where the normals differ, and is made 1 long again before it is used.")},
};

/// The triangle of a record of the same face that has these corners. Records that differ in shading have equal
/// triangles.
const ScreenTriangle& triangleAt(const StepLog& log, const ScreenTriangle& wanted)
{
    for (const std::uint32_t i : log.eventsOf(StepKind::Triangle)) {
        const ScreenTriangle& screen = log.triangle(log.event(i))->screen;
        if (std::ranges::equal(screen.vertices, wanted.vertices, {}, &ScreenVertex::position, &ScreenVertex::position))
            return screen;
    }
    throw std::logic_error("a shading has moved a triangle");
}

/// Colours as whole numbers: rounded once at the end, or cut off in each product.
void writeBytes(DerivationWriter& writer, const CanvasPart& point)
{
    writer.line(formula("{r_byte}"), formula("floor(255 * {r} + 0.5)"),
                QT_TRANSLATE_NOOP("Derive", "The red that is stored: rounded once, to a whole number up to 255."),
                {point});
    writer.line(
        formula("{r_cut}"),
        formula("floor(255 * {alpha_p} * {r_A}) + floor(255 * {beta_p} * {r_B}) + floor(255 * {gamma_p} * {r_C})"),
        QT_TRANSLATE_NOOP("Derive", "A colour type of bytes cuts off every product: the sum is up to 3 too dark."),
        {point});
}

/// Writes the sums of one attribute at the sample.
void writeAttribute(DerivationWriter& writer, const FaceRecord& record, const SampledTriangle& sample,
                    const AttributeInfo& attribute)
{
    Settings settings = record.settings();
    settings.shading = attribute.shading;
    StepFilter geometry;
    geometry.kinds = kindBit(StepKind::Triangle) | kindBit(StepKind::Setup);
    const std::shared_ptr<const StepLog> log = record.logOf(settings, geometry);
    const ScreenTriangle& triangle = triangleAt(*log, sample.triangle->screen);
    const SampledFragment fragment = fragmentOf(record, sample, settings);
    const CanvasPart point{CanvasKind::Sample, QStringLiteral("P"), {record.pixels(sample.point)}};
    for (std::size_t k = 0; k < attribute.parts.size(); ++k) {
        const QString name = QLatin1String(attribute.parts[k]);
        for (std::size_t i = 0; i < 3; ++i) {
            const ScreenVertex& corner = triangle.vertices[i];
            writer.given(name + QLatin1Char('_') + cornerLetter(i), corner.varyings[k],
                         {CanvasKind::Corner, cornerLetter(i), {record.pixels(corner.position)}});
        }
        writer.given(name, inFewestDigits(fragment.numbers.varyings[k]), point);
        writer.line(formula("{%1}", name), formula("{alpha_p} * {%1_A} + {beta_p} * {%1_B} + {gamma_p} * {%1_C}", name),
                    {attribute.words, {name}}, {point});
        writer.line(formula("{%1_affine}", name),
                    formula("{alpha} * {%1_A} + {beta} * {%1_B} + {gamma} * {%1_C}", name),
                    QT_TRANSLATE_NOOP("Derive",
                                      "With the weights on the screen instead: what affine interpolation would show."),
                    {point});
    }
    if (attribute.shading == Shading::Gouraud)
        writeBytes(writer, point);
}

} // namespace

Derivation deriveAttribute(const Scene& scene, const Settings& settings, const DerivationPlace& place,
                           const std::stop_token& stop)
{
    const FaceRecord record(scene, withArea(settings), place, stop);
    const SampledTriangle sample = sampleOf(record, SampleNeed::Inside);
    const SampledFragment fragment = fragmentOf(record, sample, record.settings());
    DerivationWriter writer(DerivationTopic::Attribute, pixelReason(record, sample));
    constexpr const char* kNames[] = {"alpha", "beta", "gamma"};
    const auto& corners = sample.triangle->screen.vertices;
    for (std::size_t i = 0; i < 3; ++i) {
        const CanvasPart corner{CanvasKind::Corner, cornerLetter(i), {record.pixels(corners[i].position)}};
        writer.given(QLatin1String(kNames[i]), fragment.numbers.screen[i], corner);
        writer.given(QLatin1String(kNames[i]) + QStringLiteral("_p"), fragment.numbers.weights[i], corner);
    }
    for (const AttributeInfo& attribute : kAttributes)
        writeAttribute(writer, record, sample, attribute);
    return writer.take();
}

} // namespace rasterlens
