// The build without EGL.
#include "core/opengl/opengl_renderers.h"

#include <QCoreApplication>

namespace rasterlens
{

OtherRenderers openGlRenderers()
{
    return {{},
            Reason{QT_TRANSLATE_NOOP("Experiment", "this program was built without OpenGL: the headers of EGL (Debian: "
                                                   "libegl-dev) were missing")}};
}

} // namespace rasterlens
