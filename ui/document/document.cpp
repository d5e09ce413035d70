#include "ui/document/document.h"

#include "core/io/file_writer.h"
#include "core/io/session.h"
#include "core/scenes/load_scene.h"
#include "core/settings/mistakes.h"
#include "core/truth/mistake_proof.h"
#include "ui/document/consents.h"
#include "ui/document/rebase.h"

#include <QFileInfo>
#include <QSettings>

#include <algorithm>
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

std::shared_ptr<const Scene> emptyScene()
{
    auto scene = std::make_shared<Scene>();
    scene->materials.emplace_back();
    return scene;
}

} // namespace

Document::Document(QObject* parent)
    : QObject(parent), m_scene(emptyScene()), m_settings(m_scene->defaults), m_clean(m_settings), m_cleanScene(m_scene),
      m_original(m_scene),
      m_loader([this](const Opened& opened) { finishOpening(opened); }, [this](Lack lack) { failOpening(lack); })
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
    if (!continues)
        pushUndo(present(false));
    m_redo.clear();
}

void Document::pushUndo(State state)
{
    m_undo.push_back(std::move(state));
    if (m_undo.size() > kMaxUndoSteps)
        m_undo.erase(m_undo.begin());
}

/// The present state, as a step of undo.
Document::State Document::present(bool withWhole) const
{
    State state{m_scene, m_settings};
    if (withWhole)
        state.whole = Whole{m_original,
                            m_cleanScene,
                            m_clean,
                            m_inputs,
                            m_sessionPath,
                            m_recovered,
                            m_viewKeeper ? m_viewKeeper() : std::function<void()>()};
    return state;
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
    m_sessionPath.clear();
    install({scene, scene, settings, {}}, false);
}

void Document::install(const Opened& opened, bool recovered)
{
    m_scene = opened.scene;
    m_settings = opened.settings.value_or(opened.scene->defaults);
    m_clean = m_settings;
    m_cleanScene = m_scene;
    m_original = opened.original;
    m_inputs = opened.inputs;
    m_recovered = recovered;
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
    const State previous = m_undo.back();
    m_redo.push_back(present(previous.whole.has_value()));
    m_undo.pop_back();
    restore(previous);
}

void Document::redo()
{
    if (!canRedo())
        return;
    const State next = m_redo.back();
    m_undo.push_back(present(next.whole.has_value()));
    m_redo.pop_back();
    restore(next);
}

void Document::restore(const State& state)
{
    m_inGesture = false;
    if (!state.whole) {
        replace(state);
        return;
    }
    const Whole& whole = *state.whole;
    m_original = whole.original;
    m_cleanScene = whole.cleanScene;
    m_clean = whole.clean;
    m_inputs = whole.inputs;
    m_sessionPath = whole.sessionPath;
    m_recovered = whole.recovered;
    replace(state);
    Q_EMIT inputsChanged();
    if (whole.showView)
        whole.showView();
}

void Document::open(const QString& name)
{
    startOpening({name}, [name] { return load(name); });
}

