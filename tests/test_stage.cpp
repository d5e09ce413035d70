// The stage for a lecture: the picture first, one caption, all menus within reach; and what a first start and a session
// show.
#include "core/lessons/lesson.h"
#include "tests/seed.h"
#include "ui/base/inks.h"
#include "ui/lessons/lesson_mode.h"
#include "ui/lessons/lesson_panel.h"
#include "ui/lessons/texts.h"
#include "ui/pipeline/mistake_badge.h"
#include "ui/steps/step_listing.h"
#include "ui/steps/step_sentence.h"
#include "ui/steps/transport_dock.h"
#include "ui/truth/truth_mode.h"
#include "ui/window/panel_places.h"
#include "ui/window/window_moment.h"
#include "window_fixture.h"

#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QStatusBar>
#include <QTableView>
#include <QToolButton>

using namespace rasterlens;
using namespace rasterlens::test;

class TestStage : public WindowFixture
{
    Q_OBJECT

private Q_SLOTS:
    void thePictureHasMostOfTheScreen_data();
    void thePictureHasMostOfTheScreen();
    void thePictureDoesNotMoveFromStepToStep();
    void theCaptionTellsTheStep();
    void allMenusAreWithinReach();
    void lessonsAreHeldOnTheStage();
    void everySlideLeavesThePictureItsShare_data();
    void everySlideLeavesThePictureItsShare();
    void panelsOfSlidesAreWhole_data();
    void panelsOfSlidesAreWhole();
    void thePictureStaysFromQuestionToAnswer_data();
    void thePictureStaysFromQuestionToAnswer();
    void theBadgeCoversNoFace_data();
    void theBadgeCoversNoFace();
    void numbersCoverNoEdge_data();
    void numbersCoverNoEdge();
    void sessionsKeepTheMoment();
    void oldSessionsLeaveTheViewAlone();
    void rOffersASmallPicture();
    void theFirstStartOpensTheFirstLesson();
    void aComparisonDoesNotWidenTheWindow();
    void theLegendIsInSight();
    void theCountersAreInSight_data();
    void theCountersAreInSight();

private:
    static constexpr double kShareOfPicture = 0.58;         ///< of the screen's height, at 1024x768
    static constexpr double kShareBesideLongChoices = 0.53; ///< where question and choices have two lines each

    /// Nothing, the first choice or the first pixel is the answer.
    static void giveWrong(LessonPlayer& player)
    {
        const Question& question = *player.slide().question;
        player.answer(question.kind == QuestionKind::Pixels ? GivenAnswer(std::vector<QPoint>{{0, 0}})
                      : !question.choices.empty()           ? GivenAnswer(std::size_t(0))
                                                            : GivenAnswer(QStringLiteral("-99")));
    }

    /// What is written in a dock and has no room there, or lies beyond its right edge.
    static QStringList cutTexts(const QWidget& dock)
    {
        QStringList cut;
        const auto check = [&](const QWidget& part, const QString& text, int needed) {
            const int right = part.mapTo(&dock, QPoint(part.width(), 0)).x();
            if (!text.isEmpty() && (right > dock.width() || part.width() < needed))
                cut << QStringLiteral("\"%1\" has %2 of %3, up to %4 of %5")
                           .arg(text)
                           .arg(part.width())
                           .arg(needed)
                           .arg(right)
                           .arg(dock.width());
        };
        for (const QWidget* part : dock.findChildren<QWidget*>()) {
            if (!part->isVisible())
                continue;
            if (const auto* label = qobject_cast<const QLabel*>(part))
                check(*label, label->text(), label->minimumSizeHint().width());
            else if (const auto* button = qobject_cast<const QAbstractButton*>(part))
                check(*button, button->text(), button->minimumSizeHint().width());
            else if (const auto* box = qobject_cast<const QComboBox*>(part))
                check(*box, box->currentText(), box->minimumSizeHint().width());
            else if (const auto* table = qobject_cast<const QTableView*>(part))
                check(*table->viewport(), QStringLiteral("table"), table->horizontalHeader()->length());
        }
        return cut;
    }

    QLabel* caption() { return m_window->findChild<QLabel*>(QStringLiteral("caption")); }

    bool openStage(QSize size)
    {
        m_window->setPresentation(true);
        m_window->showNormal();
        m_window->resize(size);
        QTest::qWait(50);
        return complete() && m_window->size() == size;
    }
};

