#include "ui/statistics_panel.h"

#include "ui/numbers.h"

#include <QCoreApplication>
#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QJsonDocument>
#include <QJsonObject>
#include <QScrollArea>
#include <QVBoxLayout>

namespace rasterlens
{
namespace
{

constexpr qint64 kRateWindowMs = 1000;

#define ROW(id, title, help, member)                                                                                   \
    {                                                                                                                  \
        id, title, help, [](const Statistics& s) -> std::uint64_t { return s.member; }                                 \
    }

QString milliseconds(double ms) { return QString::number(ms, 'f', ms < 100 ? 2 : 1); }

} // namespace

StatisticsPanel::StatisticsPanel(QWidget* parent)
    : QWidget(parent),
      m_rows{
          {nullptr, QT_TRANSLATE_NOOP("StatisticsPanel", "Faces"), nullptr, nullptr},
          ROW("submitted", QT_TRANSLATE_NOOP("StatisticsPanel", "submitted"),
              QT_TRANSLATE_NOOP("StatisticsPanel", "Triangles of the scene."), faces.submitted),
          ROW("rejected", QT_TRANSLATE_NOOP("StatisticsPanel", "rejected"),
              QT_TRANSLATE_NOOP("StatisticsPanel", "Wholly outside the view volume."), faces.rejected),
          ROW("clipped", QT_TRANSLATE_NOOP("StatisticsPanel", "clipped"),
              QT_TRANSLATE_NOOP("StatisticsPanel", "Cut by at least one plane."), faces.clipped),
          ROW("created_by_clipping", QT_TRANSLATE_NOOP("StatisticsPanel", "created by clipping"),
              QT_TRANSLATE_NOOP("StatisticsPanel", "Triangles drawn for the cut faces."), faces.createdByClipping),
          ROW("culled_back", QT_TRANSLATE_NOOP("StatisticsPanel", "culled, back"),
              QT_TRANSLATE_NOOP("StatisticsPanel", "Turned away from us."), faces.culledBack),
          ROW("culled_front", QT_TRANSLATE_NOOP("StatisticsPanel", "culled, front"),
              QT_TRANSLATE_NOOP("StatisticsPanel", "Turned towards us."), faces.culledFront),
          ROW("degenerate", QT_TRANSLATE_NOOP("StatisticsPanel", "degenerate"),
              QT_TRANSLATE_NOOP("StatisticsPanel", "Without area after snapping."), faces.degenerate),
          ROW("non_finite", QT_TRANSLATE_NOOP("StatisticsPanel", "not finite"),
              QT_TRANSLATE_NOOP("StatisticsPanel", "A corner is infinite or not a number."), faces.nonFinite),
          ROW("rasterized", QT_TRANSLATE_NOOP("StatisticsPanel", "rasterized"),
              QT_TRANSLATE_NOOP("StatisticsPanel", "Faces that reached the pixels; a cut face counts once."),
              faces.rasterized),
          {nullptr, QT_TRANSLATE_NOOP("StatisticsPanel", "Pixels"), nullptr, nullptr},
          ROW("tested", QT_TRANSLATE_NOOP("StatisticsPanel", "tested"),
              QT_TRANSLATE_NOOP("StatisticsPanel", "Positions at which coverage was decided."), pixels.tested),
          ROW("covered", QT_TRANSLATE_NOOP("StatisticsPanel", "covered"),
              QT_TRANSLATE_NOOP("StatisticsPanel", "Fragments."), pixels.covered),
          ROW("depth_passed", QT_TRANSLATE_NOOP("StatisticsPanel", "depth passed"),
              QT_TRANSLATE_NOOP("StatisticsPanel", "Fragments that passed the depth test."), pixels.depthPassed),
          ROW("depth_failed", QT_TRANSLATE_NOOP("StatisticsPanel", "depth failed"),
              QT_TRANSLATE_NOOP("StatisticsPanel", "Fragments hidden behind what was there."), pixels.depthFailed),
          ROW("shaded", QT_TRANSLATE_NOOP("StatisticsPanel", "shaded"),
              QT_TRANSLATE_NOOP("StatisticsPanel", "Fragments whose colour was computed."), pixels.shaded),
          ROW("written", QT_TRANSLATE_NOOP("StatisticsPanel", "written"),
              QT_TRANSLATE_NOOP("StatisticsPanel", "Fragments stored in the image."), pixels.written),
          ROW("covered_twice", QT_TRANSLATE_NOOP("StatisticsPanel", "hit twice"),
              QT_TRANSLATE_NOOP("StatisticsPanel",
                                "Hit by both faces at the edge they share: 0 under the top-left rule."),
              pixels.coveredTwice),
      },
      m_timeRows{{QT_TRANSLATE_NOOP("StatisticsPanel", "vertices"), &StageTimes::vertex},
                 {QT_TRANSLATE_NOOP("StatisticsPanel", "geometry"), &StageTimes::geometry},
                 {QT_TRANSLATE_NOOP("StatisticsPanel", "rasterization"), &StageTimes::raster},
                 {QT_TRANSLATE_NOOP("StatisticsPanel", "frame"), &StageTimes::total}}
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 2, 12, 8);
    column->setSpacing(2);

    auto* rate = new QHBoxLayout;
    m_fps = new QLabel(QStringLiteral("\u2013"));
    m_fps->setObjectName(QStringLiteral("fps"));
    m_fpsUnit = new QLabel;
    m_fpsUnit->setObjectName(QStringLiteral("muted"));
    rate->addWidget(m_fps, 0, Qt::AlignBaseline);
    rate->addWidget(m_fpsUnit, 1, Qt::AlignBaseline);
    column->addLayout(rate);

    m_scroll = new QScrollArea;
    m_scroll->setWidgetResizable(true);
    m_scroll->setFrameShape(QFrame::NoFrame);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_scroll->setFocusPolicy(Qt::NoFocus);
    auto* content = new QWidget;
    content->setObjectName(QStringLiteral("panelContent"));
    auto* grid = new QGridLayout(content);
    grid->setContentsMargins(0, 0, 2, 0);
    grid->setHorizontalSpacing(16);
    grid->setVerticalSpacing(2);
    grid->setColumnStretch(0, 1);
    int line = 0;
    const auto addHeading = [&] {
        auto* label = new QLabel;
        label->setObjectName(QStringLiteral("heading"));
        label->setContentsMargins(0, line == 0 ? 2 : 6, 0, 0);
        grid->addWidget(label, line++, 0, 1, 2);
        return label;
    };
    const auto addRow = [&](QLabel*& name, QLabel*& value, const char* look) {
        name = new QLabel;
        name->setObjectName(QStringLiteral("muted"));
        value = new QLabel(QStringLiteral("\u2013"));
        value->setObjectName(QLatin1String(look));
        value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        value->setTextInteractionFlags(Qt::TextSelectableByMouse);
        grid->addWidget(name, line, 0);
        grid->addWidget(value, line++, 1);
    };
    for (Row& row : m_rows)
        if (row.get)
            addRow(row.name, row.value, "counter");
        else
            row.name = addHeading();
    m_timesHeading = addHeading();
    for (TimeRow& row : m_timeRows)
        addRow(row.name, row.value, "time");
    grid->setRowStretch(line, 1);
    m_scroll->setWidget(content);
    column->addWidget(m_scroll, 1);

    m_settle.setSingleShot(true);
    m_settle.setInterval(static_cast<int>(kRateWindowMs) + 100);
    connect(&m_settle, &QTimer::timeout, this, &StatisticsPanel::showTimes);
    m_clock.start();
    retranslate();
}

