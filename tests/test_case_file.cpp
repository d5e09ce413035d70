#include "core/scenes/load_scene.h"
// `.case` files: every directive, every kind of number, and what is said about broken ones.
#include "core/io/case_file.h"
#include "scene_files.h"

#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include <clocale>
#include <cmath>
#include <limits>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

SceneLoad parse(const QByteArray& text) { return parseCase(text, QStringLiteral("a.case")); }

const QByteArray kTri = "tri 0 0 0 1 1 0 0  1 0 0 1 0 1 0  0 1 0 1 0 0 1\n";

} // namespace

class TestCaseFile : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void defaults();
    void everyDirective();
    void numbers();
    void nonFinitePositionsAreKept();
    void textures();
    void lines();
    void notes();
    void anyLocale();
    void broken_data();
    void broken();
    void unreadable();
    void sharedCases();
};

void TestCaseFile::defaults()
{
    const SceneLoad load = parse("size 8 4\n" + kTri);
    QVERIFY2(load.scene && load.diagnostics.empty(), qPrintable(textOf(load.diagnostics)));
    Settings expected;
    expected.size = {8, 4};
    expected.culling = Culling::None;
    QVERIFY(load.scene->defaults == expected);
    QVERIFY(load.scene->space == SceneSpace::Clip && !load.scene->lit && !load.scene->exact && !load.scene->window);
    QVERIFY(load.scene->background == glm::vec3(0));
    QCOMPARE(load.scene->materials.size(), std::size_t{1});
    QCOMPARE(load.scene->id, QStringLiteral("a.case"));
    QCOMPARE(load.scene->title, QStringLiteral("a"));
    const Mesh& mesh = load.scene->mesh;
    QCOMPARE(mesh.indices, (std::vector<std::uint32_t>{0, 1, 2}));
    QVERIFY(mesh.vertices[1].position == glm::vec4(1, 0, 0, 1) && mesh.vertices[1].color == glm::vec3(0, 1, 0));
    QVERIFY(load.scene->bounds.center == glm::dvec3(0.5, 0.5, 0));
}

void TestCaseFile::everyDirective()
{
    const SceneLoad load = parse(
        "# first\r\nsize 16384 1 # wide\r\nsubpixel_bits 4\r\nexact\r\ncull back\r\ndepth_test lequal\r\ndepth_format "
        "unorm24\r\nclear 0.25 0x1p-1 1\r\nssaa 3\r\nzrange d3d\r\nwindow 100 0 16284 1\r\nexpect covered "
        "64\r\nexpect cover_hist 0 39 1 25\r\n  " +
        kTri + kTri);
    QVERIFY2(load.scene && load.diagnostics.empty(), qPrintable(textOf(load.diagnostics)));
    const Settings& s = load.scene->defaults;
    QCOMPARE(s.size, QSize(16384, 1));
    QCOMPARE(s.subpixelBits, 4);
    QCOMPARE(s.culling, Culling::Back);
    QCOMPARE(s.depthTest, DepthTest::LessEqual);
    QCOMPARE(s.depthFormat, DepthFormat::Unorm24);
    QCOMPARE(s.samples, Samples::Grid3);
    QCOMPARE(s.clipZ, ClipZ::D3d);
    QVERIFY(load.scene->exact);
    QVERIFY(load.scene->background == glm::vec3(0.25F, 0.5F, 1));
    QVERIFY((load.scene->window == PixelRect{100, 0, 16284, 1}));
    QCOMPARE(load.scene->expectations.size(), std::size_t{2});
    QCOMPARE(load.scene->expectations[1].first, QStringLiteral("cover_hist"));
    QCOMPARE(load.scene->expectations[1].second, QStringLiteral("0 39 1 25"));
    QCOMPARE(load.scene->mesh.indices, (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5}));
    for (const char* text : {"size 1 1\ndepth_test none\ncull front\nssaa 1\nzrange gl\ndepth_format float32\n",
                             "size 1 1\ndepth_test greater\ndepth_format unorm16\nssaa 2\ncull none\n",
                             "size 1 1\ndepth_test less\nssaa 4\n"})
        QVERIFY2(parse(text).scene, text);
}

