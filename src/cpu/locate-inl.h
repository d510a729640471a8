// Where a triangle's fragments are shaded: perspective-correct weights at the centroid of the
// covered samples, and depth at the pixel's centre.
#if defined(SHEER_LOCATE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_LOCATE_INL_H
#undef SHEER_LOCATE_INL_H
#else
#define SHEER_LOCATE_INL_H
#endif

#include "cpu/triangle_planes.h"
#include "raster/coverage-inl.h"

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
};

// Fragments i, i + 1, ... of the list: the centroid's offset from the pixel's centre in subpixels.
HWY_INLINE void centroid(const SampleSet& set, const CoverageList& list, int i, Block::real& x,
                         Block::real& y)
{
    using real = Block::real;
    using whole = Block::whole;
    whole sum(0), covered(0);
    for (int byte = 0; 8 * byte < set.count; ++byte) {
        const std::uint32_t* word = byte < 4 ? list.low : list.high;
        const whole bits = whole::load(word + i).shift_right_by(8 * (byte & 3)) & whole(255);
        sum = sum + Block::gather(set.position_sums[static_cast<std::size_t>(byte)].data(), bits);
        covered = covered + bits.population_count();
    }
    // Lanes past the end of the list may hold no sample at all.
    const real share = real(1.0f) / Block::max(Block::to_real(covered), real(1.0f));
    const real half(0.5f * kSubpixels);
    x = Block::to_real(sum & whole(0xffff)) * share - half;
    y = Block::to_real(sum.shift_right<16>()) * share - half;
}

HWY_INLINE Block::real weight_at_center(const WeightPlane& w, const TrianglePlanes& planes,
                                        Block::whole column, Block::whole row)
{
    using real = Block::real;
    using whole = Block::whole;
    if (planes.exact) {
        const whole edge = whole(w.edge) + column * whole(w.edge_x) + row * whole(w.edge_y);
        return Block::to_real(edge) * real(planes.inverse_area);
    }
    return real(w.base) + Block::to_real(column) * real(w.pixel_x) +
           Block::to_real(row) * real(w.pixel_y);
}

HWY_INLINE LocatedOnScreen locate_on_screen(const TrianglePlanes& planes, const SampleSet& set,
                                            const CoverageList& list, int i)
{
    using real = Block::real;
    using whole = Block::whole;
    static_assert(kTileSize == 1 << 5);
    const whole pixel = whole::load(list.pixel + i);
    LocatedOnScreen at;
    at.column = pixel & whole(kTileSize - 1);
    at.row = pixel.shift_right<5>();
    at.b1 = weight_at_center(planes.weight1, planes, at.column, at.row);
    at.b2 = weight_at_center(planes.weight2, planes, at.column, at.row);
    at.depth = real(planes.depth0) + at.b1 * real(planes.depth1) + at.b2 * real(planes.depth2);
    at.x = at.y = real(0.0f);
    if (set.centered) return at;
    centroid(set, list, i, at.x, at.y);
    at.b1 = at.b1 + (at.x * real(planes.weight1.dx) + at.y * real(planes.weight1.dy));
    at.b2 = at.b2 + (at.x * real(planes.weight2.dx) + at.y * real(planes.weight2.dy));
    return at;
}

HWY_INLINE Located locate(const TrianglePlanes& planes, const SampleSet& set,
                          const CoverageList& list, int i)
{
    using real = Block::real;
    const LocatedOnScreen at = locate_on_screen(planes, set, list, i);
    if (planes.affine) return {at.b1, at.b2, at.depth};
    const real q1 = at.b1 * real(planes.inverse_w[1]), q2 = at.b2 * real(planes.inverse_w[2]);
    const real sum = (real(1.0f) - at.b1 - at.b2) * real(planes.inverse_w[0]) + q1 + q2;
    const real scale = real(1.0f) / sum;
    return {q1 * scale, q2 * scale, at.depth};
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_LOCATE_INL_H
