#include "app/cli/input.h"
#include "app/cli/options.h"
#include "app/cli/output.h"
#include "app/cli/place_options.h"
#include "app/cli/settings_options.h"
#include "app/cli/verbs.h"
#include "app/cli/window_program.h"
#include "core/base/typed_numbers.h"
#include "core/io/gif_writer.h"
#include "core/io/picture_file.h"
#include "core/io/session.h"
#include "core/lessons/moment.h"
#include "core/lessons/step_run.h"
#include "core/render/motion.h"
#include "core/render/steps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace rasterlens::cli
{
namespace
{

constexpr int kLargestScale = 128;
constexpr int kUsualWidth = 800; ///< of the picture in a figure, about

QStringList overlayNames()
{
    QStringList names;
    for (const char* id : overlayIds())
        names << QLatin1String(id);
    return names;
}

Usage usage()
{
    const auto value = [](const char* name, const char* valueName, const QString& help) {
        return Option{QString::fromLatin1(name), Option::Kind::Value, QString::fromLatin1(valueName), help};
    };
    const OptionGroup figure{
        QStringLiteral("Figure:"),
        {value("-o", "FILE", QStringLiteral("The figure: png, ppm, bmp, jpg, svg or pdf; gif with --steps. Required.")),
         value("--step", "WHERE",
               QStringLiteral(
                   "Shows a step of the drawing with the signs of the edges: %1. Default: that of the session.")
                   .arg(stepPlaceHelp())),
         value("--steps", "FIRST-LAST",
               QStringLiteral("The figures of these steps, one after the other, as an animated GIF.")),
         value("--motion", "MOTION",
               QStringLiteral("A frame of a picture that moves, or a run of frames as an animated GIF; each tells how "
                              "many pixels it changes: %1.")
                   .arg(motionRunHelp())),
         value("--frame-time", "MS",
               QStringLiteral(
                   "With --steps and --motion: how long each picture is shown, %1 to %2 milliseconds; default 250.")
                   .arg(GifWriter::kLeastMilliseconds)
                   .arg(GifWriter::kMostMilliseconds)),
         value("--pixel", "X,Y", QStringLiteral("Selects a pixel, counted from the top left.")),
         value("--region", "X,Y,W,H", QStringLiteral("The pixels that are shown; default: the whole picture.")),
         value(
             "--overlay", "IDS",
             QStringLiteral("What lies over the picture, with commas between: %1, or none. Default: grid, samples and "
                            "numbers where pixels are large enough.")
                 .arg(overlayNames().join(QStringLiteral(", ")))),
         value("--figure-scale", "N",
               QStringLiteral("Side of a pixel in the figure, 1 to %1. Default: so that the picture is about %2 wide.")
                   .arg(kLargestScale)
                   .arg(kUsualWidth)),
         value("--caption", "TEXT",
               QStringLiteral("The caption. Default: scene, settings that were changed, and step.")),
         value("--language", "en|zh", QStringLiteral("The language of what is written; default en.")),
         {QStringLiteral("--before-after"),
          Option::Kind::Switch,
          {},
          QStringLiteral("Shows the picture without the mistakes of --mistake beside it.")},
         allowOutsideOption()}};
    return {
        QStringLiteral("figure"),
        QStringLiteral("rasterlens-cli figure SCENE [--step WHERE] [--pixel x,y] [--overlay ids] -o F.png|svg|pdf "
                       "[options]\n"
                       "       rasterlens-cli figure SCENE --steps FIRST-LAST|--motion ID:FIRST-LAST "
                       "[--frame-time MS] -o F.gif [options]"),
        QStringLiteral("Writes what the canvas of the window shows as a figure: the picture, its pixels enlarged, "
                       "with a margin, a caption, the formula of the step and a legend. The program rasterlens draws "
                       "it, without a display.\n\n") +
            sceneHelp(),
        {QStringLiteral("SCENE")},
        QList<OptionGroup>{figure} + settingsOptionGroups(),
        QStringLiteral("Exit codes: 0 written; 2 bad arguments, or settings that cannot be combined; 3 input that "
                       "cannot be read, or output that cannot be written.")};
}

std::optional<MotionRun> motionOption(const Arguments& arguments)
{
    const auto text = arguments.value(QStringLiteral("--motion"));
    if (!text)
        return std::nullopt;
    const auto run = motionRunFromText(*text);
    if (!run)
        failArguments(QStringLiteral("--motion: \"%1\" is not a motion; expected: %2").arg(*text, motionRunHelp()));
    return run;
}

bool isAnimated(const MotionRun& run) { return run.frames.first < run.frames.second; }

/// Refuses a run that is too long for an animation.
void checkLength(const char* option, const QString& text, const std::pair<std::size_t, std::size_t>& run)
{
    if (run.second - run.first >= GifWriter::kMostPictures)
        failArguments(QStringLiteral("%1: an animation has at most %2 pictures; %3 are %4")
                          .arg(QLatin1String(option))
                          .arg(GifWriter::kMostPictures)
                          .arg(text)
                          .arg(run.second - run.first + 1));
}

QString outputPath(const Arguments& arguments)
{
    const auto path = arguments.value(QStringLiteral("-o"));
    if (!path)
        failArguments(QStringLiteral("rasterlens-cli figure: -o FILE is missing"));
    const QString gif = QStringLiteral("gif");
    const auto motion = motionOption(arguments);
    const bool isRun = arguments.has(QStringLiteral("--steps")) || (motion && isAnimated(*motion));
    if (!isRun && formatOf(*path) == gif)
        failArguments(QStringLiteral("%1: a GIF is an animation; --steps FIRST-LAST or --motion ID:FIRST-LAST is "
                                     "expected beside it")
                          .arg(*path));
    if (const auto problem =
            whyNotFormat(*path, isRun ? QStringList{gif}
                                      : pictureSuffixes() + QStringList{QStringLiteral("svg"), QStringLiteral("pdf")}))
        failArguments(QStringLiteral("%1: %2").arg(*path, textOf(*problem)));
    checkOutputs({*path});
    return *path;
}

QString overlayOption(const QString& text)
{
    for (const QString& id : text.split(QLatin1Char(','), Qt::SkipEmptyParts))
        if (id != QLatin1String("none") && !overlayNames().contains(id))
            failArguments(QStringLiteral("--overlay: \"%1\" is not an overlay; expected: %2, none")
                              .arg(id, overlayNames().join(QStringLiteral(", "))));
    return text;
}

/// The number of the step that `--step` names.
std::size_t stepOption(const QString& text, const Input& input)
{
    const auto place = stepPlaceFromText(text);
    if (!place)
        failArguments(QStringLiteral("--step: \"%1\" is not a step; expected: %2").arg(text, stepPlaceHelp()));
    const std::shared_ptr<const Scene> scene(std::shared_ptr<const Scene>(), &input.scene); // lent
    const auto position = positionOf(*place, recordSteps(scene, input.settings));
    if (!position)
        failArguments(QStringLiteral("--step: with these settings the record has no step \"%1\"").arg(text));
    return *position;
}

/// What the program with the window is told of the steps of an animation.
QStringList runWords(const Arguments& arguments, const Input& input)
{
    const auto text = arguments.value(QStringLiteral("--steps"));
    if (!text)
        return {};
    for (const char* other : {"--step", "--before-after", "--motion"})
        if (arguments.has(QLatin1String(other)))
            failArguments(QStringLiteral("--steps: cannot be combined with %1").arg(QLatin1String(other)));
    const auto run = stepRunFromText(*text);
    if (!run)
        failArguments(QStringLiteral("--steps: \"%1\" is no run of steps; expected: FIRST-LAST, as 10-60").arg(*text));
    checkLength("--steps", *text, *run);
    const std::shared_ptr<const Scene> scene(std::shared_ptr<const Scene>(), &input.scene); // lent
    const std::size_t size = recordSteps(scene, input.settings)->size();
    if (run->second > size)
        failArguments(QStringLiteral("--steps: with these settings the record has the steps 0 to %1").arg(size));
    return {QStringLiteral("--step"), QString::number(run->first), QStringLiteral("--figure-steps"), *text};
}

/// What it is told of a motion.
QStringList motionWords(const Arguments& arguments, const Input& input)
{
    const auto run = motionOption(arguments);
    if (!run)
        return {};
    for (const char* other : {"--step", "--before-after"})
        if (arguments.has(QLatin1String(other)))
            failArguments(QStringLiteral("--motion: cannot be combined with %1").arg(QLatin1String(other)));
    if (const auto why = whyNotMoved(input.scene, run->motion))
        failArguments(QStringLiteral("--motion: %1").arg(textOf(*why)));
    const QString text = *arguments.value(QStringLiteral("--motion"));
    checkLength("--motion", text, run->frames);
    return {QStringLiteral("--motion"), text};
}

QStringList frameTimeWords(const Arguments& arguments)
{
    const auto milliseconds = wholeOption(arguments, QStringLiteral("--frame-time"), GifWriter::kLeastMilliseconds,
                                          GifWriter::kMostMilliseconds);
    if (!milliseconds)
        return {};
    const auto motion = motionOption(arguments);
    if (!arguments.has(QStringLiteral("--steps")) && !(motion && isAnimated(*motion)))
        failArguments(QStringLiteral("--frame-time: needs --steps or a run of --motion beside it"));
    return {QStringLiteral("--frame-time"), QString::number(*milliseconds)};
}

/// The value of `--region`, or the whole picture.
QRect regionOption(const Arguments& arguments, QSize size)
{
    const QRect whole(QPoint(0, 0), size);
    const auto text = arguments.value(QStringLiteral("--region"));
    if (!text)
        return whole;
    const auto numbers = typedNumbers(*text);
    const auto isWhole = [](double number) {
        return number == std::floor(number) && number >= 0 && number <= kMaxViewport;
    };
    const bool isRegion = numbers && numbers->size() == 4 && std::ranges::all_of(*numbers, isWhole);
    const QRect region =
        isRegion ? QRectF((*numbers)[0], (*numbers)[1], (*numbers)[2], (*numbers)[3]).toRect() & whole : QRect();
    if (region.isEmpty())
        failArguments(
            QStringLiteral("--region: \"%1\" is no part of the picture; expected: x,y,w,h within %2 x %3 pixels")
                .arg(*text)
                .arg(size.width())
                .arg(size.height()));
    return region;
}

/// What the window showed when a session was saved: it stands where the command line says nothing else.
Moment viewOfSession(const QString& name)
{
    if (!isSession(name))
        return {};
    const SessionLoad load = loadSession(name);
    return load.session ? sessionView(load.session->view, name).moment : Moment();
}

/// Step, pixel and overlays: those of the command line, else those of the session.
QStringList momentWords(const Arguments& arguments, const Input& input)
{
    const Moment session = viewOfSession(arguments.operands.first());
    QStringList words;
    const bool isOneMoment =
        std::ranges::none_of(std::array{"--steps", "--motion", "--before-after"},
                             [&](const char* option) { return arguments.has(QLatin1String(option)); });
    if (const auto text = arguments.value(QStringLiteral("--step")))
        words << QStringLiteral("--step") << QString::number(stepOption(*text, input));
    else if (session.step && isOneMoment)
        words << QStringLiteral("--step") << QString::number(stepOption(textOf(*session.step), input));
    const auto pixel = pixelOption(arguments, input.settings.size);
    if (const auto shown = pixel ? pixel : session.pixel;
        shown && QRect(QPoint(0, 0), input.settings.size).contains(*shown))
        words << QStringLiteral("--pixel") << QStringLiteral("%1,%2").arg(shown->x()).arg(shown->y());
    QStringList kept;
    for (const QString& id : session.overlays)
        if (id == QLatin1String("none") || overlayNames().contains(id))
            kept << id;
    if (const auto text = arguments.value(QStringLiteral("--overlay")))
        words << QStringLiteral("--figure-overlay") << overlayOption(*text);
    else if (!kept.isEmpty())
        words << QStringLiteral("--figure-overlay") << kept.join(QLatin1Char(','));
    return words;
}

int scaleFor(QSize size) { return std::clamp(kUsualWidth / std::max(size.width(), size.height()), 1, kLargestScale); }

/// What the program with the window is told.
QStringList windowWords(const Arguments& arguments, const Input& input, const QString& path)
{
    const QRect region = regionOption(arguments, input.settings.size);
    const auto scale = wholeOption(arguments, QStringLiteral("--figure-scale"), 1, kLargestScale);
    QStringList words = regionWords(region);
    if (outsideOf(arguments) == Outside::Allow)
        words << QStringLiteral("--allow-outside");
    words << QStringLiteral("--figure") << path << QStringLiteral("--figure-scale")
          << QString::number(scale ? int(*scale) : scaleFor(region.size()));
    words << momentWords(arguments, input);
    words << runWords(arguments, input) << motionWords(arguments, input) << frameTimeWords(arguments);
    if (const auto text = arguments.value(QStringLiteral("--caption")))
        words << QStringLiteral("--caption") << *text;
    const QString language = arguments.value(QStringLiteral("--language")).value_or(QStringLiteral("en"));
    if (language != QLatin1String("en") && language != QLatin1String("zh"))
        failArguments(QStringLiteral("--language: \"%1\" is not a language; expected: en, zh").arg(language));
    words << QStringLiteral("--language") << language;
    if (arguments.isOn(QStringLiteral("--before-after"))) {
        if (input.settings.mistakes.isEmpty())
            failArguments(QStringLiteral("--before-after: needs --mistake beside it"));
        words << QStringLiteral("--before-after");
    }
    return words;
}

} // namespace

Usage figureUsage() { return usage(); }

ExitCode runFigure(const QStringList& words)
{
    const auto arguments = parseArguments(usage(), words);
    if (!arguments)
        return ExitCode::Fine;
    const Consent consent(outsideOf(*arguments));
    const QString path = outputPath(*arguments);
    const Input input = openInput(arguments->operands.first(), *arguments);
    checkInputsStay({path}, input.files);
    if (const auto reason = refusal(input.scene, input.settings))
        failArguments(QStringLiteral("rasterlens-cli figure: %1").arg(*reason));
    return runWindowProgram(input.scene, input.settings, windowWords(*arguments, input, path));
}

} // namespace rasterlens::cli
