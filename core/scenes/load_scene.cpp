#include "core/scenes/load_scene.h"

#include "core/io/case_file.h"
#include "core/io/obj_loader.h"
#include "core/scenes/builtin_scenes.h"

namespace rasterlens
{

SceneLoad loadScene(const QString& name, const LoadOptions& options)
{
    const QLatin1String builtin("builtin:");
    const QLatin1String stress("stress:");
    if (name.startsWith(builtin))
        return makeBuiltinScene(name.mid(builtin.size()));
    if (name.startsWith(stress))
        return makeStressScene(name.mid(stress.size()), options.size);
    if (name.endsWith(QLatin1String(".obj"), Qt::CaseInsensitive))
        return loadObj(name, options);
    if (name.endsWith(QLatin1String(".case"), Qt::CaseInsensitive))
        return loadCase(name);
    return {
        std::nullopt,
        {{Severity::Error, name, 0,
          QT_TRANSLATE_NOOP("Diagnostic",
                            "this is not a scene; an .obj or .case file, builtin:NAME or stress:NAME is expected")}}};
}

} // namespace rasterlens
