#pragma once
// Long arrays that are written by threads.

#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace pfem {

/// Leaves new numbers as the memory is: zeroing them would be one thread's work, before the threads come that set them.
template <class Value>
struct LeaveUnset : std::allocator<Value> {
    LeaveUnset() = default;
    template <class Other>
    LeaveUnset(const LeaveUnset<Other>&) noexcept {}

    template <class Made>
    void construct(Made* at) {
        ::new (static_cast<void*>(at)) Made;
    }
    template <class Made, class... From>
    void construct(Made* at, From&&... from) {
        ::new (static_cast<void*>(at)) Made(std::forward<From>(from)...);
    }
};

/// resize(n) and UnsetVector(n) set nothing.
template <class Value>
using UnsetVector = std::vector<Value, LeaveUnset<Value>>;

}  // namespace pfem
