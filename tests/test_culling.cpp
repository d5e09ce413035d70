// Culling: three spaces that agree, faces through w = 0, the winding, closed convex meshes, and the conservation laws.
#include "core/pipeline/culling.h"
#include "tests/support.h"

#include <QTest>
#include <boost/multiprecision/cpp_int.hpp>

using namespace rasterlens;
using namespace rasterlens::test;
using Rational = boost::multiprecision::cpp_rational;

namespace
{

bool isCulled(FaceFate fate) { return fate == FaceFate::CulledBack || fate == FaceFate::CulledFront; }

/// The sign of det[x y w], exactly.
int exactFacing(const Scene& scene, std::size_t face)
{
    std::array<std::array<Rational, 3>, 3> m;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::vec4& p = scene.mesh.vertices[scene.mesh.indices[3 * face + i]].position;
        m[i] = {Rational(p.x), Rational(p.y), Rational(p.w)};
    }
    const Rational det = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                         m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
    return det > 0 ? 1 : det < 0 ? -1 : 0;
}

double screenArea(const Processed& processed)
{
    double area = 0;
    for (const ScreenTriangle& t : processed.triangles)
        area += twiceArea(t.vertices[0].position, t.vertices[1].position, t.vertices[2].position) / 2;
    return area;
}

} // namespace

class TestCulling : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void signsDecide();
    void threeSpacesAgree();
    void facesThroughTheEyePlaneAreJudgedRight();
    void windingTurnsFrontAndBackRound();
    void closedConvexMeshes();
    void countersAreConserved_data();
    void countersAreConserved();
};

void TestCulling::signsDecide()
{
    Rules rules;
    QCOMPARE(cull(1, rules), FaceFate::Rasterized);
    QCOMPARE(cull(-1, rules), FaceFate::CulledBack);
    QCOMPARE(cull(0, rules), FaceFate::Degenerate);
    rules.culling = Culling::Front;
    QCOMPARE(cull(1, rules), FaceFate::CulledFront);
    QCOMPARE(cull(-1, rules), FaceFate::Rasterized);
    rules.frontSign = -1;
    QCOMPARE(cull(-1, rules), FaceFate::CulledFront);
    rules.culling = Culling::None;
    QCOMPARE(cull(-1, rules), FaceFate::Rasterized);
    // Counter-clockwise with y up is positive in all three.
    const auto at = [](double x, double y) { return ScreenVertex{{x, y}, 0, 1, {}}; };
    const std::array<ScreenVertex, 3> screen{at(0, 10), at(10, 10), at(0, 0)};
    QCOMPARE(twicePolygonArea(screen), 100.0);
    ClipTriangle clip{};
    clip.vertices[0].positionClip = {0, 0, 0, 1};
    clip.vertices[1].positionClip = {1, 0, 0, 1};
    clip.vertices[2].positionClip = {0, 1, 0, 1};
    QCOMPARE(clipDeterminant(clip), 1.0);
    const Scene scene = soup({{0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}});
    QCOMPARE(viewFacing(scene.mesh, 0, {0, 0, 3}), 3.0);
    QCOMPARE(viewFacing(scene.mesh, 0, {0, 0, -3}), -3.0);
}

void TestCulling::threeSpacesAgree()
{
    Random random = seededRandom();
    std::vector<glm::vec4> positions;
    for (int i = 0; i < 3 * 3000; ++i)
        positions.emplace_back(uniform(random, -3, 3), uniform(random, -3, 3), uniform(random, -3, 3), 1);
    Scene scene = soup(positions);
    scene.space = SceneSpace::Object;
    scene.bounds = boundingSphere(scene.mesh);
    Settings settings = plainSettings({512, 512});
    settings.culling = Culling::Back;
    settings.view.yaw = 20;
    settings.view.pitch = 35;
    std::array<std::vector<FaceFate>, 3> fates;
    for (const CullSpace space : {CullSpace::Screen, CullSpace::Clip, CullSpace::View}) {
        settings.cullSpace = space;
        fates[static_cast<std::size_t>(space)] = process(scene, settings).fates;
    }
    settings.culling = Culling::None;
    int culled = 0;
    int edgeOn = 0;
    for (std::size_t face = 0; face < scene.mesh.faceCount(); ++face) {
        culled += isCulled(fates[0][face]);
        if (fates[0][face] == fates[1][face] && fates[0][face] == fates[2][face])
            continue;
        // Only faces thinner than snapping can tell may be judged differently.
        Scene one = scene;
        one.mesh.indices = {scene.mesh.indices[3 * face], scene.mesh.indices[3 * face + 1],
                            scene.mesh.indices[3 * face + 2]};
        QVERIFY(std::abs(screenArea(process(one, settings))) < 2);
        ++edgeOn;
    }
    QVERIFY(culled > 1000 && culled < 2000);
    QVERIFY(edgeOn < 20);
}

