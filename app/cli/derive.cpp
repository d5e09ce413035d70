#include "core/derive/derive.h"
#include "app/cli/input.h"
#include "app/cli/options.h"
#include "app/cli/output.h"
#include "app/cli/place_options.h"
#include "app/cli/settings_options.h"
#include "app/cli/verbs.h"
#include "core/base/typed_numbers.h"

#include <QJsonDocument>

namespace rasterlens::cli
{
namespace
{

QStringList topicIds()
{
    QStringList ids;
    for (const DerivationTopicInfo& info : derivationTopics())
        ids << QLatin1String(info.id);
    return ids;
}

QString topicList()
{
    QString text;
    for (const DerivationTopicInfo& info : derivationTopics())
        text += QStringLiteral("%1 %2\n").arg(QLatin1String(info.id), -18).arg(QLatin1String(info.title));
    return text;
}

Usage usage()
{
    const auto value = [](const char* name, const char* valueName, const QString& help) {
        return Option{QString::fromLatin1(name), Option::Kind::Value, QString::fromLatin1(valueName), help};
    };
    const OptionGroup question{
        QStringLiteral("Question:"),
        {value("--topic", "ID", QStringLiteral("What to derive. Required.\n") + topicIds().join(QStringLiteral(", "))),
         {QStringLiteral("--list"), Option::Kind::Switch, QString(), QStringLiteral("Lists the topics and ends.")},
         value("--face", "N", QStringLiteral("A triangle, counted from 0 as --ids does; default 0.")),
         value("--pixel", "X,Y",
               QStringLiteral(
                   "A pixel, counted from the top left; default: one inside the face. For bresenham: a pixel of "
                   "the edge; default: its first.")),
         value("--edge", "AB|BC|CA",
               QStringLiteral(
                   "An edge of the face; default AB, for perspective and depth-curve the edge whose ends lie most "
                   "unequally far away.")),
         value("--m", "M",
               QStringLiteral("perspective, depth-curve: part of the way along the edge, between 0 and 1; default 0.5. "
                              "perspective counts it on the screen, depth-curve in space.")),
         value("--depth", "Z",
               QStringLiteral("depth-curve: a distance on the curve; default half-way from near to far.")),
         value("--json", "F",
               QStringLiteral("The derivation as a JSON object in this file (- is stdout), instead of text."))}};
    const OptionGroup input{QStringLiteral("Input:"), inputOptions()};
    return {
        QStringLiteral("derive"),
        QStringLiteral("rasterlens-cli derive SCENE --topic ID [--face N] [--pixel x,y] [--json F] [options]"),
        QStringLiteral("Derives a formula line by line, with the numbers of a face put in: in symbols, in numbers, "
                       "and in words.\n\n") +
            sceneHelp(),
        {QStringLiteral("SCENE")},
        QList<OptionGroup>{question, input} + settingsOptionGroups(),
        QStringLiteral("The numbers are those the stages draw with. The topics bresenham, two-point, cohen-sutherland "
                       "and painter set the way of drawing they are about.\n\n"
                       "Exit codes: 0 derived; 2 bad arguments, settings that cannot be combined, or a place with "
                       "nothing to derive; 3 input that cannot be read, or output that cannot be written.")};
}

/// A number between two limits, which it must not reach.
std::optional<double> numberOption(const Arguments& arguments, const QString& name, double above, double below,
                                   const QString& takes)
{
    const auto text = arguments.value(name);
    if (!text)
        return std::nullopt;
    const auto values = typedNumbers(*text);
    if (!values || values->size() != 1 || !(values->front() > above && values->front() < below))
        failArguments(QStringLiteral("%1: \"%2\" is not %3").arg(name, *text, takes));
    return values->front();
}

std::optional<int> edgeOption(const Arguments& arguments)
{
    const QStringList names{QStringLiteral("AB"), QStringLiteral("BC"), QStringLiteral("CA")};
    const auto text = arguments.value(QStringLiteral("--edge"));
    if (!text)
        return std::nullopt;
    const qsizetype edge = names.indexOf(*text);
    if (edge < 0)
        failArguments(QStringLiteral("--edge: \"%1\" is not an edge; expected: AB, BC, CA").arg(*text));
    return static_cast<int>(edge);
}

DerivationTopic topicOption(const Arguments& arguments)
{
    const auto text = arguments.value(QStringLiteral("--topic"));
    const QString expected = topicIds().join(QStringLiteral(", "));
    if (!text)
        failArguments(QStringLiteral("rasterlens-cli derive: --topic ID is missing; expected: %1").arg(expected));
    const auto topic = derivationTopic(*text);
    if (!topic)
        failArguments(QStringLiteral("--topic: \"%1\" is not a topic; expected: %2").arg(*text, expected));
    return *topic;
}

DerivationPlace placeOf(const Arguments& arguments, const Input& input)
{
    if (input.scene.mesh.faceCount() == 0)
        failArguments(QStringLiteral("rasterlens-cli derive: the scene has no face"));
    const auto last = static_cast<std::int64_t>(input.scene.mesh.faceCount()) - 1;
    DerivationPlace place;
    place.face = static_cast<std::uint32_t>(wholeOption(arguments, QStringLiteral("--face"), 0, last).value_or(0));
    place.pixel = pixelOption(arguments, input.settings.size);
    place.edge = edgeOption(arguments);
    place.m = numberOption(arguments, QStringLiteral("--m"), 0, 1, QStringLiteral("a number between 0 and 1"))
                  .value_or(place.m);
    place.depth =
        numberOption(arguments, QStringLiteral("--depth"), 0, 1e30, QStringLiteral("a distance in front of the eye"));
    return place;
}

} // namespace

Usage deriveUsage() { return usage(); }

ExitCode runDerive(const QStringList& words)
{
    if (words.contains(QStringLiteral("--list"))) {
        printText(topicList());
        return ExitCode::Fine;
    }
    const auto arguments = parseArguments(usage(), words);
    if (!arguments)
        return ExitCode::Fine;
    const DerivationTopic topic = topicOption(*arguments);
    const Input input = openInput(arguments->operands.first(), *arguments);
    if (const auto reason = refusal(input.scene, input.settings))
        failArguments(QStringLiteral("rasterlens-cli derive: %1").arg(*reason));
    const DerivationPlace place = placeOf(*arguments, input);
    const auto file = arguments->value(QStringLiteral("--json"));
    if (file) {
        checkOutputs({*file});
        checkInputsStay({*file}, input.files);
    }
    const Derived derived = derive(topic, input.scene, input.settings, place);
    if (!derived.derivation)
        failArguments(QStringLiteral("rasterlens-cli derive: %1").arg(textOf(derived.refusal)));
    if (file) {
        OutputFiles files;
        files.add(*file, QJsonDocument(toJson(*derived.derivation)).toJson());
        files.write();
    } else {
        printText(textOf(*derived.derivation));
    }
    return ExitCode::Fine;
}

} // namespace rasterlens::cli
