// What the texts of all methods have, for texts_alone.h, which has the rest.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "methods/fragment_lists.h"

namespace sheer::test {

template <class L>
struct Texts;

// A method for TextsAlone: its text's verbs, given the number of a fragment among the lists'.
template <class L>
struct MethodAlone {
    using T = Texts<L>;
    using real = typename L::real;
    using real3 = typename T::real3;
    using Kept = std::vector<real>;

    const FragmentLists& lists;
    const ChosenMethod& method;

    real3 color(std::size_t i) const
    {
        const ListedFragment& f = lists.fragments[i];
        return {real(f.red), real(f.green), real(f.blue)};
    }
    real opacity(std::size_t i) const { return real(lists.fragments[i].opacity); }
    static Kept kept(real3 c, real a, real b = real(0.0f)) { return {c.x, c.y, c.z, a, b}; }
    void begin_pixel(std::uint32_t) {}
    static constexpr bool kSorted = false;
    static constexpr int kPasses = 1;
    int pass = 0;
};

}  // namespace sheer::test
