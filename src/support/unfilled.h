// A vector whose new elements hold nothing yet: for what is about to be written as a whole.
#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace sheer {

// Of much memory in one piece the system need not be asked page by page.
inline constexpr std::size_t kHugePage = std::size_t{2} << 20;

template <class T>
struct UnfilledAllocator {
    static_assert(std::is_trivially_default_constructible_v<T>);
    using value_type = T;

    UnfilledAllocator() = default;
    template <class U>
    UnfilledAllocator(const UnfilledAllocator<U>&) noexcept
    {
    }
    bool operator==(const UnfilledAllocator&) const = default;

    T* allocate(std::size_t count)
    {
        const std::size_t bytes = count * sizeof(T);
        void* memory = ::operator new(bytes, alignment(bytes));
        if (bytes >= kHugePage) madvise(memory, bytes, MADV_HUGEPAGE);
        return static_cast<T*>(memory);
    }
    void deallocate(T* memory, std::size_t count) noexcept
    {
        ::operator delete(memory, alignment(count * sizeof(T)));
    }
    void construct(T* at) noexcept { ::new (static_cast<void*>(at)) T; }
    template <class... Arguments>
    void construct(T* at, Arguments&&... arguments)
    {
        std::construct_at(at, std::forward<Arguments>(arguments)...);
    }

private:
    static std::align_val_t alignment(std::size_t bytes)
    {
        return std::align_val_t{bytes >= kHugePage ? kHugePage : alignof(T)};
    }
};

// resize() leaves what it adds as it was in memory.
template <class T>
using UnfilledVector = std::vector<T, UnfilledAllocator<T>>;

}  // namespace sheer
