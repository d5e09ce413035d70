// The built-in scenes: the list, sound meshes, closed and outward solids, and the exact numbers of the classroom texts.
#include "core/scenes/builtin_scenes.h"

#include <QSet>
#include <QTest>

#include <array>
#include <map>

using namespace rasterlens;

namespace
{

using Point = std::array<float, 3>;
using Edge = std::pair<Point, Point>;

Scene make(const char* name)
{
    const SceneLoad load = makeBuiltinScene(QLatin1String(name));
    Q_ASSERT(load.scene);
    return *load.scene;
}

Point cornerOf(const Mesh& mesh, std::size_t i)
{
    const glm::vec4 p = mesh.vertices[mesh.indices[i]].position;
    // The sum makes +0 of -0.
    return {p.x + 0.0F, p.y + 0.0F, p.z + 0.0F};
}

/// How often every directed edge occurs, by position.
std::map<Edge, int> directedEdges(const Mesh& mesh)
{
    std::map<Edge, int> edges;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
        for (std::size_t k = 0; k < 3; ++k)
            ++edges[{cornerOf(mesh, i + k), cornerOf(mesh, i + (k + 1) % 3)}];
    return edges;
}

int repeatedEdges(const std::map<Edge, int>& edges)
{
    int count = 0;
    for (const auto& [edge, uses] : edges)
        count += uses > 1;
    return count;
}

/// The edges whose other side is open, from each point to the next.
std::multimap<Point, Point> openEdges(const std::map<Edge, int>& edges)
{
    std::multimap<Point, Point> open;
    for (const auto& [edge, uses] : edges)
        if (!edges.contains({edge.second, edge.first}))
            open.insert(edge);
    return open;
}

double signedVolume(const Mesh& mesh)
{
    double volume = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto at = [&](std::size_t k) { return glm::dvec3(mesh.vertices[mesh.indices[i + k]].position); };
        volume += glm::dot(at(0), glm::cross(at(1), at(2))) / 6;
    }
    return volume;
}

/// Faces whose winding contradicts the normals of their corners.
int facesAgainstNormals(const Mesh& mesh)
{
    int count = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto at = [&](std::size_t k) { return mesh.vertices[mesh.indices[i + k]]; };
        const glm::vec3 a(at(0).position);
        const glm::vec3 normal = glm::cross(glm::vec3(at(1).position) - a, glm::vec3(at(2).position) - a);
        count += glm::dot(normal, at(0).normal + at(1).normal + at(2).normal) <= 0;
    }
    return count;
}

bool sameVertex(const MeshVertex& a, const MeshVertex& b)
{
    return a.position == b.position && a.normal == b.normal && a.uv == b.uv && a.color == b.color;
}

glm::dvec2 screenOf(const MeshVertex& vertex, QSize size)
{
    const glm::dvec4 p(vertex.position);
    return {(p.x / p.w * 0.5 + 0.5) * size.width(), (0.5 - p.y / p.w * 0.5) * size.height()};
}

void eachScene()
{
    QTest::addColumn<QString>("name");
    for (const BuiltinScene& entry : builtinScenes())
        QTest::newRow(entry.name) << QString::fromLatin1(entry.name);
}

} // namespace

class TestBuiltinScenes : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void listIsStable();
    void unknownNameListsTheNames();
    void everySceneIsSound_data() { eachScene(); }
    void everySceneIsSound();
    void everySceneIsDeterministic_data() { eachScene(); }
    void everySceneIsDeterministic();
    void solidsAreClosedAndFaceOutwards_data();
    void solidsAreClosedAndFaceOutwards();
    void surfacesAreWoundAsTheirNormals_data();
    void surfacesAreWoundAsTheirNormals();
    void teapotIsOpenAtItsSixRimsOnly();
    void handleAndSpoutFaceOutwards();
    void squareDiagonalIsExact();
    void triangle600IsExact();
    void games101IsExact();
    void fanMeetsAtAPixelCentre();
    void linesEndAtPixelCentres();
    void fourZReachesTheKnownDepths();
    void coveringHasNoCornerInside();
    void tunnelAndFloorCrossTheEyePlane();
};

