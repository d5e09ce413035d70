// OBJ and MTL files as programs really write them: what each kind becomes, and what is said about it.
#include "core/io/file_names.h"
#include "core/io/obj_loader.h"
#include "scene_files.h"

#include <QDir>
#include <QSet>

#include <cmath>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

const QByteArray kSquare = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n";
const QByteArray kUvs = "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";
const QByteArray kCube = "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n";
const QByteArray kCubeFaces = "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

int countOf(const Diagnostics& diagnostics, Severity severity)
{
    return static_cast<int>(std::count_if(diagnostics.begin(), diagnostics.end(),
                                          [&](const Diagnostic& d) { return d.severity == severity; }));
}

/// The area of a mesh in the plane z = 0, each triangle counted as positive.
double areaOf(const Mesh& mesh)
{
    double sum = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto at = [&](std::size_t corner) {
            return glm::dvec3(mesh.vertices[mesh.indices[i + corner]].position);
        };
        sum += 0.5 * glm::length(glm::cross(at(1) - at(0), at(2) - at(0)));
    }
    return sum;
}

/// Different normals among the corners of the mesh: 6 for a flat cube, 8 for a rounded one.
int normalsOf(const Mesh& mesh)
{
    QSet<QString> different;
    for (const MeshVertex& v : mesh.vertices)
        different << QStringLiteral("%1 %2 %3")
                         .arg(std::lround(99 * v.normal.x))
                         .arg(std::lround(99 * v.normal.y))
                         .arg(std::lround(99 * v.normal.z));
    return static_cast<int>(different.size());
}

} // namespace

class TestObjRealFiles : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void geometry_data();
    void geometry();
    void smoothing_data();
    void smoothing();
    void vertexColors_data();
    void vertexColors();
    void materialNames_data();
    void materialNames();
    void libraryNames_data();
    void libraryNames();
    void materialsStandForThemselves();
    void unusedStatementsAreNamed();
    void blenderIsRemarkedOn();
    void textInUtf16();
    void linesOfFaces();
    void fileNameInAnotherEncoding();
};

