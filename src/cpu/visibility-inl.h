// Opaque surfaces, sample by sample: lanes over the samples of one pixel.
#if defined(SHEER_VISIBILITY_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_VISIBILITY_INL_H
#undef SHEER_VISIBILITY_INL_H
#else
#define SHEER_VISIBILITY_INL_H
#endif

#include "cpu/triangle_planes.h"
#include "lanes/lanes-inl.h"
#include "raster/opaque_tile.h"
#include "raster/sample_depth-inl.h"
#include "raster/sample_set.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

struct OpaqueFragment {
    std::uint32_t pixel;
    std::uint64_t samples;
    std::uint32_t primitive;
    float depth;  // at the pixel's centre
    float color[3];
};

// The functions for one number of samples.
struct OpaqueSamples {
    // Samples of a pixel at which a transparent triangle is in front of what is opaque.
    std::uint64_t (*in_front)(const OpaqueTile&, const SampleSet&, const TrianglePlanes&,
                              std::uint32_t pixel, float depth);
    void (*write)(OpaqueTile&, const SampleSet&, const TrianglePlanes&, const OpaqueFragment&);
};

template <int S>
std::uint64_t in_front(const OpaqueTile& opaque, const SampleSet& set, const TrianglePlanes& planes,
                       std::uint32_t pixel, float depth)
{
    using L = Lanes<S>;
    const DepthPlane plane{planes.depth_dx, planes.depth_dy, planes.depth_min, planes.depth_max};
    const auto count = static_cast<std::uint32_t>(set.count);
    std::uint64_t bits = 0;
    for (std::uint32_t s = 0; s < count; s += L::kCount) {
        const auto behind = L::real::load(opaque.depth.data() + pixel * count + s);
        bits |= std::uint64_t{(sample_depth<L>(plane, set, depth, s) < behind).bits()} << s;
    }
    return bits;
}

// The smallest (depth, primitive) stays.
template <int S>
void write_opaque(OpaqueTile& opaque, const SampleSet& set, const TrianglePlanes& planes,
                  const OpaqueFragment& f)
{
    using L = Lanes<S>;
    using real = typename L::real;
    using whole = typename L::whole;
    const DepthPlane plane{planes.depth_dx, planes.depth_dy, planes.depth_min, planes.depth_max};
    const auto count = static_cast<std::uint32_t>(set.count);
    const whole primitive(static_cast<std::int32_t>(f.primitive));
    for (std::uint32_t s = 0; s < count; s += L::kCount) {
        const std::uint32_t at = f.pixel * count + s;
        const real depth = sample_depth<L>(plane, set, f.depth, s);
        const real old_depth = real::load(opaque.depth.data() + at);
        const whole old_primitive = whole::load(opaque.primitive.data() + at);
        const auto nearer = (depth < old_depth) |
                            ((depth == old_depth) & L::less_unsigned(primitive, old_primitive));
        const auto wins = nearer & L::mask_of_bits(static_cast<std::uint32_t>(f.samples >> s));
        L::select(wins, depth, old_depth).store(opaque.depth.data() + at);
        L::select(wins, primitive, old_primitive).store(opaque.primitive.data() + at);
        float* channels[3] = {opaque.red.data() + at, opaque.green.data() + at,
                              opaque.blue.data() + at};
        for (int c = 0; c < 3; ++c) {
            L::select(wins, real(f.color[c]), real::load(channels[c])).store(channels[c]);
        }
    }
}

inline OpaqueSamples opaque_samples_for(int samples)
{
    switch (samples) {
        case 1: return {&in_front<1>, &write_opaque<1>};
        case 2: return {&in_front<2>, &write_opaque<2>};
        case 4: return {&in_front<4>, &write_opaque<4>};
        case 8: return {&in_front<8>, &write_opaque<8>};
        default: return {&in_front<16>, &write_opaque<16>};
    }
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_VISIBILITY_INL_H
