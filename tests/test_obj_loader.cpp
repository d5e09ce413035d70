// OBJ, MTL and textures: what good files become, and what is said about broken ones.
#include "core/io/obj_loader.h"
#include "scene_files.h"
#include "tests/seed.h"

#include <QDir>
#include <QImage>

#include <clocale>
#include <random>

#ifdef RASTERLENS_PEER_SCENES
#include "peers/scene.hpp"
#endif

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

const LoadOptions kPeerMesh{true, {1920, 1080}, {}};

LoadOptions withTexture(const QString& path) { return {false, {1920, 1080}, path}; }

const QByteArray kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

QByteArray tga(int type, int width, int height, int bits, int descriptor, const QByteArray& data)
{
    QByteArray file(18, '\0');
    file[2] = static_cast<char>(type);
    file[12] = static_cast<char>(width & 255);
    file[13] = static_cast<char>(width >> 8);
    file[14] = static_cast<char>(height & 255);
    file[15] = static_cast<char>(height >> 8);
    file[16] = static_cast<char>(bits);
    file[17] = static_cast<char>(descriptor);
    return file + data;
}

} // namespace

class TestObjLoader : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void broken_data();
    void broken();
    void brokenBesideTheObj_data();
    void brokenBesideTheObj();
    void manyErrorsAreCounted();
    void junkNeverCrashes();
    void hugePolygonEndsInTime();

    void lineEndsCommentsAndContinuation();
    void cornersOfAllKinds();
    void convexPolygonIsAFan();
    void vertexIsAPositionUvNormalMaterial();
    void generatedNormalsAreAreaWeighted();
    void missingUvIsPlanar();
    void vertexColors();
    void materials();
    void textureLiesWithRowZeroAtTheBottom();
    void tgaOfAllKinds();
    void textureOptionReplacesTextures();
    void fileNamesWithBlanksAndBackslashes();
    void anyLocale();
    void peerMeshOfAFile();
    void peerMeshIsThePeersBitForBit();
    void sharedModels();
};

void TestObjLoader::broken_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<int>("line"); // 0: the file as a whole
    QTest::addColumn<QString>("phrase");
    const auto row = [](const char* name, const QByteArray& text, int line, const char* phrase) {
        QTest::newRow(name) << text << line << QString::fromLatin1(phrase);
    };
    row("empty file", "", 0, "the file is empty");
    row("no faces", kTriangle, 0, "there are no faces");
    row("only comments", "# one\n# two\n", 0, "there are no faces");
    row("zero byte", QByteArray("v 0 0 0\nv 1 \0\1\2 0\n", 18), 2, "binary data");
    row("v of two numbers", "v 0 0\nf 1 1 1\n", 1, "v: 2 numbers; 3 to 7 expected");
    row("v without numbers", "v\nf 1 1 1\n", 1, "v: 0 numbers");
    row("v of five numbers", "v 0 0 0 1 1\nf 1 1 1\n", 1, "v: 5 numbers; x y z");
    row("v of eight numbers", "v 0 0 0 1 1 1 1 1\nf 1 1 1\n", 1, "v: 8 numbers");
    row("v with a word", "v 0 0 0\nv 0 zero 0\nf 1 1 1\n", 2, "v: \"zero\" is not a number");
    row("v with a comma", "v 0,5 0 0\nf 1 1 1\n", 1, "\"0,5\" is not a number");
    row("v with a rest", "v 1.5x 0 0\nf 1 1 1\n", 1, "\"1.5x\" is not a number");
    row("v in hexadecimal", "v 0x10 0 0\nf 1 1 1\n", 1, "\"0x10\" is not a number");
    row("v nan", "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n", 2, "v: \"nan\" is not finite");
    row("v inf", "v 0 0 -inf\nf 1 1 1\n", 1, "v: \"-inf\" is not finite");
    row("v too large", "v 1e39 0 0\nf 1 1 1\n", 1, "\"1e39\" is beyond the range of float32");
    row("v far too large", "v 0 -1e99999 0\nf 1 1 1\n", 1, "\"-1e99999\" is beyond the range of float32");
    row("v with two signs", "v +-1 0 0\nf 1 1 1\n", 1, "\"+-1\" is not a number");
    row("f of two corners", kTriangle + "f 1 2\n", 4, "f: 2 corners; at least 3 expected");
    row("f without corners", kTriangle + "f\n", 4, "f: 0 corners");
    row("f index zero", kTriangle + "f 0 1 2\n", 4, "v index 0 is out of range; indices count from 1");
    row("f index too large", kTriangle + "\nf 1 2 4\n", 5, "v index 4 is out of range; the file has 3 \"v\"");
    row("f index too far back", kTriangle + "f -1 -2 -4\n", 4, "v index -4 is out of range; 3 \"v\" come before it");
    row("f back before any", "f -1 -2 -3\n" + kTriangle, 1, "v index -1 is out of range; 0 \"v\"");
    row("f index overflows int", kTriangle + "f 1 2 4294967297\n", 4, "v index 4294967297 is out of range");
    row("f index overflows all", kTriangle + "f 1 2 99999999999999999999999\n", 4, "is out of range; the file has 3");
    row("f with words", kTriangle + "f one two three\n", 4, "f: \"one\" is not a corner");
    row("f with fractions", kTriangle + "f 1.5 2 3\n", 4, "f: \"1.5\" is not a corner");
    row("f with four parts", kTriangle + "vt 0 0\nvn 0 0 1\nf 1/1/1/1 2 3\n", 6, "\"1/1/1/1\" is not a corner");
    row("truncated face", kTriangle + "f 1 2", 4, "f: 2 corners");
    row("truncated number", "v 0 0 0\nv 1 0 -", 2, "\"-\" is not a number");
    row("line of a CRLF file", "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 9\r\n", 4, "v index 9 is out of range");
    row("line of a CR file", "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 9\r", 4, "v index 9 is out of range");
    row("line after a continuation", "v 0 0 0\nv 1 \\\n0 0\nv 0 1 0\nf 1 2 9\n", 5, "v index 9 is out of range");
    row("line of a continued face", kTriangle + "f 1 \\\n2 \\\n9\n", 4, "v index 9 is out of range");
    row("backslash at the end", kTriangle + "f 1 2 \\", 4, "f: 2 corners");
    row("10 MB line", "v " + QByteArray(10'000'000, '7') + " 0 0\nf 1 1 1\n", 1,
        "7...\" is beyond the range of float32");
    row("10 MB word", QByteArray(10'000'000, 'x'), 0, "there are no faces");
}

