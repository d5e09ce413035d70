// How far depths and colours are from the exact ones, over random faces in perspective. Prints the worst of every row:
// these are the figures of docs/ACCURACY.md. RASTERLENS_FACES=N draws N faces a row.
#include "core/truth/exact_reference.h"
#include "tests/support.h"

#include <QTest>

#include <array>
#include <limits>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

constexpr QSize kViewport(160, 120);
constexpr int kFacesPerPicture = 16;
constexpr double kNear = 1;
constexpr double kRange = 1e4; ///< the far plane

/// How faces lie on the screen.
struct Shape {
    const char* name;
    double size; ///< pixels
    bool sliver; ///< the third corner lies within half a pixel of the line between the others
};
constexpr Shape kShapes[] = {{"3 px", 3, false}, {"20 px", 20, false}, {"120 px", 120, false}, {"sliver", 120, true}};

std::array<glm::dvec2, 3> cornersPixels(Random& random, const Shape& shape)
{
    const auto jitter = [&](double size) {
        return glm::dvec2(uniform(random, -size, size), uniform(random, -size, size));
    };
    const glm::dvec2 size(kViewport.width(), kViewport.height());
    const glm::dvec2 middle = size * glm::dvec2(uniform(random, 0, 1), uniform(random, 0, 1));
    std::array<glm::dvec2, 3> corners;
    for (glm::dvec2& corner : corners)
        corner = glm::clamp(middle + jitter(shape.size), glm::dvec2(0), size);
    if (shape.sliver)
        corners[2] =
            glm::clamp(glm::mix(corners[0], corners[1], uniform(random, 0, 1)) + jitter(0.5), glm::dvec2(0), size);
    return corners;
}

/// The point of the screen at the distance w, projected with near 1 and that far plane.
glm::vec4 projected(const glm::dvec2& pixels, double w, double far)
{
    const double zNdc = (far + kNear) / (far - kNear) - 2 * far * kNear / ((far - kNear) * w);
    const glm::vec4 p = atPixel(pixels.x, pixels.y, 0, kViewport);
    return {float(double(p.x) * w), float(double(p.y) * w), float(zNdc * w), float(w)};
}

/// Faces within the depth range whose corners are at most `ratio` times as far from the eye as each other.
Scene randomFaces(Random& random, const Shape& shape, double ratio)
{
    std::vector<glm::vec4> corners;
    for (int i = 0; i < kFacesPerPicture; ++i) {
        const double nearest = kNear * std::exp(uniform(random, 0, std::log(kRange / ratio)));
        for (const glm::dvec2& pixels : cornersPixels(random, shape))
            corners.push_back(projected(pixels, nearest * std::exp(uniform(random, 0, std::log(ratio))), kRange));
    }
    Scene scene = soup(corners);
    for (MeshVertex& vertex : scene.mesh.vertices)
        vertex.color = {float(uniform(random, 0, 1)), float(uniform(random, 0, 1)), float(uniform(random, 0, 1))};
    return scene;
}

/// The distance from one float32 to the next at a value.
double unitInTheLastPlace(double value)
{
    const auto nearest = static_cast<float>(value);
    return double(std::nextafter(nearest, std::numeric_limits<float>::infinity())) - double(nearest);
}

struct Worst {
    double depthUlps = 0;  ///< of the value
    double depth = 0;      ///< depth units
    double colorSteps = 0; ///< the 8-bit value from the exact colour
    std::size_t samples = 0;

    void add(const Frame& frame, const ExactFrame& exact)
    {
        const auto* pixels = reinterpret_cast<const QRgb*>(frame.image.constBits());
        for (std::size_t i = 0; i < exact.id.size(); ++i) {
            if (exact.id[i] < 0 || frame.ids[i] != exact.id[i])
                continue;
            ++samples;
            const double error = std::abs(double(frame.depth[i]) - exact.depth[i]);
            depth = std::max(depth, error);
            depthUlps = std::max(depthUlps, error / unitInTheLastPlace(exact.depth[i]));
            const glm::dvec3 shown(qRed(pixels[i]), qGreen(pixels[i]), qBlue(pixels[i]));
            const glm::dvec3 steps = glm::abs(shown - 255.0 * glm::clamp(exact.color[i], 0.0, 1.0));
            colorSteps = std::max({colorSteps, steps.r, steps.g, steps.b});
        }
    }
};

Worst measure(const Settings& settings, const Shape& shape, double ratio)
{
    Random random = seededRandom();
    bool given = false;
    const int wanted = qEnvironmentVariableIntValue("RASTERLENS_FACES", &given);
    const int pictures = (given ? wanted : 320) / kFacesPerPicture;
    Worst worst;
    for (int i = 0; i < pictures; ++i) {
        const Scene scene = randomFaces(random, shape, ratio);
        worst.add(draw(scene, settings), exactReference(scene, settings));
    }
    qInfo("%zu samples: depth %.3g ulp, %.3g; colour %.4f steps", worst.samples, worst.depthUlps, worst.depth,
          worst.colorSteps);
    return worst;
}

struct Way {
    Algorithm algorithm;
    AttributePath path;
    const char* name;
};
constexpr Way kWays[] = {{Algorithm::EdgeEquation, AttributePath::Planes, "edge-equation"},
                         {Algorithm::EdgeWalking, AttributePath::Planes, "edge-walking"},
                         {Algorithm::EdgeWalking, AttributePath::EdgeThenSpan, "edge-walking, edge-then-span"},
                         {Algorithm::Tiled, AttributePath::Planes, "tiled"}};

} // namespace

class TestAccuracy : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void depthsAndColors_data();
    void depthsAndColors();
};

void TestAccuracy::depthsAndColors_data()
{
    QTest::addColumn<int>("way");
    QTest::addColumn<int>("shape");
    QTest::addColumn<double>("ratio");
    for (int way = 0; way < int(std::size(kWays)); ++way)
        for (int shape = 0; shape < int(std::size(kShapes)); ++shape)
            for (const double ratio : {1.0, 10.0, 100.0, 1e4})
                QTest::addRow("%s, %s, w ratio %g", kWays[way].name, kShapes[shape].name, ratio)
                    << way << shape << ratio;
}

void TestAccuracy::depthsAndColors()
{
    QFETCH(int, way);
    QFETCH(int, shape);
    QFETCH(double, ratio);
    Settings settings = plainSettings(kViewport);
    settings.algorithm = kWays[way].algorithm;
    settings.attributePath = kWays[way].path;
    const Worst worst = measure(settings, kShapes[shape], ratio);
    QVERIFY(worst.samples > 500);
    QVERIFY(worst.depthUlps <= 2);
    if (ratio <= 100)
        QVERIFY(worst.colorSteps <= 0.51);
}

QTEST_APPLESS_MAIN(TestAccuracy)
#include "test_accuracy.moc"