void TestBuiltinScenes::listIsStable()
{
    const QString expected =
        QStringLiteral("triangle square-diagonal triangle-600 games101 games101-tilted tile-square head teapot "
                       "torus-knot floor letter-f leaf fan tunnel cube sphere painter-cycle piercing z-fighting "
                       "slivers behind-camera covering edge-guardband lines four-z decal wire-over-fill equal-pass "
                       "beam-to-eye lockstep cut-outs square-counted thin-gap three-layers two-windings line-ties "
                       "tiny-tiles samples msaa-sprite msaa-gradient msaa-seams zero-area long-sliver huge-triangle "
                       "overhang flat-edge cut-on-centres between-rows small-screen points-over-border signpost "
                       "road squashed-ball picture-card texels-about-zero disc-floor coarse-ball");
    QStringList names;
    for (const BuiltinScene& entry : builtinScenes())
        names << entry.name;
    QCOMPARE(names, expected.split(QLatin1Char(' ')));
    QCOMPARE(QSet<QString>(names.begin(), names.end()).size(), names.size());
}

void TestBuiltinScenes::unknownNameListsTheNames()
{
    const SceneLoad load = makeBuiltinScene("kettle");
    QVERIFY(!load.scene);
    QCOMPARE(load.diagnostics.size(), std::size_t{1});
    QCOMPARE(load.diagnostics[0].severity, Severity::Error);
    QVERIFY(load.diagnostics[0].file.contains("kettle"));
    for (const BuiltinScene& entry : builtinScenes())
        QVERIFY2(textOf(load.diagnostics[0].message).contains(entry.name), entry.name);
}

void TestBuiltinScenes::everySceneIsSound()
{
    QFETCH(QString, name);
    const SceneLoad load = makeBuiltinScene(name);
    QVERIFY(load.scene);
    QVERIFY(load.diagnostics.empty());
    const Scene& scene = *load.scene;
    QCOMPARE(scene.id, "builtin:" + name);
    QVERIFY(!scene.title.isEmpty());
    QVERIFY(!scene.note.isEmpty());
    QVERIFY(scene.mesh.faceCount() > 0);
    QVERIFY(scene.mesh.faceCount() <= 20'000);
    QCOMPARE(scene.mesh.indices.size() % 3, std::size_t{0});
    for (const std::uint32_t index : scene.mesh.indices)
        QVERIFY(index < scene.mesh.vertices.size());
    for (const MeshVertex& v : scene.mesh.vertices) {
        for (int k = 0; k < 4; ++k)
            QVERIFY(std::isfinite(v.position[k]));
        if (scene.space == SceneSpace::Object)
            QCOMPARE(v.position.w, 1.0F);
        QVERIFY(std::abs(glm::length(v.normal) - 1) < 1e-5F);
        QVERIFY(std::isfinite(v.uv.x) && std::isfinite(v.uv.y));
        for (int k = 0; k < 3; ++k)
            QVERIFY(v.color[k] >= 0 && v.color[k] <= 1);
    }
    QVERIFY(!scene.materials.empty());
    QVERIFY(scene.mesh.faceMaterial.empty() || scene.mesh.faceMaterial.size() == scene.mesh.faceCount());
    for (const std::uint32_t material : scene.mesh.faceMaterial)
        QVERIFY(material < scene.materials.size());
    for (const Material& material : scene.materials)
        QVERIFY(material.texture < static_cast<int>(scene.textures.size()));
    for (const Texture& texture : scene.textures)
        QCOMPARE(texture.texels.size(), static_cast<std::size_t>(texture.width * texture.height));
    QVERIFY(scene.bounds.radius > 0);
}

void TestBuiltinScenes::everySceneIsDeterministic()
{
    QFETCH(QString, name);
    const Scene first = *makeBuiltinScene(name).scene;
    const Scene second = *makeBuiltinScene(name).scene;
    QVERIFY(first.mesh.indices == second.mesh.indices);
    QVERIFY(std::ranges::equal(first.mesh.vertices, second.mesh.vertices, sameVertex));
    QVERIFY(first.defaults == second.defaults);
}

void TestBuiltinScenes::solidsAreClosedAndFaceOutwards_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<double>("smallestVolume");
    QTest::addColumn<double>("largestVolume");
    QTest::newRow("cube") << QStringLiteral("cube") << 8.0 << 8.0;
    QTest::newRow("sphere") << QStringLiteral("sphere") << 4.1 << 4.19;
    QTest::newRow("letter-f") << QStringLiteral("letter-f") << 8.39 << 8.41;
    QTest::newRow("torus-knot") << QStringLiteral("torus-knot") << 14.0 << 18.0;
    QTest::newRow("head") << QStringLiteral("head") << 3.0 << 5.0;
}

