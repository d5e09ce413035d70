#pragma once
#include "core/base/diagnostics.h"

#include <QByteArray>

#include <optional>
#include <string_view>

namespace rasterlens
{

/// Collects the remarks about one file: the first 20 of each severity, then how many more there were.
class DiagnosticSink
{
public:
    explicit DiagnosticSink(QString file) : m_file(std::move(file)) {}

    void error(int line, Reason message) { add(Severity::Error, line, std::move(message)); }
    void warning(int line, Reason message) { add(Severity::Warning, line, std::move(message)); }
    [[nodiscard]] bool hasErrors() const { return m_counts[static_cast<int>(Severity::Error)] > 0; }
    [[nodiscard]] const QString& file() const { return m_file; }

    /// What was collected.
    ///
    /// order   by line, remarks without a line last
    [[nodiscard]] Diagnostics take();

private:
    void add(Severity severity, int line, Reason message);

    QString m_file;
    Diagnostics m_kept;
    int m_counts[2] = {0, 0};
};

struct InputBytes {
    QByteArray bytes;
    std::optional<Reason> problem; ///< why there are none: a sentence without the file name
};

/// The bytes of a file.
///
/// errors  no such file, a directory or device, not readable, empty, larger than 2 GB
[[nodiscard]] InputBytes readInput(const QString& path);

/// A logical line: [begin, end) without its line end, and the number of its first line, from 1.
struct TextLine {
    char* begin = nullptr;
    char* end = nullptr;
    int number = 0;

    [[nodiscard]] std::string_view text() const { return {begin, static_cast<std::size_t>(end - begin)}; }
};

enum class Continuation { None, Backslash };

/// Walks the lines of a text that may be changed in place. Lines end with LF, CRLF or CR.
///
/// out     with Continuation::Backslash a backslash at the end of a line joins the next one to it: backslash and
///         line end are overwritten with blanks
class LineCursor
{
public:
    LineCursor(QByteArray& text, Continuation continuation);

    /// The next line, or nothing at the end of the text.
    [[nodiscard]] std::optional<TextLine> next();
    /// The number of the last line that was begun; at least 1.
    [[nodiscard]] int lastLine() const { return m_line > 1 ? m_line - 1 : 1; }

private:
    char* m_at;
    char* m_end;
    int m_line = 1;
    Continuation m_continuation;
};

/// Cuts the next word off the front of `rest`; empty at the end. Words are separated by blanks and tabs.
[[nodiscard]] std::string_view nextWord(std::string_view& rest);
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// `word` for a message: in quotes, shortened, bytes that are not UTF-8 replaced.
[[nodiscard]] QString quotedWord(std::string_view word);

enum class NumberFault { None, NotANumber, NotFinite, OutOfRange };

struct NumberText {
    float value = 0;
    NumberFault fault = NumberFault::NotANumber;
};

/// A decimal number with an optional sign as the nearest float32, whatever the locale.
///
/// covers  nan and inf: NotFinite, with their value. What is too small becomes zero.
/// errors  NotANumber for any other text, OutOfRange for what rounds to infinity
[[nodiscard]] NumberText decimalFromText(std::string_view word);

/// The same number as the nearest double; for words of which decimalFromText found no fault.
[[nodiscard]] double doubleFromText(std::string_view word);

/// As decimalFromText, and C99 hexadecimal floating-point numbers.
[[nodiscard]] NumberText numberFromText(std::string_view word);

/// What is wrong with `word`, as a sentence; `fault` is not None.
[[nodiscard]] Reason describe(NumberFault fault, std::string_view word);

} // namespace rasterlens
