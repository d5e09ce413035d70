#include "core/base/typed_numbers.h"
#include "core/settings/numbers_field.h"
#include "core/settings/settings.h"
#include "core/settings/view_planes.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QLocale>

#include <cmath>
#include <utility>

// Settings as JSON, and the values of those that are no rows of a table as texts.

namespace rasterlens
{
namespace
{

const QString kHeadlight = QStringLiteral("head");
constexpr double kLongest = 1e30; // of a direction, along each axis

/// Whether a direction towards the light is one.
bool isDirection(const glm::dvec3& v)
{
    const auto isShort = [](double d) { return std::abs(d) <= kLongest; }; // false for what is no number
    return isShort(v.x) && isShort(v.y) && isShort(v.z) && v != glm::dvec3(0);
}

QJsonArray toArray(glm::dvec3 v) { return {v.x, v.y, v.z}; }

QJsonValue lightToJson(const Light& light)
{
    return light.isHead() ? QJsonValue(kHeadlight) : QJsonValue(toArray(*light.towards));
}

QJsonObject viewToJson(const View& view)
{
    QJsonObject json{{"fit", view.fit},
                     {"yaw", view.yaw},
                     {"pitch", view.pitch},
                     {"distance", view.distance},
                     {"pan", QJsonArray{view.pan.x, view.pan.y}},
                     {"eye", toArray(view.eye)},
                     {"target", toArray(view.target)},
                     {"up", toArray(view.up)},
                     {"fov", view.fov}};
    if (view.near)
        json["near"] = *view.near;
    if (view.far)
        json["far"] = *view.far;
    return json;
}

/// Reads one JSON value after the other and collects what is wrong with them.
struct Reader {
    std::vector<Reason> errors;

    void number(const QString& key, const QJsonValue& value, double& out, double minimum, double maximum)
    {
        if (value.isDouble() && std::isfinite(value.toDouble()) && value.toDouble() >= minimum &&
            value.toDouble() <= maximum)
            out = value.toDouble();
        else
            errors.push_back({QT_TRANSLATE_NOOP("Diagnostic", "\"%1\" takes a number from %2 to %3"),
                              {key, QString::number(minimum), QString::number(maximum)}});
    }

    template <int N>
    void vector(const QString& key, const QJsonValue& value, glm::vec<N, double>& out)
    {
        const QJsonArray array = value.toArray();
        glm::vec<N, double> v{};
        bool good = value.isArray() && array.size() == N;
        for (int i = 0; good && i < N; ++i) {
            good = array[i].isDouble();
            v[i] = array[i].toDouble();
        }
        if (good)
            out = v;
        else
            errors.push_back({QT_TRANSLATE_NOOP("Diagnostic", "\"%1\" takes an array of %2 numbers"), {key, N}});
    }

    void view(const QJsonObject& json, View& view)
    {
        constexpr double kHuge = 1e30;
        constexpr double kTiny = 1e-30;
        const std::size_t errorsBefore = errors.size();
        for (auto it = json.begin(); it != json.end(); ++it) {
            const QString& key = it.key();
            const QJsonValue value = it.value();
            double distance = 0;
            if (key == QLatin1String("fit") && value.isBool())
                view.fit = value.toBool();
            else if (key == QLatin1String("yaw"))
                number(key, value, view.yaw, -1e6, 1e6);
            else if (key == QLatin1String("pitch"))
                number(key, value, view.pitch, -90, 90);
            else if (key == QLatin1String("distance"))
                number(key, value, view.distance, 1e-6, 1e6);
            else if (key == QLatin1String("fov"))
                number(key, value, view.fov, 1e-3, 179.9);
            else if (key == QLatin1String("pan"))
                vector(key, value, view.pan);
            else if (key == QLatin1String("eye"))
                vector(key, value, view.eye);
            else if (key == QLatin1String("target"))
                vector(key, value, view.target);
            else if (key == QLatin1String("up"))
                vector(key, value, view.up);
            else if (key == QLatin1String("near")) {
                number(key, value, distance, value.toDouble() > 0 ? kTiny : -kHuge, kHuge);
                view.near = distance;
            } else if (key == QLatin1String("far")) {
                number(key, value, distance, value.toDouble() > 0 ? kTiny : -kHuge, kHuge);
                view.far = distance;
            } else
                errors.push_back({QT_TRANSLATE_NOOP("Diagnostic", "\"view\" has no key \"%1\" of this kind"), {key}});
        }
        if (auto why = whyNotPlanes(view.near, view.far); why && errors.size() == errorsBefore)
            errors.push_back(std::move(*why));
    }

    void light(const QJsonValue& value, Light& out)
    {
        const std::size_t errorsBefore = errors.size();
        glm::dvec3 towards{};
        if (value.isArray())
            vector(QStringLiteral("light"), value, towards);
        if (value.isString() && value.toString() == kHeadlight)
            out.towards.reset();
        else if (value.isArray() && isDirection(towards))
            out.towards = towards;
        else if (errors.size() == errorsBefore)
            errors.emplace_back(QT_TRANSLATE_NOOP(
                "Diagnostic", "\"light\" takes \"head\" or an array of three numbers that are not all 0"));
    }

