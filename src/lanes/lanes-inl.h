// real, whole and mask: a vector of floats, of 32-bit integers and of truth values, with operators,
// so that vector code reads like the formula it implements. Compiled once for each target.
//
// Every operation is one IEEE operation a lane (no fused or approximate ones), so that all targets
// give the same bits.
#if defined(SHEER_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_LANES_INL_H
#undef SHEER_LANES_INL_H
#else
#define SHEER_LANES_INL_H
#endif

#include <cstdint>

#include "lanes/pack_order.h"
#include "lanes/targets.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

template <int Most>
struct Lanes {
    // Up to `Most` lanes, fewer where the target's vectors are shorter.
    using F = hn::CappedTag<float, static_cast<std::size_t>(Most)>;
    using I = hn::RebindToSigned<F>;
    using U = hn::RebindToUnsigned<F>;
    static constexpr int kCount = static_cast<int>(hn::MaxLanes(F()));
    static constexpr bool kIsX86 =
        HWY_ARCH_X86 && HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128;

    struct mask {
        hn::Mask<F> m;
        friend HWY_ATTR HWY_INLINE mask operator&(mask a, mask b) { return {hn::And(a.m, b.m)}; }
        friend HWY_ATTR HWY_INLINE mask operator|(mask a, mask b) { return {hn::Or(a.m, b.m)}; }
        friend HWY_ATTR HWY_INLINE mask operator!(mask a) { return {hn::Not(a.m)}; }
        // As the texts write them; both sides are there already.
        friend HWY_ATTR HWY_INLINE mask operator&&(mask a, mask b) { return a & b; }
        friend HWY_ATTR HWY_INLINE mask operator||(mask a, mask b) { return a | b; }
        HWY_INLINE bool any() const { return !hn::AllFalse(F(), m); }
        // Lane i in bit i.
        HWY_INLINE std::uint32_t bits() const
        {
            std::uint8_t bytes[8] = {};
            hn::StoreMaskBits(F(), m, bytes);
            const std::uint32_t both = bytes[0] | static_cast<std::uint32_t>(bytes[1]) << 8;
            return both & ((1u << kCount) - 1u);
        }
        HWY_INLINE int count() const { return static_cast<int>(hn::CountTrue(F(), m)); }
    };

    struct real {
        hn::Vec<F> v;
        real() = default;
        HWY_INLINE real(hn::Vec<F> x) : v(x) {}
        HWY_INLINE explicit real(float x) : v(hn::Set(F(), x)) {}
        static HWY_INLINE real load(const float* p) { return hn::LoadU(F(), p); }
        HWY_INLINE void store(float* p) const { hn::StoreU(v, F(), p); }
        // Leaves the other lanes as they are in memory.
        HWY_INLINE void store_where(mask m, float* p) const
        {
            // Elsewhere a masked store takes several instructions, or long, and what is kept can be
            // a choice's own operand. Masks of one or two lanes have bits of none, which would be
            // stored too.
            if constexpr (HWY_TARGET <= HWY_AVX3 && kCount >= 4) {
                hn::BlendedStore(v, m.m, F(), p);
            } else {
                hn::StoreU(hn::IfThenElse(hn::Not(m.m), hn::LoadU(F(), p), v), F(), p);
            }
        }
        HWY_INLINE float greatest() const
        {
            // Not all of Highway's, which spreads the answer over a long vector.
            if constexpr (kIsX86 && kCount > 4) {
                const hn::Half<F> half;
                const auto other = UpperHalf(half, v);  // which single lanes have not
                return typename Lanes<kCount / 2>::real(hn::Max(hn::LowerHalf(half, v), other))
                    .greatest();
            } else {
                return hn::GetLane(hn::MaxOfLanes(F(), v));
            }
        }
        friend HWY_ATTR HWY_INLINE real operator+(real a, real b) { return hn::Add(a.v, b.v); }
        friend HWY_ATTR HWY_INLINE real operator-(real a, real b) { return hn::Sub(a.v, b.v); }
        friend HWY_ATTR HWY_INLINE real operator*(real a, real b) { return hn::Mul(a.v, b.v); }
        friend HWY_ATTR HWY_INLINE real operator/(real a, real b) { return hn::Div(a.v, b.v); }
        friend HWY_ATTR HWY_INLINE mask operator<(real a, real b) { return {hn::Lt(a.v, b.v)}; }
        friend HWY_ATTR HWY_INLINE mask operator>(real a, real b) { return {hn::Gt(a.v, b.v)}; }
        friend HWY_ATTR HWY_INLINE mask operator<=(real a, real b) { return {hn::Le(a.v, b.v)}; }
        friend HWY_ATTR HWY_INLINE mask operator>=(real a, real b) { return {hn::Ge(a.v, b.v)}; }
        friend HWY_ATTR HWY_INLINE mask operator==(real a, real b) { return {hn::Eq(a.v, b.v)}; }
    };

