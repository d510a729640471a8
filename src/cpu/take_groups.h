// Takes by the order in which their fragments come.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "cpu/frame.h"
#include "cpu/tile_passes.h"

namespace sheer {

inline Submission submission_of(const Take& take)
{
    const auto submission = take.method.row->submission;
    return submission != nullptr ? submission(take.method) : Submission::as_given;
}

// Takes whose fragments come in the same order.
struct TakeGroup {
    Submission submission;
    std::vector<std::size_t> takes;
    std::size_t uses = 0;  // how often a tile's fragments are gone through
};

inline std::vector<TakeGroup> group_takes(std::span<const Take> takes)
{
    std::vector<TakeGroup> groups;
    for (std::size_t i = 0; i < takes.size(); ++i) {
        const Submission submission = submission_of(takes[i]);
        auto group = std::find_if(groups.begin(), groups.end(),
                                  [&](const TakeGroup& g) { return g.submission == submission; });
        if (group == groups.end()) group = groups.insert(group, {submission, {}, 0});
        group->takes.push_back(i);
        group->uses +=
            takes[i].keys.size() * static_cast<std::size_t>(takes[i].method.traits().passes);
    }
    return groups;
}

// Of the stream: a tile's fragments are kept where they are used more than once.
inline int stream_capacity(const std::vector<TakeGroup>& groups)
{
    const bool again = std::any_of(groups.begin(), groups.end(),
                                   [](const TakeGroup& group) { return group.uses > 1; });
    return again ? kKeptFragments : kStreamFragments;
}

}  // namespace sheer
