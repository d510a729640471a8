// A method that approximates transmittance (shaders/sheer/transmittance.glsl), with one function
// for each pixel of a tile, which its samples share.
#include "methods/method.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "methods/transmittance_pixels.cpp"
#include "lanes/targets.h"

#include <hwy/foreach_target.h>

#include "methods/pixel_samples-inl.h"
#include "methods/transmittance_stores-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

class TransmittancePixels final : public TransmittanceStore {
public:
    TransmittancePixels(const StoreShape& shape, OwnFunction function)
        : functions_(std::move(function)),
          moment_passes_(functions_.passes()),
          one_sample_(shape.samples->count == 1),
          samples_(make_pixel_samples(shape))
    {
    }

    void clear(const TilePlace&) override
    {
        samples_->clear();
        functions_.clear();
        pass_ = 0;
    }

    void insert(const FragmentStream& f, int pass) override
    {
        finish_passes(pass);
        if (pass == 0) return samples_->look(f);
        samples_->see(f);
        const bool is_last = pass > moment_passes_;
        const auto size = static_cast<std::size_t>(f.size);
        for (std::size_t first = 0; first < size; first += kChunk) {
            const std::size_t some = std::min(kChunk, size - first);
            const FragmentChunk chunk = samples_->chunk(f, first, some);
            if (is_last) {
                functions_.add_colors(chunk, samples_->color_grid());
            } else {
                add_depths(chunk, pass == 1);
            }
        }
    }

    void merge(const TransmittanceStore& other) override
    {
        const auto& same = static_cast<const TransmittancePixels&>(other);
        samples_->merge(*same.samples_);
        functions_.merge(same.functions_);
    }

    void resolve(SampleColors& backdrop) override
    {
        finish_passes(moment_passes_ + 1);
        samples_->resolve(backdrop, functions_);
    }

    float transmittance_at(std::size_t pixel, float depth) override
    {
        finish_passes(moment_passes_ + 1);
        const float place = samples_->place(depth);
        return samples_->mean_shown(functions_.transmittance_at(pixel, place), pixel, depth);
    }

private:
    void finish_passes(int pass)
    {
        for (; pass_ < pass; ++pass_) {
            if (pass_ == 0) continue;
            functions_.prepare(samples_->touched(), pass_ == 1,
                               one_sample_ && pass_ == 1 ? samples_->depths() : nullptr);
        }
    }

    void add_depths(const FragmentChunk& chunk, bool is_first)
    {
        alignas(64) float depths[kChunk];
        functions_.find_depths(chunk, is_first, depths);
        if (is_first && !one_sample_) samples_->add_depths(chunk, depths);
        functions_.add_depths(chunk, depths);
    }

    PixelFunctions functions_;
    int moment_passes_;
    int pass_ = 0;     // that was last: 0 of looking, then those of sums, then colours
    bool one_sample_;  // whose sums are the pixel's
    std::unique_ptr<PixelSamples> samples_;
};

OwnStore make_transmittance_pixels(const StoreShape& shape, OwnFunction function)
{
    return std::make_unique<TransmittancePixels>(shape, std::move(function));
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
