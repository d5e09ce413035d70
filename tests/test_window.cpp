#include "core/scenes/builtin_scenes.h"
#include "tests/scene_files.h"
#include "tests/window_fixture.h"
#include "ui/base/applicability.h"
#include "ui/base/dock.h"
#include "ui/pipeline/pipeline_panel.h"
#include "ui/pipeline/stage_strip.h"
#include "ui/pipeline/statistics_panel.h"
#include "ui/window/figure_export.h"
#include "ui/window/help_overlay.h"

#include <QCheckBox>
#include <QClipboard>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QMimeData>
#include <QScrollArea>
#include <QSignalSpy>
#include <QSpinBox>

using namespace rasterlens;
using namespace rasterlens::test;

class TestWindow : public WindowFixture
{
    Q_OBJECT

private:
    void speak(LanguageKind language)
    {
        m_window->setLanguage(language);
        QCoreApplication::processEvents();
    }

    /// Opens a file and waits until all is said about it.
    bool read(const QString& path)
    {
        document().open(path);
        return waitFor([this] { return !document().isLoading(); });
    }

private Q_SLOTS:
    void zoomKeepsThePixelUnderTheCursor()
    {
        QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
        viewport().setZoom(4);
        const QPoint cursor = viewport().transform().toCanvas(QPointF(5.5, 2.5)).toPoint();
        for (const int notches : {1, 1, 1, 1, 1, -1, 1, 1, 1, 1}) {
            const double former = viewport().transform().zoom;
            QWheelEvent wheel(cursor, viewport().mapToGlobal(cursor), {}, {0, 120 * notches}, Qt::NoButton,
                              Qt::NoModifier, Qt::NoScrollPhase, false);
            QCoreApplication::sendEvent(&viewport(), &wheel);
            QCOMPARE(viewport().transform().zoom, nextZoomStep(former, notches));
            QCOMPARE(viewport().transform().pixelAt(cursor), QPoint(5, 2));
        }
        QCOMPARE(viewport().transform().zoom, 64.0);
    }

    void fitAndOneToOne()
    {
        QVERIFY(open(QStringLiteral("builtin:cube")));
        key(Qt::Key_1, Qt::ControlModifier);
        QCOMPARE(viewport().transform().zoom, 1.0);
        key(Qt::Key_F);
        const QRectF shown = viewport().transform().toCanvas(QRectF(QPointF(0, 0), settings().size));
        QVERIFY(QRectF(viewport().rect()).contains(shown));
        QVERIFY(viewport().isFitted());
    }

    void leftDragOrbitsObjectsAndIsOneUndoStep()
    {
        QVERIFY(openSmall(QStringLiteral("builtin:cube")));
        const Settings before = settings();
        const QPoint middle = viewport().rect().center();
        QTest::mousePress(&viewport(), Qt::LeftButton, {}, middle);
        for (int i = 1; i <= 10; ++i)
            QTest::mouseMove(&viewport(), middle + QPoint(8 * i, 3 * i));
        QTest::mouseRelease(&viewport(), Qt::LeftButton, {}, middle + QPoint(80, 30));
        QVERIFY(!(settings().view == before.view));
        document().undo();
        QVERIFY(settings() == before);
        QVERIFY(settle());
    }

    void leftDragPansClipSpaceScenes()
    {
        QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
        const Settings before = settings();
        const QPointF origin = viewport().transform().origin;
        const QPoint middle = viewport().rect().center();
        QTest::mousePress(&viewport(), Qt::LeftButton, {}, middle);
        QTest::mouseMove(&viewport(), middle + QPoint(10, 4));
        QTest::mouseMove(&viewport(), middle + QPoint(31, 17));
        QTest::mouseRelease(&viewport(), Qt::LeftButton, {}, middle + QPoint(31, 17));
        QVERIFY(settings() == before);
        QCOMPARE(viewport().transform().origin, origin + QPointF(31, 17));
    }

