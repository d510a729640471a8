// Wavelet transparency: shaders/sheer/wavelet.glsl at every sample.
#include "methods/method.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "methods/wavelet.cpp"
#include "lanes/targets.h"

#include <hwy/foreach_target.h>

#include "lanes/lone.h"
#include "methods/transmittance_stores-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <class L>
struct WaveletText {
#include "lanes/text_words.h"
#include "sheer/exponential.glsl"
#include "sheer/wavelet.glsl"
};

// The sums are the optical depth and the coefficients; what is kept are the cells' means.
template <int Rank>
class WaveletFunction {
public:
    static constexpr std::size_t kCells = 2 << Rank;
    static constexpr std::size_t kSums = kCells + 1, kTouched = Rank + 3, kKept = kCells;

    explicit WaveletFunction(const ChosenMethod&) {}

    static void addends_of_one(float place, float depth, double (&addends)[kTouched],
                               std::uint32_t (&sums)[kTouched])
    {
        using Text = WaveletText<Lone<float>>;
        const auto through = static_cast<double>(depth);
        const float d = Text::wavelet_place(place, kCells);
        const std::uint32_t cell = Text::wavelet_cell(d, kCells);
        addends[0] = through;
        sums[0] = 0;
        addends[1] = through * (1 - static_cast<double>(d));
        sums[1] = kCells;
        for (int up = 1; up <= Rank + 1; ++up) {
            const int power = Rank + 1 - up;
            const auto at = static_cast<std::size_t>(up + 1);
            addends[at] = through * WaveletText<Lone<double>>::wavelet_addend(
                                        static_cast<double>(d), cell, up,
                                        static_cast<double>(1 << power), kRoots[power]);
            sums[at] = (1u << power) + (cell >> up);  // in the tree, and after the first sum
        }
    }

    template <class W>
    static HWY_INLINE void prepare(const typename W::real (&sums)[kSums], float* to,
                                   std::size_t stride)
    {
        using Real = typename W::real;
        for (std::size_t cell = 0; cell < kCells; ++cell) {
            Real mean = sums[kCells];
            for (int up = 1; up <= Rank + 1; ++up) {
                const int power = Rank + 1 - up;
                const Real step = Real(kRoots[power]) * sums[(1u << power) + (cell >> up)];
                mean = (cell >> (up - 1) & 1) == 0 ? mean - step : mean + step;
            }
            mean.store(to + cell * stride);
        }
    }

    template <class L>
    static HWY_INLINE typename L::real transmittance(const KeptLanes<L>& kept,
                                                     typename L::real place)
    {
        using Text = WaveletText<L>;
        using Real = typename L::real;
        using Whole = typename L::whole;
        const Real cells(static_cast<float>(kCells));
        const Real d = Text::wavelet_place(place, cells);
        const Whole cell = Text::wavelet_cell(d, cells);
        const auto first = cell == Whole(0u);
        const Whole last = cell - L::select(first, Whole(0u), Whole(1u));
        const Real before = L::select(first, Real(0.0f), kept.at(last));
        // At the far end there is no cell more, and all has been before.
        const Real here = kept.at(cell);
        return Text::wavelet_transmittance(d, cell, cells,
                                           L::select(place >= Real(1.0f), here, before), here);
    }

private:
    // Of 2^p.
    static constexpr double kRoots[5] = {1, 0x1.6a09e667f3bcdp+0, 2, 0x1.6a09e667f3bcdp+1, 4};
};

StoreVerbs wavelet_store(int rank)
{
    switch (rank) {
        case 2: return verbs_of<StoreOf<WaveletFunction<2>>>();
        case 3: return verbs_of<StoreOf<WaveletFunction<3>>>();
        default: return verbs_of<StoreOf<WaveletFunction<4>>>();
    }
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sheer {

HWY_EXPORT(wavelet_store);

StoreVerbs wavelet_verbs(TargetSet targets, const ChosenMethod& method, int)
{
    return SHEER_DISPATCH(wavelet_store, targets)(method.number("rank"));
}

}  // namespace sheer
#endif
