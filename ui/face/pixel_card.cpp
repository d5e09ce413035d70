#include "ui/face/pixel_card.h"

#include "core/observe/step_text.h"
#include "core/settings/depth_rules.h"
#include "ui/base/inks.h"
#include "ui/base/language.h"
#include "ui/base/numbers.h"
#include "ui/base/parts.h"
#include "ui/base/step_words.h"
#include "ui/base/theme.h"
#include "ui/canvas/texel_plate.h"
#include "ui/face/clip_theatre.h"
#include "ui/face/sample_rows.h"

#include <QEvent>
#include <QFrame>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QScrollArea>
#include <QVBoxLayout>

#include <functional>
#include <utility>

namespace rasterlens
{
namespace
{

constexpr std::size_t kMostRows = 100;

QString signedText(const QString& number)
{
    if (number.startsWith(QLatin1Char('-')))
        return QChar(0x2212) + number.mid(1);
    return number == QLatin1String("0") ? number : QLatin1Char('+') + number;
}

QString edgeText(const WhyFace& face, const WhyEdge& edge)
{
    return QStringLiteral("E_%1\u00a0=\u00a0%2")
        .arg(edge.name, signedText(edgeValueText(edge.value, face.unitsPerArea)));
}

/// The value where there is little room: rounded if it is long. All of its digits stand in the list of the edges.
QString briefEdgeText(const WhyFace& face, const WhyEdge& edge)
{
    constexpr qsizetype kShort = 10;
    if (edgeValueText(edge.value, face.unitsPerArea).size() <= kShort)
        return edgeText(face, edge);
    return QStringLiteral("E_%1\u00a0\u2248\u00a0%2")
        .arg(edge.name, signedText(shortNumber(edge.value / face.unitsPerArea)));
}

QString sideText(EdgeSide side)
{
    switch (side) {
    case EdgeSide::Left: return PixelCard::tr("left edge");
    case EdgeSide::Top: return PixelCard::tr("top edge");
    case EdgeSide::Neither: break;
    }
    return PixelCard::tr("neither left nor top");
}

QString printedDepthSign(const WhyReport& report, const WhyFace& face)
{
    return printedSigns(QLatin1String(depthSign(report.rules, face.face)));
}

QString planesWords(std::uint32_t planes) { return planes == 0 ? PixelCard::tr("no plane") : planeSigns(planes); }

QString verdictWords(const WhyReport& report, const WhyFace& face)
{
    switch (face.verdict) {
    case WhyVerdict::NonFinite: return PixelCard::tr("dropped: a corner is not a finite number");
    case WhyVerdict::Rejected: return PixelCard::tr("rejected by %1").arg(planesWords(face.planes));
    case WhyVerdict::CulledBack: return PixelCard::tr("culled: back face");
    case WhyVerdict::CulledFront: return PixelCard::tr("culled: front face");
    case WhyVerdict::Degenerate:
        return !face.facing || face.facing->screenArea == 0
                   ? PixelCard::tr("no area on the screen")
                   : PixelCard::tr("its area on the screen, %1, counts as none")
                         .arg(shortNumber(face.facing->screenArea / 2));
    case WhyVerdict::ClippedAway: return PixelCard::tr("clipped away by %1").arg(planesWords(face.planes));
    case WhyVerdict::OutsideEdge: {
        if (const Rules pass = passRules(report.rules, face.face); !pass.coversByCentres())
            return pass.fill == Fill::Points  ? PixelCard::tr("no corner of it is drawn here")
                   : pass.fill == Fill::Solid ? PixelCard::tr("no column of it is filled here")
                                              : PixelCard::tr("no line of it is drawn here");
        if (face.edge < 0)
            return PixelCard::tr("outside of what clipping left");
        const WhyEdge& edge = face.edges[static_cast<std::size_t>(face.edge)];
        if (report.rules.coverageRule != CoverageRule::Centre)
            return (report.rules.coverageRule == CoverageRule::Inner
                        ? PixelCard::tr("%1, a part of the square is outside")
                        : PixelCard::tr("%1, the whole square is outside"))
                .arg(briefEdgeText(face, edge));
        const bool isPositive = edge.value > 0; // some mistakes want more than that
        return isPositive ? PixelCard::tr("%1, less than %2, outside")
                                .arg(briefEdgeText(face, edge), thresholdText(edge.threshold, face.unitsPerArea))
                          : PixelCard::tr("%1, outside").arg(briefEdgeText(face, edge));
    }
    case WhyVerdict::LostTie: {
        const WhyEdge& edge = face.edges[static_cast<std::size_t>(face.edge)];
        return PixelCard::tr("%1, lost the tie: %2").arg(briefEdgeText(face, edge), sideText(edge.side));
    }
    case WhyVerdict::Hole:
        return PixelCard::tr("cut out by the alpha test: the texture is opaque by %1").arg(face.opacity, 0, 'g', 3);
    case WhyVerdict::FailedDepth:
        return face.fragment ? PixelCard::tr("failed depth: not %1 %2 %3")
                                   .arg(depthNumber(face.fragment->depth), printedDepthSign(report, face),
                                        depthNumber(face.fragment->storedDepth))
                             : PixelCard::tr("covered, but not drawn by this algorithm");
    case WhyVerdict::Written:
        return face.overwrittenBy ? PixelCard::tr("written, overwritten later by face %1").arg(*face.overwrittenBy)
                                  : PixelCard::tr("written: what you see");
    }
    return {};
}

QString edgesLine(const WhyFace& face)
{
    QStringList parts;
    for (const WhyEdge& edge : face.edges)
        parts << edgeText(face, edge);
    return parts.join(QStringLiteral("\u00a0\u00a0 "));
}

QString areaLine(const WhyFace& face)
{
    return PixelCard::tr("%1 % of the pixel's area").arg(100 * face.area, 0, 'f', 1);
}

QString rgbText(std::uint32_t color)
{
    const QColor c{QRgb(color)};
    return QStringLiteral("(%1,\u00a0%2,\u00a0%3)").arg(c.red()).arg(c.green()).arg(c.blue());
}

/// `texel (12.3, 40.1) of 64 x 64; right (0.5, 0), down (0, 2); level 1`
QString texelLine(const TexelFootprint& texels)
{
    const auto pair = [](const glm::dvec2& v) {
        return QStringLiteral("(%1, %2)")
            .arg(shortNumber(v.x), shortNumber(v.y))
            .replace(QLatin1Char('-'), QChar(0x2212));
    };
    return PixelCard::tr("texel %1 of %2 x %3; right %4, down %5; mip level %6")
        .arg(pair(texels.place))
        .arg(texels.size.width())
        .arg(texels.size.height())
        .arg(pair(texels.right), pair(texels.down), shortNumber(texels.level));
}

void addFragmentLines(const WhyReport& report, const WhyFace& face, QStringList& lines)
{
    const FragmentStep& fragment = *face.fragment;
    const auto weights = [](const Weights& w) {
        return QStringLiteral("\u03b1 %1  \u03b2 %2  \u03b3 %3")
            .arg(w[0], 0, 'f', 4)
            .arg(w[1], 0, 'f', 4)
            .arg(w[2], 0, 'f', 4);
    };
    lines << weights(fragment.screen);
    if (fragment.shaded && fragment.weights != fragment.screen)
        lines << PixelCard::tr("perspective %1").arg(weights(fragment.weights));
    const QString sign = printedDepthSign(report, face);
    if (face.texels) {
        lines << texelLine(*face.texels);
        lines += texelWords(*face.texels);
    }
    if (!sign.isEmpty() && face.verdict == WhyVerdict::Written)
        lines << PixelCard::tr("z %1 %2 %3, passed")
                     .arg(depthNumber(fragment.depth), sign, depthNumber(fragment.storedDepth));
}

/// A frame that is clicked as a whole, also by key.
class ClickableRow : public QFrame
{
public:
    explicit ClickableRow(std::function<void()> run) : m_run(std::move(run))
    {
        setObjectName(QStringLiteral("whyRow"));
        setFocusPolicy(Qt::TabFocus);
        setCursor(Qt::PointingHandCursor);
    }

protected:
    void mouseReleaseEvent(QMouseEvent* event) override
    {
        if (event->button() == Qt::LeftButton && rect().contains(event->pos()))
            m_run();
    }
    void keyPressEvent(QKeyEvent* event) override
    {
        if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
            m_run();
        else
            QFrame::keyPressEvent(event);
    }

private:
    std::function<void()> m_run;
};

class Swatch : public QWidget
{
public:
    Swatch(std::uint32_t color, int side) : m_color(QRgb(color)) { setFixedSize(side, side); }

protected:
    void paintEvent(QPaintEvent*) override
    {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(palette().color(QPalette::Mid));
        painter.setBrush(m_color);
        painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), width() / 6.0, width() / 6.0);
    }

private:
    QColor m_color;
};

