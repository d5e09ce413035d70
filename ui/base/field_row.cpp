#include "ui/base/field_row.h"

#include "core/base/typed_numbers.h"
#include "ui/base/applicability.h"
#include "ui/base/parts.h"
#include "ui/base/typed_field.h"

#include <QAbstractItemView>
#include <QCheckBox>
#include <QCoreApplication>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QSignalBlocker>
#include <QStandardItemModel>
#include <QStylePainter>
#include <QToolTip>
#include <QVBoxLayout>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <utility>

namespace rasterlens
{
namespace
{

QString translated(const char* text) { return QCoreApplication::translate("Settings", text); }

/// A field takes Escape for itself, before it is a short-cut of the window.
bool acceptsEscape(QEvent* event)
{
    if (event->type() != QEvent::ShortcutOverride || static_cast<QKeyEvent*>(event)->key() != Qt::Key_Escape)
        return false;
    event->accept();
    return true;
}

} // namespace

ChangeDot::ChangeDot(QWidget* parent) : QAbstractButton(parent)
{
    setFocusPolicy(Qt::NoFocus);
    setFixedWidth(sizeHint().width());
    setEnabled(false);
}

void ChangeDot::setChanged(bool changed)
{
    if (std::exchange(m_changed, changed) == changed)
        return;
    setCursor(changed ? Qt::PointingHandCursor : Qt::ArrowCursor);
    setEnabled(changed);
    update();
}

void ChangeDot::paintEvent(QPaintEvent*)
{
    if (!m_changed)
        return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette().color(QPalette::Active, QPalette::Highlight));
    painter.drawEllipse(QRectF(rect()).center(), 3, 3);
}

PanelCombo::PanelCombo(QWidget* parent) : QComboBox(parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    setMinimumContentsLength(6);
    connect(this, &QComboBox::activated, this, [this] {
        if (m_byMouse)
            clearFocus();
    });
}

void PanelCombo::paintEvent(QPaintEvent*)
{
    QStylePainter painter(this);
    QStyleOptionComboBox option;
    initStyleOption(&option);
    painter.drawComplexControl(QStyle::CC_ComboBox, option);
    const int room = style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, this).width();
    option.currentText = fontMetrics().elidedText(option.currentText, Qt::ElideRight, room);
    painter.drawControl(QStyle::CE_ComboBoxLabel, option);
}

void PanelCombo::showPopup()
{
    Q_EMIT aboutToShowPopup();
    view()->setMinimumWidth(view()->sizeHintForColumn(0) + 24);
    QComboBox::showPopup();
}

void PanelCombo::wheelEvent(QWheelEvent* event) { event->ignore(); }

void PanelCombo::mousePressEvent(QMouseEvent* event)
{
    m_byMouse = true;
    QComboBox::mousePressEvent(event);
}

void PanelCombo::keyPressEvent(QKeyEvent* event)
{
    m_byMouse = false;
    if (event->key() == Qt::Key_Escape)
        clearFocus();
    else
        QComboBox::keyPressEvent(event);
}

bool PanelCombo::event(QEvent* event) { return acceptsEscape(event) || QComboBox::event(event); }

bool PanelSpin::event(QEvent* event)
{
    if (event->type() == QEvent::ToolTip && isRefused()) {
        QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), m_whyRefused, this);
        return true;
    }
    return acceptsEscape(event) || QSpinBox::event(event);
}

void PanelSpin::keyPressEvent(QKeyEvent* event)
{
    switch (event->key()) {
    case Qt::Key_Escape:
        setRefused({});
        setValue(value()); // in place of what was typed
        clearFocus();
        break;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (isTyped())
            take();
        if (!isRefused())
            clearFocus();
        break;
    default:
        QSpinBox::keyPressEvent(event);
        if (isRefused() && !isTyped())
            setRefused({});
    }
}

