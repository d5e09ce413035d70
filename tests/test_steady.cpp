// Nothing moves under the mouse, the keys go where the user is, and what is typed is read or refused with a reason.
#include "tests/seed.h"
#include "tests/window_fixture.h"
#include "ui/base/message_bar.h"
#include "ui/face/cards.h"
#include "ui/face/vertex_panel.h"
#include "ui/pipeline/mistakes_section.h"
#include "ui/pipeline/pipeline_panel.h"
#include "ui/steps/step_listing.h"
#include "ui/steps/transport_dock.h"
#include "ui/truth/truth_mode.h"
#include "ui/window/focus_order.h"
#include "ui/window/help_overlay.h"
#include "ui/window/panel_places.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <QTableView>
#include <QToolButton>

#include <algorithm>

using namespace rasterlens;

class TestSteady : public test::WindowFixture
{
    Q_OBJECT

    struct Eye {
        QRect canvas;
        CanvasTransform view;

        friend bool operator==(const Eye&, const Eye&) = default;
    };

    /// Where the canvas lies, once the layout has settled, and what it shows.
    Eye eye()
    {
        for (int i = 0; i < 3; ++i)
            QCoreApplication::processEvents();
        return {QRect(viewport().mapTo(m_window.get(), QPoint(0, 0)), viewport().size()), viewport().transform()};
    }

    QLineEdit* sizeEdit() { return m_window->pipelinePanel().sizeBox()->lineEdit(); }

    /// Types a text in place of what is there, and Return.
    static void type(QLineEdit* edit, const QString& text)
    {
        edit->setFocus(Qt::OtherFocusReason);
        edit->selectAll();
        edit->insert(text);
        QTest::keyClick(edit, Qt::Key_Return);
    }

private Q_SLOTS:
    void messagesMoveNothing()
    {
        for (const QSize size : {QSize(1280, 800), QSize(800, 600)}) {
            m_window->resize(size);
            QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
            const Eye before = eye();
            QVERIFY(m_window->exportFramebuffer(m_folder.filePath(QStringLiteral("written.png"))));
            QVERIFY(!m_window->message().isEmpty());
            QVERIFY(eye() == before);
            document().open(QStringLiteral("/nowhere/none.obj"));
            QVERIFY(waitFor([this] { return m_window->message().contains(QStringLiteral("none.obj")); }));
            QVERIFY(eye() == before);
            QVERIFY(change([](Settings& s) { s.cullSpace = CullSpace::View; })); // two messages at once
            QVERIFY(eye() == before);
            const auto bars = m_window->findChildren<MessageBar*>();
            QCOMPARE(std::ranges::count_if(bars, &MessageBar::isVisible), 2);
            for (const MessageBar* bar : bars) {
                if (!bar->isVisible()) // the offers have nothing to say
                    continue;
                QVERIFY(viewport().rect().contains(QRect(bar->mapTo(&viewport(), QPoint(0, 0)), bar->size())));
                const auto* text = bar->findChild<QLabel*>(QStringLiteral("messageText"));
                QVERIFY2(text->height() >= text->heightForWidth(text->width()), qPrintable(text->text()));
            }
            document().undo();
            QVERIFY(settle());
            QVERIFY(eye() == before);
            for (MessageBar* bar : bars)
                bar->hide();
            QVERIFY(eye() == before);
        }
    }

    void stepsMoveNothing_data()
    {
        QTest::addColumn<QString>("scene");
        QTest::addColumn<Algorithm>("algorithm");
        QTest::addColumn<QSize>("window");
        for (const QSize window : {QSize(1440, 900), QSize(1024, 600)})
            for (const auto& [scene, algorithm] : {std::pair("builtin:square-diagonal", Algorithm::EdgeEquation),
                                                   {"builtin:cube", Algorithm::EdgeEquation},
                                                   {"builtin:cube", Algorithm::EdgeWalking}})
                QTest::addRow("%s %d %d", scene, int(algorithm), window.height())
                    << QString::fromLatin1(scene) << algorithm << window;
    }

    void stepsMoveNothing()
    {
        QFETCH(QString, scene);
        QFETCH(Algorithm, algorithm);
        QFETCH(QSize, window);
        m_window->resize(window);
        for (const LanguageKind language : {LanguageKind::English, LanguageKind::Chinese}) {
            m_window->setLanguage(language);
            QVERIFY(openSmall(scene, {64, 48}));
            QVERIFY(change([&](Settings& s) { s.algorithm = algorithm; }));
            StepSession& session = m_window->stepMode().session();
            session.open();
            QVERIFY(settle());
            const Eye before = eye();
            const int transport = m_window->stepMode().transport().height();
            // Half of the steps from the beginning, half of them spread over the record.
            const auto half = std::size_t(test::casesOfBuild(250));
            const std::size_t stride = std::max<std::size_t>(session.size() / half, 1);
            for (std::size_t i = 0; i < 2 * half; ++i) {
                session.moveTo(std::min(i < half ? i : (i - half) * stride, session.size()));
                const Eye now = eye();
                QVERIFY2(now.canvas == before.canvas,
                         qPrintable(QStringLiteral("step %1, line %2: %3 rows in place of %4")
                                        .arg(session.position())
                                        .arg(m_window->stepMode().listing().explanation().line)
                                        .arg(now.canvas.height())
                                        .arg(before.canvas.height())));
                QVERIFY(now.view == before.view);
            }
            session.close();
            QCoreApplication::processEvents();
            QCOMPARE(m_window->stepMode().transport().height(), transport);
            QVERIFY(settle());
        }
    }

