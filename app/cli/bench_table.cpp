#include "app/cli/bench_table.h"

#include <algorithm>

namespace rasterlens::cli
{
namespace
{

QString cell(const QString& text, int width) { return text.rightJustified(width) + QLatin1Char(' '); }
QString cell(double number, int width, int digits = 4) { return cell(QString::number(number, 'g', digits), width); }

QString errorCells(const VariantError& error)
{
    const QString none = QStringLiteral("-");
    QString text;
    const auto& c = error.coverage;
    for (const auto member :
         {&VariantError::Coverage::missing, &VariantError::Coverage::extra, &VariantError::Coverage::hitTwice})
        text += cell(c ? QString::number(*c.*member) : none, 7);
    text += error.depth ? cell(error.depth->max, 9, 3) : cell(none, 9);
    text += error.color ? cell(error.color->max, 8) + cell(error.color->mean, 8) + cell(error.color->psnrDb, 7)
                        : cell(none, 8) + cell(none, 8) + cell(none, 7);
    return text;
}

QString ratioCells(const std::optional<TimeRatio>& ratio)
{
    if (!ratio)
        return cell(QStringLiteral("1"), 6) + cell(QString(), 11);
    return cell(QString::number(ratio->median, 'f', 2), 6) +
           cell(QStringLiteral("%1-%2").arg(ratio->p10, 0, 'f', 2).arg(ratio->p90, 0, 'f', 2), 11);
}

QString headOf(const ExperimentRow& first)
{
    const std::pair<QString, int> columns[] = {
        {QStringLiteral("ms"), 7},       {QStringLiteral("p10"), 7},    {QStringLiteral("p90"), 7},
        {QStringLiteral("cpu"), 7},      {QStringLiteral("ratio"), 6},  {QStringLiteral("p10-p90"), 11},
        {QStringLiteral("ns/px"), 8},    {QStringLiteral("Mtri/s"), 8}, {QStringLiteral("missing"), 7},
        {QStringLiteral("extra"), 7},    {QStringLiteral("twice"), 7},  {QStringLiteral("depth max"), 9},
        {QStringLiteral("col. max"), 8}, {QStringLiteral("mean"), 8},   {QStringLiteral("PSNR"), 7}};
    QString text = QStringLiteral("variant").leftJustified(30);
    for (const auto& [name, width] : columns)
        text += cell(name, width);
    return QStringLiteral("ratio: to %1\n").arg(first.variant) + text + QLatin1Char('\n');
}

/// What was found out about renderers that are not ours.
QString rendererLines(std::span<const ExperimentRow> rows)
{
    QString text;
    for (const ExperimentRow& row : rows)
        if (row.other) {
            const RendererTraits& traits = row.other->traits;
            text +=
                QStringLiteral("%1: %2; measured: corners snap %3 1/%4 pixel%5 (%6 subpixel bits), tie rule %7%8; its "
                               "vertices come in clip space, and its time holds bringing the picture back\n")
                    .arg(row.variant, row.other->name,
                         traits.nearest ? QStringLiteral("to the nearest") : QStringLiteral("to"))
                    .arg(1 << traits.subpixelBits)
                    .arg(traits.orMore ? QStringLiteral(" or finer") : QString())
                    .arg(traits.subpixelBits)
                    .arg(QLatin1String(idOf(traits.sides)),
                         traits.diagonalOnce ? QString() : QStringLiteral(", but a shared diagonal is not hit once"));
        }
    return text;
}

QString noiseLine(std::span<const ExperimentRow> rows)
{
    const MachineNoise noise = noiseOf(rows);
    QString text =
        QStringLiteral("noise: frames of a variant vary by %1 % (p10 to p90, median of the variants); variants "
                       "with one thread had the processor %2 % of the time\n")
            .arg(100 * noise.spread, 0, 'f', 0)
            .arg(100 * noise.own, 0, 'f', 0);
    constexpr double kBusy = 0.9;
    if (noise.own < kBusy)
        text +=
            QStringLiteral("other programs had the rest of it: the cpu column can be trusted more than the clock's\n");
    if (noise.largestBatch > 1)
        text += QStringLiteral(
                    "frames of less than %1 ms, too short to time one by one, were timed in batches of up to %2\n")
                    .arg(kShortestTiming)
                    .arg(noise.largestBatch);
    return text;
}

QString judgementLines(std::span<const ExperimentRow> rows, ErrorMeasure measure)
{
    const QString id = QLatin1String(infoOf(measure).id);
    QString text;
    if (isExactThroughout(rows, measure))
        text += QStringLiteral("every variant is exact here: all errors (%1) are 0\n").arg(id);
    if (std::ranges::any_of(rows, &ExperimentRow::frontier))
        text += QStringLiteral("* on the frontier: none with as small an error (%1) was faster in nine of ten rounds\n")
                    .arg(id);
    if (rows.front().reference)
        text += *rows.front().reference == ReferenceSpace::Object
                    ? QStringLiteral("judged from object space: the vertex stage's float32 counts as well\n")
                    : QStringLiteral("judged from clip space: what the vertex stage made is taken as given\n");
    if (const auto advantage = walkingAdvantage(rows))
        text +=
            QStringLiteral("edge equation takes %1 times as long as edge walking here, %2 to %3 (p10 to p90 of %4 "
                           "pairs); a blog measured at least %5 (72 frames in more than 8 s against 71 in 5.8 s, one "
                           "model, a debug build)\n")
                .arg(advantage->median, 0, 'f', 2)
                .arg(advantage->p10, 0, 'f', 2)
                .arg(advantage->p90, 0, 'f', 2)
                .arg(advantage->pairs)
                .arg(kPublishedWalkingAdvantage);
    return text;
}

} // namespace

QString benchTable(std::span<const ExperimentRow> rows, const Input& input, ErrorMeasure measure)
{
    QString text = QStringLiteral("%1, %2x%3, %4 faces")
                       .arg(input.scene.id)
                       .arg(input.settings.size.width())
                       .arg(input.settings.size.height())
                       .arg(input.scene.mesh.faceCount());
    if (rows.empty())
        return text + QLatin1Char('\n');
    text += QStringLiteral("; ") + headOf(rows.front());
    for (const ExperimentRow& row : rows)
        text += (row.frontier ? QLatin1Char('*') : QLatin1Char(' ')) + row.variant.leftJustified(29) +
                cell(row.ms.median, 7) + cell(row.ms.p10, 7) + cell(row.ms.p90, 7) + cell(row.ms.processor, 7) +
                ratioCells(row.ratio) + cell(row.nsPerCoveredPixel, 8) + cell(row.mtriPerS, 8) + errorCells(row.error) +
                QLatin1Char('\n');
    return text + judgementLines(rows, measure) + rendererLines(rows) + noiseLine(rows) + QLatin1Char('\n');
}

} // namespace rasterlens::cli
