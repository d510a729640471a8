// The texts of shaders/sheer/ on fragment lists, one plain number at a time: what the shaders of
// tests/vulkan/ do, in C++, and without a renderer's stores.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "methods/alpha_tests_alone.h"
#include "methods/fragment_lists.h"
#include "methods/layered_alone.h"
#include "methods/method_alone.h"
#include "methods/methods_with_texts.h"
#include "methods/peeling_alone.h"
#include "methods/slab_alone.h"
#include "methods/stochastic_alone.h"
#include "methods/stratified_alone.h"
#include "methods/sums_alone.h"
#include "methods/transmittance_alone.h"
#include "lanes/lone.h"

namespace sheer::test {

template <class L>
struct Texts {
#include "lanes/text_words.h"
#include "sheer/over.glsl"
#include "sheer/bits.glsl"
#include "sheer/random.glsl"
#include "sheer/blend.glsl"
#include "sheer/exact.glsl"
#include "sheer/weighted_average.glsl"
#include "sheer/wboit.glsl"
#include "sheer/stochastic_masks.glsl"
#include "sheer/stochastic.glsl"
#include "sheer/alpha_correction.glsl"
#include "sheer/stochastic_depth.glsl"
#include "sheer/stratified_stochastic.glsl"
#include "sheer/layers.glsl"
#include "sheer/mlab.glsl"
#include "sheer/z3.glsl"
#include "sheer/k_buffer.glsl"
#include "sheer/hybrid.glsl"
#include "sheer/adaptive.glsl"
#include "sheer/depth_peeling.glsl"
#include "sheer/dual_depth_peeling.glsl"
#include "sheer/bucket_peeling.glsl"
#include "sheer/phenomenological.glsl"
#include "sheer/deep_shadow_map.glsl"
#include "sheer/slab_bits.glsl"
#include "sheer/slab.glsl"
#include "sheer/mlcb.glsl"
#include "sheer/alpha_test.glsl"
#include "sheer/alpha_test_then_blend.glsl"
#include "sheer/hashed_threshold.glsl"
#include "sheer/fade_in.glsl"
#include "sheer/alpha_to_coverage.glsl"
#include "sheer/screen_door.glsl"
};

// Of each sample: the colour over the backdrop, in the layout of SampleColors, and the store, in
// that of SampleValues<5>.
template <class Real>
struct Made {
    std::vector<Real> colors, kept;
};

template <class L>
struct BlendAlone : MethodAlone<L> {
    using T = Texts<L>;
    using Store = typename T::BlendStore;
    static Store clear() { return T::blend_clear(); }
    Store insert(Store s, std::size_t i, std::size_t at) const
    {
        return T::blend_insert(s, this->lists.covers(i, at), this->color(i), this->opacity(i));
    }
    static auto resolve(Store s, typename T::real3 behind) { return T::blend_resolve(s, behind); }
    static auto transmittance(Store s) { return s.transmittance; }
    static auto keep(Store s) { return BlendAlone::kept(s.color, s.transmittance); }
};

template <class L>
struct ExactAlone : MethodAlone<L> {
    using T = Texts<L>;
    using Store = typename T::ExactSum;
    static constexpr bool kSorted = true;
    static Store clear() { return T::exact_clear(); }
    Store insert(Store s, std::size_t i, std::size_t at) const
    {
        return T::exact_add(s, this->lists.covers(i, at), this->color(i), this->opacity(i));
    }
    static auto resolve(Store s, typename T::real3 behind) { return T::exact_resolve(s, behind); }
    static auto transmittance(Store s) { return s.transmittance; }
    static auto keep(Store s) { return ExactAlone::kept(s.color, s.transmittance); }
};

template <class L>
struct WeightedAverageAlone : MethodAlone<L> {
    using T = Texts<L>;
    using Store = typename T::WeightedAverageStore;
    static Store clear() { return T::weighted_average_clear(); }
    Store insert(Store s, std::size_t i, std::size_t at) const
    {
        return T::weighted_average_insert(s, this->lists.covers(i, at), this->color(i),
                                          this->opacity(i));
    }
    static auto resolve(Store s, typename T::real3 behind)
    {
        return T::weighted_average_resolve(s, behind);
    }
    static auto transmittance(Store s) { return T::weighted_average_transmittance(s); }
    static auto keep(Store s) { return WeightedAverageAlone::kept(s.color, s.opacity, s.count); }
};

// 0 for "uniform", the number of "eqN".
inline int wboit_equation(const ChosenMethod& method)
{
    const std::string& weight = method.value("weight");
    if (weight == "range") return 10;
    return weight == "uniform" ? 0 : std::stoi(weight.substr(2));
}

template <class L>
struct WboitAlone : MethodAlone<L> {
    using T = Texts<L>;
    using Store = typename T::WboitStore;
    const int equation = wboit_equation(this->method);
    const bool scaled = this->method.value("weight") == "range";

