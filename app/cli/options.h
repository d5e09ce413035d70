#pragma once
#include <QList>
#include <QString>
#include <QStringList>

#include <optional>

namespace rasterlens::cli
{

/// One option of a verb.
struct Option {
    enum class Kind {
        Value,  ///< `--size 640x480` or `--size=640x480`; the last one counts
        List,   ///< a Value that may repeat, all count
        Switch, ///< `--reversed-z`, also `--reversed-z true` and `--reversed-z=false`
    };

    QString name; ///< with its dashes: `--size`, `-o`
    Kind kind = Kind::Value;
    QString valueName; ///< for the help: `WxH`, `FILE`
    QString help;      ///< sentences; a line break starts a new line
};

/// A headline and its options, for the help.
struct OptionGroup {
    QString title;
    QList<Option> options;
};

/// The words of a command line, sorted.
class Arguments
{
public:
    QStringList operands; ///< words that belong to no option

    void add(const QString& name, const QString& value) { m_values.append({name, value}); }
    [[nodiscard]] bool has(const QString& name) const { return value(name).has_value(); }
    /// The last value given.
    [[nodiscard]] std::optional<QString> value(const QString& name) const;
    [[nodiscard]] QStringList values(const QString& name) const;
    [[nodiscard]] bool isOn(const QString& name) const { return value(name) == QLatin1String("true"); }

private:
    QList<std::pair<QString, QString>> m_values;
};

/// What a verb takes; `--help` needs not be listed.
struct Usage {
    QString verb;
    QString synopsis;     ///< `rasterlens-cli render SCENE [-o out.png] [options]`
    QString description;  ///< paragraphs
    QStringList operands; ///< names of the operands, all of them required
    QList<OptionGroup> groups;
    QString notes;             ///< paragraphs below the options
    bool manyOperands = false; ///< any number of operands beyond those
};

/// The option of that name, or null.
[[nodiscard]] const Option* findOption(const Usage& usage, const QString& name);

/// The names of all options, `--help` among them.
[[nodiscard]] QStringList optionNames(const Usage& usage);

/// Sorts the words. `--` ends the options; a lone `-` is a value or an operand.
///
/// out     nothing when the words ask for help, which has then been printed
/// errors  throws Failure: unknown option (with the most similar one), value missing or not wanted, too few or too many
///         operands
[[nodiscard]] std::optional<Arguments> parseArguments(const Usage& usage, const QStringList& words);

/// The text of `--help`, 100 columns wide.
[[nodiscard]] QString helpText(const Usage& usage);

/// The name most like `word`, if it is like it at all.
[[nodiscard]] std::optional<QString> mostSimilar(const QString& word, const QStringList& names);

/// Breaks a text into lines of at most `width` characters where it has spaces.
[[nodiscard]] QStringList wrap(const QString& text, qsizetype width);

} // namespace rasterlens::cli
