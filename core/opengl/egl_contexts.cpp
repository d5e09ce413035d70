#include "core/opengl/egl_contexts.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cstring>
#include <dlfcn.h>

namespace rasterlens
{
namespace
{

/// The functions of libEGL, which is opened for them.
struct Egl {
    PFNEGLGETPROCADDRESSPROC getProcAddress = nullptr;
    PFNEGLINITIALIZEPROC initialize = nullptr;
    PFNEGLTERMINATEPROC terminate = nullptr;
    PFNEGLBINDAPIPROC bindApi = nullptr;
    PFNEGLCREATECONTEXTPROC createContext = nullptr;
    PFNEGLDESTROYCONTEXTPROC destroyContext = nullptr;
    PFNEGLMAKECURRENTPROC makeCurrent = nullptr;
    PFNEGLGETPLATFORMDISPLAYEXTPROC getPlatformDisplay = nullptr;
    PFNEGLQUERYDEVICESEXTPROC queryDevices = nullptr;           ///< null: devices are not told apart
    PFNEGLQUERYDEVICESTRINGEXTPROC queryDeviceString = nullptr; ///< null: devices are not told apart

    /// Whether libEGL is there.
    [[nodiscard]] bool isThere() const
    {
        return getProcAddress != nullptr && initialize != nullptr && terminate != nullptr && bindApi != nullptr &&
               createContext != nullptr && destroyContext != nullptr && makeCurrent != nullptr &&
               getPlatformDisplay != nullptr;
    }
};

Egl openEgl()
{
    Egl egl;
    void* library = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL); // never closed: drivers leave threads behind
    if (library == nullptr)
        return egl;
    const auto find = [&](auto& function, const char* name) {
        function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(dlsym(library, name));
    };
    find(egl.getProcAddress, "eglGetProcAddress");
    find(egl.initialize, "eglInitialize");
    find(egl.terminate, "eglTerminate");
    find(egl.bindApi, "eglBindAPI");
    find(egl.createContext, "eglCreateContext");
    find(egl.destroyContext, "eglDestroyContext");
    find(egl.makeCurrent, "eglMakeCurrent");
    if (egl.getProcAddress == nullptr)
        return egl;
    const auto findExtension = [&](auto& function, const char* name) {
        function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(egl.getProcAddress(name));
    };
    findExtension(egl.getPlatformDisplay, "eglGetPlatformDisplayEXT");
    findExtension(egl.queryDevices, "eglQueryDevicesEXT");
    findExtension(egl.queryDeviceString, "eglQueryDeviceStringEXT");
    return egl;
}

const Egl& egl()
{
    static const Egl opened = openEgl();
    return opened;
}

class Context : public EglContext
{
public:
    Context(EGLDisplay display, EGLContext context, bool isSoftware)
        : m_display(display), m_context(context), m_isSoftware(isSoftware)
    {
    }
    ~Context() override
    {
        egl().makeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        egl().destroyContext(m_display, m_context); // the display is shared by all who ask for it
    }

    void makeCurrent() override { egl().makeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, m_context); }
    [[nodiscard]] const gl::Functions& functions() const override { return m_functions; }
    [[nodiscard]] bool isSoftware() const override { return m_isSoftware; }

    /// Whether the driver has all functions.
    [[nodiscard]] bool loadFunctions() { return m_functions.load(egl().getProcAddress); }

private:
    EGLDisplay m_display;
    EGLContext m_context;
    bool m_isSoftware;
    gl::Functions m_functions;
};

/// Null: the display has no context of OpenGL 3.3 that needs no surface.
std::unique_ptr<EglContext> contextOn(EGLDisplay display, bool isSoftware)
{
    if (display == EGL_NO_DISPLAY || egl().initialize(display, nullptr, nullptr) == EGL_FALSE ||
        egl().bindApi(EGL_OPENGL_API) == EGL_FALSE)
        return nullptr;
    constexpr EGLint kWanted[] = {
        EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    const EGLContext made = egl().createContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, kWanted);
    if (made == EGL_NO_CONTEXT)
        return nullptr;
    auto context = std::make_unique<Context>(display, made, isSoftware);
    if (egl().makeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, made) == EGL_FALSE || !context->loadFunctions())
        return nullptr;
    return context;
}

std::vector<std::unique_ptr<EglContext>> contextsOfDevices()
{
    std::vector<std::unique_ptr<EglContext>> contexts;
    std::array<EGLDeviceEXT, 16> devices{};
    EGLint count = 0;
    if (egl().queryDevices == nullptr || egl().queryDeviceString == nullptr ||
        egl().queryDevices(static_cast<EGLint>(devices.size()), devices.data(), &count) == EGL_FALSE)
        return contexts;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        const char* extensions = egl().queryDeviceString(devices[i], EGL_EXTENSIONS);
        const bool isSoftware = extensions != nullptr && std::strstr(extensions, "EGL_MESA_device_software") != nullptr;
        if (auto context =
                contextOn(egl().getPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr), isSoftware))
            contexts.push_back(std::move(context));
    }
    std::ranges::stable_partition(contexts, [](const auto& context) { return !context->isSoftware(); });
    return contexts;
}

} // namespace

EglContexts eglContexts()
{
    if (!egl().isThere())
        return {{},
                Reason{QT_TRANSLATE_NOOP(
                    "Experiment", "there is no libEGL.so.1 on this machine (Debian: libegl1, libgl1-mesa-dri)")}};
    EglContexts found{contextsOfDevices(), std::nullopt};
    if (found.contexts.empty())
        if (auto context =
                contextOn(egl().getPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr), true))
            found.contexts.push_back(std::move(context));
    if (found.contexts.empty())
        found.lack = Reason{QT_TRANSLATE_NOOP(
            "Experiment", "no device of this machine draws by OpenGL 3.3 without a display (Debian: libgl1-mesa-dri)")};
    return found;
}

} // namespace rasterlens
