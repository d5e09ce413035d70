#pragma once
#include "ui/base/field_row.h"
#include "ui/base/typed_field.h"
#include "ui/document/document.h"

#include <QWidget>

#include <optional>

class QCheckBox;
class QLabel;
class QLineEdit;

namespace rasterlens
{

class LightBall;

/// The direction towards the light: three numbers to be typed, a ball to drag it on, and the headlight.
class LightFields : public QWidget
{
    Q_OBJECT

public:
    explicit LightFields(Document& document, QWidget* parent = nullptr);

    [[nodiscard]] QLineEdit& edit() { return *m_edit; }
    [[nodiscard]] QCheckBox& headBox() { return *m_head; }
    [[nodiscard]] LightBall& ball() { return *m_ball; }
    /// Why another light changes nothing here; empty where it does.
    [[nodiscard]] QString note() const;
    /// Scene or settings are others.
    void sync();
    void retranslate();

Q_SIGNALS:
    void invalidInput(const QString& message);
    void inputMended(); ///< what invalidInput() spoke of

private:
    void set(const Light& light, Document::Edit edit = Document::Edit::Step);
    void drag(const glm::dvec3& towardsView);
    std::optional<QString> read(const QString& text, TypedField::Attempt attempt);
    [[nodiscard]] QString valueText() const;

    Document& m_document;
    Light m_direction; ///< the last one that was no headlight: what the light is when the headlight goes out
    ChangeDot* m_dot = nullptr;
    QLabel* m_name = nullptr;
    QLineEdit* m_edit = nullptr;
    TypedField* m_field = nullptr;
    QCheckBox* m_head = nullptr;
    LightBall* m_ball = nullptr;
    QLabel* m_note = nullptr;
};

} // namespace rasterlens
