// A rendered frame against the truth: every kind of wrong pixel is found, counted and marked.
#include "core/truth/coverage_difference.h"

#include <QTest>

#include <cmath>

using namespace rasterlens;

namespace
{

constexpr int kSide = 8;
constexpr glm::vec3 kBlack(0, 0, 0);

/// Two faces that share the diagonal of 8 x 8 pixels; the viewport is covered but for the lowest row.
Scene twoFaces()
{
    Scene scene;
    scene.space = SceneSpace::Clip;
    scene.lit = false;
    scene.background = kBlack;
    scene.materials = {Material{}};
    scene.defaults.culling = Culling::None;
    scene.defaults.size = {kSide, kSide};
    const glm::vec4 corners[4] = {{-1, 1, 0, 1}, {-1, -0.75F, 0, 1}, {1, -0.75F, 0, 1}, {1, 1, 0, 1}};
    for (const int i : {0, 1, 2, 0, 2, 3}) {
        scene.mesh.indices.push_back(static_cast<std::uint32_t>(scene.mesh.vertices.size()));
        scene.mesh.vertices.push_back({.position = corners[i], .color = {0.5F, 1, 0}});
    }
    return scene;
}

struct Pair {
    Frame rendered;
    ExactFrame truth;

    void changeDepth(std::size_t pixel, float by) { rendered.depth.write(rendered.depth.size())[pixel] += by; }

    [[nodiscard]] CoverageDifference difference(double band = 0) const
    {
        return coverageDifference(rendered, truth, kBlack, band);
    }
};

Pair renderedAndTrue(const Scene& scene)
{
    Pair pair;
    render(scene, scene.defaults, pair.rendered, {.depth = true, .ids = true, .coverage = true});
    ExactOptions options = exactOptions(scene, scene.defaults);
    options.edgeDistance = true;
    pair.truth = exactReference(exactTriangles(scene, scene.defaults), options);
    return pair;
}

constexpr std::size_t pixel(int x, int y) { return static_cast<std::size_t>(y * kSide + x); }

} // namespace

class TestCoverageDifference : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aRightFrameIsRight();
    void everyKindOfWrongPixel();
    void aCrackIsNeverHit();
    void depthAndColor();
    void theBandTolerates();
    void withoutCoverageTheFacesDecide();
    void onlyTheWindowCounts();
    void severalSamples();
    void windowsJoin();
};

void TestCoverageDifference::aRightFrameIsRight()
{
    const CoverageDifference d = renderedAndTrue(twoFaces()).difference();
    QCOMPARE(d.pixels, 64U);
    QCOMPARE(d.covered, 56U);
    QCOMPARE(d.wrong(), 0U);
    QCOMPARE(d.tolerated, 0U);
    QCOMPARE(d.depthMax, 0.0);
    QCOMPARE(d.colorMax, 0.5); // 127.5 shown as 128
    QVERIFY(std::abs(d.colorMean - 0.5 / 3) < 1e-12);
}

void TestCoverageDifference::everyKindOfWrongPixel()
{
    Pair pair = renderedAndTrue(twoFaces());
    pair.rendered.coverage[pixel(3, 0)] = 0; // in the first row: not a crack
    pair.rendered.coverage[pixel(0, 0)] = 0;
    pair.rendered.coverage[pixel(2, 7)] = 1;
    pair.rendered.coverage[pixel(4, 4)] = 2;
    pair.rendered.ids[pixel(1, 5)] = 1;
    pair.truth.cover[pixel(6, 2)] = 3;
    pair.rendered.coverage[pixel(6, 2)] = 2;
    const CoverageDifference d = pair.difference();
    QCOMPARE(d.missing, 2U);
    QCOMPARE(d.extra, 1U);
    QCOMPARE(d.hitTwice, 1U);
    QCOMPARE(d.hitLess, 1U);
    QCOMPARE(d.otherFace, 1U);
    QCOMPARE(d.wrong(), 6U);
    QCOMPARE(d.verdicts[pixel(3, 0)], PixelVerdict::Missing);
    QCOMPARE(d.verdicts[pixel(2, 7)], PixelVerdict::Extra);
    QCOMPARE(d.verdicts[pixel(4, 4)], PixelVerdict::HitTwice);
    QCOMPARE(d.verdicts[pixel(6, 2)], PixelVerdict::HitLess);
    QCOMPARE(d.verdicts[pixel(1, 5)], PixelVerdict::OtherFace);
    QCOMPARE(d.verdicts[pixel(7, 7)], PixelVerdict::Right);
}

void TestCoverageDifference::aCrackIsNeverHit()
{
    Pair pair = renderedAndTrue(twoFaces());
    pair.rendered.coverage[pixel(3, 3)] = 0; // all neighbours are covered
    pair.rendered.coverage[pixel(3, 6)] = 0; // the pixel below is not
    const CoverageDifference d = pair.difference();
    QCOMPARE(d.missing, 2U);
    QCOMPARE(d.neverHit, 1U);
}