/// Columns: the text, how many triangles it becomes, how many warnings, and words of the first one.
void TestObjRealFiles::geometry_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<int>("faces");
    QTest::addColumn<QString>("phrase");
    const auto row = [](const char* name, const QByteArray& text, int faces, const char* phrase) {
        QTest::newRow(name) << text << faces << QString::fromLatin1(phrase);
    };
    // A corner with empty parts, in any place.
    row("slash: position and two", kSquare + "f 1// 2// 3// 4//\n", 2, "");
    row("slash: position and one", kSquare + "f 1/ 2/ 3/ 4/\n", 2, "");
    row("slash: uv and one", kSquare + kUvs + "f 1/1/ 2/2/ 3/3/ 4/4/\n", 2, "");
    row("slash: mixed in one face", kSquare + kUvs + "vn 0 0 1\nf 1//1 2/2 3/3/1 4\n", 2, "");
    row("slash: backwards", kSquare + "f -4// -3// -2// -1//\n", 2, "");
    row("slash: behind tabs", kSquare + "f\t1//\t2//\t3//\t4//\t\n", 2, "");
    row("slash: before a comment", kSquare + "f 1// 2// 3// 4// # quad\n", 2, "");
    row("slash: CRLF", kSquare + "f 1// 2// 3//\r\nf 1/ 3/ 4/\r\n", 2, "");
    row("slash: no position", kSquare + kUvs + "f /1 /2 /3\nf 1 2 3\n", 1, "\"/1\" is not a corner");
    row("slash: four parts", kSquare + "f 1/// 2 3\nf 1 2 3\n", 1, "\"1///\" is not a corner");
    row("slash: continued line", kSquare + "f 1// 2// \\\n 3// 4//\n", 2, "");
    // One number that is not finite.
    row("nan: normal", kSquare + "vn nan nan nan\nf 1//1 2//1 3//1 4//1\n", 2, "vn: \"nan\" is not finite");
    row("nan: as Visual C++ prints it", kSquare + "vn -1.#IND 0 1\nf 1//1 2//1 3//1\n", 1, "\"-1.#IND\" is not finite");
    row("nan: 1.#QNAN", kSquare + "vt 1.#QNAN 0\nf 1/1 2/1 3/1\n", 1, "\"1.#QNAN\" is not finite");
    row("nan: 1.#INF00", kSquare + "vt 0 1.#INF00\nf 1/1 2/1 3/1\n", 1, "\"1.#INF00\" is not finite");
    row("nan: -nan(ind)", kSquare + "vn -nan(ind) 0 0\nf 1//1 2//1 3//1\n", 1, "\"-nan(ind)\" is not finite");
    row("nan: NaN as JavaScript prints it", kSquare + "vn NaN NaN NaN\nf 1//1 2//1 3//1\n", 1, "\"NaN\" is not finite");
    row("nan: Infinity", kSquare + "vt Infinity 0\nf 1/1 2/1 3/1\n", 1, "\"Infinity\" is not finite");
    row("nan: undefined", kSquare + "vn undefined 0 0\nf 1//1 2//1 3//1\n", 1, "\"undefined\" is not a number");
    row("nan: vertex nobody uses", "v nan 0 0\n" + kSquare + "f 2 3 4 5\n", 2, "v: \"nan\" is not finite");
    row("nan: vertex of one face", kSquare + "v 1e40 0 0\nf 1 2 3 4\nf 1 2 5\n", 2, "beyond the range of float32");
    row("nan: third uv", kSquare + "vt 0 0 nan\nf 1/1 2/1 3/1\n", 1, "vt: \"nan\" is not finite");
    // Faces of too few corners, repeated ones.
    row("corners: none", kSquare + "f\nf 1 2 3 4\n", 2, "f: 0 corners");
    row("corners: one", kSquare + "f 1 2 3 4\nf 1\n", 2, "f: 1 corners");
    row("corners: two", kSquare + "f 1 2\nf 1 2 3 4\n", 2, "f: 2 corners");
    row("corners: the same thrice", kSquare + "f 1 1 1\nf 1 2 3 4\n", 2, "only 1 of 3 corners");
    row("corners: two different", kSquare + "f 1 2 1\nf 1 2 3 4\n", 2, "only 2 of 3 corners");
    row("corners: a quad that is a triangle", kSquare + "f 1 2 3 3\n", 1, "1 repeated corners are left out");
    row("corners: closed outline", kSquare + "f 1 2 3 4 1\n", 2, "1 repeated corners are left out");
    row("corners: repeated in the middle", kSquare + "f 1 2 2 3 4\n", 2, "1 repeated corners");
    row("corners: only a comment", kSquare + "f # empty\nf 1 2 3\n", 1, "f: 0 corners");
    row("corners: a word", kSquare + "f null\nf 1 2 3\n", 1, "\"null\" is not a corner");
    // One bad index or number.
    row("index: normal zero", kSquare + "vn 0 0 1\nf 1//0 2//1 3//1 4//1\n", 2, "vn index 0 is out of range");
    row("index: uv zero", kSquare + kUvs + "f 1/0 2/2 3/3\n", 1, "vt index 0");
    row("index: normal beyond", kSquare + "vn 0 0 1\nf 1//1 2//2 3//1\n", 1,
        "vn index 2 is out of range; the file has 1");
    row("index: uv beyond", kSquare + "f 1/1 2/2 3/3\n", 1, "vt index 1 is out of range; the file has 0");
    row("index: position beyond", kSquare + "f 1 2 9\nf 1 2 3 4\n", 2, "v index 9 is out of range; the file has 4");
    row("index: position zero", kSquare + "f 0 1 2\nf 1 2 3 4\n", 2, "v index 0 is out of range; indices count from 1");
    row("index: backwards too far", kSquare + "f -1 -2 -5\nf 1 2 3\n", 1, "v index -5 is out of range");
    row("index: beyond int", kSquare + "f 1 2 4294967297\nf 1 2 3\n", 1, "v index 4294967297");
    row("index: minus one as none", kSquare + kUvs + "f 1/1/-1 2/2/-1 3/3/-1\n", 1, "vn index -1 is out of range");
    row("surplus: v", kSquare + "v 0 0 0 1 1\nf 1 2 3 4\n", 2, "v: 5 numbers");
    row("surplus: eight of v", "v 0 0 0 1 1 1 1 1\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", 1, "v: 8 numbers");
    row("surplus: vt", kSquare + "vt 0 0 0 0\nf 1/1 2/1 3/1\n", 1, "vt: 4 numbers; 1 to 3 expected");
    row("surplus: vn", kSquare + "vn 0 0 1 0\nf 1//1 2//1 3//1\n", 1, "vn: 4 numbers; 3 expected");
    row("missing: v", kSquare + "v 1 2\nf 1 2 3 4\nf 1 2 5\n", 2, "v: 2 numbers; 3 to 7 expected");
    row("missing: vn", kSquare + "vn 0 1\nf 1//1 2//1 3//1\n", 1, "vn: 2 numbers");
    row("weight", "v -1 -1 0 2\nv 1 -1 0 1\nv 1 1 0 1.0\nf 1 2 3\n", 1, "a weight other than 1 is ignored");
    row("zero bytes at the end", kSquare + "f 1 2 3 4\n" + QByteArray(600, '\0'), 2, "binary data (a zero byte)");
    row("a line of junk", kSquare + "<!-- saved -->\nf 1 2 3 4\n", 2, "\"<!--\" is not a statement");
    // Comments and lines that go on.
    row("backslash: folder in a comment", "# from D:\\models\\\n" + kSquare + "f 1 2 3 4\n", 2, "");
    row("backslash: behind numbers", "v -1 -1 0 # C:\\\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n", 2, "");
    row("backslash: group", kSquare + "g C:\\parts\\\nf 1 2 3 4\n", 2, "");
    row("backslash: object", kSquare + "o D:\\\nf 1 2 3 4\n", 2, "");
    row("backslash: joins corners", kSquare + "f 1 2\\\n3 4\n", 2, "");
    row("backslash: joins with blanks", kSquare + "f 1 2 \\\n  3 4\n", 2, "");
    row("backslash: twice", kSquare + "f 1 \\\n2 \\\n3 4\n", 2, "");
    row("backslash: CRLF", kSquare + "f 1 2\\\r\n3 4\r\n", 2, "");
    row("backslash: a number", "v -1 -1 \\\n0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n", 2, "");
    row("backslash: empty comment", "#\\\n" + kSquare + "f 1 2 3 4\n", 2, "");
    row("backslash: at the end", kSquare + "f 1 2 3 4\n# \\", 2, "");
    row("comment behind a face", kSquare + "f 1 2 3 4#quad\n", 2, "");
    // How programs lay their files out.
    row("layout: assimp",
        "# File produced by a library\n\nmtllib \n" + kSquare + "\n# Mesh '' with 1 faces\ng \nusemtl \nf  1 2 3 4\n",
        2, "takes a name");
    row("layout: three.js", "o plane\n" + kSquare + kUvs + "vn 0 0 1\nf 1/1/1 2/2/1 3/3/1\nf 1/1/1 3/3/1 4/4/1\n", 2,
        "");
    row("layout: OpenSCAD", "# exporter\n" + kSquare + "\nf 1 2 3 \nf 3 4 1 \n", 2, "");
    row("layout: gmsh", kSquare + "l 1 2\nl 2 3\np 1\nf 1 2 3\nf 1 3 4\n", 2, "not drawn: l (2), p (1)");
    row("layout: VTK", "# a toolkit\n\nmtllib NONE\n" + kSquare + kUvs + "g grp\nusemtl NONE\nf 1/1 2/2 3/3 4/4 \n", 2,
        "mtllib");
    row("layout: Blender", "o Plane\n" + kSquare + "s 0\nf 1 2 3 4\ng\n", 2, "");
    row("layout: 3ds Max",
        "v  -1.0000 -1.0000 0.0000\r\nv  1.0 -1.0 0.0\r\nv  1.0 1.0 -0.0\r\n# 3 vertices\r\n\r\ng Box\r\n"
        "s 2\r\nf 1 2 3 \r\n# 1 faces\r\n",
        1, "");
    row("layout: MeshLab",
        "####\n#\nvn 0 0 1\n" + kSquare.left(10) + "vn 0 0 1\nv 1 -1 0\nvn 0 0 1\nv 1 1 0\nf 1//1 2//2 3//3\n\n", 1,
        "");
    row("layout: Rhino",
        "cstype bspline\ndeg 1 1\nsurf 0 1 0 1 1 2 3 4\nparm u 0 0 1 1\nend\n" + kSquare + "f 1 2 3 4\n", 2,
        "not drawn: surf (1)");
    row("layout: PowerShell's UTF-8", "\xEF\xBB\xBF" + kSquare + "f 1 2 3 4\n", 2, "");
    row("layout: Mac", QByteArray(kSquare + "f 1 2 3 4\n").replace('\n', '\r'), 2, "");
    row("layout: capitals", QByteArray(kSquare + "F 1 2 3 4\n").toUpper(), 2, "");
    row("layout: fo", kSquare + "fo 1 2 3 4\n", 2, "");
    row("layout: faces first", "f 1 2 3 4\n" + kSquare, 2, "");
    row("layout: no last line end", kSquare + "f 1 2 3 4", 2, "");
    // Polygons that are not convex.
    row("outline: dart", "v 0 0 0\nv 4 0 0\nv 1 1 0\nv 0 4 0\nf 1 2 3 4\n", 2, "");
    row("outline: bow tie", "v 0 0 0\nv 2 2 0\nv 2 0 0\nv 0 2 0\nf 1 2 3 4\n", 2,
        "the outline of 4 corners crosses itself");
    row("outline: ring with a bridge",
        "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 1 1 0\nv 1 3 0\nv 3 3 0\nv 3 1 0\n"
        "f 1 2 3 4 1 5 6 7 8 5\n",
        8, "");
}

