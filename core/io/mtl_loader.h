#pragma once
#include "core/io/mtl_map.h"
#include "core/io/reach.h"
#include "core/io/text_input.h"

#include <glm/glm.hpp>

#include <vector>

namespace rasterlens
{

/// An image that a material uses.
struct MtlImage {
    QString path; ///< absolute
    MtlMap map;
    int line = 0;           ///< where it is named
    bool isOutside = false; ///< its name leads out of the reach: not to be read
};

/// What an MTL file says about one material.
struct MtlMaterial {
    QByteArray nameBytes; ///< what `usemtl` is compared with: names are bytes, whatever their encoding
    QString name;         ///< the same for people
    std::optional<glm::vec3> diffuse;
    glm::vec3 specular{0, 0, 0};
    std::optional<float> shininess;
    std::optional<MtlImage> texture; ///< map_Kd
    std::optional<MtlImage> opacity; ///< map_d
    QString file;                    ///< where all this stands, for diagnostics
    int line = 0;                    ///< of its newmtl
};

/// Reads the materials of a Wavefront MTL file, in its order.
///
/// in      the bytes of the file `path`, beside which its textures lie, and where they may lie
/// covers  Kd, Ks, Ns, map_Kd and map_d with their options, in any letter case; names of any encoding, with blanks,
///         `#` and backslashes. Each material stands for itself: nothing is taken over from the one before it
/// errors  diagnostics with line; a statement with bad numbers is a warning and left out, as are statements before
///         the first newmtl; a remark names the statements that are not drawn
[[nodiscard]] std::vector<MtlMaterial> parseMtl(QByteArray text, const QString& path, const Reach& reach,
                                                DiagnosticSink& diagnostics);

} // namespace rasterlens
