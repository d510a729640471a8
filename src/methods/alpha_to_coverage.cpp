// Samples in proportion to opacity: shaders/sheer/alpha_to_coverage.glsl, as GPUs have it and with
// numbers that stay on the surface.
#include "methods/method.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "methods/alpha_to_coverage.cpp"
#include "lanes/targets.h"

#include <hwy/foreach_target.h>

#include "methods/alpha_tests-inl.h"
#include "methods/hashed-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <class L>
struct CoverageText {
#include "lanes/text_words.h"
#include "sheer/random.glsl"
#include "sheer/stochastic_masks.glsl"
#include "sheer/hashed_threshold.glsl"
#include "sheer/temporal_threshold.glsl"
#include "sheer/alpha_to_coverage.glsl"
};

class FixedCoverage {
    using real = FragmentLanes::real;
    using whole = FragmentLanes::whole;
    using Text = CoverageText<FragmentLanes>;

public:
    static constexpr bool kNamed = false;

    explicit FixedCoverage(const StoreShape& shape) : samples_(shape.samples->count) {}
    void clear(const TilePlace&) {}
    HWY_INLINE KeptSamples keep(const FragmentStream& f, std::size_t i, whole) const
    {
        const auto bits = Text::coverage_mask(real::load(f.opacity.data() + i), real(0.5f), false,
                                              whole(0u), whole(1u), samples_);
        return {bits.low, bits.high};
    }

private:
    int samples_;
};

class HashedCoverage {
    using real = FragmentLanes::real;
    using whole = FragmentLanes::whole;
    using Text = CoverageText<FragmentLanes>;

public:
    static constexpr bool kNamed = false;

    explicit HashedCoverage(const StoreShape& shape)
        : samples_(shape.samples->count),
          each_(shape.method->value("jitter") == "sample"),
          apart_(shape.method->value("decorrelate") == "on"),
          thresholds_(*shape.method)
    {
    }
    void clear(const TilePlace& place) { thresholds_.begin(place.film); }
    HWY_INLINE KeptSamples keep(const FragmentStream& f, std::size_t i, whole) const
    {
        const auto cells = thresholds_.cells(f, i);
        const whole n(static_cast<std::uint32_t>(samples_));
        whole offset(0u), increment(1u);
        if (apart_) {
            const auto other = [&](std::uint32_t number) HWY_ATTR {
                return thresholds_.threshold(Text::other_cells(cells, whole(number)));
            };
            offset = Text::coverage_offset(n, other(1));
            increment = Text::coverage_increment(n, other(2));
        }
        const real chi = thresholds_.in_frame(thresholds_.threshold(cells));
        const auto bits = Text::coverage_mask(real::load(f.opacity.data() + i), chi, each_, offset,
                                              increment, samples_);
        return {bits.low, bits.high};
    }

private:
    int samples_;
    bool each_, apart_;
    HashedThresholds<Text> thresholds_;
};

template <int S>
using AlphaToCoverage = AlphaTestTile<S, FixedCoverage>;

StoreVerbs alpha_to_coverage_store(int samples)
{
    return verbs_for_samples<AlphaToCoverage>(samples);
}

template <int S>
using HashedAlphaToCoverage = AlphaTestTile<S, HashedCoverage>;

StoreVerbs hashed_alpha_to_coverage_store(int samples)
{
    return verbs_for_samples<HashedAlphaToCoverage>(samples);
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sheer {

HWY_EXPORT(alpha_to_coverage_store);

StoreVerbs alpha_to_coverage_verbs(TargetSet targets, const ChosenMethod&, int samples)
{
    return SHEER_DISPATCH(alpha_to_coverage_store, targets)(samples);
}

HWY_EXPORT(hashed_alpha_to_coverage_store);

StoreVerbs hashed_alpha_to_coverage_verbs(TargetSet targets, const ChosenMethod&, int samples)
{
    return SHEER_DISPATCH(hashed_alpha_to_coverage_store, targets)(samples);
}

}  // namespace sheer
#endif
