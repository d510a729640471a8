// Edge functions of up to a vector of triangles over what each may cover of a tile: a triangle a
// lane.
//
// Edge i runs from vertex i to i + 1; a sample is inside where all three functions are positive, or
// zero on a top or left edge (docs/numerics.md). A bias of -1 on the other edges makes "inside" one
// sign bit.
#if defined(SHEER_EDGE_BATCH_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_EDGE_BATCH_INL_H
#undef SHEER_EDGE_BATCH_INL_H
#else
#define SHEER_EDGE_BATCH_INL_H
#endif

#include <algorithm>
#include <cstdlib>

#include "geometry/tile_grid.h"
#include "geometry/triangles.h"
#include "lanes/lanes-inl.h"
#include "raster/sample_set.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

using Block = Lanes<16>;

// A number for each triangle of a batch.
using RealEach = float[Block::kCount];
using WholeEach = std::int32_t[Block::kCount];

// Corners on the screen: Triangle::x, y.
struct CornerBatch {
    alignas(64) WholeEach x[3] = {};
    alignas(64) WholeEach y[3] = {};
};

// What is wanted of a tile: pixels of the picture, the first of which is the tile's.
struct WantedPixels {
    int tile_x, tile_y;
    PixelRect rect;
};

struct EdgeBatch {
    // Which pixels of the tile the triangle may cover.
    alignas(64) WholeEach x0, y0, width, height;
    // Edge functions: at the top left corner of the tile's first pixel (wrapping around in 32
    // bits), bias included, and what a subpixel to the right and down adds. Zeros: the whole region
    // is inside the edge.
    alignas(64) WholeEach origin[3], step_x[3], step_y[3];
    alignas(64) WholeEach steps[3];  // both as halves, of triangles in `small`
    // At sample s of a pixel, relative to its corner; `most`: no less than the greatest.
    alignas(64) WholeEach at_sample[kMaxSamples][3];
    alignas(64) WholeEach most[3];
    // At the corner of the region's first pixel.
    alignas(64) WholeEach corner[3];
    // Along a row, an edge function f is zero -f * to_zero pixels away. A limit that an edge does
    // not set is out of the way.
    alignas(64) RealEach to_zero[3], no_lower[3], no_upper[3];
    // Bit k, of triangle k: no sample of the region can be covered; an edge is too long for 32
    // bits; its bounds are small.
    std::uint32_t outside, wide, small;
};

// Where both sides of a triangle's bounds are shorter, what make_edges computes stays below 2^30,
// and steps fit into 16 bits.
inline constexpr int kSmallBounds = 1 << 14;
// A longer edge (|dx| + |dy|, subpixels) overflows 32 bits within a tile of 2^5 pixels of 2^8
// subpixels.
inline constexpr std::int64_t kLongestNarrowEdge = std::int64_t{1} << 18;

// An edge in 64 bits, where it may not be small.
HWY_INLINE void make_long_edge(const CornerBatch& t, std::size_t k, std::size_t i, EdgeBatch& b,
                               const WantedPixels& wanted, bool& is_outside)
{
    const std::size_t j = i == 2 ? 0 : i + 1;
    const std::int32_t dx = t.x[j][k] - t.x[i][k], dy = t.y[j][k] - t.y[i][k];
    const std::int64_t bias = dy < 0 || (dy == 0 && dx > 0) ? 0 : -1;
    const std::int64_t x = std::int64_t{wanted.tile_x + b.x0[k]} * kSubpixels - t.x[i][k];
    const std::int64_t y = std::int64_t{wanted.tile_y + b.y0[k]} * kSubpixels - t.y[i][k];
    const std::int64_t corner = std::int64_t{dx} * y - std::int64_t{dy} * x + bias;
    const std::int64_t along_x = std::int64_t{-dy} * (b.width[k] * kSubpixels - 1);
    const std::int64_t along_y = std::int64_t{dx} * (b.height[k] * kSubpixels - 1);
    const auto zero = std::int64_t{0};
    is_outside |= corner + std::max(zero, along_x) + std::max(zero, along_y) < 0;
    const bool inside = corner + std::min(zero, along_x) + std::min(zero, along_y) >= 0;
    b.corner[i][k] = inside ? 0 : static_cast<std::int32_t>(corner);
    b.step_x[i][k] = inside ? 0 : -dy;
    b.step_y[i][k] = inside ? 0 : dx;
    const std::int64_t length = std::abs(std::int64_t{dx}) + std::abs(std::int64_t{dy});
    if (!inside && length >= kLongestNarrowEdge) b.wide |= 1u << k;
}

HWY_INLINE void make_long_edges(const CornerBatch& t, std::size_t k, const WantedPixels& wanted,
                                EdgeBatch& b)
{
    bool is_outside = false;
    for (std::size_t i = 0; i < 3; ++i) {
        make_long_edge(t, k, i, b, wanted, is_outside);
    }
    const std::uint32_t bit = 1u << k;
    b.outside = is_outside ? b.outside | bit : b.outside & ~bit;
}

