// How a memory limit is shared out.
#pragma once

#include <cstddef>
#include <cstdint>

namespace sheer {

struct MemoryNeeds {
    std::uint64_t limit;       // bytes of the whole process; 0: none
    std::uint64_t pixels;      // of the picture
    std::uint64_t pictures;    // of that size that are made at once, and are not there yet
    std::size_t thread_bytes;  // what each thread holds, but for stores that grow
    int growing_stores;        // of each thread
    int threads;               // wanted
    std::uint64_t reserved;    // bytes that the caller will need besides
};

struct MemoryPlan {
    int threads;
    std::size_t store_bytes;  // for each store that grows
};

// Throws Error(Fault::work) that says how much is needed when `bytes` more would not stay below the
// limit, which there is.
void require_memory(std::uint64_t limit, std::uint64_t bytes);

// The same where no limit is set, and the machine has not got as much.
void require_machine_memory(std::uint64_t bytes);

// By a process with one thread, what it has already included.
std::uint64_t memory_needed(const MemoryNeeds& needs);

// Throws the same when not even one thread can work, or when
// there is no room to encode the picture afterwards.
MemoryPlan plan_memory(const MemoryNeeds& needs);

}  // namespace sheer
