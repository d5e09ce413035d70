#pragma once
#include "app/cli/failure.h"
#include "core/scene/scene.h"

#include <QRect>
#include <QStringList>

namespace rasterlens::cli
{

/// The option by which the program with the window is told which pixels a figure shows.
[[nodiscard]] QStringList regionWords(const QRect& region);

/// Runs the program with the window, which lies beside this one, without a display and waits for it; what it prints is
/// printed.
///
/// out     how the other program ended
/// errors  throws Failure: the program is not there, or did not end by itself
[[nodiscard]] ExitCode runWindowProgram(const QStringList& words);

/// Runs the program with the window on a scene as it is, with these settings.
///
/// in      `scene`: not read with options that a session does not keep (--texture, --peer-mesh)
/// errors  throws Failure: also where no file for the session can be written
[[nodiscard]] ExitCode runWindowProgram(const Scene& scene, const Settings& settings, const QStringList& words);

} // namespace rasterlens::cli
