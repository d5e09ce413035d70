// Small shapes written in the manner of programs that export OBJ and MTL files: spelling, order, numbers and
// materials are those that each program, run in the version named, wrote for such a shape. The shapes are our own.
#include "core/io/obj_loader.h"
#include "tests/scene_files.h"
#include "tests/support.h"

#include <QImage>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

const QByteArray kPlate = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n";
const QByteArray kUvs = "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";

/// A plate whose lower right half is the textured material `wood`, its upper left half the plain `red`.
const QByteArray kHalves =
    "mtllib x.mtl\n" + kPlate + kUvs + "vn 0 0 1\nusemtl wood\nf 1/1/1 2/2/1 3/3/1\nusemtl red\nf 1/1/1 3/3/1 4/4/1\n";

QByteArray crlf(QByteArray text) { return text.replace('\n', "\r\n"); }

QStringList warningsOf(const Diagnostics& diagnostics)
{
    QStringList texts;
    for (const Diagnostic& diagnostic : withoutNotes(diagnostics))
        texts << diagnostic.text();
    return texts;
}

/// There are as many warnings as phrases, and each phrase stands in one of them.
void verifyWarnings(const Diagnostics& diagnostics, const QStringList& phrases)
{
    const QStringList warnings = warningsOf(diagnostics);
    const QString all = textOf(diagnostics);
    QVERIFY2(warnings.size() == phrases.size(), qPrintable(all));
    for (const QString& phrase : phrases)
        QVERIFY2(std::any_of(warnings.begin(), warnings.end(), [&](const QString& w) { return w.contains(phrase); }),
                 qPrintable(phrase + QStringLiteral(" expected in:\n") + all));
}

Frame pictureOf(const Scene& scene, Shading shading)
{
    Settings settings = plainSettings({64, 48});
    settings.shading = shading;
    return draw(scene, settings);
}

/// 2 by 2 texels under the names that the files use.
void writeImages(const Folder& folder)
{
    QImage image(2, 2, QImage::Format_RGB32);
    image.setPixel(0, 0, qRgb(10, 20, 30));
    image.setPixel(1, 0, qRgb(200, 120, 40));
    image.setPixel(0, 1, qRgb(0, 255, 0));
    image.setPixel(1, 1, qRgb(0, 0, 255));
    for (const char* name : {"wood.png", "wood 1.png"})
        QVERIFY(image.save(folder.path(QString::fromLatin1(name))));
}

} // namespace

class TestExporters : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void plates_data();
    void plates();
    void materials_data();
    void materials();
    void farAway_data();
    void farAway();
    void colors_data();
    void colors();
    void smoothing_data();
    void smoothing();
};

