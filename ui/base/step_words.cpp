#include "ui/base/step_words.h"

#include "core/observe/because.h"
#include "core/observe/names.h"
#include "core/observe/step_text.h"
#include "ui/base/numbers.h"

#include <QColor>
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

QStringList storedWords(const ResolvedPixel& pixel)
{
    QStringList lines;
    for (int i = 0; i < pixel.count; ++i) {
        const Pixel& sample = pixel.samples[std::size_t(i)];
        const QColor color{QRgb(sample.color)};
        QString line = QStringLiteral("%1: (%2, %3, %4)  z %5")
                           .arg(i + 1)
                           .arg(color.red())
                           .arg(color.green())
                           .arg(color.blue())
                           .arg(depthNumber(sample.depth));
        if (pixel.counted(i) != sample.color)
            line += QStringLiteral("  ") + translated(QT_TRANSLATE_NOOP("Steps", "counts as black"));
        lines << line;
    }
    return lines;
}

QStringList meanWords(const ResolvedPixel& pixel)
{
    QStringList lines = meanSums(pixel);
    for (QString& line : lines)
        line = printedSigns(line);
    return lines;
}

QString momentText(const std::optional<std::size_t>& step)
{
    return step ? translated(QT_TRANSLATE_NOOP("Steps", "after step %1")).arg(grouped(*step))
                : translated(QT_TRANSLATE_NOOP("Steps", "finished frame"));
}

QString becauseWords(std::span<const Mistake* const> mistakes) { return textOf(becauseText(mistakes), translated); }

} // namespace rasterlens
