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
struct Group {
    Submission submission;
    std::vector<std::size_t> takes;
    std::size_t uses = 0;  // how often a tile's fragments are gone through
};

inline std::vector<Group> group_takes(std::span<const Take> takes)
{
    std::vector<Group> groups;
    for (std::size_t i = 0; i < takes.size(); ++i) {
        const Submission submission = submission_of(takes[i]);
        auto group = std::find_if(groups.begin(), groups.end(),
                                  [&](const Group& g) { return g.submission == submission; });
        if (group == groups.end()) group = groups.insert(group, {submission, {}, 0});
        group->takes.push_back(i);
        group->uses +=
            takes[i].keys.size() * static_cast<std::size_t>(takes[i].method.traits().passes);
    }
    return groups;
}

// Of the stream: a tile's fragments are kept where they are used more than once.
inline int stream_capacity(const std::vector<Group>& groups)
{
    const bool again = std::any_of(groups.begin(), groups.end(),
                                   [](const Group& group) { return group.uses > 1; });
    return again ? kKeptFragments : kStreamFragments;
}

}  // namespace sheer
