// log2 for lanes, the same bits on every target.
#if defined(SHEER_LOG2_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_LOG2_INL_H
#undef SHEER_LOG2_INL_H
#else
#define SHEER_LOG2_INL_H
#endif

#include "lanes/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

// Of a positive normal number, to 3e-7 absolutely near 1 and to one part in 2^22 elsewhere: the
// exponent, and for the rest m in [sqrt(1/2), sqrt(2)) the series of atanh,
// log2(m) = 2 / ln 2 (t + t^3 / 3 + ...), t = (m - 1) / (m + 1), |t| < 0.172.
template <class L>
HWY_INLINE typename L::real log2(typename L::real x)
{
    using real = typename L::real;
    using whole = typename L::whole;
    // Counted from sqrt(1/2), so that the exponent's bits round the way that m needs.
    constexpr std::uint32_t kRootHalf = 0x3f3504f3u;
    const whole from_root = whole::bits_of(x) - whole(kRootHalf);
    const real exponent =
        L::to_real((from_root + whole(0x3f800000u)).template shift_right<23>() - whole(127));
    const real m = ((from_root & whole(0x007fffffu)) + whole(kRootHalf)).as_real();
    const real t = (m - real(1.0f)) / (m + real(1.0f)), t2 = t * t;
    const real series =
        real(1.0f) +
        t2 * (real(1.0f / 3) + t2 * (real(1.0f / 5) + t2 * (real(1.0f / 7) + t2 * real(1.0f / 9))));
    return exponent + real(2.885390082f) * t * series;
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_LOG2_INL_H
