#include "core/derive/writer.h"

#include "core/observe/names.h"

#include <QRegularExpression>

#include <array>
#include <charconv>
#include <stdexcept>

namespace rasterlens
{
namespace
{

/// Greek letters that ids spell out.
constexpr std::pair<const char*, const char*> kLetters[] = {
    {"alpha", "\u03b1"}, {"beta", "\u03b2"}, {"gamma", "\u03b3"}, {"eta", "\u03b7"}, {"Delta", "\u0394"}};

/// The id with Greek letters and a true minus sign: `alpha_p` is `α_p`.
QString printedName(const QString& id)
{
    QStringList parts = id.split(QLatin1Char('_'));
    for (QString& part : parts)
        for (const auto& [word, letter] : kLetters)
            if (part == QLatin1String(word))
                part = QString::fromUtf8(letter);
    return parts.join(QLatin1Char('_')).replace(QLatin1Char('-'), QChar(0x2212));
}

/// The operators of a formula as they are printed.
QString printedText(QString text)
{
    text.replace(QStringLiteral("<="), QChar(0x2264)).replace(QStringLiteral(">="), QChar(0x2265));
    text.replace(QStringLiteral("=="), QStringLiteral("=")).replace(QLatin1Char('-'), QChar(0x2212));
    text.replace(QStringLiteral(" * "), QStringLiteral("\u00b7")).replace(QLatin1Char('*'), QChar(0xb7));
    return text.replace(QLatin1Char('&'), QStringLiteral("AND"));
}

/// A value in a formula; a negative one that follows an operator stands in brackets.
QString printedValue(const DerivationSymbol& symbol, const QString& before)
{
    if (symbol.form == DerivationSymbol::Form::Bits)
        return regionText(static_cast<unsigned>(symbol.value)) + QChar(0x2082);
    const QString number = derivedNumber(symbol.value);
    if (!number.startsWith(QLatin1Char('-')))
        return number;
    const QString negative = QChar(0x2212) + number.sliced(1);
    const QString trimmed = before.trimmed();
    const QString opening = QStringLiteral("(|,");
    const bool stands = trimmed.isEmpty() || opening.contains(trimmed.back());
    return stands ? negative : QStringLiteral("(%1)").arg(negative);
}

/// Calls text(piece) and symbol(id) for the pieces of a formula in their order.
template <class OnText, class OnSymbol>
void forEachPiece(const QString& formula, OnText&& text, OnSymbol&& symbol)
{
    static const QRegularExpression braces(QStringLiteral("\\{([^}]*)\\}"));
    qsizetype at = 0;
    for (const QRegularExpressionMatch& match : braces.globalMatch(formula)) {
        if (match.capturedStart() > at)
            text(formula.sliced(at, match.capturedStart() - at));
        symbol(match.captured(1));
        at = match.capturedEnd();
    }
    if (at < formula.size())
        text(formula.sliced(at));
}

QString resultText(const std::vector<const DerivationSymbol*>& symbols)
{
    QStringList values;
    for (const DerivationSymbol* symbol : symbols)
        values << printedValue(*symbol, QString());
    return values.size() == 1 ? values.front() : QStringLiteral("(%1)").arg(values.join(QStringLiteral(", ")));
}

} // namespace

double inFewestDigits(float value)
{
    std::array<char, 32> text{};
    const char* const end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    double number = double(value);
    std::from_chars(text.data(), end, number);
    return number;
}

QString filled(const char* pattern, std::initializer_list<QString> names)
{
    // QString::arg would count the places that there are, and not by their numbers.
    const QStringList parts = QString::fromUtf8(pattern).split(QLatin1Char('%'));
    QString text = parts.front();
    for (const QString& part : parts.sliced(1)) {
        const int place = part.front().digitValue();
        if (place < 1 || place > static_cast<int>(names.size()))
            throw std::logic_error(std::string("a pattern has a place without a name: ") + pattern);
        text += names.begin()[place - 1] + part.sliced(1);
    }
    return text;
}

DerivationWriter::DerivationWriter(DerivationTopic topic, Reason place)
{
    m_derivation.topic = topic;
    m_derivation.place = std::move(place);
}

void DerivationWriter::define(const QString& id, const Quantity& quantity, CanvasPart canvas)
{
    if (m_index.contains(id))
        return;
    m_index[id] = static_cast<int>(m_derivation.symbols.size());
    m_values.push_back(quantity);
    DerivationSymbol symbol;
    symbol.id = id;
    symbol.name = printedName(id);
    symbol.value = quantity.value;
    symbol.exact = quantity.exact ? ratioText(*quantity.exact) : QString();
    if (const auto shown = m_canvas.find(id); canvas.kind == CanvasKind::Nothing && shown != m_canvas.end())
        canvas = shown->second;
    symbol.canvas = std::move(canvas);
    m_derivation.symbols.push_back(std::move(symbol));
}

void DerivationWriter::given(const QString& id, double value, CanvasPart canvas)
{
    define(id, {value, ratioOf(value)}, std::move(canvas));
}

void DerivationWriter::givenBits(const QString& id, unsigned bits, CanvasPart canvas)
{
    given(id, bits, std::move(canvas));
    m_derivation.symbols[std::size_t(m_index[id])].form = DerivationSymbol::Form::Bits;
}

Quantity DerivationWriter::quantityOf(const QString& id) const
{
    const auto found = m_index.find(id);
    if (found == m_index.end())
        throw std::logic_error("a formula names a symbol without a value: " + id.toStdString());
    return m_values[std::size_t(found->second)];
}

double DerivationWriter::valueOf(const QString& id) const { return quantityOf(id).value; }

std::vector<DerivationToken> DerivationWriter::symbolTokens(const QString& formula) const
{
    std::vector<DerivationToken> tokens;
    forEachPiece(
        formula, [&](const QString& text) { tokens.push_back({printedText(text)}); },
        [&](const QString& id) {
            const int index = m_index.at(id);
            tokens.push_back({m_derivation.symbols[std::size_t(index)].name, index});
        });
    return tokens;
}

std::vector<DerivationToken> DerivationWriter::numberTokens(const QString& formula) const
{
    std::vector<DerivationToken> tokens;
    QString before;
    const auto add = [&](const QString& text, int symbol) {
        tokens.push_back({text, symbol});
        before += text;
    };
    forEachPiece(
        formula, [&](const QString& text) { add(printedText(text), -1); },
        [&](const QString& id) {
            const int index = m_index.at(id);
            add(printedValue(m_derivation.symbols[std::size_t(index)], before), index);
        });
    return tokens;
}

void DerivationWriter::line(const QString& left, const QString& formula, Reason words, std::vector<CanvasPart> marks)
{
    const std::vector<Quantity> values = evaluate(formula, [this](const QString& id) { return quantityOf(id); });
    QStringList ids;
    forEachPiece(
        left, [](const QString&) {}, [&](const QString& id) { ids << id; });
    if (ids.size() != static_cast<qsizetype>(values.size()))
        throw std::logic_error("a line has " + std::to_string(values.size()) + " values: " + formula.toStdString());
    DerivationLine line;
    std::vector<const DerivationSymbol*> results;
    for (std::size_t i = 0; i < values.size(); ++i)
        define(ids[static_cast<qsizetype>(i)], values[i], {});
    for (const QString& id : ids) {
        results.push_back(&m_derivation.symbols[std::size_t(m_index.at(id))]);
        line.values.push_back(results.back()->value);
    }
    line.left = symbolTokens(left);
    line.formula = symbolTokens(formula);
    line.numbers = numberTokens(formula);
    line.result = resultText(results);
    line.words = std::move(words);
    line.marks = std::move(marks);
    m_derivation.lines.push_back(std::move(line));
}

void DerivationWriter::compare(const QString& formula, Reason words, std::vector<CanvasPart> marks)
{
    DerivationLine line;
    line.values = {evaluate(formula, [this](const QString& id) { return quantityOf(id); }).front().value};
    line.formula = symbolTokens(formula);
    line.numbers = numberTokens(formula);
    line.words = std::move(words);
    line.marks = std::move(marks);
    m_derivation.lines.push_back(std::move(line));
}

} // namespace rasterlens
