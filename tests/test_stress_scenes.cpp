// The stress scenes are those of the peer harness, bit for bit.
#include "core/scenes/builtin_scenes.h"
#include "scene_files.h"

#include <QTest>

#ifdef RASTERLENS_PEER_SCENES
#include "peers/scene.hpp"
#endif

using namespace rasterlens;
using namespace rasterlens::test;

class TestStressScenes : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void sceneOfEveryName_data();
    void sceneOfEveryName();
    void fillQuadsCoverTheViewport();
    void badNamesAndSizes();
    void areThePeersBitForBit();
};

void TestStressScenes::sceneOfEveryName_data()
{
    QTest::addColumn<int>("faces");
    QTest::newRow("tiny") << 1'000'000;
    QTest::newRow("medium") << 100'000;
    QTest::newRow("large") << 2'000;
    QTest::newRow("fill-front-to-back") << 20;
    QTest::newRow("fill-back-to-front") << 20;
}

void TestStressScenes::sceneOfEveryName()
{
    QFETCH(int, faces);
    const QString name = QString::fromLatin1(QTest::currentDataTag());
    const SceneLoad load = makeStressScene(name, {1920, 1080});
    QVERIFY(load.scene && load.diagnostics.empty());
    QCOMPARE(load.scene->mesh.faceCount(), static_cast<std::size_t>(faces));
    QCOMPARE(load.scene->id, QStringLiteral("stress:") + name);
    QVERIFY(!load.scene->title.isEmpty());
    QVERIFY(load.scene->space == SceneSpace::Clip && !load.scene->lit);
    QVERIFY(load.scene->background == glm::vec3(0.1F));
    QCOMPARE(load.scene->defaults.size, QSize(1920, 1080));
    QCOMPARE(load.scene->materials.size(), std::size_t{1});
    const Mesh& mesh = load.scene->mesh;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::dvec2 a(mesh.vertices[mesh.indices[i]].position);
        const glm::dvec2 b(mesh.vertices[mesh.indices[i + 1]].position);
        const glm::dvec2 c(mesh.vertices[mesh.indices[i + 2]].position);
        // Snapping to 1/256 pixel may flatten a triangle, but not turn it over.
        QVERIFY((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) > -1e-9);
    }
}

void TestStressScenes::fillQuadsCoverTheViewport()
{
    const Mesh front = makeStressScene(QStringLiteral("fill-front-to-back"), {100, 50}).scene->mesh;
    const Mesh back = makeStressScene(QStringLiteral("fill-back-to-front"), {100, 50}).scene->mesh;
    QVERIFY(front.vertices[0].position == glm::vec4(-1, -1, -0.9F, 1));
    QVERIFY(front.vertices[2].uv == glm::vec2(100.0F / 512, 50.0F / 512));
    QVERIFY(front.vertices[3].color == glm::vec3(1) && front.vertices[7].color == glm::vec3(0.95F));
    QVERIFY(back.vertices[36].position == front.vertices[0].position);
}

void TestStressScenes::badNamesAndSizes()
{
    const SceneLoad load = makeStressScene(QStringLiteral("huge"), {64, 64});
    QVERIFY(!load.scene);
    verifyRemark(load.diagnostics, QStringLiteral("stress:huge: "),
                 QStringLiteral("tiny, medium, large, fill-front-to-back, fill-back-to-front"));
    for (const QSize size : {QSize(0, 5), QSize(5, -1), QSize(16385, 1), QSize()})
        QVERIFY(!makeStressScene(QStringLiteral("large"), size).scene);
}

void TestStressScenes::areThePeersBitForBit()
{
#ifdef RASTERLENS_PEER_SCENES
    const std::pair<const char*, const char*> names[] = {{"tiny", "tiny"},
                                                         {"medium", "medium"},
                                                         {"large", "large"},
                                                         {"fill-front-to-back", "fill_f2b"},
                                                         {"fill-back-to-front", "fill_b2f"}};
    for (const QSize size : {QSize(1920, 1080), QSize(333, 217)})
        for (const auto& [ours, theirs] : names) {
            ps::Mesh peer;
            ps::Sphere sphere;
            QVERIFY(ps::make_scene(theirs, size.width(), size.height(), peer, sphere));
            const Mesh mesh = makeStressScene(QString::fromLatin1(ours), size).scene->mesh;
            QCOMPARE(mesh.indices, peer.idx);
            QCOMPARE(mesh.vertices.size(), peer.v.size());
            for (std::size_t i = 0; i < peer.v.size(); ++i) {
                QVERIFY(std::memcmp(&mesh.vertices[i].position, peer.v[i].p, sizeof peer.v[i].p) == 0);
                QVERIFY(std::memcmp(&mesh.vertices[i].color, peer.v[i].n, sizeof peer.v[i].n) == 0);
                QVERIFY(std::memcmp(&mesh.vertices[i].uv, peer.v[i].uv, sizeof peer.v[i].uv) == 0);
            }
        }
    const std::vector<std::uint32_t> checker = ps::checker();
    for (std::size_t i = 0; i < checker.size(); ++i) {
        const std::uint32_t texel = checkerTexture().texels[i];
        QCOMPARE(((texel & 255U) << 16) | (texel & 0xff00ff00U) | ((texel >> 16) & 255U), checker[i]);
    }
#else
    QSKIP("the peer harness (" RASTERLENS_SHARED "/peers/scene.hpp) is not there");
#endif
}

QTEST_APPLESS_MAIN(TestStressScenes)
#include "test_stress_scenes.moc"
