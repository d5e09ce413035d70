#include "ui/steps/step_formula.h"

#include "core/observe/because.h"
#include "core/observe/step_text.h"
#include "core/settings/depth_rules.h"
#include "core/settings/mistakes.h"
#include "ui/base/numbers.h"
#include "ui/base/step_words.h"
#include "ui/steps/lens_model.h"
#include "ui/steps/line_code.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <algorithm>
#include <bit>
#include <cmath>

namespace rasterlens
{
namespace
{

QString translated(const char* text) { return QCoreApplication::translate("StepListing", text); }

// The code, one name for one thing: E_AB is the value of edge AB, t_AB the smallest that counts as inside, and the
// weights of the corners A, B and C are α, β and γ.

/// in  rules of one pass: passRules()
QString depthLine(const QString& z, const Rules& rules)
{
    const QString sign = QLatin1String(depthSign(rules, 0));
    return sign.isEmpty() ? QStringLiteral("z = %1;").arg(z)
                          : QStringLiteral("z = %1;  if (!(z %2 depth)) continue;").arg(z, sign);
}

QString weightedDepth(const Rules& rules)
{
    return QStringLiteral("    ") + depthLine(QStringLiteral("\u03b1 zA + \u03b2 zB + \u03b3 zC"), rules);
}

QString shadeLine(const Rules& rules)
{
    return rules.perspectiveCorrect
               ? QStringLiteral("    color = shade(perspective(\u03b1, \u03b2, \u03b3));  depth = z; }")
               : QStringLiteral("    color = shade(\u03b1, \u03b2, \u03b3);  depth = z; }");
}

std::array<QString, 4> geometryCode()
{
    return {QStringLiteral("for (v : A, B, C) clip[v] = clipFromObject * object[v];"),
            QStringLiteral("for (plane : w, +x, -x, +y, -y, +z, -z) polygon = cut(plane);"),
            QStringLiteral("screen[v] = snap(viewport(clip[v] / clip[v].w));"),
            QStringLiteral("if (isCulled(area2)) return;  edges = setup(A, B, C);")};
}

std::array<QString, 4> equationCode(const Rules& rules)
{
    const QString place = rules.coverageRule == CoverageRule::Centre         ? QStringLiteral("x, y")
                          : rules.coverageRule == CoverageRule::Conservative ? QStringLiteral("deepest(x, y)")
                                                                             : QStringLiteral("outermost(x, y)");
    return {addsUpEdgeValues(rules)
                ? QStringLiteral("for (x = x0; x < x1; ++x, E_AB += a_AB, E_BC += a_BC, E_CA += a_CA)")
                : QStringLiteral("for (x = x0; x < x1; ++x, E_AB = edge(A, B, %1), E_BC = .., E_CA = ..)").arg(place),
            QStringLiteral("  if (E_AB >= t_AB && E_BC >= t_BC && E_CA >= t_CA) {"), weightedDepth(rules),
            shadeLine(rules)};
}

/// Edge walking up to where a row is crossed: both halves in one loop. Corners 1, 2, 3 are those sorted by height.
std::array<QString, 4> walkingStagesCode()
{
    return {QStringLiteral("outline(AB, BC, CA);  sort by y: 1, 2, 3;"),
            QStringLiteral("long = 1 -> 3;  broken = 1 -> 2 -> 3;"),
            QStringLiteral("for (y : rows) {  up = y < y2 || y2 == y3;  i = up ? 1 : 2;  j = up ? 2 : 3;"),
            QStringLiteral("  alpha = (y-y1) / (y3-y1);  xa = x1 + alpha (x3-x1);  "
                           "beta = (y-yi) / (yj-yi);  xb = xi + beta (xj-xi);")};
}

/// Edge walking, what is done in a row.
std::array<QString, 4> walkingCode(const Rules& rules)
{
    return {QStringLiteral("for (y : rows) {  xa, xb = crossings(y);  xl = min(xa, xb);  xr = max(xa, xb);"),
            QStringLiteral("  for (x = ceil(xl - 0.5); x < ceil(xr - 0.5); ++x) {"), weightedDepth(rules),
            shadeLine(rules)};
}

/// Super-sampling, after the last face.
std::array<QString, 4> resolveCode()
{
    return {QStringLiteral("for (pixel : picture) {"), QStringLiteral("  sum = (0, 0, 0);"),
            QStringLiteral("  for (sample : pixel) sum += color[sample];"),
            QStringLiteral("  picture[pixel] = sum / n; }")};
}

std::array<QString, 4> lineCode(const StepLog& log, std::size_t i)
{
    const Rules rules = passRules(log.rightRules(), log.event(i).face);
    const QString color = QStringLiteral("  color = shade(x, y);  depth = z;");
    const QString onLine = QStringLiteral("  ") + depthLine(QStringLiteral("lerp(zA, zB, i / n)"), rules);
    if (rules.fill == Fill::Points)
        return {QStringLiteral("for (v : A, B, C) {  plot(floor(v.x), floor(v.y));"), QString(),
                QStringLiteral("  ") + depthLine(QStringLiteral("v.z"), rules), color};
    if (rules.lineRule == LineRule::DiamondExit)
        return {QStringLiteral("for (i : columns of the line, or rows where it is steep) {  j = row at x = i + 0.5;"),
                QStringLiteral("  if (!leaves(line, diamond(i, j))) continue;  plot(i, j); }"), onLine, color};
    if (rules.line == LineAlgorithm::Dda)
        return {QStringLiteral("n = max(|dx|, |dy|);  for (i = 0; i <= n; ++i) {  plot(round(x), round(y));"),
                QStringLiteral("  x += dx / n;  y += dy / n; }"), onLine, color};
    const std::array<QString, 2> loop = bresenhamCode(log, i);
    return {loop[0], loop[1], onLine, color};
}

std::array<QString, 4> columnCode(const Rules& rules)
{
    return {QStringLiteral("for (x = xmin; x <= xmax; ++x) {  ys = table[x];  if (empty(ys)) say(x);"),
            QStringLiteral("  for (y = min(ys); y <= max(ys); ++y) {"), weightedDepth(rules), shadeLine(rules)};
}

/// Whether a step is run by the code of the geometry stages. Where lines or points are drawn, no set-up follows the
/// triangle: it begins with their code.
bool isGeometry(StepKind kind, const Rules& rules)
{
    return kind < StepKind::Outline && !(kind == StepKind::Triangle && rules.fill != Fill::Solid);
}

/// The kinds there are after geometry, by the way the triangle is drawn.
StepKinds kindsOfDrawing(const Rules& rules)
{
    const StepKinds all = kindBit(StepKind::Fragment) | kindBit(StepKind::Shade) | kindBit(StepKind::Write);
    if (rules.fill != Fill::Solid)
        return all | kindBit(StepKind::LineDecision) | kindBit(StepKind::LinePosition) | kindBit(StepKind::LineSample);
    switch (rules.algorithm) {
    case Algorithm::EdgeWalking: return all | kindBit(StepKind::Crossing) | kindBit(StepKind::Span);
    case Algorithm::ColumnFill: return all | kindBit(StepKind::Column);
    case Algorithm::EdgeEquation:
    case Algorithm::Tiled: break;
    }
    return all | kindBit(StepKind::Sample);
}

/// The right code for a step, and the kinds of step it is about.
std::pair<std::array<QString, 4>, StepKinds> codeFor(const StepLog& log, std::size_t i)
{
    const StepKind kind = log.event(i).kind;
    const Rules right = passRules(log.rightRules(), log.event(i).face);
    const Rules rules = passRules(log.rules(), log.event(i).face);
    if (isGeometry(kind, rules))
        return {geometryCode(), kindBit(StepKind::Outline) - 1};
    if (kind >= StepKind::Outline && kind <= StepKind::Crossing)
        return {walkingStagesCode(), kindBit(StepKind::Crossing) * 2 - kindBit(StepKind::Outline)};
    if (kind == StepKind::Resolve)
        return {resolveCode(), kindBit(StepKind::Resolve)};
    const StepKinds kinds = kindsOfDrawing(rules);
    if (rules.fill != Fill::Solid)
        return {lineCode(log, i), kinds};
    switch (rules.algorithm) {
    case Algorithm::EdgeWalking: return {walkingCode(right), kinds};
    case Algorithm::ColumnFill: return {columnCode(right), kinds};
    case Algorithm::EdgeEquation:
    case Algorithm::Tiled: break;
    }
    return {equationCode(right), kinds};
}

/// The line of the listing that a step is run by.
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
    case StepKind::Outline:
    case StepKind::Walk:
    case StepKind::Column: return 0;
    case StepKind::Sides:
    case StepKind::Span:
    case StepKind::Sample:
    case StepKind::LineDecision:
    case StepKind::LinePosition: return 1;
    case StepKind::Halves: return 2;
    case StepKind::Crossing: return 3;
    case StepKind::LineSample: return 0; // of a line
    case StepKind::Fragment: return 2;
    case StepKind::Shade:
    case StepKind::Write: return 3;
    case StepKind::Resolve: return 2;
    case StepKind::End: break;
    }
    return -1;
}