/// Columns: the text; words of each warning. All are the plate of kPlate in the default material.
void TestExporters::plates_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QStringList>("warnings");
    const auto row = [](const char* name, const QByteArray& text, const QStringList& warnings = {}) {
        QTest::newRow(name) << text << warnings;
    };
    row("assimp 5.2.5: three numbers a vt, brackets in names, two blanks behind f",
        "# File produced by Open Asset Import Library\n# (assimp v5.2.0)\n\n# 4 vertex positions\n" + kPlate +
            "\n# 4 UV coordinates\nvt 0 0 0\nvt 1 0 0\nvt 1 1 0\nvt 0 1 0\n\n# 1 vertex normals\nvn 0 0 1\n\n"
            "# Mesh 'meshes[0]' with 2 faces\ng meshes[0]\nf  1/1/1 2/2/1 3/3/1\nf  1/1/1 3/3/1 4/4/1\n\n");
    row("OpenSceneGraph 3.6.5: vertices of each geometry once more, colons and blanks in names, blank behind f",
        "# file written by OpenSceneGraph\n\n\ng Group_0\n\no Group_front left:Plate_Geometry_0\n\nv -1 -1 0\nv 1 -1 "
        "0\n"
        "v 1 1 0\n# 3 elements written\n\nvn 0 -0 1\nvn 0 -0 1\nvn 0 -0 1\n# 3 elements written\n\nf 1//1 2//2 3//3 "
        "\n\n"
        "o Group_front left:Plate_Geometry_1\n\nv -1 -1 0\nv 1 1 0\nv -1 1 0\n# 3 elements written\n\nvn 0 -0 1\n"
        "vn 0 -0 1\nvn 0 -0 1\n# 3 elements written\nf 4//4 5//5 6//6 \n");
    row("OpenCTM 1.0.3: s 1 and two slashes", kPlate + "s 1\nf 1// 2// 3//\nf 1// 3// 4//\n");
    row("OpenCTM 1.0.3: a vt and a vn for every v",
        kPlate + kUvs + "vn 0 0 1\nvn 0 0 1\nvn 0 0 1\nvn 0 0 1\ns 1\n" + "f 1/1/1 2/2/2 3/3/3\nf 1/1/1 3/3/3 4/4/4\n");
    row("CloudCompare 2.11.3: a normal in 32 bits, mtllib behind v, comment behind faces",
        "# Created by CloudCompare v2.11.3 (Anoia)\n# Created 29 Nov 2026 10:24:56\nv -1.00000000 -1.00000000 "
        "0.00000000\nv 1.00000000 -1.00000000 0.00000000\nv 1.00000000 1.00000000 0.00000000\nv -1.00000000 1.00000000 "
        "0.00000000\nvn 0.00000000 0.00000000 1.00000000\ng Mesh\nf 1//1 2//1 3//1\nf 1//1 3//1 4//1\n#2 faces\n");
    row("CloudCompare 2.11.3: -1 where a face has neither vt nor vn",
        kPlate + kUvs + "vn 0 0 1\ng side one\nf 1/1/1 2/2/1 3/3/1\n#1 faces\ng other\nf 1/-1/-1 3/-1/-1 4/-1/-1\n",
        {QStringLiteral(":14: warning: f: in 3 corners v counts from the start and vt or vn is -1")});
    row("Draco 1.5.5: fixed places, corners of a face in turned order",
        "v -1.000000 1.000000 0.000000\nv -1.000000 -1.000000 0.000000\nv 1.000000 1.000000 0.000000\n"
        "v 1.000000 -1.000000 0.000000\nvn 0.000000 0.000000 1.000000\nvn 0.000000 0.000000 1.000000\n"
        "vn 0.000000 0.000000 1.000000\nvn 0.000000 0.000000 1.000000\nf 2//2 4//4 3//3\nf 2//2 3//3 1//1\n");
    row("Open3D 0.16.1: vn between the v",
        "# Created by Open3D \n# object name: o\n# number of vertices: 4\n# number of triangles: 2\nv -1 -1 0\nvn 0 0 "
        "1\n"
        "v 1 -1 0\nvn 0 0 1\nv 1 1 0\nvn 0 0 1\nv -1 1 0\nvn 0 0 1\nf 1//1 2//2 3//3\nf 1//1 3//3 4//4\n");
    row("three.js r170: o without a name, lines and points behind",
        "o \n" + kPlate + kUvs + "vn 0 0 1\nvn 0 0 1\nvn 0 0 1\nvn 0 0 1\nf 1/1/1 2/2/2 3/3/3\nf 1/1/1 3/3/3 4/4/4\n" +
            "o line\nv 0 0 0\nv 1e-7 0 0\nl 5 6 \no \nv 0 0 0\np 7 \n");
    row("Babylon.js 9.28: o with blanks", "o my plate\n" + kPlate + "vn 0 0 1\nvn 0 0 1\nvn 0 0 1\nvn 0 0 1\n" + kUvs +
                                              "f 1/1/1 2/2/2 3/3/3\nf 1/1/1 3/3/3 4/4/4\n");
    row("JSCAD 2.1.23: one polygon, blank lines",
        "# Wavefront OBJ file generated by JSCAD\n\n" + kPlate + "\n\nf 1 2 3 4\n");
    row("Blender 3.4.1: negative zeros, s 0, four places in vn",
        "# Blender 3.4.1\n# www.blender.org\ng 石_石\nv -1.000000 -1.000000 -0.000000\nv 1.000000 -1.000000 -0.000000\n"
        "v 1.000000 1.000000 0.000000\nv -1.000000 1.000000 0.000000\nvn -0.0000 -0.0000 1.0000\ns 0\n"
        "f 1//1 2//1 3//1 4//1\n");
    row("Blender 3.4.1, older exporter: s off", "# Blender v3.4.1 OBJ File: ''\n# www.blender.org\no Plate.001\n" +
                                                    kPlate + kUvs + "vn 0.0000 0.0000 1.0000\ns off\n" +
                                                    "f 1/1/1 2/2/1 3/3/1 4/4/1\n");
    row("Blender 3.4.1: an object of vertices alone behind the faces",
        "o Plate\n" + kPlate + "s 0\nf 1 2 3 4\no edges\nv 0.000000 0.000000 0.000000\nv 1.000000 0.000000 0.000000\n");
    row("VTK 9.1 writer: a strip as triangles, a line", "# Generated by Visualization Toolkit\n" + kPlate +
                                                            "# tcoords array 0\n" + kUvs +
                                                            "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\nl 1 2 3\n");
    row("VTK 9.1 exporter: p, l whose corners run together, f with a blank behind",
        "#  wavefront obj file written by the visualization toolkit\n\n" + kPlate +
            "vt 0 0 0\nvt 1 0 0\nvt 1 1 0\nvt 0 1 0\n\ng grp1\np 1 \nl 1/12/23/3\nf 1/1 2/2 3/3 4/4 \n");
    row("MeshLab 2020.09: counts in comments between blank lines",
        "####\n#\n# OBJ File Generated by Meshlab\n#\n####\n# Object n.obj\n#\n# Vertices: 4\n# Faces: 2\n#\n####\n"
        "v -1.000000 -1.000000 0.000000\nv 1.000000 -1.000000 0.000000\nv 1.000000 1.000000 0.000000\n"
        "v -1.000000 1.000000 0.000000\n# 4 vertices, 0 vertices normals\n\nf 1 2 3\nf 1 3 4\n"
        "# 2 faces, 0 coords texture\n\n# End of File\n");
    row("Maverick Model 3D 1.3.13: CRLF, normals of length 0, o and g alike",
        crlf(
            "# Wavefront OBJ file\n# Exported by Maverick Model 3D 1.3.13\n\n# 4 Vertices\nv -1.0 -1.0 0.0\nv 1.0 -1.0 "
            "0.0\n"
            "v 1.0 1.0 0.0\nv -1.0 1.0 0.0\n\n# 4 Vertex Normals\nvn 0.0 0.0 0.0\nvn 0.0 0.0 0.0\nvn 0.0 0.0 0.0\n"
            "vn 0.0 0.0 0.0\n# front, 2 grouped triangles\n\no front\ng front\n\nf 1//1 2//2 3//3\nf 1//1 3//3 4//4\n"),
        {QStringLiteral(":11: warning: vn: 4 normals have length 0")});
    row("meshio 5.0.0: a quad of positions, vt that no face uses",
        "# Created by meshio v5.0.0, 2026-11-29T10:27:52.345079\n" + kPlate + kUvs + "f 1 2 3 4\n");
    row("OpenMesh 9.0: counts first",
        "# 4 vertices, 1 faces\nv -1.000000 -1.000000 0.000000\nv 1.000000 -1.000000 0.000000\n"
        "v 1.000000 1.000000 0.000000\nv -1.000000 1.000000 0.000000\nf 1 2 3 4\n");
}

