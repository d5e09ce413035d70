#include "core/io/obj_text.h"

#include "core/io/obj_number.h"
#include "core/io/path_bytes.h"
#include "core/io/vertex_colors.h"

#include <QStringList>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstring>
#include <limits>

namespace rasterlens
{
namespace
{

using namespace objtext;

// Statements of the format that say nothing about triangles.
constexpr std::string_view kIgnored[] = {"g",         "o",     "mg",    "vp",       "vw",       "cstype", "deg",
                                         "bmat",      "step",  "parm",  "trim",     "hole",     "scrv",   "sp",
                                         "end",       "con",   "bevel", "c_interp", "d_interp", "lod",    "shadow_obj",
                                         "trace_obj", "ctech", "stech", "t",        "scmp",     "res"};

/// What else a file can be made of. `marks` add to triangles, the others take a part of the model's look with them.
struct OtherShape {
    std::string_view keyword;
    bool isMark;
};
constexpr auto kOtherShapes = std::to_array<OtherShape>({{"l", true},
                                                         {"p", true},
                                                         {"curv", true},
                                                         {"curv2", true},
                                                         {"surf", false},
                                                         {"bsp", false},
                                                         {"bzp", false},
                                                         {"cdc", true},
                                                         {"cdp", false},
                                                         {"usemap", false},
                                                         {"maplib", false},
                                                         {"call", false},
                                                         {"csh", false}});

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

enum Kind { Position, TexCoord, Normal };
constexpr std::array<const char*, 3> kNames = {"v", "vt", "vn"};

QString nameOf(Kind kind) { return QString::fromLatin1(kNames[kind]); }

class Reader
{
public:
    Reader(std::string_view text, ObjPositions rounding, DiagnosticSink& diagnostics)
        : m_text(text), m_rounding(rounding), m_diagnostics(diagnostics)
    {
    }

    ObjText run()
    {
        if (m_text.starts_with(kByteOrderMark))
            m_text.remove_prefix(kByteOrderMark.size());
        m_hasReturns = m_text.find('\r') != std::string_view::npos;
        m_hasZeros = m_text.find('\0') != std::string_view::npos;
        reserve();
        readLines();
        if (m_hasForward || m_hasBadPositions || m_hasBadUvs)
            dropBadFaces();
        m_out.colors = m_colors.take(m_out.positions.size(), m_diagnostics);
        remarkOnOthers();
        if (m_out.faces.empty() && m_faceStatements == 0)
            m_diagnostics.error(
                0, QT_TRANSLATE_NOOP("Diagnostic", "there are no faces; at least one \"f\" statement is expected"));
        else if (m_out.faces.empty())
            m_diagnostics.error(0, {QT_TRANSLATE_NOOP("Diagnostic", "none of the %1 \"f\" statements can be drawn"),
                                    {m_faceStatements}});
        if (m_out.faces.empty())
            m_diagnostics.promoteWarnings();
        return std::move(m_out);
    }

private:
    /// Room for about as much as a text of this size holds, so that arrays seldom move while they grow.
    void reserve()
    {
        constexpr std::size_t kMost = std::size_t{1} << 23;
        const auto least = [&](std::size_t bytes) { return std::min(m_text.size() / bytes, kMost); };
        m_out.corners.reserve(least(12));
        m_out.faces.reserve(least(36));
        m_out.positions.reserve(least(72));
    }

    void readLines()
    {
        const char* at = m_text.data();
        const char* const end = at + m_text.size();
        for (int number = 1; at != end;) {
            m_line = number;
            std::string_view line = nextLine(at, end);
            ++number;
            if (line.ends_with('\\') && continuesOnNextLine(line)) {
                m_joined.clear();
                while (line.ends_with('\\') && continuesOnNextLine(line)) {
                    m_joined.append(line.substr(0, line.size() - 1)).push_back(' ');
                    line = at == end ? std::string_view() : nextLine(at, end);
                    ++number;
                }
                line = m_joined.append(line);
            }
            if (!m_hasZeros || line.find('\0') == std::string_view::npos)
                statement(line.data(), line.data() + line.size());
            else
                m_diagnostics.warning(
                    m_line, QT_TRANSLATE_NOOP("Diagnostic", "binary data (a zero byte); an OBJ file is text"));
        }
    }

