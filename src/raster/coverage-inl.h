// Which samples of a tile's pixels a batch of triangles covers: exact integer edge functions, the
// lanes of a vector over pixels that one of them may cover, one sample after the other.
//
// An edge too long for 32 bits within a tile is for coverage_wide.h.
#if defined(SHEER_COVERAGE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_COVERAGE_INL_H
#undef SHEER_COVERAGE_INL_H
#else
#define SHEER_COVERAGE_INL_H
#endif

#include "raster/candidates-inl.h"
#include "raster/coverage_list.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

// The edge functions at the corners of the tile's pixels. They wrap around, and back.
HWY_INLINE void edges_at(const EdgeBatch& b, std::size_t k, Block::whole pixel,
                         Block::whole (&at)[3])
{
    using whole = Block::whole;
    static_assert(kTileSize == 1 << 5 && kSubpixels == 1 << 8);
    const whole column = pixel & whole(kTileSize - 1);
    if ((b.small >> k & 1) != 0) {
        const whole row = pixel & whole((kTileSize - 1) << 5);
        const whole place = (column << 8) | (row << (16 + 8 - 5));  // halves, in subpixels
        for (std::size_t e = 0; e < 3; ++e) {
            at[e] = whole(b.origin[e][k]) + Block::dot_halves(place, whole(b.steps[e][k]));
        }
        return;
    }
    const whole row = pixel.shift_right<5>();
    for (std::size_t e = 0; e < 3; ++e) {
        at[e] = whole(b.origin[e][k]) +
                (column * whole(b.step_x[e][k]) + row * whole(b.step_y[e][k])) * whole(kSubpixels);
    }
}

// Samples first, first + 1, ... (at most 32) of pixels whose edge functions at their corners are
// `at`: bit s - first of a lane is set where sample s is outside.
template <int Samples>
HWY_INLINE Block::whole samples_outside(const EdgeBatch& b, std::size_t k, std::size_t first,
                                        const Block::whole (&at)[3])
{
    using whole = Block::whole;
    whole outside(0);
    HWY_UNROLL(16)
    for (std::size_t s = 0; s < static_cast<std::size_t>(Samples); ++s) {
        const WholeEach(&step)[3] = b.at_sample[first + s];
        const whole negative =
            (at[0] + whole(step[0][k])) | (at[1] + whole(step[1][k])) | (at[2] + whole(step[2][k]));
        outside = outside | (negative.sign() & whole(std::uint32_t{1} << s));
    }
    return outside;
}

// Appends what the candidates cover to the list. Of triangle k, end[k] becomes the list's number
// of pixels after it, where it has candidates. `owner`: the triangles of the pixels that are added.
// `Samples`: that are tested, each for itself or one for all.
template <int Samples>
void cover_by_samples(const EdgeBatch& b, const CandidateList& candidates, const SampleSet& set,
                      CoverageList& list, int* end, std::uint32_t* owner)
{
    using whole = Block::whole;
    using mask = Block::mask;
    constexpr int kLow = Samples < 32 ? Samples : 32;
    const std::uint64_t all = set.all();
    const whole all_low(static_cast<std::uint32_t>(all));
    const whole all_high(static_cast<std::uint32_t>(all >> 32)), zero(0);
    int count = list.count;
    for (int v = 0; v < candidates.vectors; ++v) {
        const auto k = static_cast<std::size_t>(candidates.triangle[v]);
        const whole pixel = whole::load(candidates.pixel + v * Block::kCount);
        whole at[3];
        edges_at(b, k, pixel, at);
        whole low = samples_outside<kLow>(b, k, 0, at), high = zero;
        if constexpr (Samples == 1) {  // which may stand for more
            const mask outside = !(low == zero);
            low = Block::select(outside, zero, all_low);
            high = Block::select(outside, zero, all_high);
        } else {
            low = all_low & (low ^ all_low);
            if constexpr (Samples == 64) {
                high = all_high & (samples_outside<32>(b, k, 32, at) ^ all_high);
            }
        }
        const mask here = !((low | high) == zero) & (Block::iota() < whole(candidates.left[v]));
        const Block::Packing packing(here);
        packing.store(pixel, list.pixel + count);
        packing.store(low, list.low + count);
        if (set.count > 32) packing.store(high, list.high + count);
        whole(static_cast<std::int32_t>(k)).store(owner + (count - list.count));
        count += static_cast<int>(packing.count());
        end[k] = count;
    }
    list.count = count;
}

using CoverFunction = void (*)(const EdgeBatch&, const CandidateList&, const SampleSet&,
                               CoverageList&, int*, std::uint32_t*);

inline CoverFunction cover_function_for(const SampleSet& set)
{
    switch (set.centered ? 1 : set.count) {
        case 1: return cover_by_samples<1>;
        case 2: return cover_by_samples<2>;
        case 4: return cover_by_samples<4>;
        case 8: return cover_by_samples<8>;
        case 16: return cover_by_samples<16>;
        case 32: return cover_by_samples<32>;
        default: return cover_by_samples<64>;
    }
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_COVERAGE_INL_H
