#pragma once
#include <memory>
#include <new>
#include <utility>

namespace rasterlens
{

/// The allocator of a vector whose resize(count) gives new elements no value: of megabytes of them, those that are
/// never written take no room in the machine. Read no element before it is written.
template <class T>
struct UnfilledAllocator : std::allocator<T> {
    template <class Other>
    struct rebind {
        using other = UnfilledAllocator<Other>;
    };

    using std::allocator<T>::allocator;

    template <class Element>
    void construct(Element* place) noexcept
    {
        ::new (static_cast<void*>(place)) Element;
    }
    template <class Element, class First, class... Rest>
    void construct(Element* place, First&& first, Rest&&... rest)
    {
        std::construct_at(place, std::forward<First>(first), std::forward<Rest>(rest)...);
    }
};

} // namespace rasterlens
