#pragma once
#include "core/io/text_input.h"

#include <glm/glm.hpp>

#include <string_view>
#include <vector>

namespace rasterlens
{

/// Collects the colours of an OBJ's vertices in whichever way the file gives them: as r g b behind a position, 0 to 1
/// or, as scanners write them, 0 to 255; or as ZBrush does, hexadecimal in comments `#MRGB`.
class VertexColors
{
public:
    /// in   the vertex's number, from 0 and rising
    void add(std::size_t vertex, const glm::vec3& color);

    /// A line that begins with `#`.
    void comment(std::string_view line);

    /// The colour of each vertex, white where it has none; nothing where none has.
    [[nodiscard]] std::vector<glm::vec3> take(std::size_t vertices, DiagnosticSink& diagnostics);

private:
    std::vector<glm::vec3> m_colors;      ///< -1 for a vertex without
    std::vector<glm::vec3> m_paintColors; ///< of the comments
    float m_largest = 0;
    bool m_wholeNumbers = true;
};

} // namespace rasterlens