void TestObjRealFiles::geometry()
{
    QFETCH(QByteArray, text);
    QFETCH(int, faces);
    QFETCH(QString, phrase);
    const Folder folder;
    const QString path = folder.write(QStringLiteral("file.obj"), text);
    const SceneLoad load = loadObj(path);
    QVERIFY2(load.scene, qPrintable(textOf(load.diagnostics)));
    QCOMPARE(static_cast<int>(load.scene->mesh.faceCount()), faces);
    if (phrase.isEmpty())
        QVERIFY2(load.diagnostics.empty(), qPrintable(textOf(load.diagnostics)));
    else
        verifyRemark(load.diagnostics, path + QStringLiteral(":"), phrase);
    for (const MeshVertex& vertex : load.scene->mesh.vertices) {
        QVERIFY(std::isfinite(vertex.position.x + vertex.position.y + vertex.position.z));
        QVERIFY(std::isfinite(vertex.uv.x + vertex.uv.y));
        QVERIFY(std::abs(glm::length(vertex.normal) - 1) < 1e-5F);
    }
    const QByteArray name = QTest::currentDataTag();
    if (name.startsWith("outline: ring"))
        QCOMPARE(areaOf(load.scene->mesh), 12.0);
    else if (!name.startsWith("outline") && faces == 2)
        QCOMPARE(areaOf(load.scene->mesh), 4.0);
    SceneLoad peer = loadObj(path, {true, {1920, 1080}, {}});
    QVERIFY(peer.scene);
    QCOMPARE(static_cast<int>(peer.scene->mesh.faceCount()), faces);
}

