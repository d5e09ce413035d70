#include "ui/document/document.h"

#include "core/io/session.h"
#include "core/settings/mistakes.h"

#include <QFileInfo>
#include <QSettings>

#include <utility>

namespace rasterlens
{
namespace
{

constexpr std::size_t kMaxUndoSteps = 500;
constexpr int kMaxRecentFiles = 10;
constexpr auto kRecentKey = "recentFiles";

bool isGenerated(const QString& name)
{
    return name.startsWith(QLatin1String("builtin:")) || name.startsWith(QLatin1String("stress:"));
}

bool isSession(const QString& name)
{
    return !isGenerated(name) && name.endsWith(QLatin1String(".json"), Qt::CaseInsensitive);
}

std::shared_ptr<const Scene> emptyScene()
{
    auto scene = std::make_shared<Scene>();
    scene->materials.emplace_back();
    return scene;
}

} // namespace

Document::Document(QObject* parent)
    : QObject(parent), m_scene(emptyScene()), m_settings(m_scene->defaults), m_clean(m_settings), m_cleanScene(m_scene),
      m_original(m_scene)
{
}

Document::~Document() = default;

void Document::setSettings(const Settings& settings, Edit edit)
{
    if (settings == m_settings)
        return;
    rememberStep(edit);
    replace({m_scene, settings});
}

void Document::editScene(std::shared_ptr<const Scene> scene, Edit edit)
{
    rememberStep(edit);
    replace({std::move(scene), m_settings});
}

void Document::rememberStep(Edit edit)
{
    const bool continues = edit == Edit::Camera && m_inGesture;
    m_inGesture = edit == Edit::Camera;
    if (!continues) {
        m_undo.push_back({m_scene, m_settings});
        if (m_undo.size() > kMaxUndoSteps)
            m_undo.erase(m_undo.begin());
    }
    m_redo.clear();
}

void Document::replace(const State& state)
{
    m_settings = state.settings;
    if (state.scene != m_scene) {
        m_scene = state.scene;
        Q_EMIT sceneChanged();
    }
    Q_EMIT settingsChanged();
}

void Document::setScene(std::shared_ptr<const Scene> scene)
{
    const Settings defaults = scene->defaults;
    setScene(std::move(scene), defaults);
}

void Document::setScene(std::shared_ptr<const Scene> scene, const Settings& settings)
{
    m_scene = std::move(scene);
    m_settings = settings;
    m_clean = settings;
    m_cleanScene = m_scene;
    m_original = m_scene;
    m_undo.clear();
    m_redo.clear();
    m_inGesture = false;
    Q_EMIT sceneChanged();
    Q_EMIT settingsChanged();
}

void Document::undo()
{
    if (!canUndo())
        return;
    m_inGesture = false;
    m_redo.push_back({m_scene, m_settings});
    const State previous = m_undo.back();
    m_undo.pop_back();
    replace(previous);
}

void Document::redo()
{
    if (!canRedo())
        return;
    m_inGesture = false;
    m_undo.push_back({m_scene, m_settings});
    const State next = m_redo.back();
    m_redo.pop_back();
    replace(next);
}

void Document::open(const QString& name)
{
    startOpening(name, [name] { return load(name); });
}

void Document::openWith(const QString& name, std::function<void(Settings&)> change)
{
    startOpening(name, [name, change = std::move(change)] {
        Opened opened = load(name);
        if (opened.scene) {
            Settings settings = opened.settings.value_or(opened.scene->defaults);
            change(settings);
            opened.settings = settings;
        }
        return opened;
    });
}

void Document::openMistake(const QString& id)
{
    const Mistake* mistake = findMistake(id);
    if (mistake == nullptr)
        return;
    startOpening(QStringLiteral("builtin:") + QLatin1String(mistake->scene), [mistake] {
        MistakeDemo demo = mistakeDemo(*mistake);
        const auto scene = std::make_shared<const Scene>(std::move(demo.scene));
        return Opened{scene, scene, demo.mistaken, {}};
    });
}

void Document::startOpening(const QString& name, std::function<Opened()> load)
{
    const quint64 serial = ++m_openSerial;
    m_loading = true;
    Q_EMIT loadingChanged(true, name);
    m_loader.post(
        [this, name, serial, load = std::move(load)](std::stop_token) {
            QMetaObject::invokeMethod(
                this, [this, name, serial, opened = load()] { finishOpening(name, serial, opened); },
                Qt::QueuedConnection);
        },
        LatestTask::Running::Interrupt);
}

Document::Opened Document::load(const QString& name)
{
    Opened opened;
    QString sceneName = name;
    SessionLoad session;
    if (isSession(name)) {
        session = loadSession(name);
        opened.diagnostics = std::move(session.diagnostics);
        if (!session.session)
            return opened;
        sceneName = session.session->scene;
    }
    LoadOptions options;
    if (session.session)
        options.size = settingsOf(*session.session, {}).size;
    SceneLoad load = loadScene(sceneName, options);
    opened.diagnostics.insert(opened.diagnostics.end(), load.diagnostics.begin(), load.diagnostics.end());
    if (!load.scene)
        return opened;
    opened.original = opened.scene = std::make_shared<const Scene>(std::move(*load.scene));
    if (session.session)
        opened.settings = settingsOf(*session.session, opened.original->defaults);
    if (session.session && !session.session->vertices.empty()) {
        auto edited = std::make_shared<Scene>(*opened.original);
        const Diagnostics errors = moveVertices(*edited, *session.session, name);
        opened.diagnostics.insert(opened.diagnostics.end(), errors.begin(), errors.end());
        opened.scene = errors.empty() ? std::move(edited) : nullptr;
    }
    return opened;
}

void Document::finishOpening(const QString& name, quint64 serial, const Opened& opened)
{
    if (serial != m_openSerial)
        return;
    m_loading = false;
    if (opened.scene) {
        m_sessionPath = isSession(name) ? name : QString();
        setScene(opened.scene, opened.settings.value_or(opened.scene->defaults));
        m_original = opened.original;
        if (!isGenerated(name))
            rememberRecent(name);
    }
    Q_EMIT loadingChanged(false, name);
    if (!opened.diagnostics.empty())
        Q_EMIT diagnosticsReported(opened.diagnostics);
    if (opened.scene)
        Q_EMIT this->opened(name);
}

bool Document::saveSession(const QString& path)
{
    const Session session{m_scene->id, toJson(m_settings), movedVertices(m_original->mesh, m_scene->mesh)};
    if (const auto error = rasterlens::saveSession(session, path)) {
        Q_EMIT diagnosticsReported({{Severity::Error, path, 0, *error}});
        return false;
    }
    m_sessionPath = path;
    m_clean = m_settings;
    m_cleanScene = m_scene;
    rememberRecent(path);
    Q_EMIT settingsChanged();
    return true;
}

QStringList Document::recentFiles() const { return QSettings().value(kRecentKey).toStringList(); }

void Document::clearRecentFiles()
{
    QSettings().remove(kRecentKey);
    Q_EMIT recentFilesChanged();
}

void Document::rememberRecent(const QString& path)
{
    QStringList files = recentFiles();
    const QString absolute = QFileInfo(path).absoluteFilePath();
    files.removeAll(absolute);
    files.prepend(absolute);
    if (files.size() > kMaxRecentFiles)
        files.resize(kMaxRecentFiles);
    QSettings().setValue(kRecentKey, files);
    Q_EMIT recentFilesChanged();
}

} // namespace rasterlens