/// The line that computes crossings in the listing for a step of edge walking: its stages, or what is done in a row.
int crossingLineOf(StepKind kind) { return kind > StepKind::Crossing ? 0 : lineOf(StepKind::Crossing); }

/// The line of the listing for a step of one kind in which a mistake has its code that shows at steps of another, or
/// -1. A mistake about crossings has it where they are computed, though it shows in what follows from them, too.
int wrongLineOf(const Mistake& mistake, StepKind kind, StepKind spoilt)
{
    const bool isCrossing = spoilt == StepKind::Crossing;
    if ((stepsOf(mistake) & kindBit(spoilt)) == 0)
        return -1;
    if ((stepsOf(mistake) & kindBit(StepKind::Crossing)) != 0 && !isCrossing)
        return -1;
    return isCrossing ? crossingLineOf(kind) : lineOf(spoilt);
}

/// Whether all that makes a step of edge walking something else than it should be are wrong crossings.
bool hasWrongCrossings(const StepLog& log, std::size_t i)
{
    const auto causes = becauseOf(log, i);
    return !causes.empty() && std::ranges::all_of(causes, [](const Mistake* mistake) {
        return (stepsOf(*mistake) & kindBit(StepKind::Crossing)) != 0;
    });
}

int lineOf(const StepLog& log, std::size_t i)
{
    const StepEvent& event = log.event(i);
    const bool isFilled = passRules(log.rules(), event.face).fill == Fill::Solid;
    if (event.kind == StepKind::LineSample && isFilled)
        return 1; // of a filled column
    if ((event.kind == StepKind::Halves || event.kind == StepKind::Span) && hasWrongCrossings(log, i))
        return crossingLineOf(event.kind);
    const bool isRejected = event.kind == StepKind::Fate && log.payload<FateStep>(event).fate == FaceFate::Rejected;
    const bool beginsLines = event.kind == StepKind::Triangle && !isFilled;
    const bool isLine = event.kind == StepKind::LineDecision || event.kind == StepKind::LinePosition;
    const auto causes = isLine ? becauseOf(log, i) : std::vector<const Mistake*>();
    const bool leadsToNoSample = std::ranges::any_of(
        causes, [&](const Mistake* mistake) { return (stepsOf(*mistake) & kindBit(event.kind)) == 0; });
    // Nothing has been added to the first position of a line.
    const bool isStart =
        event.kind == StepKind::LinePosition && log.payload<LinePositionStep>(event).position.step == 0;
    if (beginsLines || leadsToNoSample || isStart)
        return lineOf(StepKind::LineSample);
    return lineOf(isRejected ? StepKind::ClipPlane : event.kind);
}