void TestObjRealFiles::smoothing_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<int>("normals");
    const auto row = [](const char* name, const QByteArray& before, const QByteArray& faces, int normals) {
        QTest::newRow(name) << QByteArray(kCube + before + faces) << normals;
    };
    const QByteArray halves = QByteArray(kCubeFaces).replace("f 1 2 6 5", "s 2\nf 1 2 6 5");
    row("no statement", "", kCubeFaces, 8);
    row("s 1", "s 1\n", kCubeFaces, 8);
    row("s on", "s on\n", kCubeFaces, 8);
    row("s off", "s off\n", kCubeFaces, 6);
    row("s 0", "s 0\n", kCubeFaces, 6);
    row("s 0 of a CRLF file", "s 0\r\n", QByteArray(kCubeFaces).replace('\n', "\r\n"), 6);
    row("S OFF in capitals", "S off\n", kCubeFaces, 6);
    row("a group a face", "",
        QByteArray(kCubeFaces)
            .replace("f ", "s 7\nf ")
            .replace("s 7\nf 1 4", "s 1\nf 1 4")
            .replace("s 7\nf 5", "s 2\nf 5")
            .replace("s 7\nf 1 2", "s 3\nf 1 2")
            .replace("s 7\nf 2", "s 4\nf 2")
            .replace("s 7\nf 3", "s 5\nf 3"),
        6);
    row("caps apart from sides", "s 1\n", halves, 10); // two of the caps, and one at each corner of the sides
    row("off, then on", "s off\n", halves, 10);
    row("large numbers", "s 4000000\n", kCubeFaces, 8);
    row("the same group again", "s 3\n", QByteArray(kCubeFaces).replace("f 1 2 6 5", "s 0\ns 3\nf 1 2 6 5"), 8);
}