    void refereeAtWorkMovesNothing()
    {
        QVERIFY(openSmall(QStringLiteral("builtin:cube")));
        m_window->truthMode().referee().setOn(true);
        const Eye before = eye();
        QVERIFY(complete());
        QVERIFY(eye() == before);
    }

    void mistakesListStays()
    {
        QVERIFY(openSmall(QStringLiteral("builtin:square-diagonal")));
        MistakesSection& section = m_window->pipelinePanel().mistakes();
        section.setOpen(true);
        QCoreApplication::processEvents();
        const auto* list = section.findChild<QScrollArea*>();
        const QRect before = list->geometry();
        QVERIFY(change([](Settings& s) { s.mistakes << QStringLiteral("all-inclusive"); }));
        QCoreApplication::processEvents();
        QCOMPARE(list->geometry(), before);
        section.setOpen(false);
    }

    void pixelsAreTyped_data()
    {
        QTest::addColumn<QString>("text");
        for (const char* text : {"3,4", "3, 4", "3 4", "(3, 4)", "3，4", "（3，4）", "３、４", " 3 ; 4 "})
            QTest::newRow(text) << QString::fromUtf8(text);
    }

    void pixelsAreTyped()
    {
        QFETCH(QString, text);
        QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
        key(Qt::Key_G, Qt::ControlModifier);
        auto* edit = m_window->findChild<QLineEdit*>(QStringLiteral("goToPixel"));
        type(edit, text);
        QCOMPARE(viewport().selectedPixel(), std::optional(QPoint(3, 4)));
        QVERIFY(!edit->isVisible());
        QVERIFY(viewport().hasFocus());
    }

    void sizesAreTyped_data()
    {
        QTest::addColumn<QString>("text");
        for (const char* text : {"12x9", "12 x 9", "12×9", "12 X 9", "12*9", "12 9", "12，9", "(12, 9)", "１２ｘ９"})
            QTest::newRow(text) << QString::fromUtf8(text);
    }

    void sizesAreTyped()
    {
        QFETCH(QString, text);
        QVERIFY(openSmall(QStringLiteral("builtin:cube")));
        type(sizeEdit(), text);
        QCOMPARE(settings().size, QSize(12, 9));
        QCOMPARE(sizeEdit()->text(), QStringLiteral("12 × 9"));
        QVERIFY2(viewport().hasFocus(), "the next key is not for the field");
    }

    void refusedStaysToBeMended()
    {
        QVERIFY(openSmall(QStringLiteral("builtin:cube")));
        const QSize before = settings().size;
        type(sizeEdit(), QStringLiteral("12 x 9e"));
        QVERIFY(m_window->message().contains(QStringLiteral("12 x 9e")));
        QCOMPARE(sizeEdit()->text(), QStringLiteral("12 x 9e"));
        QCOMPARE(settings().size, before);
        QVERIFY(change([](Settings& s) { s.fill = Fill::Wireframe; }));
        QCOMPARE(sizeEdit()->text(), QStringLiteral("12 x 9e"));
        QTest::keyClick(sizeEdit(), Qt::Key_Backspace);
        QVERIFY2(m_window->message().isEmpty(), "mended");
        QTest::keyClick(sizeEdit(), Qt::Key_Return);
        QCOMPARE(settings().size, QSize(12, 9));

        type(sizeEdit(), QStringLiteral("0"));
        QVERIFY(!m_window->message().isEmpty());
        QTest::keyClick(sizeEdit(), Qt::Key_Escape);
        QVERIFY2(m_window->message().isEmpty(), "given up");
        QCOMPARE(sizeEdit()->text(), QStringLiteral("12 × 9"));
        QVERIFY(viewport().hasFocus());
    }

    void verticesAreTyped()
    {
        QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
        QVERIFY(m_window->cards().show(QStringLiteral("vertices")));
        QVERIFY(complete());
        auto* table = m_window->cards().vertexPanel().findChild<QTableView*>();
        const QModelIndex cell = table->model()->index(VertexTableModel::ObjectSpace, 0);
        const auto former = document().scene();
        table->setFocus();
        table->setCurrentIndex(cell);
        table->edit(cell);
        auto* edit = table->findChild<QLineEdit*>();
        QVERIFY(edit);
        edit->setText(QStringLiteral("abc"));
        QTest::keyClick(edit, Qt::Key_Return);
        QVERIFY(m_window->message().contains(QStringLiteral("abc")));
        QVERIFY2(edit->isVisible(), "stays to be mended");
        QCOMPARE(document().scene(), former);
        edit->clear();
        QTest::keyClicks(edit, QStringLiteral("(0.25; 0.5; 0)"));
        QVERIFY(m_window->message().isEmpty());
        QTest::keyClick(edit, Qt::Key_Return);
        QVERIFY(waitFor([&] { return document().scene() != former; }));
        const auto vertex = (*m_window->cards().vertexPanel().model().corners())[0].meshVertex;
        QCOMPARE(document().scene()->mesh.vertices[vertex].position.x, 0.25F);
        QVERIFY(waitFor([this] { return viewport().hasFocus(); }));
    }

