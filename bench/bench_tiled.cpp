#include "core/scenes/load_scene.h"
// Milliseconds a frame of the tiled algorithm, in this process: clear + frame into the QImage. Beside the clock on the
// wall, the processor time of the whole process, which a busy machine disturbs less.
#include "core/render/render.h"

#include <QCommandLineParser>
#include <QCoreApplication>

#include <algorithm>
#include <cstdio>
#include <ctime>

using namespace rasterlens;

namespace
{

double quantile(std::vector<double> values, double q)
{
    std::sort(values.begin(), values.end());
    return values.empty() ? 0 : values[static_cast<std::size_t>(q * double(values.size() - 1))];
}

double processorMs() { return 1000.0 * double(std::clock()) / CLOCKS_PER_SEC; }

struct Series {
    std::vector<double> total, processor, vertex, geometry, raster;
};

Series measure(const Scene& scene, const Settings& settings, Outputs outputs, int warmUp, int frames)
{
    Series series;
    Frame frame;
    for (int i = -warmUp; i < frames; ++i) {
        const double before = processorMs();
        render(scene, settings, frame, outputs);
        if (i < 0)
            continue;
        series.total.push_back(frame.times.total);
        series.processor.push_back(processorMs() - before);
        series.vertex.push_back(frame.times.vertex);
        series.geometry.push_back(frame.times.geometry);
        series.raster.push_back(frame.times.raster);
    }
    return series;
}

} // namespace

int main(int argc, char** argv)
{
    const QCoreApplication application(argc, argv);
    QCommandLineParser parser;
    parser.addHelpOption();
    parser.addPositionalArgument("SCENE...",
                                 "stress:NAME, builtin:NAME or .obj files (with the peer's normals and uv)");
    parser.addOption({"frames", "frames that count", "N", "25"});
    parser.addOption({"warm-up", "frames that do not", "N", "3"});
    parser.addOption({"set", "a settings field", "FIELD=VALUE"});
    parser.addOption({"size", "pixels", "WxH", "1920x1080"});
    parser.addOption({"depth-only", "a depth buffer and no picture"});
    parser.process(application);

    Settings settings;
    settings.algorithm = Algorithm::Tiled;
    settings.threads = 1;
    settings.size = parseSize(parser.value("size")).value_or(settings.size);
    for (const QString& assignment : parser.values("set")) {
        const SettingsField* field = findSettingsField(assignment.section('=', 0, 0));
        if (field == nullptr || setFromText(*field, assignment.section('=', 1), settings)) {
            std::fprintf(stderr, "--set %s: no such field or value\n", qPrintable(assignment));
            return 2;
        }
    }
    const bool depthOnly = parser.isSet("depth-only");
    const Outputs outputs{.depth = depthOnly, .picture = !depthOnly};
    std::printf("%-30s %9s %9s %9s | %9s %9s | %8s %8s %8s (minima)\n", "scene", "median", "p90", "min", "CPU med",
                "CPU min", "vertex", "geometry", "raster");
    for (const QString& name : parser.positionalArguments()) {
        const SceneLoad load = loadScene(name, {true, settings.size, {}});
        if (!load.scene) {
            std::fprintf(stderr, "%s: cannot be read\n", qPrintable(name));
            return 3;
        }
        if (const auto reason = unsupported(*load.scene, settings)) {
            std::fprintf(stderr, "%s\n", qPrintable(textOf(*reason)));
            return 2;
        }
        const Series s =
            measure(*load.scene, settings, outputs, parser.value("warm-up").toInt(), parser.value("frames").toInt());
        std::printf("%-30s %9.3f %9.3f %9.3f | %9.3f %9.3f | %8.3f %8.3f %8.3f\n", qPrintable(name.section('/', -1)),
                    quantile(s.total, 0.5), quantile(s.total, 0.9), quantile(s.total, 0), quantile(s.processor, 0.5),
                    quantile(s.processor, 0), quantile(s.vertex, 0), quantile(s.geometry, 0), quantile(s.raster, 0));
        std::fflush(stdout);
    }
    return 0;
}
