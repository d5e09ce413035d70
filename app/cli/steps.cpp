#include "core/render/steps.h"
#include "app/cli/input.h"
#include "app/cli/options.h"
#include "app/cli/output.h"
#include "app/cli/place_options.h"
#include "app/cli/settings_options.h"
#include "app/cli/verbs.h"
#include "core/observe/step_text.h"

#include <QJsonDocument>

namespace rasterlens::cli
{
namespace
{

constexpr std::int64_t kMaxLimit = 100'000'000;

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
         value("--limit", "N", "Most steps; default 1000000. The drawing ends there, and the last line says so."),
         value("--json", "F", "One JSON object a line into this file (- is stdout), instead of text.")}};
    const OptionGroup input{QStringLiteral("Input:"), inputOptions()};
    return {QStringLiteral("steps"),
            QStringLiteral("rasterlens-cli steps SCENE [--face N] [--pixel x,y] [--limit N] [--json F] [options]"),
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

QString truncation(const StepFilter& filter)
{
    return QStringLiteral("truncated after %1 steps; a larger --limit tells more").arg(filter.cap);
}

QString textOf(const StepLog& log)
{
    QString text;
    for (std::size_t i = 0; i < log.size(); ++i)
        text += stepText(log, i) + QLatin1Char('\n');
    return log.truncated() ? text + truncation(log.filter()) + QLatin1Char('\n') : text;
}

QByteArray jsonLinesOf(const StepLog& log)
{
    const auto line = [](const QJsonObject& object) {
        return QJsonDocument(object).toJson(QJsonDocument::Compact) + '\n';
    };
    QByteArray lines;
    for (std::size_t i = 0; i < log.size(); ++i)
        lines += line(stepJson(log, i));
    if (log.truncated())
        lines += line({{"event", "truncated"}, {"limit", static_cast<qint64>(log.filter().cap)}});
    return lines;
}

} // namespace

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

    const auto file = arguments->value(QStringLiteral("--json"));
    if (file) {
        checkOutputs({*file});
        checkInputsStay({*file}, input.files);
    }
    const auto log = renderSteps(input.scene, input.settings, filter);
    if (file) {
        OutputFiles files;
        files.add(*file, jsonLinesOf(*log));
        files.write();
    } else {
        printText(textOf(*log));
    }
    return ExitCode::Fine;
}

} // namespace rasterlens::cli
