// The charts of errors, against what is known by hand or by another way to compute it.
#include "core/truth/charts.h"
#include "tests/support.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include <algorithm>
#include <cmath>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

Chart chartOf(const char* id, const Scene& scene = Scene(), const Settings& settings = plainSettings({64, 48}))
{
    return findChart(QLatin1String(id))->make(scene, settings, {});
}

double valueAt(const Chart& chart, std::size_t series, double x)
{
    const auto at = std::ranges::find(chart.x, x);
    return at == chart.x.end() ? std::nan("") : chart.series[series].y[std::size_t(at - chart.x.begin())];
}

} // namespace

class TestCharts : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyChartIsWhole_data();
    void everyChartIsWhole();
    void affineErrorIsThatOfTheFormula();
    void linesByDiamondsAreTheTrueOnes();
    void floatsLoseEdgesAsTheyGrow();
    void depthStepsGoByTheSquare();
    void aFaceTurnsOver();
    void refusalsSayWhy();
};

void TestCharts::everyChartIsWhole_data()
{
    QTest::addColumn<QString>("id");
    for (const ChartInfo& info : chartInfos())
        QTest::newRow(info.id) << QString::fromLatin1(info.id);
}

void TestCharts::everyChartIsWhole()
{
    QFETCH(QString, id);
    const ChartInfo& info = *findChart(id);
    const Scene scene = *makeBuiltinScene(QStringLiteral("cube")).scene;
    Settings settings = scene.defaults;
    settings.size = {48, 36};
    QVERIFY(!whyNoChart(info, scene, settings));
    const Chart chart = info.make(scene, settings, {});
    QVERIFY(chart.x.size() > 4);
    QVERIFY(std::ranges::is_sorted(chart.x));
    QVERIFY(!chart.series.empty());
    for (const ChartSeries& series : chart.series) {
        QCOMPARE(series.y.size(), chart.x.size());
        QVERIFY(std::ranges::none_of(series.y, [](double y) { return y < 0 || std::isinf(y); }));
    }
    const QList<QByteArray> lines = chartCsv(chart).trimmed().split('\n');
    QCOMPARE(lines.size(), qsizetype(chart.x.size()) + 1);
    for (const QByteArray& line : lines)
        QCOMPARE(line.count(','), qsizetype(chart.series.size()));
    const QJsonObject json = QJsonDocument::fromJson(chartJson(info, chart)).object();
    QCOMPARE(json["chart"].toString(), id);
    QCOMPARE(json["x"].toArray().size(), qsizetype(chart.x.size()));
    QCOMPARE(json["series"].toArray().size(), qsizetype(chart.series.size()));
    // the same again: nothing of it is measured by a clock
    QCOMPARE(chartJson(info, info.make(scene, settings, {})), chartJson(info, chart));
}

/// m - u is largest where both ends' weights meet: (sqrt r - 1) / (sqrt r + 1) for a ratio r of the distances.
void TestCharts::affineErrorIsThatOfTheFormula()
{
    const Chart chart = chartOf("attributes");
    for (std::size_t i = 0; i < chart.x.size(); ++i) {
        const double root = std::sqrt(chart.x[i]);
        QVERIFY(std::abs(chart.series[0].y[i] - 255 * (root - 1) / (root + 1)) < 0.2);
        QVERIFY(chart.series[1].y[i] <= chart.series[0].y[i]);
        QVERIFY(chart.series[2].y[i] <= chart.series[1].y[i]);
        QVERIFY(chart.series[3].y[i] < 1e-3);
    }
    QCOMPARE(valueAt(chart, 0, 1), 0.0);
    QVERIFY(std::abs(valueAt(chart, 0, 4) - 85) < 0.01);
    // A quarter of the interval has a sixteenth of the error: halving the pieces divides it by about four.
    QVERIFY(valueAt(chart, 1, 4) / valueAt(chart, 2, 4) > 3);
}

void TestCharts::linesByDiamondsAreTheTrueOnes()
{
    const Chart chart = chartOf("lines");
    QCOMPARE(chart.series.size(), std::size_t(4));
    QVERIFY(std::ranges::all_of(chart.series[3].y, [](double wrong) { return wrong == 0; }));
    for (const std::size_t rule : {0U, 1U, 2U})
        QVERIFY(std::ranges::all_of(chart.series[rule].y, [](double wrong) { return wrong > 1; }));
    QCOMPARE(chart.x.front(), 0.0);
    QCOMPARE(chart.x.back(), 90.0);
}

