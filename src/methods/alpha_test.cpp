// Alpha tests whose threshold is one number, or random.
#include "methods/method.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "methods/alpha_test.cpp"
#include "lanes/targets.h"

#include <hwy/foreach_target.h>

#include "methods/alpha_tests-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <class L>
struct AlphaTestText {
#include "lanes/text_words.h"
#include "sheer/random.glsl"
#include "sheer/alpha_test.glsl"
#include "sheer/stochastic_masks.glsl"
};

class FixedThreshold {
    using real = FragmentLanes::real;
    using Text = AlphaTestText<FragmentLanes>;

public:
    static constexpr bool kNamed = false;

    explicit FixedThreshold(const StoreShape& shape)
        : threshold_(static_cast<float>(shape.method->real("cutoff")))
    {
    }
    void clear(const TilePlace&) {}
    HWY_INLINE KeptSamples keep(const FragmentStream& f, std::size_t i, FragmentLanes::whole) const
    {
        return all_samples(Text::alpha_test(real::load(f.opacity.data() + i), real(threshold_)));
    }

private:
    float threshold_;
};

class RandomThreshold {
    using real = FragmentLanes::real;
    using whole = FragmentLanes::whole;
    using Text = AlphaTestText<FragmentLanes>;

public:
    static constexpr bool kNamed = true;

    explicit RandomThreshold(const StoreShape& shape)
        : samples_(shape.samples->count), each_(shape.method->value("threshold") == "sample")
    {
    }
    void clear(const TilePlace& place) { place_ = place; }
    std::uint32_t name(const FragmentRun& run) const { return run.primitive; }
    HWY_INLINE KeptSamples keep(const FragmentStream& f, std::size_t i, whole names) const
    {
        const PixelPlaces at = pixel_places(place_, f, i);
        const whole seed =
            Text::fragment_seed(at.x, at.y, Text::identity_seed(names, whole(place_.key)));
        const real opacity = real::load(f.opacity.data() + i);
        if (!each_) return all_samples(Text::alpha_test(opacity, Text::random_threshold(seed)));
        const auto bits = Text::naive_mask(seed, opacity, samples_);
        return {bits.low, bits.high};
    }

private:
    int samples_;
    bool each_;
    TilePlace place_;
};

template <int S>
using AlphaTest = AlphaTestTile<S, FixedThreshold>;

StoreVerbs alpha_test_store(int samples)
{
    return verbs_for_samples<AlphaTest>(samples);
}

template <int S>
using StochasticAlphaTest = AlphaTestTile<S, RandomThreshold>;

StoreVerbs stochastic_alpha_test_store(int samples)
{
    return verbs_for_samples<StochasticAlphaTest>(samples);
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sheer {

HWY_EXPORT(alpha_test_store);

StoreVerbs alpha_test_verbs(TargetSet targets, const ChosenMethod&, int samples)
{
    return SHEER_DISPATCH(alpha_test_store, targets)(samples);
}

HWY_EXPORT(stochastic_alpha_test_store);

StoreVerbs stochastic_alpha_test_verbs(TargetSet targets, const ChosenMethod&, int samples)
{
    return SHEER_DISPATCH(stochastic_alpha_test_store, targets)(samples);
}

}  // namespace sheer
#endif
