#pragma once
#include "core/io/text_input.h"

#include <glm/glm.hpp>

#include <vector>

namespace rasterlens
{

/// A name given by `mtllib` or `usemtl`.
struct ObjReference {
    QString name;
    int line = 0;
    std::size_t face = 0; ///< the `f` statement that follows, counted from 0
};

/// An OBJ text whose geometry is known to be sound.
struct ObjText {
    QByteArray geometry; ///< v, vt, vn and f statements only, each on one line, the rest overwritten with blanks
    std::vector<glm::dvec3> positions; ///< of each `v`, as near to the text as a double gets
    std::vector<glm::vec3> colors;     ///< of each `v`; empty when no `v` has one
    std::vector<ObjReference> libraries;
    std::vector<ObjReference> materialUses;
    std::size_t faceCount = 0; ///< `f` statements
};

/// Checks every statement of an OBJ that tinyobjloader would take on trust.
///
/// covers  number of components, finite float32 values, indices within range (also negative ones and those of
///         vertices defined further down), three corners a face; comments at the end of a line, backslash
///         continuation, all line ends
/// errors  diagnostics with line; the result is for use only if there are no errors among them
[[nodiscard]] ObjText checkObjText(QByteArray text, DiagnosticSink& diagnostics);

} // namespace rasterlens
