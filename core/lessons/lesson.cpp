#include "core/lessons/lesson.h"

#include "core/base/closed_list.h"
#include "core/io/byte_order_mark.h"
#include "core/io/json_fields.h"
#include "core/io/reach.h"
#include "core/settings/mistakes.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QRegularExpression>

#include <algorithm>
#include <cmath>

namespace rasterlens
{
namespace
{

using Need = JsonFields::Need;

constexpr int kFormatVersion = 1;
constexpr const char* kFolder = ":/rasterlens/lessons";

struct QuestionKindName {
    QuestionKind kind;
    const char* id;
};

constexpr std::array kQuestionKinds{
    QuestionKindName{QuestionKind::Pixels, "pixels"},   QuestionKindName{QuestionKind::NextP, "next-p"},
    QuestionKindName{QuestionKind::Winner, "winner"},   QuestionKindName{QuestionKind::Corners, "corners"},
    QuestionKindName{QuestionKind::Mistake, "mistake"}, QuestionKindName{QuestionKind::Number, "number"},
    QuestionKindName{QuestionKind::Choice, "choice"},
};
static_assert(isClosedList(kQuestionKinds, &QuestionKindName::kind));

bool hasChoices(QuestionKind kind) { return kind == QuestionKind::Mistake || kind == QuestionKind::Choice; }

QString key(const char* name) { return QString::fromLatin1(name); }

/// Reads a fact's name and what is said of it.
std::optional<Expected> readFact(const JsonFields& fields, const QString& where, const QString& text)
{
    Reason why{QString()};
    const auto fact = factFromText(text, &why);
    if (!fact) {
        fields.error(where, std::move(why));
        return std::nullopt;
    }
    return Expected{text, *fact, QJsonValue(QJsonValue::Undefined), fields.lineOf(where)};
}

bool takesSaid(const JsonFields& fields, const QString& where, const QJsonValue& said)
{
    if (canBeFact(said))
        return true;
    fields.wrongType(where, QT_TRANSLATE_NOOP("Diagnostic", "a number, a text or a list of pixels [x, y]"));
    return false;
}

std::vector<Expected> readExpected(const JsonFields& slide)
{
    std::vector<Expected> expected;
    const auto facts = slide.fields(key("expect"), Need::Optional);
    if (!facts)
        return expected;
    for (const QString& text : facts->object().keys())
        if (auto fact = readFact(*facts, text, text); fact && takesSaid(*facts, text, facts->value(text))) {
            fact->is = facts->value(text);
            expected.push_back(std::move(*fact));
        }
    return expected;
}

class QuestionReader
{
public:
    explicit QuestionReader(const JsonFields& fields) : m_fields(fields) {}

    Question read()
    {
        m_fields.allow({key("kind"), key("text"), key("answer"), key("choices")});
        m_question.line = m_fields.line();
        kind();
        m_question.text = readTexts(m_fields, key("text"), Need::Required);
        answer();
        if (hasChoices(m_question.kind))
            choices();
        else if (m_fields.has(key("choices")))
            m_fields.error(key("choices"), QT_TRANSLATE_NOOP("Diagnostic", "only questions of the kinds mistake and "
                                                                           "choice have \"choices\""));
        return m_question;
    }

private:
    const JsonFields& m_fields;
    Question m_question;

    void kind()
    {
        const auto id = m_fields.text(key("kind"), Need::Required);
        QStringList ids;
        for (const auto& [kind, name] : kQuestionKinds) {
            ids << key(name);
            if (id == ids.last()) {
                m_question.kind = kind;
                return;
            }
        }
        if (id)
            m_fields.wrongType(key("kind"), ids.join(QStringLiteral(", ")));
    }

    void answer()
    {
        const auto answer = m_fields.fields(key("answer"), Need::Required);
        if (!answer)
            return;
        answer->allow({key("from"), key("is")});
        const auto from = answer->text(key("from"), Need::Required);
        if (!from)
            return;
        m_question.answer = readFact(*answer, key("from"), *from);
        if (m_question.answer && answer->has(key("is")) && takesSaid(*answer, key("is"), answer->value(key("is"))))
            m_question.answer->is = answer->value(key("is"));
    }

