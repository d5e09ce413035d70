// The camera: the peer harness's matrix bit for bit, depth ranges, orbit, and looking along the up vector.
#include "core/scene/camera.h"
#include "tests/support.h"

#include <QTest>

#ifdef RASTERLENS_HAS_PEERS
#include <scene.hpp>
#endif

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

Scene ball(const glm::dvec3& center, double radius)
{
    Scene scene;
    scene.bounds = {center, radius};
    return scene;
}

bool close(const glm::dvec3& a, const glm::dvec3& b) { return glm::length(a - b) < 1e-5; }

glm::dvec3 ndc(const Matrices& m, const glm::dvec3& world)
{
    const glm::dvec4 p = glm::dmat4(m.clipFromView * m.viewFromObject) * glm::dvec4(world, 1);
    return glm::dvec3(p) / p.w;
}

} // namespace

class TestCamera : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void peerMatrixBitForBit();
    void sphereTouchesTheFrustum();
    void nearAndFarMapToTheEnds();
    void farStaysBeyondNear();
    void orbitGoesRoundTheTarget();
    void lookingAlongUp();
    void clipScenesHaveNoCamera();
};

void TestCamera::peerMatrixBitForBit()
{
#ifdef RASTERLENS_HAS_PEERS
    Random random = seededRandom();
    for (int i = 0; i < 500; ++i) {
        const glm::dvec3 center(uniform(random, -50, 50), uniform(random, -50, 50), uniform(random, -50, 50));
        const double radius = std::exp2(uniform(random, -10, 10));
        Settings settings;
        settings.size = i % 2 == 0 ? QSize(1920, 1080) : QSize(integer(random, 1, 4000), integer(random, 1, 4000));
        const Matrices m = cameraMatrices(ball(center, radius), settings);
        const ps::Sphere sphere{{center.x, center.y, center.z}, radius};
        std::array<float, 16> expected{};
        double near = 0;
        double far = 0;
        std::array<double, 3> eye{};
        ps::camera(sphere, settings.size.width(), settings.size.height(), expected.data(), &near, &far, eye.data());
        for (int k = 0; k < 16; ++k)
            QCOMPARE(std::bit_cast<std::uint32_t>(m.clipFromObject[k / 4][k % 4] + 0.0F),
                     std::bit_cast<std::uint32_t>(expected[std::size_t(k)] + 0.0F));
        QCOMPARE(m.near, near);
        QCOMPARE(m.far, far);
        QCOMPARE(m.eyeObject, glm::dvec3(eye[0], eye[1], eye[2]));
    }
#else
    QSKIP("../shared/peers/scene.hpp is not here");
#endif
}

void TestCamera::sphereTouchesTheFrustum()
{
    Settings settings;
    settings.size = {200, 100};
    const Matrices m = cameraMatrices(ball({1, 2, 3}, 2), settings);
    // The point of the sphere where the upper plane of the frustum touches it.
    const double half = glm::radians(22.5);
    const glm::dvec3 touching = glm::dvec3(1, 2, 3) + 2.0 * glm::dvec3(0, std::cos(half), std::sin(half));
    QVERIFY(std::abs(ndc(m, touching).y - 1) < 1e-12);
    QVERIFY(std::abs(ndc(m, {1, 2, 3}).x) < 1e-12);
    settings.view.distance = 2;
    QVERIFY(ndc(cameraMatrices(ball({1, 2, 3}, 2), settings), touching).y < 0.6);
}

void TestCamera::nearAndFarMapToTheEnds()
{
    for (const ClipZ clipZ : {ClipZ::Gl, ClipZ::D3d})
        for (const bool reversed : {false, true}) {
            Settings settings;
            settings.size = {64, 64};
            settings.clipZ = clipZ;
            settings.reversedZ = reversed;
            settings.view.fit = false;
            settings.view.near = 0.5;
            settings.view.far = 40;
            const Matrices m = cameraMatrices(ball({0, 0, 0}, 1), settings);
            const double low = clipZ == ClipZ::Gl ? -1 : 0;
            QVERIFY(std::abs(ndc(m, {0, 0, 3 - 0.5}).z - (reversed ? 1 : low)) < 1e-12);
            QVERIFY(std::abs(ndc(m, {0, 0, 3 - 40}).z - (reversed ? low : 1)) < 1e-12);
        }
    // All four depth ranges draw the same picture.
    const Scene scene = *makeBuiltinScene(QStringLiteral("teapot")).scene;
    Settings settings = scene.defaults;
    settings.size = {100, 80};
    const Frame first = draw(scene, settings);
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
    // Distances that make no sense still give finite matrices.
    settings.view.near = 10;
    settings.view.far = 1e-3;
    QVERIFY(std::isfinite(cameraMatrices(scene, settings).clipFromObject[2][2]));
}

