// The window outlives want of memory and threads: whatever a background job lacks is a message, and what is shown
// stays.
#include "tests/scarce_system.h"
#include "tests/window_fixture.h"
#include "ui/base/latest_result.h"
#include "ui/face/cards.h"
#include "ui/truth/case_browser.h"
#include "ui/truth/experiment_panel.h"
#include "ui/truth/truth_mode.h"

#include <QDockWidget>
#include <QLabel>

#include <algorithm>
#include <atomic>
#include <functional>
#include <map>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <vector>

using namespace rasterlens;
using namespace rasterlens::test;

class TestBackgroundJobs : public WindowFixture
{
    Q_OBJECT

private:
    /// One kind of job of the window: how it is begun, and how its result is taken back.
    struct Kind {
        std::function<void()> begin;
        std::function<void()> takeBack;
        std::function<QString()> ownMessage; ///< where it is not the message above the canvas
    };
    std::map<QString, Kind> m_kinds;

    TruthMode& truth() { return m_window->truthMode(); }
    Cards& cards() { return m_window->cards(); }

    /// Each time in a picture of another size: the badge keeps the right ones that it has.
    void setMistakes(const QStringList& mistakes)
    {
        Settings next = settings();
        next.mistakes = mistakes;
        next.size.setWidth(next.size.width() < 100 ? next.size.width() + 1 : 48);
        document().setSettings(next);
    }

    void describeKinds()
    {
        const auto noMessage = [] { return QString(); };
        m_kinds["opening"] = {[this] { document().open(QStringLiteral("builtin:cube")); },
                              [this] { document().open(QStringLiteral("builtin:tile-square")); }, noMessage};
        m_kinds["picture"] = {[this] { shade(Shading::Depth); }, [this] { shade(Shading::Gouraud); }, noMessage};
        m_kinds["tiled picture"] = {[this] { useTiled(3); }, [this] { useTiled(0); }, noMessage};
        const auto closeAll = [this] {
            viewport().selectPixel(std::nullopt);
            for (QDockWidget* dock : m_window->findChildren<QDockWidget*>())
                dock->hide();
        };
        const auto panel = [closeAll, this, noMessage](const char* name) {
            return Kind{[this, name] {
                            cards().show(QLatin1String(name));
                            viewport().selectPixel(QPoint(20, 20));
                        },
                        closeAll, noMessage};
        };
        m_kinds["pixel card"] = panel("why");
        m_kinds["clip theatre"] = panel("clip");
        m_kinds["race"] = panel("race");
        m_kinds["derivation"] = panel("derive");
        m_kinds["badge"] = {[this] { setMistakes({QStringLiteral("all-inclusive")}); }, [this] { setMistakes({}); },
                            noMessage};
        m_kinds["referee"] = {[this] { truth().referee().setOn(true); }, [this] { truth().referee().setOn(false); },
                              [this] { return truth().referee().text(); }};
        m_kinds["comparison"] = {[this] { truth().comparison().setView(CompareView::Difference); },
                                 [this] { truth().comparison().setView(CompareView::Off); },
                                 [this] { return truth().comparison().text(); }};
        m_kinds["recording"] = {[this] { m_window->stepMode().session().open(); },
                                [this] { m_window->stepMode().session().close(); }, noMessage};
        m_kinds["measuring"] = {[this] { truth().experiment().run(1); }, [this] { truth().experiment().cancel(); },
                                [this] {
                                    QStringList notes;
                                    for (const QLabel* label : truth().experiment().findChildren<QLabel*>())
                                        notes << label->text();
                                    return notes.join(QLatin1Char(' '));
                                }};
    }

    void shade(Shading shading)
    {
        Settings next = settings();
        next.shading = shading;
        document().setSettings(next);
    }

    void useTiled(int threads)
    {
        Settings next = settings();
        next.algorithm = threads > 0 ? Algorithm::Tiled : Algorithm::EdgeEquation;
        next.threads = std::max(threads, 1);
        document().setSettings(next);
    }

    void nameKinds()
    {
        describeKinds();
        QTest::addColumn<QString>("kind");
        for (const auto& [name, kind] : m_kinds)
            QTest::newRow(qPrintable(name)) << name;
    }

