// What the `map_...` statements of MTL files say: options of all kinds, masks, and materials with and without textures.
#include "core/io/mtl_map.h"
#include "core/io/obj_loader.h"
#include "core/pipeline/shading.h"
#include "core/render/render.h"
#include "tests/scene_files.h"

#include <QImage>
#include <QTest>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

constexpr auto kSquare = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\n";
constexpr auto kFace = "f 1/1/1 2/2/1 3/3/1 4/4/1\n";

/// Two by two texels: red and green below, blue and white above; the left ones transparent on demand.
void writeTexels(const Folder& folder, const QString& name, int leftAlpha = 255)
{
    QImage image(2, 2, QImage::Format_ARGB32);
    image.setPixel(0, 1, qRgba(255, 0, 0, leftAlpha));
    image.setPixel(1, 1, qRgba(0, 255, 0, 255));
    image.setPixel(0, 0, qRgba(0, 0, 255, leftAlpha));
    image.setPixel(1, 0, qRgba(255, 255, 255, 255));
    QVERIFY(image.save(folder.path(name)));
}

SceneLoad loadWith(const Folder& folder, const QByteArray& mtl)
{
    folder.write(QStringLiteral("a.mtl"), "newmtl m\nKd 1 1 1\n" + mtl);
    return loadObj(
        folder.write(QStringLiteral("a.obj"), QByteArray("mtllib a.mtl\n") + kSquare + "usemtl m\n" + kFace));
}

} // namespace

class TestMtlMaps : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void readsEveryOption_data();
    void readsEveryOption();
    void saysWhatItDoesNotHonour_data();
    void saysWhatItDoesNotHonour();
    void movesCoordinates();
    void spreadsTexels();
    void clamps();
    void masksComeFromAlphaOrMapD_data();
    void masksComeFromAlphaOrMapD();
    void maskFollowsItsOwnOptions();
    void replacedTexturesHaveHolesToo();
    void mixedMaterials();
    void missingMaskIsNoHole();
};

void TestMtlMaps::readsEveryOption_data()
{
    QTest::addColumn<QByteArray>("rest");
    QTest::addColumn<QByteArray>("name");
    QTest::addColumn<QList<float>>("numbers"); // scale, offset, base, gain
    QTest::addColumn<bool>("clamp");
    const auto row = [](const char* rest, const char* name, QList<float> numbers, bool clamp = false) {
        QTest::newRow(rest) << QByteArray(rest) << QByteArray(name) << numbers << clamp;
    };
    row(" a.png", "a.png", {1, 1, 0, 0, 0, 1});
    row("-s 2 3 4 a.png", "a.png", {2, 3, 0, 0, 0, 1});
    row("-s 2 3 a.png", "a.png", {2, 3, 0, 0, 0, 1});
    row("-s 2 a.png", "a.png", {2, 1, 0, 0, 0, 1});
    row("-o .5 a.png", "a.png", {1, 1, 0.5F, 0, 0, 1});
    row("-o .5 -.25 9 -s 2 2 a.png", "a.png", {2, 2, 0.5F, -0.25F, 0, 1});
    row("-s 2 2", "2", {2, 1, 0, 0, 0, 1}); // the last word is the name
    row("-s 1 1 1 2", "2", {1, 1, 0, 0, 0, 1});
    row("-mm 0.25 0.5 a.png", "a.png", {1, 1, 0, 0, 0.25F, 0.5F});
    row("-clamp on a.png", "a.png", {1, 1, 0, 0, 0, 1}, true);
    row("-CLAMP ON a.png", "a.png", {1, 1, 0, 0, 0, 1}, true);
    row("-clamp off a.png", "a.png", {1, 1, 0, 0, 0, 1});
    row("-blendu on -blendv on -cc off -t 0 0 0 -bm 1 a.png", "a.png", {1, 1, 0, 0, 0, 1});
    row("-s 2 2 1 my picture 2.png  ", "my picture 2.png", {2, 2, 0, 0, 0, 1});
    row("-dash.png", "-dash.png", {1, 1, 0, 0, 0, 1});
    row("\t-s\t2\t2\ta.png", "a.png", {2, 2, 0, 0, 0, 1});
}

