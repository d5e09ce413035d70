#pragma once
#include "core/base/reason.h"

#include <QString>

#include <vector>

namespace rasterlens
{

/// A note says what is worth knowing though nothing is wrong; `info` tells notes, other commands and the window do not.
enum class Severity { Note, Warning, Error };

/// One remark about an input, in the form `FILE:LINE: what is wrong and what is expected`.
struct Diagnostic {
    Severity severity = Severity::Error;
    QString file;
    int line = 0;   ///< counted from 1; 0 = the file as a whole
    Reason message; ///< texts of the context "Diagnostic"

    /// `FILE:LINE: message`, or `FILE: message` where no line is known; in English without `translate`.
    [[nodiscard]] QString text(Translate translate = nullptr) const;
};

using Diagnostics = std::vector<Diagnostic>;

[[nodiscard]] bool hasErrors(const Diagnostics& diagnostics);

/// All but the notes.
[[nodiscard]] Diagnostics withoutNotes(Diagnostics diagnostics);

} // namespace rasterlens
