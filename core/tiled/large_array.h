#pragma once
#include "core/base/large_pages.h"

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <type_traits>

namespace rasterlens::tiled
{

/// Uninitialised memory that only grows, in large pages.
template <class T>
class LargeArray
{
public:
    /// out  room for `count` values; what was there is gone if it had to grow
    T* reserve(std::size_t count)
    {
        if (count > m_capacity) {
            m_capacity = 0; // stays so if there is no memory
            m_memory.reset();
            m_memory.reset(LargePages<T>().allocate(count));
            m_capacity = count;
        }
        return m_memory.get();
    }

    [[nodiscard]] T* data() const { return m_memory.get(); }

private:
    static_assert(std::is_trivially_destructible_v<T>);

    struct Free {
        void operator()(T* memory) const { std::free(memory); }
    };

    std::unique_ptr<T, Free> m_memory;
    std::size_t m_capacity = 0;
};

} // namespace rasterlens::tiled
