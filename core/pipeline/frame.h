#pragma once
#include "core/pipeline/depth_buffer.h"
#include "core/pipeline/statistics.h"

#include <QImage>

#include <cstdint>
#include <memory>
#include <vector>

namespace rasterlens
{

struct TiledContext;

/// What a frame is asked for. Nothing that is not asked for is written, and without a picture nothing is shaded.
struct Outputs {
    bool depth = false;
    bool ids = false;
    bool coverage = false;
    bool picture = true;
    bool sampleCoverage = false;
};

/// A finished picture. All arrays are row by row from the top, width * height of the image.
struct Frame {
    QImage image;                  ///< Format_RGB32; null if not asked for
    DepthBuffer depth;             ///< depth buffer, 0..1; with several samples that of the sample nearest the centre
    std::vector<std::int32_t> ids; ///< face written last, -1 none; sample as for depth
    std::vector<std::uint16_t> coverage; ///< faces that covered that sample, before the depth test
    /// Faces that covered each sample: all first samples of the pixels, then all second ones, and so on.
    std::vector<std::uint16_t> sampleCoverage;
    StageTimes times;
    std::shared_ptr<TiledContext> tiled; ///< threads and memory of the tiled algorithm, for the next picture
};

} // namespace rasterlens
