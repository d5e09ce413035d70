// What the window draws, computes and keeps: at most two pictures a change, none that waits behind another, nothing for
// panels out of sight, and no memory of large pictures. And drags that bring nothing.
#include "core/questions/why.h"
#include "core/render/picture_memory.h"
#include "tests/window_fixture.h"
#include "ui/base/dock.h"
#include "ui/base/numbers.h"
#include "ui/canvas/pixel_overlay.h"
#include "ui/face/cards.h"
#include "ui/face/clip_story.h"
#include "ui/face/clip_theatre.h"
#include "ui/face/pixel_card.h"
#include "ui/face/race_panel.h"
#include "ui/pipeline/canvas_views.h"
#include "ui/pipeline/mistake_badge.h"
#include "ui/pipeline/stage_strip.h"
#include "ui/pipeline/statistics_panel.h"
#include "ui/truth/truth_mode.h"

#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFile>
#include <QLabel>
#include <QMimeData>
#include <QPainter>
#include <QSignalSpy>
#include <QUrl>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

using namespace rasterlens;
using namespace rasterlens::test;

class TestFrameFlow : public WindowFixture
{
    Q_OBJECT

private:
    RenderWorker& worker() { return m_window->worker(); }

    /// Counts the events of one type that a widget gets.
    class EventCounter : public QObject
    {
    public:
        explicit EventCounter(QEvent::Type type) : m_type(type) {}
        int events = 0;

    protected:
        bool eventFilter(QObject*, QEvent* event) override
        {
            events += event->type() == m_type ? 1 : 0;
            return false;
        }

    private:
        QEvent::Type m_type;
    };

    /// The pictures drawn since the last call: those shown and counted, and the right ones of the badge.
    struct Drawn {
        std::uint64_t shown;
        std::uint64_t right;
        friend bool operator==(const Drawn&, const Drawn&) = default;
    };
    Drawn m_before{};
    Drawn drawn()
    {
        const Drawn now{worker().picturesDrawn(), m_window->mistakeBadge().rightPicturesDrawn()};
        const Drawn before = std::exchange(m_before, now);
        return {now.shown - before.shown, now.right - before.right};
    }

    /// Opens or closes the dock around a panel and waits for what it shows.
    bool setShown(QWidget& panel, bool shown)
    {
        QWidget* dock = paneled(panel);
        dock->setVisible(shown);
        if (shown)
            dock->raise();
        QCoreApplication::processEvents();
        return complete();
    }

    static Dock* paneled(QWidget& panel)
    {
        for (QWidget* widget = &panel; widget != nullptr; widget = widget->parentWidget())
            if (auto* dock = qobject_cast<Dock*>(widget))
                return dock;
        return nullptr;
    }

    /// Drags over the window; Qt hands a drop on to what accepted that.
    bool dragIn(const QMimeData& data, Qt::DropActions offered)
    {
        QDragEnterEvent enter(QPoint(200, 200), offered, &data, Qt::LeftButton, Qt::NoModifier);
        enter.ignore();
        QCoreApplication::sendEvent(m_window.get(), &enter);
        return enter.isAccepted();
    }

    QUrl droppedCase()
    {
        QFile file(m_folder.filePath(QStringLiteral("dropped.case")));
        if (file.open(QIODevice::WriteOnly))
            file.write("size 8 8\ntri 0 0 0 1 1 0 0  1 0 0 1 0 1 0  0 1 0 1 0 0 1\n");
        return QUrl::fromLocalFile(file.fileName());
    }

private Q_SLOTS:
    void aChangeIsDrawnTwice_data()
    {
        QTest::addColumn<QStringList>("mistakes");
        QTest::newRow("right") << QStringList();
        QTest::newRow("with a mistake") << QStringList{QStringLiteral("all-inclusive")};
    }

    void aChangeIsDrawnTwice()
    {
        QFETCH(QStringList, mistakes);
        QVERIFY(openSmall(QStringLiteral("builtin:tile-square")));
        QVERIFY(change([&](Settings& s) { s.mistakes = mistakes; }));
        const auto before = worker().picturesDrawn();
        key(Qt::Key_P);
        QVERIFY(complete());
        QCOMPARE(worker().picturesDrawn() - before, 2U);
        key(Qt::Key_P);
        QVERIFY(complete());
        QCOMPARE(worker().picturesDrawn() - before, 4U);
        QCOMPARE(m_window->mistakeBadge().isVisible(), !mistakes.isEmpty());
    }

