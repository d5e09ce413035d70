#pragma once
#include "core/base/diagnostics.h"

#include <QByteArray>

#include <optional>
#include <string_view>

namespace rasterlens
{

/// Collects the remarks about one file: the first of each kind, then how many more of that kind there were. A kind is
/// all remarks of one severity that are worded alike.
class DiagnosticSink
{
public:
    static constexpr int kKeptOfAKind = 5;

    explicit DiagnosticSink(const QString& file, int keptOfAKind = kKeptOfAKind);

    void error(int line, Reason message) { add(Severity::Error, line, std::move(message)); }
    void warning(int line, Reason message) { add(Severity::Warning, line, std::move(message)); }
    void note(int line, Reason message) { add(Severity::Note, line, std::move(message)); }
    [[nodiscard]] bool hasErrors() const;
    [[nodiscard]] const QString& file() const { return m_file; }

    /// Makes errors of all warnings: what they took away was all there is.
    void promoteWarnings();

    /// What was collected.
    ///
    /// order   by line, remarks without a line last
    [[nodiscard]] Diagnostics take();

private:
    struct Kind {
        Severity severity;
        const char* text;
        int firstLine;
        int count;
    };

    void add(Severity severity, int line, Reason message);

    QString m_file;
    int m_keptOfAKind;
    Diagnostics m_kept;
    std::vector<Kind> m_kinds;
};

/// A regular file, open for reading.
struct OpenInput {
    int descriptor = -1;
    std::size_t size = 0;
    std::optional<Reason> problem; ///< why it is not open: a sentence without the file name
};

/// Opens a file, whose descriptor the caller then closes; an InputLog lists it. The errors are those of readInput().
[[nodiscard]] OpenInput openInput(const QString& path);

struct InputBytes {
    QByteArray bytes;
    std::optional<Reason> problem; ///< why there are none: a sentence without the file name
};

/// The bytes of a file. Its name may hold bytes that are not UTF-8: see path_bytes.h.
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

/// Whether a line of an OBJ or MTL text ends with a backslash that joins the next line to it. One at the end of a
/// comment does not, and one at the end of a name (`D:\\work\\`) does only behind a blank.
[[nodiscard]] bool continuesOnNextLine(std::string_view line);

/// Walks the lines of a text that may be changed in place. Lines end with LF, CRLF or CR.
///
/// out     with Continuation::Backslash a backslash at the end of a line joins the next one to it (see
///         continuesOnNextLine): backslash and line end are overwritten with blanks
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

/// `word` for a message: in quotes, shortened, bytes that are not UTF-8 read as readableName() does.
[[nodiscard]] QString quotedWord(std::string_view word);

enum class NumberFault { None, NotANumber, NotFinite, OutOfRange };

struct NumberText {
    float value = 0;
    NumberFault fault = NumberFault::NotANumber;
};

/// A decimal number with an optional sign as the nearest float32, whatever the locale.
///
/// covers  nan and inf, and as some C libraries print them (`-1.#IND`, `nan(ind)`): NotFinite. What is too small
///         becomes zero.
/// errors  NotANumber for any other text, OutOfRange for what rounds to infinity
[[nodiscard]] NumberText decimalFromText(std::string_view word);

/// The double nearest to a decimal number. in: a word in which decimalFromText found no fault
[[nodiscard]] double doubleFromText(std::string_view word);

/// As decimalFromText, and C99 hexadecimal floating-point numbers.
[[nodiscard]] NumberText numberFromText(std::string_view word);

/// What is wrong with `word`, as a sentence; `fault` is not None.
[[nodiscard]] Reason describe(NumberFault fault, std::string_view word);

} // namespace rasterlens
