#include "core/truth/variants.h"

#include "core/render/render.h"

#include <algorithm>
#include <cassert>

namespace rasterlens
{
namespace
{

constexpr const char* kVariedFields[] = {"algorithm",    "number-type",   "subpixel-bits",  "stepping",
                                         "depth-format", "interpolation", "attribute-path", "samples"};

constexpr Variant kVariants[] = {
    {"edge-equation", "algorithm=edge-equation"},
    {"edge-equation-direct", "algorithm=edge-equation stepping=direct"},
    {"edge-equation-float32", "algorithm=edge-equation number-type=float32"},
    {"edge-equation-float32-direct", "algorithm=edge-equation number-type=float32 stepping=direct"},
    {"edge-equation-float64", "algorithm=edge-equation number-type=float64"},
    {"edge-equation-float64-direct", "algorithm=edge-equation number-type=float64 stepping=direct"},
    {"edge-equation-bits-0", "algorithm=edge-equation subpixel-bits=0"},
    {"edge-equation-bits-1", "algorithm=edge-equation subpixel-bits=1"},
    {"edge-equation-bits-2", "algorithm=edge-equation subpixel-bits=2"},
    {"edge-equation-bits-4", "algorithm=edge-equation subpixel-bits=4"},
    {"edge-equation-bits-6", "algorithm=edge-equation subpixel-bits=6"},
    {"edge-equation-affine", "algorithm=edge-equation interpolation=affine"},
    {"edge-equation-unorm24", "algorithm=edge-equation depth-format=unorm24"},
    {"edge-equation-unorm16", "algorithm=edge-equation depth-format=unorm16"},
    {"edge-equation-2x2", "algorithm=edge-equation samples=2x2"},
    {"edge-equation-4x4", "algorithm=edge-equation samples=4x4"},
    {"edge-equation-msaa4", "algorithm=edge-equation samples=msaa4"},

    {"edge-walking", "algorithm=edge-walking"},
    {"edge-walking-direct", "algorithm=edge-walking stepping=direct"},
    {"edge-walking-float32", "algorithm=edge-walking number-type=float32"},
    {"edge-walking-float32-direct", "algorithm=edge-walking number-type=float32 stepping=direct"},
    {"edge-walking-float64", "algorithm=edge-walking number-type=float64"},
    {"edge-walking-float64-direct", "algorithm=edge-walking number-type=float64 stepping=direct"},
    {"edge-walking-bits-0", "algorithm=edge-walking subpixel-bits=0"},
    {"edge-walking-bits-4", "algorithm=edge-walking subpixel-bits=4"},
    {"edge-walking-spans", "algorithm=edge-walking attribute-path=edge-then-span"},
    {"edge-walking-spans-float32", "algorithm=edge-walking attribute-path=edge-then-span number-type=float32"},
    {"edge-walking-spans-every-16", "algorithm=edge-walking attribute-path=edge-then-span interpolation=every-16"},
    {"edge-walking-spans-every-8", "algorithm=edge-walking attribute-path=edge-then-span interpolation=every-8"},
    {"edge-walking-spans-affine", "algorithm=edge-walking attribute-path=edge-then-span interpolation=affine"},
    {"edge-walking-affine", "algorithm=edge-walking interpolation=affine"},
    {"edge-walking-unorm16", "algorithm=edge-walking depth-format=unorm16"},
    {"edge-walking-2x2", "algorithm=edge-walking samples=2x2"},

    {"tiled", "algorithm=tiled"},
    {"tiled-1-thread", "algorithm=tiled threads=1"},
    {"tiled-scalar", "algorithm=tiled simd=scalar"},
    {"tiled-sse4", "algorithm=tiled simd=sse4"},
    {"tiled-avx2", "algorithm=tiled simd=avx2"},
    {"tiled-avx512", "algorithm=tiled simd=avx512"},
    {"tiled-neon", "algorithm=tiled simd=neon"},
    {"tiled-bits-0", "algorithm=tiled subpixel-bits=0"},
    {"tiled-bits-4", "algorithm=tiled subpixel-bits=4"},
    {"tiled-affine", "algorithm=tiled interpolation=affine"},
    {"tiled-unorm24", "algorithm=tiled depth-format=unorm24"},
    {"tiled-unorm16", "algorithm=tiled depth-format=unorm16"},
    {"tiled-2x2", "algorithm=tiled samples=2x2"},
    {"tiled-4x4", "algorithm=tiled samples=4x4"},
    {"tiled-msaa2", "algorithm=tiled samples=msaa2"},
    {"tiled-msaa4", "algorithm=tiled samples=msaa4"},
    {"tiled-msaa8", "algorithm=tiled samples=msaa8"},
    {"tiled-msaa16", "algorithm=tiled samples=msaa16"},
};

constexpr Variant kAsGiven{"as-given", ""};

/// Calls visit(field, text of the value) for every change.
template <class Visit>
void forEachChange(const Variant& variant, Visit&& visit)
{
    for (const QString& change : QString::fromLatin1(variant.changes).split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
        const SettingsField* field = findSettingsField(change.section(QLatin1Char('='), 0, 0));
        assert(field != nullptr);
        visit(*field, change.section(QLatin1Char('='), 1));
    }
}

} // namespace

std::span<const Variant> variants() { return kVariants; }

const Variant& asGiven() { return kAsGiven; }

const Variant* findVariant(const QString& id)
{
    if (id == QLatin1String(kAsGiven.id))
        return &kAsGiven;
    const auto found = std::find_if(std::begin(kVariants), std::end(kVariants),
                                    [&](const Variant& v) { return id == QLatin1String(v.id); });
    return found == std::end(kVariants) ? nullptr : found;
}

Settings settingsOf(const Variant& variant, const Settings& base)
{
    if (&variant == &kAsGiven)
        return base;
    Settings settings = base;
    const Settings defaults;
    for (const char* id : kVariedFields) {
        const SettingsField* field = findSettingsField(QLatin1String(id));
        field->set(settings, field->get(defaults));
    }
    return changedBy(variant, settings);
}

bool decides(const Variant& variant, const SettingsField& field)
{
    Settings low;
    Settings high;
    field.set(low, field.minimum);
    field.set(high, field.maximum);
    return field.get(settingsOf(variant, low)) == field.get(settingsOf(variant, high));
}

Settings changedBy(const Variant& variant, Settings settings)
{
    forEachChange(variant, [&](const SettingsField& field, const QString& value) {
        [[maybe_unused]] const auto error = setFromText(field, value, settings);
        assert(!error);
    });
    return settings;
}

QString titleOf(const Variant& variant, QString (*translate)(const char* text))
{
    const auto words = [&](const char* text) {
        return translate != nullptr ? translate(text) : QString::fromUtf8(text);
    };
    QStringList parts;
    forEachChange(variant, [&](const SettingsField& field, const QString& value) {
        const auto choice = std::find_if(field.choices.begin(), field.choices.end(),
                                         [&](const Choice& c) { return value == QLatin1String(c.id); });
        const QString title = choice != field.choices.end() ? words(choice->title) : value;
        parts << (parts.isEmpty() ? title : words(field.title) + QStringLiteral(": ") + title);
    });
    return parts.join(QStringLiteral("; "));
}

std::vector<const Variant*> supportedVariants(const Scene& scene, const Settings& base)
{
    std::vector<const Variant*> supported;
    for (const Variant& variant : kVariants)
        if (!unsupported(scene, settingsOf(variant, base)))
            supported.push_back(&variant);
    return supported;
}

} // namespace rasterlens
