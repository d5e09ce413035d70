#include "ui/window/page_export.h"

#include "ui/base/image_export.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileDialog>
#include <QProcess>
#include <QTemporaryDir>

#include <memory>
#include <utility>

namespace rasterlens
{
namespace
{

QString words(const char* text) { return QCoreApplication::translate("PageExport", text); }

} // namespace

void writePage(QWidget& window, const PageSubject& subject, const QString& program, const QString& path,
               const PageDone& done)
{
    const auto folder = std::make_shared<QTemporaryDir>(); // until the program has ended
    const QString file = folder->filePath(QStringLiteral("page.json"));
    if (const auto why = saveSession(subject.session, file)) {
        done(path, textOf(*why, [](const char* text) { return QCoreApplication::translate("Diagnostic", text); }));
        return;
    }
    auto* process = new QProcess(&window);
    QObject::connect(process, &QProcess::errorOccurred, &window, [process, path, done](QProcess::ProcessError error) {
        if (error != QProcess::FailedToStart)
            return;
        done(path, process->program() + QStringLiteral(": ") + process->errorString());
        process->deleteLater();
    });
    QObject::connect(process, &QProcess::finished, &window, [process, folder, path, done](int exitCode) {
        const QString said = QString::fromUtf8(process->readAllStandardError()).trimmed();
        done(path, exitCode == 0 ? QString() : said);
        process->deleteLater();
    });
    QStringList arguments{QStringLiteral("page"), file, QStringLiteral("-o"), path};
    if (!subject.lesson.isEmpty())
        arguments << QStringLiteral("--lesson") << subject.lesson;
    process->start(program, arguments);
}

void choosePage(QWidget& window, const PageSubject& subject, const PageDone& done)
{
    QFileDialog* dialog = newExportDialog(&window, words(QT_TRANSLATE_NOOP("PageExport", "Export page")),
                                          QStringLiteral("page.html"), {QStringLiteral("html")});
    QObject::connect(dialog, &QFileDialog::fileSelected, &window, [=, &window](const QString& path) {
        const QDir folder(QCoreApplication::applicationDirPath());
        writePage(window, subject, folder.filePath(QStringLiteral("rasterlens-cli")), path, done);
    });
    dialog->open();
}

} // namespace rasterlens