/// Another widget was chosen: the text counts. A menu or another program only borrows the keys.
void PanelSpin::focusOutEvent(QFocusEvent* event)
{
    if (isTyped() && event->reason() != Qt::PopupFocusReason && event->reason() != Qt::ActiveWindowFocusReason)
        take();
    const QString text = lineEdit()->text();
    QSpinBox::focusOutEvent(event);
    if (isRefused())
        lineEdit()->setText(text);
}

/// Nothing is kept from being typed: a letter that does not appear is a riddle.
QValidator::State PanelSpin::validate(QString& text, int& position) const
{
    QString copy = text; // QSpinBox takes blanks out of what it is given, and moves the cursor
    int place = position;
    return std::max(QSpinBox::validate(copy, place), QValidator::Intermediate);
}

/// The text is not the one of the value.
bool PanelSpin::isTyped() const
{
    const bool special = !specialValueText().isEmpty() && value() == minimum();
    return lineEdit()->text() != (special ? specialValueText() : prefix() + textFromValue(value()) + suffix());
}

void PanelSpin::take()
{
    QString text = lineEdit()->text().trimmed();
    if (!suffix().isEmpty() && text.endsWith(suffix().trimmed()))
        text.chop(suffix().trimmed().size());
    const auto numbers = typedNumbers(text);
    const QString word = specialValueText(); // `auto`, with what it stands for behind
    const bool special = !text.isEmpty() && (text == word || word.startsWith(text + QLatin1Char(' ')));
    const double number = special ? minimum() : numbers && numbers->size() == 1 ? numbers->front() : minimum() - 1.0;
    if (number != std::floor(number) || number < minimum() || number > maximum()) {
        setRefused(tr("\"%1\" is not a whole number from %2 to %3").arg(text).arg(minimum()).arg(maximum()));
        return;
    }
    setRefused({});
    setValue(static_cast<int>(number));
}

void PanelSpin::setRefused(const QString& why)
{
    m_whyRefused = why;
    markRefused(*this, isRefused());
    setAccessibleDescription(why);
    if (isRefused())
        QToolTip::showText(mapToGlobal(rect().bottomLeft()), why, this);
}

void PanelSpin::wheelEvent(QWheelEvent* event) { event->ignore(); }

FieldRow::FieldRow(const SettingsField& field, const Language& language, QWidget* parent)
    : QWidget(parent), m_field(field), m_language(language)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(1);
    m_dot = new ChangeDot;
    m_name = new QLabel;
    m_name->setWordWrap(true);
    m_name->setObjectName(QStringLiteral("muted"));
    makeEditor();
    m_editor->setObjectName(QStringLiteral("field-") + QLatin1String(field.id));
    m_key = new QLabel;
    m_key->setObjectName(QStringLiteral("keyHint"));
    m_key->setAlignment(Qt::AlignCenter);
    column->addLayout(makeFieldLine(m_dot, m_name, m_editor, m_key));
    m_note = new QLabel;
    m_note->setObjectName(QStringLiteral("muted"));
    m_note->setWordWrap(true);
    constexpr QMargins kUnderTheName(14, 0, 18, 2);
    m_note->setContentsMargins(kUnderTheName);
    m_note->hide();
    column->addWidget(m_note);
    connect(m_dot, &ChangeDot::clicked, this, &FieldRow::resetRequested);
    retranslate();
}

void FieldRow::makeEditor()
{
    switch (m_field.kind) {
    case SettingsField::Kind::Choice: {
        auto* box = new PanelCombo;
        for (const Choice& choice : m_field.choices)
            box->addItem(QString(), QLatin1String(choice.id));
        connect(box, &QComboBox::currentIndexChanged, this, &FieldRow::chosen);
        connect(box, &PanelCombo::aboutToShowPopup, this, &FieldRow::popupOpening);
        m_editor = box;
        break;
    }
    case SettingsField::Kind::Integer: {
        auto* spin = new PanelSpin;
        spin->setRange(m_field.minimum, m_field.maximum);
        spin->setKeyboardTracking(false);
        spin->setFocusPolicy(Qt::StrongFocus);
        connect(spin, &QSpinBox::valueChanged, this, &FieldRow::chosen);
        m_editor = spin;
        break;
    }
    case SettingsField::Kind::Flag: {
        auto* box = new QCheckBox;
        connect(box, &QCheckBox::toggled, this, [this](bool on) { Q_EMIT chosen(on ? 1 : 0); });
        m_editor = box;
        break;
    }
    }
    m_editor->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
}

