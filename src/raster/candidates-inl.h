// The pixels of a tile that a batch's triangles may cover, a vector of them after the other, each
// of one triangle: what comes after has one long loop over vectors, and no short ones of which the
// processor would guess the length.
#if defined(SHEER_CANDIDATES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_CANDIDATES_INL_H
#undef SHEER_CANDIDATES_INL_H
#else
#define SHEER_CANDIDATES_INL_H
#endif

#include "raster/edge_batch-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

// The pixels of regions of width w, row by row: offsets from the first, [w - 1][0, 1, ...].
inline constexpr int kWidestSmallRegion = 32, kLargestSmallRegion = 80;
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

struct CandidateList {
    // Of triangles whose regions have no more pixels together.
    static constexpr int kMostPixels = 2 * kTilePixels;
    static constexpr int kMostVectors = kMostPixels / Block::kCount + Block::kCount;

    int vectors = 0;
    // Of vector v: its triangle, and how many of its lanes, and those of its triangle's vectors
    // after it, are candidates.
    alignas(64) std::int32_t triangle[kMostVectors + Block::kCount];
    alignas(64) std::int32_t left[kMostVectors + Block::kCount];
    // row * kTileSize + column. What is no candidate may be any number.
    alignas(64) std::uint32_t pixel[kMostVectors * Block::kCount + kLargestSmallRegion];
};

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

// Writes the rows' candidates from `pixel` on. Returns how many there are.
HWY_INLINE int add_spans(const EdgeBatch& b, std::size_t k, std::uint32_t* pixel)
{
    using whole = Block::whole;
    const int height = b.height[k];
    RowSpans spans;
    int count = 0;
    for (int y = 0; y < height; y += Block::kCount) {
        find_spans(b, k, y, spans);
        const int rows = std::min(Block::kCount, height - y);
        for (int row = 0; row < rows; ++row) {
            const whole first = Block::iota() + whole(spans.first[row]);
            first.store(pixel + count);
            for (int x = Block::kCount; x < spans.count[row]; x += Block::kCount) {
                (first + whole(x)).store(pixel + count + x);
            }
            count += spans.count[row];
        }
    }
    return count;
}

// Those of triangle k: all pixels of a small region. Of a larger one they are found a row at a
// time: from which column to which all three functions may be positive at some sample.
HWY_INLINE void add_candidates(const EdgeBatch& b, std::size_t k, CandidateList& list)
{
    using whole = Block::whole;
    const int width = b.width[k], height = b.height[k];
    std::uint32_t* pixel = list.pixel + list.vectors * Block::kCount;
    int count = width * height;
    if (width <= kWidestSmallRegion && count <= kLargestSmallRegion) {
        const whole first(b.y0[k] * kTileSize + b.x0[k]);
        const std::uint32_t* offset = kSmallRegions.offset[width - 1];
        // Of few vectors rather too many than a number of them that is guessed wrong.
        const int end = Block::kCount < 16 ? count : kLargestSmallRegion;
        for (int i = 0; i < end; i += Block::kCount) {
            (first + whole::load(offset + i)).store(pixel + i);
        }
    } else {
        count = add_spans(b, k, pixel);
    }
    const int vectors = (count + Block::kCount - 1) / Block::kCount;
    for (int v = 0; v < vectors; v += Block::kCount) {
        whole(static_cast<std::int32_t>(k)).store(list.triangle + list.vectors + v);
        const whole before = (Block::iota() + whole(v)) * whole(Block::kCount);
        (whole(count) - before).store(list.left + list.vectors + v);
    }
    list.vectors += vectors;
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_CANDIDATES_INL_H
