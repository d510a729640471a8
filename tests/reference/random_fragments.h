// Lists of fragments and masks from a seed; the same on every machine.
#pragma once

#include <algorithm>
#include <bitset>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "reference/reference.h"

namespace sheer::reference {

class RandomFragments {
public:
    explicit RandomFragments(std::uint32_t seed) : random_(seed) {}

    double uniform() { return static_cast<double>(random_()) * 0x1p-32; }  // in [0, 1)
    std::size_t below(std::size_t n) { return static_cast<std::size_t>(uniform() * double(n)); }

    // Depths in [0, 1), all different, alphas in [0, 1).
    std::vector<Fragment> list(std::size_t n)
    {
        std::vector<Fragment> fragments;
        for (std::uint32_t id = 0; id < n; ++id) {
            const double depth = uniform(), alpha = uniform();
            fragments.push_back({depth, alpha, {uniform(), uniform(), uniform()}, id});
        }
        return fragments;
    }

    template <typename T>
    void shuffle(std::vector<T>& items)
    {
        for (std::size_t n = items.size(); n > 1; --n) std::swap(items[n - 1], items[below(n)]);
    }

    // floor(alpha b + xi) of b bits, all such sets equally likely.
    std::bitset<128> mask(double alpha, std::size_t b)
    {
        std::vector<std::size_t> bits(b);
        for (std::size_t i = 0; i < b; ++i) bits[i] = i;
        shuffle(bits);
        bits.resize(static_cast<std::size_t>(std::floor(alpha * double(b) + uniform())));
        std::bitset<128> mask;
        for (const std::size_t bit : bits) mask.set(bit);
        return mask;
    }

    std::vector<std::bitset<128>> masks(const std::vector<Fragment>& fragments, int b)
    {
        std::vector<std::bitset<128>> result;
        for (const Fragment& f : fragments) {
            result.push_back(mask(f.opacity, static_cast<std::size_t>(b)));
        }
        return result;
    }

private:
    std::mt19937 random_;
};

}  // namespace sheer::reference
