#include "core/questions/identify.h"
#include "app/cli/input.h"
#include "app/cli/options.h"
#include "app/cli/output.h"
#include "app/cli/settings_options.h"
#include "app/cli/verbs.h"
#include "core/io/picture_input.h"
#include "core/settings/mistakes.h"

#include <QJsonDocument>

namespace rasterlens::cli
{
namespace
{

Usage usage()
{
    const OptionGroup question{
        QStringLiteral("Question:"),
        {{QStringLiteral("--scene"), Option::Kind::Value, QStringLiteral("SCENE"),
          QStringLiteral("What the picture is to show. Required.")},
         {QStringLiteral("--json"), Option::Kind::Value, QStringLiteral("F"),
          QStringLiteral("The answer as a JSON object in this file (- is stdout), instead of text.")}}};
    const OptionGroup input{QStringLiteral("Input:"), inputOptions()};
    return {
        QStringLiteral("identify"),
        QStringLiteral("rasterlens-cli identify IMAGE --scene SCENE [--size WxH] [--json F] [options]"),
        QStringLiteral("Says which mistake made a picture: compares it with the right one and with what each mistake "
                       "draws in the scene, alone and two at once.\n\n"
                       "IMAGE is a PNG, JPEG, BMP, PPM or TGA file, or a NumPy array of shape (H, W), (H, W, 3) or "
                       "(H, W, 4). It may have a border, be half as large, lie up to two pixels beside its place, "
                       "be noisy, and have another background.\n\n") +
            sceneHelp(),
        {QStringLiteral("IMAGE")},
        QList<OptionGroup>{question, input} + settingsOptionGroups(),
        QStringLiteral(
            "A score of 1 means that all that the mistake changes is there, and nothing else; 0 that nothing of it "
            "is. \"none\" is the picture without mistakes. Where no score reaches 0.5, nothing fits.\n\n"
            "JSON: {\"matches\": [{\"mistake\": id, \"score\": 0..1, \"pixels\": the pixels that the mistake changes, "
            "\"where\": [x, y, w, h] around them, \"unlike\": the pixels at which IMAGE differs visibly from what the "
            "mistake draws, \"alike\": mistakes that draw the same picture here, \"with\": the second of two "
            "mistakes}, "
            "..], \"fits\": whether the best one is a match, \"size\", \"place\", \"offset\"}, best first.\n\n"
            "Exit codes: 0 answered; 2 bad arguments, or settings that cannot be combined; 3 input that cannot be "
            "read, or output that cannot be written.")};
}

QString titleOf(const QString& id)
{
    const Mistake* mistake = findMistake(id);
    return mistake ? QStringLiteral("%1, %2").arg(QLatin1String(mistake->number), QLatin1String(mistake->title))
                   : QStringLiteral("the right picture");
}

QString lineOf(const MistakeMatch& match)
{
    QString line = QStringLiteral("%1 %  %2  %3")
                       .arg(100 * match.score, 5, 'f', 1)
                       .arg(match.mistake, -22)
                       .arg(titleOf(match.mistake));
    if (match.pixels > 0)
        line += QStringLiteral("; changes %1 pixels in %2 x %3 at (%4, %5)")
                    .arg(match.pixels)
                    .arg(match.where.width())
                    .arg(match.where.height())
                    .arg(match.where.x())
                    .arg(match.where.y());
    if (!match.with.isEmpty())
        line += QStringLiteral("; together with %1").arg(match.with);
    constexpr qsizetype kNamed = 6; // what changes nothing here is most of the list
    if (match.alike.size() > kNamed)
        line += QStringLiteral("; %1 mistakes draw the same picture here").arg(match.alike.size());
    else if (!match.alike.isEmpty())
        line += QStringLiteral("; draws the same picture here: %1").arg(match.alike.join(QStringLiteral(", ")));
    return line + QLatin1Char('\n');
}

QString textOf(const Identification& found)
{
    constexpr std::size_t kListed = 5;
    QString text;
    if (!found.fits())
        text = QStringLiteral("none of these: no mistake explains the picture\n");
    for (std::size_t i = 0; i < std::min(kListed, found.matches.size()); ++i)
        text += lineOf(found.matches[i]);
    return text;
}

} // namespace

Usage identifyUsage() { return usage(); }

ExitCode runIdentify(const QStringList& words)
{
    const auto arguments = parseArguments(usage(), words);
    if (!arguments)
        return ExitCode::Fine;
    const auto scene = arguments->value(QStringLiteral("--scene"));
    if (!scene)
        failArguments(QStringLiteral("rasterlens-cli identify: --scene SCENE is missing"));
    const QString file = arguments->operands.first();
    const auto json = arguments->value(QStringLiteral("--json"));
    if (json)
        checkOutputs({*json});
    const PictureLoad picture = loadPicture(file);
    if (picture.problem)
        failInput(QStringLiteral("%1: %2").arg(file, rasterlens::textOf(*picture.problem)));
    const Input input = openInput(*scene, *arguments);
    if (json)
        checkInputsStay({*json}, input.files + QStringList{file});
    if (const auto reason = refusal(input.scene, input.settings))
        failArguments(QStringLiteral("rasterlens-cli identify: %1").arg(*reason));
    if (const auto reason = whyNotIdentified(picture.image, input.settings))
        failArguments(QStringLiteral("%1: %2").arg(file, rasterlens::textOf(*reason)));
    const Identification found = identify(input.scene, input.settings, picture.image);
    if (json) {
        OutputFiles files;
        files.add(*json, QJsonDocument(toJson(found)).toJson());
        files.write();
    } else {
        printText(textOf(found));
    }
    return ExitCode::Fine;
}

} // namespace rasterlens::cli
