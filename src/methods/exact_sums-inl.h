// Sums that are the same bits in every order: each addend is rounded to a grid, and the rounded
// ones are added up as 64-bit integers, which lose nothing.
#if defined(SHEER_EXACT_SUMS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_EXACT_SUMS_INL_H
#undef SHEER_EXACT_SUMS_INL_H
#else
#define SHEER_EXACT_SUMS_INL_H
#endif

#include <bit>
#include <cmath>
#include <cstdint>

#include "lanes/wide-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

// Addends are below 2^51 units, sums below 2^63.
struct ExactGrid {
    double unit;   // a power of two
    double magic;  // where doubles are a unit apart

    // Made for every few fragments, so from bits: ldexp is a call.
    explicit ExactGrid(int exponent)
        : unit(power_of_two(exponent)), magic(1.5 * power_of_two(52 + exponent))
    {
    }

private:
    static double power_of_two(int exponent)
    {
        return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + exponent) << 52);
    }
};

HWY_INLINE std::int64_t add_wrapping(std::int64_t a, std::int64_t b)
{
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(a) + static_cast<std::uint64_t>(b));
}

HWY_INLINE void add_all(const AlignedArray<std::int64_t>& from, AlignedArray<std::int64_t>& to)
{
    for (std::size_t i = 0; i < to.size(); ++i) to[i] = add_wrapping(to[i], from[i]);
}

template <class W>
HWY_INLINE typename W::whole exact_units(typename W::real x, const ExactGrid& grid)
{
    const typename W::real magic(grid.magic);
    return W::whole::bits_of(x + magic) - W::whole::bits_of(magic);
}

// Of sums that follow one another.
HWY_INLINE void add_four(const std::int64_t* units, std::int64_t* sums)
{
    using Four = WideLanes<4>;
    for (std::size_t k = 0; k < 4; k += Four::kCount) {
        (Four::whole::load(sums + k) + Four::whole::load(units + k)).store(sums + k);
    }
}

template <class W>
HWY_INLINE typename W::real exact_sum(const std::int64_t* units, const ExactGrid& grid)
{
    return W::to_real(W::whole::load(units)) * typename W::real(grid.unit);
}

// To as many sums as L has lanes, those of W's vectors one after the other.
template <class L, class W>
HWY_INLINE void add_exactly(typename L::real x, const ExactGrid& grid, std::int64_t* units)
{
    alignas(64) float values[L::kCount];
    x.store(values);
    for (int i = 0; i < L::kCount; i += W::kCount) {
        const auto addend = exact_units<W>(W::real::load(values + i), grid);
        (W::whole::load(units + i) + addend).store(units + i);
    }
}

// The sums as floats.
template <class L, class W>
HWY_INLINE typename L::real exact_sum_as_float(const std::int64_t* units, const ExactGrid& grid)
{
    alignas(64) float values[L::kCount];
    for (int i = 0; i < L::kCount; i += W::kCount) {
        exact_sum<W>(units + i, grid).store(values + i);
    }
    return L::real::load(values);
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_EXACT_SUMS_INL_H
