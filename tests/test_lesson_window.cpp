// Lessons in the window: every part of a slide is shown, questions are answered before their picture, Undo goes back by
// whole slides, and what is wrong with a file is told with its line.
#include "core/lessons/lesson.h"
#include "core/observe/step_log.h"
#include "ui/face/cards.h"
#include "ui/face/clip_theatre.h"
#include "ui/face/pixel_card.h"
#include "ui/lessons/lesson_mode.h"
#include "ui/lessons/lesson_panel.h"
#include "ui/lessons/question_box.h"
#include "ui/pipeline/canvas_views.h"
#include "ui/pipeline/mistake_badge.h"
#include "ui/steps/step_listing.h"
#include "ui/truth/truth_mode.h"
#include "ui/window/panel_places.h"
#include "ui/window/readout_bar.h"
#include "ui/window/window_moment.h"
#include "window_fixture.h"

#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMimeData>
#include <QPushButton>
#include <QToolButton>

using namespace rasterlens;
using namespace rasterlens::test;

class TestLessonWindow : public WindowFixture
{
    Q_OBJECT

private Q_SLOTS:
    void everySlideIsShownAsAWhole_data();
    void everySlideIsShownAsAWhole();
    void momentsAreReadAsTheyAreShown();
    void pixelsAreClicked();
    void answersAreTypedAndChosen();
    void nothingIsToldOfThePixelsThatAreAsked();
    void theMistakeThatIsAskedIsNotNamed();
    void theLensKeepsWhatIsAsked();
    void noSampleThatWaitsTellsANumberToCome_data();
    void noSampleThatWaitsTellsANumberToCome();
    void theCardKeepsWhatIsAsked();
    void theTheatreTellsNoLaterPlane();
    void countedPixelsAreNotWipedAway();
    void emptyPicturesOfSlidesNeedNoRemark();
    void digitsAreAskedFor();
    void theButtonsStayWhereTheyAre_data();
    void theButtonsStayWhereTheyAre();
    void skippedQuestionsAreNotCounted();
    void undoGoesBackBySlides();
    void whatIsTriedOutIsLeft();
    void levelsAndContents();
    void answersAreKeptOnRequest();
    void ownFilesAreOpenedAndChecked();
    void textsFollowTheLanguage();

private:
    LessonMode& lessons() { return m_window->lessons(); }
    LessonPlayer& player() { return lessons().player(); }
    LessonPanel& panel() { return lessons().panel(); }
    QuestionBox& question() { return panel().question(); }

    QString title() { return panel().findChild<QLabel*>(QStringLiteral("title"))->text(); }

    /// Opens a lesson at a slide, counted from 1.
    bool openAt(const QString& name, std::size_t number, LessonPlayer::Entry entry)
    {
        if (!lessons().open(name))
            return false;
        player().goTo(number - 1, entry);
        return complete();
    }

    void press(Qt::Key which)
    {
        key(which);
        QVERIFY(complete());
    }

    void click(QPoint pixel)
    {
        const QPointF at = viewport().transform().toCanvas(QRectF(pixel, QSizeF(1, 1))).center();
        QTest::mouseClick(&viewport(), Qt::LeftButton, Qt::NoModifier, at.toPoint());
    }

    QString write(const char* name, const QByteArray& text)
    {
        QFile file(m_folder.filePath(QLatin1String(name)));
        if (file.open(QIODevice::WriteOnly))
            file.write(text);
        return file.fileName();
    }

    void compareWithSlide(const Moment& moment);
};

/// The parts of the window agree with the moment, which is opened once more to tell its settings and its step.
void TestLessonWindow::compareWithSlide(const Moment& moment)
{
    const OpenMomentLoad load = openMoment(moment);
    QVERIFY(load.moment);
    QCOMPARE(document().scene()->id, moment.scene);
    QVERIFY(settings() == load.moment->settings);
    StepSession& session = m_window->stepMode().session();
    QCOMPARE(session.isOpen(), moment.step.has_value());
    if (moment.step)
        QCOMPARE(session.position(), *positionOf(*moment.step, session.record()));
    QCOMPARE(viewport().selectedPixel(), moment.pixel);
    Comparison& comparison = m_window->truthMode().comparison();
    QCOMPARE(static_cast<int>(comparison.view()), static_cast<int>(moment.compare.view));
    if (comparison.view() != CompareView::Off)
        QVERIFY(comparison.other(settings()) == load.moment->other);
    QCOMPARE(m_window->truthMode().referee().isOn(), moment.overlays.contains(QStringLiteral("referee")));
    const QStringList open = m_window->moment().present().panels;
    for (const QString& name : moment.panels)
        QVERIFY2(open.contains(name), qPrintable(name));
    QCOMPARE(open.size() - (open.contains(QStringLiteral("why")) ? 1 : 0),
             moment.panels.size() - (moment.panels.contains(QStringLiteral("why")) ? 1 : 0));
    if (moment.centre)
        QCOMPARE(viewport().transform().zoom, *moment.zoom);
    else if (!viewport().isFitted())
        QVERIFY(moment.pixel && moment.zoom);
}

