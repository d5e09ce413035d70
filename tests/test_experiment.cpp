// Speed against error: what the variants are, what is measured of them, and who is on the frontier.
#include "core/truth/exact_reference.h"
#include "core/truth/experiment.h"
#include "core/truth/experiment_export.h"
#include "tests/support.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSet>
#include <QTest>

#include <map>
#include <set>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

constexpr QSize kViewport(96, 64);

/// A floor in perspective, two faces of which one is cut by the near plane, and a few small ones in front.
Scene scene()
{
    Random random(1);
    std::vector<glm::vec4> corners{{-4, -1, 0, 4}, {4, -1, 0, 4},        {1, -1, -0.4F, 0.5F},
                                   {-4, -1, 0, 4}, {1, -1, -0.4F, 0.5F}, {-1, -1.5F, -1, 0.2F}};
    for (int face = 0; face < 30; ++face) {
        const glm::dvec2 middle(uniform(random, 4, kViewport.width() - 4), uniform(random, 4, kViewport.height() - 4));
        for (int i = 0; i < 3; ++i)
            corners.push_back(atPixel(middle.x + uniform(random, -9, 9), middle.y + uniform(random, -9, 9),
                                      uniform(random, 0.1, 0.4), kViewport));
    }
    return soup(corners);
}

std::map<QString, ExperimentRow> measured(const Scene& scene, const Settings& base,
                                          ExperimentOptions options = {2, true})
{
    std::map<QString, ExperimentRow> rows;
    for (const ExperimentRow& row : runExperiment(scene, base, supportedVariants(scene, base), options))
        rows[row.variant] = row;
    return rows;
}

ExperimentRow row(double ms, std::uint64_t wrongPixels)
{
    ExperimentRow row;
    row.ms = {ms, ms, ms, ms, 1};
    row.error.coverage = {wrongPixels, 0, 0};
    return row;
}

} // namespace

class TestExperiment : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void thereAreManyVariantsEachItsOwn();
    void variantsKeepTheRestOfTheBase();
    void asGivenIsTheBase();
    void whatAVariantDecides();
    void unsupportedOnesAreLeftOut();
    void titlesAreTranslated();
    void exactVariantsHaveNoError();
    void everyDialHasItsError();
    void theBaseSaysWhatIsTrue();
    void whatCannotBeComparedIsEmpty();
    void timesAreInOrder();
    void progressCountsToTheEnd();
    void stopsWhereItIs();
    void frontierIsWhatNoOtherBeats();
    void frontierIsPerScene();
    void exportsSayTheSame();
    void bandsChangeNothing();
};

void TestExperiment::thereAreManyVariantsEachItsOwn()
{
    QSet<QString> ids;
    std::vector<Settings> settings;
    for (const Variant& variant : variants()) {
        ids.insert(QLatin1String(variant.id));
        settings.push_back(settingsOf(variant, {}));
        QCOMPARE(findVariant(QLatin1String(variant.id)), &variant);
        QVERIFY(std::count(settings.begin(), settings.end(), settings.back()) == 1);
    }
    QVERIFY(settings.front() == Settings());
    QCOMPARE(std::size_t(ids.size()), variants().size());
    QVERIFY(supportedVariants(scene(), {}).size() >= 30);
    QVERIFY(findVariant(QStringLiteral("no-such")) == nullptr);
}

void TestExperiment::variantsKeepTheRestOfTheBase()
{
    Settings base = plainSettings(kViewport);
    base.shading = Shading::Flat;
    base.threads = 3;
    base.numberType = NumberType::Float64;
    const Settings made = settingsOf(*findVariant(QStringLiteral("edge-walking-bits-4")), base);
    Settings expected = base;
    expected.numberType = NumberType::Fixed;
    expected.algorithm = Algorithm::EdgeWalking;
    expected.subpixelBits = 4;
    QVERIFY(made == expected);
}

