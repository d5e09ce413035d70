// Lessons: every built-in one says what the program computes, and what is wrong with a file is told with its line.
#include "cli_support.h"
#include "core/lessons/lesson.h"
#include "core/render/steps.h"
#include "core/scenes/load_scene.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QRegularExpression>
#include <QTemporaryDir>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

const QString kFile = QStringLiteral("broken.json");

/// A lesson of one slide, which begins on line 5; the given lines are part of it and begin on line 6.
QByteArray lessonWith(const QByteArray& slide)
{
    return QByteArray("{\"rasterlens-lesson\": 1,\n\"id\": \"a\",\n\"title\": {\"en\": \"A\", \"zh\": \"甲\"},\n"
                      "\"steps\": [\n{\"scene\": \"builtin:square-diagonal\",\n") +
           slide + "\n\"caption\": {\"en\": \"One.\", \"zh\": \"一。\"}}\n]}\n";
}

QStringList textsOf(const Diagnostics& diagnostics)
{
    QStringList texts;
    for (const Diagnostic& diagnostic : diagnostics)
        texts << diagnostic.text();
    return texts;
}

/// What is wrong with a lesson: with its text, or else with what it says.
QStringList faultsOf(const QByteArray& text)
{
    const LessonLoad load = lessonFromJson(text, kFile);
    return textsOf(load.lesson ? checkSlides(*load.lesson) : load.diagnostics);
}

QString documentText() { return QString::fromUtf8(readFile(QStringLiteral(RASTERLENS_ROOT "/docs/LESSONS.md"))); }

bool hasChinese(const QString& text)
{
    return std::any_of(text.begin(), text.end(), [](QChar c) { return c.script() == QChar::Script_Han; });
}

} // namespace

class TestLessons : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void linesOfValuesAreFound();
    void stepPlacesAreRead_data();
    void stepPlacesAreRead();
    void stepPlacesAreFound();
    void momentsAreWrittenAsTheyAreRead();
    void factsAreComparedAsDocumented();
    void placesStayOnOneLine();
    void brokenFilesAreRefused_data();
    void brokenFilesAreRefused();
    void thereAreEnoughLessons();
    void builtinLessonsAreWhole_data();
    void builtinLessonsAreWhole();
    void questionsStandOverWhatTheyAskOf_data();
    void questionsStandOverWhatTheyAskOf();
    void builtinLessonsSayWhatIsComputed_data();
    void builtinLessonsSayWhatIsComputed();
    void aChangedNumberIsFound();
    void theDocumentedExampleIsRight();
    void everyFactIsDocumented();
    void commandLineListsAndShows();
    void commandLineChecks();
    void commandLineDrawsSlides();
};

void TestLessons::linesOfValuesAreFound()
{
    const JsonLines lines("{\"a\": 1,\n \"b\": [2,\n  {\"c\\n\": \"x,]\",\n   \"d\": {}}],\n \"b\": true}");
    QCOMPARE(lines.lineOf({}), 1);
    QCOMPARE(lines.lineOf("a"), 1);
    QCOMPARE(lines.lineOf("b/1"), 3);
    QCOMPARE(lines.lineOf("b/1/c\n"), 3);
    QCOMPARE(lines.lineOf("b/1/d"), 4);
    QCOMPARE(lines.lineOf("b/1/d/missing/deep"), 4);
    QCOMPARE(lines.lineOf("missing"), 1);
    QCOMPARE(lines.repeated().value("b"), 5);
    QCOMPARE(lines.repeated().size(), 1);
}

void TestLessons::stepPlacesAreRead_data()
{
    QTest::addColumn<bool>("isPlace");
    for (const char* text : {"0", "12", "tie", "sign-change", "depth-fail", "clip", "nan", "end", "face 1", "sample",
                             "face 1 sample 3,4", "face 0 clip-plane #2", "face 1 tie", "3,4", "sample #7"})
        QTest::newRow(text) << true;
    for (const char* text : {"", "-1", "face", "face x", "ties", "sample 3", "sample 3,4,5", "#0", "sample #", "end 3",
                             "sample face 1", "1.5"})
        QTest::newRow(text) << false;
}

void TestLessons::stepPlacesAreRead()
{
    QFETCH(bool, isPlace);
    const QString text = QString::fromLatin1(QTest::currentDataTag());
    const auto place = stepPlaceFromText(text);
    QCOMPARE(place.has_value(), isPlace);
    if (place)
        QCOMPARE(textOf(*place), text);
}

