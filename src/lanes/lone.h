// One plain number where Lanes has a vector: the texts as float, for what goes sample by sample,
// and as double, to see what rounding does to them.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include "lanes/text.h"

namespace sheer {

template <class T>
struct Lone {
    using real = T;
    using depth_real = real;
    using whole = std::uint32_t;
    using mask = bool;

    static real select(bool m, real a, real b) { return m ? a : b; }
    static whole select(bool m, whole a, whole b) { return m ? a : b; }
    static whole zero_unless(bool m, whole a) { return m ? a : 0; }
    static real min(real a, real b) { return a < b ? a : b; }
    static real max(real a, real b) { return a > b ? a : b; }
    static real to_real(whole a) { return static_cast<real>(a); }
    static whole to_whole(real a)
    {
        return a < 0 ? static_cast<whole>(static_cast<std::int32_t>(a)) : static_cast<whole>(a);
    }
    static real floor(real a) { return std::floor(a); }
    static real octave(real a) { return std::ldexp(real(1), std::ilogb(a)); }
    static real sqrt(real a) { return std::sqrt(a); }
    // Of a float, which is all that there are bits for.
    static whole bits_of(real a) { return std::bit_cast<whole>(static_cast<float>(a)); }
    static real real_of_bits(whole a) { return static_cast<real>(std::bit_cast<float>(a)); }
};

}  // namespace sheer
