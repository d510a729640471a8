// The parallel loop: each index once, on known threads, and the first failure by index.
#include "support/parallel.h"

#include <atomic>
#include <chrono>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace sheer {
namespace {

class ParallelFor : public testing::TestWithParam<int> {};

INSTANTIATE_TEST_SUITE_P(Threads, ParallelFor, testing::Values(1, 2, 7));

TEST_P(ParallelFor, CoversEachIndexOnce)
{
    for (const std::size_t count : {0u, 1u, 3u, 1000u}) {
        std::vector<int> visits(count);
        parallel_for(GetParam(), count, [&](std::size_t i, int) { ++visits[i]; });
        for (const int n : visits) ASSERT_EQ(n, 1);
    }
}

TEST_P(ParallelFor, TellsItsThreadsApart)
{
    std::mutex mutex;
    std::set<std::pair<int, std::thread::id>> seen;
    parallel_for(GetParam(), 200, [&](std::size_t, int thread) {
        std::this_thread::sleep_for(std::chrono::microseconds(50));
        const std::lock_guard lock(mutex);
        seen.emplace(thread, std::this_thread::get_id());
    });
    std::set<int> numbers;
    for (const auto& [thread, id] : seen) {
        EXPECT_GE(thread, 0);
        EXPECT_LT(thread, GetParam());
        EXPECT_TRUE(numbers.insert(thread).second) << "two threads with one number";
        EXPECT_EQ(thread == 0, id == std::this_thread::get_id());
    }
}

TEST_P(ParallelFor, RethrowsTheFirstFailureByIndex)
{
    for (int round = 0; round < 20; ++round) {
        std::vector<int> visits(100);
        try {
            parallel_for(GetParam(), visits.size(), [&](std::size_t i, int) {
                ++visits[i];
                // The smallest failing index is the last to fail.
                if (i == 20) std::this_thread::sleep_for(std::chrono::milliseconds(1));
                if (i >= 20) throw std::runtime_error(std::to_string(i));
            });
            ADD_FAILURE() << "nothing thrown";
        } catch (const std::runtime_error& error) {
            EXPECT_STREQ(error.what(), "20");
        }
        for (std::size_t i = 0; i <= 20; ++i) EXPECT_EQ(visits[i], 1);
        EXPECT_EQ(visits.back(), 0) << "work was handed out after a failure";
    }
}

TEST(Parallel, OneThreadRunsInTheCallerInOrder)
{
    for (const int threads : {1, 0, -3}) {
        std::vector<std::size_t> order;
        parallel_for(threads, 5, [&](std::size_t i, int thread) {
            EXPECT_EQ(thread, 0);
            order.push_back(i);
        });
        EXPECT_EQ(order, (std::vector<std::size_t>{0, 1, 2, 3, 4}));
    }
}

TEST(Parallel, LoopsMayBeNested)
{
    std::atomic<int> sum{0};
    parallel_for(3, 4, [&](std::size_t, int) {
        parallel_for(2, 5, [&](std::size_t, int) { sum.fetch_add(1); });
    });
    EXPECT_EQ(sum.load(), 20);
}

TEST(Parallel, MachinesHaveAThread)
{
    EXPECT_GE(hardware_threads(), 1);
}

}  // namespace
}  // namespace sheer
