#pragma once
#include <QDateTime>
#include <QObject>
#include <QStringList>
#include <QTimer>

#include <memory>
#include <optional>
#include <vector>

namespace rasterlens
{

class Document;
class FolderLock;

/// Keeps the unsaved changes of a document on the disk, and finds those that an earlier run could not save.
///
/// Each running program has a folder of its own that it locks. The system gives the lock up when the program ends, in
/// whatever way, so a folder that can be locked belongs to no program: what is in it may be offered.
class Recovery : public QObject
{
    Q_OBJECT

public:
    /// Changes left behind by a run that ended without saving them.
    struct Found {
        QString file;        ///< a session
        QString sessionPath; ///< the session file that it belongs to; empty: it was never saved
        QDateTime keptAt;
    };

    explicit Recovery(Document& document, QObject* parent = nullptr);
    /// Takes the own file away unless it holds changes that were never given up.
    ~Recovery() override;

    /// Writes the changes at once, in place of within kDelayMs.
    ///
    /// errors  failed; false. A document without changes has no file, and that is no error.
    bool keep();
    /// The user does not want the present changes.
    void giveUp();

    /// The newest changes of a run that is over; no other running program is offered the same.
    [[nodiscard]] std::optional<Found> found() const;
    /// Takes what found() names from the disk.
    void dropFound();
    /// Leaves what found() names for the next start.
    void postponeFound();

    [[nodiscard]] static QString folder();
    static constexpr int kDelayMs = 2000; ///< a change is on the disk after so long

Q_SIGNALS:
    void failed(const QString& why);

private:
    struct Left {
        Found found;
        std::unique_ptr<FolderLock> lock;
    };

    void follow();
    void findLeft();
    bool makeFolder();
    void removeFile();

    Document& m_document;
    std::unique_ptr<FolderLock> m_own; ///< made with the first change
    std::vector<Left> m_left;          ///< the newest last
    QTimer m_delay;
    QString m_ownSession; ///< the path that stands in the own folder
    bool m_hasFile = false;
    bool m_complained = false;
};

} // namespace rasterlens
