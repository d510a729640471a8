// Which samples of a tile's pixels a triangle covers: exact integer edge functions, a block of
// pixels in a vector, one sample after the other.
//
// Edge i runs from vertex i to i + 1; a sample is inside where all three functions are positive, or
// zero on a top or left edge (docs/numerics.md). A bias of -1 on the other edges makes "inside" one
// sign bit. A block whose pixels are all inside or outside of all edges with every sample needs no
// test by sample. An edge too long for 32 bits within a tile takes the scalar way in 64 bits.
#if defined(SHEER_COVERAGE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_COVERAGE_INL_H
#undef SHEER_COVERAGE_INL_H
#else
#define SHEER_COVERAGE_INL_H
#endif

#include <algorithm>
#include <cstdlib>

#include "geometry/triangles.h"
#include "lanes/lanes-inl.h"
#include "raster/coverage_list.h"
#include "raster/sample_set.h"
#include "geometry/tile_grid.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

using Block = Lanes<16>;
inline constexpr int kBlockWidth = Block::kCount >= 8 ? 4 : Block::kCount >= 4 ? 2 : 1;
inline constexpr int kBlockHeight = Block::kCount / kBlockWidth;

// Edge functions over a region of the tile, a step being one subpixel.
struct RegionEdges {
    std::int64_t corner[3];  // at the top left corner of the region's first pixel, bias included
    std::int32_t step_x[3], step_y[3];
    bool wide = false;
};

// A longer edge (|dx| + |dy|, subpixels) overflows 32 bits within a tile of 2^5 pixels of 2^8
// subpixels.
inline constexpr std::int64_t kLongestNarrowEdge = std::int64_t{1} << 18;

// False when no sample of the region can be covered.
inline bool make_region_edges(const Triangle& t, const PixelRect& region, RegionEdges& edges)
{
    const std::int64_t right = (region.x1 - region.x0) * kSubpixels - 1;
    const std::int64_t bottom = (region.y1 - region.y0) * kSubpixels - 1;
    for (int i = 0; i < 3; ++i) {
        const int j = i == 2 ? 0 : i + 1;
        const std::int32_t dx = t.x[j] - t.x[i], dy = t.y[j] - t.y[i];
        const std::int64_t bias = dy < 0 || (dy == 0 && dx > 0) ? 0 : -1;
        const std::int64_t corner = std::int64_t{dx} * (region.y0 * kSubpixels - t.y[i]) -
                                    std::int64_t{dy} * (region.x0 * kSubpixels - t.x[i]) + bias;
        const std::int64_t along_x = -dy * right, along_y = dx * bottom;
        const auto zero = std::int64_t{0};
        if (corner + std::max(zero, along_x) + std::max(zero, along_y) < 0) return false;
        const bool inside = corner + std::min(zero, along_x) + std::min(zero, along_y) >= 0;
        edges.corner[i] = inside ? 0 : corner;
        edges.step_x[i] = inside ? 0 : -dy;
        edges.step_y[i] = inside ? 0 : dx;
        const std::int64_t length = std::abs(std::int64_t{dx}) + std::abs(std::int64_t{dy});
        edges.wide |= !inside && length >= kLongestNarrowEdge;
    }
    return true;
}

// Edge functions at samples relative to those at their pixel's corner.
struct SampleSteps {
    alignas(64) std::int32_t at[3][kMaxSamples];
    std::int32_t least[3], most[3];
};

inline void make_sample_steps(const RegionEdges& edges, const SampleSet& set, SampleSteps& steps)
{
    const int count = set.centered ? 1 : set.count;
    for (int e = 0; e < 3; ++e) {
        std::int32_t least = INT32_MAX, most = INT32_MIN;
        for (int s = 0; s < count; ++s) {
            const std::int32_t step = edges.step_x[e] * set.x[s] + edges.step_y[e] * set.y[s];
            steps.at[e][s] = step;
            least = std::min(least, step);
            most = std::max(most, step);
        }
        steps.least[e] = least;
        steps.most[e] = most;
    }
}