void TestMtlMaps::readsEveryOption()
{
    QFETCH(QByteArray, rest);
    QFETCH(QByteArray, name);
    QFETCH(QList<float>, numbers);
    QFETCH(bool, clamp);
    DiagnosticSink diagnostics(QStringLiteral("a.mtl"));
    const auto map = parseMtlMap("map_Kd", {rest.data(), std::size_t(rest.size())}, 3, diagnostics);
    const QString remarks = textOf(diagnostics.take());
    QVERIFY2(map && remarks.isEmpty(), qPrintable(remarks));
    QCOMPARE(QByteArray::fromStdString(map->name), name);
    QCOMPARE((QList<float>{map->scale.x, map->scale.y, map->offset.x, map->offset.y, map->base, map->gain}), numbers);
    QCOMPARE(map->clamp, clamp);
}

void TestMtlMaps::saysWhatItDoesNotHonour_data()
{
    QTest::addColumn<QByteArray>("rest");
    QTest::addColumn<QString>("phrase");
    const auto row = [](const char* rest, const char* phrase) {
        QTest::newRow(rest) << QByteArray(rest) << QString::fromLatin1(phrase);
    };
    row("-boost 2 t.png", "-boost\" has no effect");
    row("-bm 0.5 t.png", "-bm\" has no effect");
    row("-blendu off t.png", "-blendu\" has no effect");
    row("-cc on t.png", "-cc\" has no effect");
    row("-t 0.1 t.png", "-t\" has no effect");
    row("-texres 64 t.png", "-texres\" has no effect");
    row("-type sphere t.png", "-type\" has no effect");
    row("-colorspace sRGB t.png", "-colorspace\" has no effect");
    row("-wrap 3 on t.png", "no option \"-wrap\"");
    row("-s t.png", "value of \"-s\" is missing");
    row("-mm 1 t.png", "value of \"-mm\" is missing");
    row("-clamp maybe.png t.png", "value of \"-clamp\" is missing");
    row("-imfchan q t.png", "value of \"-imfchan\" is missing");
}

void TestMtlMaps::saysWhatItDoesNotHonour()
{
    QFETCH(QByteArray, rest);
    QFETCH(QString, phrase);
    DiagnosticSink diagnostics(QStringLiteral("a.mtl"));
    const auto map = parseMtlMap("map_Kd", {rest.data(), std::size_t(rest.size())}, 3, diagnostics);
    QVERIFY(map);
    QVERIFY2(QByteArray::fromStdString(map->name).endsWith("t.png"), map->name.c_str());
    verifyRemark(diagnostics.take(), QStringLiteral("a.mtl:3: warning: map_Kd: "), phrase);
}

void TestMtlMaps::movesCoordinates()
{
    const Folder folder;
    writeTexels(folder, QStringLiteral("t.png"));
    const SceneLoad load = loadWith(folder, "map_Kd -s 2 3 -o 0.5 -1 t.png\n");
    QVERIFY2(load.scene && load.diagnostics.empty(), qPrintable(textOf(load.diagnostics)));
    QCOMPARE(load.scene->textures.size(), std::size_t{1});
    QVERIFY(load.scene->mesh.vertices[0].uv == glm::vec2(0.5F, -1));
    QVERIFY(load.scene->mesh.vertices[2].uv == glm::vec2(2.5F, 2));
    // The short form is not the name of a file.
    const SceneLoad shorter = loadWith(folder, "map_Kd -s 2 t.png\n");
    QVERIFY2(shorter.scene && shorter.diagnostics.empty(), qPrintable(textOf(shorter.diagnostics)));
    QVERIFY(shorter.scene->mesh.vertices[2].uv == glm::vec2(2, 1));
}

