#include "ui/document/file_watch.h"

#include <QFileInfo>

#include <utility>

namespace rasterlens
{
namespace
{

constexpr int kSettleMs = 300;
constexpr int kPollMs = 1000;

} // namespace

FileWatch::FileWatch(QObject* parent) : QObject(parent)
{
    m_settle.setSingleShot(true);
    m_settle.setInterval(kSettleMs);
    m_poll.setInterval(kPollMs);
    const auto settle = [this] {
        if (!m_settle.isActive()) // a folder that is never quiet must not put the look off for ever
            m_settle.start();
    };
    connect(&m_watcher, &QFileSystemWatcher::fileChanged, this, settle);
    connect(&m_watcher, &QFileSystemWatcher::directoryChanged, this, settle);
    connect(&m_poll, &QTimer::timeout, this, &FileWatch::look);
    connect(&m_settle, &QTimer::timeout, this, &FileWatch::look);
}

void FileWatch::watch(std::vector<InputFile> files)
{
    const QStringList before = m_watcher.files() + m_watcher.directories();
    if (!before.isEmpty())
        m_watcher.removePaths(before);
    m_files = std::move(files);
    m_present.clear();
    for (const InputFile& file : m_files)
        m_present.push_back(file.stamp);
    m_poll.stop();
    m_settle.stop();
    watchPaths();
    const bool differed = !m_changed.isEmpty() || !m_missing.isEmpty();
    m_changed.clear();
    m_missing.clear();
    if (differed)
        Q_EMIT differs();
    if (!m_files.empty())
        m_settle.start(); // a file may have changed between its reading and now
}

/// The folders tell of files that come back; the files themselves of changes within them. A path that was renamed or
/// deleted is no longer watched and is asked for anew.
void FileWatch::watchPaths()
{
    bool all = true;
    const QStringList watched = m_watcher.files() + m_watcher.directories();
    QStringList wanted;
    for (const InputFile& file : m_files)
        wanted << file.path << QFileInfo(file.path).absolutePath();
    wanted.removeDuplicates();
    for (const QString& path : std::as_const(wanted)) {
        if (watched.contains(path))
            continue;
        const bool isThere = QFileInfo::exists(path);
        const bool added = isThere && m_watcher.addPath(path);
        // A missing file is seen by its folder.
        const bool folderTells = !isThere && QFileInfo::exists(QFileInfo(path).absolutePath());
        all = all && (added || folderTells);
    }
    if (all)
        m_poll.stop();
    else if (!m_poll.isActive())
        m_poll.start();
}

void FileWatch::look()
{
    bool moving = false;
    QStringList changed;
    QStringList missing;
    for (std::size_t i = 0; i < m_files.size(); ++i) {
        const FileStamp now = stampOf(m_files[i].path);
        moving = moving || now != m_present[i];
        m_present[i] = now;
        if (now != m_files[i].stamp)
            (now.exists ? changed : missing) << m_files[i].path;
    }
    watchPaths();
    if (moving) { // perhaps still being written, or between deletion and the new file
        m_settle.start();
        return;
    }
    if (changed == m_changed && missing == m_missing)
        return;
    m_changed = changed;
    m_missing = missing;
    Q_EMIT differs();
}

} // namespace rasterlens