void TestBuiltinScenes::solidsAreClosedAndFaceOutwards()
{
    QFETCH(QString, name);
    QFETCH(double, smallestVolume);
    QFETCH(double, largestVolume);
    const Scene scene = *makeBuiltinScene(name).scene;
    const std::map<Edge, int> edges = directedEdges(scene.mesh);
    QCOMPARE(repeatedEdges(edges), 0);
    QCOMPARE(openEdges(edges).size(), std::size_t{0});
    const double volume = signedVolume(scene.mesh);
    QVERIFY2(volume >= smallestVolume && volume <= largestVolume, qPrintable(QString::number(volume)));
}

void TestBuiltinScenes::surfacesAreWoundAsTheirNormals_data()
{
    QTest::addColumn<QString>("name");
    for (const char* name : {"cube", "sphere", "letter-f", "torus-knot", "head", "teapot", "leaf", "floor", "tunnel"})
        QTest::newRow(name) << QString::fromLatin1(name);
}

void TestBuiltinScenes::surfacesAreWoundAsTheirNormals()
{
    QFETCH(QString, name);
    QCOMPARE(facesAgainstNormals(makeBuiltinScene(name).scene->mesh), 0);
}

void TestBuiltinScenes::teapotIsOpenAtItsSixRimsOnly()
{
    const std::map<Edge, int> edges = directedEdges(make("teapot").mesh);
    QCOMPARE(repeatedEdges(edges), 0);
    std::multimap<Point, Point> open = openEdges(edges);
    // Body and lid have rims of 64 edges, both ends of handle and spout have 32.
    std::vector<std::size_t> rims;
    while (!open.empty()) {
        std::size_t length = 0;
        for (auto edge = open.begin(); edge != open.end(); ++length) {
            const Point next = edge->second;
            open.erase(edge);
            edge = open.find(next);
        }
        rims.push_back(length);
    }
    std::ranges::sort(rims);
    QCOMPARE(rims, (std::vector<std::size_t>{32, 32, 32, 32, 64, 64}));
    QVERIFY(signedVolume(make("teapot").mesh) > 0);
}

void TestBuiltinScenes::handleAndSpoutFaceOutwards()
{
    // The outermost points of the pot: the back of the handle on the left, the lip of the spout on the right.
    const Mesh mesh = make("teapot").mesh;
    const auto byX = [](const MeshVertex& a, const MeshVertex& b) { return a.position.x < b.position.x; };
    const auto [handle, spout] = std::ranges::minmax_element(mesh.vertices, byX);
    QVERIFY(handle->normal.x < -0.9F);
    QVERIFY(spout->normal.x > 0.5F);
}

