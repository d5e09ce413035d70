#pragma once
// Pages and what stands in them.
#include "core/page/page.h"
#include "core/render/steps.h"
#include "core/scenes/load_scene.h"
#include "ui/window/window_page_words.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

namespace rasterlens::test
{

inline Scene pageScene(const QString& name) { return *loadScene(name).scene; }

/// The page of a scene as it asks to be drawn.
inline QByteArray pageOf(const Scene& scene, const StepFilter& filter = {}, const Lesson* lesson = nullptr)
{
    WindowPageWords words;
    const PageResult made = makePage({scene, scene.defaults, filter, lesson, {}, {}}, words);
    for (const Diagnostic& diagnostic : made.diagnostics)
        qWarning("%s", qPrintable(diagnostic.text()));
    return made.html;
}

/// The data that a page holds.
inline QJsonObject dataOf(const QByteArray& html)
{
    const QByteArray begin = "<script id=\"data\" type=\"application/json\">";
    const qsizetype from = html.indexOf(begin) + begin.size();
    const QByteArray text = html.mid(from, html.indexOf("</script>", from) - from);
    QJsonParseError error{};
    const QJsonObject data = QJsonDocument::fromJson(text, &error).object();
    if (error.error != QJsonParseError::NoError)
        qWarning("the data of the page is no JSON: %s", qPrintable(error.errorString()));
    return data;
}

} // namespace rasterlens::test
