#pragma once
#include "core/pipeline/types.h"
#include "core/settings/rules.h"

#include <array>
#include <cstdint>
#include <vector>

namespace rasterlens
{

/// Which edges of a wireframe several triangles have, and which of these triangles draws them.
///
/// An edge is what it is on the screen: two ends, with position and depth. So the edges of two faces are the same where
/// they have the same corners, whether the mesh keeps these once or once a face, and however each face goes round; the
/// edges that a cut makes, and those between the pieces of a cut face, are counted by the same rule. Where a depth bias
/// with a slope lifts two faces differently, their edges lie at two depths: these are two lines, and both are drawn.
///
/// That triangle draws an edge whose samples would have stayed if all that have it did: the first of them in the order
/// of drawing where samples of equal depth fail the depth test, else the last. The line goes the way this triangle goes
/// round.
class EdgeSharing
{
public:
    explicit EdgeSharing(const Rules& rules);

    /// Adds the next triangle in the order of drawing.
    ///
    /// out  its number, from 0
    std::uint32_t add(const ScreenTriangle& triangle);

    /// The edges of a triangle that another one draws, as in ScreenTriangle::sharedEdges.
    ///
    /// in   its number, after all triangles have been added
    [[nodiscard]] std::uint8_t of(std::uint32_t triangle) const { return m_shared[triangle]; }

private:
    using Ends = std::array<double, 6>; ///< x, y and depth of both, the lesser end first
    struct Edge {
        Ends ends;
        std::uint32_t triangle; ///< that draws it
        std::uint8_t bit;
    };

    [[nodiscard]] static Ends endsOf(const ScreenVertex& a, const ScreenVertex& b);
    [[nodiscard]] static std::uint64_t hashOf(const Ends& ends);
    [[nodiscard]] std::size_t placeOf(const Ends& ends) const;
    void addEdge(const Edge& edge);
    void grow();

    bool m_firstDraws;
    std::vector<Edge> m_edges;
    std::vector<std::uint32_t> m_table; ///< 1 + index into m_edges, 0: free; a power of two of places
    std::vector<std::uint8_t> m_shared; ///< a triangle
};

} // namespace rasterlens
