#include "core/lessons/moment.h"

#include "core/io/session.h"
#include "core/render/render.h"
#include "core/scenes/builtin_scenes.h"
#include "core/scenes/load_scene.h"
#include "core/settings/mistakes.h"
#include "core/truth/hard_cases.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QJsonArray>
#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <utility>

namespace rasterlens
{
namespace
{

using Need = JsonFields::Need;

constexpr const char* kPanels[] = {"why",    "vertices", "clip",       "curves",  "race",
                                   "derive", "cases",    "experiment", "mistakes"};
constexpr const char* kOverlays[] = {"grid",        "samples",  "numbers", "wireframe",    "outline", "boxes", "tiles",
                                     "barycentric", "mid-line", "texels",  "depth-beside", "referee", "none"};
constexpr const char* kCompareViews[] = {"off", "wipe", "blink", "difference"};
constexpr const char* kCompareWiths[] = {"right", "scene"};

const QString kCasePrefix = QStringLiteral("case:");

QString joined(std::span<const char* const> ids)
{
    QStringList names;
    for (const char* id : ids)
        names << QLatin1String(id);
    return names.join(QStringLiteral(", "));
}

std::optional<std::size_t> indexOf(std::span<const char* const> ids, const QString& id)
{
    const auto found = std::ranges::find_if(ids, [&](const char* known) { return id == QLatin1String(known); });
    return found == ids.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - ids.begin()));
}

/// Whether there is a built-in, stress or hard scene of this name, or a file.
bool isScene(const QString& name)
{
    const auto isOneOf = [&](const QString& prefix, const auto& scenes) {
        return std::ranges::any_of(scenes,
                                   [&](const auto& scene) { return name == prefix + QLatin1String(scene.name); });
    };
    if (name.startsWith(QLatin1String("builtin:")))
        return isOneOf(QStringLiteral("builtin:"), builtinScenes());
    if (name.startsWith(QLatin1String("stress:")))
        return isOneOf(QStringLiteral("stress:"), stressScenes());
    const bool isModel = name.endsWith(QLatin1String(".obj"), Qt::CaseInsensitive) ||
                         name.endsWith(QLatin1String(".case"), Qt::CaseInsensitive);
    return isModel && QFileInfo(name).isFile();
}

/// The name by which loadScene() opens what a moment calls its scene.
QString loadName(const QString& scene, const QDir& folder)
{
    if (scene.startsWith(kCasePrefix))
        return hardCasePath(scene.mid(kCasePrefix.size()));
    const bool isPath = !scene.startsWith(QLatin1String("builtin:")) && !scene.startsWith(QLatin1String("stress:"));
    return isPath ? QDir::cleanPath(folder.absoluteFilePath(scene)) : scene;
}

class Reader
{
public:
    Reader(const JsonFields& fields, const QDir& folder, const Moment* before, Need caption)
        : m_fields(fields), m_folder(folder), m_before(before), m_caption(caption)
    {
    }

    Moment read()
    {
        scene();
        size();
        view();
        settings();
        step();
        place();
        named(QStringLiteral("panels"), panelIds(), m_moment.panels);
        named(QStringLiteral("overlay"), overlayIds(), m_moment.overlays);
        compare();
        m_moment.caption = readTexts(m_fields, QStringLiteral("caption"), m_caption);
        return m_moment;
    }

private:
    const JsonFields& m_fields;
    const QDir& m_folder;
    const Moment* m_before;
    Need m_caption;
    Moment m_moment;

    void scene()
    {
        const QString key = QStringLiteral("scene");
        if (m_before && !m_fields.has(key)) {
            m_moment.scene = m_before->scene;
            m_moment.size = m_before->size;
            m_moment.view = m_before->view;
            return;
        }
        const auto name = m_fields.text(key, Need::Required);
        if (!name)
            return;
        m_moment.scene = loadName(*name, m_folder);
        if (!isScene(m_moment.scene))
            m_fields.error(key, {QT_TRANSLATE_NOOP("Diagnostic", "there is no scene \"%1\"; builtin:NAME, stress:NAME, "
                                                                 "case:NAME or an .obj or .case file is expected"),
                                 {*name}});
    }

