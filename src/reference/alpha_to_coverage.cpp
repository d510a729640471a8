#include "reference/alpha_to_coverage.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>

namespace sheer::reference {
namespace {

double binomial(int n, int k)
{
    if (k < 0 || k > n) return 0;
    double result = 1;
    for (int i = 0; i < k; ++i) result = result * (n - i) / (i + 1);
    return result;
}

// Samples of which equation 9's order is below `count`.
std::uint64_t first_samples(int n, int offset, int increment, int count)
{
    std::uint64_t mask = 0;
    for (int i = 0; i < n; ++i) {
        if ((offset + i * increment) % n < count) mask |= std::uint64_t{1} << i;
    }
    return mask;
}

// Of two sets of samples, by all offsets and increments, or whatever `masks` has.
std::vector<double> overlap_of_counts(int n, int r1, int r2, CoverageMasks masks)
{
    std::vector<double> chances(static_cast<std::size_t>(n) + 1);
    if (masks == CoverageMasks::any_set) {
        for (int h = 0; h <= n; ++h) {
            chances[static_cast<std::size_t>(h)] =
                binomial(r1, h) * binomial(n - r1, r2 - h) / binomial(n, r2);
        }
        return chances;
    }
    if (masks != CoverageMasks::decorrelated) {
        chances[static_cast<std::size_t>(std::min(r1, r2))] = 1;
        return chances;
    }
    std::vector<std::uint64_t> first, second;
    for (int offset = 0; offset < n; ++offset) {
        for (int increment = 1; increment < n || increment == 1; increment += 2) {
            first.push_back(first_samples(n, offset, increment, r1));
            second.push_back(first_samples(n, offset, increment, r2));
        }
    }
    const double each = 1 / static_cast<double>(first.size() * second.size());
    for (const std::uint64_t a : first) {
        for (const std::uint64_t b : second) {
            chances[static_cast<std::size_t>(std::popcount(a & b))] += each;
        }
    }
    return chances;
}

}  // namespace

double fixed_threshold(int i, int n)
{
    return (i + 0.5) / n;
}

double jittered_threshold(int i, int n, double chi)
{
    return (i + chi) / n;
}

double decorrelated_threshold(int i, int n, double chi, int offset, int increment)
{
    return (chi + (offset + i * increment) % n) / n;
}

int decorrelated_offset(int n, double xi1)
{
    return static_cast<int>(std::floor(n * xi1));
}

int decorrelated_increment(int n, double xi2)
{
    return 2 * static_cast<int>(std::floor(n * xi2 / 2)) + 1;
}

std::vector<double> count_chances(int n, double alpha, CoverageMasks masks)
{
    std::vector<double> chances(static_cast<std::size_t>(n) + 1);
    const double bits = alpha * n, whole = std::floor(bits);
    if (masks == CoverageMasks::fixed) {
        chances[static_cast<std::size_t>(std::floor(bits + 0.5))] = 1;
        return chances;
    }
    chances[static_cast<std::size_t>(whole)] = 1 - (bits - whole);
    if (bits > whole) chances[static_cast<std::size_t>(whole) + 1] = bits - whole;
    return chances;
}

std::vector<double> overlap_chances(int n, double alpha1, double alpha2, CoverageMasks masks)
{
    std::vector<double> chances(static_cast<std::size_t>(n) + 1);
    const auto counts1 = count_chances(n, alpha1, masks), counts2 = count_chances(n, alpha2, masks);
    for (int r1 = 0; r1 <= n; ++r1) {
        for (int r2 = 0; r2 <= n; ++r2) {
            const double both =
                counts1[static_cast<std::size_t>(r1)] * counts2[static_cast<std::size_t>(r2)];
            if (both == 0) continue;
            const auto overlap = overlap_of_counts(n, r1, r2, masks);
            for (std::size_t h = 0; h < chances.size(); ++h) chances[h] += both * overlap[h];
        }
    }
    return chances;
}

}  // namespace sheer::reference
