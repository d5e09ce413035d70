#pragma once
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>

namespace rasterlens
{

/// One background thread with a mailbox of one: a job posted while another waits takes its place.
///
/// order   jobs run one at a time, never after the destructor returned
class LatestTask
{
public:
    using Job = std::function<void(std::stop_token)>;
    enum class Running { Finish, Interrupt };

    LatestTask();
    ~LatestTask();
    LatestTask(const LatestTask&) = delete;
    LatestTask& operator=(const LatestTask&) = delete;

    /// Runs `job` as soon as the thread is free.
    ///
    /// in   what is to become of the job at work: let it finish, or ask it through its token to stop
    void post(Job job, Running running);

    /// Whether a newer job waits. For the job at work, which may spare itself the rest.
    [[nodiscard]] bool superseded() const;
    /// Whether a newer job comes in this time. Likewise.
    [[nodiscard]] bool supersededWithin(std::chrono::milliseconds time);

private:
    void run(std::stop_token shutdown);

    mutable std::mutex m_mutex;
    std::condition_variable_any m_posted;
    Job m_waiting;
    std::stop_source m_current{std::nostopstate};
    std::jthread m_thread;
};

} // namespace rasterlens