// Lanes whose bounds are small.
HWY_INLINE Block::mask make_regions(const CornerBatch& t, const SampleExtent& samples,
                                    const WantedPixels& wanted, EdgeBatch& b)
{
    using whole = Block::whole;
    const auto least = [](const WholeEach(&a)[3]) HWY_ATTR {
        return Block::min(Block::min(whole::load(a[0]), whole::load(a[1])), whole::load(a[2]));
    };
    const auto most = [](const WholeEach(&a)[3]) HWY_ATTR {
        return Block::max(Block::max(whole::load(a[0]), whole::load(a[1])), whole::load(a[2]));
    };
    const whole left = least(t.x), right = most(t.x), top = least(t.y), bottom = most(t.y);
    // As pixel_bounds (geometry/screen_bounds.h): ceilings, and floors and one.
    const auto first = [](whole at, int sample) HWY_ATTR {
        return (at + whole(kSubpixels - 1 - sample)).signed_shift_right<kSubpixelBits>();
    };
    const auto last = [](whole at, int sample) HWY_ATTR {
        return (at - whole(sample)).signed_shift_right<kSubpixelBits>() + whole(1);
    };
    const PixelRect& r = wanted.rect;
    const whole x0 = Block::max(whole(r.x0), first(left, samples.x_max));
    const whole y0 = Block::max(whole(r.y0), first(top, samples.y_max));
    (x0 - whole(wanted.tile_x)).store(b.x0);
    (y0 - whole(wanted.tile_y)).store(b.y0);
    (Block::min(whole(r.x1), last(right, samples.x_min)) - x0).store(b.width);
    (Block::min(whole(r.y1), last(bottom, samples.y_min)) - y0).store(b.height);
    const whole limit(kSmallBounds);
    return (right - left < limit) & (bottom - top < limit);
}

// Of triangles whose bounds are small; the others' lanes hold no numbers of use.
HWY_INLINE void make_edges(const CornerBatch& t, const WantedPixels& wanted, EdgeBatch& b)
{
    using whole = Block::whole;
    using mask = Block::mask;
    const whole zero(0);
    const whole width = whole::load(b.width), height = whole::load(b.height);
    const whole corner_x = (whole::load(b.x0) + whole(wanted.tile_x)) * whole(kSubpixels);
    const whole corner_y = (whole::load(b.y0) + whole(wanted.tile_y)) * whole(kSubpixels);
    const whole right = width * whole(kSubpixels) - whole(1);
    const whole bottom = height * whole(kSubpixels) - whole(1);
    mask outside = (width < whole(1)) | (height < whole(1));
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = i == 2 ? 0 : i + 1;
        const whole x = whole::load(t.x[i]), y = whole::load(t.y[i]);
        const whole dx = whole::load(t.x[j]) - x, dy = whole::load(t.y[j]) - y;
        const mask top_or_left = (dy < zero) | ((dy == zero) & (zero < dx));
        const whole bias = Block::select(top_or_left, zero, whole(-1));
        const whole corner = dx * (corner_y - y) - dy * (corner_x - x) + bias;
        const whole along_x = (zero - dy) * right, along_y = dx * bottom;
        outside = outside | (corner + Block::max(zero, along_x) + Block::max(zero, along_y) < zero);
        const mask within =
            !(corner + Block::min(zero, along_x) + Block::min(zero, along_y) < zero);
        Block::select(within, zero, corner).store(b.corner[i]);
        Block::select(within, zero, zero - dy).store(b.step_x[i]);
        Block::select(within, zero, dx).store(b.step_y[i]);
    }
    b.outside = outside.bits();
    b.wide = 0;
}

// From the edges at the regions' corners, all else. `all_small`: of triangles that there are.
HWY_INLINE void make_steps(const SampleSet& set, bool all_small, EdgeBatch& b)
{
    using real = Block::real;
    using whole = Block::whole;
    const whole zero(0);
    const SampleExtent& extent = set.extent;
    const auto samples = static_cast<std::size_t>(set.centered ? 1 : set.count);
    const whole x0 = whole::load(b.x0), y0 = whole::load(b.y0);
    for (std::size_t i = 0; i < 3; ++i) {
        const whole x = whole::load(b.step_x[i]), y = whole::load(b.step_y[i]);
        const whole steps = Block::halves(x, y);
        steps.store(b.steps[i]);
        for (std::size_t s = 0; s < samples; ++s) {
            const whole at =
                all_small ? Block::dot_halves(steps, whole(Block::halves(set.x[s], set.y[s])))
                          : x * whole(set.x[s]) + y * whole(set.y[s]);
            at.store(b.at_sample[s][i]);
        }
        const whole most_x = Block::select(zero < x, whole(extent.x_max), whole(extent.x_min));
        const whole most_y = Block::select(zero < y, whole(extent.y_max), whole(extent.y_min));
        (x * most_x + y * most_y).store(b.most[i]);
        (whole::load(b.corner[i]) - (x * x0 + y * y0) * whole(kSubpixels)).store(b.origin[i]);
        const real step = Block::to_real(x * whole(kSubpixels));
        Block::zero_unless(!(x == zero), real(-1.0f) / step).store(b.to_zero[i]);
        constexpr float kOutOfTheWay = 1e9f;
        Block::zero_unless(x < zero, real(-kOutOfTheWay)).store(b.no_lower[i]);
        Block::zero_unless(!(x < zero), real(kOutOfTheWay)).store(b.no_upper[i]);
    }
}

// `count` triangles.
HWY_INLINE void set_up_edges(const CornerBatch& t, std::size_t count, const SampleSet& set,
                             const WantedPixels& wanted, EdgeBatch& b)
{
    b.small = make_regions(t, set.extent, wanted, b).bits();
    make_edges(t, wanted, b);
    for (std::size_t k = 0; k < count; ++k) {
        if ((b.small >> k & 1) != 0 || b.width[k] <= 0 || b.height[k] <= 0) continue;
        make_long_edges(t, k, wanted, b);
    }
    const std::uint32_t used = (1u << count) - 1;
    make_steps(set, (b.small & used) == used, b);
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_EDGE_BATCH_INL_H
