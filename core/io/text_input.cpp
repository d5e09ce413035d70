#include "core/io/text_input.h"

#include "core/io/input_log.h"
#include "core/io/path_bytes.h"

#include <QFile>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <limits>

namespace rasterlens
{
namespace
{

constexpr off_t kLargestFile = std::numeric_limits<int>::max();

bool isBlank(char c) { return c == ' ' || c == '\t'; }

/// Nan and infinity as C libraries print them, beside `nan` and `inf`: `1.#IND`, `1.#QNAN`, `1.#INF`, `nan(ind)`.
bool isPrintedNonFinite(std::string_view digits)
{
    return digits.starts_with("1.#") || digits.starts_with("nan(") || digits.starts_with("NaN(");
}

/// A number of the given format without its sign: from_chars knows neither `+` nor `0x`.
NumberText magnitudeFromText(std::string_view digits, std::chars_format format)
{
    float value = 0;
    const char* end = digits.data() + digits.size();
    auto parsed = std::from_chars(digits.data(), end, value, format);
    if (parsed.ec == std::errc::result_out_of_range) {
        // Too small is zero, too large is an error: a wider type tells which, or at last the sign of the exponent.
        long double wide = 0;
        parsed = std::from_chars(digits.data(), end, wide, format);
        const bool beyondAllTypes = parsed.ec == std::errc::result_out_of_range;
        const bool small = beyondAllTypes ? digits.find('-') != std::string_view::npos : wide < 1;
        if (!small)
            return {0, NumberFault::OutOfRange};
        parsed.ec = std::errc();
        value = static_cast<float>(wide);
    }
    if (isPrintedNonFinite(digits))
        return {0, NumberFault::NotFinite};
    if (parsed.ec != std::errc() || parsed.ptr != end)
        return {};
    return {value, std::isfinite(value) ? NumberFault::None : NumberFault::NotFinite};
}

NumberText signedFromText(std::string_view word, bool hexAllowed)
{
    const bool negative = word.starts_with('-');
    if (negative || word.starts_with('+'))
        word.remove_prefix(1);
    if (word.empty() || word.front() == '-')
        return {};
    const bool hex = hexAllowed && (word.starts_with("0x") || word.starts_with("0X"));
    if (hex)
        word.remove_prefix(2);
    // After 0x only digits are a number: from_chars would also take `inf` and a sign.
    const bool hexDigitsFollow =
        !word.empty() && (word.front() == '.' || std::isxdigit(static_cast<unsigned char>(word.front())));
    if (hex && !hexDigitsFollow)
        return {};
    NumberText number = magnitudeFromText(word, hex ? std::chars_format::hex : std::chars_format::general);
    if (negative)
        number.value = -number.value;
    return number;
}

} // namespace

DiagnosticSink::DiagnosticSink(const QString& file, int keptOfAKind)
    : m_file(readablePath(file)), m_keptOfAKind(keptOfAKind)
{
}

void DiagnosticSink::add(Severity severity, int line, Reason message)
{
    auto kind = std::find_if(m_kinds.begin(), m_kinds.end(),
                             [&](const Kind& k) { return k.severity == severity && k.text == message.text; });
    if (kind == m_kinds.end())
        kind = m_kinds.insert(kind, {severity, message.text, line, 0});
    if (++kind->count <= m_keptOfAKind)
        m_kept.push_back({severity, m_file, line, std::move(message)});
}

bool DiagnosticSink::hasErrors() const { return rasterlens::hasErrors(m_kept); }

void DiagnosticSink::promoteWarnings()
{
    for (Kind& kind : m_kinds)
        if (kind.severity == Severity::Warning)
            kind.severity = Severity::Error;
    for (Diagnostic& diagnostic : m_kept)
        if (diagnostic.severity == Severity::Warning)
            diagnostic.severity = Severity::Error;
}

Diagnostics DiagnosticSink::take()
{
    const auto lineOrLast = [](const Diagnostic& d) { return d.line > 0 ? d.line : std::numeric_limits<int>::max(); };
    std::stable_sort(m_kept.begin(), m_kept.end(),
                     [&](const Diagnostic& a, const Diagnostic& b) { return lineOrLast(a) < lineOrLast(b); });
    for (const Kind& kind : m_kinds)
        if (const int more = kind.count - m_keptOfAKind; more > 0)
            m_kept.push_back({kind.severity,
                              m_file,
                              0,
                              {QT_TRANSLATE_NOOP("Diagnostic", "and %1 more remarks like that on line %2"),
                               {more, kind.firstLine}}});
    m_kinds.clear();
    return std::move(m_kept);
}

namespace
{

/// Why a file is not read, by what the system says of it.
std::optional<Reason> problemOf(const struct stat& info)
{
    if (S_ISDIR(info.st_mode))
        return QT_TRANSLATE_NOOP("Diagnostic", "this is a directory; a file is expected");
    if (!S_ISREG(info.st_mode))
        return QT_TRANSLATE_NOOP("Diagnostic", "this is a device or a pipe; a file is expected");
    if (info.st_size > kLargestFile)
        return QT_TRANSLATE_NOOP("Diagnostic", "the file is larger than 2 GB");
    if (info.st_size == 0)
        return QT_TRANSLATE_NOOP("Diagnostic", "the file is empty");
    return std::nullopt;
}

} // namespace

OpenInput openInput(const QString& path)
{
    InputLog::note(path);
    const auto failed = [](Reason why) { return OpenInput{-1, 0, std::move(why)}; };
    const auto systemSays = [&] {
        return failed({QT_TRANSLATE_NOOP("Diagnostic", "the file cannot be read: %1"), {qt_error_string(errno)}});
    };
    const QByteArray name = bytesOfPath(path);
    struct stat info = {};
    if (::stat(name.constData(), &info) != 0)
        return errno == EACCES ? systemSays() : failed(QT_TRANSLATE_NOOP("Diagnostic", "there is no such file"));
    if (auto problem = problemOf(info)) // a device that is opened may already do something
        return failed(std::move(*problem));
    const int descriptor = ::open(name.constData(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
    if (descriptor < 0)
        return systemSays();
    // Another program may have put something else in its place meanwhile.
    std::optional<Reason> problem =
        ::fstat(descriptor, &info) == 0 ? problemOf(info) : std::optional(Reason(qt_error_string(errno)));
    if (!problem)
        return {descriptor, static_cast<std::size_t>(info.st_size), {}};
    ::close(descriptor);
    return failed(std::move(*problem));
}

InputBytes readInput(const QString& path)
{
    if (path.startsWith(QLatin1Char(':'))) { // a resource of the program itself
        QFile resource(path);
        if (!resource.open(QIODevice::ReadOnly))
            return {{}, Reason(QT_TRANSLATE_NOOP("Diagnostic", "there is no such file"))};
        return {resource.readAll(), {}};
    }
    const OpenInput input = openInput(path);
    if (input.problem)
        return {{}, input.problem};
    QFile file;
    QByteArray bytes;
    if (file.open(input.descriptor, QIODevice::ReadOnly, QFileDevice::AutoCloseHandle))
        bytes = file.read(static_cast<qint64>(input.size)); // no more: what looks like a file may never end
    if (file.error() != QFileDevice::NoError)
        return {{}, Reason{QT_TRANSLATE_NOOP("Diagnostic", "the file cannot be read: %1"), {file.errorString()}}};
    return {bytes, {}};
}

bool continuesOnNextLine(std::string_view line)
{
    if (!line.ends_with('\\'))
        return false;
    std::string_view rest = line;
    std::string keyword(nextWord(rest));
    for (char& c : keyword)
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    constexpr std::string_view kNamed[] = {"mtllib", "usemtl", "newmtl", "g", "o", "call", "csh", "maplib", "usemap"};
    const bool named = keyword.starts_with("map_") || std::ranges::find(kNamed, keyword) != std::end(kNamed);
    if (!named)
        return line.find('#') == std::string_view::npos;
    return line.size() > 1 && isBlank(line[line.size() - 2]);
}

LineCursor::LineCursor(QByteArray& text, Continuation continuation)
    : m_at(text.data()), m_end(m_at + text.size()), m_continuation(continuation)
{
}

std::optional<TextLine> LineCursor::next()
{
    if (m_at == m_end)
        return std::nullopt;
    TextLine line{m_at, m_at, m_line};
    for (;;) {
        char* const lineEnd = std::find_if(m_at, m_end, [](char c) { return c == '\n' || c == '\r'; });
        m_at = lineEnd;
        if (m_at != m_end)
            m_at += *m_at == '\r' && m_at + 1 != m_end && m_at[1] == '\n' ? 2 : 1;
        ++m_line;
        const bool joins = m_continuation == Continuation::Backslash &&
                           continuesOnNextLine({line.begin, static_cast<std::size_t>(lineEnd - line.begin)});
        if (joins)
            std::fill(lineEnd - 1, m_at, ' ');
        if (!joins || m_at == m_end) {
            line.end = lineEnd;
            return line;
        }
    }
}

std::string_view nextWord(std::string_view& rest)
{
    const auto begin = std::find_if_not(rest.begin(), rest.end(), isBlank);
    const auto end = std::find_if(begin, rest.end(), isBlank);
    const std::string_view word(begin, end);
    rest = {end, rest.end()};
    return word;
}

std::string_view trimmed(std::string_view text)
{
    while (!text.empty() && isBlank(text.front()))
        text.remove_prefix(1);
    while (!text.empty() && isBlank(text.back()))
        text.remove_suffix(1);
    return text;
}

QString quotedWord(std::string_view word)
{
    constexpr std::size_t kLongest = 40;
    QString text = readableName(word.substr(0, kLongest));
    for (QChar& c : text)
        if (!c.isPrint())
            c = QChar::ReplacementCharacter;
    return QStringLiteral("\"%1%2\"").arg(text, word.size() > kLongest ? QStringLiteral("...") : QString());
}

NumberText decimalFromText(std::string_view word) { return signedFromText(word, false); }

double doubleFromText(std::string_view word)
{
    if (word.starts_with('+'))
        word.remove_prefix(1);
    double value = 0; // what from_chars leaves as it is lies too near to 0 for a double
    std::from_chars(word.data(), word.data() + word.size(), value);
    return value;
}

NumberText numberFromText(std::string_view word) { return signedFromText(word, true); }

Reason describe(NumberFault fault, std::string_view word)
{
    switch (fault) {
    case NumberFault::NotFinite: return {QT_TRANSLATE_NOOP("Diagnostic", "%1 is not finite"), {quotedWord(word)}};
    case NumberFault::OutOfRange:
        return {QT_TRANSLATE_NOOP("Diagnostic", "%1 is beyond the range of float32"), {quotedWord(word)}};
    case NumberFault::NotANumber:
    case NumberFault::None: break;
    }
    if (word.empty())
        return QT_TRANSLATE_NOOP("Diagnostic", "a number is missing");
    return {QT_TRANSLATE_NOOP("Diagnostic", "%1 is not a number"), {quotedWord(word)}};
}

} // namespace rasterlens
