// Peak memory: on Linux VmHWM, which can be reset (proc(5), clear_refs); elsewhere from getrusage,
// whose unit POSIX leaves open: kibibytes, or bytes on macOS.
#include "support/memory.h"

#include <fstream>
#include <limits>
#include <string>

#include <sys/resource.h>

namespace sheer {

std::uint64_t peak_memory_bytes()
{
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;) {
        std::uint64_t kibibytes = 0;
        if (word == "VmHWM:" && status >> kibibytes) return kibibytes * 1024;
        status.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
    }
    rusage usage{};
    if (getrusage(RUSAGE_SELF, &usage) != 0) return 0;
#ifdef __APPLE__
    constexpr std::uint64_t kUnit = 1;
#else
    constexpr std::uint64_t kUnit = 1024;
#endif
    return static_cast<std::uint64_t>(usage.ru_maxrss) * kUnit;
}

void reset_peak_memory()
{
    std::ofstream("/proc/self/clear_refs") << 5;
}

}  // namespace sheer
