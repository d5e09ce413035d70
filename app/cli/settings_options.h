#pragma once
#include "app/cli/options.h"
#include "core/scene/scene.h"
#include "core/settings/settings.h"

namespace rasterlens::cli
{

/// `--size`, the camera's options, and an option for every row of the field table.
[[nodiscard]] QList<OptionGroup> settingsOptionGroups();

/// Changes those of the settings that the command line names.
///
/// errors  throws Failure: a value that its option does not take, options that contradict each other
[[nodiscard]] Settings withOptions(Settings settings, const Arguments& arguments);

/// Why these settings cannot be drawn, or nothing; with the vector instructions there are where those asked for are
/// not.
[[nodiscard]] std::optional<QString> refusal(const Scene& scene, const Settings& settings);

/// The mistakes of these settings that are not in the mistake table.
[[nodiscard]] QStringList unknownMistakes(const Settings& settings);

/// A line for every mistake: its id, number and title, and the scene that shows it.
[[nodiscard]] QString mistakeList();

} // namespace rasterlens::cli
