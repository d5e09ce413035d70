#include "core/truth/experiment_export.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace rasterlens
{
namespace
{

constexpr const char* kColumns[] = {
    "scene", "variant",    "renderer", "threads",   "simd",     "ms",      "ns_per_covered_pixel",
    "ratio", "mtri_per_s", "error",    "reference", "frontier", "settings"};

template <class Part, class Value>
QJsonValue valueOf(const std::optional<Part>& part, Value Part::*member)
{
    return part ? QJsonValue(static_cast<double>(*part.*member)) : QJsonValue();
}

QJsonObject errorJson(const VariantError& error)
{
    using E = VariantError;
    QJsonValue psnr = valueOf(error.color, &E::Color::psnrDb);
    if (psnr.isDouble() && std::isinf(psnr.toDouble()))
        psnr = kInfinitePsnr;
    return {{"missing_pixels", valueOf(error.coverage, &E::Coverage::missing)},
            {"extra_pixels", valueOf(error.coverage, &E::Coverage::extra)},
            {"hit_twice", valueOf(error.coverage, &E::Coverage::hitTwice)},
            {"depth_max", valueOf(error.depth, &E::Depth::max)},
            {"depth_mean", valueOf(error.depth, &E::Depth::mean)},
            {"color_max", valueOf(error.color, &E::Color::max)},
            {"color_mean", valueOf(error.color, &E::Color::mean)},
            {"psnr", psnr}};
}

QJsonObject ratioJson(const std::optional<TimeRatio>& ratio)
{
    return {{"to", ratio ? QJsonValue(ratio->to) : QJsonValue()},
            {"median", valueOf(ratio, &TimeRatio::median)},
            {"p10", valueOf(ratio, &TimeRatio::p10)},
            {"p90", valueOf(ratio, &TimeRatio::p90)}};
}

QJsonObject rendererJson(const std::optional<RendererFacts>& other)
{
    if (!other)
        return {{"name", "RasterLens"},
                {"subpixel_bits", QJsonValue()},
                {"snaps", QJsonValue()},
                {"tie_rule", QJsonValue()}};
    const RendererTraits& traits = other->traits;
    return {{"name", other->name},
            {"subpixel_bits", traits.subpixelBits},
            {"snaps", traits.nearest ? "nearest" : "down"},
            {"tie_rule", QLatin1String(idOf(traits.sides))}};
}

QJsonObject rowJson(const ExperimentRow& row)
{
    Settings instructions;
    instructions.simd = row.simd;
    const bool timed = row.ms.frames > 0;
    const auto ifTimed = [&](double value) { return timed ? QJsonValue(value) : QJsonValue(); };
    return {{"scene", row.scene},
            {"variant", row.variant},
            {"settings", toJson(row.settings)},
            {"threads", row.threads},
            {"simd", valueId(*findSettingsField(QStringLiteral("simd")), instructions)},
            {"ms", QJsonObject{{"median", ifTimed(row.ms.median)},
                               {"p10", ifTimed(row.ms.p10)},
                               {"p90", ifTimed(row.ms.p90)},
                               {"min", ifTimed(row.ms.min)},
                               {"processor", ifTimed(row.ms.processor)},
                               {"batch", row.ms.batch}}},
            {"ratio", ratioJson(row.ratio)},
            {"renderer", rendererJson(row.other)},
            {"ns_per_covered_pixel", row.nsPerCoveredPixel > 0 ? QJsonValue(row.nsPerCoveredPixel) : QJsonValue()},
            {"mtri_per_s", ifTimed(row.mtriPerS)},
            {"error", errorJson(row.error)},
            {"reference", row.reference ? QJsonValue(QLatin1String(idOf(*row.reference))) : QJsonValue()},
            {"frontier", row.frontier}};
}

/// Names and texts of the values below a JSON value.
struct Cells {
    QStringList names;
    QStringList texts;

    void add(const QString& name, const QJsonValue& value)
    {
        if (value.isObject()) {
            const QJsonObject object = value.toObject();
            for (auto it = object.begin(); it != object.end(); ++it)
                add(name + QLatin1Char('_') + it.key(), it.value());
            return;
        }
        names << name;
        texts << text(value);
    }

private:
    static QString text(const QJsonValue& value)
    {
        if (value.isArray()) {
            QStringList parts;
            const QJsonArray elements = value.toArray();
            for (const QJsonValue element : elements)
                parts << text(element);
            return parts.join(QLatin1Char(' '));
        }
        QString plain = value.toVariant().toString();
        if (plain.contains(QLatin1Char(',')) || plain.contains(QLatin1Char('"')) || plain.contains(QLatin1Char('\n')))
            plain = QLatin1Char('"') + plain.replace(QLatin1Char('"'), QLatin1String("\"\"")) + QLatin1Char('"');
        return plain;
    }
};

Cells cellsOf(const ExperimentRow& row)
{
    const QJsonObject json = rowJson(row);
    Cells cells;
    for (const char* column : kColumns)
        cells.add(QLatin1String(column), json[QLatin1String(column)]);
    return cells;
}

} // namespace

QByteArray experimentJson(std::span<const ExperimentRow> rows)
{
    QJsonArray array;
    for (const ExperimentRow& row : rows)
        array.append(rowJson(row));
    return QJsonDocument(array).toJson();
}

QByteArray experimentCsv(std::span<const ExperimentRow> rows)
{
    std::vector<Cells> lines;
    QStringList names;
    for (const ExperimentRow& row : rows) {
        lines.push_back(cellsOf(row));
        for (const QString& name : lines.back().names) // a view need not have all values
            if (!names.contains(name))
                names << name;
    }
    QString csv = names.join(QLatin1Char(',')) + QLatin1Char('\n');
    for (const Cells& cells : lines) {
        QStringList texts;
        for (const QString& name : names)
            texts << cells.texts.value(cells.names.indexOf(name));
        csv += texts.join(QLatin1Char(',')) + QLatin1Char('\n');
    }
    return csv.toUtf8();
}

} // namespace rasterlens