void TestLessonWindow::everySlideIsShownAsAWhole_data()
{
    QTest::addColumn<QString>("id");
    for (const char* id : {"bresenham", "top-left", "perspective", "sutherland-hodgman", "incremental"})
        QTest::newRow(id) << QString::fromLatin1(id);
}

void TestLessonWindow::everySlideIsShownAsAWhole()
{
    QFETCH(QString, id);
    player().setLevel(2);
    QVERIFY(lessons().open(id));
    QVERIFY(complete());
    const Lesson lesson = *loadLesson(id).lesson;
    for (std::size_t i = 0; i < lesson.slides.size(); ++i) {
        QCOMPARE(player().place().slide, i);
        const Slide& slide = lesson.slides[i];
        if (slide.question) {
            QVERIFY(player().isAsking());
            QCOMPARE(panel().text(), slide.question->text.en);
            compareWithSlide(slide.before ? *slide.before : lesson.slides[i - 1].moment);
            press(Qt::Key_PageDown);
        }
        QVERIFY(!player().isAsking());
        QCOMPARE(panel().text(), textWithNumbers(slide.moment.caption, slide).en);
        compareWithSlide(slide.moment);
        press(Qt::Key_PageDown);
    }
    QCOMPARE(player().place().phase, LessonPlayer::Phase::Ended);
    press(Qt::Key_PageUp);
    QCOMPARE(player().place().slide, lesson.slides.size() - 1);
    compareWithSlide(lesson.slides.back().moment);
}

void TestLessonWindow::momentsAreReadAsTheyAreShown()
{
    QVERIFY(openAt(QStringLiteral("incremental"), 8, LessonPlayer::Entry::Skips));
    const Moment first = m_window->moment().present();
    QCOMPARE(*first.zoom, 48.0);
    QVERIFY(openAt(QStringLiteral("top-left"), 2, LessonPlayer::Entry::Skips));
    viewport().selectPixel(QPoint(2, 3));
    viewport().showAround({3.5, 4.25}, 64); // larger than all of the picture: a slide does not fall short of that
    m_window->actionTable().action("view.samples")->trigger();
    const Moment second = m_window->moment().present();
    QCOMPARE(*second.pixel, QPoint(2, 3));
    QVERIFY(second.step && second.overlays.contains(QStringLiteral("grid")));
    QVERIFY(!second.overlays.contains(QStringLiteral("samples")));
    for (const QString& name : CanvasViews::overlayNames())
        QVERIFY(std::ranges::any_of(overlayIds(), [&](const char* id) { return name == QLatin1String(id); }));
    for (const Moment& moment : {first, second}) {
        m_window->moment().show(moment, Document::GivingUp::Silent);
        QVERIFY(complete());
        Moment again = m_window->moment().present();
        QVERIFY(std::abs(again.centre->x() - moment.centre->x()) < 0.5);
        again.centre = moment.centre; // the canvas moves by whole pixels
        QVERIFY(again == moment);
    }
}

