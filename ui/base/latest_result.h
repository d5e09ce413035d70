#pragma once
#include <QObject>
#include <QString>

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <new>
#include <optional>
#include <stdexcept>
#include <stop_token>
#include <system_error>
#include <thread>
#include <utility>

namespace rasterlens
{

/// What the system did not have for a background job.
enum class Lack { Memory, Threads };

/// `there is not enough memory`, in the language in use: the second half of a sentence.
[[nodiscard]] QString lackText(Lack lack);

/// Everything about LatestResult<T> that does not depend on T.
class LatestJob : public QObject
{
public:
    /// What becomes of the job at work when another one is asked for.
    enum class Running {
        Finish,   ///< it may end by itself
        Interrupt ///< it is asked through its stop token to stop, and what it would bring is not taken
    };
    /// What becomes of a result when something newer has been asked for since.
    enum class Late { Dropped, Taken };

    ~LatestJob() override;
    LatestJob(const LatestJob&) = delete;
    LatestJob& operator=(const LatestJob&) = delete;

    /// What is asked for is not wanted any more: a job at work is asked to stop, and its result is not taken.
    void drop();
    /// Whether the last result asked for has neither been taken nor failed nor been dropped.
    [[nodiscard]] bool isBusy() const { return m_asked != m_done; }

    /// What a job at work is handed: when to stop, and whether something newer waits.
    class Turn
    {
    public:
        [[nodiscard]] const std::stop_token& stop() const { return m_stop; }
        /// Whether a newer job waits. The job at work may then spare itself the rest.
        [[nodiscard]] bool superseded() const;
        /// Whether a newer job comes in this time.
        [[nodiscard]] bool supersededWithin(std::chrono::milliseconds time) const;

    protected:
        friend LatestJob;
        Turn(LatestJob& owner, std::stop_token stop, quint64 serial)
            : m_owner(owner), m_stop(std::move(stop)), m_serial(serial)
        {
        }

        LatestJob& m_owner;
        std::stop_token m_stop;
        quint64 m_serial;
    };

protected:
    using Job = std::function<void(const Turn&)>;

    explicit LatestJob(Late late) : m_late(late) {}

    /// Makes the job and has it run; what is lacking for either is told as a failure of the job.
    ///
    /// in  make  a function that returns the Job
    template <class Make>
    void start(Make&& make, Running running)
    {
        ++m_asked;
        interruptFor(running);
        if (const auto lack = lackOf([&] { post(make()); }))
            failFromWindow(*lack);
    }

    /// Ends the thread. Each class that derives from this one calls it before its members go.
    void end();

    /// Runs something.
    ///
    /// out  what it lacked; nothing if it came to its end
    template <class Run>
    [[nodiscard]] static std::optional<Lack> lackOf(Run&& run)
    {
        try {
            run();
        } catch (const std::bad_alloc&) {
            return Lack::Memory;
        } catch (const std::length_error&) { // more elements than any memory holds
            return Lack::Memory;
        } catch (const std::system_error&) { // what threads that do not start throw
            return Lack::Threads;
        }
        return std::nullopt;
    }

    /// Waits until the window has taken and shown what was delivered before, then has `store` fill the mailbox.
    ///
    /// order  on the background thread; nothing is stored if the job is to stop
    template <class Store>
    void deliver(const Turn& turn, bool last, Store&& store)
    {
        std::unique_lock lock(m_mutex);
        if (!waitForEmptyMailbox(lock, turn.stop()))
            return;
        store();
        fillMailbox(lock, turn.m_serial, last, std::nullopt);
    }

    /// On the thread of the window: takes what is in the mailbox, or only lets go of it.
    virtual void takeStored(bool wanted) = 0;
    virtual void fail(Lack lack) = 0;

    bool event(QEvent* event) override;

private:
    void interruptFor(Running running);
    void post(Job job);
    void failFromWindow(Lack lack);
    void run(const std::stop_token& shutdown);
    [[nodiscard]] bool waitForEmptyMailbox(std::unique_lock<std::mutex>& lock, const std::stop_token& stop);
    void fillMailbox(std::unique_lock<std::mutex>& lock, quint64 serial, bool last, std::optional<Lack> lack);
    void arrive();
    void emptyMailbox();

    /// What the background thread puts in for the window.
    struct Mailbox {
        bool full = false;
        quint64 serial = 0;
        bool last = false; ///< of its job
        std::optional<Lack> lack;
    };

    const Late m_late;
    quint64 m_asked = 0; ///< used on the window's thread, like the next two
    quint64 m_done = 0;
    quint64 m_dropped = 0; ///< nothing up to here is taken any more

    mutable std::mutex m_mutex; ///< guards the members below
    std::condition_variable_any m_changed;
    Job m_waiting;
    quint64 m_waitingSerial = 0;
    std::stop_source m_waitingStop{std::nostopstate};
    std::stop_source m_current{std::nostopstate}; ///< of the job at work
    Mailbox m_mailbox;
    std::jthread m_thread; ///< from the first job on
};

/// The one way in which the window has something computed: a background thread with a mailbox of one job before it and
/// a mailbox of one result behind it. A job posted while another waits takes its place; results are taken on the
/// thread of the window.
///
/// order   jobs run one at a time, never after the destructor returned. A job that delivers again waits until the
///         window has taken, shown and painted what came before: results never pile up
/// errors  std::bad_alloc and threads that do not start, in the job or while it is posted, end the job alone and are
///         handed to `failed`; what the window shows stays as it was. The message itself waits for memory
template <class T>
class LatestResult : public LatestJob
{
public:
    class Turn : public LatestJob::Turn
    {
    public:
        /// Has the window take a part of the result before the last one.
        void deliver(T part) const
        {
            auto& owner = static_cast<LatestResult&>(m_owner);
            owner.LatestJob::deliver(*this, false, [&] { owner.m_stored.emplace(std::move(part)); });
        }

    private:
        friend LatestResult;
        explicit Turn(const LatestJob::Turn& turn) : LatestJob::Turn(turn) {}
    };
    using Take = std::function<void(T)>;
    using Failed = std::function<void(Lack)>;

    LatestResult(Take take, Failed failed, Late late = Late::Dropped)
        : LatestJob(late), m_take(std::move(take)), m_failed(std::move(failed))
    {
    }
    ~LatestResult() override { end(); }

    /// Runs `work` as soon as the thread is free.
    ///
    /// in  work  T(const Turn&)
    template <class Work>
    void ask(Work&& work, Running running)
    {
        start(
            [&] {
                return Job([this, work = std::forward<Work>(work)](const LatestJob::Turn& turn) mutable {
                    T result = work(Turn(turn));
                    LatestJob::deliver(turn, true, [&] { m_stored.emplace(std::move(result)); });
                });
            },
            running);
    }

private:
    void takeStored(bool wanted) override
    {
        T result = std::move(*m_stored);
        m_stored.reset();
        if (wanted)
            m_take(std::move(result));
    }
    void fail(Lack lack) override { m_failed(lack); }

    Take m_take;
    Failed m_failed;
    std::optional<T> m_stored;
};

} // namespace rasterlens
