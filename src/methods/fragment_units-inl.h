// What fragments add to the sums of a function of depth, on the grid of exact sums. Lanes are
// fragments. depth_function-inl.h says what Function is.
#if defined(SHEER_FRAGMENT_UNITS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_FRAGMENT_UNITS_INL_H
#undef SHEER_FRAGMENT_UNITS_INL_H
#else
#define SHEER_FRAGMENT_UNITS_INL_H
#endif

#include "methods/depth_function.h"
#include "methods/exact_sums-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <class Function>
concept SparseFunction = requires
{
    Function::kTouched;
};

// How many numbers a fragment adds.
template <class Function>
constexpr std::size_t touched_sums()
{
    if constexpr (SparseFunction<Function>)
        return Function::kTouched;
    else
        return Function::kSums;
}

template <class Function, std::size_t Most>
class FragmentUnits {
    static constexpr bool kSparse = SparseFunction<Function>;
    static constexpr std::size_t kCount = touched_sums<Function>();
    // Numbers that are added together four at a time; the others are single.
    static constexpr std::size_t kInFours = kSparse ? 0 : kCount / 4 * 4;

public:
    // Number k of fragment i is [k * Most + i], unless they are in turns.
    const std::int64_t* units() const { return units_; }
    // Where it belongs; null: to sum k.
    const std::uint32_t* sums() const { return kSparse ? sums_[0] : nullptr; }

    // Those of fragment i, which are in turns.
    HWY_INLINE void add_to(std::int64_t* sums, std::size_t i) const
    {
        for (std::size_t k = 0; k < kInFours; k += 4) add_four(units_ + k * Most + 4 * i, sums + k);
        for (std::size_t k = kInFours; k < kCount; ++k) {
            std::int64_t& at = sums[kSparse ? sums_[k][i] : k];
            at = add_wrapping(at, units_[k * Most + i]);
        }
    }

    // Of `some` fragments; what is beyond them, up to a vector, may be any number. In turns: of
    // four numbers those of the first fragment follow one another, then those of the next.
    // Inline: GCC 12 takes calls of it for calls without effect where sums are sparse.
    HWY_INLINE void set(const Function& function, const float* places, const float* depths,
                        std::size_t some, bool in_turns = true)
    {
        const ExactGrid grid(-kDepthBits);
        if constexpr (kSparse) {
            using One = WideLanes<1>;
            for (std::size_t i = 0; i < some; ++i) {
                double addends[kCount];
                std::uint32_t at[kCount];
                function.addends_of_one(places[i], depths[i], addends, at);
                for (std::size_t k = 0; k < kCount; ++k) {
                    exact_units<One>(One::real(addends[k]), grid).store(units_ + k * Most + i);
                    sums_[k][i] = at[k];
                }
            }
        } else {
            using Wide = WideLanes<8>;
            for (std::size_t i = 0; i < some; i += Wide::kCount) {
                typename Wide::real addends[kCount];
                function.template addends<Wide>(Wide::real::load(places + i),
                                                Wide::real::load(depths + i), addends);
                typename Wide::whole units[kCount];
                for (std::size_t k = 0; k < kCount; ++k) {
                    units[k] = exact_units<Wide>(addends[k], grid);
                }
                store(units, i, in_turns);
            }
        }
    }

private:
    template <class Whole>
    HWY_INLINE void store(const Whole (&units)[kCount], std::size_t i, bool in_turns)
    {
        const std::size_t alone = in_turns ? kInFours : 0;
        for (std::size_t k = 0; k < alone; k += 4) {
            Whole::store_in_turns({units[k], units[k + 1], units[k + 2], units[k + 3]},
                                  units_ + k * Most + 4 * i);
        }
        for (std::size_t k = alone; k < kCount; ++k) units[k].store(units_ + k * Most + i);
    }

    alignas(64) std::int64_t units_[kCount * Most];
    std::uint32_t sums_[kSparse ? kCount : 1][Most];
};

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_FRAGMENT_UNITS_INL_H