void TestLessonWindow::pixelsAreClicked()
{
    QVERIFY(openAt(QStringLiteral("top-left"), 3, LessonPlayer::Entry::Asks));
    QVERIFY(player().isAsking() && question().asksForPixels());
    const QImage before = picture();
    for (int i = 0; i < 8; ++i)
        click({7 - i, i});
    click({0, 0});
    click({0, 0}); // and its mark is gone again
    QCOMPARE(question().marked().size(), std::size_t(8));
    question().check();
    QVERIFY(complete());
    QVERIFY(!player().isAsking());
    QVERIFY(player().answered(2)->isRight);
    QVERIFY(panel().verdict().startsWith(QStringLiteral("\u2713")));
    QCOMPARE(player().score().right, 1);

    QVERIFY(openAt(QStringLiteral("top-left"), 6, LessonPlayer::Entry::Asks));
    click({0, 7});
    click({1, 1});
    question().check();
    QVERIFY(complete());
    QVERIFY(player().isAsking()); // a second try
    QVERIFY2(panel().verdict().startsWith(QStringLiteral("\u2717 1 of 8 found, 1 too many. One more try")),
             qPrintable(panel().verdict()));
    QCOMPARE(question().marked().size(), std::size_t(2)); // to be mended
    question().check();
    QVERIFY(complete());
    QVERIFY(!player().answered(5)->isRight);
    QCOMPARE(panel().verdict(), QStringLiteral("\u2717 1 of 8 found, 1 too many"));
    QVERIFY(picture() != before);
}

void TestLessonWindow::answersAreTypedAndChosen()
{
    const auto formula = [this] { return m_window->stepMode().listing().formulaRows().join(QLatin1Char('\n')); };
    QVERIFY(openAt(QStringLiteral("bresenham"), 2, LessonPlayer::Entry::Skips));
    QVERIFY2(formula().contains(QStringLiteral("p_0 = ")) && !formula().contains(QStringLiteral("p_1 = ")),
             qPrintable(formula())); // which the next slide asks for
    QVERIFY(openAt(QStringLiteral("bresenham"), 3, LessonPlayer::Entry::Asks));
    QVERIFY(!formula().contains(QStringLiteral("p_1 = ")));
    QVERIFY(question().field().isVisible());
    QTest::keyClicks(&question().field(), QStringLiteral("8"));
    QTest::keyClick(&question().field(), Qt::Key_Return);
    QVERIFY(complete());
    QVERIFY(player().answered(2)->isRight);
    press(Qt::Key_PageDown);
    QTest::keyClicks(&question().field(), QStringLiteral("6"));
    question().check();
    QVERIFY(complete());
    QVERIFY(player().isAsking() && !panel().verdict().contains(QStringLiteral("\u22126")));
    QTest::keyClicks(&question().field(), QStringLiteral("22")); // in place of the former
    QCOMPARE(question().field().text(), QStringLiteral("22"));
    question().check();
    QVERIFY(complete());
    QVERIFY(!player().answered(3)->isRight);
    QVERIFY(panel().verdict().contains(QStringLiteral("\u22126")));
    press(Qt::Key_PageDown);
    QCOMPARE(question().choiceButtons().size(), std::size_t(2));
    question().choiceButtons()[0]->click();
    QVERIFY(complete());
    QVERIFY(player().answered(4)->isRight);
    QCOMPARE(player().score().right, 2);
    QCOMPARE(player().score().answered, 3);
}

void TestLessonWindow::nothingIsToldOfThePixelsThatAreAsked()
{
    QVERIFY(openAt(QStringLiteral("top-left"), 3, LessonPlayer::Entry::Asks));
    const auto selected = viewport().selectedPixel();
    QTest::mouseMove(&viewport(), viewport().transform().toCanvas(QRectF(3, 4, 1, 1)).center().toPoint());
    click({3, 4});
    QVERIFY(complete());
    QCOMPARE(question().marked(), std::vector<QPoint>{QPoint(3, 4)});
    QCOMPARE(viewport().selectedPixel(), selected); // no card, no outline
    QVERIFY(!viewport().overlays().tells);
    QCOMPARE(m_window->findChild<ReadoutBar*>()->text(), QStringLiteral("pixel (3, 4)"));
    QTest::keyClick(&viewport(), Qt::Key_Right); // by keys as well
    press(Qt::Key_Insert);
    QCOMPARE(question().marked().size(), std::size_t(2));
    press(Qt::Key_PageDown);
    click({3, 4});
    QCOMPARE(viewport().selectedPixel(), std::optional(QPoint(3, 4)));
}

