// shaders/sheer/exact.glsl for plain layers and for those of coloured glass, over lanes or alone.
#if defined(SHEER_EXACT_VERBS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_EXACT_VERBS_INL_H
#undef SHEER_EXACT_VERBS_INL_H
#else
#define SHEER_EXACT_VERBS_INL_H
#endif

#include "lanes/lanes-inl.h"
#include "lanes/text.h"
#include "methods/exact_layers.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <class L>
struct ExactText {
#include "lanes/text_words.h"
#include "sheer/over.glsl"
#include "sheer/exact.glsl"
};

// The text's verbs for plain layers and for coloured ones, which let each channel through by
// itself.
template <class Text, class Layer>
struct ExactVerbs {
    using real = typename Text::real;
    using real3 = typename Text::real3;
    using Sum = typename Text::ExactSum;
    static constexpr int kChannels = 4;
    // A layer at samples of which each may have another.
    struct Fragment {
        real3 color;
        real opacity;
    };

    static HWY_INLINE Sum clear() { return Text::exact_clear(); }
    static HWY_INLINE Sum add(const Sum& sum, typename Text::mask covered, const Layer& f)
    {
        return Text::exact_add(sum, covered, {real(f.red), real(f.green), real(f.blue)},
                               real(f.opacity));
    }
    // At samples that are not covered, light passes as if nothing were there.
    template <class L>
    static HWY_INLINE Fragment where(typename L::mask covered, const Layer& f)
    {
        return {{real(f.red), real(f.green), real(f.blue)},
                L::zero_unless(covered, real(f.opacity))};
    }
    static HWY_INLINE Sum add(const Sum& sum, const Fragment& f)
    {
        return Text::exact_add(sum, f.opacity > real(0.0f), f.color, f.opacity);
    }
    template <class Visit>
    static HWY_INLINE void for_each_number(Fragment& a, Fragment& b, Visit&& visit)
    {
        visit(a.color.x, b.color.x);
        visit(a.color.y, b.color.y);
        visit(a.color.z, b.color.z);
        visit(a.opacity, b.opacity);
    }
    static HWY_INLINE real3 resolve(const Sum& sum, real3 behind, real& transmittance)
    {
        transmittance = sum.transmittance;
        return Text::exact_resolve(sum, behind);
    }
    // Calls visit(channel, number) for all of a sum.
    template <class AnySum, class Visit>
    static HWY_INLINE void for_each_channel(AnySum& sum, Visit&& visit)
    {
        visit(0, sum.color.x);
        visit(1, sum.color.y);
        visit(2, sum.color.z);
        visit(3, sum.transmittance);
    }
};

template <class Text>
struct ExactVerbs<Text, ColoredLayer> {
    using real = typename Text::real;
    using real3 = typename Text::real3;
    using Sum = typename Text::ExactColoredSum;
    static constexpr int kChannels = 6;
    struct Fragment {
        real3 color;
        real opacity;
        real3 through;
    };

    static HWY_INLINE Sum clear() { return Text::exact_colored_clear(); }
    static HWY_INLINE Sum add(const Sum& sum, typename Text::mask covered, const ColoredLayer& f)
    {
        return Text::exact_colored_add(
            sum, covered, {real(f.red), real(f.green), real(f.blue)}, real(f.opacity),
            {real(f.through_red), real(f.through_green), real(f.through_blue)});
    }
    template <class L>
    static HWY_INLINE Fragment where(typename L::mask covered, const ColoredLayer& f)
    {
        const real one(1.0f);
        return {{real(f.red), real(f.green), real(f.blue)},
                L::zero_unless(covered, real(f.opacity)),
                {L::select(covered, real(f.through_red), one),
                 L::select(covered, real(f.through_green), one),
                 L::select(covered, real(f.through_blue), one)}};
    }
    static HWY_INLINE Sum add(const Sum& sum, const Fragment& f)
    {
        return Text::exact_colored_add(sum, f.opacity > real(0.0f), f.color, f.opacity, f.through);
    }
    template <class Visit>
    static HWY_INLINE void for_each_number(Fragment& a, Fragment& b, Visit&& visit)
    {
        visit(a.color.x, b.color.x);
        visit(a.color.y, b.color.y);
        visit(a.color.z, b.color.z);
        visit(a.opacity, b.opacity);
        visit(a.through.x, b.through.x);
        visit(a.through.y, b.through.y);
        visit(a.through.z, b.through.z);
    }
    static HWY_INLINE real3 resolve(const Sum& sum, real3 behind, real& transmittance)
    {
        transmittance = Text::exact_colored_transmittance(sum);
        return Text::exact_colored_resolve(sum, behind);
    }
    template <class AnySum, class Visit>
    static HWY_INLINE void for_each_channel(AnySum& sum, Visit&& visit)
    {
        visit(0, sum.color.x);
        visit(1, sum.color.y);
        visit(2, sum.color.z);
        visit(3, sum.transmittance.x);
        visit(4, sum.transmittance.y);
        visit(5, sum.transmittance.z);
    }
};

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_EXACT_VERBS_INL_H
