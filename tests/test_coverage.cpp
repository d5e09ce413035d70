// Coverage: watertight meshes are covered once, all algorithms agree bit for bit, ties are what they should be, and
// nothing depends on the order of vertices or on the place of the picture.
#include "tests/support.h"

#include <QTest>

#include <functional>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

constexpr QSize kSize{64, 64};

/// A point of the screen in 1/256 pixel.
using Spot = glm::ivec2;

struct FlatMesh {
    std::vector<Spot> spots;
    std::vector<std::uint32_t> indices;
};

Scene sceneOf(const FlatMesh& mesh, Random& random, QSize size = kSize)
{
    std::vector<glm::vec4> positions;
    for (const Spot& s : mesh.spots)
        positions.push_back(atPixel(s.x / 256.0, s.y / 256.0, uniform(random, 0.1, 0.9), size));
    return clipScene(positions, mesh.indices);
}

void addTriangle(FlatMesh& mesh, std::array<std::uint32_t, 3> corners, Random& random)
{
    if (integer(random, 0, 1) == 1)
        std::swap(corners[1], corners[2]);
    mesh.indices.insert(mesh.indices.end(), corners.begin(), corners.end());
}

int channelDifference(const QImage& a, const QImage& b);

/// The first difference of two frames. `tiled` interpolates colours in float32: one 8-bit step is not a difference.
QString differenceButForFastColors(const Frame& a, const Frame& b, Algorithm algorithm)
{
    if (algorithm != Algorithm::Tiled)
        return difference(a, b);
    Frame sameImage = b;
    if (channelDifference(a.image, b.image) <= 1)
        sameImage.image = a.image;
    return difference(a, sameImage);
}

/// Cells of 8 pixels over the whole viewport, corners moved, each cell cut by one of its diagonals.
FlatMesh jitteredGrid(Random& random, bool onCentres)
{
    constexpr int kCells = 8;
    FlatMesh mesh;
    for (int j = 0; j <= kCells; ++j)
        for (int i = 0; i <= kCells; ++i) {
            const auto moved = [&](int k) {
                const int jitter = onCentres ? 128 * integer(random, -3, 3) : integer(random, -500, 500);
                return k * 8 * 256 + (k > 0 && k < kCells ? jitter : 0);
            };
            mesh.spots.emplace_back(moved(i), moved(j));
        }
    for (std::uint32_t j = 0; j < kCells; ++j)
        for (std::uint32_t i = 0; i < kCells; ++i) {
            const std::uint32_t a = j * (kCells + 1) + i;
            const std::uint32_t b = a + 1;
            const std::uint32_t c = a + kCells + 1;
            const std::uint32_t d = c + 1;
            if (integer(random, 0, 1) == 0) {
                addTriangle(mesh, {a, b, d}, random);
                addTriangle(mesh, {a, d, c}, random);
            } else {
                addTriangle(mesh, {a, b, c}, random);
                addTriangle(mesh, {b, d, c}, random);
            }
        }
    return mesh;
}

/// Spokes from a hub to points on the border of the viewport.
FlatMesh fan(Random& random, bool hubOnCentre)
{
    FlatMesh mesh;
    const auto place = [&] {
        return hubOnCentre ? 256 * integer(random, 8, 55) + 128 : integer(random, 8 * 256, 56 * 256);
    };
    mesh.spots.emplace_back(place(), place());
    // Once round the border, with the corners of the viewport among the points.
    constexpr int kSide = 64 * 256;
    std::vector<int> way{0, kSide, 2 * kSide, 3 * kSide};
    for (int i = 0; i < 28; ++i)
        way.push_back(hubOnCentre ? 128 * integer(random, 0, 4 * kSide / 128 - 1) : integer(random, 0, 4 * kSide - 1));
    std::sort(way.begin(), way.end());
    way.erase(std::unique(way.begin(), way.end()), way.end());
    for (const int w : way) {
        const int along = w % kSide;
        const std::array<Spot, 4> at{Spot(along, 0), Spot(kSide, along), Spot(kSide - along, kSide),
                                     Spot(0, kSide - along)};
        mesh.spots.push_back(at[static_cast<std::size_t>(w / kSide)]);
    }
    const auto n = static_cast<std::uint32_t>(way.size());
    for (std::uint32_t i = 0; i < n; ++i)
        addTriangle(mesh, {0, 1 + i, 1 + (i + 1) % n}, random);
    return mesh;
}