    /// What a mistake is held against is drawn once, and kept while a setting goes to and fro.
    void rightPicturesAreKept()
    {
        QVERIFY(openSmall(QStringLiteral("builtin:tile-square")));
        drawn();
        QVERIFY(change([](Settings& s) { s.mistakes = {QStringLiteral("affine")}; }));
        QVERIFY((drawn() == Drawn{2, 1}));
        const QStringList lines = m_window->mistakeBadge().lines();
        QVERIFY(change([](Settings& s) { s.mistakes.clear(); }));
        QVERIFY(change([](Settings& s) { s.mistakes = {QStringLiteral("affine")}; }));
        QVERIFY((drawn() == Drawn{4, 0}));
        key(Qt::Key_P);
        QVERIFY(complete());
        QVERIFY((drawn() == Drawn{2, 1}));
        key(Qt::Key_P);
        QVERIFY(complete());
        QVERIFY((drawn() == Drawn{2, 0}));
        QCOMPARE(m_window->mistakeBadge().lines(), lines);
        QVERIFY(lines.front().contains(QStringLiteral("wrong pixels")));
        QVERIFY(change([](Settings& s) { s.size = {100, 80}; })); // another right picture
        QVERIFY((drawn() == Drawn{2, 1}));
        QVERIFY(m_window->mistakeBadge().lines() != lines);
    }

    void whatIsShownIsNotDrawnAgain()
    {
        QVERIFY(openSmall(QStringLiteral("builtin:tile-square")));
        const QImage former = picture();
        drawn();
        QVERIFY(document().saveSession(m_folder.filePath(QStringLiteral("saved.json"))));
        QVERIFY(complete());
        QVERIFY(change([](Settings& s) {
            s.algorithm = Algorithm::Tiled;
            s.numberType = NumberType::Float32;
        }));
        QVERIFY(!m_window->message().isEmpty());
        document().undo();
        QVERIFY(complete());
        QVERIFY((drawn() == Drawn{0, 0}));
        QCOMPARE(picture(), former);
        QVERIFY(!m_window->statisticsPanel().isStale());
        key(Qt::Key_P);
        QVERIFY(complete());
        QVERIFY((drawn() == Drawn{2, 0}));
    }

    /// The counted picture looks like the first: the canvas is painted once, and words are made once for each of them.
    /// The outline of the selected pixel's face comes with the count, and is painted then.
    void aChangeIsPaintedAndSaidOnce()
    {
        QVERIFY(openSmall(QStringLiteral("builtin:tile-square")));
        m_window->canvasViews().setOverlayNamed(QStringLiteral("outline"), false); // is known with the count only
        viewport().selectPixel(QPoint(100, 120));
        QVERIFY(complete());
        QTest::qWait(50);
        EventCounter paints(QEvent::Paint);
        EventCounter said(QEvent::ToolTipChange);
        EventCounter titled(QEvent::WindowTitleChange);
        QSignalSpy frames(&worker(), &RenderWorker::frameReady);
        viewport().installEventFilter(&paints);
        m_window->findChild<QLabel*>(QStringLiteral("readout"))->installEventFilter(&said);
        m_window->installEventFilter(&titled);
        key(Qt::Key_P);
        QVERIFY(complete());
        QTest::qWait(50);
        QCOMPARE(frames.size(), 2);
        QCOMPARE(paints.events, 1);
        QVERIFY2(said.events <= frames.size(), qPrintable(QString::number(said.events)));
        QCOMPARE(titled.events, 0);
        m_window->canvasViews().setOverlayNamed(QStringLiteral("outline"), true);
        QTest::qWait(50);
        paints.events = 0;
        key(Qt::Key_P);
        QVERIFY(complete());
        QTest::qWait(50);
        QVERIFY2(paints.events <= 2, qPrintable(QString::number(paints.events)));
    }

    /// While the camera moves a picture is made smaller quickly, and once it rests anew, as ever.
    void aMovingPictureIsScaledWellAtRest_data()
    {
        QTest::addColumn<QString>("algorithm");
        QTest::newRow("tiled first") << QStringLiteral("edge-equation");
        QTest::newRow("tiled alone") << QStringLiteral("tiled");
    }

