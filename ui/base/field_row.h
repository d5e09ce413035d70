#pragma once
#include "core/settings/settings.h"
#include "ui/base/language.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QSpinBox>

#include <functional>

class QLabel;

namespace rasterlens
{

/// A dot where a value differs from the scene's; a click on it puts the scene's value back.
class ChangeDot : public QAbstractButton
{
    Q_OBJECT

public:
    explicit ChangeDot(QWidget* parent = nullptr);
    void setChanged(bool changed);
    [[nodiscard]] bool isChanged() const { return m_changed; }
    QSize sizeHint() const override { return {10, 16}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    bool m_changed = false;
};

/// A combo box that leaves the wheel to the panel around it, and the keys to the canvas once the mouse chose a value.
class PanelCombo : public QComboBox
{
    Q_OBJECT

public:
    explicit PanelCombo(QWidget* parent = nullptr);

Q_SIGNALS:
    void aboutToShowPopup();

protected:
    void paintEvent(QPaintEvent* event) override; ///< a text without room ends in dots
    void showPopup() override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override;

private:
    bool m_byMouse = false; ///< opened so
};

/// A spin box that leaves the wheel to the panel around it. Return and Escape leave the box: the next key is not for
/// it. It takes every letter; a text that is no number of its range stays in it, marked, and its tool-tip says why,
/// until it is mended or given up with Escape.
class PanelSpin : public QSpinBox
{
    Q_OBJECT

public:
    using QSpinBox::QSpinBox;

    [[nodiscard]] bool isRefused() const { return !m_whyRefused.isEmpty(); }
    [[nodiscard]] QString whyRefused() const { return m_whyRefused; }

protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    [[nodiscard]] QValidator::State validate(QString& text, int& position) const override;

private:
    [[nodiscard]] bool isTyped() const;
    void take();
    void setRefused(const QString& why);

    QString m_whyRefused;
};

/// One field of the settings table: dot, name, switch, key.
class FieldRow : public QWidget
{
    Q_OBJECT

public:
    FieldRow(const SettingsField& field, const Language& language, QWidget* parent = nullptr);

    [[nodiscard]] const SettingsField& field() const { return m_field; }
    [[nodiscard]] QWidget* editor() const { return m_editor; }
    void setKeyHint(const QString& key);
    /// in   whether the settings cannot be drawn: then every switch stays open, to find the way back; whether the scene
    ///      has lines, for which the switches of lines are there whatever the fill
    void sync(const Settings& settings, const Settings& defaults, bool refused, bool sceneHasLines);
    /// Greys out the values that `why` gives a reason against.
    void setValueReasons(const std::function<QString(int)>& why);
    /// Says something about the value below the switch; an empty text takes it away.
    void setNote(const QString& note);
    [[nodiscard]] QString note() const;
    void retranslate();

Q_SIGNALS:
    void chosen(int value);
    void resetRequested();
    void popupOpening();

private:
    void makeEditor();
    void updateToolTip();

    const SettingsField& m_field;
    const Language& m_language;
    ChangeDot* m_dot = nullptr;
    QLabel* m_name = nullptr;
    QWidget* m_editor = nullptr;
    QLabel* m_key = nullptr;
    QLabel* m_note = nullptr;
    QString m_whyInert;
};

} // namespace rasterlens
