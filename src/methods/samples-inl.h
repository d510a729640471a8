// What stores with lanes over a pixel's samples share.
#if defined(SHEER_SAMPLES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_SAMPLES_INL_H
#undef SHEER_SAMPLES_INL_H
#else
#define SHEER_SAMPLES_INL_H
#endif

#include "lanes/lanes-inl.h"
#include "methods/method.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

// Samples s, s + 1, ... that fragment i covers.
template <class L>
HWY_INLINE typename L::mask sample_mask(const FragmentStream& f, std::size_t i, std::size_t s)
{
    const std::uint32_t word = s < 32 ? f.samples[i] : f.samples_high[i];
    return L::mask_of_bits(word >> (s & 31));
}

// A backdrop's alpha A behind transmittance T becomes 1 - T (1 - A).
template <class L>
HWY_INLINE void over_alpha(typename L::real transmittance, float* alpha)
{
    using real = typename L::real;
    // Written so that T = 1 leaves A as it is, bit for bit.
    const real behind = real::load(alpha);
    (behind + (real(1.0f) - transmittance) * (real(1.0f) - behind)).store(alpha);
}

// The verbs of Store<S> with S = min(samples, 16) lanes; more samples are a loop in the store.
template <template <int> class Store>
StoreVerbs verbs_for_samples(int samples)
{
    switch (samples) {
        case 1: return verbs_of<Store<1>>();
        case 2: return verbs_of<Store<2>>();
        case 4: return verbs_of<Store<4>>();
        case 8: return verbs_of<Store<8>>();
        default: return verbs_of<Store<16>>();
    }
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_SAMPLES_INL_H
