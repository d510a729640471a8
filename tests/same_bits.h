// One picture, bit for bit, on every level of vector instructions and any number of threads.
#pragma once

#include <string>

#include <gtest/gtest.h>

#include <sheer/sheer.h>

#include "simd_levels.h"

namespace sheer {

// Against one thread without vector instructions. What threads do does not depend on the level, so
// each level has two threads and the best one 1 and 7, too.
inline void expect_same_bits(const Scene& scene, const View& view, const std::string& method,
                             const std::string& what)
{
    Options options;
    options.method = method;
    options.threads = 1;
    options.simd = Simd::scalar;
    const Image expected = render(scene, view, options).image;
    const auto compare = [&](Simd level, int threads) {
        options.simd = level;
        options.threads = threads;
        const Frame frame = render(scene, view, options);
        EXPECT_EQ(frame.image.pixels, expected.pixels)
            << what << ", " << method << ", S = " << view.samples << ", " << frame.stats.simd
            << ", " << threads << " threads";
    };
    for (const Simd level : simd_levels()) compare(level, 2);
    for (const int threads : {1, 7}) compare(Simd::best, threads);
}

inline void expect_same_bits(const std::string& source, const View& view, const std::string& method)
{
    expect_same_bits(load(source), view, method, source);
}

}  // namespace sheer
