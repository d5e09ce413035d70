#include "ui/pipeline/stage_strip.h"

#include "core/settings/mistakes.h"
#include "core/settings/rules.h"
#include "ui/base/applicability.h"
#include "ui/base/numbers.h"
#include "ui/base/theme.h"

#include <QAbstractButton>
#include <QEvent>
#include <QPainter>

#include <algorithm>
#include <array>
#include <utility>

namespace rasterlens
{
namespace
{

constexpr std::array kStages{Stage::Scene, Stage::Clip,  Stage::Screen, Stage::Cull,
                             Stage::Cover, Stage::Depth, Stage::Shade,  Stage::Image};
constexpr int kChips = static_cast<int>(kStages.size());
constexpr int kSpacing = 2;
constexpr QMargins kMargins(8, 6, 8, 6);
constexpr QMargins kBriefMargins(8, 1, 8, 1);
constexpr int kWidthOfOneRow = 400; ///< two rows where there is less
constexpr int kArrowWidth = 14;
constexpr int kWidthWithArrows = 690;

/// Whether its figure is a counter of the picture.
bool isCounted(Stage stage)
{
    return stage == Stage::Clip || stage == Stage::Cull || stage == Stage::Cover || stage == Stage::Depth;
}

/// How corners are snapped: as the settings say, unless a mistake that is on overrules them.
Rules snappingRules(const Settings& settings)
{
    Rules rules;
    rules.numberType = settings.numberType;
    rules.subpixelBits = settings.subpixelBits;
    for (const QString& id : settings.mistakes)
        if (const Mistake* mistake = findMistake(id))
            mistake->apply(rules);
    return rules;
}

} // namespace

/// One stage: a name, a figure below it, and the arrow to the next.
class StageChip : public QAbstractButton
{
public:
    StageChip(QWidget* parent, bool last) : QAbstractButton(parent), m_last(last)
    {
        setCursor(Qt::PointingHandCursor);
        setFocusPolicy(Qt::TabFocus);
        setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    }

    /// The short texts are shown where the long ones have no room.
    struct Texts {
        QString name;
        QString shortName;
        QString figure;
        QString shortFigure;

        friend bool operator==(const Texts&, const Texts&) = default;
    };

    void setTexts(const Texts& texts)
    {
        if (texts == m_texts)
            return;
        m_texts = texts;
        setText(texts.name);
        setAccessibleDescription(texts.figure);
        setToolTip(QStringLiteral("%1: %2").arg(texts.name, texts.figure));
        update();
    }

    void setBrief(bool brief)
    {
        m_brief = brief;
        updateGeometry();
        update();
    }

    [[nodiscard]] bool isBrief() const { return m_brief; }

    void setMarked(bool on)
    {
        if (std::exchange(m_marked, on) != on)
            update();
    }

    /// The figure as it is drawn.
    [[nodiscard]] QString shownFigure() const
    {
        return fitting(box().width(), figureFont(), {m_texts.figure, m_texts.shortFigure}).text;
    }

    QSize sizeHint() const override
    {
        if (m_brief)
            return {96, QFontMetrics(nameFont()).height() + 2};
        return {96, QFontMetrics(nameFont()).height() + QFontMetrics(figureFont()).height() + 12};
    }

protected:
    void paintEvent(QPaintEvent*) override
    {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        const QRectF box = this->box();
        painter.setPen(
            QPen(hasFocus() || underMouse() ? palette().color(QPalette::Highlight) : palette().color(QPalette::Mid),
                 hasFocus() ? 2 : 1));
        painter.setBrush(palette().color(m_marked ? QPalette::Highlight : QPalette::AlternateBase));
        painter.drawRoundedRect(box, 6, 6);

        const QRectF upper(box.left(), box.top() + (m_brief ? 0.5 : 5), box.width(),
                           QFontMetricsF(nameFont()).height());
        const QRectF lower(box.left(), upper.bottom() + 1, box.width(), QFontMetricsF(figureFont()).height());
        painter.setPen(palette().color(m_marked ? QPalette::HighlightedText : QPalette::Text));
        drawFitting(painter, upper, nameFont(), {m_texts.name, m_texts.shortName});
        if (!m_marked)
            painter.setPen(palette().color(QPalette::PlaceholderText));
        if (!m_brief)
            drawFitting(painter, lower, figureFont(), {m_texts.figure, m_texts.shortFigure});

        if (hasWideArrow()) {
            painter.setPen(QPen(palette().color(QPalette::PlaceholderText), 1.5));
            const QPointF tip(width() - 4.5, box.center().y());
            painter.drawLine(tip, tip + QPointF(-4, -4));
            painter.drawLine(tip, tip + QPointF(-4, 4));
        }
    }

private:
    static QFont nameFont() { return textFont(0, true); }
    static QFont figureFont() { return textFont(-1); }

