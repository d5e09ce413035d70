#include "ui/base/typed_field.h"

#include "ui/base/style_sheet.h"

#include <QEvent>
#include <QFocusEvent>
#include <QKeyEvent>
#include <QLineEdit>
#include <QVariant>

#include <utility>

namespace rasterlens
{

void markRefused(QWidget& field, bool refused) { setStyleProperty(field, "refused", refused); }

TypedField::TypedField(QLineEdit* edit, Reader reader, QWidget* frame)
    : QObject(edit), m_edit(edit), m_frame(frame ? frame : edit), m_reader(std::move(reader))
{
    m_edit->installEventFilter(this);
    if (m_frame != m_edit)
        m_frame->installEventFilter(this);
    connect(edit, &QLineEdit::textEdited, this, &TypedField::judge);
}

void TypedField::setValue(const QString& text)
{
    const bool isNew = std::exchange(m_value, text) != text;
    if (m_touched && !isNew)
        return;
    m_touched = false;
    m_edit->setText(text);
    setRefused(std::nullopt);
}

void TypedField::judge()
{
    m_touched = true;
    if (m_refused)
        setRefused(m_reader(m_edit->text(), Attempt::Look));
}

void TypedField::take()
{
    const auto why = m_reader(m_edit->text(), Attempt::Take);
    setRefused(why);
    if (why)
        return;
    m_touched = false;
    m_edit->setText(m_value);
}

void TypedField::abandon()
{
    m_touched = false;
    m_edit->setText(m_value);
    setRefused(std::nullopt);
    m_frame->clearFocus();
    Q_EMIT left();
}

void TypedField::setRefused(const std::optional<QString>& why)
{
    const bool was = std::exchange(m_refused, why.has_value());
    markRefused(*m_frame, m_refused);
    if (why)
        Q_EMIT refused(*why);
    else if (was)
        Q_EMIT mended();
}

bool TypedField::eventFilter(QObject* watched, QEvent* event)
{
    switch (event->type()) {
    case QEvent::ShortcutOverride:
        if (static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
            event->accept();
            return true;
        }
        break;
    case QEvent::KeyPress:
        switch (static_cast<QKeyEvent*>(event)->key()) {
        case Qt::Key_Escape: abandon(); return true;
        case Qt::Key_Return:
        case Qt::Key_Enter:
            take();
            if (!m_refused) {
                m_frame->clearFocus();
                Q_EMIT left();
            }
            return true;
        default: break;
        }
        break;
    case QEvent::FocusOut:
        // Another widget was chosen: the text counts. A menu or another program only borrows the keys.
        if (const auto reason = static_cast<QFocusEvent*>(event)->reason();
            m_touched && !m_refused && reason != Qt::PopupFocusReason && reason != Qt::ActiveWindowFocusReason)
            take();
        break;
    default: break;
    }
    return QObject::eventFilter(watched, event);
}

} // namespace rasterlens
