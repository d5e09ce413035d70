#include "core/io/mtl_loader.h"

#include "core/io/file_names.h"
#include "core/io/mtl_keywords.h"

#include <tiny_obj_loader.h>

#include <algorithm>
#include <map>
#include <sstream>

namespace rasterlens
{
namespace
{

/// What tinyobjloader does not tell about a material: which statements there were, and where.
struct Found {
    QByteArray name;
    int line = 0;
    bool diffuse = false;
    bool shininess = false;
    std::optional<float> diffuseGrey;  ///< a Kd of one number
    std::optional<float> specularGrey; ///< a Ks of one number
    struct Map {
        MtlMap map;
        int line = 0;
    };
    std::optional<Map> texture;
    std::optional<Map> opacity;
};

/// Checks the statements that scenes use; blanks all others and those that are wrong.
class Checker
{
public:
    explicit Checker(DiagnosticSink& diagnostics) : m_diagnostics(diagnostics) {}

    std::vector<Found> run(QByteArray& text)
    {
        LineCursor lines(text, Continuation::Backslash);
        while (const auto line = lines.next())
            if (!keep(*line))
                std::fill(line->begin, line->end, ' ');
        m_unused.report(m_diagnostics);
        return std::move(m_found);
    }

private:
    bool keep(TextLine line)
    {
        m_line = line.number;
        std::string_view rest = line.text();
        if (m_line == 1 && rest.starts_with("\xEF\xBB\xBF")) {
            std::fill_n(line.begin, 3, ' ');
            rest.remove_prefix(3);
        }
        const std::string_view word = nextWord(rest);
        const std::string keyword = canonicalMtlKeyword(word);
        std::ranges::copy(keyword, line.begin + (word.data() - line.begin));
        const bool material = keyword == "newmtl";
        if (!material && keyword != "Kd" && keyword != "Ks" && keyword != "Ns" && keyword != "map_Kd" &&
            keyword != "map_d") {
            m_unused.add(m_line, keyword, rest);
            return false;
        }
        if (material && trimmed(rest).empty()) {
            m_diagnostics.warning(m_line, QT_TRANSLATE_NOOP("Diagnostic", "newmtl takes a name; ignored"));
            return false;
        }
        if (material) {
            const std::string_view name = trimmed(rest);
            Found& found = m_found.emplace_back();
            found.name = QByteArray(name.data(), static_cast<qsizetype>(name.size()));
            found.line = m_line;
        }
        if (m_found.empty()) {
            m_diagnostics.warning(
                m_line,
                {QT_TRANSLATE_NOOP("Diagnostic", "%1 stands before the first newmtl; ignored"), {quotedWord(keyword)}});
            return false;
        }
        return material ? true : property(keyword, rest);
    }

    bool property(std::string_view keyword, std::string_view rest)
    {
        Found& found = m_found.back();
        if (keyword == "map_Kd" || keyword == "map_d") {
            if (auto map = parseMtlMap(keyword, rest, m_line, m_diagnostics))
                (keyword == "map_d" ? found.opacity : found.texture) = Found::Map{std::move(*map), m_line};
            return false; // read here, not by tinyobjloader
        }
        std::optional<float> grey;
        const bool good = numbers(keyword, rest, keyword == "Ns" ? 1 : 3, grey);
        if (good && keyword == "Ks")
            found.specularGrey = grey;
        if (good && keyword == "Kd")
            found.diffuseGrey = grey;
        found.diffuse |= good && keyword == "Kd";
        found.shininess |= good && keyword == "Ns";
        return good;
    }

