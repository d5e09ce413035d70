#include "core/diagnostics.h"

#include <algorithm>

namespace rasterlens
{

QString Diagnostic::text() const
{
    const QString place = line > 0 ? QStringLiteral("%1:%2").arg(file).arg(line) : file;
    return severity == Severity::Warning ? QStringLiteral("%1: warning: %2").arg(place, message)
                                         : QStringLiteral("%1: %2").arg(place, message);
}

bool hasErrors(const Diagnostics& diagnostics)
{
    return std::any_of(diagnostics.begin(), diagnostics.end(),
                       [](const Diagnostic& d) { return d.severity == Severity::Error; });
}

} // namespace rasterlens
