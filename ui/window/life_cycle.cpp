#include "ui/window/life_cycle.h"

#include "core/io/session.h"
#include "ui/base/language.h"
#include "ui/base/message_bar.h"
#include "ui/document/consents.h"
#include "ui/document/document.h"
#include "ui/document/file_watch.h"
#include "ui/document/recovery.h"
#include "ui/pipeline/scene_words.h"
#include "ui/steps/step_mode.h"
#include "ui/steps/step_session.h"
#include "ui/window/outside_question.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <QStandardPaths>
#include <QWidget>

#include <utility>

namespace rasterlens
{
namespace
{

QStringList namesOf(const QStringList& paths)
{
    QStringList names;
    for (const QString& path : paths)
        names << QFileInfo(path).fileName();
    return names;
}

/// The session's name, or else that of its scene.
QString nameOf(const QString& sessionPath, const QString& sceneId)
{
    if (!sessionPath.isEmpty())
        return QFileInfo(sessionPath).fileName();
    Scene scene;
    scene.id = sceneId;
    return sceneTitle(scene);
}

} // namespace

LifeCycle::LifeCycle(Document& document, StepMode& steps, Bars bars, QWidget& window)
    : QObject(&window), m_document(document), m_steps(steps), m_bars(bars), m_window(window)
{
    connect(&m_document, &Document::loadingChanged, this, [this](bool loading) {
        if (loading)
            m_step.reset();
    });
    // The record was of the former scene; that of the new one is to open where this one stood.
    connect(&m_document, &Document::opened, this, [this] {
        if (m_step && m_steps.session().isOpen())
            m_steps.showStep(QString::number(*m_step));
        m_step.reset();
    });
}

LifeCycle::~LifeCycle() { m_document.setLeaveGuard({}); }

void LifeCycle::start()
{
    m_document.setLeaveGuard([this](auto answer) { ask(std::move(answer)); });
    m_recovery = std::make_unique<Recovery>(m_document);
    connect(m_recovery.get(), &Recovery::failed, this, [this](const QString& why) {
        Q_EMIT warned(tr("Unsaved changes cannot be kept in case the program ends unexpectedly: %1").arg(why));
    });
    connect(m_bars.recovery, &MessageBar::dismissed, this, [this] { m_recovery->postponeFound(); });
    connect(&m_document, &Document::opened, this, &LifeCycle::finishRestoring);
    m_watch = std::make_unique<FileWatch>();
    connect(m_watch.get(), &FileWatch::differs, this, &LifeCycle::offerReload);
    connect(&m_document, &Document::inputsChanged, this, [this] { m_watch->watch(m_document.inputs()); });
    connect(&m_document, &Document::settingsChanged, this, [this] { m_ending = false; });
    connect(&Consents::ofProgram(), &Consents::refused, this, [this](const QString& file, const QStringList& paths) {
        askAboutOutside(m_window, file, paths, [this, file] {
            if (file == m_document.scene()->id)
                m_document.reload();
            else
                Q_EMIT agreedTo(file);
        });
    });
    offerFound();
}

bool LifeCycle::mayClose()
{
    if (!m_recovery || m_ending)
        return true;
    if (m_leaving || !m_document.isDirty()) {
        m_recovery->giveUp();
        return true;
    }
    ask([this](bool mayLeave) {
        m_leaving = mayLeave;
        if (mayLeave)
            m_window.close();
        m_leaving = false;
    });
    return false;
}

void LifeCycle::keepForNextStart()
{
    if (!m_recovery)
        return;
    m_recovery->keep();
    m_ending = true;
}

void LifeCycle::ask(std::function<void(bool mayLeave)> answer)
{
    if (m_question) { // one question at a time
        m_question->raise();
        answer(false);
        return;
    }
    const QString name = nameOf(m_document.sessionPath(), m_document.scene()->id);
    m_question =
        new QMessageBox(QMessageBox::Warning, QStringLiteral("RasterLens"), tr("Save the changes to \"%1\"?").arg(name),
                        QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, &m_window);
    m_question->setObjectName(QStringLiteral("leaveQuestion"));
    m_question->setAttribute(Qt::WA_DeleteOnClose);
    m_question->setInformativeText(tr("Otherwise settings, camera and moved vertices are lost."));
    m_question->button(QMessageBox::Save)->setText(tr("&Save"));
    m_question->button(QMessageBox::Discard)->setText(tr("&Discard"));
    m_question->button(QMessageBox::Cancel)->setText(tr("Cancel"));
    m_question->setDefaultButton(QMessageBox::Save);
    connect(m_question, &QMessageBox::finished, this, [this, answer = std::move(answer)](int result) {
        m_question->setObjectName({}); // gone for all who look for it
        m_question = nullptr;
        if (result == QMessageBox::Save)
            save(answer);
        else
            answer(result == QMessageBox::Discard);
    });
    m_question->open();
}

void LifeCycle::save(std::function<void(bool saved)> done)
{
    if (m_document.sessionPath().isEmpty()) {
        saveAs(std::move(done));
        return;
    }
    const bool saved = saveTo(m_document.sessionPath());
    if (done)
        done(saved);
}

void LifeCycle::saveAs(std::function<void(bool saved)> done)
{
    auto* dialog = new QFileDialog(&m_window, tr("Save session"));
    dialog->setObjectName(QStringLiteral("saveSession"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("json"));
    dialog->setNameFilter(tr("Sessions (*.json)"));
    const QFileInfo proposed(m_document.sessionPath().isEmpty() ? proposedPath() : m_document.sessionPath());
    dialog->setDirectory(proposed.absolutePath());
    dialog->selectFile(proposed.fileName());
    connect(dialog, &QFileDialog::finished, this, [this, dialog, done = std::move(done)](int result) {
        const bool saved = result == QDialog::Accepted && saveTo(dialog->selectedFiles().value(0));
        if (done)
            done(saved);
    });
    dialog->open();
}

bool LifeCycle::saveTo(const QString& path)
{
    const bool saved = m_document.saveSession(path);
    if (saved)
        Q_EMIT this->saved(path);
    return saved;
}

QString LifeCycle::proposedPath() const
{
    const QString& id = m_document.scene()->id;
    const bool hasFolder = m_document.isReloadable();
    const QDir folder = hasFolder ? QFileInfo(id).absoluteDir()
                                  : QDir(QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation));
    QString base = hasFolder ? QFileInfo(id).completeBaseName() : id.section(QLatin1Char(':'), -1);
    base = QFileInfo(base).completeBaseName(); // resources are paths, too
    if (base.isEmpty())
        base = QStringLiteral("session");
    // Desktops know sessions by this end of their names.
    QString path = folder.filePath(base + QStringLiteral(".rasterlens.json"));
    for (int i = 2; QFileInfo::exists(path); ++i)
        path = folder.filePath(QStringLiteral("%1-%2.rasterlens.json").arg(base).arg(i));
    return path;
}

void LifeCycle::offerFound()
{
    const auto found = m_recovery->found();
    if (!found) {
        m_bars.recovery->hide();
        return;
    }
    const Consent consent(Outside::Allow); // the program has written it, far from its model
    const SessionLoad left = loadSession(found->file);
    const QString name = nameOf(found->sessionPath, left.session ? left.session->scene : QString());
    const QString when = QLocale().toString(found->keptAt, QLocale::ShortFormat);
    m_bars.recovery->offer(
        tr("The program ended before changes to \"%1\" were saved (%2).").arg(name, when),
        {{"restore", tr("Restore"), [this] { restoreFound(); }}, {"discardFound", tr("Discard"), [this] {
                                                                      m_recovery->dropFound();
                                                                      offerFound();
                                                                  }}});
}

void LifeCycle::restoreFound()
{
    const auto found = m_recovery->found();
    if (!found)
        return;
    m_restoring = found->file;
    m_document.openRecovered(found->file, found->sessionPath);
}

/// What was left may go as soon as this run has written the same.
void LifeCycle::finishRestoring(const QString& name)
{
    if (m_restoring.isEmpty() || name != m_restoring)
        return;
    m_restoring.clear();
    const auto found = m_recovery->found();
    const bool isStillThere = found && found->file == name;
    if (isStillThere && m_recovery->keep())
        m_recovery->dropFound();
    else if (isStillThere)
        m_recovery->postponeFound();
    offerFound();
}

void LifeCycle::offerReload()
{
    const QStringList changed = namesOf(m_watch->changed());
    const QStringList missing = namesOf(m_watch->missing());
    if (!changed.isEmpty())
        m_bars.files->offer(tr("Changed on the disk: %1").arg(listed(changed)),
                            {{"reload", tr("Reload (F5)"), [this] { reload(); }}});
    else if (!missing.isEmpty())
        m_bars.files->offer(tr("No longer on the disk: %1. The scene stays as it was read.").arg(listed(missing)), {});
    else
        m_bars.files->hide();
}

void LifeCycle::reload()
{
    const QString session =
        m_document.sessionPath().isEmpty() ? QString() : QFileInfo(m_document.sessionPath()).absoluteFilePath();
    if (m_watch && m_watch->changed().contains(session)) {
        m_document.open(session); // asks if there are changes
        return;
    }
    m_document.reload();
    if (m_steps.session().isOpen())
        m_step = m_steps.session().position();
}

void LifeCycle::retranslate()
{
    if (!m_recovery)
        return;
    if (!m_bars.recovery->isHidden())
        offerFound();
    if (!m_bars.files->isHidden())
        offerReload();
}

} // namespace rasterlens
