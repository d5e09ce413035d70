#include "core/scene/camera.h"

#include <algorithm>
#include <cmath>

namespace rasterlens
{
namespace
{

/// An orthonormal frame at the eye, in object space; `back` points away from what is looked at.
struct Frame3 {
    glm::dvec3 right;
    glm::dvec3 up;
    glm::dvec3 back;
    glm::dvec3 eye;
    glm::dvec3 target;
};

/// The view as rules put it together that are not the right ones.
glm::dmat4 viewByRules(const Frame3& f, const CameraRules& rules)
{
    const glm::dvec3& from = rules.origin == ViewOrigin::Eye ? f.eye : f.target;
    const glm::dmat3 rows(f.right, f.up, f.back); // as columns: from the camera's axes to the world's
    const glm::dmat3 turn = rules.axesAreRows ? glm::transpose(rows) : rows;
    glm::dmat4 view(turn);
    view[3] = glm::dvec4(rules.order == ViewOrder::TranslatedFirst ? -(turn * from) : -from, 1);
    return view;
}

glm::dmat4 viewFromObject(const Frame3& f, const CameraRules& rules)
{
    if (rules != CameraRules())
        return viewByRules(f, rules);
    return {glm::dvec4(f.right.x, f.up.x, f.back.x, 0), glm::dvec4(f.right.y, f.up.y, f.back.y, 0),
            glm::dvec4(f.right.z, f.up.z, f.back.z, 0),
            glm::dvec4(-glm::dot(f.right, f.eye), -glm::dot(f.up, f.eye), -glm::dot(f.back, f.eye), 1)};
}

/// Two directions that must not be parallel; a camera that looks along its up vector takes another one.
Frame3 lookAt(const View& view, const glm::dvec3& origin)
{
    glm::dvec3 back = view.eye - view.target;
    back = glm::length(back) > 0 ? glm::normalize(back) : glm::dvec3(0, 0, 1);
    glm::dvec3 right = glm::cross(view.up, back);
    if (!(glm::length(right) > 1e-9))
        right = glm::cross(std::abs(back.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1), back);
    right = glm::normalize(right);
    return {right, glm::cross(back, right), back, view.eye - origin, view.target - origin};
}

Frame3 fitted(const View& view, const BoundingSphere& bounds, double distance)
{
    const double yaw = glm::radians(view.yaw);
    const double pitch = glm::radians(view.pitch);
    const glm::dvec3 right(std::cos(yaw), 0, -std::sin(yaw));
    const glm::dvec3 up(-std::sin(yaw) * std::sin(pitch), std::cos(pitch), -std::cos(yaw) * std::sin(pitch));
    const glm::dvec3 back(std::sin(yaw) * std::cos(pitch), std::sin(pitch), std::cos(yaw) * std::cos(pitch));
    const glm::dvec3 target = bounds.center + bounds.radius * (view.pan.x * right + view.pan.y * up);
    return {right, up, back, target + distance * back, target};
}

/// Row z of a projection: z_clip = a * z_view + b. Perspective has w = -z_view, orthographic w = 1.
struct DepthRow {
    double a;
    double b;
};

DepthRow perspectiveDepth(double n, double f, const Settings& settings)
{
    if (settings.clipZ == ClipZ::D3d)
        return settings.reversedZ ? DepthRow{n / (f - n), f * n / (f - n)} : DepthRow{-f / (f - n), -f * n / (f - n)};
    const DepthRow gl{-(f + n) / (f - n), -2 * f * n / (f - n)};
    return settings.reversedZ ? DepthRow{-gl.a, -gl.b} : gl;
}

DepthRow orthographicDepth(double n, double f, const Settings& settings)
{
    if (settings.clipZ == ClipZ::D3d)
        return settings.reversedZ ? DepthRow{1 / (f - n), f / (f - n)} : DepthRow{-1 / (f - n), -n / (f - n)};
    const DepthRow gl{-2 / (f - n), -(f + n) / (f - n)};
    return settings.reversedZ ? DepthRow{-gl.a, -gl.b} : gl;
}

/// Distances of the near and the far plane.
struct Planes {
    double near;
    double far;
};

/// Planes in front of the eye and round the sphere.
Planes planesRound(const BoundingSphere& bounds, double toCenter)
{
    return {std::max(toCenter - 1.1 * bounds.radius, 0.01 * bounds.radius), toCenter + 1.1 * bounds.radius};
}

/// The planes moved apart until the whole sphere lies between them, also where it reaches behind the eye.
///
/// in   the distance of the centre along the gaze
Planes withAllOf(const Planes& planes, const BoundingSphere& bounds, double alongGaze)
{
    return {std::min(planes.near, alongGaze - 1.1 * bounds.radius),
            std::max(planes.far, alongGaze + 1.1 * bounds.radius)};
}

/// in   h: half the height of the picture at distance 1
glm::dmat4 perspective(double h, double aspect, const Planes& planes, const Settings& settings)
{
    const DepthRow z = perspectiveDepth(planes.near, planes.far, settings);
    return {glm::dvec4(1 / (h * aspect), 0, 0, 0), glm::dvec4(0, 1 / h, 0, 0), glm::dvec4(0, 0, z.a, -1),
            glm::dvec4(0, 0, z.b, 0)};
}

/// in   h: half the height of the picture, at every distance
glm::dmat4 orthographic(double h, double aspect, const Planes& planes, const Settings& settings)
{
    const DepthRow z = orthographicDepth(planes.near, planes.far, settings);
    return {glm::dvec4(1 / (h * aspect), 0, 0, 0), glm::dvec4(0, 1 / h, 0, 0), glm::dvec4(0, 0, z.a, 0),
            glm::dvec4(0, 0, z.b, 1)};
}

} // namespace

Matrices cameraMatrices(const Scene& scene, const Settings& settings, const CameraRules& rules)
{
    Matrices m;
    if (scene.space == SceneSpace::Clip)
        return m;
    const View& view = settings.view;
    const BoundingSphere& bounds = scene.bounds;
    const double halfAngle = view.fov / 2 * M_PI / 180;
    const double fitDistance = bounds.radius / std::sin(halfAngle) * view.distance;
    const Frame3 frame = view.fit ? fitted(view, bounds, fitDistance) : lookAt(view, scene.mesh.origin);

    m.orthographic = settings.projection == Projection::Orthographic;
    m.toViewer = frame.back;

    const double toCenter = view.fit ? fitDistance : glm::length(frame.eye - bounds.center);
    Planes planes = planesRound(bounds, toCenter);
    if (m.orthographic)
        planes = withAllOf(planes, bounds, view.fit ? fitDistance : glm::dot(frame.eye - bounds.center, frame.back));
    m.near = view.near.value_or(planes.near);
    m.far = std::max(view.far.value_or(planes.far), m.near * 1.001);

    const double h = std::tan(halfAngle);
    const double aspect = double(settings.size.width()) / settings.size.height();
    const double toTarget = view.fit ? fitDistance : glm::length(view.eye - view.target);
    m.clipFromView = m.orthographic ? orthographic(toTarget > 0 ? h * toTarget : h, aspect, {m.near, m.far}, settings)
                                    : perspective(h, aspect, {m.near, m.far}, settings);
    for (const int axis : {0, 1})
        m.clipFromView[axis][axis] *= rules.nearSign;
    m.viewFromObject = viewFromObject(frame, rules);
    m.clipFromObjectDouble = m.clipFromView * m.viewFromObject;
    m.clipFromObject = glm::mat4(m.clipFromObjectDouble);
    m.eyeObject = frame.eye;
    return m;
}

} // namespace rasterlens