void TestCaseFile::numbers()
{
    const std::vector<std::pair<const char*, float>> numbers = {{"1", 1.0F},
                                                                {"-0.5", -0.5F},
                                                                {"+2.5e-1", 0.25F},
                                                                {".5", 0.5F},
                                                                {"1.", 1.0F},
                                                                {"0x1.8p+1", 3.0F},
                                                                {"-0X1P-2", -0.25F},
                                                                {"0x.8", 0.5F},
                                                                {"0x10", 16.0F},
                                                                {"+0x1.fffffep127", std::numeric_limits<float>::max()},
                                                                {"0x1p-149", std::numeric_limits<float>::denorm_min()},
                                                                {"0x1.0000010000000p+0", 1.0F}, // half way, to even
                                                                {"0x1.0000010000001p+0", 1.0F + 0x1p-23F},
                                                                {"0.1", 0.1F},
                                                                {"16777217", 16777216.0F},
                                                                {"3.4028235e38", std::numeric_limits<float>::max()},
                                                                {"1e-60", 0.0F},
                                                                {"1e-9999", 0.0F},
                                                                {"0x1p-2000", 0.0F}};
    for (const auto& [text, value] : numbers) {
        const SceneLoad load = parse("size 1 1\ntri " + QByteArray(text) + kTri.mid(5));
        QVERIFY2(load.scene, qPrintable(textOf(load.diagnostics)));
        QCOMPARE(load.scene->mesh.vertices[0].position.x, value);
    }
    const SceneLoad zero = parse("size 1 1\ntri -0x0p0" + kTri.mid(5));
    QVERIFY(zero.scene && std::signbit(zero.scene->mesh.vertices[0].position.x));
}

void TestCaseFile::nonFinitePositionsAreKept()
{
    const SceneLoad load = parse("size 1 1\ntri nan inf -inf 1 1 0 0  1 0 0 NaN 0 1 0  INF infinity 0 1 0 0 1\n");
    QVERIFY2(load.scene, qPrintable(textOf(load.diagnostics)));
    const auto& v = load.scene->mesh.vertices;
    QVERIFY(std::isnan(v[0].position.x) && std::isnan(v[1].position.w));
    QVERIFY(v[0].position.y > 0 && std::isinf(v[0].position.y) && v[0].position.z < 0 && std::isinf(v[0].position.z));
    QVERIFY(std::isfinite(load.scene->bounds.radius) && std::isfinite(load.scene->bounds.center.x));
}

void TestCaseFile::textures()
{
    const QByteArray kCorner = " 0 0 0 1 1 0 0 0.25 -2 ";
    const SceneLoad load = parse("size 1 1\ntexture checker 3\ntexture_filter trilinear\ntriuv" + kCorner + kCorner +
                                 " 0 0 0 1 1 0 0 16777216 0x1p-3\n");
    QVERIFY2(load.scene && load.diagnostics.empty(), qPrintable(textOf(load.diagnostics)));
    QVERIFY(load.scene->defaults.shading == Shading::Texture);
    QVERIFY(load.scene->defaults.textureFilter == TextureFilter::Trilinear);
    const Texture& checker = load.scene->textures.at(0);
    QCOMPARE(checker.width, 3);
    QCOMPARE(checker.height, 3);
    QCOMPARE(checker.texels[0], 0xffe6e6e6U);
    QCOMPARE(checker.texels[1], 0xff283c78U);
    QCOMPARE(checker.texels[3], 0xff283c78U);
    QCOMPARE(load.scene->materials.front().texture, 0);
    QVERIFY(load.scene->mesh.vertices[0].uv == glm::vec2(0.25F, -2));
    QVERIFY(load.scene->mesh.vertices[2].uv == glm::vec2(16777216, 0.125F));

    // An image lies beside the case; its lower row is row 0.
    const Folder folder;
    QImage image(2, 3, QImage::Format_RGB32);
    image.fill(qRgb(10, 20, 30));
    image.setPixel(1, 2, qRgb(200, 100, 50));
    QVERIFY(image.save(folder.path(QStringLiteral("two by three.png"))));
    const QString path = folder.write(QStringLiteral("a.case"), "size 1 1\ntexture two by three.png\n" + kTri);
    const SceneLoad withImage = loadCase(path);
    QVERIFY2(withImage.scene, qPrintable(textOf(withImage.diagnostics)));
    const Texture& texture = withImage.scene->textures.at(0);
    QCOMPARE(texture.width, 2);
    QCOMPARE(texture.height, 3);
    QCOMPARE(texture.texels[1], 0xffc86432U);
}

