#pragma once
#include <QSettings>
#include <QString>

namespace rasterlens
{

/// The format of the file in which the window keeps what it remembers: JSON, written whole or not at all. Qt's own
/// formats do not notice that a full disk took only a part, and lose the file that was there.
///
/// covers  texts, numbers, truth values, byte arrays and lists of texts
[[nodiscard]] QSettings::Format settingsFormat();

/// Makes it the format of every `QSettings()` from here on, and takes over what earlier versions kept.
///
/// in      the names of organization and application are set
void useSettingsFormat();

/// Why what the window remembers could not be kept; empty if it could.
[[nodiscard]] QString settingsProblem();

} // namespace rasterlens
