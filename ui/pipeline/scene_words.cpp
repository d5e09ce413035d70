#include "ui/pipeline/scene_words.h"

#include "core/scenes/builtin_scenes.h"
#include "ui/base/case_note.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <algorithm>

namespace rasterlens
{
namespace
{

/// The entry of a table of scenes that `id` names, if it does.
template <class Table>
auto findScene(const Table& table, const QString& id, QLatin1String prefix)
{
    return std::ranges::find_if(table, [&](const auto& entry) { return id == prefix + QLatin1String(entry.name); });
}

} // namespace

QString sceneTitle(const Scene& scene)
{
    const auto builtins = builtinScenes();
    const auto stress = stressScenes();
    if (const auto it = findScene(builtins, scene.id, QLatin1String("builtin:")); it != builtins.end())
        return QCoreApplication::translate("BuiltinScene", it->title);
    if (const auto it = findScene(stress, scene.id, QLatin1String("stress:")); it != stress.end())
        return QCoreApplication::translate("StressScene", it->title);
    return scene.title.isEmpty() ? QFileInfo(scene.id).fileName() : caseTitle(scene.title);
}

QString sceneNote(const Scene& scene)
{
    const auto builtins = builtinScenes();
    if (const auto it = findScene(builtins, scene.id, QLatin1String("builtin:")); it != builtins.end())
        return QCoreApplication::translate("BuiltinScene", it->note);
    return caseNoteText(scene.note);
}

} // namespace rasterlens