void TestExporters::plates()
{
    QFETCH(QByteArray, text);
    QFETCH(QStringList, warnings);
    const Folder folder;
    const SceneLoad load = loadObj(folder.write(QStringLiteral("x.obj"), text));
    QVERIFY2(load.scene, qPrintable(textOf(load.diagnostics)));
    verifyWarnings(load.diagnostics, warnings);
    QCOMPARE(load.scene->mesh.faceCount(), std::size_t{2});
    const SceneLoad plain = loadObj(folder.write(QStringLiteral("plain.obj"), kPlate + "f 1 2 3\nf 1 3 4\n"));
    const QString different =
        difference(pictureOf(*load.scene, Shading::Gouraud), pictureOf(*plain.scene, Shading::Gouraud));
    QVERIFY2(different.isEmpty() || different == QStringLiteral("ids"), qPrintable(different));
}

/// Columns: the OBJ, its MTL, words of each warning. The picture is that of the MTL in `plain`.
void TestExporters::materials_data()
{
    QTest::addColumn<QByteArray>("obj");
    QTest::addColumn<QByteArray>("mtl");
    QTest::addColumn<QByteArray>("plain");
    QTest::addColumn<QStringList>("warnings");
    const auto row = [](const char* name, const QByteArray& obj, const QByteArray& mtl, const QByteArray& plain,
                        const QStringList& warnings = {}) { QTest::newRow(name) << obj << mtl << plain << warnings; };
    const QByteArray wood = "newmtl wood\nKd 1 1 1\nmap_Kd wood.png\n";
    const QByteArray red = "newmtl red\nKd 1 0 0\n";
    const auto named = [](const char* woodName, const char* redName) {
        return QByteArray(kHalves)
            .replace("usemtl wood", QByteArray("usemtl ") + woodName)
            .replace("usemtl red", QByteArray("usemtl ") + redName);
    };
    row("assimp 5.2.5: nine places, a default material first", named("Stone #2", "gr\xC3\xBCn"),
        "# File produced by Open Asset Import Library\n\nnewmtl DefaultMaterial\nKd 0.600000024 0.600000024 "
        "0.600000024\n"
        "Ka 0 0 0\nKs 0 0 0\nKe 0 0 0\nTf 1 1 1\nd 1\nNi 1\nillum 1\n\nnewmtl Stone #2\nKd 1 1 1\nKa 0 0 0\nd 1\nNs "
        "50\n"
        "illum 2\nmap_Kd wood 1.png\n\nnewmtl gr\xC3\xBCn\nKd 1 0 0\nKe 0.5 0 0\nd 0.5\nillum 1\n\n",
        wood + red, {QStringLiteral("not drawn: Ke, d")});
    row("assimp 5.2.5: a texture embedded in its source is a star and a number", kHalves,
        "newmtl wood\nKd 0.5 0.5 0.5\nillum 2\nmap_Kd *0\n\nnewmtl red\nKd 1 0 0\nillum 1\n\n",
        "newmtl wood\nKd 0.5 0.5 0.5\n" + red, {QStringLiteral("*0: there is no such file; drawn without texture")});
    row("OpenSceneGraph 3.6.5: the opacity is a fourth number", named("material_1", "material_2"),
        "newmtl material_2\n       Ka 0.2 0.2 0.2 0.5\n       Kd 1 0 0 0.5\n       Ks 0 0 0 0.5\n       Ns 0\n\n"
        "newmtl material_1\n       Ka 0.2 0.2 0.2 1\n       Kd 1 1 1 1\n       Ks 0 0 0 1\n       Ns 0\n"
        "       map_Kd wood.png\n\n",
        wood + red,
        {QStringLiteral(":3: warning: Kd: \"0.5\" behind the numbers is ignored"),
         QStringLiteral(":4: warning: Ks: \"0.5\" behind the numbers is ignored")});
    row("CloudCompare 2.11.3: Tr for what is not opaque", kHalves,
        "# Generated by CloudCompare\n\nnewmtl wood\nKa 0 0 0\nKd 1 1 1\nKs 0 0 0\nTr 0\nillum 1\nNs 50\nmap_Kd "
        "wood.png\n"
        "\nnewmtl red\nKa 0 0 0\nKd 1 0 0\nKs 0 0 0\nTr 0.5\nillum 1\nNs 50\n",
        wood + red, {QStringLiteral(":16: warning: not drawn: Tr")});
    row("VTK 9.1 exporter: Tr 1 means opaque", named("mtl1", "mtl2"),
        "# wavefront mtl file written by the visualization toolkit\n\nnewmtl mtl1\nKa 0 0 0\nKd 1 1 1\nKs 0 0 0\nNs "
        "1\nTr 1\n"
        "illum 3\nmap_Kd wood.png\n\nnewmtl mtl2\nKa 0 0 0\nKd 1 0 0\nKs 0 0 0\nNs 1\nTr 0.5\nillum 3\n",
        wood + red, {QStringLiteral("not drawn: Tr (2)")});
    row("VTK 9.1 writer: the texture's path is that of the working folder", kHalves,
        "newmtl wood\nmap_Kd out/wood.png\nnewmtl red\nKd 1 0 0\n", wood + red);
    row("Babylon.js 9.28: the MTL calls the material otherwise, mtllib x.mtl.mtl",
        QByteArray(kHalves).replace("mtllib x.mtl", "mtllib x.mtl.mtl"),
        "newmtl mat1\n  Ns 64.0000\n  Ni 1.5000\n  d 0.5000\n  Tr 0.0000\n  Tf 1.0000 1.0000 1.0000\n  illum 2\n"
        "  Ka 0.0000 0.0000 0.0000\n  Kd 0.5000 0.2500 0.1250\n  Ks 1.0000 1.0000 1.0000\n  Ke 0.0000 0.0000 0.0000",
        "newmtl wood\nKd 0.8 0.7 0.6\nnewmtl red\nKd 0.8 0.7 0.6\n",
        {QStringLiteral("x.mtl beside it is read"), QStringLiteral("no material \"wood\""),
         QStringLiteral("no material \"red\""), QStringLiteral("not drawn: d")});
    row("Blender 3.4.1: no Kd beside a texture, options before a name with a blank", named("Stone_#2", "red"),
        "# an MTL file\n\nnewmtl Stone_#2\nNs 250.000000\nKa 1.000000 1.000000 1.000000\n"
        "Ks 0.000000 0.000000 0.000000\nKe 0.000000 0.000000 0.000000\nNi 1.450000\nd 1.000000\nillum 2\n"
        "map_Kd -o 0.25 0.5 0 -s 2 3 1 wood 1.png\n\nnewmtl red\nKd 1.000000 0.000000 0.000000\nd 1.000000\nillum 2\n",
        "newmtl wood\nKd 1 1 1\nmap_Kd -o 0.25 0.5 -s 2 3 wood.png\n" + red);
    row("Blender 3.4.1 with physical parameters: Pr to anisor", kHalves,
        "newmtl wood\nKs 0.000000 0.000000 0.000000\nNi 1.450000\nd 1.000000\nillum 2\nPr 0.500000\nPm 0.000000\n"
        "Ps 0.000000\nPc 0.000000\nPcr 0.030000\naniso 0.000000\nanisor 0.000000\nmap_Kd wood 1.png\n\nnewmtl red\n"
        "Kd 1.000000 0.000000 0.000000\nillum 9\nPr 0.500000\nPm 1.000000\n",
        wood + red, {QStringLiteral("not drawn: Pm")});
    row("Blender 3.4.1, older exporter: a material called None, a folder above", named("wood", "None"),
        "newmtl None\nNs 500\nKa 0.8 0.8 0.8\nKd 0.8 0.8 0.8\nKs 0 0 0\nd 1\nillum 2\n\nnewmtl wood\nNs 250.000000\n"
        "Kd 1.000000 1.000000 1.000000\nillum 2\nmap_Kd ../wood 1.png\n",
        wood + "newmtl red\nKd 0.8 0.8 0.8\n");
    row("Maverick Model 3D 1.3.13: tabs, Ns 0", kHalves,
        "# Material file for sq.obj\n\nnewmtl wood\n\tNs 0\n\td 1\n\tillum 2\n\tKd 1.0 1.0 1.0\n\tKs 0.0 0.0 0.0\n"
        "\tKa 0.2 0.2 0.2\n\tmap_Kd wood.png\n\nnewmtl red\n\tNs 0\n\td 1\n\tillum 2\n\tKd 1.0 0.0 0.0\n"
        "\tKs 0.0 0.0 0.0\n\tKa 0.2 0.2 0.2\n\n",
        wood + red);
    row("Open3D 0.16.1: three places, a number behind the name", named("o_0", "red"),
        "# Created by Open3D \n# object name: o\nnewmtl o_0\nKa 1.000 1.000 1.000\nKd 1.000 1.000 1.000\n"
        "Ks 0.000 0.000 0.000\nmap_Kd wood.png\nnewmtl red\nKd 1.000 0.000 0.000\n",
        wood + red);
    row("JSCAD 2.1.23: colours by name and no library", QByteArray(kHalves).replace("mtllib x.mtl\n", ""), {},
        "newmtl wood\nKd 0.8 0.7 0.6\nnewmtl red\nKd 0.8 0.7 0.6\n",
        {QStringLiteral("x.obj:10: warning: usemtl: no mtllib says what the 2 materials are")});
    row("the MTL text: one number is a grey", kHalves, "newmtl wood\nKd 0.5\nKs 0 # none\nnewmtl red\nKd 1 0 0\n",
        "newmtl wood\nKd 0.5 0.5 0.5\n" + red);
    row("libraries joined to one: a name twice", kHalves, wood + red + "newmtl red\nKd 0 0 1\n", wood + red,
        {QStringLiteral(":6: warning: newmtl: \"red\" comes a second time; the first one is used")});
    row("by hand: a comment behind the name of a file", kHalves,
        "newmtl wood # oak\nKd 1 1 1\nmap_Kd wood 1.png # from the scanner\nnewmtl red\nKd 1 0 0 # bright\n",
        wood + red);
    row("names as in a web address", kHalves, "newmtl wood\nKd 1 1 1\nmap_Kd wood%201.png\nnewmtl red\nKd 1 0 0\n",
        wood + red);
}