    using depth_real = real;

    struct whole {
        hn::Vec<I> v;
        whole() = default;
        HWY_INLINE whole(hn::Vec<I> x) : v(x) {}
        HWY_INLINE explicit whole(std::int32_t x) : v(hn::Set(I(), x)) {}
        HWY_INLINE explicit whole(std::uint32_t x) : whole(static_cast<std::int32_t>(x)) {}
        static HWY_INLINE whole load(const std::int32_t* p) { return hn::LoadU(I(), p); }
        static HWY_INLINE whole load(const std::uint32_t* p)
        {
            return hn::BitCast(I(), hn::LoadU(U(), p));
        }
        static HWY_INLINE whole bits_of(real x) { return hn::BitCast(I(), x.v); }
        HWY_INLINE real as_real() const { return hn::BitCast(F(), v); }  // the same bits
        HWY_INLINE std::uint32_t first() const                           // of lane 0
        {
            return static_cast<std::uint32_t>(hn::GetLane(v));
        }
        HWY_INLINE void store(std::int32_t* p) const { hn::StoreU(v, I(), p); }
        HWY_INLINE void store(std::uint32_t* p) const { hn::StoreU(hn::BitCast(U(), v), U(), p); }
        // Wraps around, like unsigned arithmetic.
        friend HWY_ATTR HWY_INLINE whole operator+(whole a, whole b) { return hn::Add(a.v, b.v); }
        friend HWY_ATTR HWY_INLINE whole operator-(whole a, whole b) { return hn::Sub(a.v, b.v); }
        friend HWY_ATTR HWY_INLINE whole operator*(whole a, whole b) { return hn::Mul(a.v, b.v); }
        friend HWY_ATTR HWY_INLINE whole operator&(whole a, whole b) { return hn::And(a.v, b.v); }
        friend HWY_ATTR HWY_INLINE whole operator|(whole a, whole b) { return hn::Or(a.v, b.v); }
        friend HWY_ATTR HWY_INLINE whole operator^(whole a, whole b) { return hn::Xor(a.v, b.v); }
        friend HWY_ATTR HWY_INLINE whole operator>>(whole a, int bits)
        {
            return a.shift_right_by(bits);
        }
        friend HWY_ATTR HWY_INLINE whole operator<<(whole a, int bits)
        {
            return hn::ShiftLeftSame(a.v, bits);
        }
        friend HWY_ATTR HWY_INLINE whole operator<<(whole a, whole bits)
        {
            // Below 32. Of one lane Highway takes 64 bits for the count, half of them of no lane.
            if constexpr (kCount == 1) {
                const auto count = static_cast<std::uint32_t>(hn::GetLane(bits.v));
                return whole(static_cast<std::uint32_t>(hn::GetLane(a.v)) << count);
            } else {
                return hn::Shl(a.v, bits.v);
            }
        }
        friend HWY_ATTR HWY_INLINE mask operator<(whole a, whole b)
        {
            return {hn::RebindMask(F(), hn::Lt(a.v, b.v))};
        }
        friend HWY_ATTR HWY_INLINE mask operator==(whole a, whole b)
        {
            return {hn::RebindMask(F(), hn::Eq(a.v, b.v))};
        }
        // Zeros come in from above.
        template <int Bits>
        HWY_INLINE whole shift_right() const
        {
            return hn::BitCast(I(), hn::ShiftRight<Bits>(hn::BitCast(U(), v)));
        }
        // Rounds down.
        template <int Bits>
        HWY_INLINE whole signed_shift_right() const
        {
            return hn::ShiftRight<Bits>(v);
        }
        // All bits of lanes below zero.
        HWY_INLINE whole sign() const { return hn::BroadcastSignBit(v); }
        HWY_INLINE whole shift_right_by(int bits) const
        {
            return hn::BitCast(I(), hn::ShiftRightSame(hn::BitCast(U(), v), bits));
        }
        // Lane i's sign in bit i.
        HWY_INLINE std::uint32_t sign_bits() const
        {
            return mask{hn::RebindMask(F(), hn::MaskFromVec(hn::BroadcastSignBit(v)))}.bits();
        }
        HWY_INLINE whole population_count() const
        {
            return hn::BitCast(I(), hn::PopulationCount(hn::BitCast(U(), v)));
        }
    };