void TestExperiment::asGivenIsTheBase()
{
    // Every field at its other end at once.
    Settings base = plainSettings(kViewport);
    for (const SettingsField& field : settingsFields())
        field.set(base, field.get(base) == field.maximum ? field.minimum : field.maximum);
    const Variant* given = findVariant(QStringLiteral("as-given"));
    QCOMPARE(given, &asGiven());
    QVERIFY(settingsOf(*given, base) == base);
    QVERIFY(changedBy(*given, base) == base);
    for (const Variant& variant : variants())
        QVERIFY(&variant != given);

    Settings fine = plainSettings(kViewport);
    fine.algorithm = Algorithm::Tiled;
    fine.samples = Samples::Grid3;
    const auto rows = runExperiment(scene(), fine, std::vector{given}, {1, true});
    QCOMPARE(rows[0].variant, QStringLiteral("as-given"));
    QVERIFY(rows[0].settings == fine);
    QCOMPARE(rows[0].error.coverage->wrong(), 0U); // against the truth of 3 x 3 samples
}

void TestExperiment::whatAVariantDecides()
{
    const auto decided = [](const char* id, const char* field) {
        return decides(*findVariant(QLatin1String(id)), *findSettingsField(QLatin1String(field)));
    };
    for (const char* field : {"algorithm", "number-type", "subpixel-bits", "stepping", "depth-format", "interpolation",
                              "attribute-path", "samples"}) {
        for (const Variant& variant : variants())
            QVERIFY2(decided(variant.id, field), field);
        QVERIFY2(!decided("as-given", field), field);
    }
    QVERIFY(!decided("tiled", "threads") && decided("tiled-1-thread", "threads"));
    QVERIFY(!decided("tiled", "simd") && decided("tiled-scalar", "simd"));
    QVERIFY(!decided("tiled", "culling"));
}

void TestExperiment::unsupportedOnesAreLeftOut()
{
    Settings base;
    base.fill = Fill::Wireframe;
    for (const Variant* variant : supportedVariants(scene(), base))
        QVERIFY(settingsOf(*variant, base).algorithm != Algorithm::Tiled);
}

void TestExperiment::titlesAreTranslated()
{
    const Variant& variant = *findVariant(QStringLiteral("edge-walking-bits-4"));
    QCOMPARE(titleOf(variant), QStringLiteral("Edge walking; Subpixel bits: 4"));
    QCOMPARE(titleOf(variant, [](const char* text) { return QString::fromLatin1(text).toUpper(); }),
             QStringLiteral("EDGE WALKING; SUBPIXEL BITS: 4"));
}

void TestExperiment::exactVariantsHaveNoError()
{
    const auto rows = measured(scene(), plainSettings(kViewport));
    for (const auto& [id, row] : rows) {
        const Settings& s = row.settings;
        if (s.numberType != NumberType::Fixed || s.subpixelBits != 8)
            continue;
        QCOMPARE(row.error.coverage->wrong(), 0U);
        QVERIFY2(row.error.depth->max < (s.depthFormat == DepthFormat::Unorm16 ? 1.0 / 0xffff : 1e-7), qPrintable(id));
        if (s.interpolation == Interpolation::Perspective && s.samples == Samples::One)
            QVERIFY2(row.error.color->max <= 0.51, qPrintable(id));
    }
}

void TestExperiment::everyDialHasItsError()
{
    auto rows = measured(scene(), plainSettings(kViewport));
    const VariantError right = rows["edge-equation"].error;
    QVERIFY(rows["edge-equation-bits-0"].error.coverage->wrong() > 10);
    QVERIFY(rows["edge-walking-affine"].error.color->mean > 2 * right.color->mean);
    QVERIFY(rows["edge-equation-affine"].error.color->psnrDb < right.color->psnrDb - 6);
    QVERIFY(rows["tiled-unorm16"].error.depth->mean > 10 * right.depth->mean);
    QVERIFY(rows["edge-equation-unorm24"].error.depth->mean > right.depth->mean);
}

void TestExperiment::theBaseSaysWhatIsTrue()
{
    // Nothing snaps in truth where the base does not snap: now the fixed-point variants are off, and float64 is not.
    Settings base = plainSettings(kViewport);
    base.numberType = NumberType::Float64;
    auto rows = measured(scene(), base);
    QCOMPARE(rows["edge-equation-float64-direct"].error.coverage->wrong(), 0U);
    QVERIFY(rows["edge-equation-float64-direct"].error.depth->max < rows["edge-equation"].error.depth->max);
}

