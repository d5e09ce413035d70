#include "app/cli/options.h"
#include "app/cli/output.h"
#include "app/cli/verbs.h"
#include "core/io/color_tags.h"
#include "core/io/npy.h"
#include "core/io/texture_loader.h"
#include "core/truth/array_difference.h"
#include "core/truth/difference.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <cmath>
#include <cstdio>
#include <optional>

namespace rasterlens::cli
{
namespace
{

QString heatHelp()
{
    QStringList classes;
    for (const HeatClass& heat : heatScale())
        classes << QStringLiteral("%1 #%2").arg(heat.steps).arg(heat.color & 0xffffffU, 6, 16, QLatin1Char('0'));
    return QStringLiteral(
               "The heat map: a pixel that differs has the colour of its largest channel difference in steps, "
               "from %1 upward; the others show A as dark grey. - is stdout.")
        .arg(classes.join(QStringLiteral(", ")));
}

Usage usage()
{
    const QList<Option> options{
        {QStringLiteral("-o"), Option::Kind::Value, QStringLiteral("FILE"), heatHelp()},
        {QStringLiteral("--threshold"), Option::Kind::Value, QStringLiteral("T"),
         QStringLiteral(
             "The largest difference that is still fine, 0 or more; default 0. In 8-bit steps for pictures, in "
             "the array's own unit for arrays.")},
        {QStringLiteral("--json"), Option::Kind::Value, QStringLiteral("F.json"),
         QStringLiteral("The same findings as one JSON object. - is stdout, in place of the text.")}};
    return {QStringLiteral("diff"),
            QStringLiteral("rasterlens-cli diff A B [-o heat.png] [--threshold T] [--json F.json]"),
            QStringLiteral("Compares two pictures of equal size, or two NumPy arrays of equal shape.\n\n"
                           "For pictures (PNG, PPM, BMP, JPEG, TGA) it prints how many pixels differ, the largest and "
                           "the mean difference of a channel in 8-bit steps, and the PSNR in decibels (inf when "
                           "equal). The channels are red, green and blue, and alpha where both pictures have it.\n"
                           "For arrays (.npy) of booleans, integers and floats it prints how many values differ, and "
                           "the largest and the mean difference; the types of the two may differ, and a last "
                           "dimension of length 1 behind two others does not count. NaN equals NaN and differs from "
                           "every number, whatever the threshold; where there is any, a line tells how many."),
            {QStringLiteral("A"), QStringLiteral("B")},
            {{QStringLiteral("Options:"), options}},
            QStringLiteral(
                "Exit codes: 0 no difference above the threshold; 1 there is one; 2 bad arguments; 3 a file that "
                "cannot be read or written, or two that cannot be compared.")};
}

double threshold(const Arguments& arguments)
{
    const auto text = arguments.value(QStringLiteral("--threshold"));
    if (!text)
        return 0;
    bool good = false;
    const double value = text->toDouble(&good);
    if (!good || !(value >= 0) || !std::isfinite(value))
        failArguments(
            QStringLiteral("--threshold: \"%1\" is not a value of threshold, which takes: a number, 0 or more")
                .arg(*text));
    return value;
}

QString counted(std::uint64_t part, std::uint64_t whole)
{
    const double percent = whole == 0 ? 0 : 100 * static_cast<double>(part) / static_cast<double>(whole);
    return QStringLiteral("%1 of %2 (%3 %)").arg(part).arg(whole).arg(percent, 0, 'g', 3);
}

/// A file to compare.
struct Side {
    QString path;
    QByteArray bytes;

    [[nodiscard]] bool isArray() const
    {
        return isNpy(bytes) || path.endsWith(QLatin1String(".npy"), Qt::CaseInsensitive);
    }
};

Side readSide(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        failInput(QStringLiteral("%1: cannot be read: %2").arg(path, file.errorString()));
    return {path, file.readAll()};
}

/// What the two are compared for, and where the findings go.
struct Request {
    std::optional<QString> heatPath;
    QString heatFormat;
    std::optional<QString> jsonPath;
    double limit = 0;