void TestLessons::stepPlacesAreFound()
{
    const Scene scene = *loadScene("builtin:square-diagonal").scene;
    const auto log = renderSteps(scene, scene.defaults);
    const auto at = [&](const char* text) { return positionOf(*stepPlaceFromText(QString::fromLatin1(text)), *log); };
    QCOMPARE(*at("end"), log->size());
    QCOMPARE(*at("17"), std::size_t(17));
    QVERIFY(!at("100000"));
    QCOMPARE(*at("tie"), *log->findStop(0, StepDirection::Forward, {StepStop::Kind::Tie}) + 1);
    const StepEvent& sample = log->event(*at("face 1 sample 3,4") - 1);
    QCOMPARE(sample.kind, StepKind::Sample);
    QCOMPARE(sample.face, 1U);
    QCOMPARE(QPoint(sample.x, sample.y), QPoint(3, 4));
    QCOMPARE(*at("sample #2"), std::size_t(log->eventsOf(StepKind::Sample)[1]) + 1);
    QVERIFY(log->event(*at("face 1 tie") - 1).has(StepEvent::kTie));
    QVERIFY(!at("depth-fail"));
    QVERIFY(!at("face 7"));
    QVERIFY(!at("face 0 sample 3,4 #2"));
}

void TestLessons::momentsAreWrittenAsTheyAreRead()
{
    const QByteArray text =
        lessonWith("\"size\": \"16x12\", \"settings\": {\"mistakes\": [\"affine\"]},\n"
                   "\"view\": {\"fov\": 60}, \"step\": \"face 1 tie\", \"pixel\": [3, 4],\n"
                   "\"zoom\": 48, \"centre\": [4, 4.5], \"panels\": [\"why\"],\n"
                   "\"overlay\": [\"grid\"], \"compare\": {\"view\": \"wipe\", \"with\": \"scene\"},");
    const LessonLoad load = lessonFromJson(text, kFile);
    QCOMPARE(textsOf(load.diagnostics), QStringList());
    const Moment moment = load.lesson->slides[0].moment;
    QCOMPARE(*moment.size, QSize(16, 12));
    QCOMPARE(*moment.pixel, QPoint(3, 4));
    QVERIFY(moment.compare.view == MomentCompare::View::Wipe && moment.compare.with == MomentCompare::With::Scene);
    QCOMPARE(moment.step->face, std::optional(1U));
    QJsonObject again{{"rasterlens-lesson", 1}, {"id", "a"}, {"title", QJsonObject{{"en", "A"}, {"zh", "甲"}}}};
    again["steps"] = QJsonArray{toJson(moment, QDir())};
    const LessonLoad reread = lessonFromJson(QJsonDocument(again).toJson(), kFile);
    QCOMPARE(textsOf(reread.diagnostics), QStringList());
    QVERIFY(reread.lesson->slides[0].moment == moment);
}

void TestLessons::factsAreComparedAsDocumented()
{
    QVERIFY(agrees(8.0, 8));
    QVERIFY(!agrees(8.0001, 8));
    QVERIFY(agrees(0.89380198, 0.8938));
    QVERIFY(!agrees(0.8943, 0.8938));
    QVERIFY(agrees(QString("written"), "written"));
    QVERIFY(!agrees(QString("8"), 8));
    const std::vector<QPoint> pixels{{3, 4}, {2, 5}};
    QVERIFY(agrees(pixels, QJsonArray{QJsonArray{2, 5}, QJsonArray{3, 4}}));
    QVERIFY(!agrees(pixels, QJsonArray{QJsonArray{3, 4}}));
    QCOMPARE(factText(1327244), QStringLiteral("1,327,244"));
}

void TestLessons::placesStayOnOneLine()
{
    QCOMPARE(unbroken(QStringLiteral("at (3, 4), (\u22121.5, {x A 0}) and (one, two)")),
             QStringLiteral("at (3,\u00a04), (\u22121.5,\u00a0{x A 0}) and (one, two)"));
    QCOMPARE(unbroken(QStringLiteral("p starts at 2 dx \u2212 dy = \u22121, if y < 3; alpha = {alpha} of it")),
             QStringLiteral("p starts at 2\u00a0dx\u00a0\u2212\u00a0dy\u00a0=\u00a0\u22121, if y\u00a0<\u00a03; "
                            "alpha\u00a0=\u00a0{alpha} of it"));
    const TwoTexts pixels = factInWords(std::vector<QPoint>{{7, 0}, {6, 1}});
    QCOMPARE(pixels.en, QStringLiteral("(7,\u00a00), (6,\u00a01)"));
    QCOMPARE(pixels.zh, QStringLiteral("(7,\u00a00)\u3001(6,\u00a01)"));
    QCOMPARE(factInWords(0.303880728).en, QStringLiteral("0.3039"));
    QCOMPARE(factInWords(11948.0).en, QStringLiteral("11,948"));
    QCOMPARE(factInWords(QString("rejected")).zh, QStringLiteral("丢弃"));
    const Lesson lesson = *loadLesson(QStringLiteral("top-left")).lesson;
    const Slide& slide = lesson.slides[2];
    QVERIFY(textWithNumbers(slide.moment.caption, slide).zh.contains(pixels.zh));
}

