// shaders/sheer/reduced_moments.glsl in a compute shader: the same bits as in C++.
#include <bit>
#include <cstddef>

#include <gtest/gtest.h>

#include "lanes/lone.h"
#include "support/random.h"
#include "vulkan/compute_fixture.h"

namespace sheer::test {

namespace {

template <class L>
struct ReducedText {
#include "lanes/text_words.h"
#include "sheer/reduced_moments.glsl"
};

using Text = ReducedText<Lone<float>>;

}  // namespace

using ReducedTextVulkanBits = VulkanBits;

TEST_F(ReducedTextVulkanBits, EachFunction)
{
    constexpr std::size_t kLanes = 20000;
    std::vector<float> numbers;
    for (std::uint32_t i = 0; i < 4 * kLanes; ++i) numbers.push_back(unit_float(hash_u32(i + 1)));
    // No texel sees anything, nothing is missing, or the pixel has nothing.
    for (std::size_t i = 0; i < 4 * kLanes; i += 4) {
        if (i % 5 == 0) numbers[i] = numbers[i + 1] = 0;
        if (i % 7 == 0) numbers[i + 2] = numbers[i];
        if (i % 11 == 0) numbers[i + 2] = 0;
    }
    std::vector<std::uint32_t> words, expected;
    for (const float n : numbers) words.push_back(std::bit_cast<std::uint32_t>(n));
    for (std::size_t i = 0; i < 4 * kLanes; i += 4) {
        const float* n = &numbers[i];
        const auto missing = Text::missing_fragment(n[0], n[1], n[2], n[3]);
        for (const float value :
             {Text::reduced_mix(n[0], n[1], n[2]), missing.keeps, missing.depth, missing.place}) {
            expected.push_back(std::bit_cast<std::uint32_t>(value));
        }
    }
    std::vector<std::vector<std::uint32_t>> buffers = {words,
                                                       std::vector<std::uint32_t>(expected.size())};
    device->run(shader_file("reduced_moments"), {}, buffers, {(kLanes + 63) / 64, 1, 1});
    EXPECT_EQ(buffers[1], expected);
}

TEST(ReducedText, WhatIsMissingBringsThePixelsOwnSums)
{
    using Wide = ReducedText<Lone<double>>;
    // 0.5 at the mean place -0.2 are known of 0.75 at 0.1: 0.25 at 0.7 are not.
    const auto more = Wide::missing_fragment(0.5, -0.1, 0.75, 0.075);
    EXPECT_EQ(more.keeps, 1);
    EXPECT_DOUBLE_EQ(more.depth, 0.25);
    EXPECT_DOUBLE_EQ(more.place, 0.7);
    const auto less = Wide::missing_fragment(0.5, 0, 0.125, 0);
    EXPECT_EQ(less.keeps, 0.25);
    EXPECT_EQ(less.depth, 0);
}

}  // namespace sheer::test
