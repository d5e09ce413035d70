#include "core/pipeline/framebuffer.h"

#include "core/base/pieces.h"
#include "core/pipeline/shading.h"

#include <algorithm>
#include <new>

namespace rasterlens
{
namespace
{

/// out  null if `stop` came first
template <class T>
T* cleared(std::vector<T>& plane, std::size_t count, T value, const std::stop_token& stop)
{
    return assignInPieces(plane, count, value, stop) ? plane.data() : nullptr;
}

float* cleared(DepthBuffer& plane, std::size_t count, float value, const std::stop_token& stop)
{
    if (stop.stop_requested())
        return nullptr;
    plane.assign(count, value);
    return plane.write(count);
}

template <class T>
T* resized(std::vector<T>& plane, std::size_t count)
{
    plane.resize(count);
    return plane.data();
}

float* resized(DepthBuffer& plane, std::size_t count) { return plane.write(count); }

/// Picks from each N x N grid of samples the one nearest the pixel's centre (the lower right of the middle four if N is
/// even).
template <class Plane>
void pickCentres(const Plane& samples, Plane& plane, int width, int height, int grid)
{
    auto* pixels = resized(plane, static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    std::size_t pixel = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            pixels[pixel++] =
                samples[static_cast<std::size_t>(y * grid + grid / 2) * static_cast<std::size_t>(width * grid) +
                        static_cast<std::size_t>(x * grid + grid / 2)];
}

/// Makes the frame's picture one of the right size, or none.
///
/// errors  throws std::bad_alloc; QImage itself would only be null
void sizePicture(Frame& frame, const Rules& rules, Outputs outputs)
{
    if (!outputs.picture)
        frame.image = QImage();
    else if (frame.image.size() != QSize(rules.width, rules.height) || frame.image.format() != QImage::Format_RGB32)
        frame.image = QImage(rules.width, rules.height, QImage::Format_RGB32);
    if (outputs.picture && frame.image.isNull())
        throw std::bad_alloc();
}

/// Where a sample is read from: what is stored elsewhere (rules.strideIsRows) is not found.
std::size_t readIndex(const SampleBuffer& samples, int x, int y)
{
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(samples.columns) + static_cast<std::size_t>(x);
}

/// The samples of a pixel, one bit each, that do not belong to the face drawn last in it: taken as black, they make the
/// mean the colour of that face times the part of the pixel it covers.
std::uint32_t samplesOfEarlierFaces(const SampleBuffer& samples, int grid, int x, int y)
{
    const auto idOf = [&](int sample) {
        return samples.ids[readIndex(samples, x * grid + sample % grid, y * grid + sample / grid)];
    };
    std::int32_t last = -1;
    for (int sample = 0; sample < grid * grid; ++sample)
        last = std::max(last, idOf(sample));
    std::uint32_t earlier = 0;
    for (int sample = 0; sample < grid * grid; ++sample)
        if (idOf(sample) != last)
            earlier |= 1U << sample;
    return earlier;
}

} // namespace

ResolvedPixel resolvedPixel(const SampleBuffer& samples, const Rules& rules, int x, int y)
{
    const int grid = rules.sampleGrid;
    ResolvedPixel pixel;
    pixel.x = x;
    pixel.y = y;
    for (int row = y * grid; row < (y + 1) * grid; ++row)
        for (int column = x * grid; column < (x + 1) * grid; ++column) {
            const std::size_t at = readIndex(samples, column, row);
            const float depth = samples.depth != nullptr ? samples.depth[at] : rules.depthClear;
            pixel.samples[static_cast<std::size_t>(pixel.count++)] = {samples.color[at], depth};
        }
    if (rules.resolve == Resolve::LastFace)
        pixel.black = samplesOfEarlierFaces(samples, grid, x, y);
    int sample = 0;
    pixel.color = meanOfSamples(grid, x, y, [&](int, int) { return pixel.counted(sample++); });
    return pixel;
}

Framebuffer::Framebuffer(Frame& frame, const Rules& rules, Outputs outputs, std::uint32_t clearColor,
                         const std::stop_token& stop)
    : m_frame(&frame), m_rules(rules), m_outputs(outputs)
{
    sizePicture(frame, rules, outputs);
    m_samples.columns = rules.columns();
    m_samples.rows = rules.rows();
    m_samples.stride = rules.strideIsRows ? rules.rows() : rules.columns();
    const std::size_t count = sampleCount();
    const bool direct = isDirect();
    if (outputs.picture && direct) {
        m_samples.color = reinterpret_cast<std::uint32_t*>(frame.image.bits());
        constexpr std::size_t kPiece = std::size_t(1) << 22;
        for (std::size_t i = 0; i < count && !stop.stop_requested(); i += kPiece)
            std::fill_n(m_samples.color + i, std::min(kPiece, count - i), clearColor);
    } else if (outputs.picture) {
        m_samples.color = cleared(m_color, count, clearColor, stop);
    }
    if (outputs.depth || rules.depthTested)
        m_samples.depth = cleared(direct ? frame.depth : m_depth, count, rules.depthClear, stop);
    if (outputs.ids || rules.resolve == Resolve::LastFace)
        m_samples.ids = cleared(direct ? frame.ids : m_ids, count, std::int32_t(-1), stop);
    if (outputs.coverage || rules.shading == Shading::Overdraw)
        m_samples.coverage = cleared(direct ? frame.coverage : m_coverage, count, std::uint16_t(0), stop);
}

bool Framebuffer::isDirect() const { return m_rules.sampleGrid == 1 && m_samples.stride == m_samples.columns; }

std::size_t Framebuffer::sampleCount() const
{
    return static_cast<std::size_t>(m_samples.rows) *
           static_cast<std::size_t>(std::max(m_samples.columns, m_samples.stride));
}

void Framebuffer::resolve(const ResolveListener& listener)
{
    if (m_outputs.picture && m_rules.shading == Shading::Overdraw)
        for (std::size_t i = 0, n = sampleCount(); i < n; ++i)
            m_samples.color[i] = overdrawColor(m_samples.coverage[i]);
    const int grid = m_rules.sampleGrid;
    if (!isDirect()) {
        if (m_outputs.picture && (listener || m_rules.resolve != Resolve::AllSamples))
            resolveColorOneByOne(listener);
        else if (m_outputs.picture)
            resolveColor();
        if (m_outputs.depth)
            pickCentres(m_depth, m_frame->depth, m_rules.width, m_rules.height, grid);
        if (m_outputs.ids)
            pickCentres(m_ids, m_frame->ids, m_rules.width, m_rules.height, grid);
        if (m_outputs.coverage)
            pickCentres(m_coverage, m_frame->coverage, m_rules.width, m_rules.height, grid);
    }
    if (!m_outputs.depth)
        m_frame->depth.clear();
    if (!m_outputs.ids)
        m_frame->ids.clear();
    if (!m_outputs.coverage)
        m_frame->coverage.clear();
}

void Framebuffer::resolveColor()
{
    auto* out = reinterpret_cast<std::uint32_t*>(m_frame->image.bits());
    for (int y = 0; y < m_rules.height; ++y)
        for (int x = 0; x < m_rules.width; ++x)
            *out++ = meanOfSamples(m_rules.sampleGrid, x, y,
                                   [&](int column, int row) { return m_color[readIndex(column, row)]; });
}

void Framebuffer::resolveColorOneByOne(const ResolveListener& listener)
{
    auto* out = reinterpret_cast<std::uint32_t*>(m_frame->image.bits());
    for (int y = 0; y < m_rules.height; ++y)
        for (int x = 0; x < m_rules.width; ++x) {
            const ResolvedPixel pixel = resolvedPixel(m_samples, m_rules, x, y);
            *out++ = pixel.color;
            if (listener)
                listener(pixel);
        }
}

} // namespace rasterlens
