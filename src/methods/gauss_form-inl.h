// What a measure's moments become, once a sample, for shaders/sheer/secular.glsl: in doubles, and
// kept as floats.
#if defined(SHEER_GAUSS_FORM_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_GAUSS_FORM_INL_H
#undef SHEER_GAUSS_FORM_INL_H
#else
#define SHEER_GAUSS_FORM_INL_H
#endif

#include "methods/mboit_settings.h"
#include "methods/depth_function-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

// Over doubles.
template <class L>
struct GaussText {
#include "lanes/text_words.h"
#include "sheer/power_moments.glsl"
#include "sheer/gauss_rule.glsl"
#include "sheer/trigonometric_moments.glsl"
};

template <class L>
struct SecularText {
#include "lanes/text_words.h"
#include "sheer/exponential.glsl"
#include "sheer/moment.glsl"
#include "sheer/moment_formats.glsl"
#include "sheer/mboit_formats.glsl"
#include "sheer/secular.glsl"
#include "sheer/circle_fraction.glsl"
};

// Points, strengths and shares, Half each.
template <int Half, class W>
HWY_INLINE void save_rule(const typename GaussText<W>::GaussRule& rule, float* to,
                          std::size_t stride)
{
    for (std::size_t k = 0; k < Half; ++k) {
        rule.point[k].store(to + k * stride);
        rule.strength[k].store(to + (Half + k) * stride);
        rule.share[k].store(to + (2 * Half + k) * stride);
    }
}
template <int Half, class L>
HWY_INLINE typename SecularText<L>::SecularForm load_form(const KeptLanes<L>& kept)
{
    typename SecularText<L>::SecularForm form;
    for (std::size_t k = 0; k < Half; ++k) {
        form.point[k] = kept[k];
        form.strength[k] = kept[Half + k];
        form.share[k] = kept[2 * Half + k];
    }
    return form;
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_GAUSS_FORM_INL_H
