#pragma once
#include "core/scene/scene.h"

#include <QJsonObject>
#include <QStringList>

#include <map>

namespace rasterlens
{

/// What the window was doing: a scene by name, its vertices that the user edited, and the settings. A `.json` file.
struct Session {
    QString scene;                                ///< as loadScene takes it; a path is absolute
    QJsonObject settings;                         ///< those that differ from the scene's, or all
    std::map<std::uint32_t, glm::dvec4> vertices; ///< index -> position, as the scene's file would have it
    std::map<std::uint32_t, glm::vec3> colors{};  ///< index -> colour, display values 0..1
    QJsonObject view{};                           ///< what else the window showed, under the keys of sessionViewKeys()
    bool isPartial = false; ///< the file says more than was understood, which saving over it would lose
    bool sceneFound = true; ///< false: the model lies at none of the places where it is looked for
};

/// The keys of a session, and of a moment of a lesson, that tell what the window shows besides scene and settings.
[[nodiscard]] QStringList sessionViewKeys();

struct SessionLoad {
    std::optional<Session> session;
    Diagnostics diagnostics;
};

/// Whether the name stands for a session: it ends in `.json`, or in nothing that scenes end in and the file's first
/// character is the brace of a JSON object.
[[nodiscard]] bool isSession(const QString& name);

/// Reads `{"rasterlens": 1, "scene": NAME, "settings": {..}, "vertices": {"0": [x, y, z, w], ..}, "colors": {"0": [r,
/// g, b], ..}}`.
///
/// in      sceneInstead: the model in place of the one that the file names, which is then not looked for; empty: none
/// covers  a newer version: what is understood is read. The model is looked for at its place relative to the session,
///         then at its absolute place, then by its name beside the session and in the folder above.
/// errors  diagnostics with file and (for broken JSON) line: not JSON, values out of range. Warnings: keys and settings
///         that do not exist, a newer version and what is not understood of it, a model found at another place
[[nodiscard]] SessionLoad loadSession(const QString& path, const QString& sceneInstead = {});

/// The session's settings over those of its scene.
///
/// errors  settings that contradict those of the scene: a near plane beyond its far plane
[[nodiscard]] SettingsParse settingsOf(const Session& session, const Settings& base);

/// The vertices that lie elsewhere than in `original`, which has as many; finite positions only.
[[nodiscard]] std::map<std::uint32_t, glm::dvec4> movedVertices(const Mesh& original, const Mesh& edited);

/// The vertices that have another colour than in `original`, which has as many.
[[nodiscard]] std::map<std::uint32_t, glm::vec3> recoloredVertices(const Mesh& original, const Mesh& edited);

/// Moves and colours the vertices. The bounding sphere stays: the camera is not to run after them.
///
/// errors  a diagnostic if the scene has no such vertex
[[nodiscard]] Diagnostics editVertices(Scene& scene, const Session& session, const QString& sessionPath);

/// Writes the file whole or not at all. A model is named relative to the session, so that both can be moved together;
/// one outside the session's folder also by its absolute path, so that the session can be moved alone.
///
/// errors  why it could not be written: a sentence without the file name, of the context "Diagnostic"
[[nodiscard]] std::optional<Reason> saveSession(const Session& session, const QString& path);

} // namespace rasterlens
