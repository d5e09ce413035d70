#include "ui/pipeline/statistics_panel.h"

#include "core/render/render.h"
#include "ui/base/elided_label.h"
#include "ui/base/numbers.h"
#include "ui/base/parts.h"
#include "ui/base/step_words.h"

#include <QCoreApplication>
#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QJsonDocument>
#include <QJsonObject>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>
#include <chrono>
#include <iterator>

namespace rasterlens
{
namespace
{

constexpr qint64 kRateWindowMs = 1000;
constexpr int kLagMs = 100; ///< counters that follow sooner are not dimmed in between

#define COUNTER(id, member)                                                                                            \
    {                                                                                                                  \
        id, [](const Settings&, const Statistics& s) -> QString { return grouped(s.member); }                          \
    }

/// A counter over the pixels of the picture.
#define MEAN(id, member)                                                                                               \
    {                                                                                                                  \
        id, [](const Settings& settings, const Statistics& s) -> QString {                                             \
            const double pixels = double(settings.size.width()) * settings.size.height();                              \
            return QString::number(double(s.member) / pixels, 'f', 2);                                                 \
        }                                                                                                              \
    }

QLabel* mutedLabel(const QString& text = {})
{
    auto* label = new QLabel(text);
    label->setObjectName(QStringLiteral("muted"));
    return label;
}

/// Three digits tell a stage's share.
QString milliseconds(double ms) { return QString::number(ms, 'f', ms < 10 ? 2 : ms < 100 ? 1 : 0); }

const QString kUnknown = QStringLiteral("\u2013");

} // namespace

std::vector<StatisticsPanel::Row> StatisticsPanel::faceRows()
{
    return {
        {QT_TRANSLATE_NOOP("StatisticsPanel", "Faces"), nullptr, {}},
        {QT_TRANSLATE_NOOP("StatisticsPanel", "submitted"),
         QT_TRANSLATE_NOOP("StatisticsPanel", "Triangles of the scene."),
         {COUNTER("submitted", faces.submitted)}},
        {QT_TRANSLATE_NOOP("StatisticsPanel", "rejected"),
         QT_TRANSLATE_NOOP("StatisticsPanel", "Wholly outside the view volume."),
         {COUNTER("rejected", faces.rejected)}},
        {QT_TRANSLATE_NOOP("StatisticsPanel", "clipped · into pieces"),
         QT_TRANSLATE_NOOP("StatisticsPanel", "Cut by at least one plane, and the triangles drawn for the cut faces."),
         {COUNTER("clipped", faces.clipped), COUNTER("created_by_clipping", faces.createdByClipping)}},
        {QT_TRANSLATE_NOOP("StatisticsPanel", "culled: back · front"),
         QT_TRANSLATE_NOOP("StatisticsPanel", "Turned away from us, and turned towards us."),
         {COUNTER("culled_back", faces.culledBack), COUNTER("culled_front", faces.culledFront)}},
        {QT_TRANSLATE_NOOP("StatisticsPanel", "no area · not finite"),
         QT_TRANSLATE_NOOP("StatisticsPanel",
                           "Without area after snapping, and with a corner that is infinite or not a number."),
         {COUNTER("degenerate", faces.degenerate), COUNTER("non_finite", faces.nonFinite)}},
        {QT_TRANSLATE_NOOP("StatisticsPanel", "rasterized"),
         QT_TRANSLATE_NOOP("StatisticsPanel", "Faces that reached the pixels; a cut face counts once."),
         {COUNTER("rasterized", faces.rasterized)}},
        {QT_TRANSLATE_NOOP("StatisticsPanel", "lines · shared"),
         QT_TRANSLATE_NOOP("StatisticsPanel",
                           "Lines drawn: those of the scene, and edges of the wireframe; and edges that were not drawn "
                           "once more because another face draws them."),
         {COUNTER("lines_drawn", lines.drawn), COUNTER("lines_shared", lines.shared)}},
    };
}

std::vector<StatisticsPanel::Row> StatisticsPanel::pixelRows()
{
    return {
        {QT_TRANSLATE_NOOP("StatisticsPanel", "Pixels"),
         nullptr,
         {},
         QT_TRANSLATE_NOOP("StatisticsPanel", "Samples, %1 a pixel")},
        {QT_TRANSLATE_NOOP("StatisticsPanel", "tested"),
         QT_TRANSLATE_NOOP("StatisticsPanel",
                           "Positions at which coverage was decided. The tiled algorithm decides for several at once."),
         {COUNTER("tested", pixels.tested)}},
        {QT_TRANSLATE_NOOP("StatisticsPanel", "covered"),
         QT_TRANSLATE_NOOP("StatisticsPanel", "Fragments."),
         {COUNTER("covered", pixels.covered)}},
        {QT_TRANSLATE_NOOP("StatisticsPanel", "depth passed"),
         QT_TRANSLATE_NOOP("StatisticsPanel", "Fragments that passed the depth test."),
         {COUNTER("depth_passed", pixels.depthPassed)}},
        {QT_TRANSLATE_NOOP("StatisticsPanel", "depth failed"),
         QT_TRANSLATE_NOOP("StatisticsPanel", "Fragments hidden behind what was there."),
         {COUNTER("depth_failed", pixels.depthFailed)}},
        {QT_TRANSLATE_NOOP("StatisticsPanel", "shaded"),
         QT_TRANSLATE_NOOP("StatisticsPanel",
                           "Fragments whose colour was computed. The tiled algorithm shades visible ones only."),
         {COUNTER("shaded", pixels.shaded)}},
        {QT_TRANSLATE_NOOP("StatisticsPanel", "written"),
         QT_TRANSLATE_NOOP("StatisticsPanel",
                           "Fragments stored in the image. The tiled algorithm stores visible ones only."),
         {COUNTER("written", pixels.written)}},
        {QT_TRANSLATE_NOOP("StatisticsPanel", "hit twice"),
         QT_TRANSLATE_NOOP("StatisticsPanel",
                           "Hit by both faces at the edge they share: 0 under the top-left rule. With multi-sampling "
                           "samples count: at 0 the masks of the two faces complement each other in every pixel."),
         {COUNTER("covered_twice", pixels.coveredTwice)}},
        {QT_TRANSLATE_NOOP("StatisticsPanel", "shaded a pixel"),
         QT_TRANSLATE_NOOP("StatisticsPanel",
                           "What is shaded, over the pixels of the picture. Super-sampling shades every sample that is "
                           "seen, multi-sampling a face once a pixel, however many samples it covers."),
         {MEAN("shaded_a_pixel", pixels.shaded)}},
        {QT_TRANSLATE_NOOP("StatisticsPanel", "covered a pixel"),
         QT_TRANSLATE_NOOP("StatisticsPanel", "What is covered, over the pixels of the picture."),
         {MEAN("covered_a_pixel", pixels.covered)}},
    };
}

#undef COUNTER
#undef MEAN

StatisticsPanel::StatisticsPanel(QWidget* parent) : QWidget(parent), m_rows(faceRows())
{
    std::ranges::move(pixelRows(), std::back_inserter(m_rows));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 2, 8, 8);
    column->setSpacing(2);
    column->addLayout(buildRate());
    m_stageTimes = new ElidedLabel(QStringLiteral("mutedSmall")); // a slow frame does not widen the window
    column->addWidget(m_stageTimes);
    m_scroll = makePanelScroll();
    m_scroll->setWidget(buildCounters());
    column->addWidget(m_scroll, 1);

