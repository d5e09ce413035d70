#include "app/cli/settings_options.h"

#include "app/cli/failure.h"
#include "core/base/typed_numbers.h"
#include "core/render/render.h"
#include "core/settings/mistakes.h"
#include "core/settings/numbers_field.h"
#include "core/settings/view_planes.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

namespace rasterlens::cli
{
namespace
{

// The camera's limits; session files have the same ones.
constexpr double kMinFovDegrees = 1e-3;
constexpr double kMaxFovDegrees = 179.9;
constexpr double kMaxDistance = 1e30;

const View kFit;

QStringList mistakeIds()
{
    QStringList ids;
    for (const Mistake& mistake : mistakes())
        ids << QLatin1String(mistake.id);
    return ids;
}

QString optionName(const SettingsField& field) { return QStringLiteral("--") + QLatin1String(field.id); }
QString optionName(const NumbersField& field) { return QStringLiteral("--") + QLatin1String(field.id); }

bool isThreads(const SettingsField& field) { return field.id == QLatin1String("threads"); }

QString threadsValues(const SettingsField& field, const char* note = "")
{
    return QStringLiteral("auto%1, or 1 to %2").arg(QLatin1String(note)).arg(field.maximum);
}

QString valueHelp(const SettingsField& field)
{
    if (isThreads(field))
        return threadsValues(field, " (default)");
    const QString preset = valueId(field, Settings());
    if (field.kind == SettingsField::Kind::Integer)
        return QStringLiteral("%1 to %2; default %3").arg(field.minimum).arg(field.maximum).arg(preset);
    if (field.kind == SettingsField::Kind::Flag)
        return QStringLiteral("a switch, also true or false; default %1").arg(preset);
    QStringList ids;
    for (const Choice& choice : field.choices)
        ids << QLatin1String(choice.id) +
                   (preset == QLatin1String(choice.id) ? QStringLiteral(" (default)") : QString());
    return ids.join(QStringLiteral(", "));
}

QList<Option> fieldOptions()
{
    QList<Option> options;
    for (const SettingsField& field : settingsFields()) {
        const bool isFlag = field.kind == SettingsField::Kind::Flag;
        const QString valueName =
            field.kind == SettingsField::Kind::Integer ? QStringLiteral("N") : QStringLiteral("ID");
        options << Option{optionName(field), isFlag ? Option::Kind::Switch : Option::Kind::Value,
                          isFlag ? QString() : valueName,
                          QString::fromUtf8(field.help) + QLatin1Char('\n') + valueHelp(field)};
    }
    for (const NumbersField& field : numbersFields())
        options << Option{optionName(field), Option::Kind::Value, QString::fromLatin1(field.form),
                          QString::fromUtf8(field.help)};
    return options;
}

[[noreturn]] void failValue(const QString& option, const QString& value, const QString& takes)
{
    failArguments(QStringLiteral("%1: \"%2\" is not a value of %3, which takes: %4")
                      .arg(option, value, QString(option).remove(QStringLiteral("--")), takes));
}

/// `count` finite numbers.
std::vector<double> numbers(const QString& option, const QString& text, std::size_t count, const QString& takes)
{
    const auto values = typedNumbers(text);
    const auto isTooFar = [](double value) { return std::abs(value) > kMaxDistance; };
    if (!values || values->size() != count || std::ranges::any_of(*values, isTooFar))
        failValue(option, text, takes);
    return *values;
}

/// Reads the options of the camera into a View.
class ViewReader
{
public:
    ViewReader(const View& view, const Arguments& arguments) : m_view(view), m_arguments(arguments) {}

    View read()
    {
        checkCombination();
        if (const auto text = m_arguments.value(QStringLiteral("--view")); text && *text != QLatin1String("fit"))
            failValue(QStringLiteral("--view"), *text, QStringLiteral("fit"));
        if (m_arguments.has(QStringLiteral("--view")) || m_arguments.has(QStringLiteral("--orbit")))
            m_view = kFit;
        readOrbit();
        if (m_arguments.has(QStringLiteral("--eye")))
            readLookAt();
        readLens();
        return m_view;
    }

private:
    View m_view;
    const Arguments& m_arguments;

    void checkCombination() const
    {
        const bool eye = m_arguments.has(QStringLiteral("--eye"));
        for (const QString& other : {QStringLiteral("--view"), QStringLiteral("--orbit")})
            if (eye && m_arguments.has(other))
                failArguments(
                    QStringLiteral("--eye: cannot be combined with %1; one of the two is expected").arg(other));
        for (const QString& other : {QStringLiteral("--target"), QStringLiteral("--up")})
            if (!eye && m_arguments.has(other))
                failArguments(QStringLiteral("%1: needs --eye beside it").arg(other));
    }

