// One plain number where Lanes has a vector: the texts as float, for what goes sample by sample,
// and as double, to see what rounding does to them.
#pragma once

#include <cstdint>

#include "lanes/text.h"

namespace sheer {

template <class T>
struct Lone {
    using real = T;
    using whole = std::uint32_t;
    using mask = bool;

    static real select(bool m, real a, real b) { return m ? a : b; }
    static whole select(bool m, whole a, whole b) { return m ? a : b; }
    static whole zero_unless(bool m, whole a) { return m ? a : 0; }
    static real min(real a, real b) { return a < b ? a : b; }
    static real max(real a, real b) { return a > b ? a : b; }
    static real to_real(whole a) { return static_cast<real>(a); }
    static whole to_whole(real a) { return static_cast<whole>(a); }
};

}  // namespace sheer
