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

// The product of what all fragments let through, one float a sample.
template <int S>
class TotalAlpha {
    using L = Lanes<S>;
    using real = typename L::real;
    using Text = TotalAlphaText<L>;

public:
    TotalAlpha() = default;
    explicit TotalAlpha(int samples) : kept_(samples) {}

    void clear() { std::fill_n(kept_.values.data(), kept_.values.size(), 1.0f); }

    void insert(const FragmentStream& f)
    {
        const std::size_t samples = count();
        for (std::size_t i = 0; i < static_cast<std::size_t>(f.size); ++i) {
            const real opacity(f.opacity[i]);
            float* at = kept_.channel(f.pixel[i], 0);
            for (std::size_t s = 0; s < samples; s += L::kCount) {
                const auto covered = sample_mask<L>(f, i, s);
                Text::total_alpha_insert(real::load(at + s), covered, opacity).store(at + s);
            }
        }
    }

    void merge(const TotalAlpha& other)
    {
        for (std::size_t i = 0; i < static_cast<std::size_t>(kept_.values.size()); ++i) {
            kept_.values[i] *= other.kept_.values[i];
        }
    }

    template <class Color>
    HWY_INLINE void dim(SampleColors& backdrop, std::size_t pixel, std::size_t s, const Color& sum,
                        real weight) const
    {
        dim_backdrop<Text>(backdrop, pixel, s, real::load(kept_.channel(pixel, 0) + s),
                           {sum.x, sum.y, sum.z}, weight);
    }

private:
    HWY_INLINE std::size_t count() const
    {
        return S < 16 ? static_cast<std::size_t>(S) : static_cast<std::size_t>(kept_.samples);
    }

    SampleValues<1> kept_;
};

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_TOTAL_ALPHA_INL_H
