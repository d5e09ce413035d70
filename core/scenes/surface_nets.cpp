#include "core/scenes/surface_nets.h"

#include <array>

namespace rasterlens
{
namespace
{

constexpr std::uint32_t kNoCorner = 0xffffffff;

class SurfaceNets
{
public:
    SurfaceNets(const CellGrid& grid, const std::function<double(glm::dvec3)>& distance,
                const std::function<glm::vec3(glm::dvec3)>& colorAt)
        : m_grid(grid), m_points(grid.cells + 1), m_distance(distance), m_colorAt(colorAt)
    {
    }

    Mesh run()
    {
        sampleField();
        addCorners();
        addFaces();
        return std::move(m_mesh);
    }

private:
    std::size_t index(glm::ivec3 at) const
    {
        return static_cast<std::size_t>((at.z * m_points.y + at.y) * m_points.x + at.x);
    }
    double field(glm::ivec3 point) const { return m_field[index(point)]; }
    bool inside(glm::ivec3 point) const { return field(point) < 0; }

    template <typename Visit>
    static void forEach(glm::ivec3 from, glm::ivec3 size, Visit visit)
    {
        for (int z = size.z - 1; z >= from.z; --z)
            for (int y = from.y; y < size.y; ++y)
                for (int x = from.x; x < size.x; ++x)
                    visit(glm::ivec3(x, y, z));
    }

    void sampleField()
    {
        m_field.resize(index(m_points - 1) + 1);
        forEach({0, 0, 0}, m_points, [&](glm::ivec3 at) { m_field[index(at)] = m_distance(m_grid.place(at)); });
    }

    glm::dvec3 gradient(glm::dvec3 p) const
    {
        const double h = 0.25 * m_grid.smallestCell;
        const auto along = [&](glm::dvec3 step) { return m_distance(p + step) - m_distance(p - step); };
        return glm::dvec3(along({h, 0, 0}), along({0, h, 0}), along({0, 0, h})) / (2 * h);
    }

    /// The mean of the points where the surface cuts the cell's edges, if it does.
    std::optional<glm::dvec3> cutCentre(glm::ivec3 cell) const
    {
        glm::dvec3 sum{0};
        int cuts = 0;
        for (int axis = 0; axis < 3; ++axis)
            for (int corner = 0; corner < 4; ++corner) {
                glm::ivec3 from = cell;
                from[(axis + 1) % 3] += corner & 1;
                from[(axis + 2) % 3] += corner >> 1;
                glm::ivec3 to = from;
                ++to[axis];
                if (inside(from) == inside(to))
                    continue;
                const double t = field(from) / (field(from) - field(to));
                sum += glm::mix(glm::dvec3(from), glm::dvec3(to), t);
                ++cuts;
            }
        return cuts > 0 ? std::optional(sum / static_cast<double>(cuts)) : std::nullopt;
    }

    /// One Newton step onto the surface, at most half a cell long.
    glm::dvec3 ontoSurface(glm::dvec3 p) const
    {
        const glm::dvec3 slope = gradient(p);
        const glm::dvec3 step = -m_distance(p) * slope / std::max(glm::dot(slope, slope), 0.1);
        const double limit = 0.5 * m_grid.smallestCell / std::max(glm::length(step), 0.5 * m_grid.smallestCell);
        return p + limit * step;
    }

    void addCorners()
    {
        m_corners.assign(m_field.size(), kNoCorner);
        forEach({0, 0, 0}, m_grid.cells, [&](glm::ivec3 cell) {
            const std::optional<glm::dvec3> centre = cutCentre(cell);
            if (!centre)
                return;
            const glm::dvec3 p = ontoSurface(m_grid.place(*centre));
            m_corners[index(cell)] = addVertex(m_mesh, p, gradient(p), m_colorAt(p));
        });
    }

    /// A quad for every grid edge that the surface cuts, between the four cells around the edge.
    void addFaces()
    {
        forEach({1, 1, 1}, m_grid.cells, [&](glm::ivec3 from) {
            for (int axis = 0; axis < 3; ++axis) {
                glm::ivec3 to = from;
                ++to[axis];
                if (inside(from) != inside(to))
                    addQuad(from, axis, inside(from));
            }
        });
    }

    void addQuad(glm::ivec3 from, int axis, bool outwardsAlongAxis)
    {
        const auto cellAt = [&](int back1, int back2) {
            glm::ivec3 cell = from;
            cell[(axis + 1) % 3] -= back1;
            cell[(axis + 2) % 3] -= back2;
            return m_corners[index(cell)];
        };
        std::array<std::uint32_t, 4> quad{cellAt(1, 1), cellAt(0, 1), cellAt(0, 0), cellAt(1, 0)};
        if (!outwardsAlongAxis)
            std::swap(quad[1], quad[3]);
        // Cut along the shorter diagonal.
        const auto apart = [&](std::size_t a, std::size_t b) {
            return glm::distance(m_mesh.vertices[quad[a]].position, m_mesh.vertices[quad[b]].position);
        };
        const std::size_t start = apart(0, 2) <= apart(1, 3) ? 0 : 1;
        const auto corner = [&](std::size_t i) { return quad[(start + i) % 4]; };
        addFace(m_mesh, corner(0), corner(1), corner(2));
        addFace(m_mesh, corner(0), corner(2), corner(3));
    }

    const CellGrid& m_grid;
    const glm::ivec3 m_points;
    const std::function<double(glm::dvec3)>& m_distance;
    const std::function<glm::vec3(glm::dvec3)>& m_colorAt;
    std::vector<double> m_field;
    std::vector<std::uint32_t> m_corners;
    Mesh m_mesh;
};

} // namespace

Mesh surfaceNets(const CellGrid& grid, const std::function<double(glm::dvec3)>& distance,
                 const std::function<glm::vec3(glm::dvec3)>& colorAt)
{
    return SurfaceNets(grid, distance, colorAt).run();
}

} // namespace rasterlens
