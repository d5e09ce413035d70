#include "ui/window/outside_question.h"

#include "core/io/path_bytes.h"
#include "ui/document/consents.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

#include <utility>

namespace rasterlens
{
namespace
{

constexpr int kShown = 6; ///< names of files; of more only the number is told

QString listed(const QStringList& files)
{
    QStringList lines;
    for (const QString& file : files.mid(0, kShown))
        lines << readablePath(QDir::cleanPath(file));
    if (files.size() > kShown)
        lines << QCoreApplication::translate("OutsideQuestion", "and %1 more").arg(files.size() - kShown);
    return lines.join(QLatin1Char('\n'));
}

} // namespace

void askAboutOutside(QWidget& window, const QString& file, const QStringList& refused, std::function<void()> readAgain)
{
    const QString name = QFileInfo(readablePath(file)).fileName();
    auto* question = new QMessageBox(
        QMessageBox::Question, name,
        QCoreApplication::translate("OutsideQuestion", "\"%1\" names files outside its folder. Read them?").arg(name),
        QMessageBox::NoButton, &window);
    question->setAttribute(Qt::WA_DeleteOnClose);
    question->setObjectName(QStringLiteral("outsideQuestion"));
    question->setTextFormat(Qt::PlainText); // names of files may look like markup
    question->setInformativeText(listed(refused));
    QPushButton* yes =
        question->addButton(QCoreApplication::translate("OutsideQuestion", "&Read them"), QMessageBox::AcceptRole);
    QPushButton* no = question->addButton(QCoreApplication::translate("OutsideQuestion", "&Do not read them"),
                                          QMessageBox::RejectRole);
    question->setDefaultButton(no);
    question->setEscapeButton(no);
    QObject::connect(yes, &QPushButton::clicked, &window, [file, readAgain = std::move(readAgain)] {
        Consents::ofProgram().add(file);
        readAgain();
    });
    question->open();
}

} // namespace rasterlens
