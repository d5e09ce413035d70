#pragma once
#include "core/base/diagnostics.h"
#include "core/io/input_log.h"
#include "core/io/session.h"
#include "core/lessons/moment.h"
#include "core/scene/scene.h"
#include "core/settings/settings.h"
#include "ui/base/latest_result.h"

#include <QObject>
#include <QStringList>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace rasterlens
{

/// What the window works on: one scene and one Settings value, with undo of both. Panels hold no copy.
class Document : public QObject
{
    Q_OBJECT

public:
    /// Camera edits that follow each other are one undo step until endGesture().
    enum class Edit { Step, Camera };

    explicit Document(QObject* parent = nullptr);
    ~Document() override;

    [[nodiscard]] const std::shared_ptr<const Scene>& scene() const { return m_scene; }
    [[nodiscard]] const Settings& settings() const { return m_settings; }
    [[nodiscard]] const Settings& defaults() const { return m_scene->defaults; }

    /// Compares, stores, emits settingsChanged once.
    void setSettings(const Settings& settings, Edit edit = Edit::Step);
    void endGesture() { m_inGesture = false; }

    /// Takes the scene's own settings and forgets the undo steps, which were about another scene.
    void setScene(std::shared_ptr<const Scene> scene);
    void setScene(std::shared_ptr<const Scene> scene, const Settings& settings);
    /// Takes a changed mesh of the same scene as an undo step; Camera: as for settings.
    void editScene(std::shared_ptr<const Scene> scene, Edit edit = Edit::Step);

    [[nodiscard]] bool canUndo() const { return !m_undo.empty(); }
    [[nodiscard]] bool canRedo() const { return !m_redo.empty(); }
    void undo();
    void redo();
    void resetSettings() { setSettings(defaults()); }

    /// Opens an `.obj`, a `.case`, a session `.json`, `builtin:NAME` or `stress:NAME` on a background thread.
    ///
    /// errors  diagnosticsReported, also where memory or threads are wanting; scene and settings stay as they were
    void open(const QString& name);
    /// Opens a scene as open() does, then changes the settings that the file asks for by `change`.
    void openWith(const QString& name, std::function<void(Settings&)> change);
    /// Opens a session whose scene lies at another place than it says.
    void openSessionWith(const QString& path, const QString& scene);
    [[nodiscard]] bool isLoading() const { return m_loading; }
    /// Opens the scene and the settings in which a mistake shows, on a background thread as open() does.
    void openMistake(const QString& id);
    /// What a moment gives up: asked about, as before another scene is opened, or only kept for undo.
    enum class GivingUp { Asks, Silent };
    /// Opens scene and settings of a moment on a background thread, as one undo step, whatever was open before. Scene
    /// and settings are then all that a session would store: nothing of them is an unsaved change.
    ///
    /// errors  diagnosticsReported, and the undo steps stay as they were
    void openMoment(const Moment& moment, GivingUp former);
    /// Called before the window changes as a whole. The function that it returns shows again what the window showed
    /// besides scene and settings.
    using ViewKeeper = std::function<std::function<void()>()>;
    void setViewKeeper(ViewKeeper keeper) { m_viewKeeper = std::move(keeper); }

    /// What a session keeps besides scene and settings is asked for when it is written.
    using ViewReader = std::function<QJsonObject()>;
    void setViewReader(ViewReader reader) { m_viewReader = std::move(reader); }

    /// Opens the session that an earlier run left behind, as unsaved changes of `sessionPath` (empty: never saved).
    void openRecovered(const QString& file, const QString& sessionPath);

    /// Reads the files of the scene once more. Settings, moved vertices and the undo steps stay as far as they fit.
    ///
    /// errors  diagnosticsReported; all stays as it was
    void reload();
    /// Whether the scene comes from files on the disk.
    [[nodiscard]] bool isReloadable() const;
    /// Every file that the scene and its session were read from, as it lay on the disk at that time.
    [[nodiscard]] const std::vector<InputFile>& inputs() const { return m_inputs; }

    /// The document calls this function before it gives up unsaved changes for another scene. The function calls
    /// `answer` once the user has decided.
    using LeaveGuard = std::function<void(std::function<void(bool mayLeave)> answer)>;
    void setLeaveGuard(LeaveGuard guard) { m_leaveGuard = std::move(guard); }

    /// errors  diagnosticsReported, also for a file of the scene, which stays; false
    bool saveSession(const QString& path);
    [[nodiscard]] const QString& sessionPath() const { return m_sessionPath; }
    /// The files that the picture is made of: scene, materials, textures, session.
    [[nodiscard]] QStringList inputFiles() const;
    /// What saveSession() writes.
    [[nodiscard]] Session session() const;

    /// Whether a session would store something else than what was last opened or saved.
    [[nodiscard]] bool isDirty() const;

    [[nodiscard]] QStringList recentFiles() const;
    /// Puts a file on top of the list.
    void rememberRecent(const QString& path);
    void clearRecentFiles();

Q_SIGNALS:
    void sceneChanged(); ///< settingsChanged follows
    void settingsChanged();
    void loadingChanged(bool loading, const QString& name);
    void diagnosticsReported(const rasterlens::Diagnostics& diagnostics);
    void recentFilesChanged();
    void opened(const QString& name);
    /// Behind opened(): a session tells what the window showed.
    void viewOpened(const QJsonObject& view, const QString& file);
    void momentOpened();                       ///< behind settingsChanged
    void momentRefused();                      ///< what is open stays
    void sceneMissing(const QString& session); ///< behind diagnosticsReported: the user may say where the model is
    void inputsChanged();

private:
    /// What the background thread brings back.
    struct Opened {
        std::shared_ptr<const Scene> scene;
        std::shared_ptr<const Scene> original; ///< before the session moved vertices
        std::optional<Settings> settings;      ///< of a session
        Diagnostics diagnostics;
        bool isPartial = false;      ///< a session that says more than was understood, which is not to be saved over
        bool sceneIsMissing = false; ///< the model of a session is at none of its places
        std::vector<InputFile> inputs{};
        QJsonObject view{}; ///< of a session
    };

    /// What an opening is for, and what it finds when it ends.
    struct Opening {
        enum class Kind { Scene, Recovered, Reload, Moment };

        QString name{};
        Kind kind = Kind::Scene;
        QString sessionPath{};                      ///< Recovered: where the changes belong
        std::shared_ptr<const Scene> agreedScene{}; ///< the state that the user gave up for it, if any
        Settings agreedSettings{};
        GivingUp former = GivingUp::Asks; ///< Moment
    };

    /// What a change of the whole window gives up besides scene and settings.
    struct Whole {
        std::shared_ptr<const Scene> original;
        std::shared_ptr<const Scene> cleanScene;
        Settings clean;
        std::vector<InputFile> inputs;
        QString sessionPath;
        bool recovered = false;
        std::function<void()> showView;
    };

    /// One step of undo.
    struct State {
        std::shared_ptr<const Scene> scene;
        Settings settings;
        std::optional<Whole> whole{}; ///< of a step that changed the whole window
    };

    [[nodiscard]] static Opened load(const QString& name, const QString& sceneInstead = {});
    void startOpening(Opening opening, std::function<Opened()> load);
    void beginLoading(Opening opening, std::function<Opened()> load);
    void finishOpening(const Opened& opened);
    void failOpening(Lack lack);
    void take(const Opening& opening, const Opened& opened);
    void takeReloaded(const QString& name, const Opened& opened);
    void install(const Opened& opened, bool recovered);
    void noteInputs(const std::vector<InputFile>& inputs);
    void takeMoment(const Opened& opened);
    void rememberStep(Edit edit);
    void stay(const Opening& opening);
    void pushUndo(State state);
    [[nodiscard]] State present(bool withWhole) const;
    void restore(const State& state);
    void replace(const State& state);

    std::shared_ptr<const Scene> m_scene;
    Settings m_settings;
    Settings m_clean; ///< as last opened or saved
    std::shared_ptr<const Scene> m_cleanScene;
    std::shared_ptr<const Scene> m_original; ///< before any vertex was moved
    std::vector<State> m_undo;               ///< the latest last
    std::vector<State> m_redo;               ///< the next last
    bool m_inGesture = false;
    QString m_sessionPath;
    bool m_recovered = false; ///< from an earlier run, and not saved since
    std::vector<InputFile> m_inputs;
    LeaveGuard m_leaveGuard;
    ViewKeeper m_viewKeeper;
    ViewReader m_viewReader;
    bool m_loading = false;
    quint64 m_openSerial = 0;      ///< counts openings
    Opening m_opening;             ///< the last one
    LatestResult<Opened> m_loader; ///< last: its thread uses the members above
};

} // namespace rasterlens
