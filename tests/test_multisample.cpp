// Multi-sampling: where samples lie, what they cover, how often a face is shaded, where attributes are taken, and the
// mean. RASTERLENS_FACES=N draws N random faces a pattern; the CTest label `long` runs a million.
#include "core/observe/step_cursor.h"
#include "core/observe/step_record.h"
#include "core/pipeline/framebuffer.h"
#include "core/render/steps.h"
#include "core/scenes/load_scene.h"
#include "core/settings/sample_pattern.h"
#include "core/truth/exact_reference.h"
#include "core/truth/hard_cases.h"
#include "tests/support.h"

#include <QDir>
#include <QTest>

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>
#include <set>
#include <vector>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

constexpr QSize kViewport(64, 48);
constexpr std::array kPatterns{Samples::Msaa2, Samples::Msaa4, Samples::Msaa8, Samples::Msaa16};
constexpr Outputs kCounts{.depth = true, .ids = true, .coverage = true, .sampleCoverage = true};

Frame drawCounts(const Scene& scene, const Settings& settings)
{
    Frame frame;
    render(scene, settings, frame, kCounts);
    return frame;
}

Settings settingsWith(Samples samples, QSize size = kViewport)
{
    Settings settings = plainSettings(size);
    settings.samples = samples;
    return settings;
}

/// A rectangle of two triangles that share its diagonal, in pixels, with colours by corner.
Scene rectangle(glm::dvec2 from, glm::dvec2 to, QSize size, double depth = 0.5)
{
    return clipScene({atPixel(from.x, from.y, depth, size), atPixel(from.x, to.y, depth, size),
                      atPixel(to.x, to.y, depth, size), atPixel(to.x, from.y, depth, size)},
                     {0, 1, 2, 2, 3, 0});
}

Scene randomFaces(Random& random, int count)
{
    constexpr std::array kSizes{1.0, 6.0, 60.0, 2000.0};
    std::vector<glm::vec4> corners;
    for (int i = 0; i < count; ++i) {
        const double reach = kSizes[std::size_t(integer(random, 0, 3))];
        const bool isCut = integer(random, 0, 2) == 0;
        const glm::dvec2 middle(uniform(random, -4, kViewport.width() + 4),
                                uniform(random, -4, kViewport.height() + 4));
        for (int k = 0; k < 3; ++k) {
            const double x = middle.x + uniform(random, -reach, reach);
            const double y = middle.y + uniform(random, -reach, reach);
            glm::vec4 p = atPixel(x, y, uniform(random, 0.05, 0.95), kViewport);
            if (isCut) {
                const auto w = static_cast<float>(uniform(random, -0.5, 2));
                p = glm::vec4(p.x * w, p.y * w, static_cast<float>(uniform(random, -2, 2)), w);
            }
            corners.push_back(p);
        }
    }
    return soup(corners);
}

/// Where the counts of a frame and of the truth differ first, for every algorithm that draws patterns.
QString wrongCount(const Scene& scene, Settings settings)
{
    const ExactFrame truth = exactReference(scene, settings);
    for (const Algorithm algorithm : algorithmsFor(scene, settings)) {
        settings.algorithm = algorithm;
        const Frame frame = drawCounts(scene, settings);
        const PixelRect& w = truth.window;
        std::size_t i = 0; // of the truth, which may know a part of the viewport only
        for (int sample = 0; sample < truth.patternSamples; ++sample)
            for (int y = w.y; y < w.y + w.height; ++y)
                for (int x = w.x; x < w.x + w.width; ++x, ++i) {
                    const int row = sample * settings.size.height() + y;
                    const std::size_t at = std::size_t(row) * std::size_t(settings.size.width()) + std::size_t(x);
                    if (frame.sampleCoverage.at(at) != truth.cover.at(i))
                        return QStringLiteral("%1, %2 bits, sample %3 of (%4, %5): %6 instead of %7")
                            .arg(QLatin1String(idOf(algorithm)))
                            .arg(settings.subpixelBits)
                            .arg(sample)
                            .arg(x)
                            .arg(y)
                            .arg(frame.sampleCoverage[at])
                            .arg(truth.cover[i]);
                }
        if (i != truth.cover.size())
            return QStringLiteral("%1 counts and %2").arg(i).arg(truth.cover.size());
    }
    return {};
}

