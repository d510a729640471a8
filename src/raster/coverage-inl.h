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
    bool wide = false;   // an edge needs 64 bits
    bool inside = true;  // the whole region is inside all three
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
        edges.inside &= inside;
    }
    return true;
}

// Edge functions at samples relative to those at their pixel's corner.
struct SampleSteps {
    alignas(64) std::int32_t at[3][kMaxSamples];
    std::int32_t most[3];  // no less than the greatest
};

inline void make_sample_steps(const RegionEdges& edges, const SampleSet& set, SampleSteps& steps)
{
    const auto count = static_cast<std::size_t>(set.centered ? 1 : set.count);
    for (int e = 0; e < 3; ++e) {
        for (std::size_t s = 0; s < count; ++s) {
            steps.at[e][s] = edges.step_x[e] * set.x[s] + edges.step_y[e] * set.y[s];
        }
        const SampleExtent& extent = set.extent;
        steps.most[e] = edges.step_x[e] * (edges.step_x[e] > 0 ? extent.x_max : extent.x_min) +
                        edges.step_y[e] * (edges.step_y[e] > 0 ? extent.y_max : extent.y_min);
    }
}

// All of the region's pixels, wholly.
inline void cover_all(const SampleSet& set, const PixelRect& local, CoverageList& list)
{
    const std::uint64_t all = set.all();
    for (int y = local.y0; y < local.y1; ++y) {
        for (int x = local.x0; x < local.x1; ++x) {
            list.pixel[list.count] = static_cast<std::uint32_t>(y * kTileSize + x);
            list.low[list.count] = static_cast<std::uint32_t>(all);
            if (set.count > 32) list.high[list.count] = static_cast<std::uint32_t>(all >> 32);
            ++list.count;
        }
    }
}

// Pixels that a triangle may cover, and its edge functions at their corners.
struct Candidates {
    static constexpr int kMost = kTilePixels + Block::kCount;
    int count = 0;
    alignas(64) std::uint32_t pixel[kMost];
    alignas(64) std::int32_t edge[3][kMost];
};

// Rows first, first + 1, ... of the region: from which column to which a sample may be inside, by
// floats, so with a little to spare on both sides.
HWY_INLINE void find_spans(const RegionEdges& edges, const SampleSteps& steps, int first, int width,
                           std::int32_t* from, std::int32_t* to)
{
    using real = Block::real;
    using whole = Block::whole;
    const whole row = Block::iota() + whole(first);
    real lower(0.0f), upper(static_cast<float>(width - 1));
    for (int e = 0; e < 3; ++e) {
        const real best =
            Block::to_real(whole(static_cast<std::int32_t>(edges.corner[e])) +
                           row * whole(edges.step_y[e] * kSubpixels) + whole(steps.most[e]));
        if (edges.step_x[e] == 0) {
            upper = Block::select(best < real(0.0f), real(-1.0f), upper);
            continue;
        }
        const real zero_at = best * real(-1.0f / static_cast<float>(edges.step_x[e] * kSubpixels));
        if (edges.step_x[e] > 0) {
            lower = Block::max(lower, zero_at);
        } else {
            upper = Block::min(upper, zero_at);
        }
    }
    // Quotients within a tile err by less than 1e-4 of a pixel.
    const real spare(0.01f);
    lower = Block::min(lower - spare + real(1.0f), real(static_cast<float>(width)));
    upper = Block::max(upper + spare, real(-1.0f));
    Block::to_whole(Block::max(lower, real(0.0f))).store(from);
    Block::select(upper < real(0.0f), whole(-1), Block::to_whole(upper)).store(to);
}

HWY_INLINE void find_candidates(const RegionEdges& edges, const SampleSteps& steps,
                                const PixelRect& local, Candidates& candidates)
{
    using whole = Block::whole;
    const int width = local.x1 - local.x0, height = local.y1 - local.y0;
    alignas(64) std::int32_t from[Block::kCount], to[Block::kCount];
    int count = 0;
    for (int y = 0; y < height; ++y) {
        const int lane = y % Block::kCount;
        if (lane == 0) find_spans(edges, steps, y, width, from, to);
        const int row_start = (local.y0 + y) * kTileSize + local.x0;
        for (int x = from[lane]; x <= to[lane]; x += Block::kCount) {
            (Block::iota() + whole(row_start + x)).store(candidates.pixel + count + x - from[lane]);
        }
        count += std::max(0, to[lane] - from[lane] + 1);
    }
    candidates.count = count;
    for (int e = 0; e < 3; ++e) {
        // Wraps around, and back.
        const auto right = static_cast<std::uint32_t>(edges.step_x[e] * kSubpixels);
        const auto down = static_cast<std::uint32_t>(edges.step_y[e] * kSubpixels);
        const auto corner = static_cast<std::uint32_t>(edges.corner[e]) -
                            right * static_cast<std::uint32_t>(local.x0) -
                            down * static_cast<std::uint32_t>(local.y0);
        for (int i = 0; i < count; i += Block::kCount) {
            static_assert(kTileSize == 1 << 5);
            const whole pixel = whole::load(candidates.pixel + i);
            (whole(static_cast<std::int32_t>(corner)) +
             (pixel & whole(kTileSize - 1)) * whole(static_cast<std::int32_t>(right)) +
             pixel.shift_right<5>() * whole(static_cast<std::int32_t>(down)))
                .store(candidates.edge[e] + i);
        }
    }
}

