// Random numbers by counting: each is a hash of what it is for, so that neither the order of the
// work nor the number of threads shows in a picture.
#pragma once

#include <cstdint>

namespace sheer {

// "lowbias32", found by Christopher Wellons's search for the two-round xorshift-multiply hash with
// the least bias (Prospecting for Hash Functions, 2018). A bijection; 0 goes to 0.
constexpr std::uint32_t hash_u32(std::uint32_t x)
{
    x ^= x >> 16;
    x *= 0x7feb352du;
    x ^= x >> 15;
    x *= 0x846ca68bu;
    x ^= x >> 16;
    return x;
}

// The finaliser of splitmix64 (Steele, Lea and Flood. Fast Splittable Pseudorandom Number
// Generators. OOPSLA 2014; constants: David Stafford's mix 13). A bijection; 0 goes to 0.
constexpr std::uint64_t mix64(std::uint64_t x)
{
    x ^= x >> 30;
    x *= 0xbf58476d1ce4e5b9u;
    x ^= x >> 27;
    x *= 0x94d049bb133111ebu;
    x ^= x >> 31;
    return x;
}

// In [0, 1): the upper 24 bits, which a float holds exactly.
constexpr float unit_float(std::uint32_t x)
{
    return static_cast<float>(x >> 8) * 0x1p-24f;
}

// The sequence of splitmix64, any member of it at once.
struct CounterRandom {
    std::uint64_t seed = 0;

    constexpr std::uint64_t bits(std::uint64_t counter) const
    {
        // Mixing the seed keeps the sequences of neighbouring seeds from being one, shifted.
        constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15u;  // 2^64 / golden ratio, odd
        return mix64(mix64(seed) + (counter + 1) * kGolden);
    }

    // In [0, 1): 53 bits.
    constexpr double uniform(std::uint64_t counter) const
    {
        return static_cast<double>(bits(counter) >> 11) * 0x1p-53;
    }
};

}  // namespace sheer
