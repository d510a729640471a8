// A fragment a lane; sums are exact, so that no order shows.
#include "cpu/moment_shadows.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cpu/moment_shadows.cpp"
#include "lanes/targets.h"

#include <algorithm>
#include <bit>

#include <hwy/foreach_target.h>

#include "methods/fragment_units-inl.h"
#include "methods/translucent-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

struct ShadowSums {
    static constexpr std::size_t kSums = kFourMoments;

    template <class W>
    static HWY_INLINE void addends(typename W::real place, typename W::real depth,
                                   typename W::real (&addends)[kSums])
    {
        addends[0] = depth;
        for (std::size_t k = 1; k < kSums; ++k) addends[k] = addends[k - 1] * place;
    }
};

class MomentShadows final : public ShadowTileStore {
    using Block = Lanes<16>;
    using Real = Block::real;

public:
    MomentShadows(const ShadowMap& map, const SampleSet& set, int capacity)
        : set_(set),
          range_{map.moments->is_distance, map.moments->from, map.moments->scale},
          places_(capacity + FragmentStream::kSlack),
          sums_(kTilePixels * kFourMoments)
    {
    }

    void begin(const ShadowTile&, const FrameOfPicture&) override
    {
        std::fill_n(sums_.data(), sums_.size(), std::int64_t{0});
    }

    void insert(const ShadowTile&, const FragmentStream& f) override
    {
        for (int r = 0; r < f.run_count; ++r) warp_depths(range_, f, f.runs[r], places_.data());
        const auto size = static_cast<std::size_t>(f.size);
        for (std::size_t i = 0; i < size; i += kChunk) add(f, i, std::min(kChunk, size - i));
    }

    void end(const ShadowTile& tile) override
    {
        const ExactGrid grid(-kDepthBits);
        const PixelRect& rect = tile.rect;
        const auto count = static_cast<std::size_t>((rect.x1 - rect.x0) * kFourMoments);
        for (int y = rect.y0; y < rect.y1; ++y) {
            const std::int64_t* from = sums_.data() + (y - rect.y0) * kTileSize * kFourMoments;
            const std::size_t texel =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(tile.map.size) +
                static_cast<std::size_t>(rect.x0);
            double* to = tile.map.moments->sums.data() + texel * kFourMoments;
            for (std::size_t i = 0; i < count; ++i)
                to[i] = static_cast<double>(from[i]) * grid.unit;
        }
    }

private:
    // Of light that goes through some of a texel's samples a fragment takes its opacity of that
    // part: where it covers half and is opaque, half the light passes.
    void add(const FragmentStream& f, std::size_t first, std::size_t some)
    {
        alignas(64) float depths[kChunk];
        const float part = 1.0f / static_cast<float>(set_.count);
        for (std::size_t i = 0; i < some; ++i) {
            const int samples = std::popcount(f.sample_bits(first + i) & set_.all());
            depths[i] = static_cast<float>(samples) * part * f.opacity[first + i];
        }
        for (std::size_t i = 0; i < some; i += Block::kCount) {
            const Real opacity = Block::min(Real::load(depths + i), Real(kMost));
            TransmittanceText<Block>::optical_depth(opacity).store(depths + i);
        }
        units_.set({}, places_.data() + first, depths, some);
        for (std::size_t i = 0; i < some; ++i) {
            units_.add_to(sums_.data() + f.pixel[first + i] * kFourMoments, i);
        }
    }

    static constexpr float kMost = 1 - 0x1p-12f;  // what passes through one is no 4,000th

    const SampleSet& set_;
    DepthRange range_;
    AlignedArray<float> places_;
    AlignedArray<std::int64_t> sums_;
    FragmentUnits<ShadowSums, kChunk> units_;
};

std::unique_ptr<ShadowTileStore> moment_shadows(const ShadowMap& map, const SampleSet& set,
                                                int capacity)
{
    return std::make_unique<MomentShadows>(map, set, capacity);
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sheer {

HWY_EXPORT(moment_shadows);

std::unique_ptr<ShadowTileStore> make_moment_shadows(TargetSet targets, const ShadowMap& map,
                                                     const SampleSet& set, int capacity)
{
    return SHEER_DISPATCH(moment_shadows, targets)(map, set, capacity);
}

}  // namespace sheer
#endif