    // Stores the lanes of a mask one after the other; up to kCount values past them are touched.
    class Packing {
    public:
        HWY_INLINE explicit Packing(mask m) : chosen_(m)
        {
            if constexpr (kFromTable) {
                // Not Highway's: GCC 12 copies its table to the stack at every call.
                const hn::Rebind<std::uint8_t, U> bytes;
                const auto order = hn::LoadU(bytes, kPackOrder[m.bits()].data());
                order_ = hn::PromoteTo(U(), order);
            }
        }
        HWY_INLINE void store(whole a, std::uint32_t* p) const
        {
            const auto v = hn::BitCast(U(), a.v);
            if constexpr (kFromTable) {
                hn::StoreU(hn::TableLookupLanes(v, hn::IndicesFromVec(U(), order_)), U(), p);
            } else if constexpr (kCount == 1) {
                a.store(p);
            } else {
                // Not CompressStore, which takes longer where it writes those lanes alone.
                hn::StoreU(hn::Compress(v, hn::RebindMask(U(), chosen_.m)), U(), p);
            }
        }
        HWY_INLINE std::size_t count() const { return hn::CountTrue(F(), chosen_.m); }

    private:
        static constexpr bool kFromTable = kCount > 1 && kCount < 16;
        mask chosen_;
        hn::Vec<U> order_;
    };

