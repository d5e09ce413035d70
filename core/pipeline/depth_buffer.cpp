#include "core/pipeline/depth_buffer.h"

#include <atomic>

namespace rasterlens
{
namespace
{

std::uint64_t newKey()
{
    static std::atomic<std::uint64_t> last = 0;
    return ++last;
}

} // namespace

float* DepthBuffer::write(std::size_t count)
{
    m_key = newKey();
    m_depths.resize(count);
    return m_depths.data();
}

void DepthBuffer::assign(std::size_t count, float depth)
{
    m_key = newKey();
    m_depths.assign(count, depth);
}

} // namespace rasterlens