/// The footprint of the pixel in the texture.
class TexelDrawing : public QWidget
{
public:
    explicit TexelDrawing(const TexelFootprint& footprint) : m_footprint(footprint)
    {
        constexpr int kHeight = 150;
        setFixedHeight(kHeight);
        setAccessibleName(texelWords(footprint).join(QLatin1Char('\n')));
    }

protected:
    void paintEvent(QPaintEvent*) override
    {
        QPainter painter(this);
        paintTexels(painter, QRectF(rect()), m_footprint);
    }

private:
    TexelFootprint m_footprint;
};

/// A triangle, with the line of the `f` in the scene's file that it is a part of.
QString faceName(std::uint32_t face, std::int32_t line)
{
    return line > 0 ? PixelCard::tr("face %1, line %2").arg(face).arg(line) : PixelCard::tr("face %1").arg(face);
}

QLabel* wrapped(const QString& text, const char* look = "")
{
    auto* label = new QLabel(text);
    label->setObjectName(QLatin1String(look));
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    return label;
}

/// Which samples of the pixel a face covers.
QString maskLine(const WhyReport& report, const WhyFace& face)
{
    QStringList numbers;
    for (int sample = 0; sample < report.rules.patternSamples; ++sample)
        if ((face.coveredSamples >> sample & 1U) != 0)
            numbers << QString::number(sample + 1);
    return numbers.isEmpty() ? PixelCard::tr("covers none of %1 samples").arg(report.rules.patternSamples)
                             : PixelCard::tr("covers %1 of %2 samples: %3")
                                   .arg(numbers.size())
                                   .arg(report.rules.patternSamples)
                                   .arg(listed(numbers));
}

} // namespace

