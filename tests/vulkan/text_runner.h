// Runs NAME.comp with a method's text on tiles' fragment lists, all in one dispatch.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "methods/rounding.h"
#include "methods/texts_alone.h"
#include "vulkan/compute_fixture.h"

namespace sheer::test {

// As fragment_list.glsl has it.
struct ShaderTile {
    std::uint32_t x, y, key;
    std::uint32_t orthographic;
    float near, far;
    float from, scale;
    float brightest;
};

template <class T>
Words words_of_structs(const std::vector<T>& structs)
{
    static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % 4 == 0);
    Words words(structs.size() * sizeof(T) / 4);
    std::memcpy(words.data(), structs.data(), 4 * words.size());
    return words;
}

class TextRunner {
public:
    // The tiles have the same samples.
    explicit TextRunner(const std::vector<FragmentLists>& tiles)
        : samples_(tiles[0].set.count), tile_count_(tiles.size())
    {
        std::vector<ListedFragment> fragments;
        std::vector<ShaderTile> shader_tiles;
        Words first, colors;
        for (const FragmentLists& lists : tiles) {
            const auto base = static_cast<std::uint32_t>(fragments.size());
            fragments.insert(fragments.end(), lists.fragments.begin(), lists.fragments.end());
            for (std::size_t p = 0; p < kTilePixels; ++p) first.push_back(base + lists.first[p]);
            const TilePlace& place = lists.place;
            const DepthRange range = depth_range_of(lists);
            shader_tiles.push_back(
                {static_cast<std::uint32_t>(place.x), static_cast<std::uint32_t>(place.y),
                 place.key, lists.eye.orthographic ? 1u : 0u, lists.eye.znear, lists.eye.zfar,
                 range.from, range.scale, std::ldexp(1.0f, brightest_exponent(lists))});
            const Words behind = words_of(make_backdrop(samples_).values);
            colors.insert(colors.end(), behind.begin(), behind.end());
        }
        first.push_back(static_cast<std::uint32_t>(fragments.size()));
        buffers_ = {words_of_structs(fragments), first,
                    offset_words(tiles[0]),      words_of_structs(shader_tiles),
                    sorted_words(tiles),         colors,
                    Words(colors.size() / 4 * 5)};
    }

    // Bits of floats, tile by tile.
    std::vector<Made<std::uint32_t>> run(ComputeDevice& device,
                                         const std::string& method_text) const
    {
        const ChosenMethod method = choose_method(method_text);
        std::string name = method.row->id;
        std::replace(name.begin(), name.end(), '-', '_');
        if (name == "stochastic" && method.value("depth-based") == "on") name += "_depth";
        std::vector<Words> buffers = buffers_;
        const std::size_t lanes = kTilePixels * static_cast<std::size_t>(samples_);  // of a tile
        const auto groups = static_cast<std::uint32_t>(tile_count_ * lanes / 64);
        device.run(shader_file(name), constants(method), buffers, {groups, 1, 1});
        std::vector<Made<std::uint32_t>> results;
        for (std::size_t t = 0; t < tile_count_; ++t) {
            const auto part = [&](const Words& words, std::size_t channels) {
                const std::span all(words);
                const auto some = all.subspan(t * lanes * channels, lanes * channels);
                return Words(some.begin(), some.end());
            };
            results.push_back({part(buffers[5], 4), part(buffers[6], 5)});
        }
        return results;
    }

private:
    static Words offset_words(const FragmentLists& lists)
    {
        std::vector<float> offsets;
        for (std::size_t s = 0; s < lists.samples(); ++s) {
            offsets.push_back(lists.set.offset_x[s]);
            offsets.push_back(lists.set.offset_y[s]);
        }
        return words_of(offsets);
    }

    // Of each sample, tile after tile.
    static Words sorted_words(const std::vector<FragmentLists>& tiles)
    {
        Words words;
        for (std::size_t s = 0; s < tiles[0].samples(); ++s) {
            std::uint32_t base = 0;
            for (const FragmentLists& lists : tiles) {
                const std::size_t count = lists.fragments.size();
                for (std::size_t i = 0; i < count; ++i) {
                    words.push_back(base + lists.sorted[s * count + i]);
                }
                base += static_cast<std::uint32_t>(count);
            }
        }
        return words;
    }

