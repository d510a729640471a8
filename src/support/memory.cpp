// Peak memory: on Linux VmHWM, which can be reset (proc(5), clear_refs); elsewhere from getrusage,
// whose unit POSIX leaves open: kibibytes, or bytes on macOS.
#include "support/memory.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

#include <sys/resource.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace sheer {

namespace {

// A line of a file below /proc; 0 without one.
std::uint64_t bytes_in(const char* path, const std::string& name)
{
    std::ifstream lines(path);
    for (std::string word; lines >> word;) {
        std::uint64_t kibibytes = 0;
        if (word == name && lines >> kibibytes) return kibibytes * 1024;
        lines.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
    }
    return 0;
}

std::uint64_t status_bytes(const std::string& name)
{
    return bytes_in("/proc/self/status", name);
}

}  // namespace

std::uint64_t peak_memory_bytes()
{
    if (const std::uint64_t peak = status_bytes("VmHWM:"); peak != 0) return peak;
    rusage usage{};
    if (getrusage(RUSAGE_SELF, &usage) != 0) return 0;
#ifdef __APPLE__
    constexpr std::uint64_t kUnit = 1;
#else
    constexpr std::uint64_t kUnit = 1024;
#endif
    return static_cast<std::uint64_t>(usage.ru_maxrss) * kUnit;
}

std::uint64_t resident_memory_bytes()
{
    return status_bytes("VmRSS:");
}

std::uint64_t machine_memory_bytes()
{
    constexpr const char* kFile = "/proc/meminfo";
    return bytes_in(kFile, "MemTotal:") + bytes_in(kFile, "SwapTotal:");
}

void release_free_memory()
{
#ifdef __GLIBC__
    malloc_trim(0);
#endif
}

void reset_peak_memory()
{
    std::ofstream("/proc/self/clear_refs") << 5;
}

bool MemoryCeiling::has_effect()
{
#ifdef SHEER_SHADOW_MEMORY
    return false;
#else
    // What RLIMIT_DATA is compared with.
    return status_bytes("VmData:") != 0;
#endif
}

MemoryCeiling::MemoryCeiling(std::uint64_t bytes_more)
{
    rlimit limit{};
    if (!has_effect() || getrlimit(RLIMIT_DATA, &limit) != 0) return;
    before_ = limit.rlim_cur;
    const std::uint64_t wanted = status_bytes("VmData:") + bytes_more;
    limit.rlim_cur = std::min<rlim_t>(limit.rlim_cur, wanted);
    if (setrlimit(RLIMIT_DATA, &limit) != 0) before_ = 0;
}

MemoryCeiling::~MemoryCeiling()
{
    rlimit limit{};
    if (before_ == 0 || getrlimit(RLIMIT_DATA, &limit) != 0) return;
    limit.rlim_cur = static_cast<rlim_t>(before_);
    setrlimit(RLIMIT_DATA, &limit);
}

}  // namespace sheer
