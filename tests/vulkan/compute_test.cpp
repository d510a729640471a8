// The device that texts run on: that data reaches it, and that it computes the bits that C++ does.
#include "vulkan/compute.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/random.h"
#include "vulkan/compute_fixture.h"

namespace sheer::test {
namespace {

using Words = std::vector<std::uint32_t>;

// What the probes call.
using std::floor;
using std::max;
using std::min;
using std::sqrt;
#include "vulkan/probe_moments.glsl"

constexpr std::uint32_t kProbes = 17;
constexpr std::uint32_t kOperands = 8;
constexpr std::uint32_t kRows = 4096;
constexpr std::uint32_t kLanes = 64;  // of a work group of probes.comp

Words words_of(const std::vector<float>& numbers)
{
    Words words;
    for (const float number : numbers) words.push_back(std::bit_cast<std::uint32_t>(number));
    return words;
}

// From 2^-6 to 2: far from where a device may flush results to zero.
Words probe_operands()
{
    const CounterRandom random{7};
    std::vector<float> operands;
    for (std::uint32_t i = 0; i < kOperands * kRows; ++i) {
        const float mantissa = 1.0f + static_cast<float>(random.bits(2 * i) >> 41) * 0x1p-23f;
        operands.push_back(std::ldexp(mantissa, -static_cast<int>(random.bits(2 * i + 1) % 7)));
    }
    return words_of(operands);
}

Words probe_here(const Words& operands)
{
    std::vector<float> results(kProbes * kRows);
    for (std::uint32_t row = 0; row < kRows; ++row) {
        const auto at = [&](std::uint32_t i) {
            return std::bit_cast<float>(operands[kOperands * row + i]);
        };
        const float a = at(0), b = at(1), c = at(2), d = at(3);
        const float e = at(4), f = at(5), g = at(6), h = at(7);
#define PROBE(index) results[kProbes * row + (index)]
#include "vulkan/probes.glsl"
#undef PROBE
    }
    return words_of(results);
}

Words probe_there(ComputeDevice& device, const std::string& shader, const Words& operands)
{
    std::vector<Words> buffers{operands, Words(kProbes * kRows)};
    const std::vector<SpecializationConstant> constants{{0, kProbes}};
    device.run(shader_file(shader), constants, buffers, {kRows / kLanes, 1, 1});
    EXPECT_EQ(buffers[0], operands);
    return buffers[1];
}

// Which probes differ anywhere.
std::set<std::uint32_t> differing(const Words& one, const Words& other)
{
    std::set<std::uint32_t> probes;
    for (std::uint32_t i = 0; i < kProbes * kRows; ++i)
        if (one[i] != other[i]) probes.insert(i % kProbes);
    return probes;
}

TEST_F(VulkanTest, BuffersAndConstantsArrive)
{
    constexpr std::uint32_t kCount = 1000;  // not a multiple of the work group's 32
    Words given, added;
    std::vector<float> numbers, scaled;
    for (std::uint32_t i = 0; i < kCount; ++i) {
        given.push_back(hash_u32(i));
        added.push_back(hash_u32(i) + 41);
        numbers.push_back(static_cast<float>(i));
        scaled.push_back(static_cast<float>(i) * 0.75f);
    }
    std::vector<Words> buffers{given, Words(kCount), {}};
    const std::vector<SpecializationConstant> constants{{3, 41},
                                                        {5, std::bit_cast<std::uint32_t>(0.75f)}};
    for (int run = 0; run < 2; ++run) {
        buffers[2] = words_of(numbers);
        device->run(shader_file("scale"), constants, buffers, {(kCount + 31) / 32, 1, 1});
        EXPECT_EQ(buffers[0], given);
        EXPECT_EQ(buffers[1], added);
        EXPECT_EQ(buffers[2], words_of(scaled));
    }
}

TEST_F(VulkanTest, MissingShaderIsNamed)
{
    try {
        device->run("no/such.spv", {}, {}, {1, 1, 1});
        FAIL();
    } catch (const std::runtime_error& error) {
        EXPECT_STREQ(error.what(), "no/such.spv: no such file");
    }
}

TEST_F(VulkanBits, ArithmeticIsThatOfCpp)
{
    const Words operands = probe_operands();
    const Words here = probe_here(operands);
    EXPECT_EQ(differing(here, probe_there(*device, "probes", operands)), std::set<std::uint32_t>{})
        << "on " << device->name();
}

// Without the decorations the same text gives other bits; if that ends, the pass can go.
TEST_F(VulkanBits, NoContractionIsNeeded)
{
    const Words operands = probe_operands();
    const Words here = probe_here(operands);
    EXPECT_FALSE(differing(here, probe_there(*device, "probes_rearranged", operands)).empty())
        << "on " << device->name();
}

}  // namespace
}  // namespace sheer::test
