#pragma once
#include "ui/base/language.h"

#include <functional>

class QWidget;

namespace rasterlens
{

/// Asks for a lesson and a file, and has the command line write the lesson's handout in the language in use: PDF, or
/// Markdown with the figures beside it.
///
/// in  `done`: called with the file and, where it could not be written, why
void chooseHandout(QWidget& window, LanguageKind language,
                   std::function<void(const QString& path, const QString& error)> done);

} // namespace rasterlens
