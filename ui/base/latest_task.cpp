#include "ui/base/latest_task.h"

#include <utility>

namespace rasterlens
{

LatestTask::LatestTask() : m_thread([this](std::stop_token shutdown) { run(std::move(shutdown)); }) {}

LatestTask::~LatestTask()
{
    m_thread.request_stop();
    const std::lock_guard lock(m_mutex);
    m_waiting = nullptr;
    m_current.request_stop();
}

void LatestTask::post(Job job, Running running)
{
    {
        const std::lock_guard lock(m_mutex);
        m_waiting = std::move(job);
        if (running == Running::Interrupt)
            m_current.request_stop();
    }
    m_posted.notify_one();
}

bool LatestTask::superseded() const
{
    const std::lock_guard lock(m_mutex);
    return m_waiting != nullptr;
}

bool LatestTask::supersededWithin(std::chrono::milliseconds time)
{
    std::unique_lock lock(m_mutex);
    return m_posted.wait_for(lock, m_thread.get_stop_token(), time, [this] { return m_waiting != nullptr; });
}

void LatestTask::run(std::stop_token shutdown)
{
    while (true) {
        Job job;
        std::stop_token stop;
        {
            std::unique_lock lock(m_mutex);
            if (!m_posted.wait(lock, shutdown, [this] { return m_waiting != nullptr; }))
                return;
            if (shutdown.stop_requested())
                return;
            job = std::exchange(m_waiting, nullptr);
            m_current = std::stop_source();
            stop = m_current.get_token();
        }
        job(stop);
    }
}

} // namespace rasterlens
