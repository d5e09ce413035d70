#include "ui/pipeline/numbers_row.h"

#include "ui/base/applicability.h"

#include <QCoreApplication>
#include <QLineEdit>

namespace rasterlens
{

NumbersRow::NumbersRow(const NumbersField& field, Document& document, QWidget* parent)
    : TypedRow(
          QLatin1String(field.id),
          [this](const QString& text, TypedField::Attempt attempt) { return read(text, attempt); }, parent),
      m_numbers(field), m_document(document)
{
    connect(this, &TypedRow::resetRequested, this, [this] {
        Settings next = m_document.settings();
        m_numbers.set(next, m_numbers.get(m_document.defaults()));
        m_document.setSettings(next);
    });
}

std::optional<QString> NumbersRow::read(const QString& text, TypedField::Attempt attempt)
{
    Settings next = m_document.settings();
    if (const auto wrong = setFromText(m_numbers, text, next))
        return textOf(*wrong, [](const char* words) { return QCoreApplication::translate("Diagnostic", words); });
    if (attempt == TypedField::Attempt::Take) {
        m_document.setSettings(next);
        field().setValue(valueText(m_numbers, next));
    }
    return std::nullopt;
}

void NumbersRow::sync()
{
    const Settings& settings = m_document.settings();
    TypedRow::sync(valueText(m_numbers, settings), !isEqual(m_numbers, settings, m_document.defaults()));
    const std::optional<QString> inert = withoutEffectText(m_numbers, settings);
    edit().setEnabled(!inert);
    edit().setToolTip(inert.value_or(QCoreApplication::translate("Settings", m_numbers.help)));
}

void NumbersRow::retranslate()
{
    setTexts(QCoreApplication::translate("Settings", m_numbers.title), {}, tr("Put back what the scene asks for"));
    sync();
}

} // namespace rasterlens
