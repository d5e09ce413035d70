#include "ui/steps/transport_dock.h"

#include "ui/base/elided_label.h"
#include "ui/base/parts.h"
#include "ui/base/style_sheet.h"
#include "ui/base/theme.h"
#include "ui/steps/scrubber.h"
#include "ui/steps/step_listing.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QEvent>
#include <QFrame>
#include <QGraphicsOpacityEffect>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QToolButton>
#include <QVBoxLayout>

#include <array>
#include <tuple>
#include <utility>

namespace rasterlens
{
namespace
{

constexpr int kLowWindow = 580; ///< the line below the scrubber is the canvas's then
constexpr double kSpeeds[] = {0.25, 0.5, 1, 2, 4, 8, 16, 32, 64};
constexpr int kSeconds[] = {5, 10, 30, 60};

QString grouped(std::size_t number) { return QLocale(QLocale::English).toString(qulonglong(number)); }

QString speedText(double speed) { return QStringLiteral("%1\u00d7").arg(speed); }

/// Keys that a widget needs for itself while it has the focus.
bool keepsKey(const QObject* widget, int key)
{
    const bool isArrow = key == Qt::Key_Left || key == Qt::Key_Right;
    if (qobject_cast<const QAbstractItemView*>(widget) || qobject_cast<const QAbstractSlider*>(widget) ||
        qobject_cast<const QAbstractSpinBox*>(widget))
        return isArrow || key == Qt::Key_Space;
    return (qobject_cast<const QAbstractButton*>(widget) || qobject_cast<const QComboBox*>(widget)) &&
           key == Qt::Key_Space;
}

/// Says all where there is room, and leaves it to the buttons where there is none.
class NoticeLabel : public ElidedLabel
{
public:
    NoticeLabel() : ElidedLabel(QStringLiteral("stepNotice"))
    {
        setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    }
    [[nodiscard]] QSize minimumSizeHint() const override { return {kLeastWidth, sizeHint().height()}; }

private:
    static constexpr int kLeastWidth = 16;
};

} // namespace

TransportDock::TransportDock(StepSession& session, ActionTable& actions, QWidget* parent)
    : QDockWidget(parent), m_session(session), m_menu(new QMenu(this))
{
    setObjectName(QStringLiteral("transportDock"));
    buildActions(actions);
    setTitleBarWidget(buildTitleRow());
    constexpr int kRestMs = 4000;
    m_rest.setSingleShot(true);
    m_rest.setInterval(kRestMs);
    connect(&m_rest, &QTimer::timeout, this, [this] { fade(m_brief); });
    setWidget(buildBody());
    qApp->installEventFilter(this);
    connect(&session, &StepSession::openChanged, this, &TransportDock::syncLog);
    connect(&session, &StepSession::logChanged, this, &TransportDock::syncLog);
    connect(&session, &StepSession::recordingChanged, this, &TransportDock::sync);
    connect(&session, &StepSession::positionChanged, this, &TransportDock::sync);
    connect(&session, &StepSession::playbackChanged, this, [this] {
        sync();
        syncIcons();
    });
    connect(&session, &StepSession::selectionChanged, this, &TransportDock::sync);
    retranslate();
}

void TransportDock::buildActions(ActionTable& table)
{
    ActionMenu menu(table, m_menu, *this, ActionSection::Steps, QT_TR_NOOP("S&tep"));
    m_record = menu.addToggle("step.record", QT_TR_NOOP("&Record steps"), {Qt::Key_R}, false,
                              [this] { m_session.isOpen() ? m_session.close() : m_session.open(); });
    buildScopeMenu(menu.addMenu(QT_TR_NOOP("Record &what")));
    menu.addSeparator();
    m_play = menu.addToggle("step.play", QT_TR_NOOP("&Play"), {Qt::Key_Space}, false, [this] {
        m_session.open();
        m_session.setPlaying(!m_session.isPlaying());
        sync();
    });
    buildSteps(menu);
    menu.addSeparator();
    buildRunMenu(menu.addMenu(QT_TR_NOOP("Run &until")));
    buildPlayMenu(menu.addMenu(QT_TR_NOOP("Play b&y")));
    buildSpeedMenu(menu.addMenu(QT_TR_NOOP("Spee&d")));
    m_loop = menu.addToggle("step.loop", QT_TR_NOOP("&Loop"), {Qt::Key_L}, false,
                            [this] { m_session.setLooping(!m_session.isLooping()); });
}

/// Back and forth by every length of step, and to both ends.
void TransportDock::buildSteps(ActionMenu& menu)
{
    struct Step {
        const char* backId;
        const char* back;
        const char* nextId;
        const char* next;
        const char* both; ///< what the line of help for the two says
        Qt::KeyboardModifiers modifiers;
        StepLevel level;
    };
    const Step steps[] = {
        {"step.back", QT_TR_NOOP("Step &back"), "step.next", QT_TR_NOOP("&Step"), QT_TR_NOOP("One step"),
         Qt::NoModifier, StepLevel::Event},
        {"step.row-back", QT_TR_NOOP("Row back"), "step.next-row", QT_TR_NOOP("Next ro&w"), QT_TR_NOOP("One row"),
         Qt::ShiftModifier, StepLevel::Row},
        {"step.face-back", QT_TR_NOOP("Face back"), "step.next-face", QT_TR_NOOP("Next &face"), QT_TR_NOOP("One face"),
         Qt::ControlModifier, StepLevel::Face},
        {"step.stage-back", QT_TR_NOOP("Stage back"), "step.next-stage", QT_TR_NOOP("Next s&tage"),
         QT_TR_NOOP("One stage"), Qt::ControlModifier | Qt::ShiftModifier, StepLevel::Stage},
    };
    for (const Step& step : steps) {
        const auto go = [this, level = step.level](StepDirection direction) {
            return [this, level, direction] { m_session.step(level, direction); };
        };
        QAction* back = menu.add(step.backId, step.back, {step.modifiers | Qt::Key_Left}, go(StepDirection::Backward));
        QAction* next = menu.add(step.nextId, step.next, {step.modifiers | Qt::Key_Right}, go(StepDirection::Forward));
        menu.table().listTogether(menu.words(step.both), {back, next});
        m_stepActions << back << next;
    }
    m_start = menu.add("step.start", QT_TR_NOOP("To the st&art"), {Qt::CTRL | Qt::Key_Home}, [this] {
        m_session.setPlaying(false);
        m_session.moveTo(0);
    });
    m_end =
        menu.add("step.end", QT_TR_NOOP("To the &end"), {Qt::CTRL | Qt::Key_End}, [this] { m_session.moveToEnd(); });
    menu.table().listTogether(menu.words(QT_TR_NOOP("To the start, the end")), {m_start, m_end});
    m_onlyOpen = m_stepActions;
    m_onlyOpen << m_start << m_end;
}

void TransportDock::buildScopeMenu(ActionMenu menu)
{
    m_scopeMenu = menu.menu();
    const auto addScope = [&](const char* id, const char* text, StepScope scope) {
        m_scopeActions << menu.addToggle(id, text, {}, false, [this, scope] {
            if (scope == StepScope::SelectedFace) {
                m_session.whenWhole([this] { recordFaceHere(); });
                return;
            }
            if (scope == StepScope::Rectangle)
                Q_EMIT rectangleWanted();
            m_session.setScope(scope);
        });
    };
    addScope("step.record-frame", QT_TR_NOOP("The whole frame"), StepScope::Frame);
    addScope("step.record-geometry", QT_TR_NOOP("Geometry only"), StepScope::Geometry);
    addScope("step.record-coverage", QT_TR_NOOP("Coverage only"), StepScope::Coverage);
    addScope("step.record-face", QT_TR_NOOP("The face at the selected pixel"), StepScope::SelectedFace);
    addScope("step.record-view", QT_TR_NOOP("What the canvas shows"), StepScope::Rectangle);
    addScope("step.record-pixel", QT_TR_NOOP("The selected pixel"), StepScope::SelectedPixel);
}

void TransportDock::buildPlayMenu(ActionMenu menu)
{
    m_playMenu = menu.menu();
    const auto addStep = [&](const char* id, const char* text, PlayBy by) {
        m_playActions << menu.addToggle(id, text, {}, false, [this, by] {
            m_session.setPlayBy(by);
            sync();
        });
    };
    addStep("step.play-by-step", QT_TR_NOOP("Single step"), PlayBy::Event);
    addStep("step.play-by-sample", QT_TR_NOOP("Sample"), PlayBy::Sample);
    addStep("step.play-by-row", QT_TR_NOOP("Row, span"), PlayBy::Row);
    addStep("step.play-by-face", QT_TR_NOOP("Face"), PlayBy::Face);
    addStep("step.play-by-stage", QT_TR_NOOP("Stage"), PlayBy::Stage);
    menu.addSeparator();
    const auto addSeconds = [&](const char* id, const char* text, int seconds) {
        m_secondActions << menu.addToggle(id, text, {}, false, [this, seconds] {
            m_session.setSeconds(seconds);
            m_session.setPlayBy(PlayBy::Seconds);
            sync();
        });
    };
    addSeconds("step.play-in-5", QT_TR_NOOP("All of it in 5 seconds"), kSeconds[0]);
    addSeconds("step.play-in-10", QT_TR_NOOP("All of it in 10 seconds"), kSeconds[1]);
    addSeconds("step.play-in-30", QT_TR_NOOP("All of it in 30 seconds"), kSeconds[2]);
    addSeconds("step.play-in-60", QT_TR_NOOP("All of it in 60 seconds"), kSeconds[3]);
}

void TransportDock::buildRunMenu(ActionMenu menu)
{
    m_runMenu = menu.menu();
    const auto addStop = [&](const char* id, const char* text, StepStop::Kind kind) {
        QAction* action = menu.add(id, text, {}, [this, kind] { runUntil(kind); });
        m_onlyOpen << action;
        return action;
    };
    m_untilPixel = addStop("step.until-pixel", QT_TR_NOOP("This &pixel"), StepStop::Kind::Pixel);
    addStop("step.until-sign-change", QT_TR_NOOP("&Sign change"), StepStop::Kind::SignChange);
    addStop("step.until-tie", QT_TR_NOOP("&Tie"), StepStop::Kind::Tie);
    addStop("step.until-depth-fail", QT_TR_NOOP("&Depth test fails"), StepStop::Kind::DepthFail);
    addStop("step.until-clip", QT_TR_NOOP("&Clip"), StepStop::Kind::Clip);
    addStop("step.until-nan", QT_TR_NOOP("&NaN or infinity"), StepStop::Kind::NonFinite);
}

void TransportDock::buildSpeedMenu(ActionMenu menu)
{
    m_speedMenu = menu.menu();
    for (const double speed : kSpeeds) {
        QAction* action =
            menu.add(QStringLiteral("step.speed-%1").arg(speed), {.name = speedText(speed)}, {}, [this, speed] {
                m_session.setSpeed(speed);
                sync();
            });
        action->setCheckable(true);
        m_speedActions << action;
    }
    menu.addSeparator();
    const auto next = [this](double factor) { m_session.setSpeed(m_session.speed() * factor); };
    QAction* slower = menu.add("step.slower", QT_TR_NOOP("Slower"), {Qt::Key_BracketLeft}, [next] { next(0.5); });
    QAction* faster = menu.add("step.faster", QT_TR_NOOP("Faster"), {Qt::Key_BracketRight}, [next] { next(2); });
    menu.table().listTogether(menu.words(QT_TR_NOOP("Slower, faster")), {slower, faster});
}

void TransportDock::runUntil(StepStop::Kind kind)
{
    StepStop stop{kind};
    if (kind == StepStop::Kind::Pixel) {
        if (!m_session.selectedPixel())
            return;
        stop.x = m_session.selectedPixel()->x();
        stop.y = m_session.selectedPixel()->y();
    }
    m_session.runUntil(stop);
}

/// Records the face that was last at work at the selected pixel, else the present one.
void TransportDock::recordFaceHere()
{
    const auto pixel = m_session.selectedPixel();
    const auto last = pixel ? m_session.lastFaceAt(*pixel) : std::nullopt;
    m_session.selectFace(last ? last : m_session.face());
    m_session.setScope(StepScope::SelectedFace);
}

QToolButton* TransportDock::addButton(QAction* action, TransportSign sign, bool backward)
{
    auto* button = new QToolButton;
    button->setObjectName(QStringLiteral("flat"));
    button->setFocusPolicy(Qt::TabFocus); // a click leaves the keys to the canvas: Space plays
    button->setIconSize({20, 20});
    button->setFixedSize(31, 28);
    button->setStyleSheet(QStringLiteral("padding: 0;"));
    m_buttons.push_back({button, sign, backward});
    connect(button, &QToolButton::clicked, action, &QAction::trigger);
    const auto follow = [button, action] {
        button->setEnabled(action->isEnabled());
        const QString key = action->shortcut().toString(QKeySequence::NativeText);
        const QString text = withoutMnemonic(action->text());
        button->setToolTip(key.isEmpty() ? text : QStringLiteral("%1 (%2)").arg(text, key));
        button->setAccessibleName(text);
    };
    connect(action, &QAction::changed, button, follow);
    follow();
    return button;
}

QToolButton* TransportDock::addLink(QMenu* menu)
{
    QToolButton* link = makeMenuLink(menu);
    link->setFocusPolicy(Qt::TabFocus);
    return link;
}

QWidget* TransportDock::buildTitleRow()
{
    m_titleRow = new QFrame;
    m_titleRow->setObjectName(QStringLiteral("transportTitle"));
    auto* row = new QHBoxLayout(m_titleRow);
    row->setContentsMargins(12, 7, 10, 5);
    row->setSpacing(2);
    // Outward from the play button the steps grow.
    constexpr TransportSign kSigns[] = {TransportSign::Step, TransportSign::Row, TransportSign::Face,
                                        TransportSign::Stage};
    row->addWidget(addButton(m_start, TransportSign::End, true));
    for (int i = 3; i >= 0; --i)
        row->addWidget(addButton(m_stepActions[2 * i], kSigns[i], true));
    row->addWidget(addButton(m_play, TransportSign::Play, false));
    for (int i = 0; i < 4; ++i)
        row->addWidget(addButton(m_stepActions[2 * i + 1], kSigns[i], false));
    row->addWidget(addButton(m_end, TransportSign::End, false));
    row->addSpacing(10);
    m_step = new QLabel;
    m_step->setObjectName(QStringLiteral("heading"));
    row->addWidget(m_step);
    row->addSpacing(8);
    m_summary = new ElidedLabel;
    row->addWidget(m_summary, 1);
    m_notice = new NoticeLabel;
    row->addWidget(m_notice);
    row->addWidget(m_speedLink = addLink(m_speedMenu));
    row->addWidget(m_runLink = addLink(m_runMenu));
    return m_titleRow;
}

QWidget* TransportDock::buildBody()
{
    m_body = new QFrame;
    m_body->setObjectName(QStringLiteral("dockBody"));
    auto* column = new QVBoxLayout(m_body);
    column->setContentsMargins(8, 0, 8, 6);
    column->setSpacing(0);
    column->setSizeConstraint(QLayout::SetMinAndMaxSize); // room left over is the canvas's, at any size of type
    m_scrubber = new Scrubber;
    connect(m_scrubber, &Scrubber::moved, this, [this](std::size_t position) {
        m_session.setPlaying(false);
        m_session.moveTo(position);
    });
    column->addWidget(m_scrubber);
    auto* row = new QHBoxLayout;
    row->setContentsMargins(6, 0, 4, 0);
    m_legend = new QLabel;
    m_hint = new ElidedLabel;
    m_legend->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    m_hint->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    row->addWidget(m_legend);
    row->addWidget(m_hint, 1);
    row->addSpacing(6);
    row->addWidget(m_playLink = addLink(m_playMenu));
    row->addWidget(m_scopeLink = addLink(m_scopeMenu));
    column->addLayout(row);
    return m_body;
}

void TransportDock::setBrief(bool on)
{
    m_brief = on;
    auto* row = static_cast<QHBoxLayout*>(m_titleRow->layout());
    auto* column = static_cast<QVBoxLayout*>(m_body->layout());
    if (on)
        row->insertWidget(row->indexOf(m_summary), m_scrubber, 1);
    else
        column->insertWidget(0, m_scrubber);
    // Without height in place of hidden: a dock whose widget is hidden is no wider than its title needs.
    column->setSizeConstraint(on ? QLayout::SetNoConstraint : QLayout::SetMinAndMaxSize);
    column->setContentsMargins(8, 0, 8, on ? 0 : 6);
    m_body->setMinimumSize(0, 0);
    m_body->setMaximumSize(QWIDGETSIZE_MAX, on ? 0 : QWIDGETSIZE_MAX);
    row->setContentsMargins(12, on ? 1 : 7, 10, on ? 1 : 5);
    setStyleProperty(*m_titleRow, "brief", on ? QStringLiteral("true") : QStringLiteral("false"));
    fade(false);
    sync();
}

/// The room of the bar stays, so that the picture does not jump.
void TransportDock::fade(bool away)
{
    m_rest.stop();
    if (!away) {
        m_titleRow->setGraphicsEffect(nullptr);
        return;
    }
    auto* invisible = new QGraphicsOpacityEffect;
    invisible->setOpacity(0);
    m_titleRow->setGraphicsEffect(invisible);
}

void TransportDock::retranslate()
{
    syncIcons();
    setWindowTitle(tr("Steps"));
    m_runLink->setText(tr("run until \u25be"));
    const auto word = [](PipKind kind, const QString& text) {
        return QStringLiteral("<span style='color:%1'>%2</span>")
            .arg(pipColor(kind, QGuiApplication::palette()).name(), text);
    };
    m_legend->setText(QStringList{word(PipKind::Cull, tr("cull")), word(PipKind::Clip, tr("clip")),
                                  word(PipKind::Sample, tr("inside")), word(PipKind::Outside, tr("outside")),
                                  word(PipKind::Tie, tr("tie")), word(PipKind::DepthFail, tr("depth fail"))}
                          .join(QStringLiteral(" &nbsp; ")));
    sync();
}

void TransportDock::syncIcons()
{
    const QPalette colors = QGuiApplication::palette();
    const QColor ink = colors.color(QPalette::Text);
    const QColor faded = colors.color(QPalette::PlaceholderText);
    for (const Button& button : m_buttons) {
        const bool pauses = button.sign == TransportSign::Play && m_session.isPlaying();
        const TransportSign sign = pauses ? TransportSign::Pause : button.sign;
        button.widget->setIcon(transportIcon(sign, button.backward, ink, faded));
    }
}

void TransportDock::syncLog()
{
    m_scrubber->setRecord(m_session.record());
    sync();
}

QString TransportDock::stepText() const
{
    const QString all =
        m_session.isBeginning() ? tr("more than %1").arg(grouped(m_session.size())) : grouped(m_session.size());
    return tr("step %1 of %2").arg(grouped(m_session.position()), all);
}

QString TransportDock::noticeText() const
{
    if (m_session.isRecording())
        return m_session.isPutOff() ? tr("recording the rest, then on \u2026") : tr("recording \u2026");
    const auto& record = m_session.record();
    if (record && record->truncated())
        return tr("truncated at %1 events: record less").arg(grouped(record->size()));
    return {};
}

void TransportDock::syncActions()
{
    const bool open = m_session.isOpen();
    m_record->setChecked(open);
    m_play->setChecked(m_session.isPlaying());
    m_loop->setChecked(m_session.isLooping());
    for (QAction* action : std::as_const(m_onlyOpen))
        action->setEnabled(open && m_session.record());
    m_untilPixel->setEnabled(open && m_session.record() && m_session.selectedPixel());
    for (int i = 0; i < m_scopeActions.size(); ++i)
        m_scopeActions[i]->setChecked(i == int(m_session.scope()));
    for (int i = 0; i < m_playActions.size(); ++i)
        m_playActions[i]->setChecked(i == int(m_session.playBy()));
    const bool bySeconds = m_session.playBy() == PlayBy::Seconds;
    for (int i = 0; i < m_secondActions.size(); ++i)
        m_secondActions[i]->setChecked(bySeconds && kSeconds[i] == m_session.seconds());
    for (int i = 0; i < m_speedActions.size(); ++i)
        m_speedActions[i]->setChecked(kSpeeds[i] == m_session.speed());
}

QString TransportDock::playText() const
{
    const std::array by{tr("by step"), tr("by sample"), tr("by row"), tr("by face"), tr("by stage")};
    const auto i = std::size_t(m_session.playBy());
    return i < by.size() ? by[i] : tr("all in %1 s").arg(m_session.seconds());
}

void TransportDock::syncLinks()
{
    const std::array scopes{tr("whole frame"), tr("geometry"),  tr("coverage"),
                            tr("one face"),    tr("rectangle"), tr("one pixel")};
    static_assert(std::tuple_size_v<decltype(scopes)> == kStepScopes);
    const QString opens = QStringLiteral(" \u25be");
    m_scopeLink->setText(scopes[std::size_t(m_session.scope())] + opens);
    m_playLink->setText(playText() + opens);
    m_speedLink->setText(tr("speed %1 \u25be").arg(speedText(m_session.speed())));
    m_runLink->setVisible(m_session.isOpen() || m_brief); // the bar of a presentation keeps its height
    m_runLink->setEnabled(m_session.isOpen());
    m_speedLink->setVisible(m_session.isOpen() && !m_brief); // the presentation has it in its menu
    m_playLink->setVisible(m_session.isOpen() && !m_brief && !m_isLow);
    m_speedLink->setEnabled(m_session.playBy() != PlayBy::Seconds);
}

void TransportDock::sync()
{
    syncActions();
    syncLinks();
    const bool open = m_session.isOpen();
    m_step->setText(open ? stepText() : tr("Steps"));
    const std::size_t position = m_session.position();
    if (!open)
        m_summary->setText(tr("Press R or play to record every decision of this frame"));
    else if (const auto log = m_session.log())
        m_summary->setText(position == 0 ? tr("the cleared frame")
                                         : rasterlens::stepTitle(*log, m_session.positionInLog() - 1));
    else
        m_summary->clear();
    m_notice->setText(noticeText());
    m_notice->setToolTip(m_notice->text());
    m_notice->setVisible(!m_notice->text().isEmpty());
    m_summary->setVisible(!m_brief);
    const bool hasRoom = !m_brief && !m_isLow;
    m_legend->setVisible(hasRoom);
    m_scopeLink->setVisible(hasRoom);
    const bool another = m_session.record() && m_session.document().settings().algorithm == Algorithm::Tiled;
    m_hint->setText(
        another ? tr("recorded by edge equation: the same pixels as tiled")
                : tr("Space play \u00b7 \u2190 \u2192 step \u00b7 Shift row \u00b7 Ctrl face \u00b7 Ctrl+Shift stage"));
    m_hint->setVisible(hasRoom);
    m_scrubber->setPosition(position);
}

void TransportDock::changeEvent(QEvent* event)
{
    switch (event->type()) {
    case QEvent::LanguageChange:
    case QEvent::PaletteChange:
    case QEvent::StyleChange: retranslate(); break;
    default: break;
    }
    QDockWidget::changeEvent(event);
}

bool TransportDock::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == parentWidget() && event->type() == QEvent::Resize) {
        const bool isLow = parentWidget()->height() < kLowWindow;
        if (std::exchange(m_isLow, isLow) != isLow)
            sync();
    }
    if (m_brief && event->type() == QEvent::MouseMove && watched->isWidgetType()) {
        fade(false);
        m_rest.start();
    }
    if (event->type() == QEvent::ShortcutOverride && watched->isWidgetType()) {
        auto* key = static_cast<QKeyEvent*>(event);
        if (keepsKey(watched, key->key())) {
            key->accept();
            return true;
        }
    }
    return QDockWidget::eventFilter(watched, event);
}

} // namespace rasterlens
