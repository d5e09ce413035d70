// Orthographic projection: its matrix by exact numbers, sizes, zoom, painter, the exact reference, and what is said.
#include "core/pipeline/vertex_stage.h"
#include "core/questions/unchanged.h"
#include "core/questions/vertex_table.h"
#include "core/scene/camera.h"
#include "core/truth/exact_reference.h"
#include "tests/derivation_fixture.h"
#include "tests/support.h"

#include <QTest>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

Settings parallel(QSize size = {64, 64})
{
    Settings settings = plainSettings(size);
    settings.projection = Projection::Orthographic;
    return settings;
}

/// The eye at (0, 0, 4), looking at 0; half the angle is 45 degrees.
Settings fromFour()
{
    Settings settings = parallel();
    settings.view.fit = false;
    settings.view.eye = {0, 0, 4};
    settings.view.fov = 90;
    return settings;
}

Scene ball(const glm::dvec3& center, double radius)
{
    Scene scene;
    scene.bounds = {center, radius};
    return scene;
}

glm::dvec4 clip(const Matrices& m, const glm::dvec3& world) { return m.clipFromObjectDouble * glm::dvec4(world, 1); }

/// Two squares, the far one first and the near one of half its size before it, seen along -z.
Scene squares()
{
    std::vector<glm::vec4> corners;
    for (const float half : {1.0F, 0.5F}) {
        const float z = half == 1 ? -1.0F : 1.0F;
        for (const auto& [x, y] : {std::pair(-1, -1), std::pair(1, -1), std::pair(1, 1), std::pair(-1, -1),
                                   std::pair(1, 1), std::pair(-1, 1)})
            corners.emplace_back(float(x) * half, float(y) * half, z, 1);
    }
    Scene scene = soup(corners);
    scene.space = SceneSpace::Object;
    return scene;
}

} // namespace

class TestOrthographic : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void depthByExactNumbers();
    void wIsOneEverywhere();
    void targetKeepsItsSize();
    void depthChangesNoSize();
    void parallelsStayParallel();
    void zoomScalesTheHeight();
    void farFromTheOrigin();
    void picturesOfAllDepthRanges();
    void painterGoesByDepth();
    void facingGoesByTheGaze();
    void exactReferenceAgrees();
    void whatChangesNothing();
    void derivations();
};

/// near 0.5 and far 2.5, all numbers exact in binary: z' = -z - 1.5 (OpenGL) and (z + 0.5) / -2 (Direct3D) of the z of
/// view space.
void TestOrthographic::depthByExactNumbers()
{
    struct Row {
        ClipZ clipZ;
        bool reversed;
        double atNear, half, atFar;
    };
    for (const Row& row : {Row{ClipZ::Gl, false, -1, 0, 1}, Row{ClipZ::Gl, true, 1, 0, -1},
                           Row{ClipZ::D3d, false, 0, 0.5, 1}, Row{ClipZ::D3d, true, 1, 0.5, 0}}) {
        Settings settings = fromFour();
        settings.clipZ = row.clipZ;
        settings.reversedZ = row.reversed;
        settings.view.near = 0.5;
        settings.view.far = 2.5;
        const Matrices m = cameraMatrices(ball({0, 0, 0}, 1), settings);
        QVERIFY(m.orthographic);
        QCOMPARE(m.near, 0.5);
        QCOMPARE(m.far, 2.5);
        QCOMPARE(clip(m, {0, 0, 3.5}).z, row.atNear);
        QCOMPARE(clip(m, {0.25, -3, 2.5}).z, row.half); // half-way is half-way
        QCOMPARE(clip(m, {0, 0, 1.5}).z, row.atFar);
    }
}

void TestOrthographic::wIsOneEverywhere()
{
    Random random = seededRandom();
    for (int i = 0; i < 200; ++i) {
        Settings settings = parallel({integer(random, 1, 400), integer(random, 1, 400)});
        settings.view.yaw = uniform(random, -180, 180);
        settings.view.pitch = uniform(random, -90, 90);
        settings.clipZ = i % 2 == 0 ? ClipZ::Gl : ClipZ::D3d;
        settings.reversedZ = i % 3 == 0;
        const Matrices m = cameraMatrices(ball({1, 2, 3}, std::exp2(uniform(random, -10, 10))), settings);
        for (int column = 0; column < 4; ++column)
            QCOMPARE(m.clipFromObject[column][3], column == 3 ? 1.0F : 0.0F);
        QCOMPARE(clip(m, {uniform(random, -9, 9), uniform(random, -9, 9), uniform(random, -9, 9)}).w, 1.0);
    }
    for (const Scene& scene : {builtin("cube"), builtin("tunnel")}) {
        const Resolved resolved = resolve(parallel(), scene);
        for (std::size_t i = 0; i < scene.mesh.vertices.size(); ++i)
            QCOMPARE(shadeVertexAt(scene, resolved.matrices, resolved.rules, i).positionClip.w, 1.0);
    }
}

