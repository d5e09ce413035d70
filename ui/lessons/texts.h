#pragma once
#include "core/lessons/lesson.h"

#include <QString>

#include <optional>

namespace rasterlens
{

/// In the language that the program shows.
[[nodiscard]] QString textInUse(const TwoTexts& texts);

/// The text of a choice: its sentence, or number and title of its mistake.
[[nodiscard]] QString choiceText(const QuestionChoice& choice);

/// The built-in lesson behind another one; nothing behind the last and behind a lesson of the user's own.
[[nodiscard]] std::optional<LessonTitle> lessonAfter(const QString& id);

/// The first sentence, for lists.
[[nodiscard]] QString firstSentence(const QString& text);

} // namespace rasterlens
