#include "core/io/json_fields.h"

#include <QCoreApplication>
#include <QJsonArray>

#include <cmath>

namespace rasterlens
{

void JsonFields::wrongType(const QString& key, Reason what) const
{
    error(key, {QT_TRANSLATE_NOOP("Diagnostic", "\"%1\" takes %2"), {key, std::move(what)}});
}

void JsonFields::allow(const QStringList& keys) const
{
    for (const QString& key : m_object.keys())
        if (!keys.contains(key))
            error(key, {QT_TRANSLATE_NOOP("Diagnostic", "there is no key \"%1\" here; expected: %2"),
                        {key, keys.join(QStringLiteral(", "))}});
}

bool JsonFields::needs(const QString& key, Need need, Reason what) const
{
    if (has(key))
        return true;
    if (need == Need::Required)
        error(key, {QT_TRANSLATE_NOOP("Diagnostic", "\"%1\" is missing; it takes %2"), {key, std::move(what)}});
    return false;
}

std::optional<QString> JsonFields::text(const QString& key, Need need) const
{
    const Reason what = QT_TRANSLATE_NOOP("Diagnostic", "a text");
    if (!needs(key, need, what))
        return std::nullopt;
    const QJsonValue found = value(key);
    if (found.isString() && !found.toString().trimmed().isEmpty())
        return found.toString();
    wrongType(key, what);
    return std::nullopt;
}

std::optional<JsonFields> JsonFields::fields(const QString& key, Need need) const
{
    const Reason what = QT_TRANSLATE_NOOP("Diagnostic", "an object");
    if (!needs(key, need, what))
        return std::nullopt;
    if (value(key).isObject())
        return JsonFields(value(key).toObject(), jsonPath(m_path, key), *m_lines, *m_sink);
    wrongType(key, what);
    return std::nullopt;
}

std::vector<JsonFields> JsonFields::list(const QString& key, Need need) const
{
    const Reason what = QT_TRANSLATE_NOOP("Diagnostic", "a list of objects");
    std::vector<JsonFields> elements;
    if (!needs(key, need, what))
        return elements;
    const QJsonArray array = value(key).toArray();
    for (qsizetype i = 0; i < array.size(); ++i) {
        const QString path = jsonPath(jsonPath(m_path, key), QString::number(i));
        if (array[i].isObject())
            elements.emplace_back(array[i].toObject(), path, *m_lines, *m_sink);
        else
            m_sink->error(m_lines->lineOf(path), {QT_TRANSLATE_NOOP("Diagnostic", "\"%1\" takes %2"), {key, what}});
    }
    if (!value(key).isArray() || array.isEmpty())
        wrongType(key, what);
    return elements;
}

QStringList JsonFields::texts(const QString& key) const
{
    QStringList texts;
    const QJsonArray array = value(key).toArray();
    const bool areTexts = value(key).isArray() && std::all_of(array.begin(), array.end(),
                                                              [](const QJsonValue& text) { return text.isString(); });
    if (has(key) && !areTexts)
        wrongType(key, QT_TRANSLATE_NOOP("Diagnostic", "a list of texts"));
    else
        for (const QJsonValue& text : array)
            texts << text.toString();
    return texts;
}

std::optional<std::vector<double>> JsonFields::numbers(const QString& key, qsizetype count, Reason what) const
{
    if (!has(key))
        return std::nullopt;
    const QJsonArray array = value(key).toArray();
    std::vector<double> numbers;
    for (const QJsonValue& number : array)
        if (number.isDouble() && std::isfinite(number.toDouble()))
            numbers.push_back(number.toDouble());
    if (array.size() == count && numbers.size() == static_cast<std::size_t>(count))
        return numbers;
    wrongType(key, std::move(what));
    return std::nullopt;
}

void reportRepeatedKeys(const JsonLines& lines, DiagnosticSink& sink)
{
    for (auto it = lines.repeated().begin(); it != lines.repeated().end(); ++it)
        sink.error(it.value(), {QT_TRANSLATE_NOOP("Diagnostic", "\"%1\" stands twice in one object"),
                                {it.key().section(QLatin1Char('/'), -1)}});
}

} // namespace rasterlens
