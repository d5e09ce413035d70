#include "app/cli/variant_list.h"

#include "app/cli/failure.h"
#include "app/cli/options.h"

#include <algorithm>

namespace rasterlens::cli
{
namespace
{

[[noreturn]] void failUnknown(const QString& id, const QString& verb)
{
    QStringList known;
    for (const Variant& variant : variants())
        known << QLatin1String(variant.id);
    known << QLatin1String(asGiven().id);
    const auto similar = mostSimilar(id, known);
    const QString hint = similar ? QStringLiteral("did you mean %1?").arg(*similar)
                                 : QStringLiteral("\"rasterlens-cli bench --list-variants\" lists those there are");
    failArguments(QStringLiteral("rasterlens-cli %1: --variants: there is no variant \"%2\"; %3").arg(verb, id, hint));
}

} // namespace

std::vector<const Variant*> variantsOf(const QString& list, const QString& verb)
{
    std::vector<const Variant*> chosen;
    for (const QString& id : list.split(QLatin1Char(','))) {
        if (id.isEmpty())
            failArguments(QStringLiteral("rasterlens-cli %1: --variants: \"%2\" has a comma too many; ids with a comma "
                                         "between them are expected")
                              .arg(verb, list));
        const Variant* variant = findVariant(id);
        if (variant == nullptr)
            failUnknown(id, verb);
        if (std::find(chosen.begin(), chosen.end(), variant) == chosen.end())
            chosen.push_back(variant);
    }
    return chosen;
}

} // namespace rasterlens::cli