    void aMovingPictureIsScaledWellAtRest()
    {
        QFETCH(QString, algorithm);
        m_window->document().open(QStringLiteral("builtin:cube"));
        QVERIFY(complete());
        QVERIFY(change([&](Settings& s) {
            s.size = viewport().size() * 3 / 2;
            s.algorithm = algorithm == QLatin1String("tiled") ? Algorithm::Tiled : Algorithm::EdgeEquation;
        }));
        viewport().fit();
        const double zoom = viewport().transform().zoom;
        QVERIFY2(zoom >= 0.5 && zoom < 1, qPrintable(QString::number(zoom)));
        std::vector<bool> moving;
        const auto watch = connect(&viewport(), &ViewportWidget::frameShown, this,
                                   [&](const FramePtr& frame) { moving.push_back(frame->moving); });
        QVERIFY(change([](Settings& s) { s.view.yaw += 20; }));
        QTRY_VERIFY(moving.size() >= 2);
        disconnect(watch);
        QVERIFY(moving.front());
        QVERIFY(!moving.back());
    }

    /// Thin lines, small pictures of large ones, and whatever rests are means over areas.
    void thinLinesAreNotScaledQuickly()
    {
        RenderedFrame frame;
        frame.moving = true;
        CanvasTransform transform;
        transform.zoom = 0.6;
        QVERIFY(isScaledQuickly(frame, transform));
        frame.settings.fill = Fill::Wireframe;
        QVERIFY(!isScaledQuickly(frame, transform));
        frame.settings.fill = Fill::Solid;
        for (const double zoom : {0.49, 1.0, 2.0}) {
            transform.zoom = zoom;
            QVERIFY(!isScaledQuickly(frame, transform));
        }
        transform.zoom = 0.6;
        frame.moving = false;
        QVERIFY(!isScaledQuickly(frame, transform));
    }

    /// The quick filter puts the picture where the mean over areas does: a field of equal pixels is as large.
    void quickScalingKeepsThePlace()
    {
        RenderedFrame frame;
        frame.frame.image = QImage(200, 40, QImage::Format_RGB32);
        frame.frame.image.fill(Qt::black);
        for (int y = 10; y < 30; ++y)
            for (int x = 40; x < 160; ++x)
                frame.frame.image.setPixel(x, y, 0xFFFFFFFF);
        CanvasTransform transform;
        transform.zoom = 0.6;
        transform.origin = {7, 5};
        QImage canvases[2] = {QImage(200, 40, QImage::Format_RGB32), QImage(200, 40, QImage::Format_RGB32)};
        for (const bool moving : {false, true}) {
            frame.moving = moving;
            QImage& canvas = canvases[moving ? 1 : 0];
            canvas.fill(Qt::black);
            QPainter painter(&canvas);
            paintPicture(painter, canvas.rect(), transform, frame, {});
        }
        for (int y = 0; y < 40; ++y)
            for (int x = 0; x < 200; ++x)
                QVERIFY2(std::abs(qRed(canvases[0].pixel(x, y)) - qRed(canvases[1].pixel(x, y))) <= 128,
                         qPrintable(QStringLiteral("%1, %2").arg(x).arg(y)));
    }

    /// What pixels show of the counted picture is painted as soon as it is there.
    void numbersInPixelsComeWithTheCount()
    {
        QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
        viewport().setZoom(128);
        EventCounter paints(QEvent::Paint);
        viewport().installEventFilter(&paints);
        QVERIFY(change([](Settings& s) { s.shading = Shading::Depth; }));
        QCoreApplication::processEvents();
        QVERIFY2(paints.events >= 2, qPrintable(QString::number(paints.events)));
    }

    void closedPanelsComputeNothing()
    {
        QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
        viewport().selectPixel(QPoint(3, 4));
        Cards& cards = m_window->cards();
        QVERIFY(setShown(cards.pixelCard(), true));
        QVERIFY(cards.pixelCard().report() != nullptr);
        QVERIFY(setShown(cards.pixelCard(), false));
        QVERIFY(setShown(m_window->statisticsPanel(), false));
        QVERIFY(change([](Settings& s) { s.tieRule = TieRule::Exclusive; }));
        QVERIFY(cards.pixelCard().report() == nullptr);
        QVERIFY(setShown(cards.pixelCard(), true));
        QVERIFY(setShown(m_window->statisticsPanel(), true));
        const WhyReport expected = why(*document().scene(), settings(), 3, 4);
        QVERIFY(toJson(*cards.pixelCard().report()) == toJson(expected));
        const Statistics& counted = viewport().frame()->statistics;
        QCOMPARE(m_window->statisticsPanel().shown(QStringLiteral("covered")), grouped(counted.pixels.covered));
        QCOMPARE(m_window->stageStrip().figure(Stage::Cover),
                 QStringLiteral("%1 px").arg(grouped(counted.pixels.covered)));
    }

