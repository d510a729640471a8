#include "support/pages.h"

#include <cstddef>
#include <new>

#include <sys/mman.h>

namespace sheer {

namespace {

// Below it a piece's last page is too much of it to waste.
constexpr std::size_t kLeastBytes = std::size_t{1} << 16;

class PageMemory : public std::pmr::memory_resource {
    void* do_allocate(std::size_t bytes, std::size_t alignment) override
    {
        if (bytes < kLeastBytes) return std::pmr::new_delete_resource()->allocate(bytes, alignment);
        void* pages =
            mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        if (pages == MAP_FAILED) throw std::bad_alloc();
        return pages;
    }
    void do_deallocate(void* piece, std::size_t bytes, std::size_t alignment) override
    {
        if (bytes < kLeastBytes) {
            std::pmr::new_delete_resource()->deallocate(piece, bytes, alignment);
        } else {
            munmap(piece, bytes);
        }
    }
    bool do_is_equal(const memory_resource& other) const noexcept override
    {
        return this == &other;
    }
};

}  // namespace

std::pmr::memory_resource& page_memory()
{
    // Never destroyed: stores may be.
    static PageMemory& memory = *new PageMemory;
    return memory;
}

std::pmr::memory_resource* memory_within(std::size_t most_bytes)
{
    const bool bounded = most_bytes != ~std::size_t{0};
    return bounded ? &page_memory() : std::pmr::new_delete_resource();
}

}  // namespace sheer
