#include "core/settings/numbers_field.h"

#include "core/base/typed_numbers.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace rasterlens
{
namespace
{

constexpr double kLargestBias = 1e9; // the largest code of unorm24 is 1.7e7

std::vector<double> bias(const Settings& settings)
{
    const DepthBias& b = settings.depthBias;
    return b.clamp == 0 ? std::vector{b.constant, b.slope} : std::vector{b.constant, b.slope, b.clamp};
}

bool setBias(Settings& settings, std::span<const double> v)
{
    const auto isBias = [](double d) { return std::abs(d) <= kLargestBias; };
    if ((v.size() != 2 && v.size() != 3) || !std::ranges::all_of(v, isBias))
        return false;
    settings.depthBias = {v[0], v[1], v.size() == 3 ? v[2] : 0};
    return true;
}

std::vector<double> range(const Settings& settings) { return {settings.depthRange.near, settings.depthRange.far}; }

bool setRange(Settings& settings, std::span<const double> v)
{
    const auto isDepth = [](double d) { return d >= 0 && d <= 1; };
    if (v.size() != 2 || !std::ranges::all_of(v, isDepth))
        return false;
    settings.depthRange = {v[0], v[1]};
    return true;
}

constexpr NumbersField kFields[] = {
    {"depth-range", "N,F", QT_TRANSLATE_NOOP("Settings", "Depth range"),
     QT_TRANSLATE_NOOP("Settings", "The depths that the near and the far plane are mapped to, 0,1 unless asked "
                                   "otherwise. Far may be the smaller one."),
     Stage::Depth, QT_TRANSLATE_NOOP("Diagnostic", "two numbers n,f from 0 to 1"), range, setRange},
    {"depth-bias", "C,S[,M]", QT_TRANSLATE_NOOP("Settings", "Depth bias"),
     QT_TRANSLATE_NOOP("Settings",
                       "Added to the depths of a face: c units of the depth format and s times its slope a pixel; the "
                       "sum is no more than m where m > 0, no less where m < 0. In a scene of two passes it moves the "
                       "second."),
     Stage::Depth,
     QT_TRANSLATE_NOOP("Diagnostic", "two or three numbers c,s[,m] of at most 1e9: units, slopes, and the clamp"), bias,
     setBias},
};

} // namespace

std::span<const NumbersField> numbersFields() { return kFields; }

QString valueText(const NumbersField& field, const Settings& settings)
{
    QStringList words;
    for (const double number : field.get(settings))
        words << QString::number(number, 'g', QLocale::FloatingPointShortest);
    return words.join(QLatin1Char(','));
}

std::optional<Reason> setFromText(const NumbersField& field, const QString& text, Settings& settings)
{
    const auto numbers = typedNumbers(text);
    if (numbers && field.set(settings, *numbers))
        return std::nullopt;
    return Reason(QT_TRANSLATE_NOOP("Diagnostic", "\"%1\" is not a value of %2, which takes: %3"),
                  {text, QString::fromLatin1(field.id), Reason(field.expected)});
}

const NumbersField* findNumbersField(const QString& id)
{
    for (const NumbersField& field : kFields)
        if (id == QLatin1String(field.id))
            return &field;
    return nullptr;
}

QJsonArray toJson(const NumbersField& field, const Settings& settings)
{
    QJsonArray numbers;
    for (const double number : field.get(settings))
        numbers.append(number);
    return numbers;
}

std::optional<Reason> setFromJson(const NumbersField& field, const QJsonValue& value, Settings& settings)
{
    std::vector<double> numbers;
    bool good = value.isArray();
    for (const QJsonValue& number : value.toArray()) {
        good = good && number.isDouble();
        numbers.push_back(number.toDouble());
    }
    if (good && field.set(settings, numbers))
        return std::nullopt;
    return Reason(QT_TRANSLATE_NOOP("Diagnostic", "\"%1\" takes an array of %2"),
                  {QString::fromLatin1(field.id), Reason(field.expected)});
}

bool isEqual(const NumbersField& field, const Settings& a, const Settings& b) { return field.get(a) == field.get(b); }

} // namespace rasterlens
