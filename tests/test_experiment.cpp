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
    row.ms = {.median = ms, .p10 = ms, .p90 = ms, .min = ms, .frames = 1};
    row.rounds = {ms};
    row.error.coverage = {wrongPixels, 0, 0};
    return row;
}

/// One of our own drawn as if it were another: what is found out about it is known.
class OwnRenderer : public OtherRenderer
{
public:
    OwnRenderer(Algorithm algorithm, int subpixelBits, TieRule tieRule)
    {
        m_given.algorithm = algorithm;
        m_given.subpixelBits = subpixelBits;
        m_given.tieRule = tieRule;
    }

    [[nodiscard]] QString id() const override { return QStringLiteral("own"); }
    [[nodiscard]] QString name() const override { return QStringLiteral("One of ours"); }
    [[nodiscard]] std::optional<Reason> unsupported(const Scene&, const Settings& settings) const override
    {
        return settings.fill == Fill::Solid ? std::nullopt : std::optional(Reason("it only fills"));
    }
    void load(const Scene& scene, const Settings& settings) override
    {
        m_scene = &scene;
        m_settings = settings;
        m_settings.algorithm = m_given.algorithm;
        m_settings.subpixelBits = m_given.subpixelBits;
        m_settings.tieRule = m_given.tieRule;
    }
    void draw(Frame& frame, Outputs outputs) override { render(*m_scene, m_settings, frame, outputs); }

private:
    Settings m_given;
    const Scene* m_scene = nullptr;
    Settings m_settings;
};