/// Triangles anywhere, some of them with corners on pixel centres.
FlatMesh randomSoup(Random& random, int faces)
{
    FlatMesh mesh;
    for (int i = 0; i < 3 * faces; ++i) {
        const bool centre = integer(random, 0, 1) == 0;
        const auto place = [&] { return centre ? 256 * integer(random, 0, 63) + 128 : integer(random, 0, 64 * 256); };
        mesh.spots.emplace_back(place(), place());
        mesh.indices.push_back(static_cast<std::uint32_t>(i));
    }
    return mesh;
}

/// Perspective triangles of which many leave the view on all sides.
Scene wildSoup(Random& random, int faces)
{
    std::vector<glm::vec4> positions;
    for (int i = 0; i < 3 * faces; ++i) {
        const double w = uniform(random, -0.5, 3);
        positions.emplace_back(uniform(random, -2, 2), uniform(random, -2, 2), uniform(random, -2, 2), w);
    }
    return soup(positions);
}

std::int64_t edge(Spot a, Spot b, Spot p)
{
    return std::int64_t(b.x - a.x) * (p.y - a.y) - std::int64_t(b.y - a.y) * (p.x - a.x);
}

/// How many faces hold each pixel centre, with all edges belonging to the face or none.
std::vector<std::uint16_t> bruteForce(const FlatMesh& mesh, bool inclusive)
{
    std::vector<std::uint16_t> counts(std::size_t(kSize.width() * kSize.height()));
    for (std::size_t f = 0; f < mesh.indices.size(); f += 3) {
        const Spot a = mesh.spots[mesh.indices[f]];
        const Spot b = mesh.spots[mesh.indices[f + 1]];
        const Spot c = mesh.spots[mesh.indices[f + 2]];
        if (edge(a, b, c) == 0)
            continue;
        const std::int64_t sign = edge(a, b, c) > 0 ? 1 : -1;
        std::size_t at = 0;
        for (int y = 0; y < kSize.height(); ++y)
            for (int x = 0; x < kSize.width(); ++x, ++at) {
                const Spot p(256 * x + 128, 256 * y + 128);
                const std::int64_t least = std::min({sign * edge(a, b, p), sign * edge(b, c, p), sign * edge(c, a, p)});
                if (inclusive ? least >= 0 : least > 0)
                    ++counts[at];
            }
    }
    return counts;
}

/// Settings for every algorithm and both ways of stepping.
void forEachWay(const Scene& scene, Settings settings, const std::function<void(const Settings&, const QString&)>& run)
{
    for (const Algorithm algorithm : algorithmsFor(scene, settings))
        for (const Stepping stepping : {Stepping::Direct, Stepping::Incremental}) {
            settings.algorithm = algorithm;
            settings.stepping = stepping;
            run(settings, QStringLiteral("%1, stepping %2").arg(QLatin1String(idOf(algorithm))).arg(int(stepping)));
        }
}

int channelDifference(const QImage& a, const QImage& b)
{
    int most = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) {
            const QRgb p = a.pixel(x, y);
            const QRgb q = b.pixel(x, y);
            most = std::max(
                {most, std::abs(qRed(p) - qRed(q)), std::abs(qGreen(p) - qGreen(q)), std::abs(qBlue(p) - qBlue(q))});
        }
    return most;
}

} // namespace

class TestCoverage : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void watertightMeshesAreCoveredOnce();
    void watertightInPerspectiveAndThroughTheBorders();
    void tieRulesEqualBruteForce();
    void squareCutByItsDiagonal();
    void floatSpansKnowTheTieRule();
    void algorithmsAgreeOnSoups();
    void algorithmsAgreeOnBuiltinScenes_data();
    void algorithmsAgreeOnBuiltinScenes();
    void permutedVerticesGiveTheSamePicture();
    void wholePixelTranslationMovesThePicture();
    void floatsComeClose();
    void absurdInputIsDefined();
};

