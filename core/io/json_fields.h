#pragma once
#include "core/io/json_lines.h"
#include "core/io/text_input.h"

#include <QJsonObject>

#include <optional>
#include <vector>

namespace rasterlens
{

/// One object of a JSON file while it is read. Every error names the file and the line of the value that is wrong.
///
/// in  `lines` and `sink` outlive it
class JsonFields
{
public:
    enum class Need { Required, Optional };

    JsonFields(QJsonObject object, QString path, const JsonLines& lines, DiagnosticSink& sink)
        : m_object(std::move(object)), m_path(std::move(path)), m_lines(&lines), m_sink(&sink)
    {
    }

    [[nodiscard]] bool has(const QString& key) const { return m_object.contains(key); }
    [[nodiscard]] QJsonValue value(const QString& key) const { return m_object.value(key); }
    [[nodiscard]] const QJsonObject& object() const { return m_object; }
    [[nodiscard]] int line() const { return m_lines->lineOf(m_path); }
    [[nodiscard]] int lineOf(const QString& key) const { return m_lines->lineOf(jsonPath(m_path, key)); }

    void error(const QString& key, Reason message) const { m_sink->error(lineOf(key), std::move(message)); }
    /// `"KEY" takes WHAT`
    void wrongType(const QString& key, Reason what) const;

    /// errors  a key that is none of these
    void allow(const QStringList& keys) const;

    // Each reads a value. Nothing, and an error, where it has another type or a required one is missing.
    [[nodiscard]] std::optional<QString> text(const QString& key, Need need) const;
    [[nodiscard]] std::optional<JsonFields> fields(const QString& key, Need need) const;
    /// All elements, each an object.
    [[nodiscard]] std::vector<JsonFields> list(const QString& key, Need need) const;
    [[nodiscard]] QStringList texts(const QString& key) const;
    /// errors  not `count` finite numbers; `what` says what they are
    [[nodiscard]] std::optional<std::vector<double>> numbers(const QString& key, qsizetype count, Reason what) const;

private:
    /// Whether there is a value to read; an error where it is missing and needed.
    [[nodiscard]] bool needs(const QString& key, Need need, Reason what) const;

    QJsonObject m_object;
    QString m_path;
    const JsonLines* m_lines;
    DiagnosticSink* m_sink;
};

/// Reports each key that stands twice in one object.
void reportRepeatedKeys(const JsonLines& lines, DiagnosticSink& sink);

} // namespace rasterlens
