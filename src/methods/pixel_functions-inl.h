// The function of a method that approximates transmittance (shaders/sheer/transmittance.glsl), of
// each pixel of a tile; transmittance_samples-inl.h says what Function is. Lanes are fragments, and
// pixels where sums become what is kept.
//
// Nothing here depends on the number of samples, so that it is compiled once for all of them. A
// pixel takes 8 bytes for each sum (4 at least) and 4 for each float kept.
#if defined(SHEER_PIXEL_FUNCTIONS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_PIXEL_FUNCTIONS_INL_H
#undef SHEER_PIXEL_FUNCTIONS_INL_H
#else
#define SHEER_PIXEL_FUNCTIONS_INL_H
#endif

#include "methods/translucent-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <class Function>
concept SparseFunction = requires
{
    Function::kTouched;
};

// Has a second pass over the sums.
template <class Function, class W>
concept PreparesAgain = requires(const Function& function,
                                 typename W::real (&sums)[Function::kSums], float* state)
{
    function.template prepare_again<W>(sums, state, 1);
};

inline constexpr std::size_t kChunk = 64;  // fragments at a time, in the nearest cache

// How many numbers a fragment adds.
template <class Function>
constexpr std::size_t touched_sums()
{
    if constexpr (SparseFunction<Function>)
        return Function::kTouched;
    else
        return Function::kSums;
}

// Those of some fragments, on their grid.
template <class Function, std::size_t Most>
struct FragmentUnits {
    static constexpr bool kSparse = SparseFunction<Function>;
    static constexpr std::size_t kCount = touched_sums<Function>();
    // Numbers that are added together four at a time, and those that are left.
    static constexpr std::size_t kFours = kSparse ? 0 : kCount / 4, kSingles = kCount - 4 * kFours;

    HWY_INLINE std::size_t sum(std::size_t k, std::size_t i) const
    {
        if constexpr (kSparse)
            return sums_[k][i];
        else
            return k;
    }
    HWY_INLINE std::int64_t unit(std::size_t k, std::size_t i) const
    {
        if (k < 4 * kFours) return fours_[k / 4][4 * i + k % 4];
        return singles_[k - 4 * kFours][i];
    }
    // Those of fragment i.
    HWY_INLINE void add_to(std::int64_t* sums, std::size_t i) const
    {
        for (std::size_t k = 0; k < kFours; ++k) add_four(&fours_[k][4 * i], sums + 4 * k);
        for (std::size_t k = 4 * kFours; k < kCount; ++k) {
            std::int64_t& at = sums[sum(k, i)];
            at = add_wrapping(at, unit(k, i));
        }
    }

    // Of `some` fragments; what is beyond them, up to a vector, may be any number.
    // Inline: GCC 12 takes calls of it for calls without effect where sums are sparse.
    HWY_INLINE void set(const Function& function, const float* places, const float* depths,
                        std::size_t some)
    {
        const ExactGrid grid(-kDepthBits);
        if constexpr (SparseFunction<Function>) {
            using One = WideLanes<1>;
            for (std::size_t i = 0; i < some; ++i) {
                double addends[kCount];
                std::uint32_t at[kCount];
                function.addends_of_one(places[i], depths[i], addends, at);
                for (std::size_t k = 0; k < kCount; ++k) {
                    exact_units<One>(One::real(addends[k]), grid).store(&singles_[k][i]);
                    sums_[k][i] = at[k];
                }
            }
        } else {
            using Wide = WideLanes<8>;
            for (std::size_t i = 0; i < some; i += Wide::kCount) {
                typename Wide::real addends[kCount];
                function.template addends<Wide>(Wide::real::load(places + i),
                                                Wide::real::load(depths + i), addends);
                for (std::size_t k = 0; k < kFours; ++k) {
                    typename Wide::whole four[4];
                    for (std::size_t j = 0; j < 4; ++j) {
                        four[j] = exact_units<Wide>(addends[4 * k + j], grid);
                    }
                    Wide::whole::store_in_turns(four, &fours_[k][4 * i]);
                }
                for (std::size_t k = 0; k < kSingles; ++k) {
                    exact_units<Wide>(addends[4 * kFours + k], grid).store(&singles_[k][i]);
                }
            }
        }
    }

private:
    static constexpr std::size_t at_least_one(std::size_t n) { return n > 0 ? n : 1; }

