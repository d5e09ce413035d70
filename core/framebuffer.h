#pragma once
#include "core/observe/observer.h"
#include "core/render.h"
#include "core/rules.h"

#include <cstdint>
#include <vector>

namespace rasterlens
{

/// The samples of one frame: what fragments are written to, before the box filter makes pixels of them.
/// Planes nobody asked for are null.
struct SampleBuffer {
    int columns = 0;
    int rows = 0;
    std::uint32_t* color = nullptr; ///< 0xffRRGGBB
    float* depth = nullptr;
    std::int32_t* ids = nullptr;
    std::uint16_t* coverage = nullptr;

    [[nodiscard]] std::size_t index(int x, int y) const
    {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(x);
    }
};

/// The mean of the samples of pixel (x, y), channel by channel, rounded to nearest.
[[nodiscard]] std::uint32_t meanOfSamples(const std::uint32_t* color, int columns, int grid, int x, int y);

/// Owns the memory of a frame while it is drawn. With one sample a pixel the samples are the frame's own arrays.
class Framebuffer
{
public:
    /// Clears everything that `rules` and `outputs` call for; memory of an earlier frame of that size is used again.
    Framebuffer(Frame& frame, const Rules& rules, Outputs outputs, std::uint32_t clearColor);

    [[nodiscard]] const SampleBuffer& samples() const { return m_samples; }

    /// Finishes the picture: overdraw colours, box filter, and the sample nearest the centre for the other outputs.
    void resolve();

private:
    void resolveColor();

    Frame* m_frame;
    Rules m_rules;
    Outputs m_outputs;
    SampleBuffer m_samples;
    std::vector<std::uint32_t> m_color;
    std::vector<float> m_depth;
    std::vector<std::int32_t> m_ids;
    std::vector<std::uint16_t> m_coverage;
};

} // namespace rasterlens