void TestMtlMaps::spreadsTexels()
{
    const Folder folder;
    writeTexels(folder, QStringLiteral("t.png"));
    const SceneLoad load = loadWith(folder, "map_Kd -mm 0.2 0.6 t.png\n");
    QVERIFY2(load.scene && load.diagnostics.empty(), qPrintable(textOf(load.diagnostics)));
    QCOMPARE(load.scene->textures[0].texels,
             (std::vector<std::uint32_t>{0xffcc3333, 0xff33cc33, 0xff3333cc, 0xffcccccc}));
    const SceneLoad bright = loadWith(folder, "map_Kd -mm 0.5 2 t.png\n");
    QCOMPARE(bright.scene->textures[0].texels[0], 0xffff8080U);
    const SceneLoad dark = loadWith(folder, "map_Kd -mm -1 1 t.png\n");
    QCOMPARE(dark.scene->textures[0].texels[3], 0xff000000U);
}

void TestMtlMaps::clamps()
{
    const Folder folder;
    writeTexels(folder, QStringLiteral("t.png"));
    folder.write(QStringLiteral("a.mtl"), "newmtl m\nmap_Kd -clamp on t.png\nnewmtl n\nmap_Kd t.png\n");
    const SceneLoad load = loadObj(folder.write(
        QStringLiteral("a.obj"), QByteArray("mtllib a.mtl\n") + kSquare + "usemtl m\n" + kFace + "usemtl n\n" + kFace));
    QVERIFY2(load.scene && load.diagnostics.empty(), qPrintable(textOf(load.diagnostics)));
    QCOMPARE(load.scene->textures.size(), std::size_t{2});
    QVERIFY(load.scene->textures[0].clamp && !load.scene->textures[1].clamp);
}

void TestMtlMaps::masksComeFromAlphaOrMapD_data()
{
    QTest::addColumn<QByteArray>("mtl");
    QTest::addColumn<QList<int>>("opacity"); // of the four texels; empty: no mask
    const auto row = [](const char* mtl, QList<int> opacity) { QTest::newRow(mtl) << QByteArray(mtl) << opacity; };
    row("map_Kd opaque.png\n", {});
    row("map_Kd t.png\n", {64, 255, 64, 255});
    row("map_Kd t.png\nmap_d t.png\n", {64, 255, 64, 255});
    row("map_d t.png\n", {64, 255, 64, 255});
    row("map_Kd t.png\nmap_d opaque.png\n", {77, 149, 29, 255}); // luminance
    row("map_d -imfchan r t.png\n", {255, 0, 0, 255});
    row("map_d -imfchan g t.png\n", {0, 255, 0, 255});
    row("map_d -imfchan b t.png\n", {0, 0, 255, 255});
    row("map_d -imfchan m t.png\n", {64, 255, 64, 255});
    row("map_d -imfchan m opaque.png\n", {255, 255, 255, 255});
    row("map_d -imfchan l t.png\n", {77, 149, 29, 255});
    row("MAP_D -mm 1 -1 t.png\n", {191, 0, 191, 0});
}

void TestMtlMaps::masksComeFromAlphaOrMapD()
{
    QFETCH(QByteArray, mtl);
    QFETCH(QList<int>, opacity);
    const Folder folder;
    writeTexels(folder, QStringLiteral("t.png"), 64);
    writeTexels(folder, QStringLiteral("opaque.png"));
    const SceneLoad load = loadWith(folder, mtl);
    QVERIFY2(load.scene && load.diagnostics.empty(), qPrintable(textOf(load.diagnostics)));
    const Material& material = load.scene->materials[0];
    if (opacity.isEmpty()) {
        QCOMPARE(material.mask, -1);
        return;
    }
    QVERIFY(material.mask >= 0);
    QList<int> found;
    for (const std::uint32_t texel : load.scene->textures[std::size_t(material.mask)].texels)
        found << int(texel & 255U);
    QCOMPARE(found, opacity);
    if (material.texture >= 0)
        for (const std::uint32_t texel : load.scene->textures[std::size_t(material.texture)].texels)
            QCOMPARE(texel >> 24, 255U);
}

