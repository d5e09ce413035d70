// A picture that moves by itself: how far each frame goes, and how many pixels it changes.
#include "core/render/motion.h"
#include "core/render/render.h"
#include "core/scene/camera.h"
#include "tests/support.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

Frame drawn(const MovedScene& moved)
{
    Frame frame;
    render(*moved.scene, moved.settings, frame, {.ids = true});
    return frame;
}

/// What each of the frames 1..count changes.
std::vector<FrameChange> changes(const std::shared_ptr<const Scene>& scene, const Settings& settings, Motion motion,
                                 std::size_t count)
{
    std::vector<FrameChange> all;
    Frame last = drawn(movedScene(scene, settings, motion, 0));
    for (std::size_t n = 1; n <= count; ++n) {
        Frame now = drawn(movedScene(scene, settings, motion, n));
        all.push_back(changeBetween(last, now));
        last = std::move(now);
    }
    return all;
}

/// Where a point of the world stands on the screen, in pixels.
double pixelX(const glm::dvec3& point, const MovedScene& moved)
{
    const Matrices matrices = cameraMatrices(*moved.scene, moved.settings);
    const glm::dvec4 clip = matrices.clipFromObjectDouble * glm::dvec4(point - moved.scene->mesh.origin, 1);
    return (clip.x / clip.w + 1) / 2 * moved.settings.size.width();
}

} // namespace

class TestMovedScenes : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aTurnHas360Frames();
    void theJitterGoesThereAndBack();
    void jitterOfACamera_data();
    void jitterOfACamera();
    void anEdgePassesEachColumnOnce();
    void integerCornersFlicker();
    void affineTexturesSwim();
    void changesAreCounted();
    void sceneInClipSpaceHasNoTurntable();
    void runsAreReadFromText();
};

void TestMovedScenes::aTurnHas360Frames()
{
    const auto scene = std::make_shared<const Scene>(*makeBuiltinScene(QStringLiteral("cube")).scene);
    const Settings settings = scene->defaults;
    QCOMPARE(movedScene(scene, settings, Motion::Turntable, 0).settings, settings);
    QCOMPARE(movedScene(scene, settings, Motion::Turntable, 360).settings, settings);
    const MovedScene quarter = movedScene(scene, settings, Motion::Turntable, 450);
    QCOMPARE(quarter.settings.view.yaw, settings.view.yaw + 90);
    QVERIFY(quarter.scene == scene);
    // A camera given by eye and target goes round the target at the same distance, and the same way.
    Settings fixed = settings;
    fixed.view.fit = false;
    fixed.view.eye = {1, 2, 5};
    fixed.view.target = {1, 0, 1};
    const View turned = movedScene(scene, fixed, Motion::Turntable, 90).settings.view;
    QVERIFY(glm::distance(turned.eye, glm::dvec3(5, 2, 1)) < 1e-12);
    QCOMPARE(turned.target, fixed.view.target);
}

void TestMovedScenes::theJitterGoesThereAndBack()
{
    for (const auto& [n, place] : {std::pair(0, 0), {1, 1}, {256, 256}, {257, 255}, {511, 1}, {512, 0}, {513, 1}})
        QCOMPARE(motionPlace(Motion::Jitter, std::size_t(n)), place);
}

void TestMovedScenes::jitterOfACamera_data()
{
    QTest::addColumn<bool>("fit");
    QTest::addColumn<bool>("orthographic");
    QTest::newRow("fitted") << true << false;
    QTest::newRow("fitted, orthographic") << true << true;
    QTest::newRow("eye and target") << false << false;
    QTest::newRow("eye and target, orthographic") << false << true;
}

/// What is looked at goes to the right by 1/256 of a pixel a frame.
void TestMovedScenes::jitterOfACamera()
{
    QFETCH(const bool, fit);
    QFETCH(const bool, orthographic);
    const auto scene = std::make_shared<const Scene>(*makeBuiltinScene(QStringLiteral("cube")).scene);
    Settings settings = scene->defaults;
    settings.size = {320, 200};
    settings.projection = orthographic ? Projection::Orthographic : Projection::Perspective;
    settings.view.fit = fit;
    settings.view.pan = {0.1, -0.2};
    settings.view.eye = {1, 2, 5};
    settings.view.target = {0.5, 0, 1};
    const MovedScene still{scene, settings};
    // The target, and a point above it that is as far away.
    const Matrices matrices = cameraMatrices(*scene, settings);
    const glm::dmat4& view = matrices.viewFromObject;
    const glm::dvec3 up(view[0][1], view[1][1], view[2][1]);
    const glm::dvec3 right(view[0][0], view[1][0], view[2][0]);
    const double radius = scene->bounds.radius;
    const glm::dvec3 target = fit ? scene->bounds.center + radius * (0.1 * right - 0.2 * up) : settings.view.target;
    for (const std::size_t n : {std::size_t(1), std::size_t(100), std::size_t(256)})
        for (const glm::dvec3& point : {target, target + 0.3 * up}) {
            const double way = pixelX(point, movedScene(scene, settings, Motion::Jitter, n)) - pixelX(point, still);
            QVERIFY2(std::abs(way - double(n) / 256) < 1e-9, qPrintable(QString::number(way)));
        }
}