    void readOrbit()
    {
        const QString option = QStringLiteral("--orbit");
        const auto text = m_arguments.value(option);
        if (!text)
            return;
        const QString takes = QStringLiteral("yaw,pitch in degrees, the pitch from -90 to 90");
        const std::vector<double> degrees = numbers(option, *text, 2, takes);
        if (std::abs(degrees[0]) > 1e6 || std::abs(degrees[1]) > 90)
            failValue(option, *text, takes);
        m_view.yaw = degrees[0];
        m_view.pitch = degrees[1];
    }

    void readLookAt()
    {
        m_view.fit = false;
        readVector(QStringLiteral("--eye"), m_view.eye);
        readVector(QStringLiteral("--target"), m_view.target);
        readVector(QStringLiteral("--up"), m_view.up);
        const glm::dvec3 gaze = m_view.target - m_view.eye;
        if (glm::length(gaze) == 0)
            failArguments(QStringLiteral("--eye: the eye is where the target is; two different points are expected"));
        if (glm::length(glm::cross(gaze, m_view.up)) <= 1e-12 * glm::length(gaze) * glm::length(m_view.up))
            failArguments(QStringLiteral("--up: points along the gaze; another direction is expected"));
    }

    void readVector(const QString& option, glm::dvec3& out) const
    {
        if (const auto text = m_arguments.value(option)) {
            const std::vector<double> xyz = numbers(option, *text, 3, QStringLiteral("three numbers x,y,z"));
            out = {xyz[0], xyz[1], xyz[2]};
        }
    }

    void readLens()
    {
        if (const auto text = m_arguments.value(QStringLiteral("--fov"))) {
            const QString takes =
                QStringLiteral("the vertical angle in degrees, %1 to %2").arg(kMinFovDegrees).arg(kMaxFovDegrees);
            m_view.fov = numbers(QStringLiteral("--fov"), *text, 1, takes)[0];
            if (m_view.fov < kMinFovDegrees || m_view.fov > kMaxFovDegrees)
                failValue(QStringLiteral("--fov"), *text, takes);
        }
        readDistance(QStringLiteral("--near"), m_view.near);
        readDistance(QStringLiteral("--far"), m_view.far);
        if (const auto why = whyNotPlanes(m_view.near, m_view.far)) {
            const bool isNear = m_view.near && !(*m_view.near > 0);
            failArguments(QLatin1String(isNear ? "--near: " : "--far: ") + textOf(*why));
        }
    }