    explicit Request(const Arguments& arguments)
        : heatPath(arguments.value(QStringLiteral("-o"))), heatFormat(heatPath ? imageFormat(*heatPath) : QString()),
          jsonPath(arguments.value(QStringLiteral("--json"))), limit(threshold(arguments))
    {
        checkOutputs(outputs());
        checkInputsStay(outputs(), arguments.operands);
    }

    [[nodiscard]] QStringList outputs() const
    {
        QStringList names;
        for (const auto& path : {heatPath, jsonPath})
            if (path)
                names << *path;
        return names;
    }
    [[nodiscard]] bool usesStdout() const { return outputs().contains(QStringLiteral("-")); }
};

/// What was found, for people and for programs.
struct Findings {
    QString text;
    QJsonObject json;
    bool found = false; ///< a difference above the threshold
};

/// JSON has no infinity.
QJsonValue finite(double value) { return std::isfinite(value) ? QJsonValue(value) : QJsonValue(); }

QJsonValue count(std::uint64_t value) { return static_cast<qint64>(value); }

ExitCode report(const Side& a, const Side& b, const Request& request, Findings findings, OutputFiles files)
{
    QJsonObject& json = findings.json;
    json["a"] = a.path;
    json["b"] = b.path;
    json["threshold"] = request.limit;
    json["above"] = findings.found;
    if (request.jsonPath)
        files.add(*request.jsonPath, QJsonDocument(json).toJson());
    files.write();
    if (!request.usesStdout())
        printText(findings.text);
    return findings.found ? ExitCode::Found : ExitCode::Fine;
}

QImage readImage(const Side& side)
{
    const PictureLoad load = pictureFrom(side.bytes, side.path);
    if (load.problem)
        failInput(QStringLiteral("%1: is not a picture that can be read; PNG, PPM, BMP, JPEG or TGA is expected: %2")
                      .arg(side.path, textOf(*load.problem)));
    return load.image;
}

/// What is not seen by comparing the colours as they are stored, in 8 bits.
QStringList remarksOn(const Side& a, const QImage& imageA, const Side& b, const QImage& imageB)
{
    QStringList remarks;
    for (const auto& [side, image] : {std::pair(&a, &imageA), std::pair(&b, &imageB)}) {
        if (const auto remark = colorTagRemark(side->bytes))
            remarks << QStringLiteral("%1: %2").arg(side->path, textOf(*remark));
        if (image->depth() == 64 || image->format() == QImage::Format_Grayscale16)
            remarks << QStringLiteral("%1: has 16 bits a channel, which are compared in 8").arg(side->path);
    }
    if (imageA.hasAlphaChannel() != imageB.hasAlphaChannel())
        remarks << QStringLiteral("%1: has an alpha channel, which is not compared: %2 has none")
                       .arg(imageA.hasAlphaChannel() ? a.path : b.path, imageA.hasAlphaChannel() ? b.path : a.path);
    return remarks;
}

ExitCode diffImages(const Side& a, const Side& b, const Request& request)
{
    const QImage imageA = readImage(a);
    const QImage imageB = readImage(b);
    if (imageA.size() != imageB.size())
        failInput(QStringLiteral("%1: is %2x%3, but %4 is %5x%6; pictures of equal size are expected")
                      .arg(b.path)
                      .arg(imageB.width())
                      .arg(imageB.height())
                      .arg(a.path)
                      .arg(imageA.width())
                      .arg(imageA.height()));
    const QStringList remarks = remarksOn(a, imageA, b, imageB);
    for (const QString& remark : remarks)
        std::fprintf(stderr, "%s\n", qUtf8Printable(remark));
    const bool alpha = imageA.hasAlphaChannel() && imageB.hasAlphaChannel();
    const Channels channels = alpha ? Channels::Rgba : Channels::Rgb;
    const Difference found = difference(imageA, imageB, channels);
    OutputFiles files;
    if (request.heatPath)
        files.add(*request.heatPath, imageBytes(heatMap(imageA, imageB, 1, channels), request.heatFormat));

    constexpr double kEqualPsnr = 999; // as in the measurements of bench
    Findings findings;
    findings.text = QStringLiteral("differing %1\nmax %2\nmean %3\npsnr %4\n")
                        .arg(counted(found.differing, found.pixels))
                        .arg(found.max)
                        .arg(found.mean)
                        .arg(found.psnrDb);
    findings.json = {{"kind", "picture"},
                     {"total", count(found.pixels)},
                     {"differing", count(found.differing)},
                     {"max", found.max},
                     {"mean", found.mean},
                     {"psnr", std::isinf(found.psnrDb) ? kEqualPsnr : found.psnrDb},
                     {"alpha", alpha},
                     {"remarks", QJsonArray::fromStringList(remarks)}};
    findings.found = found.max > request.limit;
    return report(a, b, request, std::move(findings), std::move(files));
}

NpyArray readArray(const Side& side)
{
    NpyRead read = readNpy(side.bytes);
    if (!read.array)
        failInput(QStringLiteral("%1: %2").arg(side.path, read.error));
    return std::move(*read.array);
}

ExitCode diffArrays(const Side& a, const Side& b, const Request& request)
{
    const NpyArray arrayA = readArray(a);
    const NpyArray arrayB = readArray(b);
    if (arrayA.shape != arrayB.shape)
        failInput(QStringLiteral("%1: is %2 of shape %3, but %4 is %5 of shape %6; equal shapes are expected")
                      .arg(b.path, arrayB.type, shapeText(arrayB.shape), a.path, arrayA.type, shapeText(arrayA.shape)));
    if (arrayA.size() == 0)
        failInput(QStringLiteral("%1: is of shape %2: no values to compare").arg(a.path, shapeText(arrayA.shape)));
    const ArrayDifference found = difference(arrayA, arrayB);
    const std::uint64_t oneSided = found.nanOnlyInA + found.nanOnlyInB;
    Findings findings;
    findings.text = QStringLiteral("differing %1\nmax %2\nmean %3\n")
                        .arg(counted(found.differing, found.values))
                        .arg(found.max)
                        .arg(found.mean);
    if (oneSided + found.nanInBoth > 0)
        findings.text += QStringLiteral("nan %1 only in A, %2 only in B, %3 in both\n")
                             .arg(found.nanOnlyInA)
                             .arg(found.nanOnlyInB)
                             .arg(found.nanInBoth);
    findings.json = {{"kind", "array"},
                     {"total", count(found.values)},
                     {"differing", count(found.differing)},
                     {"max", finite(found.max)},
                     {"mean", finite(found.mean)},
                     {"nan", QJsonObject{{"only_a", count(found.nanOnlyInA)},
                                         {"only_b", count(found.nanOnlyInB)},
                                         {"both", count(found.nanInBoth)}}}};
    findings.found = found.max > request.limit || oneSided > 0;
    return report(a, b, request, std::move(findings), {});
}

} // namespace

Usage diffUsage() { return usage(); }

ExitCode runDiff(const QStringList& words)
{
    const auto arguments = parseArguments(usage(), words);
    if (!arguments)
        return ExitCode::Fine;
    const Request request(*arguments);
    const Side a = readSide(arguments->operands[0]);
    const Side b = readSide(arguments->operands[1]);
    if (a.isArray() != b.isArray())
        failArguments(
            QStringLiteral("rasterlens-cli diff: a picture and an array cannot be compared; two of a kind are "
                           "expected"));
    if (!a.isArray())
        return diffImages(a, b, request);
    if (request.heatPath)
        failArguments(QStringLiteral("rasterlens-cli diff: -o draws a heat map of pictures; arrays have none"));
    return diffArrays(a, b, request);
}

} // namespace rasterlens::cli
