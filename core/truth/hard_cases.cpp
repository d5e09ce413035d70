#include "core/truth/hard_cases.h"

#include "core/pipeline/statistics.h"
#include "core/settings/depth_rules.h"
#include "core/truth/exact_texels.h"
#include "core/truth/expectations.h"

#include <QCoreApplication>
#include <QDir>

#include <algorithm>
#include <cmath>

namespace rasterlens
{
namespace
{

constexpr const char* kFolder = ":/rasterlens/cases";

using Reasons = std::vector<Reason>;

void addCount(Reasons& reasons, std::uint64_t count, const char* text)
{
    if (count > 0)
        reasons.push_back({text, {QString::number(count)}});
}

/// Adds the place of the first pixel that has the property.
template <class Has>
void addFirst(Reasons& reasons, const CoverageDifference& difference, Has&& has)
{
    const auto width = static_cast<std::size_t>(difference.window.width);
    for (std::size_t i = 0; i < difference.verdicts.size(); ++i)
        if (has(i)) {
            reasons.push_back({QT_TRANSLATE_NOOP("HardCase", "first at (%1, %2)"),
                               {QString::number(difference.window.x + static_cast<int>(i % width)),
                                QString::number(difference.window.y + static_cast<int>(i / width))}});
            return;
        }
}

Reasons coverageReasons(const CoverageDifference& d)
{
    Reasons reasons;
    addCount(reasons, d.missing, QT_TRANSLATE_NOOP("HardCase", "%1 missing"));
    addCount(reasons, d.extra, QT_TRANSLATE_NOOP("HardCase", "%1 extra"));
    addCount(reasons, d.hitTwice, QT_TRANSLATE_NOOP("HardCase", "%1 hit too often"));
    addCount(reasons, d.hitLess, QT_TRANSLATE_NOOP("HardCase", "%1 hit too seldom"));
    addFirst(reasons, d, [&](std::size_t i) {
        return d.verdicts[i] != PixelVerdict::Right && d.verdicts[i] != PixelVerdict::OtherFace;
    });
    return reasons;
}

double depthTolerance(DepthFormat format)
{
    const int largest = largestDepthCode(format);
    return largest > 0 ? 1.01 / largest : kCaseDepthTolerance;
}

/// Another face than the right one, where there is but one or at a depth that is not the right one either.
Reasons otherFaceReasons(const CoverageDifference& d, const Frame& frame, const ExactFrame& truth, double tolerance)
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
    Reasons reasons;
    addCount(reasons, count, QT_TRANSLATE_NOOP("HardCase", "%1 show another face"));
    addFirst(reasons, d, differs);
    return reasons;
}

/// Whether each sample is shaded at its own place, as the truth knows it.
bool shadesAtSamples(const Settings& settings)
{
    return patternSamples(settings.samples) == 1 || settings.attributeAt == AttributeAt::Sample;
}

Reasons expectReasons(const Scene& scene, const Outcome& outcome)
{
    for (const Expectation& line : checkExpectations(scene.expectations, outcome))
        if (!line.holds)
            return {{QT_TRANSLATE_NOOP("HardCase", "expect %1 %2: found %3"), {line.key, line.value, line.found}}};
    return {};
}

Reasons valueReasons(const CoverageDifference& d, double tolerance, bool judgesColors)
{
    if (d.depthMax > tolerance)
        return {{QT_TRANSLATE_NOOP("HardCase", "a depth is %1 off"), {QString::number(d.depthMax, 'g', 3)}}};
    if (judgesColors && d.colorMax > kCaseColorTolerance)
        return {{QT_TRANSLATE_NOOP("HardCase", "a colour is %1 steps off"), {QString::number(d.colorMax, 'g', 4)}}};
    return {};
}

/// What is not exact about a picture that is right.
Reasons toleranceReasons(const CoverageDifference& d)
{
    Reasons reasons;
    if (d.tolerated > 0)
        addCount(reasons, d.tolerated,
                 QT_TRANSLATE_NOOP("HardCase", "%1 differ, all closer to a true edge than snapping may move it"));
    else
        addCount(
            reasons, d.otherFace,
            QT_TRANSLATE_NOOP("HardCase", "%1 show another face, closer to the right one than depths are told apart"));
    return reasons;
}

} // namespace

namespace
{

/// Whether the colours of the truth are what the case shows.
bool knowsColors(const Scene& scene)
{
    return scene.defaults.shading == Shading::Gouraud || scene.defaults.shading == Shading::Texture;
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
    options.textured = settings.shading == Shading::Texture;
    ExactFrame truth = exactReference(exactTriangles(scene, settings), options);
    if (options.textured)
        textureExactly(scene, settings, truth);
    return truth;
}

CaseVerdict judgeCase(const Scene& scene, const ExactFrame& truth, const Settings& settings)
{
    if (const auto reason = unsupported(scene, settings))
        return {CaseGrade::Unsupported, {*reason}, {}};
    Frame frame;
    const Statistics statistics = renderCounted(scene, settings, frame, {.depth = true, .ids = true, .coverage = true});
    const double band = scene.exact ? legalBandPixels(settings.size) : 0;
    CoverageDifference difference = coverageDifference(frame, truth, scene.background, band);
    const double tolerance = std::max(depthTolerance(settings.depthFormat), depthTolerance(scene.defaults.depthFormat));
    Reasons reasons = coverageReasons(difference);
    if (reasons.empty())
        reasons = otherFaceReasons(difference, frame, truth, tolerance);
    if (reasons.empty() && !scene.exact && difference.otherFace == 0 && settings.samples == scene.defaults.samples)
        reasons = expectReasons(scene, outcomeOf(frame, scene, &statistics));
    if (reasons.empty() && !scene.exact)
        reasons = valueReasons(difference, tolerance, knowsColors(scene) && shadesAtSamples(settings));
    if (!reasons.empty())
        return {CaseGrade::Fails, std::move(reasons), std::move(difference)};
    reasons = toleranceReasons(difference);
    return {reasons.empty() ? CaseGrade::Passes : CaseGrade::PassesWithin, std::move(reasons), std::move(difference)};
}

CaseVerdict judgeReference(const Scene& scene, const ExactFrame& truth)
{
    Reasons reasons = expectReasons(scene, outcomeOf(truth, scene.background));
    return {reasons.empty() ? CaseGrade::Passes : CaseGrade::Fails, std::move(reasons), {}};
}

QString textOf(const std::vector<Reason>& reasons, Translate translate)
{
    QStringList parts;
    for (const Reason& reason : reasons)
        parts << textOf(reason, translate);
    return parts.join(textOf(Reason{QT_TRANSLATE_NOOP("HardCase", ", ")}, translate));
}

} // namespace rasterlens
