#include "ui/window/locate_model.h"

#include "ui/document/document.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

namespace rasterlens
{
namespace
{

void locate(QWidget& window, Document& document, const QString& session)
{
    auto* dialog = new QFileDialog(
        &window,
        QCoreApplication::translate("LocateModel", "Locate the model of %1").arg(QFileInfo(session).fileName()),
        QFileInfo(session).absolutePath());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setObjectName(QStringLiteral("locateDialog"));
    dialog->setFileMode(QFileDialog::ExistingFile);
    dialog->setNameFilter(QCoreApplication::translate("LocateModel", "Scenes and cases (*.obj *.case)"));
    QObject::connect(dialog, &QFileDialog::fileSelected, &document,
                     [&document, session](const QString& model) { document.openSessionWith(session, model); });
    dialog->open();
}

} // namespace

void offerToLocateModel(QWidget& window, Document& document, const QString& session)
{
    auto* question =
        new QMessageBox(QMessageBox::Question, QFileInfo(session).fileName(),
                        QCoreApplication::translate("LocateModel", "The model of this session is not where it was."),
                        QMessageBox::Close, &window);
    question->setAttribute(Qt::WA_DeleteOnClose);
    question->setObjectName(QStringLiteral("locateQuestion"));
    QPushButton* yes =
        question->addButton(QCoreApplication::translate("LocateModel", "Locate\u2026"), QMessageBox::AcceptRole);
    question->setDefaultButton(yes);
    QObject::connect(yes, &QPushButton::clicked, &document,
                     [&window, &document, session] { locate(window, document, session); });
    question->open();
}

} // namespace rasterlens