void TestCoverageDifference::depthAndColor()
{
    Pair pair = renderedAndTrue(twoFaces());
    pair.changeDepth(pixel(2, 2), 0.25F);
    pair.rendered.image.setPixel(5, 1, qRgb(128, 245, 0));
    CoverageDifference d = pair.difference();
    QCOMPARE(d.depthMax, 0.25);
    QCOMPARE(d.depthMean, 0.25 / 56);
    QCOMPARE(d.colorMax, 10.0);
    // one channel is ten steps off; that 56 pixels are half a step off in red is rounding
    QVERIFY(std::abs(d.psnrDb - 10 * std::log10(255.0 * 255 * 192 / 100)) < 1e-9);

    pair.truth.depthTested = false;
    d = pair.difference();
    QCOMPARE(d.depthMax, 0.0);
}

void TestCoverageDifference::theBandTolerates()
{
    Pair pair = renderedAndTrue(twoFaces());
    pair.rendered.coverage[pixel(7, 0)] = 0; // half a pixel from the border of its face
    pair.rendered.coverage[pixel(5, 2)] = 0; // well inside
    const CoverageDifference d = pair.difference(0.6);
    QCOMPARE(d.tolerated, 1U);
    QCOMPARE(d.missing, 1U);
    QCOMPARE(d.verdicts[pixel(7, 0)], PixelVerdict::Right);
}

void TestCoverageDifference::withoutCoverageTheFacesDecide()
{
    Pair pair = renderedAndTrue(twoFaces());
    pair.rendered.coverage.clear();
    QCOMPARE(pair.difference().wrong(), 0U);
    pair.rendered.ids[pixel(3, 3)] = -1;
    pair.rendered.ids[pixel(3, 7)] = 0;
    QCOMPARE(pair.difference().missing, 1U);
    QCOMPARE(pair.difference().extra, 1U);
}

void TestCoverageDifference::onlyTheWindowCounts()
{
    Scene scene = twoFaces();
    scene.window = PixelRect{2, 3, 4, 5};
    Pair pair = renderedAndTrue(scene);
    pair.rendered.coverage[pixel(0, 0)] = 0;
    pair.rendered.coverage[pixel(5, 4)] = 0;
    const CoverageDifference d = pair.difference();
    QCOMPARE(d.pixels, 20U);
    QCOMPARE(d.missing, 1U);
    QCOMPARE(d.verdicts[1 * 4 + 3], PixelVerdict::Missing);
}

void TestCoverageDifference::severalSamples()
{
    Scene scene = twoFaces();
    for (const Samples samples : {Samples::Grid2, Samples::Grid3, Samples::Grid4}) {
        scene.defaults.samples = samples;
        const CoverageDifference d = renderedAndTrue(scene).difference();
        QCOMPARE(d.pixels, 64U);
        QCOMPARE(d.wrong(), 0U);
        QVERIFY(d.colorMax <= 1);
    }
}

void TestCoverageDifference::windowsJoin()
{
    Scene scene = twoFaces();
    scene.mesh.vertices[1].color = {0.3F, 0.1F, 0.7F};
    const auto wrongFrame = [&](std::optional<PixelRect> window) {
        scene.window = window;
        Pair pair = renderedAndTrue(scene);
        pair.rendered.coverage[pixel(2, 2)] = 0;
        pair.rendered.coverage[pixel(5, 7)] = 1;
        pair.rendered.coverage[pixel(5, 6)] = 2;
        pair.changeDepth(pixel(4, 1), 0.5F);
        pair.rendered.image.setPixel(4, 5, qRgb(0, 0, 0));
        return pair.difference();
    };
    const CoverageDifference whole = wrongFrame(std::nullopt);
    const CoverageDifference sum =
        joined(wrongFrame(PixelRect{0, 0, kSide, 3}), wrongFrame(PixelRect{0, 3, kSide, kSide - 3}));
    QVERIFY(whole.missing == 1 && whole.extra == 1 && whole.hitTwice == 1);
    for (const auto member : {&CoverageDifference::pixels, &CoverageDifference::covered, &CoverageDifference::missing,
                              &CoverageDifference::extra, &CoverageDifference::hitTwice,
                              &CoverageDifference::depthsCompared, &CoverageDifference::colorsCompared})
        QCOMPARE(sum.*member, whole.*member);
    for (const auto member :
         {&CoverageDifference::depthMax, &CoverageDifference::depthMean, &CoverageDifference::colorMax,
          &CoverageDifference::colorMean, &CoverageDifference::psnrDb})
        QVERIFY(std::abs(sum.*member - whole.*member) < 1e-12 * whole.*member);
}

QTEST_APPLESS_MAIN(TestCoverageDifference)
#include "test_coverage_difference.moc"
