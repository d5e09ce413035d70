#include "ui/base/applicability.h"

#include "core/questions/without_effect.h"
#include "core/render/render.h"

#include <QCoreApplication>

#include <algorithm>

namespace rasterlens
{
namespace
{

QString plainTitle(const SettingsField& field, int value)
{
    if (field.kind == SettingsField::Kind::Choice)
        return QCoreApplication::translate("Settings", field.choices[static_cast<std::size_t>(value)].title);
    if (field.kind == SettingsField::Kind::Integer)
        return QString::number(value);
    return value != 0 ? QCoreApplication::translate("Applicability", "on")
                      : QCoreApplication::translate("Applicability", "off");
}

std::optional<QString> inWords(const std::optional<Reason>& why)
{
    return why ? std::optional(
                     textOf(*why, [](const char* text) { return QCoreApplication::translate("Applicability", text); }))
               : std::nullopt;
}

} // namespace

std::optional<QString> withoutEffectText(const SettingsField& field, const Settings& settings, bool sceneHasLines)
{
    return inWords(whyWithoutEffect(field, settings, sceneHasLines));
}

std::optional<QString> withoutEffectText(const NumbersField& field, const Settings& settings)
{
    return inWords(whyWithoutEffect(field, settings));
}

QString whyUnsupported(const Reason& reason)
{
    return textOf(reason, [](const char* text) { return QCoreApplication::translate("Unsupported", text); });
}

Settings withNextValue(const SettingsField& field, const Settings& settings)
{
    Settings next = settings;
    const int value = field.get(settings);
    field.set(next, value >= field.maximum ? field.minimum : value + 1);
    return next;
}

Settings withOtherOf(const SettingsField& field, const char* one, const char* other, const Settings& settings)
{
    const auto valueOf = [&](const char* id) {
        const auto at = std::ranges::find(field.choices, QLatin1String(id),
                                          [](const Choice& choice) { return QLatin1String(choice.id); });
        Q_ASSERT(at != field.choices.end());
        return static_cast<int>(at - field.choices.begin());
    };
    Settings next = settings;
    field.set(next, field.get(settings) == valueOf(one) ? valueOf(other) : valueOf(one));
    return next;
}

QString valueTitle(const SettingsField& field, const Settings& settings)
{
    const int value = field.get(settings);
    const int meant = field.get(withoutAuto(settings));
    return value == meant ? plainTitle(field, value)
                          : QCoreApplication::translate("Applicability", "auto (%1)").arg(plainTitle(field, meant));
}

} // namespace rasterlens
