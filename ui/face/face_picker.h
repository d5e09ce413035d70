#pragma once
#include <QObject>
#include <QWidget>

#include <cstdint>

class QLabel;
class QSpinBox;

namespace rasterlens
{

/// The face that the panels are about.
class FaceSelection : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    [[nodiscard]] std::uint32_t face() const { return m_face; }
    [[nodiscard]] std::uint32_t count() const { return m_count; }
    /// The face is held within 0..count - 1.
    void setCount(std::uint32_t count);
    void setFace(std::uint32_t face);

Q_SIGNALS:
    void changed();

private:
    std::uint32_t m_face = 0;
    std::uint32_t m_count = 0;
};

/// `face [3] of 12`
class FacePicker : public QWidget
{
    Q_OBJECT

public:
    explicit FacePicker(FaceSelection& selection, QWidget* parent = nullptr);

    [[nodiscard]] QSpinBox* spin() const { return m_spin; }

protected:
    void changeEvent(QEvent* event) override;

private:
    void sync();

    FaceSelection& m_selection;
    QLabel* m_name;
    QSpinBox* m_spin;
    QLabel* m_total;
};

} // namespace rasterlens
