#pragma once
#include "core/lessons/lesson.h"

#include <QString>

namespace rasterlens
{

/// In the language that the program shows.
[[nodiscard]] QString textInUse(const TwoTexts& texts);

/// The text of a choice: its sentence, or number and title of its mistake.
[[nodiscard]] QString choiceText(const QuestionChoice& choice);

/// The first sentence, for lists.
[[nodiscard]] QString firstSentence(const QString& text);

} // namespace rasterlens