// Lanes over a pixel's samples, S = min(samples, 16).
template <int S>
void cover_by_samples(const RegionEdges& edges, const SampleSet& set, const PixelRect& local,
                      CoverageList& list)
{
    using L = Lanes<S>;
    using whole = typename L::whole;
    const int vectors = S < 16 ? S / L::kCount : set.count / L::kCount;
    SampleSteps steps;
    make_sample_steps(edges, set, steps);
    Candidates candidates;
    find_candidates(edges, steps, local, candidates);
    const std::uint64_t all = set.all();
    int count = list.count;
    for (int i = 0; i < candidates.count; ++i) {
        const whole at[3] = {whole(candidates.edge[0][i]), whole(candidates.edge[1][i]),
                             whole(candidates.edge[2][i])};
        std::uint64_t outside = 0;
        for (int v = 0; v < vectors; ++v) {
            const int s = v * L::kCount;
            const whole negative = (at[0] + whole::load(&steps.at[0][s])) |
                                   (at[1] + whole::load(&steps.at[1][s])) |
                                   (at[2] + whole::load(&steps.at[2][s]));
            outside |= std::uint64_t{negative.sign_bits()} << s;
        }
        const std::uint64_t inside = ~outside & all;
        list.pixel[count] = candidates.pixel[i];
        list.low[count] = static_cast<std::uint32_t>(inside);
        if constexpr (S == 16) list.high[count] = static_cast<std::uint32_t>(inside >> 32);
        count += inside != 0 ? 1 : 0;
    }
    list.count = count;
}

// Lanes over a block of pixels, one or two samples at a time; all samples at the centre are one.
inline void cover_by_pixels(const RegionEdges& edges, const SampleSet& set, const PixelRect& local,
                            CoverageList& list)
{
    using whole = Block::whole;
    SampleSteps steps;
    make_sample_steps(edges, set, steps);
    const whole lane = Block::iota();
    const whole lane_x = lane & whole(kBlockWidth - 1);
    const whole lane_y = lane.shift_right<kBlockWidth / 2>();  // log2 of 1, 2 or 4
    const whole lane_pixel = lane_y * whole(kTileSize) + lane_x;
    whole lane_step[3];
    for (int e = 0; e < 3; ++e) {
        lane_step[e] = lane_x * whole(edges.step_x[e] * kSubpixels) +
                       lane_y * whole(edges.step_y[e] * kSubpixels);
    }
    const int tested = set.centered ? 1 : set.count;
    const auto low_if_all = whole(static_cast<std::int32_t>(set.all() & 0xffffffffu));
    const auto high_if_all = whole(static_cast<std::int32_t>(set.all() >> 32));
    const whole zero(0);
    const int width = local.x1 - local.x0, height = local.y1 - local.y0;
    for (int y = 0; y < height; y += kBlockHeight) {
        for (int x = 0; x < width; x += kBlockWidth) {
            whole at[3];
            for (int e = 0; e < 3; ++e) {
                at[e] = lane_step[e] + whole(static_cast<std::int32_t>(edges.corner[e])) +
                        whole(edges.step_x[e] * kSubpixels) * whole(x) +
                        whole(edges.step_y[e] * kSubpixels) * whole(y);
            }
            whole inside = zero;
            for (int s = 0; s < tested; ++s) {
                const whole negative = (at[0] + whole(steps.at[0][s])) |
                                       (at[1] + whole(steps.at[1][s])) |
                                       (at[2] + whole(steps.at[2][s]));
                inside = inside | Block::select(negative < zero, zero, whole(1 << s));
            }
            const Block::mask here =
                (lane_x < whole(width - x)) & (lane_y < whole(height - y)) & !(inside == zero);
            const whole first((local.y0 + y) * kTileSize + local.x0 + x);
            const Block::Packing packing(here);
            packing.store(first + lane_pixel, list.pixel + list.count);
            if (set.centered) {
                packing.store(low_if_all, list.low + list.count);
                if (set.count > 32) packing.store(high_if_all, list.high + list.count);
            } else {
                packing.store(inside, list.low + list.count);
            }
            list.count += static_cast<int>(packing.count());
        }
    }
}

using CoverFunction = void (*)(const RegionEdges&, const SampleSet&, const PixelRect&,
                               CoverageList&);

inline CoverFunction cover_function_for(const SampleSet& set)
{
    if (set.centered || set.count < 4) return cover_by_pixels;
    switch (set.count) {
        case 4: return cover_by_samples<4>;
        case 8: return cover_by_samples<8>;
        default: return cover_by_samples<16>;
    }
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_COVERAGE_INL_H