void TestStage::thePictureHasMostOfTheScreen_data()
{
    QTest::addColumn<QSize>("size");
    QTest::addColumn<QString>("mistake");
    QTest::newRow("1024x768") << QSize(1024, 768) << QString();
    QTest::newRow("1024x768, mistake") << QSize(1024, 768) << QStringLiteral("all-inclusive");
    QTest::newRow("1920x1080") << QSize(1920, 1080) << QString();
}

void TestStage::thePictureHasMostOfTheScreen()
{
    QFETCH(QSize, size);
    QFETCH(QString, mistake);
    QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
    QVERIFY(change([&](Settings& s) { s.mistakes = mistake.isEmpty() ? QStringList() : QStringList{mistake}; }));
    m_window->stepMode().showStep(QStringLiteral("tie"));
    QVERIFY(complete());
    QVERIFY(openStage(size));
    const double share = double(viewport().height()) / m_window->height();
    QVERIFY2(share >= 0.6, qPrintable(QString::number(share)));
    QVERIFY2(viewport().transform().zoom >= kLensNumbersFromCell,
             qPrintable(QString::number(viewport().transform().zoom)));
    QVERIFY(m_window->stepMode().listing().isVisible());
    QVERIFY(m_window->stepMode().transport().isVisible());
    const bool isBeside = m_window->stepMode().listing().geometry().left() > viewport().geometry().left();
    QCOMPARE(isBeside, size.width() > 1200);
    QTest::keyClick(&viewport(), Qt::Key_Escape);
    QVERIFY(!m_window->look().presentation);
    QVERIFY(m_window->menuBar()->isVisible());
}

void TestStage::thePictureDoesNotMoveFromStepToStep()
{
    QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
    m_window->stepMode().showStep(QStringLiteral("12"));
    QVERIFY(complete());
    QVERIFY(openStage({1024, 768}));
    const QRect place = viewport().geometry();
    const CanvasTransform transform = viewport().transform();
    for (int i = 0; i < test::casesOfBuild(60); ++i) {
        key(Qt::Key_Right);
        QVERIFY(complete());
        QCoreApplication::processEvents();
        QCOMPARE(viewport().geometry(), place);
        QVERIFY(viewport().transform() == transform);
    }
}

void TestStage::theCaptionTellsTheStep()
{
    QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
    QVERIFY(openStage({1024, 768}));
    QVERIFY(caption()->text().contains(QStringLiteral("Square cut by its diagonal")));
    m_window->stepMode().showStep(QStringLiteral("tie"));
    QVERIFY(complete());
    const StepSession& session = m_window->stepMode().session();
    QCOMPARE(caption()->text(), stepSentence(*session.log(), session.position() - 1).toHtmlEscaped());
    QCOMPARE(caption()->text(),
             QStringLiteral("Pixel (7, 0) lies exactly on BC, a right or bottom edge: face 0 does not draw it."));
    QVERIFY(change([](Settings& s) { s.mistakes = {QStringLiteral("all-inclusive")}; }));
    QVERIFY(caption()->text().contains(QStringLiteral("M1")));
    QVERIFY(caption()->text().contains(QStringLiteral("and still face 0 draws it")));
    // Whatever happens, there is a sentence.
    for (std::size_t i = 0; i < session.size(); ++i)
        QVERIFY(!stepSentence(*session.log(), i).isEmpty());
}

void TestStage::allMenusAreWithinReach()
{
    QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
    auto* button = m_window->findChild<QToolButton*>(QStringLiteral("stageMenu"));
    QVERIFY(!button->isVisible());
    QVERIFY(openStage({1024, 768}));
    QVERIFY(button->isVisible() && !m_window->menuBar()->isVisible());
    QCOMPARE(button->menu()->actions(), m_window->menuBar()->actions());
    m_window->actionTable().action("lesson.open-perspective")->trigger();
    QVERIFY(complete());
    QCOMPARE(m_window->lessons().player().lesson().id, QStringLiteral("perspective"));
}

void TestStage::lessonsAreHeldOnTheStage()
{
    QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
    QVERIFY(openStage({1024, 768}));
    QVERIFY(m_window->lessons().open(QStringLiteral("top-left")));
    QVERIFY(complete());
    key(Qt::Key_PageDown);
    QVERIFY(complete());
    QTest::qWait(50);
    const LessonPanel& panel = m_window->lessons().panel();
    QVERIFY(panel.isVisible() && !caption()->isVisible());
    QVERIFY(!panel.text().isEmpty());
    QVERIFY2(viewport().height() >= 0.6 * m_window->height(), qPrintable(QString::number(viewport().height())));
    QVERIFY(viewport().transform().zoom >= kLensNumbersFromCell);
    m_window->setPresentation(false);
    QVERIFY(panel.isVisible()); // in its dock
    m_window->lessons().player().close();
    QVERIFY(openStage({1024, 768}));
    QVERIFY(!panel.isVisible() && caption()->isVisible());
}