void TestCoverage::watertightMeshesAreCoveredOnce()
{
    Random random = seededRandom();
    for (int kind = 0; kind < 4; ++kind)
        for (int bits = 0; bits <= 8; ++bits)
            for (int samples = 0; samples < 4; ++samples) {
                const FlatMesh mesh = kind < 2 ? jitteredGrid(random, kind == 1) : fan(random, kind == 3);
                const Scene scene = sceneOf(mesh, random);
                Settings settings = plainSettings(kSize);
                settings.subpixelBits = bits;
                settings.samples = static_cast<Samples>(samples);
                settings.shading = Shading::Overdraw;
                const std::uint64_t all =
                    std::uint64_t(kSize.width() * kSize.height()) * std::uint64_t((samples + 1) * (samples + 1));
                forEachWay(scene, settings, [&](const Settings& s, const QString& way) {
                    Frame frame;
                    const Statistics statistics = renderCounted(scene, s, frame, kAllOutputs);
                    const auto odd = std::ranges::count_if(frame.coverage, [](std::uint16_t n) { return n != 1; });
                    QVERIFY2(odd == 0, qPrintable(QStringLiteral("%1: kind %2, %3 bits, %4 samples: %5 pixels")
                                                      .arg(way)
                                                      .arg(kind)
                                                      .arg(bits)
                                                      .arg(samples + 1)
                                                      .arg(odd)));
                    QCOMPARE(statistics.pixels.covered, all);
                    QCOMPARE(statistics.pixels.coveredTwice, std::uint64_t(0));
                });
            }
}

/// A jittered height field seen in perspective that reaches beyond all borders and behind the near plane.
void TestCoverage::watertightInPerspectiveAndThroughTheBorders()
{
    Random random = seededRandom();
    for (int round = 0; round < 12; ++round) {
        constexpr std::uint32_t kCells = 12;
        std::vector<glm::vec4> positions;
        for (std::uint32_t j = 0; j <= kCells; ++j)
            for (std::uint32_t i = 0; i <= kCells; ++i) {
                const double w = std::exp2(uniform(random, -1, 2));
                const auto ndc = [&](std::uint32_t k) {
                    return (double(k) - kCells / 2.0 + uniform(random, -0.2, 0.2)) * 0.31;
                };
                positions.emplace_back(w * ndc(i), w * ndc(j), w * uniform(random, -0.9, 0.9), w);
            }
        std::vector<std::uint32_t> indices;
        for (std::uint32_t j = 0; j < kCells; ++j)
            for (std::uint32_t i = 0; i < kCells; ++i) {
                const std::uint32_t a = j * (kCells + 1) + i;
                for (const std::uint32_t v : {a, a + 1, a + kCells + 2, a, a + kCells + 2, a + kCells + 1})
                    indices.push_back(v);
            }
        const Scene scene = clipScene(positions, indices);
        for (const Clipping clipping :
             {Clipping::Frustum, Clipping::FrustumW, Clipping::GuardBand, Clipping::CohenSutherland}) {
            Settings settings = plainSettings({97, 61});
            settings.clipping = clipping;
            settings.subpixelBits = 8 - round % 4 * 2;
            forEachWay(scene, settings, [&](const Settings& s, const QString& way) {
                const Frame frame = draw(scene, s);
                const auto odd = std::ranges::count_if(frame.coverage, [](std::uint16_t n) { return n != 1; });
                QVERIFY2(odd == 0, qPrintable(QStringLiteral("%1, clipping %2, round %3: %4 pixels")
                                                  .arg(way)
                                                  .arg(int(clipping))
                                                  .arg(round)
                                                  .arg(odd)));
            });
        }
    }
}

