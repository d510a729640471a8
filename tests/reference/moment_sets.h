// Lists whose transmittances from moments are known, to six digits, from another program.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "reference/reference.h"

namespace sheer::reference {

// Depth and opacity of each.
inline std::vector<Fragment> at_depths(const std::vector<std::pair<double, double>>& layers)
{
    std::vector<Fragment> fragments;
    for (const auto& [z, alpha] : layers) {
        fragments.push_back({z, alpha, {}, static_cast<std::uint32_t>(fragments.size())});
    }
    return fragments;
}

inline const auto kTwo = at_depths({{-0.5, 0.3}, {0.4, 0.6}});
inline const auto kThree = at_depths({{-0.6, 0.4}, {0, 0.5}, {0.5, 0.7}});
inline const auto kFour = at_depths({{-0.75, 0.5}, {-0.25, 0.5}, {0.25, 0.5}, {0.75, 0.5}});
inline const auto kEight = at_depths({{-0.875, 0.2},
                                      {-0.625, 0.2},
                                      {-0.375, 0.2},
                                      {-0.125, 0.2},
                                      {0.125, 0.2},
                                      {0.375, 0.2},
                                      {0.625, 0.2},
                                      {0.875, 0.2}});

// Of the light from z, without what is at z itself.
inline double true_transmittance(const std::vector<Fragment>& fragments, double z)
{
    double through = 1;
    for (const Fragment& f : fragments) through *= f.depth < z ? 1 - f.opacity : 1;
    return through;
}

}  // namespace sheer::reference
