#pragma once
// What the sentences of a step say, read back: each is held against its own numbers.
#include "core/observe/because.h"
#include "core/observe/step_text.h"
#include "core/settings/depth_rules.h"
#include "ui/steps/lens_model.h"
#include "ui/steps/step_formula.h"

#include <QRegularExpression>

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <vector>

namespace rasterlens::test
{

/// Signs of books as those of keyboards.
inline QString plain(QString text)
{
    return text.replace(QChar(0x2212), QLatin1Char('-'))
        .replace(QChar(0x2264), QStringLiteral("<="))
        .replace(QChar(0x2265), QStringLiteral(">="))
        .replace(QChar(0x2192), QStringLiteral("->"))
        .replace(QChar(0x00b7), QLatin1Char('*'))
        .replace(QChar(0x00a0), QLatin1Char(' '));
}

inline bool holds(double a, const QString& sign, double b)
{
    if (sign == QStringLiteral("<"))
        return a < b;
    if (sign == QStringLiteral("<="))
        return a <= b;
    if (sign == QStringLiteral(">"))
        return a > b;
    return a >= b;
}

/// `3`, `-0.5`, `1/65536`, `nan`
inline double number(const QString& text)
{
    const qsizetype over = text.indexOf(QLatin1Char('/'));
    return over < 0 ? text.toDouble() : text.left(over).toDouble() / text.sliced(over + 1).toDouble();
}

inline bool isNear(double a, double b, double tolerance)
{
    return a == b || std::abs(a - b) <= tolerance || (a != a && b != b);
}

/// What a text says that is false; empty: nothing.
class Reader
{
public:
    [[nodiscard]] const QString& complaint() const { return m_complaint; }

    void expect(bool isTrue, const QString& text, const char* what)
    {
        if (!isTrue && m_complaint.isEmpty())
            m_complaint = QLatin1String(what) + QStringLiteral(": ") + text;
    }

