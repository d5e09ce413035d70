#pragma once
#include <QString>

namespace rasterlens
{

/// The note of a case of the catalogue in the language in use, line by line; other notes come back as they are.
[[nodiscard]] QString caseNoteText(const QString& note);

/// The title of a case of the catalogue in the language in use: `001 edges four quarters` of `001_edges_four_quarters`;
/// other names come back as they are.
[[nodiscard]] QString caseTitle(const QString& name);

} // namespace rasterlens
