// What the oracle of stochastic layered alpha blending (src/reference/slab.h) is asked for a
// method.
#pragma once

#include <span>

#include "methods/slab_settings.h"
#include "reference/slab.h"

namespace sheer::test {

inline reference::SlabResolve slab_resolve_of(const SlabSettings& settings)
{
    using reference::SlabResolve;
    if (settings.depth_based) {
        return settings.corrects ? SlabResolve::depth_corrected : SlabResolve::depth_based;
    }
    return settings.corrects ? SlabResolve::color_corrected : SlabResolve::color;
}

inline reference::SlabKeep slab_keep_of(const SlabSettings& settings)
{
    switch (settings.keep) {
        case SlabKeep::purged: return reference::SlabKeep::purged;
        case SlabKeep::visible: return reference::SlabKeep::visible;
        default: return reference::SlabKeep::nearest;
    }
}

// Of bits without number, where nothing is random.
inline reference::Rgba endless_slab_answer(const SlabSettings& settings,
                                           std::span<const reference::Fragment> fragments,
                                           reference::Rgba behind)
{
    const reference::SlabStore store = slab_store_of_alpha(fragments, settings.layers);
    if (settings.adds_tail) return slab(fragments, store, slab_resolve_of(settings), behind);
    // Without fragments behind the last layer the sums are the layers' own.
    if (settings.corrects) {
        return slab(fragments, store, reference::SlabResolve::color_corrected, behind);
    }
    const reference::Rgba layers = slab(fragments, store, reference::SlabResolve::color, {});
    double through = 1;
    for (const reference::Fragment& f : fragments) through *= 1 - f.opacity;
    return {layers.r + through * behind.r, layers.g + through * behind.g,
            layers.b + through * behind.b, layers.a + through * behind.a};
}

}  // namespace sheer::test
