#include "core/io/obj_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <limits>

namespace rasterlens
{
namespace
{

// Statements of the format that say nothing about triangles.
constexpr std::string_view kIgnored[] = {"g",          "o",         "s",        "l",        "p",    "mg",     "vp",
                                         "vw",         "cstype",    "deg",      "bmat",     "step", "curv",   "curv2",
                                         "surf",       "parm",      "trim",     "hole",     "scrv", "sp",     "end",
                                         "con",        "bevel",     "c_interp", "d_interp", "lod",  "usemap", "maplib",
                                         "shadow_obj", "trace_obj", "ctech",    "stech",    "call", "csh",    "t"};

/// tinyobjloader adds up digits in a double; longer numbers could overflow on the way.
constexpr std::size_t kLongestNumber = 300;

enum Kind { Position, TexCoord, Normal };
constexpr std::size_t kKinds = 3;

QString nameOf(Kind kind)
{
    constexpr std::array<const char*, kKinds> kNames = {"v", "vt", "vn"};
    return QString::fromLatin1(kNames[kind]);
}

class Checker
{
public:
    Checker(QByteArray text, DiagnosticSink& diagnostics) : m_diagnostics(diagnostics)
    {
        m_out.geometry = std::move(text);
    }

    ObjText run()
    {
        if (const auto zero = m_out.geometry.indexOf('\0'); zero >= 0) {
            const auto line = 1 + std::count(m_out.geometry.begin(), m_out.geometry.begin() + zero, '\n');
            m_diagnostics.error(static_cast<int>(line),
                                QT_TRANSLATE_NOOP("Diagnostic", "binary data (a zero byte); an OBJ file is text"));
            return {};
        }
        LineCursor lines(m_out.geometry, Continuation::Backslash);
        while (const auto line = lines.next())
            statement(*line);
        checkForwardReferences();
        if (m_out.faceCount == 0 && !m_diagnostics.hasErrors())
            m_diagnostics.error(
                0, QT_TRANSLATE_NOOP("Diagnostic", "there are no faces; at least one \"f\" statement is expected"));
        return std::move(m_out);
    }

private:
    struct ForwardReference {
        int line;
        Kind kind;
        std::int64_t index;
    };

    void statement(TextLine line)
    {
        m_line = line.number;
        const std::string_view whole = line.text();
        std::string_view rest = whole.substr(0, whole.find('#'));
        if (line.number == 1 && rest.starts_with("\xEF\xBB\xBF")) {
            std::fill_n(line.begin, 3, ' ');
            rest.remove_prefix(3);
        }
        char* const commentBegin = line.begin + (rest.data() + rest.size() - whole.data());
        const std::string_view keyword = nextWord(rest);
        const bool geometry = geometryStatement(keyword, rest);
        std::fill(geometry ? commentBegin : line.begin, line.end, ' ');
    }

    /// Checks the statement; true if it is one that tinyobjloader is to read.
    bool geometryStatement(std::string_view keyword, std::string_view rest)
    {
        if (keyword == "v")
            position(rest);
        else if (keyword == "vt")
            numbers(TexCoord, rest, 1, 3);
        else if (keyword == "vn")
            numbers(Normal, rest, 3, 3);
        else if (keyword == "f")
            face(rest);
        else {
            other(keyword, rest);
            return false;
        }
        return true;
    }

    void other(std::string_view keyword, std::string_view rest)
    {
        const auto reference = [&](std::vector<ObjReference>& list) {
            const std::string_view name = trimmed(rest);
            if (name.empty())
                m_diagnostics.warning(m_line,
                                      {QT_TRANSLATE_NOOP("Diagnostic", "%1 takes a name"), {quotedWord(keyword)}});
            else
                list.push_back(
                    {QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size())), m_line, m_out.faceCount});
        };
        if (keyword == "mtllib")
            reference(m_out.libraries);
        else if (keyword == "usemtl")
            reference(m_out.materialUses);
        else if (!keyword.empty() && std::find(std::begin(kIgnored), std::end(kIgnored), keyword) == std::end(kIgnored))
            m_diagnostics.warning(m_line,
                                  {QT_TRANSLATE_NOOP("Diagnostic", "%1 is not a statement of the OBJ format; ignored"),
                                   {quotedWord(keyword)}});
    }

    /// The numbers of a v, vt or vn statement. Those that are there are in m_numbers.
    void numbers(Kind kind, std::string_view rest, std::size_t least, std::size_t most)
    {
        ++m_counts[static_cast<std::size_t>(kind)];
        m_numberCount = 0;
        for (std::string_view word = nextWord(rest); !word.empty(); word = nextWord(rest)) {
            const NumberText number = decimalFromText(word);
            if (number.fault != NumberFault::None)
                m_diagnostics.error(m_line, {QT_TRANSLATE_NOOP("Diagnostic", "%1: %2; a finite number is expected"),
                                             {nameOf(kind), describe(number.fault, word)}});
            else if (word.size() > kLongestNumber)
                m_diagnostics.error(
                    m_line, {QT_TRANSLATE_NOOP("Diagnostic", "%1: a number of %2 characters; at most %3 are expected"),
                             {nameOf(kind), word.size(), kLongestNumber}});
            if (m_numberCount < m_numbers.size())
                m_numbers[m_numberCount] = number.value;
            ++m_numberCount;
        }
        if (m_numberCount < least || m_numberCount > most)
            m_diagnostics.error(
                m_line,
                {QT_TRANSLATE_NOOP("Diagnostic", "%1: %2 numbers; %3 expected"),
                 {nameOf(kind), m_numberCount,
                  least == most ? Reason(least) : Reason(QT_TRANSLATE_NOOP("Diagnostic", "%1 to %2"), {least, most})}});
    }

