#include "core/tiled/thread_pool.h"

#include <utility>

namespace rasterlens::tiled
{

ThreadPool::ThreadPool(int threads)
{
    for (int worker = 1; worker < threads; ++worker)
        m_threads.emplace_back([this, worker](const std::stop_token& stop) { workerMain(stop, worker); });
}

ThreadPool::~ThreadPool()
{
    for (std::jthread& thread : m_threads)
        thread.request_stop();
}

void ThreadPool::run(const Loop& loop)
{
    const bool shared = !m_threads.empty() && loop.count > 1;
    {
        std::unique_lock lock(m_mutex);
        m_done.wait(lock, [this] { return m_busy == 0; }); // a thread that woke late for the last loop
        m_loop = loop;
        m_next = 0;
        if (shared)
            ++m_generation;
    }
    if (shared)
        m_wake.notify_all();
    work(0);
    // Threads that have not woken by now find nothing left to do.
    std::unique_lock lock(m_mutex);
    m_done.wait(lock, [this] { return m_busy == 0; });
    m_loop.count = 0;
    if (m_error)
        std::rethrow_exception(std::exchange(m_error, nullptr));
}

void ThreadPool::work(int worker) noexcept
{
    try {
        for (std::size_t i = m_next++; i < m_loop.count; i = m_next++)
            m_loop.call(m_loop.context, worker, i);
    } catch (...) {
        m_next = m_loop.count; // the others need not go on
        const std::lock_guard lock(m_mutex);
        if (!m_error)
            m_error = std::current_exception();
    }
}

void ThreadPool::workerMain(const std::stop_token& stop, int worker)
{
    std::size_t seen = 0;
    std::unique_lock lock(m_mutex);
    while (m_wake.wait(lock, stop, [&] { return m_generation != seen; })) {
        seen = m_generation;
        ++m_busy;
        lock.unlock();
        work(worker);
        lock.lock();
        if (--m_busy == 0)
            m_done.notify_one();
    }
}

} // namespace rasterlens::tiled
