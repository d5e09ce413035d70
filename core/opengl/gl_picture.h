#pragma once
#include "core/opengl/gl_functions.h"
#include "core/pipeline/frame.h"
#include "core/pipeline/resolve.h"

#include <cstdint>
#include <vector>

namespace rasterlens
{

/// A scene in the memory of an OpenGL context, and the buffers that it is drawn into. The context must be current
/// whenever a function of it is called, its end included.
///
/// Row 0 of the buffers is the top of the picture: y of the corners is negated on the way, which rounds nothing. So
/// OpenGL, which counts rows from the bottom, sees the same rows in the same order as we do, and `top` of its tie rule
/// is the top of the picture.
class GlPicture
{
public:
    /// errors  throws std::bad_alloc where the driver has no memory for it
    GlPicture(const gl::Functions& gl, const Scene& scene, const Resolved& resolved);
    GlPicture(const GlPicture&) = delete;
    GlPicture& operator=(const GlPicture&) = delete;
    ~GlPicture();

    /// Clears, draws and reads back.
    void draw(Frame& frame, Outputs outputs);

private:
    /// Faces in a row that share a texture: a call.
    struct Run {
        GLuint texture;
        GLsizei first; ///< face
        GLsizei count; ///< faces
    };

    void uploadMesh(const Scene& scene, const Resolved& resolved);
    void uploadTextures(const Scene& scene);
    [[nodiscard]] GLuint uploadTexture(const Texture& texture);
    void makeRuns(const Scene& scene);
    void makeBuffers();
    [[nodiscard]] GLuint makeRenderbuffer(GLenum format);
    [[nodiscard]] GLuint makeFramebuffer(GLuint color, GLuint depth);
    [[nodiscard]] GLuint makeProgram(const char* fragmentShader);
    void setDepthAndCulling(bool depthTested);
    void drawRuns(GLuint program);
    void drawIds(Frame& frame, Outputs outputs);
    void drawCoverage(Frame& frame);

    const gl::Functions& m_gl;
    Rules m_rules;
    glm::vec3 m_background;
    GLsizei m_width;
    GLsizei m_height;
    std::vector<Run> m_runs;
    std::vector<GLuint> m_textures; ///< of the scene, and the plain one
    std::vector<GLuint> m_renderbuffers;
    std::vector<GLuint> m_framebuffers;
    std::vector<GLuint> m_programs;
    GLuint m_vertexArray = 0;
    GLuint m_vertexBuffer = 0;
    GLuint m_indexBuffer = 0;
    GLuint m_pictureTarget = 0;
    GLuint m_idTarget = 0;
    GLuint m_coverageTarget = 0;
    GLuint m_colorProgram = 0;
    GLuint m_idProgram = 0;
    GLuint m_coverageProgram = 0;
};

} // namespace rasterlens
