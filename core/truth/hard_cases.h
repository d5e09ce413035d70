#pragma once
#include "core/base/reason.h"
#include "core/truth/coverage_difference.h"

#include <QStringList>

#include <vector>

namespace rasterlens
{

/// The catalogue (resources/cases): names without `.case`, in order.
[[nodiscard]] QStringList hardCaseNames();

/// What loadScene() and the window open it by.
[[nodiscard]] QString hardCasePath(const QString& name);

enum class CaseGrade {
    Passes,
    PassesWithin, ///< right as far as snapping or the depth format can tell
    Fails,
    Unsupported, ///< these settings cannot draw it
};

/// Whether settings draw a case right, or why not.
struct CaseVerdict {
    CaseGrade grade = CaseGrade::Passes;
    std::vector<Reason> reasons;   ///< empty when it passes exactly; one where it is Unsupported
    CoverageDifference difference; ///< against the truth
};

/// `3 extra, first at (12, 7)`, in English without `translate`. Texts are of the context "HardCase", the one of an
/// Unsupported case of the context "Unsupported".
[[nodiscard]] QString textOf(const std::vector<Reason>& reasons, Translate translate = nullptr);

/// Draws a case and compares.
///
/// in      the scene of a case; settings: those of the case as a variant changes them (changedBy()); the caseTruth()
///         for as many samples
/// out     fails when, in this order: a pixel is missing, extra, hit too often or too seldom; another face is seen; an
///         `expect` line does not hold; a depth is further off than kCaseDepthTolerance or a code of the format; a
///         colour than kCaseColorTolerance. Textures: the nearest texels of faces that no plane cuts (exact_texels.h);
///         blended ones are not judged. Where several faces cover a pixel and the wrong one is seen, but at a depth
///         that is right to that tolerance, the depth buffer could not tell: the case passes within it
/// covers  with other samples than the case asks for, its `expect` lines are not asked. Cases marked `exact` are
///         the reference's own. Others snap: they pass within snapping where all that differs lies within
///         legalBandPixels() of a true edge; `expect` lines, depths and colours are not asked of them
[[nodiscard]] CaseVerdict judgeCase(const Scene& scene, const ExactFrame& truth, const Settings& settings);

/// Judges the reference itself by the `expect` lines of the case.
[[nodiscard]] CaseVerdict judgeReference(const Scene& scene, const ExactFrame& truth);

/// The truth about a case, with the distances that judgeCase() needs. The samples are those of the case, or others.
[[nodiscard]] ExactFrame caseTruth(const Scene& scene, Samples samples);

constexpr double kCaseDepthTolerance = 0x1p-22; ///< two units in the last place of float32 below 1, and a bit
constexpr double kCaseColorTolerance = 1.01;    ///< 8-bit steps

} // namespace rasterlens