// Samples [32 word, 32 word + 32) of a block's pixels: bit i of a lane for sample 32 word + i.
HWY_INLINE Block::whole covered_samples(const Block::whole (&pixel)[3], const SampleSteps& steps,
                                        int word, int count)
{
    Block::whole outside(0);
    for (int s = std::min(count, 32 * word + 32) - 1; s >= 32 * word; --s) {
        const Block::whole negative = (pixel[0] + Block::whole(steps.at[0][s])) |
                                      (pixel[1] + Block::whole(steps.at[1][s])) |
                                      (pixel[2] + Block::whole(steps.at[2][s]));
        outside = outside.shift_left<1>() | negative.shift_right<31>();
    }
    return ~outside;
}

HWY_INLINE void append(CoverageList& list, Block::whole pixel, Block::whole low, Block::whole high,
                       bool wants_high)
{
    const Block::mask covered = !((low | high) == Block::whole(0));
    pixel.store_packed(covered, list.pixel + list.count);
    low.store_packed(covered, list.low + list.count);
    if (wants_high) high.store_packed(covered, list.high + list.count);
    list.count += covered.count();
}

HWY_INLINE void cover_narrow(const RegionEdges& edges, const SampleSet& set, PixelRect local,
                             CoverageList& list)
{
    SampleSteps steps;
    make_sample_steps(edges, set, steps);
    const int tested = set.centered ? 1 : set.count;
    const auto all_low = Block::whole(static_cast<std::int32_t>(set.all() & 0xffffffffu));
    const auto all_high = Block::whole(static_cast<std::int32_t>(set.all() >> 32));
    const Block::whole lane = Block::iota();
    const Block::whole lane_x = lane & Block::whole(kBlockWidth - 1);
    const Block::whole lane_y = lane.shift_right<kBlockWidth / 2>();  // log2 of 1, 2 or 4
    const Block::whole lane_pixel = lane_y * Block::whole(kTileSize) + lane_x;
    const Block::whole zero(0);

    Block::whole lane_step[3];
    for (int e = 0; e < 3; ++e) {
        lane_step[e] = lane_x * Block::whole(edges.step_x[e] * kSubpixels) +
                       lane_y * Block::whole(edges.step_y[e] * kSubpixels);
    }
    const int width = local.x1 - local.x0, height = local.y1 - local.y0;
    for (int y = 0; y < height; y += kBlockHeight) {
        for (int x = 0; x < width; x += kBlockWidth) {
            Block::whole pixel[3];
            for (int e = 0; e < 3; ++e) {
                const auto at = static_cast<std::uint32_t>(edges.corner[e]) +
                                static_cast<std::uint32_t>(edges.step_x[e] * kSubpixels) *
                                    static_cast<std::uint32_t>(x) +
                                static_cast<std::uint32_t>(edges.step_y[e] * kSubpixels) *
                                    static_cast<std::uint32_t>(y);
                pixel[e] = Block::whole(static_cast<std::int32_t>(at)) + lane_step[e];
            }
            const Block::whole out = (pixel[0] + Block::whole(steps.most[0])) |
                                     (pixel[1] + Block::whole(steps.most[1])) |
                                     (pixel[2] + Block::whole(steps.most[2]));
            const Block::mask here = (lane_x < Block::whole(width - x)) &
                                     (lane_y < Block::whole(height - y)) & !(out < zero);
            if (!here.any()) continue;
            const Block::whole part = (pixel[0] + Block::whole(steps.least[0])) |
                                      (pixel[1] + Block::whole(steps.least[1])) |
                                      (pixel[2] + Block::whole(steps.least[2]));
            Block::whole low = all_low, high = all_high;
            if ((here & (part < zero)).any()) {
                low = covered_samples(pixel, steps, 0, tested) & all_low;
                high = tested > 32 ? covered_samples(pixel, steps, 1, tested) & all_high : zero;
            }
            const auto first = Block::whole((local.y0 + y) * kTileSize + local.x0 + x);
            append(list, first + lane_pixel, Block::select(here, low, zero),
                   Block::select(here, high, zero), set.count > 32);
        }
    }
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_COVERAGE_INL_H
