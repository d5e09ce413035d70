#include "core/io/session.h"

#include "core/io/byte_order_mark.h"
#include "core/io/file_writer.h"
#include "core/io/reach.h"
#include "core/io/text_input.h"
#include "core/scene/origin.h"
#include "core/settings/mistakes.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>

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
    return !scene.startsWith(QLatin1String("builtin:")) && !scene.startsWith(QLatin1String("stress:")) &&
           !scene.startsWith(QLatin1String(":/")); // a scene of a built-in lesson
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

QJsonObject toJson(const std::map<std::uint32_t, glm::dvec4>& vertices)
{
    QJsonObject json;
    for (const auto& [vertex, at] : vertices)
        json[QString::number(vertex)] = QJsonArray{at.x, at.y, at.z, at.w};
    return json;
}

QJsonObject toJson(const std::map<std::uint32_t, glm::vec3>& colors)
{
    QJsonObject json;
    for (const auto& [vertex, c] : colors)
        json[QString::number(vertex)] = QJsonArray{double(c.r), double(c.g), double(c.b)};
    return json;
}

const QString kSceneKey = QStringLiteral("scene");
const QString kAbsoluteKey = QStringLiteral("scene-absolute");
const QString kSettingsKey = QStringLiteral("settings");
const QString kVerticesKey = QStringLiteral("vertices");
const QString kColorsKey = QStringLiteral("colors");

/// Where a model may lie, the likeliest place first.
///
/// in      stored: as the session names it; absolute: its absolute path where the session has one
QStringList placesOf(const QString& stored, const QString& absolute, const QDir& folder)
{
    QString slashed = stored; // a session may have been saved on Windows
    slashed.replace(QLatin1Char('\\'), QLatin1Char('/'));
    QStringList places{folder.absoluteFilePath(stored), folder.absoluteFilePath(slashed)};
    if (!absolute.isEmpty())
        places << absolute;
    const QStringList parts = slashed.split(QLatin1Char('/'), Qt::SkipEmptyParts);
    for (const char* near : {"", "../"})
        for (const qsizetype tail : {2, 1})
            if (parts.size() >= tail)
                places << folder.absoluteFilePath(QLatin1String(near) +
                                                  parts.mid(parts.size() - tail).join(QLatin1Char('/')));
    for (QString& place : places)
        place = QDir::cleanPath(place);
    return places;
}

/// Reads the object of a session. What a newer version says and this one does not know is left out and named.
class Reader
{
public:
    Reader(const QJsonObject& json, const QString& path, const QString& sceneInstead, DiagnosticSink& diagnostics)
        : m_json(json), m_path(path), m_reach(Consent::reachOf(path)), m_sceneInstead(sceneInstead),
          m_diagnostics(diagnostics)
    {
    }

    Session read()
    {
        version();
        keys();
        scene();
        settings();
        vertices();
        colors();
        return std::move(m_session);
    }

private:
    /// An error, or in the file of a newer version the name of what is left out.
    void fault(Reason message)
    {
        if (!m_newer)
            return m_diagnostics.error(0, std::move(message));
        leftOut(std::move(message));
    }

    void leftOut(Reason message)
    {
        m_session.isPartial = true;
        m_diagnostics.warning(0, {QT_TRANSLATE_NOOP("Diagnostic", "%1; left out"), {std::move(message)}});
    }

    void version()
    {
        const QJsonValue version = m_json[QLatin1String("rasterlens")];
        m_newer = version.toDouble() > kFormatVersion;
        if (m_newer) {
            m_session.isPartial = true;
            m_diagnostics.warning(0,
                                  {QT_TRANSLATE_NOOP("Diagnostic", "made by a newer version (%1); this one reads %2"),
                                   {QString::number(version.toDouble()), kFormatVersion}});
        } else if (version != kFormatVersion) {
            m_diagnostics.error(0, {QT_TRANSLATE_NOOP("Diagnostic", "this is not a session of this program; "
                                                                    "\"rasterlens\": %1 is expected"),
                                    {kFormatVersion}});
        }
    }

