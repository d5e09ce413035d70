// The page in a browser: opened at steps, stepped by its interface for programs, its lesson led through. Skipped where
// there is no Chromium.
#include "core/observe/step_cursor.h"
#include "core/observe/step_text.h"
#include "tests/cli_support.h"
#include "tests/page_support.h"

#include <QStandardPaths>
#include <QTemporaryDir>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

const QString kSquare = QStringLiteral("builtin:square-diagonal");

QByteArray unescaped(QByteArray text)
{
    return text.replace("&lt;", "<").replace("&gt;", ">").replace("&nbsp;", "\u00a0").replace("&amp;", "&");
}

/// The page with a script that runs once the page stands.
QByteArray withScript(QByteArray html, const QByteArray& script)
{
    return html.replace("</body>", "<script>rasterlens.ready.then(() => {" + script + "});</script></body>");
}

} // namespace

class TestPageInChromium : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;
    QString m_browser;

    /// The document of a page after its scripts have run.
    QByteArray opened(const QByteArray& html, const QString& address = {})
    {
        const QString file = m_folder.filePath(QStringLiteral("page.html"));
        writeFile(file, html);
        const QString profile = QStringLiteral("--user-data-dir=") + m_folder.filePath(QStringLiteral("profile"));
        const Run run = test::run({QStringLiteral("--headless=new"), QStringLiteral("--no-sandbox"),
                                   QStringLiteral("--disable-gpu"), QStringLiteral("--lang=en"), profile,
                                   QStringLiteral("--virtual-time-budget=3000"), QStringLiteral("--dump-dom"),
                                   QStringLiteral("file://") + file + address},
                                  m_folder.path(), m_browser);
        return run.out;
    }

    /// What the page writes into its element "state".
    QJsonDocument stateOf(const QByteArray& html, const QString& address = {})
    {
        const QByteArray document = opened(html, address);
        const QByteArray begin = "<output id=\"state\" hidden=\"\">";
        const qsizetype from = document.indexOf(begin) + begin.size();
        return QJsonDocument::fromJson(unescaped(document.mid(from, document.indexOf("</output>", from) - from)));
    }