/// A line is a face whose second corner stands for its third.
void TestCaseFile::lines()
{
    const SceneLoad load =
        parse("size 4 4\nline_rule diamond-exit\nline_ties canonical\nline -1 0 0 1 1 0 0  1 0.5 nan 2 0 0 1\n" + kTri +
              "line 0 0 0 1 1 1 1  0 1 0 1 1 1 1\n");
    QVERIFY2(load.scene && load.diagnostics.empty(), qPrintable(textOf(load.diagnostics)));
    const Mesh& mesh = load.scene->mesh;
    QVERIFY(load.scene->defaults.lineRule == LineRule::DiamondExit);
    QVERIFY(load.scene->defaults.lineTies == LineTies::Canonical);
    QCOMPARE(mesh.indices, (std::vector<std::uint32_t>{0, 1, 1, 2, 3, 4, 5, 6, 6}));
    QCOMPARE(mesh.lines, (std::vector<std::uint32_t>{0, 2}));
    QVERIFY(mesh.isLine(0) && !mesh.isLine(1) && mesh.isLine(2));
    QVERIFY(std::isnan(mesh.vertices[1].position.z) && mesh.vertices[1].position.w == 2);
    QVERIFY(mesh.vertices[0].color == glm::vec3(1, 0, 0) && mesh.vertices[1].color == glm::vec3(0, 0, 1));
    QVERIFY(mesh.faceMaterial.empty());

    // A texture is one of triangles.
    const SceneLoad textured = parse("size 4 4\ntexture checker 2\n" + kTri + "line 0 0 0 1 1 1 1  0 1 0 1 1 1 1\n");
    QVERIFY(textured.scene);
    QCOMPARE(textured.scene->mesh.faceMaterial, (std::vector<std::uint32_t>{0, 1}));
    QCOMPARE(textured.scene->materials.at(1).texture, -1);
}

void TestCaseFile::notes()
{
    QCOMPARE(parse("# of the file \n# more\nsize 1 1\n").scene->note, QStringLiteral("of the file"));
    QCOMPARE(parse("# of the file\nsize 1 1 # of a line\nnote  one two\nnote three # no\n").scene->note,
             QStringLiteral("one two\nthree"));
    QCOMPARE(parse("size 1 1\n").scene->note, QString());
}

void TestCaseFile::anyLocale()
{
    if (!std::setlocale(LC_ALL, "de_DE.UTF-8") && !std::setlocale(LC_ALL, "de_DE.utf8"))
        QSKIP("no locale with a decimal comma is installed");
    const SceneLoad load = parse("size 1 1\ntri 0.5" + kTri.mid(5));
    std::setlocale(LC_ALL, "C");
    QVERIFY(load.scene);
    QCOMPARE(load.scene->mesh.vertices[0].position.x, 0.5F);
}

