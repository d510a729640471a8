// Lanes are a pixel's samples.
#include "methods/method.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "methods/pixel_samples.cpp"
#include "lanes/targets.h"

#include <bit>

#include <hwy/foreach_target.h>

#include "methods/pixel_samples-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <int S>
class PixelSamplesOf final : public PixelSamples {
    using L = Lanes<S>;
    using W = WideLanes<(S < 8 ? S : 8)>;
    using Wide = WideLanes<8>;
    using Text = TransmittanceText<L>;
    using real3 = typename Text::real3;
    using real = typename L::real;

public:
    explicit PixelSamplesOf(const StoreShape& shape)
        : set_(*shape.samples),
          divides_(shape.method->traits().divides),
          fragments_(shape),
          depths_(kTilePixels * count())
    {
    }

    void clear() override
    {
        fragments_.clear();
        std::fill_n(depths_.data(), depths_.size(), std::int64_t{0});
    }
    void look(const FragmentStream& f) override { fragments_.look(f); }
    void see(const FragmentStream& f) override { fragments_.see(f); }
    float place(float depth) const override { return fragments_.place(depth); }
    const char* touched() const override { return fragments_.touched(); }
    ExactGrid color_grid() const override { return fragments_.color_grid(); }

    void merge(const PixelSamples& other) override
    {
        const auto& same = static_cast<const PixelSamplesOf&>(other);
        fragments_.merge(same.fragments_);
        add_all(same.depths_, depths_);
    }
    std::int64_t* depths() override { return depths_.data(); }

    FragmentChunk chunk(const FragmentStream& f, std::size_t first, std::size_t some) override
    {
        return {f, first, some, fragments_.places() + first, parts(f, first, some)};
    }

    void add_depths(const FragmentChunk& c, const float* depths) override
    {
        const ExactGrid grid(-kDepthBits);
        alignas(64) std::int64_t units[Wide::kCount];
        for (std::size_t i = 0; i < c.some; i += Wide::kCount) {
            exact_units<Wide>(Wide::real::load(depths + i), grid).store(units);
            for (std::size_t j = 0; j < Wide::kCount && i + j < c.some; ++j) {
                const std::size_t fragment = c.first + i + j;
                std::int64_t* at = depths_.data() + c.stream.pixel[fragment] * count();
                for (std::size_t s = 0; s < count(); s += W::kCount) {
                    const auto shown = W::mask_of_bits(fragments_.samples(c.stream, fragment, s));
                    const auto addend = W::zero_unless(shown, typename W::whole(units[j]));
                    (W::whole::load(at + s) + addend).store(at + s);
                }
            }
        }
    }

    void resolve(SampleColors& backdrop, const PixelFunctions& functions) const override
    {
        const ExactGrid weights(-kColorBits), colors = fragments_.color_grid();
        for (std::size_t pixel = 0; pixel < kTilePixels; ++pixel) {
            if (!fragments_.touched(pixel)) {
                // What the last tile left there.
                if (divides_) std::fill_n(backdrop.fraction.channel(pixel, 0), 5 * count(), 0.0f);
                continue;
            }
            const std::int64_t* units = functions.sums(pixel);
            const auto sum = [&](std::size_t c, const ExactGrid& grid) {
                return real(static_cast<float>(static_cast<double>(units[c]) * grid.unit));
            };
            const real3 color{sum(0, colors), sum(1, colors), sum(2, colors)};
            const real weight = sum(3, weights);
            for (std::size_t s = 0; s < count(); s += L::kCount) {
                resolve(backdrop, pixel, s, color, weight);
            }
        }
    }

    float mean_shown(float light, std::size_t pixel, float depth) override
    {
        return mean_over_samples<L>(count(), [&](std::size_t s) HWY_ATTR {
            return fragments_.shown(real(light), pixel, s, depth);
        });
    }

private:
    std::size_t count() const { return sample_count<S>(set_.count); }

    // Null if it is all of them.
    const float* parts(const FragmentStream& f, std::size_t first, std::size_t some)
    {
        if (S == 1 && !fragments_.any_opaque()) return nullptr;
        const float part = 1.0f / static_cast<float>(count());
        for (std::size_t i = 0; i < some; ++i) {
            int samples = 0;
            for (std::size_t s = 0; s < count(); s += 32) {
                const std::uint32_t bits = fragments_.samples(f, first + i, s);
                samples += std::popcount(count() < 32 ? bits & ((1u << count()) - 1u) : bits);
            }
            parts_[i] = static_cast<float>(samples) * part;
        }
        return parts_;
    }

    HWY_INLINE void resolve(SampleColors& backdrop, std::size_t pixel, std::size_t s, real3 color,
                            real weight) const
    {
        const real depth =
            exact_sum_as_float<L, W>(depths_.data() + pixel * count() + s, ExactGrid(-kDepthBits));
        const real through = Text::exp_of(real(0.0f) - depth);
        resolve_samples<Text>(backdrop, pixel, s, [&](real3 behind, real& transmittance) HWY_ATTR {
            transmittance = through;
            behind = fragments_.behind(behind, pixel, s, transmittance);
            if (divides_) return through * behind;
            return Text::visible_resolve(color, weight, through, behind);
        });
        if (!divides_) return;
        float* at = backdrop.fraction.channel(pixel, 0) + s;
        save_color<Text>(color, at, count());
        weight.store(at + 3 * count());
        (real(1.0f) - through).store(at + 4 * count());
    }

    const SampleSet& set_;
    bool divides_;
    TranslucentFragments<S> fragments_;
    AlignedArray<std::int64_t> depths_;
    alignas(64) float parts_[kChunk] = {};
};

std::unique_ptr<PixelSamples> make_pixel_samples(const StoreShape& shape)
{
    switch (shape.samples->count) {
        case 1: return std::make_unique<PixelSamplesOf<1>>(shape);
        case 2: return std::make_unique<PixelSamplesOf<2>>(shape);
        case 4: return std::make_unique<PixelSamplesOf<4>>(shape);
        case 8: return std::make_unique<PixelSamplesOf<8>>(shape);
        default: return std::make_unique<PixelSamplesOf<16>>(shape);
    }
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
