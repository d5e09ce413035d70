#pragma once
#include <QString>

namespace rasterlens
{

/// The note of a case of the catalogue in the language in use, line by line; other notes come back as they are.
[[nodiscard]] QString caseNoteText(const QString& note);

} // namespace rasterlens
