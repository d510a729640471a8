// Linear probing in a table that is at most half full.
#include "scene/triple_table.h"

#include <algorithm>

#include "support/random.h"

namespace sheer {

std::uint32_t& TripleTable::slot_of(const Triple& triple)
{
    const std::uint64_t hash = mix64(mix64(std::uint64_t{triple[0]} << 32 | triple[1]) + triple[2]);
    const std::size_t mask = slots_.size() - 1;
    std::size_t i = static_cast<std::size_t>(hash) & mask;
    while (slots_[i] != 0 && !are_equal(triples_[slots_[i] - 1], triple)) i = (i + 1) & mask;
    return slots_[i];
}

void TripleTable::grow()
{
    constexpr std::size_t kFewest = 16;
    slots_.assign(std::max(kFewest, 2 * slots_.size()), 0);
    for (std::size_t i = 0; i < triples_.size(); ++i) {
        slot_of(triples_[i]) = static_cast<std::uint32_t>(i + 1);
    }
}

std::uint32_t TripleTable::number_of(const Triple& triple)
{
    if (2 * triples_.size() >= slots_.size()) grow();
    std::uint32_t& slot = slot_of(triple);
    if (slot == 0) {
        triples_.push_back(triple);
        slot = static_cast<std::uint32_t>(triples_.size());
    }
    return slot - 1;
}

}  // namespace sheer
