// What is found out about a lesson by drawing its slides.
#include "core/lessons/lesson.h"

#include <QCoreApplication>

#include <algorithm>

namespace rasterlens
{
namespace
{

/// The sentences about one slide.
class SlideCheck
{
public:
    SlideCheck(const Slide& slide, std::size_t number, DiagnosticSink& sink)
        : m_slide(slide), m_number(number), m_sink(sink)
    {
    }

    void run()
    {
        if (m_slide.before)
            (void)draws(*m_slide.before);
        const auto open = draws(m_slide.moment);
        if (!open)
            return;
        MomentFacts facts(m_slide.moment, *open);
        for (const Expected& expected : m_slide.expected)
            check(expected, facts);
        if (m_slide.question)
            answer(*m_slide.question, facts);
    }

private:
    const Slide& m_slide;
    std::size_t m_number;
    DiagnosticSink& m_sink;

    void fault(int line, Reason what)
    {
        m_sink.error(line, {QT_TRANSLATE_NOOP("Diagnostic", "slide %1: %2"), {m_number, std::move(what)}});
    }

    std::optional<OpenMoment> draws(const Moment& moment)
    {
        OpenMomentLoad load = openMoment(moment);
        for (const Diagnostic& diagnostic : load.diagnostics)
            if (diagnostic.severity == Severity::Error)
                fault(m_slide.line, diagnostic.message);
        if (!load.moment)
            return std::nullopt;
        MomentFacts facts(moment, *load.moment);
        if (moment.step && !facts.position())
            fault(m_slide.line,
                  {QT_TRANSLATE_NOOP("Diagnostic", "the record has no step \"%1\""), {textOf(*moment.step)}});
        else if (facts.picture().isNull())
            fault(m_slide.line, QT_TRANSLATE_NOOP("Diagnostic", "the picture is not drawn"));
        if (moment.pixel && !facts.holds(*moment.pixel))
            fault(m_slide.line, {QT_TRANSLATE_NOOP("Diagnostic", "pixel %1,%2 lies outside the picture"),
                                 {moment.pixel->x(), moment.pixel->y()}});
        return std::move(load.moment);
    }

    void check(const Expected& expected, MomentFacts& facts)
    {
        const auto value = facts.find(expected.fact);
        if (!value)
            fault(expected.line, {QT_TRANSLATE_NOOP("Diagnostic", "there is no \"%1\" here"), {expected.text}});
        else if (!agrees(*value, expected.is))
            fault(expected.line, {QT_TRANSLATE_NOOP("Diagnostic", "\"%1\" is %2, not %3"),
                                  {expected.text, textOf(*value), factText(expected.is)}});
    }

    void answer(const Question& question, MomentFacts& facts)
    {
        if (!question.answer)
            return;
        const auto answer = answerOf(question, facts);
        if (!answer)
            fault(question.line,
                  {QT_TRANSLATE_NOOP("Diagnostic", "the question has no answer: \"%1\""), {question.answer->text}});
        else if (!question.answer->is.isUndefined() && !agrees(answer->value, question.answer->is))
            fault(question.line, {QT_TRANSLATE_NOOP("Diagnostic", "\"%1\" is %2, not %3"),
                                  {question.answer->text, textOf(answer->value), factText(question.answer->is)}});
    }
};

} // namespace

std::optional<Answer> answerOf(const Question& question, MomentFacts& facts)
{
    const auto value = question.answer ? facts.find(question.answer->fact) : std::nullopt;
    if (!value)
        return std::nullopt;
    if (question.choices.empty())
        return Answer{*value, std::nullopt};
    const auto right =
        std::ranges::find_if(question.choices, [&](const QuestionChoice& choice) { return agrees(*value, choice.is); });
    if (right == question.choices.end())
        return std::nullopt;
    return Answer{*value, static_cast<std::size_t>(right - question.choices.begin())};
}

Diagnostics checkSlides(const Lesson& lesson)
{
    constexpr int kAll = 1000; // each fault is named
    DiagnosticSink sink(lesson.file, kAll);
    for (std::size_t i = 0; i < lesson.slides.size(); ++i)
        SlideCheck(lesson.slides[i], i + 1, sink).run();
    return sink.take();
}

} // namespace rasterlens
