#include "core/io/case_file.h"
#include "core/io/session.h"
#include "core/scenes/builtin_scenes.h"
#include "ui/document/document.h"
#include "ui/face/vertex_panel.h"

#include <QFile>
#include <QSettings>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest>

using namespace rasterlens;

namespace
{

constexpr auto kOneTriangle = "size 8 8\ntri 0 0 0 1 1 0 0  1 0 0 1 0 1 0  0 1 0 1 0 0 1\n";

std::shared_ptr<const Scene> oneTriangle()
{
    return std::make_shared<const Scene>(*parseCase(kOneTriangle, QStringLiteral("one.case")).scene);
}

Settings withCulling(const Settings& settings, Culling culling)
{
    Settings next = settings;
    next.culling = culling;
    return next;
}

Settings withYaw(const Settings& settings, double yaw)
{
    Settings next = settings;
    next.view.yaw = yaw;
    return next;
}

} // namespace

class TestDocument : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;

    QString write(const QString& name, const QByteArray& text)
    {
        QFile file(m_folder.filePath(name));
        const bool good = file.open(QIODevice::WriteOnly) && file.write(text) == text.size();
        return good ? file.fileName() : QString();
    }

private Q_SLOTS:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        QCoreApplication::setOrganizationName(QStringLiteral("RasterLensTest"));
        QSettings::setDefaultFormat(QSettings::IniFormat);
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, m_folder.filePath(QStringLiteral("config")));
    }

    void equalSettingsEmitNothing()
    {
        Document document;
        QSignalSpy changed(&document, &Document::settingsChanged);
        document.setSettings(document.settings());
        QCOMPARE(changed.size(), 0);
        QVERIFY(!document.canUndo());
        document.setSettings(withCulling(document.settings(), Culling::None));
        QCOMPARE(changed.size(), 1);
    }

    void undoAndRedoWalkTheValues()
    {
        Document document;
        const Settings a = document.settings();
        const Settings b = withCulling(a, Culling::Front);
        const Settings c = withCulling(a, Culling::None);
        document.setSettings(b);
        document.setSettings(c);
        document.undo();
        QVERIFY(document.settings() == b);
        document.undo();
        QVERIFY(document.settings() == a);
        QVERIFY(!document.canUndo());
        document.redo();
        document.redo();
        QVERIFY(document.settings() == c);
        QVERIFY(!document.canRedo());
        document.undo();
        document.setSettings(a);
        QVERIFY2(!document.canRedo(), "a new edit forgets what was undone");
    }

    void cameraMovesMergeUntilTheGestureEnds()
    {
        Document document;
        const Settings before = document.settings();
        for (int degrees = 1; degrees <= 20; ++degrees)
            document.setSettings(withYaw(before, degrees), Document::Edit::Camera);
        document.endGesture();
        document.setSettings(withYaw(before, 30), Document::Edit::Camera);
        document.undo();
        QCOMPARE(document.settings().view.yaw, 20.0);
        document.undo();
        QVERIFY(document.settings() == before);
        QVERIFY(!document.canUndo());
    }

    void aStepBetweenCameraMovesSeparatesThem()
    {
        Document document;
        document.setSettings(withYaw(document.settings(), 10), Document::Edit::Camera);
        document.setSettings(withCulling(document.settings(), Culling::None));
        document.setSettings(withYaw(document.settings(), 20), Document::Edit::Camera);
        document.undo();
        QCOMPARE(document.settings().view.yaw, 10.0);
        QCOMPARE(document.settings().culling, Culling::None);
        document.undo();
        QCOMPARE(document.settings().culling, Culling::Back);
        QCOMPARE(document.settings().view.yaw, 10.0);
    }

    void aSceneBringsItsSettings()
    {
        Document document;
        document.setSettings(withCulling(document.settings(), Culling::Front));
        QSignalSpy sceneChanged(&document, &Document::sceneChanged);
        QSignalSpy settingsChanged(&document, &Document::settingsChanged);
        document.setScene(oneTriangle());
        QCOMPARE(sceneChanged.size(), 1);
        QCOMPARE(settingsChanged.size(), 1);
        QCOMPARE(document.settings().size, QSize(8, 8));
        QCOMPARE(document.settings().culling, Culling::None);
        QVERIFY(!document.canUndo());
        QVERIFY(!document.isDirty());
    }

    void resetIsOneUndoStep()
    {
        Document document;
        document.setScene(oneTriangle());
        Settings changed = document.settings();
        changed.size = {100, 50};
        changed.fill = Fill::Wireframe;
        document.setSettings(changed);
        QVERIFY(document.isDirty());
        document.resetSettings();
        QVERIFY(document.settings() == document.defaults());
        QVERIFY(!document.isDirty());
        document.undo();
        QVERIFY(document.settings() == changed);
    }

    void everyBuiltinSceneOpens()
    {
        Document document;
        QSignalSpy opened(&document, &Document::opened);
        for (const BuiltinScene& scene : builtinScenes()) {
            const QString name = QStringLiteral("builtin:") + QLatin1String(scene.name);
            document.open(name);
            QVERIFY2(opened.wait(20000), qPrintable(name));
            QCOMPARE(document.scene()->id, name);
            QVERIFY(document.settings() == document.scene()->defaults);
        }
        QVERIFY2(document.recentFiles().isEmpty(), "built-in scenes are no files");
    }

    void badFileKeepsTheScene_data()
    {
        QTest::addColumn<QString>("name");
        QTest::newRow("missing") << QStringLiteral("/nowhere/none.obj");
        QTest::newRow("folder") << m_folder.path();
        QTest::newRow("no such built-in") << QStringLiteral("builtin:none");
        QTest::newRow("empty obj") << write(QStringLiteral("empty.obj"), "");
        QTest::newRow("index out of range") << write(QStringLiteral("range.obj"), "v 0 0 0\nf 1 2 3\n");
        QTest::newRow("broken case") << write(QStringLiteral("broken.case"), "size 8 8\ntri 0 0\n");
        QTest::newRow("broken json") << write(QStringLiteral("broken.json"), "{\"rasterlens\": 1,");
        QTest::newRow("session with an unknown value")
            << write(QStringLiteral("unknown.json"),
                     R"({"rasterlens": 1, "scene": "builtin:cube", "settings": {"culling": "sideways"}})");
        QTest::newRow("session of a missing scene")
            << write(QStringLiteral("lost.json"), R"({"rasterlens": 1, "scene": "lost.obj", "settings": {}})");
    }

    void badFileKeepsTheScene()
    {
        QFETCH(QString, name);
        QVERIFY(!name.isEmpty());
        Document document;
        const auto scene = oneTriangle();
        document.setScene(scene);
        document.setSettings(withCulling(document.settings(), Culling::Front));
        const Settings settings = document.settings();
        QSignalSpy changed(&document, &Document::settingsChanged);
        QSignalSpy reported(&document, &Document::diagnosticsReported);
        document.open(name);
        QVERIFY(reported.wait(20000));
        QVERIFY(hasErrors(reported.first().first().value<Diagnostics>()));
        QCOMPARE(document.scene(), scene);
        QVERIFY(document.settings() == settings);
        QCOMPARE(changed.size(), 0);
        QVERIFY(!document.isLoading());
    }

    void theLatestOpenWins()
    {
        Document document;
        QSignalSpy sceneChanged(&document, &Document::sceneChanged);
        document.open(QStringLiteral("builtin:cube"));
        document.open(QStringLiteral("builtin:sphere"));
        document.open(QStringLiteral("builtin:letter-f"));
        QTRY_VERIFY_WITH_TIMEOUT(!document.isLoading(), 20000);
        QCOMPARE(document.scene()->id, QStringLiteral("builtin:letter-f"));
        QCOMPARE(sceneChanged.size(), 1);
    }

    void sessionComesBack()
    {
        const QString scenePath = write(QStringLiteral("triangle.case"), kOneTriangle);
        const QString sessionPath = m_folder.filePath(QStringLiteral("lesson.json"));
        Document document;
        document.open(scenePath);
        QTRY_COMPARE_WITH_TIMEOUT(document.scene()->id, scenePath, 20000);
        document.setSettings(withCulling(document.settings(), Culling::Front));
        QVERIFY(document.isDirty());
        QVERIFY(document.saveSession(sessionPath));
        QVERIFY(!document.isDirty());
        const Settings saved = document.settings();

        QFile file(sessionPath);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY2(!file.readAll().contains(m_folder.path().toUtf8()), "the folder can be moved");

        Document second;
        QSignalSpy opened(&second, &Document::opened);
        second.open(sessionPath);
        QVERIFY(opened.wait(20000));
        QVERIFY(second.settings() == saved);
        QCOMPARE(second.sessionPath(), sessionPath);
        QCOMPARE(second.scene()->mesh.faceCount(), std::size_t(1));
        QVERIFY(!second.isDirty());
        QCOMPARE(second.recentFiles().value(0), sessionPath);
    }

    void movedVerticesComeBackWithTheSession()
    {
        const QString scenePath = write(QStringLiteral("triangle.case"), kOneTriangle);
        const QString sessionPath = m_folder.filePath(QStringLiteral("moved.json"));
        Document document;
        document.open(scenePath);
        QTRY_COMPARE_WITH_TIMEOUT(document.scene()->id, scenePath, 20000);
        document.editScene(withVertex(*document.scene(), 1, {0.25F, -0.5F, 0, 1}));
        QVERIFY(document.isDirty());
        QVERIFY(document.saveSession(sessionPath));
        QVERIFY(!document.isDirty());

        Document second;
        QSignalSpy opened(&second, &Document::opened);
        second.open(sessionPath);
        QVERIFY(opened.wait(20000));
        QVERIFY(second.scene()->mesh.vertices[1].position == glm::vec4(0.25F, -0.5F, 0, 1));
        QVERIFY(!second.isDirty());
        QVERIFY(second.saveSession(sessionPath)); // the move is still known as one
        QCOMPARE(loadSession(sessionPath).session->vertices.size(), 1U);

        document.undo();
        QVERIFY(document.saveSession(sessionPath));
        QVERIFY(loadSession(sessionPath).session->vertices.empty());
    }

    void unwritableSessionIsReported()
    {
        Document document;
        document.setScene(oneTriangle());
        QSignalSpy reported(&document, &Document::diagnosticsReported);
        QVERIFY(!document.saveSession(QStringLiteral("/nowhere/none.json")));
        QCOMPARE(reported.size(), 1);
        QVERIFY(document.sessionPath().isEmpty());
    }

    void recentFilesAreNewestFirstAndOnce()
    {
        Document document;
        document.clearRecentFiles();
        const QString a = write(QStringLiteral("a.case"), kOneTriangle);
        const QString b = write(QStringLiteral("b.case"), kOneTriangle);
        QSignalSpy opened(&document, &Document::opened);
        for (const QString& path : {a, b, a}) {
            document.open(path);
            QVERIFY(opened.wait(20000));
        }
        QCOMPARE(document.recentFiles(), (QStringList{a, b}));
    }

    void destroyedWhileLoading()
    {
        Document document;
        document.open(QStringLiteral("builtin:head"));
    }
};

QTEST_GUILESS_MAIN(TestDocument)
#include "test_document.moc"