private Q_SLOTS:
    void initTestCase()
    {
        m_browser = QStandardPaths::findExecutable(QStringLiteral("chromium"));
        if (m_browser.isEmpty())
            QSKIP("there is no chromium here; Debian's package has it");
        // One that is confined does not see the folder of temporary files.
        if (!opened("<!DOCTYPE html><body>").contains("<body>"))
            QSKIP("this chromium does not open files of the temporary folder");
    }

    void everyStepIsThatOfTheLog()
    {
        const Scene scene = pageScene(kSquare);
        const auto log = renderSteps(scene, scene.defaults);
        // All steps forth, and some back.
        const QJsonArray told = stateOf(withScript(pageOf(scene), R"(
            const steps = [...Array(rasterlens.events).keys()];
            const told = steps.concat([200, 40, 41, 0, -1]).map(k => {
                rasterlens.go(k);
                const pixels = [];
                for (let y = 0; y < 8; ++y)
                    for (let x = 0; x < 8; ++x)
                        pixels.push(rasterlens.pixel(x, y));
                return { k, event: rasterlens.event(), pixels };
            });
            document.getElementById("state").textContent = JSON.stringify(told);)"))
                                    .array();
        QCOMPARE(std::size_t(told.size()), log->size() + 5);
        StepCursor cursor(log);
        for (const QJsonValue& step : told) {
            const int k = step[QStringLiteral("k")].toInt();
            cursor.moveTo(std::size_t(k + 1));
            if (k < 0)
                QVERIFY(step[QStringLiteral("event")].isNull());
            else
                QCOMPARE(step[QStringLiteral("event")].toObject(),
                         QJsonDocument::fromJson(QJsonDocument(stepJson(*log, std::size_t(k))).toJson()).object());
            for (int p = 0; p < 64; ++p) {
                const QJsonValue pixel = step[QStringLiteral("pixels")].toArray()[p];
                QCOMPARE(pixel[QStringLiteral("color")].toString(), colorText(cursor.sampleColors()[std::size_t(p)]));
                QCOMPARE(pixel[QStringLiteral("depth")].toDouble(), double(cursor.sampleDepths()[std::size_t(p)]));
            }
        }
    }

    void theAddressOpensAStep_data()
    {
        QTest::addColumn<int>("number");
        for (const int number : {0, 39, 120, 300})
            QTest::newRow(qPrintable(QString::number(number))) << number;
    }

    void theAddressOpensAStep()
    {
        QFETCH(int, number);
        const Scene scene = pageScene(kSquare);
        const auto log = renderSteps(scene, scene.defaults);
        const QJsonObject state =
            stateOf(pageOf(scene), QStringLiteral("#step=%1&pixel=3,4&state").arg(number)).object();
        QCOMPARE(state[QStringLiteral("step")].toInt(-1), number);
        const QJsonObject event = state[QStringLiteral("event")].toObject();
        QCOMPARE(event, QJsonDocument::fromJson(QJsonDocument(stepJson(*log, std::size_t(number))).toJson()).object());
        if (event[QStringLiteral("event")] == QLatin1String("sample"))
            for (const QJsonValue& area : event[QStringLiteral("areas")].toArray()) {
                const QString value =
                    QString::number(area.toDouble(), 'g', 12).replace(QLatin1Char('-'), QChar(0x2212));
                QVERIFY2(state[QStringLiteral("lens")].toString().contains(value), qPrintable(value));
            }
        QVERIFY(state[QStringLiteral("card")].toString().contains(QStringLiteral("lost the tie")));
        QCOMPARE(state[QStringLiteral("lang")].toString(), QStringLiteral("en"));
    }

    void speaksChinese()
    {
        const Lesson lesson = *loadLesson(QStringLiteral("top-left")).lesson;
        const QJsonObject state =
            stateOf(pageOf(pageScene(kSquare), {}, &lesson), QStringLiteral("#slide=2&lang=zh&state")).object();
        QCOMPARE(state[QStringLiteral("lang")].toString(), QStringLiteral("zh-CN"));
        QVERIFY(state[QStringLiteral("lesson")].toString().contains(QStringLiteral("面 0 走到第一个恰在边上的中心")));
        QVERIFY(state[QStringLiteral("sentence")].toString().contains(QStringLiteral("恰在")));
        QVERIFY(state[QStringLiteral("event")][QStringLiteral("tie")].toBool());
    }

    void aBrowserThatUnpacksNothingIsTold()
    {
        const Lesson lesson = *loadLesson(QStringLiteral("perspective")).lesson;
        QByteArray html = pageOf(pageScene(kSquare), {}, &lesson);
        html.replace("<body>", "<body><script>delete window.DecompressionStream;</script>");
        QVERIFY(opened(html).contains("browser of the year 2023 or later. (DecompressionStream is not defined)"));
    }

    void keysAndAnswersWork()
    {
        const Lesson lesson = *loadLesson(QStringLiteral("top-left")).lesson;
        const QJsonArray told = stateOf(withScript(pageOf(pageScene(kSquare), {}, &lesson), R"(
            const byId = id => document.getElementById(id);
            const press = key => document.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true }));
            const told = [];
            const tell = () => told.push(byId("lesson").innerText + "|" + byId("counter").textContent);
            press("Home"); tell();
            press("ArrowRight"); press("ArrowRight"); tell();
            press("PageDown"); press("PageDown"); tell(); // the question about pixels
            const picture = byId("picture");
            const side = picture.getBoundingClientRect().width / 8;
            for (let i = 0; i < 8; ++i) {
                const box = picture.getBoundingClientRect();
                const place = { clientX: box.left + (7.5 - i) * side, clientY: box.top + (i + 0.5) * side, pointerType: "mouse" };
                picture.dispatchEvent(new PointerEvent("pointerdown", place));
                picture.dispatchEvent(new PointerEvent("pointerup", place));
            }
            tell();
            byId("answer").querySelector("button").click(); tell();
            press("PageDown");
            for (const typed of ["0", "2"]) { // two tries
                byId("answer").querySelector("input").value = typed;
                byId("answer").querySelector("button").click(); tell();
            }
            document.getElementById("state").textContent = JSON.stringify(told);)"))
                                    .array();
        QCOMPARE(told.size(), 7);
        QVERIFY2(told[0].toString().contains(QStringLiteral("|start")), qPrintable(told[0].toString()));
        QVERIFY2(told[1].toString().contains(QStringLiteral("|step 2 of")), qPrintable(told[1].toString()));
        QVERIFY2(told[2].toString().contains(QStringLiteral("Click the pixels")), qPrintable(told[2].toString()));
        QVERIFY2(told[3].toString().contains(QStringLiteral("8 marked")), qPrintable(told[3].toString()));
        QVERIFY2(told[4].toString().contains(QStringLiteral("Right:")), qPrintable(told[4].toString()));
        QVERIFY2(told[5].toString().contains(QStringLiteral("One more try")), qPrintable(told[5].toString()));
        QVERIFY2(told[6].toString().contains(QStringLiteral("Not so. The answer: 1")), qPrintable(told[6].toString()));
    }
};

QTEST_GUILESS_MAIN(TestPageInChromium)
#include "test_page_in_chromium.moc"
