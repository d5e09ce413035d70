#include "core/render/render.h"
#include "app/cli/empty_remark.h"
#include "app/cli/input.h"
#include "app/cli/options.h"
#include "app/cli/output.h"
#include "app/cli/settings_options.h"
#include "app/cli/slide.h"
#include "app/cli/unchanged_remark.h"
#include "app/cli/verbs.h"
#include "core/io/npy.h"
#include "core/render/picture_memory.h"

#include <QJsonDocument>

#include <array>
#include <cstdio>

namespace rasterlens::cli
{
namespace
{

Usage usage()
{
    const auto file = [](const char* name, const char* valueName, const char* help) {
        return Option{QString::fromLatin1(name), Option::Kind::Value, QString::fromLatin1(valueName),
                      QString::fromLatin1(help)};
    };
    const Option noPicture{QStringLiteral("--no-picture"),
                           Option::Kind::Switch,
                           {},
                           QStringLiteral("Shade nothing and write no picture, only the other outputs: a depth pass.")};
    const OptionGroup outputs{
        QStringLiteral("Outputs (- is stdout):"),
        {file("-o", "FILE", "The picture; default out.png. The suffix tells the format: png, ppm, bmp, jpg, jpeg."),
         noPicture, file("--depth", "F.npy", "The depth buffer: float32, 0 to 1."),
         file("--ids", "F.npy",
              "The triangle seen at each pixel: int32, counted from 0, -1 none. The f statements of an OBJ file are "
              "cut into triangles in their order; an f of n corners makes n - 2 of them."),
         file("--face-lines", "F.npy",
              "The line of the OBJ file on which the f statement stands that is seen at each pixel: int32, counted "
              "from 1, -1 none; of other scenes -1 everywhere."),
         file("--coverage", "F.npy", "How many faces cover each pixel's centre, before the depth test: uint16."),
         file("--sample-coverage", "F.npy",
              "How many faces cover each sample, before the depth test: uint16 of shape (samples, height, width), the "
              "samples in the pattern's order, those of a grid row by row."),
         file("--stats", "F.json",
              "Counters, times, settings, and the threads and vector instructions that worked. The frame is drawn "
              "twice: once counted, once timed without counting.")}};
    const Option listMistakes{
        QStringLiteral("--list-mistakes"),
        Option::Kind::Switch,
        {},
        QStringLiteral("Print the ids for --mistake, what they are and the scenes that show them, and end.")};
    const OptionGroup input{QStringLiteral("Input:"), inputOptions() << listMistakes << slideOptions()};
    return {
        QStringLiteral("render"),
        QStringLiteral("rasterlens-cli render SCENE [-o out.png] [options]"),
        QStringLiteral(
            "Draws SCENE into a picture, and on request into arrays and counters. --lesson NAME --step N stands in "
            "place of SCENE.\n\n") +
            sceneHelp(),
        {QStringLiteral("SCENE")},
        QList<OptionGroup>{outputs, input} + settingsOptionGroups(),
        QStringLiteral("The .npy files are NumPy arrays of shape (height, width) unless said otherwise, row 0 on top.\n"
                       "All outputs are written, each of them whole, or none is. An option given twice counts as given "
                       "last.\n\n"
                       "Exit codes: 0 drawn; 2 bad arguments, or settings that cannot be combined; 3 input that cannot "
                       "be read, or output that cannot be written.")};
}

/// The files to write. An empty name: the command line does not ask for that file.
struct OutputNames {
    QString image;
    QString imageFormat;
    QString depth;
    QString ids;
    QString faceLines;
    QString coverage;
    QString sampleCoverage;
    QString stats;

    explicit OutputNames(const Arguments& arguments)
        : image(imageName(arguments)), imageFormat(image.isEmpty() ? QString() : cli::imageFormat(image)),
          depth(arguments.value(QStringLiteral("--depth")).value_or(QString())),
          ids(arguments.value(QStringLiteral("--ids")).value_or(QString())),
          faceLines(arguments.value(QStringLiteral("--face-lines")).value_or(QString())),
          coverage(arguments.value(QStringLiteral("--coverage")).value_or(QString())),
          sampleCoverage(arguments.value(QStringLiteral("--sample-coverage")).value_or(QString())),
          stats(arguments.value(QStringLiteral("--stats")).value_or(QString()))
    {
        if (all().isEmpty())
            failArguments(QStringLiteral("rasterlens-cli render: --no-picture leaves nothing to write; one of --depth, "
                                         "--ids, --face-lines, --coverage, --sample-coverage, --stats is expected"));
        checkOutputs(all());
    }

