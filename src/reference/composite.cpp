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
    double sum[3] = {0, 0, 0};
    double transmittance[3] = {1, 1, 1};
    for (const Fragment& fragment : fragments) {
        for (int c = 0; c < 3; ++c) {
            sum[c] += transmittance[c] * fragment.opacity * fragment.color[c];
            transmittance[c] *= fragment.transmittance[c];
        }
    }
    const double mean = (transmittance[0] + transmittance[1] + transmittance[2]) / 3;
    return {sum[0] + transmittance[0] * backdrop.r, sum[1] + transmittance[1] * backdrop.g,
            sum[2] + transmittance[2] * backdrop.b, 1 - mean * (1 - backdrop.a)};
}

bool in_front(const Sighting& a, const Sighting& b)
{
    return std::tie(a.depth, a.surface->triangle->primitive) <
           std::tie(b.depth, b.surface->triangle->primitive);
}

}  // namespace sheer::reference
