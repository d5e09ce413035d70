// The render worker: who draws the first picture, and what follows once nothing moves.
#include "core/scene/camera.h"
#include "core/scenes/builtin_scenes.h"
#include "ui/document/render_worker.h"

#include <QSignalSpy>
#include <QTest>

using namespace rasterlens;

class TestMotion : public QObject
{
    Q_OBJECT

private:
    std::shared_ptr<const Scene> m_scene;
    std::vector<FramePtr> m_frames;

    /// The frames a request brings until it is settled.
    void draw(RenderWorker& worker, const Settings& settings)
    {
        m_frames.clear();
        const auto connection = connect(&worker, &RenderWorker::frameReady, this,
                                        [this](const FramePtr& frame) { m_frames.push_back(frame); });
        worker.request(m_scene, settings);
        QVERIFY(QTest::qWaitFor([&] { return !worker.busy(); }, 60000));
        disconnect(connection);
    }
    [[nodiscard]] Settings orbited(Settings settings) const
    {
        settings.view.yaw += 10;
        return settings;
    }

private Q_SLOTS:
    void init() { m_scene = std::make_shared<const Scene>(*makeBuiltinScene(QStringLiteral("cube")).scene); }
    void cameraMovesAreDrawnFastFirst();
    void theChosenAlgorithmIsNotReplacedWhereItMatters_data();
    void theChosenAlgorithmIsNotReplacedWhereItMatters();
    void canBeSwitchedOff();
    void onlyColdTiledPicturesAreNotTimed();
    void memoryIsWrittenBefore();
    void framesKeepNoThreads();
    void slowPicturesAreDrawnFastFirst();
};

void TestMotion::cameraMovesAreDrawnFastFirst()
{
    RenderWorker worker;
    Settings settings = m_scene->defaults;
    settings.algorithm = Algorithm::EdgeWalking;
    draw(worker, settings);
    QCOMPARE(m_frames.size(), 2U); // no move yet
    QVERIFY(!m_frames[0]->fast && !m_frames[1]->fast);

    draw(worker, orbited(settings));
    QCOMPARE(m_frames.size(), 3U);
    QVERIFY(m_frames[0]->fast && !m_frames[0]->counted);
    QVERIFY(!m_frames[1]->fast && !m_frames[1]->counted);
    QVERIFY(!m_frames[2]->fast && m_frames[2]->counted);
    QCOMPARE(m_frames[0]->settings.algorithm, Algorithm::EdgeWalking);
    QCOMPARE(m_frames[1]->frame.image, m_frames[2]->frame.image);
    for (int y = 0; y < settings.size.height(); ++y)
        for (int x = 0; x < settings.size.width(); ++x) {
            const QRgb fast = m_frames[0]->frame.image.pixel(x, y);
            const QRgb chosen = m_frames[1]->frame.image.pixel(x, y);
            QVERIFY(std::abs(qRed(fast) - qRed(chosen)) <= 1 && std::abs(qGreen(fast) - qGreen(chosen)) <= 1 &&
                    std::abs(qBlue(fast) - qBlue(chosen)) <= 1);
        }
}

void TestMotion::theChosenAlgorithmIsNotReplacedWhereItMatters_data()
{
    QTest::addColumn<Settings>("settings");
    const Settings defaults = makeBuiltinScene(QStringLiteral("cube")).scene->defaults;
    const auto row = [&defaults](const char* name, void (*change)(Settings&)) {
        Settings settings = defaults;
        change(settings);
        QTest::newRow(name) << settings;
    };
    row("mistake", [](Settings& s) { s.mistakes = {QStringLiteral("all-inclusive")}; });
    row("wireframe", [](Settings& s) { s.fill = Fill::Wireframe; });
    row("float32", [](Settings& s) { s.numberType = NumberType::Float32; });
    row("painter", [](Settings& s) { s.visibility = Visibility::Painter; });
    row("tiled already", [](Settings& s) { s.algorithm = Algorithm::Tiled; });
}

void TestMotion::theChosenAlgorithmIsNotReplacedWhereItMatters()
{
    QFETCH(Settings, settings);
    RenderWorker worker;
    draw(worker, settings);
    draw(worker, orbited(settings));
    QCOMPARE(m_frames.size(), 2U);
    QVERIFY(!m_frames[0]->fast && !m_frames[1]->fast);
}

/// A scene of 20 faces that cover the picture ten times is drawn fast first, whatever changes: half a second on two
/// cores is so far above what counts as slow that no machine is too fast for this test.
void TestMotion::slowPicturesAreDrawnFastFirst()
{
    m_scene = std::make_shared<const Scene>(*makeStressScene(QStringLiteral("fill-back-to-front"), {1920, 1080}).scene);
    RenderWorker worker;
    Settings settings = m_scene->defaults;
    settings.size = {1920, 1080};
    draw(worker, settings);
    QVERIFY(!m_frames[0]->fast);
    settings.shading = Shading::Depth;
    draw(worker, settings);
    QVERIFY(m_frames[0]->fast && !m_frames[1]->fast);
}

void TestMotion::canBeSwitchedOff()
{
    RenderWorker worker;
    worker.setFastMotion(false);
    draw(worker, m_scene->defaults);
    draw(worker, orbited(m_scene->defaults));
    QCOMPARE(m_frames.size(), 2U);
}

/// The counted picture tells the time of the one before it, unless that had to start the tiled algorithm's threads.
void TestMotion::onlyColdTiledPicturesAreNotTimed()
{
    RenderWorker worker;
    Settings settings = m_scene->defaults;
    settings.algorithm = Algorithm::Tiled;
    draw(worker, settings);
    QCOMPARE(m_frames.size(), 2U);
    QVERIFY(!m_frames[0]->timed && !m_frames[1]->timed);
    QVERIFY(m_frames[1]->frame.times.total > 0);

    draw(worker, orbited(settings));
    QVERIFY(m_frames[0]->timed && m_frames[1]->timed);
    QCOMPARE(m_frames[1]->frame.times.total, m_frames[0]->frame.times.total);
    settings.algorithm = Algorithm::EdgeEquation;
    draw(worker, settings);
    QVERIFY(m_frames[0]->timed && m_frames[1]->timed);
}

/// The picture that tells the time draws into memory that was written before, also the first one of a size.
void TestMotion::memoryIsWrittenBefore()
{
    RenderWorker worker;
    Settings settings = m_scene->defaults;
    for (const QSize size : {QSize(64, 48), QSize(80, 60)}) {
        settings.size = size;
        draw(worker, settings);
        for (const FramePtr& frame : m_frames)
            QCOMPARE(frame->warmSamples, std::int64_t(size.width()) * size.height());
    }
}

/// Threads and memory of the tiled algorithm stay with the worker, however many pictures are about.
void TestMotion::framesKeepNoThreads()
{
    RenderWorker worker;
    Settings settings = m_scene->defaults;
    settings.algorithm = Algorithm::Tiled;
    draw(worker, settings);
    for (const FramePtr& frame : m_frames)
        QVERIFY(!frame->frame.tiled);
    draw(worker, orbited(settings));
    for (const FramePtr& frame : m_frames)
        QVERIFY(!frame->frame.tiled);
}

QTEST_MAIN(TestMotion)
#include "test_motion.moc"
