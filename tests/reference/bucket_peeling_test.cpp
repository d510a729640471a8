// Peeling by buckets: which fragments are taken, by hand.
#include <gtest/gtest.h>

#include <vector>

#include "reference/bucket_peeling.h"
#include "reference/five_layers.h"
#include "reference/printed.h"

namespace sheer::reference {
namespace {

constexpr Rgba kBackdrop = {0.1, 0.2, 0.3, 0.5};

Rgba of_five(std::vector<std::size_t> numbers)
{
    std::vector<Fragment> some;
    for (const std::size_t i : numbers) some.push_back(kFiveLayers[i]);
    return composite(some, kBackdrop);
}

TEST(ReferenceBucketPeeling, FiveLayersInEveryOrder)
{
    for_every_order([](const auto& f) {
        expect_same(bucket_peeling(f, {32}, kBackdrop), composite(f, kBackdrop));
        expect_same(bucket_peeling(f, {32, false}, kBackdrop), composite(f, kBackdrop));
        // From .2 to .9 in two: three and two layers.
        expect_same(bucket_peeling(f, {2, true}, kBackdrop), of_five({0, 2, 3, 4}));
        expect_same(bucket_peeling(f, {2, false}, kBackdrop), of_five({0, 3}));
        expect_same(bucket_peeling(f, {2, false, 2}, kBackdrop), of_five({0, 1, 3, 4}));
        expect_same(bucket_peeling(f, {2, true, 2}, kBackdrop), composite(f, kBackdrop));
        expect_same(bucket_peeling(f, {1, true}, kBackdrop), of_five({0, 4}));
    });
}

TEST(ReferenceBucketPeeling, BucketsAreEquallyLong)
{
    const std::vector<Fragment> fragments = {{1, 0.5, {}, 1},
                                             {1.2499, 0.5, {}, 2},
                                             {1.25, 0.5, {}, 3},
                                             {1.9999, 0.5, {}, 4},
                                             {2, 0.5, {}, 5}};
    EXPECT_EQ(buckets_of(fragments, {4}), (std::vector{0, 0, 1, 3, 3}));
    const std::vector<Fragment> level = {{3, 0.5, {}, 1}, {3, 0.5, {}, 2}};
    EXPECT_EQ(buckets_of(level, {4}), (std::vector{0, 0}));
    EXPECT_TRUE(buckets_of({}, {4}).empty());
    expect_same(bucket_peeling({}, {4}, kBackdrop), kBackdrop);
}

TEST(ReferenceBucketPeeling, TiesGoById)
{
    const std::vector<Fragment> level = {
        {3, 0.5, {0, 0, 1}, 3}, {3, 0.5, {1, 0, 0}, 1}, {3, 0.5, {0, 1, 0}, 2}};
    expect_same(bucket_peeling(level, {4, false}, {}), {0.5, 0, 0, 0.5});
    expect_same(bucket_peeling(level, {4, true}, {}), {0.5, 0, 0.25, 0.75});
}

TEST(ReferenceBucketPeeling, BinsSpreadFragmentsOverBuckets)
{
    // Four layers close together and one far behind.
    std::vector<Fragment> fragments;
    for (const double z : {0.0, 0.01, 0.02, 0.03, 1.0}) {
        fragments.push_back({z, 0.5, {z, 1 - z, 0.5}, static_cast<std::uint32_t>(z * 100)});
    }
    EXPECT_EQ(buckets_of(fragments, {4}), (std::vector{0, 0, 0, 0, 3}));
    EXPECT_EQ(buckets_of(fragments, {4, true, 1, 1024}), (std::vector{0, 0, 1, 2, 3}));
    EXPECT_EQ(buckets_of(fragments, {8, true, 1, 1024}), (std::vector{0, 1, 2, 3, 4}));
    expect_same(bucket_peeling(fragments, {4, true, 1, 1024}, kBackdrop),
                composite(fragments, kBackdrop));
    EXPECT_GT(bucket_peeling(fragments, {4}, {}).a, 0.8);  // two of five are lost
    EXPECT_LT(bucket_peeling(fragments, {4}, {}).a, 0.9);
}

}  // namespace
}  // namespace sheer::reference
