#pragma once
#include "core/base/diagnostics.h"

#include <QFrame>
#include <QTimer>

class QLabel;
class QToolButton;

namespace rasterlens
{

enum class MessageKind { Info, Warning, Error };

/// A line above the canvas that tells what happened and never asks for attention by blocking.
class MessageBar : public QFrame
{
    Q_OBJECT

public:
    explicit MessageBar(QWidget* parent = nullptr);

    void show(MessageKind kind, const QString& text);
    /// In the language in use, also in the one that it is changed to.
    void show(const Diagnostics& diagnostics);
    [[nodiscard]] QString text() const;
    [[nodiscard]] MessageKind kind() const { return m_kind; }
    void setClosable(bool closable);

protected:
    void changeEvent(QEvent* event) override;

private:
    void applyColors();

    MessageKind m_kind = MessageKind::Info;
    Diagnostics m_diagnostics; ///< those that are shown
    QLabel* m_sign = nullptr;
    QLabel* m_text = nullptr;
    QToolButton* m_close = nullptr;
    QTimer m_farewell; ///< good news leaves by itself
};

} // namespace rasterlens