/// A triangle in units of 1/256 pixel, counter-clockwise with y up: the top-left rule in integers, worked out without
/// any of the program's types.
bool coversPoint(const std::array<std::array<long, 2>, 3>& corners, long x, long y)
{
    for (std::size_t i = 0; i < 3; ++i) {
        const auto& [ax, ay] = corners[i];
        const auto& [bx, by] = corners[(i + 1) % 3];
        const long side = (by - ay) * (x - ax) - (bx - ax) * (y - ay);
        const bool owns = by > ay || (by == ay && bx < ax);
        if (side < 0 || (side == 0 && !owns))
            return false;
    }
    return true;
}

} // namespace

class TestMultisample : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void patternsAreTheStandardOnes();
    void coverageIsThatOfIntegers();
    void randomFacesAreExact_data();
    void randomFacesAreExact();
    void casesAreExact();
    void samplesOnAnEdgeHaveOneOwner();
    void countsOfGridsLieByPattern();
    void aFaceIsShadedOnceAPixel();
    void attributesAreTakenWhereAsked();
    void depthIsThatOfTheSample();
    void meanIsOfValuesOrOfLight();
    void stepsComeToThePicture_data();
    void stepsComeToThePicture();
};

/// The fractions of the Vulkan specification ("Standard sample locations"), and what patterns of this kind have: each
/// column and each row of the 16 x 16 grid holds at most one sample.
void TestMultisample::patternsAreTheStandardOnes()
{
    const std::vector<std::pair<int, std::vector<glm::dvec2>>> standard{
        {1, {{0.5, 0.5}}},
        {2, {{0.75, 0.75}, {0.25, 0.25}}},
        {4, {{0.375, 0.125}, {0.875, 0.375}, {0.125, 0.625}, {0.625, 0.875}}},
        {8,
         {{0.5625, 0.3125},
          {0.4375, 0.6875},
          {0.8125, 0.5625},
          {0.3125, 0.1875},
          {0.1875, 0.8125},
          {0.0625, 0.4375},
          {0.6875, 0.9375},
          {0.9375, 0.0625}}},
        {16,
         {{0.5625, 0.5625},
          {0.4375, 0.3125},
          {0.3125, 0.625},
          {0.75, 0.4375},
          {0.1875, 0.375},
          {0.625, 0.8125},
          {0.8125, 0.6875},
          {0.6875, 0.1875},
          {0.375, 0.875},
          {0.5, 0.0625},
          {0.25, 0.125},
          {0.125, 0.75},
          {0.0, 0.5},
          {0.9375, 0.25},
          {0.875, 0.9375},
          {0.0625, 0.0}}},
    };
    for (const auto& [count, points] : standard) {
        const auto pattern = samplePattern(count);
        QCOMPARE(int(pattern.size()), count);
        std::set<double> columns;
        std::set<double> rows;
        for (std::size_t i = 0; i < pattern.size(); ++i) {
            QCOMPARE(pattern[i].pixels() + 0.5, points[i]);
            columns.insert(points[i].x);
            rows.insert(points[i].y);
        }
        QCOMPARE(int(columns.size()), count);
        QCOMPARE(int(rows.size()), count);
    }
    QCOMPARE(samplesPerPixel(Samples::Msaa2), 2);
    QCOMPARE(samplesPerPixel(Samples::Msaa16), 16);
    QCOMPARE(samplesPerPixel(Samples::Grid3), 9);
}

