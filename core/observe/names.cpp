#include "core/observe/names.h"

#include "core/base/closed_list.h"
#include "core/pipeline/clipping.h"
#include "core/pipeline/shading.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

#include <array>
#include <cmath>

namespace rasterlens
{
namespace
{

constexpr auto kPlanes = std::to_array<ClipPlaneInfo>({
    {ClipPlane::W, QT_TRANSLATE_NOOP("Steps", "w"), "w"},
    {ClipPlane::Right, QT_TRANSLATE_NOOP("Steps", "right"), "+x"},
    {ClipPlane::Left, QT_TRANSLATE_NOOP("Steps", "left"), "\u2212x"},
    {ClipPlane::Top, QT_TRANSLATE_NOOP("Steps", "top"), "+y"},
    {ClipPlane::Bottom, QT_TRANSLATE_NOOP("Steps", "bottom"), "\u2212y"},
    {ClipPlane::Near, QT_TRANSLATE_NOOP("Steps", "near"), "\u2212z"},
    {ClipPlane::Far, QT_TRANSLATE_NOOP("Steps", "far"), "+z"},
});
static_assert(isClosedList(kPlanes, &ClipPlaneInfo::plane));
static_assert(kPlanes.size() == kClipPlanes);

template <class Text>
QString joined(std::uint32_t planes, const char* separator, Text text)
{
    QStringList parts;
    for (const ClipPlaneInfo& info : kPlanes)
        if ((planes & 1U << static_cast<unsigned>(info.plane)) != 0)
            parts << QString::fromUtf8(text(info));
    return parts.join(QLatin1String(separator));
}

} // namespace

const char* edgeSideId(EdgeSide side)
{
    switch (side) {
    case EdgeSide::Left: return QT_TRANSLATE_NOOP("Steps", "left");
    case EdgeSide::Top: return QT_TRANSLATE_NOOP("Steps", "top");
    case EdgeSide::Neither: break;
    }
    return QT_TRANSLATE_NOOP("Steps", "neither");
}

const ClipPlaneInfo& infoOf(ClipPlane plane) { return kPlanes[static_cast<std::size_t>(plane)]; }

QString clipPlaneFormula(ClipPlane plane, const Rules& rules)
{
    const double side = clipVolume(rules).cut[static_cast<std::size_t>(plane)].normal.w;
    const QString w = side == 1 ? QStringLiteral("w") : QStringLiteral("%1 w").arg(side);
    switch (plane) {
    case ClipPlane::W: return QStringLiteral("w \u2265 1e-5");
    case ClipPlane::Right: return QStringLiteral("x \u2264 ") + w;
    case ClipPlane::Left: return QStringLiteral("x \u2265 \u2212") + w;
    case ClipPlane::Top: return QStringLiteral("y \u2264 ") + w;
    case ClipPlane::Bottom: return QStringLiteral("y \u2265 \u2212") + w;
    case ClipPlane::Near:
        return rules.clipZ == ClipZ::Gl ? QStringLiteral("z \u2265 \u2212w") : QStringLiteral("z \u2265 0");
    case ClipPlane::Far: return QStringLiteral("z \u2264 w");
    }
    return {};
}

QString planesText(std::uint32_t planes)
{
    const QString names = joined(planes, "+", [](const ClipPlaneInfo& info) { return info.id; });
    return names.isEmpty() ? QStringLiteral("none") : names;
}

QString planeSigns(std::uint32_t planes)
{
    return joined(planes, ", ", [](const ClipPlaneInfo& info) { return info.sign; });
}

const char* faceFateId(FaceFate fate)
{
    switch (fate) {
    case FaceFate::Rejected: return QT_TRANSLATE_NOOP("Steps", "rejected");
    case FaceFate::CulledBack: return QT_TRANSLATE_NOOP("Steps", "culled-back");
    case FaceFate::CulledFront: return QT_TRANSLATE_NOOP("Steps", "culled-front");
    case FaceFate::Degenerate: return QT_TRANSLATE_NOOP("Steps", "degenerate");
    case FaceFate::NonFinite: return QT_TRANSLATE_NOOP("Steps", "non-finite");
    case FaceFate::Rasterized: break;
    }
    return QT_TRANSLATE_NOOP("Steps", "rasterized");
}

const char* facingId(Facing facing)
{
    switch (facing) {
    case Facing::ClipDeterminant: return QT_TRANSLATE_NOOP("Steps", "clip");
    case Facing::ViewNormal: return QT_TRANSLATE_NOOP("Steps", "view");
    case Facing::LightNormal: return QT_TRANSLATE_NOOP("Steps", "light");
    case Facing::AreaWithoutDivide: return QT_TRANSLATE_NOOP("Steps", "undivided");
    case Facing::AreaWithoutClipping: return QT_TRANSLATE_NOOP("Steps", "unclipped");
    case Facing::ScreenArea: break;
    }
    return QT_TRANSLATE_NOOP("Steps", "screen");
}

unsigned screenRegion(const glm::dvec4& p)
{
    const double x = p.x / p.w;
    const double y = p.y / p.w;
    return (x < -1 ? kRegionLeft : 0U) | (x > 1 ? kRegionRight : 0U) | (y < -1 ? kRegionBelow : 0U) |
           (y > 1 ? kRegionAbove : 0U);
}

QString regionText(unsigned region) { return QString::number(region & 15U, 2).rightJustified(4, QLatin1Char('0')); }

QString colorText(std::uint32_t color)
{
    return QLatin1Char('#') + QString::number(color & 0xffffffU, 16).rightJustified(6, QLatin1Char('0'));
}

std::optional<int> overdrawCount(std::uint32_t color)
{
    for (int count = 0; count <= kMostOverdraw; ++count)
        if (overdrawColor(static_cast<std::uint32_t>(count)) == color)
            return count;
    return std::nullopt;
}

QString faceText(std::uint32_t face, std::int32_t line)
{
    const QString text = QStringLiteral("face %1").arg(face);
    return line > 0 ? text + QStringLiteral(" (line %1)").arg(line) : text;
}

QString cornerLetter(std::size_t vertex) { return QString(QLatin1Char(char('A' + vertex))); }

QString shortNumber(double value) { return QString::number(value, 'g', 6); }

QString fullNumber(double value)
{
    constexpr double kMostInFull = 1e15; // 100000 and not 1e+05
    const bool isWhole = std::abs(value) < kMostInFull && value == std::trunc(value);
    return isWhole ? QString::number(value, 'f', 0) : QString::number(value, 'g', QLocale::FloatingPointShortest);
}

QString depthNumber(float depth) { return QString::number(static_cast<double>(depth), 'g', 9); }

} // namespace rasterlens