    /// The line at `at` without its end: LF, CRLF or CR.
    std::string_view nextLine(const char*& at, const char* end) const
    {
        const auto size = static_cast<std::size_t>(end - at);
        const auto* lineEnd = static_cast<const char*>(std::memchr(at, '\n', size));
        const char* next = lineEnd == nullptr ? end : lineEnd + 1;
        lineEnd = lineEnd == nullptr ? end : lineEnd;
        if (m_hasReturns)
            if (const auto* cr =
                    static_cast<const char*>(std::memchr(at, '\r', static_cast<std::size_t>(lineEnd - at)))) {
                next = cr + 1 == lineEnd ? next : cr + 1;
                lineEnd = cr;
            }
        const std::string_view line(at, static_cast<std::size_t>(lineEnd - at));
        at = next;
        return line;
    }

    void statement(const char* at, const char* end)
    {
        skipBlanks(at, end);
        const auto is = [&](std::ptrdiff_t size) { return end - at > size && isBlank(at[size]); };
        if (at == end)
            return;
        if (*at == 'v' && is(1))
            position(at + 1, end);
        else if (*at == 'f' && is(1))
            face(at + 1, end);
        else if (at[0] == 'v' && is(2) && at[1] == 't')
            texCoord(at + 2, end);
        else if (at[0] == 'v' && is(2) && at[1] == 'n')
            normal(at + 2, end);
        else if (*at == '#')
            m_colors.comment({at, static_cast<std::size_t>(end - at)});
        else
            other({at, static_cast<std::size_t>(end - at)});
    }

    void other(std::string_view rest)
    {
        const std::string_view word = nextWord(rest);
        std::string keyword(word.substr(0, word.find('#')));
        for (char& c : keyword)
            c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        if (keyword.size() < word.size())
            rest = {};
        const char* const end = rest.data() + rest.size();
        if (keyword == "mtllib")
            reference(m_out.libraries, keyword, rest);
        else if (keyword == "usemtl")
            reference(m_out.materialUses, keyword, rest);
        else if (keyword == "s")
            smoothing(rest);
        else if (keyword == "v")
            position(rest.data(), end);
        else if (keyword == "vt")
            texCoord(rest.data(), end);
        else if (keyword == "vn")
            normal(rest.data(), end);
        else if (keyword == "f" || keyword == "fo") // fo: a face's outline in old files
            face(rest.data(), end);
        else if (const auto shape = std::ranges::find(kOtherShapes, keyword, &OtherShape::keyword);
                 shape != kOtherShapes.end())
            m_others[static_cast<std::size_t>(shape - kOtherShapes.begin())].count(m_line);
        else if (std::ranges::find(kIgnored, keyword) == std::end(kIgnored))
            m_diagnostics.warning(m_line,
                                  {QT_TRANSLATE_NOOP("Diagnostic", "%1 is not a statement of the OBJ format; ignored"),
                                   {quotedWord(word)}});
    }

    /// Says what the file holds beside triangles, and that -1 was read as the last one.
    void remarkOnOthers()
    {
        for (const bool isMark : {true, false}) {
            QStringList names;
            int line = 0;
            for (std::size_t i = 0; i < m_others.size(); ++i) {
                if (m_others[i].number == 0 || kOtherShapes[i].isMark != isMark)
                    continue;
                line = line == 0 ? m_others[i].firstLine : std::min(line, m_others[i].firstLine);
                names << QStringLiteral("%1 (%2)").arg(readableName(kOtherShapes[i].keyword)).arg(m_others[i].number);
            }
            const Reason message{QT_TRANSLATE_NOOP("Diagnostic", "not drawn: %1"), {names.join(QStringLiteral(", "))}};
            if (line > 0 && isMark && !m_out.faces.empty())
                m_diagnostics.note(line, message);
            else if (line > 0)
                m_diagnostics.warning(line, message);
        }
        if (m_noNormals.number > 0)
            m_diagnostics.warning(
                m_noNormals.firstLine,
                {QT_TRANSLATE_NOOP("Diagnostic", "vn: %1 normals have length 0; those of the faces are used"),
                 {m_noNormals.number}});
        if (m_lastOnes.number > 0)
            m_diagnostics.warning(
                m_lastOnes.firstLine,
                {QT_TRANSLATE_NOOP("Diagnostic", "f: in %1 corners v counts from the start and vt or vn "
                                                 "is -1, the last one; some programs mean none by it"),
                 {m_lastOnes.number}});
    }