void TestExporters::materials()
{
    QFETCH(QByteArray, obj);
    QFETCH(QByteArray, mtl);
    QFETCH(QByteArray, plain);
    QFETCH(QStringList, warnings);
    const Folder folder;
    writeImages(folder);
    if (!mtl.isEmpty())
        folder.write(QStringLiteral("x.mtl"), mtl);
    const SceneLoad load = loadObj(folder.write(QStringLiteral("x.obj"), obj));
    QVERIFY2(load.scene, qPrintable(textOf(load.diagnostics)));
    verifyWarnings(load.diagnostics, warnings);
    folder.write(QStringLiteral("x.mtl"), plain);
    const SceneLoad expected = loadObj(folder.write(QStringLiteral("plain.obj"), kHalves));
    QVERIFY2(expected.scene && warningsOf(expected.diagnostics).isEmpty(), qPrintable(textOf(expected.diagnostics)));
    for (const Shading shading : {Shading::Gouraud, Shading::Texture})
        QCOMPARE(difference(pictureOf(*load.scene, shading), pictureOf(*expected.scene, shading)), QString());
}

/// Columns: positions of a triangle or a plate about (500000, 4649776, 10), the highest y that is read, words of each
/// warning. Programs that compute in float32 have rounded before they write: 4649777.75 has become 4649778.
void TestExporters::farAway_data()
{
    QTest::addColumn<QByteArray>("positions");
    QTest::addColumn<double>("highest");
    QTest::addColumn<int>("seen"); // faces with an area
    QTest::addColumn<QStringList>("warnings");
    const QString far = QStringLiteral("positions are read in double");
    const auto row = [&](const char* name, const QByteArray& positions, double highest, int seen = 1,
                         const QString& warning = {}) {
        QTest::newRow(name) << positions << highest << seen << QStringList{warning.isEmpty() ? far : warning};
    };
    row("VTK 9.1 writer: as many digits as a double needs",
        "v 500000.25 4649776.5 10.125\nv 500001.25 4649776.5 10.125\nv 500000.25 4649777.75 10.125\n", 4649777.75);
    row("VTK 9.1 writer: digits beyond float32",
        "v 500000.12345678 4649776.98765432 0\nv 500001.25 4649776.5 0\nv 500000.25 4649777.87654321 0\n",
        4649777.87654321);
    row("meshio 5.0.0", "v 500000.25 4649776.5 10.125\nv 500001.25 4649776.5 10.125\nv 500001.25 4649777.75 10.125\n",
        4649777.75);
    row("three.js r170: the sum of position and size",
        "v 499999.75 4649777 10.125\nv 499999.75 4649776 10.125\nv 500000.75 4649777 10.125\n", 4649777);
    row("JSCAD 2.1.23: rounded to a grid of its own",
        "v 500000.2500032482 4649776.500003892 9.624995684532173\nv 500001.2500034117 4649776.500003892 "
        "9.624995684532173\nv 500000.55902197055 4649777.451055414 9.624995684532173\n",
        4649777.451055414);
    row("Babylon.js 9.28: the first coordinate negated",
        "v -499999.75 4649776 10.125\nv -500000.75 4649776 10.125\nv -500000.75 4649777 10.125\n", 4649777);
    row("assimp 5.2.5: float32",
        "v 500000.25 4649776.5 10.125\nv 500001.25 4649776.5 10.125\nv 500000.25 4649778 10.125\n", 4649778);
    row("OpenSceneGraph 3.6.5: float32",
        "v 500000.25 4649776.5 10.125\nv 500001.25 4649776.5 10.125\nv 500000.25 4649778 10.125\n# 3 elements "
        "written\n",
        4649778);
    row("OpenCTM 1.0.3: float32", "v 500000.25 4649776.5 0\nv 500001.25 4649776.5 0\nv 500001.25 4649778 0\n", 4649778);
    row("Blender 3.4.1: float32 in six places",
        "v 500000.250000 4649776.500000 10.125000\nv 500001.250000 4649776.500000 10.125000\n"
        "v 500000.250000 4649778.000000 10.125000\n",
        4649778);
    row("MeshLab 2020.09: float32 in six places",
        "v 500000.250000 4649776.500000 0.000000\nv 500001.250000 4649776.500000 0.000000\n"
        "v 500001.250000 4649778.000000 0.000000\n# 3 vertices, 0 vertices normals\n",
        4649778);
    row("CloudCompare 2.11.3: float32 in eight places",
        "v 500000.25000000 4649776.50000000 10.12500000\nv 500001.25000000 4649776.50000000 10.12500000\n"
        "v 500000.25000000 4649778.00000000 10.12500000\n",
        4649778);
    row("OpenMesh 9.0: doubles written as float32",
        "v 500000.250000 4649776.500000 10.125000\nv 500001.250000 4649776.500000 10.125000\n"
        "v 500001.250000 4649778.000000 10.125000\n",
        4649778);
    row("Open3D 0.16.1: six digits leave a line",
        "v 500000 4.64978e+06 10.125\nv 500001 4.64978e+06 10.125\nv 500000 4.64978e+06 10.125\n", 4649780, 0);
    row("Draco 1.5.5: eleven bits of the box leave a point",
        "v 499731.000000 4649778.000000 0.000000\nv 499731.000000 4649778.000000 0.000000\n"
        "v 499731.000000 4649778.000000 0.000000\n",
        4649778, 0, QStringLiteral("the model is 0 across"));
}

