// Column fill: the table of columns against one made by a map of lists, the steps of steep edges, and the record.
#include "core/observe/step_text.h"
#include "core/rasterizers/column_fill.h"
#include "core/render/steps.h"
#include "tests/support.h"

#include <QTest>

#include <algorithm>
#include <map>
#include <random>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

using Table = std::map<int, std::vector<int>>;

/// The rows of one edge, worked out without the class under test: whole steps of (2 dy) / dx with the sign of the way.
void addEdge(GridPoint from, GridPoint to, Table& table)
{
    if (from.x > to.x)
        std::swap(from, to);
    const int dx = to.x - from.x;
    const int dy = std::abs(to.y - from.y);
    if (dx == 0) {
        table[from.x].push_back(from.y);
        table[from.x].push_back(to.y);
        return;
    }
    int row = from.y;
    for (int x = from.x, error = 0; x <= to.x; ++x) {
        table[x].push_back(row);
        error += 2 * dy;
        const int whole = error >= dx ? error / dx : 0;
        row += to.y > from.y ? whole : -whole;
        error -= whole * 2 * dx;
    }
}

Table tableOf(const std::array<GridPoint, 3>& corners)
{
    Table table;
    for (std::size_t i = 0; i < 3; ++i)
        addEdge(corners[i], corners[(i + 1) % 3], table);
    return table;
}

ScreenTriangle triangleOf(const std::array<GridPoint, 3>& corners)
{
    ScreenTriangle triangle{};
    for (std::size_t i = 0; i < 3; ++i)
        triangle.vertices[i].position = {corners[i].x + 0.25, corners[i].y + 0.75};
    const auto& [a, b, c] = triangle.vertices;
    triangle.area2 = twiceArea(a.position, b.position, c.position);
    return triangle;
}

struct Columns : NullObserver {
    std::vector<FilledColumn> columns;
    void onColumn(const FilledColumn& column) { columns.push_back(column); }
};

struct Plotted {
    std::vector<std::pair<int, int>> at;
    std::vector<Weights> weights;
    void operator()(int x, int y, const Weights& w)
    {
        at.emplace_back(x, y);
        weights.push_back(w);
    }
};

Scene textbookScene() { return *makeBuiltinScene(QStringLiteral("triangle-600")).scene; }

Settings columnFill(const Scene& scene)
{
    Settings settings = scene.defaults;
    settings.algorithm = Algorithm::ColumnFill;
    return settings;
}

} // namespace

