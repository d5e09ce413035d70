#pragma once
#include "core/scene/scene.h"

#include <span>

namespace rasterlens
{

struct BuiltinScene {
    const char* name;  ///< stable id, used as `builtin:NAME`
    const char* title; ///< marked with QT_TRANSLATE_NOOP("BuiltinScene", ...)
    const char* note;  ///< what to look at; marked for translation as the title is
    Scene (*make)();   ///< fills mesh, space, lit and defaults; id, title, note and bounds are set by the caller
};

/// All built-in scenes, in the order of the menu. Made by code, no files.
[[nodiscard]] std::span<const BuiltinScene> builtinScenes();

/// The scene of that name (without the `builtin:` prefix), or an error that lists the names there are.
[[nodiscard]] SceneLoad makeBuiltinScene(const QString& name);

struct StressScene {
    const char* name;    ///< stable id, used as `stress:NAME`
    const char* title;   ///< marked with QT_TRANSLATE_NOOP("StressScene", ...)
    Mesh (*make)(QSize); ///< laid out for so many pixels
};

/// The scenes of the benchmark, in the order of the menu.
[[nodiscard]] std::span<const StressScene> stressScenes();

/// The stress scene of that name (without the `stress:` prefix), or an error that lists the names there are.
///
/// in   the size in pixels the triangles are laid out for
[[nodiscard]] SceneLoad makeStressScene(const QString& name, QSize size);

} // namespace rasterlens
