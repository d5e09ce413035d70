#pragma once
#include "core/lessons/given_answer.h"

#include <QWidget>

#include <vector>

class QBoxLayout;
class QLabel;
class QLineEdit;
class QPushButton;

namespace rasterlens
{

/// Takes the answer to a question: buttons for choices, which digits press as well, a field for what is typed, or the
/// pixels that are clicked on the canvas.
class QuestionBox : public QWidget
{
    Q_OBJECT

public:
    explicit QuestionBox(QWidget* parent = nullptr);

    /// in  null: no question is open. Another one forgets what was marked and typed
    void setQuestion(const Question* question);
    /// Choices stand beside each other in place of below each other.
    void setWide(bool wide);
    /// The height of a line with the field or with short choices.
    [[nodiscard]] int rowHeight() const;
    /// The width of a line in which a question is answered: by the field, by what pixels are marked with, or by choices
    /// beside each other.
    [[nodiscard]] int rowWidth(const Question& question) const;
    /// Choices beside each other are of one width, unless others make them lower.
    void balanceChoices(int width);

    /// Marks a pixel, or takes its mark away; nothing where the question does not ask for pixels.
    void togglePixel(QPoint pixel);
    [[nodiscard]] const std::vector<QPoint>& marked() const { return m_marked; }
    [[nodiscard]] bool asksForPixels() const { return m_question && m_question->kind == QuestionKind::Pixels; }
    /// Wrong answers to this question: choices among them cannot be chosen again.
    void setTries(const std::vector<GivenAnswer>& tries);
    /// Hands in what was marked or typed.
    void check();
    [[nodiscard]] QLineEdit& field() const { return *m_field; }
    [[nodiscard]] const std::vector<QPushButton*>& choiceButtons() const { return m_choiceButtons; }
    void retranslate();

    bool eventFilter(QObject* watched, QEvent* event) override;

Q_SIGNALS:
    void markedChanged();
    void given(const rasterlens::GivenAnswer& answer);
    void leftKeys(); ///< the field or button that had the keyboard is gone

private:
    void sync();

    const Question* m_question = nullptr;
    std::vector<QPoint> m_marked;
    std::vector<GivenAnswer> m_tries;
    QBoxLayout* m_choices = nullptr;
    std::vector<QPushButton*> m_choiceButtons;
    QLabel* m_hint = nullptr;
    QLineEdit* m_field = nullptr;
    QPushButton* m_clear = nullptr;
    QPushButton* m_check = nullptr;
};

} // namespace rasterlens
