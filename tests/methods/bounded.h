// A double and how far the same computation in floats may be from it, step by step: the running
// error analysis of Higham (Accuracy and Stability of Numerical Algorithms, 2002, section 3.3).
//
// The rounding of an operation is at most u = 2^-24 of its result, or half of the smallest
// denormal, and is none where the operands are exact and a float can hold the result. Bounds don't
// hold where a comparison may go one way in floats and the other in doubles; those are counted.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace sheer::test {

struct Bounded {
    double value = 0;
    double bound = 0;

    static inline std::uint64_t doubtful = 0;  // comparisons

    Bounded() = default;
    explicit Bounded(float exact) : value(static_cast<double>(exact)) {}
    explicit Bounded(std::uint32_t whole) : Bounded(rounded(whole, 0)) {}
    explicit operator std::uint32_t() const
    {
        if (bound != 0) ++doubtful;
        return static_cast<std::uint32_t>(value);
    }

    // Of an operation whose operands' errors change the result by `carried` at most.
    static Bounded rounded(double result, double carried)
    {
        Bounded r;
        r.value = result;
        if (carried == 0 && static_cast<double>(static_cast<float>(result)) == result) return r;
        // The double's own rounding too, and that of these sums.
        r.bound = carried + (std::abs(result) + carried) * (0x1p-24 + 0x1p-52) + 0x1p-150;
        r.bound *= 1 + 0x1p-48;
        return r;
    }
    friend Bounded operator+(Bounded a, Bounded b)
    {
        return rounded(a.value + b.value, a.bound + b.bound);
    }
    friend Bounded operator-(Bounded a, Bounded b)
    {
        return rounded(a.value - b.value, a.bound + b.bound);
    }
    friend Bounded operator*(Bounded a, Bounded b)
    {
        return rounded(a.value * b.value, std::abs(a.value) * b.bound +
                                              std::abs(b.value) * a.bound + a.bound * b.bound);
    }
    friend Bounded operator/(Bounded a, Bounded b)
    {
        const double least = std::abs(b.value) - b.bound;
        const double quotient = a.value / b.value;
        if (!(least > 0)) return rounded(quotient, INFINITY);
        return rounded(quotient, (a.bound + std::abs(quotient) * b.bound) / least);
    }

    static bool sure(Bounded a, Bounded b)
    {
        const double apart = std::abs(a.value - b.value);
        return (a.bound == 0 && b.bound == 0) || apart > a.bound + b.bound;
    }
    friend bool operator<(Bounded a, Bounded b)
    {
        if (!sure(a, b)) ++doubtful;
        return a.value < b.value;
    }
    friend bool operator>(Bounded a, Bounded b) { return b < a; }
    friend bool operator==(Bounded a, Bounded b)
    {
        if (!sure(a, b)) ++doubtful;
        return a.value == b.value;
    }
};

// For the texts, as Lone is.
struct LoneBounded {
    using real = Bounded;
    using depth_real = real;
    using whole = std::uint32_t;
    using mask = bool;

    static real select(bool m, real a, real b) { return m ? a : b; }
    static whole select(bool m, whole a, whole b) { return m ? a : b; }
    static whole zero_unless(bool m, whole a) { return m ? a : 0; }
    // Near where they turn, both sides' errors count.
    static real min(real a, real b)
    {
        real result = a.value < b.value ? a : b;
        if (!Bounded::sure(a, b)) result.bound = std::max(a.bound, b.bound);
        return result;
    }
    static real max(real a, real b)
    {
        real result = a.value > b.value ? a : b;
        if (!Bounded::sure(a, b)) result.bound = std::max(a.bound, b.bound);
        return result;
    }
    static real to_real(whole a) { return real(a); }
    static whole to_whole(real a) { return static_cast<whole>(a); }
};

}  // namespace sheer::test