void TestExperiment::whatCannotBeComparedIsEmpty()
{
    const auto errorOfOnly = [](const Settings& base, bool reference = true) {
        return measured(scene(), base, {1, reference}).at(QStringLiteral("edge-equation")).error;
    };
    Settings base = plainSettings(kViewport);
    QVERIFY(!errorOfOnly(base, false).coverage);
    base.shading = Shading::Flat;
    QVERIFY(!errorOfOnly(base).color && errorOfOnly(base).depth);
    base.depthTest = DepthTest::None;
    QVERIFY(!errorOfOnly(base).depth && errorOfOnly(base).coverage);
    base.fill = Fill::Wireframe;
    QVERIFY(!errorOfOnly(base).coverage);
}

void TestExperiment::timesAreInOrder()
{
    const Scene drawn = scene();
    const Settings base = plainSettings(kViewport);
    Frame frame;
    const double covered = double(renderCounted(drawn, base, frame).pixels.covered);
    for (const auto& [id, row] : measured(drawn, base, {5, false})) {
        QCOMPARE(row.ms.frames, 5);
        QVERIFY(0 < row.ms.min && row.ms.min <= row.ms.p10 && row.ms.p10 <= row.ms.median &&
                row.ms.median <= row.ms.p90);
        QCOMPARE(row.nsPerCoveredPixel, row.ms.median * 1e6 / covered);
        QCOMPARE(row.mtriPerS, double(drawn.mesh.faceCount()) / row.ms.median / 1000);
        QVERIFY(row.simd != Simd::Auto && row.threads >= 1);
    }
}

void TestExperiment::progressCountsToTheEnd()
{
    const Scene drawn = scene();
    const Settings base = plainSettings(kViewport);
    int last = 0;
    int total = 0;
    const auto rows =
        runExperiment(drawn, base, supportedVariants(drawn, base), {2, true}, [&](const ExperimentProgress& progress) {
            QCOMPARE(progress.done, ++last);
            QVERIFY(progress.changed < progress.rows.size());
            total = progress.total;
        });
    QCOMPARE(last, total);
    QCOMPARE(std::size_t(total), rows.size() * 4);
}

void TestExperiment::stopsWhereItIs()
{
    const Scene drawn = scene();
    const Settings base = plainSettings(kViewport);
    const auto chosen = supportedVariants(drawn, base);
    for (const int last : {1, int(chosen.size()) * 2 + 3}) {
        std::stop_source stop;
        int done = 0;
        const auto rows = runExperiment(
            drawn, base, chosen, {3, true},
            [&](const ExperimentProgress& progress) {
                done = progress.done;
                if (done == last)
                    stop.request_stop();
            },
            stop.get_token());
        QCOMPARE(done, last);
        QCOMPARE(rows.size(), chosen.size());
        QCOMPARE(std::count_if(rows.begin(), rows.end(), [](const auto& r) { return r.ms.frames > 0; }),
                 last == 1 ? 0 : 3);
    }
}

void TestExperiment::frontierIsWhatNoOtherBeats()
{
    Random random = seededRandom();
    for (int round = 0; round < 200; ++round) {
        std::vector<ExperimentRow> rows;
        for (int i = 0; i < 12; ++i)
            rows.push_back(row(integer(random, 1, 6), std::uint64_t(integer(random, 0, 5))));
        rows.push_back({}); // not measured
        markFrontier(rows, ErrorMeasure::Coverage);
        QVERIFY(!rows.back().frontier);
        rows.pop_back();
        for (const ExperimentRow& a : rows) {
            const bool beaten = std::any_of(rows.begin(), rows.end(), [&](const ExperimentRow& b) {
                const auto wrongA = a.error.coverage->missing;
                const auto wrongB = b.error.coverage->missing;
                return (b.ms.median < a.ms.median && wrongB <= wrongA) ||
                       (b.ms.median <= a.ms.median && wrongB < wrongA);
            });
            QCOMPARE(a.frontier, !beaten);
        }
    }
}