    static HWY_INLINE whole iota() { return hn::Iota(I(), 0); }
    static HWY_INLINE real to_real(whole a) { return hn::ConvertTo(F(), a.v); }
    // Towards zero.
    static HWY_INLINE whole to_whole(real a) { return hn::ConvertTo(I(), a.v); }
    static HWY_INLINE real select(mask m, real a, real b) { return hn::IfThenElse(m.m, a.v, b.v); }
    static HWY_INLINE whole select(mask m, whole a, whole b)
    {
        return hn::IfThenElse(hn::RebindMask(I(), m.m), a.v, b.v);
    }
    static HWY_INLINE real zero_unless(mask m, real a) { return hn::IfThenElseZero(m.m, a.v); }
    static HWY_INLINE whole zero_unless(mask m, whole a)
    {
        return hn::IfThenElseZero(hn::RebindMask(I(), m.m), a.v);
    }
    // a > b ? a : b and a < b ? a : b. x86's own instructions are that to the bit; the others'
    // differ in the sign of zero and in what is no number.
    static HWY_INLINE real max(real a, real b)
    {
        if constexpr (kIsX86) return hn::Max(a.v, b.v);
        return select(a > b, a, b);
    }
    static HWY_INLINE real min(real a, real b)
    {
        if constexpr (kIsX86) return hn::Min(a.v, b.v);
        return select(a < b, a, b);
    }
    // Of two numbers of 16 bits in each lane, `low` and `high`, signed.
    static constexpr std::uint32_t halves(std::int32_t low, std::int32_t high)
    {
        return (static_cast<std::uint32_t>(low) & 0xffffu) | static_cast<std::uint32_t>(high) << 16;
    }
    static HWY_INLINE whole halves(whole low, whole high)
    {
        return (low & whole(0xffffu)) | (high << 16);
    }
    // The low ones' product and the high ones', added up.
    static HWY_INLINE whole dot_halves(whole a, whole b)
    {
        if constexpr (kIsX86) {
            // There it leaves all in place, in one instruction.
            const hn::Repartition<std::int16_t, I> pairs;
            hn::Vec<I> none = hn::Zero(I());
            return hn::ReorderWidenMulAccumulate(I(), hn::BitCast(pairs, a.v),
                                                 hn::BitCast(pairs, b.v), none, none);
        } else {
            const auto low = [](whole c)
                                 HWY_ATTR { return (c << 16).template signed_shift_right<16>(); };
            const auto high = [](whole c) HWY_ATTR { return c.template signed_shift_right<16>(); };
            return low(a) * low(b) + high(a) * high(b);
        }
    }
    static HWY_INLINE whole max(whole a, whole b) { return hn::Max(a.v, b.v); }
    static HWY_INLINE whole min(whole a, whole b) { return hn::Min(a.v, b.v); }
    static HWY_INLINE real floor(real a)
    {
        const real whole_part = to_real(to_whole(a));
        const real below = whole_part - zero_unless(whole_part > a, real(1.0f));
        // From 2^23 on floats are whole, and integers may not hold them.
        const real limit(8388608.0f);
        return select(a < limit && a > real(0.0f) - limit, below, a);
    }
    static HWY_INLINE whole bits_of(real a) { return whole::bits_of(a); }
    static HWY_INLINE real real_of_bits(whole a) { return a.as_real(); }
    // The largest power of 2 that is no larger; of a positive normal number.
    static HWY_INLINE real octave(real a)
    {
        return (whole::bits_of(a) & whole(0x7f800000u)).as_real();
    }
    static HWY_INLINE real sqrt(real a) { return hn::Sqrt(a.v); }
    static HWY_INLINE real gather(const float* base, whole index)
    {
        return hn::GatherIndex(F(), base, index.v);
    }
    static HWY_INLINE whole gather(const std::uint32_t* base, whole index)
    {
        return hn::BitCast(I(), hn::GatherIndex(U(), base, index.v));
    }
    // Lane i takes element index[i] of kCount elements.
    class Lookup {
    public:
        HWY_INLINE explicit Lookup(whole index)
            : index_(hn::IndicesFromVec(U(), hn::BitCast(U(), index.v)))
        {
        }
        HWY_INLINE real of(const float* elements) const
        {
            return hn::BitCast(F(), look_up(hn::BitCast(U(), hn::LoadU(F(), elements))));
        }
        HWY_INLINE whole of(const std::int32_t* elements) const
        {
            return hn::BitCast(I(), look_up(hn::BitCast(U(), hn::LoadU(I(), elements))));
        }

    private:
        HWY_INLINE hn::Vec<U> look_up(hn::Vec<U> elements) const
        {
            return hn::TableLookupLanes(elements, index_);
        }
        decltype(hn::IndicesFromVec(U(), hn::Vec<U>())) index_;
    };
    // Lane i takes element index[i] of 16 elements.
    static HWY_INLINE whole look_up_16(const std::uint32_t* elements, whole index)
    {
        if constexpr (kCount == 16) {
            return Lookup(index).of(reinterpret_cast<const std::int32_t*>(elements));
        } else {
            return gather(elements, index);
        }
    }
    static HWY_INLINE real look_up_16(const float* elements, whole index)
    {
        if constexpr (kCount == 16) {
            return Lookup(index).of(elements);
        } else {
            return gather(elements, index);
        }
    }
    // Lane i takes bit i of `bits`.
    static HWY_INLINE mask mask_of_bits(std::uint32_t bits)
    {
        const auto bit = hn::Shl(hn::Set(U(), 1u), hn::Iota(U(), 0));
        return {hn::RebindMask(F(), hn::TestBit(hn::Set(U(), bits), bit))};
    }
};

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_LANES_INL_H
