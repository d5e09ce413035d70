// Random actions on the window: whatever is chosen, pressed, clicked, dragged, dropped or resized, the window settles,
// and in the end it draws what it drew before. RASTERLENS_SEED=N draws other actions, RASTERLENS_ACTIONS=N as many,
// RASTERLENS_KEPT=3,17-40 only these of them: each depends on the seed and its own number alone, so that scripts/monkey
// can leave out what a failure does not need.
#include "core/lessons/lesson.h"
#include "core/scenes/builtin_scenes.h"
#include "tests/seed.h"
#include "tests/window_fixture.h"
#include "ui/base/action_table.h"
#include "ui/lessons/lesson_mode.h"
#include "ui/truth/truth_mode.h"

#include <QAbstractButton>
#include <QAbstractSlider>
#include <QComboBox>
#include <QDesktopServices>
#include <QFileDialog>
#include <QLineEdit>
#include <QMimeData>

#include <array>
#include <iterator>
#include <random>
#include <vector>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

/// The random numbers of one action.
class Draw
{
public:
    Draw(unsigned seed, int action) : m_random(seed * 1'000'003ULL + std::uint64_t(action)) { m_random.discard(8); }

    /// 0..most
    int upTo(int most) { return std::uniform_int_distribution<int>(0, most)(m_random); }
    template <class Values>
    const auto& of(const Values& values)
    {
        return values[static_cast<decltype(std::size(values))>(upTo(int(std::size(values)) - 1))];
    }
    QPointF pointIn(const QWidget& widget)
    {
        return {double(upTo(std::max(0, widget.width() - 1))), double(upTo(std::max(0, widget.height() - 1)))};
    }

private:
    std::mt19937_64 m_random;
};

/// The numbers of "3,17-40"; all of [0, count) for an empty text.
std::vector<int> numbersOf(const QString& text, int count)
{
    std::vector<int> numbers;
    if (text.isEmpty())
        for (int i = 0; i < count; ++i)
            numbers.push_back(i);
    for (const QString& part : text.split(QLatin1Char(','), Qt::SkipEmptyParts))
        for (int i = part.section(QLatin1Char('-'), 0, 0).toInt(); i <= part.section(QLatin1Char('-'), -1).toInt(); ++i)
            numbers.push_back(i);
    return numbers;
}

constexpr std::array kSchemes{"http", "https", "file"}; ///< of links

constexpr auto kCaseText = "size 20 16\ntri -1 -1 0 1 1 0 0  1 -1 0 2 0 1 0  0 3 0 1 0 0 1\n";

} // namespace

class TestMonkey : public WindowFixture
{
    Q_OBJECT

private Q_SLOTS:
    void anythingGoes();
    void cleanup()
    {
        for (const char* scheme : kSchemes)
            QDesktopServices::unsetUrlHandler(QLatin1String(scheme));
        closeWindow();
    }

public Q_SLOTS:
    /// In place of a browser.
    void swallow(const QUrl&) {}

private:
    /// Does the action of a number; what it was.
    QString act(Draw& draw);
    QString chooseAction(Draw& draw);
    QString pressKey(Draw& draw);
    QString useWidget(Draw& draw);
    QString useCanvas(Draw& draw);
    QString changeSetting(Draw& draw);
    QString openSomething(Draw& draw);
    QString dropSomething(Draw& draw);
    QString changeWindow(Draw& draw);
    /// Pictures that move by themselves are never settled.
    void holdStill();
    /// Popups and questions do not stay: files are neither chosen nor overwritten.
    void leaveDialogs(Draw& draw);
    QString fileOf(const char* name, const QByteArray& bytes);
};

QString TestMonkey::fileOf(const char* name, const QByteArray& bytes)
{
    const QString path = m_folder.filePath(QString::fromLatin1(name));
    QFile file(path);
    if (file.open(QIODevice::WriteOnly))
        file.write(bytes);
    return path;
}

