// How much memory the process has needed.
#pragma once

#include <cstdint>

namespace sheer {

// The largest resident size so far, of the whole process; 0 where the system does not tell.
std::uint64_t peak_memory_bytes();

// The resident size now, of the whole process; 0 where the system does not tell.
std::uint64_t resident_memory_bytes();

// Of the machine, with what it swaps to; 0 where the system does not tell.
std::uint64_t machine_memory_bytes();

// Gives what is free, but kept by the allocator, back to the system, where that can be asked for.
void release_free_memory();

// Lets peak_memory_bytes count from now on, where the system can (Linux).
void reset_peak_memory();

// While it lives, whoever lets the process ask the system for more than so many bytes besides those
// that it has gets std::bad_alloc. That concerns all threads: for a program, not for a library.
// Without effect where the system can't, and under sanitizers, whose own memory has no bound.
class MemoryCeiling {
public:
    explicit MemoryCeiling(std::uint64_t bytes_more);
    MemoryCeiling(const MemoryCeiling&) = delete;
    MemoryCeiling& operator=(const MemoryCeiling&) = delete;
    ~MemoryCeiling();

    static bool has_effect();

private:
    std::uint64_t before_ = 0;  // the system's limit
};

}  // namespace sheer
