// A tile's fragments twice: as the streams that stores are fed, and as a list for each pixel, which
// is what a text wants, in C++ or in a shader. Made in make_lists.h.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <numeric>
#include <string>
#include <tuple>
#include <vector>

#include "methods/method.h"
#include "support/random.h"

namespace sheer::test {

// As tests/vulkan/fragment_list.glsl has it.
struct ListedFragment {
    std::uint32_t low, high;  // covered samples
    std::uint32_t primitive, object;
    float red, green, blue, opacity;
    float center, dx, dy, least, most;  // depth at the pixel's centre, and its plane
    std::uint32_t back_facing;
    std::array<float, 9> place;  // FragmentStream::place
    float level;                 // FragmentStream::level
};

struct FragmentLists {
    std::string name;
    SampleSet set;
    EyeSpace eye;
    TilePlace place;
    FragmentStream stream;
    std::vector<std::uint32_t> first;       // pixel p has the fragments [first[p], first[p + 1])
    std::vector<ListedFragment> fragments;  // of a pixel in order of arrival
    // Fragment i in the order of depth at sample s: element s * fragments.size() + i.
    std::vector<std::uint32_t> sorted;

    std::size_t samples() const { return static_cast<std::size_t>(set.count); }
    bool covers(std::size_t fragment, std::size_t s) const
    {
        const ListedFragment& f = fragments[fragment];
        return ((s < 32 ? f.low : f.high) >> s % 32 & 1) != 0;
    }
    // From the eye, of its pixel's centre.
    float distance_of(std::size_t fragment) const
    {
        const ListedFragment& f = fragments[fragment];
        const float depth = std::min(std::max(f.center, f.least), f.most);
        return eye.orthographic ? depth : -1.0f / depth;
    }
    float depth_at(std::size_t fragment, std::size_t s) const
    {
        const ListedFragment& f = fragments[fragment];
        const float depth = f.center + (set.offset_x[s] * f.dx + set.offset_y[s] * f.dy);
        return std::min(std::max(depth, f.least), f.most);
    }
};

// Fills `sorted`.
inline void sort_by_depth(FragmentLists& lists, const std::vector<DepthPlane>& planes)
{
    std::vector<std::tuple<double, std::uint32_t, std::uint32_t>> order;  // of a pixel
    lists.sorted.clear();
    for (std::size_t s = 0; s < lists.samples(); ++s) {
        for (std::uint32_t p = 0; p < kTilePixels; ++p) {
            order.clear();
            for (std::uint32_t i = lists.first[p]; i < lists.first[p + 1]; ++i) {
                order.emplace_back(precise_depth(planes[i], lists.set, p, s),
                                   lists.fragments[i].primitive, i);
            }
            std::sort(order.begin(), order.end());
            for (const auto& [depth, primitive, i] : order) lists.sorted.push_back(i);
        }
    }
}

// Fills the lists from the stream.
inline void list_fragments(FragmentLists& lists)
{
    const FragmentStream& f = lists.stream;
    const auto size = static_cast<std::size_t>(f.size);
    lists.first.assign(kTilePixels + 1, 0);
    for (std::size_t i = 0; i < size; ++i) ++lists.first[f.pixel[i] + 1];
    std::partial_sum(lists.first.begin(), lists.first.end(), lists.first.begin());
    lists.fragments.resize(size);
    std::vector<DepthPlane> planes(size);
    std::vector<std::uint32_t> next = lists.first;
    for (int r = 0; r < f.run_count; ++r) {
        const FragmentRun& run = f.runs[r];
        const DepthPlane& d = run.depth;
        for (std::size_t i = run.first; i < run.first + run.count; ++i) {
            const std::uint32_t at = next[f.pixel[i]]++;
            lists.fragments[at] = {f.samples[i],
                                   f.samples_high[i],
                                   run.primitive,
                                   run.object,
                                   f.red[i],
                                   f.green[i],
                                   f.blue[i],
                                   f.opacity[i],
                                   f.depth[i],
                                   d.dx,
                                   d.dy,
                                   d.least,
                                   d.most,
                                   run.back_facing ? 1u : 0u,
                                   {},
                                   f.level[i]};
            for (std::size_t c = 0; c < 9; ++c) lists.fragments[at].place[c] = f.place[c][i];
            planes[at] = d;
        }
    }
    sort_by_depth(lists, planes);
}

// Another colour for every sample, premultiplied, and opaque, half transparent or empty.
inline SampleColors make_backdrop(int samples, bool divides = false)
{
    SampleColors colors(samples, divides);
    for (std::size_t i = 0; i < kTilePixels * static_cast<std::size_t>(samples); ++i) {
        const std::size_t pixel = i / static_cast<std::size_t>(samples);
        const std::size_t s = i % static_cast<std::size_t>(samples);
        const std::uint32_t bits = hash_u32(static_cast<std::uint32_t>(i));
        const float alpha = bits % 4 == 0 ? 0.0f : bits % 4 == 1 ? 1.0f : unit_float(bits);
        for (std::uint32_t c = 0; c < 3; ++c) {
            colors.channel(pixel, c)[s] = alpha * unit_float(hash_u32(bits + c));
        }
        colors.channel(pixel, 3)[s] = alpha;
    }
    return colors;
}

using Words = std::vector<std::uint32_t>;

template <class Floats>
Words words_of(const Floats& floats)
{
    Words words;
    words.reserve(floats.size());
    for (std::size_t i = 0; i < floats.size(); ++i) {
        words.push_back(std::bit_cast<std::uint32_t>(floats[i]));
    }
    return words;
}

// What a method divides after the filter, the filter being a sample's.
inline void add_fraction(SampleColors& colors)
{
    for (std::size_t pixel = 0; pixel < kTilePixels; ++pixel) {
        for (std::size_t s = 0; s < static_cast<std::size_t>(colors.samples); ++s) {
            const auto part = [&](std::size_t c) { return colors.fraction.channel(pixel, c)[s]; };
            if (!(part(3) > 0)) continue;
            for (std::size_t c = 0; c < 3; ++c) {
                colors.channel(pixel, c)[s] += part(4) * (part(c) / part(3));
            }
        }
    }
}

// What the method's store makes of the lists over the backdrop, in the layout of SampleColors.
inline Words resolved_by_store(const FragmentLists& lists, const std::string& method_text,
                               TargetSet targets)
{
    const ChosenMethod method = choose_method(method_text);
    const StoreVerbs verbs = method.row->verbs(targets, method, lists.set.count);
    const auto store = verbs.make({&lists.set, &method, lists.eye, lists.stream.capacity});
    verbs.clear(store.get(), lists.place);
    const auto done = [&] { return verbs.done != nullptr && verbs.done(store.get()); };
    for (int pass = 0; pass < method.traits().passes && (pass == 0 || !done()); ++pass) {
        verbs.insert(store.get(), lists.stream, pass);
    }
    const bool divides = method.traits().divides;
    SampleColors colors = make_backdrop(lists.set.count, divides);
    verbs.resolve(store.get(), colors);
    if (divides) add_fraction(colors);
    return words_of(colors.values);
}

// As a float and as it is.
inline std::string spelled(std::uint32_t word)
{
    char text[40];
    std::snprintf(text, sizeof(text), "%.9g (0x%08x)",
                  static_cast<double>(std::bit_cast<float>(word)), word);
    return text;
}

// How many words differ, and the first that do; empty if none.
inline std::string difference(const Words& one, const Words& other)
{
    if (one.size() != other.size()) return "sizes differ";
    std::size_t count = 0, first = 0;
    for (std::size_t i = one.size(); i-- > 0;) {
        if (one[i] == other[i]) continue;
        ++count;
        first = i;
    }
    if (count == 0) return "";
    return std::to_string(count) + " of " + std::to_string(one.size()) + " words differ; word " +
           std::to_string(first) + " is " + spelled(one[first]) + " and " + spelled(other[first]);
}

}  // namespace sheer::test