    void reference(std::vector<ObjReference>& list, std::string_view keyword, std::string_view rest)
    {
        const std::string_view name = trimmed(rest);
        if (name.empty())
            m_diagnostics.warning(m_line, {QT_TRANSLATE_NOOP("Diagnostic", "%1 takes a name"), {quotedWord(keyword)}});
        else
            list.push_back({QByteArray(name.data(), static_cast<qsizetype>(name.size())), m_line});
    }

    void smoothing(std::string_view rest)
    {
        const std::string_view word = nextWord(rest);
        int group = 0;
        const auto parsed = std::from_chars(word.data(), word.data() + word.size(), group);
        const bool isNumber = parsed.ec == std::errc() && parsed.ptr == word.data() + word.size() && group >= 0;
        if (isNumber || word == "off" || word == "on")
            m_group = isNumber ? group : word == "on" ? 1 : ObjFace::kFlat;
        else
            m_diagnostics.warning(m_line, {QT_TRANSLATE_NOOP("Diagnostic", "s: %1; a group's number or off expected"),
                                           {quotedWord(word)}});
    }

    /// Reads the numbers of a v, vt or vn statement: how many there are, and how many good ones come first.
    void numbers(Kind kind, const char* at, const char* end)
    {
        m_count = 0;
        m_good = 0;
        for (skipBlanks(at, end); at != end && *at != '#'; skipBlanks(at, end)) {
            Number number;
            number.begin = at;
            bool good = quickNumber(at, end, number.value);
            if (good)
                number.end = at;
            else
                good = slowNumber(kind, at, end, number);
            if (m_count < m_numbers.size())
                m_numbers[m_count] = number;
            if (good && m_good == m_count)
                ++m_good;
            ++m_count;
        }
    }

    struct Number {
        double value = 0;
        const char* begin = nullptr;
        const char* end = nullptr;

        [[nodiscard]] float asFloat() const
        {
            return nearestFloat(value, {begin, static_cast<std::size_t>(end - begin)});
        }
    };

    bool slowNumber(Kind kind, const char*& at, const char*& end, Number& number)
    {
        const std::string_view word = numberWord(at, end);
        number.end = word.data() + word.size();
        const NumberFault fault = decimalFromText(word).fault;
        if (fault != NumberFault::None && m_good == m_count) // one remark a line is enough
            m_diagnostics.warning(m_line, {QT_TRANSLATE_NOOP("Diagnostic", "%1: %2; a finite number is expected"),
                                           {nameOf(kind), describe(fault, word)}});
        if (fault == NumberFault::None)
            number.value = doubleFromText(word);
        return fault == NumberFault::None;
    }

    void wrongCount(Kind kind, Reason expected)
    {
        m_diagnostics.warning(m_line, {QT_TRANSLATE_NOOP("Diagnostic", "%1: %2 numbers; %3 expected"),
                                       {nameOf(kind), m_count, std::move(expected)}});
    }

    /// x y z, then w, or r g b, or both kinds of extras of some programs: r g b a.
    void position(const char* at, const char* end)
    {
        numbers(Position, at, end);
        if (m_count < 3 || m_count > 7)
            wrongCount(Position, Reason(QT_TRANSLATE_NOOP("Diagnostic", "%1 to %2"), {3, 7}));
        else if (m_count == 5)
            wrongCount(Position, QT_TRANSLATE_NOOP("Diagnostic", "x y z, x y z w or x y z r g b"));
        else if (m_count == 4 && m_good == 4 && m_numbers[3].value != 1)
            m_diagnostics.warning(m_line, QT_TRANSLATE_NOOP("Diagnostic", "v: a weight other than 1 is ignored"));
        glm::dvec3& p = m_out.positions.emplace_back(kNaN);
        if (m_good < 3) {
            m_hasBadPositions = true;
            return;
        }
        for (std::size_t i = 0; i < 3; ++i)
            p[static_cast<int>(i)] =
                m_rounding == ObjPositions::Double ? m_numbers[i].value : double(m_numbers[i].asFloat());
        if (m_good >= 6)
            m_colors.add(m_out.positions.size() - 1,
                         {m_numbers[3].asFloat(), m_numbers[4].asFloat(), m_numbers[5].asFloat()});
    }