    static Store clear() { return T::wboit_clear(); }
    Store insert(Store s, std::size_t i, std::size_t at) const
    {
        const ListedFragment& f = this->lists.fragments[i];
        const float z = this->lists.distance_of(i);
        const float d =
            scaled ? 0.5f * place_in(this->lists, f) + 0.5f : in_buffer(this->lists.eye, z);
        const auto weight =
            T::wboit_weight(equation, typename L::real(z), typename L::real(d), this->opacity(i));
        return T::wboit_insert(s, this->lists.covers(i, at), this->color(i), this->opacity(i),
                               weight);
    }
    static auto resolve(Store s, typename T::real3 behind) { return T::wboit_resolve(s, behind); }
    static auto transmittance(Store s) { return s.transmittance; }
    static auto keep(Store s) { return WboitAlone::kept(s.color, s.weight, s.transmittance); }
};

template <class L, template <class> class Method>
Made<typename L::real> make_alone(const FragmentLists& lists, const ChosenMethod& method)
{
    using real = typename L::real;
    const std::size_t samples = lists.samples();
    const SampleColors backdrop = make_backdrop(lists.set.count);
    Made<real> made{std::vector<real>(4 * kTilePixels * samples),
                    std::vector<real>(5 * kTilePixels * samples)};
    Method<L> text{{lists, method}};
    for (std::uint32_t pixel = 0; pixel < kTilePixels; ++pixel) {
        text.begin_pixel(pixel);
        for (std::size_t s = 0; s < samples; ++s) {
            auto store = text.clear();
            for (text.pass = 0; text.pass < Method<L>::kPasses; ++text.pass) {
                for (std::uint32_t i = lists.first[pixel]; i < lists.first[pixel + 1]; ++i) {
                    const std::size_t sorted = s * lists.fragments.size() + i;
                    store = text.insert(std::move(store),
                                        Method<L>::kSorted ? lists.sorted[sorted] : i, s);
                }
                if constexpr (requires { text.done(store); }) {
                    if (text.done(store)) break;
                }
            }
            const auto behind = [&](std::size_t c) { return real(backdrop.channel(pixel, c)[s]); };
            const auto color = Method<L>::resolve(store, {behind(0), behind(1), behind(2)});
            const real alpha = Texts<L>::over_alpha(Method<L>::transmittance(store), behind(3));
            const real over[4] = {color.x, color.y, color.z, alpha};
            const auto kept = Method<L>::keep(store);
            for (std::size_t c = 0; c < 4; ++c) {
                made.colors[(4 * pixel + c) * samples + s] = over[c];
            }
            for (std::size_t c = 0; c < 5; ++c) {
                made.kept[(5 * pixel + c) * samples + s] = kept[c];
            }
        }
    }
    return made;
}

template <class L>
Made<typename L::real> make_alone(const FragmentLists& lists, const std::string& method_text)
{
    const ChosenMethod method = choose_method(method_text);
    const std::string id = method.row->id;
    if (id == "blend") return make_alone<L, BlendAlone>(lists, method);
    if (id == "exact") return make_alone<L, ExactAlone>(lists, method);
    if (id == "weighted-average") return make_alone<L, WeightedAverageAlone>(lists, method);
    if (id == "wboit") return make_alone<L, WboitAlone>(lists, method);
    if (id == "stochastic" && method.value("depth-based") == "on") {
        return make_alone<L, StochasticDepthAlone>(lists, method);
    }
    if (id == "stochastic") return make_alone<L, StochasticAlone>(lists, method);
    if (id == "stratified-stochastic") return make_alone<L, StratifiedAlone>(lists, method);
    if (id == "mlab") return make_alone<L, MlabAlone>(lists, method);
    if (id == "z3") return make_alone<L, Z3Alone>(lists, method);
    if (id == "k-buffer") return make_alone<L, KBufferAlone>(lists, method);
    if (id == "hybrid") return make_alone<L, HybridAlone>(lists, method);
    if (id == "adaptive") return make_alone<L, AdaptiveAlone>(lists, method);
    if (id == "depth-peeling") return make_alone<L, DepthPeelingAlone>(lists, method);
    if (id == "slab" || id == "mlcb") return make_alone<L, SlabAlone>(lists, method);
    if (id == "dual-depth-peeling") return make_alone<L, DualPeelingAlone>(lists, method);
    if (id == "bucket-peeling") return make_alone<L, BucketPeelingAlone>(lists, method);
    if (id == "phenomenological") return make_alone<L, PhenomenologicalAlone>(lists, method);
    if (id == "deep-shadow-map") return make_alone<L, DeepShadowAlone>(lists, method);
    if constexpr (std::is_same_v<L, Lone<float>>) {
        if (transmittance_function(method) != nullptr) {
            return make_alone<L, TransmittanceAlone>(lists, method);
        }
    }
    // Not with bounds: which fragments pass may be others.
    if constexpr (requires(typename L::real a) { L::octave(a); }) {
        if (id == "alpha-test") return make_alone<L, AlphaTestAlone>(lists, method);
        if (id == "alpha-test-then-blend") {
            return make_alone<L, TestThenBlendAlone>(lists, method);
        }
        if (id == "stochastic-alpha-test") return make_alone<L, StochasticTestAlone>(lists, method);
        if (id == "hashed-alpha-test") return make_alone<L, HashedTestAlone>(lists, method);
        if (id.ends_with("alpha-to-coverage")) return make_alone<L, CoverageAlone>(lists, method);
        if (id == "screen-door") return make_alone<L, ScreenDoorAlone>(lists, method);
    }
    throw std::runtime_error(id + " has no text here");
}

}  // namespace sheer::test