void TestBuiltinScenes::squareDiagonalIsExact()
{
    const Scene scene = make("square-diagonal");
    QCOMPARE(scene.defaults.size, QSize(8, 8));
    QCOMPARE(scene.defaults.culling, Culling::None);
    QVERIFY(scene.space == SceneSpace::Clip);
    const std::vector<glm::vec4> expected{{-1, 1, 0, 1}, {-1, -1, 0, 1}, {1, 1, 0, 1},
                                          {1, 1, 0, 1},  {-1, -1, 0, 1}, {1, -1, 0, 1}};
    QCOMPARE(scene.mesh.indices.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
        QVERIFY(scene.mesh.vertices[scene.mesh.indices[i]].position == expected[i]);
    QVERIFY(scene.mesh.vertices[3].color == glm::vec3(1, 0, 0));
    QVERIFY(scene.mesh.vertices[4].color == glm::vec3(0, 1, 0));
    QVERIFY(scene.mesh.vertices[5].color == glm::vec3(0, 0, 1));
}

void TestBuiltinScenes::triangle600IsExact()
{
    const Scene scene = make("triangle-600");
    QCOMPARE(scene.defaults.size, QSize(600, 600));
    const std::vector<glm::ivec2> yUp{{100, 200}, {300, 400}, {400, 100}};
    QCOMPARE(scene.mesh.indices.size(), yUp.size());
    for (std::size_t i = 0; i < yUp.size(); ++i) {
        // In whole numbers, without rounding: 2 x w = (position + w) 600.
        const glm::vec4 p = scene.mesh.vertices[scene.mesh.indices[i]].position;
        const glm::ivec4 whole(p);
        QVERIFY(glm::vec4(whole) == p);
        QCOMPARE((whole.x + whole.w) * 600, 2 * yUp[i].x * whole.w);
        QCOMPARE((whole.y + whole.w) * 600, 2 * yUp[i].y * whole.w);
        const glm::dvec2 screen = screenOf(scene.mesh.vertices[scene.mesh.indices[i]], scene.defaults.size);
        QCOMPARE(glm::ivec2(glm::round(screen * 256.0)) == glm::ivec2(yUp[i].x, 600 - yUp[i].y) * 256, true);
    }
}

void TestBuiltinScenes::games101IsExact()
{
    const Scene scene = make("games101");
    const std::vector<glm::vec4> expected{{2, 0, -2, 1},    {0, 2, -2, 1},     {-2, 0, -2, 1},
                                          {3.5, -1, -5, 1}, {2.5, 1.5, -5, 1}, {-1, 0.5, -5, 1}};
    QCOMPARE(scene.mesh.indices.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const MeshVertex& vertex = scene.mesh.vertices[scene.mesh.indices[i]];
        QVERIFY(vertex.position == expected[i]);
        const glm::ivec3 bytes(glm::round(vertex.color * 255.0F));
        QVERIFY(bytes == (i < 3 ? glm::ivec3(217, 238, 185) : glm::ivec3(185, 217, 238)));
    }
    const View& view = scene.defaults.view;
    QVERIFY(!view.fit);
    QVERIFY(view.eye == glm::dvec3(0, 0, 5));
    QCOMPARE(view.fov, 45.0);
    QCOMPARE(view.near.value_or(0), 0.1);
    QCOMPARE(view.far.value_or(0), 50.0);
    QCOMPARE(scene.defaults.size, QSize(700, 700));
    QVERIFY(!scene.lit);
}

void TestBuiltinScenes::fanMeetsAtAPixelCentre()
{
    const Scene scene = make("fan");
    QVERIFY(scene.mesh.faceCount() >= 12);
    for (std::size_t i = 0; i < scene.mesh.indices.size(); i += 3) {
        const MeshVertex& hub = scene.mesh.vertices[scene.mesh.indices[i]];
        QVERIFY(screenOf(hub, scene.defaults.size) == glm::dvec2(32.5, 32.5));
        // The blades follow each other round the hub without a gap.
        const std::size_t next = (i + 3) % scene.mesh.indices.size();
        QVERIFY(cornerOf(scene.mesh, i + 2) == cornerOf(scene.mesh, next + 1));
    }
}

void TestBuiltinScenes::linesEndAtPixelCentres()
{
    const Scene scene = make("lines");
    QCOMPARE(scene.defaults.fill, Fill::Wireframe);
    QSet<int> octants;
    for (const MeshVertex& vertex : scene.mesh.vertices) {
        const glm::ivec2 fixed(glm::round(screenOf(vertex, scene.defaults.size) * 256.0));
        QCOMPARE(fixed.x % 256, 128);
        QCOMPARE(fixed.y % 256, 128);
        const glm::ivec2 d = fixed / 256 - glm::ivec2(32);
        if (d.x != 0 && d.y != 0 && std::abs(d.x) != std::abs(d.y))
            octants.insert((d.x > 0) * 4 + (d.y > 0) * 2 + (std::abs(d.x) > std::abs(d.y)));
    }
    QCOMPARE(octants.size(), 8);
}

void TestBuiltinScenes::fourZReachesTheKnownDepths()
{
    const Scene scene = make("four-z");
    const View& view = scene.defaults.view;
    const double n = view.near.value_or(0);
    const double f = view.far.value_or(0);
    const auto ndcZ = [&](double distance) { return (f + n) / (f - n) - 2 * f * n / ((f - n) * distance); };
    const double left = -scene.mesh.vertices[0].position.z;
    const double right = -scene.mesh.vertices[1].position.z;
    QCOMPARE(left, 1.0);
    QCOMPARE(right, 10.0);
    QCOMPARE(std::round(1e4 * (ndcZ(left) + ndcZ(right)) / 2), 8938.0);
    // The middle of the edge on the screen is the middle of the screen.
    const auto tangent = [&](std::size_t i) {
        return static_cast<double>(scene.mesh.vertices[i].position.x) /
               -static_cast<double>(scene.mesh.vertices[i].position.z);
    };
    QVERIFY(std::abs(tangent(0) + tangent(1)) < 1e-6);
}

void TestBuiltinScenes::coveringHasNoCornerInside()
{
    const Scene scene = make("covering");
    const double halfHeight = std::tan(glm::radians(scene.defaults.view.fov / 2));
    const double halfWidth = halfHeight * scene.defaults.size.width() / scene.defaults.size.height();
    std::array<glm::dvec2, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 p(scene.mesh.vertices[scene.mesh.indices[i]].position);
        corners[i] = glm::dvec2(p.x / halfWidth, p.y / halfHeight) / -p.z;
        QVERIFY(std::abs(corners[i].x) > 1 || std::abs(corners[i].y) > 1);
    }
    for (const glm::dvec2 screenCorner : {glm::dvec2(-1, -1), {1, -1}, {1, 1}, {-1, 1}})
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec2 edge = corners[(i + 1) % 3] - corners[i];
            const glm::dvec2 toScreen = screenCorner - corners[i];
            QVERIFY(edge.x * toScreen.y - edge.y * toScreen.x > 0);
        }
}

void TestBuiltinScenes::tunnelAndFloorCrossTheEyePlane()
{
    for (const char* name : {"tunnel", "floor", "behind-camera"}) {
        const Scene scene = make(name);
        const glm::dvec3 gaze = glm::normalize(scene.defaults.view.target - scene.defaults.view.eye);
        const auto w = [&](std::size_t i) {
            const glm::dvec3 p(scene.mesh.vertices[scene.mesh.indices[i]].position);
            return glm::dot(p - scene.defaults.view.eye, gaze);
        };
        int crossing = 0;
        for (std::size_t i = 0; i < scene.mesh.indices.size(); i += 3) {
            const auto [low, high] = std::minmax({w(i), w(i + 1), w(i + 2)});
            crossing += low < 0 && high > 0;
        }
        QVERIFY2(crossing > 0, name);
    }
}

QTEST_GUILESS_MAIN(TestBuiltinScenes)
#include "test_builtin_scenes.moc"
