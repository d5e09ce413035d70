#pragma once
#include "core/base/large_pages.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rasterlens
{

/// The depths of a frame, 0..1, row by row from the top. It is read like a constant vector. Each time it may have been
/// written to, its key() changes, so the tiled algorithm can tell whether it is still as its last frame left it.
class DepthBuffer
{
public:
    using value_type = float;

    [[nodiscard]] std::size_t size() const { return m_depths.size(); }
    [[nodiscard]] bool empty() const { return m_depths.empty(); }
    [[nodiscard]] const float* data() const { return m_depths.data(); }
    [[nodiscard]] const float* begin() const { return data(); }
    [[nodiscard]] const float* end() const { return data() + size(); }
    [[nodiscard]] float operator[](std::size_t pixel) const { return m_depths[pixel]; }

    /// out  so many depths, as many of the old ones as there is room for first; to be written to until the next call
    [[nodiscard]] float* write(std::size_t count);
    void assign(std::size_t count, float depth);
    void clear() { assign(0, 0); }

    /// Equal keys mean equal depths, also of different planes.
    [[nodiscard]] std::uint64_t key() const { return m_key; }

    friend bool operator==(const DepthBuffer& a, const DepthBuffer& b) { return a.m_depths == b.m_depths; }

private:
    std::vector<float, LargePages<float>> m_depths;
    std::uint64_t m_key = 0;
};

} // namespace rasterlens
