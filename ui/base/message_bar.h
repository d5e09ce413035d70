#pragma once
#include "core/base/diagnostics.h"

#include <QFrame>
#include <QTimer>

#include <functional>
#include <vector>

class QHBoxLayout;
class QLabel;
class QToolButton;

namespace rasterlens
{

enum class MessageKind { Info, Warning, Error };

/// A line over the canvas that tells what happened and never asks for attention by blocking.
class MessageBar : public QFrame
{
    Q_OBJECT

public:
    /// A button that stands behind the text.
    struct Choice {
        const char* id; ///< the button's object name
        QString text;
        std::function<void()> run;
    };

    explicit MessageBar(QWidget* parent = nullptr);

    /// in  about: the field that the message speaks of, or nothing; see retract()
    void show(MessageKind kind, const QString& text, const QObject* about = nullptr);
    /// In the language in use, also in the one that it is changed to.
    void show(const Diagnostics& diagnostics);
    /// Offers what the buttons do, and stays until one of them or the cross is pressed: nothing waits for the answer.
    void offer(const QString& text, const std::vector<Choice>& choices);
    [[nodiscard]] QString text() const;
    [[nodiscard]] MessageKind kind() const { return m_kind; }
    void setClosable(bool closable);
    /// Hides the message if it speaks of this field: the field is mended.
    void retract(const QObject* about);
    /// The width at which no line of the text is broken.
    [[nodiscard]] int naturalWidth() const;

Q_SIGNALS:
    void changed(); ///< shown, hidden, or another text

Q_SIGNALS:
    void dismissed(); ///< by the user, with the cross

protected:
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void showKind();
    void setChoices(const std::vector<Choice>& choices);

    MessageKind m_kind = MessageKind::Info;
    Diagnostics m_diagnostics; ///< those that are shown
    const QObject* m_about = nullptr;
    QLabel* m_sign = nullptr;
    QLabel* m_text = nullptr;
    QHBoxLayout* m_choices = nullptr;
    QToolButton* m_close = nullptr;
    QTimer m_farewell; ///< good news leaves by itself
};

} // namespace rasterlens