void TestObjRealFiles::smoothing()
{
    QFETCH(QByteArray, text);
    QFETCH(int, normals);
    const Folder folder;
    const SceneLoad load = loadObj(folder.write(QStringLiteral("cube.obj"), text));
    QVERIFY2(load.scene && load.diagnostics.empty(), qPrintable(textOf(load.diagnostics)));
    QCOMPARE(load.scene->mesh.faceCount(), std::size_t{12});
    QCOMPARE(normalsOf(load.scene->mesh), normals);
}

void TestObjRealFiles::vertexColors_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("color"); // of the first vertex, in bytes
    QTest::addColumn<QString>("phrase");
    const auto row = [](const char* name, const QByteArray& text, const char* color, const char* phrase) {
        QTest::newRow(name) << QByteArray(text + "f 1 2 3\n") << QString::fromLatin1(color)
                            << QString::fromLatin1(phrase);
    };
    row("0 to 1", "v 0 0 0 1 0.5 0\nv 1 0 0 0 0 0\nv 0 1 0 0 0 0\n", "255 128 0", "");
    row("bytes", "v 0 0 0 255 128 64\nv 1 0 0 0 0 0\nv 0 1 0 0 0 0\n", "255 128 64", "all are divided by 255");
    row("bytes as reals", "v 0 0 0 255.0 128.0 0.0\nv 1 0 0 0 0 0\nv 0 1 0 0 0 0\n", "255 128 0", "divided by 255");
    row("means of bytes", "v 0 0 0 127.5 10 0\nv 1 0 0 0 0 0\nv 0 1 0 0 0 0\n", "128 10 0", "divided by 255");
    row("dark bytes", "v 0 0 0 3 2 0\nv 1 0 0 0 0 0\nv 0 1 0 1 0 0\n", "3 2 0", "colours up to 3");
    row("two bytes", "v 0 0 0 65535 32768 0\nv 1 0 0 0 0 0\nv 0 1 0 0 0 0\n", "255 128 0", "divided by 65535");
    row("a little bright", "v 0 0 0 1.02 0.5 0\nv 1 0 0 0 0 0\nv 0 1 0 0 0 0\n", "255 128 0", "shown as 1");
    row("bytes and alpha", "v 0 0 0 255 128 0 255\nv 1 0 0 0 0 0 255\nv 0 1 0 0 0 0 255\n", "255 128 0",
        "divided by 255");
    row("only some have one", "v 0 0 0\nv 1 0 0 255 0 0\nv 0 1 0\n", "255 255 255", "divided by 255");
    row("a bad colour", "v 0 0 0 nan 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\n", "255 255 255", "\"nan\" is not finite");
    row("comments", "v 0 0 0\nv 1 0 0\nv 0 1 0\n#MRGB ffff8040ff000000ff0000ff\n", "255 128 64", "");
    row("too few in comments", "v 0 0 0\nv 1 0 0\nv 0 1 0\n#MRGB ff102030\n", "16 32 48", "1 colours for 3");
}

void TestObjRealFiles::vertexColors()
{
    QFETCH(QByteArray, text);
    QFETCH(QString, color);
    QFETCH(QString, phrase);
    const Folder folder;
    const SceneLoad load = loadObj(folder.write(QStringLiteral("c.obj"), text));
    QVERIFY2(load.scene, qPrintable(textOf(load.diagnostics)));
    QCOMPARE(countOf(load.diagnostics, Severity::Warning), phrase.isEmpty() ? 0 : 1);
    if (!phrase.isEmpty())
        verifyRemark(load.diagnostics, folder.path(QStringLiteral("c.obj")), phrase);
    const glm::vec3 c = load.scene->mesh.vertices[0].color;
    const auto byte = [](float channel) { return std::min(255L, std::lround(255 * channel)); };
    QCOMPARE(QStringLiteral("%1 %2 %3").arg(byte(c.r)).arg(byte(c.g)).arg(byte(c.b)), color);
}