void TestMtlMaps::maskFollowsItsOwnOptions()
{
    const Folder folder;
    writeTexels(folder, QStringLiteral("t.png"), 64);
    const SceneLoad load = loadWith(folder, "map_Kd -s 2 4 -o 1 0 t.png\nmap_d -s 3 -o 0.5 0.25 -clamp on t.png\n");
    QVERIFY2(load.scene && load.diagnostics.empty(), qPrintable(textOf(load.diagnostics)));
    const Material& material = load.scene->materials[0];
    const glm::vec2 uv = load.scene->mesh.vertices[2].uv; // (1, 1) in the file
    QVERIFY(uv == glm::vec2(3, 4));
    QVERIFY(uv * material.maskScale + material.maskOffset == glm::vec2(3.5F, 1.25F));
    QVERIFY(load.scene->textures[std::size_t(material.mask)].clamp);
    QVERIFY(!load.scene->textures[std::size_t(material.texture)].clamp);
}

void TestMtlMaps::replacedTexturesHaveHolesToo()
{
    const Folder folder;
    writeTexels(folder, QStringLiteral("t.png"), 64);
    LoadOptions options;
    options.texture = folder.path(QStringLiteral("t.png"));
    const SceneLoad load = loadObj(folder.write(QStringLiteral("a.obj"), QByteArray(kSquare) + kFace), options);
    QVERIFY2(load.scene, qPrintable(textOf(load.diagnostics)));
    QCOMPARE(load.scene->materials[0].texture, 0);
    QCOMPARE(load.scene->materials[0].mask, 1);
}

/// A textured square on the left, a painted one on the right: each as its material says.
void TestMtlMaps::mixedMaterials()
{
    const Folder folder;
    QImage image(1, 1, QImage::Format_RGB32);
    image.fill(qRgb(0, 128, 0));
    QVERIFY(image.save(folder.path(QStringLiteral("green.png"))));
    folder.write(QStringLiteral("a.mtl"), "newmtl green\nKd 1 1 1\nmap_Kd green.png\nnewmtl paint\nKd 1 0 0\n");
    const SceneLoad load = loadObj(folder.write(
        QStringLiteral("a.obj"), "mtllib a.mtl\nv -1 -1 0\nv 0 -1 0\nv 0 1 0\nv -1 1 0\nv 1 -1 0\nv 1 1 0\nvn 0 0 1\n"
                                 "usemtl green\nf 1//1 2//1 3//1 4//1\nusemtl paint\nf 2//1 5//1 6//1 3//1\n"));
    QVERIFY2(load.scene && load.diagnostics.empty(), qPrintable(textOf(load.diagnostics)));
    for (const Algorithm algorithm : {Algorithm::EdgeEquation, Algorithm::EdgeWalking, Algorithm::Tiled})
        for (const Shading shading : {Shading::Texture, Shading::Phong}) {
            Settings settings;
            settings.size = {64, 48};
            settings.shading = shading;
            settings.algorithm = algorithm;
            Frame frame;
            render(*load.scene, settings, frame, {});
            const QRgb left = frame.image.pixel(24, 24);
            const QRgb right = frame.image.pixel(40, 24);
            QVERIFY(qRed(left) == qBlue(left) && qGreen(left) > 60 + qRed(left));
            QVERIFY(qGreen(right) == qBlue(right) && qRed(right) > 150 + qGreen(right));
        }
}

void TestMtlMaps::missingMaskIsNoHole()
{
    const Folder folder;
    const SceneLoad load = loadWith(folder, "map_d none.png\n");
    QVERIFY(load.scene);
    QCOMPARE(load.scene->materials[0].mask, -1);
    verifyRemark(load.diagnostics, folder.path(QStringLiteral("a.mtl")) + QStringLiteral(":3: warning: map_d "),
                 QStringLiteral("there is no such file; drawn without holes"));
}

QTEST_GUILESS_MAIN(TestMtlMaps)
#include "test_mtl_maps.moc"
