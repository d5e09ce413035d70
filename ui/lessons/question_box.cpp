#include "ui/lessons/question_box.h"

#include "ui/lessons/texts.h"

#include <QApplication>
#include <QBoxLayout>
#include <QFontInfo>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include <algorithm>

namespace rasterlens
{
namespace
{

constexpr int kGap = 6;
constexpr int kChoicePadding = 5; ///< above and below the text of a choice

/// A button with the key that presses it, whose text is broken into lines where it has no room.
class WrappingButton : public QPushButton
{
public:
    WrappingButton(int key, const QString& text) : m_label(new QLabel(text))
    {
        setObjectName(QStringLiteral("choice"));
        setAccessibleName(text);
        setFocusPolicy(Qt::TabFocus);
        m_label->setWordWrap(true);
        m_label->setTextFormat(Qt::PlainText);
        m_label->setAttribute(Qt::WA_TransparentForMouseEvents);
        auto* number = new QLabel(QString::number(key));
        number->setObjectName(QStringLiteral("keyHint"));
        number->setAttribute(Qt::WA_TransparentForMouseEvents);
        auto* row = new QHBoxLayout(this);
        row->setContentsMargins(9, kChoicePadding, 9, kChoicePadding);
        row->setSpacing(8);
        row->addWidget(number);
        row->addWidget(m_label, 1);
        QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Minimum);
        policy.setHeightForWidth(true);
        setSizePolicy(policy);
    }

    /// With its text in one line.
    [[nodiscard]] int widthOfLine() const
    {
        constexpr int kSlack = 4;
        m_label->ensurePolished();
        const QSize around = layout()->sizeHint() - m_label->sizeHint();
        return m_label->fontMetrics().horizontalAdvance(m_label->text()) + around.width() + kSlack;
    }

    [[nodiscard]] QSize sizeHint() const override { return layout()->sizeHint(); }
    [[nodiscard]] QSize minimumSizeHint() const override { return layout()->minimumSize(); }
    [[nodiscard]] bool hasHeightForWidth() const override { return true; }
    [[nodiscard]] int heightForWidth(int width) const override { return layout()->totalHeightForWidth(width); }

private:
    QLabel* m_label;
};

} // namespace

QuestionBox::QuestionBox(QWidget* parent) : QWidget(parent)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    m_choices = new QBoxLayout(QBoxLayout::TopToBottom);
    m_choices->setSpacing(6);
    column->addLayout(m_choices);
    auto* row = new QHBoxLayout;
    row->setSpacing(kGap);
    m_hint = new QLabel;
    m_hint->setObjectName(QStringLiteral("lessonHint"));
    m_hint->setWordWrap(true);
    m_field = new QLineEdit;
    m_field->setObjectName(QStringLiteral("lessonAnswer"));
    constexpr int kMostWidth = 260;
    m_field->setMaximumWidth(kMostWidth);
    m_clear = new QPushButton;
    m_clear->setObjectName(QStringLiteral("lessonClear"));
    m_check = new QPushButton;
    m_check->setObjectName(QStringLiteral("lessonCheck"));
    row->addWidget(m_hint, 1);
    row->addWidget(m_field, 1);
    for (QPushButton* button : {m_clear, m_check}) {
        button->setFocusPolicy(Qt::TabFocus); // a click leaves the keys to the canvas
        button->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
        row->addWidget(button);
    }
    row->addStretch(0); // beyond the greatest width of the field
    column->addLayout(row);
    connect(m_check, &QPushButton::clicked, this, &QuestionBox::check);
    connect(m_field, &QLineEdit::returnPressed, this, &QuestionBox::check);
    connect(m_field, &QLineEdit::textChanged, this, &QuestionBox::sync);
    connect(m_clear, &QPushButton::clicked, this, [this] {
        m_marked.clear();
        sync();
        Q_EMIT markedChanged();
    });
    qApp->installEventFilter(this);
    retranslate();
}

/// Digits choose, wherever the keyboard is in the window, but for what is typed into.
bool QuestionBox::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress)
        return QWidget::eventFilter(watched, event);
    const auto* key = static_cast<const QKeyEvent*>(event);
    const QWidget* focused = QApplication::focusWidget();
    const auto choice = static_cast<std::size_t>(key->key() - Qt::Key_1);
    const bool isMeant = key->key() >= Qt::Key_1 && choice < m_choiceButtons.size() && isVisible() &&
                         (key->modifiers() & ~Qt::KeypadModifier) == 0 && focused != nullptr &&
                         focused->window() == window() && !focused->testAttribute(Qt::WA_InputMethodEnabled);
    if (!isMeant)
        return QWidget::eventFilter(watched, event);
    if (event->type() == QEvent::ShortcutOverride)
        event->accept(); // no camera turns
    else
        m_choiceButtons[choice]->click();
    return true;
}

