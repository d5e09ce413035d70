#include "ui/base/step_words.h"

#include "core/observe/because.h"
#include "ui/base/numbers.h"

#include <QCoreApplication>

namespace rasterlens
{
namespace
{

/// Titles of mistakes have a context of their own.
QString translated(const char* text)
{
    const QString words = QCoreApplication::translate("Steps", text);
    return words == QString::fromUtf8(text) ? QCoreApplication::translate("Mistake", text) : words;
}

} // namespace

QString stepWords(const Reason& said) { return printedSigns(textOf(said, translated)); }

QString momentText(const std::optional<std::size_t>& step)
{
    return step ? translated(QT_TRANSLATE_NOOP("Steps", "after step %1")).arg(grouped(*step))
                : translated(QT_TRANSLATE_NOOP("Steps", "finished frame"));
}

QString becauseWords(std::span<const Mistake* const> mistakes) { return textOf(becauseText(mistakes), translated); }

} // namespace rasterlens
