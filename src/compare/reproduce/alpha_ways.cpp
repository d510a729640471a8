#include "compare/reproduce/alpha_ways.h"

#include "compare/reproduce/alpha_models.h"
#include "compare/reproduce/stratified_seeds.h"

namespace sheer {

Image draw_way(const Scene& scene, const AlphaWay& way, int pixels, std::uint64_t seed,
               Options options)
{
    View view = view_of(pixels, way.samples);
    view.alpha_mips = way.mips;
    view.texture_levels = way.levels;
    view.shade_at = way.shade_at;
    view.conservative = way.conservative;
    options.seed = seed;
    return draw_method(scene, view, way.method, options);
}

}  // namespace sheer
