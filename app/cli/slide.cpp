#include "app/cli/slide.h"

#include "app/cli/failure.h"
#include "app/cli/place_options.h"
#include "app/cli/settings_options.h"
#include "core/io/input_log.h"
#include "core/render/steps.h"

#include <cstdio>
#include <memory>

namespace rasterlens::cli
{
namespace
{

const QString kLesson = QStringLiteral("--lesson");
const QString kStep = QStringLiteral("--step");

/// Prints the warnings; ends the program at errors.
void report(const Diagnostics& diagnostics)
{
    QStringList errors;
    for (const Diagnostic& diagnostic : diagnostics)
        if (diagnostic.severity == Severity::Error)
            errors << diagnostic.text();
        else if (diagnostic.severity == Severity::Warning)
            std::fprintf(stderr, "%s\n", qUtf8Printable(diagnostic.text()));
    if (!errors.isEmpty())
        failInput(errors.join(QLatin1Char('\n')));
}

} // namespace

Lesson openLesson(const QString& name)
{
    LessonLoad load = loadLesson(name);
    report(load.diagnostics);
    return std::move(*load.lesson);
}

bool asksForSlide(const QStringList& words)
{
    return std::any_of(words.begin(), words.end(), [](const QString& word) {
        return word == kLesson || word.startsWith(kLesson + QLatin1Char('='));
    });
}

QList<Option> slideOptions()
{
    return {{kLesson, Option::Kind::Value, QStringLiteral("NAME"),
             QStringLiteral("Draws a slide of a lesson in place of SCENE: the id of a built-in lesson (rasterlens-cli "
                            "lesson --list) or a .json file. All other options change what the slide says. Needs "
                            "--step.")},
            {kStep, Option::Kind::Value, QStringLiteral("N"),
             QStringLiteral("The slide, counted from 1. Needs --lesson.")}};
}

SlideInput openSlide(const Arguments& arguments)
{
    const InputLog log;
    const Consent consent(outsideOf(arguments));
    const Lesson lesson = openLesson(*arguments.value(kLesson));
    const auto count = static_cast<std::int64_t>(lesson.slides.size());
    const auto number = wholeOption(arguments, kStep, 1, count);
    if (!number)
        failArguments(
            QStringLiteral("--lesson: needs --step N beside it, the number of a slide from 1 to %1").arg(count));
    Moment moment = lesson.slides[static_cast<std::size_t>(*number - 1)].moment;
    moment.size = arguments.has(QStringLiteral("--size")) ? withOptions(Settings(), arguments).size : moment.size;
    OpenMomentLoad load = openMoment(moment);
    report(load.diagnostics);
    QStringList files;
    for (const InputFile& file : log.files())
        if (file.stamp.exists)
            files << file.path;
    const Settings settings = withOptions(load.moment->settings, arguments);
    return {{std::move(load.moment->scene), settings, std::move(load.diagnostics), files}, moment.step};
}

QImage pictureAt(const Input& input, const StepPlace& step)
{
    const std::shared_ptr<const Scene> scene(std::shared_ptr<const Scene>(),
                                             &input.scene); // lent, the input outlives it
    const auto record = recordSteps(scene, input.settings);
    const auto position = positionOf(step, record);
    if (!position)
        failArguments(QStringLiteral("--step: with these settings the record has no step \"%1\"").arg(textOf(step)));
    StepCursor cursor(record);
    cursor.moveTo(*position);
    return cursor.image();
}

} // namespace rasterlens::cli
