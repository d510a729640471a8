// The `over` operator on a sorted list: T. Porter, T. Duff, "Compositing digital images", 1984, in
// the form of equation 2 of E. Enderton et al., "Stochastic transparency", 2010, with ties in depth
// ordered by identity (docs/numerics.md, "Resolve").
#include <algorithm>
#include <tuple>

#include "reference/fragments.h"

namespace sheer::reference {

Rgba composite(std::vector<Fragment> fragments, Rgba backdrop)
{
    // Stable, for pieces of one clipped triangle share an id: the order of submission decides
    // there.
    std::stable_sort(fragments.begin(), fragments.end(), [](const Fragment& a, const Fragment& b) {
        return std::tie(a.depth, a.id) < std::tie(b.depth, b.id);
    });
    Rgba sum;
    double transmittance = 1;
    for (const Fragment& fragment : fragments) {
        const double weight = transmittance * fragment.opacity;
        sum.r += weight * fragment.color[0];
        sum.g += weight * fragment.color[1];
        sum.b += weight * fragment.color[2];
        transmittance *= 1 - fragment.opacity;
    }
    return {sum.r + transmittance * backdrop.r, sum.g + transmittance * backdrop.g,
            sum.b + transmittance * backdrop.b, 1 - transmittance * (1 - backdrop.a)};
}

bool in_front(const Sighting& a, const Sighting& b)
{
    return std::tie(a.depth, a.surface->triangle->primitive) <
           std::tie(b.depth, b.surface->triangle->primitive);
}

}  // namespace sheer::reference