/// At distance 4 and 45 degrees the upper border of the picture is at height 4.
void TestOrthographic::targetKeepsItsSize()
{
    Settings settings = fromFour();
    const Scene scene = ball({0, 0, 0}, 1);
    for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
        settings.projection = projection;
        const glm::dvec4 top = clip(cameraMatrices(scene, settings), {-1, 4, 0});
        QVERIFY(std::abs(top.y / top.w - 1) < 1e-12);
        QVERIFY(std::abs(top.x / top.w + 0.25) < 1e-12);
    }
    // In the view fit the target is the centre of the sphere; near and far are those of perspective.
    Settings fit = parallel({200, 100});
    const Matrices m = cameraMatrices(ball({1, 2, 3}, 2), fit);
    fit.projection = Projection::Perspective;
    const Matrices p = cameraMatrices(ball({1, 2, 3}, 2), fit);
    const glm::dvec4 seen = clip(p, {1.5, 3, 3});
    QVERIFY(glm::length(glm::dvec2(clip(m, {1.5, 3, 3})) - glm::dvec2(seen) / seen.w) < 1e-12);
    QCOMPARE(m.near, p.near);
    QCOMPARE(m.far, p.far);
    // An eye at its target still has a picture.
    settings.view.eye = settings.view.target;
    QVERIFY(std::isfinite(cameraMatrices(scene, settings).clipFromObject[1][1]));
}

void TestOrthographic::depthChangesNoSize()
{
    const Matrices m = cameraMatrices(ball({0, 0, 0}, 1), fromFour());
    for (const double z : {2.0, 0.0, -2.0, -100.0}) {
        QCOMPARE(clip(m, {0.5, 0.75, z}).x, clip(m, {0.5, 0.75, 1}).x);
        QCOMPARE(clip(m, {0.5, 0.75, z}).y, clip(m, {0.5, 0.75, 1}).y);
    }
}

void TestOrthographic::parallelsStayParallel()
{
    Random random = seededRandom();
    Settings settings = parallel({300, 200});
    settings.view.yaw = 33;
    settings.view.pitch = -21;
    const Matrices m = cameraMatrices(ball({1, 0, -2}, 3), settings);
    const glm::dvec3 direction(1, 2, 3);
    const glm::dvec4 seen = clip(m, direction) - clip(m, {0, 0, 0});
    for (int i = 0; i < 100; ++i) {
        const glm::dvec3 from(uniform(random, -5, 5), uniform(random, -5, 5), uniform(random, -5, 5));
        QVERIFY(glm::length(clip(m, from + direction) - clip(m, from) - seen) < 1e-12);
    }
}

void TestOrthographic::zoomScalesTheHeight()
{
    const Scene scene = ball({0, 0, 0}, 1);
    Settings settings = parallel();
    const double usual = cameraMatrices(scene, settings).clipFromView[1][1];
    for (const double distance : {0.5, 0.125, 1e-3, 2.0}) {
        settings.view.distance = distance;
        const Matrices m = cameraMatrices(scene, settings);
        QVERIFY(std::abs(m.clipFromView[1][1] * distance / usual - 1) < 1e-12);
        for (const double z : {-1.0, 1.0}) // nothing of the scene is cut off, however near it comes
            QVERIFY(std::abs(clip(m, {0, 0, z}).z) <= 1);
    }
    Settings free = fromFour();
    const double before = cameraMatrices(scene, free).clipFromView[1][1];
    free.view.eye = {0, 0, 0.5};
    const Matrices near = cameraMatrices(scene, free);
    QVERIFY(std::abs(near.clipFromView[1][1] / before - 8) < 1e-12);
    QVERIFY(std::abs(clip(near, {0, 0, 1}).z) <= 1);
    // Zoomed in, all of a cube is still drawn: what is nearer than the eye was is not cut.
    Settings cube = parallel();
    cube.view.distance = 0.3;
    const Scene solid = builtin("cube");
    QVERIFY(std::ranges::none_of(draw(solid, cube).ids, [](std::int32_t id) { return id < 0; }));
}

