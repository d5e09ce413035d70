#include "core/opengl/gl_picture.h"

#include "core/pipeline/shading.h"
#include "core/pipeline/vertex_stage.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <new>

namespace rasterlens
{
namespace
{

/// A corner as the vertex shader takes it.
struct GlVertex {
    glm::vec4 position;
    glm::vec3 color;
    glm::vec2 uv;
};

constexpr const char* kVertexShader = R"(#version 330 core
in vec4 position;
in vec3 color;
in vec2 uv;
out vec3 fragmentColor;
out vec2 fragmentUv;
void main()
{
    gl_Position = position;
    fragmentColor = color;
    fragmentUv = uv;
}
)";
constexpr const char* kGouraudShader = R"(#version 330 core
in vec3 fragmentColor;
out vec4 result;
void main() { result = vec4(fragmentColor, 1); }
)";
constexpr const char* kTextureShader = R"(#version 330 core
in vec3 fragmentColor;
in vec2 fragmentUv;
uniform sampler2D image;
out vec4 result;
void main() { result = vec4(fragmentColor * texture(image, fragmentUv).rgb, 1); }
)";
constexpr const char* kIdShader = R"(#version 330 core
uniform int firstFace;
out int result;
void main() { result = firstFace + gl_PrimitiveID; }
)";
constexpr const char* kCoverageShader = R"(#version 330 core
out float result;
void main() { result = 1; }
)";

GLenum depthFormatOf(DepthFormat format)
{
    switch (format) {
    case DepthFormat::Float32: return GL_DEPTH_COMPONENT32F;
    case DepthFormat::Unorm24: return GL_DEPTH_COMPONENT24;
    case DepthFormat::Unorm16:
    case DepthFormat::Unorm8: break;
    }
    return GL_DEPTH_COMPONENT16;
}

GLenum functionOf(DepthCompare compare)
{
    switch (compare) {
    case DepthCompare::Less: return GL_LESS;
    case DepthCompare::LessEqual: return GL_LEQUAL;
    case DepthCompare::Equal: return GL_EQUAL;
    case DepthCompare::GreaterEqual: return GL_GEQUAL;
    case DepthCompare::Greater: return GL_GREATER;
    case DepthCompare::NotEqual: return GL_NOTEQUAL;
    case DepthCompare::Always: break;
    }
    return GL_ALWAYS;
}

bool isFinite(const glm::dvec4& p)
{
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z) && std::isfinite(p.w);
}

} // namespace

GlPicture::GlPicture(const gl::Functions& gl, const Scene& scene, const Resolved& resolved)
    : m_gl(gl), m_rules(resolved.rules), m_background(scene.background), m_width(resolved.rules.width),
      m_height(resolved.rules.height)
{
    while (m_gl.GetError() != GL_NO_ERROR) {
    }
    uploadMesh(scene, resolved);
    uploadTextures(scene);
    makeRuns(scene);
    makeBuffers();
    m_colorProgram = makeProgram(m_rules.shading == Shading::Texture ? kTextureShader : kGouraudShader);
    m_idProgram = makeProgram(kIdShader);
    m_coverageProgram = makeProgram(kCoverageShader);
    m_gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
    if (m_gl.GetError() == GL_OUT_OF_MEMORY)
        throw std::bad_alloc();
}

GlPicture::~GlPicture()
{
    const auto count = [](const std::vector<GLuint>& names) { return static_cast<GLsizei>(names.size()); };
    for (const GLuint program : m_programs)
        m_gl.DeleteProgram(program);
    m_gl.DeleteFramebuffers(count(m_framebuffers), m_framebuffers.data());
    m_gl.DeleteRenderbuffers(count(m_renderbuffers), m_renderbuffers.data());
    m_gl.DeleteTextures(count(m_textures), m_textures.data());
    m_gl.DeleteBuffers(1, &m_vertexBuffer);
    m_gl.DeleteBuffers(1, &m_indexBuffer);
    m_gl.DeleteVertexArrays(1, &m_vertexArray);
}

