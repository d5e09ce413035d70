#pragma once
#include "core/io/session.h"

#include <functional>

class QWidget;

namespace rasterlens
{

/// Called with the file and, where it could not be written, why.
using PageDone = std::function<void(const QString& path, const QString& error)>;

/// What the page shows: the scene with its present settings, vertices, step and pixel, and a lesson.
struct PageSubject {
    Session session;
    QString lesson; ///< its file; empty: none
};

/// Asks for a file and writes the page into it.
void choosePage(QWidget& window, const PageSubject& subject, const PageDone& done);

/// Has the program of the command line write the page.
///
/// in  `program`: rasterlens-cli
void writePage(QWidget& window, const PageSubject& subject, const QString& program, const QString& path,
               const PageDone& done);

} // namespace rasterlens
