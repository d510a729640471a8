// Pixels in proportion to opacity: shaders/sheer/screen_door.glsl.
#include "methods/method.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "methods/screen_door.cpp"
#include "lanes/targets.h"

#include <hwy/foreach_target.h>

#include "methods/alpha_tests-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <class L>
struct ScreenDoorText {
#include "lanes/text_words.h"
#include "sheer/random.glsl"
#include "sheer/stochastic_masks.glsl"
#include "sheer/alpha_to_coverage.glsl"
#include "sheer/screen_door.glsl"
};

class ScreenDoor {
    using real = FragmentLanes::real;
    using whole = FragmentLanes::whole;
    using Text = ScreenDoorText<FragmentLanes>;

public:
    static constexpr bool kNamed = true;

    explicit ScreenDoor(const StoreShape& shape)
        : bits_(shape.method->value("square") == "2"   ? 1
                : shape.method->value("square") == "4" ? 2
                                                       : 3),
          by_object_(shape.method->value("decorrelate") == "object"),
          apart_(shape.method->value("decorrelate") != "off"),
          jittered_(shape.method->value("jitter") == "on")
    {
    }
    void clear(const TilePlace& place) { place_ = place; }
    std::uint32_t name(const FragmentRun& run) const
    {
        return by_object_ ? 2 * run.object + (run.back_facing ? 1u : 0u) : run.primitive;
    }
    HWY_INLINE KeptSamples keep(const FragmentStream& f, std::size_t i, whole names) const
    {
        const PixelPlaces at = pixel_places(place_, f, i);
        const whole seed = Text::identity_seed(names, whole(0u));
        return all_samples(Text::screen_door_keeps(real::load(f.opacity.data() + i), at.x, at.y,
                                                   bits_, seed, apart_, jittered_));
    }

private:
    int bits_;  // of the square's side
    bool by_object_, apart_, jittered_;
    TilePlace place_;
};

template <int S>
using ScreenDoorTile = AlphaTestTile<S, ScreenDoor>;

StoreVerbs screen_door_store(int samples)
{
    return verbs_for_samples<ScreenDoorTile>(samples);
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sheer {

HWY_EXPORT(screen_door_store);

StoreVerbs screen_door_verbs(TargetSet targets, const ChosenMethod&, int samples)
{
    return SHEER_DISPATCH(screen_door_store, targets)(samples);
}

}  // namespace sheer
#endif