    m_settle.setSingleShot(true);
    m_settle.setInterval(static_cast<int>(kRateWindowMs) + 100);
    connect(&m_settle, &QTimer::timeout, this, &StatisticsPanel::showTimes);
    m_lag.setSingleShot(true);
    m_lag.setInterval(kLagMs);
    connect(&m_lag, &QTimer::timeout, this, [this] { setStale(true); });
    m_clock.start();
    retranslate();
}

QHBoxLayout* StatisticsPanel::buildRate()
{
    auto* rate = new QHBoxLayout;
    m_fps = new QLabel(kUnknown);
    m_fps->setObjectName(QStringLiteral("fps"));
    m_fpsUnit = mutedLabel();
    m_frameTime = mutedLabel();
    rate->addWidget(m_fps, 0, Qt::AlignBaseline);
    rate->addWidget(m_fpsUnit, 1, Qt::AlignBaseline);
    rate->addWidget(m_frameTime, 0, Qt::AlignBaseline);
    return rate;
}

/// A line for every row: headings over both columns, else the name and its counters.
QWidget* StatisticsPanel::buildCounters()
{
    QWidget* content = makePanelContent();
    auto* grid = new QGridLayout(content);
    grid->setContentsMargins(0, 0, 2, 0);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(0);
    grid->setColumnStretch(0, 1);
    int line = 0;
    for (Row& row : m_rows) {
        row.name = row.counters.empty() ? new QLabel : mutedLabel();
        grid->addWidget(row.name, line, 0, 1, row.counters.empty() ? 2 : 1);
        if (row.counters.empty()) {
            row.name->setObjectName(QStringLiteral("heading"));
            row.name->setContentsMargins(0, line == 0 ? 0 : 4, 0, 0);
        } else {
            grid->addLayout(counterLine(row.counters), line, 1);
        }
        ++line;
    }
    grid->setRowStretch(line, 1);
    return content;
}

