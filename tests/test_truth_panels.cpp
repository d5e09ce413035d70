// The panels of the truth that measure: speed against error, and the hard cases.
#include "core/io/case_file.h"
#include "tests/window_fixture.h"
#include "ui/base/dock.h"
#include "ui/steps/step_mode.h"
#include "ui/truth/case_browser.h"
#include "ui/truth/experiment_model.h"
#include "ui/truth/experiment_panel.h"
#include "ui/truth/truth_mode.h"
#include "ui/window/panel_places.h"

#include <QAbstractItemModelTester>
#include <QCheckBox>
#include <QComboBox>
#include <QJsonArray>
#include <QJsonDocument>
#include <QLineEdit>
#include <QListView>
#include <QRegularExpression>
#include <QSet>
#include <QTableView>

using namespace rasterlens;
using namespace rasterlens::test;

class TestTruthPanels : public WindowFixture
{
    Q_OBJECT

private:
    /// What the program says about cases follows the language: notes, what must hold, verdicts.
    void checkLanguageOfCases()
    {
        const CaseModel& model = browser().model();
        const auto texts = [&] {
            QStringList all;
            for (int i = 0; i < model.rowCount(); ++i) {
                const CaseModel::Case& one = model.at(i);
                all << one.noteText().split(QLatin1Char('\n')) << one.expectationsText().split(QLatin1Char('\n'));
                for (std::size_t v = 0; v < one.verdicts.size(); ++v)
                    if (!one.verdicts[v].reasons.empty())
                        all << one.reasonText(v);
            }
            return all;
        };
        const QStringList english = texts();
        m_window->setLanguage(LanguageKind::Chinese);
        const QStringList chinese = texts();
        m_window->setLanguage(LanguageKind::English);
        QCOMPARE(texts(), english);
        QCOMPARE(chinese.size(), english.size());
        const auto isHan = [](QChar c) { return c.script() == QChar::Script_Han; };
        for (qsizetype i = 0; i < english.size(); ++i) {
            QVERIFY2(std::ranges::none_of(english[i], isHan), qPrintable(english[i]));
            QVERIFY2(std::ranges::any_of(chinese[i], isHan), qPrintable(english[i]));
        }
    }

    TruthMode& truth() { return m_window->truthMode(); }
    ExperimentPanel& panel() { return truth().experiment(); }
    CaseBrowser& browser() { return truth().caseBrowser(); }

    bool openSmall(const char* name) { return WindowFixture::openSmall(QLatin1String(name), {64, 48}); }
    bool measure()
    {
        truth().showPanel(QStringLiteral("experiment"));
        panel().run(1);
        return panel().isRunning() && complete() && !panel().isRunning();
    }

private Q_SLOTS:
    void everyVariantIsADotAndARow()
    {
        QVERIFY(openSmall("builtin:cube"));
        QVERIFY(measure());
        const std::size_t variants = supportedVariants(*document().scene(), document().settings()).size();
        QVERIFY(variants >= 30);
        QCOMPARE(panel().rows().size(), variants);
        QCOMPARE(panel().plot().dotCount(), static_cast<int>(variants));
        QCOMPARE(panel().table().model()->rowCount(), static_cast<int>(variants));
        const QAbstractItemModelTester tester(panel().table().model(),
                                              QAbstractItemModelTester::FailureReportingMode::QtTest);
        const QString ratio = panel().ratioText();
        static const QRegularExpression spread(
            QStringLiteral("takes (\\S+) times .* \\((\\S+) to (\\S+)\\); .*1\\.36"));
        const QRegularExpressionMatch match = spread.match(ratio);
        QVERIFY2(match.hasMatch(), qPrintable(ratio));
        QVERIFY(match.captured(2).toDouble() <= match.captured(1).toDouble());
        QVERIFY(match.captured(1).toDouble() <= match.captured(3).toDouble());
    }

    /// Rows name their algorithm; dots that none beats and the chosen one are named on the plot, all others in
    /// tool-tips.
    void variantsHaveNames()
    {
        QVERIFY(openSmall("builtin:cube"));
        QVERIFY(measure());
        const QAbstractItemModel& table = *panel().table().model();
        const SettingsField& algorithm = *findSettingsField(QStringLiteral("algorithm"));
        QSet<QString> names;
        for (int row = 0; row < table.rowCount(); ++row) {
            const QString name = table.index(row, ExperimentModel::Name).data().toString();
            QVERIFY2(std::ranges::any_of(algorithm.choices,
                                         [&](const Choice& c) { return name.startsWith(QLatin1String(c.title)); }),
                     qPrintable(name));
            names.insert(name);
        }
        QCOMPARE(names.size(), table.rowCount());

        panel().errorBox()->setCurrentIndex(static_cast<int>(ErrorMeasure::Coverage));
        QVERIFY(panel().plot().sentence().isEmpty());
        QVERIFY(!panel().plot().labels().isEmpty());
        const auto beaten = std::ranges::find(panel().rows(), false, &ExperimentRow::frontier);
        QVERIFY(beaten != panel().rows().end());
        const int before = static_cast<int>(panel().plot().labels().size());
        panel().plot().setChosen(static_cast<int>(beaten - panel().rows().begin()));
        QVERIFY(titleOf(*beaten).contains(panel().plot().labels().front().chopped(1)));
        QVERIFY(panel().plot().labels().size() >= std::min(before, 1));
        QVERIFY(std::ranges::any_of(panel().remarks(),
                                    [](const QString& line) { return line.contains(QLatin1Char('%')); }));
    }