QString TestMonkey::chooseAction(Draw& draw)
{
    static const QStringList kLeftOut{QStringLiteral("file.quit")};
    const auto& rows = m_window->actionTable().rows();
    const ActionRow& row = draw.of(rows);
    if (!row.action || kLeftOut.contains(row.id) || !row.action->isEnabled())
        return QStringLiteral("nothing");
    row.action->trigger();
    return row.id;
}

QString TestMonkey::pressKey(Draw& draw)
{
    constexpr std::array kKeys{Qt::Key_Left,   Qt::Key_Right, Qt::Key_Up,       Qt::Key_Down,   Qt::Key_Space,
                               Qt::Key_Home,   Qt::Key_End,   Qt::Key_PageDown, Qt::Key_PageUp, Qt::Key_Escape,
                               Qt::Key_Return, Qt::Key_Tab,   Qt::Key_R,        Qt::Key_W,      Qt::Key_C,
                               Qt::Key_T,      Qt::Key_P,     Qt::Key_X,        Qt::Key_M,      Qt::Key_1,
                               Qt::Key_2,      Qt::Key_Plus,  Qt::Key_Minus,    Qt::Key_Z};
    constexpr std::array<Qt::KeyboardModifiers, 5> kModifiers{Qt::NoModifier, Qt::NoModifier, Qt::ShiftModifier,
                                                              Qt::ControlModifier, Qt::AltModifier};
    const Qt::Key pressed = draw.of(kKeys);
    const Qt::KeyboardModifiers modifiers = draw.of(kModifiers);
    QWidget* target = QApplication::focusWidget();
    QTest::keyClick(target ? target : &viewport(), pressed, modifiers);
    return QStringLiteral("key ") + QKeySequence(int(modifiers) | int(pressed)).toString();
}

