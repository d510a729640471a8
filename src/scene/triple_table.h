// Numbers for triples of words: equal triples get the same number, new ones the next.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace sheer {

using Triple = std::array<std::uint32_t, 3>;

// The array's own == calls memcmp, which costs more than the comparison.
inline bool are_equal(const Triple& a, const Triple& b)
{
    return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

// A hash table with open addressing; where a file's triples were chosen to meet in it, a sorted
// one.
class TripleTable {
public:
    std::uint32_t number_of(const Triple& triple);

    // By number.
    const std::vector<Triple>& triples() const { return triples_; }

private:
    bool grow();  // false where the slots are no good
    // Where the triple is, or where it is to be. Null where that is too far to look.
    std::uint32_t* slot_of(const Triple& triple);
    std::uint32_t sorted_number_of(const Triple& triple);

    std::vector<Triple> triples_;
    std::vector<std::uint32_t> slots_;        // 1 + a triple's number, or 0; a power of two of them
    std::map<Triple, std::uint32_t> sorted_;  // instead of slots_, if not empty
};

}  // namespace sheer
