#include "app/cli/options.h"

#include "app/cli/failure.h"
#include "app/cli/output.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace rasterlens::cli
{
namespace
{

constexpr qsizetype kHelpWidth = 100;
constexpr qsizetype kHelpColumn = 26;

/// Letters to insert, drop or change to make one word of the other (Levenshtein).
std::size_t editDistance(const QString& a, const QString& b)
{
    std::vector<std::size_t> row(static_cast<std::size_t>(b.size()) + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (qsizetype i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0]++;
        for (std::size_t j = 1; j < row.size(); ++j) {
            const std::size_t change = diagonal + (a[i] == b[static_cast<qsizetype>(j) - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, change});
        }
    }
    return row.back();
}

QString program(const Usage& usage) { return QStringLiteral("rasterlens-cli ") + usage.verb; }

[[noreturn]] void failUnknown(const Usage& usage, const QString& name)
{
    const auto similar = mostSimilar(name, optionNames(usage));
    const QString hint = similar ? QStringLiteral("did you mean %1?").arg(*similar)
                                 : QStringLiteral("\"%1 --help\" lists all").arg(program(usage));
    failArguments(QStringLiteral("%1: there is no option %2; %3").arg(program(usage), name, hint));
}

bool isTruth(const QString& word) { return word == QLatin1String("true") || word == QLatin1String("false"); }

/// The words still to be read.
class WordReader
{
public:
    WordReader(const Usage& usage, const QStringList& words) : m_usage(usage), m_words(words) {}

    Arguments read()
    {
        bool optionsEnded = false;
        while (m_next < m_words.size()) {
            const QString word = m_words[m_next++];
            if (optionsEnded || !word.startsWith(QLatin1Char('-')) || word == QLatin1String("-"))
                m_arguments.operands << word;
            else if (word == QLatin1String("--"))
                optionsEnded = true;
            else
                readOption(word);
        }
        checkOperands();
        return m_arguments;
    }

private:
    const Usage& m_usage;
    const QStringList& m_words;
    qsizetype m_next = 0;
    Arguments m_arguments;

    void readOption(const QString& word)
    {
        const qsizetype equals = word.indexOf(QLatin1Char('='));
        const QString name = word.left(equals);
        const Option* option = findOption(m_usage, name);
        if (!option)
            failUnknown(m_usage, name);
        if (equals >= 0)
            m_arguments.add(name, checkedValue(*option, word.mid(equals + 1)));
        else if (option->kind == Option::Kind::Switch)
            m_arguments.add(name, nextIsTruth() ? m_words[m_next++] : QStringLiteral("true"));
        else
            m_arguments.add(name, checkedValue(*option, nextValue(*option)));
    }

    bool nextIsTruth() const { return m_next < m_words.size() && isTruth(m_words[m_next]); }

    QString nextValue(const Option& option)
    {
        if (m_next == m_words.size() || m_words[m_next].startsWith(QLatin1String("--")))
            failMissing(option);
        return m_words[m_next++];
    }

    QString checkedValue(const Option& option, const QString& value) const
    {
        if (value.isEmpty())
            failMissing(option);
        if (option.kind == Option::Kind::Switch && !isTruth(value))
            failArguments(QStringLiteral("%1: \"%2\" is not a value of %3, which takes: true, false")
                              .arg(program(m_usage), value, option.name));
        return value;
    }

    [[noreturn]] void failMissing(const Option& option) const
    {
        failArguments(
            QStringLiteral("%1: %2 needs a value: %2 %3").arg(program(m_usage), option.name, option.valueName));
    }

    void checkOperands() const
    {
        const QStringList& given = m_arguments.operands;
        if (given.size() < m_usage.operands.size())
            failArguments(QStringLiteral("%1: %2 is missing; expected: %3")
                              .arg(program(m_usage), m_usage.operands[given.size()], m_usage.synopsis));
        if (given.size() > m_usage.operands.size() && !m_usage.manyOperands)
            failArguments(QStringLiteral("%1: \"%2\" is one argument too many; expected: %3")
                              .arg(program(m_usage), given[m_usage.operands.size()], m_usage.synopsis));
        for (const QString& operand : given)
            if (operand.isEmpty())
                failArguments(
                    QStringLiteral("%1: an argument is empty; expected: %2").arg(program(m_usage), m_usage.synopsis));
    }
};

QString optionHelp(const Option& option)
{
    QString left = QStringLiteral("  ") + option.name;
    if (!option.valueName.isEmpty())
        left += QLatin1Char(' ') + option.valueName;
    QStringList lines;
    for (const QString& line : option.help.split(QLatin1Char('\n')))
        lines << wrap(line, kHelpWidth - kHelpColumn);
    QString text;
    if (left.size() >= kHelpColumn - 1) {
        text = left + QLatin1Char('\n');
        left.clear();
    }
    for (const QString& line : std::as_const(lines)) {
        text += left.leftJustified(kHelpColumn) + line + QLatin1Char('\n');
        left.clear();
    }
    return text;
}

QString paragraphs(const QString& text)
{
    QStringList lines;
    for (const QString& line : text.split(QLatin1Char('\n')))
        lines << wrap(line, kHelpWidth);
    return lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

} // namespace

const Option* findOption(const Usage& usage, const QString& name)
{
    for (const OptionGroup& group : usage.groups)
        for (const Option& option : group.options)
            if (option.name == name)
                return &option;
    return nullptr;
}

QStringList optionNames(const Usage& usage)
{
    QStringList names{QStringLiteral("--help")};
    for (const OptionGroup& group : usage.groups)
        for (const Option& option : group.options)
            names << option.name;
    return names;
}

std::optional<QString> Arguments::value(const QString& name) const
{
    const QStringList all = values(name);
    return all.isEmpty() ? std::nullopt : std::optional(all.last());
}

QStringList Arguments::values(const QString& name) const
{
    QStringList found;
    for (const auto& [key, value] : m_values)
        if (key == name)
            found << value;
    return found;
}

std::optional<Arguments> parseArguments(const Usage& usage, const QStringList& words)
{
    const QStringList beforeEnd = words.mid(0, words.indexOf(QStringLiteral("--")));
    if (beforeEnd.contains(QLatin1String("--help")) || beforeEnd.contains(QLatin1String("-h"))) {
        printText(helpText(usage));
        return std::nullopt;
    }
    return WordReader(usage, words).read();
}

QString helpText(const Usage& usage)
{
    QString text = QStringLiteral("Usage: ") + usage.synopsis + QStringLiteral("\n\n") + paragraphs(usage.description);
    for (const OptionGroup& group : usage.groups) {
        text += QLatin1Char('\n') + group.title + QLatin1Char('\n');
        for (const Option& option : group.options)
            text += optionHelp(option);
    }
    if (!usage.notes.isEmpty())
        text += QLatin1Char('\n') + paragraphs(usage.notes);
    return text;
}

std::optional<QString> mostSimilar(const QString& word, const QStringList& names)
{
    std::optional<QString> best;
    std::size_t bestDistance = std::max<std::size_t>(1, static_cast<std::size_t>(word.size()) / 3) + 1;
    for (const QString& name : names)
        if (const std::size_t distance = editDistance(word, name); distance < bestDistance) {
            best = name;
            bestDistance = distance;
        }
    return best;
}

QStringList wrap(const QString& text, qsizetype width)
{
    QStringList lines;
    QString line;
    const qsizetype indent = std::find_if(text.begin(), text.end(), [](QChar c) { return c != u' '; }) - text.begin();
    for (const QString& word : text.split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
        if (!line.isEmpty() && line.size() + 1 + word.size() > width) {
            lines << line;
            line.clear();
        }
        line += (line.isEmpty() ? QString(indent, QLatin1Char(' ')) : QStringLiteral(" ")) + word;
    }
    lines << line;
    return lines;
}

} // namespace rasterlens::cli