/// Faces with a corner that is no number are given one corner three times: they keep their number and cover nothing.
void GlPicture::uploadMesh(const Scene& scene, const Resolved& resolved)
{
    const std::vector<ClipVertex> shaded = shadeVertices(scene, resolved.matrices, resolved.rules);
    const bool hasUv = m_rules.shading == Shading::Texture;
    std::vector<GlVertex> vertices;
    vertices.reserve(shaded.size());
    for (const ClipVertex& vertex : shaded) {
        const glm::dvec4& p = vertex.positionClip;
        const Varyings& v = vertex.varyings;
        vertices.push_back({glm::vec4(p.x, -p.y, p.z, p.w),
                            {v[kVaryingColor], v[kVaryingColor + 1], v[kVaryingColor + 2]},
                            hasUv ? glm::vec2(v[kVaryingUv], v[kVaryingUv + 1]) : glm::vec2(0)});
    }
    std::vector<std::uint32_t> indices = scene.mesh.indices;
    for (std::size_t face = 0; face + 2 < indices.size(); face += 3)
        for (std::size_t i = face; i < face + 3; ++i)
            if (!isFinite(shaded[indices[i]].positionClip)) {
                std::fill_n(indices.begin() + static_cast<std::ptrdiff_t>(face), 3, indices[i]);
                break;
            }
    m_gl.GenVertexArrays(1, &m_vertexArray);
    m_gl.BindVertexArray(m_vertexArray);
    m_gl.GenBuffers(1, &m_vertexBuffer);
    m_gl.BindBuffer(GL_ARRAY_BUFFER, m_vertexBuffer);
    m_gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(GlVertex)), vertices.data(),
                    GL_STATIC_DRAW);
    m_gl.GenBuffers(1, &m_indexBuffer);
    m_gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, m_indexBuffer);
    m_gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size() * sizeof(std::uint32_t)),
                    indices.data(), GL_STATIC_DRAW);
    const auto attribute = [&](GLuint at, GLint floats, std::size_t offset) {
        m_gl.EnableVertexAttribArray(at);
        m_gl.VertexAttribPointer(at, floats, GL_FLOAT, GL_FALSE, sizeof(GlVertex),
                                 reinterpret_cast<const void*>(offset));
    };
    attribute(0, 4, offsetof(GlVertex, position));
    attribute(1, 3, offsetof(GlVertex, color));
    attribute(2, 2, offsetof(GlVertex, uv));
}

void GlPicture::uploadTextures(const Scene& scene)
{
    if (m_rules.shading != Shading::Texture)
        return;
    for (const Texture& texture : scene.textures)
        m_textures.push_back(uploadTexture(texture));
    m_textures.push_back(uploadTexture(plainTexture(scene)));
}