/// A button, box, slider or line that can be seen.
QString TestMonkey::useWidget(Draw& draw)
{
    QList<QWidget*> seen;
    for (QWidget* widget : m_window->findChildren<QWidget*>())
        if (widget->isVisible() && widget->isEnabled() && widget->focusPolicy() != Qt::NoFocus)
            seen << widget;
    if (seen.isEmpty())
        return QStringLiteral("nothing");
    QWidget* widget = draw.of(seen);
    const QString what =
        QStringLiteral("%1 %2").arg(QLatin1String(widget->metaObject()->className()), widget->objectName());
    if (auto* box = qobject_cast<QComboBox*>(widget)) {
        if (box->count() > 0) {
            box->setCurrentIndex(draw.upTo(box->count() - 1));
            Q_EMIT box->activated(box->currentIndex());
        }
    } else if (auto* slider = qobject_cast<QAbstractSlider*>(widget)) {
        slider->setValue(slider->minimum() + draw.upTo(std::min(slider->maximum() - slider->minimum(), 100'000)));
    } else if (auto* line = qobject_cast<QLineEdit*>(widget)) {
        constexpr std::array kTyped{"1", "-3.5", "0", "1e9", "nan", "abc", ""};
        line->selectAll();
        QTest::keyClicks(line, QLatin1String(draw.of(kTyped)));
        QTest::keyClick(line, Qt::Key_Return);
    } else {
        QTest::mouseClick(widget, Qt::LeftButton, Qt::NoModifier, draw.pointIn(*widget).toPoint());
    }
    return what;
}

QString TestMonkey::useCanvas(Draw& draw)
{
    const QPointF from = draw.pointIn(viewport());
    const QPointF to = draw.pointIn(viewport());
    constexpr std::array kButtons{Qt::LeftButton, Qt::LeftButton, Qt::MiddleButton};
    const Qt::MouseButton button = draw.of(kButtons);
    const Qt::KeyboardModifiers modifiers = draw.upTo(3) == 0 ? Qt::ShiftModifier : Qt::NoModifier;
    switch (draw.upTo(3)) {
    case 0: QTest::mouseClick(&viewport(), button, modifiers, from.toPoint()); return QStringLiteral("click");
    case 1: QTest::mouseDClick(&viewport(), button, modifiers, from.toPoint()); return QStringLiteral("double click");
    case 2: {
        QWheelEvent wheel(from, viewport().mapToGlobal(from), {}, {0, draw.upTo(1) == 0 ? 120 : -120}, Qt::NoButton,
                          modifiers, Qt::NoScrollPhase, false);
        QApplication::sendEvent(&viewport(), &wheel);
        return QStringLiteral("wheel");
    }
    default: break;
    }
    QTest::mousePress(&viewport(), button, modifiers, from.toPoint());
    constexpr int kMoves = 4;
    for (int i = 1; i <= kMoves; ++i) {
        const QPointF at = from + (to - from) * i / kMoves;
        QMouseEvent move(QEvent::MouseMove, at, viewport().mapToGlobal(at), Qt::NoButton, button, modifiers);
        QApplication::sendEvent(&viewport(), &move);
    }
    QTest::mouseRelease(&viewport(), button, modifiers, to.toPoint());
    return QStringLiteral("drag");
}

QString TestMonkey::changeSetting(Draw& draw)
{
    const SettingsField& field = draw.of(settingsFields());
    Settings next = settings();
    field.set(next, field.minimum + draw.upTo(field.maximum - field.minimum));
    document().setSettings(next);
    return QStringLiteral("%1 = %2").arg(QLatin1String(field.id), valueId(field, next));
}

QString TestMonkey::openSomething(Draw& draw)
{
    QString name = QStringLiteral("builtin:") + QLatin1String(draw.of(builtinScenes()).name);
    switch (draw.upTo(5)) {
    case 0: {
        const QStringList ids = lessonIds();
        const QString& id = draw.of(ids);
        m_window->lessons().open(id);
        return QStringLiteral("lesson ") + id;
    }
    case 1: name = fileOf("broken.obj", "v 1 2\nf 1 2 3\n"); break;
    case 2: name = fileOf("own.case", kCaseText); break;
    case 3: name = fileOf("broken.json", "{\"rasterlens\": 1, \"scene\""); break;
    default: break;
    }
    m_window->open(name);
    return QStringLiteral("open ") + QFileInfo(name).fileName();
}

QString TestMonkey::dropSomething(Draw& draw)
{
    QMimeData data;
    QImage picture(8, 8, QImage::Format_RGB32);
    picture.fill(draw.upTo(0xffffff));
    const QString png = m_folder.filePath(QStringLiteral("answer.png"));
    picture.save(png);
    const std::array files{png, fileOf("own.case", kCaseText), fileOf("empty.obj", ""),
                           m_folder.filePath(QStringLiteral("missing.obj"))};
    QList<QUrl> urls;
    for (int i = draw.upTo(2); i > 0; --i)
        urls << QUrl::fromLocalFile(draw.of(files));
    data.setUrls(urls);
    QDragEnterEvent enter({200, 200}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(m_window.get(), &enter);
    QDropEvent drop(QPointF(200, 200), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(m_window.get(), &drop);
    return QStringLiteral("drop %1 files").arg(urls.size());
}

QString TestMonkey::changeWindow(Draw& draw)
{
    constexpr std::array kSizes{QSize(1024, 768), QSize(1280, 800), QSize(1366, 768), QSize(1920, 1080),
                                QSize(700, 500)};
    switch (draw.upTo(3)) {
    case 0: m_window->resize(draw.of(kSizes)); return QStringLiteral("resize");
    case 1:
        m_window->setLanguage(m_window->language() == LanguageKind::English ? LanguageKind::Chinese
                                                                            : LanguageKind::English);
        return QStringLiteral("language");
    case 2: m_window->setPresentation(draw.upTo(1) == 0); return QStringLiteral("presentation");
    default: break;
    }
    m_window->setLook({draw.upTo(1) == 0 ? ThemeKind::Dark : ThemeKind::Light, m_window->look().presentation});
    return QStringLiteral("theme");
}

QString TestMonkey::act(Draw& draw)
{
    switch (draw.upTo(15)) {
    case 0:
    case 1:
    case 2:
    case 3: return chooseAction(draw);
    case 4:
    case 5:
    case 6: return pressKey(draw);
    case 7:
    case 8: return useWidget(draw);
    case 9:
    case 10: return useCanvas(draw);
    case 11:
    case 12: return changeSetting(draw);
    case 13: return openSomething(draw);
    case 14: return draw.upTo(1) == 0 ? dropSomething(draw) : changeWindow(draw);
    default: break;
    }
    QTest::qWait(draw.upTo(40));
    return QStringLiteral("wait");
}

void TestMonkey::holdStill()
{
    for (const ActionRow& row : m_window->actionTable().rows())
        if (row.action && row.action->isChecked() &&
            (row.id == QLatin1String("camera.turntable") || row.id == QLatin1String("camera.jitter") ||
             row.id == QLatin1String("view.continuous")))
            row.action->trigger();
    if (m_window->stepMode().session().isPlaying())
        m_window->stepMode().session().setPlaying(false);
}

void TestMonkey::leaveDialogs(Draw& draw)
{
    for (QWidget* widget : QApplication::topLevelWidgets()) {
        auto* dialog = qobject_cast<QDialog*>(widget);
        if (!dialog || !dialog->isVisible())
            continue;
        if (!qobject_cast<QFileDialog*>(dialog) && draw.upTo(1) == 0)
            QTest::keyClick(dialog, Qt::Key_Return);
        if (dialog->isVisible())
            dialog->reject();
    }
}

void TestMonkey::anythingGoes()
{
    QDir::setCurrent(m_folder.path());
    for (const char* scheme : kSchemes)
        QDesktopServices::setUrlHandler(QLatin1String(scheme), this, "swallow");
    const unsigned seed = seedOfRun();
    bool given = false;
    const int wanted = qEnvironmentVariableIntValue("RASTERLENS_ACTIONS", &given);
    const std::vector<int> actions =
        numbersOf(qEnvironmentVariable("RASTERLENS_KEPT"), given ? wanted : casesOfBuild(500));
    const bool isTold = qEnvironmentVariableIsSet("RASTERLENS_TELL");
    QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
    const QImage before = picture();
    constexpr int kSettleEvery = 20;
    QTimer popups; // a menu below a button waits for its end
    connect(&popups, &QTimer::timeout, this, [] {
        if (QWidget* popup = QApplication::activePopupWidget())
            popup->close();
    });
    popups.start(20);
    int done = 0;
    for (const int number : actions) {
        Draw draw(seed, number);
        QElapsedTimer clock;
        clock.start();
        const QString what = act(draw);
        if (isTold)
            std::fprintf(stderr, "%d %s\n", number, qUtf8Printable(what));
        QCoreApplication::processEvents();
        leaveDialogs(draw);
        constexpr int kMostPixels = 800 * 600;
        if (settings().size.width() * settings().size.height() > kMostPixels)
            document().setSettings([&] {
                Settings small = settings();
                small.size = {320, 240};
                return small;
            }());
        if (++done % kSettleEvery != 0)
            continue;
        holdStill();
        QVERIFY2(settle(), qPrintable(QStringLiteral("action %1: %2").arg(number).arg(what)));
        if (isTold)
            std::fprintf(stderr, "settled after %lld ms\n", static_cast<long long>(clock.elapsed()));
    }
    // What was undone, opened and switched on along the way has not damaged what draws.
    holdStill();
    m_window->stepMode().session().close();
    m_window->truthMode().comparison().setView(CompareView::Off);
    m_window->setPresentation(false);
    m_window->setLanguage(LanguageKind::English);
    QVERIFY(settle());
    document().setScene(std::make_shared<const Scene>(*makeBuiltinScene(QStringLiteral("square-diagonal")).scene));
    QVERIFY(settle());
    QCOMPARE(picture(), before);
}

QTEST_MAIN(TestMonkey)
#include "test_monkey.moc"
