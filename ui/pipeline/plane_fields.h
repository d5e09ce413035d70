#pragma once
#include "ui/document/document.h"
#include "ui/pipeline/typed_row.h"

#include <QWidget>

#include <array>
#include <optional>

class QLineEdit;

namespace rasterlens
{

/// The distances of the camera's near and far plane, to be typed. An empty field leaves a distance to the camera.
class PlaneFields : public QWidget
{
    Q_OBJECT

public:
    explicit PlaneFields(Document& document, QWidget* parent = nullptr);

    [[nodiscard]] QLineEdit& nearEdit() { return m_rows[kNear]->edit(); }
    [[nodiscard]] QLineEdit& farEdit() { return m_rows[kFar]->edit(); }
    /// Scene or settings are others.
    void sync();
    void retranslate();

Q_SIGNALS:
    void invalidInput(const QString& message);
    void inputMended(); ///< what invalidInput() spoke of

private:
    static constexpr std::size_t kNear = 0;
    static constexpr std::size_t kFar = 1;

    void addRow(std::size_t which);
    [[nodiscard]] static std::optional<double>& distance(View& view, std::size_t which);
    void set(std::size_t which, std::optional<double> distance);
    std::optional<QString> read(std::size_t which, const QString& text, TypedField::Attempt attempt);
    [[nodiscard]] QString valueText(std::size_t which) const;

    Document& m_document;
    std::array<TypedRow*, 2> m_rows{};
};

} // namespace rasterlens
