#include "core/io/session.h"

#include "core/io/text_input.h"

#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QSaveFile>

#include <algorithm>
#include <cmath>

namespace rasterlens
{
namespace
{

constexpr int kFormatVersion = 1;

/// Scenes made by code have names that are not paths.
bool isPath(const QString& scene)
{
    return !scene.startsWith(QLatin1String("builtin:")) && !scene.startsWith(QLatin1String("stress:"));
}

int lineOf(const QByteArray& text, qsizetype offset)
{
    return 1 + static_cast<int>(std::count(text.begin(), text.begin() + std::min(offset, text.size()), '\n'));
}

QJsonObject parse(const QByteArray& text, DiagnosticSink& diagnostics)
{
    QJsonParseError error;
    const QJsonDocument document = QJsonDocument::fromJson(text, &error);
    if (error.error != QJsonParseError::NoError)
        diagnostics.error(lineOf(text, error.offset),
                          {QT_TRANSLATE_NOOP("Diagnostic", "broken JSON: %1"), {error.errorString()}});
    else if (!document.isObject())
        diagnostics.error(
            1,
            QT_TRANSLATE_NOOP("Diagnostic",
                              "a JSON object is expected: {\"rasterlens\": 1, \"scene\": NAME, \"settings\": {..}}"));
    return document.object();
}

std::map<std::uint32_t, glm::vec4> verticesOf(const QJsonValue& json, DiagnosticSink& diagnostics)
{
    std::map<std::uint32_t, glm::vec4> vertices;
    if (!json.isObject() && !json.isUndefined())
        diagnostics.error(0, QT_TRANSLATE_NOOP("Diagnostic", "\"vertices\" takes an object"));
    const QJsonObject object = json.toObject();
    for (auto it = object.begin(); it != object.end(); ++it) {
        bool isIndex = false;
        const std::uint32_t vertex = it.key().toUInt(&isIndex);
        const QJsonArray numbers = it.value().toArray();
        const bool isPosition = numbers.size() == 4 && std::all_of(numbers.begin(), numbers.end(), [](const auto& n) {
                                    return n.isDouble() && std::isfinite(static_cast<float>(n.toDouble()));
                                });
        if (!isIndex || !isPosition) {
            diagnostics.error(
                0, {QT_TRANSLATE_NOOP("Diagnostic",
                                      "\"vertices\" takes an index and a position: \"0\": [x, y, z, w], not \"%1\""),
                    {it.key()}});
            continue;
        }
        for (int i = 0; i < 4; ++i)
            vertices[vertex][i] = static_cast<float>(numbers[i].toDouble());
    }
    return vertices;
}

QJsonObject toJson(const std::map<std::uint32_t, glm::vec4>& vertices)
{
    QJsonObject json;
    for (const auto& [vertex, at] : vertices)
        json[QString::number(vertex)] = QJsonArray{at.x, at.y, at.z, at.w};
    return json;
}

Session sessionOf(const QJsonObject& json, const QDir& folder, DiagnosticSink& diagnostics)
{
    Session session;
    for (const QString& key : json.keys())
        if (!QStringList{"rasterlens", "scene", "settings", "vertices"}.contains(key))
            diagnostics.error(
                0, {QT_TRANSLATE_NOOP("Diagnostic",
                                      "there is no key \"%1\"; rasterlens, scene, settings and vertices are expected"),
                    {key}});
    if (json[QLatin1String("rasterlens")] != kFormatVersion)
        diagnostics.error(
            0,
            {QT_TRANSLATE_NOOP("Diagnostic", "this is not a session of this program; \"rasterlens\": %1 is expected"),
             {kFormatVersion}});

    session.scene = json[QLatin1String("scene")].toString();
    if (session.scene.isEmpty())
        diagnostics.error(0, QT_TRANSLATE_NOOP("Diagnostic", "\"scene\" takes the name of a scene"));
    else if (isPath(session.scene))
        session.scene = QDir::cleanPath(folder.absoluteFilePath(session.scene));

    const QJsonValue settings = json[QLatin1String("settings")];
    if (!settings.isObject() && !settings.isUndefined())
        diagnostics.error(0, QT_TRANSLATE_NOOP("Diagnostic", "\"settings\" takes an object"));
    session.settings = settings.toObject();
    for (const Reason& error : settingsFromJson(session.settings).errors)
        diagnostics.error(0, error);
    session.vertices = verticesOf(json[QLatin1String("vertices")], diagnostics);
    return session;
}

/// Inside the session's folder the path is relative, so that the folder can be moved as a whole.
QString storedScene(const QString& scene, const QDir& folder)
{
    if (!isPath(scene))
        return scene;
    const QString absolute = QDir::cleanPath(QFileInfo(scene).absoluteFilePath());
    const QString relative = folder.relativeFilePath(absolute);
    return relative.startsWith(QLatin1String("..")) ? absolute : relative;
}

} // namespace

SessionLoad loadSession(const QString& path)
{
    DiagnosticSink diagnostics(path);
    const InputBytes input = readInput(path);
    Session session;
    if (input.problem) {
        diagnostics.error(0, *input.problem);
    } else {
        const QJsonObject json = parse(input.bytes, diagnostics);
        if (!diagnostics.hasErrors())
            session = sessionOf(json, QFileInfo(path).absoluteDir(), diagnostics);
    }
    if (diagnostics.hasErrors())
        return {std::nullopt, diagnostics.take()};
    return {session, diagnostics.take()};
}

Settings settingsOf(const Session& session, const Settings& base)
{
    return settingsFromJson(session.settings, base).settings;
}

std::map<std::uint32_t, glm::vec4> movedVertices(const Mesh& original, const Mesh& edited)
{
    std::map<std::uint32_t, glm::vec4> moved;
    for (std::uint32_t i = 0; i < edited.vertices.size(); ++i)
        if (const glm::vec4& now = edited.vertices[i].position;
            now != original.vertices[i].position && std::isfinite(now.x + now.y + now.z + now.w))
            moved[i] = now;
    return moved;
}

Diagnostics moveVertices(Scene& scene, const Session& session, const QString& sessionPath)
{
    DiagnosticSink diagnostics(sessionPath);
    std::vector<MeshVertex>& vertices = scene.mesh.vertices;
    for (const auto& [vertex, position] : session.vertices)
        if (vertex < vertices.size())
            vertices[vertex].position = position;
        else
            diagnostics.error(
                0, {QT_TRANSLATE_NOOP("Diagnostic", "\"vertices\" names vertex %1; the scene has %2, counted from 0"),
                    {vertex, vertices.size()}});
    return diagnostics.take();
}

std::optional<Reason> saveSession(const Session& session, const QString& path)
{
    QJsonObject json{{"rasterlens", kFormatVersion},
                     {"scene", storedScene(session.scene, QFileInfo(path).absoluteDir())},
                     {"settings", session.settings}};
    if (!session.vertices.empty())
        json["vertices"] = toJson(session.vertices);
    const QByteArray text = QJsonDocument(json).toJson();
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size() || !file.commit())
        return Reason(QT_TRANSLATE_NOOP("Diagnostic", "the file cannot be written: %1"), {file.errorString()});
    return std::nullopt;
}

} // namespace rasterlens
