// Triangles of which all, or nothing, is hidden, told by blocks of pixels before they are covered:
// by opaque surfaces, or by what a store keeps. What lies between is told pixel by pixel, after.
//
// As hierarchical depth buffers do (Greene, Kass and Miller. Hierarchical Z-Buffer Visibility.
// SIGGRAPH 1993), with one level.
#if defined(SHEER_HIDDEN_BLOCKS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_HIDDEN_BLOCKS_INL_H
#undef SHEER_HIDDEN_BLOCKS_INL_H
#else
#define SHEER_HIDDEN_BLOCKS_INL_H
#endif

#include <algorithm>
#include <bit>
#include <limits>

#include "cpu/triangle_batch-inl.h"
#include "raster/opaque_tile.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

// Between which depths what hides lies, in each block of 4 x 4 of a tile's pixels.
class BlockDepths {
public:
    // Of the tile's pixels.
    void find(const float* least, const float* most)
    {
        clear();
        for (int row = 0; row < kAcross; ++row) {
            const int pixel = row * kSize * kTileSize;
            find_row(least + pixel, most + pixel, row * kAcross);
        }
    }
    // Nothing hides anything.
    void clear() { least_of_all_ = kNothing; }
    float least() const { return least_of_all_; }

    // How triangle k of the batch lies to the blocks that its region touches: as a whole behind all
    // of their pixels, or behind one; as a whole in front of all.
    struct Relation {
        bool behind_all, behind_any, in_front_of_all;
    };
    HWY_INLINE Relation relation(const TriangleBatch& batch, std::size_t k) const
    {
        const EdgeBatch& e = batch.edges;
        const int x0 = e.x0[k] >> kBits, x1 = (e.x0[k] + e.width[k] - 1) >> kBits;
        const int y0 = e.y0[k] >> kBits, y1 = (e.y0[k] + e.height[k] - 1) >> kBits;
        const Row::real near(batch.planes.least[k]), far(batch.planes.most[k]);
        std::uint32_t behind = 0, behind_some = 0, in_front = 0;
        for (int x = 0; x < kAcross; x += Row::kCount) {
            const int first = y0 * kAcross + x;
            Row::real least = Row::real::load(least_ + first),
                      most = Row::real::load(most_ + first);
            for (int i = first + kAcross; i <= y1 * kAcross + x; i += kAcross) {
                least = Row::min(least, Row::real::load(least_ + i));
                most = Row::max(most, Row::real::load(most_ + i));
            }
            behind |= (most < near).bits() << x;
            behind_some |= (least < near).bits() << x;
            in_front |= (far < least).bits() << x;
        }
        const std::uint32_t columns = (2u << x1) - (1u << x0);
        return {(behind & columns) == columns, (behind_some & columns) != 0,
                (in_front & columns) == columns};
    }

private:
    static constexpr int kBits = 2, kSize = 1 << kBits, kAcross = kTileSize / kSize;
    static constexpr float kNothing = std::numeric_limits<float>::infinity();
    using Row = Lanes<kAcross>;

    HWY_INLINE void find_row(const float* least, const float* most, int block)
    {
        alignas(64) float column_least[kTileSize], column_most[kTileSize];
        for (int x = 0; x < kTileSize; x += Row::kCount) {
            Row::real a = Row::real::load(least + x), b = Row::real::load(most + x);
            for (int i = x + kTileSize; i < kSize * kTileSize; i += kTileSize) {
                a = Row::min(a, Row::real::load(least + i));
                b = Row::max(b, Row::real::load(most + i));
            }
            a.store(column_least + x);
            b.store(column_most + x);
        }
        for (int i = 0; i < kAcross; ++i) {
            const float *a = column_least + i * kSize, *b = column_most + i * kSize;
            least_[block + i] = std::min(std::min(a[0], a[1]), std::min(a[2], a[3]));
            most_[block + i] = std::max(std::max(b[0], b[1]), std::max(b[2], b[3]));
            least_of_all_ = std::min(least_of_all_, least_[block + i]);
        }
    }

    float least_of_all_ = kNothing;
    alignas(64) float least_[kAcross * kAcross], most_[kAcross * kAcross];
};

// Opaque surfaces, and how far their depths in floats may be off.
HWY_INLINE void find_opaque(const OpaqueTile& opaque, BlockDepths& blocks)
{
    constexpr float kEmpty = std::numeric_limits<float>::infinity();
    float least[kTilePixels], most[kTilePixels];
    std::size_t at = 0;
    for (std::size_t pixel = 0; pixel < kTilePixels; ++pixel) {
        float near = kEmpty, far = -kEmpty;
        for (int s = 0; s < opaque.samples; ++s, ++at) {
            const float depth = opaque.depth.data()[at];
            const float slack = depth == kEmpty ? 0 : opaque.slack.data()[at];
            near = std::min(near, depth - slack);
            far = std::max(far, depth + slack);
        }
        least[pixel] = near;
        most[pixel] = far;
    }
    blocks.find(least, most);
}

// What hides a tile's transparent triangles.
struct HiddenBlocks {
    BlockDepths kept, opaque;

    // Triangles that are set up and hidden as a whole count as outside of their regions from here
    // on. Depths at samples are clamped to those of a triangle's vertices.
    HWY_INLINE void sort_out(TriangleBatch& batch) const
    {
        using real = Block::real;
        const PlaneBatch& planes = batch.planes;
        const std::uint32_t there = batch.conservative ? 0 : (1u << batch.count) - 1;
        // Most triangles are in front of all.
        batch.in_front = there & (real::load(planes.most) < real(opaque.least())).bits();
        batch.partly_hidden = 0;
        for_each_covering(batch, there & ~batch.in_front, [&](std::size_t k) HWY_ATTR {
            const BlockDepths::Relation to = opaque.relation(batch, k);
            if (to.behind_all) batch.edges.outside |= 1u << k;
            if (to.in_front_of_all) batch.in_front |= 1u << k;
        });
        const auto behind = real(kept.least()) < real::load(planes.least);
        for_each_covering(batch, there & behind.bits(), [&](std::size_t k) HWY_ATTR {
            const BlockDepths::Relation to = kept.relation(batch, k);
            if (to.behind_all) batch.edges.outside |= 1u << k;
            if (to.behind_any) batch.partly_hidden |= 1u << k;
        });
    }

private:
    // Triangles `bits` that may cover pixels.
    template <class Visit>
    static HWY_INLINE void for_each_covering(const TriangleBatch& batch, std::uint32_t bits,
                                             Visit&& visit)
    {
        for (; bits != 0; bits &= bits - 1) {
            const auto k = static_cast<std::size_t>(std::countr_zero(bits));
            if (most_fragments(batch, k) > 0) visit(k);
        }
    }
};

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_HIDDEN_BLOCKS_INL_H
