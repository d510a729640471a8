// A fragment a lane while masks are made, then a sample a lane.
#include "cpu/shadow_store.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cpu/shadow_store.cpp"
#include "lanes/targets.h"

#include <algorithm>
#include <limits>

#include <hwy/foreach_target.h>

#include "cpu/shadow_samples-inl.h"
#include "lanes/text.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <class L>
struct ShadowMaskText {
#include "lanes/text_words.h"
#include "sheer/random.glsl"
#include "sheer/stochastic_masks.glsl"
};

// Of sixteen fragments, with what they cover.
struct MaskBlock {
    alignas(64) std::uint32_t low[16], high[16];
    alignas(64) float opacity[16];
};

template <int Samples>
HWY_INLINE auto random_mask(ShadowMasks masks, Lanes<16>::whole seed, Lanes<16>::real opacity)
{
    using Text = ShadowMaskText<Lanes<16>>;
    if (masks == ShadowMasks::naive) return Text::naive_mask(seed, opacity, Samples);
    const auto xi = Text::next_random_real(seed);
    return Text::stratified_mask(seed, xi, opacity, Samples);
}

// Of all layers by the same random numbers, so that grey glass stays grey.
template <int Samples>
HWY_INLINE void make_masks(const ShadowTile& tile, const FragmentStream& f, std::size_t i,
                           std::size_t end, std::uint32_t primitive, std::size_t layer,
                           MaskBlock& masks)
{
    using Block = Lanes<16>;
    using Text = ShadowMaskText<Block>;
    using whole = typename Block::whole;
    static_assert(kTileSize == 1 << 5);
    const bool colored = tile.map.layers.size() > 1;
    for (std::size_t b = 0; b < 16; b += Block::kCount) {
        const whole pixel = whole::load(f.pixel.data() + i + b);
        const whole x = whole(tile.rect.x0) + (pixel & whole(kTileSize - 1));
        const whole y = whole(tile.rect.y0) + (pixel >> 5);
        const whole identity = Text::identity_seed(whole(primitive), whole(tile.map.key));
        const whole seed = Text::fragment_seed(x, y, identity);
        // What lies past the last may be any number.
        const auto there = Block::iota() + whole(static_cast<std::uint32_t>(i + b)) <
                           whole(static_cast<std::uint32_t>(end));
        const auto opacity = Block::zero_unless(there, opacity_of(f, layer, i + b, colored));
        opacity.store(masks.opacity + b);
        const auto bits = random_mask<Samples>(tile.masks, seed, opacity);
        (bits.low & whole::load(f.samples.data() + i + b)).store(masks.low + b);
        (bits.high & whole::load(f.samples_high.data() + i + b)).store(masks.high + b);
    }
}

template <int Samples>
HWY_INLINE void keep_nearest(const RunDepth<Samples>& run, float center, std::uint32_t low,
                             std::uint32_t high, float* kept)
{
    using L = typename RunDepth<Samples>::L;
    using real = typename L::real;
    for (std::size_t b = 0; b < run.kBlocks; ++b) {
        const std::size_t s = b * L::kCount;
        const auto taken = L::mask_of_bits(bits_from(low, high, s));
        const real here = sample_depth<L>(run.plane, run.offset[b], center);
        const real before = real::load(kept + s);
        L::select(taken & (here < before), here, before).store(kept + s);
    }
}

template <int Samples>
void insert_run(const ShadowTile& tile, const FragmentStream& f, const FragmentRun& run)
{
    const RunDepth<Samples> depth(run.depth, tile.set);
    const std::size_t end = run.first + run.count;
    MaskBlock masks;
    for (std::size_t layer = 0; layer < tile.map.layers.size(); ++layer) {
        ShadowMap::Layer& kept = tile.map.layers[layer];
        for (std::size_t i = run.first; i < end; i += 16) {
            make_masks<Samples>(tile, f, i, end, run.primitive, layer, masks);
            for (std::size_t k = 0; k < std::min<std::size_t>(16, end - i); ++k) {
                const std::size_t at = texel_of(tile, f.pixel[i + k]);
                if ((masks.low[k] | (Samples > 32 ? masks.high[k] : 0)) != 0) {
                    keep_nearest<Samples>(depth, f.depth[i + k], masks.low[k], masks.high[k],
                                          kept.depth.data() + at);
                }
                if (tile.map.is_corrected()) {
                    multiply<Samples>(1 - masks.opacity[k], f.samples[i + k], f.samples_high[i + k],
                                      kept.through.data() + at);
                }
            }
        }
    }
}

template <int Samples>
void insert_stream(const ShadowTile& tile, const FragmentStream& f)
{
    for (int r = 0; r < f.run_count; ++r) insert_run<Samples>(tile, f, f.runs[r]);
}

void insert_shadows(const ShadowTile& tile, const FragmentStream& f)
{
    switch (tile.map.samples) {
        case 1: return insert_stream<1>(tile, f);
        case 2: return insert_stream<2>(tile, f);
        case 4: return insert_stream<4>(tile, f);
        case 8: return insert_stream<8>(tile, f);
        case 16: return insert_stream<16>(tile, f);
        case 32: return insert_stream<32>(tile, f);
        default: return insert_stream<64>(tile, f);
    }
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sheer {

HWY_EXPORT(insert_shadows);

InsertShadows insert_shadows_for(TargetSet targets)
{
    return SHEER_DISPATCH(insert_shadows, targets);
}

namespace {

// Calls visit(its place in the map, its place in the tile) for each sample.
template <class Visit>
void for_each_sample(const ShadowTile& tile, Visit&& visit)
{
    const PixelRect& rect = tile.rect;
    const auto count = static_cast<std::size_t>((rect.x1 - rect.x0) * tile.map.samples);
    for (int y = rect.y0; y < rect.y1; ++y) {
        const auto row = static_cast<std::size_t>((y - rect.y0) * kTileSize * tile.map.samples);
        const std::size_t at = tile.map.at(rect.x0, y);
        for (std::size_t i = 0; i < count; ++i) visit(at + i, row + i);
    }
}

constexpr float kNothing = std::numeric_limits<float>::infinity();

}  // namespace

void clear_shadow_tile(const ShadowTile& tile)
{
    const bool corrected = tile.map.is_corrected();
    for (ShadowMap::Layer& layer : tile.map.layers) {
        for_each_sample(tile, [&](std::size_t at, std::size_t) {
            layer.depth[at] = kNothing;
            if (corrected) layer.through[at] = 1;
        });
    }
}

void insert_opaque_shadows(const ShadowTile& tile, const OpaqueTile& opaque)
{
    ShadowMap& map = tile.map;
    if (map.is_corrected()) {
        for_each_sample(tile, [&](std::size_t at, std::size_t in_tile) {
            map.opaque[at] = opaque.any ? opaque.depth[in_tile] : kNothing;
            for (ShadowMap::Layer& layer : map.layers) {
                const float steps = layer.through[at] / kThroughStep;
                layer.through[at] =
                    kThroughStep * static_cast<float>(static_cast<int>(steps + 0.5f));
            }
        });
    } else if (opaque.any) {
        for (ShadowMap::Layer& layer : map.layers) {
            for_each_sample(tile, [&](std::size_t at, std::size_t in_tile) {
                layer.depth[at] = std::min(layer.depth[at], opaque.depth[in_tile]);
            });
        }
    }
}

}  // namespace sheer
#endif
