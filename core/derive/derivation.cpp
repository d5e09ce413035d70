#include "core/derive/derivation.h"

#include "core/base/closed_list.h"
#include "core/observe/names.h"

#include <QCoreApplication>
#include <QJsonArray>

#include <algorithm>
#include <array>

namespace rasterlens
{
namespace
{

struct CanvasKindInfo {
    CanvasKind kind;
    const char* id;
};

constexpr auto kCanvasKinds = std::to_array<CanvasKindInfo>({
    {CanvasKind::Nothing, "nothing"},
    {CanvasKind::Edge, "edge"},
    {CanvasKind::Vector, "vector"},
    {CanvasKind::Area, "area"},
    {CanvasKind::Point, "point"},
    {CanvasKind::Corner, "corner"},
    {CanvasKind::Sample, "sample"},
    {CanvasKind::Plane, "plane"},
    {CanvasKind::Row, "row"},
    {CanvasKind::Column, "column"},
});
static_assert(isClosedList(kCanvasKinds, &CanvasKindInfo::kind));

QJsonArray toJson(const glm::dvec2& point) { return {point.x, point.y}; }

QJsonObject toJson(const CanvasPart& part)
{
    QJsonArray points;
    for (const glm::dvec2& point : part.points)
        points.append(toJson(point));
    return {{"kind", QLatin1String(canvasKindId(part.kind))}, {"name", part.name}, {"points", points}};
}

QJsonArray toJson(const std::vector<DerivationToken>& tokens, const Derivation& derivation)
{
    QJsonArray array;
    for (const DerivationToken& token : tokens) {
        QJsonObject object{{"text", token.text}};
        if (token.symbol >= 0)
            object.insert(QStringLiteral("symbol"), derivation.symbols[std::size_t(token.symbol)].id);
        array.append(object);
    }
    return array;
}

QJsonObject toJson(const DerivationSymbol& symbol)
{
    QJsonObject object{{"id", symbol.id}, {"name", symbol.name}, {"value", symbol.value}};
    if (!symbol.exact.isEmpty())
        object.insert(QStringLiteral("exact"), symbol.exact);
    if (symbol.canvas.kind != CanvasKind::Nothing)
        object.insert(QStringLiteral("canvas"), toJson(symbol.canvas));
    return object;
}

QJsonObject toJson(const DerivationLine& line, const Derivation& derivation)
{
    QJsonArray values;
    for (const double value : line.values)
        values.append(value);
    QJsonArray marks;
    for (const CanvasPart& part : line.marks)
        marks.append(toJson(part));
    QJsonObject object{{"formula", toJson(line.formula, derivation)},
                       {"numbers", toJson(line.numbers, derivation)},
                       {"words", textOf(line.words)},
                       {"marks", marks}};
    if (line.isComparison()) {
        object.insert(QStringLiteral("holds"), line.holds());
    } else {
        object.insert(QStringLiteral("left"), toJson(line.left, derivation));
        object.insert(QStringLiteral("result"), line.result);
        object.insert(QStringLiteral("values"), values);
    }
    return object;
}

/// The id of the symbol that a part of a figure is the picture of.
void insertSymbol(QJsonObject& object, int symbol, const Derivation& derivation)
{
    if (symbol >= 0)
        object.insert(QStringLiteral("symbol"), derivation.symbols[std::size_t(symbol)].id);
}

QJsonObject toJson(const DerivationFigure& figure, const Derivation& derivation)
{
    QJsonArray strokes;
    for (const FigureStroke& stroke : figure.strokes) {
        QJsonArray way;
        for (const glm::dvec2& point : stroke.points)
            way.append(toJson(point));
        QJsonObject object{
            {"name", stroke.name}, {"points", way}, {"dashed", stroke.look == FigureStroke::Look::Dashed}};
        insertSymbol(object, stroke.symbol, derivation);
        strokes.append(object);
    }
    QJsonArray points;
    for (const FigurePoint& point : figure.points) {
        QJsonObject object{{"name", point.name}, {"at", toJson(point.at)}};
        insertSymbol(object, point.symbol, derivation);
        points.append(object);
    }
    return {{"title", textOf(figure.title)},
            {"axes", QJsonArray{figure.xName, figure.yName}},
            {"low", toJson(figure.low)},
            {"high", toJson(figure.high)},
            {"log_from", figure.logFrom},
            {"strokes", strokes},
            {"points", points}};
}

} // namespace

const char* canvasKindId(CanvasKind kind) { return kCanvasKinds[static_cast<std::size_t>(kind)].id; }

const DerivationSymbol* Derivation::find(std::string_view id) const
{
    const QLatin1String wanted(id.data(), static_cast<qsizetype>(id.size()));
    const auto found = std::ranges::find_if(symbols, [&](const DerivationSymbol& s) { return s.id == wanted; });
    return found == symbols.end() ? nullptr : &*found;
}

QString textOf(const std::vector<DerivationToken>& tokens)
{
    QString text;
    for (const DerivationToken& token : tokens)
        text += token.text;
    return text;
}

QString textOf(const DerivationLine& line, Translate translate)
{
    const QString words = textOf(line.words, translate) + QLatin1Char('\n');
    if (line.isComparison()) {
        const char* verdict =
            line.holds() ? QT_TRANSLATE_NOOP("Derive", "holds") : QT_TRANSLATE_NOOP("Derive", "does not hold");
        return QStringLiteral("%1\n%2: %3\n")
                   .arg(textOf(line.formula), textOf(line.numbers), textOf(Reason(verdict), translate)) +
               words;
    }
    const QString left = textOf(line.left);
    QString text = QStringLiteral("%1 = %2\n").arg(left, textOf(line.formula));
    const QString indent(left.size(), QLatin1Char(' '));
    const QString numbers = textOf(line.numbers);
    text += numbers == line.result ? QStringLiteral("%1 = %2\n").arg(indent, numbers)
                                   : QStringLiteral("%1 = %2 = %3\n").arg(indent, numbers, line.result);
    return text + words;
}

QString textOf(const Derivation& derivation, Translate translate)
{
    QString text = textOf(Reason(infoOf(derivation.topic).title), translate) + QStringLiteral(": ") +
                   textOf(derivation.place, translate) + QLatin1Char('\n');
    for (const DerivationLine& line : derivation.lines)
        text += QLatin1Char('\n') + textOf(line, translate);
    if (!derivation.listing.empty())
        text += QLatin1Char('\n');
    for (const QString& line : derivation.listing)
        text += line + QLatin1Char('\n');
    return text;
}

QJsonObject toJson(const Derivation& derivation)
{
    QJsonArray symbols;
    for (const DerivationSymbol& symbol : derivation.symbols)
        symbols.append(toJson(symbol));
    QJsonArray lines;
    for (const DerivationLine& line : derivation.lines)
        lines.append(toJson(line, derivation));
    QJsonArray figures;
    for (const DerivationFigure& figure : derivation.figures)
        figures.append(toJson(figure, derivation));
    QJsonArray listing;
    for (const QString& line : derivation.listing)
        listing.append(line);
    const DerivationTopicInfo& info = infoOf(derivation.topic);
    return {{"id", QLatin1String(info.id)},
            {"title", QLatin1String(info.title)},
            {"place", textOf(derivation.place)},
            {"symbols", symbols},
            {"lines", lines},
            {"figures", figures},
            {"listing", listing}};
}

QString derivedNumber(double value)
{
    constexpr qsizetype kShort = 12;
    const QString full = fullNumber(value);
    return full.size() <= kShort ? full : QString::number(value, 'g', 9);
}

} // namespace rasterlens
