#include "core/io/file_names.h"

#include "core/io/text_input.h"

#include <QDir>
#include <QFileInfo>
#include <QStringConverter>
#include <QStringList>

#include <dirent.h>
#include <sys/stat.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

namespace rasterlens
{
namespace
{

QByteArray bytesOf(std::string_view text) { return {text.data(), static_cast<qsizetype>(text.size())}; }

/// The path whose bytes are the text in an encoding, or nothing where that lacks a character of it.
std::optional<QString> encoded(const QString& text, QStringEncoder encoder)
{
    if (!encoder.isValid())
        return std::nullopt;
    const QByteArray bytes = encoder.encode(text);
    return encoder.hasError() ? std::nullopt : std::optional(pathFromBytes(bytes));
}

QString withSlashes(QString name) { return name.replace(QLatin1Char('\\'), QLatin1Char('/')); }

/// What the name may be on the disk, the likeliest first. A GBK character may hold the byte of a backslash, so the
/// bytes are tried as they are before backslashes count as separators.
QStringList spellings(const QByteArray& name)
{
    const QString raw = pathFromBytes(name);
    QStringList list{raw, withSlashes(raw)};
    const auto add = [&](const std::optional<QString>& text) {
        if (text)
            list << withSlashes(*text);
    };
    if (const auto utf8 = asUtf8(name)) {
        add(encoded(*utf8, QStringEncoder(kChineseEncoding)));
        add(encoded(*utf8, QStringEncoder(QStringEncoder::Latin1)));
        add(asChinese(name)); // two bytes of GBK may also be one character of UTF-8
    } else {
        add(asChinese(name));
        add(QString::fromLatin1(name));
    }
    if (name.contains('%'))
        list << withSlashes(pathFromBytes(QByteArray::fromPercentEncoding(name)));
    list.removeDuplicates();
    return list;
}

/// What lies in a folder. std::filesystem::directory_iterator ends the program where it gets no memory.
std::vector<QString> namesIn(const QString& folder)
{
    const std::unique_ptr<DIR, int (*)(DIR*)> open(::opendir(bytesOfPath(folder).constData()), &::closedir);
    std::vector<QString> names;
    if (open)
        while (const dirent* const entry = ::readdir(open.get()))
            names.push_back(pathFromBytes(QByteArray(entry->d_name)));
    return names;
}

/// The path with each part as it is spelt on the disk, found without regard to case; nothing where there is none.
std::optional<QString> inAnyCase(const QString& path)
{
    const qsizetype slash = path.lastIndexOf(QLatin1Char('/'));
    if (slash < 0 || slash + 1 == path.size())
        return std::nullopt;
    QString folder = path.left(std::max<qsizetype>(slash, 1));
    if (!fileExists(folder)) {
        const auto found = inAnyCase(folder);
        if (!found)
            return std::nullopt;
        folder = *found;
    }
    const QString wanted = path.mid(slash + 1).toCaseFolded();
    std::optional<QString> best;
    for (const QString& name : namesIn(folder))
        if (name.toCaseFolded() == wanted && (!best || name < *best))
            best = name;
    if (best)
        best = folder + (folder.endsWith(QLatin1Char('/')) ? QString() : QStringLiteral("/")) + *best;
    return best;
}

std::string_view withoutQuotes(std::string_view name)
{
    name = trimmed(name);
    const bool quoted =
        name.size() >= 2 && (name.front() == '"' || name.front() == '\'') && name.back() == name.front();
    return quoted ? trimmed(name.substr(1, name.size() - 2)) : name;
}

} // namespace

bool fileExists(const QString& path)
{
    struct stat info = {};
    return ::stat(bytesOfPath(path).constData(), &info) == 0;
}

namespace
{

NamedFile findAsSpelt(const QString& owner, std::string_view name, const Reach& reach)
{
    const QDir folder = QFileInfo(owner).absoluteDir();
    const auto beside = [&](const QString& spelling) {
        return folder.absoluteFilePath(spelling.section(QLatin1Char('/'), -1));
    };
    const auto isThere = [&](const QString& path) { return reach.covers(path) && fileExists(path); };
    const QStringList all = spellings(bytesOf(withoutQuotes(name)));
    for (qsizetype i = 0; i < all.size(); ++i)
        if (const QString path = folder.absoluteFilePath(all[i]); isThere(path))
            return {path, i < 2 ? FoundBy::Name : FoundBy::Encoding};
    for (const QString& spelling : all)
        if (const QString path = beside(withSlashes(spelling)); isThere(path))
            return {path, FoundBy::Beside};
    for (const QString& spelling : all)
        for (const QString& path : {folder.absoluteFilePath(spelling), beside(withSlashes(spelling))})
            if (const auto found = reach.covers(path) ? inAnyCase(path) : std::nullopt; found && reach.covers(*found))
                return {*found, FoundBy::LetterCase};
    const QString expected = folder.absoluteFilePath(all.value(1, all.front()));
    if (!reach.covers(expected))
        return {QDir::cleanPath(expected), FoundBy::Outside};
    return {expected, FoundBy::Nothing};
}

} // namespace

bool NamedFile::isFound() const { return foundBy != FoundBy::Nothing && foundBy != FoundBy::Outside; }

NamedFile findNamedFile(const QString& owner, std::string_view name, const Reach& reach)
{
    NamedFile whole = findAsSpelt(owner, name, reach);
    const std::size_t comment = name.find(" #");
    if (whole.isFound() || comment == std::string_view::npos)
        return whole;
    NamedFile withoutComment = findAsSpelt(owner, name.substr(0, comment), reach);
    return withoutComment.isFound() ? withoutComment : whole;
}

void remarkOn(const NamedFile& file, std::string_view keyword, int line, DiagnosticSink& diagnostics)
{
    const Reason name = readablePath(file.path).section(QLatin1Char('/'), -1);
    if (file.foundBy == FoundBy::LetterCase)
        diagnostics.warning(line, {QT_TRANSLATE_NOOP("Diagnostic", "%1: the file's name has other letters large: %2"),
                                   {readableName(keyword), name}});
    else if (file.foundBy == FoundBy::Beside)
        diagnostics.note(line, {QT_TRANSLATE_NOOP("Diagnostic", "%1: %2 is read from the folder of this file"),
                                {readableName(keyword), name}});
}

} // namespace rasterlens
