#include "core/questions/why.h"
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

Usage usage()
{
    const OptionGroup question{
        QStringLiteral("Question:"),
        {{QStringLiteral("--pixel"), Option::Kind::Value, QStringLiteral("X,Y"),
          QStringLiteral("The pixel, counted from the top left. Required.")},
         {QStringLiteral("--json"), Option::Kind::Value, QStringLiteral("F"),
          QStringLiteral("The answer as a JSON object in this file (- is stdout), instead of text.")}}};
    const OptionGroup input{QStringLiteral("Input:"), inputOptions()};
    return {
        QStringLiteral("why"),
        QStringLiteral("rasterlens-cli why SCENE --pixel x,y [--json F] [options]"),
        QStringLiteral("Says of every face that could concern a pixel what became of it there, and with which "
                       "numbers.\n\n") +
            sceneHelp(),
        {QStringLiteral("SCENE")},
        QList<OptionGroup>{question, input} + settingsOptionGroups(),
        QStringLiteral(
            "A face is a triangle, counted from 0 as --ids does. Where the scene is an OBJ file, the line "
            "of the f statement that it is a part of stands behind it.\n\n"
            "With several samples a pixel the faces are judged at the sample nearest its centre, and what all samples "
            "store is told with the sum that makes their mean.\n\n"
            "Exit codes: 0 answered; 2 bad arguments, or settings that cannot be combined; 3 input that "
            "cannot be read, or output that cannot be written.")};
}

QString textOf(const WhyReport& report)
{
    QString text = QStringLiteral("pixel %1,%2: %3").arg(report.x).arg(report.y).arg(colorText(report.color));
    text += report.visibleFace
                ? QStringLiteral(", ") + faceText(*report.visibleFace, report.lineOf(*report.visibleFace))
                : QStringLiteral(", background");
    text += QStringLiteral(", depth %1\n").arg(double(report.depth), 0, 'g', 9);
    for (const QString& line : whySamples(report))
        text += line + QLatin1Char('\n');
    for (const WhyFace& face : report.faces)
        text += whyText(report, face) + QLatin1Char('\n');
    return report.faces.empty() ? text + QStringLiteral("no face concerns it\n") : text;
}

} // namespace

Usage whyUsage() { return usage(); }

ExitCode runWhy(const QStringList& words)
{
    const auto arguments = parseArguments(usage(), words);
    if (!arguments)
        return ExitCode::Fine;
    if (!arguments->has(QStringLiteral("--pixel")))
        failArguments(QStringLiteral("rasterlens-cli why: --pixel x,y is missing"));
    const Input input = openInput(arguments->operands.first(), *arguments);
    if (const auto reason = refusal(input.scene, input.settings))
        failArguments(QStringLiteral("rasterlens-cli why: %1").arg(*reason));
    const QPoint pixel = *pixelOption(*arguments, input.settings.size);
    const auto file = arguments->value(QStringLiteral("--json"));
    if (file) {
        checkOutputs({*file});
        checkInputsStay({*file}, input.files);
    }
    const WhyReport report = why(input.scene, input.settings, pixel.x(), pixel.y());
    if (file) {
        OutputFiles files;
        files.add(*file, QJsonDocument(toJson(report)).toJson());
        files.write();
    } else {
        printText(textOf(report));
    }
    return ExitCode::Fine;
}

} // namespace rasterlens::cli
