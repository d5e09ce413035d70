// OBJ and MTL: the input is an OBJ file and, behind a line `#MTL`, the material file `m.mtl`.
#include "core/io/obj_loader.h"
#include "tests/fuzz/frames.h"

using namespace rasterlens;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const QByteArray all = fuzz::bytesOf(data, size);
    const QByteArray kBetween = "\n#MTL\n";
    const qsizetype at = all.indexOf(kBetween);
    const QString path = fuzz::fileOf(at < 0 ? all : all.left(at), "scene.obj");
    fuzz::fileOf(at < 0 ? QByteArray() : all.mid(at + kBetween.size()), "m.mtl");
    const SceneLoad load = loadObj(path);
    fuzz::requireReason(load.scene, load.diagnostics);
    if (!load.scene)
        return 0;
    fuzz::require(load.scene->mesh.faceCount() > 0, "a model without faces is an error");
    fuzz::requireSound(*load.scene);
    fuzz::requireDrawn(*load.scene, load.scene->defaults);
    return 0;
}
