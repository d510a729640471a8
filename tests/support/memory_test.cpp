// Peak memory: grows by what is touched and never shrinks.
#include "support/memory.h"

#include <cstddef>
#include <cstdint>
#include <new>
#include <vector>

#include <gtest/gtest.h>

namespace sheer {
namespace {

TEST(Memory, PeakFollowsWhatIsTouched)
{
    constexpr std::uint64_t kMiB = 1024 * 1024;
    const std::uint64_t before = peak_memory_bytes();
    EXPECT_GT(before, kMiB);
    EXPECT_LT(before, 64 * 1024 * kMiB);
    {
        std::vector<char> touched(64 * kMiB);
        // Volatile, lest the compiler leaves the vector out.
        volatile char* bytes = touched.data();
        for (std::size_t i = 0; i < touched.size(); i += 1024) bytes[i] = 'x';
    }
    const std::uint64_t after = peak_memory_bytes();
    EXPECT_GE(after, before);
    // The process may have peaked higher before, but not below what it holds now.
    EXPECT_GE(after, 64 * kMiB);
}

TEST(Memory, CeilingStopsWhatIsBeyond)
{
    constexpr std::uint64_t kMiB = 1024 * 1024;
    if (!MemoryCeiling::has_effect()) return;
    const auto allocate = [](std::uint64_t bytes) { std::vector<char>(bytes, 'x'); };
    {
        const MemoryCeiling ceiling(64 * kMiB);
        EXPECT_NO_THROW(allocate(32 * kMiB));
        EXPECT_THROW(allocate(128 * kMiB), std::bad_alloc);
    }
    EXPECT_NO_THROW(allocate(128 * kMiB));
}

}  // namespace
}  // namespace sheer
