// What a fragment leaves at the samples of one texel of a shadow map.
#if defined(SHEER_SHADOW_SAMPLES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_SHADOW_SAMPLES_INL_H
#undef SHEER_SHADOW_SAMPLES_INL_H
#else
#define SHEER_SHADOW_SAMPLES_INL_H
#endif

#include <algorithm>
#include <cstdint>

#include "cpu/shadow_store.h"
#include "lanes/lanes-inl.h"
#include "raster/sample_depth-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

// Of a texel's samples, 16 where there are more.
template <int Samples>
using TexelLanes = Lanes<std::min(Samples, 16)>;

template <int Samples>
struct RunDepth {
    using L = TexelLanes<Samples>;
    using real = typename L::real;
    static constexpr std::size_t kBlocks = (Samples + L::kCount - 1) / L::kCount;
    const DepthPlane& plane;
    real offset[kBlocks];

    HWY_INLINE RunDepth(const DepthPlane& p, const SampleSet& set) : plane(p)
    {
        for (std::size_t b = 0; b < kBlocks; ++b) {
            offset[b] = sample_depth_offset<L>(plane, set, b * L::kCount);
        }
    }
};

// Bits of samples s, s + 1, ... out of a fragment's.
HWY_INLINE std::uint32_t bits_from(std::uint32_t low, std::uint32_t high, std::size_t s)
{
    return (s < 32 ? low : high) >> (s & 31);
}

// What a layer of a map sees of fragments i, i + 1, ...: their mean opacity, or a channel's.
HWY_INLINE Lanes<16>::real opacity_of(const FragmentStream& f, std::size_t layer, std::size_t i,
                                      bool colored)
{
    using real = Lanes<16>::real;
    if (!colored) return real::load(f.opacity.data() + i);
    const AlignedArray<float>* through[3] = {&f.through_red, &f.through_green, &f.through_blue};
    return real(1.0f) - real::load(through[layer]->data() + i);
}

template <int Samples>
HWY_INLINE void multiply(float rest, std::uint32_t low, std::uint32_t high, float* through)
{
    using L = TexelLanes<Samples>;
    using real = typename L::real;
    for (std::size_t s = 0; s < static_cast<std::size_t>(Samples); s += L::kCount) {
        const auto covered = L::mask_of_bits(bits_from(low, high, s));
        const real before = real::load(through + s);
        L::select(covered, before * real(rest), before).store(through + s);
    }
}

// The first sample of the texel that a fragment's pixel is.
HWY_INLINE std::size_t texel_of(const ShadowTile& tile, std::uint32_t pixel)
{
    return tile.map.at(tile.rect.x0 + static_cast<int>(pixel % kTileSize),
                       tile.rect.y0 + static_cast<int>(pixel / kTileSize));
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_SHADOW_SAMPLES_INL_H
