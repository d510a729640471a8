// Which level of its texture a fragment is read at, and how oblique: for methods that do something
// else far away.
#if defined(SHEER_LEVELS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_LEVELS_INL_H
#undef SHEER_LEVELS_INL_H
#else
#define SHEER_LEVELS_INL_H
#endif

#include <algorithm>
#include <limits>

#include "cpu/triangle_batch-inl.h"
#include "lanes/text.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <class L>
struct LevelText {
#include "lanes/text_words.h"
#include "sheer/fade_in.glsl"
};

// Of the fragments of triangles first, ..., end - 1, which are of one object.
HWY_INLINE void add_levels(const TileJob& job, const TileSetup& setup, const TriangleBatch& batch,
                           std::size_t first, std::size_t end, const CoverageList& list,
                           FragmentStream& s)
{
    using real = Block::real;
    const Surface& surface = job.surfaces->surfaces[batch.object()];
    float* levels = s.level.data();
    if (surface.detail == nullptr || !surface.detail->base_color) {
        std::fill(levels + batch.begin[first], levels + batch.begin[end],
                  std::numeric_limits<float>::infinity());
        return;
    }
    const PreparedTexture& texture = *surface.detail->base_color;
    for (std::size_t k = first; k < end; ++k) {
        TriangleDetail detail;
        set_texcoords(job, *batch.chunk[k], *batch.triangle[k], detail);
        const Block::Lookup of(Block::whole(static_cast<std::int32_t>(k)));
        for (int i = batch.begin[k]; i < batch.begin[k + 1]; i += Block::kCount) {
            const LocatedOnScreen at =
                locate_on_screen(batch.planes, of, *job.samples, list, i, setup.rates);
            const int lanes = batch.begin[k + 1] - i;
            const auto point = shade_point(batch.planes, k, setup.rays, at, lanes);
            const Footprint<Block> f = footprint<Block>(texture, detail, point);
            const real level = choose_level<Block>(texture, f).level;
            const real anisotropy =
                LevelText<Block>::texture_anisotropy(f.u_x, f.v_x, f.u_y, f.v_y);
            (level * anisotropy).store(levels + i);
        }
    }
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_LEVELS_INL_H