void TestStage::everySlideLeavesThePictureItsShare_data()
{
    QTest::addColumn<QString>("id");
    QTest::addColumn<bool>("isChinese");
    const QStringList ids = lessonIds();
    for (qsizetype i = 0; i < ids.size(); i += qsizetype(everyOfBuild()))
        for (const bool isChinese : {false, true})
            QTest::addRow("%s, %s", qPrintable(ids[i]), isChinese ? "Chinese" : "English") << ids[i] << isChinese;
}

/// With its question open, after a wrong answer, and with its picture. Choices of two lines take a part of it.
void TestStage::everySlideLeavesThePictureItsShare()
{
    QFETCH(const QString, id);
    QFETCH(const bool, isChinese);
    m_window->setLanguage(isChinese ? LanguageKind::Chinese : LanguageKind::English);
    QVERIFY(m_window->lessons().open(id));
    QVERIFY(openStage({1024, 768}));
    LessonPlayer& player = m_window->lessons().player();
    player.setLevel(2);
    QStringList small;
    const auto measure = [&](const char* when) {
        QVERIFY(complete());
        QTest::qWait(20); // layouts follow through the event loop
        const double share = double(viewport().height()) / m_window->height();
        bool hasLongChoices = false;
        if (player.slide().question)
            for (const QuestionChoice& choice : player.slide().question->choices)
                hasLongChoices = hasLongChoices || choiceText(choice).size() > (isChinese ? 10 : 20);
        if (share < (hasLongChoices ? kShareBesideLongChoices : kShareOfPicture))
            small
                << QStringLiteral("slide %1, %2: %3").arg(player.place().slide + 1).arg(QLatin1String(when)).arg(share);
        QCOMPARE(m_window->size(), QSize(1024, 768));
    };
    while (player.place().phase != LessonPlayer::Phase::Ended) {
        measure(player.isAsking() ? "asked" : "shown");
        if (player.isAsking()) {
            giveWrong(player);
            if (player.isAsking())
                measure("tried");
        }
        player.next();
    }
    QVERIFY2(small.isEmpty(), qPrintable(small.join(QStringLiteral("; "))));
}

void TestStage::panelsOfSlidesAreWhole_data()
{
    QTest::addColumn<QSize>("size");
    QTest::addColumn<bool>("isChinese");
    for (const QSize size : {QSize(1280, 800), QSize(1920, 1080)})
        for (const bool isChinese : {false, true})
            QTest::addRow("%d, %s", size.width(), isChinese ? "Chinese" : "English") << size << isChinese;
}

/// Beside the canvas, which keeps half of the width, no text of a panel is cut at its right.
void TestStage::panelsOfSlidesAreWhole()
{
    QFETCH(const QSize, size);
    QFETCH(const bool, isChinese);
    m_window->setLanguage(isChinese ? LanguageKind::Chinese : LanguageKind::English);
    QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
    QVERIFY(openStage(size));
    LessonPlayer& player = m_window->lessons().player();
    player.setLevel(2);
    QStringList wrong;
    std::size_t panels = 0;
    for (const QString& id : lessonIds()) {
        QVERIFY(m_window->lessons().open(id));
        for (std::size_t i = 0; i < player.lesson().slides.size(); ++i) {
            if (player.lesson().slides[i].moment.panels.isEmpty())
                continue;
            player.goTo(i, LessonPlayer::Entry::Skips);
            QVERIFY(complete());
            QTest::qWait(50);
            const QString where = QStringLiteral("%1 %2").arg(id).arg(i + 1);
            if (2 * viewport().width() < m_window->width() - 40)
                wrong << QStringLiteral("%1: the canvas is %2 wide").arg(where).arg(viewport().width());
            for (const auto& [action, dock] : m_window->panels().actions())
                if (m_window->panels().isInSight(dock)) {
                    ++panels;
                    for (const QString& text : cutTexts(*dock))
                        wrong << QStringLiteral("%1: %2").arg(where, text);
                }
            QCOMPARE(m_window->size(), size);
        }
    }
    QVERIFY(panels >= 20);
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(QStringLiteral("\n"))));
}

