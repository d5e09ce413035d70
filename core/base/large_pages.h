#pragma once
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace rasterlens
{

/// Allocates memory of megabytes in pages of 2 MiB where the system has them: the rows of a tile, or scattered records,
/// lie in as many small pages, which would all have to be looked up.
template <class T>
struct LargePages {
    using value_type = T;

    LargePages() = default;
    template <class Other>
    LargePages(const LargePages<Other>&)
    {
    }

    T* allocate(std::size_t count)
    {
        constexpr std::size_t kPage = std::size_t(2) << 20;
        constexpr std::size_t kCacheLine = 64;
        static_assert(alignof(T) <= kCacheLine);
        const bool large = count > kPage / 2 / sizeof(T);
        const std::size_t unit = large ? kPage : kCacheLine;
        constexpr std::size_t kMostBytes = static_cast<std::size_t>(std::numeric_limits<std::ptrdiff_t>::max()) - kPage;
        if (count > kMostBytes / sizeof(T))
            throw std::bad_array_new_length();
        const std::size_t bytes = (count * sizeof(T) + unit - 1) / unit * unit;
        void* memory = std::aligned_alloc(unit, bytes);
        if (memory == nullptr)
            throw std::bad_alloc();
#ifdef __linux__
        if (large)
            madvise(memory, bytes, MADV_HUGEPAGE); // a wish: nothing is lost if it is not granted
#endif
        return static_cast<T*>(memory);
    }

    void deallocate(T* memory, std::size_t) { std::free(memory); }

    friend bool operator==(LargePages, LargePages) { return true; }
};

} // namespace rasterlens