void QuestionBox::setWide(bool wide)
{
    m_choices->setDirection(wide ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    m_hint->setWordWrap(!wide);
    m_field->setMinimumWidth(wide ? m_field->maximumWidth() : 0);
}

void QuestionBox::balanceChoices(int width)
{
    const auto share = [&](bool evenly) {
        for (QPushButton* button : m_choiceButtons)
            m_choices->setStretchFactor(button, evenly ? 1 : static_cast<WrappingButton*>(button)->widthOfLine());
        m_choices->invalidate();
        return m_choices->heightForWidth(width);
    };
    const bool isBeside = m_choices->direction() == QBoxLayout::LeftToRight;
    const int even = share(true);
    if (isBeside && share(false) >= even)
        share(true);
}

int QuestionBox::rowWidth(const Question& question) const
{
    if (question.kind == QuestionKind::Pixels)
        return fontMetrics().horizontalAdvance(tr("Click the pixels on the canvas.")) + m_clear->sizeHint().width() +
               m_check->sizeHint().width() + 2 * kGap;
    if (question.choices.empty())
        return m_field->maximumWidth() + m_check->sizeHint().width() + kGap;
    constexpr double kAroundText = 2.6; // its key and its border, in letters
    int widest = 0;
    for (const QuestionChoice& choice : question.choices)
        widest = std::max(widest, fontMetrics().horizontalAdvance(choiceText(choice)));
    const int each = widest + static_cast<int>(kAroundText * QFontInfo(font()).pixelSize());
    return static_cast<int>(question.choices.size()) * (each + kGap) - kGap;
}

int QuestionBox::rowHeight() const
{
    constexpr int kOtherScripts = 4; // are taller
    const int choice = fontMetrics().height() + 2 * kChoicePadding + kOtherScripts;
    return std::max({m_field->sizeHint().height(), m_check->sizeHint().height(), choice});
}

void QuestionBox::setQuestion(const Question* question)
{
    if (question == m_question)
        return;
    const QWidget* focused = QApplication::focusWidget();
    const bool hadKeys = focused && isAncestorOf(focused);
    m_question = question;
    m_marked.clear();
    m_tries.clear();
    m_field->clear();
    retranslate();
    if (!m_field->isHidden())
        m_field->setFocus(); // what is typed is the answer, and no key of the canvas
    else if (hadKeys)
        Q_EMIT leftKeys();
    Q_EMIT markedChanged();
}

void QuestionBox::setTries(const std::vector<GivenAnswer>& tries)
{
    if (tries.size() > m_tries.size() && !m_field->isHidden())
        m_field->selectAll(); // what is typed next takes its place
    m_tries = tries;
    sync();
}

void QuestionBox::togglePixel(QPoint pixel)
{
    if (!asksForPixels())
        return;
    if (std::erase(m_marked, pixel) == 0)
        m_marked.push_back(pixel);
    sync();
    Q_EMIT markedChanged();
}

void QuestionBox::check()
{
    if (!m_question || !m_check->isEnabled())
        return;
    if (asksForPixels())
        Q_EMIT given(m_marked);
    else if (m_question->choices.empty())
        Q_EMIT given(m_field->text());
}

void QuestionBox::sync()
{
    const bool hasChoices = m_question && !m_question->choices.empty();
    const bool typed = m_question && !hasChoices && !asksForPixels();
    setVisible(m_question != nullptr);
    m_field->setVisible(typed);
    m_check->setVisible(typed || asksForPixels());
    m_clear->setVisible(asksForPixels());
    m_hint->setVisible(asksForPixels());
    m_check->setEnabled(asksForPixels() ? !m_marked.empty() : !m_field->text().trimmed().isEmpty());
    m_clear->setEnabled(!m_marked.empty());
    m_hint->setText(m_marked.empty() ? tr("Click the pixels on the canvas.")
                                     : tr("Pixels marked: %1").arg(m_marked.size()));
    for (std::size_t i = 0; i < m_choiceButtons.size(); ++i)
        m_choiceButtons[i]->setEnabled(std::ranges::find(m_tries, GivenAnswer(i)) == m_tries.end());
}

void QuestionBox::retranslate()
{
    m_clear->setText(tr("Clear"));
    m_check->setText(tr("Check"));
    const bool asksForNumber = m_question && m_question->kind == QuestionKind::Number;
    m_field->setPlaceholderText(asksForNumber ? tr("whole, or three digits") : tr("your answer"));
    m_field->setAccessibleName(tr("your answer"));
    for (QPushButton* button : m_choiceButtons) {
        button->hide();
        button->deleteLater(); // it may be the button that was just pressed
    }
    m_choiceButtons.clear();
    for (std::size_t i = 0; m_question && i < m_question->choices.size(); ++i) {
        auto* button = new WrappingButton(static_cast<int>(i) + 1, choiceText(m_question->choices[i]));
        connect(button, &QPushButton::clicked, this, [this, i] { Q_EMIT given(i); });
        m_choices->addWidget(button, 1); // beside each other they are of one width
        button->show();                  // at once, so that it is measured
        m_choiceButtons.push_back(button);
    }
    sync();
}

} // namespace rasterlens
