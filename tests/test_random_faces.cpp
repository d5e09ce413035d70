// Fixed-point coverage of random faces against the exact reference: not one sample may differ.
// RASTERLENS_FACES=N draws N faces a size class; the CTest label `long` runs a million.
#include "core/truth/exact_reference.h"
#include "tests/support.h"

#include <QTest>

#include <algorithm>
#include <numeric>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

constexpr QSize kViewport(64, 48);
constexpr int kFacesPerPicture = 50;

/// How large the faces are, in pixels, and whether they leave the view volume.
struct SizeClass {
    const char* name;
    double size;
    bool perspective; ///< corners with different w, some behind the eye: near, far and side planes cut
};

constexpr SizeClass kClasses[] = {{"a pixel", 1, false},   {"some pixels", 6, false},
                                  {"a screen", 60, false}, {"larger than the screen", 2000, false},
                                  {"cut, small", 6, true}, {"cut, large", 80, true}};

glm::vec4 corner(Random& random, const glm::dvec2& middle, const SizeClass& c)
{
    const double x = middle.x + uniform(random, -c.size, c.size);
    const double y = middle.y + uniform(random, -c.size, c.size);
    glm::vec4 p = atPixel(x, y, uniform(random, 0.05, 0.95), kViewport);
    if (c.perspective) {
        const auto w = static_cast<float>(uniform(random, -0.5, 2));
        p = glm::vec4(p.x * w, p.y * w, static_cast<float>(uniform(random, -2, 2)), w);
    }
    return p;
}

Scene randomFaces(Random& random, const SizeClass& c)
{
    std::vector<glm::vec4> corners;
    for (int i = 0; i < kFacesPerPicture; ++i) {
        const glm::dvec2 middle(uniform(random, -4, kViewport.width() + 4),
                                uniform(random, -4, kViewport.height() + 4));
        for (int k = 0; k < 3; ++k)
            corners.push_back(corner(random, middle, c));
    }
    return soup(corners);
}

int facesPerClass()
{
    bool good = false;
    const int faces = qEnvironmentVariableIntValue("RASTERLENS_FACES", &good);
    return good ? faces : 2'000;
}

} // namespace

class TestRandomFaces : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everySampleIsRight_data();
    void everySampleIsRight();
};

void TestRandomFaces::everySampleIsRight_data()
{
    QTest::addColumn<int>("sizeClass");
    QTest::addColumn<bool>("anyBits");
    for (int i = 0; i < int(std::size(kClasses)); ++i) {
        QTest::addRow("%s, 8 bits", kClasses[i].name) << i << false;
        QTest::addRow("%s, 0 to 7 bits", kClasses[i].name) << i << true;
    }
}

void TestRandomFaces::everySampleIsRight()
{
    QFETCH(int, sizeClass);
    QFETCH(bool, anyBits);
    Random random = seededRandom();
    const int pictures = facesPerClass() / kFacesPerPicture;
    std::size_t covered = 0;
    for (int i = 0; i < pictures; ++i) {
        const Scene scene = randomFaces(random, kClasses[sizeClass]);
        Settings settings = plainSettings(kViewport);
        settings.subpixelBits = anyBits ? integer(random, 0, 7) : 8;
        settings.clipping = Clipping::Frustum;
        settings.threads = 1; // the pictures are small
        const ExactFrame exact = exactReference(scene, settings);
        covered += std::accumulate(exact.cover.begin(), exact.cover.end(), std::size_t(0));
        for (const Algorithm algorithm : {Algorithm::EdgeEquation, Algorithm::EdgeWalking, Algorithm::Tiled}) {
            settings.algorithm = algorithm;
            const Frame frame = draw(scene, settings);
            QCOMPARE(frame.coverage.size(), exact.cover.size());
            const auto wrong = std::mismatch(exact.cover.begin(), exact.cover.end(), frame.coverage.begin());
            const auto at = std::size_t(wrong.first - exact.cover.begin());
            if (at < exact.cover.size())
                QFAIL(qPrintable(QStringLiteral("picture %1, %2 bits, algorithm %3, pixel (%4, %5): %6 instead of %7")
                                     .arg(i)
                                     .arg(settings.subpixelBits)
                                     .arg(int(algorithm))
                                     .arg(at % std::size_t(kViewport.width()))
                                     .arg(at / std::size_t(kViewport.width()))
                                     .arg(*wrong.second)
                                     .arg(*wrong.first)));
        }
    }
    QVERIFY(covered > std::size_t(pictures)); // the faces are seen
}

QTEST_APPLESS_MAIN(TestRandomFaces)
#include "test_random_faces.moc"
