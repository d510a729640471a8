// shaders/sheer/stochastic_shadow.glsl in a compute shader: the same bits as in C++.
#include <bit>
#include <cstddef>

#include <gtest/gtest.h>

#include "lanes/lone.h"
#include "support/random.h"
#include "vulkan/compute_fixture.h"

namespace sheer::test {

namespace {

template <class L>
struct ShadowText {
#include "lanes/text_words.h"
#include "sheer/stochastic_shadow.glsl"
};

using Text = ShadowText<Lone<float>>;

}  // namespace

using ShadowTextVulkanBits = VulkanBits;

TEST_F(ShadowTextVulkanBits, EachFunction)
{
    constexpr std::size_t kLanes = 20000;
    std::vector<float> numbers;
    for (std::uint32_t i = 0; i < 6 * kLanes; ++i) numbers.push_back(unit_float(hash_u32(i + 1)));
    // Nothing was taken away, or nothing is left, or two depths are equal.
    for (std::size_t i = 0; i < 6 * kLanes; i += 6) {
        if (i % 5 == 0) numbers[i + 4] = 1;
        if (i % 7 == 0) numbers[i + 5] = 0;
        if (i % 11 == 0) numbers[i + 1] = numbers[i];
    }
    std::vector<std::uint32_t> words, expected;
    for (const float n : numbers) words.push_back(std::bit_cast<std::uint32_t>(n));
    const auto expect = [&](float value) {
        expected.push_back(std::bit_cast<std::uint32_t>(value));
    };
    for (std::size_t i = 0; i < 6 * kLanes; i += 6) {
        const float* n = &numbers[i];
        expect(Text::shadow_is_lit(n[0], n[1]) ? 1.0f : 0.0f);
        expect(Text::shadow_depth_at(n[0], n[1], n[2], n[3], n[4]));
        expect(Text::shadow_sum(n[0], n[1], n[2], n[3]));
        expect(Text::shadow_random_place(n[0], n[1], n[2], n[3]));
        expect(Text::shadow_corrected(n[0], n[4], n[5]));
    }
    std::vector<std::vector<std::uint32_t>> buffers = {words,
                                                       std::vector<std::uint32_t>(expected.size())};
    device->run(shader_file("stochastic_shadow"), {}, buffers, {(kLanes + 63) / 64, 1, 1});
    EXPECT_EQ(buffers[1], expected);
}

// The paper's correction: the visibility behind everything becomes the true one, that before
// everything stays 1, and where no sample was taken nothing changes.
TEST(ShadowText, CorrectionEndsAtTheTrueTotal)
{
    EXPECT_EQ(Text::shadow_corrected(0.25f, 0.25f, 0.375f), 0.375f);
    EXPECT_EQ(Text::shadow_corrected(1.0f, 0.25f, 0.375f), 1.0f);
    EXPECT_EQ(Text::shadow_corrected(1.0f, 1.0f, 0.9f), 1.0f);
    // Half of what is stopped at the end is stopped here.
    EXPECT_EQ(Text::shadow_corrected(0.75f, 0.5f, 0.25f), 0.625f);
}

// A footprint 2 texels wide that begins a quarter into the first of three.
TEST(ShadowText, FootprintsCountTexelsInPart)
{
    EXPECT_EQ(Text::shadow_sum(8, 16, 4, 0.25f), 0.75f * 8 + 16 + 0.25f * 4);
}

}  // namespace sheer::test