Listing listingFor(const StepLog& log, std::size_t i)
{
    const StepKind kind = log.event(i).kind;
    const auto [code, kinds] = codeFor(log, i);
    std::array<QStringList, 4> wrong;
    for (const Mistake* mistake : log.mistakes())
        for (int k = 0; k < kStepKinds; ++k) {
            const auto spoilt = static_cast<StepKind>(k);
            const int at = (kinds & kindBit(spoilt)) != 0 ? wrongLineOf(*mistake, kind, spoilt) : -1;
            if (at < 0)
                continue;
            QStringList& lines = wrong[std::size_t(at)];
            if (const QString line = QCoreApplication::translate("Mistake", mistake->wrongLine); !lines.contains(line))
                lines << line;
        }
    Listing listing;
    for (std::size_t i = 0; i < code.size(); ++i) {
        if (wrong[i].isEmpty()) {
            listing[i].code = code[i];
            continue;
        }
        const auto indent = code[i].size() - QStringView(code[i]).trimmed().size();
        listing[i] = {QString(indent, QLatin1Char(' ')) + wrong[i].join(QStringLiteral(";  ")), code[i]};
    }
    return listing;
}

QString minus(QString text) { return text.replace(QLatin1Char('-'), QChar(0x2212)); }

/// ` − 8` or ` + 8` for -8: what is taken away.
QString minusOrPlus(double value)
{
    return (value < 0 ? QStringLiteral(" + ") : QStringLiteral(" \u2212 ")) + fullNumber(std::abs(value));
}

