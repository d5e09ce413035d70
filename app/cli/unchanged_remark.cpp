#include "app/cli/unchanged_remark.h"

#include "core/questions/unchanged.h"
#include "core/questions/without_effect.h"
#include "core/settings/numbers_field.h"

#include <algorithm>
#include <cstdio>
#include <utility>
#include <vector>

namespace rasterlens::cli
{
namespace
{

/// The fields whose value is not the scene's, as far as there may be a reason why this changes nothing.
std::vector<const SettingsField*> changedFields(const Settings& settings, const Settings& defaults)
{
    std::vector<const SettingsField*> changed;
    for (const SettingsField& field : settingsFields())
        if (canBeUnchanged(field) && field.get(settings) != field.get(defaults))
            changed.push_back(&field);
    return changed;
}

} // namespace

void remarkIfUnchanged(const Scene& scene, const Settings& settings)
{
    const auto remark = [&](const QString& what, const Reason& why) {
        std::fprintf(stderr, "%s: note: %s changes nothing here: %s\n", qUtf8Printable(scene.id), qUtf8Printable(what),
                     qUtf8Printable(textOf(why)));
    };
    for (const NumbersField& field : numbersFields())
        if (const auto why = whyWithoutEffect(field, settings); why && !isEqual(field, settings, scene.defaults))
            remark(QStringLiteral("--%1 %2").arg(QLatin1String(field.id), valueText(field, settings)), *why);
    const std::vector<const SettingsField*> fields = changedFields(settings, scene.defaults);
    const bool isLightMoved = settings.light != scene.defaults.light;
    if (fields.empty() && settings.mistakes.empty() && !isLightMoved)
        return;
    const auto needsSamples = [](const auto& asked) {
        return asked != nullptr && factsFor(*asked) == FactsOf::Samples;
    };
    const FactsOf what =
        std::ranges::any_of(fields, needsSamples) || std::ranges::any_of(settings.mistakes, needsSamples, findMistake)
            ? FactsOf::Samples
            : FactsOf::Faces;
    const FrameFacts facts = frameFacts(scene, settings, what);
    for (const SettingsField* field : fields) {
        Settings asked = settings;
        field->set(asked, field->get(scene.defaults));
        const QString option = QStringLiteral("--%1 %2").arg(QLatin1String(field->id), valueId(*field, settings));
        if (const auto inert = whyWithoutEffect(*field, settings, !scene.mesh.lines.empty()))
            remark(option, *inert);
        else if (const auto why = whyUnchanged(*field, settings, asked, facts))
            remark(option, *why);
    }
    if (isLightMoved)
        if (const auto why = whyLightUnchanged(scene, settings))
            remark(QStringLiteral("--light %1").arg(lightText(settings.light)), *why);
    for (const QString& id : settings.mistakes)
        if (const Mistake* mistake = findMistake(id))
            if (const auto why = whyUnchanged(*mistake, settings, facts))
                remark(QStringLiteral("--mistake %1").arg(id), *why);
}

} // namespace rasterlens::cli