void TestLessons::brokenFilesAreRefused_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("fault");
    const auto slide = [](const char* name, const QByteArray& lines, const char* fault) {
        QTest::newRow(name) << lessonWith(lines) << QString::fromUtf8(fault);
    };
    QTest::newRow("no JSON") << QByteArray("{\"rasterlens-lesson\": 1,\n\"id\" \"a\"}")
                             << "broken.json:2: broken JSON: ";
    QTest::newRow("an array") << QByteArray("[1]") << "broken.json:1: broken JSON: {\"rasterlens-lesson\": 1, ..}";
    QTest::newRow("version") << lessonWith("").replace("lesson\": 1", "lesson\": 2")
                             << "broken.json:1: \"rasterlens-lesson\" takes 1";
    QTest::newRow("no title") << lessonWith("").replace("\"title\"", "\"titel\"")
                              << "broken.json:3: there is no key \"titel\" here";
    QTest::newRow("no Chinese") << lessonWith("").replace(", \"zh\": \"一。\"", "")
                                << "broken.json:7: \"zh\" is missing; it takes a text";
    QTest::newRow("no steps") << QByteArray("{\"rasterlens-lesson\": 1, \"id\": \"a\",\n\"title\": {\"en\": \"A\", "
                                            "\"zh\": \"甲\"},\n\"steps\": []}")
                              << "broken.json:3: \"steps\" takes a list of objects";
    QTest::newRow("scene") << lessonWith("").replace("square-diagonal", "square-diagnoal")
                           << "broken.json:5: there is no scene \"builtin:square-diagnoal\"";
    slide("key", "\"panel\": [\"why\"],", "broken.json:6: there is no key \"panel\" here; expected: scene, size, ");
    slide("key twice", "\"zoom\": 4,\n\"zoom\": 8,", "broken.json:7: \"zoom\" stands twice in one object");
    slide("size", "\"size\": \"16\",", "broken.json:6: \"size\" takes \"WIDTHxHEIGHT\" with 1 to 16384 each");
    slide("setting", "\"settings\": {\n\"cullling\": \"back\"},", "broken.json:7: there is no setting \"cullling\"");
    slide("value", "\"settings\": {\n\n\"culling\": \"bakc\"},", "broken.json:8: ");
    slide("size in settings", "\"settings\": {\"size\": \"8x8\"},",
          "broken.json:6: \"size\" stands beside \"settings\", not in it");
    slide("mistake", "\"settings\": {\n\"mistakes\": [\"affin\"]},", "broken.json:7: there is no mistake \"affin\"");
    slide("view", "\"view\": {\n\"fov\": 200},", "broken.json:7: ");
    slide("step", "\"step\": \"first\",", "broken.json:6: \"step\" takes a number, tie, ");
    slide("pixel", "\"pixel\": \"3,4\",", "broken.json:6: \"pixel\" takes a pixel: [x, y]");
    slide("half a pixel", "\"pixel\": [3, 4.5],", "broken.json:6: \"pixel\" takes a pixel: [x, y]");
    slide("pixel outside", "\"pixel\": [3, 8],", "broken.json:5: slide 1: pixel 3,8 lies outside the picture");
    slide("zoom", "\"zoom\": \"4x\",", "broken.json:6: \"zoom\" takes a number from 1/64 to 128");
    slide("panel", "\"panels\": [\"wy\"],", "broken.json:6: \"panels\" knows no \"wy\"; expected: why, ");
    slide("panels", "\"panels\": \"why\",", "broken.json:6: \"panels\" takes a list of texts");
    slide("overlay", "\"overlay\": [\"gird\"],", "broken.json:6: \"overlay\" knows no \"gird\"; expected: grid, ");
    slide("compare", "\"compare\": {\"view\": \"side\"},",
          "broken.json:6: \"view\" takes off, wipe, blink, difference");
    slide("level", "\"level\": 3,", "broken.json:6: \"level\" takes 1 (first course) or 2 (second look)");
    slide("fact", "\"expect\": {\n\"holse\": 1},", "broken.json:7: there is no fact \"holse\"; ");
    slide("fact's pixel", "\"expect\": {\n\"winner 3\": 1},", "broken.json:7: the fact \"winner\" takes: winner X,Y");
    slide("fact's value", "\"expect\": {\"holes\": true},",
          "broken.json:6: \"holes\" takes a number, a text or a list");
    slide("false", "\"expect\": {\"holes\": 0,\n\"covered\": 63},",
          "broken.json:7: slide 1: \"covered\" is 64, not 63");
    slide("no such step", "\"step\": \"depth-fail\",", "broken.json:5: slide 1: the record has no step \"depth-fail\"");
    slide("refused", "\"settings\": {\"algorithm\": \"tiled\", \"number-type\": \"float32\"},",
          "broken.json:5: slide 1: ");
    QTest::newRow("number of a caption") << lessonWith("").replace("One.", "{holes}")
                                         << "broken.json:7: the caption names {holes}, which \"expect\" does not have";
    QTest::newRow("number in one language")
        << lessonWith("\"expect\": {\"holes\": 0},").replace("One.", "{holes}")
        << "broken.json:7: the caption does not have the same numbers in both languages";
    slide("question first",
          "\"question\": {\"kind\": \"number\", \"text\": {\"en\": \"?\", \"zh\": \"?\"}, "
          "\"answer\": {\"from\": \"holes\"}},",
          "broken.json:6: the first slide asks a question and needs \"before\"");
    const QByteArray asks = "\"before\": {\"caption\": {\"en\": \"Think.\", \"zh\": \"想一想。\"}},\n\"question\": {\n";
    const auto question = [&](const char* name, const char* lines, const char* fault) {
        slide(name, asks + "\"text\": {\"en\": \"?\", \"zh\": \"?\"},\n" + lines + "},", fault);
    };
    question("kind", "\"kind\": \"guess\", \"answer\": {\"from\": \"holes\"}",
             "broken.json:9: \"kind\" takes pixels, next-p, winner, corners, mistake, number, choice");
    question("no answer", "\"kind\": \"number\"", "broken.json:7: \"answer\" is missing; it takes an object");
    question("answer's fact", "\"kind\": \"number\",\n\"answer\": {\"from\": \"hole\"}",
             "broken.json:10: there is no fact \"hole\"");
    question("typed answer", "\"kind\": \"number\", \"answer\": {\"from\": \"holes\", \"is\": 8}",
             "broken.json:7: slide 1: \"holes\" is 0, not 8");
    question("choices of a number", "\"kind\": \"number\", \"answer\": {\"from\": \"holes\"},\n\"choices\": []",
             "broken.json:10: only questions of the kinds mistake and choice have \"choices\"");
    question("choice without value",
             "\"kind\": \"choice\", \"answer\": {\"from\": \"holes\"},\n\"choices\": [\n{\"text\": {\"en\": \"a\", "
             "\"zh\": \"甲\"}}]",
             "broken.json:11: \"is\" takes a number, a text or a list of pixels");
    question("no right choice",
             "\"kind\": \"choice\", \"answer\": {\"from\": \"holes\"},\n\"choices\": [\n{\"is\": 9, \"text\": {\"en\": "
             "\"a\", \"zh\": \"甲\"}}]",
             "broken.json:7: slide 1: the question has no answer: \"holes\"");
}