WhyWords whyWords(const WhyReport& report, const WhyFace& face)
{
    WhyWords words{
        face.face, faceName(face.face, face.line), face.verdict == WhyVerdict::Written, verdictWords(report, face), {}};
    const bool culled = face.verdict == WhyVerdict::CulledBack || face.verdict == WhyVerdict::CulledFront;
    if (culled && face.facing)
        words.details << PixelCard::tr("%1 %2").arg(face.facing->by == Facing::ScreenArea
                                                        ? PixelCard::tr("screen area")
                                                        : QLatin1String(facingId(face.facing->by)),
                                                    signedText(shortNumber(face.facing->value)));
    if (face.hasEdges)
        words.details << edgesLine(face);
    if (hasPartOfPixel(face))
        words.details << areaLine(face);
    if (face.hasEdges && report.rules.multiSampled())
        words.details << maskLine(report, face);
    if (face.hasEdges && report.rules.coverageRule == CoverageRule::Centre && face.verdict >= WhyVerdict::FailedDepth)
        for (const WhyEdge& edge : face.edges)
            if (edge.value == 0)
                words.details << PixelCard::tr("won the tie on %1: %2").arg(edge.name, sideText(edge.side));
    if (face.fragment)
        addFragmentLines(report, face, words.details);
    if (face.verdict == WhyVerdict::Written)
        words.details
            << PixelCard::tr("%1 over %2").arg(rgbText(face.write.after.color), rgbText(face.write.before.color));
    if (!face.because.empty())
        words.details << becauseWords(face.because);
    return words;
}

QString whyAnswer(const WhyReport& report)
{
    return report.visibleFace
               ? PixelCard::tr("%1 is seen").arg(faceName(*report.visibleFace, report.lineOf(*report.visibleFace)))
               : PixelCard::tr("background: no face was written");
}

PixelCard::PixelCard(QWidget* parent) : QWidget(parent)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 4);
    m_scroll = makePanelScroll();
    column->addWidget(m_scroll);
    m_rebuildSoon.setSingleShot(true);
    m_rebuildSoon.setInterval(0);
    connect(&m_rebuildSoon, &QTimer::timeout, this, &PixelCard::rebuild);
    rebuild();
}

void PixelCard::setReport(std::shared_ptr<const WhyReport> report)
{
    m_report = std::move(report);
    rebuild();
}

QString PixelCard::title() const
{
    if (!m_report)
        return tr("Why this pixel?");
    return tr("Why pixel (%1, %2)?").arg(m_report->x).arg(m_report->y);
}

void PixelCard::setSaysMoment(bool on)
{
    if (m_saysMoment == on)
        return;
    m_saysMoment = on;
    rebuild();
}

QString PixelCard::answer() const
{
    const QString seen = whyAnswer(*m_report);
    return m_saysMoment ? seen + QStringLiteral(" \u00b7 ") + momentText(std::nullopt) : seen;
}