    /// out   grey  the number of a colour that has but one: the MTL text lets it stand for all three
    bool numbers(std::string_view keyword, std::string_view rest, int count, std::optional<float>& grey)
    {
        for (int i = 0; i < count; ++i) {
            const std::string_view word = nextWord(rest);
            const NumberText number = decimalFromText(word);
            if (i == 1 && (word.empty() || word.starts_with('#')))
                return true;
            if (number.fault == NumberFault::None && number.value >= 0) {
                grey = i == 0 && count == 3 ? std::optional(number.value) : std::nullopt;
                continue;
            }
            const Reason problem = number.fault == NumberFault::None
                                       ? Reason(QT_TRANSLATE_NOOP("Diagnostic", "%1 is negative"), {quotedWord(word)})
                                       : describe(number.fault, word);
            const char* expected = count == 1 ? QT_TRANSLATE_NOOP("Diagnostic", "a number")
                                              : QT_TRANSLATE_NOOP("Diagnostic", "red, green and blue");
            m_diagnostics.warning(m_line, {QT_TRANSLATE_NOOP("Diagnostic", "%1: %2; %3 expected, ignored"),
                                           {QString::fromLatin1(keyword.data(), static_cast<qsizetype>(keyword.size())),
                                            problem, expected}});
            return false;
        }
        // Some programs write the opacity behind a colour; 1 says nothing.
        if (const std::string_view word = nextWord(rest);
            !word.empty() && !word.starts_with('#') && decimalFromText(word).value != 1)
            m_diagnostics.warning(m_line, {QT_TRANSLATE_NOOP("Diagnostic", "%1: %2 behind the numbers is ignored"),
                                           {QString::fromLatin1(keyword.data(), static_cast<qsizetype>(keyword.size())),
                                            quotedWord(word)}});
        return true;
    }

    DiagnosticSink& m_diagnostics;
    int m_line = 0;
    std::vector<Found> m_found;
    UnusedStatements m_unused;
};

} // namespace

std::vector<MtlMaterial> parseMtl(QByteArray text, const QString& path, const Reach& reach, DiagnosticSink& diagnostics)
{
    if (text.contains('\0')) {
        diagnostics.warning(0, QT_TRANSLATE_NOOP("Diagnostic", "binary data (a zero byte); an MTL file is text"));
        return {};
    }
    const std::vector<Found> found = Checker(diagnostics).run(text);
    if (found.empty())
        return {};

    // tinyobjloader appends each material as its newmtl ends, so the two lists run in step.
    std::istringstream stream(text.toStdString());
    std::map<std::string, int> indexOfName;
    std::vector<tinyobj::material_t> parsed;
    std::string warnings;
    std::string errors;
    tinyobj::LoadMtl(&indexOfName, &parsed, &stream, &warnings, &errors);

    std::vector<MtlMaterial> materials;
    for (std::size_t i = 0; i < std::min(parsed.size(), found.size()); ++i) {
        const tinyobj::material_t& m = parsed[i];
        MtlMaterial material;
        material.nameBytes = found[i].name;
        material.name = readableName({found[i].name.data(), static_cast<std::size_t>(found[i].name.size())});
        material.file = path;
        material.line = found[i].line;
        if (found[i].diffuse)
            material.diffuse = {m.diffuse[0], m.diffuse[1], m.diffuse[2]};
        if (found[i].diffuseGrey)
            material.diffuse = glm::vec3(*found[i].diffuseGrey);
        material.specular = {m.specular[0], m.specular[1], m.specular[2]};
        if (found[i].specularGrey)
            material.specular = glm::vec3(*found[i].specularGrey);
        if (found[i].shininess)
            material.shininess = m.shininess;
        const auto image = [&](const std::optional<Found::Map>& map, std::string_view keyword) {
            if (!map)
                return std::optional<MtlImage>();
            const NamedFile file = findNamedFile(path, map->map.name, reach);
            remarkOn(file, keyword, map->line, diagnostics);
            return std::optional(MtlImage{file.path, map->map, map->line, file.foundBy == FoundBy::Outside});
        };
        material.texture = image(found[i].texture, "map_Kd");
        material.opacity = image(found[i].opacity, "map_d");
        materials.push_back(std::move(material));
    }
    return materials;
}

} // namespace rasterlens
