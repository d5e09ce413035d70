#include "core/lessons/lesson.h"
#include "app/cli/handout.h"
#include "app/cli/input.h"
#include "app/cli/output.h"
#include "app/cli/slide.h"
#include "app/cli/verbs.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace rasterlens::cli
{
namespace
{

Usage usage()
{
    const auto flag = [](const char* name, const char* help) {
        return Option{QString::fromLatin1(name), Option::Kind::Switch, {}, QString::fromLatin1(help)};
    };
    const QList<Option> options{
        flag("--list", "Print the built-in lessons: id, number of slides, title in English and Chinese."),
        {QStringLiteral("--json"), Option::Kind::Value, QStringLiteral("FILE"),
         QStringLiteral("With --list: an array of {\"id\", \"title\", \"steps\", \"source\"} into this file (- is "
                        "stdout), instead of text.")},
        {QStringLiteral("-o"), Option::Kind::Value, QStringLiteral("FILE"),
         QStringLiteral("With handout: F.pdf, or F.md with the figures beside it as F-01.png, F-02.png ..")},
        {QStringLiteral("--language"), Option::Kind::Value, QStringLiteral("en|zh"),
         QStringLiteral("With handout: its language; default en.")},
        allowOutsideOption(),
        flag("--facts", "Print the facts that a lesson's \"expect\" and answers may name, and end.")};
    return {
        QStringLiteral("lesson"),
        QStringLiteral("rasterlens-cli lesson --list [--json FILE] | show NAME | check FILE | handout NAME -o FILE"),
        QStringLiteral("Lessons: lists of moments with a caption in English and Chinese, and questions.\n\n"
                       "show NAME prints the slides of a lesson: the id of a built-in one, or a .json file.\n"
                       "check FILE reads a lesson, draws each of its slides and compares what it says with what is "
                       "computed. It prints nothing but what is wrong, as FILE:LINE.\n"
                       "handout NAME writes the slides with their questions, figures and captions for reading."),
        {},
        {{QStringLiteral("Options:"), options}},
        QStringLiteral("rasterlens-cli render --lesson NAME --step N -o FILE draws a slide.\n"
                       "The format of lessons is described in docs/LESSONS.md.\n\n"
                       "Exit codes: 0 fine; 2 bad arguments; 3 a lesson that cannot be read or says something "
                       "wrong, or output that cannot be written."),
        true};
}

QString listText()
{
    QString text;
    for (const QString& id : lessonIds()) {
        const Lesson lesson = openLesson(id);
        text += QStringLiteral("%1 %2 slides  %3 / %4\n")
                    .arg(id, -24)
                    .arg(lesson.slides.size(), 2)
                    .arg(lesson.title.en, lesson.title.zh);
    }
    return text;
}

QJsonObject toJson(const TwoTexts& texts) { return {{"en", texts.en}, {"zh", texts.zh}}; }

QByteArray listJson()
{
    QJsonArray rows;
    for (const QString& id : lessonIds()) {
        const Lesson lesson = openLesson(id);
        rows.append(QJsonObject{{"id", id},
                                {"title", toJson(lesson.title)},
                                {"steps", static_cast<qint64>(lesson.slides.size())},
                                {"source", lesson.source}});
    }
    return QJsonDocument(rows).toJson();
}

QString factList()
{
    QString text;
    for (const FactRow& fact : factRows())
        text += QStringLiteral("%1 %2\n")
                    .arg(QStringLiteral("%1 %2").arg(QLatin1String(fact.name), QLatin1String(fact.arguments)), -32)
                    .arg(QLatin1String(fact.meaning));
    return text;
}

QString slideText(const Slide& slide, std::size_t number)
{
    const TwoTexts caption = textWithNumbers(slide.moment.caption, slide);
    QString text = QStringLiteral("\n%1. %2").arg(number).arg(slide.moment.scene);
    if (slide.moment.step)
        text += QStringLiteral(", step ") + textOf(*slide.moment.step);
    text += slide.level == 2 ? QStringLiteral(", second look\n") : QStringLiteral("\n");
    if (slide.question) {
        const TwoTexts question = textWithNumbers(slide.question->text, slide);
        text += QStringLiteral("   ? %1\n   ? %2\n").arg(question.en, question.zh);
    }
    return text + QStringLiteral("   %1\n   %2\n").arg(caption.en, caption.zh);
}

QString lessonText(const Lesson& lesson)
{
    QString text = QStringLiteral("%1\n%2\n").arg(lesson.title.en, lesson.title.zh);
    if (!lesson.source.isEmpty())
        text += QStringLiteral("after %1\n").arg(lesson.source);
    for (std::size_t i = 0; i < lesson.slides.size(); ++i)
        text += slideText(lesson.slides[i], i + 1);
    return text;
}

void check(const QString& name)
{
    QStringList lines;
    for (const Diagnostic& diagnostic : checkSlides(openLesson(name)))
        lines << diagnostic.text();
    if (!lines.isEmpty())
        failInput(lines.join(QLatin1Char('\n')));
}

void handout(const QString& name, const Arguments& arguments)
{
    const auto path = arguments.value(QStringLiteral("-o"));
    if (!path)
        failArguments(QStringLiteral("rasterlens-cli lesson handout: -o FILE is missing"));
    const QString language = arguments.value(QStringLiteral("--language")).value_or(QStringLiteral("en"));
    if (language != QLatin1String("en") && language != QLatin1String("zh"))
        failArguments(QStringLiteral("--language: \"%1\" is not a language; expected: en, zh").arg(language));
    writeHandout(openLesson(name), *path, language == QLatin1String("zh"));
}

void list(const Arguments& arguments)
{
    const auto json = arguments.value(QStringLiteral("--json"));
    if (!json)
        return printText(listText());
    checkOutputs({*json});
    OutputFiles files;
    files.add(*json, listJson());
    files.write();
}

} // namespace

Usage lessonUsage() { return usage(); }

ExitCode runLesson(const QStringList& words)
{
    const auto arguments = parseArguments(usage(), words);
    if (!arguments)
        return ExitCode::Fine;
    const Consent consent(outsideOf(*arguments));
    const QStringList& operands = arguments->operands;
    const QString action = operands.value(0);
    const bool isAlone = operands.isEmpty();
    if (arguments->has(QStringLiteral("--json")) && !arguments->isOn(QStringLiteral("--list")))
        failArguments(QStringLiteral("rasterlens-cli lesson: --json needs --list beside it"));
    if (isAlone && arguments->isOn(QStringLiteral("--list")))
        list(*arguments);
    else if (isAlone && arguments->isOn(QStringLiteral("--facts")))
        printText(factList());
    else if (operands.size() == 2 && action == QLatin1String("show"))
        printText(lessonText(openLesson(operands[1])));
    else if (operands.size() == 2 && action == QLatin1String("check"))
        check(operands[1]);
    else if (operands.size() == 2 && action == QLatin1String("handout"))
        handout(operands[1], *arguments);
    else
        failArguments(QStringLiteral(
            "rasterlens-cli lesson: --list, --facts, \"show NAME\", \"check FILE\" or \"handout NAME\" is "
            "expected"));
    return ExitCode::Fine;
}

} // namespace rasterlens::cli
