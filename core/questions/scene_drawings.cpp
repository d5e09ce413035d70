#include "core/questions/scene_drawings.h"

#include "core/render/render.h"

#include <algorithm>
#include <cmath>

namespace rasterlens
{
namespace
{

constexpr double kMostKept = 256e6; ///< bytes
constexpr double kNudge = 0.01;     ///< pixels: more than 1/256, to which vertices snap, and than what doubles lose

/// The scene in clip space, moved right and down by so many pixels.
Scene movedInClip(const Scene& scene, QSize size, glm::dvec2 pixels)
{
    Scene moved = scene;
    for (MeshVertex& vertex : moved.mesh.vertices) {
        vertex.position.x += static_cast<float>(2 * pixels.x / size.width() * vertex.position.w);
        vertex.position.y -= static_cast<float>(2 * pixels.y / size.height() * vertex.position.w);
    }
    return moved;
}

/// The view with the camera moved so that what it looks at lies about so many pixels further right and down.
View movedView(View view, QSize size, glm::dvec2 pixels)
{
    const double pixel = 2.0 / size.height();
    if (view.fit) {
        view.pan += view.distance * pixel * glm::dvec2(-pixels.x, pixels.y);
        return view;
    }
    const glm::dvec3 back = view.eye - view.target;
    const glm::dvec3 right = glm::cross(view.up, back);
    const glm::dvec3 up = glm::cross(back, right);
    if (!(glm::length(up) > 0))
        return view;
    const double step = pixel * std::tan(glm::radians(view.fov) / 2) * glm::length(back);
    const glm::dvec3 move = step * (pixels.y * glm::normalize(up) - pixels.x * glm::normalize(right));
    view.eye += move;
    view.target += move;
    return view;
}

} // namespace

SceneDrawings::SceneDrawings(const Scene& scene, Settings settings, std::stop_token stop)
    : m_scene(scene), m_settings(std::move(settings)), m_stop(std::move(stop))
{
    m_settings.mistakes.clear();
}

QImage SceneDrawings::drawn(const Scene& scene, const Settings& settings) const
{
    if (unsupported(scene, settings))
        return {};
    Frame frame;
    render(scene, settings, frame, {}, m_stop);
    return frame.image;
}

const Settings& SceneDrawings::doubles()
{
    if (m_doubles)
        return *m_doubles;
    m_doubles = m_settings;
    m_doubles->numberType = NumberType::Float64;
    if (m_settings.clipping == Clipping::Frustum || m_settings.clipping == Clipping::FrustumW)
        m_doubles->clipping = Clipping::GuardBand;
    Settings notCulling = *m_doubles;
    notCulling.culling = Culling::None;
    if (m_settings.culling != Culling::None && drawn(m_scene, notCulling) == drawn(m_scene, *m_doubles))
        m_doubles = notCulling;
    return *m_doubles;
}

QImage SceneDrawings::of(const QStringList& mistakes, Program program)
{
    const std::pair key(mistakes, program);
    if (const auto kept = m_kept.find(key); kept != m_kept.end())
        return kept->second;
    Settings settings = program == Program::Doubles ? doubles() : m_settings;
    settings.mistakes = mistakes;
    const QImage image = drawn(m_scene, settings);
    const bool hasRoom = double(m_kept.size() + 1) * double(image.sizeInBytes()) <= kMostKept;
    if (mistakes.size() < 2 && hasRoom && !m_stop.stop_requested())
        m_kept.emplace(key, image);
    return image;
}

const std::vector<QImage>& SceneDrawings::rights()
{
    if (!m_rights.empty())
        return m_rights;
    Settings cutting = m_settings;
    cutting.numberType = NumberType::Float64;
    cutting.clipping = Clipping::CohenSutherland;
    for (const QImage& image : {of({}), of({}, Program::Doubles), drawn(m_scene, cutting)})
        if (m_rights.empty() || (!image.isNull() && std::ranges::find(m_rights, image) == m_rights.end()))
            m_rights.push_back(image);
    return m_rights;
}

std::vector<QImage> SceneDrawings::nudged(const QStringList& mistakes) const
{
    const bool isClip = m_scene.space == SceneSpace::Clip;
    std::vector<QImage> images;
    for (const glm::dvec2 pixels : {glm::dvec2(1, 1), {-1, -1}, {1, -1}, {-1, 1}}) {
        Settings settings = m_settings;
        settings.mistakes = mistakes;
        if (!isClip)
            settings.view = movedView(settings.view, settings.size, kNudge * pixels);
        images.push_back(drawn(isClip ? movedInClip(m_scene, settings.size, kNudge * pixels) : m_scene, settings));
    }
    return images;
}

} // namespace rasterlens
