#pragma once
#include "core/truth/other_renderer.h"

namespace rasterlens
{

/// The renderers behind OpenGL 3.3 that this machine offers without a display: `opengl-software` (Mesa's llvmpipe) and,
/// where there are graphics processors, `opengl-gpu`, `opengl-gpu-2` ..
///
/// libEGL is opened when this is called for the first time, and stays open: neither program needs it to start.
///
/// out     none, and why, where the library, a context or the sources for it were not there (a build without the
///         headers of EGL); a text of the context "Experiment"
/// source  EGL_EXT_device_enumeration, EGL_EXT_platform_device, EGL_MESA_platform_surfaceless
[[nodiscard]] OtherRenderers openGlRenderers();

} // namespace rasterlens
