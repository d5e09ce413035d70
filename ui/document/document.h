#pragma once
#include "core/base/diagnostics.h"
#include "core/scene/scene.h"
#include "core/settings/settings.h"
#include "ui/base/latest_task.h"

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
    /// errors  diagnosticsReported; scene and settings stay as they were
    void open(const QString& name);
    /// Likewise, with a change of the settings that the file asks for.
    void openWith(const QString& name, std::function<void(Settings&)> change);
    [[nodiscard]] bool isLoading() const { return m_loading; }
    /// Opens the scene and the settings in which a mistake shows, likewise.
    void openMistake(const QString& id);

    /// errors  diagnosticsReported; false
    bool saveSession(const QString& path);
    [[nodiscard]] const QString& sessionPath() const { return m_sessionPath; }

    /// Whether settings or mesh differ from those last opened or saved.
    [[nodiscard]] bool isDirty() const { return !(m_settings == m_clean) || m_scene != m_cleanScene; }

    [[nodiscard]] QStringList recentFiles() const;
    void clearRecentFiles();

Q_SIGNALS:
    void sceneChanged(); ///< settingsChanged follows
    void settingsChanged();
    void loadingChanged(bool loading, const QString& name);
    void diagnosticsReported(const rasterlens::Diagnostics& diagnostics);
    void recentFilesChanged();
    void opened(const QString& name);

private:
    /// What the background thread brings back.
    struct Opened {
        std::shared_ptr<const Scene> scene;
        std::shared_ptr<const Scene> original; ///< before the session moved vertices
        std::optional<Settings> settings;      ///< of a session
        Diagnostics diagnostics;
    };

    /// One step of undo.
    struct State {
        std::shared_ptr<const Scene> scene;
        Settings settings;
    };

    [[nodiscard]] static Opened load(const QString& name);
    void finishOpening(const QString& name, quint64 serial, const Opened& opened);
    void rememberRecent(const QString& path);
    void startOpening(const QString& name, std::function<Opened()> load);
    void rememberStep(Edit edit);
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
    bool m_loading = false;
    quint64 m_openSerial = 0;
    LatestTask m_loader; ///< last: its thread uses the members above
};

} // namespace rasterlens
