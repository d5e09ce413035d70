#pragma once
#include "core/io/input_log.h"

#include <QFileSystemWatcher>
#include <QObject>
#include <QStringList>
#include <QTimer>

#include <vector>

namespace rasterlens
{

/// Tells when files on the disk are no longer as they were read. Editors write in place, put a new file over the old
/// one by renaming, or delete and write anew; for all of these the names count, not the files behind them.
class FileWatch : public QObject
{
    Q_OBJECT

public:
    explicit FileWatch(QObject* parent = nullptr);

    /// Watches these files instead of those before.
    void watch(std::vector<InputFile> files);

    [[nodiscard]] const QStringList& changed() const { return m_changed; } ///< other than when read
    [[nodiscard]] const QStringList& missing() const { return m_missing; } ///< there when read, now gone

Q_SIGNALS:
    /// changed() or missing() is another list than before. Files still being written are waited for.
    void differs();

private:
    void look();
    void watchPaths();

    std::vector<InputFile> m_files;   ///< as they were read
    std::vector<FileStamp> m_present; ///< at the last look, in the same order
    QStringList m_changed;
    QStringList m_missing;
    QFileSystemWatcher m_watcher;
    QTimer m_settle; ///< from an event to the look at it
    QTimer m_poll;   ///< looks without events, while some path cannot be watched
};

} // namespace rasterlens
