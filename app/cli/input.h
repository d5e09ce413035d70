#pragma once
#include "app/cli/options.h"
#include "core/io/reach.h"
#include "core/scene/scene.h"

namespace rasterlens::cli
{

/// A scene and what to draw it with.
struct Input {
    Scene scene;
    Settings settings;       ///< those of the scene or of the session that named it, changed by the command line
    Diagnostics diagnostics; ///< warnings of the loader
    QStringList files;       ///< those it was read from, which no output may take the place of
};

/// Opens what the command line calls SCENE: all that loadScene takes, and session files.
/// Warnings go to stderr.
///
/// in      the options of inputOptions() and settingsOptionGroups()
/// errors  throws Failure: bad values, the diagnostics of the loader
[[nodiscard]] Input openInput(const QString& name, const Arguments& arguments);

/// `--allow-outside`, by which the user agrees that files name others outside their folders.
[[nodiscard]] Option allowOutsideOption();
[[nodiscard]] Outside outsideOf(const Arguments& arguments);

/// `--texture`, `--peer-mesh` and `--allow-outside`.
[[nodiscard]] QList<Option> inputOptions();

/// The paragraph of the help about SCENE.
[[nodiscard]] QString sceneHelp();

} // namespace rasterlens::cli
