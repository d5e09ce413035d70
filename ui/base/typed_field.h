#pragma once
#include <QObject>
#include <QString>

#include <functional>
#include <optional>

class QLineEdit;
class QWidget;

namespace rasterlens
{

/// Marks a field whose text is refused, or takes the mark away; the style sheet draws it.
void markRefused(QWidget& field, bool refused);

/// A line edit for numbers. Return takes the text and leaves the field; Escape puts the former text back and leaves it.
/// A text that is refused stays in the field, marked, with a sentence that says why, until it is mended.
class TypedField : public QObject
{
    Q_OBJECT

public:
    enum class Attempt { Look, Take }; ///< only judge the text, or use it as well

    /// Reads a text.
    ///
    /// out  why it is refused; nothing where it is good
    using Reader = std::function<std::optional<QString>(const QString& text, Attempt attempt)>;

    /// in  frame: the widget that holds the focus and gets the mark, where it is not the line edit
    TypedField(QLineEdit* edit, Reader reader, QWidget* frame = nullptr);

    /// Shows the value in use. A text that is being typed stays as long as the value stays the same.
    void setValue(const QString& text);
    [[nodiscard]] bool isRefused() const { return m_refused; }

Q_SIGNALS:
    void refused(const QString& why);
    void mended(); ///< no text is refused any more
    void left();   ///< by Return or Escape

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void take();
    void abandon();
    void judge();
    void setRefused(const std::optional<QString>& why);

    QLineEdit* m_edit;
    QWidget* m_frame;
    Reader m_reader;
    QString m_value;
    bool m_refused = false;
    bool m_touched = false; ///< the text is not the value's
};

} // namespace rasterlens
