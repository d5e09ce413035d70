#include "core/io/obj_loader.h"

#include "core/io/file_names.h"
#include "core/io/mapped_file.h"
#include "core/io/obj_materials.h"
#include "core/io/obj_mesh.h"
#include "core/io/obj_text.h"
#include "core/io/peer_mesh.h"
#include "core/io/texture_loader.h"
#include "core/io/texture_table.h"

#include <QFileInfo>
#include <QStringConverter>

#include <algorithm>
#include <iterator>

namespace rasterlens
{
namespace
{

void append(Diagnostics& to, Diagnostics&& from)
{
    to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

/// UTF-8 of a text in UTF-16, as some shells write it; nothing for other texts.
QByteArray fromUtf16(std::string_view text)
{
    if (!text.starts_with("\xFF\xFE") && !text.starts_with("\xFE\xFF"))
        return {};
    QStringDecoder decoder(QStringDecoder::Utf16);
    return QString(decoder.decode(QByteArrayView(text.data(), static_cast<qsizetype>(text.size())))).toUtf8();
}

ObjText readFile(const QString& path, ObjPositions positions, DiagnosticSink& diagnostics)
{
    MappedFile file;
    if (const auto problem = file.open(path)) {
        diagnostics.error(0, *problem);
        return {};
    }
    const QByteArray converted = fromUtf16(file.text());
    if (!converted.isEmpty())
        diagnostics.note(0,
                         QT_TRANSLATE_NOOP("Diagnostic", "the text is UTF-16; UTF-8 is smaller and read everywhere"));
    ObjText text = readObjText(converted.isEmpty()
                                   ? file.text()
                                   : std::string_view(converted.data(), static_cast<std::size_t>(converted.size())),
                               positions, diagnostics);
    if (file.wasShortened())
        diagnostics.error(0, QT_TRANSLATE_NOOP("Diagnostic", "another program shortened the file while it was read"));
    return text;
}

Diagnostics fillScene(const ObjText& text, const QString& path, const LoadOptions& options, DiagnosticSink& diagnostics,
                      Scene& scene)
{
    ObjMaterials materials(path, options, !text.colors.empty(), diagnostics, scene);
    materials.loadLibraries(text);
    const std::vector<std::uint32_t> materialOfFace = materials.ofFaces(text);
    scene.mesh = makeObjMesh(text, materialOfFace, scene.materials, diagnostics);
    const auto moves = [](const Material& m) { return m.uvScale != glm::vec2(1) || m.uvOffset != glm::vec2(0); };
    if (std::ranges::any_of(scene.materials, moves))
        changeCoordinates(scene);
    scene.bounds = boundingSphere(scene.mesh);
    return materials.takeDiagnostics();
}

void fillPeerScene(const ObjText& text, Scene& scene)
{
    PeerMesh peer = peerMesh(text);
    scene.mesh = std::move(peer.mesh);
    scene.bounds = peer.bounds;
    Material material;
    material.diffuse = kPeerColor;
    material.texture = scene.textures.empty() ? -1 : 0;
    scene.materials = {material};
}

} // namespace

SceneLoad loadObj(const QString& path, const LoadOptions& options)
{
    DiagnosticSink diagnostics(path);
    const ObjText text = readFile(path, options.peerMesh ? ObjPositions::Float32 : ObjPositions::Double, diagnostics);
    if (diagnostics.hasErrors())
        return {std::nullopt, diagnostics.take()};

    Scene scene;
    scene.id = path;
    scene.title = QFileInfo(readablePath(path)).completeBaseName();
    if (!options.texture.isEmpty()) {
        TextureLoad texture = loadTexture(options.texture);
        if (!texture.texture)
            return {std::nullopt, {{Severity::Error, options.texture, 0, *texture.problem}}};
        scene.textures.push_back(std::move(*texture.texture));
        if (texture.opacity && !options.peerMesh)
            scene.textures.push_back(std::move(*texture.opacity));
    }
    Diagnostics ofOthers;
    if (options.peerMesh)
        fillPeerScene(text, scene);
    else
        ofOthers = fillScene(text, path, options, diagnostics, scene);
    Diagnostics all = diagnostics.take();
    append(all, std::move(ofOthers));
    return {std::move(scene), std::move(all)};
}

} // namespace rasterlens