    /// Where the stage is drawn: the arrow to the next one lies behind.
    [[nodiscard]] QRectF box() const
    {
        const int arrow = m_last ? 0 : hasWideArrow() ? kArrowWidth : 5;
        return QRectF(rect()).adjusted(0.5, 0.5, -0.5 - arrow, -0.5);
    }
    [[nodiscard]] bool hasWideArrow() const { return !m_last && parentWidget()->width() >= kWidthWithArrows; }

    struct Fitting {
        QString text;
        QFont font;
    };
    /// The first of the texts that fits; the last one is narrowed until it does, and ends in dots where it still does
    /// not.
    static Fitting fitting(double width, QFont font, const QStringList& texts)
    {
        constexpr double kPadding = 4;
        const double room = width - kPadding;
        QString text = texts.last();
        for (const QString& candidate : texts)
            if (QFontMetricsF(font).horizontalAdvance(candidate) <= room) {
                text = candidate;
                break;
            }
        const double needed = QFontMetricsF(font).horizontalAdvance(text);
        if (needed > room)
            font.setPointSizeF(std::max(font.pointSizeF() * room / needed, font.pointSizeF() * 0.75));
        return {QFontMetricsF(font).elidedText(text, Qt::ElideRight, width), font};
    }

    static void drawFitting(QPainter& painter, const QRectF& box, const QFont& font, const QStringList& texts)
    {
        const Fitting fits = fitting(box.width(), font, texts);
        painter.setFont(fits.font);
        painter.drawText(box, Qt::AlignCenter, fits.text);
    }

    Texts m_texts;
    bool m_last;
    bool m_marked = false;
    bool m_brief = false;
};

QString stageTitle(Stage stage)
{
    switch (stage) {
    case Stage::Scene: return StageStrip::tr("Model");
    case Stage::Clip: return StageStrip::tr("Clip space");
    case Stage::Screen: return StageStrip::tr("Screen");
    case Stage::Cull: return StageStrip::tr("Cull");
    case Stage::Cover: return StageStrip::tr("Cover");
    case Stage::Depth: return StageStrip::tr("Depth");
    case Stage::Shade: return StageStrip::tr("Shade");
    case Stage::Image: return StageStrip::tr("Image");
    }
    return {};
}

StageStrip::StageStrip(QWidget* parent) : QWidget(parent)
{
    QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Preferred);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    for (const Stage stage : kStages) {
        auto* chip = new StageChip(this, stage == kStages.back());
        chip->setObjectName(QStringLiteral("stage%1").arg(static_cast<int>(stage)));
        connect(chip, &QAbstractButton::clicked, this, [this, stage] { Q_EMIT stageClicked(stage); });
        m_chips.push_back(chip);
    }
    updateTexts();
}

void StageStrip::setBrief(bool brief)
{
    for (StageChip* chip : m_chips)
        chip->setBrief(brief);
    updateGeometry();
    resizeEvent(nullptr);
}

int StageStrip::chipsInARow(int width) { return width >= kWidthOfOneRow ? kChips : kChips / 2; }

int StageStrip::heightForWidth(int width) const
{
    const int rows = kChips / chipsInARow(width);
    const QMargins margins = m_chips.front()->isBrief() ? kBriefMargins : kMargins;
    return rows * m_chips.front()->sizeHint().height() + (rows - 1) * kSpacing + margins.top() + margins.bottom();
}

QSize StageStrip::sizeHint() const { return {kChips * 96, heightForWidth(kWidthOfOneRow)}; }

QSize StageStrip::minimumSizeHint() const { return {kWidthOfOneRow / 2, heightForWidth(kWidthOfOneRow)}; }

void StageStrip::resizeEvent(QResizeEvent*)
{
    const QRect room = rect().marginsRemoved(m_chips.front()->isBrief() ? kBriefMargins : kMargins);
    const int inARow = chipsInARow(width());
    const int height = m_chips.front()->sizeHint().height();
    for (int i = 0; i < kChips; ++i) {
        const auto edge = [&](int column) { return room.left() + column * (room.width() + kSpacing) / inARow; };
        const int left = edge(i % inARow);
        m_chips[static_cast<std::size_t>(i)]->setGeometry(left, room.top() + i / inARow * (height + kSpacing),
                                                          edge(i % inARow + 1) - kSpacing - left, height);
    }
}