QString PixelCard::asText() const
{
    if (!m_report)
        return {};
    QStringList lines{QStringLiteral("%1  %2").arg(title(), colorText(m_report->color))};
    for (const SampleWords& group : sampleWords(*m_report))
        lines << group.title << group.samples << group.sums;
    for (const WhyWords& row : m_rows) {
        lines << row.name + QStringLiteral(": ") + row.verdict;
        for (const QString& detail : row.details)
            lines << QStringLiteral("    ") + detail;
    }
    return lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

QWidget* PixelCard::makeHeader() const
{
    auto* header = new QWidget;
    auto* row = new QHBoxLayout(header);
    row->setContentsMargins(8, 2, 8, 4);
    row->setSpacing(10);
    constexpr int kSide = 38;
    row->addWidget(new Swatch(m_report->color, kSide), 0, Qt::AlignTop);
    auto* texts = new QVBoxLayout;
    texts->setSpacing(1);
    texts->addWidget(wrapped(answer(), "heading"));
    QString numbers = QStringLiteral("%1\nz %2").arg(rgbText(m_report->color), depthNumber(m_report->depth));
    texts->addWidget(wrapped(numbers, "muted"));
    row->addLayout(texts, 1);
    return header;
}

QWidget* PixelCard::makeRow(std::size_t index)
{
    const WhyWords& words = m_rows[index];
    const WhyFace& face = m_report->faces[index];
    auto* frame =
        new ClickableRow([this, index] { Q_EMIT rowClicked(m_rows[index].face, QPoint(m_report->x, m_report->y)); });
    frame->setToolTip(tr("Show the step at which this was decided"));
    frame->setAccessibleName(words.name + QStringLiteral(": ") + words.verdict);
    auto* column = new QVBoxLayout(frame);
    column->setContentsMargins(8, 5, 8, 6);
    column->setSpacing(2);
    auto* head = new QHBoxLayout;
    head->setSpacing(7);
    auto* pill = new QLabel(words.name);
    pill->setObjectName(QStringLiteral("pill"));
    head->addWidget(pill, 0, Qt::AlignTop);
    auto* verdict = wrapped(words.verdict);
    const Inks inks = inksFor(palette());
    verdict->setStyleSheet(QStringLiteral("color: %1;").arg((words.good ? inks.plus : inks.minus).name()));
    head->addWidget(verdict, 1);
    if (face.verdict == WhyVerdict::Written) {
        constexpr int kSide = 16;
        head->addWidget(new Swatch(face.write.after.color, kSide), 0, Qt::AlignTop);
    }
    column->addLayout(head);
    if (!words.details.isEmpty())
        column->addWidget(wrapped(words.details.join(QLatin1Char('\n')), "numbers"));
    if (face.texels && face.verdict == WhyVerdict::Written && !face.texels->patch.texels.empty())
        column->addWidget(new TexelDrawing(*face.texels));
    return frame;
}

void PixelCard::rebuild()
{
    m_rows.clear();
    QWidget* content = makePanelContent();
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(4, 0, 4, 4);
    column->setSpacing(3);
    if (!m_report) {
        auto* hint = wrapped(tr("Click a pixel of the picture: here you see every face that could concern it, how far "
                                "it got, and the numbers that decided."),
                             "muted");
        hint->setContentsMargins(8, 2, 8, 0);
        column->addWidget(hint);
    } else {
        column->addWidget(makeHeader());
        if (const auto samples = sampleWords(*m_report); !samples.empty())
            column->addWidget(makeSampleRows(samples));
        for (const WhyFace& face : m_report->faces)
            m_rows.push_back(whyWords(*m_report, face));
        for (std::size_t i = 0; i < std::min(m_rows.size(), kMostRows); ++i)
            column->addWidget(makeRow(i));
        if (m_rows.size() > kMostRows)
            column->addWidget(wrapped(
                tr("and %n more faces; Copy has them all", nullptr, static_cast<int>(m_rows.size() - kMostRows)),
                "muted"));
        if (m_rows.empty()) {
            auto* nothing = wrapped(tr("No face comes near this pixel."), "muted");
            nothing->setContentsMargins(8, 0, 8, 0);
            column->addWidget(nothing);
        }
    }
    column->addStretch(1);
    m_scroll->setWidget(content);
}

void PixelCard::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange)
        m_rebuildSoon.start(); // not now: the application goes through all widgets
    QWidget::changeEvent(event);
}

} // namespace rasterlens
