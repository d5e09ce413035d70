// Lessons and moments: what connects them with the rest of the window, and what a start without arguments shows.
#include "core/lessons/lesson.h"
#include "ui/base/dock.h"
#include "ui/base/message_bar.h"
#include "ui/face/cards.h"
#include "ui/lessons/lesson_mode.h"
#include "ui/pipeline/mistake_badge.h"
#include "ui/steps/step_listing.h"
#include "ui/steps/step_mode.h"
#include "ui/truth/truth_mode.h"
#include "ui/window/main_window.h"
#include "ui/window/panel_places.h"
#include "ui/window/window_moment.h"

#include <QSettings>
#include <QTimer>

#include <utility>

namespace rasterlens
{
namespace
{

constexpr int kRoomForPanels = 1200; ///< the width of a stage on which slides open their panels

} // namespace

/// The first time the program is started it explains itself.
void MainWindow::openAtStart()
{
    QSettings memory;
    const QString key = QStringLiteral("window/greeted");
    const bool isFirst = !memory.contains(key) && !memory.contains(QStringLiteral("window/geometry"));
    memory.setValue(key, true);
    if (!isFirst || !m_lessons->open(lessonIds().first()))
        openDefaultScene();
}

/// Few can follow a million steps: after R on a large picture a small one is offered.
void MainWindow::offerSmallRecord()
{
    constexpr QSize kSmall(64, 48);
    constexpr int kManyPixels = 128 * 128;
    const QSize size = m_document.settings().size;
    if (!m_stepMode->session().isOpen() || size.width() * size.height() <= kManyPixels)
        return;
    const QSize small = size.scaled(kSmall, Qt::KeepAspectRatio).expandedTo({1, 1});
    m_message->offer(tr("Every step of %1 x %2 pixels is recorded. In a small picture each step is seen.")
                         .arg(size.width())
                         .arg(size.height()),
                     {{"recordSmall", tr("Draw at %1 x %2").arg(small.width()).arg(small.height()), [this, small] {
                           Settings next = m_document.settings();
                           next.size = small;
                           m_document.setSettings(next);
                           m_message->hide();
                       }}});
}

void MainWindow::connectLessons()
{
    m_moment = new WindowMoment({m_document, *m_viewport, *m_stepMode, *m_truth, *m_cards, *m_pipelinePanel, m_actions,
                                 [this] { return isSettled(); }, [this] { return m_look.presentation; },
                                 [this] { return !m_look.presentation || width() >= kRoomForPanels; }},
                                this);
    LessonPlayer& player = m_lessons->player();
    // A lesson that begins asks about unsaved changes; what is tried out in it comes back by Undo.
    connect(m_lessons.get(), &LessonMode::momentWanted, this, [this, &player](const Moment& moment) {
        const bool isUnderWay = m_shownPlace.lesson == player.place().lesson;
        m_moment->show(moment, isUnderWay ? Document::GivingUp::Silent : Document::GivingUp::Asks);
    });
    connect(m_lessons.get(), &LessonMode::reported, m_message, [this](const Diagnostics& diagnostics) {
        if (m_moment->isPending()) // a new scene takes former messages away
            m_lessonRemarks = diagnostics;
        else
            m_message->show(diagnostics);
    });
    connect(m_lessons.get(), &LessonMode::tryWanted, m_panels, &PanelPlaces::showScene);
    connect(&player, &LessonPlayer::changed, this, &MainWindow::keepAnswersSecret);
    connect(this, &MainWindow::settled, m_moment, &WindowMoment::finish);
    connect(m_moment, &WindowMoment::shown, this, [this, &player] {
        m_shownPlace = player.place();
        if (const Diagnostics remarks = std::exchange(m_lessonRemarks, {}); !remarks.empty())
            m_message->show(remarks);
        if (!m_look.presentation)
            QTimer::singleShot(0, m_panels, &PanelPlaces::follow); // once the bars and panels of the slide have room
        tellIfSettled();
    });
    connect(m_moment, &WindowMoment::refused, this, [this, &player] {
        player.setPlace(m_shownPlace);
        tellIfSettled();
    });
    connect(&m_document, &Document::opened, this, [this] { m_shownPlace = {}; }); // what is open now is no slide
    connect(&player, &LessonPlayer::changed, this, &MainWindow::syncStage);
    connect(&player, &LessonPlayer::changed, this, &MainWindow::syncTransport);
    connect(&m_stepMode->session(), &StepSession::openChanged, this, &MainWindow::syncTransport);
    connect(&m_truth->comparison(), &Comparison::changed, this, &MainWindow::syncCompareBar);
    connect(&m_truth->referee(), &Referee::changed, this, &MainWindow::syncCompareBar);
    connect(m_panels, &PanelPlaces::changed, this, [this] {
        if (m_look.presentation)
            syncStage();
    });
    connect(m_moment, &WindowMoment::changed, this,
            [this, &player] { m_lessons->setAway(player.isOpen() && m_moment->isChanged()); });
    m_document.setViewReader([this] { return toSessionView(m_moment->present()); });
    connect(&m_document, &Document::viewOpened, this, [this](const QJsonObject& view, const QString& file) {
        const SessionViewLoad load = sessionView(view, file);
        if (!load.diagnostics.empty())
            m_message->show(load.diagnostics);
        m_moment->showView(load.moment);
    });
    m_document.setViewKeeper([this, &player] {
        return [this, &player, moment = m_moment->present(), place = m_shownPlace] {
            m_moment->showView(moment);
            player.setPlace(place);
            m_shownPlace = place;
        };
    });
}

/// What would answer a question is not shown while it is open, nor what the lens would tell before.
void MainWindow::keepAnswersSecret()
{
    const LessonPlayer& player = m_lessons->player();
    m_mistakeBadge->setConcealed(player.isAsking() && player.slide().question->kind == QuestionKind::Mistake);
    const Question* coming = player.openOrNextQuestion();
    m_stepMode->listing().setNextPConcealed(coming && coming->kind == QuestionKind::NextP);
    const std::optional<QPoint> asked = player.askedPixel();
    LensSecret secret;
    if (asked)
        secret.pixel.emplace(asked->x(), asked->y());
    m_stepMode->setSecret(player.isAsking() || player.willAskForEdgeValue() ? std::optional(secret) : std::nullopt);
    m_cards->setSecret(asked);
    syncSoon(Words::OfPixel);
}

void MainWindow::open(const QString& name)
{
    if (!isLesson(name)) {
        m_document.open(name);
        return;
    }
    if (m_lessons->open(name))
        m_document.rememberRecent(name);
}

} // namespace rasterlens