void TestObjLoader::broken()
{
    QFETCH(QByteArray, text);
    QFETCH(int, line);
    QFETCH(QString, phrase);
    const Folder folder;
    const QString path = folder.write(QStringLiteral("broken.obj"), text);
    const QString prefix = line > 0 ? QStringLiteral("%1:%2: ").arg(path).arg(line) : path + QStringLiteral(": ");
    for (const bool peerMesh : {false, true}) {
        const SceneLoad load = loadObj(path, peerMesh ? kPeerMesh : LoadOptions{});
        QVERIFY(!load.scene);
        QVERIFY(hasErrors(load.diagnostics));
        verifyRemark(load.diagnostics, prefix, phrase);
    }
}

void TestObjLoader::brokenBesideTheObj_data()
{
    QTest::addColumn<QByteArray>("mtl");
    QTest::addColumn<QString>("place"); // file and line
    QTest::addColumn<QString>("phrase");
    const auto row = [](const char* name, const QByteArray& mtl, const char* place, const char* phrase) {
        QTest::newRow(name) << mtl << QString::fromLatin1(place) << QString::fromLatin1(phrase);
    };
    row("missing MTL", QByteArray(), "scene.obj:1", "there is no such file; the default material is used");
    row("empty MTL", "", "scene.obj:1", "the file is empty");
    row("material not in the MTL", "newmtl other\n", "scene.obj:5", "no material \"wood\" in the MTL files");
    row("missing texture", "newmtl wood\n\nmap_Kd none.png\n", "scene.mtl:3",
        "none.png: there is no such file; drawn without texture");
    row("texture is a directory", "newmtl wood\nmap_Kd .\n", "scene.mtl:2", "this is a directory");
    row("texture is not an image", "newmtl wood\nmap_Kd scene.obj\n", "scene.mtl:2", "the image cannot be read");
    row("texture without a name", "newmtl wood\nmap_Kd\n", "scene.mtl:2", "map_Kd takes a file name");
    row("texture too wide", "newmtl wood\nmap_Kd wide.tga\n", "scene.mtl:2",
        "65535 x 65535 texels; at most 16384 x 16384");
    row("texture over the limit", "newmtl wood\nmap_Kd large.tga\n", "scene.mtl:2", "would take 1024 MB; at most");
    row("texture too wide, PNG", "newmtl wood\nmap_Kd wide.png\n", "scene.mtl:2", "20000 x 1 texels; at most 16384");
    row("truncated TGA", "newmtl wood\nmap_Kd short.tga\n", "scene.mtl:2", "the image ends early");
    row("TGA of no kind", "newmtl wood\nmap_Kd odd.tga\n", "scene.mtl:2", "type 7 with 24 bits is not supported");
    row("empty TGA", "newmtl wood\nmap_Kd none.tga\n", "scene.mtl:2", "the image is empty");
    row("Kd with a word", "newmtl wood\nKd red 0 0\n", "scene.mtl:2", "Kd: \"red\" is not a number");
    row("Kd of two numbers", "newmtl wood\nKd 1 1\n", "scene.mtl:2",
        "Kd: a number is missing; red, green and blue expected");
    row("Ks nan", "newmtl wood\nKs nan 0 0\n", "scene.mtl:2", "Ks: \"nan\" is not finite");
    row("Ns too large", "newmtl wood\nNs 1e99\n", "scene.mtl:2", "Ns: \"1e99\" is beyond the range");
    row("Ns negative", "newmtl wood\nNs -5\n", "scene.mtl:2", "Ns: \"-5\" is negative");
    row("newmtl without a name", "newmtl\nnewmtl wood\n", "scene.mtl:1", "newmtl takes a name");
    row("Kd before newmtl", "Kd 1 1 1\nnewmtl wood\n", "scene.mtl:1", "\"Kd\" stands before the first newmtl");
    row("binary MTL", QByteArray("newmtl wood\n\0\0", 14), "scene.mtl", "binary data");
}

