#pragma once
#include "core/settings/numbers_field.h"
#include "ui/document/document.h"
#include "ui/pipeline/typed_row.h"

namespace rasterlens
{

/// The row of a setting that is a few numbers.
class NumbersRow : public TypedRow
{
    Q_OBJECT

public:
    NumbersRow(const NumbersField& field, Document& document, QWidget* parent = nullptr);

    [[nodiscard]] const NumbersField& numbers() const { return m_numbers; }
    /// Scene or settings are others.
    void sync();
    void retranslate();

private:
    std::optional<QString> read(const QString& text, TypedField::Attempt attempt);

    const NumbersField& m_numbers;
    Document& m_document;
};

} // namespace rasterlens
