// How much memory the process has needed.
#pragma once

#include <cstdint>

namespace sheer {

// The largest resident size so far, of the whole process; 0 where the system does not tell.
std::uint64_t peak_memory_bytes();

// The resident size now, of the whole process; 0 where the system does not tell.
std::uint64_t resident_memory_bytes();

// Gives what is free, but kept by the allocator, back to the system, where that can be asked for.
void release_free_memory();

// Lets peak_memory_bytes count from now on, where the system can (Linux).
void reset_peak_memory();

}  // namespace sheer
