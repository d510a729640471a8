// Which samples of a tile's pixels a triangle covers: exact integer edge functions, the lanes of a
// vector over pixels that may be covered, one sample after the other.
//
// Those are all pixels of a small region. Of a larger one they are found a row at a time: from
// which column to which all three functions may be positive at some sample. A region that is inside
// of all edges needs no test; an edge too long for 32 bits within a tile takes the scalar way in 64
// bits.
#if defined(SHEER_COVERAGE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_COVERAGE_INL_H
#undef SHEER_COVERAGE_INL_H
#else
#define SHEER_COVERAGE_INL_H
#endif

#include "raster/coverage_list.h"
#include "raster/edge_batch-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

// All of the region's pixels, wholly.
inline void cover_all(const SampleSet& set, const EdgeBatch& b, std::size_t k, CoverageList& list)
{
    const std::uint64_t all = set.all();
    for (int y = b.y0[k]; y < b.y0[k] + b.height[k]; ++y) {
        for (int x = b.x0[k]; x < b.x0[k] + b.width[k]; ++x) {
            list.pixel[list.count] = static_cast<std::uint32_t>(y * kTileSize + x);
            list.low[list.count] = static_cast<std::uint32_t>(all);
            if (set.count > 32) list.high[list.count] = static_cast<std::uint32_t>(all >> 32);
            ++list.count;
        }
    }
}

// Of a vector of rows: the tile's pixel with which the row's candidates begin, and their number.
struct RowSpans {
    alignas(64) WholeEach first, count;
};

// Rows first, first + 1, ... of the region: from which column to which a sample may be inside, by
// floats, so with a little to spare on both sides.
HWY_INLINE void find_spans(const EdgeBatch& b, std::size_t k, int first, RowSpans& spans)
{
    using real = Block::real;
    using whole = Block::whole;
    const whole row = Block::iota() + whole(first);
    const int width = b.width[k];
    real lower(0.0f), upper(static_cast<float>(width - 1));
    for (std::size_t e = 0; e < 3; ++e) {
        const real best = Block::to_real(whole(b.corner[e][k] + b.most[e][k]) +
                                         row * whole(b.step_y[e][k] * kSubpixels));
        const real zero_at = best * real(b.to_zero[e][k]);
        lower = Block::max(lower, zero_at + real(b.no_lower[e][k]));
        upper = Block::min(upper, zero_at + real(b.no_upper[e][k]));
    }
    // Quotients within a tile err by less than 1e-4 of a pixel.
    const real spare(0.01f);
    lower = Block::min(lower - spare + real(1.0f), real(static_cast<float>(width)));
    upper = Block::max(upper + spare, real(-1.0f));
    const whole from = Block::to_whole(Block::max(lower, real(0.0f)));
    const whole to = Block::select(upper < real(0.0f), whole(-1), Block::to_whole(upper));
    const whole count = Block::max(to - from + whole(1), whole(0));
    (from + whole(b.y0[k] * kTileSize + b.x0[k]) + row * whole(kTileSize)).store(spans.first);
    Block::select(row < whole(b.height[k]), count, whole(0)).store(spans.count);
}

// Pixels that a triangle may cover: `first` and each of count offsets.
struct Candidates {
    int first, count;
    const std::uint32_t* offset;
};

// Room for a tile's pixels and a vector.
struct CandidateRoom {
    alignas(64) std::uint32_t offset[kTilePixels + Block::kCount];
};

// The pixels of regions of width w, row by row: offsets from the first, [w - 1][0, 1, ...].
inline constexpr int kWidestSmallRegion = 16, kLargestSmallRegion = 48;
struct SmallRegions {
    alignas(64) std::uint32_t offset[kWidestSmallRegion][kLargestSmallRegion];
};
constexpr SmallRegions make_small_regions()
{
    SmallRegions regions = {};
    for (std::uint32_t w = 1; w <= kWidestSmallRegion; ++w) {
        for (std::uint32_t i = 0; i < kLargestSmallRegion; ++i) {
            regions.offset[w - 1][i] = i / w * kTileSize + i % w;
        }
    }
    return regions;
}
inline constexpr SmallRegions kSmallRegions = make_small_regions();

HWY_INLINE Candidates find_candidates(const EdgeBatch& b, std::size_t k, CandidateRoom& room)
{
    using whole = Block::whole;
    const int width = b.width[k], height = b.height[k];
    if (width <= kWidestSmallRegion && width * height <= kLargestSmallRegion) {
        return {b.y0[k] * kTileSize + b.x0[k], width * height, kSmallRegions.offset[width - 1]};
    }
    RowSpans spans;
    int count = 0;
    for (int y = 0; y < height; y += Block::kCount) {
        find_spans(b, k, y, spans);
        const int rows = std::min(Block::kCount, height - y);
        for (int row = 0; row < rows; ++row) {
            const whole pixel = Block::iota() + whole(spans.first[row]);
            pixel.store(room.offset + count);
            for (int x = Block::kCount; x < spans.count[row]; x += Block::kCount) {
                (pixel + whole(x)).store(room.offset + count + x);
            }
            count += spans.count[row];
        }
    }
    return {0, count, room.offset};
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

// `Samples`: that are tested, each for itself or one for all.
template <int Samples>
void cover_by_samples(const EdgeBatch& b, std::size_t k, const SampleSet& set, CoverageList& list)
{
    using whole = Block::whole;
    using mask = Block::mask;
    CandidateRoom room;
    const Candidates candidates = find_candidates(b, k, room);
    constexpr int kLow = Samples < 32 ? Samples : 32;
    const std::uint64_t all = set.all();
    const whole all_low(static_cast<std::uint32_t>(all));
    const whole all_high(static_cast<std::uint32_t>(all >> 32)), zero(0);
    int count = list.count;
    for (int i = 0; i < candidates.count; i += Block::kCount) {
        static_assert(kTileSize == 1 << 5);
        const whole pixel = whole(candidates.first) + whole::load(candidates.offset + i);
        const whole column = pixel & whole(kTileSize - 1), row = pixel.shift_right<5>();
        whole at[3];
        for (std::size_t e = 0; e < 3; ++e) {
            // Wraps around, and back.
            at[e] =
                whole(b.origin[e][k]) +
                (column * whole(b.step_x[e][k]) + row * whole(b.step_y[e][k])) * whole(kSubpixels);
        }
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
        const mask here = !((low | high) == zero) & (Block::iota() < whole(candidates.count - i));
        const Block::Packing packing(here);
        packing.store(pixel, list.pixel + count);
        packing.store(low, list.low + count);
        if (set.count > 32) packing.store(high, list.high + count);
        count += static_cast<int>(packing.count());
    }
    list.count = count;
}

using CoverFunction = void (*)(const EdgeBatch&, std::size_t, const SampleSet&, CoverageList&);

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
