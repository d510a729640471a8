// real and mask over doubles, for the few texts that want them, and 64-bit integers for exact sums.
#if defined(SHEER_WIDE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_WIDE_INL_H
#undef SHEER_WIDE_INL_H
#else
#define SHEER_WIDE_INL_H
#endif

#include <cstdint>

#include "lanes/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <int Most>
struct WideLanes {
    // Up to `Most` lanes, fewer where the target's vectors are shorter.
    using D = hn::CappedTag<double, static_cast<std::size_t>(Most)>;
    using I = hn::RebindToSigned<D>;
    using U = hn::RebindToUnsigned<D>;
    using Float = hn::Rebind<float, D>;
    static constexpr int kCount = static_cast<int>(hn::MaxLanes(D()));

    struct mask {
        hn::Mask<D> m;
    };

    struct real {
        hn::Vec<D> v;
        real() = default;
        HWY_INLINE real(hn::Vec<D> x) : v(x) {}
        HWY_INLINE explicit real(double x) : v(hn::Set(D(), x)) {}
        static HWY_INLINE real load(const float* p)
        {
            return hn::PromoteTo(D(), hn::LoadU(Float(), p));
        }
        static HWY_INLINE real load(const double* p) { return hn::LoadU(D(), p); }
        HWY_INLINE void store(double* p) const { hn::StoreU(v, D(), p); }
        // Rounded to floats.
        HWY_INLINE hn::Vec<Float> narrowed() const { return hn::DemoteTo(Float(), v); }
        HWY_INLINE void store(float* p) const { hn::StoreU(narrowed(), Float(), p); }
        friend HWY_ATTR HWY_INLINE real operator+(real a, real b) { return hn::Add(a.v, b.v); }
        friend HWY_ATTR HWY_INLINE real operator-(real a, real b) { return hn::Sub(a.v, b.v); }
        friend HWY_ATTR HWY_INLINE real operator*(real a, real b) { return hn::Mul(a.v, b.v); }
        friend HWY_ATTR HWY_INLINE real operator/(real a, real b) { return hn::Div(a.v, b.v); }
        friend HWY_ATTR HWY_INLINE mask operator<(real a, real b) { return {hn::Lt(a.v, b.v)}; }
        friend HWY_ATTR HWY_INLINE mask operator>(real a, real b) { return {hn::Gt(a.v, b.v)}; }
    };

    using depth_real = real;

    // Of 64 bits.
    struct whole {
        hn::Vec<I> v;
        whole() = default;
        HWY_INLINE whole(hn::Vec<I> x) : v(x) {}
        HWY_INLINE explicit whole(std::int64_t x) : v(hn::Set(I(), x)) {}
        static HWY_INLINE whole load(const std::int64_t* p) { return hn::LoadU(I(), p); }
        static HWY_INLINE whole bits_of(real x) { return hn::BitCast(I(), x.v); }
        HWY_INLINE void store(std::int64_t* p) const { hn::StoreU(v, I(), p); }
        // Lane 0 of each of the four, then lane 1, ...
        static HWY_INLINE void store_in_turns(const whole (&four)[4], std::int64_t* p)
        {
            hn::StoreInterleaved4(four[0].v, four[1].v, four[2].v, four[3].v, I(), p);
        }
        // Wraps around.
        friend HWY_ATTR HWY_INLINE whole operator+(whole a, whole b) { return hn::Add(a.v, b.v); }
        friend HWY_ATTR HWY_INLINE whole operator-(whole a, whole b) { return hn::Sub(a.v, b.v); }
    };

    static HWY_INLINE real to_real(whole a) { return hn::ConvertTo(D(), a.v); }
    static HWY_INLINE real select(mask m, real a, real b) { return hn::IfThenElse(m.m, a.v, b.v); }
    static HWY_INLINE whole zero_unless(mask m, whole a)
    {
        return hn::IfThenElseZero(hn::RebindMask(I(), m.m), a.v);
    }
    // As in Lanes.
    static HWY_INLINE real max(real a, real b) { return select(a > b, a, b); }
    static HWY_INLINE real min(real a, real b) { return select(a < b, a, b); }
    static HWY_INLINE real sqrt(real a) { return hn::Sqrt(a.v); }
    // Lane i takes bit i of `bits`.
    static HWY_INLINE mask mask_of_bits(std::uint32_t bits)
    {
        const auto bit = hn::Shl(hn::Set(U(), 1u), hn::Iota(U(), 0));
        return {hn::RebindMask(D(), hn::TestBit(hn::Set(U(), bits), bit))};
    }
};

// Rounded to floats, and floats as doubles.
template <class W>
HWY_INLINE typename Lanes<W::kCount>::real narrowed(typename W::real x)
{
    alignas(64) float values[W::kCount];
    x.store(values);
    return Lanes<W::kCount>::real::load(values);
}
template <class W>
HWY_INLINE typename W::real widened(typename Lanes<W::kCount>::real x)
{
    alignas(64) float values[W::kCount];
    x.store(values);
    return W::real::load(values);
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_WIDE_INL_H