    void escapeLeavesOneThingAPress()
    {
        QVERIFY(openSmall(QStringLiteral("builtin:cube")));
        viewport().selectPixel(QPoint(5, 5));
        StepSession& session = m_window->stepMode().session();
        session.open();
        QVERIFY(settle());
        m_window->setPresentation(true);
        key(Qt::Key_H);
        key(Qt::Key_G, Qt::ControlModifier);
        auto* edit = m_window->findChild<QLineEdit*>(QStringLiteral("goToPixel"));
        const auto open = [&] {
            return QList<bool>{edit->isVisible(), m_window->helpOverlay().isVisible(), m_window->look().presentation,
                               session.isOpen(), viewport().selectedPixel().has_value()};
        };
        QList<bool> expected(5, true);
        QCOMPARE(open(), expected);
        for (bool& thing : expected) {
            QWidget* focused = QApplication::focusWidget();
            QTest::keyClick(focused ? focused : &viewport(), Qt::Key_Escape);
            QCoreApplication::processEvents();
            thing = false;
            QCOMPARE(open(), expected);
        }
    }

    void helpIsLive()
    {
        QVERIFY(openSmall(QStringLiteral("builtin:cube")));
        key(Qt::Key_H);
        const auto text = [this] {
            QString all;
            for (const QLabel* label : m_window->helpOverlay().findChildren<QLabel*>())
                all += label->text();
            return all;
        };
        for (const Qt::Key pressed : {Qt::Key_R, Qt::Key_S, Qt::Key_V}) {
            const QString before = text();
            key(pressed);
            QVERIFY2(waitFor([&] { return text() != before; }), qPrintable(QKeySequence(pressed).toString()));
            QVERIFY(complete());
        }
        key(Qt::Key_Escape);
        QVERIFY(!m_window->helpOverlay().isVisible());
    }

    void tabComesToEverything()
    {
        QVERIFY(openSmall(QStringLiteral("builtin:cube")));
        m_window->stepMode().session().open();
        QVERIFY(settle());
        const std::vector<QWidget*> order = m_window->focusOrder().widgets();
        const auto place = [&](const QWidget* widget) { return std::ranges::find(order, widget) - order.begin(); };
        const auto count = std::ptrdiff_t(order.size());
        int buttons = 0;
        for (const QToolButton* button : m_window->stepMode().transport().findChildren<QToolButton*>())
            if (button->isVisible() && button->isEnabled()) {
                ++buttons;
                QVERIFY2(place(button) < count, qPrintable(button->accessibleName() + button->text()));
            }
        QVERIFY(buttons > 8);
        QVERIFY(place(m_window->pipelinePanel().sceneBox()) < place(&viewport()));
        QVERIFY(place(&viewport()) < place(m_window->stepMode().transport().findChild<QToolButton*>()));
        viewport().setFocus();
        for (std::size_t i = 0; i < order.size(); ++i) {
            QWidget* former = QApplication::focusWidget();
            QTest::keyClick(former, Qt::Key_Tab);
            QVERIFY2(QApplication::focusWidget() != former, former->metaObject()->className());
        }
        QVERIFY2(viewport().hasFocus(), "once round");
    }

    void panelKeysAreTheirsAlone()
    {
        QVERIFY(openSmall(QStringLiteral("builtin:square-diagonal")));
        QMap<QString, QStringList> users;
        for (const QAction* action : m_window->findChildren<QAction*>())
            for (const QKeySequence& sequence : action->shortcuts())
                users[sequence.toString()] << action->text();
        const auto& panels = m_window->panels().actions();
        QCOMPARE(panels.size(), std::size_t(13));
        for (const auto& [action, dock] : panels) {
            QVERIFY(!action->shortcut().isEmpty());
            QCOMPARE(users[action->shortcut().toString()].size(), 1);
            const bool before = m_window->panels().isInSight(dock);
            key(Qt::Key(action->shortcut()[0].key()), Qt::AltModifier);
            QCoreApplication::processEvents();
            QCOMPARE(m_window->panels().isInSight(dock), !before);
        }
    }

    void canvasShowsItsFocus()
    {
        QVERIFY(openSmall(QStringLiteral("builtin:cube")));
        const auto corner = [this] { return viewport().grab().toImage().pixelColor(1, 1); };
        viewport().setFocus();
        const QColor focused = corner();
        m_window->pipelinePanel().sceneBox()->setFocus();
        QVERIFY(corner() != focused);
    }
};

QTEST_MAIN(TestSteady)
#include "test_steady.moc"
