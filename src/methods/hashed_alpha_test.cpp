// Alpha tests whose thresholds stay on the surface: shaders/sheer/hashed_threshold.glsl. Nearby
// they may be those of an alpha test: shaders/sheer/fade_in.glsl.
#include "methods/method.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "methods/hashed_alpha_test.cpp"
#include "lanes/targets.h"

#include <hwy/foreach_target.h>

#include "methods/alpha_tests-inl.h"
#include "methods/hashed-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <class L>
struct HashedTestText {
#include "lanes/text_words.h"
#include "sheer/random.glsl"
#include "sheer/alpha_test.glsl"
#include "sheer/hashed_threshold.glsl"
#include "sheer/temporal_threshold.glsl"
#include "sheer/fade_in.glsl"
};

class HashedThreshold {
    using real = FragmentLanes::real;
    using Text = HashedTestText<FragmentLanes>;

public:
    static constexpr bool kNamed = false;

    explicit HashedThreshold(const StoreShape& shape)
        : thresholds_(*shape.method), fade_levels_(fade_in_levels(*shape.method))
    {
    }
    void clear(const TilePlace& place) { thresholds_.begin(place.film); }
    HWY_INLINE KeptSamples keep(const FragmentStream& f, std::size_t i, FragmentLanes::whole) const
    {
        real threshold = thresholds_.in_frame(thresholds_.threshold(thresholds_.cells(f, i)));
        if (fade_levels_ > 0) {
            const real b = Text::fade_in(real::load(f.level.data() + i), real(fade_levels_));
            threshold = Text::faded_threshold(threshold, b);
        }
        return all_samples(Text::alpha_test(real::load(f.opacity.data() + i), threshold));
    }

private:
    HashedThresholds<Text> thresholds_;
    float fade_levels_;
};

template <int S>
using HashedAlphaTest = AlphaTestTile<S, HashedThreshold>;

StoreVerbs hashed_alpha_test_store(int samples)
{
    return verbs_for_samples<HashedAlphaTest>(samples);
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sheer {

HWY_EXPORT(hashed_alpha_test_store);

StoreVerbs hashed_alpha_test_verbs(TargetSet targets, const ChosenMethod&, int samples)
{
    return SHEER_DISPATCH(hashed_alpha_test_store, targets)(samples);
}

}  // namespace sheer
#endif