void TestStage::thePictureStaysFromQuestionToAnswer_data()
{
    QTest::addColumn<QString>("id");
    QTest::addColumn<bool>("isChinese");
    for (const char* id : {"top-left", "perspective", "super-sampling"})
        for (const bool isChinese : {false, true})
            QTest::addRow("%s, %s", id, isChinese ? "Chinese" : "English") << QString::fromLatin1(id) << isChinese;
}

/// A wrong answer is told of, then the right one, and then another slide is shown: the canvas keeps its place.
void TestStage::thePictureStaysFromQuestionToAnswer()
{
    QFETCH(QString, id);
    QFETCH(bool, isChinese);
    m_window->setLanguage(isChinese ? LanguageKind::Chinese : LanguageKind::English);
    QVERIFY(m_window->lessons().open(id));
    QVERIFY(complete());
    QVERIFY(openStage({1024, 768}));
    LessonPlayer& player = m_window->lessons().player();
    const auto place = [&] {
        QTest::qWait(20); // layouts follow through the event loop
        return viewport().geometry();
    };
    int questions = 0;
    while (player.place().phase != LessonPlayer::Phase::Ended) {
        const QRect before = place();
        const std::size_t slide = player.place().slide;
        if (player.isAsking()) {
            ++questions;
            const QuestionKind kind = player.slide().question->kind;
            const bool isChoice = !player.slide().question->choices.empty();
            for (int i = 0; i < 2 && player.isAsking(); ++i)
                player.answer(kind == QuestionKind::Pixels ? GivenAnswer(std::vector<QPoint>{{0, 0}})
                              : isChoice                   ? GivenAnswer(std::size_t(i))
                                                           : GivenAnswer(QStringLiteral("-99")));
            if (player.isAsking())
                key(Qt::Key_PageDown);
        } else {
            key(Qt::Key_PageDown);
        }
        QVERIFY(complete());
        if (player.place().slide == slide)
            QCOMPARE(place(), before);
    }
    QVERIFY(questions >= 3);
}

void TestStage::theBadgeCoversNoFace_data()
{
    QTest::addColumn<QString>("id");
    QTest::addColumn<std::size_t>("slide");
    QTest::newRow("a part of the picture") << QStringLiteral("barycentric") << std::size_t(8);
    QTest::newRow("two lines over a picture") << QStringLiteral("linear-z") << std::size_t(5);
    QTest::newRow("up to the border") << QStringLiteral("number-types") << std::size_t(3);
}

void TestStage::theBadgeCoversNoFace()
{
    QFETCH(const QString, id);
    QFETCH(const std::size_t, slide);
    QVERIFY(m_window->lessons().open(id));
    QVERIFY(openStage({1024, 768}));
    m_window->lessons().player().goTo(slide - 1, LessonPlayer::Entry::Skips);
    QVERIFY(complete());
    QTest::qWait(50);
    QVERIFY(complete());
    const auto* badge = m_window->findChild<MistakeBadge*>();
    QVERIFY(badge->isVisible());
    const Frame& frame = viewport().frame()->frame;
    int faces = 0;
    for (int y = 0; y < frame.image.height(); ++y)
        for (int x = 0; x < frame.image.width(); ++x)
            if (frame.ids[std::size_t(y) * std::size_t(frame.image.width()) + std::size_t(x)] >= 0) {
                ++faces;
                const QRectF pixel = viewport().transform().toCanvas(QRectF(x, y, 1, 1));
                QVERIFY2(!pixel.intersects(QRectF(badge->geometry())),
                         qPrintable(QStringLiteral("%1, %2").arg(x).arg(y)));
            }
    QVERIFY(faces > 0);
}

void TestStage::numbersCoverNoEdge_data()
{
    QTest::addColumn<std::size_t>("slide");
    QTest::addColumn<QSize>("size");
    for (const std::size_t slide : {5, 6, 7})
        for (const QSize size : {QSize(1024, 768), QSize(1920, 1080)})
            QTest::addRow("%d, %d", int(slide), size.width()) << slide << size;
}

