// Where a triangle's fragments are shaded: perspective-correct weights at the centroid of the
// covered samples, or of what the triangle has of the pixel where it is drawn conservatively, and
// depth at the pixel's centre.
#if defined(SHEER_LOCATE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_LOCATE_INL_H
#undef SHEER_LOCATE_INL_H
#else
#define SHEER_LOCATE_INL_H
#endif

#include "cpu/plane_batch-inl.h"
#include "cpu/shading_rates.h"
#include "raster/coverage_list.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

struct Located {
    Block::real w1, w2;  // of vertices 1 and 2
    Block::real depth;
};

// Before perspective.
struct LocatedOnScreen {
    Block::real b1, b2;  // affine weights at the centroid
    Block::real depth;   // at the pixel's centre
    Block::whole column, row;
    Block::real x, y;  // the centroid from the pixel's centre, subpixels
    // Of what is shaded, in pixels: the square of those that are shaded together, whose middle it
    // is then; below 1 where samples are shaded for themselves. What changes is for that.
    Block::real side;
};

// Bits set in a number below 16, and 1 / n for n = 1, ..., 15, with 1 / 16 in place of 0.
alignas(64) inline constexpr std::uint32_t kBitCounts[16] = {0, 1, 1, 2, 1, 2, 2, 3,
                                                             1, 2, 2, 3, 2, 3, 3, 4};
alignas(64) inline constexpr float kShares[16] = {
    1.0f / 16, 1.0f,     1.0f / 2,  1.0f / 3,  1.0f / 4,  1.0f / 5,  1.0f / 6,  1.0f / 7,
    1.0f / 8,  1.0f / 9, 1.0f / 10, 1.0f / 11, 1.0f / 12, 1.0f / 13, 1.0f / 14, 1.0f / 15};

// Fragments i, i + 1, ... of the list: the centroid's offset from the pixel's centre in subpixels.
HWY_INLINE void centroid(const SampleSet& set, const CoverageList& list, int i, Block::real& x,
                         Block::real& y)
{
    using real = Block::real;
    using whole = Block::whole;
    whole sum(0), covered(0);
    for (int group = 0; 4 * group < set.count; ++group) {
        const std::uint32_t* word = group < 8 ? list.low : list.high;
        const whole bits = whole::load(word + i).shift_right_by(4 * (group & 7)) & whole(15);
        sum = sum +
              Block::look_up_16(set.position_sums[static_cast<std::size_t>(group)].data(), bits);
        covered = covered + Block::look_up_16(kBitCounts, bits);
    }
    // Lanes past the end of the list may hold no sample at all.
    const real share = set.count <= 16
                           ? Block::look_up_16(kShares, covered & whole(15))
                           : real(1.0f) / Block::max(Block::to_real(covered), real(1.0f));
    const real half(0.5f * kSubpixels);
    x = Block::to_real(sum & whole(0xffff)) * share - half;
    y = Block::to_real(sum.shift_right<16>()) * share - half;
}

// `of`: each lane's triangle.
HWY_INLINE Block::real weight_at_center(const WeightBatch& w, const PlaneBatch& planes,
                                        const Block::Lookup& of, Block::whole column,
                                        Block::whole row)
{
    using real = Block::real;
    using whole = Block::whole;
    const whole edge = of.of(w.edge) + column * of.of(w.edge_x) + row * of.of(w.edge_y);
    const real precise = Block::to_real(edge) * of.of(planes.inverse_area);
    if (planes.all_exact) return precise;
    const real rough = of.of(w.base) + Block::to_real(column) * of.of(w.pixel_x) +
                       Block::to_real(row) * of.of(w.pixel_y);
    return Block::select(of.of(planes.exact) == whole(0), rough, precise);
}

