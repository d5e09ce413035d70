#pragma once
#include "core/pipeline/depth_buffer.h"
#include "core/pipeline/frame.h"
#include "core/pipeline/observer.h"
#include "core/settings/rules.h"

#include <cstdint>
#include <functional>
#include <span>
#include <stop_token>
#include <vector>

namespace rasterlens
{

/// The samples of one frame: what fragments are written to, before the box filter makes pixels of them.
/// Planes that were not asked for are null.
struct SampleBuffer {
    int columns = 0;
    int rows = 0;
    int stride = 0;                 ///< samples from one row to the next
    std::uint32_t* color = nullptr; ///< 0xffRRGGBB
    float* depth = nullptr;
    std::int32_t* ids = nullptr;
    std::uint16_t* coverage = nullptr;

    [[nodiscard]] std::size_t index(int x, int y) const
    {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(stride) + static_cast<std::size_t>(x);
    }

    /// Multi-sampling: where a sample of the pattern of pixel (x, y) is stored. The frames of the samples follow each
    /// other.
    [[nodiscard]] std::size_t index(int x, int y, int sample) const
    {
        return static_cast<std::size_t>(sample) * static_cast<std::size_t>(stride) * static_cast<std::size_t>(rows) +
               index(x, y);
    }
};

/// Where the i-th sample of pixel (x, y) is read from: on a grid row by row, in a pattern in its order.
[[nodiscard]] inline std::size_t readIndex(const Rules& rules, int x, int y, int i)
{
    const auto columns = static_cast<std::size_t>(rules.columns());
    if (rules.multiSampled())
        return (static_cast<std::size_t>(i) * static_cast<std::size_t>(rules.rows()) + static_cast<std::size_t>(y)) *
                   columns +
               static_cast<std::size_t>(x);
    const int grid = rules.sampleGrid;
    return static_cast<std::size_t>(y * grid + i / grid) * columns + static_cast<std::size_t>(x * grid + i % grid);
}

/// The light that a display makes of a channel of 0..255: 0..1.
///
/// source  IEC 61966-2-1 (sRGB)
[[nodiscard]] double lightOfValue(std::uint32_t channel);

/// The mean of colours as the rules want it, channel by channel, rounded to nearest: of the values, or of the light
/// that a display makes of them.
///
/// in   at least one colour
[[nodiscard]] std::uint32_t meanColor(std::span<const std::uint32_t> colors, ResolveLight light);

/// The mean of the samples of pixel (x, y) on a grid, of their values, channel by channel, rounded to nearest.
template <class ColorAt>
[[nodiscard]] std::uint32_t meanOfSamples(int grid, int x, int y, ColorAt&& colorAt)
{
    const auto samplesPerPixel = static_cast<std::uint32_t>(grid * grid);
    std::uint32_t red = samplesPerPixel / 2;
    std::uint32_t green = red;
    std::uint32_t blue = red;
    for (int j = 0; j < grid; ++j)
        for (int i = 0; i < grid; ++i) {
            const std::uint32_t color = colorAt(x * grid + i, y * grid + j);
            red += color >> 16 & 255U;
            green += color >> 8 & 255U;
            blue += color & 255U;
        }
    return 0xff000000U | red / samplesPerPixel << 16 | green / samplesPerPixel << 8 | blue / samplesPerPixel;
}

/// What the samples of pixel (x, y) store, row by row or in the order of the pattern, and the colour that the picture
/// has of them.
///
/// in  samples with colours and, under Resolve::LastFace, ids
[[nodiscard]] ResolvedPixel resolvedPixel(const SampleBuffer& samples, const Rules& rules, int x, int y);

/// Owns the memory of a frame while it is drawn. With one sample a pixel the samples are the frame's own arrays.
class Framebuffer
{
public:
    /// Clears everything that `rules` and `outputs` call for; memory of an earlier frame of that size is used again.
    ///
    /// errors  throws std::bad_alloc; `stop` ends the clearing early. Planes that are not finished are null then, and
    ///         nothing may be drawn
    Framebuffer(Frame& frame, const Rules& rules, Outputs outputs, std::uint32_t clearColor,
                const std::stop_token& stop = {});

    [[nodiscard]] const SampleBuffer& samples() const { return m_samples; }

    /// A function that is told of each pixel what samples it has and what colour the picture has of them.
    using ResolveListener = std::function<void(const ResolvedPixel&)>;

    /// Finishes the picture: overdraw colours, box filter, and the sample nearest the centre for the other outputs.
    ///
    /// in  a listener, or nothing
    void resolve(const ResolveListener& listener = {});

private:
    void resolveColor();
    void resolveColorOneByOne(const ResolveListener& listener);
    [[nodiscard]] bool isDirect() const;
    [[nodiscard]] std::size_t sampleCount() const;
    void takeSampleCoverage();

    Frame* m_frame;
    Rules m_rules;
    Outputs m_outputs;
    SampleBuffer m_samples;
    std::vector<std::uint32_t> m_color;
    DepthBuffer m_depth;
    std::vector<std::int32_t> m_ids;
    std::vector<std::uint16_t> m_coverage;
};

} // namespace rasterlens
