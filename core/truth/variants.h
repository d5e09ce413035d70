#pragma once
#include "core/settings/settings.h"

#include <span>

namespace rasterlens
{

struct Scene;

/// One way to draw a scene: what is measured, what a dot of the plot is, what a column of the hard cases is.
struct Variant {
    const char* id;      ///< stable: command line, JSON
    const char* changes; ///< `FIELD=VALUE FIELD=VALUE ..` of the field table; nothing in asGiven()
};

/// Every variant, algorithm by algorithm. The first, `edge-equation`, is what Settings are by default.
[[nodiscard]] std::span<const Variant> variants();

/// `as-given`, which changes nothing: whatever the base is. It is none of variants(), one of which it may equal.
[[nodiscard]] const Variant& asGiven();

/// One of variants(), or asGiven(), or null.
[[nodiscard]] const Variant* findVariant(const QString& id);

/// asGiven(): the base. Others: the base with the variant's changes. What variants vary (algorithm, number type,
/// subpixel bits, stepping, depth format, interpolation, attribute path, samples) is first set to its default;
/// everything else stays as it is in the base: size, camera, culling, shading, threads, vector instructions.
[[nodiscard]] Settings settingsOf(const Variant& variant, const Settings& base);

/// Whether settingsOf() has one value of this field whatever the base says.
[[nodiscard]] bool decides(const Variant& variant, const SettingsField& field);

/// The settings with the variant's changes and nothing else: the way to draw a hard case, whose settings are its own.
[[nodiscard]] Settings changedBy(const Variant& variant, Settings settings);

/// `Edge equation; Number type: Float, 32 bit; Stepping: Direct`. `translate` is handed texts of the context
/// "Settings"; without it the title is English. asGiven() has none.
[[nodiscard]] QString titleOf(const Variant& variant, QString (*translate)(const char* text) = nullptr);

/// The variants that can draw the scene with this base, on this machine; in the order of variants().
[[nodiscard]] std::vector<const Variant*> supportedVariants(const Scene& scene, const Settings& base);

} // namespace rasterlens
