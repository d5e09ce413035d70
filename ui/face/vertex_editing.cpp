#include "ui/face/vertex_editing.h"

#include "core/base/typed_numbers.h"

#include <QColor>

#include <algorithm>
#include <cmath>

namespace rasterlens
{

bool isEditable(const Scene& scene)
{
    const std::size_t faces = scene.mesh.faceCount();
    return faces > 0 && faces <= kMostEditableFaces;
}

QPointF snappedPlace(QPointF pixels, VertexEditing::Snap snap, int subpixelBits)
{
    const auto nearest = [](QPointF point, double step, double offset) {
        return QPointF(std::round((point.x() - offset) / step) * step + offset,
                       std::round((point.y() - offset) / step) * step + offset);
    };
    switch (snap) {
    case VertexEditing::Snap::SubpixelGrid: return nearest(pixels, std::exp2(-subpixelBits), 0);
    case VertexEditing::Snap::PixelCentre: return nearest(pixels, 1, 0.5);
    case VertexEditing::Snap::PixelGrid: break;
    }
    return nearest(pixels, 1, 0);
}

std::shared_ptr<const Scene> withVertex(const Scene& scene, std::uint32_t vertex, const glm::vec4& position)
{
    auto edited = std::make_shared<Scene>(scene);
    edited->mesh.vertices[vertex].position = position;
    return edited;
}

std::shared_ptr<const Scene> withCorner(const Scene& scene, std::uint32_t vertex, const glm::vec4& position)
{
    auto edited = std::make_shared<Scene>(scene);
    const glm::vec4 former = scene.mesh.vertices[vertex].position;
    for (MeshVertex& other : edited->mesh.vertices)
        if (other.position == former)
            other.position = position;
    edited->mesh.vertices[vertex].position = position; // also one that is no number, which equals nothing
    return edited;
}

std::shared_ptr<const Scene> withColor(const Scene& scene, std::uint32_t vertex, const glm::vec3& color)
{
    auto edited = std::make_shared<Scene>(scene);
    edited->mesh.vertices[vertex].color = color;
    return edited;
}

std::optional<glm::vec4> typedPosition(const QString& text, const glm::vec4& former, const glm::dvec3& origin)
{
    const auto numbers = typedNumbers(text);
    if (!numbers || (numbers->size() != 3 && numbers->size() != 4))
        return std::nullopt;
    glm::vec4 position = former;
    for (std::size_t i = 0; i < numbers->size(); ++i) {
        const double typed = (*numbers)[i];
        const int k = static_cast<int>(i);
        position[k] = static_cast<float>(k < 3 ? typed - origin[k] : typed);
        if (!std::isfinite(position[k]))
            return std::nullopt;
    }
    return position;
}

std::optional<glm::dvec2> typedPlace(const QString& text)
{
    const auto numbers = typedNumbers(text);
    if (!numbers || numbers->size() != 2)
        return std::nullopt;
    return glm::dvec2((*numbers)[0], (*numbers)[1]);
}

std::optional<glm::vec3> typedColor(const QString& text)
{
    const QString plain = text.normalized(QString::NormalizationForm_KC).trimmed();
    if (plain.startsWith(QLatin1Char('#'))) {
        const QColor color(plain);
        constexpr qsizetype kDigits = 6;
        if (!color.isValid() || plain.size() != 1 + kDigits)
            return std::nullopt;
        return glm::vec3(color.red(), color.green(), color.blue()) / 255.0F;
    }
    const auto numbers = typedNumbers(text);
    const auto inRange = [](double value) { return value >= 0 && value <= 1; };
    if (!numbers || numbers->size() != 3 || !std::ranges::all_of(*numbers, inRange))
        return std::nullopt;
    return glm::vec3((*numbers)[0], (*numbers)[1], (*numbers)[2]);
}

} // namespace rasterlens
