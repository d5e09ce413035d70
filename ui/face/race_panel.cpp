#include "ui/face/race_panel.h"

#include "ui/base/flow_layout.h"
#include "ui/base/inks.h"
#include "ui/base/numbers.h"
#include "ui/base/theme.h"
#include "ui/base/turning.h"

#include <QEvent>
#include <QFontInfo>
#include <QHBoxLayout>
#include <QImage>
#include <QLabel>
#include <QPainter>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace rasterlens
{
namespace
{

constexpr int kFrameMs = 33;
constexpr int kBlinkMs = 450;
constexpr std::size_t kSecondsForAll = 10; ///< a race lasts no longer
constexpr std::size_t kFramesPerSecond = 1000 / kFrameMs;

QToolButton* button(const char* look)
{
    auto* tool = new QToolButton;
    tool->setObjectName(QLatin1String(look));
    tool->setCursor(Qt::PointingHandCursor);
    return tool;
}

} // namespace

/// The samples of one algorithm, and its counts at the right.
class RacePanel::Track : public QWidget
{
public:
    Track(RacePanel& panel, Algorithm algorithm) : m_panel(panel), m_algorithm(algorithm) { fitToType(); }

    /// The numbers have the room that they need, and the samples some beside them.
    void fitToType()
    {
        constexpr int kLeastHeight = 150;
        const double line = QFontMetricsF(textFont(0, true)).lineSpacing() + 1;
        m_numbersWidth = kNumbersLetters * QFontInfo(textFont(0)).pixelSize();
        setMinimumSize(static_cast<int>(m_numbersWidth + kGap) + kLeastSamples,
                       std::max(kLeastHeight, static_cast<int>(std::ceil(kLines * line)) + kTitleGap));
    }

protected:
    void changeEvent(QEvent* event) override
    {
        QWidget::changeEvent(event);
        if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange)
            fitToType();
    }

    void paintEvent(QPaintEvent*) override
    {
        QPainter painter(this);
        m_numbersLeft = 0;
        if (m_panel.m_race)
            paintSamples(painter);
        paintNumbers(painter);
    }

private:
    void paintNumbers(QPainter& painter)
    {
        const OperationCounts counts = m_panel.counts(m_algorithm);
        const auto covered = static_cast<std::uint64_t>(m_covered);
        painter.setFont(textFont(0, true));
        painter.setPen(palette().color(QPalette::Text));
        const double line = QFontMetricsF(painter.font()).lineSpacing() + 1;
        const QRectF box(m_numbersLeft, 0, m_numbersWidth, height());
        painter.drawText(box, Qt::AlignLeft | Qt::AlignTop,
                         m_algorithm == Algorithm::EdgeWalking ? RacePanel::tr("Edge walking")
                                                               : RacePanel::tr("Edge equation"));
        const std::pair<QString, QString> rows[] = {
            {RacePanel::tr("samples tested"), grouped(counts.candidates)},
            {RacePanel::tr("covered"), grouped(covered)},
            {RacePanel::tr("wasted"), grouped(counts.candidates - std::min(counts.candidates, covered))},
            {RacePanel::tr("additions"), grouped(counts.additions)},
            {RacePanel::tr("multiplications"), grouped(counts.multiplications)},
            {RacePanel::tr("divisions"), grouped(counts.divisions)},
        };
        double y = line + kTitleGap;
        for (const auto& [name, value] : rows) {
            const QRectF row(box.left(), y, box.width(), line);
            painter.setFont(textFont(-0.5));
            painter.setPen(palette().color(QPalette::PlaceholderText));
            painter.drawText(row, Qt::AlignLeft | Qt::AlignVCenter, name);
            painter.setFont(numberFont());
            painter.setPen(palette().color(QPalette::Text));
            painter.drawText(row, Qt::AlignRight | Qt::AlignVCenter, value);
            y += line;
        }
    }

    [[nodiscard]] QRect bounds() const
    {
        QRect all;
        for (const RaceLane* lane : {&m_panel.m_race->walking, &m_panel.m_race->equation})
            for (const RaceTick& tick : lane->ticks) {
                if (all.isNull())
                    all = QRect(tick.x, tick.y, 1, 1);
                all.setLeft(std::min(all.left(), tick.x));
                all.setRight(std::max(all.right(), tick.x));
                all.setTop(std::min(all.top(), tick.y));
                all.setBottom(std::max(all.bottom(), tick.y));
            }
        return all;
    }

    /// Draws on from where the picture is; starts again if the race or the time went back.
    void bringUpToDate()
    {
        const bool other = m_race != m_panel.m_race;
        if (other) {
            m_race = m_panel.m_race;
            m_bounds = bounds();
        }
        const std::vector<RaceTick>& ticks = m_panel.lane(m_algorithm).ticks;
        const std::size_t until = std::min(m_panel.m_tick, ticks.size());
        if (other || until < m_drawn || m_image.size() != m_bounds.size()) {
            m_image = QImage(m_bounds.size(), QImage::Format_ARGB32_Premultiplied);
            m_image.fill(Qt::transparent);
            m_drawn = 0;
            m_covered = 0;
        }
        const Inks inks = inksFor(palette());
        QColor miss = inks.minus;
        miss.setAlpha(90);
        for (; m_drawn < until; ++m_drawn) {
            const RaceTick& tick = ticks[m_drawn];
            m_image.setPixelColor(tick.x - m_bounds.x(), tick.y - m_bounds.y(), tick.covered ? inks.plus : miss);
            m_covered += tick.covered ? 1 : 0;
        }
    }

    void paintSamples(QPainter& painter)
    {
        bringUpToDate();
        if (m_bounds.isEmpty())
            return;
        const QRectF room(0, 0, width() - m_numbersWidth - kGap - 1, height() - 1);
        double side = std::min(room.width() / m_bounds.width(), room.height() / m_bounds.height());
        if (side > 1)
            side = std::min(std::floor(side), kLargestCell);
        const QRectF picture(0, 0, m_bounds.width() * side, m_bounds.height() * side);
        m_numbersLeft = picture.right() + kGap;
        painter.fillRect(picture, palette().color(QPalette::Window));
        painter.drawImage(picture, m_image);
        const auto cell = [&](int x, int y) {
            return QRectF((x - m_bounds.x()) * side, (y - m_bounds.y()) * side, side, side);
        };
        painter.setPen(QPen(palette().color(QPalette::Mid), 1));
        if (side >= kGridFrom) {
            for (int x = 0; x <= m_bounds.width(); ++x)
                painter.drawLine(QPointF(x * side, 0), QPointF(x * side, picture.height()));
            for (int y = 0; y <= m_bounds.height(); ++y)
                painter.drawLine(QPointF(0, y * side), QPointF(picture.width(), y * side));
        }
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(picture);
        paintLonely(painter, cell);
        const std::vector<RaceTick>& ticks = m_panel.lane(m_algorithm).ticks;
        if (m_drawn > 0 && m_drawn < ticks.size()) {
            const RaceTick& now = ticks[m_drawn - 1];
            const double reach = std::max(0.0, 6 - side) / 2;
            painter.setPen(QPen(palette().color(QPalette::Text), 2));
            painter.drawRect(cell(now.x, now.y).adjusted(-reach, -reach, reach, reach));
        }
    }

    /// What this algorithm alone chose blinks.
    template <class Cell>
    void paintLonely(QPainter& painter, const Cell& cell)
    {
        const auto& lonely = m_algorithm == Algorithm::EdgeWalking ? m_race->onlyWalking : m_race->onlyEquation;
        if (!m_panel.m_blink || m_drawn < m_panel.lane(m_algorithm).ticks.size())
            return;
        painter.setPen(QPen(palette().color(QPalette::Text), 2));
        painter.setBrush(palette().color(QPalette::Base));
        for (const RaceSample& sample : lonely)
            painter.drawRect(cell(sample.x, sample.y));
    }

    static constexpr int kNumbersLetters = 12; ///< what a name and its number are wide
    static constexpr int kLines = 7;
    static constexpr int kTitleGap = 3;
    static constexpr int kLeastSamples = 78;
    static constexpr double kGap = 16;
    static constexpr double kLargestCell = 32;
    static constexpr double kGridFrom = 5;

    RacePanel& m_panel;
    Algorithm m_algorithm;
    std::shared_ptr<const AlgorithmRace> m_race;
    QRect m_bounds;
    QImage m_image;
    double m_numbersLeft = 0;
    double m_numbersWidth = 0;
    std::size_t m_drawn = 0;
    std::size_t m_covered = 0;
};

