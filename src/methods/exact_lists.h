// The fragments that `exact` keeps of a tile, and where those of each pixel are.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory_resource>
#include <vector>

#include <hwy/cache_control.h>

#include "methods/exact_layers.h"
#include "support/pages.h"

namespace sheer {

template <class Layer>
struct ExactLists {
    std::pmr::vector<Layer> layers;          // as they came
    std::pmr::vector<std::uint16_t> pixels;  // of each layer
    std::pmr::vector<float> depths;          // of each, at the first sample that it covers
    std::pmr::vector<LayerRun> runs;
    std::vector<std::uint32_t> counts = std::vector<std::uint32_t>(kTilePixels);  // of layers
    std::uint32_t most_in_pixel = 0;
    // After `list`: the layers of pixel p are by_pixel[first[p] .. first[p + 1]), each its depth,
    // as ordered_bits, above its number. Their triangles are roughly near to far, and so are they,
    // but for triangles that overlap in depth.
    std::vector<std::uint32_t> first = std::vector<std::uint32_t>(kTilePixels + 1);
    std::pmr::vector<std::uint64_t> by_pixel;

    explicit ExactLists(std::pmr::memory_resource* memory)
        : layers(memory),
          pixels(memory),
          depths(memory),
          runs(memory),
          by_pixel(memory),
          bucket_of_(memory),
          near_to_far_(memory)
    {
    }

    static constexpr std::size_t kBytesOfLayer =
        sizeof(Layer) + sizeof(pixels[0]) + sizeof(depths[0]) + sizeof(by_pixel[0]);
    static constexpr std::size_t kBytesOfRun = sizeof(LayerRun) + 2 * sizeof(std::uint32_t);

    void clear()
    {
        layers.clear();
        pixels.clear();
        depths.clear();
        runs.clear();
        std::fill(counts.begin(), counts.end(), 0);
        most_in_pixel = 0;
    }

    // Room that is needed at once, where memory is short: vectors that grow hold their old contents
    // beside the new for a while. It costs nothing before it is used.
    void reserve(std::size_t most_bytes)
    {
        layers.reserve(most_bytes / kBytesOfLayer);
        pixels.reserve(most_bytes / kBytesOfLayer);
        depths.reserve(most_bytes / kBytesOfLayer);
        by_pixel.reserve(most_bytes / kBytesOfLayer);
        runs.reserve(most_bytes / kBytesOfRun);
    }

    void give_back()
    {
        sheer::give_back(layers);
        sheer::give_back(pixels);
        sheer::give_back(depths);
        sheer::give_back(runs);
        sheer::give_back(by_pixel);
        sheer::give_back(bucket_of_);
        sheer::give_back(near_to_far_);
    }

    void count(const FragmentStream& f)
    {
        for (std::size_t i = 0; i < static_cast<std::size_t>(f.size); ++i) {
            most_in_pixel = std::max(most_in_pixel, ++counts[f.pixel[i]]);
        }
    }

    void insert(const FragmentStream& f, const SampleSet& set)
    {
        const std::size_t old = layers.size();
        const std::size_t size = old + static_cast<std::size_t>(f.size);
        layers.resize(size);
        pixels.resize(size);
        depths.resize(size);
        // A stream's runs follow one another and hold all of it.
        for (std::size_t i = old; i < size; ++i) {
            pixels[i] = static_cast<std::uint16_t>(f.pixel[i - old]);
        }
        std::size_t to = old;
        for (std::size_t r = 0; r < static_cast<std::size_t>(f.run_count); ++r) {
            const FragmentRun& run = f.runs[r];
            const auto number = static_cast<std::uint32_t>(runs.size());
            runs.push_back({run.depth, run.primitive, static_cast<std::uint32_t>(to)});
            for (std::size_t i = run.first; i < run.first + run.count; ++i, ++to) {
                layers[to].set(f, i, number);
                const auto s = static_cast<std::size_t>(std::countr_zero(layers[to].bits()));
                depths[to] = sample_depth_at(run.depth, set, f.depth[i], s);
            }
        }
    }

    void merge(const ExactLists& other)
    {
        for (std::size_t p = 0; p < kTilePixels; ++p) {
            counts[p] += other.counts[p];
            most_in_pixel = std::max(most_in_pixel, counts[p]);
        }
        const auto run_shift = static_cast<std::uint32_t>(runs.size());
        const auto shift = static_cast<std::uint32_t>(layers.size());
        pixels.insert(pixels.end(), other.pixels.begin(), other.pixels.end());
        depths.insert(depths.end(), other.depths.begin(), other.depths.end());
        for (LayerRun run : other.runs) {
            run.first += shift;
            runs.push_back(run);
        }
        for (Layer layer : other.layers) {
            layer.run += run_shift;
            layers.push_back(layer);
        }
    }

    // A counting sort by pixel, of triangles roughly near to far.
    void list()
    {
        order_runs();
        first[0] = 0;
        for (std::size_t p = 0; p < kTilePixels; ++p) first[p + 1] = first[p] + counts[p];
        if (by_pixel.size() < layers.size()) by_pixel.resize(layers.size());
        for (std::size_t r = 0; r < runs.size(); ++r) {
            if (r + kRunsAhead < runs.size()) {
                const std::size_t next = runs[near_to_far_[r + kRunsAhead]].first;
                hwy::Prefetch(&pixels[next]);
                hwy::Prefetch(&depths[next]);
            }
            const std::size_t run = near_to_far_[r];
            const std::size_t end = run + 1 < runs.size() ? runs[run + 1].first : layers.size();
            for (std::size_t i = runs[run].first; i < end; ++i) {
                by_pixel[first[pixels[i]]++] = ordered_bits(depths[i]) << 32 | i;
            }
        }
        for (std::size_t p = kTilePixels; p > 0; --p) first[p] = first[p - 1];
        first[0] = 0;
    }

private:
    // By the depth at their first layer: a counting sort over equal parts of the depths that there
    // are. What is left to do, pixels do.
    void order_runs()
    {
        constexpr std::size_t kBuckets = 4096;
        constexpr float kInfinity = std::numeric_limits<float>::infinity();
        float least = kInfinity, most = -kInfinity;
        for (const LayerRun& run : runs) {
            least = std::min(least, depths[run.first]);
            most = std::max(most, depths[run.first]);
        }
        const float scale = static_cast<float>(kBuckets - 1) / (most - least);
        std::vector<std::uint32_t> begin(kBuckets + 1);
        bucket_of_.resize(runs.size());
        for (std::size_t r = 0; r < runs.size(); ++r) {
            const float bucket = (depths[runs[r].first] - least) * scale;
            // Also where all are equal, or infinite: then it is no number.
            const bool inside = bucket >= 0 && bucket < static_cast<float>(kBuckets);
            bucket_of_[r] = inside ? static_cast<std::uint32_t>(bucket) : 0;
            ++begin[bucket_of_[r] + 1];
        }
        for (std::size_t b = 0; b < kBuckets; ++b) begin[b + 1] += begin[b];
        near_to_far_.resize(runs.size());
        for (std::size_t r = 0; r < runs.size(); ++r) {
            near_to_far_[begin[bucket_of_[r]]++] = static_cast<std::uint32_t>(r);
        }
    }

    static constexpr std::size_t kRunsAhead = 8;

    std::pmr::vector<std::uint32_t> bucket_of_, near_to_far_;
};

}  // namespace sheer