/// ` - 8` or ` + 8`
QString signedTerm(double value)
{
    return (value < 0 ? QStringLiteral(" \u2212 ") : QStringLiteral(" + ")) + fullNumber(std::abs(value));
}

/// `8·(3.5 − 8) − 8·(4.5 − 0)`
QString edgeTerms(const StepEdge& edge, double unitsPerSample, const glm::dvec2& point, const glm::dvec2& from)
{
    const auto factor = [](double at, double origin) {
        return QStringLiteral("\u00b7(%1 %2 %3)")
            .arg(fullNumber(at), origin < 0 ? QStringLiteral("+") : QStringLiteral("\u2212"),
                 fullNumber(std::abs(origin)));
    };
    return minus(fullNumber(edge.a / unitsPerSample)) + factor(point.x, from.x) + signedTerm(edge.b / unitsPerSample) +
           factor(point.y, from.y);
}

/// How the value that decides came to be, where it is not what its terms make: ` = 3` else.
QString valueText(const Rules& rules, const QString& direct, const QString& value)
{
    if (direct == value)
        return QStringLiteral(" = ") + value;
    const QString came =
        rules.insideTest == InsideTest::Wrapped32   ? translated(QT_TRANSLATE_NOOP("StepListing", "in 32 bits: %1"))
        : rules.insideTest == InsideTest::Wrapped16 ? translated(QT_TRANSLATE_NOOP("StepListing", "in 16 bits: %1"))
        : addsUpEdgeValues(rules)                   ? translated(QT_TRANSLATE_NOOP("StepListing", "added up: %1"))
                                                    : translated(QT_TRANSLATE_NOOP("StepListing", "rounded: %1"));
    return QStringLiteral(" = %1   %2").arg(direct, came.arg(value));
}

/// `E_AB >= t_AB = 0: inside`
QString edgeVerdict(const StepSetup& setup, const DecidingEdge& decides)
{
    const int edge = int(decides.edge);
    const EdgeSide side = setup.edges[decides.edge].side;
    const char* const sign = decides.sign == DecidingEdge::Sign::AtLeast  ? ">="
                             : decides.sign == DecidingEdge::Sign::AtMost ? "<="
                                                                          : "<";
    QString verdict = decides.isInside() ? translated(QT_TRANSLATE_NOOP("StepListing", "inside"))
                                         : translated(QT_TRANSLATE_NOOP("StepListing", "outside"));
    if (decides.isTie())
        verdict = (decides.isInside() ? translated(QT_TRANSLATE_NOOP("StepListing", "owned: %1 is a %2 edge"))
                                      : translated(QT_TRANSLATE_NOOP("StepListing", "not owned: %1 is a %2 edge")))
                      .arg(edgeName(setup, edge), side == EdgeSide::Neither
                                                      ? translated(QT_TRANSLATE_NOOP("StepListing", "right or bottom"))
                                                      : edgeSideText(side));
    return printedSigns(QStringLiteral("%1 %2 %3 = %4: %5")
                            .arg(edgeValueName(setup, edge), QLatin1String(sign), thresholdName(setup, edge),
                                 thresholdText(decides.threshold, setup.unitsPerArea), verdict));
}