void TestLessonWindow::theMistakeThatIsAskedIsNotNamed()
{
    QVERIFY(openAt(QStringLiteral("top-left"), 10, LessonPlayer::Entry::Asks));
    auto* badge = m_window->findChild<MistakeBadge*>();
    QVERIFY(settings().mistakes.contains(QStringLiteral("either-sign")));
    QVERIFY(badge->isHidden());
    QCOMPARE(question().choiceButtons().size(), std::size_t(3));
    const View view = settings().view;
    press(Qt::Key_4); // there is no such choice
    press(Qt::Key_1); // chooses, and turns no camera
    QVERIFY(complete());
    QCOMPARE(settings().view, view);
    QVERIFY(player().isAsking() && badge->isHidden());
    QVERIFY(!question().choiceButtons()[0]->isEnabled());
    question().choiceButtons()[2]->click();
    QVERIFY(complete());
    QVERIFY(player().answered(9)->isRight);
    QVERIFY(!badge->isHidden());
}

/// Signs and numbers of samples that had their turn stay, but for the pixel that the question is about.
void TestLessonWindow::theLensKeepsWhatIsAsked()
{
    const auto cell = [this](int x, int y) { return m_window->stepMode().lens().model()->cell(x, y); };
    QVERIFY(openAt(QStringLiteral("edge-equation"), 4, LessonPlayer::Entry::Asks)); // of (3, 3), which is tested
    QCOMPARE(player().askedPixel(), std::optional(QPoint(3, 3)));
    QVERIFY(!cell(3, 3).hasValues);
    QVERIFY(cell(3, 3).state == LensCell::State::Waiting);
    QVERIFY(cell(4, 3).hasValues);
    QVERIFY(!cell(9, 8).hasValues); // is yet to come
    press(Qt::Key_PageDown);
    QVERIFY(cell(3, 3).hasValues && cell(9, 8).hasValues);
    QCOMPARE(cell(3, 3).values[2], -19.0 * m_window->stepMode().lens().model()->triangle().setup.unitsPerArea);

    QVERIFY(openAt(QStringLiteral("incremental"), 3, LessonPlayer::Entry::Asks)); // of the third sample
    QVERIFY(cell(3, 1).hasValues && !cell(4, 1).hasValues);
    QVERIFY(lensHoverLines(*m_window->stepMode().lens().model(), 4, 1).isEmpty());
    press(Qt::Key_PageDown);
    QVERIFY(cell(4, 1).hasValues && cell(9, 8).hasValues);
    press(Qt::Key_PageUp); // who was asked may look
    QVERIFY(cell(4, 1).hasValues);
}

void TestLessonWindow::noSampleThatWaitsTellsANumberToCome_data()
{
    QTest::addColumn<QString>("id");
    for (const QString& id : lessonIds())
        QTest::newRow(qPrintable(id)) << id;
}

/// The number that a question asks for stands at no sample before its turn, on the slides before and while it is open.
void TestLessonWindow::noSampleThatWaitsTellsANumberToCome()
{
    QFETCH(QString, id);
    QVERIFY(lessons().open(id));
    const std::vector<Slide>& slides = player().lesson().slides;
    player().setLevel(2);
    const auto compare = [&](std::size_t at, std::size_t asking) {
        const QString fact = slides[asking].question->answer->text;
        const auto answer = std::ranges::find(slides[asking].expected, fact, &Expected::text);
        const LensModel* model = m_window->stepMode().lens().model();
        if (answer == slides[asking].expected.end() || !model || !model->hasSetup())
            return;
        const StepSetup& setup = model->triangle().setup;
        for (int y = setup.bounds.y; y < setup.bounds.y + setup.bounds.height; ++y)
            for (int x = setup.bounds.x; x < setup.bounds.x + setup.bounds.width; ++x) {
                const LensCell cell = model->cell(x, y);
                const double value = cell.values[std::size_t(cell.deciding)] / setup.unitsPerArea;
                const bool tells = cell.hasValues && cell.state == LensCell::State::Waiting;
                QVERIFY2(
                    !tells || value != answer->is.toDouble(),
                    qPrintable(QStringLiteral("slide %1 tells %2 of slide %3").arg(at + 1).arg(fact).arg(asking + 1)));
            }
    };
    for (std::size_t asking = 0; asking < slides.size(); ++asking) {
        const std::optional<Question>& question = slides[asking].question;
        for (std::size_t at = 0; question && question->kind == QuestionKind::Number && at <= asking; ++at) {
            if (slides[at].moment.scene != slides[asking].moment.scene)
                continue;
            player().goTo(at, LessonPlayer::Entry::Asks);
            QVERIFY(complete());
            compare(at, asking);
        }
    }
}