RacePanel::RacePanel(FaceSelection& selection, QWidget* parent)
    : QWidget(parent), m_play(button("flat")), m_back(button("flat")), m_step(button("flat")),
      m_slider(new QSlider(Qt::Horizontal)), m_position(new QLabel), m_tracks{new Track(*this, Algorithm::EdgeWalking),
                                                                              new Track(*this, Algorithm::EdgeEquation)}
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 2, 12, 8);
    column->setSpacing(6);
    auto* head = new FlowLayout(6);
    head->addWidget(new FacePicker(selection));
    for (QToolButton* tool : {m_back, m_play, m_step})
        head->addWidget(tool);
    m_slider->setFixedWidth(150);
    head->addWidget(m_slider);
    m_position->setObjectName(QStringLiteral("muted"));
    head->addWidget(m_position);
    column->addLayout(head);
    auto* lanes = new QHBoxLayout;
    lanes->setSpacing(24);
    for (Track* track : m_tracks)
        lanes->addWidget(track, 1);
    column->addLayout(lanes, 1);
    constexpr int kBeside = 580;
    new Turning(this, kBeside, [lanes](bool beside) {
        lanes->setDirection(beside ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    });

    m_clock.setInterval(kFrameMs);
    connect(&m_clock, &QTimer::timeout, this, &RacePanel::advance);
    m_blinker.setInterval(kBlinkMs);
    connect(&m_blinker, &QTimer::timeout, this, [this] {
        m_blink = !m_blink;
        for (Track* track : m_tracks)
            track->update();
    });
    connect(m_play, &QToolButton::clicked, this, [this] { setPlaying(!isPlaying()); });
    connect(m_back, &QToolButton::clicked, this, [this] {
        setPlaying(false);
        setTick(0);
    });
    connect(m_step, &QToolButton::clicked, this, [this] {
        setPlaying(false);
        setTick(m_tick + 1);
    });
    connect(m_slider, &QSlider::valueChanged, this, [this](int value) { setTick(static_cast<std::size_t>(value)); });
    retranslate();
}

