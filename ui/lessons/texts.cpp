#include "ui/lessons/texts.h"

#include "core/settings/mistakes.h"
#include "ui/base/language.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <algorithm>
#include <vector>

namespace rasterlens
{

QString textInUse(const TwoTexts& texts) { return Language::inUse() == LanguageKind::Chinese ? texts.zh : texts.en; }

QString choiceText(const QuestionChoice& choice)
{
    const Mistake* mistake = findMistake(choice.mistake);
    if (!mistake)
        return textInUse(choice.text);
    return labelled(QLatin1String(mistake->number), QCoreApplication::translate("Mistake", mistake->title));
}

std::optional<LessonTitle> lessonAfter(const QString& id)
{
    const std::vector<LessonTitle> titles = lessonTitles();
    const auto at = std::ranges::find(titles, id, &LessonTitle::id);
    return at == titles.end() || at + 1 == titles.end() ? std::nullopt : std::optional(*(at + 1));
}

QString firstSentence(const QString& text)
{
    static const QRegularExpression end(QStringLiteral("(?<=[.?!])\\s|(?<=[\u3002\uff1f\uff01])"));
    return text.section(end, 0, 0).trimmed();
}

} // namespace rasterlens