    void choices()
    {
        for (const JsonFields& choice : m_fields.list(key("choices"), Need::Required))
            m_question.choices.push_back(m_question.kind == QuestionKind::Mistake ? mistakeChoice(choice)
                                                                                  : textChoice(choice));
    }

    static QuestionChoice mistakeChoice(const JsonFields& fields)
    {
        fields.allow({key("mistake")});
        const QString id = fields.text(key("mistake"), Need::Required).value_or(QString());
        if (!id.isEmpty() && !findMistake(id))
            fields.error(key("mistake"), {QT_TRANSLATE_NOOP("Diagnostic", "there is no mistake \"%1\""), {id}});
        return {{}, id, id};
    }

    static QuestionChoice textChoice(const JsonFields& fields)
    {
        fields.allow({key("text"), key("is")});
        const TwoTexts text = readTexts(fields, key("text"), Need::Required);
        (void)takesSaid(fields, key("is"), fields.value(key("is")));
        return {text, {}, fields.value(key("is"))};
    }
};

/// The names in braces in a text: `hit-twice`, `winner 3,4`.
QStringList namesIn(const QString& text)
{
    static const QRegularExpression pattern(QStringLiteral("\\{([^{}]*)\\}"));
    QStringList names;
    for (auto it = pattern.globalMatch(text); it.hasNext();)
        names << it.next().captured(1);
    return names;
}

const Expected* expectedNamed(const Slide& slide, const QString& name)
{
    const auto found = std::ranges::find_if(slide.expected, [&](const Expected& e) { return e.text == name; });
    return found == slide.expected.end() ? nullptr : &*found;
}

class LessonReader
{
public:
    LessonReader(const JsonFields& fields, QString file) : m_fields(fields), m_reach(Consent::reachOf(file))
    {
        m_lesson.file = std::move(file);
    }

    Lesson read()
    {
        const QString version = key("rasterlens-lesson");
        m_fields.allow({version, key("id"), key("title"), key("source"), key("steps")});
        if (m_fields.value(version) != kFormatVersion)
            m_fields.wrongType(version, QString::number(kFormatVersion));
        m_lesson.id = m_fields.text(key("id"), Need::Required).value_or(QString());
        m_lesson.title = readTexts(m_fields, key("title"), Need::Required);
        m_lesson.source = m_fields.text(key("source"), Need::Optional).value_or(QString());
        for (const JsonFields& slide : m_fields.list(key("steps"), Need::Required))
            m_lesson.slides.push_back(slideOf(slide));
        return std::move(m_lesson);
    }

private:
    const JsonFields& m_fields;
    const Reach m_reach;
    Lesson m_lesson;

    Slide slideOf(const JsonFields& fields)
    {
        fields.allow(momentKeys() + QStringList{key("level"), key("expect"), key("question"), key("before")});
        const QDir folder = QFileInfo(m_lesson.file).absoluteDir();
        const Moment* last = m_lesson.slides.empty() ? nullptr : &m_lesson.slides.back().moment;
        Slide slide;
        slide.line = fields.line();
        if (leadsOut(fields))
            return slide;
        slide.moment = readMoment(fields, folder, last);
        slide.expected = readExpected(fields);
        level(fields, slide);
        if (const auto question = fields.fields(key("question"), Need::Optional))
            slide.question = QuestionReader(*question).read();
        if (const auto before = fields.fields(key("before"), Need::Optional)) {
            before->allow(momentKeys());
            if (leadsOut(*before))
                return slide;
            slide.before = readMoment(*before, folder, &slide.moment, Need::Optional); // the question says it
        } else if (slide.question && last) {
            slide.before = usualBefore(slide);
        }
        if (slide.question && !slide.before)
            fields.error(key("question"),
                         QT_TRANSLATE_NOOP("Diagnostic", "the first slide asks a question and needs "
                                                         "\"before\", what is shown while it is open"));
        numbers(fields, slide);
        return slide;
    }

