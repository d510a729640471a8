// Linear probing in a table that is at most half full.
#include "scene/triple_table.h"

#include <algorithm>

#include "support/random.h"

namespace sheer {

namespace {

// At half full the longest way of n triples is about log(n) / 0.19: 120 of 2^32 (Pittel. Linear
// Probing: The Probable Largest Search Time Grows Logarithmically with the Number of Records.
// Journal of Algorithms 8(2), 1987). Longer ones are made on purpose.
constexpr std::size_t kLongestWay = 256;

}  // namespace

std::uint32_t* TripleTable::slot_of(const Triple& triple)
{
    const std::uint64_t hash = mix64(mix64(std::uint64_t{triple[0]} << 32 | triple[1]) + triple[2]);
    const std::size_t mask = slots_.size() - 1;
    std::size_t i = static_cast<std::size_t>(hash) & mask;
    for (std::size_t way = 0; way < kLongestWay; ++way, i = (i + 1) & mask) {
        if (slots_[i] == 0 || are_equal(triples_[slots_[i] - 1], triple)) return &slots_[i];
    }
    return nullptr;
}

bool TripleTable::grow()
{
    constexpr std::size_t kFewest = 16;
    slots_.assign(std::max(kFewest, 2 * slots_.size()), 0);
    for (std::size_t i = 0; i < triples_.size(); ++i) {
        std::uint32_t* slot = slot_of(triples_[i]);
        if (slot == nullptr) return false;
        *slot = static_cast<std::uint32_t>(i + 1);
    }
    return true;
}

std::uint32_t TripleTable::sorted_number_of(const Triple& triple)
{
    const auto next = static_cast<std::uint32_t>(triples_.size());
    const auto [entry, is_new] = sorted_.try_emplace(triple, next);
    if (is_new) triples_.push_back(triple);
    return entry->second;
}

std::uint32_t TripleTable::number_of(const Triple& triple)
{
    if (!sorted_.empty()) return sorted_number_of(triple);
    const bool has_room = 2 * triples_.size() < slots_.size() || grow();
    std::uint32_t* slot = has_room ? slot_of(triple) : nullptr;
    if (slot == nullptr) {
        slots_ = {};
        for (std::uint32_t i = 0; i < triples_.size(); ++i) sorted_.emplace(triples_[i], i);
        return sorted_number_of(triple);
    }
    if (*slot == 0) {
        triples_.push_back(triple);
        *slot = static_cast<std::uint32_t>(triples_.size());
    }
    return *slot - 1;
}

}  // namespace sheer
