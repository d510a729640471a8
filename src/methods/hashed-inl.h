// Hashed thresholds of a stream's fragments, a fragment a lane.
#if defined(SHEER_HASHED_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_HASHED_INL_H
#undef SHEER_HASHED_INL_H
#else
#define SHEER_HASHED_INL_H
#endif

#include "lanes/lanes-inl.h"
#include "lanes/text.h"
#include "methods/hashed_settings.h"
#include "methods/method.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

// Text: has the words of hashed_threshold.glsl and temporal_threshold.glsl.
template <class Text>
class HashedThresholds {
    using real = typename Text::real;
    using real3 = typename Text::real3;
    using whole = typename Text::whole;

public:
    explicit HashedThresholds(const ChosenMethod& method) : settings_(hashed_settings(method)) {}

    void begin(const FrameOfFilm& frame)
    {
        period_ = frame.period;
        frame_ = static_cast<std::uint32_t>(frame.number % frame.period);
    }

    // Of fragments i, i + 1, ...
    HWY_INLINE typename Text::HashCells cells(const FragmentStream& f, std::size_t i) const
    {
        const auto load = [&](std::size_t c) HWY_ATTR {
            return real3(real::load(f.place[c].data() + i), real::load(f.place[c + 1].data() + i),
                         real::load(f.place[c + 2].data() + i));
        };
        const real scale(settings_.hash_scale);
        const real3 place = load(0), dx = load(3), dy = load(6);
        typename Text::HashCells cells;
        if (settings_.variant == HashVariant::isotropic) {
            const real one = Text::isotropic_scale(dx, dy, scale);
            cells = settings_.octaves ? Text::isotropic_cells(place, one)
                                      : Text::continuous_cells(place, real3(one, one, one));
        } else {
            const real3 each = Text::anisotropic_scales(dx, dy, scale);
            cells = settings_.octaves ? Text::anisotropic_cells(place, each)
                                      : Text::continuous_cells(place, each);
        }
        if (!settings_.third) cells.coarse.z = cells.fine.z = real(0.0f);
        const bool moves = settings_.frames == HashFrames::offsets && frame_ != 0;
        return moves ? Text::frame_cells(cells, whole(frame_)) : cells;
    }
    HWY_INLINE real threshold(const typename Text::HashCells& cells) const
    {
        if (settings_.variant == HashVariant::eight_corners) {
            return Text::threshold_of_corners(cells, settings_.hash, settings_.uniform);
        }
        return Text::threshold_of_cells(cells, settings_.hash, settings_.uniform);
    }

    // A threshold as the frame has it.
    HWY_INLINE real in_frame(real threshold) const
    {
        if (settings_.frames < HashFrames::linear) return threshold;
        const int order = static_cast<int>(settings_.frames) - static_cast<int>(HashFrames::linear);
        const whole stratum = Text::frame_stratum(whole(frame_), period_, order);
        return Text::stratified_threshold(threshold, stratum, period_);
    }

private:
    HashedSettings settings_;
    int period_ = 1;
    std::uint32_t frame_ = 0;  // in [0, period_)
};

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_HASHED_INL_H