    /// What any place of the window says about the job.
    QString said(const Kind& kind) { return m_window->message() + QLatin1Char(' ') + kind.ownMessage(); }

    /// The picture on the canvas is the one of the present settings.
    bool pictureIsRight()
    {
        Frame expected;
        render(*document().scene(), settings(), expected);
        return m_window->stepMode().session().isOpen() || picture() == expected.image ||
               truth().comparison().view() != CompareView::Off;
    }

private Q_SLOTS:
    void cleanup()
    {
        threadsRefused = false;
        giveMemory();
        closeWindow();
    }

    void everyAllocationMayFail_data() { nameKinds(); }

    /// The nth allocation of the background and all after it fail, for every n that a job gets to, until the window has
    /// noticed; the job is then begun anew and comes to its end.
    void everyAllocationMayFail()
    {
        QFETCH(QString, kind);
        QVERIFY(openSmall(QStringLiteral("builtin:tile-square"), {48, 36}));
        const Kind job = m_kinds[kind];
        job.begin(); // its thread starts
        QVERIFY(complete());
        bool told = false;
        bool refused = true;
        for (int left = 0; refused; left += 1 + left / 4) {
            job.takeBack();
            QVERIFY2(complete(), qPrintable(QString::number(left)));
            refuseMemoryAfter(left);
            job.begin();
            QVERIFY(waitFor([this] { return allocationsRefused > 0 || m_window->isComplete(); }));
            refused = allocationsRefused > 0;
            giveMemory();
            QVERIFY2(complete(), qPrintable(QString::number(left)));
            told = told || said(job).contains(QStringLiteral("memory"));
        }
        QVERIFY(told);
        QVERIFY(pictureIsRight());
    }

    void closingWhileItRuns_data()
    {
        nameKinds();
        QTest::newRow("exporting") << QStringLiteral("exporting");
    }

    /// The window goes at any moment of a job: at once, or after some turns of its event loop. It waits for no answer,
    /// and no result comes after it.
    void closingWhileItRuns()
    {
        QFETCH(QString, kind);
        for (int turns = 0; turns < 12; turns += 1 + turns / 2) {
            if (!m_window)
                openWindow();
            QVERIFY(openSmall(QStringLiteral("builtin:tile-square"), {48, 36}));
            if (kind == QLatin1String("exporting")) {
                m_window->stepMode().session().open();
                QVERIFY(complete());
                m_window->stepMode().exportRun(m_folder.path(), {0, 12, 16});
            } else {
                m_kinds[kind].begin();
            }
            for (int turn = 0; turn < turns; ++turn)
                QCoreApplication::processEvents();
            QVERIFY(m_window->close());
            closeWindow();
            QCoreApplication::processEvents();
        }
    }

    void threadsMayNotStart_data() { nameKinds(); }

    void threadsMayNotStart()
    {
        if (RASTERLENS_SANITIZED)
            QSKIP("the sanitizers start threads themselves");
        QFETCH(QString, kind);
        QVERIFY(openSmall(QStringLiteral("builtin:tile-square"), {48, 36}));
        const Kind job = m_kinds[kind];
        if (kind == QLatin1String("opening") || kind == QLatin1String("picture"))
            openWindow(); // their threads run already in the one before
        threadsRefused = true;
        if (kind == QLatin1String("picture"))
            document().setScene(std::make_shared<const Scene>(
                *parseCase("size 8 8\ntri 0 0 0 1 1 0 0  1 0 0 1 0 1 0  0 1 0 1 0 0 1\n", QStringLiteral("one.case"))
                     .scene));
        else
            job.begin();
        QVERIFY(waitFor([&] { return said(job).contains(QStringLiteral("thread")); }));
        threadsRefused = false;
        QVERIFY(waitFor([this] { return !document().isLoading(); }));
        job.takeBack();
        QVERIFY(complete());
        job.begin();
        QVERIFY(complete());
        QVERIFY(pictureIsRight());
    }

