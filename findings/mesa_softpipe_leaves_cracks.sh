#!/usr/bin/env bash
# Question: a mesh without gaps or overlaps is drawn by Mesa's softpipe, which people use as the plain reference beside the
#   drivers that generate code. All corners lie on pixel centres, so all coordinates are exact. Is every pixel drawn once?
# Usual guess: yes. Watertight edges are what OpenGL asks for, and a reference has them if any driver does.
# Seen with Mesa 22.3.6 (Debian 12): llvmpipe draws every pixel once. softpipe leaves 45 of 2.6 million pixels out and draws 13
#   twice. It reports 4 subpixel bits, where llvmpipe reports 8.
# Why it matters: whoever takes softpipe for the truth reports its holes as errors of a rasterizer that has none. Differences
#   from it mean something away from edges only.
# Exits 0 if this is still so, 1 if it changed, 2 if the packages cannot be had (apt-get install g++ libegl-dev libgl-dev
#   libgl1-mesa-dri).
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
[[ $(dpkg-query -Wf '${Version}' libgl1-mesa-dri 2>/dev/null) == 22.3.6* ]] || exit 2
cat >mesh.cpp <<'CPP'
#define GL_GLEXT_PROTOTYPES
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glext.h>

#include <array>
#include <cstdio>
#include <random>
#include <vector>

constexpr int kSide = 256; // pixels
constexpr int kCells = 16; // of 16 pixels, so that none folds over

void beginContext()
{
    const auto displayOf = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    EGLDisplay display = displayOf(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    eglInitialize(display, nullptr, nullptr);
    eglBindAPI(EGL_OPENGL_API);
    const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config;
    EGLint count;
    eglChooseConfig(display, wanted, &config, 1, &count);
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr));
    GLuint frame, color;
    glGenFramebuffers(1, &frame);
    glBindFramebuffer(GL_FRAMEBUFFER, frame);
    glGenRenderbuffers(1, &color);
    glBindRenderbuffer(GL_RENDERBUFFER, color);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, kSide, kSide);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color);
    glViewport(0, 0, kSide, kSide);
    glMatrixMode(GL_PROJECTION);
    glOrtho(0, kSide, 0, kSide, -1, 1);
}

// The corner of a column and a row of the grid: on a pixel centre, up to 3 pixels off; those of the border lie outside.
std::array<int, 2> cornerOf(int column, int row, std::mt19937& random)
{
    const auto place = [&](int i) { return i == 0 ? -8 : i == kCells ? kSide + 8 : i * kSide / kCells + int(random() % 7) - 3; };
    return {place(column), place(row)};
}

int main()
{
    beginContext();
    glColor3ub(100, 100, 100);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE); // a pixel drawn twice is 200
    std::mt19937 random(7);
    long holes = 0, twice = 0;
    for (int picture = 0; picture < 40; ++picture) {
        std::vector<std::array<int, 2>> corners;
        for (int i = 0; i < (kCells + 1) * (kCells + 1); ++i)
            corners.push_back(cornerOf(i % (kCells + 1), i / (kCells + 1), random));
        glClear(GL_COLOR_BUFFER_BIT);
        glBegin(GL_TRIANGLES);
        for (int cell = 0; cell < kCells * kCells; ++cell) {
            const int a = cell % kCells + cell / kCells * (kCells + 1), b = a + 1, d = a + kCells + 1, c = d + 1;
            for (const int corner : {a, b, c, a, c, d})
                glVertex2f(corners[corner][0] + 0.5F, corners[corner][1] + 0.5F);
        }
        glEnd();
        std::vector<unsigned char> pixels(4 * kSide * kSide);
        glReadPixels(0, 0, kSide, kSide, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
        for (std::size_t i = 0; i < pixels.size(); i += 4) {
            holes += pixels[i] < 50;
            twice += pixels[i] > 150;
        }
    }
    GLint bits = 0;
    glGetIntegerv(GL_SUBPIXEL_BITS, &bits);
    std::printf("%.8s: %ld holes, %ld drawn twice of %d; GL_SUBPIXEL_BITS %d\n", glGetString(GL_RENDERER), holes, twice,
                40 * kSide * kSide, bits);
}
CPP
g++ -std=c++17 -O1 mesh.cpp -o mesh -lEGL -lGL || exit 2
for driver in llvmpipe softpipe; do
    LIBGL_ALWAYS_SOFTWARE=1 GALLIUM_DRIVER=$driver ./mesh
done | tee seen
grep -q '^llvmpipe: 0 holes, 0 drawn twice' seen && grep -q '^softpipe: [1-9][0-9]* holes, [1-9]' seen || {
    echo "This changed."
    exit 1
}
