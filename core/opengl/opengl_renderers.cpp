#include "core/opengl/opengl_renderers.h"

#include "core/opengl/egl_contexts.h"
#include "core/opengl/gl_picture.h"
#include "core/pipeline/resolve.h"
#include "core/pipeline/shading.h"
#include "core/pipeline/vertex_stage.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <optional>

namespace rasterlens
{
namespace
{

bool hasHoles(const Scene& scene)
{
    return std::ranges::any_of(scene.materials, [](const Material& material) { return material.mask >= 0; });
}

/// Settings that OpenGL is not told here.
std::optional<Reason> refused(const Scene& scene, const Settings& settings)
{
    if (settings.fill != Fill::Solid || !scene.mesh.lines.empty())
        return Reason{QT_TRANSLATE_NOOP("Unsupported", "OpenGL is asked for filled faces only")};
    if (settings.shading != Shading::Gouraud && settings.shading != Shading::Texture)
        return Reason{QT_TRANSLATE_NOOP("Unsupported", "OpenGL is asked for shading gouraud and texture only")};
    if (settings.samples != Samples::One || settings.coverageRule != CoverageRule::Centre)
        return Reason{QT_TRANSLATE_NOOP("Unsupported", "OpenGL is asked for one sample a pixel, at its centre")};
    if (settings.visibility == Visibility::Painter)
        return Reason{QT_TRANSLATE_NOOP("Unsupported", "OpenGL does not sort faces: it needs visibility z-buffer")};
    if (settings.clipping != Clipping::Frustum && settings.clipping != Clipping::GuardBand)
        return Reason{QT_TRANSLATE_NOOP("Unsupported", "OpenGL clips by the view volume: it needs clipping frustum")};
    if (settings.clipZ != ClipZ::Gl)
        return Reason{QT_TRANSLATE_NOOP("Unsupported", "OpenGL clips at z = -w: it needs clip-z gl")};
    if (scene.secondPassFrom > 0 || settings.depthBias.isOn() || !settings.depthRange.isWhole())
        return Reason{QT_TRANSLATE_NOOP("Unsupported", "OpenGL is asked for one pass, without depth bias and range")};
    if (settings.depthFormat == DepthFormat::Unorm8)
        return Reason{QT_TRANSLATE_NOOP("Unsupported", "OpenGL has no depth-format unorm8")};
    if (hasHoles(scene) && settings.alphaTest == AlphaTest::On)
        return Reason{QT_TRANSLATE_NOOP("Unsupported", "OpenGL is not told of masks: it needs alpha-test off")};
    if (!settings.mistakes.isEmpty())
        return Reason{QT_TRANSLATE_NOOP("Unsupported", "OpenGL makes none of these mistakes")};
    return std::nullopt;
}

/// What a driver draws of a scene is its business alone: corners come in clip space, as our vertex stage made them, and
/// the shaders hand them on. So the referee judges clipping, snapping, coverage, depth and interpolation.
class OpenGlRenderer : public OtherRenderer
{
public:
    OpenGlRenderer(std::unique_ptr<EglContext> context, QString id)
        : m_context(std::move(context)), m_id(std::move(id)), m_gl(m_context->functions())
    {
        m_context->makeCurrent();
        const auto text = [&](GLenum what) {
            return QString::fromLatin1(reinterpret_cast<const char*>(m_gl.GetString(what)));
        };
        m_name = text(GL_RENDERER) + QStringLiteral(", OpenGL ") + text(GL_VERSION);
        m_gl.GetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &m_largestSide);
    }
    ~OpenGlRenderer() override
    {
        m_context->makeCurrent();
        m_picture.reset(); // while its context is the current one
    }

    [[nodiscard]] QString id() const override { return m_id; }
    [[nodiscard]] QString name() const override { return m_name; }

    [[nodiscard]] std::optional<Reason> unsupported(const Scene& scene, const Settings& settings) const override
    {
        if (std::max(settings.size.width(), settings.size.height()) > m_largestSide)
            return Reason{QT_TRANSLATE_NOOP("Unsupported", "this OpenGL draws at most %1 pixels a side"),
                          {m_largestSide}};
        return refused(scene, settings);
    }

    void load(const Scene& scene, const Settings& settings) override
    {
        m_context->makeCurrent();
        m_picture.reset(); // first: its memory may be needed
        m_picture.emplace(m_gl, scene, resolve(settings, scene));
    }

    void draw(Frame& frame, Outputs outputs) override
    {
        m_context->makeCurrent();
        m_picture->draw(frame, outputs);
    }

private:
    std::unique_ptr<EglContext> m_context;
    QString m_id;
    const gl::Functions& m_gl;
    QString m_name;
    GLint m_largestSide = 0;
    std::optional<GlPicture> m_picture;
};

} // namespace

OtherRenderers openGlRenderers()
{
    EglContexts found = eglContexts();
    OtherRenderers others{{}, std::move(found.lack)};
    int processors = 0;
    int software = 0;
    for (std::unique_ptr<EglContext>& context : found.contexts) {
        int& count = context->isSoftware() ? software : processors;
        QString id = context->isSoftware() ? QStringLiteral("opengl-software") : QStringLiteral("opengl-gpu");
        if (++count > 1)
            id += QStringLiteral("-%1").arg(count);
        others.renderers.push_back(std::make_unique<OpenGlRenderer>(std::move(context), id));
    }
    return others;
}

} // namespace rasterlens
