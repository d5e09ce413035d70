#include "core/io/json_lines.h"

#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>

namespace rasterlens
{
namespace
{

/// Walks a valid JSON text and notes where each value begins.
class Walker
{
public:
    Walker(const QByteArray& text, QMap<QString, int>& lines, QMap<QString, int>& repeated)
        : m_text(text), m_lines(lines), m_repeated(repeated)
    {
    }

    void walk()
    {
        skipBlanks();
        note(QString(), m_line);
        value(QString());
    }

private:
    const QByteArray& m_text;
    QMap<QString, int>& m_lines;
    QMap<QString, int>& m_repeated;
    qsizetype m_at = 0;
    int m_line = 1;

    [[nodiscard]] char now() const { return m_at < m_text.size() ? m_text[m_at] : '\0'; }

    void advance()
    {
        if (now() == '\n')
            ++m_line;
        ++m_at;
    }

    void skipBlanks()
    {
        while (m_at < m_text.size() && QByteArrayView(" \t\r\n,:").contains(now()))
            advance();
    }

    void note(const QString& path, int line)
    {
        if (m_lines.contains(path))
            m_repeated.insert(path, line);
        m_lines.insert(path, line);
    }

    void value(const QString& path)
    {
        if (now() == '{')
            members(path);
        else if (now() == '[')
            elements(path);
        else if (now() == '"')
            (void)string();
        else
            while (m_at < m_text.size() && !QByteArrayView(" \t\r\n,]}").contains(now()))
                advance();
    }

    void members(const QString& path)
    {
        advance();
        for (skipBlanks(); m_at < m_text.size() && now() != '}'; skipBlanks()) {
            const int line = m_line;
            const QString key = jsonPath(path, string());
            note(key, line);
            skipBlanks();
            value(key);
        }
        advance();
    }

    void elements(const QString& path)
    {
        advance();
        int index = 0;
        for (skipBlanks(); m_at < m_text.size() && now() != ']'; skipBlanks()) {
            const QString element = jsonPath(path, QString::number(index++));
            note(element, m_line);
            value(element);
        }
        advance();
    }

    /// The text between quotation marks, without its escapes.
    QString string()
    {
        const qsizetype begin = m_at;
        advance();
        while (m_at < m_text.size() && now() != '"') {
            if (now() == '\\')
                advance();
            advance();
        }
        advance();
        const QByteArray quoted = "{\"s\":" + m_text.mid(begin, m_at - begin) + "}";
        return QJsonDocument::fromJson(quoted).object().value(QLatin1String("s")).toString();
    }
};

} // namespace

QString jsonPath(const QString& path, const QString& key)
{
    return path.isEmpty() ? key : path + QLatin1Char('/') + key;
}

JsonLines::JsonLines(const QByteArray& text) { Walker(text, m_lines, m_repeated).walk(); }

int JsonLines::lineOf(QString path) const
{
    while (!m_lines.contains(path)) {
        if (path.isEmpty())
            return 1;
        path = path.left(std::max(qsizetype(0), path.lastIndexOf(QLatin1Char('/'))));
    }
    return m_lines.value(path);
}

} // namespace rasterlens
