#include "ui/pipeline/mistake_badge.h"

#include "core/questions/unchanged.h"
#include "core/render/picture_memory.h"
#include "core/truth/mistake_proof.h"
#include "ui/base/inks.h"
#include "ui/base/step_words.h"
#include "ui/base/theme.h"
#include "ui/pipeline/mistakes_section.h"
#include "ui/pipeline/unchanged_notes.h"

#include <QEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <utility>

namespace rasterlens
{
namespace
{

constexpr int kMargin = 10;
constexpr int kPaddingX = 10;
constexpr int kBar = 6; ///< on the left, in the colour of alarm
constexpr int kPaddingY = 5;
constexpr qsizetype kShownLines = 5;
constexpr QRgb kAlarm = kCanvasMinus;
constexpr std::size_t kKept = 2;

QString number(double value) { return QLocale(QLocale::English, QLocale::UnitedStates).toString(value, 'g', 6); }

/// Whether a picture drawn with the outputs `has` has all of `needed`.
bool covers(const Outputs& has, const Outputs& needed)
{
    return (has.depth || !needed.depth) && (has.ids || !needed.ids) && (has.picture || !needed.picture);
}

} // namespace

QString proofTitle(Proof proof)
{
    switch (proof) {
    case Proof::CoveredTwice: return MistakeBadge::tr("hit twice");
    case Proof::Covered: return MistakeBadge::tr("covered");
    case Proof::Tested: return MistakeBadge::tr("tested");
    case Proof::DepthPassed: return MistakeBadge::tr("depth passed");
    case Proof::DepthFailed: return MistakeBadge::tr("depth failed");
    case Proof::Rejected: return MistakeBadge::tr("rejected");
    case Proof::CulledBack: return MistakeBadge::tr("culled, back");
    case Proof::Degenerate: return MistakeBadge::tr("degenerate");
    case Proof::Rasterized: return MistakeBadge::tr("rasterized");
    case Proof::Holes: return MistakeBadge::tr("holes");
    case Proof::Strays: return MistakeBadge::tr("stray pixels");
    case Proof::WrongFaces: return MistakeBadge::tr("pixels of a wrong face");
    case Proof::WrongPixels: return MistakeBadge::tr("wrong pixels");
    case Proof::DepthError: return MistakeBadge::tr("depth error");
    case Proof::Colors: return MistakeBadge::tr("colours");
    case Proof::MissingLight: return MistakeBadge::tr("white pixels of light lost");
    }
    return {};
}

MistakeBadge::MistakeBadge(QWidget* canvas)
    : QWidget(canvas),
      m_result(
          [this](Weighed weighed) {
              m_evidence = std::move(weighed.evidence);
              keep(std::move(weighed.right));
              fitToText();
              Q_EMIT counted();
          },
          [this](Lack lack) { Q_EMIT failed(tr("The mistakes were not counted: %1.").arg(lackText(lack))); })
{
    setCursor(Qt::PointingHandCursor);
    canvas->installEventFilter(this);
    hide();
}

void MistakeBadge::showFor(const FramePtr& frame)
{
    std::vector<Evidence> evidence;
    for (const QString& id : frame->settings.mistakes)
        if (const Mistake* mistake = findMistake(id)) {
            // The former number stays until the new one is there: a badge that flickers is not read.
            const auto former = std::ranges::find(m_evidence, mistake, &Evidence::mistake);
            evidence.push_back(former == m_evidence.end() ? Evidence{mistake} : *former);
        }
    m_evidence = std::move(evidence);
    fitToText();
    std::erase_if(m_kept, [&](const Right& right) { return right.scene != frame->scene; });
    if (m_evidence.empty()) {
        m_result.drop();
        return;
    }
    m_result.ask([this, frame, known = Weighed{m_evidence, rightFor(*frame)}](
                     const auto& turn) { return weigh(*frame, known, turn.stop()); },
                 LatestJob::Running::Interrupt);
}

/// The right picture for the one that is shown, with its memory where it is kept.
MistakeBadge::Right MistakeBadge::rightFor(const RenderedFrame& shown) const
{
    Right right{shown.scene, shown.settings, {.picture = false}, nullptr};
    right.settings.mistakes.clear();
    for (const Evidence& one : m_evidence) {
        const Outputs needed = proofOutputs(one.mistake->proof);
        right.has.depth = right.has.depth || needed.depth;
        right.has.ids = right.has.ids || needed.ids;
        right.has.picture = right.has.picture || needed.picture;
    }
    const auto kept = std::ranges::find_if(
        m_kept, [&](const Right& one) { return one.settings == right.settings && covers(one.has, right.has); });
    return kept == m_kept.end() ? right : *kept;
}

/// Large pictures are not kept: the next ones want their memory.
void MistakeBadge::keep(Right right)
{
    std::erase_if(m_kept, [&](const Right& one) { return one.settings == right.settings; });
    if (!right.picture || isLarge(right.settings))
        return;
    m_kept.push_back(std::move(right));
    if (m_kept.size() > kKept)
        m_kept.erase(m_kept.begin());
}

/// On the background thread.
MistakeBadge::Weighed MistakeBadge::weigh(const RenderedFrame& shown, Weighed known, const std::stop_token& stop)
{
    Right& right = known.right;
    if (!right.picture) {
        if (unsupported(*right.scene, right.settings))
            return known;
        ++m_drawn;
        CountedPicture picture = drawCounted(*right.scene, right.settings, right.has, stop);
        if (!right.has.depth)
            picture.frame.depth = {}; // memory of the depth test, which no proof looks at
        right.picture = std::make_shared<const CountedPicture>(std::move(picture));
    }
    const bool needsSamples = std::ranges::any_of(
        known.evidence, [](const Evidence& one) { return factsFor(*one.mistake) == FactsOf::Samples; });
    const FrameFacts facts =
        frameFacts(*right.scene, right.settings, needsSamples ? FactsOf::Samples : FactsOf::Faces, stop);
    for (Evidence& one : known.evidence) {
        if (stop.stop_requested())
            return known;
        one.unchanged = whyUnchanged(*one.mistake, shown.settings, facts);
        one.known = true;
        one.shown = proofValue(one.mistake->proof, shown, *right.picture);
        one.right = proofValue(one.mistake->proof, *right.picture, *right.picture);
    }
    return known;
}

void MistakeBadge::setSaysMoment(bool on)
{
    if (std::exchange(m_saysMoment, on) != on)
        fitToText();
}

void MistakeBadge::setConcealed(bool on)
{
    if (std::exchange(m_isConcealed, on) != on)
        fitToText();
}

/// Title, proof and moment stand in one line where there is room for them, for the proof must not be cut.
QStringList MistakeBadge::lines() const
{
    const QFontMetrics metrics(textFont(0, true));
    QStringList lines;
    for (const Evidence& one : m_evidence) {
        lines << mistakeTitle(*one.mistake);
        if (!one.known)
            continue;
        const auto add = [&](const QString& part) {
            const QString longer = lines.last() + QStringLiteral(" \u00b7 ") + part;
            if (metrics.horizontalAdvance(longer) <= room())
                lines.last() = longer;
            else
                lines << part;
        };
        const QString proof = QStringLiteral("%1 %2").arg(proofTitle(one.mistake->proof), number(one.shown));
        add(one.right == 0 ? proof : proof + tr(", right: %1").arg(number(one.right)));
        if (m_saysMoment)
            add(momentText(std::nullopt));
        if (one.unchanged)
            lines << unchangedText(*one.unchanged);
    }
    if (lines.size() > kShownLines) {
        const qsizetype more = lines.size() - kShownLines + 1;
        lines = lines.first(kShownLines - 1);
        lines << tr("and %n more", nullptr, static_cast<int>(more));
    }
    return lines;
}

/// The width of the longest line.
int MistakeBadge::room() const { return parentWidget()->width() - 2 * kMargin - 2 * kPaddingX - kBar; }

void MistakeBadge::fitToText()
{
    const QFontMetrics metrics(textFont(0, true));
    int width = 0;
    const QStringList shown = lines();
    for (const QString& line : shown)
        width = std::max(width, metrics.horizontalAdvance(line));
    setGeometry(kMargin, kMargin, std::min(width, room()) + 2 * kPaddingX + kBar,
                static_cast<int>(shown.size()) * metrics.lineSpacing() + 2 * kPaddingY);
    setVisible(!m_evidence.empty() && !m_isConcealed);
    update();
    Q_EMIT placed(isHidden() ? QRect() : geometry());
}

bool MistakeBadge::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == parentWidget() && event->type() == QEvent::Resize)
        fitToText();
    return QWidget::eventFilter(watched, event);
}

void MistakeBadge::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(QColor(kAlarm), 1.5));
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 6, 6);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(kAlarm));
    painter.drawRoundedRect(QRectF(1, 1, 7, height() - 2), 3, 3);
    painter.setPen(palette().color(QPalette::Text));
    painter.setFont(textFont(0, true));
    const QFontMetrics metrics(painter.font());
    int y = kPaddingY;
    for (const QString& line : lines()) {
        const QRect row(kPaddingX + 4, y, width() - 2 * kPaddingX, metrics.lineSpacing());
        painter.drawText(row, Qt::AlignVCenter, metrics.elidedText(line, Qt::ElideRight, row.width()));
        y += metrics.lineSpacing();
    }
}

void MistakeBadge::mousePressEvent(QMouseEvent* event)
{
    event->accept();
    Q_EMIT clicked();
}

void MistakeBadge::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::FontChange)
        fitToText();
    QWidget::changeEvent(event);
}

} // namespace rasterlens
