// How much memory the process has needed.
#pragma once

#include <cstdint>

namespace sheer {

// The largest resident size so far, of the whole process; 0 where the system does not tell.
std::uint64_t peak_memory_bytes();

}  // namespace sheer
