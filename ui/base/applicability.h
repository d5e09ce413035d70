#pragma once
#include "core/base/reason.h"
#include "core/settings/numbers_field.h"
#include "core/settings/settings.h"

#include <QString>

#include <optional>

namespace rasterlens
{

/// What whyWithoutEffect() says, in the language in use.
[[nodiscard]] std::optional<QString> withoutEffectText(const SettingsField& field, const Settings& settings,
                                                       bool sceneHasLines);
[[nodiscard]] std::optional<QString> withoutEffectText(const NumbersField& field, const Settings& settings);

/// What unsupported() says, in the language in use.
[[nodiscard]] QString whyUnsupported(const Reason& reason);

/// The next value of a field, first after last.
[[nodiscard]] Settings withNextValue(const SettingsField& field, const Settings& settings);
/// The settings with the value `other` of the field where it has the value `one`, and with `one` where it has any
/// other.
///
/// in  ids of two choices of the field
[[nodiscard]] Settings withOtherOf(const SettingsField& field, const char* one, const char* other,
                                   const Settings& settings);

/// The translated title of the present value; for `auto` also what it stands for on this machine.
[[nodiscard]] QString valueTitle(const SettingsField& field, const Settings& settings);

} // namespace rasterlens
