#pragma once
#include "core/io/text_input.h"

#include <glm/glm.hpp>

#include <vector>

namespace rasterlens
{

/// What an MTL file says about one material.
struct MtlMaterial {
    QString name;
    std::optional<glm::vec3> diffuse;
    glm::vec3 specular{0, 0, 0};
    std::optional<float> shininess;
    QString diffuseTexture; ///< absolute path; empty = none
    QString file;           ///< where map_Kd stands, for diagnostics
    int textureLine = 0;
};

/// Reads the materials of a Wavefront MTL file, in its order.
///
/// in      the bytes of the file `path`, beside which its textures lie
/// covers  Kd, Ks, Ns, map_Kd with its options; file names with blanks and backslashes
/// errors  diagnostics with line; a statement with bad numbers is a warning and left out, as are statements before
///         the first newmtl
[[nodiscard]] std::vector<MtlMaterial> parseMtl(QByteArray text, const QString& path, DiagnosticSink& diagnostics);

} // namespace rasterlens