    void axisViewsAndHome()
    {
        QVERIFY(openSmall(QStringLiteral("builtin:cube")));
        const View home = settings().view;
        key(Qt::Key_7);
        QCOMPARE(settings().view.pitch, 90.0);
        key(Qt::Key_3);
        QCOMPARE(settings().view.yaw, 90.0);
        QCOMPARE(settings().view.pitch, 0.0);
        key(Qt::Key_1);
        QCOMPARE(settings().view.yaw, 0.0);
        key(Qt::Key_Home);
        QVERIFY(settings().view == home);
        document().undo();
        QCOMPARE(settings().view.yaw, 0.0);
    }

    void clickSelectsAndArrowsNudge()
    {
        QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
        const QPoint at = viewport().transform().toCanvas(QPointF(3.5, 4.5)).toPoint();
        QTest::mouseClick(&viewport(), Qt::LeftButton, {}, at);
        QCOMPARE(viewport().selectedPixel(), std::optional(QPoint(3, 4)));
        key(Qt::Key_Right);
        key(Qt::Key_Down);
        QCOMPARE(viewport().selectedPixel(), std::optional(QPoint(4, 5)));
        for (int i = 0; i < 10; ++i)
            key(Qt::Key_Left);
        QCOMPARE(viewport().selectedPixel(), std::optional(QPoint(0, 5)));
        key(Qt::Key_Escape);
        QVERIFY(!viewport().selectedPixel());
    }

    void readoutNamesColourFaceAndDepth()
    {
        QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
        const auto pixel = viewport().readout({0, 7});
        QVERIFY(pixel);
        QCOMPARE(pixel->color, picture().pixel(0, 7));
        QVERIFY(pixel->face && *pixel->face >= 0);
        QVERIFY(pixel->depth && *pixel->depth < 1);
        QVERIFY(!viewport().readout({8, 0}));
        QVERIFY(!viewport().readout({-1, 0}));
    }

    void goToPixel()
    {
        QVERIFY(open(QStringLiteral("builtin:cube")));
        key(Qt::Key_G, Qt::ControlModifier);
        auto* edit = m_window->findChild<QLineEdit*>(QStringLiteral("goToPixel"));
        QVERIFY(edit->isVisible());
        edit->clear();
        QTest::keyClicks(edit, QStringLiteral("112, 43"));
        QTest::keyClick(edit, Qt::Key_Return);
        QCOMPARE(viewport().selectedPixel(), std::optional(QPoint(112, 43)));
        QVERIFY(!edit->isVisible());
        QCOMPARE(viewport().transform().pixelAt(viewport().rect().center()), QPoint(112, 43));

        key(Qt::Key_G, Qt::ControlModifier);
        edit->setText(QStringLiteral("99999, 0"));
        QTest::keyClick(edit, Qt::Key_Return);
        QVERIFY(m_window->message().contains(QStringLiteral("99999")));
    }

    void sizeIsEdited()
    {
        QVERIFY(open(QStringLiteral("builtin:cube")));
        QComboBox* box = m_window->pipelinePanel().sizeBox();
        box->lineEdit()->setText(QStringLiteral("123x45"));
        QTest::keyClick(box->lineEdit(), Qt::Key_Return);
        QCOMPARE(settings().size, QSize(123, 45));
        QVERIFY(settle());
        QCOMPARE(picture().size(), QSize(123, 45));
        box->lineEdit()->setText(QStringLiteral("0 x 5"));
        QTest::keyClick(box->lineEdit(), Qt::Key_Return);
        QCOMPARE(settings().size, QSize(123, 45));
        QVERIFY(!m_window->message().isEmpty());
    }

