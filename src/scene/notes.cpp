// Notes about what a reader leaves out. The number of kinds is limited, since some are named after
// what stands in the file.

#include "scene/notes.h"

namespace sheer {

namespace {

constexpr std::size_t kMaxKinds = 40;

}  // namespace

void Notes::add(const std::string& things, const std::string& consequence, std::size_t count)
{
    if (count == 0) return;
    const std::pair kind(things, consequence);
    if (counts_.size() < kMaxKinds || counts_.contains(kind)) {
        counts_[kind] += count;
    } else {
        counts_[{"other things", "not drawn"}] += count;
    }
}

std::vector<std::string> Notes::lines() const
{
    std::vector<std::string> lines;
    for (const auto& [kind, count] : counts_) {
        lines.push_back(kind.first + ": " + std::to_string(count) + ", " + kind.second);
    }
    return lines;
}

}  // namespace sheer
