// The texts of shaders/sheer/ as GLSL: on the same fragments they give the same bits as the stores
// on every level of vector instructions, and as the texts alone in C++.
#include <gtest/gtest.h>

#include <cmath>

#include "methods/make_lists.h"
#include "methods/methods_with_texts.h"
#include "methods/texts_alone.h"
#include "simd_levels.h"
#include "vulkan/compute_fixture.h"
#include "vulkan/text_runner.h"

namespace sheer::test {
namespace {

class TextVulkanBits : public VulkanBits {
protected:
    void expect_same_bits(const std::vector<FragmentLists>& tiles,
                          const std::vector<std::string>& methods)
    {
        const TextRunner runner(tiles);
        for (const std::string& method : methods) {
            const auto there = runner.run(*device, method);
            for (std::size_t t = 0; t < tiles.size(); ++t) compare(tiles[t], method, there[t]);
        }
    }

private:
    static void compare(const FragmentLists& lists, const std::string& method,
                        const Made<std::uint32_t>& there)
    {
        const std::string what = method + " on " + lists.name;
        const auto alone = make_alone<Lone<float>>(lists, method);
        EXPECT_EQ(difference(words_of(alone.kept), there.kept), "") << what << ", text's store";
        EXPECT_EQ(difference(words_of(alone.colors), there.colors), "") << what << ", text";
        for (const Simd level : simd_levels()) {
            const TargetSet targets = targets_of(level);
            EXPECT_EQ(difference(resolved_by_store(lists, method, targets), there.colors), "")
                << what << ", " << name_of_targets(targets);
        }
    }
};

TEST_F(TextVulkanBits, OnRealAndRandomTiles)
{
    const Scene motor = load("builtin:motor");
    const Scene table = load(SHEER_SOURCE_DIR "/scenes/tea_table.glb");
    // Of 8 samples WithEveryParameter has lists.
    for (const int samples : {1, 4, 64}) {
        std::vector<FragmentLists> tiles = random_lists(samples);
        tiles.push_back(lists_of_fullest_tile(motor, "motor", samples));
        tiles.push_back(lists_of_fullest_tile(table, "tea table", samples));
        expect_same_bits(
            tiles, {"blend", "exact", "weighted-average", "wboit", "stochastic",
                    "stratified-stochastic", "slab", "mlab", "mlcb", "z3", "k-buffer", "hybrid",
                    "adaptive", "phenomenological", "deep-shadow-map", "alpha-test-then-blend",
                    "hashed-alpha-test", "hashed-alpha-to-coverage"});
        // Long texts, whose samples have nothing to do with one another.
        if (samples <= 4) expect_same_bits(tiles, {"moment", "mboit", "fourier", "wavelet"});
        for (std::size_t t = tiles.size() - 2; t < tiles.size(); ++t) {
            tiles[t] = with_exact_depths(std::move(tiles[t]));
        }
        expect_same_bits(tiles, {"depth-peeling", "dual-depth-peeling", "bucket-peeling",
                                 "bucket-peeling:buckets=8:borders=adaptive:peels=2"});
    }
}

TEST_F(TextVulkanBits, WithEveryParameter)
{
    expect_same_bits(random_lists(8), kMethodsWithTexts);
}

// random.comp's results, by Lone.
Words random_words(std::uint32_t i, std::uint32_t seed, float opacity, int samples)
{
    using T = Texts<Lone<float>>;
    std::uint32_t state = seed;
    const std::uint32_t next = T::next_random(state);
    const auto next_real = std::bit_cast<std::uint32_t>(T::next_random_real(state));
    const auto naive = T::naive_mask(seed, opacity, samples);
    std::uint32_t own = seed;
    const float xi = T::next_random_real(own);
    const auto stratified = T::stratified_mask(own, xi, opacity, samples);
    const float dithered = T::dithered_xi(seed & 0x3fffu, i & 0x3fffu, next, own);
    const auto part = T::sample_part(stratified, samples / 2, samples - samples / 2);
    const int count = std::popcount(naive.low) + (samples > 32 ? std::popcount(naive.high) : 0);
    const auto open = T::stratified_mask_of_open(own, xi, opacity, naive,
                                                 static_cast<std::uint32_t>(count), samples);
    const std::uint32_t index = T::mask_table_index(seed, opacity);
    const auto table = T::mask_of_table(index / 2047, index % 2047, samples);
    return {T::hash_whole(seed),
            T::identity_seed(i, seed),
            T::fragment_seed(seed, i, next),
            next,
            next_real,
            state,
            naive.low,
            naive.high,
            stratified.low,
            stratified.high,
            std::bit_cast<std::uint32_t>(dithered),
            part.low,
            part.high,
            open.low,
            open.high,
            index,
            table.low,
            table.high};
}

// The seed whose first random number is `wanted`, of 24 bits: the hash backwards.
std::uint32_t seed_before(std::uint32_t wanted)
{
    std::uint32_t x = wanted << 8;
    x ^= x >> 16;
    x *= 0x43021123u;
    x ^= x >> 15 ^ x >> 30;
    x *= 0x1d69e2a5u;
    x ^= x >> 16;
    return x - 0x9e3779b9u;
}

// Random ones, and those whose first number is at a mask's threshold: at the opacity, at what is
// left of opacity S, or of the opacity in 16 bits.
Words seeds_for(float opacity, int samples)
{
    Words seeds = {0, ~0u};
    for (std::uint32_t i = 0; i < 60; ++i) {
        seeds.push_back(hash_u32(std::bit_cast<std::uint32_t>(opacity) + i));
    }
    for (const float scale : {1.0f, static_cast<float>(samples), 0x1p16f}) {
        const float x = opacity * scale;
        const auto at = static_cast<std::uint32_t>((x - std::floor(x)) * 0x1p24f);
        for (const std::uint32_t wanted : {at - 1, at, at + 1}) {
            seeds.push_back(seed_before(wanted & 0xffffffu));
        }
    }
    return seeds;
}

TEST_F(TextVulkanBits, RandomNumbersAndMasks)
{
    std::uint32_t state = seed_before(0xabcdefu);
    ASSERT_EQ(Texts<Lone<float>>::next_random(state), 0xabcdefu);
    for (const int samples : {1, 2, 4, 8, 16, 32, 64}) {
        std::vector<float> opacities = edge_opacities(samples);
        opacities.push_back(0x1p-126f);
        for (std::uint32_t i = 0; i < 100; ++i) opacities.push_back(unit_float(hash_u32(i + 1)));
        std::vector<float> all_opacities;
        Words seeds, expected;
        for (const float opacity : opacities) {
            for (const std::uint32_t seed : seeds_for(opacity, samples)) {
                const auto i = static_cast<std::uint32_t>(seeds.size());
                const Words here = random_words(i, seed, opacity, samples);
                expected.insert(expected.end(), here.begin(), here.end());
                seeds.push_back(seed);
                all_opacities.push_back(opacity);
            }
        }
        std::vector<Words> buffers = {seeds, words_of(all_opacities), Words(expected.size())};
        const std::vector<SpecializationConstant> constants{
            {0, static_cast<std::uint32_t>(samples)}};
        const auto groups = static_cast<std::uint32_t>((seeds.size() + 63) / 64);
        device->run(shader_file("random"), constants, buffers, {groups, 1, 1});
        EXPECT_EQ(difference(expected, buffers[2]), "") << "S = " << samples;
    }
}

// Over and beyond the distances that the paper gives its weights for.
TEST_F(TextVulkanBits, Weights)
{
    std::vector<float> places;  // z, d, opacity
    for (std::uint32_t i = 0; i < 60000; ++i) {
        const float u = unit_float(hash_u32(3 * i + 1)), v = unit_float(hash_u32(3 * i + 2));
        const float z = i % 8 == 0 ? 0.001f + u : i % 8 == 1 ? 1e4f * u : 0.1f + 500 * u * u;
        const float d = i % 8 == 2 ? 1 - 0x1p-10f * v : v;
        places.insert(places.end(), {z, d, i % 8 == 3 ? 0x1p-20f : 1 - u * v});
    }
    for (const int equation : {0, 7, 8, 9, 10}) {
        std::vector<float> expected;
        for (std::size_t i = 0; i < places.size(); i += 3) {
            expected.push_back(Texts<Lone<float>>::wboit_weight(equation, places[i], places[i + 1],
                                                                places[i + 2]));
        }
        std::vector<Words> buffers = {words_of(places), Words(expected.size())};
        const std::vector<SpecializationConstant> constants{
            {0, static_cast<std::uint32_t>(equation)}};
        const auto groups = static_cast<std::uint32_t>((expected.size() + 63) / 64);
        device->run(shader_file("weights"), constants, buffers, {groups, 1, 1});
        EXPECT_EQ(difference(words_of(expected), buffers[1]), "") << "equation " << equation;
    }
}

}  // namespace
}  // namespace sheer::test
