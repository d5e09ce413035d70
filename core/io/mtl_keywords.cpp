#include "core/io/mtl_keywords.h"

#include "core/io/file_names.h"

#include <QStringList>

#include <algorithm>
#include <cctype>
#include <iterator>

namespace rasterlens
{
namespace
{

/// When what a statement says would be seen, if this program drew it.
enum class Seen {
    Never,      ///< a part of lighting models that this program does not have
    IfNotBlack, ///< with a number other than 0
    IfNotWhite, ///< with a number other than 1
    Always,
};

struct Keyword {
    std::string_view name;
    Seen seen;
};

constexpr Keyword kKeywords[] = {
    {"newmtl", Seen::Never},    {"Kd", Seen::Never},        {"Ks", Seen::Never},      {"Ns", Seen::Never},
    {"map_Kd", Seen::Always},   {"Ka", Seen::Never},        {"illum", Seen::Never},   {"Ni", Seen::Never},
    {"Ke", Seen::IfNotBlack},   {"d", Seen::IfNotWhite},    {"Tr", Seen::IfNotBlack}, {"Tf", Seen::IfNotWhite},
    {"Km", Seen::IfNotBlack},   {"sharpness", Seen::Never}, {"Pr", Seen::Never},      {"Pm", Seen::IfNotBlack},
    {"Ps", Seen::IfNotBlack},   {"Pc", Seen::IfNotBlack},   {"Pcr", Seen::Never},     {"aniso", Seen::Never},
    {"anisor", Seen::Never},    {"map_Ka", Seen::Never},    {"map_Ks", Seen::Always}, {"map_Ns", Seen::Always},
    {"map_Ke", Seen::Always},   {"map_d", Seen::Always},    {"map_Tr", Seen::Always}, {"map_opacity", Seen::Always},
    {"map_Bump", Seen::Always}, {"bump", Seen::Always},     {"norm", Seen::Always},   {"map_Kn", Seen::Always},
    {"disp", Seen::Always},     {"map_disp", Seen::Always}, {"decal", Seen::Always},  {"map_decal", Seen::Always},
    {"refl", Seen::Always},     {"map_refl", Seen::Always}, {"map_Pr", Seen::Always}, {"map_Pm", Seen::Always},
    {"map_Ps", Seen::Always},   {"map_aat", Seen::Never},   {"Kt", Seen::IfNotBlack}, {"map_Kt", Seen::Always},
};

bool equalsInAnyCase(std::string_view a, std::string_view b)
{
    return std::ranges::equal(a, b,
                              [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

/// A word is another number than `value`, or no number.
bool hasOther(std::string_view rest, float value)
{
    for (std::string_view word = nextWord(rest); !word.empty() && !word.starts_with('#'); word = nextWord(rest))
        if (decimalFromText(word).value != value)
            return true;
    return false;
}

} // namespace

std::string canonicalMtlKeyword(std::string_view keyword)
{
    const auto known =
        std::ranges::find_if(kKeywords, [&](const Keyword& k) { return equalsInAnyCase(k.name, keyword); });
    return std::string(known == std::end(kKeywords) ? keyword : known->name);
}

UnusedStatements::Kind UnusedStatements::kindOf(std::string_view keyword, std::string_view rest)
{
    const auto known = std::ranges::find(kKeywords, keyword, &Keyword::name);
    if (known == std::end(kKeywords))
        return Kind::Unknown;
    switch (known->seen) {
    case Seen::Never: return Kind::Silent;
    case Seen::IfNotBlack: return hasOther(rest, 0) ? Kind::Seen : Kind::Silent;
    case Seen::IfNotWhite: return hasOther(rest, 1) ? Kind::Seen : Kind::Silent;
    case Seen::Always: return Kind::Seen;
    }
    return Kind::Seen;
}

void UnusedStatements::add(int line, std::string_view keyword, std::string_view rest)
{
    if (keyword.empty() || keyword.starts_with('#'))
        return;
    const Kind kind = kindOf(keyword, rest);
    const auto row = std::ranges::find_if(m_rows, [&](const Row& r) { return r.keyword == keyword && r.kind == kind; });
    if (row != m_rows.end())
        ++row->count;
    else
        m_rows.push_back({std::string(keyword), kind, line, 1});
}

void UnusedStatements::report(DiagnosticSink& diagnostics) const
{
    const auto tell = [&](Kind kind, const char* words) {
        QStringList names;
        int line = 0;
        for (const Row& row : m_rows) {
            if (row.kind != kind)
                continue;
            line = line == 0 ? row.line : line;
            const QString name = readableName(row.keyword);
            names << (row.count == 1 ? name : QStringLiteral("%1 (%2)").arg(name).arg(row.count));
        }
        if (names.isEmpty())
            return;
        const Reason message{words, {names.join(QStringLiteral(", "))}};
        if (kind == Kind::Silent)
            diagnostics.note(line, message);
        else
            diagnostics.warning(line, message);
    };
    tell(Kind::Seen, QT_TRANSLATE_NOOP("Diagnostic", "not drawn: %1"));
    tell(Kind::Unknown, QT_TRANSLATE_NOOP("Diagnostic", "not statements of the MTL format; ignored: %1"));
    tell(Kind::Silent, QT_TRANSLATE_NOOP("Diagnostic", "read, but no part of the lighting here: %1"));
}

} // namespace rasterlens