void TestLessonWindow::theCardKeepsWhatIsAsked()
{
    QVERIFY(openAt(QStringLiteral("first-minute"), 3, LessonPlayer::Entry::Asks));
    QVERIFY(m_window->cards().show(QStringLiteral("why")));
    QVERIFY(complete());
    QCOMPARE(viewport().selectedPixel(), std::optional(QPoint(4, 5)));
    QVERIFY(!m_window->cards().pixelCard().report());
    QCOMPARE(m_window->findChild<ReadoutBar*>()->text(), QStringLiteral("pixel (4, 5)"));
    press(Qt::Key_PageDown);
    QVERIFY(m_window->cards().pixelCard().report());
}

void TestLessonWindow::theTheatreTellsNoLaterPlane()
{
    QVERIFY(openAt(QStringLiteral("sutherland-hodgman"), 2, LessonPlayer::Entry::Skips));
    ClipTheatre& theatre = m_window->cards().clipTheatre();
    QCOMPARE(theatre.summary(), QStringLiteral("3 \u2192 4 \u2192 \u2026 corners"));
    const auto tells = [&](ClipPlane plane) { return theatre.planeButton(plane)->text().back().isDigit(); };
    QVERIFY(tells(ClipPlane::Right) && !tells(ClipPlane::Left));
    theatre.planeButton(ClipPlane::Left)->click(); // who wants to know finds it
    QCOMPARE(theatre.summary(), QStringLiteral("3 \u2192 4 \u2192 5 \u2192 \u2026 corners"));
    QVERIFY(tells(ClipPlane::Left));
    player().goTo(5, LessonPlayer::Entry::Skips); // the end of the record
    QVERIFY(complete());
    QVERIFY2(theatre.summary().endsWith(QStringLiteral("6 corners, a fan of 4")), qPrintable(theatre.summary()));
}

/// Where single pixels are seen the whole picture is that with the mistake.
void TestLessonWindow::countedPixelsAreNotWipedAway()
{
    QVERIFY(openAt(QStringLiteral("top-left"), 6, LessonPlayer::Entry::Skips));
    QCOMPARE(viewport().overlays().wipe->at, 0.0);
    QVERIFY(openAt(QStringLiteral("perspective"), 2, LessonPlayer::Entry::Skips));
    QCOMPARE(viewport().overlays().wipe->at, 0.1);
}

void TestLessonWindow::emptyPicturesOfSlidesNeedNoRemark()
{
    QVERIFY(openAt(QStringLiteral("z-buffer"), 6, LessonPlayer::Entry::Skips)); // nothing passes the depth test
    QCOMPARE(m_window->message(), QString());
    QVERIFY(change([](Settings& s) { s.shading = Shading::Flat; })); // is no slide any more
    QVERIFY2(m_window->message().contains(QStringLiteral("all 23,193 fragments")), qPrintable(m_window->message()));
    player().comeBack();
    QVERIFY(complete());
    QCOMPARE(m_window->message(), QString());
}

void TestLessonWindow::digitsAreAskedFor()
{
    QVERIFY(openAt(QStringLiteral("perspective"), 3, LessonPlayer::Entry::Asks));
    for (const char* text : {"0.3", "0.30"}) {
        question().field().setText(QLatin1String(text));
        question().check();
        QVERIFY(complete());
        QVERIFY(player().isAsking() && player().tries().empty());
        QVERIFY2(panel().verdict().startsWith(QStringLiteral("Right so far")), qPrintable(panel().verdict()));
    }
    question().field().setText(QStringLiteral("0.304"));
    question().check();
    QVERIFY(complete());
    QVERIFY(player().answered(2)->isRight);
}

void TestLessonWindow::theButtonsStayWhereTheyAre_data()
{
    QTest::addColumn<QString>("id");
    QTest::addColumn<bool>("onStage");
    for (const bool onStage : {false, true})
        QTest::addRow("%s", onStage ? "stage" : "window") << QStringLiteral("top-left") << onStage;
    QTest::newRow("panels") << QStringLiteral("sutherland-hodgman") << false;
}