    /// `0.5 < 1: passed`, `not 0.5 < 0.2`
    void readComparisons(const QString& text)
    {
        static const QRegularExpression verdict(
            QStringLiteral("(?:depth|z) (\\S+) (<=?|>=?) (\\S+?)[:,] (passed|failed)"));
        for (const auto& match : verdict.globalMatch(text))
            expect(holds(number(match.captured(1)), match.captured(2), number(match.captured(3))) ==
                       (match.captured(4) == QStringLiteral("passed")),
                   text, "depth test");
        static const QRegularExpression denial(QStringLiteral("not (\\S+) (<=?|>=?) ([^\\s;]+)"));
        for (const auto& match : denial.globalMatch(text))
            expect(!holds(number(match.captured(1)), match.captured(2), number(match.captured(3))), text,
                   "failed depth test");
    }

private:
    QString m_complaint;
};

/// `E_AB(3.5, 4.5) = 8*(3.5 - 8) - 8*(4.5 - 0) = -0.5` and the verdict below it.
inline void readSample(const StepLog& log, const StepEvent& event, const QString& formula, Reader& reader)
{
    static const QRegularExpression terms(
        QStringLiteral("^(E_\\w\\w)\\((\\S+), (\\S+)\\) = (\\S+)\\*\\((\\S+) ([-+]) (\\S+)\\) ([-+]) "
                       "(\\S+)\\*\\((\\S+) ([-+]) (\\S+)\\) = (\\S+)(?:   [^:\n]+: (\\S+))?\n"));
    static const QRegularExpression verdict(
        QStringLiteral("(E_\\w\\w) (>=|<=|<) (t_\\w\\w) = (\\S+): (inside|outside|owned|not owned)"));
    const auto left = terms.match(formula);
    const auto right = verdict.match(formula);
    reader.expect(left.hasMatch() && right.hasMatch(), formula, "sample");
    if (!left.hasMatch() || !right.hasMatch())
        return;
    const auto n = [&](int i) { return number(left.captured(i)); };
    const auto signOf = [&](int i) { return left.captured(i) == QStringLiteral("-") ? -1.0 : 1.0; };
    reader.expect(n(2) == n(5) && n(3) == n(10), formula, "point of the sample");
    const double x = n(4) * (n(5) + signOf(6) * n(7));
    const double y = n(9) * (n(10) + signOf(11) * n(12));
    const double sum = x + signOf(8) * y;
    reader.expect(isNear(sum, n(13), 1e-9 * (std::abs(x) + std::abs(y)) + 1e-12), formula, "edge function");
    const double value = left.captured(14).isEmpty() ? n(13) : n(14);
    reader.expect(left.captured(1) == right.captured(1) && left.captured(1).sliced(2) == right.captured(3).sliced(2),
                  formula, "names of edge and threshold");
    reader.expect(holds(value, right.captured(2), number(right.captured(4))) || value != value, formula, "threshold");
    const bool inside = right.captured(5) == QStringLiteral("inside") || right.captured(5) == QStringLiteral("owned");
    reader.expect(inside == event.has(StepEvent::kCovered), formula, "verdict of the sample");
    const StepSetup& setup = log.triangle(event)->setup;
    const EdgeValues& values = log.payload<SampleStep>(event).values;
    static const QRegularExpression other(QStringLiteral("   E_(\\w\\w) = (\\S+)"));
    for (const auto& match : other.globalMatch(formula))
        for (int i = 0; i < 3; ++i)
            if (edgeName(setup, i) == match.captured(1))
                reader.expect(isNear(number(match.captured(2)), values[std::size_t(i)] / setup.unitsPerArea,
                                     1e-9 * std::abs(values[std::size_t(i)])),
                              formula, "other edge value");
}

/// `xl = 1.5   ceil(1.5 - 0.5) = 1`, or in whole numbers `xl = 1.5   floor(1.5) = 1`
inline void readSpan(const SpanStep& span, const QString& formula, Reader& reader)
{
    static const QRegularExpression end(
        QStringLiteral("x[lr] = (\\S+)   (ceil|floor)\\((\\S+?)( - 0.5)?\\)( \\+ 1)? = (-?\\d+)"));
    int ends = 0;
    for (const auto& match : end.globalMatch(formula)) {
        ++ends;
        const double v = number(match.captured(1));
        const bool isWhole = match.captured(4).isEmpty();
        const double from = isWhole ? v : v - 0.5;
        const double rounded = (match.captured(2) == QStringLiteral("ceil") ? std::ceil(from) : std::floor(from)) +
                               (match.captured(5).isEmpty() ? 0 : 1);
        reader.expect(isWhole == span.ends.whole && number(match.captured(3)) == v &&
                          rounded == number(match.captured(6)),
                      formula, "end of a span");
    }
    reader.expect(ends == 2, formula, "ends of a span");
    static const QRegularExpression range(QStringLiteral("x = (-?\\d+) \u2026 (-?\\d+)"));
    const auto filled = range.match(formula);
    reader.expect(filled.hasMatch() == (span.xBegin < span.xEnd), formula, "samples of a span");
}

/// `p_0 = 3 > 0 .. p_1 = 3 + 2*1 - 2*5 = -5`; a cause stands behind it
inline void readLine(const QString& formula, Reader& reader)
{
    static const QRegularExpression decision(
        QStringLiteral("^p_(\\d+) = (-?\\d+) (>|<=) 0   d_lower = (\\S+)   d_upper = (\\S+)\n"
                       "p_(\\d+) = (-?\\d+) \\+ "
                       "2\\*(\\d+)(?: - 2\\*(\\d+))? = (-?\\d+)"));
    const auto match = decision.match(formula);
    reader.expect(match.hasMatch(), formula, "line decision");
    const auto n = [&](int i) { return number(match.captured(i)); };
    reader.expect(holds(n(2), match.captured(3), 0) && n(2) == n(7) && n(6) == n(1) + 1, formula, "sign of p");
    reader.expect(n(7) + 2 * n(8) - 2 * n(9) == n(10), formula, "next p");
    reader.expect((n(4) > n(5)) == (n(2) > 0) || isNear(n(4), n(5), 1e-5), formula, "nearer sample");
}

/// `y_4 = 3.9 + 0.3 = 4.2   x_4 = 7`, `round(y_4) = 4   error = 4.2 - 4 = 0.2`
inline void readPosition(const QString& formula, Reader& reader)
{
    static const QRegularExpression position(QStringLiteral(
        "^([xy])_(\\d+) = (?:(\\S+) ([+-]) (\\S+) = )?(\\S+)   ([xy])_\\2 = (?:\\S+ [+-] \\S+ = )?(-?\\d+)"
        "\nround\\(\\1_\\2\\) = (-?\\d+)   error = (\\S+) - \\(?(-?\\d+)\\)? = (\\S+)(?:\nbecause of [^\n]*)?$"));
    const auto match = position.match(formula);
    reader.expect(match.hasMatch(), formula, "line position");
    const auto n = [&](int i) { return number(match.captured(i)); };
    reader.expect(match.captured(1) != match.captured(7), formula, "axes");
    reader.expect((n(2) > 0) == !match.captured(3).isEmpty(), formula, "an addition but for the first");
    const double added = match.captured(4) == QLatin1String("-") ? -n(5) : n(5);
    reader.expect(n(2) == 0 || isNear(n(3) + added, n(6), 1e-3), formula, "sum");
    reader.expect(n(9) == n(11) && n(6) == n(10) && std::abs(n(6) - n(9)) <= 0.5001, formula, "nearest");
    reader.expect(isNear(n(10) - n(11), n(12), 1e-3), formula, "error");
}

/// `(437.914, 772.335) -> (437.9140625, 772.3359375), depth 0.5, 1/w 0.2`
inline void readViewport(const StepLog& log, const ViewportStep& step, const QString& text, Reader& reader)
{
    static const QRegularExpression snapping(QStringLiteral(
        "\\((\\S+), (\\S+)\\) -> \\((\\S+), (\\S+)\\), depth (\\S+), (?:1/w (\\S+)|(\\S+) in place of)"));
    const auto match = snapping.match(text);
    reader.expect(match.hasMatch(), text, "viewport");
    const Rules& rules = log.rules();
    const auto n = [&](int i) { return number(match.captured(i)); };
    const double unit =
        rules.numberType == NumberType::Fixed ? double(rules.sampleGrid) / (1 << rules.subpixelBits) : 0;
    const double most = rules.verticesTruncated ? 1 + unit : rules.rowsRounded ? 0.5 + unit : unit / 2;
    if (rules.cutStore == CutStore::LastUnwritten && n(3) == 0 && n(4) == 0)
        return; // a corner that was never written
    for (const int axis : {1, 2})
        if (std::abs(n(axis)) < 1e5)
            reader.expect(isNear(n(axis), n(axis + 2), most * 1.01 + 1e-5 * std::abs(n(axis)) + 1e-9), text,
                          "snapping");
    if (!match.captured(6).isEmpty())
        reader.expect(isNear(n(6) * step.positionClip.w, 1, 1e-5), text, "1/w");
}

inline void readFacing(const StepLog& log, const FacingDecision& decision, const QString& text, Reader& reader)
{
    static const QRegularExpression facing(QStringLiteral("facing [^:]+: (\\S+) (\\S+), screen area (\\S+): (\\S+)$"));
    const auto match = facing.match(text);
    reader.expect(match.hasMatch(), text, "facing");
    const Rules& rules = log.rules();
    const double value = number(match.captured(2)) * rules.frontSign;
    const double area = number(match.captured(3));
    const QString fate = match.captured(4);
    if (fate == QStringLiteral("culled-back"))
        reader.expect(value < 0 && rules.culling == Culling::Back, text, "back face");
    else if (fate == QStringLiteral("culled-front"))
        reader.expect(value > 0 && rules.culling == Culling::Front, text, "front face");
    else if (fate == QStringLiteral("degenerate"))
        reader.expect(area == 0 || std::abs(area) < rules.smallestArea2 || number(match.captured(2)) == 0, text,
                      "no area");
    else
        reader.expect(fate == QStringLiteral("rasterized") && decision.fate == FaceFate::Rasterized, text, "fate");
}

inline void readClip(const ClipStep& step, const QString& text, Reader& reader)
{
    static const QRegularExpression counts(QStringLiteral(": (\\d+) -> (\\d+) vertices"));
    const auto match = counts.match(text);
    reader.expect(match.captured(1).toULongLong() == step.before.size() &&
                      match.captured(2).toULongLong() == step.after.size(),
                  text, "vertices of the polygon");
    static const QRegularExpression cut(QStringLiteral("([ABC]|I\\d+)->([ABC]|I\\d+) t=(\\S+?)(?:,|$)"));
    std::size_t told = 0;
    for (const auto& one : cut.globalMatch(text)) {
        reader.expect(one.captured(1) != one.captured(2), text, "ends of a cut edge");
        if (++told > step.cuts.size())
            break;
        const ClipCut& made = step.cuts[told - 1];
        const double inside = step.distances[std::size_t(made.inside)];
        const double outside = step.distances[std::size_t(made.outside)];
        reader.expect(inside >= 0 && !(outside >= 0) &&
                          isNear(number(one.captured(3)), inside / (inside - outside), 1e-5),
                      text, "cut");
    }
    reader.expect(told == step.cuts.size(), text, "every cut");
}

/// The least and the greatest row of a column are those of its list.
inline void readColumn(const FilledColumn& column, const QString& text, Reader& reader)
{
    static const QRegularExpression list(QStringLiteral("\\[([^\\]]*)\\].*min (-?\\d+)(?: to|,) max (-?\\d+)"));
    const auto match = list.match(text);
    reader.expect(match.hasMatch() == (column.count > 0), text, "column");
    if (!match.hasMatch())
        return;
    std::vector<int> rows;
    for (const QString& row : match.captured(1).split(QStringLiteral(", ")))
        rows.push_back(row.toInt());
    reader.expect(rows.size() == std::size_t(column.count) &&
                      std::ranges::equal(rows, std::span(column.rows).first(rows.size())),
                  text, "rows of a column");
    reader.expect(match.captured(2).toInt() == std::ranges::min(rows) &&
                      match.captured(3).toInt() == std::ranges::max(rows),
                  text, "ends of a column");
}

/// `alpha = (3.5 - 1) / (10 - 1) = 0.277778   xa = 7 + 0.277778*(2 - 7) = 5.61111`
inline void readCrossingLine(const QString& line, double fraction, double crossing, Reader& reader)
{
    static const QRegularExpression terms(QStringLiteral(
        "(?:alpha|beta) = \\((\\S+) ([-+]) (\\S+)\\) / \\((\\S+) ([-+]) (\\S+?)(?: \\+ (\\d+))?\\) = (\\S+)"
        "   x[ab] = (\\S+) \\+ (\\S+)\\*\\((\\S+) ([-+]) (\\S+)\\) = (\\S+)(?:   [^:\n]+: (\\S+))?"));
    const auto match = terms.match(line);
    reader.expect(match.hasMatch(), line, "crossing");
    if (!match.hasMatch())
        return;
    const auto n = [&](int i) { return number(match.captured(i)); };
    const auto sum = [&](int i) {
        return n(i) + (match.captured(i + 1) == QStringLiteral("-") ? -n(i + 2) : n(i + 2));
    };
    reader.expect(isNear(sum(1) / (sum(4) + n(7)), n(8), 1e-5 * std::abs(n(8)) + 1e-12), line, "fraction of an edge");
    reader.expect(isNear(n(8), fraction, 1e-5 * std::abs(fraction)) && n(8) == n(10), line, "fraction of the step");
    reader.expect(isNear(n(9) + fraction * sum(11), n(14), 1e-8 * (1 + std::abs(n(9)) + std::abs(sum(11)))), line,
                  "point of an edge");
    const double walked = match.captured(15).isEmpty() ? n(14) : n(15);
    reader.expect(isNear(walked, crossing, 1e-8 * (1 + std::abs(crossing))), line, "crossing of the step");
}

inline void readCrossing(const RowCrossings& row, const QString& formula, Reader& reader)
{
    const QStringList lines = formula.split(QLatin1Char('\n'));
    reader.expect(lines.size() >= 2, formula, "crossings");
    if (lines.size() < 2)
        return;
    readCrossingLine(lines[0], row.alpha, row.xa, reader);
    readCrossingLine(lines[1], row.beta, row.xb, reader);
}

/// `R = (240 + 164 + 0 + 1) / 4 = 101.25 -> 101`
inline void readResolve(const ResolvedPixel& pixel, const QString& formula, Reader& reader)
{
    static const QRegularExpression sums(QStringLiteral("([RGB]) = \\(([\\d+ ]+)\\) / (\\d+) = (\\S+)(?: -> (\\d+))?"));
    int channels = 0;
    for (const auto& match : sums.globalMatch(formula)) {
        const int shift = match.captured(1) == QStringLiteral("R")   ? 16
                          : match.captured(1) == QStringLiteral("G") ? 8
                                                                     : 0;
        double sum = 0;
        int terms = 0;
        for (const QString& term : match.captured(2).split(QStringLiteral(" + "))) {
            sum += term.toDouble();
            ++terms;
        }
        const double mean = sum / match.captured(3).toInt();
        reader.expect(terms == pixel.count && isNear(mean, number(match.captured(4)), 1e-5 * mean), formula, "mean");
        const double rounded = match.captured(5).isEmpty() ? number(match.captured(4)) : number(match.captured(5));
        reader.expect(rounded == double(pixel.color >> shift & 255U) && std::abs(rounded - mean) <= 0.5, formula,
                      "rounded mean");
        ++channels;
    }
    reader.expect(channels == 3, formula, "channels of a mean");
}

/// What the sentences of a whole record tell, counted.
struct Told {
    std::uint64_t passed = 0;
    std::uint64_t failed = 0;
    std::map<QString, std::uint64_t> fates;

