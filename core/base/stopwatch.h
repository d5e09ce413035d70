#pragma once
#include <chrono>

namespace rasterlens
{

/// Milliseconds since it was made or last read.
class Stopwatch
{
public:
    double lap()
    {
        const auto now = Clock::now();
        const double ms = std::chrono::duration<double, std::milli>(now - m_last).count();
        m_last = now;
        return ms;
    }

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point m_last = Clock::now();
};

} // namespace rasterlens
