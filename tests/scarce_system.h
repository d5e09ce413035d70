#pragma once
// A system that has no memory or no threads for the background: included by one source of a test, whose allocations and
// threads it counts and refuses. The thread of the window always gets what it asks for, and so do the threads that Qt
// paints large areas with: Qt itself ends the program where those get none.
#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <new>

#include <QThread>

#include <dlfcn.h>
#include <pthread.h>

namespace rasterlens::test
{

inline const pthread_t windowThread = pthread_self(); ///< globals are made by the first thread
inline std::atomic<int> allocationsLeft = std::numeric_limits<int>::max();
inline std::atomic<int> allocationsRefused = 0;
inline std::atomic<bool> threadsRefused = false;

/// Lets so many allocations of background threads succeed, and none after them.
inline void refuseMemoryAfter(int allocations)
{
    allocationsRefused = 0;
    allocationsLeft = allocations;
}

inline void giveMemory() { allocationsLeft = std::numeric_limits<int>::max(); }

/// A thread of Qt's own pool. Asking allocates in threads that Qt does not know yet; that is let through.
inline bool isPaintingThread()
{
    thread_local bool known = false;
    thread_local bool painting = true;
    if (!known) {
        known = true;
        painting = QThread::currentThread()->inherits("QThreadPoolThread");
    }
    return painting;
}

inline bool mayAllocate()
{
    if (allocationsLeft == std::numeric_limits<int>::max() || pthread_equal(pthread_self(), windowThread) ||
        isPaintingThread())
        return true;
    if (--allocationsLeft >= 0)
        return true;
    ++allocationsRefused;
    return false;
}

inline void* allocate(std::size_t size, std::size_t alignment)
{
    void* memory = nullptr;
    if (!mayAllocate() || posix_memalign(&memory, std::max(alignment, sizeof(void*)), size) != 0)
        return nullptr;
    return memory;
}

inline void* allocateOrThrow(std::size_t size, std::size_t alignment)
{
    if (void* memory = allocate(size, alignment))
        return memory;
    throw std::bad_alloc();
}

constexpr std::size_t kUsualAlignment = alignof(std::max_align_t);

} // namespace rasterlens::test

void* operator new(std::size_t size)
{
    return rasterlens::test::allocateOrThrow(size, rasterlens::test::kUsualAlignment);
}
void* operator new(std::size_t size, std::align_val_t a)
{
    return rasterlens::test::allocateOrThrow(size, std::size_t(a));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept
{
    return rasterlens::test::allocate(size, rasterlens::test::kUsualAlignment);
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

#if !RASTERLENS_SANITIZED // those have theirs
void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept
{
    return rasterlens::test::allocate(size, alignment);
}

extern "C" int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*start)(void*),
                              void* argument) noexcept
{
    using Create = int (*)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);
    static const auto create = reinterpret_cast<Create>(dlsym(RTLD_NEXT, "pthread_create"));
    return rasterlens::test::threadsRefused ? EAGAIN : create(thread, attributes, start, argument);
}
#endif
