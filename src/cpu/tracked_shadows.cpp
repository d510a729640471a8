// A fragment at a time, a texel's samples in the lanes.
#include "cpu/tracked_shadows.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cpu/tracked_shadows.cpp"
#include "lanes/targets.h"

#include <algorithm>
#include <limits>
#include <vector>

#include <hwy/foreach_target.h>

#include "cpu/shadow_samples-inl.h"
#include "methods/tracked_masks-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <int Samples>
class TrackedTexels final : public ShadowTileStore {
    using L = TexelLanes<Samples>;
    using real = typename L::real;
    using whole = typename L::whole;
    using Block = Lanes<16>;  // of fragments

public:
    TrackedTexels(const ShadowMap& map, const SampleSet& set, const StratifiedSettings& settings)
        : set_(set)
    {
        for (std::size_t i = 0; i < map.layers.size(); ++i) layers_.emplace_back(set, settings);
    }

    void begin(const ShadowTile& tile, const FrameOfPicture& frame) override
    {
        for (Layer& layer : layers_) {
            layer.masks.clear({tile.rect.x0, tile.rect.y0, tile.map.key, frame});
            layer.masks.begin_pass(0);
            for (std::size_t pixel = 0; pixel < kTilePixels; ++pixel) {
                for (std::size_t s = 0; s < Samples; s += L::kCount) {
                    real(kNothing).store(layer.kept.channel(pixel, kDepth) + s);
                    whole(kNobody).as_real().store(layer.kept.channel(pixel, kPrimitive) + s);
                }
            }
        }
    }

    void insert(const ShadowTile& tile, const FragmentStream& f) override
    {
        for (std::size_t i = 0; i < layers_.size(); ++i) {
            Layer& layer = layers_[i];
            const float* opacity = find_opacity(f, i);
            layer.masks.template for_each_run<Samples>(
                f, opacity, {layer.kept.values.data(), kChannels},
                [&](const FragmentRun& run, std::size_t k)
                    HWY_ATTR { insert_run(f, run, k, layer); });
            if (!tile.map.is_corrected()) continue;
            float* through = tile.map.layers[i].through.data();
            for (std::size_t k = 0; k < static_cast<std::size_t>(f.size); ++k) {
                multiply<Samples>(1 - opacity[k], f.samples[k], f.samples_high[k],
                                  through + texel_of(tile, f.pixel[k]));
            }
        }
    }

    void end(const ShadowTile& tile) override
    {
        for (int y = tile.rect.y0; y < tile.rect.y1; ++y) {
            for (int x = tile.rect.x0; x < tile.rect.x1; ++x) {
                const auto pixel =
                    static_cast<std::size_t>((y - tile.rect.y0) * kTileSize + x - tile.rect.x0);
                for (std::size_t i = 0; i < layers_.size(); ++i) {
                    std::copy_n(layers_[i].kept.channel(pixel, kDepth), Samples,
                                tile.map.layers[i].depth.data() + tile.map.at(x, y));
                }
            }
        }
    }

private:
    static constexpr std::size_t kDepth = 0, kPrimitive = 1, kChannels = 2;
    static constexpr float kNothing = std::numeric_limits<float>::infinity();
    static constexpr std::uint32_t kNobody = 0x7fffffffu;  // loses every tie

    struct Layer {
        TrackedMasks<L::kCount> masks;
        SampleValues<kChannels> kept{Samples};

        Layer(const SampleSet& set, const StratifiedSettings& settings) : masks(set, settings, {})
        {
        }
    };

    // Of a stream's fragments, as layer i sees them.
    HWY_INLINE const float* find_opacity(const FragmentStream& f, std::size_t i)
    {
        if (layers_.size() == 1) return f.opacity.data();
        const auto size = static_cast<std::size_t>(f.size);
        opacity_.resize(size + Block::kCount);
        for (std::size_t k = 0; k < size; k += Block::kCount) {
            opacity_of(f, i, k, true).store(opacity_.data() + k);
        }
        return opacity_.data();
    }

    // The run's candidates from k on, at the samples that they take, where they are nearer.
    HWY_INLINE void insert_run(const FragmentStream& f, const FragmentRun& run, std::size_t k,
                               Layer& layer)
    {
        const RunDepth<Samples> depth(run.depth, set_);
        const std::size_t end = run.first + run.count;
        for (; layer.masks.number(k) < end; ++k) {
            const std::size_t i = layer.masks.number(k), pixel = f.pixel[i];
            float* depths = layer.kept.channel(pixel, kDepth);
            float* primitives = layer.kept.channel(pixel, kPrimitive);
            real most;
            for (std::size_t b = 0; b < depth.kBlocks; ++b) {
                const std::size_t s = b * L::kCount;
                const auto taken = L::mask_of_bits(layer.masks.word(k, s));
                const real here = sample_depth<L>(run.depth, depth.offset[b], f.depth[i]);
                const real now = L::select(taken, here, real::load(depths + s));
                const whole owner = L::select(taken, whole(run.primitive),
                                              whole::bits_of(real::load(primitives + s)));
                now.store(depths + s);
                owner.as_real().store(primitives + s);
                most = b == 0 ? now : L::max(most, now);
            }
            layer.masks.farthest.data()[pixel] = most.greatest();
        }
    }

    const SampleSet& set_;
    std::vector<Layer> layers_;  // of the map
    std::vector<float> opacity_;
};

std::unique_ptr<ShadowTileStore> tracked_texels(const ShadowMap& map, const SampleSet& set,
                                                const StratifiedSettings& settings)
{
    switch (map.samples) {
        case 1: return std::make_unique<TrackedTexels<1>>(map, set, settings);
        case 2: return std::make_unique<TrackedTexels<2>>(map, set, settings);
        case 4: return std::make_unique<TrackedTexels<4>>(map, set, settings);
        case 8: return std::make_unique<TrackedTexels<8>>(map, set, settings);
        case 16: return std::make_unique<TrackedTexels<16>>(map, set, settings);
        case 32: return std::make_unique<TrackedTexels<32>>(map, set, settings);
        default: return std::make_unique<TrackedTexels<64>>(map, set, settings);
    }
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sheer {

HWY_EXPORT(tracked_texels);

std::unique_ptr<ShadowTileStore> make_tracked_shadows(TargetSet targets, const ShadowMap& map,
                                                      const SampleSet& set, ShadowMasks masks)
{
    StratifiedSettings settings;
    if (masks == ShadowMasks::systematic) settings.sequence = Sequence::systematic;
    return SHEER_DISPATCH(tracked_texels, targets)(map, set, settings);
}

}  // namespace sheer
#endif