void TestCoverage::tieRulesEqualBruteForce()
{
    Random random = seededRandom();
    for (int round = 0; round < 12; ++round) {
        const FlatMesh mesh = round % 3 == 0   ? jitteredGrid(random, true)
                              : round % 3 == 1 ? fan(random, true)
                                               : randomSoup(random, 60);
        const Scene scene = sceneOf(mesh, random);
        for (const TieRule tie : {TieRule::Inclusive, TieRule::Exclusive}) {
            const std::vector<std::uint16_t> expected = bruteForce(mesh, tie == TieRule::Inclusive);
            Settings settings = plainSettings(kSize);
            settings.tieRule = tie;
            forEachWay(scene, settings, [&](const Settings& s, const QString& way) {
                QVERIFY2(draw(scene, s).coverage == expected, qPrintable(way));
            });
            if (round % 3 == 2)
                continue;
            const auto odd = std::ranges::count_if(expected, [](std::uint16_t n) { return n != 1; });
            QVERIFY(odd > 0);
        }
    }
}

void TestCoverage::squareCutByItsDiagonal()
{
    const Scene scene = *makeBuiltinScene(QStringLiteral("square-diagonal")).scene;
    Settings anyTieRule = scene.defaults;
    anyTieRule.tieRule = TieRule::Inclusive; // algorithms that know the top-left rule alone are left out
    forEachWay(scene, anyTieRule, [&](Settings settings, const QString& way) {
        const auto count = [&](TieRule tie, std::uint16_t hits) {
            settings.tieRule = tie;
            return std::ranges::count(draw(scene, settings).coverage, hits);
        };
        QVERIFY2(count(TieRule::TopLeft, 1) == 64 && count(TieRule::TopLeft, 2) == 0, qPrintable(way));
        QVERIFY2(count(TieRule::Inclusive, 1) == 56 && count(TieRule::Inclusive, 2) == 8, qPrintable(way));
        QVERIFY2(count(TieRule::Exclusive, 1) == 56 && count(TieRule::Exclusive, 2) == 0, qPrintable(way));
        settings.tieRule = TieRule::Inclusive;
        Frame frame;
        QCOMPARE(renderCounted(scene, settings, frame).pixels.coveredTwice, std::uint64_t(8));
    });
}

/// A square whose four sides and diagonal run through centres: its positions are exact in float32 and float64, so that
/// the tie rules have to give what they give in fixed point.
void TestCoverage::floatSpansKnowTheTieRule()
{
    const QSize size(8, 8);
    const auto at = [&](double x, double y) { return atPixel(x, y, 0.5, size); };
    const Scene scene = clipScene({at(1.5, 1.5), at(1.5, 6.5), at(6.5, 6.5), at(6.5, 1.5)}, {0, 1, 2, 0, 2, 3});
    const auto edgeCentres = [&](TieRule tie, int hits) {
        // 36 centres lie in the square or on its border, 6 of them on the diagonal; 16 lie inside of the border.
        switch (tie) {
        case TieRule::TopLeft: return hits == 1 ? 25 : 0; // the top and left sides, not the others
        case TieRule::Inclusive: return hits == 1 ? 30 : 6;
        case TieRule::Exclusive: return hits == 1 ? 12 : 0;
        }
        return -1;
    };
    for (const NumberType type : {NumberType::Fixed, NumberType::Float32, NumberType::Float64})
        for (const TieRule tie : {TieRule::TopLeft, TieRule::Inclusive, TieRule::Exclusive}) {
            Settings settings = plainSettings(size);
            settings.numberType = type;
            settings.tieRule = tie;
            forEachWay(scene, settings, [&](const Settings& s, const QString& way) {
                const Frame frame = draw(scene, s);
                for (const int hits : {1, 2}) {
                    const auto found = std::ranges::count(frame.coverage, hits);
                    QVERIFY2(found == edgeCentres(tie, hits), qPrintable(QStringLiteral("%1, number type %2, tie rule "
                                                                                        "%3: %4 pixels hit %5 times")
                                                                             .arg(way)
                                                                             .arg(int(type))
                                                                             .arg(int(tie))
                                                                             .arg(found)
                                                                             .arg(hits)));
                }
            });
        }
}

