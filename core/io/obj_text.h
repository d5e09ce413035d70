#pragma once
#include "core/io/text_input.h"

#include <glm/glm.hpp>

#include <string_view>
#include <vector>

namespace rasterlens
{

/// A name given by `mtllib` or `usemtl`.
struct ObjReference {
    QByteArray name; ///< its bytes, whatever their encoding
    int line = 0;
};

/// Indices from 0, -1 none.
struct ObjCorner {
    int position;
    int uv;
    int normal;
};

/// An `f` statement.
struct ObjFace {
    static constexpr int kNoGroup = -1; ///< no `s` statement came before
    static constexpr int kFlat = 0;     ///< `s off` or `s 0`

    std::uint32_t cornersEnd; ///< its corners end here; they begin where those of the face before end
    int line;
    int materialUse;    ///< index into ObjText::materialUses, -1 none
    int smoothingGroup; ///< of the last `s`
};

/// What an OBJ says, without what was wrong: every index is within range, every face has three different neighbours or
/// more and only finite positions.
struct ObjText {
    std::vector<glm::dvec3> positions; ///< as near to the text as a double gets; a bad one, which no face uses, is NaN
    std::vector<glm::vec3> colors;     ///< of each `v`, 0..1; empty when no `v` has one
    std::vector<glm::vec3> normals;    ///< a bad one is zero
    std::vector<glm::vec2> uvs;
    std::vector<ObjCorner> corners;
    std::vector<ObjFace> faces;
    std::vector<ObjReference> libraries;
    std::vector<ObjReference> materialUses;
};

/// How positions are rounded.
enum class ObjPositions {
    Double,
    Float32, ///< to the float32 nearest to the text
};

/// Reads an OBJ text, once: what is checked is taken.
///
/// covers  all line ends, comments, backslash continuation, negative indices and those of vertices defined further
/// down;
///         absent indices; `s`; colours behind positions, as 0..1 or as bytes, and in comments `#MRGB`
/// cost    linear
/// errors  diagnostics with line. A bad line is a warning: its face is left out, a bad normal or texture coordinate is
///         as if absent, surplus numbers are ignored. An error only where no face is left
[[nodiscard]] ObjText readObjText(std::string_view text, ObjPositions positions, DiagnosticSink& diagnostics);

} // namespace rasterlens
