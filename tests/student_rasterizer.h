#pragma once
// A rasterizer as a student writes it: one loop over the bounding box of each triangle, in doubles, without clipping
// and without snapping, and its own mistakes. It shares no code with the program, whose pictures it is compared with,
// but the scene and the camera's matrix.
#include "core/scene/camera.h"
#include "core/scene/scene.h"

#include <QImage>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace rasterlens::test
{

/// What the student got wrong. Default-constructed, nothing.
struct StudentMistakes {
    enum class Tie { TopLeft, Inclusive, Exclusive };
    enum class Weights { Right, Rotated, Exchanged };
    enum class Depth { Less, None, Greater, ClearedToZero, WrittenOnFail };
    enum class Perspective { Right, Affine, TimesW };

    Tie tie = Tie::TopLeft;
    double sample = 0.5; ///< of a pixel's width
    Weights weights = Weights::Right;
    bool shortBox = false;
    Depth depth = Depth::Less;
    bool wholeVertices = false;
    bool oneWinding = false;
    double smallestArea = 0; ///< twice the area, in pixels
    Perspective perspective = Perspective::Right;
    bool upsideDown = false;
};

class StudentRasterizer
{
public:
    StudentRasterizer(const Scene& scene, const Settings& settings, const StudentMistakes& mistakes)
        : m_scene(scene), m_textured(settings.shading == Shading::Texture), m_mistakes(mistakes),
          m_image(settings.size, QImage::Format_RGB32)
    {
        m_image.fill(colorOf(scene.background));
        const bool reversed = mistakes.depth == StudentMistakes::Depth::Greater;
        const bool zero = mistakes.depth == StudentMistakes::Depth::ClearedToZero;
        m_depth.assign(std::size_t(m_image.width()) * std::size_t(m_image.height()), reversed || zero ? 0.0 : 1.0);
        const glm::dmat4 matrix = cameraMatrices(scene, settings).clipFromObjectDouble;
        for (std::size_t face = 0; face < scene.mesh.faceCount(); ++face)
            drawTriangle({cornerOf(face, 0, matrix), cornerOf(face, 1, matrix), cornerOf(face, 2, matrix)});
    }

    [[nodiscard]] const QImage& image() const { return m_image; }

private:
    struct Corner {
        double x, y, z, w;
        glm::dvec3 color;
        glm::dvec2 uv;
    };

    static QRgb colorOf(const glm::dvec3& color)
    {
        const auto channel = [](double c) { return int(std::lround(255 * std::clamp(c, 0.0, 1.0))); };
        return qRgb(channel(color.r), channel(color.g), channel(color.b));
    }

    [[nodiscard]] Corner cornerOf(std::size_t face, std::size_t i, const glm::dmat4& matrix) const
    {
        const MeshVertex& vertex = m_scene.mesh.vertices[m_scene.mesh.indices[3 * face + i]];
        const glm::dvec4 clip = matrix * glm::dvec4(vertex.position);
        const double up = m_mistakes.upsideDown ? -1 : 1;
        Corner corner{(clip.x / clip.w * 0.5 + 0.5) * m_image.width(),
                      (0.5 - up * clip.y / clip.w * 0.5) * m_image.height(),
                      clip.z / clip.w * 0.5 + 0.5,
                      clip.w,
                      glm::dvec3(vertex.color),
                      glm::dvec2(vertex.uv)};
        if (m_mistakes.wholeVertices) {
            corner.x = std::trunc(corner.x);
            corner.y = std::trunc(corner.y);
        }
        return corner;
    }

    static double edge(const Corner& a, const Corner& b, double x, double y)
    {
        return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
    }

    /// Whether a pixel with that edge value is on the side of the triangle, whose area is positive.
    [[nodiscard]] bool isInside(double value, const Corner& a, const Corner& b) const
    {
        if (value != 0)
            return value > 0;
        if (m_mistakes.tie != StudentMistakes::Tie::TopLeft)
            return m_mistakes.tie == StudentMistakes::Tie::Inclusive;
        const bool top = a.y == b.y && b.x > a.x;
        const bool left = b.y < a.y;
        return top || left;
    }

    void drawTriangle(std::array<Corner, 3> t)
    {
        double area = edge(t[0], t[1], t[2].x, t[2].y); // positive: clockwise on the screen
        const bool turned = area < 0;
        if (area == 0 || std::abs(area) < m_mistakes.smallestArea || (!turned && m_mistakes.oneWinding))
            return;
        if (turned) {
            std::swap(t[1], t[2]);
            area = -area;
        }
        const auto xs = std::minmax({t[0].x, t[1].x, t[2].x});
        const auto ys = std::minmax({t[0].y, t[1].y, t[2].y});
        const int spare = m_mistakes.shortBox ? 0 : 1;
        const int left = std::max(0, int(std::floor(xs.first)));
        const int top = std::max(0, int(std::floor(ys.first)));
        const int right = std::min(m_image.width(), int(std::ceil(xs.second)) - 1 + spare);
        const int bottom = std::min(m_image.height(), int(std::ceil(ys.second)) - 1 + spare);
        for (int y = top; y < bottom; ++y)
            for (int x = left; x < right; ++x) {
                const double px = x + m_mistakes.sample;
                const double py = y + m_mistakes.sample;
                const std::array<double, 3> e{edge(t[1], t[2], px, py), edge(t[2], t[0], px, py),
                                              edge(t[0], t[1], px, py)};
                if (isInside(e[0], t[1], t[2]) && isInside(e[1], t[2], t[0]) && isInside(e[2], t[0], t[1]))
                    shade(x, y, t, {e[0] / area, e[1] / area, e[2] / area}, turned);
            }
    }

    void shade(int x, int y, const std::array<Corner, 3>& t, std::array<double, 3> weights, bool turned)
    {
        const double z = weights[0] * t[0].z + weights[1] * t[1].z + weights[2] * t[2].z;
        if (!passes(z, m_depth[std::size_t(y) * std::size_t(m_image.width()) + std::size_t(x)]))
            return;
        if (m_mistakes.perspective != StudentMistakes::Perspective::Affine) {
            double sum = 0;
            for (std::size_t i = 0; i < 3; ++i) {
                const bool inverse = m_mistakes.perspective == StudentMistakes::Perspective::Right;
                weights[i] *= inverse ? 1 / t[i].w : t[i].w;
                sum += weights[i];
            }
            for (double& weight : weights)
                weight /= sum;
        }
        if (turned) // in the order in which the file has the corners
            std::swap(weights[1], weights[2]);
        if (m_mistakes.weights == StudentMistakes::Weights::Rotated)
            weights = {weights[2], weights[0], weights[1]};
        if (m_mistakes.weights == StudentMistakes::Weights::Exchanged)
            std::swap(weights[1], weights[2]);
        const std::array<std::size_t, 3> order{0, std::size_t(turned ? 2 : 1), std::size_t(turned ? 1 : 2)};
        glm::dvec3 color(0);
        glm::dvec2 uv(0);
        for (std::size_t i = 0; i < 3; ++i) {
            color += weights[i] * t[order[i]].color;
            uv += weights[i] * t[order[i]].uv;
        }
        reinterpret_cast<QRgb*>(m_image.scanLine(y))[x] = m_textured ? texel(uv) : colorOf(color);
    }

    bool passes(double z, double& stored) const
    {
        using Depth = StudentMistakes::Depth;
        const bool passed =
            m_mistakes.depth == Depth::None || (m_mistakes.depth == Depth::Greater ? z > stored : z < stored);
        if (passed || m_mistakes.depth == Depth::WrittenOnFail)
            stored = z;
        return passed;
    }

    [[nodiscard]] QRgb texel(glm::dvec2 uv) const
    {
        const Texture& texture = m_scene.textures.front();
        const auto at = [](double t, int size) { return std::clamp(int(std::floor(t * size)), 0, size - 1); };
        return texture.texels[std::size_t(at(uv.y, texture.height) * texture.width + at(uv.x, texture.width))];
    }

    const Scene& m_scene;
    bool m_textured;
    StudentMistakes m_mistakes;
    QImage m_image;
    std::vector<double> m_depth;
};

} // namespace rasterlens::test