QString sampleFormula(const StepLog& log, const StepEvent& event)
{
    const StepSetup& setup = log.triangle(event)->setup;
    const Rules& rules = log.rules();
    const EdgeValues& values = log.payload<SampleStep>(event).values;
    const DecidingEdge decides = decidingEdge(setup, values, rules);
    const StepEdge& edge = setup.edges[decides.edge];
    const QString name = edgeValueName(setup, int(decides.edge));
    const auto area = [&](double value) { return minus(edgeValueText(value, setup.unitsPerArea)); };

    // Positions that are shifted by half a sample: samples that are tested at their corner.
    const glm::dvec2 tested =
        testedPoint(rules, event.x, event.y, event.sample) + cornerAsked(setup, decides.edge, rules);
    const glm::dvec2 point = tested - rules.screenShift;
    const glm::dvec2 from = glm::dvec2(edge.from) / setup.unitsPerSample - rules.screenShift;
    QStringList others;
    for (std::size_t i = 0; i < 3; ++i)
        if (i != decides.edge)
            others << QStringLiteral("%1 = %2").arg(edgeValueName(setup, int(i)), area(values[i]));
    QString text =
        QStringLiteral("%1(%2, %3) = %4%5\n%6   %7")
            .arg(name, fullNumber(point.x), fullNumber(point.y), edgeTerms(edge, setup.unitsPerSample, point, from),
                 valueText(rules, area(setup.at(tested)[decides.edge]), area(decides.value)),
                 edgeVerdict(setup, decides), others.join(QStringLiteral("   ")));
    if (addsUpEdgeValues(rules)) {
        const QString step =
            edge.perX < 0 ? QStringLiteral("\u2212= ") + area(-edge.perX) : QStringLiteral("+= ") + area(edge.perX);
        text += QStringLiteral("   ") + translated(QT_TRANSLATE_NOOP("StepListing", "next x: %1 %2")).arg(name, step);
    }
    return text;
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

/// `1012`, `0.534759`: as many digits whatever the size, so that sums can be added up again.
QString sixDecimals(double value)
{
    QString text = QString::number(value, 'f', 6);
    while (text.endsWith(QLatin1Char('0')))
        text.chop(1);
    if (text.endsWith(QLatin1Char('.')))
        text.chop(1);
    return text == QLatin1String("-0") ? QStringLiteral("0") : text;
}

/// `y_4 = 3.9 + 0.3 = 4.2   x_4 = 7`, `round(y_4) = 4   error = 4.2 − 4 = 0.2`
QString positionFormula(const StepLog& log, const StepEvent& event)
{
    const LinePosition& p = log.payload<LinePositionStep>(event).position;
    const auto axis = [&](const char* name, double at, double perStep) {
        const QString added =
            QStringLiteral("%1 %2 %3 = ")
                .arg(minus(sixDecimals(at - perStep)), perStep < 0 ? QStringLiteral("\u2212") : QStringLiteral("+"),
                     sixDecimals(std::abs(perStep)));
        return QStringLiteral("%1_%2 = %3%4")
            .arg(QLatin1String(name))
            .arg(p.step)
            .arg(p.step > 0 ? added : QString(), minus(sixDecimals(at)));
    };
    const QString x = axis("x", p.x, p.perStepX);
    const QString y = axis("y", p.y, p.perStepY);
    const double at = p.steep() ? p.x : p.y;
    const int rounded = p.steep() ? p.column : p.row;
    return QStringLiteral("%1   %2\nround(%3_%4) = %5   error = %6 \u2212 %7 = %8")
        .arg(p.steep() ? x : y, p.steep() ? y : x, p.steep() ? QStringLiteral("x") : QStringLiteral("y"))
        .arg(p.step)
        .arg(minus(QString::number(rounded)), minus(sixDecimals(at)),
             rounded < 0 ? QStringLiteral("(%1)").arg(minus(QString::number(rounded))) : QString::number(rounded),
             minus(sixDecimals(p.error())));
}

/// The sum of each channel: two in the first line, one in the second with what counts as black.
QString resolveFormula(const StepLog& log, const StepEvent& event)
{
    const ResolvedPixel& pixel = log.payload<ResolveStep>(event).pixel;
    const QStringList sums = meanWords(pixel);
    QString text = sums[0] + QStringLiteral("   ") + sums[1] + QLatin1Char('\n') + sums[2];
    if (pixel.black != 0)
        text += QStringLiteral("   ") + translated(QT_TRANSLATE_NOOP("StepListing", "%1 of %2 samples count as black"))
                                            .arg(std::popcount(pixel.black))
                                            .arg(pixel.count);
    return text;
}

/// The part that decides first: the other may have to do with dots in its middle.
QString joined(const StepParts& parts, bool numbersFirst)
{
    QStringList lines{stepWords(parts.what), stepWords(parts.numbers)};
    if (numbersFirst)
        lines.swapItemsAt(0, 1);
    lines.removeAll(QString());
    return lines.join(QLatin1Char('\n'));
}

/// Each edge on a line of its own.
QString setupFormula(const StepLog& log, std::size_t i)
{
    static const QRegularExpression between(QStringLiteral("; |\uff1b"));
    return joined(stepParts(log, i), false).replace(between, QStringLiteral("\n"));
}

QString formulaOf(const StepLog& log, std::size_t i)
{
    const StepEvent& event = log.event(i);
    switch (event.kind) {
    case StepKind::Sample: return sampleFormula(log, event);
    case StepKind::Span: {
        const QStringList lines = spanLines(log.payload<SpanStep>(event), Digits::All);
        return lines[0] + QLatin1Char('\n') + lines[1] + QStringLiteral("   ") + lines[2];
    }
    case StepKind::LineDecision: return lineFormula(log, event);
    case StepKind::LinePosition: return positionFormula(log, event);
    case StepKind::Crossing: return crossingLines(log, event).join(QLatin1Char('\n'));
    case StepKind::Resolve: return resolveFormula(log, event);
    case StepKind::Fragment: return joined(stepParts(log, i), true);
    case StepKind::Setup: return setupFormula(log, i);
    case StepKind::Vertex:
    case StepKind::ClipPlane:
    case StepKind::CohenSutherland:
    case StepKind::Viewport:
    case StepKind::Facing:
    case StepKind::Clipped:
    case StepKind::Fate:
    case StepKind::Triangle:
    case StepKind::Outline:
    case StepKind::Walk:
    case StepKind::Sides:
    case StepKind::Halves:
    case StepKind::Column:
    case StepKind::LineSample:
    case StepKind::Shade:
    case StepKind::Write:
    case StepKind::End: break;
    }
    return joined(stepParts(log, i), false);
}

QString nineDigits(double value) { return minus(QString::number(value, 'g', 9)); }

/// How a crossing came to be where it is not what the formula makes of the printed numbers.
QString crossingText(const Rules& rules, double direct, double walked)
{
    constexpr double kSame = 1e-12;
    if (direct == walked || std::abs(direct - walked) <= kSame * (1 + std::abs(walked)))
        return QStringLiteral(" = ") + nineDigits(walked);
    const QString came = rules.stepping == Stepping::Incremental
                             ? translated(QT_TRANSLATE_NOOP("StepListing", "added up: %1"))
                             : translated(QT_TRANSLATE_NOOP("StepListing", "rounded: %1"));
    return QStringLiteral(" = %1   %2").arg(nineDigits(direct), came.arg(nineDigits(walked)));
}

/// `alpha = (3.5 − 1) / (10 − 1) = 0.277778   xa = 7 + 0.277778·(2 − 7) = 5.61111`
QString crossingLine(const Rules& rules, const QString& fraction, const QString& crossing, const glm::dvec2& from,
                     const glm::dvec2& to, double y, double way, double x)
{
    const QString height = QStringLiteral("%1%2").arg(
        minus(fullNumber(to.y)) + minusOrPlus(from.y),
        rules.extraEdgeHeight != 0 ? QStringLiteral(" + %1").arg(rules.extraEdgeHeight) : QString());
    return QStringLiteral("%1 = (%2%3) / (%4) = %5   %6 = %7 + %5\u00b7(%8%9)")
               .arg(fraction, minus(fullNumber(y)), minusOrPlus(from.y), height, minus(shortNumber(way)), crossing,
                    minus(fullNumber(from.x)), minus(fullNumber(to.x)), minusOrPlus(from.x)) +
           crossingText(rules, from.x + way * (to.x - from.x), x);
}

} // namespace

