#pragma once
#include "core/base/reason.h"
#include "core/opengl/gl_functions.h"

#include <memory>
#include <optional>
#include <vector>

namespace rasterlens
{

/// A context of OpenGL 3.3 without a surface, on one of the machine's devices. Only the thread that made it uses it.
class EglContext
{
public:
    EglContext() = default;
    EglContext(const EglContext&) = delete;
    EglContext& operator=(const EglContext&) = delete;
    virtual ~EglContext() = default;

    /// Makes it the one that the functions draw with.
    virtual void makeCurrent() = 0;
    [[nodiscard]] virtual const gl::Functions& functions() const = 0;
    /// Whether the processor draws, in place of a device made for it.
    [[nodiscard]] virtual bool isSoftware() const = 0;
};

/// A context on every device that has one, graphics processors first; or why there is none.
struct EglContexts {
    std::vector<std::unique_ptr<EglContext>> contexts;
    std::optional<Reason> lack;
};
[[nodiscard]] EglContexts eglContexts();

} // namespace rasterlens