void TestCaseFile::broken_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<int>("line");
    QTest::addColumn<QString>("phrase");
    const auto row = [](const char* name, const QByteArray& text, int line, const char* phrase) {
        QTest::newRow(name) << text << line << QString::fromLatin1(phrase);
    };
    row("no size", "# note\n" + kTri, 2, "the file ends without a size");
    row("nothing", "", 1, "the file ends without a size");
    row("size zero", "size 0 5\n", 1, "size: \"0\" is not a whole number from 1 to 16384");
    row("size too large", "\nsize 5 16385\n", 2, "\"16385\" is not a whole number from 1 to 16384");
    row("size negative", "size -1 5\n", 1, "\"-1\" is not a whole number");
    row("size of one", "size 5\n", 1, "size: 1 values; width and height expected");
    row("size of three", "size 5 5 5\n", 1, "size: 3 values");
    row("size with a fraction", "size 5.5 5\n", 1, "\"5.5\" is not a whole number");
    row("size overflows", "size 99999999999 5\n", 1, "\"99999999999\" is not a whole number");
    row("unknown directive", "size 1 1\nblend on\n", 2, "\"blend\" is not a directive");
    row("directive in capitals", "size 1 1\nSIZE 1 1\n", 2, "\"SIZE\" is not a directive");
    row("binary", QByteArray("size 1 1\n\0\1\2", 12), 2, "is not a directive");
    row("subpixel bits", "size 1 1\nsubpixel_bits 9\n", 2, "\"9\" is not a whole number from 0 to 8");
    row("exact with a value", "size 1 1\nexact yes\n", 2, "exact: 1 values; none expected");
    row("cull", "size 1 1\ncull sideways\n", 2, "\"sideways\" is not one of back, front, none");
    row("cull without", "size 1 1\ncull\n", 2, "cull: 0 values; one expected");
    row("depth test", "size 1 1\ndepth_test never\n", 2,
        "\"never\" is not one of less, lequal, equal, gequal, greater, notequal, none");
    row("depth format", "size 1 1\ndepth_format float16\n", 2, "\"float16\" is not one of float32, unorm16, unorm24");
    row("zrange", "size 1 1\nzrange vulkan\n", 2, "\"vulkan\" is not one of gl, d3d");
    row("ssaa", "size 1 1\nssaa 5\n", 2, "\"5\" is not a whole number from 1 to 4");
    row("clear out of range", "size 1 1\nclear 0 1.5 0\n", 2, "clear: \"1.5\" is not from 0 to 1");
    row("clear nan", "size 1 1\nclear 0 nan 0\n", 2, "clear: \"nan\" is not finite");
    row("clear of two", "size 1 1\nclear 0 0\n", 2, "clear: 2 values; red, green and blue expected");
    row("window of three", "size 8 8\nwindow 1 1 1\n", 2, "window: 3 values");
    row("window outside", "window 4 4 5 4\nsize 8 8\n", 1, "not within the size 8 x 8");
    row("window empty", "size 8 8\nwindow 4 4 0 4\n", 2, "window: it is empty");
    row("line of 21", "size 1 1\nline" + kTri.mid(3), 2, "line: 21 values; 14 (x y z w r g b of both ends) expected");
    row("line of one end", "size 1 1\nline 0 0 0 1 1 1 1\n", 2, "line: 7 values; 14");
    row("line with a word", "size 1 1\nline 0 0 0 one 1 1 1  1 0 0 1 1 1 1\n", 2, "line: \"one\" is not a number");
    row("line colour nan", "size 1 1\nline 0 0 0 1 1 nan 1  1 0 0 1 1 1 1\n", 2, "\"nan\" is not finite");
    row("line rule", "size 1 1\nline_rule open\n", 2, "\"open\" is not one of inclusive, half-open, diamond-exit");
    row("line ties", "size 1 1\nline_ties none\n", 2, "\"none\" is not one of by-direction, canonical");
    row("lines elsewhere", "size 1 1\nlines 1\n", 2, "\"lines\" is not a directive");
    row("second pass before lines", "size 1 1\nsecond_pass\nline 0 0 0 1 1 1 1  1 0 0 1 1 1 1\n", 2,
        "behind the triangles and lines of the first pass");
    row("tri of 20", "size 1 1\ntri 0 0 0 1 1 0 0  1 0 0 1 0 1 0  0 1 0 1 0 0\n", 2, "tri: 20 values; 21");
    row("texture without", "size 1 1\ntexture\n", 2, "the name of an image, is expected");
    row("texture without a size", "size 1 1\ntexture checker\n", 2, "texture: 0 values; one expected");
    row("texture too large", "size 1 1\ntexture checker 1025\n", 2, "\"1025\" is not a whole number from 1 to 1024");
    row("texture that is not there", "size 1 1\ntexture no.png\n", 2, "there is no such file");
    row("texture filter", "size 1 1\ntexture_filter cubic\n", 2,
        "\"cubic\" is not one of nearest, bilinear, trilinear");
    row("triuv of 21", "size 1 1\ntriuv" + kTri.mid(3), 2, "triuv: 21 values; 27");
    row("triuv with nan", "size 1 1\ntriuv 0 0 0 1 1 0 0 nan 0  1 0 0 1 0 1 0 0 0  0 1 0 1 0 0 1 0 0\n", 2,
        "not finite");
    row("tri of 22", "size 1 1\n" + kTri.trimmed() + " 1\n", 2, "tri: 22 values; 21");
    row("tri with a word", "size 1 1\ntri zero" + kTri.mid(5), 2, "\"zero\" is not a number");
    row("tri too large", "size 1 1\ntri 1e39" + kTri.mid(5), 2, "\"1e39\" is beyond the range of float32");
    row("tri too large, hexadecimal", "size 1 1\ntri -0x1p128" + kTri.mid(5), 2, "\"-0x1p128\" is beyond the range");
    row("tri rounds too large", "size 1 1\ntri 0x1.ffffffp127" + kTri.mid(5), 2, "beyond the range of float32");
    row("tri with 0x alone", "size 1 1\ntri 0x" + kTri.mid(5), 2, "\"0x\" is not a number");
    row("tri with 0xinf", "size 1 1\ntri 0xinf" + kTri.mid(5), 2, "\"0xinf\" is not a number");
    row("tri with 0x-1", "size 1 1\ntri 0x-1" + kTri.mid(5), 2, "\"0x-1\" is not a number");
    row("tri with a comma", "size 1 1\ntri 0,5" + kTri.mid(5), 2, "\"0,5\" is not a number");
    row("tri colour nan", "size 1 1\ntri 0 0 0 1 nan 0 0  1 0 0 1 0 1 0  0 1 0 1 0 0 1\n", 2, "\"nan\" is not finite");
    row("expect without a value", "size 1 1\nexpect covered\n", 2, "expect: a key and a value are expected");
    row("truncated", "size 1 1\ntri 0 0 0", 2, "tri: 3 values");
}