/// What is wrong beside the OBJ is a warning, and the mesh is there.
void TestObjLoader::brokenBesideTheObj()
{
    QFETCH(QByteArray, mtl);
    QFETCH(QString, place);
    QFETCH(QString, phrase);
    const Folder folder;
    QImage wide(20000, 1, QImage::Format_RGB32);
    wide.fill(Qt::red);
    QVERIFY(wide.save(folder.path(QStringLiteral("wide.png"))));
    folder.write(QStringLiteral("wide.tga"), tga(2, 65535, 65535, 24, 0, {}));
    folder.write(QStringLiteral("large.tga"), tga(2, 16384, 16384, 24, 0, {}));
    folder.write(QStringLiteral("short.tga"), tga(2, 4, 4, 24, 0, "123456789"));
    folder.write(QStringLiteral("odd.tga"), tga(7, 4, 4, 24, 0, {}));
    folder.write(QStringLiteral("none.tga"), tga(2, 0, 4, 24, 0, {}));
    if (!mtl.isNull())
        folder.write(QStringLiteral("scene.mtl"), mtl);
    const QString path =
        folder.write(QStringLiteral("scene.obj"), "mtllib scene.mtl\n" + kTriangle + "usemtl wood\nf 1 2 3\n");
    const SceneLoad load = loadObj(path);
    QVERIFY2(load.scene, qPrintable(textOf(load.diagnostics)));
    QCOMPARE(load.scene->mesh.faceCount(), std::size_t{1});
    QVERIFY(load.scene->textures.empty());
    verifyRemark(load.diagnostics, folder.path(place) + QStringLiteral(": warning: "), phrase);
}

void TestObjLoader::manyErrorsAreCounted()
{
    const Folder folder;
    QByteArray text = kTriangle;
    for (int i = 0; i < 57; ++i)
        text += "f 1 2 0\n";
    const QString path = folder.write(QStringLiteral("many.obj"), text);
    const SceneLoad load = loadObj(path);
    QVERIFY(!load.scene);
    QCOMPARE(load.diagnostics.size(), std::size_t{7});
    QCOMPARE(load.diagnostics.front().line, 4);
    QCOMPARE(load.diagnostics[4].line, 8);
    QCOMPARE(load.diagnostics[5].text(), path + QStringLiteral(": none of the 57 \"f\" statements can be drawn"));
    QCOMPARE(load.diagnostics.back().text(), path + QStringLiteral(": and 52 more remarks like that on line 4"));
}

void TestObjLoader::junkNeverCrashes()
{
    const unsigned seed = test::seedOfRun();
    std::mt19937 random(seed);
    const QByteArray good =
        "mtllib a.mtl\nv 0 0 0 1 1 1\nv 1 0 0\nv 1e0 1.0 -0\nv 0 1 0\nvt 0 0\nvt 1 1\nvn 0 0 1\nusemtl m\n"
        "f 1/1/1 2/2/1 3/1/1 \\\n 4//1 # end\nf -1 -2 -3\r\nl 1 2\n";
    const QByteArray mtl = "newmtl m\nKd .5 0.5 1\nNs 10\nmap_Kd -s 1 1 1 x.tga\nnewmtl n\nKs 1 1 1\n";
    const QByteArray image = tga(10, 3, 2, 24, 0x20,
                                 QByteArray("\x82"
                                            "abc"
                                            "\x02"
                                            "abcdefghi",
                                            14));
    const auto mutated = [&](QByteArray bytes) {
        for (int i = 0; i < 4; ++i) {
            const auto at = static_cast<qsizetype>(random() % static_cast<unsigned>(bytes.size()));
            switch (random() % 3) {
            case 0: bytes[at] = static_cast<char>(random()); break;
            case 1: bytes.remove(at, static_cast<qsizetype>(random() % 5)); break;
            default: bytes.insert(at, "/-1e9\\\n#. "[random() % 10]); break;
            }
            if (bytes.isEmpty())
                break;
        }
        return bytes;
    };
    const Folder folder;
    for (int i = 0; i < 500; ++i) {
        folder.write(QStringLiteral("a.mtl"), i % 3 == 1 ? mutated(mtl) : mtl);
        folder.write(QStringLiteral("x.tga"), i % 3 == 2 ? mutated(image) : image);
        const QString path = folder.write(QStringLiteral("a.obj"), i % 3 == 0 ? mutated(good) : good);
        const SceneLoad load = loadObj(path);
        QCOMPARE(load.scene.has_value(), !hasErrors(load.diagnostics));
        if (!load.scene)
            continue;
        for (const std::uint32_t index : load.scene->mesh.indices)
            QVERIFY(index < load.scene->mesh.vertices.size());
        for (const Material& material : load.scene->materials)
            QVERIFY(material.texture < static_cast<int>(load.scene->textures.size()));
    }
}

