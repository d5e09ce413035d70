#pragma once
#include <algorithm>
#include <cstddef>
#include <system_error>
#include <thread>
#include <vector>

namespace rasterlens
{

/// Calls body(first, last) for parts of [0, count) that together are all of it, in as many threads as there are
/// processors, this one among them. Where the system has no thread to give, this thread does that part, too.
///
/// in  atLeast  how many of `count` are worth a thread; the bodies do not throw, and write to places of their own
template <class Body>
void inParallel(std::size_t count, std::size_t atLeast, Body&& body)
{
    constexpr std::size_t kMostThreads = 8;
    const std::size_t processors = std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, kMostThreads);
    const std::size_t parts = std::clamp<std::size_t>(count / atLeast, 1, processors);
    std::vector<std::jthread> threads;
    threads.reserve(parts);
    for (std::size_t part = 1; part < parts; ++part) {
        const std::size_t first = count * part / parts;
        const std::size_t last = count * (part + 1) / parts;
        try {
            threads.emplace_back([&body, first, last] { body(first, last); });
        } catch (const std::system_error&) {
            body(first, last);
        }
    }
    body(0, count / parts);
}

} // namespace rasterlens