void TestObjRealFiles::materialNames_data()
{
    QTest::addColumn<QByteArray>("used");
    QTest::addColumn<QByteArray>("mtl");
    const auto row = [](const char* name, const QByteArray& used, const QByteArray& mtl) {
        QTest::newRow(name) << used << mtl;
    };
    const QByteArray red = "\nKd 1 0 0\n";
    const QByteArray blue = "\nKd 0 0 1\n";
    const auto both = [&](const QByteArray& wanted, const QByteArray& other) {
        return QByteArray("newmtl " + other + blue + "newmtl " + wanted + red);
    };
    row("a number sign", "Wall #7", both("Wall #7", "Wall"));
    row("a number sign first", "#7", both("#7", "7"));
    row("a number sign within", "a#b", both("a#b", "a"));
    row("two number signs", "x ## y", both("x ## y", "x"));
    row("a comment behind", "Wall # the long one", both("Wall", "Roof"));
    row("blanks", "two words", both("two words", "two"));
    row("tab before, blank behind", "\tpaint ", both("paint", "Paint"));
    row("slashes", "lib/steel\\brushed", both("lib/steel\\brushed", "lib/steel"));
    row("GBK", "\xCA\xAF\xCD\xB7", both("\xCA\xAF\xCD\xB7", "\xCD\xB7\xCA\xAF"));
    row("GBK with a backslash byte", "\x8A\x5C", both("\x8A\x5C", "\x8A\x5D"));
    row("Latin-1", "gr\xFCn", both("gr\xFCn", "gr\xFC"));
    row("Shift-JIS", "\x90\xC2", both("\x90\xC2", "\x90\xC3"));
    row("UTF-8", "\xE7\x9F\xB3", both("\xE7\x9F\xB3", "\xE7\x9F\xB4"));
    row("UTF-8 in the OBJ, GBK in the MTL", "\xE7\xBA\xA2", both("\xBA\xEC", "\xC0\xB6"));
    row("letter case tells apart", "Mat", both("Mat", "mat"));
    row("kd", "m", "newmtl m\nkd 1 0 0\n");
    row("KD and NEWMTL", "m", "NEWMTL m\nKD 1 0 0\n");
    row("indented", "m", "\tnewmtl m\n\t\tKd\t1 0 0\n");
    row("comment behind numbers", "m", "newmtl m\nKd 1 0 0 # red\n");
    row("comment that ends with a backslash", "m", "# made in C:\\out\\\nnewmtl m\nKd 1 0 0\n");
    row("CRLF and no last line end", "m", "newmtl m\r\nKd 1 0 0");
    row("UTF-8 mark", "m", "\xEF\xBB\xBFnewmtl m\nKd 1 0 0\n");
}

/// The face is red whatever the material is called and however its MTL is written.
void TestObjRealFiles::materialNames()
{
    QFETCH(QByteArray, used);
    QFETCH(QByteArray, mtl);
    const Folder folder;
    folder.write(QStringLiteral("m.mtl"), mtl);
    const SceneLoad load =
        loadObj(folder.write(QStringLiteral("m.obj"), "mtllib m.mtl\n" + kSquare + "usemtl " + used + "\nf 1 2 3 4\n"));
    QVERIFY2(load.scene && load.diagnostics.empty(), qPrintable(textOf(load.diagnostics)));
    QVERIFY(load.scene->mesh.vertices[0].color == glm::vec3(1, 0, 0));
    QVERIFY(!load.scene->materials[0].name.contains(QChar::ReplacementCharacter));
}

