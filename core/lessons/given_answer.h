#pragma once
#include "core/lessons/lesson.h"

#include <QByteArray>
#include <QPoint>
#include <QString>

#include <cstddef>
#include <span>
#include <variant>
#include <vector>

namespace rasterlens
{

/// An answer as it was given: the pixels that were clicked, the index of a choice, or a text that was typed.
using GivenAnswer = std::variant<std::vector<QPoint>, std::size_t, QString>;

/// Whether it is the answer. Typed whole numbers must be equal, others agree within a hundredth.
[[nodiscard]] bool isRight(const GivenAnswer& given, const Answer& answer);

/// Whether a number was typed that is the answer, rounded to fewer digits than isRight() takes: 0.3 for 0.3333.
[[nodiscard]] bool hasTooFewDigits(const GivenAnswer& given, const Answer& answer);

/// `4 of 8, 1 too many`: how many of the pixels were found.
struct PixelScore {
    std::size_t found = 0;
    std::size_t wanted = 0;
    std::size_t extra = 0;
};
[[nodiscard]] PixelScore scoreOf(const std::vector<QPoint>& given, const std::vector<QPoint>& right);

/// One line of the list of answers: no name of a person, no time.
struct AnswerRow {
    QString lesson;        ///< id
    std::size_t slide = 0; ///< counted from 1
    QString kind;          ///< id of the kind of question
    QString given;         ///< empty: the picture was shown without an answer
    QString right;
    bool isRight = false;
};

/// An answer in words: `4`, `(3, 4), (4, 3)`, the English text or the mistake's id of a choice.
[[nodiscard]] QString textOf(const Question& question, const GivenAnswer& given);
[[nodiscard]] QString textOf(const Question& question, const Answer& answer);

/// The list as CSV: `lesson,slide,kind,given,right,is_right`, UTF-8.
[[nodiscard]] QByteArray answersAsCsv(std::span<const AnswerRow> rows);

} // namespace rasterlens
