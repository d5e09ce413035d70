// Pictures as textures and as students' answers: the first byte chooses the suffix, the rest is the file.
#include "core/io/texture_loader.h"
#include "tests/fuzz/target.h"

#include <array>

using namespace rasterlens;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    if (size == 0)
        return 0;
    constexpr std::array kNames{"a.tga", "a.png", "a.bmp", "a.ppm", "a.jpg"};
    const PictureLoad picture =
        pictureFrom(QByteArray(reinterpret_cast<const char*>(data + 1), static_cast<qsizetype>(size - 1)),
                    QString::fromLatin1(kNames[data[0] % kNames.size()]));
    fuzz::require(picture.image.isNull() == picture.problem.has_value(), "there is either a picture or a problem");
    if (picture.problem)
        fuzz::require(!textOf(*picture.problem).isEmpty(), "a problem is a sentence");
    return 0;
}
