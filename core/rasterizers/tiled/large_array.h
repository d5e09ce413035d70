#pragma once
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace rasterlens::tiled
{

/// Uninitialised memory that only grows, in pages of 2 MiB where the system has them: scattered reads and writes of
/// tens of megabytes would spend most of their time in looking pages up.
template <class T>
class LargeArray
{
public:
    /// out  room for `count` values; what was there is gone if it had to grow
    T* reserve(std::size_t count)
    {
        if (count > m_capacity)
            allocate(count);
        return m_memory.get();
    }

    [[nodiscard]] T* data() const { return m_memory.get(); }

private:
    static_assert(std::is_trivially_destructible_v<T>);
    static constexpr std::size_t kPage = std::size_t(2) << 20;

    struct Free {
        void operator()(T* memory) const { std::free(memory); }
    };

    void allocate(std::size_t count)
    {
        m_memory.reset();
        const std::size_t bytes = (count * sizeof(T) + kPage - 1) / kPage * kPage;
        void* memory = std::aligned_alloc(kPage, bytes);
        if (memory == nullptr)
            throw std::bad_alloc();
#ifdef __linux__
        madvise(memory, bytes, MADV_HUGEPAGE); // a wish: nothing is lost if it is not granted
#endif
        m_memory.reset(static_cast<T*>(memory));
        m_capacity = bytes / sizeof(T);
    }

    std::unique_ptr<T, Free> m_memory;
    std::size_t m_capacity = 0;
};

} // namespace rasterlens::tiled