void FieldRow::setKeyHint(const QString& key)
{
    m_key->setText(key);
    updateToolTip();
}

void FieldRow::sync(const Settings& settings, const Settings& defaults, bool refused, bool sceneHasLines)
{
    const QSignalBlocker blocked(m_editor);
    const int value = m_field.get(settings);
    if (auto* combo = qobject_cast<QComboBox*>(m_editor))
        combo->setCurrentIndex(value);
    else if (auto* spin = qobject_cast<PanelSpin*>(m_editor); spin && !(spin->isRefused() && spin->value() == value))
        spin->setValue(value);
    else if (auto* check = qobject_cast<QCheckBox*>(m_editor))
        check->setChecked(value != 0);

    m_dot->setChanged(value != m_field.get(defaults));
    m_dot->setToolTip(tr("The scene asks for: %1. Click to put it back.").arg(valueTitle(m_field, defaults)));
    m_whyInert = withoutEffectText(m_field, settings, sceneHasLines).value_or(QString());
    m_editor->setEnabled(refused || m_whyInert.isEmpty());
    m_name->setEnabled(m_editor->isEnabled());
    updateToolTip();
}

void FieldRow::setNote(const QString& note)
{
    m_note->setText(note);
    m_note->setVisible(!note.isEmpty());
    m_editor->setAccessibleDescription(note);
}

QString FieldRow::note() const { return m_note->text(); }

void FieldRow::setValueReasons(const std::function<QString(int)>& why)
{
    auto* combo = qobject_cast<QComboBox*>(m_editor);
    auto* model = combo ? qobject_cast<QStandardItemModel*>(combo->model()) : nullptr;
    if (!model)
        return;
    for (int i = 0; i < model->rowCount(); ++i) {
        const QString reason = why(i);
        model->item(i)->setEnabled(reason.isEmpty());
        model->item(i)->setToolTip(reason);
    }
}

void FieldRow::retranslate()
{
    m_name->setText(translated(m_field.title));
    m_editor->setAccessibleName(m_name->text());
    const auto titleOf = [this](int value) {
        Settings settings;
        m_field.set(settings, value);
        return valueTitle(m_field, settings);
    };
    if (auto* combo = qobject_cast<QComboBox*>(m_editor))
        for (int i = 0; i < combo->count(); ++i)
            combo->setItemText(i, titleOf(i));
    if (auto* spin = qobject_cast<QSpinBox*>(m_editor))
        spin->setSpecialValueText(titleOf(m_field.minimum));
    updateToolTip();
}

void FieldRow::updateToolTip()
{
    QString text = QStringLiteral("<p><b>%1</b><br/>%2</p><p>%3</p>")
                       .arg(translated(m_field.title).toHtmlEscaped(),
                            m_language.inOther("Settings", m_field.title).toHtmlEscaped(),
                            translated(m_field.help).toHtmlEscaped());
    if (!m_whyInert.isEmpty())
        text += QStringLiteral("<p><i>%1</i></p>").arg(tr("No effect now: %1").arg(m_whyInert).toHtmlEscaped());
    if (!m_key->text().isEmpty())
        text += QStringLiteral("<p>%1</p>").arg(tr("Key %1 steps through the values.").arg(m_key->text()));
    m_name->setToolTip(text);
    m_editor->setToolTip(text);
}

} // namespace rasterlens
