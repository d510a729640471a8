// Takes by what they want of their fragments.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "cpu/frame.h"
#include "cpu/tile_passes.h"

namespace sheer {

// Takes that share fragments.
struct TakeGroup {
    FragmentWants wants;
    std::vector<std::size_t> takes;
    std::size_t uses = 0;  // how often a tile's fragments are gone through
};

inline std::vector<TakeGroup> group_takes(std::span<const Take> takes)
{
    std::vector<TakeGroup> groups;
    for (std::size_t i = 0; i < takes.size(); ++i) {
        const FragmentWants wants = takes[i].method.wants();
        auto group = std::find_if(groups.begin(), groups.end(),
                                  [&](const TakeGroup& g) { return g.wants == wants; });
        if (group == groups.end()) group = groups.insert(group, {wants, {}, 0});
        group->takes.push_back(i);
        group->uses +=
            takes[i].keys.size() * static_cast<std::size_t>(takes[i].method.traits().passes);
    }
    return groups;
}

inline bool any_placed(const std::vector<TakeGroup>& groups)
{
    return std::any_of(groups.begin(), groups.end(),
                       [](const TakeGroup& group) { return group.wants.places.has_value(); });
}

// Of the methods, and of hashed rays.
inline PlaceSpaces places_of(std::span<const Take> takes, const AmbientOcclusion& occlusion)
{
    PlaceSpaces places = {};
    if (occlusion.rays > 0 && occlusion.samples == RaySamples::hashed) {
        places[static_cast<std::size_t>(PlaceSpace::object)] = true;
    }
    for (const Take& take : takes) {
        const auto space = take.method.wants().places;
        if (space) places[static_cast<std::size_t>(*space)] = true;
    }
    return places;
}

// Of the stream: a tile's fragments are kept where they are used more than once.
inline int stream_capacity(const std::vector<TakeGroup>& groups)
{
    const bool again = std::any_of(groups.begin(), groups.end(),
                                   [](const TakeGroup& group) { return group.uses > 1; });
    return again ? kKeptFragments : kStreamFragments;
}

}  // namespace sheer