    void texCoord(const char* at, const char* end)
    {
        numbers(TexCoord, at, end);
        if (m_count < 1 || m_count > 3)
            wrongCount(TexCoord, Reason(QT_TRANSLATE_NOOP("Diagnostic", "%1 to %2"), {1, 3}));
        const bool bad = m_good < std::min<std::size_t>(std::max<std::size_t>(m_count, 1), 2);
        m_hasBadUvs |= bad;
        m_out.uvs.push_back(bad            ? glm::vec2(kNaN)
                            : m_count == 1 ? glm::vec2(m_numbers[0].asFloat(), 0)
                                           : glm::vec2(m_numbers[0].asFloat(), m_numbers[1].asFloat()));
    }

    void normal(const char* at, const char* end)
    {
        numbers(Normal, at, end);
        if (m_count != 3)
            wrongCount(Normal, 3);
        const glm::vec3& n = m_out.normals.emplace_back(
            m_good < 3 ? glm::vec3(0)
                       : glm::vec3(m_numbers[0].asFloat(), m_numbers[1].asFloat(), m_numbers[2].asFloat()));
        if (m_good >= 3 && n == glm::vec3(0))
            m_noNormals.count(m_line);
    }

    void face(const char* at, const char* end)
    {
        ++m_faceStatements;
        const std::size_t begin = m_out.corners.size();
        std::size_t named = 0;
        for (skipBlanks(at, end); at != end && *at != '#'; skipBlanks(at, end), ++named) {
            ObjCorner corner{-1, -1, -1};
            if (!readCorner(at, end, corner)) {
                m_out.corners.resize(begin);
                return;
            }
            if (m_out.corners.size() == begin || m_out.corners.back().position != corner.position)
                m_out.corners.push_back(corner);
        }
        while (m_out.corners.size() > begin + 1 && m_out.corners.back().position == m_out.corners[begin].position)
            m_out.corners.pop_back();
        const std::size_t count = m_out.corners.size() - begin;
        const bool enough = count >= 3;
        if (named < 3)
            m_diagnostics.warning(m_line,
                                  {QT_TRANSLATE_NOOP("Diagnostic", "f: %1 corners; at least 3 expected"), {named}});
        else if (!enough)
            m_diagnostics.warning(
                m_line, {QT_TRANSLATE_NOOP("Diagnostic", "f: only %1 of %2 corners are different; at least 3 expected"),
                         {count, named}});
        else if (count < named)
            m_diagnostics.warning(
                m_line, {QT_TRANSLATE_NOOP("Diagnostic", "f: %1 repeated corners are left out"), {named - count}});
        if (!enough)
            m_out.corners.resize(begin);
        else
            m_out.faces.push_back({static_cast<std::uint32_t>(m_out.corners.size()), m_line,
                                   static_cast<int>(m_out.materialUses.size()) - 1, m_group});
    }

    /// v, v/vt, v//vn or v/vt/vn, where vt and vn may be absent; false if the face has to be left out.
    bool readCorner(const char*& at, const char* end, ObjCorner& corner)
    {
        const char* const begin = at;
        const IndexText v = indexAt(at, end);
        IndexText vt{0, true, true};
        IndexText vn{0, true, true};
        if (v.good && at != end && *at == '/')
            vt = indexAt(++at, end);
        if (v.good && vt.good && at != end && *at == '/')
            vn = indexAt(++at, end);
        if (v.absent || !v.good || !vt.good || !vn.good || (at != end && *at == '/')) {
            while (at != end && !isBlank(*at))
                ++at;
            m_diagnostics.warning(
                m_line, {QT_TRANSLATE_NOOP("Diagnostic", "f: %1 is not a corner; v, v/vt, v//vn or v/vt/vn expected"),
                         {quotedWord({begin, static_cast<std::size_t>(at - begin)})}});
            return false;
        }
        corner.uv = vt.absent ? -1 : resolved(TexCoord, vt.value, m_out.uvs.size());
        corner.normal = vn.absent ? -1 : resolved(Normal, vn.value, m_out.normals.size());
        corner.position = resolved(Position, v.value, m_out.positions.size());
        if (v.value > 0 && (vt.value == -1 || vn.value == -1) && (corner.uv >= 0 || corner.normal >= 0))
            m_lastOnes.count(m_line);
        return corner.position >= 0;
    }

