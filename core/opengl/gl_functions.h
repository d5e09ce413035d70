#pragma once
#include <GL/glcorearb.h>

#include <type_traits>

namespace rasterlens::gl
{

// The functions of OpenGL 3.3 that are called here: name without gl, and the type that Khronos' header has for it.
#define RASTERLENS_GL_FUNCTIONS(X)                                                                                     \
    X(AttachShader, ATTACHSHADER)                                                                                      \
    X(BindAttribLocation, BINDATTRIBLOCATION)                                                                          \
    X(BindBuffer, BINDBUFFER)                                                                                          \
    X(BindFragDataLocation, BINDFRAGDATALOCATION)                                                                      \
    X(BindFramebuffer, BINDFRAMEBUFFER)                                                                                \
    X(BindRenderbuffer, BINDRENDERBUFFER)                                                                              \
    X(BindTexture, BINDTEXTURE)                                                                                        \
    X(BindVertexArray, BINDVERTEXARRAY)                                                                                \
    X(BlendFunc, BLENDFUNC)                                                                                            \
    X(BufferData, BUFFERDATA)                                                                                          \
    X(CheckFramebufferStatus, CHECKFRAMEBUFFERSTATUS)                                                                  \
    X(Clear, CLEAR)                                                                                                    \
    X(ClearBufferfv, CLEARBUFFERFV)                                                                                    \
    X(ClearBufferiv, CLEARBUFFERIV)                                                                                    \
    X(ClearColor, CLEARCOLOR)                                                                                          \
    X(ClearDepth, CLEARDEPTH)                                                                                          \
    X(CompileShader, COMPILESHADER)                                                                                    \
    X(CreateProgram, CREATEPROGRAM)                                                                                    \
    X(CreateShader, CREATESHADER)                                                                                      \
    X(CullFace, CULLFACE)                                                                                              \
    X(DeleteBuffers, DELETEBUFFERS)                                                                                    \
    X(DeleteFramebuffers, DELETEFRAMEBUFFERS)                                                                          \
    X(DeleteProgram, DELETEPROGRAM)                                                                                    \
    X(DeleteRenderbuffers, DELETERENDERBUFFERS)                                                                        \
    X(DeleteShader, DELETESHADER)                                                                                      \
    X(DeleteTextures, DELETETEXTURES)                                                                                  \
    X(DeleteVertexArrays, DELETEVERTEXARRAYS)                                                                          \
    X(DepthFunc, DEPTHFUNC)                                                                                            \
    X(Disable, DISABLE)                                                                                                \
    X(DrawElements, DRAWELEMENTS)                                                                                      \
    X(Enable, ENABLE)                                                                                                  \
    X(EnableVertexAttribArray, ENABLEVERTEXATTRIBARRAY)                                                                \
    X(FramebufferRenderbuffer, FRAMEBUFFERRENDERBUFFER)                                                                \
    X(FrontFace, FRONTFACE)                                                                                            \
    X(GenBuffers, GENBUFFERS)                                                                                          \
    X(GenFramebuffers, GENFRAMEBUFFERS)                                                                                \
    X(GenRenderbuffers, GENRENDERBUFFERS)                                                                              \
    X(GenTextures, GENTEXTURES)                                                                                        \
    X(GenVertexArrays, GENVERTEXARRAYS)                                                                                \
    X(GetError, GETERROR)                                                                                              \
    X(GetIntegerv, GETINTEGERV)                                                                                        \
    X(GetProgramiv, GETPROGRAMIV)                                                                                      \
    X(GetString, GETSTRING)                                                                                            \
    X(GetUniformLocation, GETUNIFORMLOCATION)                                                                          \
    X(LinkProgram, LINKPROGRAM)                                                                                        \
    X(PixelStorei, PIXELSTOREI)                                                                                        \
    X(ReadPixels, READPIXELS)                                                                                          \
    X(RenderbufferStorage, RENDERBUFFERSTORAGE)                                                                        \
    X(ShaderSource, SHADERSOURCE)                                                                                      \
    X(TexImage2D, TEXIMAGE2D)                                                                                          \
    X(TexParameteri, TEXPARAMETERI)                                                                                    \
    X(Uniform1i, UNIFORM1I)                                                                                            \
    X(UseProgram, USEPROGRAM)                                                                                          \
    X(VertexAttribPointer, VERTEXATTRIBPOINTER)                                                                        \
    X(Viewport, VIEWPORT)

/// OpenGL's functions, as a driver hands them out at run time.
struct Functions {
#define RASTERLENS_GL_MEMBER(name, type) PFNGL##type##PROC name = nullptr;
    RASTERLENS_GL_FUNCTIONS(RASTERLENS_GL_MEMBER)
#undef RASTERLENS_GL_MEMBER

    /// Asks for every function by its name.
    ///
    /// out   whether all were found
    template <class Find>
    bool load(Find&& find)
    {
        bool isWhole = true;
        const auto loadOne = [&](auto& function, const char* name) {
            function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(find(name));
            isWhole = isWhole && function != nullptr;
        };
#define RASTERLENS_GL_LOAD(name, type) loadOne(name, "gl" #name);
        RASTERLENS_GL_FUNCTIONS(RASTERLENS_GL_LOAD)
#undef RASTERLENS_GL_LOAD
        return isWhole;
    }
};

} // namespace rasterlens::gl
