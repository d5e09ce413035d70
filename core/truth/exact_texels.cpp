#include "core/truth/exact_texels.h"

#include "core/pipeline/shading.h"
#include "core/truth/exact_geometry.h"
#include "core/truth/exact_reference.h"

#include <array>
#include <cmath>
#include <optional>

namespace rasterlens
{
namespace
{

using namespace exact;

constexpr int kUvBits = 149; ///< every float32 is a whole number of 2^-149

Integer wholeNumber(float value)
{
    int exponent = 0;
    const float mantissa = std::frexp(value, &exponent); // 24 bits behind the point
    const Integer digits(static_cast<std::int64_t>(std::ldexp(mantissa, 24)));
    const int shift = exponent - 24 + kUvBits;
    return shift >= 0 ? digits << static_cast<unsigned>(shift) : digits >> static_cast<unsigned>(-shift);
}

bool isInside(const glm::vec4& p, ClipZ clipZ)
{
    const float nearest = clipZ == ClipZ::Gl ? -p.w : 0;
    return p.w > 0 && std::abs(p.x) <= p.w && std::abs(p.y) <= p.w && nearest <= p.z && p.z <= p.w;
}

/// floor(t + 5 |t| 2^-24 + 2^-20) for t = numerator / denominator.
///
/// in   denominator > 0
Integer texelOf(const Integer& numerator, const Integer& denominator)
{
    const Integer held = (numerator << 24U) + 5 * boost::multiprecision::abs(numerator) + (denominator << 4U);
    return floorDivide(held, denominator << 24U);
}

std::int32_t repeated(const Integer& texel, int size, bool clamp)
{
    if (clamp)
        return clampedTo({0, size - 1}, texel);
    const Integer whole = floorDivide(texel, size);
    return static_cast<std::int32_t>(texel - whole * size);
}

/// Texture coordinates over an uncut face: u = uv[0] / weight / 2^149 and v = uv[1] / weight / 2^149.
class FaceTexels
{
public:
    /// in  a face that no plane cuts
    FaceTexels(const Scene& scene, const ClipTriangle& triangle, const std::array<glm::vec2, 3>& uv,
               const Lattice& lattice)
        : m_texture(*textureOf(scene, triangle.face))
    {
        IntegerTriangle integers = integerTriangle(triangle, 0, glm::dmat4(1));
        std::array<Snapped, 3> p{};
        std::array<Integer, 3> w;
        for (std::size_t i = 0; i < 3; ++i) {
            ScreenCorner corner = toScreen(integers.corners[i], triangle, lattice);
            w[i] = integers.corners[i].position[3];
            p[i] = snap(corner, lattice);
        }
        const std::int64_t area = doubledArea(p);
        const int sign = area < 0 ? -1 : 1;
        for (std::size_t i = 0; i < 3; ++i) {
            const Snapped& a = p[(i + 1) % 3];
            const Snapped& b = p[(i + 2) % 3];
            // The area of the edge opposite corner i and the sample, times the w of the other two.
            const Integer ax = Integer(b.x - a.x);
            const Integer ay = Integer(b.y - a.y);
            const Integer step = 2 * lattice.unit;
            const Integer offset = lattice.unit;
            Linear edge;
            edge.perColumn = -ay * step;
            edge.perRow = ax * step;
            edge.origin = ax * (offset - a.y) - ay * (offset - a.x);
            edge = edge * Integer(Integer(sign) * w[(i + 1) % 3] * w[(i + 2) % 3]);
            m_weight = m_weight + edge;
            m_uv[0] = m_uv[0] + edge * wholeNumber(uv[i].x);
            m_uv[1] = m_uv[1] + edge * wholeNumber(uv[i].y);
        }
    }

    [[nodiscard]] static const Texture* textureOf(const Scene& scene, std::uint32_t face)
    {
        const std::size_t material = scene.mesh.faceMaterial.empty() ? 0 : scene.mesh.faceMaterial[face];
        const int texture = scene.materials[material].texture;
        return texture < 0 ? nullptr : &scene.textures[static_cast<std::size_t>(texture)];
    }

    [[nodiscard]] ExactTexel at(int column, int row) const
    {
        const Integer weight = m_weight.at(column, row);
        if (weight.sign() <= 0)
            return {};
        const std::array<int, 2> sizes{m_texture.width, m_texture.height};
        std::array<Integer, 2> texel;
        for (std::size_t axis = 0; axis < 2; ++axis)
            texel[axis] = texelOf(m_uv[axis].at(column, row) * sizes[axis], weight << kUvBits);
        return {repeated(texel[0], sizes[0], m_texture.clamp), repeated(texel[1], sizes[1], m_texture.clamp),
                levelAt(column, row, weight)};
    }