GLuint GlPicture::uploadTexture(const Texture& texture)
{
    GLuint name = 0;
    m_gl.GenTextures(1, &name);
    m_gl.BindTexture(GL_TEXTURE_2D, name);
    const MipLevels& mips = texture.mipLevels();
    for (std::size_t level = 0; level < mips.levels.size(); ++level)
        m_gl.TexImage2D(GL_TEXTURE_2D, static_cast<GLint>(level), GL_RGBA8, mips.levels[level].width,
                        mips.levels[level].height, 0, GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV,
                        mips.texels.data() + mips.levels[level].first);
    const auto set = [&](GLenum what, GLint value) { m_gl.TexParameteri(GL_TEXTURE_2D, what, value); };
    set(GL_TEXTURE_MAX_LEVEL, static_cast<GLint>(mips.levels.size()) - 1);
    const GLint wrap = texture.clamp ? GL_CLAMP_TO_EDGE : GL_REPEAT;
    set(GL_TEXTURE_WRAP_S, wrap);
    set(GL_TEXTURE_WRAP_T, wrap);
    switch (m_rules.textureFilter) {
    case TextureFilter::Nearest:
        set(GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        set(GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        break;
    case TextureFilter::Bilinear:
        set(GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        set(GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        break;
    case TextureFilter::Trilinear:
        set(GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        set(GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
        break;
    }
    return name;
}

void GlPicture::makeRuns(const Scene& scene)
{
    const auto textureOf = [&](std::size_t face) -> GLuint {
        if (m_textures.empty())
            return 0;
        const std::size_t material = scene.mesh.faceMaterial.empty() ? 0 : scene.mesh.faceMaterial[face];
        const int texture = scene.materials[material].texture;
        return texture < 0 ? m_textures.back() : m_textures[static_cast<std::size_t>(texture)];
    };
    for (std::size_t face = 0; face < scene.mesh.faceCount(); ++face) {
        if (m_runs.empty() || m_runs.back().texture != textureOf(face))
            m_runs.push_back({textureOf(face), static_cast<GLsizei>(face), 0});
        ++m_runs.back().count;
    }
}

void GlPicture::makeBuffers()
{
    const GLuint depth = makeRenderbuffer(depthFormatOf(m_rules.depthFormat));
    m_pictureTarget = makeFramebuffer(makeRenderbuffer(GL_RGBA8), depth);
    m_idTarget = makeFramebuffer(makeRenderbuffer(GL_R32I), depth);
    m_coverageTarget = makeFramebuffer(makeRenderbuffer(GL_R32F), 0);
}

GLuint GlPicture::makeRenderbuffer(GLenum format)
{
    GLuint name = 0;
    m_gl.GenRenderbuffers(1, &name);
    m_renderbuffers.push_back(name);
    m_gl.BindRenderbuffer(GL_RENDERBUFFER, name);
    m_gl.RenderbufferStorage(GL_RENDERBUFFER, format, m_width, m_height);
    return name;
}

GLuint GlPicture::makeFramebuffer(GLuint color, GLuint depth)
{
    GLuint name = 0;
    m_gl.GenFramebuffers(1, &name);
    m_framebuffers.push_back(name);
    m_gl.BindFramebuffer(GL_FRAMEBUFFER, name);
    m_gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color);
    if (depth != 0)
        m_gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
    if (m_gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw std::bad_alloc(); // all formats are ones that OpenGL 3.3 must have
    return name;
}

GLuint GlPicture::makeProgram(const char* fragmentShader)
{
    const GLuint program = m_gl.CreateProgram();
    m_programs.push_back(program);
    const auto attach = [&](GLenum kind, const char* source) {
        const GLuint shader = m_gl.CreateShader(kind);
        m_gl.ShaderSource(shader, 1, &source, nullptr);
        m_gl.CompileShader(shader);
        m_gl.AttachShader(program, shader);
        m_gl.DeleteShader(shader); // with the program
    };
    attach(GL_VERTEX_SHADER, kVertexShader);
    attach(GL_FRAGMENT_SHADER, fragmentShader);
    m_gl.BindAttribLocation(program, 0, "position");
    m_gl.BindAttribLocation(program, 1, "color");
    m_gl.BindAttribLocation(program, 2, "uv");
    m_gl.BindFragDataLocation(program, 0, "result");
    m_gl.LinkProgram(program);
    GLint isLinked = 0;
    m_gl.GetProgramiv(program, GL_LINK_STATUS, &isLinked);
    if (isLinked == 0)
        throw std::bad_alloc(); // the shaders are fixed: only memory can be wanting
    return program;
}

void GlPicture::setDepthAndCulling(bool depthTested)
{
    const auto enable = [&](GLenum what, bool on) { on ? m_gl.Enable(what) : m_gl.Disable(what); };
    enable(GL_DEPTH_TEST, depthTested);
    m_gl.DepthFunc(functionOf(m_rules.depthCompare));
    m_gl.ClearDepth(static_cast<double>(m_rules.depthClear));
    enable(GL_CULL_FACE, m_rules.culling != Culling::None);
    m_gl.CullFace(m_rules.culling == Culling::Front ? GL_FRONT : GL_BACK);
    m_gl.FrontFace(m_rules.frontSign > 0 ? GL_CW : GL_CCW); // upside down
    m_gl.Viewport(0, 0, m_width, m_height);
}

void GlPicture::drawRuns(GLuint program)
{
    m_gl.UseProgram(program);
    m_gl.BindVertexArray(m_vertexArray);
    const GLint firstFace = m_gl.GetUniformLocation(program, "firstFace");
    for (const Run& run : m_runs) {
        if (run.texture != 0)
            m_gl.BindTexture(GL_TEXTURE_2D, run.texture);
        if (firstFace >= 0)
            m_gl.Uniform1i(firstFace, run.first);
        const std::size_t offset = 3 * static_cast<std::size_t>(run.first) * sizeof(std::uint32_t);
        m_gl.DrawElements(GL_TRIANGLES, 3 * run.count, GL_UNSIGNED_INT, reinterpret_cast<const void*>(offset));
    }
}

void GlPicture::draw(Frame& frame, Outputs outputs)
{
    const QSize size(m_width, m_height);
    if (outputs.picture) {
        if (frame.image.size() != size)
            frame.image = QImage(size, QImage::Format_RGB32);
        if (frame.image.isNull())
            throw std::bad_alloc();
        m_gl.BindFramebuffer(GL_FRAMEBUFFER, m_pictureTarget);
        setDepthAndCulling(m_rules.depthTested);
        m_gl.ClearColor(m_background.r, m_background.g, m_background.b, 1);
        m_gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        drawRuns(m_colorProgram);
        m_gl.ReadPixels(0, 0, m_width, m_height, GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV, frame.image.bits());
    }
    if (outputs.depth || outputs.ids)
        drawIds(frame, outputs);
    if (outputs.coverage)
        drawCoverage(frame);
}

void GlPicture::drawIds(Frame& frame, Outputs outputs)
{
    const std::size_t pixels = static_cast<std::size_t>(m_width) * static_cast<std::size_t>(m_height);
    m_gl.BindFramebuffer(GL_FRAMEBUFFER, m_idTarget);
    setDepthAndCulling(m_rules.depthTested);
    constexpr GLint kNone[] = {-1, 0, 0, 0};
    m_gl.ClearBufferiv(GL_COLOR, 0, kNone);
    m_gl.Clear(GL_DEPTH_BUFFER_BIT);
    drawRuns(m_idProgram);
    if (outputs.ids) {
        frame.ids.resize(pixels);
        m_gl.ReadPixels(0, 0, m_width, m_height, GL_RED_INTEGER, GL_INT, frame.ids.data());
    }
    if (outputs.depth)
        m_gl.ReadPixels(0, 0, m_width, m_height, GL_DEPTH_COMPONENT, GL_FLOAT, frame.depth.write(pixels));
}

/// Every face adds 1 to the pixels that it covers.
void GlPicture::drawCoverage(Frame& frame)
{
    const std::size_t pixels = static_cast<std::size_t>(m_width) * static_cast<std::size_t>(m_height);
    m_gl.BindFramebuffer(GL_FRAMEBUFFER, m_coverageTarget);
    setDepthAndCulling(false);
    constexpr GLfloat kNone[] = {0, 0, 0, 0};
    m_gl.ClearBufferfv(GL_COLOR, 0, kNone);
    m_gl.Enable(GL_BLEND);
    m_gl.BlendFunc(GL_ONE, GL_ONE);
    drawRuns(m_coverageProgram);
    m_gl.Disable(GL_BLEND);
    std::vector<float> counts(pixels);
    m_gl.ReadPixels(0, 0, m_width, m_height, GL_RED, GL_FLOAT, counts.data());
    frame.coverage.resize(pixels);
    std::ranges::transform(counts, frame.coverage.begin(),
                           [](float count) { return static_cast<std::uint16_t>(std::min(count, 65535.0F)); });
}

} // namespace rasterlens
