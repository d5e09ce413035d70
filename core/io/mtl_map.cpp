#include "core/io/mtl_map.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <iterator>

namespace rasterlens
{
namespace
{

/// What follows an option.
enum class Takes { Switch, Number, TwoNumbers, UpToThreeNumbers, Word };

struct MapOption {
    std::string_view name;
    Takes takes;
};

constexpr MapOption kOptions[] = {
    {"-blendu", Takes::Switch},      {"-blendv", Takes::Switch},      {"-boost", Takes::Number},
    {"-bm", Takes::Number},          {"-cc", Takes::Switch},          {"-clamp", Takes::Switch},
    {"-imfchan", Takes::Word},       {"-mm", Takes::TwoNumbers},      {"-o", Takes::UpToThreeNumbers},
    {"-s", Takes::UpToThreeNumbers}, {"-t", Takes::UpToThreeNumbers}, {"-texres", Takes::Number},
    {"-type", Takes::Word},          {"-colorspace", Takes::Word},
};

std::string lowerCase(std::string_view text)
{
    std::string lower(text);
    std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return lower;
}

bool isNumber(std::string_view word) { return decimalFromText(word).fault == NumberFault::None; }
bool isSwitch(std::string_view word) { return lowerCase(word) == "on" || lowerCase(word) == "off"; }

/// Goes through the words of one statement.
class MapParser
{
public:
    MapParser(std::string_view keyword, std::string_view rest, int line, DiagnosticSink& diagnostics)
        : m_keyword(keyword), m_rest(trimmed(rest)), m_line(line), m_diagnostics(diagnostics)
    {
    }

    std::optional<MtlMap> run()
    {
        while (const auto word = optionAhead())
            option(*word);
        m_map.name = std::string(trimmed(m_rest));
        if (!m_map.name.empty())
            return m_map;
        m_diagnostics.warning(m_line,
                              {QT_TRANSLATE_NOOP("Diagnostic", "%1 takes a file name; ignored"), {quoted(m_keyword)}});
        return std::nullopt;
    }

private:
    static QString quoted(std::string_view text)
    {
        return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
    }

    void warn(const char* words, std::string_view name)
    {
        m_diagnostics.warning(m_line, {words, {quoted(m_keyword), quotedWord(name)}});
    }

    /// The next word and whether others follow: the last one is always the name of the file.
    [[nodiscard]] std::string_view wordAhead(bool& last) const
    {
        std::string_view rest = m_rest;
        const std::string_view word = nextWord(rest);
        last = trimmed(rest).empty();
        return word;
    }

    std::optional<std::string_view> optionAhead()
    {
        bool last = false;
        const std::string_view word = wordAhead(last);
        const bool letter = word.size() > 1 && std::isalpha(static_cast<unsigned char>(word[1])) != 0;
        if (last || !letter || word[0] != '-')
            return std::nullopt;
        return nextWord(m_rest);
    }

    /// Takes the next word if it fits and is not the name of the file.
    template <class Fits>
    std::optional<std::string_view> takeIf(Fits fits)
    {
        bool last = false;
        const std::string_view word = wordAhead(last);
        if (last || !fits(word))
            return std::nullopt;
        return nextWord(m_rest);
    }

    void option(std::string_view word)
    {
        const std::string name = lowerCase(word);
        const auto known = std::ranges::find(kOptions, std::string_view(name), &MapOption::name);
        if (known == std::end(kOptions)) {
            warn(QT_TRANSLATE_NOOP("Diagnostic", "%1: there is no option %2; ignored"), word);
            while (takeIf([](std::string_view w) { return isNumber(w) || isSwitch(w); })) {
            }
            return;
        }
        if (!takeValues(*known))
            warn(QT_TRANSLATE_NOOP("Diagnostic", "%1: the value of %2 is missing or wrong; ignored"), word);
    }

    bool takeValues(const MapOption& option)
    {
        switch (option.takes) {
        case Takes::Switch: return takeSwitch(option.name);
        case Takes::Word: return takeWord(option.name);
        case Takes::Number: return takeNumbers(option.name, 1, 1);
        case Takes::TwoNumbers: return takeNumbers(option.name, 2, 2);
        case Takes::UpToThreeNumbers: break;
        }
        return takeNumbers(option.name, 1, 3);
    }

    bool takeSwitch(std::string_view name)
    {
        const auto word = takeIf(isSwitch);
        if (!word)
            return false;
        const bool on = lowerCase(*word) == "on";
        if (name == "-clamp")
            m_map.clamp = on;
        else if (on != name.starts_with("-blend")) // blending is what the texture filter does
            sayWithoutEffect(name);
        return true;
    }

    bool takeWord(std::string_view name)
    {
        const auto word = takeIf([](std::string_view) { return true; });
        if (!word)
            return false;
        if (name != "-imfchan") {
            sayWithoutEffect(name);
            return true;
        }
        const std::string channel = lowerCase(*word);
        if (channel.size() != 1 || std::string_view("rgbmlz").find(channel[0]) == std::string_view::npos)
            return false;
        m_map.channel = channel[0];
        return true;
    }

    bool takeNumbers(std::string_view name, std::size_t fewest, std::size_t most)
    {
        std::array<float, 3> numbers{0, 0, 0};
        std::size_t count = 0;
        for (; count < most; ++count) {
            const auto word = takeIf(isNumber);
            if (!word)
                break;
            numbers[count] = decimalFromText(*word).value;
        }
        if (count < fewest)
            return false;
        if (name == "-mm") {
            m_map.base = numbers[0];
            m_map.gain = numbers[1];
        } else if (name == "-s") {
            m_map.scale = {numbers[0], count > 1 ? numbers[1] : 1};
        } else if (name == "-o") {
            m_map.offset = {numbers[0], numbers[1]};
        } else if (name == "-t" ? numbers != std::array<float, 3>{0, 0, 0} : name != "-bm" || numbers[0] != 1) {
            sayWithoutEffect(name);
        }
        return true;
    }

    void sayWithoutEffect(std::string_view name)
    {
        warn(QT_TRANSLATE_NOOP("Diagnostic", "%1: %2 has no effect here"), name);
    }

    std::string_view m_keyword;
    std::string_view m_rest;
    int m_line;
    DiagnosticSink& m_diagnostics;
    MtlMap m_map;
};

} // namespace

std::optional<MtlMap> parseMtlMap(std::string_view keyword, std::string_view rest, int line,
                                  DiagnosticSink& diagnostics)
{
    return MapParser(keyword, rest, line, diagnostics).run();
}

} // namespace rasterlens
