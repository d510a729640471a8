#include "reference/owned_samples.h"

namespace sheer::reference {
namespace {

bool covers(const PixelFragment& fragment, std::size_t sample)
{
    return (fragment.covered >> sample & 1) != 0;
}

bool is_behind(const PixelFragment& fragment, const PixelFragment& owner, std::size_t sample)
{
    const double depth = fragment.depth[sample], of_owner = owner.depth[sample];
    return depth > of_owner || (depth == of_owner && fragment.id > owner.id);
}

}  // namespace

SampleSum owned_sum(std::span<const PixelFragment> fragments, int owner)
{
    if (owner < 0) return {};
    return {fragments[static_cast<std::size_t>(owner)].color, 1};
}

SampleSum seen_sum(std::span<const PixelFragment> fragments, int owner, std::size_t sample)
{
    SampleSum sum;
    for (const PixelFragment& fragment : fragments) {
        if (!covers(fragment, sample)) continue;
        if (owner >= 0 && is_behind(fragment, fragments[static_cast<std::size_t>(owner)], sample)) {
            continue;
        }
        for (std::size_t c = 0; c < 3; ++c) sum.color[c] += fragment.opacity * fragment.color[c];
        sum.weight += fragment.opacity;
    }
    return sum;
}

double total_transmittance(std::span<const PixelFragment> fragments, std::size_t sample)
{
    double transmittance = 1;
    for (const PixelFragment& fragment : fragments) {
        if (covers(fragment, sample)) transmittance *= 1 - fragment.opacity;
    }
    return transmittance;
}

}  // namespace sheer::reference
