#include "ui/lessons/lesson_mode.h"

#include "core/io/file_writer.h"
#include "ui/base/bring_to_front.h"
#include "ui/base/dock.h"
#include "ui/base/parts.h"
#include "ui/canvas/viewport_widget.h"
#include "ui/document/consents.h"
#include "ui/lessons/lesson_panel.h"
#include "ui/lessons/question_box.h"
#include "ui/lessons/texts.h"

#include <QAction>
#include <QFileDialog>
#include <QLayout>
#include <QMainWindow>
#include <QMenu>

#include <algorithm>

namespace rasterlens
{

LessonMode::LessonMode(ViewportWidget& viewport, QMainWindow& window, ActionTable& actions)
    : m_viewport(viewport), m_window(window), m_menu(new QMenu(&window)),
      m_check(
          [this](const Diagnostics& found) {
              if (!found.empty())
                  Q_EMIT reported(found);
          },
          [this](Lack lack) { Q_EMIT failed(tr("The lesson was not checked: %1.").arg(lackText(lack))); })
{
    buildMenu(actions);
    m_panel = new LessonPanel(m_player, {m_previous, m_next, m_back});
    m_dock = new Dock(QStringLiteral("lessonDock"), m_panel, &window);
    viewport.addLayer(&m_layer);
    connect(&m_player, &LessonPlayer::changed, this, &LessonMode::follow);
    connect(&m_player, &LessonPlayer::momentWanted, this, [this] { Q_EMIT momentWanted(m_player.moment()); });
    connect(&m_player, &LessonPlayer::failed, this, &LessonMode::failed);
    connect(&m_player, &LessonPlayer::rowsChanged, this, [this] {
        if (!m_answerFile.isEmpty())
            writeAnswers();
    });
    connect(m_panel, &LessonPanel::tryWanted, this, &LessonMode::tryWanted);
    connect(&m_panel->question(), &QuestionBox::markedChanged, this, [this] {
        if (m_player.isAsking())
            m_layer.setMarked(m_panel->question().marked());
        m_viewport.update();
    });
    connect(&viewport, &ViewportWidget::pixelAnswered, &m_panel->question(), &QuestionBox::togglePixel);
    connect(&m_panel->question(), &QuestionBox::leftKeys, this, [this] { m_viewport.setFocus(Qt::OtherFocusReason); });
    retranslate();
}

LessonMode::~LessonMode() { m_viewport.removeLayer(&m_layer); }

void LessonMode::buildMenu(ActionTable& table)
{
    ActionMenu menu(table, m_menu, *this, ActionSection::Lessons, QT_TR_NOOP("Less&ons"));
    m_next = menu.add("lesson.next", QT_TR_NOOP("&Next slide"), {Qt::Key_PageDown}, [this] {
        if (m_player.place().phase == LessonPlayer::Phase::Ended)
            openNext();
        else
            m_player.next();
    });
    m_previous =
        menu.add("lesson.previous", QT_TR_NOOP("&Previous slide"), {Qt::Key_PageUp}, [this] { m_player.previous(); });
    menu.table().listTogether(menu.words(QT_TR_NOOP("Next, previous slide, also by a presenter's remote")),
                              {m_next, m_previous});
    m_back = menu.add("lesson.back", QT_TR_NOOP("&Back to the lesson"), {Qt::CTRL | Qt::Key_PageUp},
                      [this] { m_player.comeBack(); });
    m_mark = menu.add("lesson.mark", QT_TR_NOOP("&Mark the selected pixel as an answer"), {Qt::Key_Insert},
                      [this] { markPixel(); });
    menu.addSeparator();
    buildLessons(menu);
    menu.addSeparator();
    m_level = menu.addToggle("lesson.level", QT_TR_NOOP("With slides for a &second look"), {}, false,
                             [this](bool on) { m_player.setLevel(on ? 2 : 1); });
    m_keep = menu.addToggle("lesson.keep-answers", QT_TR_NOOP("&Keep answers in a file (CSV, no names)\u2026"), {},
                            false, [this](bool on) {
                                if (on)
                                    chooseAnswerFile();
                                else
                                    m_answerFile.clear();
                                sync();
                            });
    m_close = menu.add("lesson.close", QT_TR_NOOP("&Close the lesson"), {}, [this] { m_player.close(); });
}

void LessonMode::buildLessons(ActionMenu menu)
{
    int number = 0;
    for (const LessonTitle& lesson : lessonTitles()) {
        ++number;
        const auto named = [&](const QString& title) { return QStringLiteral("%1  %2").arg(number).arg(title); };
        menu.add(QStringLiteral("lesson.open-%1").arg(lesson.id),
                 {.name = named(lesson.title.en), .chinese = named(lesson.title.zh)}, {},
                 [this, id = lesson.id] { open(id); });
    }
}

bool LessonMode::open(const QString& name)
{
    const auto decided = Consents::ofProgram().decided();
    const Consent consent(decided);
    LessonLoad load = loadLesson(name);
    Consents::ofProgram().tell(consent.refused());
    if (const Diagnostics remarks = withoutNotes(load.diagnostics); !remarks.empty())
        Q_EMIT reported(remarks);
    if (!load.lesson)
        return false;
    const auto lesson = std::make_shared<const Lesson>(std::move(*load.lesson));
    m_player.open(lesson);
    showDock();
    m_check.drop();
    if (!lesson->file.startsWith(QLatin1Char(':')))
        m_check.ask(
            [lesson, decided](const auto&) {
                const Consent ofCheck(decided);
                return checkSlides(*lesson);
            },
            LatestJob::Running::Interrupt);
    return true;
}

void LessonMode::showDock()
{
    if (m_isBar || !m_player.isOpen())
        return;
    bringToFront(*m_dock);
}

/// Behind the last slide comes the next lesson of the list.
void LessonMode::openNext()
{
    if (const auto next = lessonAfter(m_player.lesson().id))
        open(next->id);
}

void LessonMode::markPixel()
{
    if (m_viewport.isAnswering() && m_viewport.hoveredPixel())
        m_panel->question().togglePixel(*m_viewport.hoveredPixel());
}

/// The marks stay on the canvas until another slide is shown.
void LessonMode::follow()
{
    const auto* answered = m_player.isOpen() ? m_player.answered(m_player.place().slide) : nullptr;
    const bool isShown = m_player.place().phase == LessonPlayer::Phase::Shown;
    const auto* right =
        isShown && answered && answered->right ? std::get_if<std::vector<QPoint>>(&answered->right->value) : nullptr;
    const auto* given = answered && answered->given ? std::get_if<std::vector<QPoint>>(&*answered->given) : nullptr;
    if (right && m_player.slide().question->kind == QuestionKind::Pixels) {
        m_layer.setMarked(given ? *given : std::vector<QPoint>());
        m_layer.setRight(*right);
    } else if (!m_player.isAsking()) {
        m_layer.clear();
    }
    // What is known of pixels would answer these.
    const bool isAboutPixels = m_player.isAsking() && (m_player.slide().question->kind == QuestionKind::Pixels ||
                                                       m_player.slide().question->kind == QuestionKind::Winner);
    m_viewport.setAnswering(isAboutPixels);
    sync();
}

void LessonMode::sync()
{
    const bool isOpen = m_player.isOpen();
    m_next->setEnabled(isOpen && (m_player.hasNext() || lessonAfter(m_player.lesson().id)));
    m_previous->setEnabled(m_player.hasPrevious());
    for (QAction* action : {m_back, m_close})
        action->setEnabled(isOpen);
    m_mark->setEnabled(isOpen && m_panel->question().asksForPixels());
    m_level->setChecked(m_player.level() > 1);
    m_keep->setChecked(!m_answerFile.isEmpty());
    m_dock->setTitle(tr("Lesson"));
}

void LessonMode::setAway(bool away) { m_panel->setAway(away); }

void LessonMode::setBar(QLayout* bar)
{
    m_isBar = bar != nullptr;
    (bar ? bar : m_dock->widget()->layout())->addWidget(m_panel);
    m_panel->setBar(bar != nullptr);
    m_panel->setVisible(!bar || m_player.isOpen());
}

void LessonMode::chooseAnswerFile()
{
    auto* dialog = new QFileDialog(&m_window, tr("Keep answers in a file"));
    dialog->setObjectName(QStringLiteral("keepAnswers"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("csv"));
    dialog->setNameFilter(tr("Tables (*.csv)"));
    dialog->selectFile(QStringLiteral("answers.csv"));
    connect(dialog, &QFileDialog::fileSelected, this, &LessonMode::keepAnswers);
    dialog->open();
}

bool LessonMode::keepAnswers(const QString& path)
{
    m_answerFile = path;
    const bool written = writeAnswers();
    if (written)
        Q_EMIT message(tr("Answers are kept in %1, without names.").arg(path));
    return written;
}

bool LessonMode::writeAnswers()
{
    const auto problem = writeFile(m_answerFile, answersAsCsv(m_player.rows()), NoReader::Refuse);
    if (problem) {
        Q_EMIT failed(tr("%1: the answers cannot be written: %2").arg(m_answerFile, textOf(*problem)));
        m_answerFile.clear();
    }
    sync();
    return !problem;
}

void LessonMode::retranslate()
{
    m_panel->retranslate();
    sync();
}

} // namespace rasterlens
