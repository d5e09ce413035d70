#include "ui/base/latest_result.h"

#include <QCoreApplication>
#include <QEvent>
#include <QThread>

#include <new>

namespace rasterlens
{
namespace
{

const auto kArrived = static_cast<QEvent::Type>(QEvent::registerEventType()); ///< the mailbox is full
const auto kShown = static_cast<QEvent::Type>(QEvent::registerEventType());   ///< what was taken has been painted

/// Paint events have Qt::LowEventPriority: what comes after them has been seen.
constexpr int kAfterPainting = Qt::LowEventPriority - 1;

/// Posts an event.
///
/// out  false if there is no memory for it
bool tryPost(QObject* to, QEvent::Type type, int priority)
{
    try {
        QCoreApplication::postEvent(to, new QEvent(type), priority);
        return true;
    } catch (const std::bad_alloc&) {
        return false;
    }
}

} // namespace

QString lackText(Lack lack)
{
    switch (lack) {
    case Lack::Memory: return QCoreApplication::translate("LatestResult", "there is not enough memory");
    case Lack::Threads: return QCoreApplication::translate("LatestResult", "the system does not start so many threads");
    }
    return {};
}

bool LatestJob::Turn::superseded() const
{
    const std::lock_guard lock(m_owner.m_mutex);
    return m_owner.m_waiting != nullptr;
}

bool LatestJob::Turn::supersededWithin(std::chrono::milliseconds time) const
{
    std::unique_lock lock(m_owner.m_mutex);
    return m_owner.m_changed.wait_for(lock, m_owner.m_thread.get_stop_token(), time,
                                      [this] { return m_owner.m_waiting != nullptr; });
}

LatestJob::~LatestJob() { end(); }

void LatestJob::end()
{
    if (!m_thread.joinable())
        return;
    m_thread.request_stop();
    {
        const std::lock_guard lock(m_mutex);
        m_waiting = nullptr;
        m_current.request_stop();
    }
    m_changed.notify_all();
    m_thread.join();
}

void LatestJob::drop()
{
    m_done = m_dropped = ++m_asked;
    {
        const std::lock_guard lock(m_mutex);
        m_waiting = nullptr;
    }
    interruptFor(Running::Interrupt);
}

void LatestJob::interruptFor(Running running)
{
    if (running == Running::Finish)
        return;
    {
        const std::lock_guard lock(m_mutex);
        m_current.request_stop();
    }
    m_changed.notify_all();
}

void LatestJob::post(Job job)
{
    std::stop_source stop; // takes memory, as the thread does: here that is no danger
    if (!m_thread.joinable())
        m_thread = std::jthread([this](const std::stop_token& shutdown) { run(shutdown); });
    {
        const std::lock_guard lock(m_mutex);
        m_waiting = std::move(job);
        m_waitingStop = std::move(stop);
        m_waitingSerial = m_asked;
    }
    m_changed.notify_all();
}

void LatestJob::failFromWindow(Lack lack)
{
    {
        const std::lock_guard lock(m_mutex);
        m_waiting = nullptr; // it was asked for before
    }
    m_done = m_asked;
    fail(lack);
}

void LatestJob::run(const std::stop_token& shutdown)
{
    // Has Qt take what it keeps of a thread, some hundred bytes, while there is nothing yet that could fail: its first
    // QObject would do so else, and Qt 6.4.2 does not outlive that there is no memory for them.
    (void)QThread::currentThread();
    while (true) {
        Job job;
        quint64 serial = 0;
        std::stop_token stop;
        {
            std::unique_lock lock(m_mutex);
            if (!m_changed.wait(lock, shutdown, [this] { return m_waiting != nullptr; }))
                return;
            if (shutdown.stop_requested())
                return;
            job = std::exchange(m_waiting, nullptr);
            serial = m_waitingSerial;
            m_current = std::move(m_waitingStop);
            stop = m_current.get_token();
        }
        const Turn turn(*this, stop, serial);
        const std::optional<Lack> lack = lackOf([&] { job(turn); });
        job = nullptr; // its memory may be what the message needs
        std::unique_lock lock(m_mutex);
        if (lack && waitForEmptyMailbox(lock, stop))
            fillMailbox(lock, serial, true, lack);
    }
}

bool LatestJob::waitForEmptyMailbox(std::unique_lock<std::mutex>& lock, const std::stop_token& stop)
{
    m_changed.wait(lock, m_thread.get_stop_token(), [&] { return !m_mailbox.full || stop.stop_requested(); });
    return !m_mailbox.full && !stop.stop_requested();
}

void LatestJob::fillMailbox(std::unique_lock<std::mutex>& lock, quint64 serial, bool last, std::optional<Lack> lack)
{
    constexpr std::chrono::milliseconds kPause(20);
    m_mailbox = {true, serial, last, lack};
    const std::stop_token shutdown = m_thread.get_stop_token();
    while (!tryPost(this, kArrived, Qt::NormalEventPriority))
        if (m_changed.wait_for(lock, shutdown, kPause, [] { return false; }) || shutdown.stop_requested())
            return;
}

bool LatestJob::event(QEvent* event)
{
    if (event->type() == kArrived)
        arrive();
    else if (event->type() == kShown)
        emptyMailbox();
    else
        return QObject::event(event);
    return true;
}

void LatestJob::arrive()
{
    Mailbox box;
    {
        const std::lock_guard lock(m_mutex);
        box = m_mailbox;
    }
    const bool isLatest = box.serial == m_asked;
    const bool wanted = box.serial > m_dropped && (isLatest || m_late == Late::Taken);
    if (box.last && isLatest)
        m_done = m_asked;
    std::optional<Lack> lack = box.lack;
    if (!lack)
        lack = lackOf([&] { takeStored(wanted); });
    if (lack && wanted && isLatest)
        fail(*lack);
    if (!tryPost(this, kShown, kAfterPainting))
        emptyMailbox();
}

void LatestJob::emptyMailbox()
{
    {
        const std::lock_guard lock(m_mutex);
        m_mailbox.full = false;
    }
    m_changed.notify_all();
}

} // namespace rasterlens
