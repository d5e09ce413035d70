#include "core/truth/hard_cases.h"

#include "core/observe/statistics.h"
#include "core/truth/expectations.h"

#include <QDir>

#include <algorithm>
#include <cmath>

namespace rasterlens
{
namespace
{

constexpr const char* kFolder = ":/rasterlens/cases";

QString counted(std::uint64_t count, const char* what)
{
    return count > 0 ? QStringLiteral("%1 %2").arg(count).arg(QLatin1String(what)) : QString();
}

/// `, first at (x, y)` for the first pixel that has the property.
template <class Has>
QString firstAt(const CoverageDifference& difference, Has&& has)
{
    const auto width = static_cast<std::size_t>(difference.window.width);
    for (std::size_t i = 0; i < difference.verdicts.size(); ++i)
        if (has(i))
            return QStringLiteral(", first at (%1, %2)")
                .arg(difference.window.x + static_cast<int>(i % width))
                .arg(difference.window.y + static_cast<int>(i / width));
    return {};
}

QString coverageReason(const CoverageDifference& d)
{
    QStringList parts{counted(d.missing, "missing"), counted(d.extra, "extra"), counted(d.hitTwice, "hit too often"),
                      counted(d.hitLess, "hit too seldom")};
    parts.removeAll(QString());
    if (parts.isEmpty())
        return {};
    return parts.join(QStringLiteral(", ")) + firstAt(d, [&](std::size_t i) {
               return d.verdicts[i] != PixelVerdict::Right && d.verdicts[i] != PixelVerdict::OtherFace;
           });
}

double depthTolerance(DepthFormat format)
{
    switch (format) {
    case DepthFormat::Unorm16: return 1.01 / 0xffff;
    case DepthFormat::Unorm24: return 1.01 / 0xffffff;
    case DepthFormat::Float32: break;
    }
    return kCaseDepthTolerance;
}

/// Another face than the right one, where there is but one or at a depth that is not the right one either.
QString otherFaceReason(const CoverageDifference& d, const Frame& frame, const ExactFrame& truth, double tolerance)
{
    const PixelRect& window = d.window;
    const auto differs = [&](std::size_t i) {
        if (d.verdicts[i] != PixelVerdict::OtherFace)
            return false;
        const int x = static_cast<int>(i % static_cast<std::size_t>(window.width));
        const int y = static_cast<int>(i / static_cast<std::size_t>(window.width));
        const auto at = static_cast<std::size_t>(window.y + y) * static_cast<std::size_t>(frame.image.width()) +
                        static_cast<std::size_t>(window.x + x);
        const std::size_t sample = truth.sampleNearestCentre(x, y);
        return !truth.depthTested || truth.cover[sample] < 2 ||
               std::abs(static_cast<double>(frame.depth[at]) - truth.depth[sample]) > tolerance;
    };
    std::uint64_t count = 0;
    for (std::size_t i = 0; i < d.verdicts.size(); ++i)
        count += differs(i);
    return count > 0 ? counted(count, "show another face") + firstAt(d, differs) : QString();
}

QString expectReason(const Scene& scene, const Outcome& outcome)
{
    for (const Expectation& line : checkExpectations(scene.expectations, outcome))
        if (!line.holds)
            return QStringLiteral("expect %1 %2: found %3").arg(line.key, line.value, line.found);
    return {};
}

QString valueReason(const CoverageDifference& d, double tolerance)
{
    if (d.depthMax > tolerance)
        return QStringLiteral("a depth is %1 off").arg(d.depthMax, 0, 'g', 3);
    if (d.colorMax > kCaseColorTolerance)
        return QStringLiteral("a colour is %1 steps off").arg(d.colorMax, 0, 'g', 4);
    return {};
}

/// What is not exact about a picture that is right.
QString toleranceReason(const CoverageDifference& d)
{
    if (d.tolerated > 0)
        return counted(d.tolerated, "differ, all closer to a true edge than snapping may move it");
    return counted(d.otherFace, "show another face, closer to the right one than depths are told apart");
}

} // namespace

QStringList hardCaseNames()
{
    QStringList names;
    for (const QString& file :
         QDir(QLatin1String(kFolder)).entryList({QStringLiteral("*.case")}, QDir::Files, QDir::Name))
        names << file.chopped(5);
    return names;
}

QString hardCasePath(const QString& name) { return QStringLiteral("%1/%2.case").arg(QLatin1String(kFolder), name); }

ExactFrame caseTruth(const Scene& scene, Samples samples)
{
    Settings settings = scene.defaults;
    settings.samples = samples;
    ExactOptions options = exactOptions(scene, settings);
    options.edgeDistance = scene.exact;
    return exactReference(exactTriangles(scene, settings), options);
}

CaseVerdict judgeCase(const Scene& scene, const ExactFrame& truth, const Settings& settings)
{
    if (auto reason = unsupported(scene, settings))
        return {CaseGrade::Unsupported, *reason, {}};
    Frame frame;
    const Statistics statistics = renderCounted(scene, settings, frame, {.depth = true, .ids = true, .coverage = true});
    const double band = scene.exact ? legalBandPixels(settings.size) : 0;
    CoverageDifference difference = coverageDifference(frame, truth, scene.background, band);
    const double tolerance = std::max(depthTolerance(settings.depthFormat), depthTolerance(scene.defaults.depthFormat));
    QString reason = coverageReason(difference);
    if (reason.isEmpty())
        reason = otherFaceReason(difference, frame, truth, tolerance);
    if (reason.isEmpty() && !scene.exact && difference.otherFace == 0 && settings.samples == scene.defaults.samples)
        reason = expectReason(scene, outcomeOf(frame, scene, &statistics));
    if (reason.isEmpty() && !scene.exact)
        reason = valueReason(difference, tolerance);
    if (!reason.isEmpty())
        return {CaseGrade::Fails, std::move(reason), std::move(difference)};
    reason = toleranceReason(difference);
    return {reason.isEmpty() ? CaseGrade::Passes : CaseGrade::PassesWithin, std::move(reason), std::move(difference)};
}

CaseVerdict judgeReference(const Scene& scene, const ExactFrame& truth)
{
    const QString reason = expectReason(scene, outcomeOf(truth, scene.background));
    return {reason.isEmpty() ? CaseGrade::Passes : CaseGrade::Fails, reason, {}};
}

} // namespace rasterlens
