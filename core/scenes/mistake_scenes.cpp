#include "core/scenes/makers.h"
#include "core/scenes/shapes.h"

#include <cmath>

namespace rasterlens
{
namespace
{

/// Appends a rectangle of the screen, in pixels, cut from its lower left corner to its upper right one.
void addRectangle(Scene& scene, glm::dvec2 topLeft, glm::dvec2 bottomRight, glm::vec3 color, bool clockwise = false)
{
    const QSize size = scene.defaults.size;
    const MeshVertex a = cornerAtPixel(topLeft, size, color);
    const MeshVertex b = cornerAtPixel({topLeft.x, bottomRight.y}, size, color);
    const MeshVertex c = cornerAtPixel(bottomRight, size, color);
    const MeshVertex d = cornerAtPixel({bottomRight.x, topLeft.y}, size, color);
    addClipTriangle(scene.mesh, a, clockwise ? d : b, clockwise ? b : d);
    addClipTriangle(scene.mesh, d, clockwise ? c : b, clockwise ? b : c);
}

/// Moves the vertices appended since `first` to a depth of 0..1.
void setDepth(Mesh& mesh, std::size_t first, float depth)
{
    for (std::size_t i = first; i < mesh.vertices.size(); ++i)
        mesh.vertices[i].position.z = (2 * depth - 1) * mesh.vertices[i].position.w;
}

} // namespace

Scene makeSquareCounted()
{
    Scene scene = makeSquareDiagonal();
    scene.defaults.shading = Shading::Overdraw;
    return scene;
}

Scene makeThinGap()
{
    Scene scene = makeZFighting();
    scene.defaults.view.near = 0.5;
    return scene;
}

Scene makeThreeLayers()
{
    Scene scene = clipScene(QSize(160, 120));
    const auto addLayer = [&](glm::dvec2 topLeft, glm::vec3 color, float depth) {
        const std::size_t first = scene.mesh.vertices.size();
        addRectangle(scene, topLeft, topLeft + glm::dvec2(80, 60), color);
        setDepth(scene.mesh, first, depth);
    };
    addLayer({16, 12}, {0.95F, 0.55F, 0.15F}, 0.25F);
    addLayer({64, 48}, {0.20F, 0.45F, 0.80F}, 0.75F);
    addLayer({40, 30}, {0.35F, 0.70F, 0.40F}, 0.5F);
    return scene;
}

Scene makeTwoWindings()
{
    Scene scene = clipScene(QSize(20, 12));
    scene.defaults.shading = Shading::Overdraw;
    addRectangle(scene, {1, 2}, {9, 10}, {0.90F, 0.55F, 0.20F});
    addRectangle(scene, {11, 2}, {19, 10}, {0.30F, 0.60F, 0.90F}, true);
    return scene;
}

Scene makeLineTies()
{
    Scene scene = clipScene(QSize(64, 40));
    // From pixel centre to pixel centre; the diagonals pass half-way between two pixels again and again.
    addRectangle(scene, {2.5, 2.5}, {34.5, 18.5}, {0.95F, 0.60F, 0.20F});
    addRectangle(scene, {38.5, 2.5}, {54.5, 34.5}, {0.35F, 0.75F, 0.95F});
    addRectangle(scene, {2.5, 24.5}, {34.5, 32.5}, {0.60F, 0.85F, 0.40F});
    scene.defaults.fill = Fill::Wireframe;
    scene.defaults.lineTies = LineTies::Canonical;
    scene.defaults.sharedEdges = SharedEdges::EachFace; // a line from A to B over the one from B to A
    return scene;
}

Scene makeTinyTiles()
{
    constexpr int kSide = 64;
    Scene scene = clipScene(QSize(kSide, kSide));
    // Columns from half a pixel on the left to ten pixels on the right.
    double left = 2;
    int number = 0;
    for (double width = 0.5; left + width <= kSide - 2; left += width, width *= 1.09)
        for (double top = 2; top + width <= kSide - 2; top += width)
            addRectangle(scene, {left, top}, {left + width, top + width}, rainbow(0.381966 * ++number));
    return scene;
}

Scene makeSamples()
{
    const QSize size(96, 64);
    Scene scene = clipScene(size);
    scene.background = {0.15F, 0.25F, 0.45F};
    scene.defaults.samples = Samples::Grid2;
    // The near triangle is sent first.
    const glm::vec3 orange{0.95F, 0.55F, 0.15F};
    addClipTriangle(scene.mesh, cornerAtPixel({20.3, 51.2}, size, orange), cornerAtPixel({70.6, 40.7}, size, orange),
                    cornerAtPixel({41.8, 12.4}, size, orange));
    setDepth(scene.mesh, 0, 0.25F);
    const std::size_t first = scene.mesh.vertices.size();
    addRectangle(scene, {8.3, 6.7}, {87.4, 57.2}, {0.92F, 0.92F, 0.88F});
    setDepth(scene.mesh, first, 0.75F);
    return scene;
}

Scene makeZeroArea()
{
    const QSize size(24, 24);
    Scene scene = clipScene(size);
    addRectangle(scene, {2, 2}, {22, 22}, {0.90F, 0.80F, 0.35F});
    const auto addFlattened = [&](glm::dvec2 from, glm::dvec2 to) {
        const std::size_t first = scene.mesh.vertices.size();
        addClipTriangle(scene.mesh, cornerAtPixel(from, size, kRed), cornerAtPixel((from + to) / 2.0, size, kRed),
                        cornerAtPixel(to, size, kRed));
        setDepth(scene.mesh, first, 0.25F);
    };
    addFlattened({4.5, 6.5}, {18.5, 6.5});
    addFlattened({6.5, 8.5}, {18.5, 20.5});
    addFlattened({4.5, 10.5}, {4.5, 20.5});
    return scene;
}

Scene makeLongSliver()
{
    const QSize size(4096, 64);
    Scene scene = clipScene(size);
    // Two needles that share their long edge, across which both are as thin as a pixel.
    const MeshVertex left = cornerAtPixel({8.3, 13.4}, size, kYellow);
    const MeshVertex right = cornerAtPixel({4088.6, 50.2}, size, kYellow);
    addClipTriangle(scene.mesh, left, right, cornerAtPixel({2000.1, 24.7}, size, {0.95F, 0.50F, 0.20F}));
    addClipTriangle(scene.mesh, right, left, cornerAtPixel({2100.7, 38.9}, size, {0.30F, 0.60F, 0.95F}));
    return scene;
}

Scene makeHugeTriangle()
{
    const QSize size(640, 480);
    Scene scene = clipScene(size);
    // 60,000 times 35,791 is 2^31: so far from the right edge is the middle of the screen.
    addClipTriangle(scene.mesh, cornerAtPixel({-20'000, 240}, size, kRed),
                    cornerAtPixel({36'111, 30'240}, size, kGreen), cornerAtPixel({36'111, -29'760}, size, kBlue));
    scene.defaults.clipping = Clipping::None;
    return scene;
}

namespace
{

/// Appends a triangle that points to the right.
void addArrowHead(Scene& scene, double top, double halfHeight)
{
    const QSize size = scene.defaults.size;
    addClipTriangle(scene.mesh, cornerAtPixel({2, top}, size, kYellow),
                    cornerAtPixel({2, top + 2 * halfHeight}, size, kGreen),
                    cornerAtPixel({30, top + halfHeight}, size, kRed));
}

} // namespace

Scene makeFlatEdge()
{
    Scene scene = clipScene(QSize(32, 32));
    addArrowHead(scene, 3, 2);
    addArrowHead(scene, 9, 4);
    addArrowHead(scene, 19, 6);
    return scene;
}

Scene makeBetweenRows()
{
    Scene scene = clipScene(QSize(32, 32));
    addArrowHead(scene, 3.25, 2.25);
    addArrowHead(scene, 9.375, 4.125);
    addArrowHead(scene, 19.625, 5.875);
    return scene;
}

Scene makeCutOnCentres()
{
    const QSize size(64, 64);
    Scene scene = clipScene(size);
    // Both have the edge y = x + 8. It is cut at (0, 8) for the orange triangle; the blue one begins there.
    const glm::vec3 orange{0.95F, 0.55F, 0.15F};
    const glm::vec3 blue{0.20F, 0.45F, 0.80F};
    addClipTriangle(scene.mesh, cornerAtPixel({-16, -8}, size, orange), cornerAtPixel({40, 48}, size, orange),
                    cornerAtPixel({56, 16}, size, orange));
    addClipTriangle(scene.mesh, cornerAtPixel({0, 8}, size, blue), cornerAtPixel({4, 56}, size, blue),
                    cornerAtPixel({40, 48}, size, blue));
    return scene;
}

Scene makeOverhang()
{
    const QSize size(160, 120);
    Scene scene = clipScene(size);
    addClipTriangle(scene.mesh, cornerAtPixel({90, 20}, size, kRed), cornerAtPixel({110, 100}, size, kGreen),
                    cornerAtPixel({230, 50}, size, kBlue));
    scene.defaults.clipping = Clipping::GuardBand;
    return scene;
}

Scene makeSmallScreen()
{
    const QSize size(320, 240);
    Scene scene = clipScene(size);
    addClipTriangle(scene.mesh, cornerAtPixel({4, 6}, size, kRed), cornerAtPixel({20, 234}, size, kGreen),
                    cornerAtPixel({310, 120}, size, kBlue));
    return scene;
}

Scene makePointsOverBorder()
{
    constexpr int kColumns = 14;
    constexpr int kRows = 12;
    const QSize size(12, 10);
    Scene scene = clipScene(size);
    // A point in every pixel and in a row and a column beyond the borders, three a triangle.
    const auto point = [&](int column, int row) {
        return cornerAtPixel({column - 0.5, row - 0.5}, size, rainbow(0.381966 * (column + row)));
    };
    for (int row = 0; row < kRows; row += 3)
        for (int column = 0; column < kColumns; column += 2) {
            addClipTriangle(scene.mesh, point(column, row), point(column, row + 1), point(column + 1, row));
            addClipTriangle(scene.mesh, point(column + 1, row + 1), point(column, row + 2), point(column + 1, row + 2));
        }
    scene.defaults.fill = Fill::Points;
    scene.defaults.shading = Shading::Overdraw;
    scene.defaults.clipping = Clipping::GuardBand;
    return scene;
}

} // namespace rasterlens
