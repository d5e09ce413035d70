#include "core/page/page_lesson.h"

#include "core/lessons/given_answer.h"
#include "core/observe/step_cursor.h"
#include "core/render/render.h"
#include "core/render/steps.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QJsonDocument>

#include <algorithm>
#include <memory>
#include <utility>

namespace rasterlens
{
namespace
{

/// What tells one run from another: the scene with its vertices, the settings, and the picture that it is compared
/// with.
QByteArray keyOf(const Scene& scene, const Settings& settings, const std::optional<Settings>& other)
{
    QCryptographicHash hash(QCryptographicHash::Sha1);
    hash.addData(scene.id.toUtf8());
    hash.addData(QByteArray::fromRawData(reinterpret_cast<const char*>(scene.mesh.vertices.data()),
                                         static_cast<qsizetype>(scene.mesh.vertices.size() * sizeof(MeshVertex))));
    for (const Settings* part : {&settings, other ? &*other : nullptr})
        if (part != nullptr)
            hash.addData(QJsonDocument(toJson(*part)).toJson(QJsonDocument::Compact));
    return hash.result();
}

QImage pictureOf(const Scene& scene, const Settings& settings)
{
    Frame frame;
    render(scene, settings, frame);
    return frame.image.copy();
}

std::shared_ptr<const Scene> lent(const Scene& scene) { return {std::shared_ptr<const Scene>(), &scene}; }

QJsonObject answerJson(const Answer& answer, TextTable& texts)
{
    if (answer.choice)
        return {{"choice", static_cast<qint64>(*answer.choice)}};
    QJsonObject object{{"words", texts.add(factInWords(answer.value))}};
    if (const auto* pixels = std::get_if<std::vector<QPoint>>(&answer.value)) {
        QJsonArray places;
        for (const QPoint pixel : *pixels)
            places << QJsonArray{pixel.x(), pixel.y()};
        object.insert(QStringLiteral("pixels"), places);
    } else if (const auto* number = std::get_if<double>(&answer.value)) {
        object.insert(QStringLiteral("value"), *number);
    } else {
        object.insert(QStringLiteral("value"), std::get<QString>(answer.value));
    }
    return object;
}

QJsonObject questionJson(const Slide& slide, const Answer& answer, PageWords& words, TextTable& texts)
{
    const Question& question = *slide.question;
    QJsonArray choices;
    for (const QuestionChoice& choice : question.choices) {
        const Mistake* mistake = findMistake(choice.mistake);
        choices << texts.add(mistake != nullptr ? textInBoth(words, [&] { return words.mistake(*mistake); })
                                                : choice.text);
    }
    QJsonObject object{{"kind", QLatin1String(questionKindId(question.kind))},
                       {"text", texts.add(textWithNumbers(question.text, slide))},
                       {"choices", choices},
                       {"answer", answerJson(answer, texts)}};
    if (const std::optional<QPoint> pixel = question.answer->fact.pixel)
        object.insert(QStringLiteral("pixel"), QJsonArray{pixel->x(), pixel->y()});
    return object;
}

/// One slide; what is wrong with it goes into the diagnostics.
class SlideWriter
{
public:
    SlideWriter(const Lesson& lesson, PageRuns& runs, PageWords& words, TextTable& texts, Diagnostics& diagnostics)
        : m_lesson(lesson), m_runs(runs), m_words(words), m_texts(texts), m_diagnostics(diagnostics)
    {
    }

    /// in  `number`: counted from 1
    [[nodiscard]] QJsonObject json(const Slide& slide, std::size_t number)
    {
        m_number = number;
        const OpenMomentLoad load = openMoment(slide.moment);
        if (!load.moment) {
            fail(slide.line, load.diagnostics);
            return {};
        }
        QJsonObject object = momentJson(slide.moment, *load.moment, slide.line);
        object.insert(QStringLiteral("caption"), m_texts.add(textWithNumbers(slide.moment.caption, slide)));
        object.insert(QStringLiteral("level"), slide.level);
        if (slide.before) {
            const OpenMomentLoad before = openMoment(*slide.before);
            if (before.moment)
                object.insert(QStringLiteral("before"), momentJson(*slide.before, *before.moment, slide.line));
            else
                fail(slide.line, before.diagnostics);
        }
        if (!slide.question)
            return object;
        MomentFacts facts(slide.moment, *load.moment);
        if (const auto answer = answerOf(*slide.question, facts))
            object.insert(QStringLiteral("question"), questionJson(slide, *answer, m_words, m_texts));
        else
            fail(slide.question->line, {QT_TRANSLATE_NOOP("Diagnostic", "the question has no answer: \"%1\""),
                                        {slide.question->answer ? slide.question->answer->text : QString()}});
        return object;
    }

private:
    [[nodiscard]] QJsonObject momentJson(const Moment& moment, const OpenMoment& open, int line)
    {
        if (auto object = m_runs.momentJson(moment, open))
            return *object;
        fail(line, {QT_TRANSLATE_NOOP("Diagnostic", "the record has no step \"%1\""),
                    {moment.step ? textOf(*moment.step) : QString()}});
        return {};
    }

