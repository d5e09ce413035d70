#include "core/render/steps.h"
#include "app/cli/input.h"
#include "app/cli/options.h"
#include "app/cli/output.h"
#include "app/cli/place_options.h"
#include "app/cli/settings_options.h"
#include "app/cli/verbs.h"
#include "core/observe/step_text.h"

#include <QJsonDocument>

#include <algorithm>
#include <memory>

namespace rasterlens::cli
{
namespace
{

constexpr std::int64_t kMaxLimit = 100'000'000;
constexpr std::int64_t kMaxFrom = 4'000'000'000;

Usage usage()
{
    const auto value = [](const char* name, const char* valueName, const char* help) {
        return Option{QString::fromLatin1(name), Option::Kind::Value, QString::fromLatin1(valueName),
                      QString::fromLatin1(help)};
    };
    const OptionGroup steps{
        QStringLiteral("Steps:"),
        {value(
             "--face", "N",
             "Only this face: a triangle, counted from 0 as --ids does. Where the scene is an OBJ file, each step also "
             "names the line of the f statement that its triangle is a part of."),
         value("--pixel", "X,Y",
               "Only what happens at this pixel, counted from the top left, and to the faces that get there."),
         value("--from", "N",
               "Begins with the step after N others, counted among those that are told; default 0. Steps are made anew "
               "there: any step of a large scene is told in moments."),
         value("--limit", "N", "Most steps; default 1000000. The telling ends there, and the last line says so."),
         value("--json", "F", "One JSON object a line into this file (- is stdout), instead of text.")}};
    const OptionGroup input{QStringLiteral("Input:"), inputOptions()};
    return {QStringLiteral("steps"),
            QStringLiteral("rasterlens-cli steps SCENE [--face N] [--pixel x,y] [--from N] [--limit N] [options]"),
            QStringLiteral("Draws SCENE and tells every step: vertices, clipping, facing, set-up, samples with their "
                           "edge values, depth, colour, writes.\n\n") +
                sceneHelp(),
            {QStringLiteral("SCENE")},
            QList<OptionGroup>{steps, input} + settingsOptionGroups(),
            QStringLiteral("Edge values are areas in samples, exact to the last decimal in fixed point; the JSON also "
                           "has the whole numbers. The algorithm tiled is told as edge-equation, which draws the same "
                           "pixels.\n\n"
                           "Exit codes: 0 told; 2 bad arguments, or settings that cannot be combined; 3 input that "
                           "cannot be read, or output that cannot be written.")};
}

/// Steps as they are written: one after the other, and last that there are more.
struct Telling {
    bool isJson;
    QByteArray text{};

    void add(const QJsonObject& object) { text += QJsonDocument(object).toJson(QJsonDocument::Compact) + '\n'; }
    void add(const StepLog& log, std::size_t i)
    {
        if (isJson)
            add(stepJson(log, i));
        else
            text += stepText(log, i).toUtf8() + '\n';
    }
    void addTruncation(std::size_t limit)
    {
        if (isJson)
            add({{"event", "truncated"}, {"limit", static_cast<qint64>(limit)}});
        else
            text += QStringLiteral("truncated after %1 steps; a larger --limit tells more\n").arg(limit).toUtf8();
    }
};

/// The steps [from, from + limit) of a record, window by window.
void tellRecord(const StepRecord& record, std::size_t from, std::size_t limit, Telling& telling)
{
    const std::size_t size = record.size();
    const std::size_t last = size - std::min(from, size) <= limit + 1 ? size : from + limit; // the end is told beside
    FramePlanes planes;
    while (from < last) {
        const auto log = record.window(from, std::min(last - from, record.index().memory().windowEvents), planes);
        for (std::size_t i = log->lead(); i < log->size(); ++i)
            telling.add(*log, i);
        from = log->last();
    }
    if (last < size)
        telling.addTruncation(limit);
}

} // namespace

Usage stepsUsage() { return usage(); }

ExitCode runSteps(const QStringList& words)
{
    const auto arguments = parseArguments(usage(), words);
    if (!arguments)
        return ExitCode::Fine;
    const Input input = openInput(arguments->operands.first(), *arguments);
    if (const auto reason = refusal(input.scene, input.settings))
        failArguments(QStringLiteral("rasterlens-cli steps: %1").arg(*reason));

    StepFilter filter;
    const auto lastFace = static_cast<std::int64_t>(input.scene.mesh.faceCount()) - 1;
    if (const auto face = wholeOption(*arguments, QStringLiteral("--face"), 0, lastFace))
        filter.face = static_cast<std::uint32_t>(*face);
    if (const auto pixel = pixelOption(*arguments, input.settings.size))
        filter.pixels = PixelRect{pixel->x(), pixel->y(), 1, 1};
    if (const auto limit = wholeOption(*arguments, QStringLiteral("--limit"), 1, kMaxLimit))
        filter.cap = static_cast<std::size_t>(*limit);
    const auto from = wholeOption(*arguments, QStringLiteral("--from"), 0, kMaxFrom);

    const auto file = arguments->value(QStringLiteral("--json"));
    if (file) {
        checkOutputs({*file});
        checkInputsStay({*file}, input.files);
    }
    const std::shared_ptr<const Scene> scene(std::shared_ptr<const Scene>(),
                                             &input.scene); // lent, the input outlives it
    Telling telling{file.has_value()};
    tellRecord(*recordSteps(scene, input.settings, filter), static_cast<std::size_t>(from.value_or(0)), filter.cap,
               telling);
    if (file) {
        OutputFiles files;
        files.add(*file, telling.text);
        files.write();
    } else {
        printText(QString::fromUtf8(telling.text));
    }
    return ExitCode::Fine;
}

} // namespace rasterlens::cli
