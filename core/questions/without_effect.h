#pragma once
#include "core/base/reason.h"
#include "core/settings/numbers_field.h"
#include "core/settings/settings.h"

#include <optional>

namespace rasterlens
{

/// Why no value of a field has an effect beside the other settings, whatever the scene: a sentence of the context
/// "Applicability"; nothing where one may have.
[[nodiscard]] std::optional<Reason> whyWithoutEffect(const SettingsField& field, const Settings& settings,
                                                     bool sceneHasLines = false);
[[nodiscard]] std::optional<Reason> whyWithoutEffect(const NumbersField& field, const Settings& settings);

} // namespace rasterlens
