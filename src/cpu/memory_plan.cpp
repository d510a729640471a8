// From what the process has now to what its threads may take.
#include "cpu/memory_plan.h"

#include <algorithm>
#include <string>

#include <sheer/error.h>

#include "support/memory.h"

namespace sheer {

namespace {

constexpr std::uint64_t kMiB = 1024 * 1024;
constexpr std::uint64_t kPixelBytes = 16;
// An OpenEXR file of noise is as large as its pixels; PNG takes half of that.
constexpr std::uint64_t kEncodedPixelBytes = kPixelBytes + 1;
// The allocator's own, stacks, file buffers.
constexpr std::uint64_t kSlack = 8 * kMiB, kThreadSlack = kMiB;
// Below this a store that grows splits its tiles too often: several thousand fragments.
constexpr std::size_t kLeastStore = kMiB;
// And above this nothing is gained: thousands of layers in each pixel of a tile. Stores reserve as
// many addresses, of which there are not always more than there is memory.
constexpr std::size_t kMostStore = 512 * kMiB;

[[noreturn]] void refuse(std::uint64_t limit, std::uint64_t needed)
{
    throw Error(Fault::work, "memory-limit: " + std::to_string(limit / kMiB) +
                                 " MiB are too little for this scene and picture; at least " +
                                 std::to_string((needed + kMiB - 1) / kMiB) + " MiB are needed");
}

std::uint64_t base_bytes(const MemoryNeeds& needs)
{
    return resident_memory_bytes() + kSlack + needs.reserved +
           needs.pictures * needs.pixels * kPixelBytes;
}

// Of one thread.
std::uint64_t least_bytes(const MemoryNeeds& needs)
{
    return needs.thread_bytes + kThreadSlack +
           static_cast<std::uint64_t>(needs.growing_stores) * kLeastStore;
}

}  // namespace

void require_memory(std::uint64_t limit, std::uint64_t bytes)
{
    const std::uint64_t needed = resident_memory_bytes() + kSlack + bytes;
    if (needed > limit) refuse(limit, needed);
}

void require_machine_memory(std::uint64_t bytes)
{
    const std::uint64_t machine = machine_memory_bytes();
    const std::uint64_t needed = resident_memory_bytes() + bytes;
    if (machine == 0 || needed <= machine) return;
    throw Error(Fault::work, "this scene needs " + std::to_string(needed / kMiB) +
                                 " MiB, and the machine has " + std::to_string(machine / kMiB));
}

std::uint64_t memory_needed(const MemoryNeeds& needs)
{
    return base_bytes(needs) + std::max(least_bytes(needs), needs.pixels * kEncodedPixelBytes);
}

MemoryPlan plan_memory(const MemoryNeeds& needs)
{
    if (needs.limit == 0) return {needs.threads, ~std::size_t{0}};
    const std::uint64_t needed = memory_needed(needs);
    if (needed > needs.limit) refuse(needs.limit, needed);

    const std::uint64_t base = base_bytes(needs), least = least_bytes(needs);
    const std::uint64_t growing = static_cast<std::uint64_t>(needs.growing_stores);
    const std::uint64_t left = needs.limit - base;
    const auto threads = static_cast<int>(
        std::min<std::uint64_t>(static_cast<std::uint64_t>(needs.threads), left / least));
    if (growing == 0) return {threads, 0};
    const std::uint64_t share =
        left / static_cast<std::uint64_t>(threads) - needs.thread_bytes - kThreadSlack;
    return {threads, std::min(static_cast<std::size_t>(share / growing), kMostStore)};
}

}  // namespace sheer