    void fail(int line, Reason message)
    {
        m_diagnostics.push_back({Severity::Error,
                                 m_lesson.file,
                                 line,
                                 {QT_TRANSLATE_NOOP("Diagnostic", "slide %1: %2"), {m_number, std::move(message)}}});
    }
    void fail(int line, const Diagnostics& why)
    {
        for (const Diagnostic& diagnostic : why)
            if (diagnostic.severity == Severity::Error)
                fail(line, diagnostic.message);
    }

    const Lesson& m_lesson;
    PageRuns& m_runs;
    PageWords& m_words;
    TextTable& m_texts;
    Diagnostics& m_diagnostics;
    std::size_t m_number = 0;
};

} // namespace

void PageRuns::addMain(const Scene& scene, const Settings& settings, const StepFilter& filter)
{
    std::optional<Settings> other;
    if (!settings.mistakes.isEmpty()) {
        other = settings;
        other->mistakes.clear();
    }
    const auto log = renderSteps(scene, settings, filter);
    m_runs << runJson(scene, settings, *log, other ? pictureOf(scene, *other) : QImage(), m_words, m_tables);
    if (!filter.face && !filter.pixels && !log->truncated())
        m_known.insert(keyOf(scene, settings, other), {0, log});
}

std::optional<QJsonObject> PageRuns::momentJson(const Moment& moment, const OpenMoment& open)
{
    const bool hasOther = moment.compare.view != MomentCompare::View::Off || !open.settings.mistakes.isEmpty();
    const QByteArray key =
        keyOf(open.scene, open.settings, hasOther ? std::optional(open.other) : std::optional<Settings>());
    auto known = m_known.constFind(key);
    if (known == m_known.constEnd()) {
        StepFilter filter;
        filter.cap = std::min(kMostSlideSteps, kMostLessonSteps - std::min(kMostLessonSteps - 1, m_lessonSteps));
        const auto log = renderSteps(open.scene, open.settings, filter);
        const QImage other = hasOther ? pictureOf(open.scene, open.other) : QImage();
        if (log->truncated())
            return stillMoment(moment, open, *log, other);
        m_lessonSteps += std::min(log->size(), filter.cap);
        m_runs << runJson(open.scene, open.settings, *log, other, m_words, m_tables);
        known = m_known.insert(key, {static_cast<int>(m_runs.size()) - 1, log});
    }
    QJsonObject object{{"run", known->number}};
    if (moment.step) {
        const auto position = positionOf(*moment.step, *known->log);
        if (!position)
            return std::nullopt;
        object.insert(QStringLiteral("step"), static_cast<qint64>(*position) - 1);
    }
    if (moment.pixel)
        object.insert(QStringLiteral("pixel"), QJsonArray{moment.pixel->x(), moment.pixel->y()});
    return object;
}

std::optional<QJsonObject> PageRuns::stillMoment(const Moment& moment, const OpenMoment& open, const StepLog& begun,
                                                 const QImage& other)
{
    PageStill still{{}, &begun, std::nullopt, other, moment.pixel};
    std::optional<StepCursor> cursor;
    if (moment.step) {
        const auto record = recordSteps(lent(open.scene), open.settings);
        const auto position = positionOf(*moment.step, record);
        if (!position)
            return std::nullopt;
        cursor.emplace(record);
        cursor->moveTo(*position);
        still.picture = cursor->image();
        still.log = &cursor->log();
        if (*position > 0)
            still.event = cursor->positionInLog() - 1;
    } else {
        still.picture = pictureOf(open.scene, open.settings);
    }
    m_runs << stillJson(open.scene, open.settings, still, m_words, m_tables);
    QJsonObject object{{"run", m_runs.size() - 1}};
    if (moment.pixel)
        object.insert(QStringLiteral("pixel"), QJsonArray{moment.pixel->x(), moment.pixel->y()});
    return object;
}

QJsonObject lessonJson(const Lesson& lesson, PageRuns& runs, PageWords& words, TextTable& texts,
                       Diagnostics& diagnostics)
{
    SlideWriter writer(lesson, runs, words, texts, diagnostics);
    QJsonArray slides;
    for (const Slide& slide : lesson.slides)
        slides << writer.json(slide, static_cast<std::size_t>(slides.size()) + 1);
    return {{"id", lesson.id}, {"title", texts.add(lesson.title)}, {"slides", slides}};
}

} // namespace rasterlens
