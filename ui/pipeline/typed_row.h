#pragma once
#include "ui/base/field_row.h"
#include "ui/base/typed_field.h"

#include <QWidget>

class QLabel;
class QLineEdit;

namespace rasterlens
{

/// A row of the pipeline panel whose value is typed: dot, name, line.
class TypedRow : public QWidget
{
    Q_OBJECT

public:
    /// in  name: the object name of the line
    TypedRow(const QString& name, TypedField::Reader reader, QWidget* parent = nullptr);

    [[nodiscard]] QLineEdit& edit() { return *m_edit; }
    [[nodiscard]] TypedField& field() { return *m_field; }
    void sync(const QString& value, bool changed);
    void setTexts(const QString& name, const QString& toolTip, const QString& putBack);

Q_SIGNALS:
    void resetRequested();
    void invalidInput(const QString& message);
    void inputMended(); ///< what invalidInput() spoke of

private:
    ChangeDot* m_dot;
    QLabel* m_name;
    QLineEdit* m_edit;
    TypedField* m_field;
};

} // namespace rasterlens
