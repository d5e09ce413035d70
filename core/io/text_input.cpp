#include "core/io/text_input.h"

#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace rasterlens
{
namespace
{

constexpr int kDiagnosticsKept = 20;
constexpr qint64 kLargestFile = std::numeric_limits<int>::max();

bool isBlank(char c) { return c == ' ' || c == '\t'; }

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

void DiagnosticSink::add(Severity severity, int line, Reason message)
{
    if (++m_counts[static_cast<int>(severity)] <= kDiagnosticsKept)
        m_kept.push_back({severity, m_file, line, std::move(message)});
}

Diagnostics DiagnosticSink::take()
{
    const auto lineOrLast = [](const Diagnostic& d) { return d.line > 0 ? d.line : std::numeric_limits<int>::max(); };
    std::stable_sort(m_kept.begin(), m_kept.end(),
                     [&](const Diagnostic& a, const Diagnostic& b) { return lineOrLast(a) < lineOrLast(b); });
    for (const Severity severity : {Severity::Error, Severity::Warning})
        if (const int more = m_counts[static_cast<int>(severity)] - kDiagnosticsKept; more > 0)
            m_kept.push_back({severity, m_file, 0, {QT_TRANSLATE_NOOP("Diagnostic", "and %1 more"), {more}}});
    return std::move(m_kept);
}

InputBytes readInput(const QString& path)
{
    const auto failed = [](Reason why) { return InputBytes{{}, std::move(why)}; };
    const QFileInfo info(path);
    if (!info.exists())
        return failed(QT_TRANSLATE_NOOP("Diagnostic", "there is no such file"));
    if (info.isDir())
        return failed(QT_TRANSLATE_NOOP("Diagnostic", "this is a directory; a file is expected"));
    if (!info.isFile())
        return failed(QT_TRANSLATE_NOOP("Diagnostic", "this is a device or a pipe; a file is expected"));
    if (info.size() > kLargestFile)
        return failed(QT_TRANSLATE_NOOP("Diagnostic", "the file is larger than 2 GB"));
    QFile file(path);
    InputBytes input;
    if (file.open(QIODevice::ReadOnly))
        input.bytes = file.readAll();
    if (file.error() != QFileDevice::NoError)
        return failed({QT_TRANSLATE_NOOP("Diagnostic", "the file cannot be read: %1"), {file.errorString()}});
    if (input.bytes.isEmpty())
        return failed(QT_TRANSLATE_NOOP("Diagnostic", "the file is empty"));
    return input;
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
        const bool joins = m_continuation == Continuation::Backslash && lineEnd != line.begin && lineEnd[-1] == '\\';
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
    QString text = QString::fromUtf8(word.data(), static_cast<qsizetype>(std::min(word.size(), kLongest)));
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
