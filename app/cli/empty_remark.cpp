#include "app/cli/empty_remark.h"

#include "core/base/diagnostics.h"
#include "core/questions/empty_picture.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <functional>

namespace rasterlens::cli
{
namespace
{

template <class Values>
bool isUniform(const Values& values)
{
    return std::adjacent_find(values.begin(), values.end(), std::not_equal_to<>()) == values.end();
}

bool isUniform(const QImage& image)
{
    const auto bytes = static_cast<std::size_t>(image.width()) * sizeof(QRgb);
    const auto* first = reinterpret_cast<const QRgb*>(image.constScanLine(0));
    if (!std::all_of(first, first + image.width(), [&](QRgb pixel) { return pixel == *first; }))
        return false;
    for (int y = 1; y < image.height(); ++y)
        if (std::memcmp(image.constScanLine(y), first, bytes) != 0)
            return false;
    return true;
}

/// Cheap to see, and true of every empty picture, though of some others, too.
bool mayBeEmpty(const Frame& frame, const Outputs& outputs)
{
    return (!outputs.picture || isUniform(frame.image)) && (!outputs.ids || isUniform(frame.ids)) &&
           (!outputs.coverage || isUniform(frame.coverage)) && (!outputs.depth || isUniform(frame.depth));
}

} // namespace

void remarkIfEmpty(const Scene& scene, const Settings& settings, const Frame& frame, const Outputs& outputs)
{
    if (!mayBeEmpty(frame, outputs))
        return;
    if (const auto empty = whyEmpty(scene, settings)) {
        const Diagnostic remark{Severity::Warning, scene.id, 0, sentenceOf(*empty, empty->option)};
        std::fprintf(stderr, "%s\n", qUtf8Printable(remark.text()));
    }
}

} // namespace rasterlens::cli
