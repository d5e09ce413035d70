#include "core/scene/origin.h"

#include "core/scene/scene.h"

#include <QLocale>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace rasterlens
{

void BoundingBox::add(const glm::dvec3& point)
{
    if (!std::isfinite(point.x) || !std::isfinite(point.y) || !std::isfinite(point.z))
        return;
    low = glm::min(low, point);
    high = glm::max(high, point);
}

double BoundingBox::longestSide() const
{
    const glm::dvec3 sides = high - low;
    return isEmpty() ? 0 : std::max({sides.x, sides.y, sides.z});
}

double BoundingBox::relativeSize() const
{
    const double distance = isEmpty() ? 0 : glm::length(center());
    return distance > 0 ? longestSide() / distance : std::numeric_limits<double>::infinity();
}

glm::dvec3 originFor(const BoundingBox& box)
{
    if (box.relativeSize() >= kRecentredBelow)
        return glm::dvec3(0);
    const double side = box.longestSide();
    if (!(side > 0))
        return box.center(); // all points are one
    int exponent = 0;
    const double fraction = std::frexp(side, &exponent); // side = fraction * 2^exponent, fraction in [0.5, 1)
    const double step = std::ldexp(1.0, fraction == 0.5 ? exponent - 1 : exponent);
    const glm::dvec3 steps = box.center() / step;
    // nearbyint: half to even
    return step * glm::dvec3(std::nearbyint(steps.x), std::nearbyint(steps.y), std::nearbyint(steps.z));
}

glm::dvec4 worldFromObject(const glm::dvec4& object, const glm::dvec3& origin)
{
    return {glm::dvec3(object) + origin, object.w};
}

glm::dvec4 worldPosition(const Mesh& mesh, std::size_t vertex)
{
    return worldFromObject(glm::dvec4(mesh.vertices[vertex].position), mesh.origin);
}

QString worldNumber(float object, double origin)
{
    constexpr int kMostDecimals = 20; // beyond them a number is too small to write out
    const double world = double(object) + origin;
    for (int decimals = 0; decimals <= kMostDecimals; ++decimals) {
        const QString text = QString::number(world, 'f', decimals);
        if (static_cast<float>(text.toDouble() - origin) == object)
            return text;
    }
    return QString::number(world, 'g', QLocale::FloatingPointShortest);
}

QString worldText(const glm::vec4& object, const glm::dvec3& origin)
{
    QStringList numbers;
    for (int i = 0; i < 3; ++i)
        numbers << worldNumber(object[i], origin[i]);
    return numbers.join(QStringLiteral(", "));
}

std::optional<Reason> remarkOnDistance(const BoundingBox& box)
{
    if (box.relativeSize() >= kRemarkedBelow)
        return std::nullopt;
    const glm::dvec3 center = glm::abs(box.center());
    const double farthest = std::max({center.x, center.y, center.z});
    const double side = box.longestSide();
    const auto floatStep =
        double(std::nextafter(float(farthest), std::numeric_limits<float>::infinity())) - float(farthest);
    const double doubleStep = std::nextafter(farthest, std::numeric_limits<double>::infinity()) - farthest;
    const auto rounded = [](double value) { return QString::number(value, 'g', 6); };
    const auto full = [](double value) { return QString::number(value, 'g', 17); };
    const glm::dvec3 origin = originFor(box);
    constexpr double kVisible = 1e-5; // steps of the model's size that show as ragged edges in a large picture
    if (doubleStep > kVisible * side)
        return Reason(QT_TRANSLATE_NOOP("Diagnostic",
                                        "the model is %1 across and %2 from 0, where even double keeps only steps of "
                                        "%3; move it nearer to 0 before it is exported"),
                      {rounded(side), rounded(glm::length(center)), rounded(doubleStep)});
    return Reason(QT_TRANSLATE_NOOP("Diagnostic",
                                    "the model is %1 across and %2 from 0, where float32 keeps only steps of %3; "
                                    "positions are read in double and drawn about the origin (%4, %5, %6)"),
                  {rounded(side), rounded(glm::length(center)), rounded(floatStep), full(origin.x), full(origin.y),
                   full(origin.z)});
}

} // namespace rasterlens
