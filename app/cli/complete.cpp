#include "app/cli/options.h"
#include "app/cli/output.h"
#include "app/cli/verbs.h"
#include "core/derive/derive.h"
#include "core/lessons/lesson.h"
#include "core/scenes/builtin_scenes.h"
#include "core/settings/mistakes.h"
#include "core/truth/variants.h"

namespace rasterlens::cli
{
namespace
{

Usage usage()
{
    return {
        QStringLiteral("complete"),
        QStringLiteral("rasterlens-cli complete -- [WORD...]"),
        QStringLiteral("Prints how a command line may go on: what the last WORD may be, a line each. The words are "
                       "those after the program's name. A last line :files says that names of files fit as well.\n\n"
                       "The completion files of bash, zsh and fish call this; they are installed with the program."),
        {},
        {},
        QStringLiteral("Exit codes: 0 fine; 2 bad arguments."),
        true};
}

/// What may stand in a place of the command line.
struct Candidates {
    QStringList words;
    bool files = false; ///< names of files as well
};

const Candidates kFiles{{}, true};

template <class Rows, class Name>
QStringList namesOf(const Rows& rows, Name name, const char* prefix = "")
{
    QStringList names;
    for (const auto& row : rows)
        names << QLatin1String(prefix) + QLatin1String(row.*name);
    return names;
}

Candidates scenes()
{
    return {namesOf(builtinScenes(), &BuiltinScene::name, "builtin:") +
                namesOf(stressScenes(), &StressScene::name, "stress:"),
            true};
}

QStringList choicesOf(const SettingsField& field)
{
    if (field.kind == SettingsField::Kind::Flag)
        return {QStringLiteral("true"), QStringLiteral("false")};
    return namesOf(field.choices, &Choice::id);
}

/// `en|zh` names its values; `X,Y,Z|head` those of small letters.
QStringList valuesIn(const QString& valueName)
{
    QStringList values;
    if (valueName.contains(QLatin1Char('|')))
        for (const QString& value : valueName.split(QLatin1Char('|')))
            if (value == value.toLower())
                values << value;
    return values;
}

/// The values of an option.
Candidates valuesOf(const Option& option)
{
    if (const SettingsField* field = findSettingsField(option.name.mid(2)))
        return {choicesOf(*field), false};
    if (option.name == QLatin1String("--mistake"))
        return {namesOf(mistakes(), &Mistake::id), false};
    if (option.name == QLatin1String("--topic"))
        return {namesOf(derivationTopics(), &DerivationTopicInfo::id), false};
    if (option.name == QLatin1String("--variants"))
        return {namesOf(variants(), &Variant::id), false};
    if (option.name == QLatin1String("--lesson"))
        return {lessonIds(), true};
    if (option.name == QLatin1String("--scene"))
        return scenes();
    if (const QStringList values = valuesIn(option.valueName); !values.isEmpty())
        return {values, false};
    return {{}, option.valueName.contains(QLatin1String("FILE")) || option.valueName.startsWith(QLatin1String("F."))};
}

Candidates operandsOf(const Verb& verb, const QStringList& before)
{
    if (verb.run == runLesson)
        return before.isEmpty()
                   ? Candidates{{QStringLiteral("show"), QStringLiteral("check"), QStringLiteral("handout")}, false}
                   : Candidates{lessonIds(), true};
    return verb.run == runDiff || verb.run == runIdentify ? kFiles : scenes();
}

/// What the last of the words may be.
///
/// in  words  those after the verb, at least one
Candidates candidates(const Verb& verb, const QStringList& words)
{
    const Usage usage = verb.usage();
    QStringList operands;
    for (qsizetype i = 0; i + 1 < words.size(); ++i) {
        const Option* option = findOption(usage, words[i]);
        const bool takesNext = option && option->kind != Option::Kind::Switch;
        if (takesNext && i + 2 == words.size())
            return valuesOf(*option);
        if (takesNext)
            ++i;
        else if (!words[i].startsWith(QLatin1Char('-')))
            operands << words[i];
    }
    return words.last().startsWith(QLatin1Char('-')) ? Candidates{optionNames(usage), false}
                                                     : operandsOf(verb, operands);
}

Candidates candidates(const QStringList& words)
{
    if (words.size() < 2) {
        QStringList names{QStringLiteral("--help"), QStringLiteral("--version")};
        return {names + namesOf(verbs(), &Verb::name), false};
    }
    for (const Verb& verb : verbs())
        if (words.first() == QLatin1String(verb.name))
            return candidates(verb, words.mid(1));
    return {};
}

} // namespace

Usage completeUsage() { return usage(); }

ExitCode runComplete(const QStringList& words)
{
    // Other verbs refuse empty words; here the last one is empty where nothing has been typed yet.
    if (words.value(0) != QLatin1String("--")) {
        if (parseArguments(usage(), words))
            failArguments(QStringLiteral("rasterlens-cli complete: -- is missing; expected: %1").arg(usage().synopsis));
        return ExitCode::Fine;
    }
    const Candidates found = candidates(words.mid(1));
    QString text;
    for (const QString& word : found.words)
        if (word.startsWith(words.last()) || words.size() == 1)
            text += word + QLatin1Char('\n');
    if (found.files)
        text += QStringLiteral(":files\n");
    printText(text);
    return ExitCode::Fine;
}

} // namespace rasterlens::cli
