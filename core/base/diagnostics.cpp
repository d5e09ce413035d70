#include "core/base/diagnostics.h"

#include <algorithm>

namespace rasterlens
{

QString Diagnostic::text(Translate translate) const
{
    const QString place = line > 0 ? QStringLiteral("%1:%2").arg(file, QString::number(line)) : file;
    const char* words = QT_TRANSLATE_NOOP("Diagnostic", "%1: %2");
    switch (severity) {
    case Severity::Note: words = QT_TRANSLATE_NOOP("Diagnostic", "%1: note: %2"); break;
    case Severity::Warning: words = QT_TRANSLATE_NOOP("Diagnostic", "%1: warning: %2"); break;
    case Severity::Error: break;
    }
    return textOf(Reason{words, {place, message}}, translate);
}

bool hasErrors(const Diagnostics& diagnostics)
{
    return std::any_of(diagnostics.begin(), diagnostics.end(),
                       [](const Diagnostic& d) { return d.severity == Severity::Error; });
}

Diagnostics withoutNotes(Diagnostics diagnostics)
{
    std::erase_if(diagnostics, [](const Diagnostic& d) { return d.severity == Severity::Note; });
    return diagnostics;
}

} // namespace rasterlens
