#include "ui/document/navigation.h"

#include <algorithm>
#include <cmath>

namespace rasterlens
{
namespace
{

constexpr double kPi = 3.14159265358979323846;
constexpr double kNearest = 1e-3;
constexpr double kFarthest = 1e3;
constexpr glm::dvec3 kUpSeenFromAbove{0, 0, -1};

/// Eye relative to the target as yaw, pitch (degrees) and distance.
struct Spherical {
    double yaw = 0;
    double pitch = 0;
    double distance = 1;
};

Spherical sphericalOf(const View& view)
{
    const glm::dvec3 offset = view.eye - view.target;
    const double distance = glm::length(offset);
    if (!(distance > 0))
        return {};
    return {std::atan2(offset.x, offset.z) * 180 / kPi,
            std::asin(std::clamp(offset.y / distance, -1.0, 1.0)) * 180 / kPi, distance};
}

glm::dvec3 eyeOf(const Spherical& s, const glm::dvec3& target)
{
    const double yaw = s.yaw * kPi / 180;
    const double pitch = s.pitch * kPi / 180;
    return target +
           s.distance * glm::dvec3(std::cos(pitch) * std::sin(yaw), std::sin(pitch), std::cos(pitch) * std::cos(yaw));
}

double wrapDegrees(double degrees) { return std::remainder(degrees, 360.0); }

} // namespace

View orbit(const View& view, QPointF drag, int viewportHeight)
{
    const double degreesPerPixel = 180.0 / std::max(viewportHeight, 1);
    View next = view;
    if (view.fit) {
        next.yaw = wrapDegrees(view.yaw - drag.x() * degreesPerPixel);
        next.pitch = std::clamp(view.pitch + drag.y() * degreesPerPixel, -90.0, 90.0);
        return next;
    }
    // The free camera keeps clear of the poles, where its up vector would be parallel to the gaze.
    constexpr double kMaxPitch = 89.5;
    Spherical s = sphericalOf(view);
    s.yaw = wrapDegrees(s.yaw - drag.x() * degreesPerPixel);
    s.pitch = std::clamp(s.pitch + drag.y() * degreesPerPixel, -kMaxPitch, kMaxPitch);
    next.eye = eyeOf(s, view.target);
    if (view.up == kUpSeenFromAbove)
        next.up = {0, 1, 0};
    return next;
}

View panCamera(const View& view, QPointF drag, int viewportHeight, const BoundingSphere& bounds)
{
    const double tanHalf = std::tan(view.fov * kPi / 360);
    const double sinHalf = std::sin(view.fov * kPi / 360);
    View next = view;
    if (view.fit) {
        // The eye stands distance / sin(fov / 2) radii away.
        const double radiiPerPixel = 2 * tanHalf * view.distance / sinHalf / std::max(viewportHeight, 1);
        next.pan += glm::dvec2(-drag.x(), drag.y()) * radiiPerPixel;
        return next;
    }
    const glm::dvec3 gaze = view.target - view.eye;
    const glm::dvec3 side = glm::cross(gaze, view.up);
    if (!(glm::length(side) > 0))
        return view;
    const double distance = std::max(glm::length(gaze), bounds.radius * kNearest);
    const double unitsPerPixel = 2 * tanHalf * distance / std::max(viewportHeight, 1);
    const glm::dvec3 right = glm::normalize(side);
    const glm::dvec3 up = glm::normalize(glm::cross(right, gaze));
    const glm::dvec3 move = (right * -drag.x() + up * drag.y()) * unitsPerPixel;
    next.eye += move;
    next.target += move;
    return next;
}

View dolly(const View& view, double factor)
{
    View next = view;
    if (view.fit)
        next.distance = std::clamp(view.distance * factor, kNearest, kFarthest);
    else
        next.eye = view.target + (view.eye - view.target) * factor;
    return next;
}

View axisView(const View& view, AxisView axis)
{
    View next = view;
    const double yaw = axis == AxisView::Right ? 90 : 0;
    const double pitch = axis == AxisView::Top ? 90 : 0;
    if (view.fit) {
        next.yaw = yaw;
        next.pitch = pitch;
        next.pan = {0, 0};
        return next;
    }
    next.eye = eyeOf({yaw, pitch, sphericalOf(view).distance}, view.target);
    next.up = axis == AxisView::Top ? kUpSeenFromAbove : glm::dvec3(0, 1, 0);
    return next;
}

} // namespace rasterlens
