// Fragments with their depths, at every sample.
#if defined(SHEER_SAMPLE_DEPTHS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_SAMPLE_DEPTHS_INL_H
#undef SHEER_SAMPLE_DEPTHS_INL_H
#else
#define SHEER_SAMPLE_DEPTHS_INL_H
#endif

#include "methods/samples-inl.h"
#include "raster/sample_depth-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

// Calls visit(plane, primitive, i, s, depth) with every fragment i of a stream at each vector of
// its pixel's samples.
template <int S, class Visit>
HWY_INLINE void for_each_sample_depth(const FragmentStream& f, const SampleSet& set, Visit&& visit)
{
    using L = Lanes<S>;
    using real = typename L::real;
    constexpr std::size_t kMostBlocks = (S < 16 ? S : kMaxSamples) / L::kCount;
    const std::size_t samples = sample_count<S>(set.count);
    for (int r = 0; r < f.run_count; ++r) {
        const FragmentRun& run = f.runs[r];
        const DepthPlane plane = run.depth;  // copies, which what is stored cannot alias
        const std::uint32_t primitive = run.primitive;
        real offsets[kMostBlocks];
        for (std::size_t s = 0; s < samples; s += L::kCount) {
            offsets[s / L::kCount] = sample_depth_offset<L>(plane, set, s);
        }
        for (std::size_t i = run.first; i < run.first + run.count; ++i) {
            for (std::size_t s = 0; s < samples; s += L::kCount) {
                visit(plane, primitive, i, s,
                      sample_depth<L>(plane, offsets[s / L::kCount], f.depth[i]));
            }
        }
    }
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_SAMPLE_DEPTHS_INL_H
