#include "app/cli/bench_plot.h"
#include "app/cli/bench_table.h"
#include "app/cli/chart.h"
#include "app/cli/coverage_chart.h"
#include "app/cli/distance_chart.h"
#include "app/cli/input.h"
#include "app/cli/options.h"
#include "app/cli/output.h"
#include "app/cli/place_options.h"
#include "app/cli/settings_options.h"
#include "app/cli/variant_list.h"
#include "app/cli/verbs.h"
#include "core/io/picture_file.h"
#include "core/opengl/opengl_renderers.h"
#include "core/render/render.h"
#include "core/truth/experiment_export.h"

#include <QElapsedTimer>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <unistd.h>

namespace rasterlens::cli
{
namespace
{

constexpr const char* kDefaultScenes[] = {"builtin:head", "builtin:sphere", "builtin:behind-camera"};
constexpr int kMaxFrames = 100'000;

Option value(const char* name, const char* valueName, const QString& help)
{
    return {QString::fromLatin1(name), Option::Kind::Value, QString::fromLatin1(valueName), help};
}

QString measureIds()
{
    QStringList ids;
    for (int i = 0; i < kErrorMeasures; ++i)
        ids << QLatin1String(infoOf(static_cast<ErrorMeasure>(i)).id);
    return ids.join(QStringLiteral(", "));
}

QStringList chartNames()
{
    QStringList names;
    for (const ChartInfo& info : chartInfos())
        names << QLatin1String(info.id);
    return names;
}

OptionGroup measuredOptions()
{
    return {
        QStringLiteral("What is measured:"),
        {value("--variants", "LIST",
               QStringLiteral("all (default), frontier (measure all, keep those that no other beats), or ids joined by "
                              "commas; see --list-variants. as-given measures exactly the settings given.")),
         {QStringLiteral("--list-variants"),
          Option::Kind::Switch,
          {},
          QStringLiteral("Print the id of every variant and what it changes, and end.")},
         {QStringLiteral("--with-opengl"),
          Option::Kind::Switch,
          {},
          QStringLiteral(
              "Also the renderers behind OpenGL on this machine, without a display: Mesa's software renderer "
              "and graphics processors. Their subpixel bits and tie rule are found by drawing.")},
         value("--frames", "N",
               QStringLiteral("Rounds that count, 1 to %1; default %2. In a round every variant has its turn; one "
                              "round more warms up.")
                   .arg(kMaxFrames)
                   .arg(ExperimentOptions().frames)),
         value(
             "--reference", "exact|exact-object|none",
             QStringLiteral("What errors are measured against; default exact: it starts from the clip-space positions "
                            "that the vertex stage makes. exact-object starts from the mesh and the camera and judges "
                            "the vertex stage as well; scenes in clip space have none.")),
         value("--chart", "NAME",
               QStringLiteral("Another chart in place of speed against error: %1. distance: how far corners and pixels "
                              "are from the truth as SCENE is moved away from 0, with positions held as OBJ files are "
                              "read and as float32 from 0. msaa: how well the samples of grids and patterns tell what "
                              "part of a pixel is covered. snapping: faces that snapping turns over. depth-step: how "
                              "far apart surfaces have to be. edge-functions, lines, attributes: errors of edge "
                              "functions in floats, of line rules, of interpolation without a division; they need no "
                              "SCENE. --csv, --json and --plot hold it.")
                   .arg(chartNames().join(QStringLiteral(", ")))),
         value("--error", "MEASURE",
               QStringLiteral("The error of the plot's axis and of the frontier: %1 (default color). coverage: pixels "
                              "missing, extra or hit twice; depth: the largest error; color: root mean square over the "
                              "picture in 8-bit steps.")
                   .arg(measureIds()))}};
}

Usage usage()
{
    const OptionGroup outputs{
        QStringLiteral("Outputs (- is stdout, and then there is no table):"),
        {value("--csv", "FILE", QStringLiteral("The rows, a line each.")),
         value("--json", "FILE", QStringLiteral("The rows, an array of objects.")),
         value("--plot", "FILE", QStringLiteral("Speed against error, a panel a scene; .svg or .png."))}};
    QStringList scenes;
    for (const char* scene : kDefaultScenes)
        scenes << QLatin1String(scene);
    return {
        QStringLiteral("bench"),
        QStringLiteral("rasterlens-cli bench [SCENE...] [options]"),
        QStringLiteral("Measures speed against error: every variant of the pipeline on every SCENE. Without SCENE: ") +
            scenes.join(QStringLiteral(", ")) + QStringLiteral(".\n\n") + sceneHelp(),
        {},
        QList<OptionGroup>{measuredOptions(), outputs, {QStringLiteral("Input:"), inputOptions()}} +
            settingsOptionGroups(),
        QStringLiteral(
            "A time is clear + frame into the picture. Variants take turns frame by frame, after a warm-up; ms is the "
            "median, p10 and p90 are the 10th and the 90th percentile, cpu is the processor time of all threads. "
            "Frames that take less than %2 ms are timed in batches. ratio is how many times as long a frame takes as "
            "that of the first variant in the same round: median, 10th and 90th percentile of the pairs. Of two "
            "variants one is said to be faster only where it was in nine of ten rounds: the others are not ranked, and "
            "both may be on the frontier (*). The last line says how noisy the machine was.\n\n"
            "ns/px is the median over the fragments of the scene (the counter `covered` of edge-equation with one "
            "sample a pixel; one number a scene). Mtri/s counts submitted faces.\n\n"
            "Errors are those against the exact picture of the settings given, in rational arithmetic, at the full "
            "size: correct clipping, top-left rule, perspective, exact depths; vertices snapped to --subpixel-bits, "
            "or not at all with --number-type float64. A variant with several samples a pixel is compared with the "
            "truth of as many. Depth and colour are compared where both show the same face, colour in 8-bit steps from "
            "the exact value (rounding alone: 0.5); PSNR is that of the whole picture against the exact one rounded to "
            "8 bits. Colours need --shading gouraud or texture; a truth with several samples shades each at its own "
            "place, which multi-sampling does not. A PSNR of %1 in JSON and CSV stands for infinity: equal "
            "pictures.\n\n"
            "Each variant has its own algorithm, number type, subpixel bits, stepping, depth format, interpolation, "
            "attribute path and samples, some also threads or vector instructions; all else is as given. An option "
            "that no variant measured heeds is refused; --number-type and --subpixel-bits, which still shape the exact "
            "picture, are taken with a warning. Any combination of settings is measured as-given:\n"
            "  rasterlens-cli bench builtin:head --variants as-given --algorithm tiled --samples 3x3\n\n"
            "Variants that the scene, the settings or the machine do not support are left out of `all`.\n\n"
            "Exit codes: 0 measured; 2 bad arguments, or a variant asked for that is not supported; 3 input that "
            "cannot be read, or output that cannot be written.")
            .arg(kInfinitePsnr)
            .arg(kShortestTiming),
        true};
}

struct Request {
    QStringList scenes;
    std::vector<const Variant*> variants; ///< empty: all
    bool frontierOnly = false;
    ExperimentOptions options;
    ErrorMeasure measure = ErrorMeasure::Color;
    QString csv;
    QString json;
    QString plot;
    QString plotFormat;

