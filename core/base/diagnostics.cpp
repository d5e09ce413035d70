#include "core/base/diagnostics.h"

#include <algorithm>

namespace rasterlens
{

QString Diagnostic::text(Translate translate) const
{
    const QString place = line > 0 ? QStringLiteral("%1:%2").arg(file, QString::number(line)) : file;
    const char* words = severity == Severity::Warning ? QT_TRANSLATE_NOOP("Diagnostic", "%1: warning: %2")
                                                      : QT_TRANSLATE_NOOP("Diagnostic", "%1: %2");
    return textOf(Reason{words, {place, message}}, translate);
}

bool hasErrors(const Diagnostics& diagnostics)
{
    return std::any_of(diagnostics.begin(), diagnostics.end(),
                       [](const Diagnostic& d) { return d.severity == Severity::Error; });
}

} // namespace rasterlens
