#include "core/render/motion.h"

#include "core/scene/camera.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <array>
#include <cmath>

namespace rasterlens
{
namespace
{

constexpr int kDegrees = 360;
constexpr int kParts = 256; // of a pixel

constexpr std::array<MotionInfo, 2> kMotions{{
    {Motion::Turntable, "turntable", QT_TRANSLATE_NOOP("Motion", "Turntable")},
    {Motion::Jitter, "jitter", QT_TRANSLATE_NOOP("Motion", "Jitter by 1/256 pixel")},
}};

View turned(View view, double degrees)
{
    if (view.fit) {
        view.yaw += degrees;
        return view;
    }
    const double angle = glm::radians(degrees);
    const auto turn = [&](const glm::dvec3& v) {
        return glm::dvec3(v.x * std::cos(angle) + v.z * std::sin(angle), v.y,
                          v.z * std::cos(angle) - v.x * std::sin(angle));
    };
    view.eye = view.target + turn(view.eye - view.target);
    view.up = turn(view.up);
    return view;
}

/// The view under which what lies as far away as the target is seen so many pixels further right.
View shifted(const Scene& scene, const Settings& settings, double pixels)
{
    View view = settings.view;
    const Matrices matrices = cameraMatrices(scene, settings);
    // How far a pixel reaches at the target: there the projection makes w of the distance, and 1 of x / w is half the
    // width.
    const double toTarget = view.fit ? scene.bounds.radius / std::sin(glm::radians(view.fov / 2)) * view.distance
                                     : glm::length(view.eye - view.target);
    const double w = matrices.orthographic ? 1 : toTarget;
    const double step = pixels * 2 / settings.size.width() * w / matrices.clipFromView[0][0];
    if (view.fit) {
        view.pan.x -= step / scene.bounds.radius;
        return view;
    }
    const glm::dmat4& m = matrices.viewFromObject;
    const glm::dvec3 right(m[0][0], m[1][0], m[2][0]);
    view.eye -= step * right;
    view.target -= step * right;
    return view;
}

/// A scene in clip space, seen so many pixels further right.
std::shared_ptr<const Scene> shifted(const Scene& scene, int width, double pixels)
{
    auto moved = std::make_shared<Scene>(scene);
    const double ndc = pixels * 2 / width;
    for (MeshVertex& vertex : moved->mesh.vertices)
        vertex.position.x = static_cast<float>(vertex.position.x + ndc * vertex.position.w);
    return moved;
}

} // namespace

std::span<const MotionInfo> motions() { return kMotions; }

const MotionInfo& infoOf(Motion motion) { return kMotions[static_cast<std::size_t>(motion)]; }

std::optional<Motion> motionFromId(const QString& id)
{
    for (const MotionInfo& info : kMotions)
        if (id == QLatin1String(info.id))
            return info.motion;
    return std::nullopt;
}

std::optional<Reason> whyNotMoved(const Scene& scene, Motion motion)
{
    if (motion == Motion::Turntable && scene.space == SceneSpace::Clip)
        return Reason{QT_TRANSLATE_NOOP(
            "Unsupported", "a turntable turns the camera; this scene is given in clip space and has none")};
    return std::nullopt;
}

int motionPlace(Motion motion, std::size_t n)
{
    if (motion == Motion::Turntable)
        return static_cast<int>(n % kDegrees);
    const auto place = static_cast<int>(n % (2 * kParts));
    return place <= kParts ? place : 2 * kParts - place;
}

MovedScene movedScene(const std::shared_ptr<const Scene>& scene, Settings settings, Motion motion, std::size_t n)
{
    const int place = motionPlace(motion, n);
    if (place == 0)
        return {scene, std::move(settings)};
    switch (motion) {
    case Motion::Turntable: settings.view = turned(settings.view, place); break;
    case Motion::Jitter: {
        const double pixels = double(place) / kParts;
        if (scene->space == SceneSpace::Clip)
            return {shifted(*scene, settings.size.width(), pixels), std::move(settings)};
        settings.view = shifted(*scene, settings, pixels);
        break;
    }
    }
    return {scene, std::move(settings)};
}

FrameChange changeBetween(const Frame& before, const Frame& now)
{
    FrameChange change;
    const auto width = static_cast<std::size_t>(now.image.width());
    for (int y = 0; y < now.image.height(); ++y) {
        const auto* a = reinterpret_cast<const QRgb*>(before.image.constScanLine(y));
        const auto* b = reinterpret_cast<const QRgb*>(now.image.constScanLine(y));
        const std::size_t first = static_cast<std::size_t>(y) * width;
        for (std::size_t x = 0; x < width; ++x) {
            change.colors += a[x] != b[x] ? 1 : 0;
            change.owners += before.ids[first + x] != now.ids[first + x] ? 1 : 0;
        }
    }
    return change;
}

std::optional<MotionRun> motionRunFromText(const QString& text)
{
    const QStringList words = text.split(QLatin1Char(':'));
    if (words.size() != 2)
        return std::nullopt;
    const auto motion = motionFromId(words[0]);
    const QStringList ends = words[1].split(QLatin1Char('-'));
    bool isFirst = false;
    bool isLast = false;
    const uint first = ends.first().toUInt(&isFirst);
    const uint last = ends.last().toUInt(&isLast);
    constexpr uint kMost = 1000000;
    if (!motion || !isFirst || !isLast || ends.size() > 2 || last < first || last > kMost)
        return std::nullopt;
    return MotionRun{*motion, {first, last}};
}

QString motionRunHelp()
{
    QStringList ids;
    for (const MotionInfo& info : kMotions)
        ids << QLatin1String(info.id);
    return QStringLiteral("%1, with a frame or a run of them, as turntable:0-89 or jitter:12")
        .arg(ids.join(QStringLiteral(", ")));
}

} // namespace rasterlens
