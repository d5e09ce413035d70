// Other renderers by OpenGL: drawn without a display, and judged as ours are. Without a driver these tests skip.
#include "core/io/case_file.h"
#include "core/opengl/opengl_renderers.h"
#include "core/render/render.h"
#include "core/scenes/load_scene.h"
#include "core/truth/coverage_difference.h"
#include "core/truth/experiment.h"
#include "tests/support.h"

#include <QTest>

using namespace rasterlens;
using namespace rasterlens::test;

class TestOpenGl : public QObject
{
    Q_OBJECT

private:
    /// Mesa's software renderer, or whatever comes first.
    [[nodiscard]] OtherRenderer& renderer()
    {
        for (const auto& one : m_found.renderers)
            if (one->id() == QLatin1String("opengl-software"))
                return *one;
        return *m_found.renderers.front();
    }

    [[nodiscard]] CoverageDifference differenceOf(const Scene& scene, const Settings& settings, Frame& frame)
    {
        renderer().load(scene, settings);
        renderer().draw(frame, {.depth = true, .ids = true, .coverage = true});
        return coverageDifference(frame, exactReference(scene, settings), scene.background);
    }

    OtherRenderers m_found;

private Q_SLOTS:
    void init()
    {
        if (m_found.renderers.empty())
            m_found = openGlRenderers();
        if (m_found.lack)
            QSKIP(qPrintable(textOf(*m_found.lack)));
    }
    void cleanupTestCase() { m_found.renderers.clear(); }

    /// OpenGL leaves to its makers how many subpixel bits there are (at least 4) and who owns ties; but shared edges
    /// are hit once.
    void traitsAreWithinTheSpecification()
    {
        const RendererTraits traits = traitsOf(renderer());
        QVERIFY2(traits.subpixelBits >= 4, qPrintable(QString::number(traits.subpixelBits)));
        QVERIFY(traits.diagonalOnce);
        QVERIFY(traits.sides != OwnedSides::All && traits.sides != OwnedSides::None);
        QVERIFY(!renderer().name().isEmpty());
    }

    /// The picture stands upright, faces have our numbers, and depths are ours to float32's rounding.
    void drawsWhatWeDraw()
    {
        for (const char* name : {"builtin:cube", "builtin:head"}) {
            const SceneLoad load = loadScene(QLatin1String(name));
            Settings settings = load.scene->defaults;
            settings.size = {320, 240};
            Frame frame;
            const CoverageDifference difference = differenceOf(*load.scene, settings, frame);
            QVERIFY(difference.covered > 5000);
            QVERIFY2(difference.wrong() < difference.covered / 100, qPrintable(QString::number(difference.wrong())));
            QVERIFY(difference.depthMax < 1e-2 && difference.depthMean < 1e-4);
            QVERIFY2(difference.colorMean < 0.6, qPrintable(QString::number(difference.colorMean)));
        }
    }

    void facingAndDepthTestsAreOurs()
    {
        const SceneLoad load = loadScene(QStringLiteral("builtin:cube"));
        for (const Culling culling : {Culling::Back, Culling::Front, Culling::None})
            for (const bool reversedZ : {false, true}) {
                Settings settings = load.scene->defaults;
                settings.size = {160, 120};
                settings.culling = culling;
                settings.reversedZ = reversedZ;
                Frame frame;
                const CoverageDifference difference = differenceOf(*load.scene, settings, frame);
                QVERIFY(difference.covered > 1000);
                QVERIFY2(difference.wrong() < difference.covered / 50, qPrintable(QString::number(difference.wrong())));
            }
    }

    void texturesStandUpright()
    {
        const SceneLoad load = loadScene(QStringLiteral("builtin:tile-square"));
        Settings settings = load.scene->defaults;
        settings.size = {160, 120};
        Frame theirs;
        renderer().load(*load.scene, settings);
        renderer().draw(theirs, {});
        Frame ours;
        render(*load.scene, settings, ours);
        int different = 0;
        for (int y = 0; y < 120; ++y)
            for (int x = 0; x < 160; ++x)
                different += std::abs(qRed(theirs.image.pixel(x, y)) - qRed(ours.image.pixel(x, y))) > 2 ? 1 : 0;
        QVERIFY2(different < 160 * 120 / 50, qPrintable(QString::number(different)));
    }

    /// A face with a corner that is no number is dropped, and those behind it keep their numbers.
    void facesKeepTheirNumbers()
    {
        const SceneLoad load = parseCase("size 8 8\n"
                                         "tri nan 0 0 1 1 1 1  1 0 0 1 1 1 1  0 1 0 1 1 1 1\n"
                                         "tri -1 -1 0 1 1 1 1  1 -1 0 1 1 1 1  -1 1 0 1 1 1 1\n",
                                         QStringLiteral("a.case"));
        QVERIFY(load.scene);
        Frame frame;
        const CoverageDifference difference = differenceOf(*load.scene, load.scene->defaults, frame);
        QCOMPARE(frame.ids[7 * 8], 1);
        QCOMPARE(difference.otherFace, 0U);
    }

    void whatItDoesNotDrawIsRefused()
    {
        const SceneLoad load = loadScene(QStringLiteral("builtin:cube"));
        const auto isRefused = [&](auto&& change) {
            Settings settings = load.scene->defaults;
            change(settings);
            return renderer().unsupported(*load.scene, settings).has_value();
        };
        QVERIFY(!isRefused([](Settings&) {}));
        QVERIFY(isRefused([](Settings& s) { s.fill = Fill::Wireframe; }));
        QVERIFY(isRefused([](Settings& s) { s.shading = Shading::Phong; }));
        QVERIFY(isRefused([](Settings& s) { s.visibility = Visibility::Painter; }));
        QVERIFY(isRefused([](Settings& s) { s.samples = Samples::Msaa4; }));
        QVERIFY(isRefused([](Settings& s) { s.mistakes = {QStringLiteral("tie-inclusive")}; }));
        QVERIFY(isRefused([](Settings& s) { s.depthBias.constant = 1; }));
    }

    void isARowOfTheExperiment()
    {
        const SceneLoad load = loadScene(QStringLiteral("builtin:cube"));
        Settings settings = load.scene->defaults;
        settings.size = {64, 48};
        ExperimentOptions options{1, true};
        options.others = openGlRenderers;
        const auto rows =
            runExperiment(*load.scene, settings, std::vector{findVariant(QStringLiteral("edge-equation"))}, options);
        QCOMPARE(rows.size(), 1 + m_found.renderers.size());
        QVERIFY(rows.back().other && rows.back().error.coverage && rows.back().error.depth && rows.back().ratio);
    }
};

QTEST_APPLESS_MAIN(TestOpenGl)
#include "test_opengl.moc"
