#pragma once
#include "core/lessons/facts.h"
#include "core/lessons/moment.h"

#include <QByteArray>
#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

namespace rasterlens
{

/// A fact that a slide speaks of, and what it says of it.
struct Expected {
    QString text; ///< as the file has it: `winner 3,4`
    FactName fact;
    QJsonValue is;
    int line = 0; ///< in the lesson's file
};

/// What a question asks for.
enum class QuestionKind {
    Pixels,  ///< click the pixels; the answer is a set of them
    NextP,   ///< the next value of p on a line
    Winner,  ///< which face is seen
    Corners, ///< how many corners
    Mistake, ///< which mistake; the choices are ids of mistakes
    Number,  ///< any other number
    Choice,  ///< one of some sentences
};

struct QuestionChoice {
    TwoTexts text;   ///< of a Mistake question: its title, which both programs translate, and empty here
    QString mistake; ///< Mistake only: the id
    QJsonValue is;   ///< the choice is right where the answer's fact is this
};

/// A question that is asked before the slide's picture is shown.
struct Question {
    QuestionKind kind = QuestionKind::Number;
    TwoTexts text;
    std::optional<Expected> answer; ///< the fact that answers it; `is` where the file types it as well, else undefined
    std::vector<QuestionChoice> choices; ///< Mistake and Choice only
    int line = 0;
};

struct Slide {
    Moment moment; ///< shown once the question, if there is one, is answered
    int level = 1; ///< 1: first course; 2: only at a second look
    std::vector<Expected> expected;
    std::optional<Question> question;
    std::optional<Moment> before; ///< shown while the question is open; of a slide with a question, always there
    int line = 0;                 ///< in the lesson's file
};

struct Lesson {
    QString id;
    TwoTexts title;
    QString source; ///< the text and its items that the lesson follows: `[000] 0.1 to 0.13`
    std::vector<Slide> slides;
    QString file; ///< path, of a built-in lesson that of the resource
};

struct LessonLoad {
    std::optional<Lesson> lesson; ///< empty when diagnostics hold an error
    Diagnostics diagnostics;
};

/// The built-in lessons (resources/lessons) by id, in their order.
[[nodiscard]] QStringList lessonIds();

/// What a list of lessons shows of one.
struct LessonTitle {
    QString id;
    TwoTexts title;
};
/// The built-in lessons in their order; their slides are not read.
[[nodiscard]] std::vector<LessonTitle> lessonTitles();

/// Whether a file is meant as a lesson, be it a broken one: its text names the key `rasterlens-lesson`.
[[nodiscard]] bool isLesson(const QString& path);

/// Opens a built-in lesson by its id, or a file by its path.
///
/// errors  in the diagnostics, with file and line: what is no JSON, unknown keys, wrong types, names that do not exist,
///         facts and kinds of questions that do not exist, a language that is missing
[[nodiscard]] LessonLoad loadLesson(const QString& name);

/// A lesson from the bytes of a file.
[[nodiscard]] LessonLoad lessonFromJson(QByteArray text, const QString& file);

/// A caption or a question with the numbers that the slide expects in place of their names: `{hit-twice}`.
[[nodiscard]] TwoTexts textWithNumbers(const TwoTexts& text, const Slide& slide);

/// A fact as a sentence has it, with four digits; in Chinese ids are words, and pixels have the comma of lists between
/// them.
[[nodiscard]] TwoTexts factInWords(const FactValue& value);

/// The answer in words, and the index of the right choice where there are choices; computed from the slide's moment.
struct Answer {
    FactValue value;
    std::optional<std::size_t> choice;
};
/// errors  nothing where the moment does not have the fact or no choice has its value
[[nodiscard]] std::optional<Answer> answerOf(const Question& question, MomentFacts& facts);

/// The id of a kind of question: `next-p`.
[[nodiscard]] const char* questionKindId(QuestionKind kind);

/// What is wrong with the slides of a lesson, found by drawing each of them: a scene or settings that cannot be drawn,
/// a step that the record does not have, a fact that is not as the slide says, an answer that is not as the file types
/// it.
///
/// cost  as MomentFacts, for each slide
[[nodiscard]] Diagnostics checkSlides(const Lesson& lesson);

} // namespace rasterlens