#undef ROW

void StatisticsPanel::setFrame(const FramePtr& frame)
{
    if (!frame->counted) {
        const qint64 now = m_clock.elapsed();
        m_finished.push_back(now);
        while (now - m_finished.front() > kRateWindowMs)
            m_finished.pop_front();
        m_times = frame->frame.times;
        showTimes();
        m_settle.start();
        return;
    }
    m_counted = frame;
    for (const Row& row : m_rows)
        if (row.get)
            row.value->setText(grouped(row.get(frame->statistics)));
    keepWideEnough();
}

/// No counter is ever cut off: the panel is as wide as its widest row.
void StatisticsPanel::keepWideEnough()
{
    constexpr int kScrollBarRoom = 12;
    const int needed = m_scroll->widget()->sizeHint().width() + kScrollBarRoom;
    if (m_scroll->minimumWidth() < needed)
        m_scroll->setMinimumWidth(needed);
}

void StatisticsPanel::setStale(bool stale)
{
    for (const Row& row : m_rows)
        if (row.get)
            row.value->setEnabled(!stale);
}

/// Counted while frames keep coming; what one frame's time allows once they stopped.
double StatisticsPanel::framesPerSecond() const
{
    constexpr std::size_t kEnough = 4;
    const qint64 now = m_clock.elapsed();
    if (m_finished.size() >= kEnough && now - m_finished.back() < kRateWindowMs &&
        m_finished.back() > m_finished.front())
        return 1000.0 * static_cast<double>(m_finished.size() - 1) /
               static_cast<double>(m_finished.back() - m_finished.front());
    return m_times.total > 0 ? 1000.0 / m_times.total : 0;
}

void StatisticsPanel::showTimes()
{
    const double rate = framesPerSecond();
    m_fps->setText(rate > 0
                       ? (rate < 10 ? QString::number(rate, 'f', 1) : grouped(static_cast<std::uint64_t>(rate + 0.5)))
                       : QStringLiteral("\u2013"));
    for (const TimeRow& row : m_timeRows)
        row.value->setText(milliseconds(m_times.*row.time));
}

QString StatisticsPanel::asJson() const
{
    if (!m_counted)
        return {};
    return QString::fromUtf8(QJsonDocument(toJson(m_counted->statistics, m_times, m_counted->settings)).toJson());
}

QString StatisticsPanel::asCsv() const
{
    if (!m_counted)
        return {};
    const QJsonObject json = toJson(m_counted->statistics, m_times, m_counted->settings);
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

QString StatisticsPanel::shown(const QString& counter) const
{
    for (const Row& row : m_rows)
        if (row.get && QLatin1String(row.id) == counter)
            return row.value->text();
    return {};
}

void StatisticsPanel::retranslate()
{
    const auto translated = [](const char* text) { return QCoreApplication::translate("StatisticsPanel", text); };
    m_fpsUnit->setText(QStringLiteral("FPS"));
    m_fpsUnit->setToolTip(translated(QT_TRANSLATE_NOOP(
        "StatisticsPanel",
        "Frames per second: counted while frames keep coming, else what the last frame's time allows.")));
    m_fps->setToolTip(m_fpsUnit->toolTip());
    m_timesHeading->setText(translated(QT_TRANSLATE_NOOP("StatisticsPanel", "Milliseconds")));
    for (const Row& row : m_rows) {
        row.name->setText(translated(row.title));
        if (!row.get)
            continue;
        row.name->setToolTip(translated(row.help));
        row.value->setToolTip(row.name->toolTip());
    }
    for (const TimeRow& row : m_timeRows) {
        row.name->setText(translated(row.title));
    }
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