    [[nodiscard]] QStringList all() const
    {
        QStringList names{image, depth, ids, faceLines, coverage, sampleCoverage, stats};
        names.removeAll(QString());
        return names;
    }

private:
    static QString imageName(const Arguments& arguments)
    {
        const auto name = arguments.value(QStringLiteral("-o"));
        if (!arguments.isOn(QStringLiteral("--no-picture")))
            return name.value_or(QStringLiteral("out.png"));
        if (name)
            failArguments(QStringLiteral("rasterlens-cli render: -o and --no-picture exclude each other"));
        return {};
    }
};

template <typename Values>
void addArray(OutputFiles& files, const QString& path, const Values& values, QSize size)
{
    if (!path.isEmpty())
        files.add(path, npyBytes(std::span<const typename Values::value_type>(values.data(), values.size()),
                                 size.height(), size.width()));
}

/// The ids, each replaced by the line of its face in the file.
std::vector<std::int32_t> faceLines(const Mesh& mesh, std::vector<std::int32_t> ids)
{
    for (std::int32_t& id : ids)
        id = id < 0 ? -1 : mesh.lineOf(static_cast<std::size_t>(id));
    return ids;
}

/// Writes the picture of a slide that stands in the middle of the drawing; of the other outputs there are none then.
void renderStepTo(const Input& input, const StepPlace& step, const OutputNames& names)
{
    if (names.all() != QStringList{names.image})
        failArguments(QStringLiteral("rasterlens-cli render: this slide shows a step of the drawing, of which only the "
                                     "picture can be written"));
    OutputFiles files;
    files.add(names.image, imageBytes(pictureAt(input, step), names.imageFormat));
    files.write();
}

/// Says what a large picture needs, before the system is asked for it.
///
/// errors  throws Failure: there is less
void sayMemory(const Settings& settings, const Outputs& outputs)
{
    if (!isLarge(settings))
        return;
    const std::int64_t pixels = std::int64_t(settings.size.width()) * settings.size.height();
    constexpr std::int64_t kInFile = 4; // bytes of a pixel, or of a value of an array, as it is written
    const std::int64_t files = 1 + int(outputs.depth) + int(outputs.ids) + int(outputs.coverage);
    const std::int64_t needed = pictureBytes(settings) + pixels * kInFile * files;
    const std::int64_t free = freeMemoryBytes();
    if (needed > free)
        failArguments(QStringLiteral("rasterlens-cli render: the picture needs up to %1 of memory, and %2 are free; a "
                                     "smaller --size or fewer --samples need less")
                          .arg(gigabytesText(needed), gigabytesText(free)));
    std::fprintf(stderr, "%dx%d: up to %s of memory\n", settings.size.width(), settings.size.height(),
                 qUtf8Printable(gigabytesText(needed)));
}

void renderTo(const Scene& scene, const Settings& settings, const OutputNames& names)
{
    const bool counted = !names.stats.isEmpty();
    Frame frame;
    const Outputs outputs{.depth = !names.depth.isEmpty(),
                          .ids = !names.ids.isEmpty() || !names.faceLines.isEmpty(),
                          .coverage = !names.coverage.isEmpty(),
                          .picture = !names.image.isEmpty(),
                          .sampleCoverage = !names.sampleCoverage.isEmpty()};
    if (const auto reason = unsupportedOutputs(settings, outputs))
        failArguments(QStringLiteral("rasterlens-cli render: --sample-coverage: %1").arg(textOf(*reason)));
    sayMemory(settings, outputs);
    const Statistics statistics = counted ? renderCounted(scene, settings, frame, outputs) : Statistics();
    render(scene, settings, frame, outputs);

    OutputFiles files;
    if (outputs.picture)
        files.add(names.image, imageBytes(frame.image, names.imageFormat));
    addArray(files, names.depth, frame.depth, settings.size);
    addArray(files, names.ids, frame.ids, settings.size);
    if (!names.faceLines.isEmpty())
        addArray(files, names.faceLines, faceLines(scene.mesh, frame.ids), settings.size);
    addArray(files, names.coverage, frame.coverage, settings.size);
    if (outputs.sampleCoverage)
        files.add(names.sampleCoverage, npyBytes(std::span<const std::uint16_t>(frame.sampleCoverage),
                                                 std::array{samplesPerPixel(settings.samples), settings.size.height(),
                                                            settings.size.width()}));
    if (counted)
        files.add(names.stats,
                  QJsonDocument(toJson(statistics, frame.times, settings, withWorkers(settings))).toJson());
    files.write();
    remarkIfEmpty(scene, settings, frame, outputs);
    remarkIfUnchanged(scene, settings);
}

} // namespace

Usage renderUsage() { return usage(); }

ExitCode runRender(const QStringList& words)
{
    if (words.contains(QStringLiteral("--list-mistakes"))) {
        printText(mistakeList());
        return ExitCode::Fine;
    }
    Usage shown = usage();
    const bool isSlide = asksForSlide(words);
    if (isSlide) {
        shown.operands.clear();
        shown.synopsis = QStringLiteral("rasterlens-cli render --lesson NAME --step N [-o out.png] [options]");
    }
    const auto arguments = parseArguments(shown, words);
    if (!arguments)
        return ExitCode::Fine;
    if (!isSlide && arguments->has(QStringLiteral("--step")))
        failArguments(QStringLiteral("--step: needs --lesson beside it"));

    const OutputNames names(*arguments);
    const SlideInput slide =
        isSlide ? openSlide(*arguments) : SlideInput{openInput(arguments->operands.first(), *arguments), {}};
    const Input& input = slide.input;
    checkInputsStay(names.all(), input.files);
    if (const auto reason = refusal(input.scene, input.settings))
        failArguments(QStringLiteral("rasterlens-cli render: %1").arg(*reason));
    if (input.settings.shading == Shading::Texture && input.scene.textures.empty())
        std::fprintf(stderr, "%s: note: no material has a texture; shading texture shows a checkerboard\n",
                     qUtf8Printable(input.scene.id));
    if (slide.step)
        renderStepTo(input, *slide.step, names);
    else
        renderTo(input.scene, input.settings, names);
    return ExitCode::Fine;
}

} // namespace rasterlens::cli