    /// Only the tab in front is computed.
    void tabsBehindComputeNothing()
    {
        QVERIFY(open(QStringLiteral("builtin:cube")));
        Cards& cards = m_window->cards();
        QVERIFY(cards.show(QStringLiteral("clip")) && complete());
        QVERIFY(cards.clipTheatre().story() != nullptr);
        QVERIFY(cards.show(QStringLiteral("race")));
        QCoreApplication::processEvents();
        QVERIFY(complete());
        QVERIFY(paneled(cards.clipTheatre())->isVisible() && !paneled(cards.clipTheatre())->isInSight());
        QVERIFY(cards.clipTheatre().story() == nullptr);
        QVERIFY(change([](Settings& s) { s.clipping = Clipping::None; }));
        QVERIFY(cards.clipTheatre().story() == nullptr);
        QVERIFY(cards.racePanel().race() != nullptr);
        paneled(cards.clipTheatre())->raise();
        QCoreApplication::processEvents();
        QVERIFY(complete());
        QVERIFY(cards.racePanel().race() == nullptr);
        const ClipStory expected = clipStory(*document().scene(), settings(), cards.selection().face());
        QVERIFY(cards.clipTheatre().story() != nullptr);
        QCOMPARE(cards.clipTheatre().story()->steps.size(), expected.steps.size());
        QVERIFY(cards.clipTheatre().story()->rules.clipping == settings().clipping);
    }

    /// The caption is made when the presentation begins, of the settings there are then.
    void theCaptionIsOfThePresentSettings()
    {
        QVERIFY(openSmall(QStringLiteral("builtin:tile-square")));
        QVERIFY(change([](Settings& s) { s.fill = Fill::Wireframe; }));
        const auto* caption = m_window->findChild<QLabel*>(QStringLiteral("caption"));
        QVERIFY(!caption->text().contains(QStringLiteral("Wireframe")));
        m_window->setPresentation(true);
        QVERIFY2(caption->text().contains(QStringLiteral("Wireframe")), qPrintable(caption->text()));
        QVERIFY(change([](Settings& s) { s.fill = Fill::Points; }));
        QVERIFY2(!caption->text().contains(QStringLiteral("Wireframe")), qPrintable(caption->text()));
        m_window->setPresentation(false);
    }

    void aRefusedPictureIsRefusedOnce()
    {
        QVERIFY(openSmall(QStringLiteral("builtin:tile-square")));
        const auto before = worker().picturesDrawn();
        Settings refused = settings();
        refused.cullSpace = CullSpace::View;
        refused.algorithm = Algorithm::Tiled;
        refused.numberType = NumberType::Float32;
        document().setSettings(refused);
        QVERIFY(unsupported(*document().scene(), refused).has_value());
        QSignalSpy settled(m_window.get(), &MainWindow::settled);
        EventCounter changes(QEvent::LanguageChange);
        m_window->installEventFilter(&changes);
        m_window->setLanguage(LanguageKind::Chinese);
        QCoreApplication::processEvents();
        QVERIFY(changes.events > 0);
        QCOMPARE(settled.size(), changes.events); // each is answered once
        QCOMPARE(worker().picturesDrawn(), before);
        QVERIFY(!m_window->message().contains(QStringLiteral("cannot be drawn")));
    }

    /// While the window does something else, the worker waits with the next picture.
    void continuousDrawingWaitsForTheWindow()
    {
        QVERIFY(openSmall(QStringLiteral("builtin:tile-square")));
        worker().setContinuous(true);
        const auto start = worker().picturesDrawn();
        QVERIFY(waitFor([&] { return worker().picturesDrawn() > start + 20; }));
        const auto before = worker().picturesDrawn();
        QTest::qSleep(300); // without events
        QVERIFY2(worker().picturesDrawn() <= before + 2,
                 qPrintable(QString::number(worker().picturesDrawn() - before)));
        worker().setContinuous(false);
        QVERIFY(waitFor([&] { return !worker().busy(); }));
    }

    /// With a selected pixel and both pictures of a comparison: pictures come and go, and each is painted.
    void continuousDrawingKeepsFewPictures()
    {
        QVERIFY(openSmall(QStringLiteral("builtin:tile-square")));
        viewport().selectPixel(QPoint(10, 10));
        m_window->truthMode().comparison().setView(CompareView::Wipe);
        QVERIFY(complete());
        std::vector<std::weak_ptr<const RenderedFrame>> seen;
        std::ptrdiff_t mostAlive = 0;
        EventCounter counter(QEvent::Paint);
        viewport().installEventFilter(&counter);
        connect(&worker(), &RenderWorker::frameReady, &counter, [&](const FramePtr& frame) {
            seen.push_back(frame);
            mostAlive = std::max(mostAlive, std::ranges::count_if(seen, [](const auto& f) { return !f.expired(); }));
        });
        worker().setContinuous(true);
        QVERIFY(waitFor([&] { return seen.size() >= 60; }));
        worker().setContinuous(false);
        QVERIFY2(mostAlive <= 8, qPrintable(QString::number(mostAlive)));
        QVERIFY2(counter.events >= 50, qPrintable(QString::number(counter.events)));
    }

