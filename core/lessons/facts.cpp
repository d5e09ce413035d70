#include "core/lessons/facts.h"

#include "core/base/grouped.h"
#include "core/base/typed_numbers.h"
#include "core/observe/step_cursor.h"
#include "core/render/steps.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QRect>

#include <algorithm>
#include <cmath>

namespace rasterlens
{
namespace
{

/// Reads the arguments of a fact, whose row says which there are: F a face, P a pixel, W a word, N a number.
std::optional<FactName> readArguments(std::size_t row, const QStringList& words)
{
    FactName name;
    name.row = row;
    const QString kinds = QLatin1String(factRows()[row].kinds);
    if (words.size() != kinds.size())
        return std::nullopt;
    for (qsizetype i = 0; i < kinds.size(); ++i) {
        bool isRead = true;
        if (kinds[i] == QLatin1Char('F'))
            name.face = words[i].toUInt(&isRead);
        else if (kinds[i] == QLatin1Char('P'))
            isRead = (name.pixel = typedPoint(words[i])).has_value();
        else if (kinds[i] == QLatin1Char('W'))
            name.word = words[i];
        else
            name.numbers.push_back(words[i].toDouble(&isRead));
        if (!isRead)
            return std::nullopt;
    }
    return name;
}

QPoint pointOf(const QJsonValue& xy) { return {xy.toArray().at(0).toInt(-1), xy.toArray().at(1).toInt(-1)}; }

bool isPoint(const QJsonValue& xy)
{
    return xy.isArray() && xy.toArray().size() == 2 && pointOf(xy).x() >= 0 && pointOf(xy).y() >= 0;
}

bool numbersAgree(double value, double said)
{
    constexpr double kHalfOfTheFourthDigit = 5e-4;
    if (said == std::round(said))
        return value == said;
    return std::abs(value - said) <= kHalfOfTheFourthDigit * std::abs(said);
}

/// Pixels in the order of rows.
std::vector<QPoint> sorted(std::vector<QPoint> pixels)
{
    std::ranges::sort(pixels, {}, [](QPoint p) { return std::pair(p.y(), p.x()); });
    return pixels;
}

} // namespace

std::optional<FactName> factFromText(const QString& text, Reason* why)
{
    const QStringList words = text.simplified().split(QLatin1Char(' '));
    const std::span<const FactRow> rows = factRows();
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (words.first() != QLatin1String(rows[i].name))
            continue;
        if (auto name = readArguments(i, words.mid(1)))
            return name;
        *why = {
            QT_TRANSLATE_NOOP("Diagnostic", "the fact \"%1\" takes: %2"),
            {words.first(), QString(words.first() + QLatin1Char(' ') + QLatin1String(rows[i].arguments)).trimmed()}};
        return std::nullopt;
    }
    *why = {QT_TRANSLATE_NOOP("Diagnostic", "there is no fact \"%1\"; \"rasterlens-cli lesson --facts\" lists them"),
            {words.first()}};
    return std::nullopt;
}

bool isEdgeValue(const FactName& name)
{
    const QLatin1String row(factRows()[name.row].name);
    return row == QLatin1String("edge") || row == QLatin1String("step-edge");
}

MomentFacts::MomentFacts(const Moment& moment, const OpenMoment& open) : m_moment(moment), m_open(open) {}

std::optional<FactValue> MomentFacts::find(const FactName& name)
{
    if (!hasFace(name.face) || (name.pixel && !holds(*name.pixel)))
        return std::nullopt;
    return factRows()[name.row].find(*this, name);
}

QImage MomentFacts::picture()
{
    if (!m_moment.step)
        return shown().frame.image;
    const auto at = position();
    if (!at)
        return {};
    StepCursor cursor(log());
    cursor.moveTo(*at);
    return cursor.image();
}

const CountedPicture& MomentFacts::shown()
{
    if (!m_shown)
        m_shown = drawCounted(m_open.scene, m_open.settings, {.depth = true, .ids = true, .coverage = true});
    return *m_shown;
}

const CountedPicture& MomentFacts::other()
{
    if (!m_other)
        m_other = drawCounted(m_open.scene, m_open.other, {.depth = true, .ids = true, .coverage = true});
    return *m_other;
}

const Judgement& MomentFacts::judgement()
{
    if (!m_judgement)
        m_judgement = judge(m_open.scene, m_open.settings);
    return *m_judgement;
}

const std::shared_ptr<const StepLog>& MomentFacts::log()
{
    if (!m_log)
        m_log = renderSteps(m_open.scene, m_open.settings);
    return m_log;
}

std::optional<std::size_t> MomentFacts::position()
{
    return m_moment.step ? positionOf(*m_moment.step, *log()) : std::optional(log()->size());
}

const StepEvent* MomentFacts::event()
{
    const auto at = position();
    return at && *at > 0 ? &log()->event(*at - 1) : nullptr;
}

bool MomentFacts::holds(QPoint pixel) const
{
    const QSize size = m_open.settings.size;
    return QRect(QPoint(0, 0), size).contains(pixel);
}

std::size_t MomentFacts::indexOf(QPoint pixel) const
{
    return static_cast<std::size_t>(pixel.y()) * static_cast<std::size_t>(m_open.settings.size.width()) +
           static_cast<std::size_t>(pixel.x());
}

bool agrees(const FactValue& value, const QJsonValue& said)
{
    if (const auto* number = std::get_if<double>(&value))
        return said.isDouble() && numbersAgree(*number, said.toDouble());
    if (const auto* text = std::get_if<QString>(&value))
        return said.isString() && said.toString() == *text;
    std::vector<QPoint> pixels;
    for (const QJsonValue& xy : said.toArray())
        pixels.push_back(pointOf(xy));
    return said.isArray() && sorted(std::move(pixels)) == std::get<std::vector<QPoint>>(value);
}

bool canBeFact(const QJsonValue& said)
{
    const QJsonArray array = said.toArray();
    return said.isDouble() || said.isString() ||
           (said.isArray() &&
            std::all_of(array.begin(), array.end(), [](const QJsonValue& xy) { return isPoint(xy); }));
}

QString textOf(const FactValue& value)
{
    if (const auto* number = std::get_if<double>(&value))
        return factText(*number);
    if (const auto* text = std::get_if<QString>(&value))
        return *text;
    QStringList pixels;
    for (const QPoint pixel : std::get<std::vector<QPoint>>(value))
        pixels << QStringLiteral("(%1, %2)").arg(pixel.x()).arg(pixel.y());
    return pixels.join(QStringLiteral(", "));
}

QString factText(const QJsonValue& said)
{
    if (said.isString())
        return said.toString();
    if (said.isArray()) {
        std::vector<QPoint> pixels;
        for (const QJsonValue& xy : said.toArray())
            pixels.push_back(pointOf(xy));
        return textOf(FactValue(sorted(std::move(pixels))));
    }
    const double number = said.toDouble();
    constexpr double kGrouped = 1'000; // from here on in groups of three digits
    if (number == std::round(number) && std::abs(number) >= kGrouped) {
        const QString digits = grouped(static_cast<std::uint64_t>(std::abs(number)));
        return number < 0 ? QChar(0x2212) + digits : digits;
    }
    constexpr int kDigits = 9;
    return QString::number(number, 'g', kDigits).replace(QLatin1Char('-'), QChar(0x2212));
}

} // namespace rasterlens