/// A near plane that a session or a user puts behind the far plane pushes it on.
void TestCamera::farStaysBeyondNear()
{
    const Scene scene = ball({1, 2, 3}, 1);
    Settings settings;
    settings.size = {64, 64};
    const Matrices ordinary = cameraMatrices(scene, settings);
    QVERIFY(ordinary.far > ordinary.near * 1.5);
    for (const double near : {ordinary.far, 10.0, 1000.0}) {
        settings.view.near = near; // beyond the far plane that the scene's size gives
        settings.view.far.reset();
        QCOMPARE(cameraMatrices(scene, settings).near, near);
        QCOMPARE(cameraMatrices(scene, settings).far, near * 1.001);
        settings.view.far = near / 2;
        QCOMPARE(cameraMatrices(scene, settings).far, near * 1.001);
        settings.view.far = near * 2;
        QCOMPARE(cameraMatrices(scene, settings).far, near * 2);
    }
}

void TestCamera::orbitGoesRoundTheTarget()
{
    const glm::dvec3 center(1, 2, 3);
    const Scene scene = ball(center, 1);
    Settings settings;
    settings.size = {64, 64};
    const double d = 1 / std::sin(glm::radians(22.5));
    const auto eye = [&](double yaw, double pitch) {
        settings.view.yaw = yaw;
        settings.view.pitch = pitch;
        return cameraMatrices(scene, settings).eyeObject - center;
    };
    QVERIFY(close(eye(0, 0), {0, 0, d}));
    QVERIFY(close(eye(90, 0), {d, 0, 0}));
    QVERIFY(close(eye(180, 0), {0, 0, -d}));
    QVERIFY(close(eye(0, 90), {0, d, 0}));
    QVERIFY(close(eye(0, -90), {0, -d, 0}));
    Random random = seededRandom();
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 from = eye(uniform(random, -360, 360), uniform(random, -90, 90));
        const Matrices m = cameraMatrices(scene, settings);
        QVERIFY(std::abs(glm::length(from) - d) < 1e-12);
        QVERIFY(close(ndc(m, center) * glm::dvec3(1, 1, 0), {0, 0, 0}));
        // The world's up is never down on the screen, and the frame is orthonormal.
        QVERIFY(ndc(m, center + glm::dvec3(0, 0.1, 0)).y >= -1e-9);
        const glm::dmat3 r(m.viewFromObject);
        QVERIFY(std::abs(glm::determinant(r) - 1) < 1e-12);
    }
    settings.view.pan = {0.5, -0.25};
    settings.view.yaw = settings.view.pitch = 0;
    const Matrices panned = cameraMatrices(scene, settings);
    QVERIFY(close(ndc(panned, center + glm::dvec3(0.5, -0.25, 0)) * glm::dvec3(1, 1, 0), {0, 0, 0}));
}

void TestCamera::lookingAlongUp()
{
    Settings settings;
    settings.size = {64, 64};
    settings.view.fit = false;
    for (const glm::dvec3 up : {glm::dvec3(0, 1, 0), glm::dvec3(0, -2, 0), glm::dvec3(0, 0, 1), glm::dvec3(0, 0, 0)})
        for (const glm::dvec3 eye : {glm::dvec3(0, 5, 0), glm::dvec3(0, -5, 0), glm::dvec3(0, 0, 5), glm::dvec3(0)}) {
            settings.view.eye = eye;
            settings.view.up = up;
            const Matrices m = cameraMatrices(ball({0, 0, 0}, 1), settings);
            const glm::dmat3 r(m.viewFromObject);
            QVERIFY(std::abs(glm::determinant(r) - 1) < 1e-12);
            for (int k = 0; k < 16; ++k)
                QVERIFY(std::isfinite(m.clipFromObject[k / 4][k % 4]));
            if (eye != glm::dvec3(0))
                QVERIFY(close(ndc(m, {0, 0, 0}) * glm::dvec3(1, 1, 0), {0, 0, 0}));
        }
}

void TestCamera::clipScenesHaveNoCamera()
{
    Scene scene = ball({5, 5, 5}, 2);
    scene.space = SceneSpace::Clip;
    Settings settings;
    settings.reversedZ = true;
    const Matrices m = cameraMatrices(scene, settings);
    QVERIFY(m.clipFromObject == glm::mat4(1));
    QVERIFY(m.viewFromObject == glm::dmat4(1));
}

QTEST_APPLESS_MAIN(TestCamera)
#include "test_camera.moc"