    void aPictureThatMemoryCannotHoldIsNotBegun()
    {
        QVERIFY(openSmall(QStringLiteral("builtin:tile-square")));
        const QImage former = picture();
        const auto before = worker().picturesDrawn();
        worker().setFreeMemory([] { return std::int64_t(2'000'000'000); });
        QVERIFY(change([](Settings& s) { s.size = {16384, 16384}; }));
        QCOMPARE(worker().picturesDrawn(), before);
        QCOMPARE(picture(), former);
        QVERIFY2(m_window->message().contains(QStringLiteral("it takes 3.2 GB, and 2.0 GB are free")),
                 qPrintable(m_window->message()));
        document().undo();
        QVERIFY(complete());
        QCOMPARE(picture(), former);
    }

    void aLargePictureIsAnnounced()
    {
        RenderWorker alone;
        QSignalSpy needed(&alone, &RenderWorker::memoryNeeded);
        const auto scene = std::make_shared<const Scene>();
        Settings settings;
        settings.size = {16384, 8192};
        alone.setFreeMemory([] { return std::int64_t(1) << 40; });
        alone.request(scene, settings);
        settings.size = {64, 64}; // it is not drawn here
        alone.request(scene, settings);
        QCOMPARE(needed.size(), 1);
        QVERIFY2(needed[0][0].toString().contains(QStringLiteral("16,384 x 8,192 take up to 1.6 GB")),
                 qPrintable(needed[0][0].toString()));
        QVERIFY(waitFor([&] { return !alone.busy(); }));
    }

    void emptyDragsDoNothing()
    {
        QVERIFY(open(QStringLiteral("builtin:cube")));
        const auto former = document().scene();
        QMimeData empty;
        empty.setUrls({});
        QVERIFY(!dragIn(empty, Qt::CopyAction));

        // The other program has gone by the time of the drop, and its data with it.
        QMimeData full;
        full.setUrls({droppedCase()});
        QVERIFY(dragIn(full, Qt::CopyAction));
        QDropEvent drop(QPointF(200, 200), Qt::CopyAction, &empty, Qt::LeftButton, Qt::NoModifier);
        drop.ignore();
        QCoreApplication::sendEvent(m_window.get(), &drop);
        QVERIFY(!drop.isAccepted());
        QVERIFY(m_window->message().contains(QStringLiteral("did not arrive")));
        QVERIFY(!document().isLoading());
        QCOMPARE(document().scene(), former);
    }

    /// Who drags to move would delete the file after a drop that was accepted as a move.
    void drops_data()
    {
        QTest::addColumn<int>("offered");
        QTest::addColumn<int>("answer"); ///< 0: refused
        QTest::newRow("copy") << int(Qt::CopyAction) << int(Qt::CopyAction);
        QTest::newRow("move or copy") << int(Qt::MoveAction | Qt::CopyAction) << int(Qt::CopyAction);
        QTest::newRow("link") << int(Qt::LinkAction | Qt::MoveAction) << int(Qt::LinkAction);
        QTest::newRow("move") << int(Qt::MoveAction) << 0;
    }

    void drops()
    {
        QFETCH(int, offered);
        QFETCH(int, answer);
        QVERIFY(open(QStringLiteral("builtin:cube")));
        QMimeData data;
        data.setUrls({droppedCase()});
        QCOMPARE(dragIn(data, Qt::DropActions(offered)), answer != 0);
        QDropEvent drop(QPointF(200, 200), Qt::DropActions(offered), &data, Qt::LeftButton, Qt::NoModifier);
        drop.ignore();
        QCoreApplication::sendEvent(m_window.get(), &drop);
        QCOMPARE(drop.isAccepted(), answer != 0);
        if (answer != 0)
            QCOMPARE(int(drop.dropAction()), answer);
        QVERIFY(complete());
        QCOMPARE(document().scene()->id == data.urls().first().toLocalFile(), answer != 0);
    }
};

QTEST_MAIN(TestFrameFlow)
#include "test_frame_flow.moc"