void Document::openWith(const QString& name, std::function<void(Settings&)> change)
{
    startOpening({name}, [name, change = std::move(change)] {
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
    startOpening({QStringLiteral("builtin:") + QLatin1String(mistake->scene)}, [mistake] {
        MistakeDemo demo = mistakeDemo(*mistake);
        const auto scene = std::make_shared<const Scene>(std::move(demo.scene));
        return Opened{scene, scene, demo.mistaken, {}};
    });
}

void Document::openMoment(const Moment& moment, GivingUp former)
{
    Opening opening{moment.scene, Opening::Kind::Moment};
    opening.former = former;
    startOpening(std::move(opening), [moment] {
        OpenMomentLoad load = rasterlens::openMoment(moment);
        Opened opened;
        opened.diagnostics = std::move(load.diagnostics);
        if (load.moment) {
            opened.scene = opened.original = std::make_shared<const Scene>(std::move(load.moment->scene));
            opened.settings = load.moment->settings;
        }
        return opened;
    });
}

void Document::openRecovered(const QString& file, const QString& sessionPath)
{
    startOpening({file, Opening::Kind::Recovered, sessionPath}, [file] { return load(file); });
}

bool Document::isReloadable() const
{
    const QString& id = m_scene->id;
    return !id.isEmpty() && !isGenerated(id) && !id.startsWith(QLatin1Char(':'));
}

void Document::reload()
{
    if (isReloadable())
        beginLoading({m_scene->id, Opening::Kind::Reload}, [name = m_scene->id] { return load(name); });
}

void Document::startOpening(Opening opening, std::function<Opened()> load)
{
    if (!m_leaveGuard || !isDirty() || opening.former == GivingUp::Silent) {
        beginLoading(std::move(opening), std::move(load));
        return;
    }
    m_leaveGuard([this, opening = std::move(opening), load = std::move(load)](bool mayLeave) mutable {
        if (!mayLeave) {
            stay(opening);
            return;
        }
        opening.agreedScene = m_scene;
        opening.agreedSettings = m_settings;
        beginLoading(std::move(opening), std::move(load));
    });
}

/// What is open stays open.
void Document::stay(const Opening& opening)
{
    Q_EMIT loadingChanged(m_loading, opening.name);
    if (opening.kind == Opening::Kind::Moment)
        Q_EMIT momentRefused();
}

void Document::beginLoading(Opening opening, std::function<Opened()> load)
{
    m_loading = true;
    ++m_openSerial;
    m_opening = std::move(opening);
    // A recovered session was written by the program, far from its model.
    const bool isOwn = m_opening.kind == Opening::Kind::Recovered;
    const auto decided = Consents::ofProgram().decided(isOwn ? m_opening.name : QString());
    Q_EMIT loadingChanged(true, m_opening.name);
    m_loader.ask(
        [load = std::move(load), decided](const auto&) {
            const InputLog log;
            const Consent consent(decided);
            Opened opened = load();
            Consents::ofProgram().tell(consent.refused());
            if (opened.inputs.empty())
                opened.inputs = log.files();
            return opened;
        },
        LatestJob::Running::Interrupt);
}

void Document::openSessionWith(const QString& path, const QString& scene)
{
    Opening opening{path};
    if (path == m_opening.name) { // a recovered session stays one
        opening.kind = m_opening.kind;
        opening.sessionPath = m_opening.sessionPath;
    }
    startOpening(std::move(opening), [path, scene] { return load(path, scene); });
}

Document::Opened Document::load(const QString& name, const QString& sceneInstead)
{
    Opened opened;
    QString sceneName = name;
    SessionLoad session;
    if (isSession(name)) {
        session = loadSession(name, sceneInstead);
        opened.diagnostics = std::move(session.diagnostics);
        if (!session.session)
            return opened;
        sceneName = session.session->scene;
        opened.view = session.session->view;
        opened.isPartial = session.session->isPartial;
        opened.sceneIsMissing = !session.session->sceneFound;
    }
    LoadOptions options;
    if (session.session)
        options.size = settingsOf(*session.session, {}).settings.size;
    SceneLoad load = loadScene(sceneName, options);
    opened.diagnostics.insert(opened.diagnostics.end(), load.diagnostics.begin(), load.diagnostics.end());
    if (!load.scene)
        return opened;
    opened.original = opened.scene = std::make_shared<const Scene>(std::move(*load.scene));
    if (session.session) {
        const SettingsParse parse = settingsOf(*session.session, opened.original->defaults);
        for (const Reason& error : parse.errors)
            opened.diagnostics.push_back({Severity::Error, name, 0, error});
        if (!parse.errors.empty())
            opened.scene = nullptr;
        opened.settings = parse.settings;
    }
    if (opened.scene && session.session && !(session.session->vertices.empty() && session.session->colors.empty())) {
        auto edited = std::make_shared<Scene>(*opened.original);
        const Diagnostics errors = editVertices(*edited, *session.session, name);
        opened.diagnostics.insert(opened.diagnostics.end(), errors.begin(), errors.end());
        opened.scene = errors.empty() ? std::move(edited) : nullptr;
    }
    return opened;
}

void Document::finishOpening(const Opened& opened)
{
    const Opening opening = m_opening;
    m_loading = false;
    const bool isReload = opening.kind == Opening::Kind::Reload;
    const bool agreed = m_scene == opening.agreedScene && m_settings == opening.agreedSettings;
    const bool asks = !isReload && opening.former == GivingUp::Asks;
    if (opened.scene && asks && m_leaveGuard && isDirty() && !agreed) {
        // The user changed something while the file was being read.
        m_leaveGuard([this, opening, opened, serial = m_openSerial](bool mayLeave) {
            if (mayLeave && serial == m_openSerial)
                take(opening, opened);
            else
                stay(opening);
        });
        return;
    }
    take(opening, opened);
}

void Document::take(const Opening& opening, const Opened& opened)
{
    const bool isReload = opening.kind == Opening::Kind::Reload;
    const bool isMoment = opening.kind == Opening::Kind::Moment;
    if (opened.scene && isReload) {
        takeReloaded(opening.name, opened);
    } else if (opened.scene && isMoment) {
        takeMoment(opened);
    } else if (opened.scene) {
        const bool recovered = opening.kind == Opening::Kind::Recovered;
        const bool isWhole = isSession(opening.name) && !opened.isPartial;
        m_sessionPath = recovered ? opening.sessionPath : isWhole ? opening.name : QString();
        install(opened, recovered);
        if (recovered) // the file that an earlier run left behind goes away; the session that it belongs to stays
            std::erase_if(m_inputs, [&](const InputFile& input) { return input.path == opening.name; });
        if (recovered && !m_sessionPath.isEmpty())
            noteInputs({{m_sessionPath, stampOf(m_sessionPath)}});
        if (!recovered && !isGenerated(opening.name))
            rememberRecent(opening.name);
    } else if (isReload) {
        noteInputs(opened.inputs);
    }
    if (opened.scene || isReload)
        Q_EMIT inputsChanged();
    Q_EMIT loadingChanged(false, opening.name);
    if (const Diagnostics remarks = withoutNotes(opened.diagnostics); !remarks.empty())
        Q_EMIT diagnosticsReported(remarks);
    if (opened.sceneIsMissing)
        Q_EMIT sceneMissing(opening.name);
    if (isMoment && opened.scene)
        Q_EMIT momentOpened();
    else if (isMoment)
        Q_EMIT momentRefused();
    else if (opened.scene)
        Q_EMIT this->opened(opening.name);
    if (opened.scene && !opened.view.isEmpty() && !isReload)
        Q_EMIT viewOpened(opened.view, opening.name);
}

void Document::takeMoment(const Opened& opened)
{
    if (m_scene->mesh.faceCount() > 0 || !m_scene->id.isEmpty()) // before a first scene there is nothing to go back to
        pushUndo(present(true));
    m_redo.clear();
    m_inGesture = false;
    m_original = m_cleanScene = opened.original;
    m_clean = *opened.settings;
    m_inputs = opened.inputs;
    m_sessionPath.clear();
    m_recovered = false;
    replace({opened.scene, *opened.settings});
}

void Document::takeReloaded(const QString& name, const Opened& opened)
{
    const auto formerCount = m_original->mesh.vertices.size();
    // Steps from and to other scenes go: they were about files that may have changed as well.
    for (auto* steps : {&m_undo, &m_redo}) {
        const auto whole =
            std::find_if(steps->rbegin(), steps->rend(), [](const State& step) { return step.whole.has_value(); });
        steps->erase(steps->begin(), whole.base());
    }
    Rebase rebase(m_original, opened.scene);
    for (auto* steps : {&m_undo, &m_redo})
        for (State& step : *steps)
            step = {rebase.scene(step.scene), rebase.settings(step.settings)};
    m_cleanScene = rebase.scene(m_cleanScene);
    m_clean = rebase.settings(m_clean);
    m_original = opened.scene;
    m_inGesture = false;
    noteInputs(opened.inputs);
    replace({rebase.scene(m_scene), rebase.settings(m_settings)});
    if (rebase.movesLost())
        Q_EMIT diagnosticsReported(
            {{Severity::Warning, name, 0,
              Reason(QT_TRANSLATE_NOOP("Diagnostic", "the file now has %1 vertices instead of %2: moved vertices are "
                                                     "back where the file has them"),
                     {opened.scene->mesh.vertices.size(), formerCount})}});
}

/// Files read again get their new stamp; new ones join the list.
void Document::noteInputs(const std::vector<InputFile>& inputs)
{
    for (const InputFile& input : inputs) {
        const auto known = std::ranges::find(m_inputs, input.path, &InputFile::path);
        if (known == m_inputs.end())
            m_inputs.push_back(input);
        else
            known->stamp = input.stamp;
    }
}

bool Document::isDirty() const { return m_recovered || !(m_settings == m_clean) || m_scene != m_cleanScene; }

Session Document::session() const
{
    return {m_scene->id, toJson(m_settings), movedVertices(m_original->mesh, m_scene->mesh),
            recoloredVertices(m_original->mesh, m_scene->mesh), m_viewReader ? m_viewReader() : QJsonObject()};
}

void Document::failOpening(Lack lack)
{
    m_loading = false;
    stay(m_opening);
    const char* why =
        lack == Lack::Memory
            ? QT_TRANSLATE_NOOP("Diagnostic", "there is not enough memory to open it")
            : QT_TRANSLATE_NOOP("Diagnostic", "it was not opened: the system does not start so many threads");
    Q_EMIT diagnosticsReported({{Severity::Error, m_opening.name, 0, why}});
}

QStringList Document::inputFiles() const
{
    QStringList files{m_scene->id, m_sessionPath};
    for (const InputFile& input : m_inputs)
        files << input.path;
    files.removeAll(QString());
    return files;
}

bool Document::saveSession(const QString& path)
{
    if (const auto why = whyNotOver(path, {m_scene->id})) {
        Q_EMIT diagnosticsReported({{Severity::Error, path, 0, *why}});
        return false;
    }
    if (const auto error = rasterlens::saveSession(session(), path)) {
        Q_EMIT diagnosticsReported({{Severity::Error, path, 0, *error}});
        return false;
    }
    Consents::ofProgram().add(path); // the model that it names is open
    m_sessionPath = path;
    m_clean = m_settings;
    m_cleanScene = m_scene;
    m_recovered = false;
    const QString absolute = QFileInfo(path).absoluteFilePath();
    noteInputs({{absolute, stampOf(absolute)}});
    Q_EMIT inputsChanged();
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