void TestCulling::facesThroughTheEyePlaneAreJudgedRight()
{
    Random random = seededRandom();
    std::vector<glm::vec4> positions;
    for (int i = 0; i < 3 * 10000; ++i)
        positions.emplace_back(uniform(random, -3, 3), uniform(random, -3, 3), uniform(random, -2, 2),
                               uniform(random, -1.5, 2));
    const Scene scene = soup(positions);
    Settings settings = plainSettings({256, 256});
    settings.culling = Culling::Back;
    int crossing = 0;
    for (const CullSpace space : {CullSpace::Screen, CullSpace::Clip}) {
        settings.cullSpace = space;
        const Processed processed = process(scene, settings);
        for (std::size_t face = 0; face < scene.mesh.faceCount(); ++face) {
            const FaceFate fate = processed.fates[face];
            if (fate != FaceFate::CulledBack && fate != FaceFate::Rasterized)
                continue;
            const auto w = [&](std::size_t i) { return positions[3 * face + i].w; };
            crossing += std::min({w(0), w(1), w(2)}) < 0;
            const bool front = exactFacing(scene, face) > 0;
            if ((fate == FaceFate::Rasterized) == front)
                continue;
            Scene one = scene;
            one.mesh.indices = {std::uint32_t(3 * face), std::uint32_t(3 * face + 1), std::uint32_t(3 * face + 2)};
            Settings all = settings;
            all.culling = Culling::None;
            QVERIFY2(space == CullSpace::Screen && std::abs(screenArea(process(one, all))) < 2, "judged wrongly");
        }
    }
    QVERIFY(crossing > 1000);
}

void TestCulling::windingTurnsFrontAndBackRound()
{
    const Scene scene = *makeBuiltinScene(QStringLiteral("torus-knot")).scene;
    Settings settings = scene.defaults;
    settings.size = {160, 120};
    for (const CullSpace space : {CullSpace::Screen, CullSpace::Clip, CullSpace::View}) {
        settings.cullSpace = space;
        settings.culling = Culling::Back;
        settings.winding = Winding::CounterClockwise;
        const Frame right = draw(scene, settings);
        settings.winding = Winding::Clockwise;
        const Frame insideOut = draw(scene, settings);
        QVERIFY(!difference(right, insideOut).isEmpty());
        settings.culling = Culling::Front;
        QCOMPARE(difference(right, draw(scene, settings)), QString());
        settings.winding = Winding::CounterClockwise;
        QCOMPARE(difference(insideOut, draw(scene, settings)), QString());
    }
}

void TestCulling::closedConvexMeshes()
{
    for (const char* name : {"cube", "sphere"}) {
        const Scene scene = *makeBuiltinScene(QLatin1String(name)).scene;
        Settings settings = scene.defaults;
        settings.size = {320, 240};
        Frame frame;
        settings.culling = Culling::Back;
        const Statistics back = renderCounted(scene, settings, frame, kAllOutputs);
        const Statistics::Faces f = back.faces;
        QCOMPARE(f.culledBack + f.rasterized + f.degenerate, f.submitted);
        QVERIFY(f.culledBack > 0 && f.rasterized > 0);
        // A convex body covers each pixel of its outline once from the front, once from the back.
        QVERIFY(std::ranges::all_of(frame.coverage, [](std::uint16_t n) { return n <= 1; }));
        const std::vector<std::uint16_t> front = frame.coverage;
        settings.culling = Culling::Front;
        const Statistics other = renderCounted(scene, settings, frame, kAllOutputs);
        QCOMPARE(other.faces.culledFront, f.rasterized);
        QCOMPARE(other.faces.rasterized, f.culledBack);
        QVERIFY(frame.coverage == front);
    }
}

void TestCulling::countersAreConserved_data()
{
    QTest::addColumn<QString>("name");
    for (const BuiltinScene& scene : builtinScenes())
        QTest::newRow(scene.name) << QString::fromLatin1(scene.name);
}

void TestCulling::countersAreConserved()
{
    QFETCH(QString, name);
    const Scene scene = *makeBuiltinScene(name).scene;
    int run = 0;
    for (const char* varied : {"clipping", "culling", "cull-space", "depth-test", "fill", "number-type", "algorithm"}) {
        const SettingsField* field = findSettingsField(QLatin1String(varied));
        for (int value = field->minimum; value <= field->maximum; ++value) {
            Settings settings = scene.defaults;
            settings.size = {64, 48};
            field->set(settings, value);
            if (unsupported(scene, settings))
                continue;
            Frame frame;
            const Statistics s = renderCounted(scene, settings, frame);
            const Statistics::Faces& f = s.faces;
            const Statistics::Pixels& p = s.pixels;
            QCOMPARE(f.submitted, std::uint64_t(scene.mesh.faceCount()));
            QCOMPARE(f.submitted,
                     f.rejected + f.culledBack + f.culledFront + f.degenerate + f.nonFinite + f.rasterized);
            QVERIFY(f.clipped <= f.submitted - f.rejected);
            QVERIFY((f.createdByClipping > 0) <= (f.clipped > 0));
            QCOMPARE(p.covered, p.depthPassed + p.depthFailed);
            const bool oncePerSample = settings.algorithm == Algorithm::Tiled; // what is hidden later is not shaded
            QVERIFY(oncePerSample ? p.written <= p.depthPassed : p.written == p.depthPassed);
            // Multi-sampling shades a face once a pixel and writes to the samples that it covers.
            const bool sharesShading = patternSamples(settings.samples) > 1;
            QVERIFY(sharesShading ? p.shaded <= p.written : p.shaded == p.written);
            QVERIFY(p.tested >= p.covered);
            // Clipping none and its like may fold a face over its neighbour; then an edge has both on one side.
            if (settings.algorithm != Algorithm::ColumnFill) // has no rule for ties
                QCOMPARE(p.coveredTwice, std::uint64_t(0));
            ++run;
        }
    }
    QVERIFY(run >= 20);
}

QTEST_APPLESS_MAIN(TestCulling)
#include "test_culling.moc"