/// Right-aligned, with a dot between two.
QHBoxLayout* StatisticsPanel::counterLine(std::vector<Counter>& counters)
{
    auto* line = new QHBoxLayout;
    line->setSpacing(4);
    line->addStretch(1);
    for (Counter& counter : counters) {
        if (&counter != &counters.front())
            line->addWidget(mutedLabel(QStringLiteral("\u00b7")));
        counter.value = new QLabel(kUnknown);
        counter.value->setObjectName(QStringLiteral("counter"));
        counter.value->setTextInteractionFlags(Qt::TextSelectableByMouse);
        line->addWidget(counter.value);
    }
    return line;
}

void StatisticsPanel::setFrame(const FramePtr& frame)
{
    // Where threads and memory of the tiled algorithm were new, the counted picture tells that time, dimmed.
    if (frame->timed || frame->counted) {
        m_times = frame->frame.times;
        m_fast = frame->fast;
    }
    m_timesLag = !frame->timed;
    if (frame->counted)
        showCounters(frame);
    else
        noteFinished(frame);
    showTimes();
}

void StatisticsPanel::showCounters(const FramePtr& frame)
{
    m_counted = {frame->scene, frame->settings, frame->statistics};
    for (const Row& row : m_rows)
        for (const Counter& counter : row.counters)
            counter.value->setText(counter.text(frame->settings, frame->statistics));
    showHeadings();
    keepWideEnough();
    m_lag.stop();
    setStale(false);
}

/// `Faces · after step 120`: what moment the counters below are of.
void StatisticsPanel::showHeadings()
{
    const int samples = m_counted ? samplesPerPixel(m_counted->settings.samples) : 1;
    for (const Row& row : m_rows) {
        if (!row.counters.empty())
            continue;
        const QString title = samples > 1 && row.ofSamples != nullptr
                                  ? QCoreApplication::translate("StatisticsPanel", row.ofSamples).arg(samples)
                                  : QCoreApplication::translate("StatisticsPanel", row.title);
        row.name->setText(QStringLiteral("%1 \u00b7 %2").arg(title, momentText(m_step)));
    }
}

void StatisticsPanel::setMoment(const std::optional<std::size_t>& step)
{
    if (std::exchange(m_step, step) == step)
        return;
    showHeadings();
    Q_EMIT changed();
}

