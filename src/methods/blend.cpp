// Alpha blending in the order of submission.
// Porter and Duff. Compositing Digital Images. SIGGRAPH 1984.
//
// Each sample keeps the premultiplied colour C and the transmittance T of what was drawn so far; a
// fragment goes over it. The baseline of every comparison: what an engine gets that does not sort.
// Exact for one fragment, and for any number that arrive from far to near. 16 bytes a sample.
#include "methods/method.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "methods/blend.cpp"
#include "lanes/targets.h"

#include <hwy/foreach_target.h>

#include "methods/samples-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <int S>
struct BlendStore {
    using L = Lanes<S>;
    using real = typename L::real;
    SampleColors kept;  // C in the first three channels, T in the fourth

    explicit BlendStore(const StoreShape& shape) : kept(shape.samples->count) {}

    void clear()
    {
        for (std::size_t pixel = 0; pixel < kTilePixels; ++pixel) {
            std::fill_n(kept.channel(pixel, 0), 3 * kept.samples, 0.0f);
            std::fill_n(kept.channel(pixel, 3), kept.samples, 1.0f);
        }
    }

    void insert(const FragmentStream& f, int)
    {
        const auto samples = static_cast<std::size_t>(kept.samples);
        for (std::size_t i = 0; i < static_cast<std::size_t>(f.size); ++i) {
            const real opacity(f.opacity[i]), red(f.red[i]), green(f.green[i]), blue(f.blue[i]);
            float* at = kept.channel(f.pixel[i], 0);
            for (std::size_t s = 0; s < samples; s += L::kCount, at += L::kCount) {
                const real a = L::zero_unless(sample_mask<L>(f, i, s), opacity);
                const real rest = real(1.0f) - a;
                (a * red + rest * real::load(at)).store(at);
                (a * green + rest * real::load(at + samples)).store(at + samples);
                (a * blue + rest * real::load(at + 2 * samples)).store(at + 2 * samples);
                (rest * real::load(at + 3 * samples)).store(at + 3 * samples);
            }
        }
    }

    // `later` was submitted after everything here: its layers go over these.
    void merge(const BlendStore& later)
    {
        for (std::size_t pixel = 0; pixel < kTilePixels; ++pixel) {
            for (std::size_t s = 0; s < static_cast<std::size_t>(kept.samples); s += L::kCount) {
                const real rest = real::load(later.kept.channel(pixel, 3) + s);
                for (std::size_t c = 0; c < 3; ++c) {
                    float* color = kept.channel(pixel, c) + s;
                    const real front = real::load(later.kept.channel(pixel, c) + s);
                    (front + rest * real::load(color)).store(color);
                }
                float* transmittance = kept.channel(pixel, 3) + s;
                (rest * real::load(transmittance)).store(transmittance);
            }
        }
    }

    void resolve(SampleColors& backdrop) const
    {
        for (std::size_t pixel = 0; pixel < kTilePixels; ++pixel) {
            for (std::size_t s = 0; s < static_cast<std::size_t>(kept.samples); s += L::kCount) {
                const real rest = real::load(kept.channel(pixel, 3) + s);
                for (std::size_t c = 0; c < 3; ++c) {
                    float* color = backdrop.channel(pixel, c) + s;
                    const real front = real::load(kept.channel(pixel, c) + s);
                    (front + rest * real::load(color)).store(color);
                }
                over_alpha<L>(rest, backdrop.channel(pixel, 3) + s);
            }
        }
    }
};

StoreVerbs blend_store(int samples)
{
    return verbs_for_samples<BlendStore>(samples);
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sheer {

HWY_EXPORT(blend_store);

StoreVerbs blend_verbs(TargetSet targets, int samples)
{
    return SHEER_DISPATCH(blend_store, targets)(samples);
}

}  // namespace sheer
#endif