QStringList crossingLines(const StepLog& log, const StepEvent& event)
{
    const RowCrossings& row = log.payload<CrossingStep>(event).row;
    const WalkedTriangle* walk = walkOf(log, event);
    if (walk == nullptr)
        return {minus(shortNumber(row.alpha)), minus(shortNumber(row.beta))};
    const auto& v = walk->vertices;
    const double y = row.height;
    const std::size_t from = row.upperHalf ? 0 : 1;
    return {crossingLine(log.rules(), QStringLiteral("alpha"), QStringLiteral("xa"), v[0], v[2], y, row.alpha, row.xa),
            crossingLine(log.rules(), QStringLiteral("beta"), QStringLiteral("xb"), v[from], v[from + 1], y, row.beta,
                         row.xb)};
}

QStringList spanLines(const SpanStep& span, Digits digits)
{
    const SpanEnds& ends = span.ends;
    const auto end = [&](const char* name, double from, bool ceiling, std::int64_t to) {
        const auto round = [&](double at) {
            const double shifted = ends.whole ? at : at - 0.5;
            return ceiling && !ends.whole ? std::ceil(shifted) : std::floor(shifted);
        };
        const QString brief = shortNumber(from);
        const bool isEnough = digits == Digits::Few && round(brief.toDouble()) == round(from);
        const QString number = minus(isEnough ? brief : fullNumber(from));
        const QString rounded = ends.whole ? ceiling ? QStringLiteral("floor(%1)") : QStringLiteral("floor(%1) + 1")
                                : ceiling ? QStringLiteral("ceil(%1 \u2212 0.5)")
                                           : QStringLiteral("floor(%1 \u2212 0.5) + 1");
        return QStringLiteral("%1 = %2   %3 = %4").arg(QLatin1String(name), number, rounded.arg(number)).arg(to);
    };
    return {end("xl", ends.left, ends.whole || ends.leftOwnsTie, ends.begin),
            end("xr", ends.right, !ends.whole && !ends.rightOwnsTie, ends.end),
            span.xBegin < span.xEnd ? QStringLiteral("x = %1 \u2026 %2").arg(span.xBegin).arg(span.xEnd - 1)
                                    : translated(QT_TRANSLATE_NOOP("StepListing", "no sample"))};
}