/// On 8 x 8, a rectangle from (2.3, 2.3) to (6.3, 6.3), snapped to 589/256 and 1613/256: after 51/256 its left edge
/// lies on the centres of column 2, which are still inside, and after 52 they are not; its right edge takes column 6 in
/// after 52 as well. Nothing else changes on the way to a whole pixel.
void TestMovedScenes::anEdgePassesEachColumnOnce()
{
    const QSize size(8, 8);
    const auto at = [&](double x, double y) { return atPixel(x, y, 0.5, size); };
    const auto scene = std::make_shared<const Scene>(
        soup({at(2.3, 2.3), at(2.3, 6.3), at(6.3, 6.3), at(2.3, 2.3), at(6.3, 6.3), at(6.3, 2.3)}));
    const std::vector<FrameChange> all = changes(scene, plainSettings(size), Motion::Jitter, 256);
    for (std::size_t n = 1; n <= all.size(); ++n) {
        // The diagonal between the two faces leaves the centres it lies on at once.
        const std::size_t least = n == 52 ? 8 : n == 1 ? 1 : 0;
        const std::size_t most = n == 1 ? 4 : least;
        QVERIFY2(all[n - 1].owners >= least && all[n - 1].owners <= most,
                 qPrintable(QStringLiteral("frame %1: %2").arg(n).arg(all[n - 1].owners)));
    }
}

/// With corners cast to int the picture stands still, and then jumps: flicker.
void TestMovedScenes::integerCornersFlicker()
{
    const QSize size(64, 64);
    const auto scene = std::make_shared<const Scene>(
        soup({atPixel(5.31, 7.73, 0.5, size), atPixel(23.17, 58.61, 0.5, size), atPixel(59.43, 30.29, 0.5, size)}));
    const auto summary = [&](const Settings& settings) {
        std::size_t most = 0;
        std::size_t still = 0;
        for (const FrameChange& change : changes(scene, settings, Motion::Jitter, 256)) {
            most = std::max(most, change.owners);
            still += change.owners == 0 ? 1 : 0;
        }
        return std::pair(most, still);
    };
    const auto [most, still] = summary(plainSettings(size));
    Settings wrong = plainSettings(size);
    wrong.mistakes = {QStringLiteral("integer-vertices")};
    const auto [mostWrong, stillWrong] = summary(wrong);
    qInfo("right: at most %zu pixels a frame, %zu of 256 frames change none; integer corners: %zu, %zu", most, still,
          mostWrong, stillWrong);
    QVERIFY(mostWrong >= 8 * most);
    QCOMPARE(stillWrong, std::size_t(253)); // each corner jumps once
    QVERIFY(still < 200);
}

/// On the turntable an affine texture changes pixels that perspective leaves as they are.
void TestMovedScenes::affineTexturesSwim()
{
    const auto scene = std::make_shared<const Scene>(*makeBuiltinScene(QStringLiteral("tile-square")).scene);
    Settings settings = scene->defaults;
    settings.size = {160, 120};
    Settings affine = settings;
    affine.interpolation = Interpolation::Affine;
    const auto sum = [&](const Settings& of) {
        std::size_t all = 0;
        for (const FrameChange& change : changes(scene, of, Motion::Turntable, 20))
            all += change.colors;
        return all;
    };
    const std::size_t right = sum(settings);
    const std::size_t swimming = sum(affine);
    qInfo("tile-square, 20 degrees: %zu pixels change, %zu with affine interpolation", right, swimming);
    QVERIFY(right > 0);
    QVERIFY(swimming > right);
}

void TestMovedScenes::changesAreCounted()
{
    Frame a;
    a.image = QImage(3, 2, QImage::Format_RGB32);
    a.image.fill(Qt::black);
    a.ids.assign(6, -1);
    Frame b = a;
    QCOMPARE(changeBetween(a, b), FrameChange());
    b.image.setPixel(2, 1, qRgb(0, 0, 1));
    b.image.setPixel(0, 0, qRgb(0, 0, 1));
    b.ids[5] = 0;
    QCOMPARE(changeBetween(a, b), (FrameChange{2, 1}));
}

void TestMovedScenes::sceneInClipSpaceHasNoTurntable()
{
    const Scene clip = *makeBuiltinScene(QStringLiteral("square-diagonal")).scene;
    QVERIFY(whyNotMoved(clip, Motion::Turntable));
    QVERIFY(!whyNotMoved(clip, Motion::Jitter));
    QVERIFY(!whyNotMoved(*makeBuiltinScene(QStringLiteral("cube")).scene, Motion::Turntable));
}

void TestMovedScenes::runsAreReadFromText()
{
    const auto run = motionRunFromText(QStringLiteral("turntable:3-89"));
    QVERIFY(run);
    QVERIFY(run->motion == Motion::Turntable);
    QCOMPARE(run->frames, std::pair(std::size_t(3), std::size_t(89)));
    const auto one = motionRunFromText(QStringLiteral("jitter:12"));
    QVERIFY(one);
    QCOMPARE(one->frames, std::pair(std::size_t(12), std::size_t(12)));
    for (const char* bad : {"", "jitter", "jitter:", "jitter:2-1", "jitter:-1", "jitter:1-2-3", "spin:1", "jitter:1:2",
                            "jitter:1.5", "jitter:0-9999999"})
        QVERIFY2(!motionRunFromText(QLatin1String(bad)), bad);
}

QTEST_GUILESS_MAIN(TestMovedScenes)
#include "test_moved_scenes.moc"