    void whereAllIsExactASentenceSaysSo()
    {
        QVERIFY(openSmall("builtin:square-diagonal"));
        Settings settings = document().settings();
        settings.size = {8, 8};
        document().setSettings(settings);
        QVERIFY(measure());
        panel().errorBox()->setCurrentIndex(static_cast<int>(ErrorMeasure::Coverage));
        const bool exact = isExactThroughout(panel().rows(), ErrorMeasure::Coverage);
        QCOMPARE(panel().plot().sentence().isEmpty(), !exact);
        QCOMPARE(panel().plot().dotCount() == 0, exact);
        QVERIFY(exact);
    }

    /// With the switch on, another renderer has a row; without one, the note says why.
    void otherRenderersAreMeasured()
    {
        if (RASTERLENS_SANITIZED)
            QSKIP("drivers are not built for the sanitizers");
        QVERIFY(openSmall("builtin:cube"));
        panel().othersBox()->setChecked(true);
        QVERIFY(measure());
        panel().othersBox()->setChecked(false);
        const auto other =
            std::ranges::find_if(panel().rows(), [](const ExperimentRow& row) { return row.other.has_value(); });
        const bool isTold = std::ranges::any_of(
            panel().remarks(), [](const QString& line) { return line.startsWith(QLatin1String("No other renderer")); });
        QCOMPARE(isTold, other == panel().rows().end());
        if (isTold)
            return;
        const Settings before = document().settings();
        panel().load(static_cast<int>(other - panel().rows().begin()));
        QVERIFY(document().settings() == before); // there is nothing to load
        QVERIFY(ExperimentModel::describe(*other).contains(QLatin1String("tie rule")));
    }

    /// Dots keep to the axes: more error is further right, a longer time higher, more triangles a second higher.
    void dotsLieWhereTheirNumbersSay()
    {
        QVERIFY(openSmall("builtin:tile-square"));
        QVERIFY(measure());
        for (int error = 0; error < kErrorMeasures; ++error)
            for (int speed = 0; speed < 2; ++speed) {
                panel().errorBox()->setCurrentIndex(error);
                panel().speedBox()->setCurrentIndex(speed);
                QCoreApplication::processEvents();
                const auto number = [&](const ExperimentRow& row) { return speedOf(row, SpeedMeasure(speed)).median; };
                const auto& rows = panel().rows();
                for (std::size_t i = 1; i < rows.size(); ++i) {
                    const auto a = panel().plot().placeOf(static_cast<int>(i - 1));
                    const auto b = panel().plot().placeOf(static_cast<int>(i));
                    const auto errorA = errorOf(rows[i - 1], ErrorMeasure(error));
                    const auto errorB = errorOf(rows[i], ErrorMeasure(error));
                    QCOMPARE(a.has_value(), errorA.has_value());
                    if (!a || !b)
                        continue;
                    QCOMPARE(a->x() < b->x(), *errorA < *errorB);
                    QCOMPARE(a->y() > b->y(), number(rows[i - 1]) < number(rows[i]));
                }
            }
    }