    void keys()
    {
        const QStringList known{
            QStringLiteral("rasterlens"), kSceneKey, kAbsoluteKey, kSettingsKey, kVerticesKey, kColorsKey};
        const QStringList view = sessionViewKeys();
        for (const QString& key : m_json.keys())
            if (view.contains(key))
                m_session.view[key] = m_json[key];
            else if (!known.contains(key))
                leftOut(
                    {QT_TRANSLATE_NOOP("Diagnostic",
                                       "there is no key \"%1\"; rasterlens, scene, settings, vertices and colors are "
                                       "expected"),
                     {key}});
    }

    void scene()
    {
        const QString stored = m_json[kSceneKey].toString();
        m_session.scene = stored;
        if (stored.isEmpty())
            return m_diagnostics.error(0, QT_TRANSLATE_NOOP("Diagnostic", "\"scene\" takes the name of a scene"));
        if (!m_sceneInstead.isEmpty()) {
            m_session.scene = m_sceneInstead;
            return;
        }
        if (!isPath(stored))
            return;
        const QStringList places = placesOf(stored, m_json[kAbsoluteKey].toString(), m_reach.folder);
        const auto found = std::find_if(places.begin(), places.end(), [this](const QString& place) {
            return m_reach.covers(place) && QFileInfo(place).isFile();
        });
        m_session.sceneFound = found != places.end();
        m_session.scene = m_session.sceneFound ? *found : places.first();
        if (!m_session.sceneFound && !m_reach.covers(places.first()))
            refuse(places.first());
        else if (!m_session.sceneFound && m_reach.outside == Outside::Refuse)
            m_diagnostics.warning(
                0, {QT_TRANSLATE_NOOP("Diagnostic", "the scene is neither at %1 nor, by its name, beside the session; "
                                                    "other folders are looked at only if that is allowed "
                                                    "(--allow-outside)"),
                    {places.first()}});
        else if (!m_session.sceneFound)
            m_diagnostics.warning(0, {QT_TRANSLATE_NOOP("Diagnostic", "the scene is neither at %1 nor, by its name, "
                                                                      "beside the session or in the folder above"),
                                      {places.first()}});
        else if (*found != places.first())
            m_diagnostics.warning(
                0, {QT_TRANSLATE_NOOP("Diagnostic", "the scene is not at %1; %2 is used"), {places.first(), *found}});
    }

    void refuse(const QString& scene)
    {
        Consent::refuse(m_path, scene);
        m_diagnostics.error(0, {QT_TRANSLATE_NOOP("Diagnostic", "the scene %1 lies outside the session's folder and is "
                                                                "opened only if that is allowed (--allow-outside)"),
                                {scene}});
    }

    void settings()
    {
        const QJsonValue json = m_json[kSettingsKey];
        if (!json.isObject() && !json.isUndefined())
            fault(QT_TRANSLATE_NOOP("Diagnostic", "\"settings\" takes an object"));
        m_session.settings = json.toObject();
        if (const QJsonValue view = m_session.settings.value(QLatin1String("view")); m_newer && view.isObject())
            m_session.settings[QLatin1String("view")] = understoodView(view.toObject());
        if (m_newer)
            leaveOutUnknownMistakes();
        for (const QString& key : m_session.settings.keys()) {
            const SettingsParse parse = settingsFromJson({{key, m_session.settings.value(key)}});
            for (const Reason& error : parse.errors)
                if (isSetting(key))
                    fault(error);
                else
                    leftOut(error);
            if (!parse.errors.empty())
                m_session.settings.remove(key);
        }
    }

    void leaveOutUnknownMistakes()
    {
        const QString key = QStringLiteral("mistakes");
        QJsonArray known;
        for (const QJsonValue& id : m_session.settings.value(key).toArray())
            if (findMistake(id.toString()) != nullptr)
                known.append(id);
            else
                leftOut({QT_TRANSLATE_NOOP("Diagnostic", "there is no mistake \"%1\""), {id.toString()}});
        if (m_session.settings.value(key).isArray())
            m_session.settings[key] = known;
    }

