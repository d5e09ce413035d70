// The page that shows a run: its data are those of the step log, and nothing of it comes from elsewhere.
#include "core/observe/step_cursor.h"
#include "core/observe/step_text.h"
#include "tests/cli_support.h"
#include "tests/page_support.h"
#include "ui/face/pixel_card.h"
#include "ui/steps/step_sentence.h"

#include <QTemporaryDir>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

constexpr qsizetype kMostBytes = 2'000'000; ///< of a page with a lesson

const QString kSquare = QStringLiteral("builtin:square-diagonal");

QJsonObject mainRun(const QByteArray& html) { return dataOf(html)[QStringLiteral("runs")].toArray()[0].toObject(); }

/// A text of a page by its number, in English (0) or Chinese (1).
QString pageText(const QJsonObject& data, const QJsonValue& number, int language)
{
    const QJsonValue text = data[QStringLiteral("texts")].toArray()[number.toInt()];
    if (text.isString())
        return text.toString();
    if (text[0].isString())
        return text[language].toString();
    QString filled = pageText(data, text[0], language);
    for (const QString& value : text[1].toString().split(QLatin1Char(' ')))
        filled.replace(filled.indexOf(QChar(QChar::ObjectReplacementCharacter)), 1, value);
    return filled;
}

bool hasChinese(const QString& text)
{
    return std::any_of(text.begin(), text.end(), [](QChar c) { return c.script() == QChar::Script_Han; });
}

Lesson topLeft() { return *loadLesson(QStringLiteral("top-left")).lesson; }

} // namespace