void TestLessons::brokenFilesAreRefused()
{
    QFETCH(QByteArray, text);
    QFETCH(QString, fault);
    const QStringList faults = faultsOf(text);
    QVERIFY2(std::any_of(faults.begin(), faults.end(), [&](const QString& said) { return said.startsWith(fault); }),
             qPrintable(fault + QStringLiteral("\n  is not in\n") + faults.join(QLatin1Char('\n'))));
}

void TestLessons::thereAreEnoughLessons()
{
    const QStringList ids = lessonIds();
    QVERIFY(ids.size() >= 18);
    QCOMPARE(QSet<QString>(ids.begin(), ids.end()).size(), ids.size());
    QCOMPARE(faultsOf(lessonWith("")), QStringList());
}

void TestLessons::builtinLessonsAreWhole_data()
{
    QTest::addColumn<QString>("id");
    for (const QString& id : lessonIds())
        QTest::newRow(qPrintable(id)) << id;
}

void TestLessons::builtinLessonsAreWhole()
{
    QFETCH(QString, id);
    const LessonLoad load = loadLesson(id);
    QCOMPARE(textsOf(load.diagnostics), QStringList());
    const Lesson& lesson = *load.lesson;
    QCOMPARE(lesson.id, id);
    QVERIFY(!lesson.source.isEmpty());
    QVERIFY(lesson.slides.size() >= 6 && lesson.slides.size() <= 14);
    int questions = 0;
    int ofLevel[] = {0, 0};
    for (const Slide& slide : lesson.slides) {
        ++ofLevel[slide.level - 1];
        questions += slide.question.has_value() ? 1 : 0;
        QVERIFY2(!slide.expected.empty(), qPrintable(slide.moment.caption.en));
        QVERIFY2(hasChinese(slide.moment.caption.zh) && !hasChinese(slide.moment.caption.en),
                 qPrintable(slide.moment.caption.en));
        if (slide.question)
            QVERIFY2(hasChinese(slide.question->text.zh) && !hasChinese(slide.question->text.en),
                     qPrintable(slide.question->text.en));
        QVERIFY(!textWithNumbers(slide.moment.caption, slide).en.contains(QLatin1Char('{')));
    }
    QVERIFY(ofLevel[0] >= 3 && ofLevel[1] >= 1);
    QVERIFY(questions >= 1);
}