    std::vector<SpecializationConstant> constants(const ChosenMethod& method) const
    {
        const std::string id = method.row->id;
        std::vector<SpecializationConstant> all = {{0, static_cast<std::uint32_t>(samples_)}};
        if (id == "wboit") {
            all.push_back({1, static_cast<std::uint32_t>(wboit_equation(method))});
            all.push_back({2, method.value("weight") == "range" ? 1u : 0u});
        }
        if (id == "stochastic") {
            const std::string& by = method.value("seed-by");
            all.push_back({1, method.value("masks") == "stratified" ? 1u : 0u});
            all.push_back({2, by == "depth"       ? 0u
                              : by == "primitive" ? 1u
                              : by == "object"    ? 2u
                                                  : 3u});
            all.push_back({3, method.value("round") == "tile-dither" ? 1u : 0u});
            all.push_back({4, method.value("correction") == "on" ? 1u : 0u});
        }
        if (id == "slab") {
            const SlabSettings settings = slab_settings(method);
            all.push_back({1, static_cast<std::uint32_t>(settings.layers)});
            all.push_back({2, static_cast<std::uint32_t>(settings.bits)});
            all.push_back({3, settings.has_masks() ? 1u : 0u});
            all.push_back({4, settings.stratified ? 1u : 0u});
            all.push_back({5, settings.in_depth ? 1u : 0u});
            all.push_back({6, static_cast<std::uint32_t>(settings.keep)});
            all.push_back({7, settings.depth_based ? 1u : 0u});
            all.push_back({8, settings.adds_tail ? 1u : 0u});
            all.push_back({9, settings.corrects ? 1u : 0u});
        }
        if (id == "mlcb") {
            const SlabSettings settings = mlcb_settings(method);
            all.push_back({1, static_cast<std::uint32_t>(settings.layers)});
            all.push_back({2, static_cast<std::uint32_t>(settings.bits)});
            all.push_back({3, static_cast<std::uint32_t>(settings.keep)});
            all.push_back({4, settings.corrects ? 1u : 0u});
        }
        if (id == "mlab" || id == "z3" || id == "k-buffer" || id == "hybrid") {
            all.push_back({1, static_cast<std::uint32_t>(method.number("layers"))});
        }
        if (id == "adaptive") {
            all.push_back({1, static_cast<std::uint32_t>(method.number("nodes"))});
        }
        if (id.ends_with("depth-peeling")) {
            all.push_back({1, static_cast<std::uint32_t>(method.number("peels"))});
        }
        if (id == "bucket-peeling") {
            all.push_back({1, static_cast<std::uint32_t>(method.number("buckets"))});
            all.push_back({2, method.value("borders") == "adaptive" ? 1u : 0u});
            all.push_back({3, static_cast<std::uint32_t>(method.number("peels"))});
        }
        if (id == "deep-shadow-map") {
            const DeepShadowSettings settings = deep_shadow_settings(method);
            all.push_back({1, std::bit_cast<std::uint32_t>(settings.error)});
            all.push_back({2, settings.corrects ? 1u : 0u});
        }
        if (id == "k-buffer") {
            const std::string& merge = method.value("merge");
            all.push_back({2, merge == "front" ? 0u : merge == "nearest-two" ? 1u : 2u});
        }
        if (id == "hybrid") all.push_back({2, static_cast<std::uint32_t>(hybrid_kind(method))});
        if (id == "moment") add_moment_constants(moment_settings(method), all);
        if (id == "mboit") add_mboit_constants(mboit_settings(method), all);
        if (id == "fourier") {
            all.push_back({1, static_cast<std::uint32_t>(method.number("terms"))});
            all.push_back({2, method.value("window") == "lanczos" ? 1u : 0u});
        }
        if (id == "wavelet") all.push_back({1, static_cast<std::uint32_t>(method.number("rank"))});
        if (is_alpha_test(method) || id == "alpha-test-then-blend") add_alpha_test(method, all);
        if (id == "stratified-stochastic") {
            const StratifiedSettings settings = stratified_settings(method);
            all.push_back({1, settings.tracking ? 1u : 0u});
            all.push_back({2, settings.compaction ? 1u : 0u});
            all.push_back({3, settings.sort ? 1u : 0u});
            all.push_back({4, static_cast<std::uint32_t>(settings.dither)});
            all.push_back({5, static_cast<std::uint32_t>(settings.sequence)});
        }
        return all;
    }

