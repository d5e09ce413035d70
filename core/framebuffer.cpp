#include "core/framebuffer.h"

#include "core/pipeline/shading.h"

#include <algorithm>

namespace rasterlens
{
namespace
{

template <class T>
T* cleared(std::vector<T>& plane, std::size_t count, T value)
{
    plane.assign(count, value);
    return plane.data();
}

/// Of an N x N grid of samples, the one nearest the pixel's centre (the lower right of the middle four if N is even).
template <class T>
void pickCentres(const std::vector<T>& samples, std::vector<T>& pixels, int width, int height, int grid)
{
    pixels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    std::size_t pixel = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            pixels[pixel++] =
                samples[static_cast<std::size_t>(y * grid + grid / 2) * static_cast<std::size_t>(width * grid) +
                        static_cast<std::size_t>(x * grid + grid / 2)];
}

} // namespace

std::uint32_t meanOfSamples(const std::uint32_t* color, int columns, int grid, int x, int y)
{
    const auto samplesPerPixel = static_cast<std::uint32_t>(grid * grid);
    std::uint32_t red = samplesPerPixel / 2;
    std::uint32_t green = red;
    std::uint32_t blue = red;
    for (int j = 0; j < grid; ++j) {
        const std::uint32_t* row = color + std::size_t(y * grid + j) * std::size_t(columns) + std::size_t(x * grid);
        for (int i = 0; i < grid; ++i) {
            red += row[i] >> 16 & 255U;
            green += row[i] >> 8 & 255U;
            blue += row[i] & 255U;
        }
    }
    return 0xff000000U | red / samplesPerPixel << 16 | green / samplesPerPixel << 8 | blue / samplesPerPixel;
}

Framebuffer::Framebuffer(Frame& frame, const Rules& rules, Outputs outputs, std::uint32_t clearColor)
    : m_frame(&frame), m_rules(rules), m_outputs(outputs)
{
    if (frame.image.size() != QSize(rules.width, rules.height) || frame.image.format() != QImage::Format_RGB32)
        frame.image = QImage(rules.width, rules.height, QImage::Format_RGB32);
    m_samples.columns = rules.columns();
    m_samples.rows = rules.rows();
    const std::size_t count = m_samples.index(0, m_samples.rows);
    const bool direct = rules.sampleGrid == 1;
    if (direct) {
        m_samples.color = reinterpret_cast<std::uint32_t*>(frame.image.bits());
        std::fill_n(m_samples.color, count, clearColor);
    } else {
        m_samples.color = cleared(m_color, count, clearColor);
    }
    if (outputs.depth || rules.depthTested)
        m_samples.depth = cleared(direct ? frame.depth : m_depth, count, rules.depthClear);
    if (outputs.ids)
        m_samples.ids = cleared(direct ? frame.ids : m_ids, count, std::int32_t(-1));
    if (outputs.coverage || rules.shading == Shading::Overdraw)
        m_samples.coverage = cleared(direct ? frame.coverage : m_coverage, count, std::uint16_t(0));
}

void Framebuffer::resolve()
{
    if (m_rules.shading == Shading::Overdraw)
        for (std::size_t i = 0, n = m_samples.index(0, m_samples.rows); i < n; ++i)
            m_samples.color[i] = overdrawColor(m_samples.coverage[i]);
    const int grid = m_rules.sampleGrid;
    if (grid > 1) {
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
            *out++ = meanOfSamples(m_color.data(), m_samples.columns, m_rules.sampleGrid, x, y);
}

} // namespace rasterlens
