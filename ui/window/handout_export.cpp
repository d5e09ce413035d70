#include "ui/window/handout_export.h"

#include "core/lessons/lesson.h"
#include "ui/base/image_export.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileDialog>
#include <QInputDialog>
#include <QProcess>

#include <utility>

namespace rasterlens
{
namespace
{

using Done = std::function<void(const QString& path, const QString& error)>;

QString words(const char* text) { return QCoreApplication::translate("HandoutExport", text); }

/// Runs the program of the command line, which lies beside this one.
void writeHandout(QWidget& window, const QString& lesson, const QString& path, LanguageKind language, Done done)
{
    auto* process = new QProcess(&window);
    const QString program = QDir(QCoreApplication::applicationDirPath()).filePath(QStringLiteral("rasterlens-cli"));
    QObject::connect(process, &QProcess::errorOccurred, &window, [process, path, done](QProcess::ProcessError error) {
        if (error != QProcess::FailedToStart)
            return;
        done(path, process->program() + QStringLiteral(": ") + process->errorString());
        process->deleteLater();
    });
    QObject::connect(process, &QProcess::finished, &window, [process, path, done](int exitCode) {
        const QString said = QString::fromUtf8(process->readAllStandardError()).trimmed();
        done(path, exitCode == 0 ? QString() : said);
        process->deleteLater();
    });
    process->start(program, {QStringLiteral("lesson"), QStringLiteral("handout"), lesson, QStringLiteral("-o"), path,
                             QStringLiteral("--language"),
                             language == LanguageKind::Chinese ? QStringLiteral("zh") : QStringLiteral("en")});
}

} // namespace

void chooseHandout(QWidget& window, LanguageKind language, Done done)
{
    const QStringList ids = lessonIds();
    QStringList titles;
    for (const QString& id : ids) {
        const LessonLoad load = loadLesson(id);
        titles << (!load.lesson                        ? id
                   : language == LanguageKind::Chinese ? load.lesson->title.zh
                                                       : load.lesson->title.en);
    }
    auto* question = new QInputDialog(&window);
    question->setAttribute(Qt::WA_DeleteOnClose);
    question->setWindowTitle(words(QT_TRANSLATE_NOOP("HandoutExport", "Handout of a lesson")));
    question->setLabelText(words(QT_TRANSLATE_NOOP("HandoutExport", "Lesson:")));
    question->setComboBoxItems(titles);
    QObject::connect(question, &QInputDialog::textValueSelected, &window, [=, &window](const QString& title) {
        const QString id = ids.value(titles.indexOf(title));
        QFileDialog* dialog =
            newExportDialog(&window, words(QT_TRANSLATE_NOOP("HandoutExport", "Handout of a lesson")),
                            id + QStringLiteral(".pdf"), {QStringLiteral("pdf"), QStringLiteral("md")});
        QObject::connect(dialog, &QFileDialog::fileSelected, &window,
                         [=, &window](const QString& path) { writeHandout(window, id, path, language, done); });
        dialog->open();
    });
    question->open();
}

} // namespace rasterlens
