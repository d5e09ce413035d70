#include "ui/lessons/lesson_player.h"

#include <algorithm>
#include <utility>

namespace rasterlens
{

LessonPlayer::LessonPlayer(QObject* parent)
    : QObject(parent), m_key(
                           [this](std::optional<Answer> right) {
                               m_right = std::move(right);
                               if (m_given)
                                   judge();
                           },
                           [this](Lack lack) {
                               Q_EMIT failed(tr("The answer was not computed: %1.").arg(lackText(lack)));
                               m_given.reset();
                           })
{
}

void LessonPlayer::open(std::shared_ptr<const Lesson> lesson)
{
    close(); // a question of the former lesson would stay open
    m_answered.clear();
    m_place.lesson = std::move(lesson);
    goTo(0);
}

void LessonPlayer::close()
{
    m_key.drop();
    m_given.reset();
    m_place = {};
    Q_EMIT changed();
}

void LessonPlayer::setPlace(const Place& place)
{
    if (place.lesson != m_place.lesson)
        m_answered.clear();
    begin(place);
}

/// A question that was left in the middle of its tries begins anew.
void LessonPlayer::begin(const Place& place)
{
    m_place = place;
    m_given.reset();
    m_tries.clear();
    m_wantsDigits = false;
    m_key.drop();
    if (isAsking())
        computeAnswer();
    Q_EMIT changed();
}

std::optional<QPoint> LessonPlayer::askedPixel() const
{
    return isAsking() && slide().question->answer ? slide().question->answer->fact.pixel : std::nullopt;
}

const Moment& LessonPlayer::moment() const { return isAsking() ? *slide().before : slide().moment; }

void LessonPlayer::show(std::size_t slide, Phase phase)
{
    begin({m_place.lesson, slide, phase});
    Q_EMIT momentWanted();
}

void LessonPlayer::goTo(std::size_t slide, Entry entry)
{
    const bool asks = entry == Entry::Asks && lesson().slides[slide].question && !answered(slide);
    show(slide, asks ? Phase::Asking : Phase::Shown);
}

void LessonPlayer::next()
{
    if (isAsking()) {
        const bool wasTried = !m_tries.empty();
        m_answered[m_place.slide] = {wasTried ? std::optional(m_tries.back()) : std::nullopt, m_right, false};
        if (!wasTried)
            noteRow(std::nullopt, false);
        show(m_place.slide, Phase::Shown);
        return;
    }
    if (const std::size_t next = slideAfter(); next < lesson().slides.size()) {
        goTo(next);
        return;
    }
    m_place.phase = Phase::Ended;
    Q_EMIT changed();
}

std::size_t LessonPlayer::slideAfter() const
{
    std::size_t next = m_place.slide + 1;
    while (next < lesson().slides.size() && !isOfLevel(next))
        ++next;
    return next;
}

const Question* LessonPlayer::openOrNextQuestion() const
{
    if (!isOpen() || m_place.phase == Phase::Ended)
        return nullptr;
    const std::size_t at = isAsking() ? m_place.slide : slideAfter();
    const bool isThere = at < lesson().slides.size() && lesson().slides[at].question && !answered(at);
    return isThere ? &*lesson().slides[at].question : nullptr;
}

bool LessonPlayer::willAskForEdgeValue() const
{
    if (!isOpen() || m_place.phase == Phase::Ended)
        return false;
    const auto& slides = lesson().slides;
    for (std::size_t at = m_place.slide + 1; at < slides.size(); ++at) {
        if (slides[at].moment.scene != slide().moment.scene)
            return false;
        const std::optional<Question>& question = slides[at].question;
        if (question && question->kind == QuestionKind::Number && isEdgeValue(question->answer->fact) &&
            isOfLevel(at) && !answered(at))
            return true;
    }
    return false;
}

std::vector<std::size_t> LessonPlayer::leftOut() const
{
    std::vector<std::size_t> slides;
    if (!isOpen())
        return slides;
    std::size_t at = m_place.phase == Phase::Ended ? lesson().slides.size() : m_place.slide;
    while (at > 0 && !isOfLevel(at - 1))
        slides.insert(slides.begin(), --at);
    return slides;
}

bool LessonPlayer::hasPrevious() const { return isOpen() && (m_place.slide > 0 || m_place.phase == Phase::Ended); }

void LessonPlayer::previous()
{
    if (m_place.phase == Phase::Ended) {
        show(m_place.slide, Phase::Shown);
        return;
    }
    for (std::size_t former = m_place.slide; former-- > 0;)
        if (isOfLevel(former) || former == 0) {
            goTo(former, Entry::Skips);
            return;
        }
}

void LessonPlayer::comeBack()
{
    if (isOpen())
        show(m_place.slide, isAsking() ? Phase::Asking : Phase::Shown);
}

void LessonPlayer::setLevel(int level)
{
    if (std::exchange(m_level, level) != level)
        Q_EMIT changed();
}

bool LessonPlayer::isOfLevel(std::size_t slide) const { return lesson().slides[slide].level <= m_level; }

/// The right answer is computed while the question is being thought about.
void LessonPlayer::computeAnswer()
{
    m_right.reset();
    m_key.ask(
        [lesson = m_place.lesson, index = m_place.slide](const auto&) -> std::optional<Answer> {
            const Slide& slide = lesson->slides[index];
            const OpenMomentLoad load = openMoment(slide.moment);
            if (!load.moment)
                return std::nullopt;
            MomentFacts facts(slide.moment, *load.moment);
            return answerOf(*slide.question, facts);
        },
        LatestJob::Running::Interrupt);
}

void LessonPlayer::answer(GivenAnswer given)
{
    if (!isAsking())
        return;
    m_given = std::move(given);
    if (!m_key.isBusy())
        judge();
}

void LessonPlayer::judge()
{
    Answered answered{std::exchange(m_given, std::nullopt), m_right};
    answered.isRight = m_right && isRight(*answered.given, *m_right);
    m_wantsDigits = m_right && hasTooFewDigits(*answered.given, *m_right);
    if (m_wantsDigits) {
        Q_EMIT changed();
        return;
    }
    noteRow(answered.given, answered.isRight);
    constexpr std::size_t kTries = 2;
    const bool isLastTry = slide().question->choices.size() == kTries || m_tries.size() + 1 == kTries;
    if (m_right && !answered.isRight && !isLastTry) {
        m_tries.push_back(*answered.given);
        Q_EMIT changed();
        return;
    }
    m_answered[m_place.slide] = answered;
    show(m_place.slide, Phase::Shown);
}

std::optional<PixelScore> LessonPlayer::triedPixels() const
{
    const auto* pixels = m_tries.empty() ? nullptr : std::get_if<std::vector<QPoint>>(&m_tries.back());
    const auto* right = pixels && m_right ? std::get_if<std::vector<QPoint>>(&m_right->value) : nullptr;
    return right ? std::optional(scoreOf(*pixels, *right)) : std::nullopt;
}

/// in  `given`: nothing where the question was skipped
void LessonPlayer::noteRow(const std::optional<GivenAnswer>& given, bool isRight)
{
    const auto& question = *slide().question;
    m_rows.push_back({lesson().id, m_place.slide + 1, QString::fromLatin1(questionKindId(question.kind)),
                      given ? textOf(question, *given) : QString(), m_right ? textOf(question, *m_right) : QString(),
                      isRight});
    Q_EMIT rowsChanged();
}

const LessonPlayer::Answered* LessonPlayer::answered(std::size_t slide) const
{
    const auto found = m_answered.find(slide);
    return found == m_answered.end() ? nullptr : &found->second;
}

LessonPlayer::Score LessonPlayer::score() const
{
    Score score;
    if (!isOpen())
        return score;
    for (std::size_t i = 0; i < lesson().slides.size(); ++i)
        score.questions += lesson().slides[i].question && isOfLevel(i) ? 1 : 0;
    for (const auto& [slide, answered] : m_answered) {
        score.answered += answered.given ? 1 : 0;
        score.right += answered.isRight ? 1 : 0;
    }
    return score;
}

} // namespace rasterlens