    void readDistance(const QString& option, std::optional<double>& out) const
    {
        if (const auto text = m_arguments.value(option)) {
            const QString takes = QStringLiteral("a distance greater than 0");
            out = numbers(option, *text, 1, takes)[0];
        }
    }
};

/// `--threads auto` says what the number 0 means.
void readField(const SettingsField& field, const QString& text, Settings& settings)
{
    const bool isAuto = isThreads(field) && text == QLatin1String("auto");
    const auto error = setFromText(field, isAuto ? QStringLiteral("0") : text, settings);
    if (error && isThreads(field))
        failValue(optionName(field), text, threadsValues(field));
    if (error)
        failArguments(optionName(field) + QStringLiteral(": ") + textOf(*error));
}

/// The vector instructions that these settings can be drawn with, and scalar.
QStringList simdIds(const Scene& scene, Settings settings)
{
    QStringList ids;
    const SettingsField& field = *findSettingsField(QStringLiteral("simd"));
    for (int value = field.minimum; value <= field.maximum; ++value) {
        field.set(settings, value);
        if (settings.simd != Simd::Auto && !unsupported(scene, settings))
            ids << valueId(field, settings);
    }
    return ids;
}

void readMistakes(const QStringList& ids, QStringList& out)
{
    for (const QString& id : ids) {
        if (!mistakeIds().contains(id)) {
            const auto similar = mostSimilar(id, mistakeIds());
            const QString hint = similar ? QStringLiteral("did you mean %1?").arg(*similar)
                                         : QStringLiteral("--list-mistakes lists those there are");
            failArguments(QStringLiteral("--mistake: there is no mistake \"%1\"; %2").arg(id, hint));
        }
        if (!out.contains(id))
            out << id;
    }
}

} // namespace

QList<OptionGroup> settingsOptionGroups()
{
    const auto value = [](const char* name, const char* valueName, const QString& help) {
        return Option{QString::fromLatin1(name), Option::Kind::Value, QString::fromLatin1(valueName), help};
    };
    const QList<Option> camera{
        value("--size", "WxH",
              QStringLiteral("Width and height of the picture in pixels, 1 to %1 each. Case files and built-in scenes "
                             "bring their own; for all others the default is 1920x1080.")
                  .arg(kMaxViewport)),
        value("--view", "fit",
              QStringLiteral(
                  "Look along -z so that the scene's bounding sphere just touches the frustum (default, unless "
                  "the scene brings a camera).")),
        value("--orbit", "YAW,PITCH",
              QStringLiteral(
                  "The view fit, with the eye moved round the scene: degrees round the y axis, degrees upward.")),
        value("--eye", "X,Y,Z", QStringLiteral("Where the camera is, in world space (right-handed, y up).")),
        value("--target", "X,Y,Z", QStringLiteral("The point it looks at; default 0,0,0. Needs --eye.")),
        value("--up", "X,Y,Z", QStringLiteral("The direction that is up in the picture; default 0,1,0. Needs --eye.")),
        value("--fov", "DEGREES",
              QStringLiteral("Full vertical angle of view, %1 to %2; default 45.")
                  .arg(kMinFovDegrees)
                  .arg(kMaxFovDegrees)),
        value("--near", "N",
              QStringLiteral("Distance of the near plane, greater than 0; default: in front of the scene.")),
        value("--far", "F", QStringLiteral("Distance of the far plane, greater than N; default: behind the scene.")),
        value("--light", "X,Y,Z|head",
              QStringLiteral("The direction towards the light, in world space; default %1. \"head\": from the scene "
                             "to the eye, so that the light shines along the camera's view.")
                  .arg(lightText(Light()))),
    };
    QList<Option> pipeline = fieldOptions();
    pipeline << Option{QStringLiteral("--mistake"), Option::Kind::List, QStringLiteral("ID"),
                       QStringLiteral("Make a mistake on purpose. May be given several times; see --list-mistakes.")};
    return {{QStringLiteral("Picture and camera:"), camera},
            {QStringLiteral("Pipeline, from first stage to last:"), pipeline}};
}

Settings withOptions(Settings settings, const Arguments& arguments)
{
    const QString sizeOption = QStringLiteral("--size");
    if (const auto text = arguments.value(sizeOption)) {
        const auto size = typedSize(*text, kMaxViewport);
        if (!size)
            failValue(sizeOption, *text, QStringLiteral("WIDTHxHEIGHT in pixels, 1 to %1 each").arg(kMaxViewport));
        settings.size = *size;
    }
    settings.view = ViewReader(settings.view, arguments).read();
    const QString lightOption = QStringLiteral("--light");
    if (const auto text = arguments.value(lightOption)) {
        const auto light = parseLight(*text);
        if (!light)
            failValue(lightOption, *text, QStringLiteral("head, or three numbers x,y,z that are not all 0"));
        settings.light = *light;
    }
    for (const SettingsField& field : settingsFields())
        if (const auto text = arguments.value(optionName(field)))
            readField(field, *text, settings);
    for (const NumbersField& field : numbersFields())
        if (const auto text = arguments.value(optionName(field)))
            if (const auto wrong = setFromText(field, *text, settings))
                failArguments(QStringLiteral("%1: %2").arg(optionName(field), textOf(*wrong)));
    readMistakes(arguments.values(QStringLiteral("--mistake")), settings.mistakes);
    return settings;
}

std::optional<QString> refusal(const Scene& scene, const Settings& settings)
{
    const auto reason = unsupported(scene, settings);
    if (!reason)
        return std::nullopt;
    const QStringList others = simdIds(scene, settings); // none where anything else is in the way
    return textOf(*reason) +
           (others.isEmpty() ? QString() : QStringLiteral("; it has ") + others.join(QStringLiteral(", ")));
}

QStringList unknownMistakes(const Settings& settings)
{
    QStringList unknown;
    for (const QString& id : settings.mistakes)
        if (!mistakeIds().contains(id))
            unknown << id;
    return unknown;
}

QString mistakeList()
{
    QString text;
    for (const Mistake& mistake : mistakes())
        text += QStringLiteral("%1 %2 %3 builtin:%4\n")
                    .arg(QLatin1String(mistake.id), -26)
                    .arg(QLatin1String(mistake.number), -4)
                    .arg(QLatin1String(mistake.title), -54)
                    .arg(QLatin1String(mistake.scene));
    return text;
}

} // namespace rasterlens::cli
