#pragma once
#include "core/io/file_names.h"
#include "core/io/mtl_loader.h"
#include "core/io/obj_text.h"
#include "core/io/texture_table.h"
#include "core/scene/scene.h"

#include <map>
#include <optional>
#include <set>

namespace rasterlens
{

/// The materials and textures of a scene, made as faces use them.
class ObjMaterials
{
public:
    /// in   remarks about the OBJ itself go to `objDiagnostics`
    ObjMaterials(const QString& objPath, const LoadOptions& options, bool vertexColors, DiagnosticSink& objDiagnostics,
                 Scene& scene)
        : m_objPath(objPath), m_reach(Consent::reachOf(objPath)), m_objDiagnostics(objDiagnostics),
          m_vertexColors(vertexColors), m_scene(scene), m_textures(scene, !options.texture.isEmpty())
    {
    }

    /// covers   a library that is not there, or not named, beside an MTL with the name of the OBJ: that is read
    void loadLibraries(const ObjText& text);

    /// The index in the scene of the material of each face.
    [[nodiscard]] std::vector<std::uint32_t> ofFaces(const ObjText& text);

    /// Remarks about other files than the OBJ.
    [[nodiscard]] Diagnostics takeDiagnostics() { return std::move(m_otherDiagnostics); }

private:
    void loadReference(const ObjReference& library);
    void loadLibrary(const NamedFile& file, int line);
    bool loadLibraryOfSameName(const Reason& why, int line);
    [[nodiscard]] const MtlMaterial* find(const QByteArray& name) const;
    [[nodiscard]] std::uint32_t use(const ObjReference& reference);
    [[nodiscard]] std::uint32_t useDefault();
    [[nodiscard]] std::uint32_t add(const MtlMaterial& mtl);

    const QString m_objPath;
    const Reach m_reach;
    DiagnosticSink& m_objDiagnostics;
    Diagnostics m_otherDiagnostics;
    const bool m_vertexColors;
    Scene& m_scene;
    bool m_libraryMissing = false;
    // A QHash ends the program where it gets no memory to grow.
    std::set<QString> m_read;
    std::map<QByteArray, MtlMaterial> m_library;
    std::map<QString, QByteArray> m_nameOfReadable;
    std::map<QByteArray, std::uint32_t> m_used;
    TextureTable m_textures;
    std::optional<std::uint32_t> m_default;
};

} // namespace rasterlens
