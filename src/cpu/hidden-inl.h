// Covered pixels in which nothing more can be seen of a triangle, left out before they are shaded.
#if defined(SHEER_HIDDEN_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_HIDDEN_INL_H
#undef SHEER_HIDDEN_INL_H
#else
#define SHEER_HIDDEN_INL_H
#endif

#include <bit>

#include "cpu/triangle_batch-inl.h"
#include "cpu/visibility-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

// Of those of the list's pixels i, i + 1, ... that are in `bits`: how many have a sample in front
// of what is opaque. `owner`: of pixel i, and so on. For statistics: a depth that is rounded in
// another way than the stream's makes no difference to `in_front`.
inline int count_in_front(const OpaqueTile& opaque, const SampleSet& set,
                          const TriangleBatch& batch, const CoverageList& list, int i,
                          const std::uint32_t* owner, std::uint32_t bits)
{
    const OpaqueSamples samples = opaque_samples_for(set.count);
    int count = 0;
    for (; bits != 0; bits &= bits - 1) {
        const int lane = std::countr_zero(bits), at = i + lane;
        const DepthPlane plane = batch.planes.depth_plane(owner[lane]);
        const std::uint32_t pixel = list.pixel[at];
        const auto depth = static_cast<float>(plane.precise(pixel % kTileSize, pixel / kTileSize));
        const PixelFragment fragment{pixel, list.samples(at), depth, {}};
        count += samples.in_front(opaque, set, plane, fragment) != 0;
    }
    return count;
}

// Leaves out of those triangles first, ..., end - 1 that are partly hidden, and of those after the
// first of them, the pixels in which `hidden_behind` (of kTilePixels) is nearer than the whole
// triangle: depths at samples are clamped to those of its vertices. Returns how many fragments
// these were, of any opacity.
HWY_INLINE int leave_out_hidden(const float* hidden_behind, const OpaqueTile& opaque,
                                const SampleSet& set, std::size_t first, std::size_t end,
                                TriangleBatch& batch, const CoverageList& list)
{
    using whole = Block::whole;
    const std::uint32_t partly = batch.partly_hidden >> first & ((1u << (end - first)) - 1);
    if (partly == 0) return 0;
    const int before = batch.begin[first], last = batch.begin[end];
    std::size_t k = first + static_cast<std::size_t>(std::countr_zero(partly));
    int kept = batch.begin[k], in_front = 0;
    // k: the triangle whose last fragment is next.
    for (int i = kept; i < last; i += Block::kCount) {
        std::uint32_t* owners = batch.owner + (i - before);
        const whole owner = whole::load(owners);
        // What lies past the list's end may be any number.
        const whole pixel = whole::load(list.pixel + i) & whole(kTilePixels - 1);
        const auto there = Block::iota() < whole(last - i);
        const auto behind =
            Block::Lookup(owner).of(batch.planes.least) > Block::gather(hidden_behind, pixel);
        if (opaque.any) {
            in_front +=
                count_in_front(opaque, set, batch, list, i, owners, (there & behind).bits());
        }
        const auto seen = there & !behind;
        const std::uint32_t bits = seen.bits();
        for (; k < end && batch.begin[k + 1] <= i + Block::kCount; ++k) {
            const std::uint32_t of_triangle = (1u << (batch.begin[k + 1] - i)) - 1;
            batch.begin[k + 1] = kept + std::popcount(bits & of_triangle);
        }
        const Block::Packing packing(seen);
        packing.store(pixel, list.pixel + kept);
        packing.store(whole::load(list.low + i), list.low + kept);
        if (set.count > 32) packing.store(whole::load(list.high + i), list.high + kept);
        packing.store(owner, batch.owner + (kept - before));
        kept += std::popcount(bits);
    }
    return opaque.any ? in_front : last - kept;
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_HIDDEN_INL_H
