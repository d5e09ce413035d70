#pragma once
#include <QString>

#include <vector>

namespace rasterlens
{

enum class Severity { Warning, Error };

/// One remark about an input, in the form `FILE:LINE: what is wrong and what is expected`.
struct Diagnostic {
    Severity severity = Severity::Error;
    QString file;
    int line = 0; ///< counted from 1; 0 = the file as a whole
    QString message;

    /// `FILE:LINE: message`, or `FILE: message` where no line is known. Not translated.
    [[nodiscard]] QString text() const;
};

using Diagnostics = std::vector<Diagnostic>;

[[nodiscard]] bool hasErrors(const Diagnostics& diagnostics);

} // namespace rasterlens