/// From slide to slide and question to answer, whatever their texts and panels.
void TestLessonWindow::theButtonsStayWhereTheyAre()
{
    QFETCH(QString, id);
    QFETCH(bool, onStage);
    QVERIFY(lessons().open(id));
    m_window->setPresentation(onStage);
    QVERIFY(complete());
    const QToolButton* next = panel().findChildren<QToolButton*>(QStringLiteral("flat")).at(1);
    QCOMPARE(next->text(), QStringLiteral("\u25b6"));
    const auto place = [&] {
        QTest::qWait(20); // docks follow through the event loop
        return next->mapTo(m_window.get(), next->rect().center());
    };
    const QPoint first = place();
    for (int guard = 0; player().hasNext() && guard < 40; ++guard) {
        press(Qt::Key_PageDown);
        const QPoint now = place();
        QVERIFY2((now - first).manhattanLength() <= 1, qPrintable(QStringLiteral("slide %1: %2,%3 after %4,%5")
                                                                      .arg(player().place().slide + 1)
                                                                      .arg(now.x())
                                                                      .arg(now.y())
                                                                      .arg(first.x())
                                                                      .arg(first.y())));
    }
    QVERIFY2(player().place().phase == LessonPlayer::Phase::Ended,
             qPrintable(QString::number(player().place().slide + 1)));
}

void TestLessonWindow::skippedQuestionsAreNotCounted()
{
    QVERIFY(openAt(QStringLiteral("bresenham"), 3, LessonPlayer::Entry::Asks));
    press(Qt::Key_PageDown);
    QVERIFY(!player().isAsking());
    QCOMPARE(player().score().answered, 0);
    QVERIFY(player().answered(2) && !player().answered(2)->given);
    press(Qt::Key_PageUp); // a slide that is gone back to shows its picture
    QCOMPARE(player().place().slide, std::size_t(1));
}

void TestLessonWindow::undoGoesBackBySlides()
{
    QVERIFY(openAt(QStringLiteral("top-left"), 4, LessonPlayer::Entry::Skips));
    const Moment former = m_window->moment().present();
    player().goTo(8, LessonPlayer::Entry::Skips); // another scene
    QVERIFY(complete());
    QCOMPARE(document().scene()->id, QStringLiteral("builtin:two-windings"));
    QVERIFY(!document().isDirty());
    QVERIFY(change([](Settings& s) { s.culling = Culling::Front; }));
    document().undo();
    QVERIFY(complete());
    QCOMPARE(player().place().slide, std::size_t(8));
    document().undo();
    QVERIFY(complete());
    QCOMPARE(player().place().slide, std::size_t(3));
    QVERIFY(m_window->moment().present() == former);
    QVERIFY(!document().isDirty());
    document().redo();
    QVERIFY(complete());
    QCOMPARE(player().place().slide, std::size_t(8));
    QCOMPARE(document().scene()->id, QStringLiteral("builtin:two-windings"));
}

void TestLessonWindow::whatIsTriedOutIsLeft()
{
    QVERIFY(openAt(QStringLiteral("top-left"), 2, LessonPlayer::Entry::Skips));
    const Moment slide = m_window->moment().present();
    QVERIFY(!m_window->moment().isChanged());
    press(Qt::Key_Right);
    QVERIFY(m_window->moment().isChanged());
    QVERIFY(change([](Settings& s) { s.mistakes = {QStringLiteral("all-inclusive")}; }));
    QTest::keyClick(&viewport(), Qt::Key_PageUp, Qt::ControlModifier);
    QVERIFY(complete());
    QVERIFY(m_window->moment().present() == slide);
    QVERIFY(!m_window->moment().isChanged());
    QCOMPARE(player().place().slide, std::size_t(1));
    document().open(QStringLiteral("builtin:cube"));
    QVERIFY(complete());
    QVERIFY(m_window->moment().isChanged());
    player().comeBack();
    QVERIFY(complete());
    QVERIFY(m_window->moment().present() == slide);
}

void TestLessonWindow::levelsAndContents()
{
    QVERIFY(openAt(QStringLiteral("top-left"), 6, LessonPlayer::Entry::Skips));
    QCOMPARE(panel().contents().count(), 11);
    QVERIFY(panel().contents().item(4)->text().startsWith(QStringLiteral("5  ? If every edge"))); // not its answer
    press(Qt::Key_PageDown);
    QCOMPARE(player().place().slide, std::size_t(8)); // two for a second look between, which are told of
    QVERIFY(panel().leftOut().isVisible());
    QCOMPARE(panel().leftOut().text(), QStringLiteral("Second look: 7, 8"));
    panel().leftOut().click();
    QVERIFY(complete());
    QCOMPARE(player().place().slide, std::size_t(6));
    QVERIFY(panel().leftOut().isHidden());
    QVERIFY(m_window->actionTable().action("lesson.level")->isChecked());
    player().setLevel(2);
    player().goTo(5, LessonPlayer::Entry::Skips);
    QVERIFY(complete());
    press(Qt::Key_PageDown);
    QCOMPARE(player().place().slide, std::size_t(6));
    Q_EMIT panel().contents().itemClicked(panel().contents().item(0));
    QVERIFY(complete());
}

