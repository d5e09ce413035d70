#pragma once
#include "core/scene.h"

#include <span>

namespace rasterlens
{

struct BuiltinScene {
    const char* name;  ///< stable id, used as `builtin:NAME`
    const char* title; ///< marked with QT_TRANSLATE_NOOP("BuiltinScene", ...)
    const char* note;  ///< what to look at, marked likewise
    Scene (*make)();   ///< fills mesh, space, lit and defaults; id, title, note and bounds are set by the caller
};

/// All built-in scenes, in the order of the menu. Made by code, no files.
[[nodiscard]] std::span<const BuiltinScene> builtinScenes();

/// The scene of that name (without the `builtin:` prefix), or an error that lists the names there are.
[[nodiscard]] SceneLoad makeBuiltinScene(const QString& name);

/// The stress scenes of the benchmark: tiny, medium, large, fill-front-to-back, fill-back-to-front.
///
/// in   the size in pixels the triangles are laid out for
[[nodiscard]] SceneLoad makeStressScene(const QString& name, QSize size);

} // namespace rasterlens
