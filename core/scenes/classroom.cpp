#include "core/scenes/makers.h"
#include "core/scenes/shapes.h"

#include <cmath>

namespace rasterlens
{

Scene makeTriangle()
{
    Scene scene = objectScene(false);
    const glm::dvec3 towardsViewer{0, 0, 1};
    addVertex(scene.mesh, {-1, -0.8, 0}, towardsViewer, kRed, {0, 0});
    addVertex(scene.mesh, {1, -0.8, 0}, towardsViewer, kGreen, {1, 0});
    addVertex(scene.mesh, {0, 1, 0}, towardsViewer, kBlue, {0.5, 1});
    addFace(scene.mesh, 0, 1, 2);
    return scene;
}

Scene makeSquareDiagonal()
{
    const QSize size(8, 8);
    Scene scene = clipScene(size);
    const MeshVertex topLeft = cornerAtPixel({0, 0}, size, kYellow);
    const MeshVertex topRight = cornerAtPixel({8, 0}, size, kRed);
    const MeshVertex bottomLeft = cornerAtPixel({0, 8}, size, kGreen);
    const MeshVertex bottomRight = cornerAtPixel({8, 8}, size, kBlue);
    addClipTriangle(scene.mesh, topLeft, bottomLeft, topRight);
    addClipTriangle(scene.mesh, topRight, bottomLeft, bottomRight);
    return scene;
}

Scene makeTriangle600()
{
    const QSize size(600, 600);
    Scene scene = clipScene(size);
    // The source counts y upwards from the bottom.
    const auto corner = [&](double x, double yUp, glm::vec3 color) {
        return cornerAtPixel({x, size.height() - yUp}, size, color, size.width());
    };
    addClipTriangle(scene.mesh, corner(100, 200, kRed), corner(300, 400, kGreen), corner(400, 100, kBlue));
    return scene;
}

namespace
{

const glm::vec3 kLime = glm::vec3(217, 238, 185) / 255.0F;
const glm::vec3 kSky = glm::vec3(185, 217, 238) / 255.0F;
constexpr glm::dvec3 kGames101Eye{0, 0, 5};

Scene games101Frame()
{
    Scene scene = objectScene(false);
    scene.background = {0, 0, 0};
    scene.defaults.size = QSize(700, 700);
    scene.defaults.view = viewFrom(kGames101Eye, {0, 0, 0}, 0.1, 50);
    return scene;
}

} // namespace

Scene makeGames101()
{
    Scene scene = games101Frame();
    addFlatTriangle(scene.mesh, {2, 0, -2}, {0, 2, -2}, {-2, 0, -2}, kLime);
    addFlatTriangle(scene.mesh, {3.5, -1, -5}, {2.5, 1.5, -5}, {-1, 0.5, -5}, kSky);
    return scene;
}

Scene makeGames101Tilted()
{
    // A corner that moves along its ray to the eye by a power of two keeps x / w and y / w bit for bit.
    const auto along = [](double factor, glm::dvec3 corner) { return kGames101Eye + factor * (corner - kGames101Eye); };
    Scene scene = games101Frame();
    addFlatTriangle(scene.mesh, along(0.5, {2, 0, -2}), along(1, {0, 2, -2}), along(2, {-2, 0, -2}), kLime);
    addFlatTriangle(scene.mesh, along(1, {3.5, -1, -5}), along(2, {2.5, 1.5, -5}), along(0.5, {-1, 0.5, -5}), kSky);
    for (const std::size_t last : {2U, 5U}) // a face of one colour looks alike however it is interpolated
        scene.mesh.vertices[last].color *= 0.25F;
    return scene;
}

namespace
{

/// Four by four tiles with a white line across the middle.
Texture tiles()
{
    constexpr int kSide = 64;
    constexpr int kTiles = 4;
    Texture texture = checkerboard(QStringLiteral("tiles"), kSide, kTiles, 0xff2f5fa8, 0xffe8a33d);
    for (const int row : {kSide / 2 - 1, kSide / 2})
        for (int column = 0; column < kSide; ++column)
            texture.texels[static_cast<std::size_t>(row * kSide + column)] = 0xffffffff;
    return texture;
}

} // namespace

Scene makeTileSquare()
{
    Scene scene = objectScene(false);
    addFlatQuad(scene.mesh, {-1, 0, 1}, {1, 0, 1}, {1, 0, -1}, {-1, 0, -1}, kWhite);
    setTexture(scene, tiles());
    scene.defaults.view = viewFrom({0, 0.9, 2.1}, {0, -0.15, 0}, 0.1, 20);
    scene.defaults.culling = Culling::None;
    return scene;
}

Scene makeFan()
{
    constexpr int kBlades = 16;
    constexpr double kRadiusPixels = 30;
    constexpr int kSide = 65;
    const QSize size(kSide, kSide);
    Scene scene = clipScene(size);
    const glm::dvec2 hub{kSide / 2.0, kSide / 2.0};
    const auto rim = [&](int blade) {
        const double angle = 2 * kPi * (blade % kBlades) / kBlades;
        const glm::dvec2 exact = hub + kRadiusPixels * glm::dvec2(std::cos(angle), -std::sin(angle));
        return glm::dvec2(std::round(exact.x * 256) / 256, std::round(exact.y * 256) / 256);
    };
    for (int blade = 0; blade < kBlades; ++blade) {
        const glm::vec3 color = rainbow(static_cast<double>(blade) / kBlades);
        addClipTriangle(scene.mesh, cornerAtPixel(hub, size, color, kSide),
                        cornerAtPixel(rim(blade), size, color, kSide),
                        cornerAtPixel(rim(blade + 1), size, color, kSide));
    }
    return scene;
}

Scene makeLines()
{
    constexpr int kSide = 65;
    const QSize size(kSide, kSide);
    Scene scene = clipScene(size);
    const glm::dvec2 hub{kSide / 2.0, kSide / 2.0};
    // Pixels right and up of the hub: slopes 0, 1/3, 1 and 3 in the first quadrant, turned into the other three.
    std::vector<glm::dvec2> ends{{28, 0}, {27, 9}, {20, 20}, {9, 27}};
    for (std::size_t i = 0; i < 12; ++i)
        ends.push_back({-ends[i].y, ends[i].x});
    for (std::size_t i = 0; i < ends.size(); ++i) {
        const glm::dvec2 flipY{1, -1};
        const glm::dvec2 from = hub + flipY * ends[i];
        const glm::dvec2 to = hub + flipY * ends[(i + 1) % ends.size()];
        const glm::vec3 color = rainbow(static_cast<double>(i) / static_cast<double>(ends.size()));
        addClipTriangle(scene.mesh, cornerAtPixel(hub, size, kWhite, kSide), cornerAtPixel(from, size, color, kSide),
                        cornerAtPixel(to, size, color, kSide));
    }
    scene.defaults.fill = Fill::Wireframe;
    scene.defaults.sharedEdges = SharedEdges::EachFace; // each line from the hub is drawn, and the one back to it
    return scene;
}

} // namespace rasterlens
