// Peak memory, from getrusage (POSIX leaves the unit open: Linux counts kibibytes, macOS bytes).
#include "support/memory.h"

#include <sys/resource.h>

namespace sheer {

std::uint64_t peak_memory_bytes()
{
    rusage usage{};
    if (getrusage(RUSAGE_SELF, &usage) != 0) return 0;
#ifdef __APPLE__
    constexpr std::uint64_t kUnit = 1;
#else
    constexpr std::uint64_t kUnit = 1024;
#endif
    return static_cast<std::uint64_t>(usage.ru_maxrss) * kUnit;
}

}  // namespace sheer