void TestCoverage::algorithmsAgreeOnSoups()
{
    Random random = seededRandom();
    const SettingsField* shading = findSettingsField(QStringLiteral("shading"));
    for (int round = 0; round < casesOfBuild(60); ++round) {
        const Scene scene = round % 2 == 0 ? wildSoup(random, 40) : sceneOf(randomSoup(random, 40), random);
        Settings settings = plainSettings({integer(random, 1, 90), integer(random, 1, 90)});
        settings.subpixelBits = integer(random, 0, 8);
        settings.samples = static_cast<Samples>(integer(random, 0, 3));
        settings.tieRule = static_cast<TieRule>(round % 3);
        settings.clipping = static_cast<Clipping>(integer(random, 0, 6));
        shading->set(settings, integer(random, 0, shading->maximum));
        std::optional<Frame> first;
        forEachWay(scene, settings, [&](const Settings& s, const QString& way) {
            const Frame frame = draw(scene, s);
            if (!first)
                first = frame;
            const QString text = differenceButForFastColors(*first, frame, s.algorithm);
            QVERIFY2(text.isEmpty(), qPrintable(QStringLiteral("round %1, %2: %3").arg(round).arg(way, text)));
        });
    }
}

void TestCoverage::algorithmsAgreeOnBuiltinScenes_data()
{
    QTest::addColumn<QString>("name");
    for (const BuiltinScene& scene : builtinScenes())
        QTest::newRow(scene.name) << QString::fromLatin1(scene.name);
}

void TestCoverage::algorithmsAgreeOnBuiltinScenes()
{
    QFETCH(QString, name);
    const Scene scene = *makeBuiltinScene(name).scene;
    for (const TieRule tie : {TieRule::TopLeft, TieRule::Inclusive, TieRule::Exclusive}) {
        Settings settings = scene.defaults;
        settings.size = settings.size.boundedTo({160, 120});
        settings.tieRule = tie;
        std::optional<Frame> first;
        forEachWay(scene, settings, [&](const Settings& s, const QString& way) {
            const Frame frame = draw(scene, s);
            if (!first)
                first = frame;
            const QString text = differenceButForFastColors(*first, frame, s.algorithm);
            QVERIFY2(text.isEmpty(), qPrintable(way + text));
        });
    }
}

/// Coverage and ids exactly. Depth and colour are sums that start at another corner: one unit in the last place.
void TestCoverage::permutedVerticesGiveTheSamePicture()
{
    Random random = seededRandom();
    for (int round = 0; round < 20; ++round) {
        const Scene scene = round % 2 == 0 ? wildSoup(random, 30) : sceneOf(randomSoup(random, 30), random);
        Scene permuted = scene;
        for (std::size_t f = 0; f < scene.mesh.indices.size(); f += 3)
            std::shuffle(permuted.mesh.indices.begin() + std::ptrdiff_t(f),
                         permuted.mesh.indices.begin() + std::ptrdiff_t(f) + 3, random);
        forEachWay(scene, plainSettings(kSize), [&](const Settings& s, const QString& way) {
            const Frame a = draw(scene, s);
            const Frame b = draw(permuted, s);
            QVERIFY2(a.coverage == b.coverage, qPrintable(way));
            // Where a face is clipped, its polygon starts elsewhere: other triangles, whose snapped corners are not
            // quite in one plane.
            if (round % 2 == 0)
                return;
            QVERIFY2(a.ids == b.ids, qPrintable(way));
            QVERIFY(channelDifference(a.image, b.image) <= 1);
            for (std::size_t i = 0; i < a.depth.size(); ++i)
                QVERIFY(std::abs(a.depth[i] - b.depth[i]) <= 0x1p-24F);
        });
    }
}

void TestCoverage::wholePixelTranslationMovesThePicture()
{
    Random random = seededRandom();
    const QSize large(128, 128);
    for (int round = 0; round < 20; ++round) {
        const FlatMesh mesh = randomSoup(random, 30);
        FlatMesh moved = mesh;
        const glm::ivec2 by(integer(random, 0, 64), integer(random, 0, 64));
        for (Spot& s : moved.spots)
            s += 256 * by;
        Random depths(7);
        Random sameDepths(7);
        const Scene scene = sceneOf(mesh, depths, large);
        const Scene shifted = sceneOf(moved, sameDepths, large);
        forEachWay(scene, plainSettings(large), [&](const Settings& s, const QString& way) {
            const Frame a = draw(scene, s);
            const Frame b = draw(shifted, s);
            for (int y = 0; y < 64; ++y)
                for (int x = 0; x < 64; ++x) {
                    const auto from = std::size_t(y * large.width() + x);
                    const auto to = std::size_t((y + by.y) * large.width() + x + by.x);
                    QVERIFY2(a.coverage[from] == b.coverage[to] && a.ids[from] == b.ids[to], qPrintable(way));
                    if (s.algorithm != Algorithm::Tiled) // whose colours depend on the corner of the block
                        QCOMPARE(a.image.pixel(x, y), b.image.pixel(x + by.x, y + by.y));
                    QVERIFY(std::abs(a.depth[from] - b.depth[to]) <= 0x1p-24F);
                }
        });
    }
}