    /// The index counted from 0; -1 and a warning where there can be no vertex of that number.
    int resolved(Kind kind, std::int64_t index, std::size_t count)
    {
        const auto before = static_cast<std::int64_t>(count);
        if (index > 0 && index <= std::numeric_limits<int>::max()) {
            m_hasForward |= index > before;
            return static_cast<int>(index - 1);
        }
        if (index < 0 && index >= -before)
            return static_cast<int>(index + before);
        outOfRange(m_line, kind, index, count);
        return -1;
    }

    void outOfRange(int line, Kind kind, std::int64_t index, std::size_t count)
    {
        const Reason expected =
            index == 0  ? Reason(QT_TRANSLATE_NOOP("Diagnostic", "indices count from 1"))
            : index < 0 ? Reason(QT_TRANSLATE_NOOP("Diagnostic", "%1 \"%2\" come before it"), {count, nameOf(kind)})
                        : Reason(QT_TRANSLATE_NOOP("Diagnostic", "the file has %1 \"%2\""), {count, nameOf(kind)});
        m_diagnostics.warning(line, {QT_TRANSLATE_NOOP("Diagnostic", "f: %1 index %2 is out of range; %3"),
                                     {nameOf(kind), index, expected}});
    }

    /// Now that all vertices are known: faces with a corner that is none are left out, absent what else is none.
    void dropBadFaces()
    {
        std::size_t keptFaces = 0;
        std::uint32_t keptCorners = 0;
        std::uint32_t begin = 0;
        for (ObjFace& face : m_out.faces) {
            const std::uint32_t end = face.cornersEnd;
            bool good = true;
            for (std::uint32_t i = begin; i < end; ++i)
                good = repaired(m_out.corners[i], face.line) && good;
            if (good) {
                for (std::uint32_t i = begin; i < end; ++i)
                    m_out.corners[keptCorners++] = m_out.corners[i];
                face.cornersEnd = keptCorners;
                m_out.faces[keptFaces++] = face;
            }
            begin = end;
        }
        m_out.faces.resize(keptFaces);
        m_out.corners.resize(keptCorners);
    }

    /// False where the corner has no position.
    bool repaired(ObjCorner& corner, int line)
    {
        const auto isBeyond = [&](Kind kind, int index, std::size_t count) {
            const bool beyond = index >= 0 && static_cast<std::size_t>(index) >= count;
            if (beyond)
                outOfRange(line, kind, std::int64_t{index} + 1, count);
            return beyond;
        };
        if (isBeyond(TexCoord, corner.uv, m_out.uvs.size()) ||
            (corner.uv >= 0 && std::isnan(m_out.uvs[static_cast<std::size_t>(corner.uv)].x)))
            corner.uv = -1;
        if (isBeyond(Normal, corner.normal, m_out.normals.size()))
            corner.normal = -1;
        if (isBeyond(Position, corner.position, m_out.positions.size()))
            return false;
        const bool bad = std::isnan(m_out.positions[static_cast<std::size_t>(corner.position)].x);
        if (bad)
            m_diagnostics.warning(line,
                                  {QT_TRANSLATE_NOOP("Diagnostic", "f: v %1 is no position; the face is left out"),
                                   {corner.position + 1}});
        return !bad;
    }

    /// How often something was met, and where first.
    struct Tally {
        int number = 0;
        int firstLine = 0;

        void count(int line) { firstLine = number++ == 0 ? line : firstLine; }
    };

    std::string_view m_text;
    ObjPositions m_rounding;
    DiagnosticSink& m_diagnostics;
    ObjText m_out;
    VertexColors m_colors;
    std::string m_joined; ///< a line that goes on over several
    int m_line = 0;
    int m_group = ObjFace::kNoGroup;
    std::size_t m_faceStatements = 0;
    std::array<Tally, kOtherShapes.size()> m_others;
    Tally m_noNormals;
    Tally m_lastOnes;                  ///< corners where vt or vn is -1 and v is not negative
    std::array<Number, 7> m_numbers{}; ///< of the statement at hand
    std::size_t m_count = 0;           ///< how many it has
    std::size_t m_good = 0;            ///< the first so many of them are finite numbers
    bool m_hasReturns = false;
    bool m_hasZeros = false;
    bool m_hasForward = false; ///< an index of a vertex further down, or of none
    bool m_hasBadPositions = false;
    bool m_hasBadUvs = false;
};

} // namespace

ObjText readObjText(std::string_view text, ObjPositions positions, DiagnosticSink& diagnostics)
{
    return Reader(text, positions, diagnostics).run();
}

} // namespace rasterlens