void TestExperiment::frontierIsPerScene()
{
    std::vector<ExperimentRow> rows{row(1, 0), row(2, 5)};
    rows[1].scene = QStringLiteral("another");
    markFrontier(rows, ErrorMeasure::Coverage);
    QVERIFY(rows[0].frontier && rows[1].frontier);
    QVERIFY(!errorOf(rows[0], ErrorMeasure::Depth));
    QVERIFY(!walkingAdvantage(rows));
    rows[0].variant = QStringLiteral("edge-walking");
    rows[1].variant = QStringLiteral("edge-equation");
    rows[0].ms.p10 = 0.5;
    rows[0].ms.p90 = 4;
    rows[1].ms.p10 = 1.5;
    rows[1].ms.p90 = 3;
    const auto ratio = walkingAdvantage(rows);
    QVERIFY(ratio);
    QCOMPARE(ratio->median, 2.0);
    QCOMPARE(ratio->low, 0.375); // 1.5 / 4
    QCOMPARE(ratio->high, 6.0);  // 3 / 0.5
}

void TestExperiment::exportsSayTheSame()
{
    Scene drawn = scene();
    drawn.id = QStringLiteral("a \"scene\", quoted");
    const Settings base = plainSettings(kViewport);
    std::vector<ExperimentRow> rows =
        runExperiment(drawn, base, std::vector{findVariant(QStringLiteral("edge-equation"))}, {1, true});
    rows.push_back({});
    rows.back().settings.view.near = 0.5;
    const QJsonArray json = QJsonDocument::fromJson(experimentJson(rows)).array();
    QCOMPARE(json.size(), 2);
    const QJsonObject first = json[0].toObject();
    QCOMPARE(first.keys(), QStringList({"error", "frontier", "ms", "mtri_per_s", "ns_per_covered_pixel", "reference",
                                        "scene", "settings", "simd", "threads", "variant"}));
    QCOMPARE(first["scene"].toString(), drawn.id);
    QCOMPARE(first["settings"].toObject(), toJson(base));
    QCOMPARE(first["error"].toObject().keys(), QStringList({"color_max", "color_mean", "depth_max", "depth_mean",
                                                            "extra_pixels", "hit_twice", "missing_pixels", "psnr"}));
    QCOMPARE(first["error"]["missing_pixels"].toInt(-1), 0);
    QCOMPARE(first["ms"]["median"].toDouble(), rows[0].ms.median);
    for (const char* key : {"psnr", "depth_max", "hit_twice"})
        QVERIFY(json[1]["error"][QLatin1String(key)].isNull());
    QVERIFY(json[1]["ms"]["median"].isNull());

    const QList<QByteArray> lines = experimentCsv(rows).split('\n');
    QCOMPARE(lines.size(), 4); // names, two rows, and the end
    QVERIFY(lines[0].startsWith("scene,variant,threads,simd,ms_median,"));
    QVERIFY(lines[0].contains(",error_missing_pixels,"));
    QVERIFY(lines[1].startsWith("\"a \"\"scene\"\", quoted\",edge-equation,1,scalar,"));
    QCOMPARE(lines[1].count(',') - 1, lines[0].count(','));
    QCOMPARE(lines[2].count(','), lines[0].count(','));
    QVERIFY(lines[2].contains(",,,,"));
}

void TestExperiment::bandsChangeNothing()
{
    // 4 x 4 samples of this viewport make two bands; a fixed-point variant stays without error.
    const QSize size(1024, 520);
    QVERIFY(std::int64_t(size.width()) * size.height() * 16 > kSamplesPerBand);
    Settings base = plainSettings(size);
    int steps = 0;
    const auto rows = runExperiment(scene(), base, std::vector{findVariant(QStringLiteral("tiled-4x4"))}, {1, true},
                                    [&](const ExperimentProgress&) { ++steps; });
    QCOMPARE(steps, 4); // two bands, warm-up, a frame
    QCOMPARE(rows[0].error.coverage->wrong(), 0U);
    QVERIFY(rows[0].error.color->max <= 1);
}

QTEST_APPLESS_MAIN(TestExperiment)
#include "test_experiment.moc"