    void size()
    {
        const QString key = QStringLiteral("size");
        if (!m_fields.has(key))
            return;
        m_moment.size = parseSize(m_fields.value(key).toString());
        if (!m_moment.size)
            m_fields.error(key, {QT_TRANSLATE_NOOP("Diagnostic", "\"size\" takes \"WIDTHxHEIGHT\" with 1 to %1 each"),
                                 {kMaxViewport}});
    }

    void view()
    {
        const QString key = QStringLiteral("view");
        const auto view = m_fields.fields(key, Need::Optional);
        if (!view)
            return;
        m_moment.view = view->object();
        for (const QString& part : m_moment.view.keys())
            for (const Reason& error : settingsFromJson({{key, QJsonObject{{part, m_moment.view.value(part)}}}}).errors)
                view->error(part, error);
    }

    void settings()
    {
        const auto settings = m_fields.fields(QStringLiteral("settings"), Need::Optional);
        if (!settings)
            return;
        m_moment.settings = settings->object();
        for (const QString& key : m_moment.settings.keys())
            if (key == QLatin1String("size") || key == QLatin1String("view"))
                settings->error(
                    key, {QT_TRANSLATE_NOOP("Diagnostic", "\"%1\" stands beside \"settings\", not in it"), {key}});
            else
                for (const Reason& error : settingsFromJson({{key, m_moment.settings.value(key)}}).errors)
                    settings->error(key, error);
        for (const QJsonValue& id : m_moment.settings.value(QLatin1String("mistakes")).toArray())
            if (!findMistake(id.toString()))
                settings->error(QStringLiteral("mistakes"),
                                {QT_TRANSLATE_NOOP("Diagnostic", "there is no mistake \"%1\""), {id.toString()}});
    }

    void step()
    {
        const QString key = QStringLiteral("step");
        const QJsonValue value = m_fields.value(key);
        if (value.isUndefined())
            return;
        m_moment.step = stepPlaceFromText(value.isDouble() ? QString::number(value.toDouble()) : value.toString());
        if (!m_moment.step)
            m_fields.wrongType(key, stepPlaceHelp());
    }

    void place()
    {
        const QString pixel = QStringLiteral("pixel");
        const Reason what = QT_TRANSLATE_NOOP("Diagnostic", "a pixel: [x, y], two whole numbers from 0 on");
        if (const auto xy = m_fields.numbers(pixel, 2, what)) {
            m_moment.pixel = QPoint(static_cast<int>((*xy)[0]), static_cast<int>((*xy)[1]));
            if (QPointF(*m_moment.pixel) != QPointF((*xy)[0], (*xy)[1]) || m_moment.pixel->x() < 0 ||
                m_moment.pixel->y() < 0)
                m_fields.wrongType(pixel, what);
        }
        if (const auto xy = m_fields.numbers(QStringLiteral("centre"), 2,
                                             QT_TRANSLATE_NOOP("Diagnostic", "a point of the picture: [x, y]")))
            m_moment.centre = QPointF((*xy)[0], (*xy)[1]);
        const QString zoom = QStringLiteral("zoom");
        if (!m_fields.has(zoom))
            return;
        m_moment.zoom = m_fields.value(zoom).toDouble(0);
        constexpr double kLeast = 1.0 / 64;
        constexpr double kMost = 128;
        if (!(*m_moment.zoom >= kLeast && *m_moment.zoom <= kMost))
            m_fields.wrongType(zoom, QT_TRANSLATE_NOOP("Diagnostic", "a number from 1/64 to 128"));
    }

