// The oracle of stratified stochastic transparency (reference/stratified_listing.h) on fragment
// lists, with what a method's parameters ask for.
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "lanes/lone.h"
#include "methods/fragment_lists.h"
#include "methods/stratified_settings.h"
#include "methods/texts_alone.h"
#include "reference/stratified_listing.h"

namespace sheer::test {

// One of the `count` parts that a pixel's surface has of a sequence: a part a pass or frame.
struct SequencePart {
    std::uint32_t number = 0, count = 1;
};

// The values of a sequence of which a pixel has `numbers` in each part.
inline reference::AlphaReference reference_of(Sequence sequence, int numbers,
                                              SequencePart part = {})
{
    using T = Texts<Lone<float>>;
    const auto first = static_cast<std::uint32_t>(numbers) * part.number;
    const int all = numbers * static_cast<int>(part.count);
    return [=](std::uint32_t number, std::uint32_t pixel, std::uint32_t surface) {
        const std::uint32_t n = first + number;
        const std::uint32_t index = n + pixel * static_cast<std::uint32_t>(all);
        switch (sequence) {
            case Sequence::paper:
            case Sequence::systematic:
                return reference::value_of_bits(reference::paper_bits(n, pixel, surface, all));
            case Sequence::sobol:
                return reference::value_of_bits(reference::sobol_bits(n, pixel, surface, all));
            case Sequence::vegdahl:
                return reference::value_of_bits(reference::vegdahl_bits(index, hash_u32(surface)));
            default:  // of no paper
                return reference::value_of_bits(
                    T::reference_bits(3, T::reversed_bits(index), surface));
        }
    };
}

inline std::vector<reference::PixelFragment> fragments_of_pixel(const FragmentLists& lists,
                                                                std::uint32_t pixel)
{
    std::vector<reference::PixelFragment> fragments;
    for (std::uint32_t i = lists.first[pixel]; i < lists.first[pixel + 1]; ++i) {
        const ListedFragment& f = lists.fragments[i];
        reference::PixelFragment fragment;
        fragment.opacity = static_cast<double>(f.opacity);
        fragment.id = f.primitive;
        fragment.color = {static_cast<double>(f.red), static_cast<double>(f.green),
                          static_cast<double>(f.blue)};
        for (std::size_t s = 0; s < lists.samples(); ++s) {
            fragment.depth[s] = static_cast<double>(lists.depth_at(i, s));
            if (lists.covers(i, s)) fragment.covered |= 1ull << s;
        }
        fragments.push_back(fragment);
    }
    return fragments;
}

// Who owns the pixel's samples in the end; `key`: the first surface's id.
inline std::vector<int> owners_by_oracle(const FragmentLists& lists,
                                         const StratifiedSettings& settings, std::uint32_t pixel,
                                         std::uint32_t key, SequencePart part = {})
{
    const std::uint32_t x = static_cast<std::uint32_t>(lists.place.x) + pixel % kTileSize;
    const std::uint32_t y = static_cast<std::uint32_t>(lists.place.y) + pixel / kTileSize;
    const std::uint32_t index = settings.dither == Dither::hilbert
                                    ? reference::hilbert_index(x, y, 16384)
                                : settings.dither == Dither::morton ? reference::morton_index(x, y)
                                                                    : 0;
    const bool systematic = settings.sequence == Sequence::systematic;
    const int numbers = systematic ? 1 : lists.set.count;
    return reference::stratified_owners(
        fragments_of_pixel(lists, pixel),
        {lists.set.count,
         index,
         key,
         reference_of(settings.sequence, numbers, part),
         {settings.tracking, settings.compaction, settings.sort, systematic}});
}

}  // namespace sheer::test
