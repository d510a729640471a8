#include "reference/stratified_listing.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace sheer::reference {
namespace {

std::uint32_t reverse_bits(std::uint32_t x)
{
    std::uint32_t reversed = 0;
    for (int i = 0; i < 32; ++i) {
        reversed = reversed << 1 | (x >> i & 1);
    }
    return reversed;
}

std::uint32_t reversed_index(std::uint32_t number, std::uint32_t pixel, int samples)
{
    return reverse_bits(number + pixel * static_cast<std::uint32_t>(samples));
}

// What a pixel's samples keep, and what the pixel knows of the surface that is being drawn.
struct State {
    explicit State(const StratifiedPixel& pixel)
        : count(static_cast<std::size_t>(pixel.samples)),
          surface(pixel.surface),
          depth(count, std::numeric_limits<double>::infinity()),
          id(count),
          owner(count, -1),
          covered(count)
    {
    }

    std::size_t count;
    std::uint32_t surface;
    std::vector<double> depth;
    std::vector<std::uint32_t> id;
    std::vector<int> owner;
    std::vector<bool> covered;
};

bool is_hidden(const PixelFragment& fragment, const State& state, std::size_t s)
{
    if (state.owner[s] < 0) return false;
    const double depth = fragment.depth[s];
    return depth > state.depth[s] || (depth == state.depth[s] && fragment.id > state.id[s]);
}

bool takes(const StratifiedPixel& pixel, double opacity, std::uint32_t number,
           std::uint32_t surface)
{
    if (!pixel.switches.systematic) {
        return opacity > pixel.reference(number, pixel.index, surface);
    }
    const double start = pixel.reference(0, pixel.index, surface);
    const double step = std::ceil(std::ldexp(opacity, 24)) / 16777216.0;
    return std::floor(start + (number + 1.0) * step) > std::floor(start + number * step);
}

// Figure 7, with its line numbers.
void draw(const PixelFragment& fragment, int number_of_fragment, const StratifiedPixel& pixel,
          State& state)
{
    // 1 to 3
    std::vector<std::size_t> open;
    for (std::size_t s = 0; s < state.count; ++s) {
        if ((fragment.covered >> s & 1) != 0 && !is_hidden(fragment, state, s)) open.push_back(s);
    }
    if (open.empty()) return;
    // 4 to 7
    const auto is_covered = [&](std::size_t s) { return bool(state.covered[s]); };
    if (!pixel.switches.tracking || std::any_of(open.begin(), open.end(), is_covered)) {
        ++state.surface;
        std::fill(state.covered.begin(), state.covered.end(), false);
    }
    // 8
    auto n =
        static_cast<std::uint32_t>(std::count(state.covered.begin(), state.covered.end(), true));
    // 9
    if (pixel.switches.sort) {
        std::stable_sort(open.begin(), open.end(), [&](std::size_t a, std::size_t b) {
            return state.depth[a] < state.depth[b];
        });
    }
    // 10 to 17
    for (const std::size_t s : open) {
        const std::uint32_t number = pixel.switches.compaction ? n : static_cast<std::uint32_t>(s);
        if (takes(pixel, fragment.opacity, number, state.surface)) {
            state.depth[s] = fragment.depth[s];
            state.id[s] = fragment.id;
            state.owner[s] = number_of_fragment;
        }
        ++n;
    }
    // 18
    for (const std::size_t s : open) {
        state.covered[s] = true;
    }
}

}  // namespace

std::uint32_t paper_bits(std::uint32_t number, std::uint32_t pixel, std::uint32_t surface,
                         int samples)
{
    std::uint32_t x = reversed_index(number, pixel, samples) + surface;
    for (const std::uint32_t factor : {0x6C50B47Cu, 0xB82F1E52u, 0xC7AFE638u, 0x8D22F6E6u}) {
        x ^= x * factor;
    }
    return x;
}

std::uint32_t vegdahl_bits(std::uint32_t number, std::uint32_t seed)
{
    std::uint32_t x = reverse_bits(number);
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= seed >> 16 | 1;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return x;
}

std::uint32_t sobol_bits(std::uint32_t number, std::uint32_t pixel, std::uint32_t surface,
                         int samples)
{
    const std::uint32_t x = reversed_index(number, pixel, samples) + surface;
    std::uint32_t value = 0;
    for (std::uint32_t i = 0; i < 32; ++i) {
        for (std::uint32_t j = 0; j <= i; ++j) {
            // i over j is odd where j has no bit that i has not (Lucas).
            if ((j & ~i) == 0) value ^= (x >> j & 1) << i;
        }
    }
    return value;
}

double value_of_bits(std::uint32_t bits)
{
    return (bits >> 8) / 16777216.0;
}

std::uint32_t hilbert_index(std::uint32_t x, std::uint32_t y, std::uint32_t side)
{
    std::uint32_t index = 0;
    for (std::uint32_t s = side / 2; s > 0; s /= 2) {
        const std::uint32_t right = (x & s) != 0, below = (y & s) != 0;
        index += s * s * ((3 * right) ^ below);
        if (below == 0) {
            if (right != 0) {
                x = side - 1 - x;
                y = side - 1 - y;
            }
            std::swap(x, y);
        }
    }
    return index;
}

std::uint32_t morton_index(std::uint32_t x, std::uint32_t y)
{
    std::uint32_t index = 0;
    for (int i = 0; i < 16; ++i) {
        index |= (x >> i & 1) << 2 * i | (y >> i & 1) << (2 * i + 1);
    }
    return index;
}

std::vector<int> stratified_owners(std::span<const PixelFragment> fragments,
                                   const StratifiedPixel& pixel)
{
    State state(pixel);
    for (std::size_t i = 0; i < fragments.size(); ++i) {
        draw(fragments[i], static_cast<int>(i), pixel, state);
    }
    return state.owner;
}

}  // namespace sheer::reference