void StatisticsPanel::noteFinished(const FramePtr& frame)
{
    const qint64 now = m_clock.elapsed();
    m_finished.push_back(now);
    while (now - m_finished.front() > kRateWindowMs)
        m_finished.pop_front();
    m_settle.start();
    const bool counted = m_counted && m_counted->scene == frame->scene && m_counted->settings == frame->settings;
    if (!counted && !m_lag.isActive())
        m_lag.start();
}

void StatisticsPanel::setShown(const FramePtr& frame)
{
    if (!frame->fast)
        return;
    constexpr std::size_t kLatencies = 50;
    const std::chrono::duration<double, std::milli> latency = std::chrono::steady_clock::now() - frame->requested;
    m_latencies.push_back(latency.count());
    if (m_latencies.size() > kLatencies)
        m_latencies.pop_front();
    explainRate();
}

double StatisticsPanel::latency() const
{
    if (m_latencies.empty())
        return 0;
    std::vector<double> sorted(m_latencies.begin(), m_latencies.end());
    const auto middle = sorted.begin() + std::ptrdiff_t(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    return *middle;
}

/// No counter is ever cut off: the panel is as wide as its widest row.
void StatisticsPanel::keepWideEnough()
{
    constexpr int kScrollBarRoom = 9;
    m_scroll->widget()->layout()->activate(); // the lines within do not know of the new texts before
    const int needed = m_scroll->widget()->sizeHint().width() + kScrollBarRoom;
    m_scroll->setMinimumWidth(std::max(m_scroll->minimumWidth(), needed));
}

QSize StatisticsPanel::sizeHint() const
{
    const int scrolled = m_scroll->widget()->sizeHint().height() - m_scroll->sizeHint().height();
    return QWidget::sizeHint() + QSize(0, scrolled);
}

QSize StatisticsPanel::minimumSizeHint() const
{
    const auto culled = std::ranges::find_if(m_rows, [](const Row& row) {
        return !row.counters.empty() && QLatin1String(row.counters.front().id) == QLatin1String("culled_back");
    });
    int rows = 0;
    for (auto row = m_rows.begin(); row <= culled; ++row)
        rows += row->name->sizeHint().height();
    const QSize scroll = m_scroll->minimumSizeHint();
    return QWidget::minimumSizeHint() + QSize(0, std::max(rows + 4 - scroll.height(), 0));
}

void StatisticsPanel::setStale(bool stale)
{
    m_stale = stale;
    for (const Row& row : m_rows)
        for (const Counter& counter : row.counters)
            counter.value->setEnabled(!stale);
    showTimes();
}

/// The frames a second while they keep coming.
std::optional<double> StatisticsPanel::countedRate() const
{
    constexpr std::size_t kEnough = 4;
    const qint64 now = m_clock.elapsed();
    if (m_finished.size() < kEnough || now - m_finished.back() >= kRateWindowMs ||
        m_finished.back() <= m_finished.front())
        return std::nullopt;
    return 1000.0 * static_cast<double>(m_finished.size() - 1) /
           static_cast<double>(m_finished.back() - m_finished.front());
}

/// Counted while frames keep coming; what one frame's time allows once they stopped.
double StatisticsPanel::framesPerSecond() const
{
    return countedRate().value_or(m_times.total > 0 ? 1000.0 / m_times.total : 0);
}

void StatisticsPanel::showTimes()
{
    const double rate = framesPerSecond();
    m_fps->setText(rate > 0
                       ? (rate < 10 ? QString::number(rate, 'f', 1) : grouped(static_cast<std::uint64_t>(rate + 0.5)))
                       : kUnknown);
    m_fps->setEnabled(!m_timesLag);
    m_fpsUnit->setText(m_fast ? tr("FPS, tiled") : QStringLiteral("FPS"));
    const auto shown = [this](double ms) { return m_times.total > 0 ? milliseconds(ms) : kUnknown; };
    m_frameTime->setText(tr("%1 ms").arg(shown(m_times.total)));
    m_stageTimes->setText(tr("vertex %1 · geometry %2 · raster %3")
                              .arg(shown(m_times.vertex), shown(m_times.geometry), shown(m_times.raster)));
    Q_EMIT changed();
}

QString StatisticsPanel::brief() const
{
    // No screen shows tens of thousands of frames a second: of a tiny picture its time says more.
    constexpr double kShortMs = 1;
    const bool isShort = m_times.total > 0 && m_times.total < kShortMs && !countedRate();
    QStringList parts;
    if (m_step)
        parts << momentText(m_step);
    if (isShort)
        parts << tr("%1 ms a frame").arg(milliseconds(m_times.total));
    else if (framesPerSecond() > 0)
        parts << tr("%1 FPS").arg(m_fps->text());
    parts << tr("clipped %1 \u00b7 culled: back %2, front %3")
                 .arg(shown(QStringLiteral("clipped")), shown(QStringLiteral("culled_back")),
                      shown(QStringLiteral("culled_front")));
    return parts.join(QStringLiteral(" \u00b7 "));
}

QJsonObject StatisticsPanel::statisticsDocument() const
{
    return toJson(m_counted->statistics, m_times, m_counted->settings, withWorkers(m_counted->settings));
}

QString StatisticsPanel::asJson() const
{
    if (!m_counted)
        return {};
    return QString::fromUtf8(QJsonDocument(statisticsDocument()).toJson());
}

QString StatisticsPanel::asCsv() const
{
    if (!m_counted)
        return {};
    const QJsonObject json = statisticsDocument();
    QStringList names;
    QStringList values;
    for (const char* group : {"faces", "pixels", "milliseconds"}) {
        const QJsonObject object = json[QLatin1String(group)].toObject();
        for (auto it = object.begin(); it != object.end(); ++it) {
            names << QLatin1String(group) + QLatin1Char('_') + it.key();
            values << it.value().toVariant().toString();
        }
    }
    return names.join(QLatin1Char(',')) + QLatin1Char('\n') + values.join(QLatin1Char(',')) + QLatin1Char('\n');
}

const QLabel* StatisticsPanel::counter(const QString& id) const
{
    for (const Row& row : m_rows)
        for (const Counter& candidate : row.counters)
            if (QLatin1String(candidate.id) == id)
                return candidate.value;
    return nullptr;
}

QString StatisticsPanel::shown(const QString& id) const
{
    const QLabel* label = counter(id);
    return label ? label->text() : QString();
}

void StatisticsPanel::explainRate()
{
    QString text = tr("Frames per second: counted while frames keep coming, else what the last frame's time allows. "
                      "While the camera moves, and first where pictures take long, the tiled algorithm draws the same "
                      "picture.");
    if (!m_latencies.empty())
        text += QLatin1Char(' ') + tr("From a move to its picture on the screen: %1 ms, the median of %2.")
                                       .arg(milliseconds(latency()))
                                       .arg(m_latencies.size());
    m_fpsUnit->setToolTip(text);
    m_fps->setToolTip(text);
}

void StatisticsPanel::retranslate()
{
    const auto translated = [](const char* text) { return QCoreApplication::translate("StatisticsPanel", text); };
    explainRate();
    m_frameTime->setToolTip(tr("Time of the last frame."));
    m_stageTimes->setToolTip(tr("Milliseconds of the last frame in each part of the pipeline."));
    for (const Row& row : m_rows) {
        if (!row.counters.empty())
            row.name->setText(translated(row.title));
        if (row.help)
            row.name->setToolTip(translated(row.help));
        for (const Counter& counter : row.counters)
            counter.value->setToolTip(row.name->toolTip());
    }
    showHeadings();
    showTimes();
    m_scroll->setMinimumWidth(0);
    keepWideEnough();
}

void StatisticsPanel::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::StyleChange)
        retranslate();
    QWidget::changeEvent(event);
}

} // namespace rasterlens