    /// The catalogue is long: a few places have to do, then it goes on where it was.
    void casesGoOnAfterwards()
    {
        CaseModel model;
        for (const int left : {0, 1, 7, 60, 300, 2000}) {
            QSignalSpy failed(&model, &CaseModel::failed);
            model.start();
            const int before = model.judged();
            QVERIFY(waitFor([&] { return model.judged() > before; }));
            refuseMemoryAfter(left);
            QVERIFY(waitFor([&] { return allocationsRefused > 0; }));
            giveMemory();
            QVERIFY(waitFor([&] { return !model.isBusy() || model.judged() > before + 4; }));
            if (!model.isBusy()) {
                QVERIFY(model.judged() < model.rowCount());
                QVERIFY(failed.size() == 1 && failed[0][0].toString().contains(QStringLiteral("memory")));
            }
        }
    }

    void aFailedSceneLeavesTheFormerOne()
    {
        QVERIFY(openSmall(QStringLiteral("builtin:tile-square"), {48, 36}));
        const auto former = document().scene();
        const QImage formerPicture = picture();
        refuseMemoryAfter(0);
        document().open(QStringLiteral("builtin:cube"));
        QVERIFY(waitFor([] { return allocationsRefused > 0; }));
        giveMemory();
        QVERIFY(complete());
        QCOMPARE(document().scene(), former);
        QCOMPARE(picture(), formerPicture);
        QCOMPARE(m_window->message(), QStringLiteral("builtin:cube: there is not enough memory to open it"));
    }

    void theLatestWins()
    {
        std::vector<int> taken;
        LatestResult<int> result([&](int n) { taken.push_back(n); }, [](Lack) {});
        std::atomic<bool> begun = false;
        result.ask(
            [&](const auto& turn) {
                begun = true;
                while (!turn.stop().stop_requested())
                    std::this_thread::yield();
                return 1;
            },
            LatestJob::Running::Interrupt);
        QVERIFY(waitFor([&] { return begun.load(); }));
        for (const int n : {2, 3, 4})
            result.ask([n](const auto&) { return n; }, LatestJob::Running::Interrupt);
        QVERIFY(waitFor([&] { return !result.isBusy(); }));
        QVERIFY(!taken.empty() && taken.back() == 4);
        QVERIFY(std::ranges::find(taken, 1) == taken.end());
        result.ask([](const auto&) { return 5; }, LatestJob::Running::Interrupt);
        result.drop();
        QVERIFY(!result.isBusy());
        result.ask([](const auto&) { return 6; }, LatestJob::Running::Interrupt);
        QVERIFY(waitFor([&] { return !result.isBusy(); }));
        QCOMPARE(taken.back(), 6);
        QVERIFY(std::ranges::find(taken, 5) == taken.end());
    }

    /// However fast a job is, it is never more than one result ahead of the window.
    void resultsDoNotPileUp()
    {
        std::atomic<int> made = 0;
        int taken = 0;
        int furthest = 0;
        LatestResult<int> result(
            [&](int) {
                furthest = std::max(furthest, made - taken);
                ++taken;
                QTest::qSleep(1);
            },
            [](Lack) {});
        result.ask(
            [&](const auto& turn) {
                for (int i = 0; i < 100; ++i)
                    turn.deliver(++made);
                return ++made;
            },
            LatestJob::Running::Finish);
        QVERIFY(waitFor([&] { return !result.isBusy(); }));
        QCOMPARE(taken, 101);
        QVERIFY2(furthest <= 2,
                 qPrintable(QString::number(furthest))); // the one taken, and one that waits to be handed over
    }

    void lackIsTold()
    {
        std::vector<Lack> lacks;
        int taken = 0;
        LatestResult<int> result([&](int) { ++taken; }, [&](Lack lack) { lacks.push_back(lack); });
        const auto fail = [&](auto&& toss) {
            result.ask(
                [toss](const auto&) {
                    toss();
                    return 0;
                },
                LatestJob::Running::Finish);
            return waitFor([&] { return !result.isBusy(); });
        };
        QVERIFY(fail([] { throw std::bad_alloc(); }));
        QVERIFY(fail([] { throw std::length_error("more than any memory holds"); }));
        QVERIFY(fail([] { throw std::system_error(EAGAIN, std::system_category()); }));
        QCOMPARE(lacks, (std::vector{Lack::Memory, Lack::Memory, Lack::Threads}));
        QVERIFY(fail([] {}));
        QCOMPARE(taken, 1);
    }
};

QTEST_MAIN(TestBackgroundJobs)
#include "test_background_jobs.moc"
