#pragma once
#include "core/lessons/given_answer.h"
#include "core/lessons/lesson.h"
#include "ui/base/latest_result.h"

#include <QObject>

#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace rasterlens
{

/// A lesson while it is held: the slide, the question that is open, and what was answered so far.
class LessonPlayer : public QObject
{
    Q_OBJECT

public:
    enum class Phase {
        Closed,
        Asking, ///< the slide's question is open, and its picture not shown yet
        Shown,
        Ended, ///< behind the last slide
    };
    /// Where a lesson stands.
    struct Place {
        std::shared_ptr<const Lesson> lesson;
        std::size_t slide = 0;
        Phase phase = Phase::Closed;
    };
    enum class Entry { Asks, Skips }; ///< a question that was not answered yet

    explicit LessonPlayer(QObject* parent = nullptr);

    void open(std::shared_ptr<const Lesson> lesson);
    void close();
    [[nodiscard]] bool isOpen() const { return m_place.phase != Phase::Closed; }
    [[nodiscard]] const Place& place() const { return m_place; }
    /// Goes back to where the lesson stood before, without asking for the moment: the window shows it already.
    void setPlace(const Place& place);

    // Only while a lesson is open.
    [[nodiscard]] const Lesson& lesson() const { return *m_place.lesson; }
    [[nodiscard]] const Slide& slide() const { return lesson().slides[m_place.slide]; }
    /// What the window is to show: the slide's moment, or while its question is open what stands before it.
    [[nodiscard]] const Moment& moment() const;
    [[nodiscard]] bool isAsking() const { return m_place.phase == Phase::Asking; }
    /// The pixel that the open question is about, where it is about one.
    [[nodiscard]] std::optional<QPoint> askedPixel() const;
    /// The question that is open, or else that of the slide after the present one where it was not answered yet; null:
    /// neither.
    [[nodiscard]] const Question* openOrNextQuestion() const;
    /// Whether a later slide with the same scene, whose question was not answered yet, asks for the value of an edge
    /// function: the lens would tell it before the sample has its turn.
    [[nodiscard]] bool willAskForEdgeValue() const;

    /// in  slide: counted from 0
    void goTo(std::size_t slide, Entry entry = Entry::Asks);
    /// An open question is skipped, and the slide shown; else to the next slide of the level, or to the end.
    void next();
    /// To the slide before, which is shown with its picture.
    void previous();
    [[nodiscard]] bool hasNext() const { return isOpen() && m_place.phase != Phase::Ended; }
    [[nodiscard]] bool hasPrevious() const;
    /// The slides for a second look just before the present one, or before the end, that the level leaves out.
    [[nodiscard]] std::vector<std::size_t> leftOut() const;
    /// Asks once more for the moment.
    void comeBack();

    /// in  1: the slides of the first course; 2: those for a second look as well
    void setLevel(int level);
    [[nodiscard]] int level() const { return m_level; }

    /// Answers the open question, as soon as the right answer is computed. After a wrong answer there is a second try,
    /// but for questions with two choices; then the slide is shown.
    void answer(GivenAnswer given);
    /// The wrong answers to the open question.
    [[nodiscard]] const std::vector<GivenAnswer>& tries() const { return m_tries; }
    /// The last answer was right as far as it went, which is no try: a number with too few digits.
    [[nodiscard]] bool wantsDigits() const { return m_wantsDigits; }
    /// How the last wrong answer compares with the right pixels; nothing where it is not a matter of pixels.
    [[nodiscard]] std::optional<PixelScore> triedPixels() const;
    /// What was answered to a slide's question, with the right answer; nothing while it was not answered.
    struct Answered {
        std::optional<GivenAnswer> given; ///< nothing: skipped
        std::optional<Answer> right;      ///< nothing: the moment has none
        bool isRight = false;
    };
    [[nodiscard]] const Answered* answered(std::size_t slide) const;
    struct Score {
        int right = 0;
        int answered = 0;
        int questions = 0; ///< of the level
    };
    [[nodiscard]] Score score() const;
    /// The answers since the program started, of all lessons.
    [[nodiscard]] const std::vector<AnswerRow>& rows() const { return m_rows; }
    /// Whether the right answer is still being computed.
    [[nodiscard]] bool isBusy() const { return m_key.isBusy(); }

Q_SIGNALS:
    void changed();      ///< lesson, slide, phase, level or score
    void momentWanted(); ///< the window is to show moment()
    void rowsChanged();
    void failed(const QString& message);

private:
    void begin(const Place& place);
    void show(std::size_t slide, Phase phase);
    void computeAnswer();
    void judge();
    void noteRow(const std::optional<GivenAnswer>& given, bool isRight);
    [[nodiscard]] bool isOfLevel(std::size_t slide) const;
    /// The slide after the present one; as many as there are: none.
    [[nodiscard]] std::size_t slideAfter() const;

    Place m_place;
    int m_level = 1;
    std::map<std::size_t, Answered> m_answered; ///< by slide
    std::vector<AnswerRow> m_rows;
    std::vector<GivenAnswer> m_tries;
    bool m_wantsDigits = false;
    std::optional<GivenAnswer> m_given;        ///< while the right answer is computed
    std::optional<Answer> m_right;             ///< to the open question, once it is computed
    LatestResult<std::optional<Answer>> m_key; ///< last: its thread uses the members above
};

} // namespace rasterlens