    alignas(64) std::int64_t fours_[at_least_one(kFours)][4 * Most];
    alignas(64) std::int64_t singles_[at_least_one(kSingles)][Most];
    std::uint32_t sums_[kSparse ? kCount : 1][Most];
};

// Fragments first, first + 1, ... of a stream, `some` of them, at most kChunk; there may be more up
// to a vector, of which nothing is taken.
struct FragmentChunk {
    const FragmentStream& stream;
    std::size_t first, some;
    const float* places;  // of the chunk's fragments
    const float* parts;   // of its pixel that each takes; null: all of it

    const float* opacity() const { return stream.opacity.data() + first; }
    const std::uint32_t* pixel() const { return stream.pixel.data() + first; }
};

template <class Function>
class PixelFunctions {
    using Block = Lanes<16>;  // of fragments
    using Wide = WideLanes<8>;
    using Real = Block::real;
    using Text = TransmittanceText<Block>;
    static constexpr std::size_t kOfFunction = Function::kSums, kState = Function::kState;

public:
    static constexpr std::size_t kSums = kOfFunction > 4 ? kOfFunction : 4;

    explicit PixelFunctions(const ChosenMethod& method)
        : function_(method), sums_(kTilePixels * kSums), state_(kTilePixels * kState)
    {
    }

    int passes() const { return function_.passes(); }
    void clear() { std::fill_n(sums_.data(), sums_.size(), std::int64_t{0}); }
    void merge(const PixelFunctions& other) { add_all(other.sums_, sums_); }
    const std::int64_t* sums(std::size_t pixel) const { return sums_.data() + pixel * kSums; }

    // Optical depths of the opacities or, the second time, of what is seen of them.
    HWY_NOINLINE void find_depths(const FragmentChunk& c, bool is_first, float* depths) const
    {
        for (std::size_t i = 0; i < c.some; i += Block::kCount) {
            Real seen = Real::load(c.opacity() + i);
            if constexpr (PreparesAgain<Function, Wide>) {
                if (!is_first) seen = seen * transmittances(c, i);
            }
            Text::optical_depth(seen).store(depths + i);
        }
    }

    // `depths` become those of the parts.
    HWY_NOINLINE void add_depths(const FragmentChunk& c, float* depths)
    {
        for (std::size_t i = 0; c.parts != nullptr && i < c.some; i += Block::kCount) {
            (Real::load(depths + i) * Real::load(c.parts + i)).store(depths + i);
        }
        FragmentUnits<Function, kChunk> units;
        units.set(function_, c.places, depths, c.some);
        for (std::size_t i = 0; i < c.some; ++i) {
            units.add_to(sums_.data() + c.pixel()[i] * kSums, i);
        }
    }

    // Red, green, blue and weight.
    HWY_NOINLINE void add_colors(const FragmentChunk& c, const ExactGrid& colors)
    {
        const ExactGrid weights(-kColorBits);
        const FragmentStream& f = c.stream;
        alignas(64) float values[4][Block::kCount];
        alignas(64) std::int64_t units[4 * kChunk];
        for (std::size_t i = 0; i < c.some; i += Block::kCount) {
            Real weight = Text::visible_alpha(transmittances(c, i), Real::load(c.opacity() + i));
            if (c.parts != nullptr) weight = weight * Real::load(c.parts + i);
            (weight * Real::load(f.red.data() + c.first + i)).store(values[0]);
            (weight * Real::load(f.green.data() + c.first + i)).store(values[1]);
            (weight * Real::load(f.blue.data() + c.first + i)).store(values[2]);
            weight.store(values[3]);
            for (std::size_t j = 0; j < Block::kCount; j += Wide::kCount) {
                typename Wide::whole four[4];
                for (std::size_t k = 0; k < 4; ++k) {
                    four[k] = exact_units<Wide>(Wide::real::load(values[k] + j),
                                                k < 3 ? colors : weights);
                }
                Wide::whole::store_in_turns(four, units + 4 * (i + j));
            }
        }
        for (std::size_t i = 0; i < c.some; ++i) {
            add_four(units + 4 * i, sums_.data() + c.pixel()[i] * kSums);
        }
    }

