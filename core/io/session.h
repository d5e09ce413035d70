#pragma once
#include "core/scene/scene.h"

#include <QJsonObject>

#include <map>

namespace rasterlens
{

/// What the window was doing: a scene by name, its vertices that the user moved, and the settings. A `.json` file.
struct Session {
    QString scene;        ///< as loadScene takes it; relative paths are relative to the session file
    QJsonObject settings; ///< those that differ from the scene's, or all
    std::map<std::uint32_t, glm::vec4> vertices; ///< index -> position in the scene's space
};

struct SessionLoad {
    std::optional<Session> session;
    Diagnostics diagnostics;
};

/// Reads `{"rasterlens": 1, "scene": NAME, "settings": {..}, "vertices": {"0": [x, y, z, w], ..}}`.
///
/// errors  diagnostics with file and (for broken JSON) line: not JSON, unknown keys, values out of range
[[nodiscard]] SessionLoad loadSession(const QString& path);

/// The session's settings over those of its scene.
[[nodiscard]] Settings settingsOf(const Session& session, const Settings& base);

/// The vertices that lie elsewhere than in `original`, which has as many; finite positions only.
[[nodiscard]] std::map<std::uint32_t, glm::vec4> movedVertices(const Mesh& original, const Mesh& edited);

/// Moves the vertices. The bounding sphere stays: the camera is not to run after them.
///
/// errors  a diagnostic if the scene has no such vertex
[[nodiscard]] Diagnostics moveVertices(Scene& scene, const Session& session, const QString& sessionPath);

/// Writes the file whole or not at all.
///
/// errors  why it could not be written: a sentence without the file name, of the context "Diagnostic"
[[nodiscard]] std::optional<Reason> saveSession(const Session& session, const QString& path);

} // namespace rasterlens
