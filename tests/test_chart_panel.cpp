// The panel of charts: each is drawn when it is chosen, in the language in use, and written as it stands.
#include "tests/window_fixture.h"
#include "ui/truth/chart_panel.h"
#include "ui/truth/truth_mode.h"

#include <QComboBox>
#include <QFile>
#include <QImage>
#include <QTemporaryDir>

#include <algorithm>

using namespace rasterlens;
using namespace rasterlens::test;

class TestChartPanel : public WindowFixture
{
    Q_OBJECT

private:
    ChartPanel& panel() { return m_window->truthMode().charts(); }
    bool choose(const char* id)
    {
        m_window->truthMode().showPanel(QStringLiteral("charts"));
        panel().choose(QLatin1String(id));
        return complete() && !panel().isBusy();
    }

private Q_SLOTS:
    void everyChartIsDrawn()
    {
        QVERIFY(openSmall(QLatin1String("builtin:cube"), {64, 48}));
        for (const ChartInfo& info : chartInfos()) {
            QVERIFY(choose(info.id));
            QCOMPARE(QLatin1String(panel().info().id), QLatin1String(info.id));
            QVERIFY2(panel().plot().curveCount() > 0, info.id);
            QVERIFY(panel().chart().series.size() >= std::size_t(panel().plot().curveCount()));
        }
    }

    /// More is higher, and farther along the axis is further right.
    void curvesLieWhereTheirValuesSay()
    {
        QVERIFY(openSmall(QLatin1String("builtin:cube"), {64, 48}));
        QVERIFY(choose("attributes"));
        QCoreApplication::processEvents();
        const Chart& chart = panel().chart();
        for (std::size_t i = 1; i < chart.x.size(); ++i) {
            const QPointF before = panel().plot().placeOf(0, i - 1);
            const QPointF at = panel().plot().placeOf(0, i);
            QVERIFY(before.x() < at.x());
            QCOMPARE(before.y() > at.y(), chart.series[0].y[i - 1] < chart.series[0].y[i]);
        }
        QVERIFY(panel().plot().placeOf(0, 5).y() < panel().plot().placeOf(1, 5).y()); // affine has the larger error
    }

    void notesFollowTheLanguageAndTheScene()
    {
        QVERIFY(openSmall(QLatin1String("builtin:cube"), {64, 48}));
        QVERIFY(choose("snapping"));
        const QString english = panel().note();
        QVERIFY(english.contains(QLatin1String("faces in the view volume")));
        m_window->setLanguage(LanguageKind::Chinese);
        QCoreApplication::sendPostedEvents();
        const auto isHan = [](QChar c) { return c.script() == QChar::Script_Han; };
        for (const QString& line : panel().note().split(QLatin1Char('\n')))
            QVERIFY2(std::ranges::any_of(line, isHan), qPrintable(line));
        for (int i = 0; i < panel().box()->count(); ++i)
            QVERIFY(std::ranges::any_of(panel().box()->itemText(i), isHan));
        m_window->setLanguage(LanguageKind::English);
        QCoreApplication::sendPostedEvents();
        QCOMPARE(panel().note(), english);
        Settings settings = document().settings();
        settings.view.yaw += 20;
        document().setSettings(settings);
        QVERIFY(panel().note().contains(QLatin1String("have changed since")));
        QVERIFY(choose("lines")); // is about no scene
        settings.view.yaw += 20;
        document().setSettings(settings);
        QVERIFY(!panel().note().contains(QLatin1String("have changed since")));
    }

    void whatCannotBeDrawnSaysWhy()
    {
        QVERIFY(openSmall(QLatin1String("builtin:square-diagonal"), {8, 8})); // in clip space
        QVERIFY(choose("distance"));
        QCOMPARE(panel().plot().curveCount(), 0);
        QVERIFY2(panel().note().contains(QLatin1String("has no camera")), qPrintable(panel().note()));
    }

    void filesHoldTheChart()
    {
        const QTemporaryDir folder;
        QVERIFY(openSmall(QLatin1String("builtin:cube"), {64, 48}));
        QVERIFY(choose("attributes"));
        const QString csv = folder.filePath(QStringLiteral("a.csv"));
        QVERIFY(!panel().exportTo(csv));
        QFile file(csv);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll(), chartCsv(panel().chart()));
        const QString png = folder.filePath(QStringLiteral("a.png"));
        QVERIFY(!panel().exportTo(png));
        QCOMPARE(QImage(png).size(), QSize(2000, 1280));
        QVERIFY(!panel().exportTo(folder.filePath(QStringLiteral("a.svg"))));
        QVERIFY(panel().exportTo(folder.filePath(QStringLiteral("a.nonsense"))));
    }
};

QTEST_MAIN(TestChartPanel)
#include "test_chart_panel.moc"