    void aClickOnADotLoadsTheVariant()
    {
        QVERIFY(openSmall("builtin:cube"));
        QVERIFY(measure());
        panel().errorBox()->setCurrentIndex(static_cast<int>(ErrorMeasure::Color));
        QCoreApplication::processEvents();
        Settings moved = document().settings();
        moved.view.yaw = 33;
        document().setSettings(moved);
        for (const char* id : {"edge-equation-bits-0", "edge-walking-float32"}) {
            const auto row = std::ranges::find(panel().rows(), QLatin1String(id), &ExperimentRow::variant);
            QVERIFY(row != panel().rows().end());
            const int index = static_cast<int>(row - panel().rows().begin());
            const QPoint at = panel().plot().placeOf(index)->toPoint();
            QWidget* target = panel().plot().childAt(at);
            QVERIFY(target);
            QTest::mouseClick(target, Qt::LeftButton, {}, target->mapFrom(&panel().plot(), at));
            QVERIFY(complete());
            // Another dot may lie on the same spot; what was loaded is one of them.
            const auto same = std::ranges::any_of(panel().rows(), [&](const ExperimentRow& other) {
                Settings settings = other.settings;
                settings.view = document().settings().view;
                const auto place = panel().plot().placeOf(static_cast<int>(&other - panel().rows().data()));
                return settings == document().settings() && place && (*place - QPointF(at)).manhattanLength() < 18;
            });
            QVERIFY(same);
            QCOMPARE(document().settings().view.yaw, 33.0);
        }
        const auto row = std::ranges::find(panel().rows(), QLatin1String("tiled-2x2"), &ExperimentRow::variant);
        panel().load(static_cast<int>(row - panel().rows().begin()));
        QCOMPARE(document().settings().algorithm, Algorithm::Tiled);
        QCOMPARE(document().settings().samples, Samples::Grid2);
    }

    void cancelKeepsWhatIsThere()
    {
        QVERIFY(openSmall("builtin:torus-knot"));
        panel().run(1000);
        QVERIFY(panel().isRunning());
        QVERIFY(waitFor([this] { return !panel().rows().empty(); }));
        panel().cancel();
        QVERIFY(waitFor([this] { return !panel().isRunning(); }));
        QVERIFY(!panel().rows().empty());
        QVERIFY(panel().rows().front().ms.frames < 1000);
    }

    void exports()
    {
        QVERIFY(openSmall("builtin:cube"));
        QVERIFY(measure());
        const auto written = [this](const char* name) {
            const QString path = m_folder.filePath(QLatin1String(name));
            const auto error = panel().exportTo(path);
            QFile file(path);
            return error || !file.open(QIODevice::ReadOnly) ? QByteArray() : file.readAll();
        };
        const auto rows = static_cast<qsizetype>(panel().rows().size());
        QCOMPARE(written("rows.csv").count('\n'), rows + 1);
        QCOMPARE(QJsonDocument::fromJson(written("rows.json")).array().size(), rows);
        const QByteArray svg = written("plot.svg");
        QVERIFY(svg.contains("<svg"));
        QVERIFY(svg.count("<path") + svg.count("<polyline") + svg.count("<polygon") + svg.count("<circle") > 30);
        QVERIFY(!svg.contains("<image"));
        const QImage png = QImage::fromData(written("plot.png"));
        QVERIFY(png.width() >= 1000);
        QVERIFY(panel().exportTo(QStringLiteral("/no/such/folder/rows.csv")).has_value());
    }

    void casesAreJudgedFilteredAndTranslated()
    {
        truth().showPanel(QStringLiteral("cases"));
        QVERIFY(browser().model().isBusy());
        QVERIFY(waitFor([this] { return !browser().model().isBusy(); }));
        const CaseModel& model = browser().model();
        QVERIFY(model.rowCount() >= 100);
        QCOMPARE(model.judged(), model.rowCount());
        int failing = 0;
        for (int i = 0; i < model.rowCount(); ++i) {
            const CaseModel::Case& one = model.at(i);
            QCOMPARE(one.verdicts.size(), CaseModel::kVariants.size());
            QVERIFY2(!one.thumbnail.isNull(), qPrintable(one.name));
            QVERIFY2(!one.note.isEmpty() && !one.expectations.empty(), qPrintable(one.name));
            failing += one.fails();
            // Fixed point is right wherever it draws at all, and float32 is not.
            QVERIFY2(one.verdicts[0].grade != CaseGrade::Fails, qPrintable(one.name + textOf(one.verdicts[0].reasons)));
        }
        QVERIFY(failing > 0 && failing < model.rowCount());
        QCOMPARE(browser().listed(), model.rowCount());
        browser().failingBox()->setChecked(true);
        QCOMPARE(browser().listed(), failing);
        browser().failingBox()->setChecked(false);
        browser().filterEdit()->setText(QStringLiteral("needle"));
        QVERIFY(browser().listed() > 0 && browser().listed() < model.rowCount());
        browser().filterEdit()->setText(QStringLiteral("no such case"));
        QCOMPARE(browser().listed(), 0);
        checkLanguageOfCases();
        const QAbstractItemModelTester tester(&browser().model(),
                                              QAbstractItemModelTester::FailureReportingMode::QtTest);
    }

