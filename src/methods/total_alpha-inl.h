// The total alpha of every sample of a tile, and what it is for:
// shaders/sheer/alpha_correction.glsl.
#if defined(SHEER_TOTAL_ALPHA_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_TOTAL_ALPHA_INL_H
#undef SHEER_TOTAL_ALPHA_INL_H
#else
#define SHEER_TOTAL_ALPHA_INL_H
#endif

#include "methods/samples-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <class L>
struct TotalAlphaText {
#include "lanes/text_words.h"
#include "sheer/over.glsl"
#include "sheer/alpha_correction.glsl"
};

// Makes of a backdrop's sample what is left of it behind transmittance T, and gives the pixel's
// fraction its part: a sum of colours, its weight, 1 - T.
template <class Text>
HWY_INLINE void dim_backdrop(SampleColors& backdrop, std::size_t pixel, std::size_t s,
                             typename Text::real transmittance, typename Text::real3 sum,
                             typename Text::real weight)
{
    using real = typename Text::real;
    const auto samples = static_cast<std::size_t>(backdrop.samples);
    resolve_samples<Text>(backdrop, pixel, s,
                          [&](typename Text::real3 behind, real& through) HWY_ATTR {
                              through = transmittance;
                              return transmittance * behind;
                          });
    float* at = backdrop.fraction.channel(pixel, 0) + s;
    save_color<Text>(sum, at, samples);
    weight.store(at + 3 * samples);
    (real(1.0f) - transmittance).store(at + 4 * samples);
}

template <int S>
struct TotalAlphaMethod {
    using L = Lanes<S>;
    using Text = TotalAlphaText<L>;
    using Store = typename L::real;  // transmittance
    static constexpr int kChannels = 1;

    static HWY_INLINE Store clear() { return Store(1.0f); }
    static HWY_INLINE Store merge(Store a, Store b) { return a * b; }
    static HWY_INLINE Store load(const float* at, std::size_t) { return Store::load(at); }
    static HWY_INLINE void save(Store s, float* at, std::size_t) { s.store(at); }
};

// The product of what all fragments let through.
template <int S>
struct TotalAlpha : SampleStore<S, TotalAlphaMethod<S>> {
    using Base = SampleStore<S, TotalAlphaMethod<S>>;
    using Base::Base;
    using typename Base::real;
    using typename Base::Text;

    HWY_INLINE void insert(const FragmentStream& f)
    {
        this->update(f,
                     [](const StreamColumns& c, std::size_t i, real store, auto covered) HWY_ATTR {
                         return Text::total_alpha_insert(store, covered, real(c.opacity[i]));
                     });
    }

    template <class Color>
    HWY_INLINE void dim(SampleColors& backdrop, std::size_t pixel, std::size_t s, const Color& sum,
                        real weight) const
    {
        dim_backdrop<Text>(backdrop, pixel, s, this->load(pixel, s), {sum.x, sum.y, sum.z}, weight);
    }
};

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_TOTAL_ALPHA_INL_H
