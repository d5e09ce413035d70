#include "core/page/page.h"

#include "core/page/page_lesson.h"

#include <QFile>
#include <QJsonDocument>

namespace rasterlens
{
namespace
{

QByteArray resource(const char* name)
{
    QFile file(QStringLiteral(":/rasterlens/page/") + QLatin1String(name));
    if (!file.open(QIODevice::ReadOnly))
        qFatal("the page's %s is missing in the resources of this program", name);
    return file.readAll();
}

QByteArray script()
{
    QByteArray text;
    for (const char* part : {"words.js", "run.js", "picture.js", "lesson.js", "page.js"})
        text += resource(part) + '\n';
    return text;
}

/// Puts the parts in the places of their names, in one pass: a part may hold the name of another.
QByteArray filled(const QByteArray& text, const QHash<QByteArray, QByteArray>& parts)
{
    QByteArray out;
    qsizetype from = 0;
    for (qsizetype at = text.indexOf('@'); at >= 0; at = text.indexOf('@', from)) {
        const qsizetype end = text.indexOf('@', at + 1);
        const auto part = parts.constFind(text.mid(at + 1, end - at - 1));
        out += text.mid(from, at - from);
        out += part == parts.constEnd() ? text.mid(at, end + 1 - at) : *part;
        from = end + 1;
    }
    return out + text.mid(from);
}

} // namespace

QByteArray embeddable(const QJsonObject& object)
{
    QByteArray text = QJsonDocument(object).toJson(QJsonDocument::Compact);
    text.replace('<', "\\u003c"); // JSON has the sign within texts alone
    text.replace("\u2028", "\\u2028");
    text.replace("\u2029", "\\u2029");
    return text;
}

PageResult makePage(const PageRequest& request, PageWords& words)
{
    PageResult result;
    PageTables tables;
    PageRuns runs(words, tables);
    runs.addMain(request.scene, request.settings, request.filter);
    QJsonObject data;
    if (request.lesson != nullptr)
        data.insert(QStringLiteral("lesson"),
                    lessonJson(*request.lesson, runs, words, tables.texts, result.diagnostics));
    if (hasErrors(result.diagnostics))
        return result;
    QJsonObject start;
    if (request.start)
        start.insert(QStringLiteral("step"), static_cast<qint64>(*request.start) - 1);
    if (request.pixel)
        start.insert(QStringLiteral("pixel"), QJsonArray{request.pixel->x(), request.pixel->y()});
    if (!start.isEmpty())
        data.insert(QStringLiteral("start"), start);
    data.insert(QStringLiteral("texts"), tables.texts.json());
    data.insert(QStringLiteral("codes"), tables.codes);
    data.insert(QStringLiteral("runs"), runs.json());
    words.use(PageLanguage::English);
    const QString title = words.sceneTitle(request.scene) + QStringLiteral(" \u2013 RasterLens");
    result.html = filled(resource("page.html"), {{"generator", "RasterLens " RASTERLENS_VERSION},
                                                 {"title", title.toHtmlEscaped().toUtf8()},
                                                 {"style", resource("page.css")},
                                                 {"data", embeddable(data)},
                                                 {"script", script()}});
    return result;
}

} // namespace rasterlens
