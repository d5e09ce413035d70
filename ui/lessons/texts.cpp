#include "ui/lessons/texts.h"

#include "core/settings/mistakes.h"
#include "ui/base/language.h"

#include <QCoreApplication>
#include <QRegularExpression>

namespace rasterlens
{

QString textInUse(const TwoTexts& texts) { return Language::inUse() == LanguageKind::Chinese ? texts.zh : texts.en; }

QString choiceText(const QuestionChoice& choice)
{
    const Mistake* mistake = findMistake(choice.mistake);
    if (!mistake)
        return textInUse(choice.text);
    return QLatin1String(mistake->number) + QStringLiteral(": ") +
           QCoreApplication::translate("Mistake", mistake->title);
}

QString firstSentence(const QString& text)
{
    static const QRegularExpression end(QStringLiteral("(?<=[.?!])\\s|(?<=[\u3002\uff1f\uff01])"));
    return text.section(end, 0, 0).trimmed();
}

} // namespace rasterlens
