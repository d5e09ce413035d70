#pragma once
#include "ui/lessons/lesson_player.h"

#include <QFrame>

class QBoxLayout;
class QHBoxLayout;
class QLabel;
class QListWidget;
class QToolButton;
class QVBoxLayout;

namespace rasterlens
{

class QuestionBox;

/// A lesson as it is read: the slide's number, caption or question, the verdict, and the list of slides. Follows the
/// player.
class LessonPanel : public QFrame
{
    Q_OBJECT

public:
    /// What the buttons of the panel do; their texts and keys are those of the actions.
    struct Actions {
        QAction* previous;
        QAction* next;
        QAction* back; ///< to the lesson
    };

    LessonPanel(LessonPlayer& player, const Actions& actions, QWidget* parent = nullptr);

    [[nodiscard]] QuestionBox& question() const { return *m_question; }
    [[nodiscard]] QListWidget& contents() const { return *m_contents; }
    /// Caption or question, in the language in use.
    [[nodiscard]] QString text() const;
    [[nodiscard]] QString verdict() const;
    /// Says whether the window shows something else than the slide.
    void setAway(bool away);
    /// As a bar below the picture: without the list of slides.
    void setBar(bool bar);
    /// The link to the slides that the level leaves out; hidden where there are none.
    [[nodiscard]] QToolButton& leftOut() const { return *m_leftOut; }
    void retranslate();

Q_SIGNALS:
    void tryWanted(); ///< what can be changed is to be brought to the front

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    QWidget* buildButtons(const Actions& actions);
    void sync();
    void syncContents();
    void syncLeftOut();
    [[nodiscard]] QString tryText() const;
    [[nodiscard]] QString tryAgainText(const std::optional<PixelScore>& score) const;
    [[nodiscard]] static QString pixelText(const PixelScore& score);
    [[nodiscard]] QString verdictText() const;
    [[nodiscard]] QString endText() const;
    void keepHeight();
    [[nodiscard]] int heightOfTexts(const Slide& slide) const;
    [[nodiscard]] int barWidth() const;
    [[nodiscard]] int roomForTexts() const;
    [[nodiscard]] int verdictWidth(const Slide& slide, bool isOpen) const;
    [[nodiscard]] int heightOfRow(const QString& verdict, int width) const;
    [[nodiscard]] bool isAnsweredInRow(const Slide& slide) const;
    [[nodiscard]] int widthBesideNumber() const;
    void placeQuestion();
    void placeVerdict();
    [[nodiscard]] int leastVerdict() const;
    [[nodiscard]] static QString longestVerdict(const Question& question);

    LessonPlayer& m_player;
    QBoxLayout* m_outer = nullptr; ///< buttons, and what is read, below them or, in a bar, above them
    QVBoxLayout* m_column = nullptr;
    QWidget* m_buttons = nullptr;
    QHBoxLayout* m_row = nullptr; ///< of the buttons; in a bar with the verdict and all links
    QLabel* m_title = nullptr;
    QLabel* m_number = nullptr;
    QLabel* m_score = nullptr;
    QLabel* m_verdict = nullptr;
    QLabel* m_text = nullptr;
    QuestionBox* m_question = nullptr;
    QToolButton* m_try = nullptr;
    QToolButton* m_back = nullptr;
    QToolButton* m_leftOut = nullptr; ///< slides for a second look before this one, and the way to them
    QListWidget* m_contents = nullptr;
    bool m_away = false;
    bool m_bar = false;
    QLabel* m_measure = nullptr;          ///< hidden: tells the height of texts that are not shown
    const Slide* m_measuredFor = nullptr; ///< the slide whose choices were measured
    int m_choices = 0;                    ///< their height in a bar
};

} // namespace rasterlens