    [[nodiscard]] QStringList outputs() const
    {
        QStringList names{csv, json, plot};
        names.removeAll(QString());
        return names;
    }
    [[nodiscard]] bool usesStdout() const { return outputs().contains(QStringLiteral("-")); }
};

[[noreturn]] void fail(const QString& text) { failArguments(QStringLiteral("rasterlens-cli bench: ") + text); }

void readVariants(const QString& list, Request& request)
{
    request.frontierOnly = list == QLatin1String("frontier");
    if (!request.frontierOnly && list != QLatin1String("all"))
        request.variants = variantsOf(list, QStringLiteral("bench"));
}

void readReference(const QString& id, ExperimentOptions& options)
{
    options.reference = id != QLatin1String("none");
    for (const ReferenceSpace space : {ReferenceSpace::Clip, ReferenceSpace::Object})
        if (id == QLatin1String(idOf(space))) {
            options.space = space;
            return;
        }
    if (options.reference)
        fail(QStringLiteral("--reference: \"%1\" is not a value of reference, which takes: exact, exact-object, none")
                 .arg(id));
}

/// What is wanting is said before the first frame.
void useOpenGl(ExperimentOptions& options)
{
    if (const auto lack = openGlRenderers().lack)
        fail(QStringLiteral("--with-opengl: ") + textOf(*lack));
    options.others = openGlRenderers;
    options.refused = [](const QString& id, const Reason& reason) {
        std::fprintf(stderr, "%s is not measured: %s\n", qUtf8Printable(id), qUtf8Printable(textOf(reason)));
    };
}

ErrorMeasure measureOf(const QString& id)
{
    for (int i = 0; i < kErrorMeasures; ++i)
        if (id == QLatin1String(infoOf(static_cast<ErrorMeasure>(i)).id))
            return static_cast<ErrorMeasure>(i);
    fail(QStringLiteral("--error: \"%1\" is not a value of error, which takes: %2").arg(id, measureIds()));
}

QString plotFormat(const QString& path)
{
    const QStringList formats{QStringLiteral("svg"), QStringLiteral("png")};
    const QString format = formatOf(path, isStream(path) ? formats.first() : QString());
    if (!formats.contains(format))
        fail(QStringLiteral("--plot: %1: a name that ends in .svg or .png is expected").arg(path));
    return format;
}

/// Options of the measurement say nothing about a chart of another kind, which takes one scene.
void checkChart(const Arguments& arguments)
{
    const auto chart = arguments.value(QStringLiteral("--chart"));
    if (!chart)
        return;
    if (!chartNames().contains(*chart))
        fail(QStringLiteral("--chart: \"%1\" is not a value of chart, which takes: %2")
                 .arg(*chart, chartNames().join(QStringLiteral(", "))));
    if (arguments.operands.size() > 1)
        fail(QStringLiteral("--chart %1 takes one scene").arg(*chart));
    for (const char* option : {"--variants", "--with-opengl", "--frames", "--reference", "--error"})
        if (arguments.has(QLatin1String(option)))
            fail(QStringLiteral("%1: cannot be combined with --chart").arg(QLatin1String(option)));
}

Request requestOf(const Arguments& arguments)
{
    Request request;
    request.scenes = arguments.operands;
    if (request.scenes.isEmpty())
        for (const char* scene : kDefaultScenes)
            request.scenes << QLatin1String(scene);
    readVariants(arguments.value(QStringLiteral("--variants")).value_or(QStringLiteral("all")), request);
    if (const auto frames = wholeOption(arguments, QStringLiteral("--frames"), 1, kMaxFrames))
        request.options.frames = static_cast<int>(*frames);
    if (arguments.has(QStringLiteral("--with-opengl")))
        useOpenGl(request.options);
    readReference(arguments.value(QStringLiteral("--reference")).value_or(QStringLiteral("exact")), request.options);
    if (request.frontierOnly && !request.options.reference)
        fail(QStringLiteral("--variants frontier needs --reference exact"));
    if (const auto measure = arguments.value(QStringLiteral("--error")))
        request.measure = measureOf(*measure);
    checkChart(arguments);
    request.csv = arguments.value(QStringLiteral("--csv")).value_or(QString());
    request.json = arguments.value(QStringLiteral("--json")).value_or(QString());
    request.plot = arguments.value(QStringLiteral("--plot")).value_or(QString());
    if (!request.plot.isEmpty()) {
        request.plotFormat = plotFormat(request.plot);
        if (!request.options.reference)
            fail(QStringLiteral("--plot needs --reference exact"));
    }
    checkOutputs(request.outputs());
    return request;
}

/// The variants to measure on a scene.
std::vector<const Variant*> variantsFor(const Request& request, const Input& input)
{
    if (request.variants.empty())
        return supportedVariants(input.scene, input.settings);
    for (const Variant* variant : request.variants)
        if (const auto reason = refusal(input.scene, settingsOf(*variant, input.settings)))
            fail(QStringLiteral("%1: %2").arg(QLatin1String(variant->id), *reason));
    return request.variants;
}

/// The exact picture snaps to them, whatever variants do.
bool shapesTheTruth(const SettingsField& field)
{
    return field.id == QLatin1String("number-type") || field.id == QLatin1String("subpixel-bits");
}

/// Refuses options that change nothing, because every variant measured has a value of its own.
///
/// out     warnings about options that change the exact picture alone
QStringList checkHeeded(const Arguments& arguments, const Request& request, const Input& input)
{
    const std::vector<const Variant*> measured = variantsFor(request, input);
    QStringList warnings;
    for (const SettingsField& field : settingsFields()) {
        const QString option = QStringLiteral("--") + QLatin1String(field.id);
        const auto given = arguments.value(option);
        const auto overrules = [&](const Variant* variant) { return decides(*variant, field); };
        const auto agrees = [&](const Variant* variant) {
            return field.get(settingsOf(*variant, input.settings)) == field.get(input.settings);
        };
        if (!given || !std::all_of(measured.begin(), measured.end(), overrules) ||
            std::all_of(measured.begin(), measured.end(), agrees))
            continue;
        const QString text = QStringLiteral("%1 %2: every variant measured has its own %3")
                                 .arg(option, *given)
                                 .arg(QLatin1String(field.id));
        const QString hint = QStringLiteral("--variants as-given measures exactly the settings given");
        if (!request.options.reference || !shapesTheTruth(field))
            fail(text + QStringLiteral("; ") + hint);
        warnings << text + QStringLiteral(", only the exact picture is made with it; ") + hint;
    }
    return warnings;
}

/// Opens the scenes; what is wrong is said before the first frame.
std::vector<Input> openInputs(const Arguments& arguments, const Request& request)
{
    std::vector<Input> inputs;
    QStringList warnings;
    for (const QString& scene : request.scenes) {
        inputs.push_back(openInput(scene, arguments));
        checkInputsStay(request.outputs(), inputs.back().files);
        warnings << checkHeeded(arguments, request, inputs.back());
    }
    warnings.removeDuplicates();
    for (const QString& warning : std::as_const(warnings))
        std::fprintf(stderr, "%s\n", qUtf8Printable(warning));
    return inputs;
}

/// How far a scene is, on stderr: in place on a terminal, elsewhere a line at the start and every few seconds.
class ProgressLine
{
public:
    ProgressLine(const Input& input, std::size_t variants) : m_scene(input.scene.id)
    {
        show(QStringLiteral("variants to measure: %1").arg(variants));
    }