/// Edge walking: the plate with the numbers of a row, and the legend, leave the edges from B in sight.
void TestStage::numbersCoverNoEdge()
{
    QFETCH(const std::size_t, slide);
    QFETCH(const QSize, size);
    QVERIFY(m_window->lessons().open(QStringLiteral("edge-walking")));
    QVERIFY(openStage(size));
    m_window->lessons().player().goTo(slide - 1, LessonPlayer::Entry::Skips);
    QVERIFY(complete());
    const QImage canvas = viewport().grab().toImage();
    const auto isEdge = [&](QPointF at) {
        for (int dy = -4; dy <= 4; ++dy)
            for (int dx = -4; dx <= 4; ++dx)
                if (canvas.pixel(at.toPoint() + QPoint(dx, dy)) == kCanvasBrokenEdge)
                    return true;
        return false;
    };
    for (const QPointF end : {QPointF(7, 1), QPointF(2, 10)}) { // C and A, see the lesson's first slides
        const QLineF edge(viewport().transform().toCanvas(QPointF(15, 7)), viewport().transform().toCanvas(end));
        constexpr double kNames = 70; // canvas pixels that the names of the corners may take
        constexpr double kDash = 40;
        for (double along = kNames; along + kDash < edge.length() - kNames; along += kDash) {
            bool isSeen = false;
            for (double s = along; s < along + kDash; s += 2)
                isSeen = isSeen || isEdge(edge.pointAt(s / edge.length()));
            QVERIFY2(isSeen, qPrintable(QStringLiteral("%1 of %2").arg(along).arg(edge.length())));
        }
    }
}

void TestStage::sessionsKeepTheMoment()
{
    QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
    m_window->stepMode().showStep(QStringLiteral("tie"));
    QVERIFY(complete());
    viewport().selectPixel(QPoint(7, 0));
    viewport().showAround({4, 4}, 32);
    m_window->actionTable().action("view.samples")->trigger();
    m_window->truthMode().showPanel(QStringLiteral("cases"));
    QVERIFY(complete());
    const Moment kept = m_window->moment().present();
    const QString path = m_folder.filePath(QStringLiteral("moment.json"));
    QVERIFY(document().saveSession(path));
    closeWindow();
    openWindow();
    document().open(path);
    QVERIFY(complete());
    Moment again = m_window->moment().present();
    QCOMPARE(again.step->position, kept.step->position);
    QCOMPARE(again.pixel, kept.pixel);
    QCOMPARE(again.zoom, kept.zoom);
    QCOMPARE(again.panels, kept.panels);
    QCOMPARE(again.overlays, kept.overlays);
    QVERIFY(!document().isDirty());
}