    /// x y z, then w, or r g b, or both kinds of extras of some programs: r g b a.
    void position(std::string_view rest)
    {
        numbers(Position, rest, 3, 7);
        glm::dvec3& exact = m_out.positions.emplace_back();
        if (m_numberCount >= 3)
            for (int i = 0; i < 3; ++i)
                exact[i] = doubleFromText(nextWord(rest));
        if (m_numberCount == 5)
            m_diagnostics.error(
                m_line, QT_TRANSLATE_NOOP("Diagnostic", "v: 5 numbers; x y z, x y z w or x y z r g b expected"));
        const bool colored = m_numberCount >= 6;
        if (colored)
            m_out.colors.resize(m_counts[Position] - 1, glm::vec3(1));
        if (!m_out.colors.empty() || colored)
            m_out.colors.push_back(colored ? glm::vec3(m_numbers[3], m_numbers[4], m_numbers[5]) : glm::vec3(1));
    }

    void face(std::string_view rest)
    {
        std::size_t corners = 0;
        for (std::string_view word = nextWord(rest); !word.empty(); word = nextWord(rest)) {
            corner(word);
            ++corners;
        }
        if (corners < 3)
            m_diagnostics.error(m_line,
                                {QT_TRANSLATE_NOOP("Diagnostic", "f: %1 corners; at least 3 expected"), {corners}});
        ++m_out.faceCount;
    }

    /// v, v/vt, v//vn or v/vt/vn
    void corner(std::string_view word)
    {
        constexpr std::array<Kind, kKinds> kOrder = {Position, TexCoord, Normal};
        std::string_view rest = word;
        for (std::size_t part = 0; part < kOrder.size(); ++part) {
            const std::size_t slash = rest.find('/');
            const std::string_view digits = rest.substr(0, slash);
            const bool mayBeAbsent = part == 1 && slash != std::string_view::npos;
            if (!(digits.empty() && mayBeAbsent) && !index(kOrder[part], digits, word))
                return;
            if (slash == std::string_view::npos)
                return;
            rest.remove_prefix(slash + 1);
        }
        badCorner(word);
    }

    void badCorner(std::string_view word)
    {
        m_diagnostics.error(
            m_line, {QT_TRANSLATE_NOOP("Diagnostic", "f: %1 is not a corner; v, v/vt, v//vn or v/vt/vn expected"),
                     {quotedWord(word)}});
    }

    /// One index of a corner; false if something was wrong with it.
    bool index(Kind kind, std::string_view digits, std::string_view cornerText)
    {
        std::int64_t value = 0;
        const char* end = digits.data() + digits.size();
        const auto parsed = std::from_chars(digits.data(), end, value);
        if (parsed.ptr != end || parsed.ec == std::errc::invalid_argument) {
            badCorner(cornerText);
            return false;
        }
        const std::int64_t count = static_cast<std::int64_t>(m_counts[static_cast<std::size_t>(kind)]);
        const bool overflow = parsed.ec != std::errc() || value > std::numeric_limits<int>::max();
        if (overflow || value == 0 || value < -count) {
            outOfRange(
                m_line, kind,
                QString::fromLatin1(digits.data(), static_cast<qsizetype>(std::min<std::size_t>(digits.size(), 40))));
            return false;
        }
        if (value > count)
            m_forward.push_back({m_line, kind, value});
        return true;
    }

    void outOfRange(int line, Kind kind, const QString& value)
    {
        const std::size_t count = m_counts[static_cast<std::size_t>(kind)];
        const Reason expected =
            value == QLatin1String("0") ? Reason(QT_TRANSLATE_NOOP("Diagnostic", "indices count from 1"))
            : value.startsWith(QLatin1Char('-'))
                ? Reason(QT_TRANSLATE_NOOP("Diagnostic", "%1 \"%2\" come before it"), {count, nameOf(kind)})
                : Reason(QT_TRANSLATE_NOOP("Diagnostic", "the file has %1 \"%2\""), {count, nameOf(kind)});
        m_diagnostics.error(line, {QT_TRANSLATE_NOOP("Diagnostic", "f: %1 index %2 is out of range; %3"),
                                   {nameOf(kind), value, expected}});
    }

    void checkForwardReferences()
    {
        for (const ForwardReference& reference : m_forward)
            if (reference.index > static_cast<std::int64_t>(m_counts[static_cast<std::size_t>(reference.kind)]))
                outOfRange(reference.line, reference.kind, QString::number(reference.index));
    }

    DiagnosticSink& m_diagnostics;
    ObjText m_out;
    int m_line = 0;
    std::array<std::size_t, kKinds> m_counts{};
    std::array<float, 7> m_numbers{};
    std::size_t m_numberCount = 0;
    std::vector<ForwardReference> m_forward;
};

} // namespace

ObjText checkObjText(QByteArray text, DiagnosticSink& diagnostics)
{
    return Checker(std::move(text), diagnostics).run();
}

} // namespace rasterlens