    void operator()(const ExperimentProgress& progress)
    {
        if (m_inPlace || m_sinceShown.hasExpired(kIntervalMs))
            show(QStringLiteral("%1 of %2 frames").arg(progress.done).arg(progress.total));
        if (m_inPlace && progress.done == progress.total)
            std::fputs("\r\033[K", stderr);
    }

private:
    static constexpr int kIntervalMs = 5000;

    void show(const QString& text)
    {
        std::fprintf(stderr, m_inPlace ? "\r%s: %s\033[K" : "%s: %s\n", qUtf8Printable(m_scene), qUtf8Printable(text));
        m_sinceShown.start();
    }

    QString m_scene;
    bool m_inPlace = isatty(STDERR_FILENO) != 0;
    QElapsedTimer m_sinceShown;
};

std::vector<ExperimentRow> measure(const Request& request, const Input& input)
{
    const std::vector<const Variant*> variants = variantsFor(request, input);
    std::vector<ExperimentRow> rows =
        runExperiment(input.scene, input.settings, variants, request.options, ProgressLine(input, variants.size()));
    markFrontier(rows, request.measure);
    if (request.frontierOnly)
        std::erase_if(rows, [](const ExperimentRow& row) { return !row.frontier; });
    return rows;
}

QString variantList()
{
    QString text;
    for (const Variant& variant : variants())
        text += QStringLiteral("%1 %2\n").arg(QLatin1String(variant.id), -28).arg(QLatin1String(variant.changes));
    text += QStringLiteral("%1 (exactly the settings given)\n").arg(QLatin1String(asGiven().id), -28);
    return text + QStringLiteral("%1 (what this machine draws by OpenGL: --with-opengl)\n")
                      .arg(QStringLiteral("opengl-software, opengl-gpu"), -28);
}

} // namespace

Usage benchUsage() { return usage(); }

ExitCode runBench(const QStringList& words)
{
    if (words.contains(QStringLiteral("--list-variants"))) {
        printText(variantList());
        return ExitCode::Fine;
    }
    const auto arguments = parseArguments(usage(), words);
    if (!arguments)
        return ExitCode::Fine;
    const Request request = requestOf(*arguments);
    if (arguments->has(QStringLiteral("--chart"))) {
        const ChartInfo& info = *findChart(*arguments->value(QStringLiteral("--chart")));
        const Input input = openInput(request.scenes.first(), *arguments);
        // these two tell more than their chart
        if (QLatin1String(info.id) == QLatin1String("distance"))
            printDistanceChart(input, *arguments);
        else if (QLatin1String(info.id) == QLatin1String("msaa"))
            printCoverageChart(input, *arguments);
        else
            printChart(info, input, *arguments);
        return ExitCode::Fine;
    }
    std::vector<ExperimentRow> all;
    for (const Input& input : openInputs(*arguments, request)) {
        const std::vector<ExperimentRow> rows = measure(request, input);
        if (!request.usesStdout())
            printText(benchTable(rows, input, request.measure));
        all.insert(all.end(), rows.begin(), rows.end());
    }
    OutputFiles files;
    if (!request.csv.isEmpty())
        files.add(request.csv, experimentCsv(all));
    if (!request.json.isEmpty())
        files.add(request.json, experimentJson(all));
    if (!request.plot.isEmpty())
        files.add(request.plot, experimentFigure(all, request.measure, request.plotFormat));
    files.write();
    return ExitCode::Fine;
}

} // namespace rasterlens::cli
