#include "core/io/mapped_file.h"

#include "core/io/text_input.h"

#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <mutex>

namespace rasterlens
{

/// A mapping that the signal handler watches over. Reading a page that is no longer in the file raises SIGBUS, which
/// would end the program; the handler puts pages of zeros there instead.
struct MappedFile::Guard {
    std::atomic<bool> taken = false;
    std::atomic<std::uintptr_t> begin = 0;
    std::atomic<std::uintptr_t> end = 0; ///< 0: nothing is mapped
    std::atomic<bool> shortened = false;

    static constexpr std::size_t kMost = 64;
    static std::array<Guard, kMost> all;
    static struct sigaction former;

    static Guard* take();
    static void onBusError(int signal, siginfo_t* info, void* context);
};

std::array<MappedFile::Guard, MappedFile::Guard::kMost> MappedFile::Guard::all;
struct sigaction MappedFile::Guard::former = {};

/// A free guard, or none where too many files are open.
MappedFile::Guard* MappedFile::Guard::take()
{
    static std::once_flag installed;
    std::call_once(installed, [] {
        struct sigaction action = {};
        action.sa_sigaction = &Guard::onBusError;
        action.sa_flags = SA_SIGINFO;
        ::sigaction(SIGBUS, &action, &former);
    });
    for (Guard& guard : all)
        if (!guard.taken.exchange(true))
            return &guard;
    return nullptr;
}

void MappedFile::Guard::onBusError(int, siginfo_t* info, void*)
{
    const auto at = reinterpret_cast<std::uintptr_t>(info->si_addr);
    const auto page = static_cast<std::uintptr_t>(::sysconf(_SC_PAGESIZE));
    for (Guard& guard : all) {
        const std::uintptr_t end = guard.end;
        if (end == 0 || at < guard.begin || at >= end)
            continue;
        const std::uintptr_t from = at / page * page;
        void* const zeros = ::mmap(reinterpret_cast<void*>(from), end - from, PROT_READ,
                                   MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED, -1, 0);
        if (zeros == MAP_FAILED)
            break;
        guard.shortened = true;
        return;
    }
    ::sigaction(SIGBUS, &former, nullptr); // not ours: the access is made again, and the former handler sees it
}

MappedFile::~MappedFile()
{
    if (m_data == nullptr)
        return;
    m_guard->end = 0;
    ::munmap(const_cast<char*>(m_data), m_size);
    m_guard->taken = false;
}

std::optional<Reason> MappedFile::open(const QString& path)
{
    const OpenInput input = openInput(path);
    if (input.problem)
        return input.problem;
    m_guard = Guard::take();
    void* const data = m_guard == nullptr
                           ? MAP_FAILED
                           : ::mmap(nullptr, input.size, PROT_READ, MAP_PRIVATE | MAP_POPULATE, input.descriptor, 0);
    const int error = m_guard == nullptr ? EMFILE : errno;
    ::close(input.descriptor);
    if (data == MAP_FAILED) {
        if (m_guard != nullptr)
            m_guard->taken = false;
        return Reason(QT_TRANSLATE_NOOP("Diagnostic", "the file cannot be read: %1"), {qt_error_string(error)});
    }
    m_data = static_cast<const char*>(data);
    m_size = input.size;
    m_guard->shortened = false;
    m_guard->begin = reinterpret_cast<std::uintptr_t>(data);
    m_guard->end = m_guard->begin + m_size;
    return std::nullopt;
}

bool MappedFile::wasShortened() const { return m_guard != nullptr && m_guard->shortened; }

} // namespace rasterlens
