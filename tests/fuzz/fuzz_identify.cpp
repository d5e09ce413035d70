// A student's picture against a small scene, and against the right picture: the first byte chooses the width, the rest
// are pixels, two bits a channel.
#include "core/questions/identify.h"
#include "core/scenes/builtin_scenes.h"
#include "core/truth/difference.h"
#include "tests/fuzz/target.h"

#include <algorithm>

using namespace rasterlens;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const Scene scene = *makeBuiltinScene(QStringLiteral("square-diagonal")).scene;
    if (size < 2)
        return 0;
    const int width = 1 + data[0] % 24;
    const int height = std::min(24, static_cast<int>((size - 1 + std::size_t(width) - 1) / std::size_t(width)));
    QImage picture(width, height, QImage::Format_RGB32);
    fuzz::Bytes bytes(data + 1, size - 1);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const int pixel = bytes.byte();
            const auto channel = [pixel](int shift) { return (pixel >> shift & 3) * 85; };
            picture.setPixel(x, y, qRgb(channel(4), channel(2), channel(0)));
        }
    const Difference itself = difference(picture, picture);
    fuzz::require(itself.differing == 0 && itself.pixels == std::uint64_t(width) * std::uint64_t(height),
                  "a picture equals itself");
    (void)heatMap(picture, picture.mirrored());
    const Settings& settings = scene.defaults;
    if (whyNotIdentified(picture, settings))
        return 0;
    const Identification found = identify(scene, settings, picture);
    fuzz::require(!found.matches.empty(), "there are matches");
    for (const MistakeMatch& match : found.matches)
        fuzz::require(match.score >= 0 && match.score <= 1, "scores are 0..1");
    fuzz::require(std::ranges::is_sorted(found.matches, std::ranges::greater{}, &MistakeMatch::score),
                  "the best match is first");
    return 0;
}
