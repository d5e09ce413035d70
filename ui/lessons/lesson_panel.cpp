#include "ui/lessons/lesson_panel.h"

#include "ui/base/language.h"
#include "ui/base/parts.h"
#include "ui/base/style_sheet.h"
#include "ui/lessons/question_box.h"
#include "ui/lessons/texts.h"

#include <QAction>
#include <QBoxLayout>
#include <QFontInfo>
#include <QLabel>
#include <QListWidget>
#include <QToolButton>

#include <algorithm>
#include <utility>

namespace rasterlens
{
namespace
{

constexpr int kBorder = 1; ///< of the card on which the bar lies
constexpr int kArrows = 2;
constexpr int kVerdictShare = 1000; ///< of the row's spare width, beside 1 of the gap
constexpr int kVerdictGap = 8;      ///< between the verdict of a bar and what stands beside it

QLabel* makeText(const char* name)
{
    auto* label = new QLabel;
    label->setObjectName(QLatin1String(name));
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
    return label;
}

QToolButton* makeButton(QAction* action)
{
    auto* button = new QToolButton;
    button->setObjectName(QStringLiteral("flat"));
    button->setFocusPolicy(Qt::TabFocus);
    if (action)
        button->setDefaultAction(action);
    return button;
}

} // namespace

LessonPanel::LessonPanel(LessonPlayer& player, const Actions& actions, QWidget* parent)
    : QFrame(parent), m_player(player)
{
    setObjectName(QStringLiteral("lessonPanel"));
    m_outer = new QBoxLayout(QBoxLayout::TopToBottom, this);
    m_outer->setContentsMargins(12, 4, 12, 6);
    m_outer->setSpacing(8);
    m_outer->addWidget(m_buttons = buildButtons(actions)); // above all that wraps: they stay where the mouse is
    m_title = makeText("title");
    m_outer->addWidget(m_title);
    auto* column = m_column = new QVBoxLayout;
    column->setSpacing(8);
    m_outer->addLayout(column, 1);
    m_verdict = makeText("lessonVerdict");
    m_text = makeText("lessonText");
    m_measure = makeText("lessonText");
    m_measure->setParent(this);
    m_measure->hide();
    for (QLabel* text : {m_text, m_measure}) {
        text->setTextInteractionFlags(Qt::TextSelectableByMouse);
        text->setFocusPolicy(Qt::NoFocus);
    }
    m_question = new QuestionBox;
    column->addWidget(m_verdict);
    column->addWidget(m_text);
    column->addWidget(m_question);
    column->addWidget(m_leftOut, 0, Qt::AlignLeft);
    m_score = new QLabel;
    m_score->setObjectName(QStringLiteral("muted"));
    column->addWidget(m_score);
    m_contents = new QListWidget;
    m_contents->setObjectName(QStringLiteral("lessonContents"));
    m_contents->setFrameShape(NoFrame);
    m_contents->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_contents->setTextElideMode(Qt::ElideRight);
    column->addWidget(m_contents, 1);
    column->addStretch();
    connect(m_contents, &QListWidget::itemActivated, this,
            [this] { m_player.goTo(static_cast<std::size_t>(m_contents->currentRow())); });
    connect(m_contents, &QListWidget::itemClicked, this,
            [this] { m_player.goTo(static_cast<std::size_t>(m_contents->currentRow())); });
    connect(&player, &LessonPlayer::changed, this, &LessonPanel::sync);
    connect(m_question, &QuestionBox::given, &player, &LessonPlayer::answer);
    retranslate();
}

QWidget* LessonPanel::buildButtons(const Actions& actions)
{
    auto* buttons = new QWidget;
    auto* row = m_row = new QHBoxLayout(buttons);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    for (QAction* action : {actions.previous, actions.next}) {
        QToolButton* button = makeButton(nullptr);
        button->setText(action == actions.next ? QStringLiteral("\u25b6") : QStringLiteral("\u25c0"));
        connect(button, &QToolButton::clicked, action, &QAction::trigger);
        const auto follow = [button, action] {
            button->setEnabled(action->isEnabled());
            button->setToolTip(action->toolTip());
            button->setAccessibleName(action->iconText());
        };
        connect(action, &QAction::changed, button, follow);
        follow();
        row->addWidget(button);
    }
    m_number = new QLabel;
    m_number->setObjectName(QStringLiteral("heading"));
    row->addWidget(m_number);
    row->addStretch(1);
    m_try = makeLink();
    m_try->setFocusPolicy(Qt::TabFocus);
    connect(m_try, &QToolButton::clicked, this, &LessonPanel::tryWanted);
    row->addWidget(m_try);
    m_back = makeLink();
    m_back->setFocusPolicy(Qt::TabFocus);
    connect(m_back, &QToolButton::clicked, actions.back, &QAction::trigger);
    row->addWidget(m_back);
    m_leftOut = makeLink();
    m_leftOut->setFocusPolicy(Qt::TabFocus);
    connect(m_leftOut, &QToolButton::clicked, this, [this] {
        const std::size_t first = m_player.leftOut().front();
        m_player.setLevel(2);
        m_player.goTo(first);
    });
    return buttons;
}

QString LessonPanel::text() const { return m_text->text(); }
QString LessonPanel::verdict() const { return m_verdict->text(); }

void LessonPanel::setAway(bool away)
{
    m_away = away;
    sync();
}

/// The lower end of a bar, with the buttons, stays where it is, however much there is to read above it.
void LessonPanel::setBar(bool bar)
{
    m_bar = bar;
    const QMargins around = bar ? QMargins(12, 2, 12, 3) : QMargins(12, 4, 12, 6);
    const int gap = bar ? 3 : 8;
    m_outer->setContentsMargins(around);
    m_outer->setSpacing(gap);
    m_column->setSpacing(gap);
    for (QLabel* text : {m_text, m_measure})
        setStyleProperty(*text, "bar", bar ? QStringLiteral("true") : QStringLiteral("false"));
    for (int i = 0; i < kArrows; ++i) // as high as the links beside them
        m_row->itemAt(i)->widget()->setMaximumHeight(bar ? m_try->sizeHint().height() : QWIDGETSIZE_MAX);
    m_number->setMinimumHeight(bar ? m_try->sizeHint().height() : 0);
    if (bar)
        m_row->addWidget(m_leftOut);
    else
        m_column->insertWidget(m_column->indexOf(m_score), m_leftOut, 0, Qt::AlignLeft);
    for (int i = 0; i < m_row->count(); ++i) // beside a verdict of several lines as well
        if (QWidget* part = m_row->itemAt(i)->widget(); part && part != m_verdict)
            m_row->setAlignment(part, bar ? Qt::AlignBottom : Qt::Alignment());
    m_outer->setAlignment(m_buttons, bar ? Qt::Alignment() : Qt::AlignTop);
    m_outer->setDirection(bar ? QBoxLayout::BottomToTop : QBoxLayout::TopToBottom);
    m_question->setWide(bar);
    sync();
}

void LessonPanel::retranslate()
{
    m_try->setText(tr("Try it yourself"));
    m_try->setToolTip(tr("Change anything: settings, mistakes, corners, steps. The lesson waits."));
    m_back->setText(tr("Back to the lesson"));
    m_question->retranslate();
    syncContents();
    sync();
}

void LessonPanel::sync()
{
    const bool isOpen = m_player.isOpen();
    setEnabled(isOpen);
    if (!m_player.isAsking())
        m_question->setQuestion(nullptr); // first: the row is to have at no time more than it has room for
    const bool isOpenBar = m_bar && m_player.isAsking(); // which has the room for the answer alone
    m_try->setVisible(isOpen && !m_away && !isOpenBar);
    m_back->setVisible(isOpen && m_away);
    syncLeftOut();
    m_contents->setVisible(isOpen && !m_bar);
    m_title->setVisible(isOpen && !m_bar);
    m_title->setText(isOpen ? textInUse(m_player.lesson().title) : QString());
    placeQuestion(); // before: it takes the keys
    placeVerdict();
    m_question->setQuestion(m_player.isAsking() ? &*m_player.slide().question : nullptr);
    m_question->setTries(m_player.tries());
    m_verdict->setText(!isOpen ? QString() : m_player.isAsking() ? tryText() : verdictText());
    m_verdict->setVisible(!m_verdict->text().isEmpty());
    if (!isOpen) {
        m_number->clear();
        m_score->clear();
        m_text->setText(tr("Choose a lesson in the menu Lessons."));
        syncContents();
        keepHeight();
        return;
    }
    const LessonPlayer::Place& place = m_player.place();
    m_number->setText(tr("%1 of %2").arg(place.slide + 1).arg(m_player.lesson().slides.size()));
    const LessonPlayer::Score score = m_player.score();
    m_score->setText(score.answered > 0 ? tr("%1 of %2 right").arg(score.right).arg(score.answered) : QString());
    m_score->setVisible(score.answered > 0 && !m_bar); // the end of the lesson tells it there
    const Slide& slide = m_player.slide();
    m_text->setText(m_player.isAsking() ? textInUse(slide.question->text)
                    : place.phase == LessonPlayer::Phase::Ended
                        ? endText()
                        : textInUse(textWithNumbers(slide.moment.caption, slide)));
    setStyleProperty(*m_verdict, "kind",
                     m_player.answered(place.slide) && m_player.answered(place.slide)->isRight
                         ? QStringLiteral("right")
                         : QStringLiteral("wrong"));
    syncContents();
    keepHeight();
}

/// Whether the answer is given in the row of the buttons: what is typed, or one of some short choices.
bool LessonPanel::isAnsweredInRow(const Slide& slide) const
{
    if (!m_bar || !slide.question)
        return false;
    // A question with two choices has no second try, and so no verdict beside them.
    const int verdict = slide.question->choices.size() == 2  ? 0
                        : slide.question->choices.size() > 2 ? 3 * leastVerdict() / 2
                                                             : leastVerdict();
    return m_question->rowWidth(*slide.question) + verdict <= widthBesideNumber();
}

/// In a bar a short answer stands in the row of the buttons, and longer choices stand in a row of their own.
void LessonPanel::placeQuestion()
{
    const bool isInRow = m_player.isAsking() && isAnsweredInRow(m_player.slide());
    m_question->setMinimumWidth(isInRow ? m_question->rowWidth(*m_player.slide().question) : 0);
    if (isInRow) {
        if (m_row->indexOf(m_question) < 0)
            m_row->insertWidget(m_row->indexOf(m_number) + 1, m_question, 0, Qt::AlignBottom);
    } else if (m_column->indexOf(m_question) < 0) {
        m_column->insertWidget(m_column->indexOf(m_text) + 1, m_question);
    }
}

void LessonPanel::resizeEvent(QResizeEvent* event)
{
    QFrame::resizeEvent(event);
    if (event->size().width() == event->oldSize().width())
        return;
    placeQuestion();
    placeVerdict();
    keepHeight();
}

/// A bar keeps its height from a question to its answer, whatever these say, and from slide to slide as far as that
/// leaves the picture most of the window: the picture stays where it is.
void LessonPanel::keepHeight()
{
    if (!m_bar || !m_player.isOpen()) {
        setMinimumHeight(0);
        return;
    }
    for (QWidget* part : findChildren<QWidget*>())
        part->ensurePolished(); // in the type that is measured
    if (std::exchange(m_measuredFor, &m_player.slide()) != &m_player.slide())
        m_choices = 0;
    if (m_player.isAsking() && !isAnsweredInRow(m_player.slide())) {
        m_question->balanceChoices(roomForTexts());
        m_choices = m_question->heightForWidth(roomForTexts());
    }
    constexpr double kShare = 0.15; // of the window's height; the picture has three fifths then
    int ofAll = 0;
    for (const Slide& slide : m_player.lesson().slides)
        ofAll = std::max(ofAll, heightOfTexts(slide));
    ofAll = std::min(ofAll, static_cast<int>(window()->height() * kShare));
    setMinimumHeight(std::max(heightOfTexts(m_player.slide()), ofAll));
}

/// A verdict in less than this would have too many lines.
int LessonPanel::leastVerdict() const
{
    constexpr int kLetters = 9;
    return kLetters * QFontInfo(font()).pixelSize();
}

/// In a bar the verdict stands beside the number, or above the text where there is too little room.
void LessonPanel::placeVerdict()
{
    if (m_bar && m_player.isOpen() && verdictWidth(m_player.slide(), m_player.isAsking()) >= leastVerdict()) {
        if (m_row->indexOf(m_verdict) < 0)
            m_row->insertWidget(m_row->indexOf(m_number) + 1, m_verdict, kVerdictShare);
    } else if (m_column->indexOf(m_verdict) < 0) {
        m_column->insertWidget(0, m_verdict);
    }
    const int gap = m_row->indexOf(m_verdict) < 0 ? 0 : kVerdictGap;
    m_verdict->setContentsMargins(gap, 0, gap, 0);
}

/// What the arrows and the number leave of the lower row of a bar.
int LessonPanel::widthBesideNumber() const
{
    int width = roomForTexts() - m_row->spacing();
    for (int i = 0; i <= m_row->indexOf(m_number); ++i)
        width -= m_row->itemAt(i)->sizeHint().width() + m_row->spacing();
    return width;
}

/// What is left for the verdict: while a question is open beside its field, and then beside the links, whichever of
/// them is shown.
int LessonPanel::verdictWidth(const Slide& slide, bool isOpen) const
{
    const auto with = [this](int width) { return width + m_row->spacing(); };
    if (isOpen)
        return widthBesideNumber() - (isAnsweredInRow(slide) ? with(m_question->rowWidth(*slide.question)) : 0);
    // At the end there is no verdict, and the bar keeps the height of the last slide.
    const bool hasNone = m_player.leftOut().empty() || m_player.place().phase == LessonPlayer::Phase::Ended;
    const int leftOut = hasNone ? 0 : with(m_leftOut->sizeHint().width());
    return widthBesideNumber() - with(std::max(m_try->sizeHint().width(), m_back->sizeHint().width())) - leftOut;
}

/// Before the layout has followed, the panel is as wide as it was beside the canvas.
int LessonPanel::barWidth() const { return std::max(width(), parentWidget()->contentsRect().width() - 2 * kBorder); }

int LessonPanel::roomForTexts() const
{
    const QMargins around = m_outer->contentsMargins();
    return barWidth() - around.left() - around.right();
}

/// The height of the bar's lower row with a verdict that has a width, or of the row and the verdict above the text.
int LessonPanel::heightOfRow(const QString& verdict, int width) const
{
    const bool isInRow = width >= leastVerdict();
    const QWidget* arrow = m_row->itemAt(0)->widget();
    const int row = std::max(m_try->sizeHint().height(), std::min(arrow->sizeHint().height(), arrow->maximumHeight()));
    constexpr int kSlack = 8;
    const QRect place(0, 0, (isInRow ? width : roomForTexts()) - 2 * kVerdictGap - kSlack, QWIDGETSIZE_MAX);
    const int text =
        verdict.isEmpty() ? 0 : m_verdict->fontMetrics().boundingRect(place, Qt::TextWordWrap, verdict).height();
    const int high = text + text / 8; // lines of other scripts are higher
    return isInRow ? std::max(high, row) : row + high + m_outer->spacing();
}

/// The height of the bar for a slide's question, and for its caption with what became of the answer.
int LessonPanel::heightOfTexts(const Slide& slide) const
{
    const QMargins around = m_outer->contentsMargins();
    const int gap = m_outer->spacing();
    m_measure->ensurePolished();
    m_verdict->ensurePolished();
    const auto heightOf = [&](const TwoTexts& text) {
        m_measure->setText(textInUse(text));
        return m_measure->heightForWidth(roomForTexts());
    };
    const QString verdict = slide.question ? longestVerdict(*slide.question) : QString();
    const int shown =
        heightOf(textWithNumbers(slide.moment.caption, slide)) + gap + heightOfRow(verdict, verdictWidth(slide, false));
    int asked = 0;
    if (slide.question) {
        constexpr PixelScore kUsual{10, 10, 10};
        const bool asksForPixels = slide.question->kind == QuestionKind::Pixels;
        const bool isTriedOnce = slide.question->choices.size() == 2;
        const QString tried =
            isTriedOnce ? QString() : tryAgainText(asksForPixels ? std::optional(kUsual) : std::nullopt);
        const int row = heightOfRow(tried, verdictWidth(slide, true));
        asked = heightOf(slide.question->text) + gap +
                (isAnsweredInRow(slide) ? std::max(row, m_question->rowHeight()) : row);
        // Choices that were open are measured; those of other slides are taken for one line.
        const int choices = &slide == m_measuredFor ? m_choices : 0;
        if (!isAnsweredInRow(slide))
            asked += std::max(m_question->rowHeight(), choices) + gap;
    }
    return std::max(shown, asked) + around.top() + around.bottom();
}

/// Answers that are no choices are numbers or pixels, and short.
QString LessonPanel::longestVerdict(const Question& question)
{
    QString longest = QStringLiteral("0.0000"); // four digits of what is typed
    for (const QuestionChoice& choice : question.choices)
        if (const QString text = choiceText(choice); text.size() > longest.size())
            longest = text;
    return tr("\u2717 Not quite. The answer: %1").arg(longest);
}

/// Slides for a second look are not left out without a word.
void LessonPanel::syncLeftOut()
{
    QStringList numbers; // none where no lesson is open
    for (const std::size_t slide : m_player.leftOut())
        numbers << QString::number(slide + 1);
    m_leftOut->setVisible(!numbers.isEmpty() && !(m_bar && m_player.isAsking()));
    m_leftOut->setText(tr("Second look: %1").arg(listed(numbers)));
    m_leftOut->setToolTip(tr("A first course leaves these slides out. A click shows them, here and in all lessons; the "
                             "menu Lessons leaves them out again."));
}

/// What came of the first try at the open question.
QString LessonPanel::tryText() const
{
    if (m_player.wantsDigits())
        return tr("Right so far: three digits, please.");
    if (m_player.tries().empty())
        return {};
    return tryAgainText(m_player.triedPixels());
}

QString LessonPanel::tryAgainText(const std::optional<PixelScore>& score) const
{
    const QString again = m_bar ? tr("One more try, or \u25b6.") : tr("One more try; \u25b6 shows the answer.");
    if (score)
        return pixelText(*score) + QStringLiteral(". ") + again;
    return tr("\u2717 Not quite.") + QLatin1Char(' ') + again;
}

/// How many of the pixels were found.
QString LessonPanel::pixelText(const PixelScore& score)
{
    return tr("\u2717 %1 of %2 found, %3 too many").arg(score.found).arg(score.wanted).arg(score.extra);
}

/// What became of the answer to the slide that is shown.
QString LessonPanel::verdictText() const
{
    const auto* answered = m_player.answered(m_player.place().slide);
    if (m_player.place().phase != LessonPlayer::Phase::Shown || !answered)
        return {};
    if (!answered->right)
        return answered->given ? tr("This question has no answer here.") : QString();
    const Question& question = *m_player.slide().question;
    const bool arePixels = std::holds_alternative<std::vector<QPoint>>(answered->right->value);
    const QString right = answered->right->choice ? choiceText(question.choices[*answered->right->choice])
                          : m_bar && arePixels    ? tr("the pixels marked") // one line, and no list of them
                                                  : textInUse(factInWords(answered->right->value));
    if (!answered->given)
        return tr("The answer: %1").arg(right);
    if (const auto* all = std::get_if<std::vector<QPoint>>(&answered->right->value); all && answered->isRight)
        return tr("\u2713 Right: all %1 pixels").arg(all->size()); // which the canvas marks
    if (answered->isRight)
        return tr("\u2713 Right: %1").arg(right);
    if (const auto* pixels = std::get_if<std::vector<QPoint>>(&*answered->given))
        return pixelText(scoreOf(*pixels, std::get<std::vector<QPoint>>(answered->right->value)));
    return tr("\u2717 Not quite. The answer: %1").arg(right);
}

QString LessonPanel::endText() const
{
    const LessonPlayer::Score score = m_player.score();
    QString text = tr("The lesson ends here.");
    if (score.questions > 0)
        text += QLatin1Char(' ') + tr("%1 of %2 questions answered right.").arg(score.right).arg(score.questions);
    if (const auto next = lessonAfter(m_player.lesson().id))
        text += QLatin1Char('\n') + tr("\u25b6 opens the next lesson: %1").arg(textInUse(next->title));
    return text;
}

void LessonPanel::syncContents()
{
    const QSignalBlocker quiet(m_contents);
    const std::size_t count = m_player.isOpen() ? m_player.lesson().slides.size() : 0;
    while (m_contents->count() > static_cast<int>(count))
        delete m_contents->takeItem(m_contents->count() - 1);
    for (std::size_t i = 0; i < count; ++i) {
        const Slide& slide = m_player.lesson().slides[i];
        const auto* answered = m_player.answered(i);
        const QString sign = !slide.question                 ? QString()
                             : answered && answered->isRight ? QStringLiteral("\u2713 ")
                             : answered && answered->given   ? QStringLiteral("\u2717 ")
                                                             : QStringLiteral("? ");
        // A question that is still open is not to be answered by the list.
        const bool isHidden = slide.question && !answered;
        const TwoTexts& shown = isHidden ? slide.question->text : slide.moment.caption;
        const QString level = slide.level > 1 ? tr("(second look) ") : QString();
        const QString text = QStringLiteral("%1  %2%3%4")
                                 .arg(i + 1)
                                 .arg(sign, level, firstSentence(textInUse(textWithNumbers(shown, slide))));
        auto* item = m_contents->item(static_cast<int>(i));
        if (!item)
            m_contents->addItem(item = new QListWidgetItem);
        item->setText(text);
        item->setToolTip(text);
    }
    if (m_player.isOpen())
        m_contents->setCurrentRow(static_cast<int>(m_player.place().slide));
}

} // namespace rasterlens