void TestLessons::questionsStandOverWhatTheyAskOf_data() { builtinLessonsAreWhole_data(); }

/// The scene is that of the slide. A mistake is to be known by its picture; what a mistake will spoil is still right.
void TestLessons::questionsStandOverWhatTheyAskOf()
{
    QFETCH(QString, id);
    const Lesson lesson = *loadLesson(id).lesson;
    const QString mistakes = QStringLiteral("mistakes");
    for (const Slide& slide : lesson.slides) {
        if (!slide.question)
            continue;
        QVERIFY(slide.before);
        QCOMPARE(slide.before->scene, slide.moment.scene);
        QCOMPARE(slide.before->size, slide.moment.size);
        const bool asksForMistake = slide.question->kind == QuestionKind::Mistake;
        if (asksForMistake)
            QCOMPARE(slide.before->settings, slide.moment.settings);
        else
            QVERIFY(slide.before->settings[mistakes].isUndefined() ||
                    slide.before->settings[mistakes] != slide.moment.settings[mistakes]);
        QVERIFY(!asksForMistake || slide.before->compare.view == MomentCompare::View::Off);
    }
}

void TestLessons::builtinLessonsSayWhatIsComputed_data() { builtinLessonsAreWhole_data(); }

void TestLessons::builtinLessonsSayWhatIsComputed()
{
    QFETCH(QString, id);
    QCOMPARE(textsOf(checkSlides(*loadLesson(id).lesson)), QStringList());
}

void TestLessons::aChangedNumberIsFound()
{
    QFile file(loadLesson("top-left").lesson->file);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QByteArray text = file.readAll();
    const qsizetype at = text.indexOf("\"hit-twice\": 8");
    QVERIFY(at > 0);
    text[at + 13] = '7';
    const LessonLoad load = lessonFromJson(text, file.fileName());
    const QStringList faults = textsOf(checkSlides(*load.lesson));
    QCOMPARE(faults.size(), 1);
    const auto line = text.left(at).count('\n') + 1;
    QVERIFY2(faults[0].startsWith(QStringLiteral("%1:%2: slide ").arg(file.fileName()).arg(line)),
             qPrintable(faults[0]));
    QVERIFY2(faults[0].endsWith(QStringLiteral("\"hit-twice\" is 8, not 7")), qPrintable(faults[0]));
}

void TestLessons::theDocumentedExampleIsRight()
{
    static const QRegularExpression block(QStringLiteral("```json\\n(\\{\\n  \"rasterlens-lesson\".*?)```"),
                                          QRegularExpression::DotMatchesEverythingOption);
    const auto match = block.match(documentText());
    QVERIFY(match.hasMatch());
    QCOMPARE(faultsOf(match.captured(1).toUtf8()), QStringList());
    const LessonLoad load = lessonFromJson(match.captured(1).toUtf8(), kFile);
    QVERIFY(std::ranges::any_of(load.lesson->slides, [](const Slide& slide) { return slide.question.has_value(); }));
}