/// Corners on the lattice of 1/256 pixel, edges through samples included.
void TestMultisample::coverageIsThatOfIntegers()
{
    Random random = seededRandom();
    constexpr int kSide = 16;
    const QSize size(kSide, kSide);
    int covered = 0;
    for (int round = 0; round < casesOfBuild(400); ++round) {
        const int coarse = round % 2 == 0 ? 16 : 1; // sixteenths of a pixel meet samples exactly
        std::array<std::array<long, 2>, 3> corners{};
        for (auto& corner : corners)
            corner = {long(integer(random, 0, kSide * 256 / coarse)) * coarse,
                      long(integer(random, 0, kSide * 256 / coarse)) * coarse};
        const auto at = [&](std::size_t i) {
            return atPixel(double(corners[i][0]) / 256, double(corners[i][1]) / 256, 0.5, size);
        };
        const Scene scene = soup({at(0), at(1), at(2)});
        const long area = (corners[1][1] - corners[0][1]) * (corners[2][0] - corners[0][0]) -
                          (corners[1][0] - corners[0][0]) * (corners[2][1] - corners[0][1]);
        if (area == 0)
            continue;
        if (area < 0)
            std::swap(corners[1], corners[2]);
        const Samples samples = kPatterns[std::size_t(round / 2) % kPatterns.size()];
        const Frame frame = drawCounts(scene, settingsWith(samples, size));
        const int count = patternSamples(samples);
        for (int sample = 0; sample < count; ++sample)
            for (int y = 0; y < kSide; ++y)
                for (int x = 0; x < kSide; ++x) {
                    const SampleOffset offset = samplePattern(count)[std::size_t(sample)];
                    const bool expected =
                        coversPoint(corners, x * 256 + 128 + offset.x * 16, y * 256 + 128 + offset.y * 16);
                    QCOMPARE(int(frame.sampleCoverage[std::size_t((sample * kSide + y) * kSide + x)]), int(expected));
                    covered += expected ? 1 : 0;
                }
    }
    QVERIFY(covered > casesOfBuild(10'000));
}

void TestMultisample::randomFacesAreExact_data()
{
    QTest::addColumn<int>("samples");
    for (const Samples samples : kPatterns)
        QTest::addRow("msaa%d", patternSamples(samples)) << int(samples);
}

void TestMultisample::randomFacesAreExact()
{
    QFETCH(int, samples);
    bool given = false;
    const int asked = qEnvironmentVariableIntValue("RASTERLENS_FACES", &given);
    constexpr int kFacesPerPicture = 50;
    Random random = seededRandom();
    for (int i = 0; i < (given ? asked : casesOfBuild(1500)) / kFacesPerPicture; ++i) {
        const Scene scene = randomFaces(random, kFacesPerPicture);
        Settings settings = settingsWith(static_cast<Samples>(samples));
        settings.subpixelBits = i % 2 == 0 ? 8 : integer(random, 0, 7);
        const QString wrong = wrongCount(scene, settings);
        QVERIFY2(wrong.isEmpty(), qPrintable(QStringLiteral("picture %1: %2").arg(i).arg(wrong)));
    }
}

/// The cases of the program, and those beside the project where they are.
void TestMultisample::casesAreExact()
{
    QStringList paths;
    for (const QString& name : hardCaseNames())
        paths << hardCasePath(name);
    const QDir shared(QStringLiteral(RASTERLENS_SHARED "/cases"));
    for (const QString& name : shared.entryList({QStringLiteral("*.case")}))
        paths << shared.filePath(name);
    int compared = 0;
    for (const QString& path : paths) {
        const SceneLoad load = loadScene(path);
        QVERIFY2(load.scene, qPrintable(path));
        const Scene& scene = *load.scene;
        for (const Samples samples : kPatterns) {
            Settings settings = scene.defaults;
            settings.samples = samples;
            constexpr std::int64_t kMost = std::int64_t(1) << 25;
            if (std::int64_t(settings.size.width()) * settings.size.height() * patternSamples(samples) > kMost)
                continue;      // 16384 x 16384
            if (scene.exact) { // the truth does not snap: within what snapping may move
                const CaseVerdict verdict = judgeCase(scene, caseTruth(scene, samples), settings);
                QVERIFY2(verdict.grade != CaseGrade::Fails, qPrintable(path));
                continue;
            }
            ++compared;
            const QString wrong = wrongCount(scene, settings);
            QVERIFY2(wrong.isEmpty(), qPrintable(path + QStringLiteral(": ") + wrong));
        }
    }
    QVERIFY(compared >= 200);
    qInfo("%d comparisons of %d cases", compared, int(paths.size()));
}

/// A shared edge exactly through samples: each belongs to one face, so that the masks of the two make up the pixel's.
void TestMultisample::samplesOnAnEdgeHaveOneOwner()
{
    const QSize size(8, 8);
    for (const Samples samples : kPatterns) {
        const int count = patternSamples(samples);
        int ties = 0;
        for (int x16 = 0; x16 <= 16; ++x16) { // the diagonal, shifted by sixteenths of a pixel
            const double x = 1 + x16 / 16.0;
            const Scene scene = rectangle({x, 1}, {x + 5, 6}, size);
            Settings settings = settingsWith(samples, size);
            const Frame both = drawCounts(scene, settings);
            Scene first = scene;
            first.mesh.indices = {0, 1, 2};
            Scene second = scene;
            second.mesh.indices = {2, 3, 0};
            const Frame one = drawCounts(first, settings);
            const Frame other = drawCounts(second, settings);
            settings.tieRule = TieRule::Inclusive;
            const Frame inclusive = drawCounts(scene, settings);
            for (std::size_t i = 0; i < both.sampleCoverage.size(); ++i) {
                QVERIFY(both.sampleCoverage[i] <= 1);
                QCOMPARE(int(one.sampleCoverage[i]) + int(other.sampleCoverage[i]), int(both.sampleCoverage[i]));
                ties += inclusive.sampleCoverage[i] == 2 ? 1 : 0;
            }
            // inside the rectangle no sample is left out
            for (int sample = 0; sample < count; ++sample)
                for (int y = 2; y < 5; ++y)
                    for (int column = 3; column < 6; ++column)
                        QCOMPARE(int(both.sampleCoverage[std::size_t((sample * 8 + y) * 8 + column)]), 1);
            Frame frame;
            QCOMPARE(renderCounted(scene, settingsWith(samples, size), frame).pixels.coveredTwice, std::uint64_t(0));
            const std::uint64_t twice = renderCounted(scene, settings, frame).pixels.coveredTwice;
            QCOMPARE(twice, std::uint64_t(std::ranges::count(inclusive.sampleCoverage, 2)));
        }
        QVERIFY(ties > 0);
    }
}

/// The counts of a grid of 2 x 2 are those of a picture of twice the size, the sample's number first.
void TestMultisample::countsOfGridsLieByPattern()
{
    Random random = seededRandom();
    const Scene scene = randomFaces(random, 30);
    const Frame grid = drawCounts(scene, settingsWith(Samples::Grid2));
    Settings large = settingsWith(Samples::One, kViewport * 2);
    large.subpixelBits = 7; // the same lattice
    const Frame twice = drawCounts(scene, large);
    const int width = kViewport.width();
    const int height = kViewport.height();
    QCOMPARE(twice.sampleCoverage.size(), grid.sampleCoverage.size());
    for (int sample = 0; sample < 4; ++sample)
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                QCOMPARE(grid.sampleCoverage[std::size_t((sample * height + y) * width + x)],
                         twice.coverage[std::size_t((2 * y + sample / 2) * 2 * width + 2 * x + sample % 2)]);
    QVERIFY(twice.sampleCoverage == twice.coverage);
}

void TestMultisample::aFaceIsShadedOnceAPixel()
{
    Random random = seededRandom();
    for (const Samples samples : kPatterns) {
        const Scene scene = randomFaces(random, 20);
        Settings settings = settingsWith(samples);
        settings.visibility = Visibility::SubmissionOrder;
        std::uint64_t pixels = 0;
        std::uint64_t covered = 0;
        for (std::size_t face = 0; face < scene.mesh.faceCount(); ++face) {
            Scene alone = scene;
            alone.mesh.indices.assign(scene.mesh.indices.begin() + std::ptrdiff_t(3 * face),
                                      scene.mesh.indices.begin() + std::ptrdiff_t(3 * face + 3));
            const Frame frame = drawCounts(alone, settings);
            const std::size_t plane = frame.coverage.size();
            for (std::size_t i = 0; i < plane; ++i) {
                int mask = 0;
                for (std::size_t at = i; at < frame.sampleCoverage.size(); at += plane)
                    mask += frame.sampleCoverage[at];
                covered += std::uint64_t(mask);
                pixels += mask > 0 ? 1 : 0;
            }
        }
        Frame frame;
        const Statistics::Pixels counted = renderCounted(scene, settings, frame).pixels;
        QCOMPARE(counted.covered, covered);
        QCOMPARE(counted.written, covered);
        // a piece of a cut face is a triangle of its own: at their seams a pixel is shaded for each
        QVERIFY(counted.shaded >= pixels && counted.shaded < covered);
        settings.attributeAt = AttributeAt::Sample;
        QCOMPARE(renderCounted(scene, settings, frame).pixels.shaded, covered);
    }
    // uncut: exactly once
    const Scene whole = rectangle({3.3, 2.2}, {50.7, 40.1}, kViewport);
    Scene half = whole;
    half.mesh.indices = {0, 1, 2};
    const Frame counts = drawCounts(half, settingsWith(Samples::Msaa4));
    std::uint64_t pixels = 0;
    for (std::size_t i = 0; i < counts.coverage.size(); ++i)
        pixels += counts.sampleCoverage[i] + counts.sampleCoverage[i + counts.coverage.size()] +
                              counts.sampleCoverage[i + 2 * counts.coverage.size()] +
                              counts.sampleCoverage[i + 3 * counts.coverage.size()] >
                          0
                      ? 1
                      : 0;
    Frame frame;
    QCOMPARE(renderCounted(half, settingsWith(Samples::Msaa4), frame).pixels.shaded, pixels);
}

/// Red rises by 1/4 a pixel to the right. The face covers one sample of pixel 2, that at 2.125: at the centre, 2.5, red
/// would be 0.625, beyond the face; at the sample it is 0.53125.
void TestMultisample::attributesAreTakenWhereAsked()
{
    const QSize size(4, 4);
    Scene scene = rectangle({0, 0}, {2.25, 4}, size);
    for (std::size_t i = 0; i < 4; ++i)
        scene.mesh.vertices[i].color = {i < 2 ? 0.0F : 0.5625F, 0, 0};
    const auto redAt = [&](AttributeAt at, int x, ResolveLight light = ResolveLight::Gamma) {
        Settings settings = settingsWith(Samples::Msaa4, size);
        settings.attributeAt = at;
        settings.resolveLight = light;
        const Frame frame = drawCounts(scene, settings);
        int mask = 0;
        for (std::size_t sample = 0; sample < 4; ++sample)
            mask += frame.sampleCoverage[sample * 16 + 2];
        return mask == 1 ? qRed(frame.image.pixel(x, 0)) : -1; // the top row, where no pixel is cut by the diagonal
    };
    const auto mean = [](std::array<int, 4> samples) {
        return (std::accumulate(samples.begin(), samples.end(), 0) + 2) / 4;
    };
    QCOMPARE(redAt(AttributeAt::Centre, 2), mean({159, 0, 0, 0}));   // round(0.625 * 255) = 159
    QCOMPARE(redAt(AttributeAt::Centroid, 2), mean({135, 0, 0, 0})); // round(0.53125 * 255) = 135
    QCOMPARE(redAt(AttributeAt::Sample, 2), mean({135, 0, 0, 0}));
    // covered whole: the centroid is the centre, at 1.5; the samples are at 1.375, 1.875, 1.125, 1.625
    QCOMPARE(redAt(AttributeAt::Centre, 1), 96); // round(0.375 * 255)
    QCOMPARE(redAt(AttributeAt::Centroid, 1), 96);
    QCOMPARE(redAt(AttributeAt::Sample, 1), mean({88, 120, 72, 104})); // of 0.34375, 0.46875, 0.28125, 0.40625
}

/// Depth is 0.25 at the left border and 0.75 at the right one: the first sample of pixel x lies at x + 0.375.
void TestMultisample::depthIsThatOfTheSample()
{
    const QSize size(16, 16);
    Scene scene = clipScene({atPixel(0, 0, 0.25, size), atPixel(0, 16, 0.25, size), atPixel(16, 16, 0.75, size),
                             atPixel(16, 0, 0.75, size)},
                            {0, 1, 2, 2, 3, 0});
    const Frame frame = drawCounts(scene, settingsWith(Samples::Msaa4, size));
    for (int x = 0; x < 16; ++x)
        QCOMPARE(frame.depth[std::size_t(5 * 16 + x)], float(0.25 + (x + 0.375) / 32));
    // A second face at the depth of the centre, 0.25 + 8.5 / 32: in pixel 8 it is nearer than the slope at the samples
    // right of the centre, two of four.
    const float middle = 0.25F + 8.5F / 32;
    for (const glm::vec4 corner : {atPixel(0, 0, middle, size), atPixel(0, 16, middle, size),
                                   atPixel(16, 16, middle, size), atPixel(16, 0, middle, size)}) {
        MeshVertex vertex;
        vertex.position = corner;
        vertex.color = {1, 1, 1};
        scene.mesh.vertices.push_back(vertex);
    }
    for (std::size_t i = 0; i < 4; ++i)
        scene.mesh.vertices[i].color = {0, 0, 0};
    for (const std::uint32_t i : {4U, 5U, 6U, 6U, 7U, 4U})
        scene.mesh.indices.push_back(i);
    const Frame crossed = drawCounts(scene, settingsWith(Samples::Msaa4, size));
    QCOMPARE(qRed(crossed.image.pixel(7, 3)), 0);
    QCOMPARE(qRed(crossed.image.pixel(8, 3)), 128); // two of four samples are white: 127.5
    QCOMPARE(qRed(crossed.image.pixel(9, 3)), 255);
}

void TestMultisample::meanIsOfValuesOrOfLight()
{
    const std::array<std::uint32_t, 2> half{0xffffffff, 0xff000000};
    QCOMPARE(meanColor(half, ResolveLight::Gamma), 0xff808080);
    QCOMPARE(meanColor(half, ResolveLight::Linear), 0xffbcbcbc); // sRGB of half the light is 0.7354 = 187.5 / 255
    for (std::uint32_t value = 0; value < 256; ++value) {
        const std::array<std::uint32_t, 3> same{0xff000000 | value, 0xff000000 | value, 0xff000000 | value};
        QCOMPARE(meanColor(same, ResolveLight::Linear), 0xff000000 | value);
    }
    // white over black, the edge through the middle of a pixel: half of its samples
    const QSize size(4, 4);
    Scene scene = rectangle({0, 0}, {1.5, 4}, size);
    for (MeshVertex& vertex : scene.mesh.vertices)
        vertex.color = {1, 1, 1};
    for (const Samples samples : {Samples::Msaa4, Samples::Grid2}) {
        Settings settings = settingsWith(samples, size);
        QCOMPARE(draw(scene, settings).image.pixel(1, 1), 0xff808080U);
        settings.resolveLight = ResolveLight::Linear;
        QCOMPARE(draw(scene, settings).image.pixel(1, 1), 0xffbcbcbcU);
    }
}

void TestMultisample::stepsComeToThePicture_data()
{
    QTest::addColumn<int>("samples");
    QTest::addColumn<int>("algorithm");
    for (const Samples samples : kPatterns)
        for (const Algorithm algorithm : {Algorithm::EdgeEquation, Algorithm::EdgeWalking})
            QTest::addRow("msaa%d, %s", patternSamples(samples), idOf(algorithm)) << int(samples) << int(algorithm);
}

/// A record that is drawn anew from moments in the middle shows what a log of all events shows, forward and back.
void TestMultisample::stepsComeToThePicture()
{
    QFETCH(int, samples);
    QFETCH(int, algorithm);
    Random random = seededRandom();
    const auto scene = std::make_shared<const Scene>(randomFaces(random, 8));
    Settings settings = settingsWith(static_cast<Samples>(samples));
    settings.algorithm = static_cast<Algorithm>(algorithm);
    StepFilter all;
    all.cap = std::size_t(4) << 20;
    StepCursor whole(renderSteps(*scene, settings, all));
    const auto record = recordSteps(scene, settings, {}, {}, {500, std::size_t(4) << 20, 900});
    QCOMPARE(record->size(), whole.size());
    StepCursor cursor(record);
    std::size_t to = record->size();
    for (int i = 0; i < 40; ++i) {
        cursor.moveTo(to);
        whole.moveTo(to);
        QVERIFY(cursor.image() == whole.image());
        QVERIFY(std::ranges::equal(cursor.sampleColors(), whole.sampleColors()));
        QVERIFY(std::ranges::equal(cursor.sampleDepths(), whole.sampleDepths()));
        QVERIFY(std::ranges::equal(cursor.sampleOwners(), whole.sampleOwners()));
        QVERIFY(cursor.counters() == whole.counters());
        if (to > 0 && cursor.lastEvent() != nullptr)
            QCOMPARE(cursor.lastEvent()->sample, whole.lastEvent()->sample);
        to = i % 3 == 0 && to > 0 ? to - 1 : std::size_t(random() % (record->size() + 1));
    }
    whole.moveTo(whole.size());
    Frame frame;
    const Statistics statistics = renderCounted(*scene, settings, frame);
    QVERIFY(whole.image() == frame.image);
    QVERIFY(whole.counters() == statistics);
    whole.moveTo(0);
    QVERIFY(std::ranges::all_of(whole.sampleOwners(), [](std::int32_t owner) { return owner == -1; }));
}

QTEST_APPLESS_MAIN(TestMultisample)
#include "test_multisample.moc"
