// shaders/sheer/alpha_test_then_blend.glsl at every sample: 36 bytes, the nearest that passes and
// what is blended before it.
#include "methods/method.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "methods/alpha_test_then_blend.cpp"
#include "lanes/targets.h"

#include <hwy/foreach_target.h>

#include "methods/nearest_samples-inl.h"
#include "raster/sample_depth-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <class L>
struct TestThenBlendText {
#include "lanes/text_words.h"
#include "sheer/random.glsl"
#include "sheer/over.glsl"
#include "sheer/stochastic.glsl"
#include "sheer/alpha_test.glsl"
#include "sheer/blend.glsl"
#include "sheer/alpha_test_then_blend.glsl"
};

template <int S>
struct TestThenBlendMethod {
    using L = Lanes<S>;
    using Text = TestThenBlendText<L>;
    using Nearest = NearestSamples<S, TestThenBlendText>;
    using Store = typename Text::TestThenBlendStore;
    using real3 = typename Text::real3;
    using real = typename L::real;
    static constexpr int kChannels = Nearest::kChannels + 4;

    static HWY_INLINE Store clear() { return Text::test_then_blend_clear(Nearest::beyond_any()); }
    static HWY_INLINE Store merge(Store s, Store later)
    {
        return Text::test_then_blend_merge(s, later, Nearest::beyond_any());
    }
    static HWY_INLINE real3 resolve(Store s, real3 backdrop, real& transmittance)
    {
        transmittance = Text::test_then_blend_transmittance(s, Nearest::beyond_any());
        return Text::test_then_blend_resolve(s, Nearest::beyond_any(), backdrop);
    }
    static HWY_INLINE Store load(const float* at, std::size_t samples)
    {
        const float* rest = at + Nearest::kChannels * samples;
        return {Nearest::load(at, samples),
                {load_color<Text>(rest, samples), real::load(rest + 3 * samples)}};
    }
    static HWY_INLINE void save(const Store& s, float* at, std::size_t samples)
    {
        float* rest = at + Nearest::kChannels * samples;
        Nearest::save(s.opaque, at, samples);
        save_color<Text>(s.rest.color, rest, samples);
        s.rest.transmittance.store(rest + 3 * samples);
    }
};

template <int S>
class TestThenBlendTile : public SampleStore<S, TestThenBlendMethod<S>> {
    using Base = SampleStore<S, TestThenBlendMethod<S>>;
    using typename Base::L;
    using typename Base::real;
    using typename Base::Text;

public:
    explicit TestThenBlendTile(const StoreShape& shape)
        : Base(shape),
          set_(*shape.samples),
          threshold_(static_cast<float>(shape.method->real("cutoff")))
    {
    }

    void insert(const FragmentStream& f, int pass)
    {
        for (int r = 0; r < f.run_count; ++r) {
            const FragmentRun& run = f.runs[r];
            for (std::size_t i = run.first; i < run.first + run.count; ++i) {
                // Neither pass has anything to do with what the other is for.
                if ((f.opacity[i] >= threshold_) != (pass == 0)) continue;
                for (std::size_t s = 0; s < this->count(); s += L::kCount) add(f, run, i, s, pass);
            }
        }
    }

private:
    HWY_INLINE void add(const FragmentStream& f, const FragmentRun& run, std::size_t i,
                        std::size_t s, int pass)
    {
        const typename Text::StochasticStore fragment = {
            sample_depth<L>(run.depth, set_, f.depth[i], s), typename L::whole(run.primitive),
            color_of<Text>(f, i)};
        const auto covered = sample_mask<L>(f, i, s);
        const real opacity(f.opacity[i]), threshold(threshold_);
        const auto store = this->load(f.pixel[i], s);
        this->save(pass == 0
                       ? Text::test_then_blend_test(store, covered, fragment, opacity, threshold)
                       : Text::test_then_blend_blend(store, covered, fragment, opacity, threshold),
                   f.pixel[i], s);
    }

    const SampleSet& set_;
    float threshold_;
};

StoreVerbs alpha_test_then_blend_store(int samples)
{
    return verbs_for_samples<TestThenBlendTile>(samples);
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sheer {

HWY_EXPORT(alpha_test_then_blend_store);

StoreVerbs alpha_test_then_blend_verbs(TargetSet targets, const ChosenMethod&, int samples)
{
    return SHEER_DISPATCH(alpha_test_then_blend_store, targets)(samples);
}

}  // namespace sheer
#endif