FindRenderers finderOf(Algorithm algorithm, int subpixelBits)
{
    return [=] {
        OtherRenderers found;
        found.renderers.push_back(std::make_unique<OwnRenderer>(algorithm, subpixelBits, TieRule::TopLeft));
        return found;
    };
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
    void ratiosAreOfPairs();
    void overlappingTimesAreNotRanked();
    void noiseIsTold();
    void exactThroughout();
    void probesFindWhatIsKnown_data();
    void probesFindWhatIsKnown();
    void otherRenderersAreJudged();
    void shortFramesAreTimedInBatches();
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
                return b.ms.median < a.ms.median && wrongB <= wrongA;
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
    const auto ratio = walkingAdvantage(rows);
    QVERIFY(ratio);
    QCOMPARE(ratio->median, 2.0);
    QCOMPARE(ratio->to, QStringLiteral("edge-walking"));
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
    QCOMPARE(first.keys(), QStringList({"error", "frontier", "ms", "mtri_per_s", "ns_per_covered_pixel", "ratio",
                                        "reference", "renderer", "scene", "settings", "simd", "threads", "variant"}));
    QCOMPARE(first["ms"].toObject().keys(), QStringList({"batch", "median", "min", "p10", "p90", "processor"}));
    QCOMPARE(first["ratio"].toObject().keys(), QStringList({"median", "p10", "p90", "to"}));
    QVERIFY(first["ratio"]["median"].isNull()); // the first row is what others are compared with
    QCOMPARE(first["renderer"]["name"].toString(), QStringLiteral("RasterLens"));
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
    QVERIFY(lines[0].startsWith("scene,variant,renderer_name,"));
    QVERIFY(lines[0].contains(",threads,simd,ms_batch,ms_median,"));
    QVERIFY(lines[0].contains(",error_missing_pixels,"));
    QVERIFY(lines[1].startsWith("\"a \"\"scene\"\", quoted\",edge-equation,RasterLens,,,,1,scalar,"));
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

/// The median of the ratios, which is not the ratio of the medians.
void TestExperiment::ratiosAreOfPairs()
{
    ExperimentRow slow;
    ExperimentRow fast;
    fast.variant = QStringLiteral("fast");
    slow.rounds = {2, 30, 8};
    fast.rounds = {1, 10, 8, 99}; // a round more, without its pair
    const auto ratio = pairedRatio(slow, fast);
    QVERIFY(ratio);
    QCOMPARE(ratio->to, fast.variant);
    QCOMPARE(ratio->pairs, 3);
    QCOMPARE(ratio->median, 2.0); // of 2, 3 and 1
    QCOMPARE(ratio->p10, 1.2);
    QCOMPARE(ratio->p90, 2.8);
    QVERIFY(!pairedRatio(slow, {}));

    const Scene drawn = scene();
    const auto rows = measured(drawn, plainSettings(kViewport), {3, false});
    for (const auto& [id, row] : rows) {
        QCOMPARE(row.rounds.size(), std::size_t(3));
        QCOMPARE(row.ratio.has_value(), id != QLatin1String("edge-equation"));
        if (row.ratio) {
            const auto again = pairedRatio(row, rows.at(QStringLiteral("edge-equation")));
            QCOMPARE(row.ratio->median, again->median);
            QVERIFY(row.ratio->p10 <= row.ratio->median && row.ratio->median <= row.ratio->p90);
        }
        QVERIFY2(row.ms.processor > 0, qPrintable(id));
    }
}

void TestExperiment::overlappingTimesAreNotRanked()
{
    std::vector<ExperimentRow> rows{row(1, 0), row(1.1, 0)};
    rows[0].rounds = {1, 1.3, 0.9, 1.2, 0.8};
    rows[1].rounds = {1.1, 1.1, 1.1, 1.1, 1.1}; // slower by the medians, but not in every round
    markFrontier(rows, ErrorMeasure::Coverage);
    QVERIFY(rows[0].frontier && rows[1].frontier);
    rows[0].rounds = {1, 1, 0.9, 1, 0.8};
    markFrontier(rows, ErrorMeasure::Coverage);
    QVERIFY(rows[0].frontier && !rows[1].frontier);
    rows[0].error.coverage->missing = 1; // faster, but with an error
    markFrontier(rows, ErrorMeasure::Coverage);
    QVERIFY(rows[0].frontier && rows[1].frontier);
}

void TestExperiment::noiseIsTold()
{
    std::vector<ExperimentRow> rows{row(1, 0), row(4, 0), row(2, 0)};
    rows[0].ms.p90 = 1.5;
    rows[1].ms.p10 = 3;
    rows[2].ms.p90 = 3.6;
    rows[0].ms.processor = 0.9;
    rows[1].ms.processor = 2;
    rows[2].ms.processor = 2;
    rows[2].ms.batch = 7;
    const MachineNoise noise = noiseOf(rows);
    QCOMPARE(noise.spread, 0.5); // of 0.5, 0.25 and 0.8
    QCOMPARE(noise.own, 0.9);    // of 0.9, 0.5 and 1
    QCOMPARE(noise.largestBatch, 7);
}

void TestExperiment::exactThroughout()
{
    std::vector<ExperimentRow> rows{row(1, 0), row(2, 0), ExperimentRow()};
    QVERIFY(isExactThroughout(rows, ErrorMeasure::Coverage));
    QVERIFY(!isExactThroughout(rows, ErrorMeasure::Depth)); // none is measured
    rows[1].error.coverage->extra = 1;
    QVERIFY(!isExactThroughout(rows, ErrorMeasure::Coverage));
}

void TestExperiment::probesFindWhatIsKnown_data()
{
    QTest::addColumn<Algorithm>("algorithm");
    QTest::addColumn<int>("bits");
    QTest::addColumn<TieRule>("tieRule");
    QTest::addColumn<OwnedSides>("sides");
    QTest::newRow("tiled, 8 bits") << Algorithm::Tiled << 8 << TieRule::TopLeft << OwnedSides::TopLeft;
    for (int bits = 0; bits <= 8; bits += 2)
        QTest::addRow("%d bits", bits) << Algorithm::EdgeEquation << bits << TieRule::TopLeft << OwnedSides::TopLeft;
    QTest::newRow("1 bit") << Algorithm::EdgeWalking << 1 << TieRule::TopLeft << OwnedSides::TopLeft;
    QTest::newRow("inclusive") << Algorithm::EdgeEquation << 7 << TieRule::Inclusive << OwnedSides::All;
    QTest::newRow("exclusive") << Algorithm::EdgeEquation << 5 << TieRule::Exclusive << OwnedSides::None;
}

void TestExperiment::probesFindWhatIsKnown()
{
    QFETCH(const Algorithm, algorithm);
    QFETCH(const int, bits);
    QFETCH(const TieRule, tieRule);
    QFETCH(const OwnedSides, sides);
    OwnRenderer renderer(algorithm, bits, tieRule);
    const RendererTraits traits = traitsOf(renderer);
    QCOMPARE(traits.subpixelBits, bits);
    QVERIFY(!traits.orMore);
    QVERIFY(traits.nearest || bits == 0); // of steps of a whole pixel it is not told
    // With whole pixels the square of the probe, which lies half a pixel off them, is moved.
    if (bits > 0) {
        QCOMPARE(traits.sides, sides);
        QCOMPARE(traits.diagonalOnce, tieRule == TieRule::TopLeft);
    }
}

void TestExperiment::otherRenderersAreJudged()
{
    const Scene drawn = scene();
    const Settings base = plainSettings(kViewport);
    ExperimentOptions options{2, true};
    options.others = finderOf(Algorithm::EdgeWalking, 2);
    const std::vector ours{findVariant(QStringLiteral("edge-equation")),
                           findVariant(QStringLiteral("edge-equation-bits-2"))};
    const auto rows = runExperiment(drawn, base, ours, options);
    QCOMPARE(rows.size(), std::size_t(3));
    QCOMPARE(rows[2].variant, QStringLiteral("own"));
    QCOMPARE(rows[2].other->name, QStringLiteral("One of ours"));
    QCOMPARE(rows[2].other->traits.subpixelBits, 2);
    QCOMPARE(rows[2].error.coverage->wrong(), rows[1].error.coverage->wrong()); // what it is in truth
    QVERIFY(rows[2].error.coverage->wrong() > 0);
    QCOMPARE(rows[2].ms.frames, 2);
    const QJsonObject json = QJsonDocument::fromJson(experimentJson(rows)).array()[2].toObject();
    QCOMPARE(json["renderer"]["subpixel_bits"].toInt(), 2);
    QCOMPARE(json["renderer"]["tie_rule"].toString(), QStringLiteral("top-left"));

    // One that does not draw the scene has no row, and says why.
    Settings lines = base;
    lines.fill = Fill::Wireframe;
    QString refused;
    options.refused = [&](const QString& id, const Reason& reason) { refused = id + textOf(reason); };
    QCOMPARE(runExperiment(drawn, lines, std::vector{ours[0]}, options).size(), std::size_t(1));
    QCOMPARE(refused, QStringLiteral("ownit only fills"));
}

void TestExperiment::shortFramesAreTimedInBatches()
{
    QCOMPARE(batchOf(5), 1);
    QCOMPARE(batchOf(kShortestTiming), 1);
    QCOMPARE(batchOf(kShortestTiming / 2.5), 3);
    QCOMPARE(batchOf(1e-9), 1000);
    QCOMPARE(batchOf(0), 1000);
}

QTEST_APPLESS_MAIN(TestExperiment)
#include "test_experiment.moc"