/// Corners on the fixed-point grid: float64 holds every edge value, float32 only those of small triangles.
void TestCoverage::floatsComeClose()
{
    Random random = seededRandom();
    std::size_t samples = 0;
    std::size_t different = 0;
    for (int round = 0; round < 20; ++round) {
        const Scene scene = sceneOf(randomSoup(random, 40), random);
        Settings settings = plainSettings(kSize);
        for (const Algorithm algorithm : algorithmsFor(scene, settings)) {
            settings.algorithm = algorithm;
            settings.numberType = NumberType::Fixed;
            const Frame fixed = draw(scene, settings);
            settings.numberType = NumberType::Float64;
            settings.stepping = Stepping::Direct;
            if (!unsupported(scene, settings) && algorithm == Algorithm::EdgeEquation)
                QCOMPARE(difference(fixed, draw(scene, settings)), QString());
            for (const NumberType type : {NumberType::Float32, NumberType::Float64})
                for (const Stepping stepping : {Stepping::Direct, Stepping::Incremental}) {
                    settings.numberType = type;
                    settings.stepping = stepping;
                    if (unsupported(scene, settings))
                        continue;
                    const Frame frame = draw(scene, settings);
                    for (std::size_t i = 0; i < frame.coverage.size(); ++i)
                        different += frame.coverage[i] != fixed.coverage[i];
                    samples += frame.coverage.size();
                }
        }
    }
    qInfo("floating point: %zu of %zu pixels differ", different, samples);
    QVERIFY(different * 1000 < samples);
}

/// Any bits at all, in every mode: the sanitizers would tell.
void TestCoverage::absurdInputIsDefined()
{
    Random random = seededRandom();
    for (int round = 0; round < 150; ++round) {
        std::vector<glm::vec4> positions;
        for (int i = 0; i < 3 * 12; ++i) {
            const auto number = [&] {
                switch (integer(random, 0, 3)) {
                case 0: return anyFloat(random);
                case 1: return static_cast<float>(integer(random, -1, 1));
                default: return static_cast<float>(uniform(random, -2, 2));
                }
            };
            positions.emplace_back(number(), number(), number(), number());
        }
        const Scene scene = soup(positions);
        Settings settings = plainSettings({integer(random, 1, 40), integer(random, 1, 40)});
        settings.clipping = static_cast<Clipping>(round % 7);
        settings.cullSpace = static_cast<CullSpace>(integer(random, 0, 1));
        settings.shading = static_cast<Shading>(integer(random, 0, 9));
        settings.textureFilter = static_cast<TextureFilter>(integer(random, 0, 1));
        for (const NumberType type : {NumberType::Fixed, NumberType::Float32, NumberType::Float64})
            for (const AttributePath path : {AttributePath::Planes, AttributePath::EdgeThenSpan}) {
                settings.numberType = type;
                settings.attributePath = path;
                forEachWay(scene, settings, [&](const Settings& s, const QString&) {
                    Frame frame;
                    const Statistics::Faces f = renderCounted(scene, s, frame, kAllOutputs).faces;
                    QCOMPARE(f.submitted, std::uint64_t(12));
                    QCOMPARE(f.submitted, f.rejected + f.degenerate + f.nonFinite + f.rasterized);
                    QVERIFY(std::ranges::all_of(frame.depth, [](float d) { return d >= 0 && d <= 1; }));
                });
            }
    }
}

QTEST_APPLESS_MAIN(TestCoverage)
#include "test_coverage.moc"