    static void add_moment_constants(const MomentSettings& settings,
                                     std::vector<SpecializationConstant>& all)
    {
        all.push_back({1, static_cast<std::uint32_t>(settings.passes)});
        all.push_back({2, static_cast<std::uint32_t>(settings.format)});
        all.push_back({3, settings.adapts ? 1u : 0u});
        all.push_back({4, std::bit_cast<std::uint32_t>(settings.overestimation)});
        add_doubles({settings.bias, settings.even2, settings.even4}, 5, all);
    }

    static void add_mboit_constants(const MboitSettings& settings,
                                    std::vector<SpecializationConstant>& all)
    {
        all.push_back({1, settings.trigonometric ? 1u : 0u});
        all.push_back({2, static_cast<std::uint32_t>(settings.half)});
        all.push_back({3, settings.rounded ? 1u : 0u});
        all.push_back({4, std::bit_cast<std::uint32_t>(settings.overestimation)});
        const WrappingZone zone = wrapping_zone();
        add_doubles({settings.bias, settings.even[1], settings.even[2], settings.even[3],
                     settings.even[4], zone.half_depth},
                    5, all);
        std::uint32_t id = 17;
        for (const double number : {zone.edge, zone.cosine, zone.sine, zone.begins, zone.rest}) {
            all.push_back({id++, std::bit_cast<std::uint32_t>(static_cast<float>(number))});
        }
    }

    // Each as two words, the lower one first.
    static void add_doubles(std::initializer_list<double> numbers, std::uint32_t id,
                            std::vector<SpecializationConstant>& all)
    {
        for (const double number : numbers) {
            const auto bits = std::bit_cast<std::uint64_t>(number);
            all.push_back({id++, static_cast<std::uint32_t>(bits)});
            all.push_back({id++, static_cast<std::uint32_t>(bits >> 32)});
        }
    }

    static void add_alpha_test(const ChosenMethod& method, std::vector<SpecializationConstant>& all)
    {
        const std::string id = method.row->id;
        const auto is = [&](const char* name, const char* value) {
            return method.value(name) == value ? 1u : 0u;
        };
        if (id == "alpha-test" || id == "alpha-test-then-blend") {
            all.push_back(
                {1, std::bit_cast<std::uint32_t>(static_cast<float>(method.real("cutoff")))});
        }
        if (id == "stochastic-alpha-test") all.push_back({1, is("threshold", "sample")});
        if (id == "screen-door") {
            const int square = method.number("square");
            all.push_back({1, square == 2 ? 1u : square == 4 ? 2u : 3u});
            all.push_back({2, is("decorrelate", "object")});
            all.push_back({3, 1 - is("decorrelate", "off")});
            all.push_back({4, is("jitter", "on")});
        }
        if (!id.starts_with("hashed")) return;
        const HashedSettings settings = hashed_settings(method);
        all.push_back({1, static_cast<std::uint32_t>(settings.variant)});
        all.push_back({2, std::bit_cast<std::uint32_t>(settings.hash_scale)});
        all.push_back({3, static_cast<std::uint32_t>(settings.hash)});
        all.push_back({4, settings.octaves ? 1u : 0u});
        all.push_back({5, settings.uniform ? 1u : 0u});
        all.push_back({6, settings.third ? 1u : 0u});
        if (id == "hashed-alpha-test") {
            all.push_back({7, std::bit_cast<std::uint32_t>(fade_in_levels(method))});
            return;
        }
        all.push_back({7, is("jitter", "sample")});
        all.push_back({8, is("decorrelate", "on")});
    }

    int samples_;
    std::size_t tile_count_;
    std::vector<Words> buffers_;
};

}  // namespace sheer::test
