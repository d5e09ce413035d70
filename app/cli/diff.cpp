#include "app/cli/options.h"
#include "app/cli/output.h"
#include "app/cli/verbs.h"
#include "core/io/npy.h"
#include "core/truth/difference.h"

#include <QFile>
#include <QImageReader>

#include <algorithm>
#include <cmath>

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
             "the array's own unit for arrays.")}};
    return {QStringLiteral("diff"),
            QStringLiteral("rasterlens-cli diff A B [-o heat.png] [--threshold T]"),
            QStringLiteral("Compares two pictures of equal size, or two .npy arrays of equal shape and type.\n\n"
                           "For pictures it prints how many pixels differ, the largest and the mean difference of a "
                           "channel (red, green, blue) in 8-bit steps, and the PSNR in decibels (inf when equal). For "
                           "arrays it prints how many values differ, and the largest and the mean difference."),
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

bool isArray(const QString& path) { return path.endsWith(QLatin1String(".npy"), Qt::CaseInsensitive); }

QString counted(std::uint64_t part, std::uint64_t whole)
{
    const double percent = whole == 0 ? 0 : 100 * static_cast<double>(part) / static_cast<double>(whole);
    return QStringLiteral("%1 of %2 (%3 %)").arg(part).arg(whole).arg(percent, 0, 'g', 3);
}

QByteArray readFile(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        failInput(QStringLiteral("%1: cannot be read: %2").arg(path, file.errorString()));
    return file.readAll();
}

QImage readImage(const QString& path)
{
    QByteArray bytes = readFile(path);
    QImage image;
    if (!image.loadFromData(bytes))
        failInput(QStringLiteral("%1: is not a picture that can be read; PNG, PPM, BMP or JPEG is expected").arg(path));
    return image;
}

NpyArray readArray(const QString& path)
{
    const NpyRead read = readNpy(readFile(path));
    if (!read.array)
        failInput(QStringLiteral("%1: %2").arg(path, read.error));
    return *read.array;
}

ExitCode verdict(double max, double limit) { return max > limit ? ExitCode::Found : ExitCode::Fine; }

ExitCode diffImages(const QString& pathA, const QString& pathB, const std::optional<QString>& heatPath, double limit)
{
    const QByteArray format = heatPath ? imageFormat(*heatPath) : QByteArray();
    const QImage a = readImage(pathA);
    const QImage b = readImage(pathB);
    if (a.size() != b.size())
        failInput(QStringLiteral("%1: is %2x%3, but %4 is %5x%6; pictures of equal size are expected")
                      .arg(pathB)
                      .arg(b.width())
                      .arg(b.height())
                      .arg(pathA)
                      .arg(a.width())
                      .arg(a.height()));
    const Difference found = difference(a, b);
    if (heatPath) {
        OutputFiles files;
        files.add(*heatPath, imageBytes(heatMap(a, b), format));
        files.write();
    }
    if (heatPath != QLatin1String("-"))
        printText(QStringLiteral("differing %1\nmax %2\nmean %3\npsnr %4\n")
                      .arg(counted(found.differing, found.pixels))
                      .arg(found.max)
                      .arg(found.mean)
                      .arg(found.psnrDb));
    return verdict(found.max, limit);
}

ExitCode diffArrays(const QString& pathA, const QString& pathB, double limit)
{
    const NpyArray a = readArray(pathA);
    const NpyArray b = readArray(pathB);
    if (a.type != b.type || a.rows != b.rows || a.columns != b.columns)
        failInput(QStringLiteral("%1: is %2 of shape (%3, %4), but %5 is %6 of shape (%7, %8); equal ones are expected")
                      .arg(pathB, b.type)
                      .arg(b.rows)
                      .arg(b.columns)
                      .arg(pathA, a.type)
                      .arg(a.rows)
                      .arg(a.columns));
    std::uint64_t differing = 0;
    double max = 0;
    double sum = 0;
    for (std::size_t i = 0; i < a.values.size(); ++i) {
        const double step = std::abs(a.values[i] - b.values[i]);
        differing += step > 0 ? 1U : 0U;
        max = std::max(max, step);
        sum += step;
    }
    const double mean = a.values.empty() ? 0 : sum / static_cast<double>(a.values.size());
    printText(
        QStringLiteral("differing %1\nmax %2\nmean %3\n").arg(counted(differing, a.values.size())).arg(max).arg(mean));
    return verdict(max, limit);
}

} // namespace

ExitCode runDiff(const QStringList& words)
{
    const auto arguments = parseArguments(usage(), words);
    if (!arguments)
        return ExitCode::Fine;
    const QString& a = arguments->operands[0];
    const QString& b = arguments->operands[1];
    const auto heatPath = arguments->value(QStringLiteral("-o"));
    const double limit = threshold(*arguments);
    if (isArray(a) != isArray(b))
        failArguments(
            QStringLiteral("rasterlens-cli diff: a picture and an array cannot be compared; two of a kind are "
                           "expected"));
    if (!isArray(a))
        return diffImages(a, b, heatPath, limit);
    if (heatPath)
        failArguments(QStringLiteral("rasterlens-cli diff: -o draws a heat map of pictures; arrays have none"));
    return diffArrays(a, b, limit);
}

} // namespace rasterlens::cli