void TestLessonWindow::answersAreKeptOnRequest()
{
    QVERIFY(openAt(QStringLiteral("top-left"), 5, LessonPlayer::Entry::Asks));
    question().field().setText(QStringLiteral("7"));
    question().check();
    question().field().setText(QStringLiteral("9")); // the second try
    question().check();
    QVERIFY(complete());
    const QString path = m_folder.filePath(QStringLiteral("answers.csv"));
    QVERIFY(!QFile::exists(path));
    QVERIFY(lessons().keepAnswers(path));
    press(Qt::Key_PageDown);
    press(Qt::Key_PageDown); // skipped
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QList<QByteArray> lines = file.readAll().split('\n');
    QCOMPARE(lines.value(0), QByteArray("lesson,slide,kind,given,right,is_right"));
    QCOMPARE(lines.value(1), QByteArray("top-left,5,number,7,8,0"));
    QCOMPARE(lines.value(2), QByteArray("top-left,5,number,9,8,0"));
    QVERIFY(lines.value(3).startsWith("top-left,6,pixels,,\"(7, 0), (6, 1)"));
    QVERIFY(!lessons().keepAnswers(m_folder.filePath(QStringLiteral("nowhere/answers.csv"))));
    QVERIFY(m_window->message().contains(QStringLiteral("nowhere/answers.csv")));
}

void TestLessonWindow::ownFilesAreOpenedAndChecked()
{
    const QByteArray whole =
        "{\"rasterlens-lesson\": 1, \"id\": \"own\", \"title\": {\"en\": \"Own\", \"zh\": \"自己的\"},\n"
        "\"steps\": [{\"scene\": \"builtin:square-diagonal\",\n"
        "\"caption\": {\"en\": \"{covered} hits.\", \"zh\": \"{covered} 次。\"},\n"
        "\"expect\": {\"covered\": 64}}]}";
    m_window->open(write("own.json", whole));
    QVERIFY(complete());
    QVERIFY(waitFor([this] { return !lessons().isChecking(); }));
    QCOMPARE(m_window->message(), QString());
    QCOMPARE(panel().text(), QStringLiteral("64 hits."));
    QCOMPARE(title(), QStringLiteral("Own"));
    QVERIFY(document().recentFiles().first().endsWith(QStringLiteral("own.json")));

    m_window->open(write("broken.json", QByteArray(whole).replace("builtin:square-diagonal", "builtin:squair")));
    QVERIFY2(m_window->message().contains(QStringLiteral("broken.json:2: there is no scene \"builtin:squair\"")),
             qPrintable(m_window->message()));
    QCOMPARE(player().lesson().id, QStringLiteral("own")); // which stays

    m_window->open(write("wrong.json", QByteArray(whole).replace("64}", "63}")));
    QVERIFY(waitFor([this] { return m_window->message().contains(QStringLiteral("wrong.json:4: ")); }));
    QVERIFY(m_window->message().contains(QStringLiteral("\"covered\" is 64, not 63")));
    QVERIFY(complete());
}

void TestLessonWindow::textsFollowTheLanguage()
{
    QVERIFY(openAt(QStringLiteral("top-left"), 5, LessonPlayer::Entry::Asks));
    m_window->setLanguage(LanguageKind::Chinese);
    QCoreApplication::processEvents(); // the window hears of it through the event loop
    QVERIFY(complete());
    const Lesson lesson = *loadLesson(QStringLiteral("top-left")).lesson;
    QCOMPARE(panel().text(), lesson.slides[4].question->text.zh);
    QCOMPARE(title(), lesson.title.zh);
    QCOMPARE(m_window->actionTable().action("lesson.open-top-left")->text(), QStringLiteral("7  ") + lesson.title.zh);
}

QTEST_MAIN(TestLessonWindow)
#include "test_lesson_window.moc"