    QJsonObject understoodView(QJsonObject view)
    {
        for (const QString& key : view.keys()) {
            const QJsonObject alone{{QStringLiteral("view"), QJsonObject{{key, view[key]}}}};
            const SettingsParse parse = settingsFromJson(alone);
            for (const Reason& error : parse.errors)
                fault(error);
            if (!parse.errors.empty())
                view.remove(key);
        }
        return view;
    }

    void vertices()
    {
        const QJsonValue json = m_json[kVerticesKey];
        if (!json.isObject() && !json.isUndefined())
            return fault(QT_TRANSLATE_NOOP("Diagnostic", "\"vertices\" takes an object"));
        const QJsonObject object = json.toObject();
        for (auto it = object.begin(); it != object.end(); ++it)
            vertex(it.key(), it.value().toArray());
    }

    void vertex(const QString& key, const QJsonArray& numbers)
    {
        bool isIndex = false;
        const std::uint32_t vertex = key.toUInt(&isIndex);
        const bool isPosition = numbers.size() == 4 && std::all_of(numbers.begin(), numbers.end(), [](const auto& n) {
                                    return n.isDouble() && std::isfinite(static_cast<float>(n.toDouble()));
                                });
        if (!isIndex || !isPosition)
            return fault({QT_TRANSLATE_NOOP("Diagnostic", "\"vertices\" takes an index and a position: \"0\": [x, "
                                                          "y, z, w], not \"%1\""),
                          {key}});
        for (int i = 0; i < 4; ++i)
            m_session.vertices[vertex][i] = numbers[i].toDouble();
    }

    void colors()
    {
        const QJsonValue json = m_json[kColorsKey];
        if (!json.isObject() && !json.isUndefined())
            return fault(QT_TRANSLATE_NOOP("Diagnostic", "\"colors\" takes an object"));
        const QJsonObject object = json.toObject();
        for (auto it = object.begin(); it != object.end(); ++it)
            color(it.key(), it.value().toArray());
    }

    void color(const QString& key, const QJsonArray& numbers)
    {
        bool isIndex = false;
        const std::uint32_t vertex = key.toUInt(&isIndex);
        const bool isColor = numbers.size() == 3 && std::all_of(numbers.begin(), numbers.end(), [](const auto& n) {
                                 return n.isDouble() && n.toDouble() >= 0 && n.toDouble() <= 1;
                             });
        if (!isIndex || !isColor)
            return fault({QT_TRANSLATE_NOOP("Diagnostic", "\"colors\" takes an index and a colour: \"0\": [r, g, b], "
                                                          "each from 0 to 1, not \"%1\""),
                          {key}});
        for (int i = 0; i < 3; ++i)
            m_session.colors[vertex][i] = static_cast<float>(numbers[i].toDouble());
    }

    static bool isSetting(const QString& key)
    {
        return findSettingsField(key) != nullptr || toJson(Settings()).contains(key);
    }

    const QJsonObject& m_json;
    const QString& m_path;
    const Reach m_reach;
    const QString& m_sceneInstead;
    DiagnosticSink& m_diagnostics;
    Session m_session;
    bool m_newer = false;
};

/// Names the scene in the file of a session in `folder`.
void nameScene(const QString& scene, const QDir& folder, QJsonObject& json)
{
    json[kSceneKey] = scene;
    if (!isPath(scene))
        return;
    const QString absolute = QDir::cleanPath(QFileInfo(scene).absoluteFilePath());
    const QString relative = folder.relativeFilePath(absolute);
    json[kSceneKey] = relative;
    if (relative.startsWith(QLatin1String("..")))
        json[kAbsoluteKey] = absolute;
}

} // namespace

QStringList sessionViewKeys()
{
    return {QStringLiteral("step"),   QStringLiteral("pixel"),   QStringLiteral("zoom"),   QStringLiteral("centre"),
            QStringLiteral("panels"), QStringLiteral("overlay"), QStringLiteral("compare")};
}

