// Where on its surface a fragment is, at the point where it is shaded, and how that changes over
// the screen: from the triangle's planes, not from differences between pixels.
#if defined(SHEER_PLACES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_PLACES_INL_H
#undef SHEER_PLACES_INL_H
#else
#define SHEER_PLACES_INL_H
#endif

#include "cpu/triangle_batch-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

// Weights of vertices 1 and 2, perspective-correct, and what a pixel to the right and down adds.
struct WeightsOnScreen {
    Block::real w1, w2, w1_x, w2_x, w1_y, w2_y;
};

HWY_INLINE WeightsOnScreen weights_on_screen(const PlaneBatch& planes, const Block::Lookup& of,
                                             const LocatedOnScreen& at)
{
    using real = Block::real;
    const WeightBatch &weight1 = planes.weight1, &weight2 = planes.weight2;
    const WeightsOnScreen affine{at.b1,
                                 at.b2,
                                 of.of(weight1.pixel_x),
                                 of.of(weight2.pixel_x),
                                 of.of(weight1.pixel_y),
                                 of.of(weight2.pixel_y)};
    if (planes.all_affine) return affine;
    const real inverse0 = of.of(planes.inverse_w[0]), inverse1 = of.of(planes.inverse_w[1]),
               inverse2 = of.of(planes.inverse_w[2]);
    const real g1 = at.b1 * inverse1, g2 = at.b2 * inverse2;
    const real w = real(1.0f) / ((real(1.0f) - at.b1 - at.b2) * inverse0 + g1 + g2);
    WeightsOnScreen result;
    result.w1 = g1 * w;
    result.w2 = g2 * w;
    // Of quotients along one axis of the screen.
    const auto steps = [&](real step1, real step2, real& w1, real& w2) HWY_ATTR {
        const real g1_step = step1 * inverse1, g2_step = step2 * inverse2;
        const real sum_step = g1_step + g2_step - (step1 + step2) * inverse0;
        w1 = (g1_step - result.w1 * sum_step) * w;
        w2 = (g2_step - result.w2 * sum_step) * w;
    };
    steps(affine.w1_x, affine.w2_x, result.w1_x, result.w2_x);
    steps(affine.w1_y, affine.w2_y, result.w1_y, result.w2_y);
    if (!planes.any_affine) return result;
    const Block::mask perspective = of.of(planes.affine) == Block::whole(0);
    const auto choose = [&](real& mine, real other)
                            HWY_ATTR { mine = Block::select(perspective, mine, other); };
    choose(result.w1, affine.w1);
    choose(result.w2, affine.w2);
    choose(result.w1_x, affine.w1_x);
    choose(result.w2_x, affine.w2_x);
    choose(result.w1_y, affine.w1_y);
    choose(result.w2_y, affine.w2_y);
    return result;
}

// Of the fragments of triangles first, ..., end - 1, whose list is the stream's.
HWY_INLINE void add_places(const TileJob& job, const TileSetup& setup, const TriangleBatch& batch,
                           std::size_t first, std::size_t end, const CoverageList& list,
                           FragmentStream& s)
{
    using real = Block::real;
    VaryingBatch<Block, 3> corners;
    for (std::size_t k = first; k < end; ++k) {
        const Triangle& t = *batch.triangle[k];
        const auto at = [&](std::size_t i) HWY_ATTR {
            return job.geometry->place_of(*job.wants.places, *batch.chunk[k], t.vertex[i]);
        };
        corners.set(k, at(0), at(1), at(2));
    }
    const int begin = batch.begin[first];
    for (int i = begin; i < batch.begin[end]; i += Block::kCount) {
        const Block::Lookup of(Block::whole::load(batch.owner + (i - begin)));
        const LocatedOnScreen at =
            locate_on_screen(batch.planes, of, *job.samples, list, i, setup.rates);
        const WeightsOnScreen w = weights_on_screen(batch.planes, of, at);
        for (std::size_t c = 0; c < 3; ++c) {
            const real toward1 = of.of(corners.value[1][c]), toward2 = of.of(corners.value[2][c]);
            corners.at(c, of, w.w1, w.w2).store(s.place[c].data() + i);
            (at.side * (w.w1_x * toward1 + w.w2_x * toward2)).store(s.place[3 + c].data() + i);
            (at.side * (w.w1_y * toward1 + w.w2_y * toward2)).store(s.place[6 + c].data() + i);
        }
    }
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_PLACES_INL_H