void TestLessons::everyFactIsDocumented()
{
    const QString text = documentText();
    for (const FactRow& fact : factRows()) {
        const QString row =
            QStringLiteral("| `%1` |")
                .arg(QStringLiteral("%1 %2").arg(QLatin1String(fact.name), QLatin1String(fact.arguments)).trimmed());
        QVERIFY2(text.contains(row), qPrintable(row));
    }
}

void TestLessons::commandLineListsAndShows()
{
    const QTemporaryDir folder;
    const Run list = run({"lesson", "--list"}, folder.path());
    QCOMPARE(list.exitCode, 0);
    QCOMPARE(list.out.count('\n'), lessonIds().size());
    const Run json = run({"lesson", "--list", "--json", "-"}, folder.path());
    const QJsonArray rows = QJsonDocument::fromJson(json.out).array();
    QCOMPARE(rows.size(), lessonIds().size());
    QCOMPARE(rows[0]["id"].toString(), lessonIds()[0]);
    QVERIFY(rows[0]["steps"].toInt() >= 6);
    QVERIFY(hasChinese(rows[0]["title"]["zh"].toString()));
    const Run show = run({"lesson", "show", "top-left"}, folder.path());
    QCOMPARE(show.exitCode, 0);
    QVERIFY(show.out.contains("8 pixels are hit twice"));
    QVERIFY(run({"lesson", "--facts"}, folder.path()).out.contains("winner X,Y"));
    for (const QStringList& words : {QStringList{"lesson"},
                                     {"lesson", "show"},
                                     {"lesson", "draw", "top-left"},
                                     {"lesson", "show", "top-left", "--json", "-"}})
        QCOMPARE(run(words, folder.path()).exitCode, 2);
    const Run unknown = run({"lesson", "show", "nothing"}, folder.path());
    QCOMPARE(unknown.exitCode, 3);
    QVERIFY2(unknown.err.contains("there is no such lesson"), qPrintable(unknown.err));
}

void TestLessons::commandLineChecks()
{
    const QTemporaryDir folder;
    const auto check = [&](const QByteArray& text) {
        writeFile(folder.filePath("l.json"), text);
        return run({"lesson", "check", "l.json"}, folder.path());
    };
    const Run right = check(lessonWith("\"expect\": {\"covered\": 64},"));
    QCOMPARE(right.exitCode, 0);
    QVERIFY(right.out.isEmpty() && right.err.isEmpty());
    const Run wrong = check(lessonWith("\"expect\": {\"covered\": 65},"));
    QCOMPARE(wrong.exitCode, 3);
    QCOMPARE(wrong.err, QStringLiteral("l.json:6: slide 1: \"covered\" is 64, not 65\n"));
    QCOMPARE(check("{").exitCode, 3);
    QCOMPARE(run({"lesson", "check", "absent.json"}, folder.path()).exitCode, 3);
}

void TestLessons::commandLineDrawsSlides()
{
    const QTemporaryDir folder;
    const auto draw = [&](const QStringList& words) {
        const Run drawn =
            run(QStringList{"render", "--lesson", "top-left"} + words + QStringList{"-o", "s.png"}, folder.path());
        return drawn.exitCode == 0 ? QImage(folder.filePath("s.png")) : QImage();
    };
    const Lesson lesson = *loadLesson("top-left").lesson;
    for (std::size_t i = 0; i < lesson.slides.size(); ++i) {
        const OpenMomentLoad open = openMoment(lesson.slides[i].moment);
        const QImage picture = MomentFacts(lesson.slides[i].moment, *open.moment).picture();
        QCOMPARE(draw({"--step", QString::number(i + 1)}).convertToFormat(QImage::Format_RGB32), picture);
    }
    QCOMPARE(draw({"--step", "1", "--size", "20x10"}).size(), QSize(20, 10));
    const auto code = [&](const QStringList& words) {
        return run(QStringList{"render"} + words, folder.path()).exitCode;
    };
    QCOMPARE(code({"--lesson", "top-left"}), 2);
    QCOMPARE(code({"--lesson", "top-left", "--step", "99"}), 2);
    QCOMPARE(code({"--lesson", "top-left", "--step", "2", "--ids", "i.npy"}), 2);
    QCOMPARE(code({"builtin:cube", "--step", "1"}), 2);
    QCOMPARE(code({"--lesson", "nothing", "--step", "1"}), 3);
}

QTEST_GUILESS_MAIN(TestLessons)
#include "test_lessons.moc"
