#include "core/session.h"

#include "core/text_input.h"

#include <QDir>
#include <QFileInfo>
#include <QJsonDocument>
#include <QSaveFile>

#include <algorithm>

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
        diagnostics.error(lineOf(text, error.offset), QStringLiteral("broken JSON: %1").arg(error.errorString()));
    else if (!document.isObject())
        diagnostics.error(
            1, QStringLiteral("a JSON object is expected: {\"rasterlens\": 1, \"scene\": NAME, \"settings\": {..}}"));
    return document.object();
}

Session sessionOf(const QJsonObject& json, const QDir& folder, DiagnosticSink& diagnostics)
{
    Session session;
    for (const QString& key : json.keys())
        if (key != QLatin1String("rasterlens") && key != QLatin1String("scene") && key != QLatin1String("settings"))
            diagnostics.error(
                0, QStringLiteral("there is no key \"%1\"; rasterlens, scene and settings are expected").arg(key));
    if (json[QLatin1String("rasterlens")] != kFormatVersion)
        diagnostics.error(0, QStringLiteral("this is not a session of this program; \"rasterlens\": %1 is expected")
                                 .arg(kFormatVersion));

    session.scene = json[QLatin1String("scene")].toString();
    if (session.scene.isEmpty())
        diagnostics.error(0, QStringLiteral("\"scene\" takes the name of a scene"));
    else if (isPath(session.scene))
        session.scene = QDir::cleanPath(folder.absoluteFilePath(session.scene));

    const QJsonValue settings = json[QLatin1String("settings")];
    if (!settings.isObject() && !settings.isUndefined())
        diagnostics.error(0, QStringLiteral("\"settings\" takes an object"));
    const SettingsParse parsed = settingsFromJson(settings.toObject());
    for (const QString& error : parsed.errors)
        diagnostics.error(0, error);
    session.settings = parsed.settings;
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
    if (!input.problem.isEmpty()) {
        diagnostics.error(0, input.problem);
    } else {
        const QJsonObject json = parse(input.bytes, diagnostics);
        if (!diagnostics.hasErrors())
            session = sessionOf(json, QFileInfo(path).absoluteDir(), diagnostics);
    }
    if (diagnostics.hasErrors())
        return {std::nullopt, diagnostics.take()};
    return {session, diagnostics.take()};
}

std::optional<QString> saveSession(const Session& session, const QString& path)
{
    const QJsonObject json{{"rasterlens", kFormatVersion},
                           {"scene", storedScene(session.scene, QFileInfo(path).absoluteDir())},
                           {"settings", toJson(session.settings)}};
    const QByteArray text = QJsonDocument(json).toJson();
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size() || !file.commit())
        return QStringLiteral("%1 cannot be written: %2").arg(path, file.errorString());
    return std::nullopt;
}

} // namespace rasterlens
