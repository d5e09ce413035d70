#include "app/cli/input.h"

#include "app/cli/failure.h"
#include "app/cli/settings_options.h"
#include "core/io/input_log.h"
#include "core/io/session.h"
#include "core/scenes/builtin_scenes.h"
#include "core/scenes/load_scene.h"

#include <cstdio>

namespace rasterlens::cli
{
namespace
{

void printWarnings(const Diagnostics& diagnostics)
{
    for (const Diagnostic& diagnostic : diagnostics)
        if (diagnostic.severity == Severity::Warning)
            std::fprintf(stderr, "%s\n", qUtf8Printable(diagnostic.text()));
}

[[noreturn]] void failDiagnostics(const Diagnostics& diagnostics)
{
    QStringList lines;
    for (const Diagnostic& diagnostic : diagnostics)
        lines << diagnostic.text();
    failInput(lines.join(QLatin1Char('\n')));
}

SceneLoad openScene(const QString& name, const LoadOptions& options)
{
    SceneLoad load = loadScene(name, options);
    if (!load.scene)
        failDiagnostics(load.diagnostics);
    printWarnings(load.diagnostics);
    return load;
}

Session openSession(const QString& path)
{
    const SessionLoad load = loadSession(path);
    if (!load.session)
        failDiagnostics(load.diagnostics);
    printWarnings(load.diagnostics);
    if (const QStringList unknown = unknownMistakes(settingsOf(*load.session, {}).settings); !unknown.isEmpty())
        failInput(
            QStringLiteral("%1: there is no mistake \"%2\"; \"rasterlens-cli render --list-mistakes\" lists those "
                           "there are")
                .arg(path, unknown.first()));
    return *load.session;
}

/// The files that were read, as far as they are there.
QStringList namesOf(const InputLog& log)
{
    QStringList names;
    for (const InputFile& file : log.files())
        if (file.stamp.exists)
            names << file.path;
    return names;
}

/// The session's settings in the scene that it names.
Settings sessionSettings(const Session& session, const Settings& defaults, const QString& path)
{
    const SettingsParse parse = settingsOf(session, defaults);
    Diagnostics errors;
    for (const Reason& error : parse.errors)
        errors.push_back({Severity::Error, path, 0, error});
    if (!errors.empty())
        failDiagnostics(errors);
    return parse.settings;
}

} // namespace

Input openInput(const QString& name, const Arguments& arguments)
{
    const Consent consent(outsideOf(arguments));
    const InputLog log;
    LoadOptions options;
    options.peerMesh = arguments.isOn(QStringLiteral("--peer-mesh"));
    options.texture = arguments.value(QStringLiteral("--texture")).value_or(QString());
    options.size = withOptions(Settings(), arguments).size;
    if (!isSession(name)) {
        SceneLoad load = openScene(name, options);
        const Settings settings = withOptions(load.scene->defaults, arguments);
        return {std::move(*load.scene), settings, std::move(load.diagnostics), namesOf(log)};
    }
    const Session session = openSession(name);
    options.size = withOptions(settingsOf(session, {}).settings, arguments).size;
    SceneLoad load = openScene(session.scene, options);
    if (const Diagnostics errors = editVertices(*load.scene, session, name); !errors.empty())
        failDiagnostics(errors);
    const Settings settings = withOptions(sessionSettings(session, load.scene->defaults, name), arguments);
    return {std::move(*load.scene), settings, std::move(load.diagnostics), namesOf(log)};
}

Option allowOutsideOption()
{
    return {
        QStringLiteral("--allow-outside"),
        Option::Kind::Switch,
        {},
        QStringLiteral("Models, sessions and lessons may name files outside their own folders; without it those are "
                       "not read.")};
}

Outside outsideOf(const Arguments& arguments)
{
    return arguments.isOn(QStringLiteral("--allow-outside")) ? Outside::Allow : Outside::Refuse;
}

QList<Option> inputOptions()
{
    return {
        {QStringLiteral("--texture"), Option::Kind::Value, QStringLiteral("FILE"),
         QStringLiteral("A picture used in place of the materials' textures (see --shading texture).")},
        {QStringLiteral("--peer-mesh"),
         Option::Kind::Switch,
         {},
         QStringLiteral("Normals and texture coordinates of an OBJ file exactly as the peers' harness makes them.")},
        allowOutsideOption()};
}

QString sceneHelp()
{
    QStringList names;
    for (const BuiltinScene& scene : builtinScenes())
        names << QLatin1String(scene.name);
    return QStringLiteral("SCENE is an OBJ file with its MTL files and textures (.obj), a hard case (.case), a session "
                          "saved by the "
                          "window (.json: its scene and its settings, which the options then change), builtin:NAME or "
                          "stress:NAME.\n"
                          "  builtin: %1\n"
                          "  stress: tiny, medium, large, fill-front-to-back, fill-back-to-front")
        .arg(names.join(QStringLiteral(", ")));
}

} // namespace rasterlens::cli
