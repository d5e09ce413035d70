#pragma once
#include <algorithm>
#include <cstddef>
#include <stop_token>
#include <vector>

namespace rasterlens
{

/// Makes a vector one of `count` equal values, piece by piece: a plane of the largest picture takes a second, a piece a
/// few milliseconds. Memory that the vector has is used again.
///
/// out     false: `stop` was requested in between, and there are fewer values
/// errors  throws std::bad_alloc
template <class T, class Allocator>
bool assignInPieces(std::vector<T, Allocator>& values, std::size_t count, T value, const std::stop_token& stop)
{
    constexpr std::size_t kPiece = std::size_t(1) << 22;
    values.clear();
    values.reserve(count);
    while (values.size() < count && !stop.stop_requested())
        values.insert(values.end(), std::min(kPiece, count - values.size()), value);
    return values.size() == count;
}

} // namespace rasterlens