    [[nodiscard]] const Texture& texture() const { return m_texture; }

private:
    /// The greatest n for which the longer of the two steps is at least 2^n texels; 0 where it is less than one.
    [[nodiscard]] int levelAt(int column, int row, const Integer& weight) const
    {
        const Integer squaredWeight = weight * weight;
        const Integer unit = (squaredWeight * squaredWeight) << (2U * kUvBits); // one texel, squared
        Integer longest = 0;
        for (const bool down : {false, true}) {
            Integer squared = 0;
            for (std::size_t axis = 0; axis < 2; ++axis) {
                const Linear& n = m_uv[axis];
                const Integer slope = down ? n.perRow : n.perColumn;
                const Integer weightSlope = down ? m_weight.perRow : m_weight.perColumn;
                const Integer step = (slope * weight - n.at(column, row) * weightSlope) *
                                     (axis == 0 ? m_texture.width : m_texture.height);
                squared += step * step;
            }
            longest = std::max(longest, squared);
        }
        int level = 0;
        for (Integer least = unit << 2U; longest >= least; least <<= 2U)
            ++level;
        return level;
    }

    const Texture& m_texture;
    Linear m_weight{};
    std::array<Linear, 2> m_uv{};
};

/// The texels of one face after another, made when its first sample asks.
class Texels
{
public:
    Texels(const Scene& scene, const Settings& settings)
        : m_scene(scene), m_clipZ(settings.clipZ), m_triangles(exactTriangles(scene, settings)),
          m_lattice(latticeOf(exactOptions(scene, settings))), m_faces(m_triangles.size())
    {
    }

    /// Null: not known.
    [[nodiscard]] const FaceTexels* of(std::int32_t face)
    {
        const auto at = static_cast<std::size_t>(face);
        if (!m_faces[at] && isKnown(at)) {
            std::array<glm::vec2, 3> uv{};
            for (std::size_t i = 0; i < 3; ++i)
                uv[i] = m_scene.mesh.vertices[m_scene.mesh.indices[3 * at + i]].uv;
            m_faces[at].emplace(m_scene, m_triangles[at], uv, m_lattice);
        }
        return m_faces[at] ? &*m_faces[at] : nullptr;
    }

private:
    [[nodiscard]] bool isKnown(std::size_t face) const
    {
        for (const ClipVertex& vertex : m_triangles[face].vertices)
            if (!isInside(glm::vec4(vertex.positionClip), m_clipZ))
                return false;
        return FaceTexels::textureOf(m_scene, static_cast<std::uint32_t>(face)) != nullptr;
    }

    const Scene& m_scene;
    ClipZ m_clipZ;
    std::vector<ClipTriangle> m_triangles;
    Lattice m_lattice;
    std::vector<std::optional<FaceTexels>> m_faces;
};

/// Calls visit(sample, face, texels) for every sample that shows a face; texels is null where they are not known.
template <class Visit>
void forEachSeen(const Scene& scene, const Settings& settings, const ExactFrame& truth, Visit&& visit)
{
    Texels texels(scene, settings);
    const bool snaps = settings.numberType == NumberType::Fixed && !scene.exact && truth.patternSamples == 1;
    for (int y = 0; y < truth.height; ++y)
        for (int x = 0; x < truth.width; ++x) {
            const auto sample =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(truth.width) + static_cast<std::size_t>(x);
            const std::int32_t face = truth.id[sample];
            if (face < 0 || scene.mesh.isLine(static_cast<std::uint32_t>(face)))
                continue;
            const FaceTexels* known = snaps ? texels.of(face) : nullptr;
            const ExactTexel texel = known != nullptr ? known->at(truth.window.x * truth.sampleGrid + x,
                                                                  truth.window.y * truth.sampleGrid + y)
                                                      : ExactTexel();
            visit(sample, texel, known != nullptr ? &known->texture() : nullptr);
        }
}

} // namespace

std::vector<ExactTexel> exactTexels(const Scene& scene, const Settings& settings, const ExactFrame& truth)
{
    std::vector<ExactTexel> all(truth.id.size());
    forEachSeen(scene, settings, truth,
                [&](std::size_t sample, const ExactTexel& texel, const Texture*) { all[sample] = texel; });
    return all;
}

bool textureExactly(const Scene& scene, const Settings& settings, ExactFrame& truth)
{
    bool isKnown = true;
    forEachSeen(scene, settings, truth, [&](std::size_t sample, const ExactTexel& texel, const Texture* texture) {
        if (texel.column < 0) {
            isKnown = false;
            return;
        }
        const std::ptrdiff_t at = std::ptrdiff_t(texel.row) * texture->width + texel.column;
        truth.color[sample] *= glm::dvec3(unpackColor(texture->texels[static_cast<std::size_t>(at)]));
    });
    return isKnown;
}

} // namespace rasterlens