void TestObjRealFiles::libraryNames_data()
{
    QTest::addColumn<QByteArray>("statement");
    QTest::addColumn<QByteArray>("file"); // the MTL's name on the disk, in bytes
    QTest::addColumn<int>("warnings");
    const auto row = [](const char* name, const QByteArray& statement, const QByteArray& file, int warnings) {
        QTest::newRow(name) << statement << file << warnings;
    };
    row("plain", "mtllib a.mtl", "a.mtl", 0);
    row("quotes", "mtllib \"a b.mtl\"", "a b.mtl", 0);
    row("single quotes", "mtllib 'a.mtl'", "a.mtl", 0);
    row("blanks", "mtllib my parts.mtl", "my parts.mtl", 0);
    row("dot and slash", "mtllib ./a.mtl", "a.mtl", 0);
    row("dot and backslash", "mtllib .\\a.mtl", "a.mtl", 0);
    row("a drive", "mtllib C:\\Users\\x\\a.mtl", "a.mtl", 0);
    row("a drive in quotes", "mtllib \"C:\\my parts\\a.mtl\"", "a.mtl", 0);
    row("a home", "mtllib /home/nobody/parts/a.mtl", "a.mtl", 0);
    row("a share", "mtllib \\\\server\\share\\a.mtl", "a.mtl", 0);
    row("another letter case", "mtllib Chair.MTL", "chair.mtl", 1);
    row("folder and letter case", "mtllib D:\\Out\\CHAIR.MTL", "chair.mtl", 1);
    row("renamed pair", "mtllib former.mtl", "file.mtl", 1);
    row("renamed pair of another case", "mtllib former.mtl", "FILE.mtl", 1);
    row("no statement", "", "file.mtl", 1);
    row("GBK both", "mtllib \xCA\xAF.mtl", "\xCA\xAF.mtl", 0);
    row("GBK in the OBJ", "mtllib \xCA\xAF.mtl", "\xE7\x9F\xB3.mtl", 0);
    row("GBK on the disk", "mtllib \xE7\x9F\xB3.mtl", "\xCA\xAF.mtl", 0);
    row("Latin-1 in the OBJ", "mtllib gr\xFCn.mtl", "gr\xC3\xBCn.mtl", 0);
    row("several", "mtllib none.mtl a.mtl", "a.mtl", 1);
    row("in capitals", "MTLLIB a.mtl", "a.mtl", 0);
}

void TestObjRealFiles::libraryNames()
{
    QFETCH(QByteArray, statement);
    QFETCH(QByteArray, file);
    QFETCH(int, warnings);
    const Folder folder;
    FILE* const mtl = std::fopen((folder.path().toUtf8() + '/' + file).constData(), "wb");
    QVERIFY(mtl != nullptr);
    std::fputs("newmtl m\nKd 1 0 0\n", mtl);
    std::fclose(mtl);
    const SceneLoad load =
        loadObj(folder.write(QStringLiteral("file.obj"), statement + "\n" + kSquare + "usemtl m\nf 1 2 3 4\n"));
    QVERIFY(load.scene);
    QVERIFY2(load.scene->mesh.vertices[0].color == glm::vec3(1, 0, 0), qPrintable(textOf(load.diagnostics)));
    QVERIFY2(countOf(load.diagnostics, Severity::Warning) == warnings, qPrintable(textOf(load.diagnostics)));
}

/// What a material does not say it does not take over from the one before it, in whichever order they stand.
void TestObjRealFiles::materialsStandForThemselves()
{
    const Folder folder;
    const QByteArray full = "newmtl full\nKd 0.1 0.2 0.3\nKs 0.4 0.4 0.4\nNs 77\n";
    const QByteArray bare = "newmtl bare\nillum 2\n";
    const QString path = folder.write(QStringLiteral("m.obj"),
                                      "mtllib m.mtl\n" + kSquare + "usemtl full\nf 1 2 3\nusemtl bare\nf 1 3 4\n");
    std::vector<Material> former;
    for (const QByteArray& mtl : {full + bare, bare + full}) {
        folder.write(QStringLiteral("m.mtl"), mtl);
        const SceneLoad load = loadObj(path);
        QVERIFY2(load.scene, qPrintable(textOf(load.diagnostics)));
        const std::vector<Material>& m = load.scene->materials;
        QCOMPARE(m.size(), std::size_t{2});
        QVERIFY(m[0].diffuse == glm::vec3(0.1F, 0.2F, 0.3F));
        QVERIFY(m[1].diffuse == glm::vec3(0.8F, 0.7F, 0.6F));
        QCOMPARE(m[1].shininess, Material{}.shininess);
        QVERIFY(former.empty() || former[1].specular == m[1].specular);
        former = m;
    }
}