void TestExporters::farAway()
{
    QFETCH(QByteArray, positions);
    QFETCH(double, highest);
    QFETCH(int, seen);
    QFETCH(QStringList, warnings);
    const Folder folder;
    const SceneLoad load = loadObj(folder.write(QStringLiteral("x.obj"), positions + "f 1 2 3\n"));
    QVERIFY2(load.scene, qPrintable(textOf(load.diagnostics)));
    const Mesh& mesh = load.scene->mesh;
    double top = 0;
    for (const MeshVertex& vertex : mesh.vertices)
        top = std::max(top, mesh.origin.y + double(vertex.position.y));
    QVERIFY2(std::abs(top - highest) < 1e-6, qPrintable(QString::number(top, 'f', 9)));
    const auto at = [&](std::size_t i) { return glm::dvec3(mesh.vertices[mesh.indices[i]].position); };
    QCOMPARE(glm::length(glm::cross(at(1) - at(0), at(2) - at(0))) > 0.1, seen == 1);
    const Frame frame = pictureOf(*load.scene, Shading::Gouraud);
    QCOMPARE(std::any_of(frame.ids.begin(), frame.ids.end(), [](auto id) { return id == 0; }), seen == 1);
    verifyWarnings(load.diagnostics, warnings);
}

/// Columns: a `v` line behind which others follow in the same manner, the colour in bytes.
void TestExporters::colors_data()
{
    QTest::addColumn<QByteArray>("color");
    QTest::addColumn<QString>("bytes");
    const auto row = [](const char* name, const char* color, const char* bytes) {
        QTest::newRow(name) << QByteArray(color) << QString::fromLatin1(bytes);
    };
    row("assimp 5.2.5: nine digits", " 1 0.501960814 0.250980407", "255 128 64");
    row("Open3D 0.16.1: six digits", " 1 0.501961 0.25098", "255 128 64");
    row("Blender 3.4.1: four places", " 0.7353 0.5371 0.0000", "188 137 0");
    row("MeshLab: six places", " 1.000000 0.501961 0.250980", "255 128 64");
}

