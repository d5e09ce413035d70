#include "core/page/page.h"
#include "app/cli/input.h"
#include "app/cli/options.h"
#include "app/cli/output.h"
#include "app/cli/place_options.h"
#include "app/cli/settings_options.h"
#include "app/cli/slide.h"
#include "app/cli/verbs.h"
#include "app/cli/window_program.h"
#include "core/io/picture_file.h"
#include "core/io/session.h"
#include "core/lessons/moment.h"

#include <QFileInfo>

namespace rasterlens::cli
{
namespace
{

constexpr std::int64_t kMaxLimit = 1'000'000;
const QString kLesson = QStringLiteral("--lesson");

Usage usage()
{
    const auto value = [](const char* name, const char* valueName, const QString& help) {
        return Option{QString::fromLatin1(name), Option::Kind::Value, QString::fromLatin1(valueName), help};
    };
    const OptionGroup page{
        QStringLiteral("Page:"),
        {value("-o", "FILE", QStringLiteral("The page: F.html (- is stdout). Required.")),
         value("--face", "N", QStringLiteral("Only the steps of this face: a triangle, counted from 0 as --ids does.")),
         value("--pixel", "X,Y",
               QStringLiteral("Only what happens at this pixel, counted from the top left, and to the faces that get "
                              "there.")),
         value("--limit", "N",
               QStringLiteral("Most steps; default %1, some four megabytes, or %2 with a lesson. The page ends there, "
                              "and says so.")
                   .arg(kUsualPageSteps)
                   .arg(kUsualLessonPageSteps)),
         value("--lesson", "NAME",
               QStringLiteral("The slides of a lesson, with their questions, lead through the steps: the id of a "
                              "built-in lesson (rasterlens-cli lesson --list) or a .json file. SCENE may be left out: "
                              "the page is then about the scene of the first slide.")),
         allowOutsideOption()}};
    return {QStringLiteral("page"),
            QStringLiteral("rasterlens-cli page SCENE [--face N] [--pixel x,y] [--limit N] [--lesson NAME] -o F.html "
                           "[options]"),
            QStringLiteral("Writes one HTML file that every browser opens, without a network: the picture, "
                           "every step of its drawing with the signs and values of the edge functions, and for every "
                           "pixel why it is what it is, in English and Chinese. The program rasterlens finds the "
                           "words, without a display.\n\n") +
                sceneHelp(),
            {},
            QList<OptionGroup>{page} + settingsOptionGroups(),
            QStringLiteral("The page is moved by its buttons, by a swipe, and by keys: Left and Right, Home and End; "
                           "Space plays, PageUp and PageDown turn the slides. In its address, #step=N opens the step "
                           "that \"rasterlens-cli steps\" numbers N; slide=N, pixel=X,Y and lang=en|zh may follow, "
                           "with & between. A page of a session opens at the step and the pixel that it keeps.\n\n"
                           "With several hundred thousand pixels times faces or more there is no list of faces for "
                           "each pixel; of slides with more than 2000 steps the page has the picture alone.\n\n"
                           "Exit codes: 0 written; 2 bad arguments, or settings that cannot be combined; 3 input that "
                           "cannot be read, or output that cannot be written."),
            true};
}

QString outputPath(const Arguments& arguments)
{
    const auto path = arguments.value(QStringLiteral("-o"));
    if (!path)
        failArguments(QStringLiteral("rasterlens-cli page: -o F.html is missing"));
    if (const auto problem = whyNotFormat(*path, {QStringLiteral("html"), QStringLiteral("htm")}))
        failArguments(QStringLiteral("%1: %2").arg(*path, textOf(*problem)));
    checkOutputs({*path});
    return *path;
}

/// The scene of the lesson's first slide, with the slide's settings changed by the command line.
Input firstOf(const Lesson& lesson, const Arguments& arguments)
{
    OpenMomentLoad load = openMoment(lesson.slides.front().moment);
    if (!load.moment) {
        QStringList lines;
        for (const Diagnostic& diagnostic : load.diagnostics)
            lines << diagnostic.text();
        failInput(lines.join(QLatin1Char('\n')));
    }
    const Settings settings = withOptions(load.moment->settings, arguments);
    return {std::move(load.moment->scene), settings, std::move(load.diagnostics), {}};
}

/// Where a session stands, as options of the program with the window.
QStringList momentWords(const QString& operand, QSize size)
{
    QStringList words;
    if (!isSession(operand))
        return words;
    const SessionLoad load = loadSession(operand);
    if (!load.session)
        return words;
    const Moment moment = sessionView(load.session->view, operand).moment;
    if (moment.step)
        words << QStringLiteral("--step") << textOf(*moment.step);
    if (moment.pixel && QRect(QPoint(0, 0), size).contains(*moment.pixel))
        words << QStringLiteral("--pixel") << QStringLiteral("%1,%2").arg(moment.pixel->x()).arg(moment.pixel->y());
    return words;
}

/// What the program with the window is told.
QStringList windowWords(const Arguments& arguments, const Input& input, const QString& path)
{
    QStringList words{QStringLiteral("--page"), path};
    if (outsideOf(arguments) == Outside::Allow)
        words << QStringLiteral("--allow-outside");
    const auto lastFace = static_cast<std::int64_t>(input.scene.mesh.faceCount()) - 1;
    if (const auto face = wholeOption(arguments, QStringLiteral("--face"), 0, lastFace))
        words << QStringLiteral("--page-face") << QString::number(*face);
    if (const auto pixel = pixelOption(arguments, input.settings.size))
        words << QStringLiteral("--page-pixel") << QStringLiteral("%1,%2").arg(pixel->x()).arg(pixel->y());
    if (const auto limit = wholeOption(arguments, QStringLiteral("--limit"), 1, kMaxLimit))
        words << QStringLiteral("--page-limit") << QString::number(*limit);
    return words;
}

} // namespace

Usage pageUsage() { return usage(); }

ExitCode runPage(const QStringList& words)
{
    const auto arguments = parseArguments(usage(), words);
    if (!arguments)
        return ExitCode::Fine;
    const Consent consent(outsideOf(*arguments));
    const auto lessonName = arguments->value(kLesson);
    const QStringList& operands = arguments->operands;
    if (operands.size() > 1 || (operands.isEmpty() && !lessonName))
        failArguments(operands.isEmpty()
                          ? QStringLiteral("rasterlens-cli page: SCENE is missing")
                          : QStringLiteral("rasterlens-cli page: \"%1\" is one argument too many").arg(operands[1]));
    const QString path = outputPath(*arguments);
    const std::optional<Lesson> lesson = lessonName ? std::optional(openLesson(*lessonName)) : std::nullopt;
    const Input input = operands.isEmpty() ? firstOf(*lesson, *arguments) : openInput(operands.first(), *arguments);
    checkInputsStay({path}, input.files);
    if (const auto reason = refusal(input.scene, input.settings))
        failArguments(QStringLiteral("rasterlens-cli page: %1").arg(*reason));
    QStringList asked = windowWords(*arguments, input, path);
    if (lesson) {
        checkInputsStay({path}, {lesson->file});
        const bool isBuiltin = lesson->file.startsWith(QLatin1Char(':'));
        asked << QStringLiteral("--page-lesson")
              << (isBuiltin ? lesson->id : QFileInfo(lesson->file).absoluteFilePath());
    }
    if (!operands.isEmpty())
        asked += momentWords(operands.first(), input.settings.size);
    return runWindowProgram(input.scene, input.settings, asked);
}

} // namespace rasterlens::cli