    void add(const StepEvent& event, const QString& text)
    {
        if (event.kind == StepKind::Fragment) {
            passed += text.contains(QStringLiteral(": passed")) ? 1 : 0;
            failed += text.contains(QStringLiteral(": failed")) ? 1 : 0;
        }
        if (event.kind == StepKind::Fate)
            ++fates[text.section(QStringLiteral(": "), -1)];
    }
    [[nodiscard]] bool agrees(const Statistics& counted) const
    {
        const auto fate = [&](const char* id) {
            const auto at = fates.find(QLatin1String(id));
            return at == fates.end() ? 0 : at->second;
        };
        return passed == counted.pixels.depthPassed && failed == counted.pixels.depthFailed &&
               fate("rejected") == counted.faces.rejected && fate("culled-back") == counted.faces.culledBack &&
               fate("culled-front") == counted.faces.culledFront && fate("degenerate") == counted.faces.degenerate &&
               fate("non-finite") == counted.faces.nonFinite && fate("rasterized") == counted.faces.rasterized;
    }
};

/// The line of the listing that is run is the wrong one exactly where a mistake says so, and the cause is named.
inline void readExplanation(const StepLog& log, std::size_t i, const StepExplanation& told, Reader& reader)
{
    const QString title = stepTitle(log, i);
    const auto causes = becauseOf(log, i);
    for (const Mistake* mistake : causes) {
        const QString name = QStringLiteral("%1 %2").arg(QLatin1String(mistake->number), QLatin1String(mistake->title));
        reader.expect(told.formula.contains(name) && told.formula.contains(QStringLiteral("because of ")), told.formula,
                      "cause in the formula");
        reader.expect(title.contains(name), title, "cause in the caption");
        const ListingLine line = told.line < 0 ? ListingLine() : told.listing[std::size_t(told.line)];
        reader.expect(told.line < 0 || line.code.contains(QString::fromUtf8(mistake->wrongLine)), line.code,
                      "wrong line");
        reader.expect(told.line < 0 || !line.right.isEmpty(), line.code, "right line");
    }
    reader.expect(!causes.empty() || !told.formula.contains(QStringLiteral("because of")), told.formula, "no cause");
    for (const ListingLine& line : told.listing)
        reader.expect(!log.mistakes().empty() || line.right.isEmpty(), line.right, "struck through");
}

/// The lens says of a sample what the log says.
inline void readLens(const StepLog& log, std::size_t i, Reader& reader)
{
    const StepEvent& event = log.event(i);
    const auto triangles = log.eventsOf(StepKind::Triangle);
    const auto triangle =
        std::ranges::find(triangles, event.triangle, [&](std::uint32_t k) { return log.event(k).triangle; });
    const LensModel model(log, log.event(*triangle), i + 1);
    const LensCell cell = model.cell(event.x, event.y);
    if (cell.state == LensCell::State::OutOfBounds) // samples of whole pixels are tested beyond the bounds
        return;
    reader.expect((cell.state == LensCell::State::Covered) == event.has(StepEvent::kCovered), QString(), "lens state");
    if (!cell.hasValues || cell.state == LensCell::State::Waiting)
        return;
    const QString text = plain(lensCellText(model.triangle().setup, cell));
    if (cell.tie)
        reader.expect(text.endsWith(QStringLiteral("not ours")) != event.has(StepEvent::kCovered), text,
                      "tie of the lens");
    else if (log.rules().insideTest == InsideTest::AllPositive && log.rules().floatTieUnit == 0)
        reader.expect((number(text) > 0) == event.has(StepEvent::kCovered) || number(text) != number(text), text,
                      "sign of the lens");
}

inline void readEvent(const StepLog& log, std::size_t i, const QString& text, Reader& reader)
{
    const StepEvent& event = log.event(i);
    reader.readComparisons(text);
    const StepExplanation told = explainStep(log, i);
    const QString formula = plain(told.formula);
    reader.readComparisons(formula);
    readExplanation(log, i, told, reader);
    switch (event.kind) {
    case StepKind::Sample:
        reader.expect(text.contains(QStringLiteral("  inside")) == event.has(StepEvent::kCovered), text, "sample");
        readSample(log, event, formula, reader);
        readLens(log, i, reader);
        break;
    case StepKind::Span: readSpan(log.payload<SpanStep>(event), formula, reader); break;
    case StepKind::LineDecision: readLine(formula, reader); break;
    case StepKind::LinePosition: readPosition(formula, reader); break;
    case StepKind::Crossing: readCrossing(log.payload<CrossingStep>(event).row, formula, reader); break;
    case StepKind::Resolve: readResolve(log.payload<ResolveStep>(event).pixel, formula, reader); break;
    case StepKind::Column: readColumn(log.payload<ColumnFillStep>(event).column, text, reader); break;
    case StepKind::Viewport: readViewport(log, log.payload<ViewportStep>(event), text, reader); break;
    case StepKind::Facing: readFacing(log, log.payload<FacingStep>(event).decision, text, reader); break;
    case StepKind::ClipPlane: readClip(log.payload<ClipStep>(event), text, reader); break;
    case StepKind::Fragment:
        reader.expect(text.contains(QStringLiteral(": passed")) == event.has(StepEvent::kPassed), text, "fragment");
        reader.expect(text.contains(QStringLiteral("compared with nothing")) ==
                          QLatin1String(depthSign(log.rules(), event.face)).isEmpty(),
                      text, "comparison");
        break;
    case StepKind::Vertex:
    case StepKind::CohenSutherland:
    case StepKind::Clipped:
    case StepKind::Fate:
    case StepKind::Triangle:
    case StepKind::Setup:
    case StepKind::Outline:
    case StepKind::Walk:
    case StepKind::Sides:
    case StepKind::Halves:
    case StepKind::LineSample:
    case StepKind::Shade:
    case StepKind::Write:
    case StepKind::End: break;
    }
}

} // namespace rasterlens::test
