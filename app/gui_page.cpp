#include "app/gui_page.h"

#include "core/base/typed_numbers.h"
#include "core/io/file_writer.h"
#include "core/io/picture_file.h"
#include "core/io/session.h"
#include "core/page/page.h"
#include "core/render/render.h"
#include "core/render/steps.h"
#include "core/scenes/load_scene.h"
#include "ui/window/window_page_words.h"

#include <cstdio>
#include <utility>

namespace rasterlens
{
namespace
{

enum ExitCode { kFine = 0, kBadArguments = 2, kInvalidInput = 3 };

/// Ends the writing.
struct Failure {
    ExitCode code;
    QString message;
};

void printErrors(const Diagnostics& diagnostics)
{
    for (const Diagnostic& diagnostic : diagnostics)
        if (diagnostic.severity != Severity::Note)
            std::fprintf(stderr, "%s\n", qPrintable(diagnostic.text()));
}

/// Hands out what was loaded.
///
/// errors  throws Failure
template <class Value>
Value loaded(std::optional<Value>&& value, const Diagnostics& diagnostics)
{
    printErrors(diagnostics);
    if (!value)
        throw Failure{kInvalidInput, {}};
    return std::move(*value);
}

/// A scene with the settings to draw it with.
struct Input {
    Scene scene;
    Settings settings;
};

Scene openScene(const QString& name, const LoadOptions& options = {})
{
    SceneLoad load = loadScene(name, options);
    return loaded(std::move(load.scene), load.diagnostics);
}

Input openInput(const QString& name, const QString& model)
{
    if (!isSession(name)) {
        Scene scene = openScene(name);
        const Settings settings = scene.defaults;
        return {std::move(scene), settings};
    }
    SessionLoad load = loadSession(name, model);
    const Session session = loaded(std::move(load.session), load.diagnostics);
    LoadOptions options;
    options.size = settingsOf(session, {}).settings.size;
    Scene scene = openScene(session.scene, options);
    Diagnostics errors = editVertices(scene, session, name);
    const SettingsParse parse = settingsOf(session, scene.defaults);
    for (const Reason& error : parse.errors)
        errors.push_back({Severity::Error, name, 0, error});
    printErrors(errors);
    if (hasErrors(errors))
        throw Failure{kInvalidInput, {}};
    return {std::move(scene), parse.settings};
}

/// The position of the run that is shown first.
std::optional<std::size_t> startOf(const QString& step, const Input& input, const StepFilter& filter)
{
    if (step.isEmpty())
        return std::nullopt;
    const auto place = stepPlaceFromText(step);
    const auto log = renderSteps(input.scene, input.settings, filter);
    const auto position = place ? positionOf(*place, *log) : std::nullopt;
    if (!position && log->truncated())
        return log->size(); // as near as the page gets
    if (!position)
        throw Failure{kBadArguments, QStringLiteral("--step: the page has no step \"%1\"").arg(step)};
    return position;
}

void write(const PageArguments& page)
{
    const Consent consent(page.outside);
    const Input input = openInput(page.scene, page.model);
    if (const auto why = unsupported(input.scene, input.settings))
        throw Failure{kBadArguments, textOf(*why)};
    StepFilter filter;
    filter.cap = page.limit.value_or(page.lesson.isEmpty() ? kUsualPageSteps : kUsualLessonPageSteps);
    filter.face = page.face;
    if (page.pixel)
        filter.pixels = PixelRect{page.pixel->x(), page.pixel->y(), 1, 1};
    std::optional<Lesson> lesson;
    if (!page.lesson.isEmpty()) {
        LessonLoad load = loadLesson(page.lesson);
        lesson = loaded(std::move(load.lesson), load.diagnostics);
    }
    const auto start = startOf(page.step, input, filter);
    WindowPageWords words;
    const PageResult made =
        makePage({input.scene, input.settings, filter, lesson ? &*lesson : nullptr, start, page.chosen}, words);
    printErrors(made.diagnostics);
    if (hasErrors(made.diagnostics))
        throw Failure{kInvalidInput, {}};
    if (const auto why = writeFile(page.path, made.html))
        throw Failure{kInvalidInput, QStringLiteral("%1: cannot be written: %2").arg(page.path, textOf(*why))};
}

} // namespace

PageOptions::PageOptions()
    : path(QStringLiteral("page"),
           QStringLiteral("Writes a page for browsers that shows every step to <file> (F.html) and exits; no window "
                          "is opened. With --step and --pixel it opens there."),
           QStringLiteral("file")),
      lesson(QStringLiteral("page-lesson"), QStringLiteral("The lesson that leads through the page."),
             QStringLiteral("name")),
      face(QStringLiteral("page-face"), QStringLiteral("The page has only the steps of this face."),
           QStringLiteral("n")),
      pixel(QStringLiteral("page-pixel"), QStringLiteral("The page has only the steps at this pixel."),
            QStringLiteral("x,y")),
      limit(QStringLiteral("page-limit"),
            QStringLiteral("Most steps of the page; default %1, %2 with a lesson.")
                .arg(kUsualPageSteps)
                .arg(kUsualLessonPageSteps),
            QStringLiteral("n"))
{
}

std::optional<QString> readPage(const QCommandLineParser& parser, const PageOptions& options, PageArguments& page)
{
    page.path = parser.value(options.path);
    if (!parser.isSet(options.path))
        return std::nullopt;
    if (page.path.isEmpty())
        return QStringLiteral("--page needs a file");
    if (const auto why = whyNotFormat(page.path, {QStringLiteral("html"), QStringLiteral("htm")}))
        return QStringLiteral("--page %1: %2").arg(page.path, textOf(*why));
    page.lesson = parser.value(options.lesson);
    bool isNumber = true;
    if (parser.isSet(options.face))
        page.face = parser.value(options.face).toUInt(&isNumber);
    if (!isNumber)
        return QStringLiteral("--page-face takes the number of a face");
    if (parser.isSet(options.limit))
        page.limit = parser.value(options.limit).toUInt(&isNumber);
    if (!isNumber || page.limit == std::size_t(0))
        return QStringLiteral("--page-limit takes a number from 1 on");
    if (parser.isSet(options.pixel)) {
        page.pixel = typedPoint(parser.value(options.pixel));
        if (!page.pixel)
            return QStringLiteral("--page-pixel takes x,y");
    }
    return std::nullopt;
}

int writePage(const PageArguments& page)
{
    try {
        write(page);
        return kFine;
    } catch (const Failure& failure) {
        if (!failure.message.isEmpty())
            std::fprintf(stderr, "%s\n", qPrintable(failure.message));
        return failure.code;
    }
}

} // namespace rasterlens
