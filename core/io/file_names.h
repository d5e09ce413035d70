#pragma once
#include "core/io/path_bytes.h"
#include "core/io/reach.h"

#include <QByteArray>
#include <QString>

#include <string_view>

namespace rasterlens
{

class DiagnosticSink;

[[nodiscard]] bool fileExists(const QString& path);

enum class FoundBy {
    Name,       ///< as it is written, with slashes for backslashes
    Encoding,   ///< its name on the disk has another encoding
    Beside,     ///< without the folder that is written
    LetterCase, ///< its name on the disk has other letters large
    Nothing,
    Outside, ///< its name leads out of the reach; nothing of that name is within
};

struct NamedFile {
    QString path; ///< absolute; where it is not found, where it was expected
    FoundBy foundBy = FoundBy::Nothing;

    [[nodiscard]] bool isFound() const;
};

/// Where the file lies that a text in the file `owner` names.
///
/// in      the name's bytes, with or without quotes; where files may lie
/// covers  names relative to the owner's folder and absolute ones, backslashes; UTF-8, GB18030, Latin-1
[[nodiscard]] NamedFile findNamedFile(const QString& owner, std::string_view name, const Reach& reach);

/// Says where a file was found if that is not where its name says: a warning about letter case, a note about the
/// folder.
///
/// in   the statement that names it, and its line
void remarkOn(const NamedFile& file, std::string_view keyword, int line, DiagnosticSink& diagnostics);

} // namespace rasterlens