    void aClickOpensTheCaseInTheLens()
    {
        truth().showPanel(QStringLiteral("cases"));
        browser().filterEdit()->setText(QStringLiteral("cancellation_one_unit_inside"));
        QCOMPARE(browser().listed(), 1);
        const QModelIndex only = browser().list().model()->index(0, 0);
        constexpr std::size_t kFloat32 = 3;
        const QPoint sign = CaseBrowser::signBox(browser().list().visualRect(only), kFloat32).center();
        QTest::mouseClick(browser().list().viewport(), Qt::LeftButton, {}, sign);
        const auto isShown = [this] {
            return m_window->isSettled() && m_window->stepMode().session().event() && truth().referee().judgement();
        };
        QVERIFY(waitFor(isShown));
        QCOMPARE(document().settings().numberType, NumberType::Float32);
        const WrongPixel& wrong = truth().referee().judgement()->wrong.front();
        QCOMPARE(m_window->viewport().selectedPixel(), std::optional(QPoint(wrong.x, wrong.y)));
        QVERIFY(m_window->stepMode().lens().model());
        QVERIFY(QTest::qWaitFor([this] { return m_window->viewport().transform().zoom >= 16; }));
        const QPointF shown = m_window->viewport().transform().toCanvas(QPointF(wrong.x + 0.5, wrong.y + 0.5));
        QVERIFY(m_window->viewport().rect().contains(shown.toPoint()));

        // A case that is right is opened as well, at a tie.
        truth().showCase(QStringLiteral("001_edges_four_quarters"), QStringLiteral("edge-walking"));
        QVERIFY(waitFor([this] { return document().scene()->id.contains(QLatin1String("/001_")); }));
        QVERIFY(waitFor(isShown));
        QCOMPARE(document().settings().algorithm, Algorithm::EdgeWalking);
        QCOMPARE(truth().referee().judgement()->difference.wrong(), std::uint64_t{0});
    }

    /// Beside the canvas or, in a window with room for it, below; nothing lies above the canvas, which keeps half of
    /// the window's height.
    void panelsLeaveTheCanvasItsRoom_data()
    {
        QTest::addColumn<QString>("panel");
        QTest::addColumn<QSize>("size");
        QTest::addColumn<bool>("below");
        for (const QString& panel : {QStringLiteral("cases"), QStringLiteral("experiment")})
            for (const auto& [size, below] :
                 {std::pair(QSize(1024, 768), false), {QSize(1280, 800), false}, {QSize(1440, 960), true}})
                QTest::addRow("%s %d", qPrintable(panel), size.width()) << panel << size << below;
    }
    void panelsLeaveTheCanvasItsRoom()
    {
        QFETCH(QString, panel);
        QFETCH(QSize, size);
        QFETCH(bool, below);
        m_window->resize(size);
        m_window->panels().setTabsAtBottom(below);
        truth().showPanel(panel);
        for (int i = 0; i < 5; ++i)
            QCoreApplication::processEvents();
        QCOMPARE(m_window->size(), size);
        Dock* dock = truth().docks()[static_cast<std::size_t>(TruthMode::panelNames().indexOf(panel))];
        QVERIFY(!dock->isFloating());
        QCOMPARE(m_window->dockWidgetArea(dock), below ? Qt::BottomDockWidgetArea : Qt::RightDockWidgetArea);
        const auto inWindow = [this](const QWidget& widget) {
            return QRect(widget.mapTo(m_window.get(), QPoint(0, 0)), widget.size());
        };
        const ViewportWidget& canvas = m_window->viewport();
        QVERIFY(!inWindow(*dock).intersects(inWindow(canvas)));
        QVERIFY(m_window->rect().contains(inWindow(*dock)));
        QVERIFY2(2 * canvas.height() >= size.height() && canvas.width() >= 250,
                 qPrintable(QStringLiteral("%1 x %2").arg(canvas.width()).arg(canvas.height())));
        QVERIFY2(dock->height() >= 130 && dock->width() >= 300,
                 qPrintable(QStringLiteral("%1 x %2").arg(dock->width()).arg(dock->height())));
        m_window->resetLayout();
        QVERIFY(!dock->isVisible());
    }

    void panelsShareOnePlaceAsTabs()
    {
        m_window->resize(1024, 768);
        for (const QString& panel : TruthMode::panelNames() + TruthMode::panelNames())
            truth().showPanel(panel);
        QCoreApplication::processEvents();
        const std::vector<Dock*>& docks = truth().docks();
        QVERIFY(m_window->tabifiedDockWidgets(docks[0]).contains(docks.back()));
        // The one asked for last is in the window, the others beyond it.
        for (Dock* dock : docks)
            QCOMPARE(m_window->rect().intersects(dock->geometry()), dock == docks.back());
        QVERIFY(m_window->rect().contains(docks.back()->geometry()));
        QVERIFY(m_window->viewport().height() >= 180);
    }
};

QTEST_MAIN(TestTruthPanels)
#include "test_truth_panels.moc"