// Moves fragments to the middles of their squares, but not beyond the triangle: floats that depend
// on square and triangle alone. The integers of weight_at_center hold in covered pixels only.
HWY_INLINE void move_to_squares(const ShadingRates& rates, const PlaneBatch& planes,
                                const Block::Lookup& of, const CoverageList& list, int i,
                                LocatedOnScreen& at)
{
    using real = Block::real;
    alignas(64) float x[Block::kCount], y[Block::kCount], side[Block::kCount];
    for (int lane = 0; lane < Block::kCount; ++lane) {
        // Lanes past the end of the list may hold anything.
        const std::uint32_t pixel = list.pixel[i + lane] & (kTilePixels - 1);
        x[lane] = rates.x[pixel];
        y[lane] = rates.y[pixel];
        side[lane] = rates.side[pixel];
    }
    const real zero(0.0f), one(1.0f), column = real::load(x), row = real::load(y);
    const real pixels = real::load(side);
    const auto coarse = pixels > one;
    at.side = Block::select(coarse, pixels, at.side);
    const auto weight = [&](const WeightBatch& w) HWY_ATTR {
        return Block::max(of.of(w.base) + column * of.of(w.pixel_x) + row * of.of(w.pixel_y), zero);
    };
    const real b1 = weight(planes.weight1), b2 = weight(planes.weight2);
    const real inside = one / Block::max(b1 + b2, one);
    at.b1 = Block::select(coarse, b1 * inside, at.b1);
    at.b2 = Block::select(coarse, b2 * inside, at.b2);
    const real subpixels(kSubpixels);
    at.x = Block::select(coarse, (column - Block::to_real(at.column)) * subpixels, at.x);
    at.y = Block::select(coarse, (row - Block::to_real(at.row)) * subpixels, at.y);
}

// `rates`: or null, if all squares are one pixel.
HWY_INLINE LocatedOnScreen locate_on_screen(const PlaneBatch& planes, const Block::Lookup& of,
                                            const SampleSet& set, const CoverageList& list, int i,
                                            const ShadingRates* rates)
{
    using real = Block::real;
    using whole = Block::whole;
    static_assert(kTileSize == 1 << 5);
    const whole pixel = whole::load(list.pixel + i);
    LocatedOnScreen at;
    at.column = pixel & whole(kTileSize - 1);
    at.row = pixel.shift_right<5>();
    at.b1 = weight_at_center(planes.weight1, planes, of, at.column, at.row);
    at.b2 = weight_at_center(planes.weight2, planes, of, at.column, at.row);
    at.depth =
        of.of(planes.depth[0]) + at.b1 * of.of(planes.depth[1]) + at.b2 * of.of(planes.depth[2]);
    at.x = at.y = real(0.0f);
    at.side = real(planes.spacing);
    const bool overlaps = list.overlaps != nullptr;
    if (overlaps) {
        at.x = real::load(list.overlaps->x.data() + i);
        at.y = real::load(list.overlaps->y.data() + i);
    } else if (!set.centered) {
        centroid(set, list, i, at.x, at.y);
    }
    if (overlaps || !set.centered) {
        const auto along = [&](const WeightBatch& w)
                               HWY_ATTR { return at.x * of.of(w.dx) + at.y * of.of(w.dy); };
        at.b1 = at.b1 + along(planes.weight1);
        at.b2 = at.b2 + along(planes.weight2);
    }
    if (rates != nullptr) move_to_squares(*rates, planes, of, list, i, at);
    return at;
}

HWY_INLINE Located locate(const PlaneBatch& planes, const Block::Lookup& of, const SampleSet& set,
                          const CoverageList& list, int i, const ShadingRates* rates)
{
    using real = Block::real;
    using whole = Block::whole;
    const LocatedOnScreen at = locate_on_screen(planes, of, set, list, i, rates);
    if (planes.all_affine) return {at.b1, at.b2, at.depth};
    const real q1 = at.b1 * of.of(planes.inverse_w[1]), q2 = at.b2 * of.of(planes.inverse_w[2]);
    const real sum = (real(1.0f) - at.b1 - at.b2) * of.of(planes.inverse_w[0]) + q1 + q2;
    const real scale = real(1.0f) / sum;
    Located result{q1 * scale, q2 * scale, at.depth};
    if (planes.any_affine) {
        const Block::mask perspective = of.of(planes.affine) == whole(0);
        result.w1 = Block::select(perspective, result.w1, at.b1);
        result.w2 = Block::select(perspective, result.w2, at.b2);
    }
    return result;
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_LOCATE_INL_H
