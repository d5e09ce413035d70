#include "core/pipeline/framebuffer.h"

#include "core/base/pieces.h"
#include "core/pipeline/shading.h"

#include <algorithm>
#include <array>
#include <cmath>
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

/// The samples of a pixel, one bit each, that do not belong to the face drawn last in it: taken as black, they make the
/// mean the colour of that face times the part of the pixel it covers.
std::uint32_t samplesOfEarlierFaces(const SampleBuffer& samples, const Rules& rules, int x, int y)
{
    const auto idOf = [&](int sample) { return samples.ids[readIndex(rules, x, y, sample)]; };
    std::int32_t last = -1;
    for (int sample = 0; sample < rules.samplesPerPixel(); ++sample)
        last = std::max(last, idOf(sample));
    std::uint32_t earlier = 0;
    for (int sample = 0; sample < rules.samplesPerPixel(); ++sample)
        if (idOf(sample) != last)
            earlier |= 1U << sample;
    return earlier;
}

std::array<double, 256> lightsOfValues()
{
    std::array<double, 256> lights{};
    for (std::size_t i = 0; i < lights.size(); ++i)
        lights[i] = lightOfValue(static_cast<std::uint32_t>(i));
    return lights;
}

/// The value whose light is nearest to this one.
std::uint32_t valueOfLight(double light, const std::array<double, 256>& lights)
{
    const auto above = std::ranges::lower_bound(lights, light);
    const auto i = static_cast<std::uint32_t>(above - lights.begin());
    if (above == lights.end())
        return 255;
    return i > 0 && light - lights[i - 1] < *above - light ? i - 1 : i;
}

} // namespace

double lightOfValue(std::uint32_t channel)
{
    const double value = channel / 255.0;
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

std::uint32_t meanColor(std::span<const std::uint32_t> colors, ResolveLight light)
{
    static const std::array<double, 256> lights = lightsOfValues();
    const auto count = static_cast<std::uint32_t>(colors.size());
    const auto channel = [&](int shift) {
        std::uint32_t values = count / 2;
        double sum = 0;
        for (const std::uint32_t color : colors) {
            values += color >> shift & 255U;
            sum += lights[color >> shift & 255U];
        }
        return light == ResolveLight::Gamma ? values / count : valueOfLight(sum / count, lights);
    };
    return 0xff000000U | channel(16) << 16 | channel(8) << 8 | channel(0);
}

ResolvedPixel resolvedPixel(const SampleBuffer& samples, const Rules& rules, int x, int y)
{
    ResolvedPixel pixel;
    pixel.x = x;
    pixel.y = y;
    pixel.count = rules.samplesPerPixel();
    pixel.isPattern = rules.multiSampled();
    pixel.light = rules.resolveLight;
    for (int sample = 0; sample < pixel.count; ++sample) {
        const std::size_t at = readIndex(rules, x, y, sample);
        const float depth = samples.depth != nullptr ? samples.depth[at] : rules.depthClear;
        pixel.samples[static_cast<std::size_t>(sample)] = {samples.color[at], depth};
    }
    if (rules.resolve == Resolve::LastFace)
        pixel.black = samplesOfEarlierFaces(samples, rules, x, y);
    std::array<std::uint32_t, ResolvedPixel::kMostSamples> colors{};
    for (int sample = 0; sample < pixel.count; ++sample)
        colors[static_cast<std::size_t>(sample)] = pixel.counted(sample);
    pixel.color = meanColor(std::span(colors).first(static_cast<std::size_t>(pixel.count)), rules.resolveLight);
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
    if (outputs.coverage || outputs.sampleCoverage || rules.shading == Shading::Overdraw)
        m_samples.coverage = cleared(direct ? frame.coverage : m_coverage, count, std::uint16_t(0), stop);
}

bool Framebuffer::isDirect() const { return m_rules.samplesPerPixel() == 1 && m_samples.stride == m_samples.columns; }

std::size_t Framebuffer::sampleCount() const
{
    return static_cast<std::size_t>(m_samples.rows) *
           static_cast<std::size_t>(std::max(m_samples.columns, m_samples.stride)) *
           static_cast<std::size_t>(m_rules.patternSamples);
}

void Framebuffer::resolve(const ResolveListener& listener)
{
    if (m_outputs.picture && m_rules.shading == Shading::Overdraw)
        for (std::size_t i = 0, n = sampleCount(); i < n; ++i)
            m_samples.color[i] = overdrawColor(m_samples.coverage[i]);
    const int grid = m_rules.sampleGrid;
    if (!isDirect()) {
        const bool isPlainMean = m_rules.resolve == Resolve::AllSamples && m_rules.resolveLight == ResolveLight::Gamma;
        if (m_outputs.picture && (listener || !isPlainMean || m_rules.multiSampled()))
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
    takeSampleCoverage();
    if (!m_outputs.depth)
        m_frame->depth.clear();
    if (!m_outputs.ids)
        m_frame->ids.clear();
    if (!m_outputs.coverage)
        m_frame->coverage.clear();
}

/// The counts of the first samples of all pixels, then those of the second ones, and so on.
void Framebuffer::takeSampleCoverage()
{
    std::vector<std::uint16_t>& out = m_frame->sampleCoverage;
    out.clear();
    if (!m_outputs.sampleCoverage)
        return;
    const std::vector<std::uint16_t>& samples = isDirect() ? m_frame->coverage : m_coverage;
    for (int sample = 0; sample < m_rules.samplesPerPixel(); ++sample)
        for (int y = 0; y < m_rules.height; ++y)
            for (int x = 0; x < m_rules.width; ++x)
                out.push_back(samples[readIndex(m_rules, x, y, sample)]);
}

void Framebuffer::resolveColor()
{
    auto* out = reinterpret_cast<std::uint32_t*>(m_frame->image.bits());
    for (int y = 0; y < m_rules.height; ++y)
        for (int x = 0; x < m_rules.width; ++x)
            *out++ = meanOfSamples(m_rules.sampleGrid, x, y, [&](int column, int row) {
                return m_color[static_cast<std::size_t>(row) * static_cast<std::size_t>(m_samples.columns) +
                               static_cast<std::size_t>(column)];
            });
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