bool isSession(const QString& name)
{
    if (!isPath(name))
        return false;
    const QString suffix = QFileInfo(name).suffix().toLower();
    if (suffix == QLatin1String("json"))
        return true;
    if (suffix == QLatin1String("obj") || suffix == QLatin1String("case") || !QFileInfo(name).isFile())
        return false;
    constexpr qint64 kLooked = 256;
    QFile file(name);
    if (!file.open(QIODevice::ReadOnly))
        return false;
    QByteArray beginning = file.read(kLooked);
    return !takeOffByteOrderMark(beginning) && beginning.trimmed().startsWith('{');
}

SessionLoad loadSession(const QString& path, const QString& sceneInstead)
{
    constexpr int kAll = 1000; // each key that is left out is named
    DiagnosticSink diagnostics(path, kAll);
    InputBytes input = readInput(path);
    if (!input.problem)
        input.problem = takeOffByteOrderMark(input.bytes);
    Session session;
    if (input.problem) {
        diagnostics.error(0, *input.problem);
    } else {
        const QJsonObject json = parse(input.bytes, diagnostics);
        if (!diagnostics.hasErrors())
            session = Reader(json, path, sceneInstead, diagnostics).read();
    }
    if (diagnostics.hasErrors())
        return {std::nullopt, diagnostics.take()};
    return {session, diagnostics.take()};
}

SettingsParse settingsOf(const Session& session, const Settings& base)
{
    return settingsFromJson(session.settings, base);
}

std::map<std::uint32_t, glm::dvec4> movedVertices(const Mesh& original, const Mesh& edited)
{
    std::map<std::uint32_t, glm::dvec4> moved;
    for (std::uint32_t i = 0; i < edited.vertices.size(); ++i)
        if (const glm::vec4& now = edited.vertices[i].position;
            now != original.vertices[i].position && std::isfinite(now.x + now.y + now.z + now.w))
            moved[i] = worldPosition(edited, i);
    return moved;
}

std::map<std::uint32_t, glm::vec3> recoloredVertices(const Mesh& original, const Mesh& edited)
{
    std::map<std::uint32_t, glm::vec3> recolored;
    for (std::uint32_t i = 0; i < edited.vertices.size(); ++i)
        if (edited.vertices[i].color != original.vertices[i].color)
            recolored[i] = edited.vertices[i].color;
    return recolored;
}

Diagnostics editVertices(Scene& scene, const Session& session, const QString& sessionPath)
{
    constexpr int kAll = 1000;
    DiagnosticSink diagnostics(sessionPath, kAll);
    std::vector<MeshVertex>& vertices = scene.mesh.vertices;
    const auto absent = [&](const char* text, std::uint32_t vertex) {
        diagnostics.error(0, {text, {vertex, vertices.size()}});
    };
    for (const auto& [vertex, position] : session.vertices)
        if (vertex < vertices.size())
            vertices[vertex].position = glm::vec4(objectFromWorld(glm::dvec3(position), scene.mesh.origin), position.w);
        else
            absent(QT_TRANSLATE_NOOP("Diagnostic", "\"vertices\" names vertex %1; the scene has %2, counted from 0"),
                   vertex);
    for (const auto& [vertex, color] : session.colors)
        if (vertex < vertices.size())
            vertices[vertex].color = color;
        else
            absent(QT_TRANSLATE_NOOP("Diagnostic", "\"colors\" names vertex %1; the scene has %2, counted from 0"),
                   vertex);
    return diagnostics.take();
}

std::optional<Reason> saveSession(const Session& session, const QString& path)
{
    QJsonObject json{{"rasterlens", kFormatVersion}, {kSettingsKey, session.settings}};
    nameScene(session.scene, QFileInfo(path).absoluteDir(), json);
    for (auto it = session.view.begin(); it != session.view.end(); ++it)
        json[it.key()] = it.value();
    if (!session.vertices.empty())
        json[kVerticesKey] = toJson(session.vertices);
    if (!session.colors.empty())
        json[kColorsKey] = toJson(session.colors);
    const QByteArray text = QJsonDocument(json).toJson();
    const auto problem = writeFile(path, text, NoReader::Refuse);
    return problem
               ? std::optional(Reason(QT_TRANSLATE_NOOP("Diagnostic", "the file cannot be written: %1"), {*problem}))
               : std::nullopt;
}

} // namespace rasterlens
