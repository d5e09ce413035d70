#pragma once
#include "core/scene/scene.h"

#include <glm/glm.hpp>

#include <cstdint>

namespace rasterlens
{

/// Appends a corner in object space.
///
/// in   a normal of any length but zero
/// out  its index
std::uint32_t addVertex(Mesh& mesh, glm::dvec3 position, glm::dvec3 normal, glm::vec3 color, glm::dvec2 uv = {0, 0});

/// Appends a face of corners that are there; nothing if two of them lie at one point (the triangles at a pole).
void addFace(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c);

/// Appends a triangle with corners and a normal of its own, front side counter-clockwise.
void addFlatTriangle(Mesh& mesh, glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, glm::vec3 color);

/// Appends a plane quad a b c d, counter-clockwise, as a b c and a c d, with uv (0,0) (1,0) (1,1) (0,1).
void addFlatQuad(Mesh& mesh, glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, glm::dvec3 d, glm::vec3 color);

/// Appends (columns + 1) x (rows + 1) corners and two faces a cell.
///
/// in  vertexAt(column, row) appends a corner and returns its index; it is asked row by row. Front is where columns
///     run to the right and rows run up
template <typename VertexAt>
void addGrid(Mesh& mesh, int columns, int rows, VertexAt vertexAt)
{
    std::vector<std::uint32_t> corners;
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column <= columns; ++column)
            corners.push_back(vertexAt(column, row));
    const auto corner = [&](int column, int row) {
        return corners[static_cast<std::size_t>(row * (columns + 1) + column)];
    };
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            addFace(mesh, corner(column, row), corner(column + 1, row), corner(column + 1, row + 1));
            addFace(mesh, corner(column, row), corner(column + 1, row + 1), corner(column, row + 1));
        }
}

/// A clip-space corner that lands on a screen point (pixels, y down) of a viewport, at depth 0.5.
///
/// exact  without rounding for w = the side of a square viewport and points on the 1/256 grid; for w = 1 where the
///        side is a power of two
[[nodiscard]] MeshVertex cornerAtPixel(glm::dvec2 screen, QSize size, glm::vec3 color, double w = 1);

/// Appends a triangle of three clip-space corners.
void addClipTriangle(Mesh& mesh, const MeshVertex& a, const MeshVertex& b, const MeshVertex& c);

/// A square texture of cells x cells fields in two colours, 0xffRRGGBB.
[[nodiscard]] Texture checkerboard(const QString& name, int side, int cells, std::uint32_t even, std::uint32_t odd);

/// A fully saturated colour; `turn` goes once round the colour wheel from 0 (red) to 1 (red).
[[nodiscard]] glm::vec3 rainbow(double turn);

/// A view that does not follow the bounding sphere, with its planes at the given distances.
[[nodiscard]] View viewFrom(glm::dvec3 eye, glm::dvec3 target, double near, double far);

/// A view that frames the bounding sphere from the side and above, in degrees.
[[nodiscard]] View fitFrom(double yaw, double pitch);

/// A scene of clip-space triangles: no light, nothing culled, black background.
[[nodiscard]] Scene clipScene(QSize size);

/// A scene in object space, 1280 x 960.
[[nodiscard]] Scene objectScene(bool lit);

/// Gives the scene one material that shows the texture, and texture shading.
void setTexture(Scene& scene, Texture texture);

constexpr glm::vec3 kRed{1, 0, 0};
constexpr glm::vec3 kGreen{0, 1, 0};
constexpr glm::vec3 kBlue{0, 0, 1};
constexpr glm::vec3 kYellow{1, 1, 0};
constexpr glm::vec3 kWhite{1, 1, 1};
constexpr double kPi = 3.14159265358979323846;

} // namespace rasterlens
