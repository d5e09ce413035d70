#pragma once
#include <QStringList>

class QWidget;

namespace rasterlens
{

class Document;

/// Asks whether a file may name others outside its folder, and reads those if the user agrees.
///
/// in  the file, and those that it names
void askAboutOutside(QWidget& window, Document& document, const QString& file, const QStringList& refused);

} // namespace rasterlens