    void refusedSettingsKeepThePicture()
    {
        QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
        const FramePtr before = viewport().frame();
        Settings refused = settings();
        refused.cullSpace = CullSpace::View;
        document().setSettings(refused);
        QVERIFY(m_window->isSettled());
        QVERIFY(!m_window->message().isEmpty());
        QCOMPARE(viewport().frame(), before);
        QVERIFY2(m_window->pipelinePanel().editor(QStringLiteral("cull-space"))->isEnabled(), "the way back is open");
        const auto reason = unsupported(*document().scene(), refused);
        QVERIFY(m_window->message().endsWith(textOf(*reason)));
        speak(LanguageKind::Chinese);
        QVERIFY(m_window->message().endsWith(whyUnsupported(*reason)));
        QVERIFY(!m_window->message().contains(textOf(*reason)));
        document().undo();
        QVERIFY(settle());
        QVERIFY(m_window->message().isEmpty());
    }

    void badFileLeavesAMessage()
    {
        QVERIFY(open(QStringLiteral("builtin:cube")));
        document().open(QStringLiteral("/nowhere/none.obj"));
        QTRY_VERIFY_WITH_TIMEOUT(m_window->message().contains(QStringLiteral("/nowhere/none.obj")), kPatienceMs);
        QCOMPARE(document().scene()->id, QStringLiteral("builtin:cube"));
        QVERIFY(settle());
    }

