#include "ui/steps/step_listing.h"

#include "core/observe/step_text.h"
#include "ui/base/theme.h"
#include "ui/steps/lens_model.h"
#include "ui/steps/step_session.h"

#include <QCoreApplication>
#include <QEvent>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace rasterlens
{
namespace
{

constexpr std::size_t kListingLines = 4;
constexpr int kFormulaLines = 2;
constexpr int kCompactBelow = 560; ///< height of the canvas card from which on the whole listing has room

QString translated(const char* text) { return QCoreApplication::translate("StepListing", text); }

const QStringList& geometryListing()
{
    static const QStringList lines{QStringLiteral("for (v : A, B, C) clip[v] = clipFromObject * object[v];"),
                                   QStringLiteral("for (plane : w, +x, -x, +y, -y, +z, -z) polygon = cut(plane);"),
                                   QStringLiteral("screen[v] = snap(viewport(clip[v] / clip[v].w));"),
                                   QStringLiteral("if (isCulled(area2)) return;  edges = setup(A, B, C);")};
    return lines;
}

const QStringList& equationListing()
{
    static const QStringList lines{QStringLiteral("for (x = x0; x < x1; ++x, E0 += A0, E1 += A1, E2 += A2)"),
                                   QStringLiteral("  if (E0 >= t0 && E1 >= t1 && E2 >= t2) {"),
                                   QStringLiteral("    z = a zA + b zB + c zC;  if (!passes(z, depth)) continue;"),
                                   QStringLiteral("    color = shade(perspective(a, b, c));  depth = z; }")};
    return lines;
}

const QStringList& walkingListing()
{
    static const QStringList lines{QStringLiteral("sort(top, middle, bottom);  long = top -> bottom;"),
                                   QStringLiteral("for (x = ceil(xl - 0.5); x < ceil(xr - 0.5); ++x) {"),
                                   QStringLiteral("    z = a zA + b zB + c zC;  if (!passes(z, depth)) continue;"),
                                   QStringLiteral("    color = shade(perspective(a, b, c));  depth = z; }")};
    return lines;
}

const QStringList& lineListing()
{
    static const QStringList lines{QStringLiteral("p = 2 dy - dx;  for (x = x0; x <= x1; ++x) {  plot(x, y);"),
                                   QStringLiteral("  if (p > 0) { y += 1;  p -= 2 dx; }  p += 2 dy; }"),
                                   QStringLiteral("  z = lerp(zA, zB, i / dx);  if (!passes(z, depth)) continue;"),
                                   QStringLiteral("  color = shade(x, y);  depth = z;")};
    return lines;
}

const QStringList& listingOf(const StepLog& log, StepKind kind)
{
    if (kind < StepKind::Walk)
        return geometryListing();
    if (log.settings().fill != Fill::Solid)
        return lineListing();
    return log.settings().algorithm == Algorithm::EdgeWalking ? walkingListing() : equationListing();
}

int lineOf(StepKind kind)
{
    switch (kind) {
    case StepKind::Vertex: return 0;
    case StepKind::ClipPlane:
    case StepKind::CohenSutherland:
    case StepKind::Clipped: return 1;
    case StepKind::Viewport: return 2;
    case StepKind::Facing:
    case StepKind::Fate:
    case StepKind::Triangle:
    case StepKind::Setup: return 3;
    case StepKind::Walk: return 0;
    case StepKind::Span:
    case StepKind::Sample:
    case StepKind::LineDecision: return 1;
    case StepKind::LineSample: return 0;
    case StepKind::Fragment: return 2;
    case StepKind::Shade:
    case StepKind::Write: return 3;
    case StepKind::End: return -1;
    }
    return -1;
}

QString minus(QString text) { return text.replace(QLatin1Char('-'), QChar(0x2212)); }

/// ` - 8` or ` + 8`
QString signedTerm(double value)
{
    return (value < 0 ? QStringLiteral(" \u2212 ") : QStringLiteral(" + ")) + fullNumber(std::abs(value));
}

/// `8·(3.5 − 8) − 8·(4.5 − 0)`
QString edgeTerms(const StepSetup& setup, const StepEdge& edge, int x, int y)
{
    const double u = setup.unitsPerSample;
    const auto factor = [](double at, double from) {
        return QStringLiteral("\u00b7(%1 %2 %3)")
            .arg(fullNumber(at), from < 0 ? QStringLiteral("+") : QStringLiteral("\u2212"), fullNumber(std::abs(from)));
    };
    return minus(fullNumber(edge.a / u)) + factor(x + 0.5, edge.from.x / u) + signedTerm(edge.b / u) +
           factor(y + 0.5, edge.from.y / u);
}

QString sampleFormula(const StepLog& log, const StepEvent& event)
{
    const StepSetup& setup = log.triangle(event)->setup;
    const EdgeValues& values = log.payload<SampleStep>(event).values;
    std::size_t decides = 0;
    bool failed = false;
    for (std::size_t i = 0; i < 3; ++i) {
        const bool fails = !(values[i] >= setup.edges[i].threshold);
        if (fails == failed ? values[i] < values[decides] : fails)
            decides = i;
        failed = failed || fails;
    }
    const StepEdge& edge = setup.edges[decides];
    const QString name = QStringLiteral("E_") + edgeName(setup, int(decides));
    const auto area = [&](double value) { return minus(edgeValueText(value, setup.unitsPerArea)); };
    QString verdict = values[decides] >= edge.threshold ? translated(QT_TRANSLATE_NOOP("StepListing", "inside"))
                                                        : translated(QT_TRANSLATE_NOOP("StepListing", "outside"));
    if (values[decides] == 0)
        verdict =
            (values[decides] >= edge.threshold
                 ? translated(QT_TRANSLATE_NOOP("StepListing", "owned: %1 is a %2 edge"))
                 : translated(QT_TRANSLATE_NOOP("StepListing", "not owned: %1 is a %2 edge")))
                .arg(edgeName(setup, int(decides)),
                     edge.side == EdgeSide::Neither ? translated(QT_TRANSLATE_NOOP("StepListing", "right or bottom"))
                                                    : edgeSideText(edge.side));
    QStringList others;
    for (std::size_t i = 0; i < 3; ++i)
        if (i != decides)
            others << QStringLiteral("E_%1 = %2").arg(edgeName(setup, int(i)), area(values[i]));
    const QString step =
        edge.perX < 0 ? QStringLiteral("\u2212= ") + area(-edge.perX) : QStringLiteral("+= ") + area(edge.perX);
    return QStringLiteral("%1(%2, %3) = %4 = %5\n%6   %8   %7")
        .arg(name, shortNumber(event.x + 0.5), shortNumber(event.y + 0.5), edgeTerms(setup, edge, event.x, event.y),
             area(values[decides]), verdict, others.join(QStringLiteral("   ")),
             translated(QT_TRANSLATE_NOOP("StepListing", "next x: %1 %2")).arg(name, step));
}

QString spanFormula(const StepLog& log, const StepEvent& event)
{
    const SpanStep& span = log.payload<SpanStep>(event);
    const auto rounding = [](double from, bool ceiling) {
        return (ceiling ? QStringLiteral("ceil(%1 \u2212 0.5)") : QStringLiteral("floor(%1 \u2212 0.5) + 1"))
            .arg(shortNumber(from));
    };
    return QStringLiteral("xl = %1   %2 = %3\nxr = %4   %5 = %6   x = %7 \u2026 %8")
        .arg(shortNumber(span.ends.left), rounding(span.ends.left, span.ends.leftOwnsTie))
        .arg(span.ends.begin)
        .arg(shortNumber(span.ends.right), rounding(span.ends.right, !span.ends.rightOwnsTie))
        .arg(span.ends.end)
        .arg(span.xBegin)
        .arg(span.xEnd - 1);
}

QString lineFormula(const StepLog& log, const StepEvent& event)
{
    const LineStep& step = log.payload<LineStep>(event);
    const LineDecision& d = step.decision;
    const int next = d.decision + 2 * d.shorter - (d.sideways ? 2 * d.longer : 0);
    const QString change = d.sideways ? QStringLiteral("2\u00b7%1 \u2212 2\u00b7%2").arg(d.shorter).arg(d.longer)
                                      : QStringLiteral("2\u00b7%1").arg(d.shorter);
    return QStringLiteral("p_%1 = %2 %3 0   d_lower = %4   d_upper = %5\np_%6 = %2 + %7 = %8")
        .arg(d.step)
        .arg(minus(QString::number(d.decision)), d.sideways ? QStringLiteral(">") : QStringLiteral("\u2264"),
             minus(shortNumber(step.dLower())), minus(shortNumber(step.dUpper())))
        .arg(d.step + 1)
        .arg(change, minus(QString::number(next)));
}

/// What the new depth has to be to the stored one; null where it does not matter.
const char* depthRelation(DepthTest test)
{
    switch (test) {
    case DepthTest::Less: return "<";
    case DepthTest::LessEqual: return "\u2264";
    case DepthTest::Greater: return ">";
    case DepthTest::Always:
    case DepthTest::None: break;
    }
    return nullptr;
}

QString fragmentFormula(const StepLog& log, const StepEvent& event)
{
    const FragmentStep& step = log.payload<FragmentStep>(event);
    const auto weights = [](const Weights& w) {
        return QStringLiteral("(%1, %2, %3)").arg(shortNumber(w[0]), shortNumber(w[1]), shortNumber(w[2]));
    };
    const QString z = shortNumber(double(step.depth));
    const QString verdict = event.has(StepEvent::kPassed) ? translated(QT_TRANSLATE_NOOP("StepListing", "passed"))
                                                          : translated(QT_TRANSLATE_NOOP("StepListing", "failed"));
    QString text = QStringLiteral("z = %1").arg(z);
    if (const char* relation = depthRelation(log.settings().depthTest))
        text += QStringLiteral("   %1 %2 %3: %4")
                    .arg(z, QString::fromUtf8(relation), shortNumber(double(step.storedDepth)), verdict);
    text += QStringLiteral("\n(\u03b1, \u03b2, \u03b3) = %1 \u2192 %2   1/w = %3")
                .arg(weights(step.screen), weights(step.weights), shortNumber(step.invW));
    return text;
}

QString formulaOf(const StepLog& log, std::size_t i)
{
    const StepEvent& event = log.event(i);
    switch (event.kind) {
    case StepKind::Sample: return sampleFormula(log, event);
    case StepKind::Span: return spanFormula(log, event);
    case StepKind::LineDecision: return lineFormula(log, event);
    case StepKind::Fragment: return fragmentFormula(log, event);
    default: break;
    }
    // The line of the log from its numbers on; the transport names the rest.
    QString text = stepText(log, i);
    const auto colon = text.indexOf(QLatin1String(": "));
    text = colon >= 0 ? text.mid(colon + 2) : QString();
    return text.replace(QStringLiteral("->"), QStringLiteral("\u2192"))
        .replace(QLatin1String(": "), QLatin1String(":\n"));
}

} // namespace

StepExplanation explainStep(const StepLog& log, std::size_t i)
{
    const StepKind kind = log.event(i).kind;
    return {listingOf(log, kind), lineOf(kind), formulaOf(log, i)};
}

QString stepTitle(const StepLog& log, std::size_t i)
{
    static constexpr const char* kTitles[] = {
        QT_TRANSLATE_NOOP("StepListing", "vertex"),
        QT_TRANSLATE_NOOP("StepListing", "clip plane"),
        QT_TRANSLATE_NOOP("StepListing", "Cohen-Sutherland"),
        QT_TRANSLATE_NOOP("StepListing", "viewport"),
        QT_TRANSLATE_NOOP("StepListing", "facing"),
        QT_TRANSLATE_NOOP("StepListing", "fan"),
        QT_TRANSLATE_NOOP("StepListing", "verdict"),
        QT_TRANSLATE_NOOP("StepListing", "triangle"),
        QT_TRANSLATE_NOOP("StepListing", "setup"),
        QT_TRANSLATE_NOOP("StepListing", "corners by height"),
        QT_TRANSLATE_NOOP("StepListing", "span"),
        QT_TRANSLATE_NOOP("StepListing", "sample"),
        QT_TRANSLATE_NOOP("StepListing", "line decision"),
        QT_TRANSLATE_NOOP("StepListing", "line sample"),
        QT_TRANSLATE_NOOP("StepListing", "depth test"),
        QT_TRANSLATE_NOOP("StepListing", "shade"),
        QT_TRANSLATE_NOOP("StepListing", "write"),
        QT_TRANSLATE_NOOP("StepListing", "end of the frame"),
    };
    static_assert(std::size(kTitles) == kStepKinds);
    const StepEvent& event = log.event(i);
    QStringList parts{translated(kTitles[std::size_t(event.kind)])};
    if (event.has(StepEvent::kTie))
        parts << translated(QT_TRANSLATE_NOOP("StepListing", "tie"));
    if (event.x >= 0)
        parts << QStringLiteral("(%1, %2)").arg(event.x).arg(event.y);
    else if (event.y >= 0)
        parts << translated(QT_TRANSLATE_NOOP("StepListing", "row %1")).arg(event.y);
    if (event.face != StepEvent::kNone)
        parts << translated(QT_TRANSLATE_NOOP("StepListing", "face %1")).arg(event.face);
    return parts.join(QStringLiteral(" \u00b7 "));
}

StepListing::StepListing(const StepSession& session, QWidget* parent) : QFrame(parent), m_session(session)
{
    setObjectName(QStringLiteral("stepListing"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(10, 3, 10, 3);
    column->setSpacing(0);
    const auto addLabel = [&] {
        auto* label = new QLabel;
        label->setTextFormat(Qt::PlainText);
        label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
        column->addWidget(label);
        return label;
    };
    for (std::size_t i = 0; i < kListingLines; ++i)
        m_lines.push_back(addLabel());
    m_formula = addLabel();
    m_formula->setContentsMargins(4, 2, 0, 0);
    m_formula->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_formula->setFocusPolicy(Qt::NoFocus);
    connect(&session, &StepSession::positionChanged, this, &StepListing::sync);
    connect(&session, &StepSession::openChanged, this, [this](bool open) {
        setVisible(open);
        sync();
    });
    hide();
}

void StepListing::sync()
{
    m_explanation = {};
    if (m_session.isOpen() && m_session.log() && m_session.position() > 0)
        m_explanation = explainStep(*m_session.log(), m_session.position() - 1);
    const bool isCompact = parentWidget()->height() < kCompactBelow;
    const QFont font = numberFont(-0.5);
    const QString accent = palette().color(QPalette::AlternateBase).name();
    // The canvas above keeps its height: there are as many lines at every step, all of one height.
    const int kept = std::clamp(m_explanation.line, 0, int(m_lines.size()) - 1);
    for (std::size_t i = 0; i < m_lines.size(); ++i) {
        const bool now = int(i) == m_explanation.line;
        m_lines[i]->setFont(font);
        m_lines[i]->setFixedHeight(lineHeight());
        m_lines[i]->setVisible(int(i) == kept || !isCompact);
        m_lines[i]->setText(m_explanation.listing.value(int(i)));
        m_lines[i]->setStyleSheet(
            QStringLiteral("padding: 0 4px; border-radius: 3px; %1")
                .arg(now ? QStringLiteral("background: %1;").arg(accent)
                         : QStringLiteral("color: %1;").arg(palette().color(QPalette::PlaceholderText).name())));
    }
    m_formula->setStyleSheet(QStringLiteral("color: %1;").arg(palette().color(QPalette::Link).name()));
    fitFormula();
}

/// Room for digits and for the taller signs of other scripts.
int StepListing::lineHeight()
{
    constexpr int kAir = 2;
    return std::max(QFontMetrics(numberFont(-0.5)).height(), QFontMetrics(textFont(-0.5)).height()) + kAir;
}

/// Long numbers first make the formula smaller, then leave dots in its middle; the tool tip has all of it.
void StepListing::fitFormula()
{
    constexpr double kSmallest = 0.8;
    const QMargins around = layout()->contentsMargins() + m_formula->contentsMargins();
    const int room = width() - around.left() - around.right();
    QStringList lines = m_explanation.formula.split(QLatin1Char('\n'));
    while (lines.size() > kFormulaLines) {
        const QString last = lines.takeLast();
        lines.last() += QStringLiteral("   ") + last;
    }
    while (lines.size() < kFormulaLines)
        lines << QString();
    QFont font = numberFont(-0.5);
    int longest = 1;
    for (const QString& line : lines)
        longest = std::max(longest, QFontMetrics(font).horizontalAdvance(line));
    font.setPointSizeF(font.pointSizeF() * std::clamp(double(room) / longest, kSmallest, 1.0));
    for (QString& line : lines)
        line = QFontMetrics(font).elidedText(line, Qt::ElideMiddle, room);
    m_formula->setFont(font);
    m_formula->setFixedHeight(kFormulaLines * lineHeight() + 2);
    m_formula->setText(lines.join(QLatin1Char('\n')));
    m_formula->setToolTip(m_explanation.formula);
}

void StepListing::resizeEvent(QResizeEvent* event)
{
    QFrame::resizeEvent(event);
    fitFormula();
}

QSize StepListing::minimumSizeHint() const
{
    int shown = 0;
    for (const QLabel* line : m_lines)
        shown += line->isHidden() ? 0 : 1;
    return QFrame::minimumSizeHint() - QSize(0, std::max(shown - 1, 0) * m_lines.front()->sizeHint().height());
}

void StepListing::showEvent(QShowEvent* event)
{
    parentWidget()->installEventFilter(this);
    QFrame::showEvent(event);
}

bool StepListing::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == parentWidget() && event->type() == QEvent::Resize)
        sync();
    return QFrame::eventFilter(watched, event);
}

void StepListing::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange)
        sync();
    QFrame::changeEvent(event);
}

} // namespace rasterlens
