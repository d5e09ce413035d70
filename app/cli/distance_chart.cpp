#include "app/cli/distance_chart.h"

#include "app/cli/distance_plot.h"
#include "app/cli/failure.h"
#include "app/cli/output.h"
#include "core/truth/distance_chart.h"

#include <array>
#include <cstdio>
#include <unistd.h>

namespace rasterlens::cli
{
namespace
{

/// Powers of two of the scene's size: from beside it to where double begins to lose it.
constexpr std::array kLog2Sides = {0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 28, 32, 36, 40};

QString tableOf(const Input& input, std::span<const DistanceRow> rows)
{
    QString text =
        QStringLiteral("%1, %2x%3, %4 faces, moved away from 0; judged from object space, positions in double\n")
            .arg(input.scene.id)
            .arg(input.settings.size.width())
            .arg(input.settings.size.height())
            .arg(input.scene.mesh.faceCount());
    const auto cells = [](const QStringList& words) {
        constexpr int kWidth = 14;
        QString line;
        for (const QString& word : words)
            line += word.rightJustified(kWidth);
        return line + QLatin1Char('\n');
    };
    const auto number = [](double value) { return QString::number(value, 'g', 3); };
    text += cells({{}, {}, {}, QStringLiteral("recentred"), {}, QStringLiteral("float32"), {}});
    text += cells({QStringLiteral("distance"), QStringLiteral("size/distance"), QStringLiteral("covered"),
                   QStringLiteral("corner px"), QStringLiteral("wrong"), QStringLiteral("corner px"),
                   QStringLiteral("wrong")});
    for (const DistanceRow& row : rows)
        text += cells({number(row.units), number(row.relativeSize), QString::number(row.covered),
                       number(row.recentred.corner), QString::number(row.recentred.wrong), number(row.float32.corner),
                       QString::number(row.float32.wrong)});
    return text +
           QStringLiteral("recentred: positions told from an origin of the mesh, as OBJ files are read; float32: "
                          "from 0.\nA step of snapping is %1 px.\n")
               .arg(number(1.0 / (1 << input.settings.subpixelBits)));
}

} // namespace

void printDistanceChart(const Input& input, const Arguments& arguments)
{
    if (input.scene.space != SceneSpace::Object)
        failArguments(QStringLiteral("rasterlens-cli bench: --chart distance: %1 is given in clip space and has no "
                                     "camera; a scene in object space is expected")
                          .arg(input.scene.id));
    const QString csv = arguments.value(QStringLiteral("--csv")).value_or(QString());
    const QString json = arguments.value(QStringLiteral("--json")).value_or(QString());
    const QString plot = arguments.value(QStringLiteral("--plot")).value_or(QString());
    const bool onTerminal = isatty(STDERR_FILENO) != 0;
    const std::vector<DistanceRow> rows = distanceChart(input.scene, input.settings, kLog2Sides, [&](std::size_t done) {
        if (onTerminal)
            std::fprintf(stderr, done < kLog2Sides.size() ? "\r%zu of %zu distances\033[K" : "\r\033[K", done,
                         kLog2Sides.size());
    });
    if (!QStringList{csv, json, plot}.contains(QStringLiteral("-")))
        printText(tableOf(input, rows));
    OutputFiles files;
    if (!csv.isEmpty())
        files.add(csv, distanceCsv(rows));
    if (!json.isEmpty())
        files.add(json, distanceJson(rows));
    if (!plot.isEmpty())
        files.add(plot, distanceFigure(rows, input.scene.id, 1.0 / (1 << input.settings.subpixelBits),
                                       plot.endsWith(QLatin1String(".png"), Qt::CaseInsensitive) ? "png" : "svg"));
    files.write();
}

} // namespace rasterlens::cli
