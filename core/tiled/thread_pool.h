#pragma once
#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <type_traits>
#include <vector>

namespace rasterlens::tiled
{

/// Threads that wait for work between frames.
///
/// A loop is handed out index by index, so that the others wait for a thread that wakes late, or that the system takes
/// away, no longer than its present index takes; the calling thread works too. The standard library has all that is
/// needed for this; a task scheduler would bring stealing, nesting and allocation that no frame uses.
class ThreadPool
{
public:
    /// in  how many threads work on a loop, the caller's included; 1 starts none
    explicit ThreadPool(int threads);
    ~ThreadPool();
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;

    [[nodiscard]] int threads() const { return static_cast<int>(m_threads.size()) + 1; }

    /// Calls body(worker, i) for every i in [0, count), in any order, each once; worker < threads() is never busy
    /// twice at a time.
    ///
    /// order   everything the bodies did is visible to the caller
    /// errors  what a body throws reaches the caller once all threads have stopped; some i may not have had their turn
    template <class Body>
    void forEach(std::size_t count, Body&& body)
    {
        run({count,
             [](void* context, int worker, std::size_t i) {
                 (*static_cast<std::remove_reference_t<Body>*>(context))(worker, i);
             },
             &body});
    }

private:
    struct Loop {
        std::size_t count = 0;
        void (*call)(void* context, int worker, std::size_t index) = nullptr;
        void* context = nullptr;
    };

    void run(const Loop& loop);
    void work(int worker) noexcept;
    void workerMain(const std::stop_token& stop, int worker);

    std::mutex m_mutex;
    std::condition_variable_any m_wake;
    std::condition_variable m_done;
    Loop m_loop;                  ///< written under the mutex while no thread works
    std::size_t m_generation = 0; ///< counts loops
    int m_busy = 0;               ///< threads of the pool inside the present loop
    std::exception_ptr m_error;   ///< the first that a body of the present loop threw
    alignas(64) std::atomic<std::size_t> m_next = 0;
    std::vector<std::jthread> m_threads;
};

} // namespace rasterlens::tiled
