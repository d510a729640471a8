#include "reference/bucket_peeling.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>

namespace sheer::reference {
namespace {

bool nearer(const Fragment& a, const Fragment& b)
{
    return std::tie(a.depth, a.id) < std::tie(b.depth, b.id);
}

// Which of n equal parts of the fragments' range each lies in.
std::vector<int> equal_parts(std::span<const Fragment> fragments, int n)
{
    std::vector<int> parts;
    if (fragments.empty()) return parts;
    const auto [nearest, farthest] =
        std::minmax_element(fragments.begin(), fragments.end(), nearer);
    const double range = farthest->depth - nearest->depth;
    for (const Fragment& f : fragments) {
        const double at = range > 0 ? (f.depth - nearest->depth) / range * n : 0;
        parts.push_back(std::min(static_cast<int>(std::floor(at)), n - 1));
    }
    return parts;
}

// What the passes take of one bucket.
void peel(std::vector<Fragment> bucket, const BucketPeeling& how, std::vector<Fragment>& taken)
{
    std::sort(bucket.begin(), bucket.end(), nearer);
    for (int pass = 0; pass < how.passes && !bucket.empty(); ++pass) {
        taken.push_back(bucket.front());
        bucket.erase(bucket.begin());
        if (!how.both_ends || bucket.empty()) continue;
        taken.push_back(bucket.back());
        bucket.pop_back();
    }
}

}  // namespace

std::vector<int> buckets_of(std::span<const Fragment> fragments, const BucketPeeling& how)
{
    if (how.bins == 0) return equal_parts(fragments, how.buckets);
    std::vector<int> buckets = equal_parts(fragments, how.bins);
    std::vector<int> occupied = buckets;
    std::sort(occupied.begin(), occupied.end());
    occupied.erase(std::unique(occupied.begin(), occupied.end()), occupied.end());
    const int n = static_cast<int>(occupied.size());
    for (int& bucket : buckets) {
        const auto bin = std::lower_bound(occupied.begin(), occupied.end(), bucket);
        const int i = static_cast<int>(bin - occupied.begin());
        bucket = n > how.buckets ? i * how.buckets / n : i;
    }
    return buckets;
}

Rgba bucket_peeling(std::span<const Fragment> fragments, const BucketPeeling& how, Rgba backdrop)
{
    std::vector<std::vector<Fragment>> buckets(static_cast<std::size_t>(how.buckets));
    const std::vector<int> numbers = buckets_of(fragments, how);
    for (std::size_t i = 0; i < fragments.size(); ++i) {
        buckets[static_cast<std::size_t>(numbers[i])].push_back(fragments[i]);
    }
    std::vector<Fragment> taken;
    for (const std::vector<Fragment>& bucket : buckets) peel(bucket, how, taken);
    return composite(taken, backdrop);
}

}  // namespace sheer::reference