    void named(const QString& key, std::span<const char* const> known, QStringList& out)
    {
        out = m_fields.texts(key);
        for (const QString& id : out)
            if (!indexOf(known, id))
                m_fields.error(key, {QT_TRANSLATE_NOOP("Diagnostic", "\"%1\" knows no \"%2\"; expected: %3"),
                                     {key, id, joined(known)}});
    }

    template <class Enum>
    void choice(const JsonFields& fields, const QString& key, std::span<const char* const> ids, Enum& out)
    {
        const auto text = fields.text(key, Need::Optional);
        const auto index = text ? indexOf(ids, *text) : std::nullopt;
        if (index)
            out = static_cast<Enum>(*index);
        else if (text)
            fields.wrongType(key, joined(ids));
    }

    void compare()
    {
        const auto compare = m_fields.fields(QStringLiteral("compare"), Need::Optional);
        if (!compare)
            return;
        compare->allow({QStringLiteral("view"), QStringLiteral("with")});
        choice(*compare, QStringLiteral("view"), kCompareViews, m_moment.compare.view);
        choice(*compare, QStringLiteral("with"), kCompareWiths, m_moment.compare.with);
    }
};

QString sceneName(const QString& scene, const QDir& folder)
{
    for (const QString& name : hardCaseNames())
        if (scene == hardCasePath(name))
            return kCasePrefix + name;
    const bool isPath = !scene.startsWith(QLatin1String("builtin:")) && !scene.startsWith(QLatin1String("stress:"));
    return isPath ? folder.relativeFilePath(scene) : scene;
}

QJsonObject toJson(const TwoTexts& texts) { return {{"en", texts.en}, {"zh", texts.zh}}; }

QJsonObject toJson(const MomentCompare& compare)
{
    return {{"view", QLatin1String(kCompareViews[static_cast<std::size_t>(compare.view)])},
            {"with", QLatin1String(kCompareWiths[static_cast<std::size_t>(compare.with)])}};
}

/// The settings of the moment's other picture.
Settings otherSettings(const Settings& shown, const Settings& defaults, MomentCompare::With with)
{
    Settings other = shown;
    if (with == MomentCompare::With::Right) {
        other.mistakes.clear();
        return other;
    }
    other = defaults;
    other.size = shown.size;
    other.view = shown.view;
    return other;
}

} // namespace

std::span<const char* const> panelIds() { return kPanels; }

std::span<const char* const> overlayIds() { return kOverlays; }

QStringList momentKeys()
{
    return QStringList{QStringLiteral("scene"), QStringLiteral("size"), QStringLiteral("settings"),
                       QStringLiteral("view")} +
           sessionViewKeys() + QStringList{QStringLiteral("caption")};
}

SessionViewLoad sessionView(const QJsonObject& view, const QString& file)
{
    const JsonLines lines{QByteArray()};
    DiagnosticSink sink(file);
    const Moment scene; // is open already
    Moment moment = Reader(JsonFields(view, {}, lines, sink), QDir(), &scene, Need::Optional).read();
    moment.caption = {}; // only lessons have one
    Diagnostics found = sink.take();
    for (Diagnostic& diagnostic : found) {
        diagnostic.severity = Severity::Warning; // the scene opens all the same
        diagnostic.line = 0;
    }
    return {std::move(moment), std::move(found)};
}

QJsonObject toSessionView(const Moment& moment)
{
    QJsonObject json = toJson(moment, QDir());
    const QStringList keys = sessionViewKeys();
    for (const QString& key : json.keys())
        if (!keys.contains(key))
            json.remove(key);
    return json;
}

Moment readMoment(const JsonFields& fields, const QDir& folder, const Moment* before, JsonFields::Need caption)
{
    return Reader(fields, folder, before, caption).read();
}

