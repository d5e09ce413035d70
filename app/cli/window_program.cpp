#include "app/cli/window_program.h"

#include "core/io/session.h"
#include "core/scenes/load_scene.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QProcess>
#include <QTemporaryDir>

#include <cstdio>

namespace rasterlens::cli
{
namespace
{

/// A session keeps the vertices that lie elsewhere, or have another colour, than in the scene's file.
void addEditsSinceLoading(Session& session, const Scene& scene)
{
    LoadOptions options;
    options.size = scene.defaults.size;
    const SceneLoad original = loadScene(scene.id, options);
    if (!original.scene || original.scene->mesh.vertices.size() != scene.mesh.vertices.size())
        return;
    session.vertices = movedVertices(original.scene->mesh, scene.mesh);
    session.colors = recoloredVertices(original.scene->mesh, scene.mesh);
}

/// Whether the scene is no file of the disk.
bool isGenerated(const Scene& scene)
{
    return scene.id.startsWith(QLatin1String("builtin:")) || scene.id.startsWith(QLatin1String("stress:")) ||
           scene.id.startsWith(QLatin1String(":/")); // a scene of a built-in lesson
}

QString absoluteId(const Scene& scene)
{
    return isGenerated(scene) ? scene.id : QFileInfo(scene.id).absoluteFilePath();
}

} // namespace

QStringList regionWords(const QRect& region)
{
    return {QStringLiteral("--region"),
            QStringLiteral("%1,%2,%3,%4").arg(region.x()).arg(region.y()).arg(region.width()).arg(region.height())};
}

ExitCode runWindowProgram(const QStringList& words)
{
    char name[] = "rasterlens-cli";
    char* names[] = {name, nullptr};
    int count = 1;
    const QCoreApplication application(count, names);
    const QString program = QDir(QCoreApplication::applicationDirPath()).filePath(QStringLiteral("rasterlens"));
    if (!QFileInfo(program).isExecutable())
        failInput(
            QStringLiteral("%1: cannot be run; the program with the window is expected beside rasterlens-cli, as it "
                           "draws figures")
                .arg(program));
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("QT_QPA_PLATFORM"), QStringLiteral("offscreen"));
    process.setProcessEnvironment(environment);
    process.setProcessChannelMode(QProcess::ForwardedOutputChannel); // for a figure that goes to stdout
    process.start(program, words);
    if (!process.waitForFinished(-1) || process.exitStatus() != QProcess::NormalExit)
        failInput(QStringLiteral("%1: ended too early: %2").arg(program, process.errorString()));
    const QByteArray said = process.readAllStandardError();
    std::fwrite(said.constData(), 1, std::size_t(said.size()), stderr);
    return static_cast<ExitCode>(process.exitCode());
}

ExitCode runWindowProgram(const Scene& scene, const Settings& settings, const QStringList& words)
{
    const QTemporaryDir folder;
    const QString session = folder.filePath(QStringLiteral("figure.json"));
    if (!folder.isValid())
        failInput(QStringLiteral("%1: cannot be written: %2").arg(folder.path(), folder.errorString()));
    Session state;
    state.scene = absoluteId(scene);
    state.settings = toJson(settings);
    addEditsSinceLoading(state, scene);
    if (const auto problem = saveSession(state, session))
        failInput(QStringLiteral("%1: cannot be written: %2").arg(session, textOf(*problem)));
    QStringList all{session};
    if (!isGenerated(scene))
        all << QStringLiteral("--model") << state.scene; // which lies elsewhere than the session
    return runWindowProgram(all + words);
}

} // namespace rasterlens::cli