/// Hundreds of thousands of corners in no order: nearly every one is reflex or in the way.
void TestObjLoader::hugePolygonEndsInTime()
{
    QByteArray text = "v 0 0 0\nv 9 1 0\nv 1 9 0\nv 7 7 0\nv 3 2 0\nf";
    for (int i = 0; i < 300'000; ++i)
        text += i % 7 < 3 ? " 1 2" : " 5 3 4";
    const Folder folder;
    const SceneLoad load = loadObj(folder.write(QStringLiteral("huge.obj"), text));
    QVERIFY(load.scene);
    QVERIFY(load.scene->mesh.faceCount() > 600'000);
    QCOMPARE(load.scene->mesh.vertices.size(), std::size_t{5});
}

void TestObjLoader::lineEndsCommentsAndContinuation()
{
    const Folder folder;
    const SceneLoad plain = loadObj(folder.write(QStringLiteral("plain.obj"), kTriangle + "f 1 2 3\n"));
    QVERIFY(plain.scene);
    const QByteArray same[] = {
        "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n",
        "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3",
        "\xEF\xBB\xBFv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3",
        "# head\n\n  v 0 0 0 # origin\n\tv\t1 0 0\nv 0 \\\n 1 \\\r\n0\nf 1 2 3#end",
        "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n",
        kTriangle + "f -3 -2 -1\n",
        "v 0 0 0 1\nv 1 0 0 1\nv 0 1 0 1\no thing\ng part\ns off\nf 1 2 3\nl 0 77\np 1\nt x 1/1/1\nvw 1\n",
        "v .0 +0 0e5\nv 1. 0 0\nv 1e-60 10e-1 0\nf 1 2 3\n",
    };
    for (const QByteArray& text : same) {
        const SceneLoad load = loadObj(folder.write(QStringLiteral("same.obj"), text));
        QVERIFY2(load.scene && withoutNotes(load.diagnostics).empty(),
                 qPrintable(QString::fromUtf8(text) + textOf(load.diagnostics)));
        QCOMPARE(load.scene->mesh.indices, plain.scene->mesh.indices);
        QCOMPARE(load.scene->mesh.vertices.size(), std::size_t{3});
        for (std::size_t i = 0; i < 3; ++i)
            QVERIFY(load.scene->mesh.vertices[i].position == plain.scene->mesh.vertices[i].position);
    }
    const SceneLoad unknown =
        loadObj(folder.write(QStringLiteral("unknown.obj"), kTriangle + "frobnicate 1\nf 1 2 3\n"));
    QVERIFY(unknown.scene);
    verifyRemark(unknown.diagnostics, folder.path(QStringLiteral("unknown.obj:4: warning: ")),
                 QStringLiteral("\"frobnicate\""));
    verifyRemark(loadObj(folder.path()).diagnostics, folder.path() + QStringLiteral(": "),
                 QStringLiteral("this is a directory"));
    verifyRemark(loadObj(folder.path(QStringLiteral("no.obj"))).diagnostics, folder.path(QStringLiteral("no.obj: ")),
                 QStringLiteral("no such file"));
}

void TestObjLoader::cornersOfAllKinds()
{
    const Folder folder;
    const SceneLoad load = loadObj(folder.write(
        QStringLiteral("corners.obj"), kTriangle + "vt 0.25 0.5\nvt 0.75\nvn 0 0 2\nvn 0 3 0\nf 1/1/1 2/2/-1 -1//1\n"));
    QVERIFY(load.scene);
    const std::vector<MeshVertex>& v = load.scene->mesh.vertices;
    QCOMPARE(load.scene->mesh.indices, (std::vector<std::uint32_t>{0, 1, 2}));
    QVERIFY(v[0].uv == glm::vec2(0.25F, 0.5F) && v[1].uv == glm::vec2(0.75F, 0));
    QVERIFY(v[0].normal == glm::vec3(0, 0, 1) && v[1].normal == glm::vec3(0, 1, 0) &&
            v[2].normal == glm::vec3(0, 0, 1));
    QVERIFY(v[0].color == glm::vec3(0.8F, 0.7F, 0.6F));
    QVERIFY(load.scene->lit && load.scene->space == SceneSpace::Object);
    QCOMPARE(load.scene->title, QStringLiteral("corners"));
}

void TestObjLoader::convexPolygonIsAFan()
{
    const Folder folder;
    const SceneLoad load = loadObj(folder.write(
        QStringLiteral("fan.obj"), "v 0 0 0\nv 2 0 0\nv 3 2 0\nv 1 3 0\nv -1 1 0\nf 1 2 3 4 5\nf 4 1 3\n"));
    QVERIFY(load.scene);
    QCOMPARE(load.scene->mesh.indices, (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3, 0, 3, 4, 3, 0, 2}));
}

void TestObjLoader::vertexIsAPositionUvNormalMaterial()
{
    const Folder folder;
    folder.write(QStringLiteral("m.mtl"), "newmtl a\nKd 1 0 0\nnewmtl b\nKd 0 1 0\n");
    const SceneLoad load =
        loadObj(folder.write(QStringLiteral("m.obj"), "mtllib m.mtl\n" + kTriangle +
                                                          "v 1 1 0\nvt 0 0\nvt 1 1\nusemtl a\nf 1/1 2/1 3/1\nf 2/1 "
                                                          "4/1 3/1\nf 1/2 2/1 3/1\nusemtl b\nf 1/1 2/1 3/1\n"));
    QVERIFY(load.scene && load.diagnostics.empty());
    QCOMPARE(load.scene->mesh.indices, (std::vector<std::uint32_t>{0, 1, 2, 1, 3, 2, 4, 1, 2, 5, 6, 7}));
    QCOMPARE(load.scene->mesh.faceMaterial, (std::vector<std::uint32_t>{0, 0, 0, 1}));
    QCOMPARE(load.scene->materials.size(), std::size_t{2});
    QVERIFY(load.scene->mesh.vertices[0].color == glm::vec3(1, 0, 0));
    QVERIFY(load.scene->mesh.vertices[5].color == glm::vec3(0, 1, 0));
}

void TestObjLoader::generatedNormalsAreAreaWeighted()
{
    const Folder folder;
    // One triangle of area 0.5 facing z and one of area 1 facing x meet at the first vertex; the last face has no area.
    const SceneLoad load =
        loadObj(folder.write(QStringLiteral("n.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 2 0\nv 0 0 1\nv 5 5 5\n"
                                                      "v 6 6 6\nv 7 7 7\nf 1 2 3\nf 1 4 5\nf 6 7 8\n"));
    QVERIFY(load.scene);
    const glm::vec3 shared = load.scene->mesh.vertices[0].normal;
    QVERIFY(glm::length(shared - glm::normalize(glm::vec3(2, 0, 1))) < 1e-6F);
    QVERIFY(load.scene->mesh.vertices[1].normal == glm::vec3(0, 0, 1));
    QVERIFY(load.scene->mesh.vertices.back().normal == glm::vec3(0, 0, 1));

    // Two faces back to back cancel out: each takes the normal of its own face.
    const SceneLoad leaf = loadObj(folder.write(QStringLiteral("leaf.obj"), kTriangle + "f 1 2 3\nf 3 2 1\n"));
    QCOMPARE(leaf.scene->mesh.vertices.size(), std::size_t{6});
    QVERIFY(leaf.scene->mesh.vertices[0].normal == glm::vec3(0, 0, 1));
    QVERIFY(leaf.scene->mesh.vertices[3].normal == glm::vec3(0, 0, -1));
}

void TestObjLoader::missingUvIsPlanar()
{
    const Folder folder;
    const SceneLoad load = loadObj(folder.write(QStringLiteral("uv.obj"), "v -3 0 0\nv 5 0 0\nv 1 4 0\nf 1 2 3\n"));
    QVERIFY(load.scene);
    const BoundingSphere& bounds = load.scene->bounds;
    QVERIFY(bounds.center == glm::dvec3(1, 2, 0));
    QCOMPARE(bounds.radius, std::sqrt(20.0));
    QCOMPARE(load.scene->mesh.vertices[0].uv.x, static_cast<float>(-4 / (2 * bounds.radius) + 0.5));
    QCOMPARE(load.scene->mesh.vertices[2].uv.y, static_cast<float>(2 / (2 * bounds.radius) + 0.5));
    const SceneLoad point = loadObj(folder.write(QStringLiteral("point.obj"), "v 7 7 7\nv 7 7 7\nv 7 7 7\nf 1 2 3\n"));
    QCOMPARE(point.scene->bounds.radius, 1.0);
    QVERIFY(point.scene->mesh.vertices[0].uv == glm::vec2(0.5F));
}

void TestObjLoader::vertexColors()
{
    const Folder folder;
    folder.write(QStringLiteral("c.mtl"), "newmtl half\nKd 0.5 0.5 1\nnewmtl bare\n");
    const QByteArray colored = "v 0 0 0\nv 1 0 0 1 0.5 0\nv 0 1 0 0.25 1 1 0.5\n";
    const SceneLoad plain = loadObj(folder.write(QStringLiteral("plain.obj"), colored + "f 1 2 3\n"));
    QVERIFY(plain.scene);
    QVERIFY(plain.scene->mesh.vertices[0].color == glm::vec3(1));
    QVERIFY(plain.scene->mesh.vertices[1].color == glm::vec3(1, 0.5F, 0));
    QVERIFY(plain.scene->mesh.vertices[2].color == glm::vec3(0.25F, 1, 1));
    const SceneLoad times = loadObj(folder.write(
        QStringLiteral("times.obj"), "mtllib c.mtl\n" + colored + "usemtl half\nf 1 2 3\nusemtl bare\nf 1 2 3\n"));
    QVERIFY(times.scene);
    QVERIFY(times.scene->mesh.vertices[1].color == glm::vec3(0.5F, 0.25F, 0));
    QVERIFY(times.scene->mesh.vertices[4].color == glm::vec3(1, 0.5F, 0));
}

void TestObjLoader::materials()
{
    const Folder folder;
    folder.write(QStringLiteral("m.mtl"),
                 "# three\nnewmtl red paint\nKd 1 0 0\nKs 0.5 0.5 0.5\nNs 90\nd 1\nillum 2\n\nnewmtl bare\nnewmtl red "
                 "paint\nKd 0 0 1\n");
    const SceneLoad load = loadObj(folder.write(
        QStringLiteral("m.obj"),
        "mtllib m.mtl\n" + kTriangle +
            "f 1 2 3\nusemtl bare\nusemtl red paint\nf 1 2 3\nusemtl bare\nf 1 2 3\nusemtl red paint\nf 1 2 3\n"));
    QVERIFY(load.scene);
    const std::vector<Diagnostic> warnings = withoutNotes(load.diagnostics);
    QVERIFY2(warnings.size() == 1 && warnings[0].line == 10, qPrintable(textOf(load.diagnostics))); // "red paint" again
    const std::vector<Material>& m = load.scene->materials;
    QCOMPARE(m.size(), std::size_t{3});
    QCOMPARE(load.scene->mesh.faceMaterial, (std::vector<std::uint32_t>{0, 1, 2, 1}));
    QVERIFY(m[0].name.isEmpty() && m[0].diffuse == glm::vec3(0.8F, 0.7F, 0.6F));
    QVERIFY(m[1].name == QLatin1String("red paint") && m[1].diffuse == glm::vec3(1, 0, 0));
    QVERIFY(m[1].specular == glm::vec3(0.5F) && m[1].shininess == 90 && m[1].texture == -1);
    QVERIFY(m[2].diffuse == glm::vec3(0.8F, 0.7F, 0.6F) && m[2].shininess == 32);
}

void TestObjLoader::textureLiesWithRowZeroAtTheBottom()
{
    const Folder folder;
    QImage image(2, 3, QImage::Format_ARGB32);
    image.fill(Qt::black);
    image.setPixel(0, 0, qRgb(10, 20, 30));
    image.setPixel(1, 2, qRgba(200, 100, 50, 255));
    QVERIFY(image.save(folder.path(QStringLiteral("t.png"))));
    QVERIFY(image.save(folder.path(QStringLiteral("t.jpg"))));
    folder.write(
        QStringLiteral("t.mtl"),
        "newmtl p\nmap_Kd t.png\nnewmtl j\nKd 0.5 0.5 0.5\nmap_Kd -clamp on t.jpg\nnewmtl again\nmap_Kd t.png\n");
    const SceneLoad load = loadObj(
        folder.write(QStringLiteral("t.obj"),
                     "mtllib t.mtl\n" + kTriangle + "usemtl p\nf 1 2 3\nusemtl j\nf 1 2 3\nusemtl again\nf 1 2 3\n"));
    QVERIFY2(load.scene && load.diagnostics.empty(), qPrintable(textOf(load.diagnostics)));
    QCOMPARE(load.scene->textures.size(), std::size_t{2});
    const Texture& t = load.scene->textures[0];
    QCOMPARE(t.name, QStringLiteral("t.png"));
    QCOMPARE(t.width, 2);
    QCOMPARE(t.height, 3);
    QCOMPARE(t.texels[1], 0xffc86432U);
    QCOMPARE(t.texels[4], 0xff0a141eU);
    QVERIFY(load.scene->materials[0].diffuse == glm::vec3(1) && load.scene->materials[0].texture == 0);
    QVERIFY(load.scene->materials[1].diffuse == glm::vec3(0.5F) && load.scene->materials[1].texture == 1);
    QCOMPARE(load.scene->materials[2].texture, 0);
}

void TestObjLoader::tgaOfAllKinds()
{
    const QByteArray blueThenRed("\xff\0\0\0\0\xff", 6);
    QByteArray palette = tga(1, 2, 1, 8, 0, QByteArray("\xff\0\0\0\0\xff\0\1", 8));
    palette[1] = 1;
    palette[5] = 2;
    palette[7] = 24;
    const QByteArray packed = tga(10, 2, 2, 24, 0, QByteArray("\0\xff\0\0\x82\0\0\xff", 8));
    const std::vector<std::pair<QByteArray, std::vector<std::uint32_t>>> kinds = {
        {tga(2, 2, 1, 24, 0, blueThenRed), {0xff0000ff, 0xffff0000}},
        {tga(2, 2, 1, 24, 0x10, blueThenRed), {0xffff0000, 0xff0000ff}},
        {tga(2, 1, 2, 24, 0, blueThenRed), {0xff0000ff, 0xffff0000}},
        {tga(2, 1, 2, 24, 0x20, blueThenRed), {0xffff0000, 0xff0000ff}},
        {tga(2, 1, 1, 32, 8, QByteArray("\x10\x20\x30\x40", 4)), {0xff302010}},
        {tga(2, 2, 1, 16, 0, QByteArray("\x1f\0\0\x7c", 4)), {0xff0000ff, 0xffff0000}},
        {tga(3, 2, 1, 8, 0, QByteArray("\x07\xf0", 2)), {0xff070707, 0xfff0f0f0}},
        {tga(11, 2, 1, 8, 0, QByteArray("\x81\x55", 2)), {0xff555555, 0xff555555}},
        {palette, {0xff0000ff, 0xffff0000}},
        {packed, {0xff0000ff, 0xffff0000, 0xffff0000, 0xffff0000}},
    };
    const Folder folder;
    const QString obj = folder.write(QStringLiteral("a.obj"), kTriangle + "f 1 2 3\n");
    for (const auto& [bytes, texels] : kinds) {
        const SceneLoad load = loadObj(obj, withTexture(folder.write(QStringLiteral("a.TGA"), bytes)));
        QVERIFY2(load.scene, qPrintable(textOf(load.diagnostics)));
        QCOMPARE(load.scene->textures[0].texels, texels);
    }
}

void TestObjLoader::textureOptionReplacesTextures()
{
    const Folder folder;
    const QString white = folder.write(QStringLiteral("white.tga"), tga(3, 1, 1, 8, 0, "\xff"));
    folder.write(QStringLiteral("t.mtl"), "newmtl a\nmap_Kd missing.png\nnewmtl b\nKd 0 1 0\n");
    const QString path = folder.write(QStringLiteral("t.obj"),
                                      "mtllib t.mtl\n" + kTriangle + "f 1 2 3\nusemtl a\nf 1 2 3\nusemtl b\nf 1 2 3\n");
    const SceneLoad load = loadObj(path, withTexture(white));
    QVERIFY2(load.scene && load.diagnostics.empty(), qPrintable(textOf(load.diagnostics)));
    QCOMPARE(load.scene->textures.size(), std::size_t{1});
    QCOMPARE(load.scene->materials.size(), std::size_t{3});
    for (const Material& material : load.scene->materials)
        QCOMPARE(material.texture, 0);
    QVERIFY(load.scene->mesh.vertices[0].color == glm::vec3(1) &&
            load.scene->mesh.vertices[6].color == glm::vec3(0, 1, 0));
    const SceneLoad none = loadObj(path, withTexture(folder.path(QStringLiteral("none.png"))));
    QVERIFY(!none.scene);
    verifyRemark(none.diagnostics, folder.path(QStringLiteral("none.png: ")), QStringLiteral("no such file"));
}

void TestObjLoader::fileNamesWithBlanksAndBackslashes()
{
    const Folder folder;
    QVERIFY(QDir(folder.path()).mkpath(QStringLiteral("sub dir")));
    folder.write(QStringLiteral("sub dir/my image.tga"), tga(3, 1, 1, 8, 0, "\x11"));
    folder.write(QStringLiteral("sub dir/the mtl.mtl"), "newmtl a\r\nmap_Kd C:\\elsewhere\\my image.tga  \r\n");
    folder.write(QStringLiteral("one.mtl"), "newmtl b\nmap_Kd sub dir\\my image.tga");
    for (const QByteArray library :
         {"mtllib sub dir\\the mtl.mtl\nusemtl a\n", "mtllib none.mtl one.mtl\nusemtl b\n"}) {
        const SceneLoad load = loadObj(folder.write(QStringLiteral("s.obj"), library + kTriangle + "f 1 2 3\n"));
        QVERIFY(load.scene);
        QCOMPARE(load.scene->textures.size(), std::size_t{1});
        QCOMPARE(load.scene->textures[0].texels[0], 0xff111111U);
    }
}

void TestObjLoader::anyLocale()
{
    if (!std::setlocale(LC_ALL, "de_DE.UTF-8") && !std::setlocale(LC_ALL, "de_DE.utf8"))
        QSKIP("no locale with a decimal comma is installed");
    const Folder folder;
    const SceneLoad load =
        loadObj(folder.write(QStringLiteral("l.obj"), "v 0.5 0 0\nv 1.25 0 0\nv 0 1.5 0\nf 1 2 3\n"));
    std::setlocale(LC_ALL, "C");
    QVERIFY(load.scene);
    QCOMPARE(load.scene->mesh.vertices[1].position.x, 1.25F);
}

void TestObjLoader::peerMeshOfAFile()
{
    const Folder folder;
    const SceneLoad load =
        loadObj(folder.write(QStringLiteral("p.obj"), "mtllib none.mtl\nv 9 9 9\nv 0 0 0\nv 4 0 0\nv 4 4 0\nv 2 1 "
                                                      "0\nvt 0.5 0.25\nvn 1 0 0\nf 2//1 3//1 4/1/1 5//1\n"),
                kPeerMesh);
    QVERIFY(load.scene && load.diagnostics.empty());
    QCOMPARE(load.scene->mesh.indices, (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}));
    QVERIFY(load.scene->bounds.center == glm::dvec3(4.5));
    QVERIFY(load.scene->mesh.vertices[2].uv == glm::vec2(0.5F, 0.25F));
    QVERIFY(load.scene->mesh.vertices[0].normal == glm::vec3(0, 0, 1));
    QVERIFY(load.scene->mesh.vertices[0].color == glm::vec3(0.8F, 0.7F, 0.6F));
}

void TestObjLoader::peerMeshIsThePeersBitForBit()
{
#ifdef RASTERLENS_PEER_SCENES
    for (const char* name : {"suzanne", "spot", "teapot", "stanford-bunny", "nefertiti", "african_head/african_head"}) {
        const QString path = QStringLiteral(RASTERLENS_SHARED "/models/%1.obj").arg(QLatin1String(name));
        ps::Mesh peer;
        ps::Sphere sphere;
        QVERIFY2(ps::load_obj(path.toUtf8().constData(), peer, sphere), name);
        const SceneLoad load = loadObj(path, kPeerMesh);
        QVERIFY(load.scene);
        const Mesh& mesh = load.scene->mesh;
        QCOMPARE(mesh.indices, peer.idx);
        QCOMPARE(mesh.vertices.size(), peer.v.size());
        for (std::size_t i = 0; i < peer.v.size(); ++i) {
            QVERIFY(std::memcmp(&mesh.vertices[i].position, peer.v[i].p, sizeof peer.v[i].p) == 0);
            QVERIFY(std::memcmp(&mesh.vertices[i].normal, peer.v[i].n, sizeof peer.v[i].n) == 0);
            QVERIFY(std::memcmp(&mesh.vertices[i].uv, peer.v[i].uv, sizeof peer.v[i].uv) == 0);
        }
        QVERIFY(load.scene->bounds.center == glm::dvec3(sphere.c[0], sphere.c[1], sphere.c[2]));
        QVERIFY(load.scene->bounds.radius == sphere.r);
    }
#else
    QSKIP("the peer harness (" RASTERLENS_SHARED "/peers/scene.hpp) is not there");
#endif
}

void TestObjLoader::sharedModels()
{
    const QString folder = QStringLiteral(RASTERLENS_SHARED "/models/");
    if (!QFile::exists(folder))
        QSKIP("the shared models (" RASTERLENS_SHARED "/models) are not there");
    const std::vector<std::pair<QString, std::size_t>> faces = {
        {QStringLiteral("stanford-bunny.obj"), 69451},
        {QStringLiteral("nefertiti.obj"), 99938},
        {QStringLiteral("spot.obj"), 5856},
        {QStringLiteral("suzanne.obj"), 968},
        {QStringLiteral("african_head/african_head_textured.obj"), 2492}};
    for (const auto& [name, count] : faces) {
        const SceneLoad load = loadObj(folder + name);
        QVERIFY2(load.scene && withoutNotes(load.diagnostics).empty(), qPrintable(textOf(load.diagnostics)));
        QCOMPARE(load.scene->mesh.faceCount(), count);
        for (const MeshVertex& vertex : load.scene->mesh.vertices)
            QVERIFY(std::abs(glm::length(vertex.normal) - 1) < 1e-5F);
    }
    const SceneLoad head = loadObj(folder + faces.back().first);
    QCOMPARE(head.scene->textures.size(), std::size_t{1});
    QCOMPARE(head.scene->textures[0].width, 1024);
    QCOMPARE(head.scene->textures[0].texels[0], 0xff584537U);
}

QTEST_GUILESS_MAIN(TestObjLoader)
#include "test_obj_loader.moc"