void TestCharts::floatsLoseEdgesAsTheyGrow()
{
    const Chart chart = chartOf("edge-functions");
    QVERIFY(std::ranges::all_of(chart.series[4].y, [](double wrong) { return wrong == 0; })); // float64 is exact here
    for (const std::size_t way : {0U, 2U, 3U}) {
        QVERIFY(chart.series[way].y.back() > 0);
        QVERIFY(chart.series[way].y.back() > chart.series[way].y.front());
    }
    // What is added up loses a little at every step; compensation wins nearly all of that back.
    QVERIFY(chart.series[0].y.back() > 2 * chart.series[1].y.back());
}

void TestCharts::depthStepsGoByTheSquare()
{
    const Chart chart = chartOf("depth-step", *makeBuiltinScene(QStringLiteral("cube")).scene);
    const auto& unorm24 = chart.series[2].y;
    const auto& unorm16 = chart.series[3].y;
    const auto& formula24 = chart.series[4].y;
    const auto& formula16 = chart.series[5].y;
    int compared = 0;
    for (std::size_t i = 0; i < chart.x.size(); ++i) {
        // A step that is small beside the distance is that of the formula.
        if (std::isfinite(unorm24[i]) && formula24[i] < chart.x[i] / 1000) {
            ++compared;
            QVERIFY(std::abs(unorm24[i] / formula24[i] - 1) < 0.1);
        }
        if (std::isfinite(unorm16[i]) && formula16[i] < chart.x[i] / 1000)
            QVERIFY(std::abs(unorm16[i] / formula16[i] - 1) < 0.1);
        if (std::isfinite(chart.series[0].y[i]) && i + 1 < chart.x.size() && i > chart.x.size() / 2)
            QVERIFY(chart.series[1].y[i] <= chart.series[0].y[i]); // reversed floats are finer far away
    }
    QVERIFY(compared > 10);
}

/// A (1.4, 1.1), B (1.6, 1.9), C (2.4, 2.6) become (1, 1), (2, 2), (2, 3): AB x AC is -0.5 before and 1 after.
void TestCharts::aFaceTurnsOver()
{
    const QSize size(8, 8);
    const Scene scene =
        soup({atPixel(1.4, 1.1, 0.5, size), atPixel(1.6, 1.9, 0.5, size), atPixel(2.4, 2.6, 0.5, size)});
    const Chart chart = chartOf("snapping", scene, plainSettings(size));
    QCOMPARE(valueAt(chart, 0, 0), 100.0);
    QCOMPARE(valueAt(chart, 0, 8), 0.0);
    QCOMPARE(valueAt(chart, 1, 0), 0.0);
    QVERIFY(std::isnan(valueAt(chart, 2, 0))); // no face is cut
    // Within a quarter of a pixel all corners meet without subpixels.
    const Scene small =
        soup({atPixel(3.1, 3.1, 0.5, size), atPixel(3.1, 3.3, 0.5, size), atPixel(3.3, 3.1, 0.5, size)});
    QCOMPARE(valueAt(chartOf("snapping", small, plainSettings(size)), 1, 0), 100.0);
}

void TestCharts::refusalsSayWhy()
{
    QVERIFY(findChart(QStringLiteral("nonsense")) == nullptr);
    const Scene scene = soup({{-1, -1, 0, 1}, {1, -1, 0, 1}, {0, 1, 0, 1}});
    const auto reason = whyNoChart(*findChart(QStringLiteral("distance")), scene, plainSettings({8, 8}));
    QVERIFY(reason);
    QVERIFY(textOf(*reason).contains(QLatin1String("has no camera")));
    Settings columns = plainSettings({8, 8});
    columns.algorithm = Algorithm::ColumnFill;
    QVERIFY(whyNoChart(*findChart(QStringLiteral("msaa")), scene, columns));
    QVERIFY(!whyNoChart(*findChart(QStringLiteral("lines")), scene, columns));
}

QTEST_GUILESS_MAIN(TestCharts)
#include "test_charts.moc"