void StageStrip::setScene(const Scene& scene)
{
    m_faceCount = scene.mesh.faceCount();
    m_counted.reset();
    updateTexts();
}

void StageStrip::setSettings(const Settings& settings)
{
    m_settings = settings;
    updateTexts();
}

void StageStrip::setFrame(const FramePtr& frame)
{
    if (!frame->counted)
        return;
    m_counted = frame->statistics;
    updateTexts();
}

void StageStrip::setCurrent(std::optional<Stage> stage)
{
    m_current = stage;
    for (std::size_t i = 0; i < m_chips.size(); ++i)
        m_chips[i]->setMarked(stage == kStages[i]);
}

QString StageStrip::figure(Stage stage) const
{
    if (!m_counted && isCounted(stage))
        return QStringLiteral("\u2013");
    const Statistics counts = m_counted.value_or(Statistics{});
    const auto shading = findSettingsField(QStringLiteral("shading"));
    switch (stage) {
    case Stage::Scene: return m_faceCount == 1 ? tr("1 face") : tr("%1 faces").arg(grouped(m_faceCount));
    case Stage::Clip: return tr("%1 cut").arg(grouped(counts.faces.clipped));
    case Stage::Screen: {
        const Rules rules = snappingRules(m_settings);
        return rules.numberType == NumberType::Fixed ? tr("snapped 1/%1").arg(1 << rules.subpixelBits)
                                                     : tr("not snapped");
    }
    case Stage::Cull: return tr("%1 culled").arg(grouped(counts.faces.culledBack + counts.faces.culledFront));
    case Stage::Cover:
        return m_settings.samples == Samples::One ? tr("%1 px").arg(grouped(counts.pixels.covered))
                                                  : tr("%1 samples").arg(grouped(counts.pixels.covered));
    case Stage::Depth: return tr("%1 pass").arg(grouped(counts.pixels.depthPassed));
    case Stage::Shade: return valueTitle(*shading, m_settings);
    case Stage::Image: return QStringLiteral("%1 \u00d7 %2").arg(m_settings.size.width()).arg(m_settings.size.height());
    }
    return {};
}

QString StageStrip::shown(Stage stage) const
{
    const auto at = std::ranges::find(kStages, stage) - kStages.begin();
    return m_chips[static_cast<std::size_t>(at)]->shownFigure();
}

QString StageStrip::shortFigure(Stage stage) const
{
    if (!m_counted && isCounted(stage))
        return figure(stage);
    const Statistics counts = m_counted.value_or(Statistics{});
    switch (stage) {
    case Stage::Scene: return shortened(m_faceCount);
    case Stage::Clip: return shortened(counts.faces.clipped);
    case Stage::Screen: {
        const Rules rules = snappingRules(m_settings);
        return rules.numberType == NumberType::Fixed ? QStringLiteral("1/%1").arg(1 << rules.subpixelBits)
                                                     : tr("no snap", "short for not snapped");
    }
    case Stage::Cull: return shortened(counts.faces.culledBack + counts.faces.culledFront);
    case Stage::Cover: return shortened(counts.pixels.covered);
    case Stage::Depth: return shortened(counts.pixels.depthPassed);
    case Stage::Image: return figure(stage).remove(QLatin1Char(' '));
    case Stage::Shade: break;
    }
    return figure(stage);
}

/// What cannot be seen waits until it is shown.
void StageStrip::updateTexts()
{
    m_textsAreOld = !isVisible();
    if (m_textsAreOld)
        return;
    for (const Stage stage : kStages) {
        const QString shortName = stage == Stage::Clip ? tr("Clip", "short for clip space") : stageTitle(stage);
        m_chips[static_cast<std::size_t>(stage)]->setTexts(
            {stageTitle(stage), shortName, figure(stage), shortFigure(stage)});
    }
}

void StageStrip::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    if (m_textsAreOld)
        updateTexts();
}

void StageStrip::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        updateTexts();
    if (event->type() == QEvent::FontChange || event->type() == QEvent::ApplicationFontChange) {
        updateGeometry();
        resizeEvent(nullptr);
    }
    QWidget::changeEvent(event);
}

} // namespace rasterlens