    void mistakes(const QJsonValue& value, QStringList& out)
    {
        if (!value.isArray()) {
            errors.emplace_back(QT_TRANSLATE_NOOP("Diagnostic", "\"mistakes\" takes an array of mistake ids"));
            return;
        }
        out.clear();
        for (const QJsonValue& id : value.toArray())
            if (!out.contains(id.toString()))
                out << id.toString();
    }

    void field(const SettingsField& field, const QJsonValue& value, Settings& settings)
    {
        const QString text = value.isBool()     ? (value.toBool() ? QStringLiteral("true") : QStringLiteral("false"))
                             : value.isDouble() ? QString::number(value.toDouble())
                                                : value.toString();
        if (const auto error = setFromText(field, text, settings))
            errors.push_back(*error);
    }
};

} // namespace

QJsonObject toJson(const Settings& settings)
{
    QJsonObject json{{"size", QStringLiteral("%1x%2").arg(settings.size.width()).arg(settings.size.height())},
                     {"view", viewToJson(settings.view)},
                     {"light", lightToJson(settings.light)},
                     {"mistakes", QJsonArray::fromStringList(settings.mistakes)}};
    for (const SettingsField& field : settingsFields()) {
        const QString key = QString::fromLatin1(field.id);
        switch (field.kind) {
        case SettingsField::Kind::Choice: json[key] = valueId(field, settings); break;
        case SettingsField::Kind::Integer: json[key] = field.get(settings); break;
        case SettingsField::Kind::Flag: json[key] = field.get(settings) != 0; break;
        }
    }
    for (const NumbersField& field : numbersFields())
        json[QLatin1String(field.id)] = toJson(field, settings);
    return json;
}

SettingsParse settingsFromJson(const QJsonObject& json, const Settings& base)
{
    Reader reader;
    Settings settings = base;
    for (auto it = json.begin(); it != json.end(); ++it) {
        if (it.key() == QLatin1String("size")) {
            if (const auto size = parseSize(it.value().toString()))
                settings.size = *size;
            else
                reader.errors.push_back(
                    {QT_TRANSLATE_NOOP("Diagnostic", "\"size\" takes \"WIDTHxHEIGHT\" with 1 to %1 each"),
                     {kMaxViewport}});
        } else if (it.key() == QLatin1String("view")) {
            if (it.value().isObject())
                reader.view(it.value().toObject(), settings.view);
            else
                reader.errors.emplace_back(QT_TRANSLATE_NOOP("Diagnostic", "\"view\" takes an object"));
        } else if (it.key() == QLatin1String("light")) {
            reader.light(it.value(), settings.light);
        } else if (it.key() == QLatin1String("mistakes")) {
            reader.mistakes(it.value(), settings.mistakes);
        } else if (const NumbersField* numbers = findNumbersField(it.key())) {
            if (auto error = setFromJson(*numbers, it.value(), settings))
                reader.errors.push_back(std::move(*error));
        } else if (const SettingsField* field = findSettingsField(it.key())) {
            reader.field(*field, it.value(), settings);
        } else {
            reader.errors.push_back({QT_TRANSLATE_NOOP("Diagnostic", "there is no setting \"%1\""), {it.key()}});
        }
    }
    return {reader.errors.empty() ? settings : base, reader.errors};
}

std::optional<QSize> parseSize(const QString& text)
{
    const QStringList parts = text.split(QLatin1Char('x'));
    if (parts.size() != 2)
        return std::nullopt;
    bool goodWidth = false;
    bool goodHeight = false;
    const QSize size(parts[0].toInt(&goodWidth), parts[1].toInt(&goodHeight));
    const auto inRange = [](int v) { return v >= 1 && v <= kMaxViewport; };
    if (!goodWidth || !goodHeight || !inRange(size.width()) || !inRange(size.height()))
        return std::nullopt;
    return size;
}

std::optional<Light> parseLight(const QString& text)
{
    if (text == kHeadlight)
        return Light{std::nullopt};
    const auto numbers = typedNumbers(text);
    if (!numbers || numbers->size() != 3)
        return std::nullopt;
    const glm::dvec3 towards((*numbers)[0], (*numbers)[1], (*numbers)[2]);
    return isDirection(towards) ? std::optional(Light{towards}) : std::nullopt;
}

QString lightText(const Light& light)
{
    if (light.isHead())
        return kHeadlight;
    QStringList words;
    for (int i = 0; i < 3; ++i)
        words << QString::number((*light.towards)[i], 'g', QLocale::FloatingPointShortest);
    return words.join(QLatin1Char(','));
}

} // namespace rasterlens
