#include "core/io/obj_materials.h"

#include <QFileInfo>

#include <algorithm>
#include <iterator>

namespace rasterlens
{
namespace
{

constexpr glm::vec3 kDefaultDiffuse{0.8F, 0.7F, 0.6F};

std::string_view viewOf(const QByteArray& bytes) { return {bytes.data(), static_cast<std::size_t>(bytes.size())}; }

/// Where a file of the OBJ's own name would be.
QString mtlOfSameName(const QString& objPath) { return QFileInfo(objPath).completeBaseName() + QStringLiteral(".mtl"); }

bool isByBlender(const QByteArray& mtl) { return mtl.left(100).contains("Blender"); }

} // namespace

void ObjMaterials::loadLibraries(const ObjText& text)
{
    for (const ObjReference& library : text.libraries)
        loadReference(library);
    if (!text.libraries.empty() || text.materialUses.empty() ||
        loadLibraryOfSameName(QT_TRANSLATE_NOOP("Diagnostic", "no mtllib names a file"), 0))
        return;
    m_libraryMissing = true;
    std::set<QByteArray> names;
    for (const ObjReference& use : text.materialUses)
        names.insert(use.name);
    m_objDiagnostics.warning(
        text.materialUses.front().line,
        {QT_TRANSLATE_NOOP("Diagnostic",
                           "usemtl: no mtllib says what the %1 materials are; all look like the default one"),
         {names.size()}});
}

/// A name may hold blanks; otherwise `mtllib` takes several names.
void ObjMaterials::loadReference(const ObjReference& library)
{
    std::string_view rest = viewOf(library.name);
    const NamedFile whole = findNamedFile(m_objPath, rest, m_reach);
    if (whole.isFound() || library.name.contains('"')) {
        remarkOn(whole, "mtllib", library.line, m_objDiagnostics);
        loadLibrary(whole, library.line);
        return;
    }
    for (std::string_view word = nextWord(rest); !word.empty(); word = nextWord(rest)) {
        const NamedFile file = findNamedFile(m_objPath, word, m_reach);
        remarkOn(file, "mtllib", library.line, m_objDiagnostics);
        loadLibrary(file, library.line);
    }
}

void ObjMaterials::loadLibrary(const NamedFile& file, int line)
{
    const QString& path = file.path;
    if (m_read.contains(path))
        return;
    m_read.insert(path);
    const QString readable = readablePath(path);
    const bool isOutside = file.foundBy == FoundBy::Outside;
    if (isOutside)
        Consent::refuse(m_objPath, path);
    InputBytes input = isOutside ? InputBytes{{}, outsideReason()} : readInput(path);
    if (input.problem) {
        const Reason why{QT_TRANSLATE_NOOP("Diagnostic", "mtllib %1: %2"), {readable, *input.problem}};
        if (loadLibraryOfSameName(why, line))
            return;
        m_libraryMissing = true;
        m_objDiagnostics.warning(line, {QT_TRANSLATE_NOOP("Diagnostic", "mtllib %1: %2; the default material is used"),
                                        {readable, *input.problem}});
        return;
    }
    DiagnosticSink diagnostics(path);
    if (isByBlender(input.bytes))
        diagnostics.note(1, QT_TRANSLATE_NOOP("Diagnostic",
                                              "Blender writes Kd as linear light and vertex colours as they are shown; "
                                              "here both are shown as they stand, so Kd looks darker than in Blender"));
    std::set<QByteArray> ofThisFile;
    for (const MtlMaterial& material : parseMtl(std::move(input.bytes), path, m_reach, diagnostics)) {
        if (ofThisFile.contains(material.nameBytes))
            diagnostics.warning(
                material.line,
                {QT_TRANSLATE_NOOP("Diagnostic", "newmtl: %1 comes a second time; the first one is used"),
                 {quotedWord(viewOf(material.nameBytes))}});
        ofThisFile.insert(material.nameBytes);
        if (!m_library.contains(material.nameBytes)) {
            m_library.emplace(material.nameBytes, material);
            m_nameOfReadable.insert_or_assign(material.name, material.nameBytes);
        }
        const qsizetype comment = material.name.indexOf(QStringLiteral(" # "));
        const QString withoutComment = material.name.left(std::max<qsizetype>(comment, 0)).trimmed();
        if (!withoutComment.isEmpty() && !m_nameOfReadable.contains(withoutComment))
            m_nameOfReadable.emplace(withoutComment, material.nameBytes);
    }
    Diagnostics remarks = diagnostics.take();
    m_otherDiagnostics.insert(m_otherDiagnostics.end(), std::make_move_iterator(remarks.begin()),
                              std::make_move_iterator(remarks.end()));
}

/// An OBJ and its MTL that were renamed together. False where there is no such file.
bool ObjMaterials::loadLibraryOfSameName(const Reason& why, int line)
{
    const QByteArray name = bytesOfPath(mtlOfSameName(m_objPath));
    const NamedFile file = findNamedFile(m_objPath, viewOf(name), m_reach);
    if (!file.isFound() || m_read.contains(file.path))
        return false;
    m_objDiagnostics.warning(line, {QT_TRANSLATE_NOOP("Diagnostic", "%1; %2 beside it is read"),
                                    {why, QFileInfo(readablePath(file.path)).fileName()}});
    loadLibrary(file, line);
    return true;
}

/// By its bytes, else by its text where OBJ and MTL have two encodings, else without what may be a comment.
const MtlMaterial* ObjMaterials::find(const QByteArray& name) const
{
    if (const auto found = m_library.find(name); found != m_library.end())
        return &found->second;
    if (const auto bytes = m_nameOfReadable.find(readableName(viewOf(name))); bytes != m_nameOfReadable.end())
        return &m_library.find(bytes->second)->second;
    const qsizetype comment = name.indexOf(" #");
    return comment > 0 ? find(name.left(comment).trimmed()) : nullptr;
}

std::uint32_t ObjMaterials::use(const ObjReference& reference)
{
    if (const auto known = m_used.find(reference.name); known != m_used.end())
        return known->second;
    const MtlMaterial* const found = find(reference.name);
    if (found == nullptr && !m_libraryMissing)
        m_objDiagnostics.warning(
            reference.line,
            {QT_TRANSLATE_NOOP("Diagnostic", "usemtl: no material %1 in the MTL files; the default material is used"),
             {quotedWord(viewOf(reference.name))}});
    std::uint32_t index = 0;
    if (found == nullptr)
        index = useDefault();
    else if (const auto same = m_used.find(found->nameBytes); same != m_used.end())
        index = same->second;
    else
        index = add(*found);
    m_used.insert_or_assign(reference.name, index);
    if (found != nullptr)
        m_used.insert_or_assign(found->nameBytes, index);
    return index;
}

/// The material of faces that name none.
std::uint32_t ObjMaterials::useDefault()
{
    if (!m_default)
        m_default = add(MtlMaterial{});
    return *m_default;
}

std::vector<std::uint32_t> ObjMaterials::ofFaces(const ObjText& text)
{
    std::vector<std::uint32_t> materials;
    materials.reserve(text.faces.size());
    int lastUse = -2;
    std::uint32_t material = 0;
    for (const ObjFace& face : text.faces) {
        if (face.materialUse != lastUse) {
            lastUse = face.materialUse;
            material = lastUse < 0 ? useDefault() : use(text.materialUses[static_cast<std::size_t>(lastUse)]);
        }
        materials.push_back(material);
    }
    return materials;
}

std::uint32_t ObjMaterials::add(const MtlMaterial& mtl)
{
    Material material;
    material.name = mtl.name;
    m_textures.dress(mtl, material, m_otherDiagnostics);
    const bool ownColor = material.texture >= 0 || m_vertexColors;
    material.diffuse = mtl.diffuse.value_or(ownColor ? glm::vec3(1) : kDefaultDiffuse);
    material.specular = mtl.specular;
    material.shininess = mtl.shininess.value_or(material.shininess);
    m_scene.materials.push_back(std::move(material));
    return static_cast<std::uint32_t>(m_scene.materials.size() - 1);
}

} // namespace rasterlens
