// Opaque surfaces, sample by sample: lanes over the samples of one pixel. Where floats can't tell
// which of two surfaces is nearer, doubles do (raster/depth_plane.h).
#if defined(SHEER_VISIBILITY_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_VISIBILITY_INL_H
#undef SHEER_VISIBILITY_INL_H
#else
#define SHEER_VISIBILITY_INL_H
#endif

#include <bit>
#include <limits>

#include "lanes/lanes-inl.h"
#include "raster/opaque_tile.h"
#include "raster/sample_depth-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

// A triangle's part of one pixel.
struct PixelFragment {
    std::uint32_t pixel;
    std::uint64_t samples;
    float depth;  // at the pixel's centre
    float color[3];
};

// The functions for one number of samples.
struct OpaqueSamples {
    // Of a transparent fragment's samples, those in front of what is opaque.
    std::uint64_t (*in_front)(const OpaqueTile&, const SampleSet&, const DepthPlane&,
                              const PixelFragment&);
    // Draws an opaque fragment of one of the tile's surfaces.
    void (*write)(OpaqueTile&, const SampleSet&, const PixelFragment&, std::uint32_t surface);
};

// Of the samples s, s + 1, ... (bits), those at which the plane is nearer than the opaque surface.
// At equal depth `wins_tie` decides, given the opaque surface.
template <class WinsTie>
HWY_INLINE std::uint32_t nearer_precisely(const OpaqueTile& opaque, const SampleSet& set,
                                          const DepthPlane& plane, std::uint32_t pixel,
                                          std::size_t s, std::uint32_t bits, WinsTie&& wins_tie)
{
    std::uint32_t nearer = 0;
    for (; bits != 0; bits &= bits - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(bits));
        const auto at = pixel * static_cast<std::size_t>(set.count) + s + lane;
        const OpaqueSurface& other = opaque.surfaces[opaque.surface[at]];
        const double ours = precise_depth(plane, set, pixel, s + lane);
        const double theirs = precise_depth(other.depth, set, pixel, s + lane);
        if (ours < theirs || (ours == theirs && wins_tie(other))) nearer |= 1u << lane;
    }
    return nearer;
}

template <class L>
struct Comparison {
    typename L::real depth;
    std::uint32_t nearer, doubtful;  // samples of the fragment, bits
};

template <class L>
HWY_INLINE Comparison<L> compare(const OpaqueTile& opaque, const SampleSet& set,
                                 const DepthPlane& plane, const PixelFragment& f, std::size_t s)
{
    using real = typename L::real;
    const std::size_t at = f.pixel * static_cast<std::size_t>(set.count) + s;
    const real depth = sample_depth<L>(plane, set, f.depth, s);
    const real other = real::load(opaque.depth.data() + at);
    const real slack = real(plane.slack) + real::load(opaque.slack.data() + at);
    const auto here = L::mask_of_bits(static_cast<std::uint32_t>(f.samples >> s));
    // In front of nothing there is no doubt, and no surface to compare with.
    const auto empty = other == real(std::numeric_limits<float>::infinity());
    const auto nearer = empty | (depth + slack < other), farther = other + slack < depth;
    return {depth, (here & nearer).bits(), (here & !(nearer | farther)).bits()};
}

template <int S>
std::uint64_t in_front(const OpaqueTile& opaque, const SampleSet& set, const DepthPlane& plane,
                       const PixelFragment& f)
{
    using L = Lanes<S>;
    std::uint64_t bits = 0;
    for (std::size_t s = 0; s < static_cast<std::size_t>(set.count); s += L::kCount) {
        const Comparison<L> c = compare<L>(opaque, set, plane, f, s);
        const std::uint32_t nearer =
            c.nearer | nearer_precisely(opaque, set, plane, f.pixel, s, c.doubtful,
                                        [](const OpaqueSurface&) { return false; });
        bits |= std::uint64_t{nearer} << s;
    }
    return bits;
}

template <int S>
void write_opaque(OpaqueTile& opaque, const SampleSet& set, const PixelFragment& f,
                  std::uint32_t surface)
{
    using L = Lanes<S>;
    using real = typename L::real;
    using whole = typename L::whole;
    const OpaqueSurface& ours = opaque.surfaces[surface];
    for (std::size_t s = 0; s < static_cast<std::size_t>(set.count); s += L::kCount) {
        const Comparison<L> c = compare<L>(opaque, set, ours.depth, f, s);
        const std::uint32_t nearer =
            c.nearer |
            nearer_precisely(opaque, set, ours.depth, f.pixel, s, c.doubtful,
                             [&](const OpaqueSurface& o) { return ours.primitive < o.primitive; });
        const auto wins = L::mask_of_bits(nearer);
        const std::size_t at = f.pixel * static_cast<std::size_t>(set.count) + s;
        const auto put = [&](AlignedArray<float>& array, real value) HWY_ATTR {
            L::select(wins, value, real::load(array.data() + at)).store(array.data() + at);
        };
        put(opaque.depth, c.depth);
        put(opaque.slack, real(ours.depth.slack));
        put(opaque.red, real(f.color[0]));
        put(opaque.green, real(f.color[1]));
        put(opaque.blue, real(f.color[2]));
        std::uint32_t* drawn = opaque.surface.data() + at;
        L::select(wins, whole(surface), whole::load(drawn)).store(drawn);
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
