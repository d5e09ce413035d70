#pragma once
#include <QObject>
#include <QPointer>
#include <QStringList>

#include <functional>
#include <memory>
#include <optional>

class QMessageBox;
class QWidget;

namespace rasterlens
{

class Document;
class FileWatch;
class MessageBar;
class Recovery;
class StepMode;

/// Sees to it that no work is lost: asks before changes are given up, keeps them on the disk in the meantime, offers
/// what an earlier run could not save, and offers to read files again that changed on the disk.
class LifeCycle : public QObject
{
    Q_OBJECT

public:
    /// The two bars that offer something.
    struct Bars {
        MessageBar* recovery;
        MessageBar* files;
    };

    LifeCycle(Document& document, StepMode& steps, Bars bars, QWidget& window);
    ~LifeCycle() override;

    /// Begins to ask, to keep and to watch. A window that draws itself into a file and ends does none of it.
    void start();

    /// Whether the window may close now. If not, the user is asked, and the window closes itself if the answer is yes.
    [[nodiscard]] bool mayClose();
    /// The system ends the session or the program: unsaved changes are kept for the next start, nothing is asked.
    void keepForNextStart();

    /// Saves to the file of the session, or asks for one; `done` learns whether it was saved.
    void save(std::function<void(bool saved)> done = {});
    void saveAs(std::function<void(bool saved)> done = {});
    /// A name for a session that was never saved: beside the scene, and of no file that is there already.
    [[nodiscard]] QString proposedPath() const;

    void reload();
    void retranslate();

Q_SIGNALS:
    void saved(const QString& path);
    void warned(const QString& text);
    /// The user agrees that this session or lesson names files outside its folder: it is to be opened again.
    void agreedTo(const QString& file);

private:
    void ask(std::function<void(bool mayLeave)> answer);
    bool saveTo(const QString& path);
    void offerFound();
    void restoreFound();
    void offerReload();
    void finishRestoring(const QString& name);

    Document& m_document;
    StepMode& m_steps;
    Bars m_bars;
    QWidget& m_window;
    std::unique_ptr<Recovery> m_recovery;
    std::unique_ptr<FileWatch> m_watch;
    QPointer<QMessageBox> m_question;
    bool m_leaving = false;            ///< the user agreed to close
    bool m_ending = false;             ///< the system ends the session
    QString m_restoring;               ///< the file that is being opened as a restored session
    std::optional<std::size_t> m_step; ///< the step to show again after a reload
};

} // namespace rasterlens
