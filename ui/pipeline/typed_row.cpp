#include "ui/pipeline/typed_row.h"

#include "ui/base/parts.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>

#include <utility>

namespace rasterlens
{

TypedRow::TypedRow(const QString& name, TypedField::Reader reader, QWidget* parent)
    : QWidget(parent), m_dot(new ChangeDot), m_name(new QLabel), m_edit(new QLineEdit),
      m_field(new TypedField(m_edit, std::move(reader)))
{
    m_name->setObjectName(QStringLiteral("muted"));
    m_name->setWordWrap(true);
    m_edit->setObjectName(name);
    m_edit->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    connect(m_field, &TypedField::refused, this, &TypedRow::invalidInput);
    connect(m_field, &TypedField::mended, this, &TypedRow::inputMended);
    connect(m_dot, &ChangeDot::clicked, this, &TypedRow::resetRequested);
    QHBoxLayout* line = makeFieldLine(m_dot, m_name, m_edit);
    line->setContentsMargins(0, 0, 0, 0);
    setLayout(line);
}

void TypedRow::sync(const QString& value, bool changed)
{
    m_field->setValue(value);
    m_dot->setChanged(changed);
}

void TypedRow::setTexts(const QString& name, const QString& toolTip, const QString& putBack)
{
    m_name->setText(name);
    m_edit->setAccessibleName(name);
    m_edit->setToolTip(toolTip);
    m_dot->setToolTip(putBack);
}

} // namespace rasterlens