StepExplanation explainStep(const StepLog& log, std::size_t i)
{
    StepExplanation told{listingFor(log, i), lineOf(log, i), formulaOf(log, i)};
    if (const QString because = becauseWords(becauseOf(log, i)); !because.isEmpty()) {
        if (!told.formula.isEmpty())
            told.formula += QLatin1Char('\n');
        told.formula += because;
    }
    return told;
}

QString stepTitle(const StepLog& log, std::size_t i)
{
    const StepEvent& event = log.event(i);
    QStringList parts{translated(infoOf(event.kind).title)};
    if (event.has(StepEvent::kTie))
        parts << translated(QT_TRANSLATE_NOOP("StepListing", "tie"));
    if (event.kind == StepKind::Column)
        parts << QStringLiteral("x = %1").arg(event.x);
    else if (event.kind == StepKind::Resolve)
        parts << translated(QT_TRANSLATE_NOOP("StepListing", "pixel (%1, %2)"))
                     .arg(event.x / log.grid())
                     .arg(event.y / log.grid());
    else if (event.x >= 0)
        parts << QStringLiteral("(%1, %2)").arg(event.x).arg(event.y);
    else if (event.y >= 0)
        parts << translated(QT_TRANSLATE_NOOP("StepListing", "row %1")).arg(event.y);
    if (isOfPattern(log, event))
        parts << translated(QT_TRANSLATE_NOOP("StepListing", "sample %1")).arg(event.sample + 1);
    if (event.face != StepEvent::kNone)
        parts << translated(QT_TRANSLATE_NOOP("StepListing", "face %1")).arg(event.face);
    if (const QString because = becauseWords(becauseOf(log, i)); !because.isEmpty())
        parts << because;
    return parts.join(QStringLiteral(" \u00b7 "));
}

} // namespace rasterlens
