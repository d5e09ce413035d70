// The answers of why() in words and as JSON.
#include "core/observe/names.h"
#include "core/observe/step_text.h"
#include "core/pipeline/mask_test.h"
#include "core/questions/why.h"
#include "core/settings/depth_rules.h"

#include <QJsonArray>

#include <bit>
#include <cmath>

namespace rasterlens
{
namespace
{

/// `BC (-8)`; `BC (0.5 < t_BC = 1)` where a value above 0 is not enough.
QString edgeText(const WhyFace& row, const WhyEdge& edge)
{
    const QString value = edgeValueText(edge.value, row.unitsPerArea);
    if (edge.passed || !(edge.value > 0))
        return QStringLiteral("%1 (%2)").arg(edge.name, value);
    return QStringLiteral("%1 (%2 < t_%1 = %3)").arg(edge.name, value, thresholdText(edge.threshold, row.unitsPerArea));
}

QString verdictText(const WhyReport& report, const WhyFace& row)
{
    switch (row.verdict) {
    case WhyVerdict::NonFinite: return QStringLiteral("dropped: a vertex is not a finite number");
    case WhyVerdict::Rejected: return QStringLiteral("rejected by %1").arg(planesText(row.planes));
    case WhyVerdict::CulledBack:
    case WhyVerdict::CulledFront:
        return QStringLiteral("culled as %1 face (%2 %3)")
            .arg(row.verdict == WhyVerdict::CulledBack ? QStringLiteral("back") : QStringLiteral("front"),
                 QLatin1String(facingId(row.facing->by)), fullNumber(row.facing->value));
    case WhyVerdict::Degenerate:
        return !row.facing || row.facing->screenArea == 0
                   ? QStringLiteral("degenerate: no area on the screen")
                   : QStringLiteral("degenerate: its area on the screen, %1, counts as none")
                         .arg(fullNumber(row.facing->screenArea / 2));
    case WhyVerdict::ClippedAway: return QStringLiteral("clipped away by %1").arg(planesText(row.planes));
    case WhyVerdict::OutsideEdge:
        if (const Rules pass = passRules(report.rules, row.face); !pass.coversByCentres())
            return pass.fill == Fill::Points  ? QStringLiteral("no corner of it is drawn here")
                   : pass.fill == Fill::Solid ? QStringLiteral("no column of it is filled here")
                                              : QStringLiteral("no line of it is drawn here");
        if (row.edge >= 0 && report.rules.coverageRule != CoverageRule::Centre)
            return (report.rules.coverageRule == CoverageRule::Inner
                        ? QStringLiteral("a part of the pixel's square lies outside edge %1")
                        : QStringLiteral("the whole square of the pixel lies outside edge %1"))
                .arg(edgeText(row, row.edges[std::size_t(row.edge)]));
        return row.edge < 0 ? QStringLiteral("outside the pieces that clipping left")
                            : QStringLiteral("outside edge %1").arg(edgeText(row, row.edges[std::size_t(row.edge)]));
    case WhyVerdict::LostTie: {
        const WhyEdge& edge = row.edges[std::size_t(row.edge)];
        return QStringLiteral("lost the tie on edge %1: %2")
            .arg(edgeText(row, edge), edge.side == EdgeSide::Neither
                                          ? QStringLiteral("neither a left nor a top edge, so not ours")
                                          : QStringLiteral("a %1 edge, but the tie rule excludes it")
                                                .arg(QLatin1String(edgeSideId(edge.side))));
    }
    case WhyVerdict::Hole:
        return QStringLiteral("cut out by the alpha test: the texture is opaque by %1 here, less than %2")
            .arg(depthNumber(row.opacity), depthNumber(kLeastOpacity));
    case WhyVerdict::FailedDepth:
        return row.fragment
                   ? QStringLiteral("failed the depth test: not %1 %2 %3")
                         .arg(depthNumber(row.fragment->depth), QLatin1String(depthSign(report.rules, row.face)),
                              depthNumber(row.fragment->storedDepth))
                   : QStringLiteral("covered, but not drawn by this algorithm");
    case WhyVerdict::Written: {
        const QString later = row.overwrittenBy
                                  ? QStringLiteral("overwritten later by %1")
                                        .arg(faceText(*row.overwrittenBy, report.lineOf(*row.overwrittenBy)))
                                  : QStringLiteral("seen");
        return QStringLiteral("written %1 over %2, depth %3 over %4; %5")
            .arg(colorText(row.write.after.color), colorText(row.write.before.color),
                 depthNumber(row.write.after.depth), depthNumber(row.write.before.depth), later);
    }
    }
    return {};
}

QJsonValue finiteOrText(double value)
{
    return std::isfinite(value) ? QJsonValue(value) : QJsonValue(fullNumber(value));
}

QJsonObject texelsToJson(const TexelFootprint& texels)
{
    const auto pair = [](const glm::dvec2& v) { return QJsonArray{finiteOrText(v.x), finiteOrText(v.y)}; };
    QJsonArray reads;
    for (const TexelRead& read : texels.reads)
        reads << QJsonObject{{"level", read.level},
                             {"texel", QJsonArray{read.x, read.y}},
                             {"weight", read.weight},
                             {"color", colorText(read.color)}};
    QJsonArray corners;
    for (const glm::dvec2& corner : texels.corners())
        corners << pair(corner);
    return {{"size", QJsonArray{texels.size.width(), texels.size.height()}},
            {"place", pair(texels.place)},
            {"right", pair(texels.right)},
            {"down", pair(texels.down)},
            {"level", finiteOrText(texels.level)},
            {"footprint", corners},
            {"reads", reads}};
}

QJsonObject rowToJson(const WhyReport& report, const WhyFace& row)
{
    QJsonObject object{{"face", static_cast<qint64>(row.face)},
                       {"verdict", QLatin1String(whyVerdictId(row.verdict))},
                       {"text", verdictText(report, row)}};
    if (row.line > 0)
        object.insert(QStringLiteral("line"), row.line);
    if (row.planes != 0)
        object.insert(QStringLiteral("planes"), planesText(row.planes));
    if (row.facing)
        object.insert(QStringLiteral("facing"), QJsonObject{{"space", QLatin1String(facingId(row.facing->by))},
                                                            {"value", finiteOrText(row.facing->value)},
                                                            {"screen_area", finiteOrText(row.facing->screenArea)}});
    if (row.hasEdges) {
        QJsonArray edges;
        for (const WhyEdge& edge : row.edges)
            edges << QJsonObject{{"edge", edge.name},
                                 {"value", finiteOrText(edge.value / row.unitsPerArea)},
                                 {"units", finiteOrText(edge.value)},
                                 {"side", QLatin1String(edgeSideId(edge.side))},
                                 {"passed", edge.passed}};
        object.insert(QStringLiteral("edges"), edges);
        object.insert(QStringLiteral("area"), row.area);
    }
    if (report.rules.multiSampled()) {
        QJsonArray covered;
        for (int sample = 0; sample < report.rules.patternSamples; ++sample)
            if ((row.coveredSamples >> sample & 1U) != 0)
                covered << sample;
        object.insert(QStringLiteral("covered_samples"), covered);
    }
    if (row.verdict == WhyVerdict::Hole)
        object.insert(QStringLiteral("opacity"), double(row.opacity));
    if (row.fragment) {
        object.insert(QStringLiteral("depth"), double(row.fragment->depth));
        object.insert(QStringLiteral("stored_depth"), double(row.fragment->storedDepth));
    }
    if (row.texels)
        object.insert(QStringLiteral("texels"), texelsToJson(*row.texels));
    if (row.verdict == WhyVerdict::Written) {
        object.insert(QStringLiteral("color_before"), colorText(row.write.before.color));
        object.insert(QStringLiteral("color"), colorText(row.write.after.color));
        if (row.overwrittenBy)
            object.insert(QStringLiteral("overwritten_by"), static_cast<qint64>(*row.overwrittenBy));
    }
    return object;
}

/// The numbers of the samples that a face covers, counted from 1.
QStringList samplesOf(const WhyFace& row)
{
    QStringList samples;
    for (SampleMask left = row.coveredSamples; left != 0; left &= static_cast<SampleMask>(left - 1))
        samples << QString::number(std::countr_zero(left) + 1);
    return samples;
}

QString samplesText(const ResolvedPixel& pixel)
{
    QStringList stored;
    for (int i = 0; i < pixel.count; ++i) {
        const Pixel& sample = pixel.samples[std::size_t(i)];
        stored << QStringLiteral("%1 z %2").arg(colorText(sample.color), depthNumber(sample.depth));
        if (pixel.counted(i) != sample.color)
            stored.last() += QStringLiteral(" (counts as black)");
    }
    return QStringLiteral("%1; mean %2: %3")
        .arg(stored.join(QStringLiteral(", ")), colorText(pixel.color), meanSums(pixel).join(QStringLiteral(", ")));
}

QJsonObject samplesToJson(const ResolvedPixel& pixel)
{
    QJsonArray samples;
    for (int i = 0; i < pixel.count; ++i) {
        const Pixel& sample = pixel.samples[std::size_t(i)];
        samples << QJsonObject{{"color", colorText(sample.color)},
                               {"depth", finiteOrText(double(sample.depth))},
                               {"counts_as", colorText(pixel.counted(i))}};
    }
    return {{"samples", samples}, {"color", colorText(pixel.color)}};
}

} // namespace

const char* whyVerdictId(WhyVerdict verdict)
{
    switch (verdict) {
    case WhyVerdict::NonFinite: return "non-finite";
    case WhyVerdict::Rejected: return "rejected";
    case WhyVerdict::CulledBack: return "culled-back";
    case WhyVerdict::CulledFront: return "culled-front";
    case WhyVerdict::Degenerate: return "degenerate";
    case WhyVerdict::ClippedAway: return "clipped-away";
    case WhyVerdict::OutsideEdge: return "outside-edge";
    case WhyVerdict::LostTie: return "lost-tie";
    case WhyVerdict::Hole: return "hole";
    case WhyVerdict::FailedDepth: return "failed-depth";
    case WhyVerdict::Written: return "written";
    }
    return "";
}

QString whyText(const WhyReport& report, const WhyFace& face)
{
    QString text = QStringLiteral("%1: %2").arg(faceText(face.face, face.line), verdictText(report, face));
    if (hasPartOfPixel(face))
        text += QStringLiteral("; %1 % of the pixel's area").arg(100 * face.area, 0, 'f', 1);
    if (!report.rules.multiSampled() || !face.hasEdges)
        return text;
    return QStringLiteral("%1; covers %2 of %3 samples%4")
        .arg(text)
        .arg(std::popcount(face.coveredSamples))
        .arg(report.rules.patternSamples)
        .arg(face.coveredSamples == 0 ? QString() : QStringLiteral(": ") + samplesOf(face).join(QStringLiteral(", ")));
}

QStringList whySamples(const WhyReport& report)
{
    if (!report.samples)
        return {};
    QStringList lines{QStringLiteral("samples ") + samplesText(*report.samples)};
    for (const WhyReport::Without& other : report.without)
        lines << QStringLiteral("without %1: samples %2")
                     .arg(QLatin1String(other.mistake->number), samplesText(other.samples));
    return lines;
}

QJsonObject toJson(const WhyReport& report)
{
    QJsonArray rows;
    for (const WhyFace& row : report.faces)
        rows << rowToJson(report, row);
    QJsonObject object{
        {"x", report.x},
        {"y", report.y},
        {"sample_x", report.sampleX},
        {"sample_y", report.sampleY},
        {"background", colorText(report.background)},
        {"color", colorText(report.color)},
        {"depth", double(report.depth)},
        {"visible_face", report.visibleFace ? QJsonValue(static_cast<qint64>(*report.visibleFace)) : QJsonValue()},
        {"faces", rows}};
    if (report.samples) {
        QJsonArray without;
        for (const WhyReport::Without& other : report.without) {
            QJsonObject row = samplesToJson(other.samples);
            row.insert(QStringLiteral("mistake"), QLatin1String(other.mistake->id));
            without << row;
        }
        object.insert(QStringLiteral("samples"), samplesToJson(*report.samples).value(QStringLiteral("samples")));
        object.insert(QStringLiteral("without"), without);
    }
    return object;
}

} // namespace rasterlens
