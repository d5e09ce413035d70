#include "core/builtin_scenes.h"

namespace rasterlens
{

std::span<const BuiltinScene> builtinScenes() { return {}; }

SceneLoad makeBuiltinScene(const QString& name)
{
    return {
        std::nullopt,
        {{Severity::Error, QStringLiteral("builtin:") + name, 0, QStringLiteral("there is no such built-in scene")}}};
}

} // namespace rasterlens