const RaceLane& RacePanel::lane(Algorithm algorithm) const
{
    return algorithm == Algorithm::EdgeWalking ? m_race->walking : m_race->equation;
}

std::size_t RacePanel::ticks() const
{
    return m_race ? std::max(m_race->walking.ticks.size(), m_race->equation.ticks.size()) : 0;
}

OperationCounts RacePanel::counts(Algorithm algorithm) const
{
    if (!m_race)
        return {};
    const RaceLane& one = lane(algorithm);
    if (m_tick >= one.ticks.size())
        return one.total;
    return m_tick == 0 ? OperationCounts{} : one.ticks[m_tick - 1].soFar;
}

void RacePanel::setRace(std::shared_ptr<const AlgorithmRace> race, Absence why)
{
    m_absence = why;
    m_race = std::move(race);
    setPlaying(false);
    m_tick = ticks();
    if (m_race && !(m_race->onlyWalking.empty() && m_race->onlyEquation.empty()))
        m_blinker.start();
    else
        m_blinker.stop();
    m_blink = true;
    sync();
}

void RacePanel::setTick(std::size_t tick)
{
    m_tick = std::min(tick, ticks());
    sync();
}

void RacePanel::setPlaying(bool playing)
{
    if (playing && m_tick >= ticks())
        m_tick = 0;
    if (playing && ticks() > 0)
        m_clock.start();
    else
        m_clock.stop();
    sync();
}

void RacePanel::advance()
{
    const std::size_t each = std::max<std::size_t>(1, ticks() / (kSecondsForAll * kFramesPerSecond));
    setTick(m_tick + each);
    if (m_tick >= ticks())
        setPlaying(false);
}

void RacePanel::sync()
{
    const QSignalBlocker blocked(m_slider);
    const std::size_t all = ticks();
    m_slider->setRange(0, static_cast<int>(all));
    m_slider->setValue(static_cast<int>(m_tick));
    for (QWidget* part : std::initializer_list<QWidget*>{m_play, m_back, m_step, m_slider})
        part->setEnabled(all > 0);
    m_play->setText(isPlaying() ? tr("Pause") : tr("Play"));
    const QString none = m_absence == Absence::TooLarge ? tr("too many samples to race: choose a smaller picture")
                                                        : tr("this face is not drawn");
    m_position->setText(all == 0 ? none : tr("sample %1 of %2").arg(grouped(m_tick), grouped(all)));
    for (Track* track : m_tracks)
        track->update();
}

void RacePanel::retranslate()
{
    m_back->setText(QStringLiteral("|\u25c0"));
    m_back->setToolTip(tr("To the start"));
    m_step->setText(tr("Step"));
    m_step->setToolTip(tr("One sample further, in both"));
    m_slider->setAccessibleName(tr("Sample of the race"));
    for (Track* track : m_tracks)
        track->setToolTip(
            tr("Blue: covered. Orange: tested in vain. What one of the two alone chose blinks at the end."));
    sync();
}

void RacePanel::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

} // namespace rasterlens