class TestPage : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void holdsEveryStepOfTheLog_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("algorithm");
        QTest::addColumn<int>("grid");
        QTest::newRow("square") << kSquare << QStringLiteral("edge-equation") << 1;
        QTest::newRow("walked") << kSquare << QStringLiteral("edge-walking") << 1;
        QTest::newRow("samples") << kSquare << QStringLiteral("edge-equation") << 2;
    }

    void holdsEveryStepOfTheLog()
    {
        QFETCH(QString, name);
        QFETCH(QString, algorithm);
        QFETCH(int, grid);
        Scene scene = pageScene(name);
        scene.defaults.algorithm =
            algorithm == QLatin1String("edge-walking") ? Algorithm::EdgeWalking : Algorithm::EdgeEquation;
        scene.defaults.samples = grid == 2 ? Samples::Grid2 : Samples::One;
        const QJsonObject run = mainRun(pageOf(scene));
        const auto log = renderSteps(scene, scene.defaults);
        const QJsonArray events = run[QStringLiteral("events")].toArray();
        QCOMPARE(std::size_t(events.size()), log->size());
        for (std::size_t i = 0; i < log->size(); ++i) {
            const QJsonObject event = QJsonDocument::fromJson(QJsonDocument(stepJson(*log, i)).toJson()).object();
            QCOMPARE(events[qsizetype(i)].toObject(), event);
        }
        QCOMPARE(run[QStringLiteral("steps")].toArray().size(), events.size());
        QCOMPARE(run[QStringLiteral("grid")].toInt(), grid);
        QVERIFY(!run.contains(QStringLiteral("limit")));
    }

    void changesMakeThePicture()
    {
        const Scene scene = pageScene(kSquare);
        const QJsonObject run = mainRun(pageOf(scene));
        const auto log = renderSteps(scene, scene.defaults);
        std::vector<QString> colors(64, run[QStringLiteral("clear")].toArray()[0].toString());
        std::vector<double> depths(64, run[QStringLiteral("clear")].toArray()[1].toDouble());
        const QJsonArray changes = run[QStringLiteral("changes")].toArray();
        StepCursor cursor(log);
        qsizetype next = 0;
        for (std::size_t i = 0; i < log->size(); ++i) {
            for (; next < changes.size() && changes[next].toArray()[0].toInt() == int(i); ++next) {
                const QJsonArray change = changes[next].toArray();
                colors[std::size_t(change[1].toInt())] = change[2].toString();
                depths[std::size_t(change[1].toInt())] = change[3].toDouble();
            }
            cursor.moveTo(i + 1);
            for (std::size_t p = 0; p < 64; ++p) {
                QCOMPARE(colors[p], colorText(cursor.sampleColors()[p]));
                QCOMPARE(depths[p], double(cursor.sampleDepths()[p]));
            }
            const QJsonArray counts = run[QStringLiteral("counts")].toArray()[qsizetype(i)].toArray();
            QCOMPARE(counts[0].toInt(), int(cursor.counters().pixels.tested));
            QCOMPARE(counts[1].toInt(), int(cursor.counters().pixels.covered));
            QCOMPARE(counts[4].toInt(), int(cursor.counters().pixels.written));
        }
        QCOMPARE(next, changes.size());
    }

    void saysWhatTheWindowSays()
    {
        const Scene scene = pageScene(kSquare);
        const QByteArray html = pageOf(scene);
        const QJsonObject data = dataOf(html);
        const QJsonObject run = mainRun(html);
        const auto log = renderSteps(scene, scene.defaults);
        const QJsonArray steps = run[QStringLiteral("steps")].toArray();
        for (std::size_t i = 0; i < log->size(); ++i) {
            const QJsonArray step = steps[qsizetype(i)].toArray();
            QCOMPARE(pageText(data, step[1], 0), stepSentence(*log, i));
            QVERIFY2(hasChinese(pageText(data, step[0], 1)), qPrintable(pageText(data, step[0], 1)));
            QVERIFY2(hasChinese(pageText(data, step[1], 1)), qPrintable(pageText(data, step[1], 1)));
        }
        const QJsonObject cards = run[QStringLiteral("cards")].toObject();
        QCOMPARE(cards.size(), 64);
        const WhyReport report = why(scene, scene.defaults, 3, 4);
        const QJsonObject card = cards[QStringLiteral("3,4")].toObject();
        const QJsonArray faces = card[QStringLiteral("faces")].toArray();
        QCOMPARE(std::size_t(faces.size()), report.faces.size());
        for (std::size_t i = 0; i < report.faces.size(); ++i) {
            const WhyWords words = whyWords(report, report.faces[i]);
            const QJsonObject face = faces[qsizetype(i)].toObject();
            QCOMPARE(pageText(data, face[QStringLiteral("verdict")], 0), words.verdict);
            QCOMPARE(face[QStringLiteral("seen")].toBool(), words.good);
            QVERIFY(hasChinese(pageText(data, face[QStringLiteral("verdict")], 1)));
            const QJsonArray details = face[QStringLiteral("details")].toArray();
            for (qsizetype line = 0; line < words.details.size(); ++line)
                QCOMPARE(pageText(data, details[line], 0), words.details[line]);
        }
        QCOMPARE(QCoreApplication::translate("StepSentence", "The frame is finished."),
                 QStringLiteral("The frame is finished.")); // the language is what it was
    }

    void isOneSmallFileByItself()
    {
        const Lesson lesson = topLeft();
        const QByteArray html = pageOf(pageScene(kSquare), {}, &lesson);
        QVERIFY(!html.isEmpty());
        QVERIFY2(html.size() < kMostBytes, qPrintable(QString::number(html.size())));
        for (const char* outside :
             {"http:", "https:", "//cdn", " src=", " href=", "url(", "@import", "eval(", "fetch("})
            QVERIFY2(!html.contains(outside), outside);
        for (const char* name : {"@style@", "@script@", "@data@", "@title@"})
            QVERIFY2(!html.contains(name), name);
        QCOMPARE(html.count("</script>"), 2);
    }

    void leadsThroughItsLesson()
    {
        const Lesson lesson = topLeft();
        const QJsonObject data = dataOf(pageOf(pageScene(kSquare), {}, &lesson));
        const QJsonArray slides = data[QStringLiteral("lesson")].toObject()[QStringLiteral("slides")].toArray();
        QCOMPARE(std::size_t(slides.size()), lesson.slides.size());
        const QJsonArray runs = data[QStringLiteral("runs")].toArray();
        for (std::size_t i = 0; i < lesson.slides.size(); ++i) {
            const QJsonObject slide = slides[qsizetype(i)].toObject();
            const TwoTexts caption = textWithNumbers(lesson.slides[i].moment.caption, lesson.slides[i]);
            QCOMPARE(pageText(data, slide[QStringLiteral("caption")], 0), caption.en);
            QCOMPARE(pageText(data, slide[QStringLiteral("caption")], 1), caption.zh);
            QVERIFY(slide[QStringLiteral("run")].toInt(-1) >= 0);
            QVERIFY(slide[QStringLiteral("run")].toInt() < runs.size());
            QCOMPARE(slide.contains(QStringLiteral("question")), lesson.slides[i].question.has_value());
        }
        // The second slide stands at the first tie: that of the log.
        QCOMPARE(slides[1].toObject()[QStringLiteral("run")].toInt(), 0);
        const QJsonObject tie = runs[0][QStringLiteral("events")]
                                    .toArray()[slides[1].toObject()[QStringLiteral("step")].toInt()]
                                    .toObject();
        QVERIFY(tie[QStringLiteral("tie")].toBool());
        const QJsonObject clicked = slides[2].toObject()[QStringLiteral("question")].toObject();
        QCOMPARE(clicked[QStringLiteral("answer")].toObject()[QStringLiteral("pixels")].toArray().size(), 8);
    }

    void everyLessonBecomesAPage_data()
    {
        QTest::addColumn<QString>("id");
        for (const QString& id : lessonIds())
            QTest::newRow(qPrintable(id)) << id;
    }

    void everyLessonBecomesAPage()
    {
        QFETCH(QString, id);
        const Lesson lesson = *loadLesson(id).lesson;
        const QByteArray html = pageOf(pageScene(kSquare), {}, &lesson);
        QVERIFY(!html.isEmpty());
        QVERIFY2(html.size() < kMostBytes, qPrintable(QString::number(html.size())));
        // About its own first scene, as the command line makes it.
        StepFilter filter;
        filter.cap = kUsualLessonPageSteps;
        const OpenMoment first = *openMoment(lesson.slides.front().moment).moment;
        WindowPageWords words;
        const PageResult own = makePage({first.scene, first.settings, filter, &lesson, {}, {}}, words);
        QVERIFY(!own.html.isEmpty());
        QVERIFY2(own.html.size() < kMostBytes, qPrintable(QString::number(own.html.size())));
    }

    void textsStayTexts()
    {
        Scene scene = pageScene(kSquare);
        const QString mean = QStringLiteral("</script><script>alert(1)</script><!-- &amp; \u2028 @data@ \"'");
        scene.id = QStringLiteral("mean.case");
        scene.title = mean;
        scene.note = mean;
        const QByteArray html = pageOf(scene);
        QCOMPARE(html.count("</script>"), 2);
        QVERIFY(!html.contains("<!--"));
        QVERIFY(!html.contains("alert(1)</"));
        const QJsonObject data = dataOf(html);
        QCOMPARE(pageText(data, mainRun(html)[QStringLiteral("scene")], 0), mean);
        QCOMPARE(pageText(data, mainRun(html)[QStringLiteral("note")], 1), mean);
    }

    void holdsOnlyWhatIsAskedFor()
    {
        const Scene scene = pageScene(kSquare);
        StepFilter filter;
        filter.cap = 50;
        QJsonObject run = mainRun(pageOf(scene, filter));
        QCOMPARE(run[QStringLiteral("events")].toArray().size(), 50);
        QCOMPARE(run[QStringLiteral("limit")].toInt(), 50);
        filter = {};
        filter.face = 1;
        run = mainRun(pageOf(scene, filter));
        for (const QJsonValue& event : run[QStringLiteral("events")].toArray())
            QVERIFY(event[QStringLiteral("face")].toInt(1) == 1);
        QCOMPARE(run[QStringLiteral("filter")][QStringLiteral("face")].toInt(), 1);
        filter = {};
        filter.pixels = PixelRect{3, 4, 1, 1};
        run = mainRun(pageOf(scene, filter));
        int samples = 0;
        for (const QJsonValue& event : run[QStringLiteral("events")].toArray())
            if (event[QStringLiteral("event")] == QLatin1String("sample")) {
                QCOMPARE(event[QStringLiteral("x")].toInt(), 3);
                QCOMPARE(event[QStringLiteral("y")].toInt(), 4);
                ++samples;
            }
        QCOMPARE(samples, 2);
    }

    void anEmptySceneSaysSo()
    {
        Scene scene = pageScene(kSquare);
        scene.mesh.indices.clear();
        const QByteArray html = pageOf(scene);
        const QJsonObject run = mainRun(html);
        const QString said = pageText(dataOf(html), run[QStringLiteral("empty")], 0);
        QVERIFY2(said.contains(QLatin1String("there are no faces")), qPrintable(said));
    }

    void theCommandLineWritesIt()
    {
        const QTemporaryDir folder;
        const auto page = [&](const QStringList& words) {
            return run(QStringList{QStringLiteral("page")} + words, folder.path());
        };
        const QString out = QStringLiteral("run.html");
        const Run made = page({kSquare, QStringLiteral("-o"), out});
        QVERIFY2(made.exitCode == 0, qPrintable(made.err));
        const Run told =
            run({QStringLiteral("steps"), kSquare, QStringLiteral("--json"), QStringLiteral("-")}, folder.path());
        const QJsonArray events = mainRun(readFile(folder.filePath(out)))[QStringLiteral("events")].toArray();
        const QList<QByteArray> lines = told.out.trimmed().split('\n');
        QCOMPARE(events.size(), lines.size());
        for (qsizetype i = 0; i < lines.size(); ++i)
            QCOMPARE(events[i].toObject(), QJsonDocument::fromJson(lines[i]).object());

        const Run withLesson = page({kSquare, QStringLiteral("--lesson"), QStringLiteral("top-left"),
                                     QStringLiteral("-o"), QStringLiteral("l.html")});
        QVERIFY2(withLesson.exitCode == 0, qPrintable(withLesson.err));
        QVERIFY(readFile(folder.filePath(QStringLiteral("l.html"))).size() < kMostBytes);
        QCOMPARE(page({QStringLiteral("--lesson"), QStringLiteral("top-left"), QStringLiteral("-o"),
                       QStringLiteral("m.html")})
                     .exitCode,
                 0);
        const Run ofResource = page(
            {QStringLiteral("--lesson"), QStringLiteral("bresenham"), QStringLiteral("-o"), QStringLiteral("b.html")});
        QCOMPARE(ofResource.exitCode, 0);
        QCOMPARE(ofResource.err, QString());
        QVERIFY(page({kSquare, QStringLiteral("-o"), QStringLiteral("-")}).out.startsWith("<!DOCTYPE html>"));
    }

    void theCommandLineRefuses_data()
    {
        QTest::addColumn<QStringList>("words");
        QTest::addColumn<int>("code");
        QTest::addColumn<QString>("message");
        const auto row = [](const char* words, int code, const char* message) {
            QTest::newRow(words) << QString::fromLatin1(words).split(QLatin1Char(' '), Qt::SkipEmptyParts) << code
                                 << QString::fromLatin1(message);
        };
        row("", 2, "SCENE is missing");
        row("builtin:square-diagonal", 2, "-o F.html is missing");
        row("builtin:square-diagonal -o run.pdf", 2, "html");
        row("builtin:square-diagonal -o run.html --face 2", 2, "--face");
        row("builtin:square-diagonal -o run.html --pixel 8,0", 2, "--pixel");
        row("builtin:square-diagonal -o run.html --limit 0", 2, "--limit");
        row("builtin:square-diagonal extra -o run.html", 2, "extra");
        row("builtin:nothing -o run.html", 3, "nothing");
        row("builtin:square-diagonal -o run.html --lesson nothing", 3, "no such lesson");
        row("builtin:square-diagonal -o nowhere/run.html", 3, "cannot be written");
    }

    void theCommandLineRefuses()
    {
        QFETCH(QStringList, words);
        QFETCH(int, code);
        QFETCH(QString, message);
        const QTemporaryDir folder;
        const Run refused = run(QStringList{QStringLiteral("page")} + words, folder.path());
        QCOMPARE(refused.exitCode, code);
        QVERIFY2(refused.err.contains(message), qPrintable(refused.err));
        QVERIFY(!QFile::exists(folder.filePath(QStringLiteral("run.html"))));
    }
};

QTEST_GUILESS_MAIN(TestPage)
#include "test_page.moc"
