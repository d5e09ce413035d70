#pragma once
#include <QStringList>

#include <functional>

class QWidget;

namespace rasterlens
{

/// Asks whether a file may name others outside its folder.
///
/// in  the file, those that it names, and what reads it again once the user has agreed
void askAboutOutside(QWidget& window, const QString& file, const QStringList& refused, std::function<void()> readAgain);

} // namespace rasterlens