class TestColumnFill : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// (100, 200), (300, 400), (400, 100): counted by a program of twenty lines in another language.
    void textbookTriangle()
    {
        const Scene scene = textbookScene();
        Frame frame;
        const Statistics statistics = renderCounted(scene, columnFill(scene), frame, {});
        QCOMPARE(statistics.pixels.covered, 40251U);
        QCOMPARE(statistics.pixels.tested, 40251U);
    }

    /// An edge of slope -3 moves by 6, 0, 6, 0 rows.
    void steepEdgesMoveTwoColumnsAtOnce()
    {
        ColumnWalker edge({300, 400}, {400, 100});
        std::vector<int> rows;
        for (int x = 300; x < 308; ++x, edge.step())
            rows.push_back(edge.row());
        QCOMPARE(rows, (std::vector<int>{400, 394, 394, 388, 388, 382, 382, 376}));
    }

    /// The columns of 2,000 triangles, partly off the target and with vertical edges, are those of a table.
    void columnsAreTheTable()
    {
        std::mt19937 random(7);
        Rules rules;
        rules.width = 40;
        rules.height = 30;
        const auto within = [&](int low, int high) { return low + int(random() % unsigned(high - low + 1)); };
        for (int n = 0; n < 2000; ++n) {
            std::array<GridPoint, 3> corners;
            for (GridPoint& corner : corners)
                corner = {within(-20, 60), within(-20, 50)};
            if (n % 4 == 0)
                corners[1].x = corners[0].x;
            const ScreenTriangle triangle = triangleOf(corners);
            if (triangle.area2 == 0)
                continue;
            Columns observer;
            Plotted samples;
            ColumnFill::cover(triangle, rules, samples, observer);
            std::vector<std::pair<int, int>> expected;
            std::size_t column = 0;
            for (const auto& [x, rows] : tableOf(corners)) {
                if (x < 0 || x >= rules.width)
                    continue;
                QVERIFY(column < observer.columns.size());
                const FilledColumn& told = observer.columns[column++];
                QCOMPARE(told.x, x);
                QVERIFY2(told.count > 0, "edges join the leftmost corner to the rightmost one");
                QCOMPARE(std::vector<int>(told.rows.begin(), told.rows.begin() + told.count), rows);
                for (int y = std::max(*std::ranges::min_element(rows), 0);
                     y <= std::min(*std::ranges::max_element(rows), rules.height - 1); ++y)
                    expected.emplace_back(x, y);
            }
            QCOMPARE(column, observer.columns.size());
            QCOMPARE(samples.at, expected);
        }
    }

    /// Samples of the outline lie outside; none of their attributes does.
    void weightsStayWithinTheTriangle()
    {
        Rules rules;
        rules.width = rules.height = 64;
        NullObserver nobody;
        Plotted samples;
        const ScreenTriangle triangle = triangleOf({{{3, 40}, {50, 60}, {9, 2}}});
        ColumnFill::cover(triangle, rules, samples, nobody);
        QVERIFY(samples.weights.size() > 900);
        for (const Weights& weights : samples.weights) {
            QVERIFY(std::ranges::all_of(weights, [](double w) { return w >= 0 && w <= 1; }));
            QVERIFY(std::abs(weights[0] + weights[1] + weights[2] - 1) < 1e-12);
        }
    }

    void anEmptyColumnSaysSo()
    {
        const FilledColumn empty;
        QVERIFY(empty.first() > empty.last());
    }

    /// Both halves of a square draw the samples of their diagonal, and the counter says so: as many as the records of
    /// the faces, each by itself, have in common. The counter of the record says the same.
    void sharedEdgesAreHitTwice()
    {
        for (const char* name : {"square-diagonal", "two-windings"}) {
            const Scene scene = *makeBuiltinScene(QLatin1String(name)).scene;
            Settings settings = columnFill(scene);
            settings.depthTest = DepthTest::Always;
            settings.culling = Culling::None;
            std::map<std::pair<int, int>, int> drawn; // sample -> faces
            StepFilter filter;
            filter.kinds = kindBit(StepKind::Fragment);
            for (std::uint32_t face = 0; face < scene.mesh.faceCount(); ++face) {
                filter.face = face;
                const auto log = renderSteps(scene, settings, filter);
                for (const std::uint32_t i : log->eventsOf(StepKind::Fragment))
                    ++drawn[{log->event(i).x, log->event(i).y}];
            }
            const auto common = std::count_if(drawn.begin(), drawn.end(), [](const auto& at) { return at.second > 1; });
            QVERIFY2(common > 0, name);
            Frame frame;
            const std::uint64_t counted = renderCounted(scene, settings, frame, {}).pixels.coveredTwice;
            QCOMPARE(counted, std::uint64_t(common));
            const auto log = renderSteps(scene, settings);
            QCOMPARE(log->countersAt(log->size()).pixels.coveredTwice, counted);
        }
    }

    /// A column, then its samples from above; the sentence of the column tells the table, least and greatest.
    void theRecordGoesColumnByColumn()
    {
        const Scene scene = textbookScene();
        StepFilter filter;
        filter.kinds = kindBit(StepKind::Column) | kindBit(StepKind::LineSample);
        const auto log = renderSteps(scene, columnFill(scene), filter);
        const auto columns = log->eventsOf(StepKind::Column);
        QCOMPARE(columns.size(), 301U);
        // Rows count down from the top here: y = 599 - row of the text's [300], [167] in column 200.
        const std::uint32_t i = columns[100];
        QCOMPARE(log->event(i).x, 200);
        const FilledColumn& column = log->payload<ColumnFillStep>(log->event(i)).column;
        QCOMPARE(std::make_pair(column.first(), column.last()), std::make_pair(300, 433));
        QVERIFY2(stepText(*log, i).contains(QLatin1String("filled from min 300 to max 433")),
                 qPrintable(stepText(*log, i)));
        for (std::uint32_t k = 0; k <= 133; ++k) {
            const StepEvent& sample = log->event(i + 1 + k);
            QCOMPARE(std::make_pair(sample.x, sample.y), std::make_pair(200, 300 + int(k)));
        }
        QCOMPARE(log->countersAt(log->size()).pixels.tested, 40251U);
    }

    /// Rows above and below the picture are no part of what is filled, and the sentence says so.
    void columnsOffTheTargetSaySo()
    {
        const QSize size(16, 8);
        Settings settings = plainSettings(size);
        settings.algorithm = Algorithm::ColumnFill;
        const auto said = [&](double y0, double y1, double y2) {
            Settings all = settings;
            all.clipping = Clipping::None;
            const auto log = renderSteps(
                soup({atPixel(2.5, y0, 0.5, size), atPixel(12.5, y1, 0.5, size), atPixel(7.5, y2, 0.5, size)}), all);
            const auto columns = log->eventsOf(StepKind::Column);
            return columns.empty() ? QString() : stepText(*log, columns[columns.size() / 2]);
        };
        // The middle column is x = 7, that of the third corner. The edge from (2, 2) to (7, 12) takes 4 rows in each of
        // its steps 1, 3 and 5 and is 2 rows too low there; the one from (2, -6) to (7, -3) takes 1, 1 and 2.
        const QString above = said(-5.5, -4.5, -2.5);
        QVERIFY2(above.contains(QLatin1String("min -5, max -2: nothing of it is on the target")), qPrintable(above));
        const QString across = said(2.5, 2.5, 12.5);
        QVERIFY2(across.contains(QLatin1String("min 2, max 14, of which 2 to 7 are on the target")),
                 qPrintable(across));
        const QString within = said(1.5, 1.5, 5.5);
        QVERIFY2(within.contains(QLatin1String("filled from min 1 to max 5")), qPrintable(within));
    }

    /// With the mistake a line of 1 x 10 has two samples, the second of them 20 rows on.
    void linesWithOneRowAColumn()
    {
        std::vector<std::pair<int, int>> at;
        oneRowLine({2, 2}, {3, 12}, [&](int x, int y, double) { at.emplace_back(x, y); });
        QCOMPARE(at, (std::vector<std::pair<int, int>>{{2, 2}, {3, 22}}));
    }
};

QTEST_GUILESS_MAIN(TestColumnFill)
#include "test_column_fill.moc"
