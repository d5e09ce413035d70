// Hard cases: the text of a `.case` file. What is read is drawn.
#include "core/io/case_file.h"
#include "tests/fuzz/frames.h"

using namespace rasterlens;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const SceneLoad load = parseCase(fuzz::bytesOf(data, size), QStringLiteral("fuzz.case"));
    fuzz::requireReason(load.scene, load.diagnostics);
    if (!load.scene)
        return 0;
    fuzz::requireSound(*load.scene);
    fuzz::requireDrawn(*load.scene, load.scene->defaults);
    return 0;
}
