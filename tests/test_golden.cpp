// A few exact pictures. RASTERLENS_SAVE_GOLDEN=1 saves them anew; look at them before committing.
#include "tests/support.h"

#include <QDir>
#include <QTest>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

struct Picture {
    const char* name;
    const char* scene;
    QSize size;
    void (*adjust)(Settings&);
};

const Picture kPictures[] = {
    {"teapot", "teapot", {160, 120}, [](Settings&) {}},
    {"letter-f-wireframe", "letter-f", {160, 120}, [](Settings& s) { s.fill = Fill::Wireframe; }},
    {"floor-perspective", "floor", {160, 120}, [](Settings&) {}},
    {"floor-affine", "floor", {160, 120}, [](Settings& s) { s.interpolation = Interpolation::Affine; }},
    {"square-diagonal", "square-diagonal", {8, 8}, [](Settings&) {}},
    {"torus-knot-normals-2x2",
     "torus-knot",
     {120, 90},
     [](Settings& s) {
         s.shading = Shading::Normals;
         s.samples = Samples::Grid2;
     }},
};

} // namespace

class TestGolden : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void pictures_data();
    void pictures();
};

void TestGolden::pictures_data()
{
    QTest::addColumn<int>("index");
    for (std::size_t i = 0; i < std::size(kPictures); ++i)
        QTest::newRow(kPictures[i].name) << int(i);
}

void TestGolden::pictures()
{
    QFETCH(int, index);
    const Picture& picture = kPictures[index];
    const Scene scene = *makeBuiltinScene(QLatin1String(picture.scene)).scene;
    Settings settings = scene.defaults;
    settings.size = picture.size;
    picture.adjust(settings);
    Frame frame;
    render(scene, settings, frame);

    const QString file = QLatin1String(picture.name) + QStringLiteral(".png");
    const QString expectedPath = QStringLiteral(RASTERLENS_GOLDEN "/") + file;
    const QString foundPath = QDir::current().absoluteFilePath(QStringLiteral("golden-") + file);
    if (qEnvironmentVariableIntValue("RASTERLENS_SAVE_GOLDEN") == 1) {
        QVERIFY2(frame.image.save(expectedPath), qPrintable(expectedPath));
        return;
    }
    QImage expected;
    const bool loaded = expected.load(expectedPath);
    if (loaded && expected.convertToFormat(QImage::Format_RGB32) == frame.image)
        return;
    QVERIFY2(frame.image.save(foundPath), qPrintable(foundPath));
    QFAIL(qPrintable(QStringLiteral("%1: expected %2, found %3")
                         .arg(loaded ? QStringLiteral("another picture") : QStringLiteral("no picture to compare with"),
                              expectedPath, foundPath)));
}

QTEST_APPLESS_MAIN(TestGolden)
#include "test_golden.moc"