/// A model and its camera moved by a power of two, with the origin there: the same matrices bit for bit.
void TestOrthographic::farFromTheOrigin()
{
    Scene scene = squares();
    Settings settings = fromFour();
    const Matrices here = cameraMatrices(scene, settings);
    const Frame expected = draw(scene, settings);
    const glm::dvec3 far(0x1p30, -0x1p31, 0x1p29);
    scene.mesh.origin = far;
    settings.view.eye += far;
    settings.view.target += far;
    const Matrices there = cameraMatrices(scene, settings);
    QVERIFY(here.clipFromObjectDouble == there.clipFromObjectDouble);
    QCOMPARE(difference(expected, draw(scene, settings)), QString());
}

void TestOrthographic::picturesOfAllDepthRanges()
{
    const Scene scene = builtin("teapot");
    Settings settings = scene.defaults;
    settings.size = {100, 80};
    settings.projection = Projection::Orthographic;
    const Frame first = draw(scene, settings);
    QVERIFY(draw(scene, scene.defaults).image.size() != first.image.size());
    for (const ClipZ clipZ : {ClipZ::Gl, ClipZ::D3d})
        for (const bool reversed : {false, true}) {
            settings.clipZ = clipZ;
            settings.reversedZ = reversed;
            const Frame frame = draw(scene, settings);
            std::size_t different = 0;
            for (std::size_t i = 0; i < frame.ids.size(); ++i)
                different += frame.ids[i] != first.ids[i];
            QVERIFY2(different <= 4, qPrintable(QString::number(different))); // where surfaces meet
        }
}

/// All w are 1, so the painter sorts by z, also where it falls with the distance.
void TestOrthographic::painterGoesByDepth()
{
    Scene scene = squares();
    Settings settings = fromFour();
    const std::vector<std::uint32_t> right{0, 1, 2, 3};
    for (const bool swapped : {false, true}) {
        if (swapped)
            std::rotate(scene.mesh.indices.begin(), scene.mesh.indices.begin() + 6, scene.mesh.indices.end());
        for (const ClipZ clipZ : {ClipZ::Gl, ClipZ::D3d})
            for (const bool reversed : {false, true}) {
                settings.clipZ = clipZ;
                settings.reversedZ = reversed;
                settings.visibility = Visibility::ZBuffer;
                const QImage expected = draw(scene, settings).image;
                settings.visibility = Visibility::Painter;
                QVERIFY(draw(scene, settings).image == expected);
                const Derivation d = derived(DerivationTopic::Painter, scene, settings, {0, {}, 0, 0.5, {}});
                for (const DerivationLine& line : d.lines)
                    QVERIFY(line.holds());
            }
    }
}

/// Normals against the gaze and areas on the screen judge alike, also at the side of the picture.
void TestOrthographic::facingGoesByTheGaze()
{
    const Scene scene = builtin("sphere");
    Settings settings = parallel({400, 400});
    settings.culling = Culling::Back;
    settings.view.yaw = 20;
    settings.view.pitch = 35;
    const std::vector<FaceFate> byArea = process(scene, settings).fates;
    settings.cullSpace = CullSpace::View;
    const std::vector<FaceFate> byGaze = process(scene, settings).fates;
    std::size_t different = 0;
    for (std::size_t i = 0; i < byArea.size(); ++i)
        different += byArea[i] != byGaze[i];
    QVERIFY2(different <= byArea.size() / 200, qPrintable(QString::number(different))); // faces seen edge-on
    QVERIFY(std::ranges::count(byGaze, FaceFate::CulledBack) > std::ptrdiff_t(byArea.size() / 3));
}

void TestOrthographic::exactReferenceAgrees()
{
    for (const char* name : {"cube", "tile-square", "piercing", "behind-camera"}) {
        const Scene scene = builtin(name);
        Settings settings = parallel({160, 120});
        settings.view = scene.defaults.view;
        settings.view.yaw += 17;
        const Frame frame = draw(scene, settings);
        const ExactFrame exact = exactReference(scene, settings);
        QVERIFY2(std::ranges::equal(frame.coverage, exact.cover), name);
        const ExactFrame fromObject = exactReference(exactTriangles(scene, settings, ReferenceSpace::Object),
                                                     exactOptions(scene, settings, ReferenceSpace::Object));
        std::size_t different = 0; // where float32 and the exact products snap to two steps
        for (std::size_t i = 0; i < fromObject.cover.size(); ++i)
            different += fromObject.cover[i] != frame.coverage[i];
        QVERIFY2(different <= 6, qPrintable(QString::number(different)));
        QVERIFY(std::ranges::any_of(frame.coverage, [](std::uint16_t count) { return count > 0; }));
    }
}

