#pragma once
#include "core/scene.h"

namespace rasterlens
{

/// What the window was doing: a scene by name and the settings. A `.json` file.
struct Session {
    QString scene; ///< as loadScene takes it; relative paths are relative to the session file
    Settings settings;
};

struct SessionLoad {
    std::optional<Session> session;
    Diagnostics diagnostics;
};

/// Reads `{"rasterlens": 1, "scene": NAME, "settings": {..}}`.
///
/// errors  diagnostics with file and (for broken JSON) line: not JSON, unknown keys, values out of range
[[nodiscard]] SessionLoad loadSession(const QString& path);

/// Writes the file whole or not at all.
///
/// errors  a sentence why it could not be written
[[nodiscard]] std::optional<QString> saveSession(const Session& session, const QString& path);

} // namespace rasterlens