    /// Whether a moment names a scene that is not to be read; says so.
    bool leadsOut(const JsonFields& moment) const
    {
        const QString scene = moment.value(key("scene")).toString();
        const bool isMade = scene.startsWith(QLatin1String("builtin:")) || scene.startsWith(QLatin1String("stress:")) ||
                            scene.startsWith(QLatin1String("case:"));
        if (scene.isEmpty() || isMade || m_reach.covers(scene))
            return false;
        Consent::refuse(m_lesson.file, QDir(m_reach.folder).absoluteFilePath(scene));
        moment.error(key("scene"), {QT_TRANSLATE_NOOP("Diagnostic", "the scene %1 lies outside the lesson's folder and "
                                                                    "is opened only if that is allowed "
                                                                    "(--allow-outside)"),
                                    {scene}});
        return true;
    }

    /// What stands while a question is open, where the file does not say it: what the question is about.
    [[nodiscard]] Moment usualBefore(const Slide& slide) const
    {
        Moment own = slide.moment;
        own.compare = {};
        own.panels.clear();
        own.overlays.removeAll(key("referee"));
        own.caption = {};
        if (slide.question->kind == QuestionKind::Mistake)
            return own; // the mistake is to be known by its picture
        if (own.settings.contains(key("mistakes"))) {
            own.settings.remove(key("mistakes")); // what the mistake will spoil
            return own;
        }
        const auto& slides = m_lesson.slides;
        const auto former = std::find_if(slides.rbegin(), slides.rend(),
                                         [&](const Slide& other) { return other.level <= slide.level; });
        if (former == slides.rend() || former->moment.scene != own.scene)
            return own;
        Moment shown = former->moment;
        // Only the card of a pixel does not know what comes.
        shown.panels = shown.panels.filter(key("why"));
        return shown;
    }

    static void level(const JsonFields& fields, Slide& slide)
    {
        if (!fields.has(key("level")))
            return;
        slide.level = fields.value(key("level")).toInt();
        if (slide.level != 1 && slide.level != 2)
            fields.wrongType(key("level"), QT_TRANSLATE_NOOP("Diagnostic", "1 (first course) or 2 (second look)"));
    }