QString unbroken(QString text)
{
    // Each is a number, or the name in braces that stands for one.
    static const QRegularExpression pair(QStringLiteral("(\\((?:[\u2212-]?[0-9.]+|\\{[^{}]*\\}),) "
                                                        "((?:[\u2212-]?[0-9.]+|\\{[^{}]*\\})\\))"));
    static const QRegularExpression before(QStringLiteral(" (?=(?:==|[=<>+\u2264\u2265\u2212\u00d7]) )"));
    static const QRegularExpression after(QStringLiteral("(?<=\u00a0)(==|[=<>+\u2264\u2265\u2212\u00d7]) "));
    static const QRegularExpression factor(QStringLiteral("(?<=\\d) (?=[a-zA-Z]+\u00a0)"));
    const QString blank(QChar(0xa0));
    return text.replace(pair, QStringLiteral("\\1\u00a0\\2"))
        .replace(before, blank)
        .replace(after, QStringLiteral("\\1\u00a0"))
        .replace(factor, blank);
}

TwoTexts readTexts(const JsonFields& fields, const QString& key, JsonFields::Need need)
{
    const auto texts = fields.fields(key, need);
    if (!texts)
        return {};
    texts->allow({QStringLiteral("en"), QStringLiteral("zh")});
    return {unbroken(texts->text(QStringLiteral("en"), Need::Required).value_or(QString())),
            unbroken(texts->text(QStringLiteral("zh"), Need::Required).value_or(QString()))};
}

QJsonObject toJson(const Moment& moment, const QDir& folder)
{
    QJsonObject json{{"scene", sceneName(moment.scene, folder)}};
    if (moment.size)
        json[QLatin1String("size")] = QStringLiteral("%1x%2").arg(moment.size->width()).arg(moment.size->height());
    if (!moment.settings.isEmpty())
        json[QLatin1String("settings")] = moment.settings;
    if (!moment.view.isEmpty())
        json[QLatin1String("view")] = moment.view;
    if (moment.step)
        json[QLatin1String("step")] = textOf(*moment.step);
    if (moment.pixel)
        json[QLatin1String("pixel")] = QJsonArray{moment.pixel->x(), moment.pixel->y()};
    if (moment.zoom)
        json[QLatin1String("zoom")] = *moment.zoom;
    if (moment.centre)
        json[QLatin1String("centre")] = QJsonArray{moment.centre->x(), moment.centre->y()};
    if (!moment.panels.isEmpty())
        json[QLatin1String("panels")] = QJsonArray::fromStringList(moment.panels);
    if (!moment.overlays.isEmpty())
        json[QLatin1String("overlay")] = QJsonArray::fromStringList(moment.overlays);
    if (moment.compare != MomentCompare())
        json[QLatin1String("compare")] = toJson(moment.compare);
    json[QLatin1String("caption")] = toJson(moment.caption);
    return json;
}

OpenMomentLoad openMoment(const Moment& moment)
{
    LoadOptions options;
    options.size = moment.size.value_or(options.size);
    SceneLoad load = loadScene(moment.scene, options);
    if (!load.scene)
        return {std::nullopt, std::move(load.diagnostics)};
    const Settings& defaults = load.scene->defaults;
    QJsonObject json = moment.settings;
    if (!moment.view.isEmpty())
        json[QLatin1String("view")] = moment.view;
    SettingsParse parse = settingsFromJson(json, defaults);
    for (const Reason& error : parse.errors)
        load.diagnostics.push_back({Severity::Error, moment.scene, 0, error});
    parse.settings.size = moment.size.value_or(defaults.size);
    if (const auto reason = unsupported(*load.scene, parse.settings))
        load.diagnostics.push_back({Severity::Error, moment.scene, 0, *reason});
    if (hasErrors(load.diagnostics))
        return {std::nullopt, std::move(load.diagnostics)};
    Settings other = otherSettings(parse.settings, defaults, moment.compare.with);
    return {OpenMoment{std::move(*load.scene), std::move(parse.settings), std::move(other)},
            std::move(load.diagnostics)};
}

} // namespace rasterlens