void TestExporters::colors()
{
    QFETCH(QByteArray, color);
    QFETCH(QString, bytes);
    QByteArray text;
    for (const char* position : {"-1 -1 0", "1 -1 0", "1 1 0"})
        text += QByteArray("v ") + position + color + "\n";
    const Folder folder;
    const SceneLoad load = loadObj(folder.write(QStringLiteral("x.obj"), text + "f 1 2 3\n"));
    QVERIFY2(load.scene && load.diagnostics.empty(), qPrintable(textOf(load.diagnostics)));
    for (const MeshVertex& vertex : load.scene->mesh.vertices)
        QCOMPARE(QStringLiteral("%1 %2 %3")
                     .arg(std::lround(255 * vertex.color.r))
                     .arg(std::lround(255 * vertex.color.g))
                     .arg(std::lround(255 * vertex.color.b)),
                 bytes);
}

/// A roof of two faces: are the two corners of its ridge shared (4 vertices) or apart (6)?
void TestExporters::smoothing_data()
{
    QTest::addColumn<QByteArray>("before");
    QTest::addColumn<QByteArray>("between");
    QTest::addColumn<int>("vertices");
    const auto row = [](const char* name, const char* before, const char* between, int vertices) {
        QTest::newRow(name) << QByteArray(before) << QByteArray(between) << vertices;
    };
    row("OpenCTM 1.0.3: s 1", "s 1\n", "", 4);
    row("Blender 3.4.1: s 0", "s 0\n", "", 6);
    row("Blender 3.4.1: s 0 in each object", "o a\ns 0\n", "o b\ns 0\n", 6);
    row("Blender 3.4.1: numbered groups", "s 1\n", "s 2\n", 6);
    row("Blender 3.4.1, older exporter: s off", "s off\n", "", 6);
    row("assimp 5.2.5: no statement, a group each", "g a\n", "g b\n", 4);
    row("three.js r170: no statement", "o a\n", "", 4);
}

void TestExporters::smoothing()
{
    QFETCH(QByteArray, before);
    QFETCH(QByteArray, between);
    QFETCH(int, vertices);
    const Folder folder;
    const SceneLoad load =
        loadObj(folder.write(QStringLiteral("x.obj"),
                             "v -1 0 0\nv 0 0 1\nv 0 1 1\nv 1 0 0\n" + before + "f 1 2 3\n" + between + "f 2 4 3\n"));
    QVERIFY2(load.scene && load.diagnostics.empty(), qPrintable(textOf(load.diagnostics)));
    QCOMPARE(static_cast<int>(load.scene->mesh.vertices.size()), vertices);
}

QTEST_GUILESS_MAIN(TestExporters)
#include "test_exporters.moc"