    void remarksAreInTheLanguageOfTheWindow_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("english");
        QTest::addColumn<QString>("chinese");
        const auto row = [](const char* name, const QByteArray& text, const char* english, const char* chinese) {
            QTest::newRow(name) << QString::fromLatin1(name) << text << QString::fromUtf8(english)
                                << QString::fromUtf8(chinese);
        };
        row("corners.obj", "v 0 0 0\nf 1 1\n",
            "%1:2: f: 2 corners; at least 3 expected\n%1: none of the 1 \"f\" statements can be drawn",
            "%1:2：f：2 个顶点；至少 3 个\n%1：1 条“f”语句都无法绘制");
        row("100%2.obj", "v 0 %2\nf 1 1 1\n",
            "%1:1: v: \"%2\" is not a number; a finite number is expected\n%1:1: v: 2 numbers; 3 to 7 expected\n"
            "%1:2: f: only 1 of 3 corners are different; at least 3 expected\n"
            "%1: none of the 1 \"f\" statements can be drawn",
            "%1:1：v：\"%2\" 不是数；应为有限数\n%1:1：v：2 个数；要求 3 到 7 个\n"
            "%1:2：f：3 个角中只有 1 个不同；至少应有 3 个\n"
            "%1：1 条“f”语句都无法绘制");
        row("remarks.obj", "foo\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
            "%1:1: warning: \"foo\" is not a statement of the OBJ format; ignored",
            "%1:1：警告：\"foo\" 不是 OBJ 格式的语句；已忽略");
        row("session.json", "[1]",
            R"(%1:1: a JSON object is expected: {"rasterlens": 1, "scene": NAME, "settings": {..}})",
            R"(%1:1：应为 JSON 对象：{"rasterlens": 1, "scene": 名称, "settings": {..}})");
        row("value.json", R"({"rasterlens": 1, "scene": "builtin:cube", "settings": {"subpixel-bits": 9}})",
            "%1: \"9\" is not a value of subpixel-bits, which takes: 0 to 8",
            "%1：\"9\" 不是 subpixel-bits 的值；可用的值：0 到 8");
        row("hard.case", "size 8 8\ncull\n", "%1:2: cull: 0 values; one expected",
            "%1:2：cull：给了 0 个值；要求：一个");
        row("scene.txt", "", "%1: this is not a scene; an .obj or .case file, builtin:NAME or stress:NAME is expected",
            "%1：这不是场景；应为 .obj 或 .case 文件、builtin:名称 或 stress:名称");
    }

    void remarksAreInTheLanguageOfTheWindow()
    {
        QFETCH(QString, name);
        QFETCH(QByteArray, text);
        QFETCH(QString, english);
        QFETCH(QString, chinese);
        const Folder folder;
        const QString path = folder.write(name, text);
        speak(LanguageKind::Chinese);
        QVERIFY(read(path));
        QCOMPARE(m_window->message(), chinese.replace(QLatin1String("%1"), path));
        speak(LanguageKind::English);
        QCOMPARE(m_window->message(), english.replace(QLatin1String("%1"), path));
    }

    void missingTextureIsToldInTheLanguageOfTheWindow()
    {
        const Folder folder;
        const QString mtl = folder.write(QStringLiteral("a.mtl"), "newmtl a\nmap_Kd none.png\n");
        const QString obj =
            folder.write(QStringLiteral("a.obj"), "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n");
        const QString texture = folder.path(QStringLiteral("none.png"));
        speak(LanguageKind::Chinese);
        QVERIFY(read(obj));
        QCOMPARE(m_window->message(),
                 QStringLiteral("%1:2：警告：map_Kd %2：没有这个文件；绘制时不用纹理").arg(mtl, texture));
        speak(LanguageKind::English);
        QCOMPARE(
            m_window->message(),
            QStringLiteral("%1:2: warning: map_Kd %2: there is no such file; drawn without texture").arg(mtl, texture));
    }

    void unwritableSessionIsToldInTheLanguageOfTheWindow()
    {
        const Folder folder;
        const QString path = folder.path(QStringLiteral("none/s.json"));
        speak(LanguageKind::Chinese);
        QVERIFY(!document().saveSession(path));
        QVERIFY(m_window->message().startsWith(path + QStringLiteral("：无法写入文件：")));
    }

    void droppedFileOpens()
    {
        QFile file(m_folder.filePath(QStringLiteral("dropped.case")));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("size 8 8\ntri 0 0 0 1 1 0 0   1 0 0 1 0 1 0   0 1 0 1 0 0 1\n");
        file.close();
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(file.fileName())});
        QDragEnterEvent enter(QPoint(300, 300), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(m_window.get(), &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent drop(QPointF(300, 300), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(m_window.get(), &drop);
        QTRY_COMPARE_WITH_TIMEOUT(document().scene()->id, file.fileName(), kPatienceMs);
        QVERIFY(settle());
    }

    void statisticsAreShownWholeAndCopied()
    {
        QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
        StatisticsPanel& panel = m_window->statisticsPanel();
        QCOMPARE(panel.shown(QStringLiteral("covered")), QStringLiteral("64"));
        QCOMPARE(panel.shown(QStringLiteral("submitted")), QStringLiteral("2"));
        const QJsonObject json = QJsonDocument::fromJson(panel.asJson().toUtf8()).object();
        QCOMPARE(json[QStringLiteral("pixels")][QStringLiteral("covered")].toInt(), 64);
        const QStringList lines = panel.asCsv().split(QLatin1Char('\n'), Qt::SkipEmptyParts);
        QCOMPARE(lines.size(), 2);
        const auto column = lines[0].split(QLatin1Char(',')).indexOf(QStringLiteral("pixels_covered"));
        QCOMPARE(lines[1].split(QLatin1Char(',')).value(column), QStringLiteral("64"));
        for (const QSize& size : {QSize(1280, 800), QSize(1024, 768)}) {
            m_window->resize(size);
            QCoreApplication::processEvents();
            for (const QLabel* label : panel.findChildren<QLabel*>())
                QVERIFY2(label->width() >= label->sizeHint().width(), qPrintable(label->text()));
        }
    }

    /// Also beside a scroll bar, and with the longest numbers.
    void countersAreNotCutOffByTheScrollBar()
    {
        QVERIFY(open(QStringLiteral("stress:tiny")));
        StatisticsPanel& panel = m_window->statisticsPanel();
        const auto* scroll = panel.findChild<QScrollArea*>();
        for (const QSize& size : {QSize(1280, 800), QSize(1024, 768), QSize(1280, 560)}) {
            m_window->resize(size);
            QCoreApplication::processEvents();
            QVERIFY2(scroll->viewport()->width() >= scroll->widget()->width(),
                     qPrintable(QString::number(scroll->viewport()->width())));
        }
    }

    /// Cold pictures tell no time; counters of another picture are dimmed; before anything is known there are dashes.
    void statisticsTellOnlyWhatIsKnown()
    {
        StatisticsPanel panel;
        const auto show = [&panel](double yaw, bool counted, bool timed, double ms) {
            auto frame = std::make_shared<RenderedFrame>();
            frame->settings.view.yaw = yaw;
            frame->counted = counted;
            frame->timed = timed;
            frame->frame.times.total = ms;
            panel.setFrame(frame);
        };
        const auto rate = [&panel] { return panel.findChild<QLabel*>(QStringLiteral("fps"))->text(); };
        show(0, false, false, 50);
        QCOMPARE(rate(), QStringLiteral("\u2013"));
        for (const QLabel* label : panel.findChildren<QLabel*>())
            QVERIFY2(!label->text().contains(QStringLiteral("0.00")), qPrintable(label->text()));
        show(0, true, true, 2);
        QCOMPARE(rate(), QStringLiteral("500"));
        QVERIFY(!panel.isStale());
        show(10, false, false, 50);
        QCOMPARE(rate(), QStringLiteral("500"));
        QTRY_VERIFY_WITH_TIMEOUT(panel.isStale(), kPatienceMs);
        show(10, true, true, 4);
        QCOMPARE(rate(), QStringLiteral("250"));
        QVERIFY(!panel.isStale());
    }

    void stageStripTellsAndScrolls()
    {
        QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
        QCOMPARE(StageStrip().figure(Stage::Cover), QStringLiteral("\u2013"));
        StageStrip& strip = m_window->stageStrip();
        QCOMPARE(strip.figure(Stage::Scene), QStringLiteral("2 faces"));
        QCOMPARE(strip.figure(Stage::Cover), QStringLiteral("64 px"));
        QCOMPARE(strip.figure(Stage::Screen), QStringLiteral("snapped 1/256"));
        QSignalSpy clicked(&strip, &StageStrip::stageClicked);
        auto* shade = strip.findChild<QAbstractButton*>(QStringLiteral("stage%1").arg(static_cast<int>(Stage::Shade)));
        QTest::mouseClick(shade, Qt::LeftButton);
        QCOMPARE(clicked.size(), 1);
        QWidget* shading = m_window->pipelinePanel().editor(QStringLiteral("shading"));
        QVERIFY(!shading->visibleRegion().isEmpty());
    }

    void languageSwitchesWhileRunning()
    {
        QVERIFY(open(QStringLiteral("builtin:cube")));
        const auto fileMenu = [this] { return m_window->menuBar()->actions().first()->text(); };
        const auto culling = [this] {
            return qobject_cast<QComboBox*>(m_window->pipelinePanel().editor(QStringLiteral("culling")))->itemText(0);
        };
        QCOMPARE(fileMenu(), QStringLiteral("&File"));
        speak(LanguageKind::Chinese);
        QVERIFY(fileMenu() != QStringLiteral("&File"));
        QVERIFY(culling() != QStringLiteral("Back faces"));
        QVERIFY(m_window->stageStrip().figure(Stage::Scene).startsWith(QStringLiteral("12")));
        QVERIFY(m_window->stageStrip().figure(Stage::Scene) != QStringLiteral("12 faces"));
        speak(LanguageKind::English);
        QCOMPARE(fileMenu(), QStringLiteral("&File"));
        QCOMPARE(culling(), QStringLiteral("Back faces"));
    }

    /// No text is left in English.
    void everyTextIsTranslated()
    {
        speak(LanguageKind::Chinese);
        const auto isChinese = [](const QString& text) {
            return std::any_of(text.begin(), text.end(), [](QChar c) { return c.script() == QChar::Script_Han; });
        };
        for (const SettingsField& field : settingsFields()) {
            QVERIFY2(isChinese(QCoreApplication::translate("Settings", field.title)), field.title);
            QVERIFY2(isChinese(QCoreApplication::translate("Settings", field.help)), field.help);
        }
        for (const StressScene& scene : stressScenes())
            QVERIFY2(isChinese(QCoreApplication::translate("StressScene", scene.title)), scene.title);
        for (const BuiltinScene& scene : builtinScenes()) {
            QVERIFY2(isChinese(QCoreApplication::translate("BuiltinScene", scene.title)), scene.title);
            QVERIFY2(isChinese(QCoreApplication::translate("BuiltinScene", scene.note)), scene.note);
        }
        QVERIFY2(isChinese(QCoreApplication::translate("QFileDialog", "Look in:")), "texts of Qt's dialogs");
        Scene inClipSpace;
        inClipSpace.space = SceneSpace::Clip;
        int refusals = 0;
        for (const SettingsField& field : settingsFields())
            for (int value = field.minimum; value <= field.maximum; ++value) {
                Settings tiled;
                tiled.algorithm = Algorithm::Tiled;
                field.set(tiled, value);
                const auto reason = unsupported(inClipSpace, tiled);
                refusals += reason.has_value();
                QVERIFY2(!reason || isChinese(whyUnsupported(*reason)), reason ? reason->text : "");
            }
        QVERIFY(refusals > 0);
        document().clearRecentFiles();
        for (const QAction* action : m_window->findChildren<QAction*>())
            if (action->text().contains(QRegularExpression(QStringLiteral("[a-z]{4}"))))
                QVERIFY2(isChinese(action->text()) || action->text() == QLatin1String("English"),
                         qPrintable(action->text()));
    }

    /// The scene box holds them, translated, and finds the present one.
    void stressScenesAreInTheBox()
    {
        QVERIFY(open(QStringLiteral("stress:large")));
        speak(LanguageKind::Chinese);
        const QComboBox* box = m_window->pipelinePanel().sceneBox();
        QCOMPARE(box->currentData().toString(), document().scene()->id);
        for (const StressScene& scene : stressScenes()) {
            const int index = box->findData(QStringLiteral("stress:") + QLatin1String(scene.name));
            QVERIFY2(index >= 0, scene.name);
            QCOMPARE(box->itemText(index), QCoreApplication::translate("StressScene", scene.title));
        }
    }

    void toolTipsHaveBothLanguages()
    {
        const QString tip = m_window->pipelinePanel().editor(QStringLiteral("clipping"))->toolTip();
        QVERIFY(tip.contains(QStringLiteral("Clipping")));
        QVERIFY(tip.contains(QStringLiteral("\u88c1\u526a")));
    }

    void layoutIsReset()
    {
        QVERIFY(open(QStringLiteral("builtin:cube")));
        auto* dock = m_window->findChild<Dock*>(QStringLiteral("statisticsDock"));
        dock->hide();
        m_window->addDockWidget(Qt::LeftDockWidgetArea, dock);
        key(Qt::Key_0, Qt::ControlModifier);
        QVERIFY(dock->isVisible());
        QCOMPARE(m_window->dockWidgetArea(dock), Qt::RightDockWidgetArea);
    }

    void layoutIsRemembered()
    {
        m_window.reset();
        {
            MainWindow first(MainWindow::Memory::Remember);
            first.show();
            first.findChild<Dock*>(QStringLiteral("statisticsDock"))->hide();
            first.setLanguage(LanguageKind::Chinese);
            first.worker().setFastMotion(false);
            first.close();
        }
        MainWindow second(MainWindow::Memory::Remember);
        second.show();
        QVERIFY(second.findChild<Dock*>(QStringLiteral("statisticsDock"))->isHidden());
        QCOMPARE(second.language(), LanguageKind::Chinese);
        QVERIFY(!second.worker().hasFastMotion());
        second.setLanguage(LanguageKind::English);
    }

    void helpListsLiveStates()
    {
        QVERIFY(openSmall(QStringLiteral("builtin:cube")));
        const auto text = [this] {
            QString all;
            for (const QLabel* label : m_window->helpOverlay().findChildren<QLabel*>())
                all += label->text();
            return all;
        };
        key(Qt::Key_H);
        QVERIFY(m_window->helpOverlay().isVisible());
        QVERIFY(text().contains(QStringLiteral("Solid")));
        key(Qt::Key_W);
        QVERIFY(text().contains(QStringLiteral("Wireframe")));
        key(Qt::Key_H);
        QVERIFY(!m_window->helpOverlay().isVisible());
    }

    void presentationPutsDocksAway()
    {
        QVERIFY(open(QStringLiteral("builtin:cube")));
        std::vector<const Dock*> docks;
        for (const Dock* dock : m_window->findChildren<Dock*>())
            if (dock->isVisible())
                docks.push_back(dock);
        QVERIFY(!docks.empty());
        key(Qt::Key_F11);
        for (const Dock* dock : docks)
            QVERIFY(!dock->isVisible());
        QVERIFY(QApplication::font().pointSizeF() >= 18);
        key(Qt::Key_F11);
        for (const Dock* dock : docks)
            QVERIFY(dock->isVisible());
        QVERIFY(QApplication::font().pointSizeF() < 12);
    }

    void exportsWriteWholePictures()
    {
        QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
        const QString framebuffer = m_folder.filePath(QStringLiteral("framebuffer.png"));
        QVERIFY(m_window->exportFramebuffer(framebuffer));
        QCOMPARE(QImage(framebuffer).convertToFormat(QImage::Format_RGB32), picture());
        const QString window = m_folder.filePath(QStringLiteral("window.png"));
        QVERIFY(m_window->exportWindow(window));
        QCOMPARE(QImage(window).size(), m_window->size());
        const QString figure = m_folder.filePath(QStringLiteral("figure.png"));
        m_window->figures().setTexts(false);
        QVERIFY(m_window->exportFigure(figure));
        const int zoom = static_cast<int>(viewport().transform().zoom);
        QCOMPARE(QImage(figure).size(), QSize(8 * zoom + 1, 8 * zoom + 1));
        const QImage scaled = viewport().figure(4);
        QCOMPARE(scaled.size(), QSize(32, 32));
        QCOMPARE(scaled.pixel(4 * 3 + 1, 4 * 5 + 2), picture().pixel(3, 5));
        QVERIFY(viewport().figure(32).size() == QSize(257, 257));
    }

    void unwritableExportIsSaidInTheWindow()
    {
        QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
        QVERIFY(!m_window->exportFramebuffer(QStringLiteral("/nowhere/none.png")));
        QVERIFY(m_window->message().contains(QStringLiteral("/nowhere/none.png")));
        QVERIFY(!QFile::exists(QStringLiteral("/nowhere/none.png")));
    }

    void copyPutsThePictureOnTheClipboard()
    {
        QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
        key(Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(QGuiApplication::clipboard()->image().convertToFormat(QImage::Format_RGB32), picture());
    }

    void closingWhileRendering()
    {
        QVERIFY(open(QStringLiteral("builtin:head")));
        Settings large = settings();
        large.size = {3000, 3000};
        large.samples = Samples::Grid4;
        document().setSettings(large);
        QCoreApplication::processEvents();
        m_window->close();
        m_window.reset();
    }

    void theLatestSettingsAreShown()
    {
        QVERIFY(open(QStringLiteral("builtin:head")));
        for (int degrees = 0; degrees < 40; ++degrees) {
            Settings next = settings();
            next.view.yaw = degrees;
            document().setSettings(next, Document::Edit::Camera);
            QCoreApplication::processEvents();
        }
        QVERIFY(settle());
        QCOMPARE(viewport().frame()->settings.view.yaw, 39.0);
    }
};

QTEST_MAIN(TestWindow)
#include "test_window.moc"