    /// Names in braces must be expected, and both languages must name the same ones.
    static void numbers(const JsonFields& fields, const Slide& slide)
    {
        QStringList en = namesIn(slide.moment.caption.en);
        QStringList zh = namesIn(slide.moment.caption.zh);
        for (const QString& name : en + zh)
            if (!expectedNamed(slide, name))
                fields.error(key("caption"),
                             {QT_TRANSLATE_NOOP("Diagnostic", "the caption names {%1}, which \"expect\" does not have"),
                              {name}});
        en.sort();
        zh.sort();
        if (en != zh)
            fields.error(key("caption"), QT_TRANSLATE_NOOP("Diagnostic", "the caption does not have the same numbers "
                                                                         "in both languages"));
    }
};

/// What facts say in words, as Chinese captions have it.
constexpr std::pair<const char*, const char*> kWordsInChinese[] = {
    {"near", "近"},
    {"far", "远"},
    {"left", "左"},
    {"right", "右"},
    {"bottom", "下"},
    {"top", "上"},
    {"rasterized", "已光栅化"},
    {"rejected", "丢弃"},
    {"culled-back", "作为背面剔除"},
    {"culled-front", "作为正面剔除"},
    {"degenerate", "没有面积"},
};

/// Ids in Chinese, and lists with the comma that Chinese lists have.
QString inChinese(const QString& fact)
{
    const auto found =
        std::ranges::find_if(kWordsInChinese, [&](const auto& pair) { return fact == QLatin1String(pair.first); });
    return found == std::end(kWordsInChinese) ? QString(fact).replace(QLatin1String("), ("), QStringLiteral(")\u3001("))
                                              : QString::fromUtf8(found->second);
}

QString withNumbers(QString text, const Slide& slide, QString (*word)(const QString&))
{
    for (const Expected& expected : slide.expected)
        text.replace(QLatin1Char('{') + expected.text + QLatin1Char('}'), word(unbroken(factText(expected.is))));
    return text;
}

/// Names of the built-in files without their number and suffix, and their paths.
std::vector<std::pair<QString, QString>> builtinFiles()
{
    std::vector<std::pair<QString, QString>> files;
    const QDir folder(QString::fromLatin1(kFolder));
    for (const QString& name : folder.entryList({QStringLiteral("*.json")}, QDir::Files, QDir::Name))
        files.emplace_back(QFileInfo(name).baseName().section(QLatin1Char('_'), 1), folder.filePath(name));
    return files;
}

} // namespace

QStringList lessonIds()
{
    QStringList ids;
    for (const auto& [id, path] : builtinFiles())
        ids << id;
    return ids;
}

std::vector<LessonTitle> lessonTitles()
{
    std::vector<LessonTitle> titles;
    for (const auto& [id, path] : builtinFiles()) {
        const QJsonObject title =
            QJsonDocument::fromJson(readInput(path).bytes).object().value(key("title")).toObject();
        titles.push_back({id, {title.value(key("en")).toString(), title.value(key("zh")).toString()}});
    }
    return titles;
}

bool isLesson(const QString& path)
{
    constexpr qint64 kLooked = 4096;
    QFile file(path);
    const bool mayBe = path.endsWith(QLatin1String(".json"), Qt::CaseInsensitive) && QFileInfo(path).isFile();
    return mayBe && file.open(QIODevice::ReadOnly) && file.read(kLooked).contains("\"rasterlens-lesson\"");
}

LessonLoad loadLesson(const QString& name)
{
    QString path = name;
    for (const auto& [id, file] : builtinFiles())
        if (id == name)
            path = file;
    const bool isFile = path != name || path.endsWith(QLatin1String(".json"), Qt::CaseInsensitive);
    DiagnosticSink sink(path);
    if (!isFile) {
        sink.error(0, {QT_TRANSLATE_NOOP("Diagnostic", "there is no such lesson; expected a .json file or one of: %1"),
                       {lessonIds().join(QStringLiteral(", "))}});
        return {std::nullopt, sink.take()};
    }
    InputBytes input = readInput(path);
    if (input.problem) {
        sink.error(0, *input.problem);
        return {std::nullopt, sink.take()};
    }
    return lessonFromJson(std::move(input.bytes), path);
}

LessonLoad lessonFromJson(QByteArray text, const QString& file)
{
    constexpr int kAll = 1000; // each fault is named
    DiagnosticSink sink(file, kAll);
    if (const auto problem = takeOffByteOrderMark(text)) {
        sink.error(0, *problem);
        return {std::nullopt, sink.take()};
    }
    QJsonParseError error;
    const QJsonDocument document = QJsonDocument::fromJson(text, &error);
    if (error.error != QJsonParseError::NoError || !document.isObject()) {
        const QByteArray before = text.left(error.offset);
        const int line = document.isArray() ? 1 : 1 + static_cast<int>(before.count('\n'));
        const QString what =
            document.isArray() ? QStringLiteral("{\"rasterlens-lesson\": 1, ..}") : error.errorString();
        sink.error(line, {QT_TRANSLATE_NOOP("Diagnostic", "broken JSON: %1"), {what}});
        return {std::nullopt, sink.take()};
    }
    const JsonLines lines(text);
    reportRepeatedKeys(lines, sink);
    const JsonFields fields(document.object(), {}, lines, sink);
    Lesson lesson = LessonReader(fields, file).read();
    if (sink.hasErrors())
        return {std::nullopt, sink.take()};
    return {std::move(lesson), sink.take()};
}

TwoTexts textWithNumbers(const TwoTexts& text, const Slide& slide)
{
    return {withNumbers(text.en, slide, [](const QString& fact) { return fact; }),
            withNumbers(text.zh, slide, inChinese)};
}

TwoTexts factInWords(const FactValue& value)
{
    constexpr int kDigits = 4; // as captions have them
    const auto* number = std::get_if<double>(&value);
    const QString fact = number && *number != std::round(*number) && std::abs(*number) < std::pow(10, kDigits)
                             ? factText(QString::number(*number, 'g', kDigits).toDouble())
                             : unbroken(textOf(value));
    return {fact, inChinese(fact)};
}

const char* questionKindId(QuestionKind kind) { return kQuestionKinds[static_cast<std::size_t>(kind)].id; }

} // namespace rasterlens
