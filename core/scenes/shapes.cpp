#include "core/scenes/shapes.h"

#include <algorithm>
#include <cmath>

namespace rasterlens
{

std::uint32_t addVertex(Mesh& mesh, glm::dvec3 position, glm::dvec3 normal, glm::vec3 color, glm::dvec2 uv)
{
    mesh.vertices.push_back(
        {glm::vec4(glm::vec3(position), 1.0F), glm::vec3(glm::normalize(normal)), glm::vec2(uv), color});
    return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
}

void addFace(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c)
{
    const auto at = [&](std::uint32_t index) { return mesh.vertices[index].position; };
    if (at(a) == at(b) || at(b) == at(c) || at(c) == at(a))
        return;
    mesh.indices.insert(mesh.indices.end(), {a, b, c});
}

void addFlatTriangle(Mesh& mesh, glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, glm::vec3 color)
{
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const std::uint32_t first = addVertex(mesh, a, normal, color, {0, 0});
    addVertex(mesh, b, normal, color, {1, 0});
    addVertex(mesh, c, normal, color, {1, 1});
    addFace(mesh, first, first + 1, first + 2);
}

void addFlatQuad(Mesh& mesh, glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, glm::dvec3 d, glm::vec3 color)
{
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const std::uint32_t first = addVertex(mesh, a, normal, color, {0, 0});
    addVertex(mesh, b, normal, color, {1, 0});
    addVertex(mesh, c, normal, color, {1, 1});
    addVertex(mesh, d, normal, color, {0, 1});
    addFace(mesh, first, first + 1, first + 2);
    addFace(mesh, first, first + 2, first + 3);
}

MeshVertex cornerAtPixel(glm::dvec2 screen, QSize size, glm::vec3 color, double w)
{
    const double width = size.width();
    const double height = size.height();
    MeshVertex corner;
    corner.position =
        glm::vec4(glm::dvec4((2 * screen.x - width) * w / width, (height - 2 * screen.y) * w / height, 0, w));
    corner.uv = glm::vec2(screen / glm::dvec2(width, height));
    corner.color = color;
    return corner;
}

void addClipTriangle(Mesh& mesh, const MeshVertex& a, const MeshVertex& b, const MeshVertex& c)
{
    for (const MeshVertex& corner : {a, b, c}) {
        mesh.indices.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
        mesh.vertices.push_back(corner);
    }
}

Texture checkerboard(const QString& name, int side, int cells, std::uint32_t even, std::uint32_t odd)
{
    Texture texture{name, side, side, {}};
    const int cell = side / cells;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            texture.texels.push_back((x / cell + y / cell) % 2 == 0 ? even : odd);
    return texture;
}

glm::vec3 rainbow(double turn)
{
    const auto channel = [&](double peak) {
        const double away = turn - peak;
        const double distance = std::abs(away - std::round(away));
        return static_cast<float>(std::clamp(2.0 - 6.0 * distance, 0.0, 1.0));
    };
    return {channel(0), channel(1.0 / 3), channel(2.0 / 3)};
}

View viewFrom(glm::dvec3 eye, glm::dvec3 target, double near, double far)
{
    View view;
    view.fit = false;
    view.eye = eye;
    view.target = target;
    view.near = near;
    view.far = far;
    return view;
}

View fitFrom(double yaw, double pitch)
{
    View view;
    view.yaw = yaw;
    view.pitch = pitch;
    return view;
}

Scene clipScene(QSize size)
{
    Scene scene;
    scene.space = SceneSpace::Clip;
    scene.lit = false;
    scene.background = {0, 0, 0};
    scene.defaults.size = size;
    scene.defaults.culling = Culling::None;
    return scene;
}

Scene objectScene(bool lit)
{
    Scene scene;
    scene.lit = lit;
    scene.defaults.size = QSize(1280, 960);
    return scene;
}

void setTexture(Scene& scene, Texture texture)
{
    Material material;
    material.name = texture.name;
    material.texture = 0;
    scene.materials = {material};
    scene.textures = {std::move(texture)};
    scene.defaults.shading = Shading::Texture;
}

} // namespace rasterlens