void TestCaseFile::broken()
{
    QFETCH(QByteArray, text);
    QFETCH(int, line);
    QFETCH(QString, phrase);
    const SceneLoad load = parse(text);
    QVERIFY(!load.scene);
    verifyRemark(load.diagnostics, QStringLiteral("a.case:%1: ").arg(line), phrase);
    QCOMPARE(load.diagnostics.size(), std::size_t{1});
}

void TestCaseFile::unreadable()
{
    const Folder folder;
    verifyRemark(loadCase(folder.path(QStringLiteral("no.case"))).diagnostics, folder.path(QStringLiteral("no.case: ")),
                 QStringLiteral("no such file"));
    verifyRemark(loadCase(folder.path()).diagnostics, folder.path() + QStringLiteral(": "),
                 QStringLiteral("directory"));
    const QString empty = folder.write(QStringLiteral("empty.case"), {});
    verifyRemark(loadCase(empty).diagnostics, empty + QStringLiteral(": "), QStringLiteral("empty"));
}

void TestCaseFile::sharedCases()
{
    const QDir folder(QStringLiteral(RASTERLENS_SHARED "/cases"));
    QFile file(folder.filePath(QStringLiteral("catalogue.json")));
    if (!file.open(QIODevice::ReadOnly))
        QSKIP("the shared cases (" RASTERLENS_SHARED "/cases) are not there");
    const QJsonArray catalogue = QJsonDocument::fromJson(file.readAll()).array();
    QCOMPARE(catalogue.size(), folder.entryList({QStringLiteral("*.case")}).size());
    for (const QJsonValue& entry : catalogue) {
        const QString name = entry[QLatin1String("name")].toString();
        const SceneLoad load = loadScene(folder.filePath(name + QStringLiteral(".case")));
        QVERIFY2(load.scene && load.diagnostics.empty(), qPrintable(textOf(load.diagnostics)));
        QCOMPARE(load.scene->defaults.size.width(), entry[QLatin1String("size")][0].toInt());
        QCOMPARE(load.scene->defaults.size.height(), entry[QLatin1String("size")][1].toInt());
        QCOMPARE(static_cast<int>(load.scene->mesh.faceCount()), entry[QLatin1String("triangles")].toInt());
        QCOMPARE(load.scene->note, entry[QLatin1String("note")].toString());
        QCOMPARE(load.scene->title, name);
    }
}

QTEST_APPLESS_MAIN(TestCaseFile)
#include "test_case_file.moc"