void TestObjRealFiles::unusedStatementsAreNamed()
{
    const Folder folder;
    folder.write(QStringLiteral("m.mtl"), "newmtl m\nKa 0 0 0\nKd 1 1 1\nKe 0 0 0\nNi 1.45\nillum 2\n"
                                          "map_bump n.png\nnewmtl n\nKe 1 0 0\nmap_Bump o.png\nshader 4\n");
    const SceneLoad load =
        loadObj(folder.write(QStringLiteral("m.obj"), "mtllib m.mtl\n" + kSquare + "usemtl m\nf 1 2 3 4\n"));
    QVERIFY(load.scene);
    const QString mtl = folder.path(QStringLiteral("m.mtl"));
    verifyRemark(load.diagnostics, mtl + QStringLiteral(":7: warning: "),
                 QStringLiteral("not drawn: map_Bump (2), Ke"));
    verifyRemark(load.diagnostics, mtl + QStringLiteral(":11: warning: "), QStringLiteral("ignored: shader"));
    verifyRemark(load.diagnostics, mtl + QStringLiteral(":2: note: "), QStringLiteral("Ka, Ke, Ni, illum"));
    QCOMPARE(load.diagnostics.size(), std::size_t{3});
    QCOMPARE(withoutNotes(load.diagnostics).size(), std::size_t{2});
}

void TestObjRealFiles::blenderIsRemarkedOn()
{
    const Folder folder;
    folder.write(QStringLiteral("m.mtl"), "# Blender 3.4.1 MTL File: 'None'\nnewmtl m\nKd 0.215861 0 0\n");
    const SceneLoad load =
        loadObj(folder.write(QStringLiteral("m.obj"), "mtllib m.mtl\n" + kSquare + "usemtl m\nf 1 2 3 4\n"));
    QVERIFY(load.scene);
    verifyRemark(load.diagnostics, folder.path(QStringLiteral("m.mtl:1: note: ")), QStringLiteral("linear light"));
}

void TestObjRealFiles::textInUtf16()
{
    const QString text = QString::fromLatin1(kSquare + "f 1 2 3 4\n");
    QByteArray little("\xFF\xFE");
    QByteArray big("\xFE\xFF");
    for (const QChar c : text) {
        little += static_cast<char>(c.unicode() & 0xFF);
        little += static_cast<char>(c.unicode() >> 8);
        big += static_cast<char>(c.unicode() >> 8);
        big += static_cast<char>(c.unicode() & 0xFF);
    }
    const Folder folder;
    for (const QByteArray& bytes : {little, big}) {
        const SceneLoad load = loadObj(folder.write(QStringLiteral("wide.obj"), bytes));
        QVERIFY2(load.scene, qPrintable(textOf(load.diagnostics)));
        QCOMPARE(load.scene->mesh.faceCount(), std::size_t{2});
        verifyRemark(load.diagnostics, folder.path(QStringLiteral("wide.obj: note: ")), QStringLiteral("UTF-16"));
    }
}

/// Triangles know the line of their `f`: also where faces before it are left out, and where it goes on over lines.
void TestObjRealFiles::linesOfFaces()
{
    const Folder folder;
    const QString path =
        folder.write(QStringLiteral("l.obj"), kSquare + "f 1\nf 1 2 3 4\n# one\nf 1 \\\n2 \\\n3\nf 1 2 3\n");
    for (const bool peerMesh : {false, true}) {
        const SceneLoad load = loadObj(path, {peerMesh, {1920, 1080}, {}});
        QVERIFY(load.scene);
        QCOMPARE(load.scene->mesh.faceLine, (std::vector<std::int32_t>{6, 6, 8, 11}));
        QCOMPARE(load.scene->mesh.lineOf(3), 11);
        QCOMPARE(load.scene->mesh.lineOf(4), -1);
    }
}

void TestObjRealFiles::fileNameInAnotherEncoding()
{
    const Folder folder;
    const QByteArray bytes = folder.path().toUtf8() + "/\xBA\xEC.obj";
    QFile(folder.write(QStringLiteral("plain.obj"), kSquare + "f 1 2 3 9\n"))
        .copy(folder.path(QStringLiteral("x.obj")));
    QCOMPARE(std::rename(folder.path(QStringLiteral("x.obj")).toUtf8().constData(), bytes.constData()), 0);
    const QString path = pathFromBytes(bytes);
    QCOMPARE(bytesOfPath(path), bytes);
    const SceneLoad load = loadObj(path);
    QVERIFY(!load.scene);
    std::remove(bytes.constData());
    verifyRemark(load.diagnostics, folder.path() + QStringLiteral("/\u7ea2.obj:5: "), QStringLiteral("v index 9"));
}

QTEST_GUILESS_MAIN(TestObjRealFiles)
#include "test_obj_real_files.moc"
