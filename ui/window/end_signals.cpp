#include "ui/window/end_signals.h"

#include <QSocketNotifier>

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>

namespace rasterlens
{
namespace
{

constexpr std::array kSignals{SIGTERM, SIGINT, SIGHUP};
constexpr unsigned kSecondsToEnd = 5;

/// The end of the pipe that the handler writes to: a handler may call little else than write().
volatile std::sig_atomic_t writeEnd = -1;

extern "C" void onEndSignal(int signal)
{
    const int before = errno;
    const auto byte = static_cast<unsigned char>(signal);
    [[maybe_unused]] const auto written = ::write(writeEnd, &byte, 1);
    ::alarm(kSecondsToEnd); // in case the event loop no longer turns
    errno = before;
}

bool setHandler(int signal, void (*handler)(int), int flags)
{
    struct sigaction action = {};
    action.sa_handler = handler;
    action.sa_flags = flags;
    sigemptyset(&action.sa_mask);
    return ::sigaction(signal, &action, nullptr) == 0;
}

bool isIgnored(int signal)
{
    struct sigaction present = {};
    return ::sigaction(signal, nullptr, &present) == 0 && present.sa_handler == SIG_IGN;
}

} // namespace

EndSignals::EndSignals(QObject* parent) : QObject(parent)
{
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC | O_NONBLOCK) != 0)
        return; // the signals end the program as they always do
    m_readEnd = ends[0];
    writeEnd = ends[1];
    m_notifier = new QSocketNotifier(m_readEnd, QSocketNotifier::Read, this);
    connect(m_notifier, &QSocketNotifier::activated, this, &EndSignals::read);
    for (const int signal : kSignals)
        if (!isIgnored(signal))
            // The second one of a kind finds the system's own handler.
            setHandler(signal, onEndSignal, static_cast<int>(SA_RESTART | SA_RESETHAND));
}

EndSignals::~EndSignals()
{
    if (m_readEnd < 0)
        return;
    for (const int signal : kSignals)
        if (!isIgnored(signal))
            setHandler(signal, SIG_DFL, 0);
    delete m_notifier;
    ::close(writeEnd);
    ::close(m_readEnd);
    writeEnd = -1;
}

void EndSignals::read()
{
    unsigned char signal = 0;
    if (::read(m_readEnd, &signal, 1) == 1)
        Q_EMIT received(signal);
}

} // namespace rasterlens