    // Makes of the sums what is kept, in pixels that `touched` names, and of the sums 0. The first
    // ones are copied to `depths`, where that is not null.
    HWY_NOINLINE void prepare(const char* touched, bool is_first, std::int64_t* depths)
    {
        const ExactGrid grid(-kDepthBits);
        for (std::size_t pixel = 0; pixel < kTilePixels; pixel += Wide::kCount) {
            if (!any_of(touched + pixel)) continue;
            alignas(64) std::int64_t units[kOfFunction][Wide::kCount];
            for (std::size_t i = 0; i < Wide::kCount; ++i) {
                std::int64_t* at = sums_.data() + (pixel + i) * kSums;
                for (std::size_t k = 0; k < kOfFunction; ++k) units[k][i] = at[k];
                if (depths != nullptr) depths[pixel + i] = at[0];
                std::fill_n(at, kSums, std::int64_t{0});
            }
            typename Wide::real sums[kOfFunction];
            for (std::size_t k = 0; k < kOfFunction; ++k) sums[k] = exact_sum<Wide>(units[k], grid);
            keep(pixel, sums, is_first);
        }
    }

    float transmittance_at(std::size_t pixel, float place) const
    {
        const State state{state_.data(), Block::whole(static_cast<std::uint32_t>(pixel))};
        return function_.template transmittance<Block>(state, Real(place)).greatest();
    }

protected:
    static bool any_of(const char* touched)
    {
        return std::any_of(touched, touched + Wide::kCount, [](char t) { return t != 0; });
    }

    // Of pixels `pixel`, `pixel` + 1, ...
    HWY_INLINE void keep(std::size_t pixel, const typename Wide::real (&sums)[kOfFunction],
                         bool is_first)
    {
        float* state = state_.data() + pixel;
        if constexpr (PreparesAgain<Function, Wide>) {
            if (!is_first) return function_.template prepare_again<Wide>(sums, state, kTilePixels);
        }
        function_.template prepare<Wide>(sums, state, kTilePixels);
    }

    // The optical depth that is seen of a fragment there, one in each of these pixels.
    HWY_INLINE typename Wide::real seen_depth(std::size_t pixel, typename Wide::real place,
                                              typename Wide::real depth) const
    {
        using L = Lanes<Wide::kCount>;
        using Alike = TransmittanceText<L>;
        const KeptState<L> state{state_.data() + pixel};
        const auto all =
            typename L::real(1.0f) - Alike::exp_of(typename L::real(0.0f) - narrowed<Wide>(depth));
        const auto opacity = L::min(all, typename L::real(1 - 0x1p-24f));
        const auto through = function_.template transmittance<L>(state, narrowed<Wide>(place));
        return widened<Wide>(Alike::optical_depth(opacity * through));
    }

    Function function_;

private:
    // Of pixels that follow one another.
    template <class L>
    struct KeptState {
        const float* from;

        HWY_INLINE typename L::real operator[](std::size_t k) const
        {
            return L::real::load(from + k * kTilePixels);
        }
    };
    // What is kept for pixels, one a lane.
    struct State {
        const float* from;
        Block::whole pixels;

        HWY_INLINE Real operator[](std::size_t k) const
        {
            return Block::gather(from + k * kTilePixels, pixels);
        }
        HWY_INLINE Real at(Block::whole k) const { return Block::gather(from, (k << 10) + pixels); }
    };
    static_assert(kTilePixels == 1 << 10);

    // Of the chunk's fragments i, i + 1, ...
    HWY_INLINE Real transmittances(const FragmentChunk& c, std::size_t i) const
    {
        // What lies past the stream's end may be any number.
        const auto pixels = Block::whole::load(c.pixel() + i) &
                            Block::whole(static_cast<std::uint32_t>(kTilePixels - 1));
        return function_.template transmittance<Block>(State{state_.data(), pixels},
                                                       Real::load(c.places + i));
    }

    AlignedArray<std::int64_t> sums_;
    AlignedArray<float> state_;
};

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_PIXEL_FUNCTIONS_INL_H
