#include "ui/document/recovery.h"

#include "core/io/file_writer.h"
#include "core/io/session.h"
#include "ui/document/document.h"
#include "ui/document/folder_lock.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>
#include <QTemporaryDir>

#include <algorithm>
#include <utility>

namespace rasterlens
{
namespace
{

QString sessionFile(const FolderLock& lock) { return lock.folder() + QStringLiteral("/session.json"); }

/// The session file that the changes belong to stands in a file beside them.
QString originFile(const FolderLock& lock) { return lock.folder() + QStringLiteral("/origin"); }

QString readOrigin(const FolderLock& lock)
{
    QFile file(originFile(lock));
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

bool writeOrigin(const FolderLock& lock, const QString& path) { return !writeFile(originFile(lock), path.toUtf8()); }

} // namespace

Recovery::Recovery(Document& document, QObject* parent) : QObject(parent), m_document(document)
{
    m_delay.setSingleShot(true);
    m_delay.setInterval(kDelayMs);
    connect(&m_delay, &QTimer::timeout, this, &Recovery::keep);
    connect(&m_document, &Document::settingsChanged, this, &Recovery::follow);
    findLeft();
}

Recovery::~Recovery()
{
    if (m_hasFile && m_document.isDirty())
        return;
    removeFile();
    if (m_own)
        QDir(m_own->folder()).removeRecursively();
}

QString Recovery::folder()
{
    return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + QStringLiteral("/recovery");
}

/// The timer runs from the first change on, however many follow: it is not put off by them.
void Recovery::follow()
{
    if (!m_document.isDirty()) {
        m_delay.stop();
        removeFile();
    } else if (!m_delay.isActive()) {
        m_delay.start();
    }
}

bool Recovery::keep()
{
    m_delay.stop();
    if (!m_document.isDirty())
        return true;
    const QString origin =
        m_document.sessionPath().isEmpty() ? QString() : QFileInfo(m_document.sessionPath()).absoluteFilePath();
    std::optional<Reason> error;
    if (!makeFolder() || (origin != m_ownSession && !writeOrigin(*m_own, origin)))
        error = Reason(QT_TRANSLATE_NOOP("Diagnostic", "the file cannot be written: %1"), {folder()});
    else
        error = saveSession(m_document.session(), sessionFile(*m_own));
    if (error) {
        if (!std::exchange(m_complained, true))
            Q_EMIT failed(
                textOf(*error, [](const char* text) { return QCoreApplication::translate("Diagnostic", text); }));
        return false;
    }
    m_ownSession = origin;
    m_hasFile = true;
    m_complained = false;
    return true;
}

void Recovery::giveUp()
{
    m_delay.stop();
    removeFile();
}

/// Under the lock of the common folder: a program that looks for what was left must not find a folder that is being
/// made and not locked yet.
bool Recovery::makeFolder()
{
    if (m_own)
        return true;
    if (!QDir().mkpath(folder()))
        return false;
    const auto common = FolderLock::waitFor(folder());
    QTemporaryDir own(folder() + QStringLiteral("/XXXXXX"));
    own.setAutoRemove(false);
    if (!common || !own.isValid())
        return false;
    m_own = FolderLock::take(own.path());
    return m_own != nullptr;
}

void Recovery::removeFile()
{
    if (std::exchange(m_hasFile, false))
        QFile::remove(sessionFile(*m_own));
}

void Recovery::findLeft()
{
    const auto common = FolderLock::waitFor(folder());
    if (!common)
        return; // nothing was ever kept
    const QFileInfoList folders = QDir(folder()).entryInfoList(QDir::Dirs | QDir::NoDotAndDotDot);
    for (const QFileInfo& info : folders) {
        auto lock = FolderLock::take(info.absoluteFilePath());
        if (!lock)
            continue; // of a running program
        const QFileInfo session(sessionFile(*lock));
        if (session.size() > 0)
            m_left.push_back(
                {{session.absoluteFilePath(), readOrigin(*lock), session.lastModified()}, std::move(lock)});
        else
            QDir(info.absoluteFilePath()).removeRecursively();
    }
    std::ranges::sort(m_left, {}, [](const Left& left) { return left.found.keptAt; });
}

std::optional<Recovery::Found> Recovery::found() const
{
    if (m_left.empty())
        return std::nullopt;
    return m_left.back().found;
}

void Recovery::dropFound()
{
    if (m_left.empty())
        return;
    QDir(m_left.back().lock->folder()).removeRecursively();
    m_left.pop_back();
}

void Recovery::postponeFound() { m_left.clear(); }

} // namespace rasterlens