void TestStage::oldSessionsLeaveTheViewAlone()
{
    const QString path = m_folder.filePath(QStringLiteral("old.json"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("{\"rasterlens\": 1, \"scene\": \"builtin:square-diagonal\", \"settings\": {\"culling\": \"none\"}}");
    file.close();
    QVERIFY(open(QStringLiteral("builtin:cube")));
    m_window->truthMode().showPanel(QStringLiteral("cases"));
    QVERIFY(complete());
    document().open(path);
    QVERIFY(complete());
    QVERIFY(m_window->moment().present().panels.contains(QStringLiteral("cases")));
    QVERIFY(viewport().isFitted());
    QCOMPARE(m_window->message(), QString());
    QFile wrong(m_folder.filePath(QStringLiteral("wrong.json")));
    QVERIFY(wrong.open(QIODevice::WriteOnly));
    wrong.write("{\"rasterlens\": 1, \"scene\": \"builtin:cube\", \"settings\": {}, \"step\": \"nowhere\"}");
    wrong.close();
    document().open(wrong.fileName());
    QVERIFY(complete());
    QVERIFY2(m_window->message().contains(QStringLiteral("\"step\" takes")), qPrintable(m_window->message()));
    QCOMPARE(document().scene()->id, QStringLiteral("builtin:cube"));
}

void TestStage::rOffersASmallPicture()
{
    QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
    key(Qt::Key_R);
    QVERIFY(complete());
    QCOMPARE(m_window->message(), QString());
    key(Qt::Key_R);
    QVERIFY(open(QStringLiteral("builtin:cube")));
    QVERIFY(change([](Settings& s) { s.size = {320, 240}; }));
    key(Qt::Key_R);
    QVERIFY(complete());
    QVERIFY(m_window->message().contains(QStringLiteral("320 x 240")));
    auto* button = m_window->findChild<QPushButton*>(QStringLiteral("recordSmall"));
    QVERIFY(button);
    button->click();
    QVERIFY(complete());
    QCOMPARE(settings().size, QSize(64, 48));
    QVERIFY(m_window->stepMode().session().isOpen());
}

void TestStage::theFirstStartOpensTheFirstLesson()
{
    QSettings().clear();
    m_window->openAtStart();
    QVERIFY(complete());
    QCOMPARE(m_window->lessons().player().lesson().id, QStringLiteral("first-minute"));
    QCOMPARE(settings().size, QSize(16, 12));
    QVERIFY(m_window->stepMode().session().event()->has(StepEvent::kTie));
    QVERIFY(!document().canUndo()); // to a window without a scene
    const std::size_t before = m_window->stepMode().session().position();
    key(Qt::Key_Right);
    QCOMPARE(m_window->stepMode().session().position(), before + 1);
    closeWindow();
    openWindow();
    m_window->openAtStart();
    QVERIFY(complete());
    QVERIFY(!m_window->lessons().player().isOpen());
}

/// Beside a lesson and the statistics, in either language, a comparison leaves the window narrow enough for two
/// columns.
void TestStage::aComparisonDoesNotWidenTheWindow()
{
    for (const LanguageKind language : {LanguageKind::English, LanguageKind::Chinese}) {
        m_window->setLanguage(language);
        m_window->resize(1000, 740);
        QVERIFY(m_window->lessons().open(QStringLiteral("perspective")));
        QVERIFY(complete());
        m_window->lessons().player().next();
        QVERIFY(complete());
        for (const bool onStage : {false, true, false}) {
            m_window->setPresentation(onStage);
            QTest::qWait(100);
            QVERIFY(complete());
            QVERIFY2(m_window->minimumSizeHint().width() < 900,
                     qPrintable(QString::number(m_window->minimumSizeHint().width())));
            m_window->lessons().player().next();
            QVERIFY(complete());
        }
    }
}

/// What the circles say is told once: on a narrow stage on the canvas, on a wide one beside the code.
void TestStage::theLegendIsInSight()
{
    QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
    const auto* beside = m_window->findChild<QWidget*>(QStringLiteral("lensLegend"));
    const StepListing& listing = m_window->stepMode().listing();
    for (const QSize size : {QSize(1024, 768), QSize(1920, 1080)})
        for (const auto& [id, slide] : {std::pair("first-minute", 0), std::pair("top-left", 1)}) {
            QVERIFY(openStage(size));
            QVERIFY(m_window->lessons().open(QLatin1String(id)));
            m_window->lessons().player().goTo(std::size_t(slide), LessonPlayer::Entry::Skips);
            QVERIFY(complete());
            QTest::qWait(50);
            const bool isBeside = size.width() > 1200;
            QCOMPARE(beside->isVisible(), isBeside);
            QCOMPARE(m_window->stepMode().lens().legendPlate().isEmpty(), isBeside);
            QVERIFY(!isBeside || listing.rect().contains(beside->geometry()));
            for (const QLabel* label : listing.findChildren<QLabel*>())
                QVERIFY(!isBeside || !label->geometry().intersects(beside->geometry()));
        }
    m_window->stepMode().session().close();
    QVERIFY(complete() && !beside->isVisible());
}

void TestStage::theCountersAreInSight_data()
{
    QTest::addColumn<QSize>("size");
    QTest::newRow("1024x768") << QSize(1024, 768);
    QTest::newRow("1280x800") << QSize(1280, 800);
}

/// Frames a second, clipped and culled faces, whole, in both languages; the panel is out of sight.
void TestStage::theCountersAreInSight()
{
    QFETCH(const QSize, size);
    QVERIFY(open(QStringLiteral("builtin:cube")));
    QVERIFY(openStage(size));
    auto* counters = m_window->findChild<QLabel*>(QStringLiteral("counters"));
    for (const auto& [language, words] :
         {std::pair(LanguageKind::English, QStringList{"FPS", "clipped", "culled"}),
          std::pair(LanguageKind::Chinese, QStringList{"FPS", QStringLiteral("\u88c1\u526a")})}) {
        m_window->setLanguage(language);
        QVERIFY(complete());
        QTest::qWait(50);
        QVERIFY(counters->isVisible());
        for (const QString& word : words)
            QVERIFY2(counters->text().contains(word), qPrintable(counters->text()));
        QVERIFY(counters->width() >= counters->sizeHint().width());
        const QRect place(counters->mapTo(m_window.get(), QPoint(0, 0)), counters->size());
        QVERIFY(m_window->rect().contains(place));
    }
    m_window->setPresentation(false);
    QVERIFY(m_window->statusBar()->isAncestorOf(counters));
}

QTEST_MAIN(TestStage)
#include "test_stage.moc"
