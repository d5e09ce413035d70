#pragma once
#include <QString>

class QWidget;

namespace rasterlens
{

class Document;

/// Offers to look for the model of a session that is at none of its places: a question that blocks nothing but the
/// window it stands on, then a file dialog, then the session is opened with the chosen model.
void offerToLocateModel(QWidget& window, Document& document, const QString& session);

} // namespace rasterlens