void TestOrthographic::whatChangesNothing()
{
    const auto reason = [](const char* id, const Settings& one, const Settings& other, const Scene& scene) {
        const auto why = whyUnchanged(*findSettingsField(QLatin1String(id)), one, other, frameFacts(scene, one));
        return why ? textOf(*why) : QString();
    };
    const Scene cube = builtin("cube");
    Settings settings = parallel();
    Settings affine = settings;
    affine.interpolation = Interpolation::Affine;
    QCOMPARE(reason("interpolation", affine, settings, cube), QStringLiteral("all w of these faces are equal: 1"));
    QVERIFY(draw(cube, affine).image == draw(cube, settings).image);
    Settings perspective = settings;
    perspective.projection = Projection::Perspective;
    QCOMPARE(reason("projection", settings, perspective, cube), QString());
    QVERIFY(draw(cube, settings).image != draw(cube, perspective).image);
    // Depth is the distance, and all w are 1: mistakes about them are none.
    for (const char* id : {"view-z-linear", "z-corrected", "affine", "w-lost"}) {
        Settings mistaken = settings;
        mistaken.mistakes = {QLatin1String(id)};
        QVERIFY2(whyUnchanged(*findMistake(QLatin1String(id)), settings, frameFacts(cube, settings)), id);
        QVERIFY2(draw(cube, mistaken).image == draw(cube, settings).image, id);
    }
    // A scene in clip space has been projected.
    const Scene square = builtin("square-diagonal");
    QCOMPARE(reason("projection", settings, perspective, square),
             QStringLiteral("the scene is given in clip space: no camera projects it"));
    QCOMPARE(difference(draw(square, settings), draw(square, perspective)), QString());
}

void TestOrthographic::derivations()
{
    const Scene scene = squares();
    Settings settings = fromFour();
    settings.view.near = 2;
    settings.view.far = 6;
    const Derivation weights = derived(DerivationTopic::Perspective, scene, settings, {0, {}, 0, 0.25, {}});
    for (const char* w : {"w1", "w2", "w_A", "w_B", "w_C"})
        QCOMPARE(valueOf(weights, w), 1.0);
    QCOMPARE(valueOf(weights, "n"), 0.25);
    QCOMPARE(valueOf(weights, "w_spread"), 0.0);
    for (const auto& [space, screen] : {std::pair("alpha_p", "alpha"), std::pair("beta_p", "beta")})
        QVERIFY(isNear(valueOf(weights, space), valueOf(weights, screen), 1e-14));
    // z' = (z - 4) / 2: the far square at distance 5 comes to 0.5, half-way to 0.
    const Derivation depth = derived(DerivationTopic::DepthCurve, scene, settings, {0, {}, 0, 0.25, {}});
    QCOMPARE(valueOf(depth, "T_33"), 0.5);
    QCOMPARE(valueOf(depth, "T_34"), -2.0);
    QCOMPARE(valueOf(depth, "n'"), -1.0);
    QCOMPARE(valueOf(depth, "f'"), 1.0);
    QCOMPARE(valueOf(depth, "c1"), 0.5);
    QCOMPARE(valueOf(depth, "z3"), 5.0);
    QCOMPARE(valueOf(depth, "z'"), 0.0);
    QCOMPARE(valueOf(depth, "part"), 0.5);
    // What is derived is what the vertex stage made.
    const Scene cube = builtin("cube");
    const Derivation ofCube = derived(DerivationTopic::DepthCurve, cube, parallel(), {3, {}, 1, 0.25, {}});
    const std::array<VertexRow, 3> corners = vertexTable(cube, parallel(), 3);
    QVERIFY(isNear(valueOf(ofCube, "c1"), corners[1].clip.z, 1e-6));
    QVERIFY(isNear(valueOf(ofCube, "c2"), corners[2].clip.z, 1e-6));
    settings.clipZ = ClipZ::D3d;
    settings.reversedZ = true;
    const Derivation reversed = derived(DerivationTopic::DepthCurve, scene, settings, {2, {}, 0, 0.25, 3.0});
    QCOMPARE(valueOf(reversed, "T_33"), -0.25); // (0 - 1) / (6 - 2)
    QCOMPARE(valueOf(reversed, "T_34"), 1.5);
    QCOMPARE(valueOf(reversed, "c1"), 0.75); // the near square, at distance 3
    QCOMPARE(valueOf(reversed, "z'"), 0.75);
    QCOMPARE(valueOf(reversed, "part"), 0.25);
}

QTEST_APPLESS_MAIN(TestOrthographic)
#include "test_orthographic.moc"
