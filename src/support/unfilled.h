// A vector whose new elements hold nothing yet: for what is about to be written as a whole.
#pragma once

#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace sheer {

template <class T>
struct UnfilledAllocator : std::allocator<T> {
    static_assert(std::is_trivially_default_constructible_v<T>);

    template <class U>
    struct rebind {
        using other = UnfilledAllocator<U>;
    };

    void construct(T* at) noexcept { ::new (static_cast<void*>(at)) T; }
    template <class... Arguments>
    void construct(T* at, Arguments&&... arguments)
    {
        std::construct_at(at, std::forward<Arguments>(arguments)...);
    }
};

// resize() leaves what it adds as it was in memory.
template <class T>
using UnfilledVector = std::vector<T, UnfilledAllocator<T>>;

}  // namespace sheer
